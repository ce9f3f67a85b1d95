//! `driftpost golden`: a folder of cases, each a program with its options and the result that is expected.
//!
//! `CASE/source/` holds the modules, `CASE/options.toml` the options of `compensate` by their names
//! (`tolerance-mm = 0.05`, `strict = true`, `tool = ["t=[...]"]`; files are relative to the case), and
//! `CASE/expected/` the emitted files, `review.txt`, `changes.diff` and `messages.txt`.

use super::compensate;
use super::destination::Destination;
use super::files::{self, Output, Pending};
use super::program_input::ProgramInput;
use super::settings;
use super::{Console, Outcome};
use crate::application::{TaskOutcome, TaskOutcomes, check_tasks, write_file_diff};
use crate::report::{self, ColorMode, LocatedDiagnostic};
use clap::{Args as _, FromArgMatches};
use driftpost::application::{Compensation, ProgramFiles, Refusal};
use rapid_compensation::emit::EmittedFile;
use rapid_program::Program;
use rapid_syntax::diagnostic::Diagnostic;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

/// Command line of `driftpost golden`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Folder of cases.
    #[arg(value_name = "DIR")]
    pub dir: PathBuf,

    /// Write what comes out as what is expected from now on.
    #[arg(long)]
    pub update: bool,

    /// Which cases are the same, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// Files by their place under `expected/`, `/` between folders.
type Files = BTreeMap<String, Vec<u8>>;

/// Runs `golden`: differences are shown as diffs from what is expected to what came out.
///
/// # Errors
/// A case that cannot be read or written.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let json = Output::new(args.json.as_deref())?;
    let mut cases = Vec::new();
    for folder in no_cases_of(&args.dir) {
        console.note(format_args!("{} is no case: it holds no source/ and no expected/", folder.display()));
    }
    for case in cases_of(&args.dir)? {
        let actual = result_of(&case)?;
        let folder = case.join("expected");
        let expected = if folder.is_dir() { read_all(&folder)? } else { Files::new() };
        let files = different_files(&expected, &actual);
        let same = files.is_empty();
        if !same && args.update {
            write_all(&folder, &expected, &actual)?;
            console.note(format_args!("{}: updated", case.display()));
        } else if !same && !json.is_standard() {
            show(console, &folder, &expected, &actual)?;
        }
        cases.push((case.display().to_string(), files));
    }
    let different = cases.iter().filter(|(_, files)| !files.is_empty()).count();
    let verdict = format!("{}, {different} different", report::counted(cases.len(), "case"));
    if json.is_standard() || console.is_quiet() {
        console.note(verdict);
    } else {
        writeln!(console.out(), "{verdict}")?;
    }
    json.write(console, || Ok(report::golden_json(&cases, args.update).into_bytes()))?;
    Ok(if different == 0 || args.update { Outcome::Done } else { Outcome::Difference })
}

/// What a folder of a case holds.
const CASE: [&str; 3] = ["source", "expected", "options.toml"];

/// Folders of cases, in order of name.
fn cases_of(dir: &Path) -> Result<Vec<PathBuf>, Diagnostic> {
    let entries = fs::read_dir(dir).map_err(|cause| files::cannot_read(dir, "folder of cases", &cause))?;
    let mut cases: Vec<PathBuf> = entries
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| CASE.iter().any(|part| path.join(part).exists()))
        .collect();
    sorting::ascending(&mut cases);
    if let Some(case) = cases.iter().find(|case| !case.join("source").is_dir()) {
        let text = format!("the case {} has no folder source/", case.display());
        return Err(
            Diagnostic::error("golden::no-source", text).help("put the program back, or take the case away")
        );
    }
    if cases.is_empty() {
        let text = format!("{} holds no case", dir.display());
        return Err(Diagnostic::error("golden::no-case", text)
            .help("a case is a folder with CASE/source/ and, if needed, CASE/options.toml"));
    }
    Ok(cases)
}

/// Folders beside the cases that hold nothing of one, in order of name: a case that was emptied is seldom meant to pass.
fn no_cases_of(dir: &Path) -> Vec<PathBuf> {
    let is_hidden =
        |path: &Path| path.file_name().is_some_and(|name| name.to_string_lossy().starts_with('.'));
    let is_none = |path: &PathBuf| {
        path.is_dir() && !is_hidden(path) && !CASE.iter().any(|part| path.join(part).exists())
    };
    let entries = fs::read_dir(dir).into_iter().flatten();
    let mut folders: Vec<PathBuf> =
        entries.filter_map(|entry| Some(entry.ok()?.path())).filter(is_none).collect();
    sorting::ascending(&mut folders);
    folders
}

/// What `compensate` makes of a case.
fn result_of(case: &Path) -> anyhow::Result<Files> {
    let args = options(case)?;
    let mut given = ProgramInput::read(&args.program)?;
    let destination = Destination::new(&given, Some(Path::new("expected")), false, true)?;
    // what comes out must not depend on where the folder of cases stands
    for (path, place) in given.paths.iter_mut().zip(&given.places) {
        *path = Path::new("source").join(place);
    }
    let mut result = Files::new();
    let color_mode = ColorMode::Plain;
    let mut message_text = Vec::new();
    let mut diff = Vec::new();
    let mut accept = |program: &Program, file: EmittedFile| {
        let to = destination.path_of(&file, &given).display().to_string();
        write_file_diff(&mut diff, program, &file, &to)
            .map_err(|cause| Diagnostic::error("output::unwritable", cause.to_string()))?;
        let path = destination.path_of(&file, &given);
        let place = path.strip_prefix("expected").unwrap_or(&path).to_string_lossy().replace('\\', "/");
        result.entry(place).or_default().extend(file.bytes);
        Ok(())
    };
    let program = given.program();
    check_tasks(&args.task.iter().map(|of| of.task.as_str()).collect::<Vec<_>>(), &program)?;
    let messages = match reviewed(&args.jobs()?, &program, &mut accept) {
        Ok((review, messages)) => {
            result.insert("review.txt".to_owned(), review);
            result.insert("changes.diff".to_owned(), diff);
            messages
        }
        // Where one task's robot cannot be corrected, no task's files are written.
        Err(refusal) => {
            result.clear();
            refusal.messages
        }
    };
    report::write_messages(&mut message_text, &messages, color_mode, true)?;
    if !message_text.is_empty() {
        result.insert("messages.txt".to_owned(), message_text);
    }
    Ok(result)
}

/// The review of all tasks, and the messages.
///
/// # Errors
/// The refusal that keeps every task from being written.
fn reviewed(
    jobs: &[Compensation],
    program: &ProgramFiles,
    accept: &mut dyn FnMut(&Program, EmittedFile) -> Result<(), Diagnostic>,
) -> Result<(Vec<u8>, Vec<LocatedDiagnostic>), Box<Refusal>> {
    let (mut review, mut messages) = (Vec::new(), Vec::new());
    let mut outcomes = TaskOutcomes::default();
    for job in jobs {
        outcomes.add((job, jobs.len()), job.run_each(program, accept), |outcome| match outcome {
            TaskOutcome::Made(made) => {
                // a vector takes all that is written to it
                let _ = made.write_review(&mut review, true);
                messages.extend(made.messages);
            }
            TaskOutcome::LeftAlone { task, refusal } => messages.extend(refusal.as_warnings(task)),
        })?;
    }
    outcomes.finish()?;
    Ok((review, messages))
}

/// The options of a case, read by the same rules as the command line.
fn options(case: &Path) -> Result<compensate::Args, Diagnostic> {
    let path = case.join("options.toml");
    let wrong = |text: String| Diagnostic::error("golden::options", format!("{}: {text}", path.display()));
    let text = if path.exists() { files::read(&path, "file of options")? } else { Vec::new() };
    let text = String::from_utf8(text).map_err(|error| wrong(error.to_string()))?;
    let table: toml::Table = toml::from_str(&text).map_err(|error| wrong(error.message().to_owned()))?;
    let mut words = vec![OsString::from("compensate")];
    for (name, value) in &table {
        let in_case = |text: &str| {
            let file = case.join(text);
            if file.is_file() { file.display().to_string() } else { text.to_owned() }
        };
        words.extend(settings::words(name, value, |text| match text.split_once('=') {
            // A robot's file and its table's, TASK=ROBOT,TABLE.
            Some((task, files)) if name == "task" => {
                let files: Vec<String> = files.split(',').map(in_case).collect();
                format!("{task}={}", files.join(","))
            }
            _ => in_case(text),
        }));
    }
    words.push(case.join("source").into());
    let command = compensate::Args::augment_args(clap::Command::new("compensate"));
    let matches = command.try_get_matches_from(words).map_err(|error| wrong(error.to_string()))?;
    compensate::Args::from_arg_matches(&matches).map_err(|error| wrong(error.to_string()))
}

fn read_all(folder: &Path) -> Result<Files, Diagnostic> {
    let mut files = Files::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(at) = folders.pop() {
        let entries = fs::read_dir(&at).map_err(|cause| files::cannot_read(&at, "folder", &cause))?;
        for path in entries.filter_map(|entry| Some(entry.ok()?.path())) {
            if path.is_dir() {
                folders.push(path);
            } else {
                let place = path.strip_prefix(folder).unwrap_or(&path).to_string_lossy().replace('\\', "/");
                files.insert(place, files::read(&path, "expected file")?);
            }
        }
    }
    Ok(files)
}

fn write_all(folder: &Path, old: &Files, new: &Files) -> Result<(), Diagnostic> {
    for place in old.keys().filter(|place| !new.contains_key(*place)) {
        let path = folder.join(place);
        fs::remove_file(&path).map_err(|cause| files::cannot_read(&path, "expected file", &cause))?;
    }
    for (place, bytes) in new.iter().filter(|(place, bytes)| old.get(*place) != Some(bytes)) {
        Pending::new(&folder.join(place))?.write(bytes)?;
    }
    Ok(())
}

/// The files that one of both does not have, or has otherwise, in order of name.
fn different_files(expected: &Files, actual: &Files) -> Vec<String> {
    let mut places: Vec<String> = expected.keys().chain(actual.keys()).cloned().collect();
    sorting::ascending(&mut places);
    places.dedup();
    places.retain(|place| expected.get(place) != actual.get(place));
    places
}

fn show(console: &mut Console, folder: &Path, expected: &Files, actual: &Files) -> std::io::Result<()> {
    let none = Vec::new();
    for place in different_files(expected, actual) {
        let path = folder.join(&place).display().to_string();
        let old = expected.get(&place).unwrap_or(&none);
        let new = actual.get(&place).unwrap_or(&none);
        report::write_texts(console.out(), &path, "what comes out", old, new)?;
    }
    console.out().flush()
}
