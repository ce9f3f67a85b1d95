//! `driftpost compensate`: the main job.

mod args;

pub(in crate::cli) use args::temperatures;
pub use args::{Args, Temperatures};
use driftpost::application::{Compensated, Refusal, write_file_diff};

use super::destination::{Destination, Writing};
use super::files::{Output, Pending};
use super::program_input::ProgramInput;
use super::{Console, Outcome};
use driftpost::report;
use rapid_program::emit::EmittedFile;
use rapid_program::program::Program;
use rapid_syntax::diagnostic::Diagnostic;
use std::io::{BufWriter, Write};
use std::path::Path;

/// A diff on standard output is cut after so many lines.
const DIFF_LINES: usize = 2000;

/// Runs `compensate`.
///
/// # Errors
/// A JSON file or standard output that cannot be written; everything else is a refusal, which says why.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let mut json = Some(Output::new(args.json.as_deref())?);
    match write_result(args, console, &mut json) {
        Ok(written) => written.map(|()| Outcome::Done),
        Err(refusal) => {
            console.explain(&refusal.messages, args.all);
            console.say("nothing was written");
            json.map_or(Ok(()), |json| json.stream(console, |out| Ok(refusal.write_json(out)?)))?;
            Ok(Outcome::Refused)
        }
    }
}

/// Gives what came of writing the JSON, for which `json` is taken.
fn write_result(
    args: &Args,
    console: &mut Console,
    json: &mut Option<Output>,
) -> Result<anyhow::Result<()>, Box<Refusal>> {
    args.check()?;
    let given = ProgramInput::read(&args.program)?;
    let program = given.program();
    let destination = Destination::new(&given, args.output.as_deref(), args.in_place)?;
    let job = args.compensation()?;
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
    let mut accept = |program: &Program, file: EmittedFile| {
        if let Some(diff) = &mut diff {
            let path = destination.path_of(&file, &given).display().to_string();
            write_file_diff(diff, program, &file, &path).map_err(|cause| no_output(&cause))?;
        }
        writing.add(&destination, &given, file)
    };
    let made = console.while_busy("compensating", || job.run_each(&program, &mut accept))?;
    let flushed = diff.map_or(Ok(()), |mut diff| diff.flush().map_err(|cause| no_output(&cause)));
    let dropped = cut.dropped;
    let finished = flushed.and_then(|()| {
        if args.joints_csv.is_some() {
            made.check_joints()?;
        }
        console.explain(&made.messages, args.all);
        let written = writing.finish(&destination, &given)?;
        if let Some(diff) = diff_file {
            diff.write(&[])?;
        }
        let streamed = joints_file.stream(console, |out| Ok(made.write_joints(out)?));
        streamed.map_err(|error| no_output(&std::io::Error::other(error)))?;
        if !quiet {
            show(console, (&made, args.all), &head, dropped).map_err(|cause| no_output(&cause))?;
        }
        Ok(written)
    });
    let written = match finished {
        Ok(written) => written,
        Err(message) => return Err(made.refuse(message)),
    };
    if let Some(text) = made.size_note() {
        console.say(text);
    }
    if let Some(text) = made.embedded_clock_note() {
        console.say(text);
    }
    for (path, size) in written {
        console.say(format_args!("wrote {} ({size} bytes)", path.display()));
    }
    let json = json.take().unwrap_or(Output::Nowhere);
    Ok(json.stream(console, |out| Ok(made.write_json(out)?)))
}

/// The review and the diff, on standard output.
fn show(
    console: &mut Console,
    (made, all): (&Compensated<'_>, bool),
    diff: &[u8],
    dropped: usize,
) -> std::io::Result<()> {
    made.write_review(console.out(), all)?;
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
