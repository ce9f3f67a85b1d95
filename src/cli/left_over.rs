//! What an earlier run left in the folder of a result and this one did not write: a module that is there under another file now, or is no
//! longer in the program. No controller loads such a folder whole, or it loads what was made for another program.

use super::destination::Destination;
use super::files;
use super::overwriting::asks;
use super::pending::folder_of;
use super::program_at::{bytes_of_file, module_names};
use super::program_input::{is_module, walk};
use crate::application::EarlierResult;
use rapid_program::task_of;
use rapid_syntax::diagnostic::Diagnostic;
use std::path::{Path, PathBuf};

/// A module that this run writes.
pub struct WrittenModule {
    /// Where it stands in the folder of the result.
    pub path: PathBuf,
    /// The module's name, as its MODULE line has it.
    pub name: String,
    /// It holds clock and functions, which the others ask.
    pub is_core: bool,
}

/// A warning for each such file; none where the result is no folder.
#[must_use]
pub fn left_over(destination: &Destination, written: &[WrittenModule]) -> Vec<Diagnostic> {
    let Some(copies) = &destination.copies else { return Vec::new() };
    let mut there = Vec::new();
    // A folder that cannot be read to its end holds what was found until then.
    let _ = walk(copies.folder(), &mut there);
    let outputs = written.iter().map(|module| &module.path).chain(&destination.modules);
    let outputs: Vec<PathBuf> = outputs.map(|path| files::identity(path)).collect();
    let is_another = |path: &PathBuf| is_module(path) && !outputs.contains(&files::identity(path));
    let others = there.into_iter().filter(is_another);
    others
        .filter_map(|path| {
            let bytes = bytes_of_file(&path)?;
            let is_ours = EarlierResult::of(&bytes).is_some() || copies.is_as_copied(&path, &bytes);
            if !is_ours { None } else { warning(&path, bytes, written) }
        })
        .collect()
}

/// That a file of an earlier run gets in the way of what is written.
fn warning(path: &Path, bytes: Vec<u8>, written: &[WrittenModule]) -> Option<Diagnostic> {
    let task = |path: &Path| task_of(&path.to_string_lossy()).map(str::to_ascii_lowercase);
    let of_task = || written.iter().filter(|module| task(&module.path) == task(path));
    let asked = of_task().find(|core| {
        core.is_core
            && folder_of(&core.path) == folder_of(path)
            && asks(&bytes, &[core.name.to_ascii_lowercase()])
    });
    let names = module_names(path, bytes);
    let same = of_task().find(|module| names.contains(&module.name.to_ascii_lowercase()));
    let (text, help) = match (same, asked) {
        (Some(same), _) => (
            format!(
                "{} is left from an earlier run and declares module {}, as {} does: no controller loads both",
                path.display(),
                same.name,
                same.path.display()
            ),
            format!("delete {}: the module is in the other file now", path.display()),
        ),
        (None, Some(core)) => (
            format!(
                "{} is left from an earlier run, asks {} and is not written by this one",
                path.display(),
                core.path.display()
            ),
            format!(
                "delete {} if its module is no longer in the program; else compensate it with the others",
                path.display()
            ),
        ),
        (None, None) => return None,
    };
    Some(Diagnostic::warning("output::left-over", text).help(help))
}
