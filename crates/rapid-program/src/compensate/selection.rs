//! Which motions are to be left alone, by the names of their targets, routines and modules.

use super::error::CompensateError;
use super::placement::keep;
use crate::program::Program;
use crate::program::motion::{Motion, Origin, SkipReason, Target};
use wildmatch::WildMatch;

/// Names with `*` and `?`, in any case.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Selection {
    /// What these name is left alone: `--keep`.
    pub keep: Vec<String>,
    /// Where there is one, only what these name is corrected: `--only`.
    pub only: Vec<String>,
}

impl Selection {
    /// For each motion why it is left alone, where it is.
    ///
    /// # Errors
    /// [`CompensateError::Selection`] for a pattern that names nothing: a typing error would otherwise move the arm.
    pub(super) fn of(&self, program: &Program) -> Result<Vec<Option<SkipReason>>, CompensateError> {
        if self.keep.is_empty() && self.only.is_empty() {
            return Ok(Vec::new());
        }
        let [mut keep_patterns, mut only_patterns] = [&self.keep, &self.only].map(|all| patterns(all));
        let one = |motion: &Motion| {
            let names = names(program, motion);
            let kept = first_match(&mut keep_patterns, &names);
            let named = first_match(&mut only_patterns, &names);
            match (kept, named) {
                (Some(by), _) => Some(keep("keep::as-asked", format!("--keep {by} leaves it alone"))),
                (None, None) if !self.only.is_empty() => {
                    Some(keep("keep::as-asked", "--only names other motions alone".to_owned()))
                }
                _ => None,
            }
        };
        let found = program.motions.iter().map(one).collect();
        let all = [("--keep", keep_patterns), ("--only", only_patterns)];
        for (option, patterns) in all {
            if let Some(unused) = patterns.into_iter().find(|pattern| !pattern.used) {
                return Err(CompensateError::Selection { option, pattern: unused.written });
            }
        }
        Ok(found)
    }
}

struct Pattern {
    written: String,
    matcher: WildMatch,
    used: bool,
}

fn patterns(written: &[String]) -> Vec<Pattern> {
    let pattern = |written: &String| Pattern {
        written: written.clone(),
        matcher: WildMatch::new_case_insensitive(written),
        used: false,
    };
    written.iter().map(pattern).collect()
}

/// The first pattern that fits one of the names; all that fit are marked as used.
fn first_match(patterns: &mut [Pattern], names: &[&str]) -> Option<String> {
    let mut first = None;
    for pattern in patterns {
        if names.iter().any(|name| pattern.matcher.matches(name)) {
            pattern.used = true;
            first.get_or_insert_with(|| pattern.written.clone());
        }
    }
    first
}

/// The names that a motion goes by: its targets', its routine's, its module's.
fn names<'p>(program: &'p Program, motion: &'p Motion) -> Vec<&'p str> {
    let target = |target: &'p Target| match target.origin() {
        Origin::Named { name, .. } => Some(name.as_str()),
        Origin::Inline | Origin::Expression => None,
    };
    let routine = program.routines.get(motion.setup.routine.index());
    let routine = routine.into_iter().flat_map(|routine| [routine.name.as_str(), routine.module.as_str()]);
    motion.targets.iter().filter_map(target).chain(routine).collect()
}
