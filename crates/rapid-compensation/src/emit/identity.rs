//! Whether a program is another one but for the targets of its motions: the proof that a review of
//! targets is a review of everything.

use super::header;
use super::restore::{Altered, ModifiedTarget, RestoreError, altered_core, restore};
use crate::compensate::compare::is_comparable;
use rapid_program::{FilePairs, Overrides, Program};
use rapid_syntax::diagnostic::{FileId, Span, TextRange};
use rapid_syntax::{SourceFile, first_difference};
use std::collections::BTreeSet;

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
    /// Two compensated modules that were made with different options, or with different clocks.
    MadeOtherwise {
        /// Module as the first program names it.
        before: String,
        /// Module as the second program names it.
        after: String,
        /// What they were made with, where that differs: name of the option, and its values.
        what: Vec<(String, [String; 2])>,
    },
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

/// Why targets that differ are not what a compensated module declares.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Undeclared {
    /// Neither program holds a compensated module.
    NoneCompensated,
    /// Both hold one.
    BothCompensated,
    /// Something beside the targets of motions differs.
    Elsewhere,
    /// An original that a compensated module holds, or the correction that a motion asks with, is not the one that it was made with.
    Touched {
        /// The file of the module.
        file: String,
        /// Line of the original.
        line: u32,
        /// The target's name, or its text where it is written out.
        target: String,
        /// How many more there are.
        more: usize,
    },
    /// A compensated module was made of another original: its text differs from the other program's, from this line of that program on.
    OtherOriginal {
        /// The file of the original.
        file: String,
        /// The first line of the original that the module was not made of.
        line: u32,
    },
}

/// Two programs without what compensation added to them.
pub struct WithoutAdded {
    /// The program before the change.
    pub before: Program,
    /// The program after it.
    pub after: Program,
    /// Which of their files stand for each other.
    pub pairs: FilePairs,
    /// What differs beside the targets of motions.
    pub differences: Vec<Difference>,
    /// Why it is not so that one of the two holds no compensated module and the other, with nothing touched up in it since, gives it back.
    pub undeclared: Option<Undeclared>,
}

impl WithoutAdded {
    /// Compares two programs token by token, what this program adds to a module taken out first, targets of
    /// motions left out where they can be compared as poses.
    ///
    /// The common module of a compensated program counts as what was added.
    #[must_use]
    pub fn of(before: &Program, after: &Program, pairs: &FilePairs, overrides: &Overrides) -> Self {
        let mut differences: Vec<Difference> =
            pairs.pairs.iter().filter_map(|(a, b)| made_otherwise(before.file(*a), after.file(*b))).collect();
        let before = RestoredProgram::of(before, overrides, &mut differences);
        let after = RestoredProgram::of(after, overrides, &mut differences);
        let mut restored = FilePairs::default();
        for (a, b) in &pairs.pairs {
            match (before.file(*a), after.file(*b)) {
                (Some(a), Some(b)) => {
                    differences.extend(text_difference((&before.program, a), (&after.program, b)));
                    restored.pairs.push((a, b));
                }
                (Some(a), None) => restored.only_before.push(a),
                (None, Some(b)) => restored.only_after.push(b),
                (None, None) => {}
            }
        }
        restored.only_before.extend(pairs.only_before.iter().filter_map(|file| before.file(*file)));
        restored.only_after.extend(pairs.only_after.iter().filter_map(|file| after.file(*file)));
        let missing = restored.only_before.iter().flat_map(|file| before.modules(*file));
        differences.extend(missing.map(Difference::Missing));
        let added = restored.only_after.iter().flat_map(|file| after.modules(*file));
        differences.extend(added.map(Difference::Added));
        differences.dedup();
        let compensated = [before.is_compensated, after.is_compensated];
        let touched: Vec<(String, ModifiedTarget)> =
            before.touched.into_iter().chain(after.touched).collect();
        let mut found = Self {
            before: before.program,
            after: after.program,
            pairs: restored,
            differences,
            undeclared: None,
        };
        found.undeclared = found.why_undeclared(compensated, &touched);
        found
    }

    fn why_undeclared(
        &self,
        compensated: [bool; 2],
        touched: &[(String, ModifiedTarget)],
    ) -> Option<Undeclared> {
        let FilePairs { pairs, only_before, only_after } = &self.pairs;
        let is_whole = only_before.is_empty() && only_after.is_empty() && self.differences.is_empty();
        match compensated {
            [false, false] => return Some(Undeclared::NoneCompensated),
            [true, true] => return Some(Undeclared::BothCompensated),
            _ if !is_whole => return Some(Undeclared::Elsewhere),
            _ => {}
        }
        if let [(file, first), more @ ..] = touched {
            let (file, line, target) = (file.clone(), first.line, first.target.clone());
            return Some(Undeclared::Touched { file, line, target, more: more.len() });
        }
        let (original, other) =
            if compensated[0] { (&self.after, &self.before) } else { (&self.before, &self.after) };
        pairs.iter().find_map(|(a, b)| {
            let (a, b) = if compensated[0] { (b, a) } else { (a, b) };
            let (a, b) = (original.file(*a), other.file(*b));
            if a.bytes == b.bytes {
                return None;
            }
            let same = a.bytes.iter().zip(b.bytes.iter()).take_while(|(a, b)| a == b).count();
            let at = u32::try_from(same).unwrap_or(u32::MAX);
            Some(Undeclared::OtherOriginal { file: a.path.clone(), line: a.lines.line(at) })
        })
    }

    /// Whether the text of all files that stand for each other is the same.
    #[must_use]
    pub fn is_same_text(&self) -> bool {
        self.pairs.pairs.iter().all(|(a, b)| self.before.file(*a).bytes == self.after.file(*b).bytes)
    }
}

/// Where two files of compensated modules were made otherwise.
fn made_otherwise(a: &SourceFile, b: &SourceFile) -> Option<Difference> {
    if header::is_made_otherwise(&a.bytes, &b.bytes) != Some(true) {
        return None;
    }
    let [first, second] = [a, b].map(|file| header::made_with(&file.bytes).unwrap_or_default());
    let value = |all: &[(String, String)], name: &str| {
        all.iter()
            .find(|(known, _)| known == name)
            .map_or_else(|| "none".to_owned(), |(_, value)| value.clone())
    };
    let mut names: Vec<&String> = first.iter().chain(&second).map(|(name, _)| name).collect();
    let mut seen = BTreeSet::new();
    names.retain(|name| seen.insert(*name));
    let both = |name: &String| (name.clone(), [value(&first, name), value(&second, name)]);
    let what = names.into_iter().map(both).filter(|(_, [a, b])| a != b).collect();
    Some(Difference::MadeOtherwise { before: a.path.clone(), after: b.path.clone(), what })
}

fn text_difference((before, a): (&Program, FileId), (after, b): (&Program, FileId)) -> Option<Difference> {
    let (free_a, free_b) = (free(before, a), free(after, b));
    let (a, b) = (before.file(a), after.file(b));
    let (at_a, at_b) = first_difference(&a.bytes, &free_a, &b.bytes, &free_b)?;
    let before = (a.path.clone(), a.lines.line(at_a));
    Some(Difference::Text { before, after: (b.path.clone(), b.lines.line(at_b)) })
}

/// A program without what was added to it.
struct RestoredProgram {
    program: Program,
    /// For each of its files the one that it was made of.
    origin: Vec<FileId>,
    /// Whether any of its modules is a compensated one.
    is_compensated: bool,
    /// Points of compensated modules that were touched up, each with its file.
    touched: Vec<(String, ModifiedTarget)>,
}

impl RestoredProgram {
    fn of(program: &Program, overrides: &Overrides, found: &mut Vec<Difference>) -> Self {
        let compensated = |file: &SourceFile| {
            program.facts.modules.iter().any(|m| m.file == file.id && m.compensated.is_some())
        };
        let mut files: Vec<SourceFile> = Vec::new();
        let (mut origin, mut touched) = (Vec::new(), Vec::new());
        for file in &program.files {
            let bytes = match compensated(file).then(|| restore(&file.bytes)) {
                None => file.bytes.clone(),
                Some(Ok(restored)) => {
                    touched.extend(restored.touched.into_iter().map(|one| (file.path.clone(), one)));
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
            origin.push(file.id);
        }
        let is_compensated = program.files.iter().any(compensated);
        Self { program: Program::read(files, overrides), origin, is_compensated, touched }
    }

    /// What became of a file; `None` where all of it was added.
    fn file(&self, of: FileId) -> Option<FileId> {
        Some(FileId(self.origin.iter().position(|file| *file == of)? as u32))
    }

    fn modules(&self, file: FileId) -> impl Iterator<Item = String> + '_ {
        let path = &self.program.file(file).path;
        let modules = self.program.facts.modules.iter().filter(move |module| module.file == file);
        modules.map(move |module| format!("{} ({path})", module.name))
    }
}

fn altered(file: &SourceFile, list: Vec<Altered>) -> impl Iterator<Item = Difference> {
    let file = file.path.clone();
    list.into_iter().map(move |what| Difference::Altered { file: file.clone(), what })
}

/// The targets of a file's motions and the values of targets that are declared in it.
fn free(program: &Program, file: FileId) -> Vec<TextRange> {
    let targets = program.motions.iter().filter(|motion| is_comparable(motion)).flat_map(|motion| {
        let own = motion.targets.iter().map(|target| Span { file: motion.file, range: target.range });
        own.chain(motion.targets.iter().filter_map(|target| target.literal(motion.file)))
    });
    let mut free: Vec<TextRange> = targets.filter(|span| span.file == file).map(|span| span.range).collect();
    sorting::by_key(&mut free, |range| (range.start, range.end));
    free.dedup();
    free
}
