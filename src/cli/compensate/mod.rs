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
use crate::report;
use rapid_program::emit::EmittedFile;
use rapid_program::program::Program;
use rapid_syntax::diagnostic::Diagnostic;
use std::fs::File;
use std::io::{BufWriter, Seek, Write};
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
    let mut json = Some(Output::new(args.json.as_deref())?);
    match work(args, console, &mut json) {
        Ok(written) => written.map(|()| Outcome::Done),
        Err(refusal) => {
            console.explain(&refusal.messages, args.all);
            console.say("nothing was written");
            json.map_or(Ok(()), |json| json.stream(console, |out| refusal.write_json(out)))?;
            Ok(Outcome::Refused)
        }
    }
}

/// Gives what came of writing the JSON, for which `json` is taken.
fn work(
    args: &Args,
    console: &mut Console,
    json: &mut Option<Output>,
) -> Result<anyhow::Result<()>, Box<Refusal>> {
    args.check()?;
    let given = Given::read_up_to(&args.program, PART_BYTES)?;
    let destination = Destination::new(&given, args.output.as_deref(), args.in_place)?;
    let job = Job::new(args)?;
    destination.keep_apart(&[args.json.as_deref(), args.diff.as_deref(), args.joints_csv.as_deref()])?;
    destination.open()?;
    let mut diff_file = diff_file(args)?;
    let joints_file = Output::new(args.joints_csv.as_deref())?;
    let quiet = json.as_ref().is_some_and(Output::is_standard) || joints_file.is_standard();
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
    let whole = diff.map_or(Ok(()), |mut diff| diff.flush().map_err(|cause| no_output(&cause)));
    whole.map_err(|message| made.refuse(message))?;
    let dropped = cut.dropped;

    if args.joints_csv.is_some() {
        made.check_joints().map_err(|message| made.refuse(message))?;
    }
    // A large program is read again for these, and where it is changed in place that must be before.
    let early = args.in_place && given.is_large();
    let table = aside(early && args.joints_csv.is_some(), |out| made.write_joints(out));
    let table = table.map_err(|message| made.refuse(message))?;
    let facts = aside(early && args.json.is_some(), |out| made.write_json(out));
    let facts = facts.map_err(|message| made.refuse(message))?;
    console.explain(&made.messages, args.all);
    let written = writing.finish(&destination, &given).map_err(|message| made.refuse(message))?;
    if let Some(diff) = diff_file {
        diff.write(&[]).map_err(|message| made.refuse(message))?;
    }
    let kept = joints_file.stream(console, |out| match table {
        Some(table) => copy(table, out),
        None => made.write_joints(out),
    });
    kept.map_err(|error| made.refuse(no_output(&std::io::Error::other(error))))?;
    if !quiet {
        show(console, &made, &head, dropped).map_err(|cause| made.refuse(no_output(&cause)))?;
    }
    if let Some(text) = made.about_size() {
        console.say(text);
    }
    if let Some(text) = made.about_core() {
        console.say(text);
    }
    for (path, size) in written {
        console.say(format_args!("wrote {} ({size} bytes)", path.display()));
    }
    let json = json.take().unwrap_or(Output::Nowhere);
    Ok(json.stream(console, |out| match facts {
        Some(facts) => copy(facts, out),
        None => made.write_json(out),
    }))
}

/// A result in a file of its own until all others are in their places, where that is wanted.
fn aside(
    wanted: bool,
    write: impl FnOnce(&mut dyn Write) -> anyhow::Result<()>,
) -> Result<Option<File>, Diagnostic> {
    let failed = |error: anyhow::Error| {
        error.downcast().unwrap_or_else(|error| {
            let text = format!("a result cannot be kept in a file until the others are written: {error}");
            Diagnostic::error("output::unwritable", text)
                .help("make room in the folder for temporary files, or name one in TMPDIR")
        })
    };
    let write = || -> anyhow::Result<File> {
        let mut out = BufWriter::with_capacity(1 << 16, tempfile::tempfile()?);
        write(&mut out)?;
        let mut file = out.into_inner()?;
        file.rewind()?;
        Ok(file)
    };
    wanted.then(write).transpose().map_err(failed)
}

fn copy(mut file: File, out: &mut dyn Write) -> anyhow::Result<()> {
    std::io::copy(&mut file, out)?;
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

fn diff_file(args: &Args) -> Result<Option<Pending>, Diagnostic> {
    args.diff.as_deref().filter(|path| *path != Path::new("none")).map(Pending::new).transpose()
}

fn no_output(cause: &std::io::Error) -> Diagnostic {
    Diagnostic::error("output::unwritable", format!("standard output cannot be written: {cause}"))
}

#[cfg(test)]
mod tests;
