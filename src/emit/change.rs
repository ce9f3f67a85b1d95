//! What a plan changes, module by module.
//!
//! Files that are there as outlines are left alone: they are another part's.

use std::collections::BTreeMap;

use super::options::EmitError;
use crate::compensate::plan::{Plan, Status, Tick};
use crate::diagnostic::{FileId, TextRange};
use crate::program::Program;
use crate::syntax::tree::{FileItem, Module};

/// A module: its file, and its position among the file's items.
pub type Place = (FileId, usize);

/// What is to be changed in a module.
#[derive(Clone, Debug, Default)]
pub struct Change {
    /// The compensated motions: indices into [`Program::motions`].
    pub motions: Vec<usize>,
    /// Where the clock is brought up to date: before the statement at this byte.
    pub ticks: Vec<u32>,
}

impl Change {
    /// The compensated motions that stand in a range of the module: motions stand in the order of their places.
    #[must_use]
    pub fn motions_in(&self, program: &Program, range: TextRange) -> &[usize] {
        let before = |offset: u32| {
            self.motions.partition_point(|&m| program.motions.get(m).is_some_and(|m| m.range.start < offset))
        };
        self.motions.get(before(range.start)..before(range.end)).unwrap_or_default()
    }
}

/// Refuses a plan that was made for another program or is not whole.
///
/// # Errors
/// [`EmitError::PlanMismatch`].
pub fn check_plan(program: &Program, plan: &Plan) -> Result<(), EmitError> {
    let mismatch = |text: String| Err(EmitError::PlanMismatch(text));
    if plan.motions.len() != program.motions.len() {
        return mismatch(format!("{} motions, {} planned", program.motions.len(), plan.motions.len()));
    }
    for (motion, planned) in program.motions.iter().zip(&plan.motions) {
        if !program.is_own(motion) {
            continue;
        }
        let wrong = match &planned.status {
            Status::Kept(_) => None,
            Status::Refused(why) => Some(why.reason.as_str()),
            Status::Compensated if planned.targets.len() != motion.targets.len() => {
                Some("targets are missing")
            }
            Status::Compensated => None,
        };
        if let Some(wrong) = wrong {
            return mismatch(format!("{}:{}: {wrong}", program.file(motion.file).path, motion.line));
        }
    }
    Ok(())
}

/// What is to be changed in each module of the files that are there in full, by file and position among the file's items.
///
/// # Errors
/// [`EmitError::NoModule`], [`EmitError::PlanMismatch`].
pub fn changes(program: &Program, plan: &Plan) -> Result<BTreeMap<Place, Change>, EmitError> {
    let mut changes: BTreeMap<Place, Change> = BTreeMap::new();
    let place = |id: FileId, offset: u32| {
        let file = program.file(id);
        let holds = |module: &Module| module.range.start <= offset && offset < module.range.end;
        let index = file
            .tree
            .items
            .iter()
            .position(|item| matches!(item, FileItem::Module(m) if m.end.is_some() && holds(m)));
        let line = file.lines.line(offset);
        index.map(|i| (id, i)).ok_or_else(|| EmitError::NoModule { path: file.path.clone().into(), line })
    };
    for (index, (motion, planned)) in program.motions.iter().zip(&plan.motions).enumerate() {
        if planned.status == Status::Compensated && program.is_own(motion) {
            let key = place(motion.file, motion.range.start)?;
            changes.entry(key).or_default().motions.push(index);
        }
    }
    for tick in &plan.ticks {
        let at = match *tick {
            Tick::Routine(i) => program.routines.get(i).map(|r| (r.file, r.first_statement)),
            Tick::Loop(i) => program.loops.get(i).map(|l| (l.file, l.first_statement)),
            Tick::Motion(i) => program.motions.get(i).map(|m| (m.file, m.range.start)),
        };
        let (id, offset) = at.ok_or_else(|| EmitError::PlanMismatch(format!("{tick:?} is not there")))?;
        if !program.file(id).is_outline() {
            changes.entry(place(id, offset)?).or_default().ticks.push(offset);
        }
    }
    Ok(changes)
}
