//! Which motions are to be left alone, by the names of their targets, routines and modules.

use super::error::CompensateError;
use super::placement::skip;
use rapid_program::Program;
use rapid_program::motion::{Motion, Origin, SkipReason};
use std::collections::BTreeSet;
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
                (Some(by), _) => Some(skip("keep::as-asked", format!("--keep {by} leaves it alone"))),
                (None, None) if !self.only.is_empty() => {
                    Some(skip("keep::as-asked", "--only names other motions alone".to_owned()))
                }
                _ => None,
            }
        };
        let found = program.motions.iter().map(one).collect();
        let all = [("--keep", keep_patterns), ("--only", only_patterns)];
        for (option, patterns) in all {
            if let Some(unused) = patterns.into_iter().find(|pattern| !pattern.used) {
                let names = known_names(program);
                return Err(CompensateError::Selection { option, pattern: unused.written, names });
            }
        }
        Ok(found)
    }
}

/// Names that a message lists at most.
const MOST_NAMES: usize = 8;

/// Names that motions go by: modules and routines first, then targets; an ellipsis where there are more.
fn known_names(program: &Program) -> Vec<String> {
    let (mut of_routines, mut of_targets) = (BTreeSet::new(), BTreeSet::new());
    for motion in &program.motions {
        let routine = program.routine_of(motion);
        of_routines.extend(routine.into_iter().flat_map(|r| [r.module.as_str(), r.name.as_str()]));
        of_targets.extend(target_names(motion));
    }
    let mut names: Vec<String> = of_routines.into_iter().chain(of_targets).map(str::to_owned).collect();
    if names.len() > MOST_NAMES {
        names.truncate(MOST_NAMES);
        names.push("...".to_owned());
    }
    names
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

/// The names that a motion goes by: its targets' and those that its targets are made of (`p30` of `Offs(p30,0,0,10)`), its routine's, its
/// module's.
fn names<'p>(program: &'p Program, motion: &'p Motion) -> Vec<&'p str> {
    let routine = program.routine_of(motion);
    let routine = routine.into_iter().flat_map(|routine| [routine.name.as_str(), routine.module.as_str()]);
    target_names(motion).chain(routine).collect()
}

fn target_names(motion: &Motion) -> impl Iterator<Item = &str> {
    motion.targets.iter().flat_map(|target| {
        match target.origin() {
            Origin::Named { name, .. } => std::slice::from_ref(name),
            Origin::Expression(names) => names,
            Origin::Inline => &[],
        }
        .iter()
        .map(String::as_str)
    })
}
