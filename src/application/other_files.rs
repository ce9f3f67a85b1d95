//! A program with what lies beside its modules, and what differs there between two.

use super::program_files::ProgramFiles;
use rapid_compensation::emit::{RestoreError, restore};
use rapid_program::{modules_of_pgf, pgf_with_module};
use rapid_syntax::diagnostic::Diagnostic;

/// Reads a file that is no module, by its place.
pub type ReadOther<'f> = dyn Fn(&str) -> Result<Vec<u8>, Diagnostic> + 'f;

/// A program, where its modules stand within it, and the files that are no modules.
pub struct PlacedProgram<'f> {
    /// The modules.
    pub files: ProgramFiles,
    /// The place of each, relative to what was given, `/` between folders.
    pub places: Vec<String>,
    /// Places of the files that are no modules, in order.
    pub others: Vec<String>,
    /// Reads one of `others`.
    pub read: Box<ReadOther<'f>>,
}

impl PlacedProgram<'_> {
    /// A program of modules alone, each at its path.
    #[must_use]
    pub fn of(files: ProgramFiles) -> Self {
        let places = files.iter().map(|(path, _)| path.to_owned()).collect();
        Self { files, places, others: Vec::new(), read: Box::new(|_| Ok(Vec::new())) }
    }
}

/// What differs among the files that are no modules, a sentence each.
pub(super) fn other_files(
    before: &PlacedProgram<'_>,
    after: &PlacedProgram<'_>,
) -> Result<Vec<String>, Diagnostic> {
    let mut found = Vec::new();
    for place in &before.others {
        let Some(other) = counterpart(place, &before.others, &after.others) else {
            found.push(format!("{place} is only in the first program."));
            continue;
        };
        let (a, b) = ((before.read)(place)?, (after.read)(other)?);
        if a != b && !lists_the_core(&a, &b, after) {
            found.push(format!("{place} differs."));
        }
    }
    for place in
        after.others.iter().filter(|place| counterpart(place, &after.others, &before.others).is_none())
    {
        found.push(format!("{place} is only in the second program."));
    }
    Ok(found)
}

/// The file at the same place of the other side; or its list of modules, where each side has one alone, under a name of its own.
fn counterpart<'f>(place: &String, own: &[String], others: &'f [String]) -> Option<&'f String> {
    let is_list =
        |place: &&String| place.rsplit_once('.').is_some_and(|(_, e)| e.eq_ignore_ascii_case("pgf"));
    let lists = |files: &[String]| files.iter().filter(is_list).count();
    let alone = is_list(&place) && lists(own) == 1 && lists(others) == 1;
    let same = others.iter().find(|other| *other == place);
    same.or_else(|| others.iter().find(|other| alone && is_list(other)))
}

/// Whether a `.pgf` differs from another in naming the common module of compensated ones alone.
fn lists_the_core(before: &[u8], after: &[u8], given: &PlacedProgram<'_>) -> bool {
    let listed = modules_of_pgf(before);
    let new: Vec<String> =
        modules_of_pgf(after).into_iter().filter(|module| !listed.contains(module)).collect();
    let is_core = |module: &String| {
        let modules = given.places.iter().zip(given.files.iter());
        let named = modules.into_iter().find(|(place, _)| place.ends_with(module.as_str()));
        named.is_some_and(|(_, (_, bytes))| restore(bytes).err() == Some(RestoreError::IsCore))
    };
    let expected = new.iter().fold(before.to_vec(), |list, module| pgf_with_module(&list, module));
    new.iter().all(is_core) && expected == after
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(others: &[(&'static str, &'static str)]) -> PlacedProgram<'static> {
        let files: Vec<_> = others.to_vec();
        PlacedProgram {
            others: files.iter().map(|(place, _)| (*place).to_owned()).collect(),
            read: Box::new(move |place| {
                Ok(files
                    .iter()
                    .find(|(known, _)| *known == place)
                    .map(|(_, text)| text.as_bytes().to_vec())
                    .unwrap())
            }),
            ..PlacedProgram::of(ProgramFiles::default())
        }
    }

    #[test]
    fn files_that_are_no_modules_are_compared_by_their_places() {
        let before = with(&[("a.txt", "1"), ("b.txt", "2"), ("cell.pgf", "<Program/>"), ("only.txt", "")]);
        let after = with(&[("a.txt", "1"), ("b.txt", "3"), ("new.txt", ""), ("other.pgf", "<Program/>")]);
        let changed = [
            "b.txt differs.",
            "only.txt is only in the first program.",
            "new.txt is only in the second program.",
        ];
        assert_eq!(other_files(&before, &after).unwrap(), changed);
    }
}
