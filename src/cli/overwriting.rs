//! Which files that stand where a result is to go may be overwritten.

use super::copies::Copies;
use super::files::{self, PENDING};
use crate::application::EarlierResult;
use rapid_syntax::diagnostic::Diagnostic;
use std::fs;
use std::path::{Path, PathBuf};

/// Refuses to overwrite a result that was changed since it was written: touched up, or saved back by a controller.
///
/// # Errors
/// `output::changed`, naming the file.
pub fn check_result(path: &Path) -> Result<(), Diagnostic> {
    let is_file = fs::metadata(path).is_ok_and(|metadata| metadata.is_file());
    let Some(bytes) = is_file.then(|| fs::read(path).ok()).flatten() else { return Ok(()) };
    if EarlierResult::of(&bytes) == Some(EarlierResult::Altered) {
        let text = format!("{} was changed since it was written", path.display());
        return Err(Diagnostic::error("output::changed", text).help(
            "get what was touched up with `driftpost restore`, name another place with -o, or say --force",
        ));
    }
    Ok(())
}

/// Refuses to overwrite a copy that was changed since it was put into the result's folder; `new` is what would stand there.
///
/// # Errors
/// `output::changed`, naming the file.
pub fn check_copy(copies: &Copies, to: &Path, new: impl FnOnce() -> Vec<u8>) -> Result<(), Diagnostic> {
    let Some(there) = to.is_file().then(|| fs::read(to).ok()).flatten() else { return Ok(()) };
    if there == new() || EarlierResult::of(&there).is_some() || copies.is_as_copied(to, &there) {
        return Ok(());
    }
    let text = format!("{} was changed since it was written, or is no result of this program", to.display());
    Err(Diagnostic::error("output::changed", text)
        .help("take it away, name another place with -o, or say --force"))
}

/// Why a common module that is there already must stay; `None` where it may be written.
pub fn of_another_program(core: &Path, bytes: &[u8], outputs: &[&Path]) -> Option<String> {
    let there = fs::read(core).ok()?;
    if there == bytes {
        return None;
    }
    if EarlierResult::of(&there).is_none() {
        return Some("it is no module of this program's making".to_owned());
    }
    // Of this program alone where all compensated modules beside it are written anew.
    let written: Vec<PathBuf> = outputs.iter().map(|path| files::identity(path)).collect();
    let beside = fs::read_dir(core.parent()?).ok()?;
    let mut others: Vec<PathBuf> = beside.filter_map(|entry| Some(entry.ok()?.path())).collect();
    others.sort();
    let other = others.into_iter().find(|path| {
        path.is_file()
            && !path.file_name().is_some_and(|name| name.to_string_lossy().starts_with(PENDING))
            && !written.contains(&files::identity(path))
            && fs::read(path).is_ok_and(|bytes| EarlierResult::of(&bytes).is_some())
    })?;
    Some(format!("{} was made with it", other.display()))
}
