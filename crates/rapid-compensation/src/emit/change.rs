//! What a plan changes, module by module.

use super::context::Changes;
use super::options::EmitError;
use crate::compensate::plan::{Form, Plan, Status};
use rapid_program::Program;
use rapid_syntax::diagnostic::FileId;
use rapid_syntax::tree::{FileItem, Module};

/// Refuses a plan that was made for another program or is not whole.
///
/// # Errors
/// [`EmitError::PlanMismatch`].
pub(super) fn check_plan(program: &Program, plan: &Plan) -> Result<(), EmitError> {
    let mismatch = |text: String| Err(EmitError::PlanMismatch(text));
    if plan.motions.len() != program.motions.len() {
        return mismatch(format!("{} motions, {} planned", program.motions.len(), plan.motions.len()));
    }
    for (motion, planned) in program.motions.iter().zip(&plan.motions) {
        let wrong = match &planned.status {
            Status::Kept(_) => None,
            Status::Refused(why) => Some(why.reason.as_str()),
            Status::Compensated if planned.form == Form::Live => None,
            Status::Compensated => {
                let values: usize = motion.targets.iter().map(|target| target.values().count()).sum();
                (planned.targets.len() != values).then_some("targets are missing")
            }
        };
        if let Some(wrong) = wrong {
            return mismatch(format!("{}:{}: {wrong}", program.file(motion.file).path, motion.line));
        }
    }
    Ok(())
}

/// The modules that a plan changes, with their compensated motions.
///
/// # Errors
/// [`EmitError::NoModule`], [`EmitError::PlanMismatch`].
pub(super) fn changes(program: &Program, plan: &Plan) -> Result<Changes, EmitError> {
    let mut changes = Changes::new();
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
    for ((id, motion), planned) in program.numbered_motions().zip(&plan.motions) {
        if planned.status == Status::Compensated {
            let key = place(motion.file, motion.range.start)?;
            changes.entry(key).or_default().push(id);
        }
    }
    Ok(changes)
}
