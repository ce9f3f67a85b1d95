//! `--watch`: again whenever a file of the program is written anew.

use super::{Args, run_once};
use crate::cli::program_input::ProgramInput;
use crate::cli::{Console, Outcome};
use rapid_syntax::diagnostic::Diagnostic;
use std::fs;
use std::path::{Path, PathBuf};
use std::thread::sleep;
use std::time::{Duration, SystemTime};

/// How often the files are looked at; a file that changed is read when it has stayed the same for as long.
const EVERY: Duration = Duration::from_millis(300);

/// Size and time of each file.
type Stamps = Vec<Option<(u64, SystemTime)>>;

/// Runs until it is interrupted.
///
/// # Errors
/// `watch::standard`, as standard input is not written anew.
pub(super) fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    if args.program.iter().any(|path| path == Path::new("-")) {
        let text = "--watch waits for files, and standard input is none";
        return Err(Diagnostic::error("watch::standard", text).help("name the program's file").into());
    }
    loop {
        let before = stamps(args);
        if let Err(error) = run_once(args, console) {
            console.fail(&error);
        }
        console.flush();
        console.note("waiting for the program to be written anew; Ctrl-C ends");
        let mut last = before.clone();
        loop {
            sleep(EVERY);
            let now = stamps(args);
            // A file that is just being written is missing, or still grows.
            if now != before && now == last && now.iter().all(Option::is_some) {
                break;
            }
            last = now;
        }
    }
}

fn stamps(args: &Args) -> Stamps {
    let paths: Vec<PathBuf> =
        ProgramInput::read(&args.program).map_or_else(|_| args.program.clone(), |given| given.paths);
    let stamp = |path: &PathBuf| {
        let metadata = fs::metadata(path).ok()?;
        Some((metadata.len(), metadata.modified().ok()?))
    };
    paths.iter().map(stamp).collect()
}
