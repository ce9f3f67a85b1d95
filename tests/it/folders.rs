//! Folders of RAPID that tests go through: the fixtures, and a corpus that is no part of the repository.

use std::path::{Path, PathBuf};

/// The folder of the fixtures.
pub(crate) fn fixtures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures")
}

/// The folder that `DRIFTPOST_CORPUS` names; tests that need it are ignored unless asked for.
pub(crate) fn corpus() -> PathBuf {
    let folder = std::env::var_os("DRIFTPOST_CORPUS").map(PathBuf::from);
    folder.filter(|f| f.is_dir()).expect("DRIFTPOST_CORPUS names a folder of RAPID programs")
}

/// All files below a folder, in order of path.
pub(crate) fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut entries: Vec<_> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    entries.sort();
    entries.into_iter().flat_map(|path| if path.is_dir() { files_below(&path) } else { vec![path] }).collect()
}

/// All files below a folder that end as RAPID modules do.
pub(crate) fn modules_below(folder: &Path) -> Vec<PathBuf> {
    let is_module = |path: &PathBuf| {
        let ending = path.extension().map(|e| e.to_string_lossy().to_lowercase());
        ending.is_some_and(|e| ["mod", "modx", "prg", "sys", "sysx"].contains(&e.as_str()))
    };
    files_below(folder).into_iter().filter(is_module).collect()
}
