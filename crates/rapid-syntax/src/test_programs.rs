//! What tests read: the RAPID programs of the fixtures, and chance to change them by.

use std::path::{Path, PathBuf};

/// The bytes of every RAPID program of the fixtures, in order of path.
pub(crate) fn programs() -> Vec<Vec<u8>> {
    let mut paths = Vec::new();
    programs_below(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures"), &mut paths);
    assert!(paths.len() > 50, "{}", paths.len());
    sorting::ascending(&mut paths);
    paths.iter().map(|path| std::fs::read(path).unwrap()).collect()
}

fn programs_below(folder: &Path, into: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let named = |name: &str| path.extension().is_some_and(|e| e.eq_ignore_ascii_case(name));
        if path.is_dir() {
            programs_below(&path, into);
        } else if ["mod", "sys", "prg"].into_iter().any(named) {
            into.push(path);
        }
    }
}

/// Numbers that look drawn, the same in every run.
pub(crate) struct Chance(u64);

impl Chance {
    pub(crate) fn new() -> Self {
        Self(0x9E37_79B9_7F4A_7C15)
    }

    pub(crate) fn below(&mut self, end: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as usize % end
    }
}
