//! Whether the modules of a compensated program and their common module are of one run: a clock of another one corrects by another amount.

use super::program_files::ProgramFiles;
use rapid_compensation::emit::{CommonModule, common_module, made_with};
use rapid_program::task_of;
use rapid_syntax::diagnostic::Diagnostic;

/// A module that asks a common one.
struct Asking<'f> {
    path: &'f str,
    task: Option<String>,
    /// What the common module is known by; empty of an older one.
    common: Vec<u8>,
    settings: Vec<(String, String)>,
}

/// What is said of modules whose common module is another run's, or is not there though `is_whole`, all of the program, is given.
pub(super) fn not_of_one_run(files: &ProgramFiles, is_whole: bool) -> Vec<Diagnostic> {
    let (mut asking, mut cores) = (Vec::new(), Vec::new());
    for (path, bytes) in files.iter() {
        let task = task_of(path).map(str::to_ascii_lowercase);
        match common_module(bytes) {
            Some(CommonModule::Is(known_by)) => cores.push((path, task, known_by)),
            Some(CommonModule::Asks(common)) => {
                asking.push(Asking { path, task, common, settings: made_with(bytes).unwrap_or_default() });
            }
            None => {}
        }
    }
    let mut found = Vec::new();
    for (at, module) in asking.iter().enumerate() {
        let mut own = cores.iter().filter(|(_, task, _)| *task == module.task).peekable();
        let Asking { path, common, .. } = module;
        match own.peek().copied() {
            None if is_whole => {
                let text =
                    format!("{path}: the common module that it asks is not there: no controller loads it");
                found.push(
                    Diagnostic::warning("restore::no-core", text)
                        .help("put tcCore of the same run beside it"),
                );
            }
            Some((core, ..)) if !common.is_empty() && !own.any(|(_, _, known_by)| known_by == common) => {
                let text =
                    format!("{path}: {core} is of another run than it: its clock corrects by another amount");
                let help = "load the common module of the same run, or compensate anew";
                found.push(Diagnostic::warning("restore::other-core", text).help(help));
            }
            _ => found.extend(asking[..at].iter().find_map(|other| made_otherwise(other, module))),
        }
    }
    found
}

/// Two modules of one task that say different things of what they were made with.
fn made_otherwise(first: &Asking<'_>, second: &Asking<'_>) -> Option<Diagnostic> {
    if first.task != second.task || first.settings == second.settings {
        return None;
    }
    let differs = |setting: &&(String, String)| !first.settings.contains(setting);
    let own = second.settings.iter().find(differs);
    let (name, value) = own.or_else(|| first.settings.iter().find(|of| !second.settings.contains(of)))?;
    let text =
        format!("{}: it was made otherwise than {} ({name} {value} in one alone)", second.path, first.path);
    Some(
        Diagnostic::warning("made-with::differs", text)
            .help("load modules of one run together: compensate anew"),
    )
}
