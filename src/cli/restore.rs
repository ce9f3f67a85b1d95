//! `driftpost restore`: emitted modules in, their originals out.

use super::copies::Copies;
use super::destination::{STANDARD, is_folder, is_pgf, without_tc};
use super::files::{self, Output, Pending, is_standard, keep_apart, place_all};
use super::overwriting::RestoredOver;
use super::pending::folder_of;
use super::program_input::ProgramInput;
use super::{Console, Outcome, overwriting};
use driftpost::application::{ProgramFiles, Restoration, RestoredFile, RestoredFiles};
use rapid_compensation::emit::{Altered, ModifiedIn, ModifiedTarget, Restored};
use rapid_syntax::diagnostic::Diagnostic;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

/// Command line of `driftpost restore`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Modules that `compensate` wrote; a folder or a .pgf for a whole program; - for standard input.
    #[arg(required = true, value_name = "EMITTED")]
    pub emitted: Vec<PathBuf>,

    /// Where the original goes: a file, a folder, or - for standard output
    /// [default: beside each, under the name that its header gives; of standard input to standard output].
    #[arg(short, long, value_name = "PATH")]
    pub output: Option<PathBuf>,

    /// Overwrite what stands where the original goes, changed since the program was compensated as it may be.
    #[arg(long)]
    pub force: bool,

    /// What was restored, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// Runs `restore`.
///
/// # Errors
/// A file that is none of ours, was edited beyond touched-up targets, or cannot be written; nothing is
/// written then.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let json = Output::new(args.json.as_deref())?;
    if let [program] = args.emitted.as_slice()
        && (program.is_dir() || is_pgf(program))
    {
        return restore_program(program, args, json, console);
    }
    let mut emitted = Vec::new();
    for path in &args.emitted {
        emitted.push((path.display().to_string(), files::read(path, "emitted module")?));
    }
    let found = Restoration::new(ProgramFiles::new(emitted)).run().map_err(Diagnostic::from)?;
    note_cores(&found, console);
    let (mut outputs, mut places) = (Vec::new(), Vec::new());
    // By the paths as they were given: a name in another coding is no text.
    let given = args.emitted.iter().map(PathBuf::as_path).zip(&found.files);
    for (path, restored) in given.filter_map(|(path, file)| Some((path, file.original()?))) {
        let to = place(path, restored, args)?;
        if !args.force && to != Path::new(STANDARD) {
            overwriting::check_original(&to, &restored.bytes)?;
            let over = RestoredOver {
                restored: Copies::of(folder_of(&to)),
                copied: Copies::of(folder_of(path)),
                force: false,
            };
            over.check((path, &to), &restored.bytes, Some(&restored.source_sha256))?;
        }
        places.push(to.clone());
        keep_apart(&[], &args.json.iter().chain(&places).map(PathBuf::as_path).collect::<Vec<_>>())?;
        let mut output = Output::of_program(Some(&to))?;
        output.fill(|out| Ok(out.write_all(&restored.bytes)?))?;
        outputs.push(output);
    }
    let records = records(&places, &found)?;
    put_in_place(&found, outputs, records, json, console)
}

/// The records of the folders that originals go to one by one.
fn records(places: &[PathBuf], found: &RestoredFiles) -> Result<Vec<Pending>, Diagnostic> {
    // A device or pipe is no place to be known again.
    let is_kept = |to: &Path| to != Path::new(STANDARD) && (to.is_file() || !to.exists());
    let mut folders: Vec<&Path> = places.iter().filter(|to| is_kept(to)).map(|to| folder_of(to)).collect();
    sorting::ascending(&mut folders);
    folders.dedup();
    let originals =
        || places.iter().map(PathBuf::as_path).zip(found.originals().map(|(_, restored)| restored));
    let record_of = |folder: &Path| {
        record(&Copies::of(folder), originals().filter(|(to, _)| is_kept(to) && folder_of(to) == folder))
    };
    folders.into_iter().filter_map(|folder| record_of(folder).transpose()).collect()
}

/// A whole program, folder by folder: emitted modules become their originals, the common module goes, a `.pgf` loses it, and
/// everything else is copied.
fn restore_program(
    program: &Path,
    args: &Args,
    json: Output,
    console: &mut Console,
) -> anyhow::Result<Outcome> {
    let folder = folder(program, args)?;
    let given = ProgramInput::read(std::slice::from_ref(&program.to_path_buf()))?;
    check_all_read(&given)?;
    let job = Restoration::of_program(given.program(), program.display().to_string());
    let found = job.run().map_err(Diagnostic::from)?;
    note_cores(&found, console);
    let over = RestoredOver { restored: Copies::of(folder), copied: Copies::of(program), force: args.force };
    let beside_place = |path: &Path, place: &Path, bytes: &[u8], sha256| -> Result<Pending, Diagnostic> {
        let to = apart(path, folder.join(place))?;
        if !is_pgf(path) {
            over.check((path, &to), bytes, sha256)?;
        }
        let mut pending = Pending::new(&to)?;
        pending.fill(bytes)?;
        Ok(pending)
    };
    let (mut outputs, mut copies) = (Vec::new(), Vec::new());
    for (((path, place), bytes), file) in
        given.paths.iter().zip(&given.places).zip(&given.bytes).zip(&found.files)
    {
        match file {
            RestoredFile::Original(restored) => {
                outputs.push(Output::File(beside_place(
                    path,
                    place,
                    &restored.bytes,
                    Some(&restored.source_sha256),
                )?));
            }
            RestoredFile::Core(_) => {}
            RestoredFile::Other => copies.push(beside_place(path, place, bytes, None)?),
        }
    }
    for (path, place) in &given.others {
        let bytes = files::read(path, "file")?;
        let bytes = if is_pgf(path) { found.list_without_cores(path, bytes) } else { bytes };
        copies.push(beside_place(path, place, &bytes, None)?);
    }
    let places: Vec<PathBuf> = given.places.iter().map(|place| folder.join(place)).collect();
    let originals = places.iter().zip(&found.files);
    let originals = originals.filter_map(|(to, file)| Some((to.as_path(), file.original()?)));
    copies.extend(record(&over.restored, originals)?);
    put_in_place(&found, outputs, copies, json, console)
}

/// Refuses a folder with a compensated module that is not read: it would be missing from what is got back.
fn check_all_read(given: &ProgramInput) -> Result<(), Diagnostic> {
    if let Some(result) = given.results_beside().first() {
        let text = format!(
            "{} is compensated, and a module that is called so is not read in a folder",
            result.display()
        );
        let help =
            "give it the name of its original again, or restore it by itself and take it out of the folder";
        return Err(Diagnostic::error("restore::not-read", text).help(help));
    }
    Ok(())
}

/// A folder's record with those of the originals in it that are not as they were compensated: they may be overwritten by what is got back
/// another time. `None` where it stays as it is.
fn record<'f>(
    known: &Copies,
    originals: impl Iterator<Item = (&'f Path, &'f Restored)>,
) -> Result<Option<Pending>, Diagnostic> {
    let changed = originals
        .filter(|(to, restored)| !restored.exact && !known.is_as_copied(to, &restored.bytes))
        .map(|(to, restored)| known.line(to, &restored.bytes));
    let changed: String = changed.collect();
    if changed.is_empty() {
        return Ok(None);
    }
    let mut pending = Pending::new(&known.record())?;
    pending.fill(format!("{}{changed}", known.text()).as_bytes())?;
    Ok(Some(pending))
}

/// Where a whole program goes.
fn folder<'a>(program: &Path, args: &'a Args) -> Result<&'a Path, Diagnostic> {
    match args.output.as_deref() {
        None => {
            let text = format!("where the program {} goes must be said", program.display());
            Err(Diagnostic::error("output::needed", text).help("name a folder with -o"))
        }
        Some(standard) if standard == Path::new(STANDARD) => {
            let text = "a whole program does not go to standard output";
            Err(Diagnostic::error("output::one-file", text).help("name a folder with -o"))
        }
        Some(folder) => Ok(folder),
    }
}

fn note_cores(found: &RestoredFiles, console: &mut Console) {
    for (path, altered) in found.cores() {
        console.note(format_args!("{path}: the common module, it has no original"));
        warn(path, altered, console);
    }
    console.report(found.of_other_runs.iter().cloned());
}

/// Puts originals and copies in their places, and says what was changed since they were compensated.
fn put_in_place(
    found: &RestoredFiles,
    outputs: Vec<Output>,
    copies: Vec<Pending>,
    json: Output,
    console: &mut Console,
) -> anyhow::Result<Outcome> {
    let names: Vec<String> = outputs.iter().map(Output::name).collect();
    json.write_json(console, &found.json(&names))?;
    let (mut all, mut is_taken) = (copies, true);
    for ((_, restored), output) in found.originals().zip(outputs) {
        if output.is_standard() {
            console.out().write_all(&restored.bytes)?;
            is_taken = console.out().flush().is_ok();
        }
        all.extend(output.into_pending());
    }
    place_all(all, &[])?;
    if !is_taken {
        // Why is told at the end.
        return Ok(Outcome::Refused);
    }
    for ((path, restored), to) in found.originals().zip(&names) {
        restored.touched.iter().for_each(|touched| note_touched(path, touched, console));
        warn(path, &restored.altered, console);
        let how = if restored.exact { "byte for byte the original" } else { "with what was changed since" };
        console.note(format_args!("wrote {to} ({how})"));
    }
    Ok(if found.is_untouched() { Outcome::Done } else { Outcome::Difference })
}

fn note_touched(path: &str, touched: &ModifiedTarget, console: &mut Console) {
    let (how, what_now) = match touched.into {
        ModifiedIn::Motion => ("touched up on the controller", "its new value is in the motion"),
        ModifiedIn::Declaration => ("touched up on the controller", "its new value is in the declaration"),
        ModifiedIn::DeclarationAlone => (
            "changed where it is declared",
            "the corrected motions went by its array, as it was made; those of the original go by the new value",
        ),
    };
    // To the digits that are shown the tool stands and points as it did.
    let by = if touched.moved < 5e-5 {
        "in orientation, configuration or external axes alone, or is corrected by another target's correction"
            .to_owned()
    } else {
        format!("by {:.4} {}", touched.moved, touched.unit)
    };
    let others: Vec<String> = touched.others.iter().map(u32::to_string).collect();
    let others = match others.as_slice() {
        [] => String::new(),
        [line] => format!("; line {line} names it too, and goes with it"),
        lines => format!("; lines {} name it too, and go with it", lines.join(", ")),
    };
    console
        .note(format_args!("{path}:{}: {} was {how} {by}; {what_now}{others}", touched.line, touched.target));
}

/// What was changed in the emitted module and has no place in the original.
fn warn(path: &str, altered: &[Altered], console: &mut Console) {
    let message =
        |what: &Altered| Diagnostic::warning(what.code(), format!("{path}:{}: {what}", what.line()));
    console.report(altered.iter().map(message));
}

/// Where an original goes.
fn place(path: &Path, restored: &Restored, args: &Args) -> Result<PathBuf, Diagnostic> {
    // The header is text that anybody may have edited: a name, never a way to elsewhere.
    let name = || {
        let name = restored.source_name.rsplit(['/', '\\']).next().unwrap_or_default();
        if let Some(own) = original_name(path, name) {
            return Ok(own);
        }
        if name.is_empty() || name == ".." {
            let text = format!("the header of {} names no file", path.display());
            let help = "say with -o which file the original goes to";
            return Err(Diagnostic::error("restore::damaged", text).help(help));
        }
        Ok(OsString::from(name))
    };
    let to = match &args.output {
        Some(standard) if standard == Path::new(STANDARD) && args.emitted.len() > 1 => {
            let text = "several modules do not go to standard output";
            return Err(Diagnostic::error("output::one-file", text).help("name a folder with -o"));
        }
        Some(folder) if args.emitted.len() > 1 || is_folder(folder) => folder.join(name()?),
        Some(file) => file.clone(),
        None if is_standard(path) => PathBuf::from(STANDARD),
        None => path.with_file_name(name()?),
    };
    let to = apart(path, to)?;
    // What is there already may stay.
    let is_there = || fs::read(&to).is_ok_and(|bytes| bytes == restored.bytes);
    if args.output.is_none() && !args.force && !is_standard(path) && to.exists() && !is_there() {
        let text = format!("{} exists", to.display());
        return Err(Diagnostic::error("output::exists", text)
            .help("say with -o where the original goes, or say --force"));
    }
    Ok(to)
}

/// The name of an original whose header says it with question marks, in place of letters that are none of ASCII, where the emitted module is
/// called by it and `_tc`.
fn original_name(emitted: &Path, name: &str) -> Option<OsString> {
    if !name.contains('?') {
        return None;
    }
    let own = without_tc(emitted)?;
    let shown = own.to_string_lossy();
    let is_it = shown.chars().count() == name.chars().count()
        && shown.chars().zip(name.chars()).all(|(own, said)| own == said || said == '?' && !own.is_ascii());
    is_it.then_some(own)
}

/// A place that is not the input's.
fn apart(path: &Path, to: PathBuf) -> Result<PathBuf, Diagnostic> {
    let same =
        fs::canonicalize(&to).ok().is_some_and(|to| fs::canonicalize(path).is_ok_and(|path| path == to));
    if same {
        let text = format!("{} is the input and would be overwritten", to.display());
        return Err(Diagnostic::error("output::is-input", text)
            .help("name another place with -o; what is there can take its place then"));
    }
    Ok(to)
}
