//! Which file of one program stands for which of another: by their places first, as every backup of a controller has a
//! `MainModule` in each task.

use super::Program;
use rapid_syntax::diagnostic::FileId;
use std::collections::BTreeSet;

/// Files of two programs that stand for each other.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FilePairs {
    /// A file of the first program and its counterpart of the second, in the order of the first.
    pub pairs: Vec<(FileId, FileId)>,
    /// Files of the first program without a counterpart.
    pub only_before: Vec<FileId>,
    /// Files of the second program without a counterpart.
    pub only_after: Vec<FileId>,
}

impl FilePairs {
    /// Pairs the files of two programs; `places` are their paths relative to what was given, `/` between folders.
    ///
    /// Files at the same place belong together, in whatever case; of the rest those with the same module, where each has
    /// just one such file; and the last one left of each with the other's.
    #[must_use]
    pub fn new(before: (&Program, &[String]), after: (&Program, &[String])) -> Self {
        let mut found = Pairing {
            left: [before.0, after.0].map(|program| program.files.iter().map(|file| file.id).collect()),
            pairs: Vec::new(),
        };
        let place = |places: &[String], file: FileId| Some(places.get(file.0 as usize)?.to_lowercase());
        found.by(|file| place(before.1, file), |file| place(after.1, file));
        found.by(|file| module(before.0, file), |file| module(after.0, file));
        found.by(|_| Some(String::new()), |_| Some(String::new()));
        let Pairing { left: [only_before, only_after], mut pairs } = found;
        sorting::ascending(&mut pairs);
        Self {
            pairs,
            only_before: only_before.into_iter().collect(),
            only_after: only_after.into_iter().collect(),
        }
    }

    /// The number of the pair that a file belongs to.
    #[must_use]
    pub fn of(&self, before: bool, file: FileId) -> Option<usize> {
        self.pairs.iter().position(|(a, b)| file == if before { *a } else { *b })
    }
}

/// Files that are not paired yet.
struct Pairing {
    left: [BTreeSet<FileId>; 2],
    pairs: Vec<(FileId, FileId)>,
}

impl Pairing {
    /// Pairs the files of one key, where it is that of one file only on either side.
    fn by(&mut self, before: impl Fn(FileId) -> Option<String>, after: impl Fn(FileId) -> Option<String>) {
        let [ours, theirs] = self.left.clone();
        for &file in &ours {
            let Some(key) = before(file) else { continue };
            let same = |key_of: Option<String>| key_of.as_deref() == Some(key.as_str());
            let mut others = theirs.iter().filter(|other| same(after(**other)));
            let alone = ours.iter().filter(|own| same(before(**own))).count() == 1;
            if let (Some(&other), None, true) = (others.next(), others.next(), alone) {
                self.left[0].remove(&file);
                self.left[1].remove(&other);
                self.pairs.push((file, other));
            }
        }
    }
}

/// The name of a file's first module.
fn module(program: &Program, file: FileId) -> Option<String> {
    Some(program.facts.modules.iter().find(|module| module.file == file)?.name.to_lowercase())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Overrides;
    use rapid_syntax::SourceFile;

    fn program(files: &[(&str, &str)]) -> (Program, Vec<String>) {
        let read = |(id, (place, module)): (usize, &(&str, &str))| {
            SourceFile::read(FileId(id as u32), *place, format!("MODULE {module}\nENDMODULE\n").into_bytes())
        };
        let sources = files.iter().enumerate().map(read).collect();
        let places = files.iter().map(|(place, _)| (*place).to_owned()).collect();
        (Program::read(sources, &Overrides::default()), places)
    }

    fn pairs(before: &[(&str, &str)], after: &[(&str, &str)]) -> (Vec<(u32, u32)>, usize, usize) {
        let ((a, a_places), (b, b_places)) = (program(before), program(after));
        let found = FilePairs::new((&a, &a_places), (&b, &b_places));
        let pairs = found.pairs.iter().map(|(a, b)| (a.0, b.0)).collect();
        (pairs, found.only_before.len(), found.only_after.len())
    }

    #[test]
    fn places_come_before_names_of_modules() {
        let task = |n: u32| (format!("TASK{n}/PROGMOD/MainModule.mod"), "MainModule");
        let (one, two) = (task(1), task(2));
        let backup = [(one.0.as_str(), one.1), (two.0.as_str(), two.1)];
        let turned = [(two.0.as_str(), two.1), (one.0.as_str(), one.1), ("TASK1/tcCore.mod", "tcCore")];
        assert_eq!(pairs(&backup, &turned), (vec![(0, 1), (1, 0)], 0, 1));
        // Renamed files go by their module, where it is one on either side.
        assert_eq!(
            pairs(&[("A.mod", "m"), ("B.mod", "n")], &[("x.mod", "N"), ("y.mod", "M")]).0,
            [(0, 1), (1, 0)]
        );
        assert_eq!(pairs(&[("A.mod", "m"), ("B.mod", "m")], &[("x.mod", "m")]), (vec![], 2, 1));
        // One file against one, whatever they are called.
        assert_eq!(pairs(&[("p.mod", "m")], &[("p_tc.mod", "n")]).0, [(0, 0)]);
    }
}
