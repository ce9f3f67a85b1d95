//! Whether a program is another one but for the targets of its motions: the proof that a review of
//! targets is a review of everything.

use super::restore::{Altered, RestoreError, altered_core, restore};
use crate::program::{Overrides, Program};
use rapid_syntax::diagnostic::{FileId, Span, TextRange};
use rapid_syntax::{SourceFile, first_difference};

/// Where two programs differ beside the targets of their motions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Difference {
    /// Their text, from here on.
    Text {
        /// Line of the first program, from 1.
        before: (String, u32),
        /// Line of the second, from 1; of its restored text where it is a compensated module.
        after: (String, u32),
    },
    /// A module of the first program is not in the second.
    Missing(String),
    /// A module of the second program is not in the first.
    Added(String),
    /// What was added to a compensated module is not as it was made.
    Altered {
        /// The file of the module.
        file: String,
        /// What was changed in it.
        what: Altered,
    },
    /// A compensated module of the second program was edited where it must not be.
    Damaged {
        /// The file of the module.
        file: String,
        /// What is wrong with it.
        error: RestoreError,
    },
}

/// Compares two programs token by token, what this program adds to a module taken out first, targets of
/// motions left out.
///
/// Modules are matched by name; the common module of a compensated program counts as what was added.
#[must_use]
pub fn differences(before: &Program, after: &Program) -> Vec<Difference> {
    let mut found = Vec::new();
    let before = plain(before, &mut found);
    let after = plain(after, &mut found);
    for (name, file) in modules(&before) {
        let Some((_, other)) = modules(&after).find(|(other, _)| other.eq_ignore_ascii_case(name)) else {
            found.push(Difference::Missing(name.to_owned()));
            continue;
        };
        let (a, b) = (before.file(file), after.file(other));
        let at = first_difference(&a.bytes, &free(&before, file), &b.bytes, &free(&after, other));
        if let Some((at_a, at_b)) = at {
            let before = (a.path.clone(), a.lines.line(at_a));
            found.push(Difference::Text { before, after: (b.path.clone(), b.lines.line(at_b)) });
        }
    }
    let known: Vec<&str> = modules(&before).map(|(name, _)| name).collect();
    for (name, _) in modules(&after) {
        if !known.iter().any(|known| known.eq_ignore_ascii_case(name)) {
            found.push(Difference::Added(name.to_owned()));
        }
    }
    found.dedup();
    found
}

fn modules(program: &Program) -> impl Iterator<Item = (&str, FileId)> {
    program.facts.modules.iter().map(|module| (module.name.as_str(), module.file))
}

/// The program without what was added to it.
fn plain(program: &Program, found: &mut Vec<Difference>) -> Program {
    let compensated = |file: &SourceFile| {
        program.facts.modules.iter().any(|m| m.file == file.id && m.compensated.is_some())
    };
    let mut files: Vec<SourceFile> = Vec::new();
    for file in &program.files {
        let bytes = match compensated(file).then(|| restore(&file.bytes)) {
            None => file.bytes.clone(),
            Some(Ok(restored)) => {
                found.extend(altered(file, restored.altered));
                restored.bytes.into()
            }
            Some(Err(RestoreError::IsCore)) => {
                found.extend(altered(file, altered_core(&file.bytes)));
                continue;
            }
            Some(Err(error)) => {
                found.push(Difference::Damaged { file: file.path.clone(), error });
                file.bytes.clone()
            }
        };
        files.push(SourceFile::read(FileId(files.len() as u32), file.path.clone(), bytes));
    }
    Program::read(files, &Overrides::default())
}

fn altered(file: &SourceFile, list: Vec<Altered>) -> impl Iterator<Item = Difference> {
    let file = file.path.clone();
    list.into_iter().map(move |what| Difference::Altered { file: file.clone(), what })
}

/// The targets of a file's motions and the values of targets that are declared in it.
fn free(program: &Program, file: FileId) -> Vec<TextRange> {
    let targets = program.motions.iter().flat_map(|motion| {
        let own = motion.targets.iter().map(|target| Span { file: motion.file, range: target.range });
        own.chain(motion.targets.iter().filter_map(|target| target.literal(motion.file)))
    });
    let mut free: Vec<TextRange> = targets.filter(|span| span.file == file).map(|span| span.range).collect();
    free.sort_unstable_by_key(|range| (range.start, range.end));
    free.dedup();
    free
}
