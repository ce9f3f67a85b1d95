//! `driftpost compensate`: the main job.

mod args;
mod made;
mod work;

pub(in crate::cli) use args::temperatures;
pub use args::{Args, ClockName, CoreName, FormName, Models, Temperatures};
use made::Made;
pub(in crate::cli) use made::Refusal;
pub(in crate::cli) use work::{Job, write_diff};

use super::destination::{Destination, Writing};
use super::files::{Output, Pending};
use super::given::Given;
use super::{Console, Outcome};
use crate::diagnostic::Diagnostic;
use crate::emit::EmittedFile;
use crate::program::Program;
use crate::report;
use std::fs::File;
use std::io::{BufReader, BufWriter, Seek, Write};
use std::path::Path;

/// RAPID that is read at one go: a larger program is read, planned and emitted in parts of about so many bytes.
const PART_BYTES: usize = 4_000_000;

/// A diff on standard output is cut after so many lines.
const DIFF_LINES: usize = 2000;

/// Runs `compensate`.
///
/// # Errors
/// A JSON file or standard output that cannot be written; everything else is a refusal, which says why.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let json = Output::new(args.json.as_deref())?;
    match work(args, console, &json) {
        Ok(mut made) => {
            json.stream(console, |out| copy(&mut made, out))?;
            Ok(Outcome::Done)
        }
        Err(refusal) => {
            console.explain(&refusal.messages, args.all);
            console.say("nothing was written");
            json.stream(console, |out| refusal.write_json(out))?;
            Ok(Outcome::Refused)
        }
    }
}

/// Gives the JSON of what was made.
fn work(args: &Args, console: &mut Console, json: &Output) -> Result<File, Box<Refusal>> {
    args.check()?;
    let given = Given::read_up_to(&args.program, PART_BYTES)?;
    let destination = Destination::new(&given, args.output.as_deref(), args.in_place)?;
    let job = Job::new(args)?;
    destination.keep_apart(&[args.json.as_deref(), args.diff.as_deref(), args.joints_csv.as_deref()])?;
    destination.open()?;
    let mut diff_file = diff_file(args)?;
    let joints_file = Output::new(args.joints_csv.as_deref())?;
    let quiet = json.is_standard() || joints_file.is_standard();
    let shown = !quiet && args.diff.is_none();

    // File by file: the result of a large program is larger than what is needed to make it.
    let mut writing = Writing::default();
    let mut head = Vec::new();
    let mut cut = report::Cut::new(&mut head, if quiet || args.diff.is_some() { 0 } else { DIFF_LINES });
    let diff: Option<&mut dyn Write> = match &mut diff_file {
        Some(pending) => Some(pending.out()),
        None if shown => Some(&mut cut),
        None => None,
    };
    let mut diff = diff.map(|out| BufWriter::with_capacity(1 << 16, out));
    let mut take = |program: &Program, file: EmittedFile| {
        if let Some(diff) = &mut diff {
            write_diff(diff, program, &file, &given, &destination).map_err(|cause| no_output(&cause))?;
        }
        writing.add(&destination, &given, file)
    };
    let mut made = console.while_busy("compensating", || job.make(&given, args.all, &mut take))?;
    let whole = diff.map_or(Ok(()), |diff| write_on_disk(diff, &writing));
    whole.map_err(|message| made.refuse(message))?;
    let dropped = cut.dropped;

    // Before anything is put in its place: the program may be read for them once more.
    let table = written_aside(args.joints_csv.is_some(), |out| made.write_joints(out));
    let mut table = table.map_err(|message| made.refuse(message))?;
    let facts = written_aside(args.json.is_some(), |out| made.write_json(out));
    let facts = facts.map_err(|message| made.refuse(message))?;
    console.explain(&made.messages, args.all);
    let written = writing.finish(&destination, &given).map_err(|message| made.refuse(message))?;
    if let Some(diff) = diff_file {
        diff.write(&[]).map_err(|message| made.refuse(message))?;
    }
    let kept = joints_file.stream(console, |out| copy(&mut table, out));
    kept.map_err(|error| made.refuse(no_output(&std::io::Error::other(error))))?;
    if !quiet {
        show(console, &made, &head, dropped).map_err(|cause| made.refuse(no_output(&cause)))?;
    }
    console.say(made.about_form());
    if let Some(text) = made.about_core() {
        console.say(text);
    }
    for (path, size) in written {
        console.say(format_args!("wrote {} ({size} bytes)", path.display()));
    }
    Ok(facts)
}

/// A result in a file of its own until all others are in their places; an empty one where it is not wanted.
fn written_aside(
    wanted: bool,
    write: impl FnOnce(&mut dyn Write) -> anyhow::Result<()>,
) -> Result<File, Diagnostic> {
    let failed = |error: anyhow::Error| {
        error.downcast().unwrap_or_else(|error| no_output(&std::io::Error::other(error)))
    };
    let aside = || -> anyhow::Result<File> {
        let mut file = tempfile::tempfile()?;
        if wanted {
            let mut out = BufWriter::with_capacity(1 << 16, &mut file);
            write(&mut out)?;
            out.flush()?;
        }
        file.rewind()?;
        Ok(file)
    };
    aside().map_err(failed)
}

fn copy(file: &mut File, out: &mut dyn Write) -> anyhow::Result<()> {
    std::io::copy(file, out)?;
    Ok(())
}

/// The review and the diff, on standard output.
fn show(console: &mut Console, made: &Made<'_>, diff: &[u8], dropped: usize) -> std::io::Result<()> {
    made.write_review(console.out())?;
    console.out().write_all(diff)?;
    if dropped > 0 {
        writeln!(console.out(), "... and {dropped} more lines; --diff FILE writes all of them")?;
    }
    console.out().flush()
}

/// The diff of the files on the controller's disk, which are whole now.
fn write_on_disk(mut diff: BufWriter<&mut dyn Write>, writing: &Writing) -> Result<(), Diagnostic> {
    for (path, file) in writing.on_disk() {
        let mut file = BufReader::with_capacity(1 << 16, file?);
        report::write_created(&mut diff, &path.display().to_string(), &mut file)
            .map_err(|cause| no_output(&cause))?;
    }
    diff.flush().map_err(|cause| no_output(&cause))
}

fn diff_file(args: &Args) -> Result<Option<Pending>, Diagnostic> {
    args.diff.as_deref().filter(|path| *path != Path::new("none")).map(Pending::new).transpose()
}

fn no_output(cause: &std::io::Error) -> Diagnostic {
    Diagnostic::error("output::unwritable", format!("standard output cannot be written: {cause}"))
}

#[cfg(test)]
mod tests;
