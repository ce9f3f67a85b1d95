//! What stands in a place where something is to be written: a program is seldom meant to go.

use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{Diagnostic, FileId};
use rapid_syntax::tree::FileItem;
use std::fs;
use std::path::Path;

/// What stands in a regular file; `None` of a pipe or device, which may give nothing for ever, and where nothing is.
pub(super) fn bytes_of_file(path: &Path) -> Option<Vec<u8>> {
    path.is_file().then(|| fs::read(path).ok()).flatten()
}

/// Whether a text holds a RAPID module.
pub(super) fn holds_module(path: &Path, bytes: Vec<u8>) -> bool {
    !module_names(path, bytes).is_empty()
}

/// Names of the modules in a text, in lower case.
pub(super) fn module_names(path: &Path, bytes: Vec<u8>) -> Vec<String> {
    let file = SourceFile::read(FileId(0), path.display().to_string(), bytes);
    let name = |item: &FileItem| match item {
        FileItem::Module(module) => {
            Some(String::from_utf8_lossy(file.text(module.name)).to_ascii_lowercase())
        }
        _ => None,
    };
    file.tree.items.iter().filter_map(name).collect()
}

/// That what stands at `path` is kept, and why.
pub(super) fn kept(path: &Path, why: &str, help: &'static str) -> Diagnostic {
    Diagnostic::error("output::changed", format!("{} {why}", path.display())).help(help)
}

/// Whether a text begins with a module, a comment, or the head of a saved file: a list of differences, or JSON with RAPID in its strings, does not.
pub(super) fn begins_as_program(bytes: &[u8]) -> bool {
    let text = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes).trim_ascii_start();
    let is_module = text.get(..6).is_some_and(|head| head.eq_ignore_ascii_case(b"MODULE"));
    is_module || text.starts_with(b"%%%") || text.starts_with(b"!")
}

/// Refuses to overwrite a program with what is none: a table, JSON, a list of differences.
///
/// # Errors
/// `output::changed`, naming the file.
pub fn check_no_program(path: &Path) -> Result<(), Diagnostic> {
    let Some(bytes) = bytes_of_file(path) else { return Ok(()) };
    if !begins_as_program(&bytes) || !holds_module(path, bytes) {
        return Ok(());
    }
    Err(kept(
        path,
        "is a program, and what would be written over it is none",
        "name another place, or take it away",
    ))
}
