//! `driftpost compensate`: the main job.

mod args;
mod jobs;
mod option_values;
mod touch;
mod watch;

pub use args::Args;
use driftpost::application::{Compensated, Compensation, Refusal, write_file_diff};
pub use option_values::Temperatures;
pub(in crate::cli) use option_values::temperatures;

use super::destination::{Destination, Writing, Written, is_pgf};
use super::files::{Output, Pending, check_size, place_all};
use super::model;
use super::other_tasks;
use super::program_input::ProgramInput;
use super::{Console, Outcome};
use driftpost::report::{self, LocatedDiagnostic, ShortDiff, SourceReview};
use rapid_program::emit::EmittedFile;
use rapid_program::program::Program;
use rapid_syntax::diagnostic::Diagnostic;
use std::io::{BufWriter, Read, Seek, Write};
use std::path::Path;

/// What is shown or written of the difference.
enum DiffTo {
    Nowhere,
    /// The first changes, on standard output.
    Short(ShortDiff),
    /// All of it on standard output; until all is well in a file without a name.
    Standard(std::fs::File),
    File(Pending),
}

impl DiffTo {
    fn new(asked: &Path, is_quiet: bool) -> Result<Self, Diagnostic> {
        let unnamed = || tempfile::tempfile().map_err(|cause| no_output(&cause));
        match asked.to_str() {
            Some("none") => Ok(Self::Nowhere),
            Some("short") if is_quiet => Ok(Self::Nowhere),
            Some("short") => Ok(Self::Short(ShortDiff::default())),
            Some("-") => unnamed().map(Self::Standard),
            _ => Pending::new(asked).map(Self::File),
        }
    }

    fn add(&mut self, program: &Program, file: &EmittedFile, path: &str) -> std::io::Result<()> {
        let buffered = |out: &mut dyn Write| {
            let mut out = BufWriter::with_capacity(1 << 16, out);
            write_file_diff(&mut out, program, file, path)?;
            out.flush()
        };
        match self {
            Self::Nowhere => Ok(()),
            Self::Short(short) => {
                if let Some(id) = file.source {
                    let source = program.file(id);
                    short.add(&source.path, path, &source.bytes, &file.edits);
                }
                Ok(())
            }
            Self::Standard(all) => buffered(all),
            Self::File(pending) => buffered(pending.out()),
        }
    }

    /// Writes what goes to standard output.
    fn show(&mut self, console: &mut Console) -> std::io::Result<()> {
        let mut text = Vec::new();
        match self {
            Self::Short(short) => short.write(&mut text)?,
            Self::Standard(all) => {
                all.rewind()?;
                if !console.is_coloured() {
                    std::io::copy(all, console.out())?;
                    return writeln!(console.out());
                }
                all.read_to_end(&mut text)?;
                text.push(b'\n');
            }
            Self::Nowhere | Self::File(_) => return Ok(()),
        }
        match console.is_coloured() {
            true => report::write_coloured(console.out(), &text),
            false => console.out().write_all(&text),
        }
    }
}

/// Runs `compensate`.
///
/// # Errors
/// What keeps a result from being written, with what was written until then; everything else is a refusal, which says why.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    if args.watch { watch::run(args, console) } else { run_once(args, console) }
}

fn run_once(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let mut json = Some(Output::new(args.json.as_deref())?);
    let mut page = args.report.as_deref().map(Pending::new).transpose()?;
    let mut jobs = Vec::new();
    match write_result(args, console, &mut jobs, &mut json, &mut page) {
        Ok(written) => written.map(|()| Outcome::Done),
        Err(refusal) => {
            console.explain(&refusal.messages, args.all);
            console.say("nothing was written");
            if let Some(mut page) = page {
                let title = args.program.iter().map(|path| path.display().to_string()).collect::<Vec<_>>();
                // of several jobs it does not say whose the refusal is
                let job = <&[Compensation; 1]>::try_from(jobs.as_slice()).ok().map(|[job]| job);
                refusal.write_page(&title.join(", "), job, page.out())?;
                page.place()?;
            }
            json.map_or(Ok(()), |json| json.stream(console, |out| Ok(refusal.write_json(out)?)))?;
            Ok(Outcome::Refused)
        }
    }
}

/// Gives what came of putting the results in their places, for which `json` and `page` are taken; `jobs` is then what was asked for.
fn write_result(
    args: &Args,
    console: &mut Console,
    jobs: &mut Vec<Compensation>,
    json: &mut Option<Output>,
    page: &mut Option<Pending>,
) -> Result<anyhow::Result<()>, Box<Refusal>> {
    args.check()?;
    let given = ProgramInput::read(&args.program)?;
    let program = given.program();
    let destination = Destination::new(&given, args.output.as_deref(), args.in_place, args.force)?;
    *jobs = args.jobs()?;
    other_tasks::check_named(&args.task, &program)?;
    if let Some(moved) = given.paths.first().map(|path| model::base_beside(path)).transpose()?.flatten() {
        console.explain(&[LocatedDiagnostic::new(moved, &[])], true);
    }
    let beside = other_tasks::beside(&given.paths);
    jobs.iter_mut().for_each(|job| job.overrides.other_tasks.clone_from(&beside));
    destination.keep_apart(&[
        args.json.as_deref(),
        Some(&args.diff),
        args.joints_csv.as_deref(),
        args.report.as_deref(),
    ])?;
    destination.open()?;
    let mut joints_file = Output::new(args.joints_csv.as_deref())?;
    let is_quiet = console.is_quiet()
        || json.as_ref().is_some_and(Output::is_standard)
        || joints_file.is_standard()
        || destination.is_standard();
    let mut diff = DiffTo::new(&args.diff, is_quiet)?;

    // File by file: the result of a large program is larger than what is needed to make it.
    let mut writing = Writing::default();
    let mut sources = Vec::with_capacity(jobs.len());
    let mut all_made = Vec::with_capacity(jobs.len());
    for job in jobs.iter() {
        let mut source = SourceReview::default();
        let mut accept = |program: &Program, file: EmittedFile| {
            let path = destination.path_of(&file, &given).display().to_string();
            check_size(&path, &file.bytes)?;
            diff.add(program, &file, &path).map_err(|cause| no_output(&cause))?;
            if let Some(id) = file.source.filter(|_| page.is_some()) {
                let from = program.file(id);
                source.add(&from.path, &path, &from.bytes, &file.edits);
            }
            writing.add(&destination, &given, file)
        };
        let made = console.while_busy("compensating", || job.run_each(&program, &mut accept))?;
        console.explain(&made.messages, args.all);
        all_made.push(made);
        sources.push(source);
    }
    // A recording is asked for of one robot alone.
    let [made, ..] = all_made.as_slice() else { return Ok(Ok(())) };
    // All is written whole beside its place before anything is put there.
    let prepared = || -> Result<_, Diagnostic> {
        if args.joints_csv.is_some() {
            all_made.iter().try_for_each(Compensated::check_joints)?;
        }
        let filled = |error: anyhow::Error| {
            error.downcast().unwrap_or_else(|error| no_output(&std::io::Error::other(error)))
        };
        joints_file.fill(|out| Ok(Compensated::write_joints(&all_made, out)?)).map_err(filled)?;
        if let Some(json) = json.as_mut() {
            json.fill(|out| Ok(write_json(&all_made, out)?)).map_err(filled)?;
        }
        if let Some(page) = page.as_mut() {
            let mut out = BufWriter::with_capacity(1 << 16, page.out());
            let written = match sources.pop() {
                Some(source) if made.task.is_none() => made.write_page(source, &mut out),
                last => {
                    sources.extend(last);
                    Compensated::write_page_of_tasks(&all_made, sources, &mut out)
                }
            };
            written.and_then(|()| out.flush()).map_err(|cause| no_output(&cause))?;
        }
        let mut written = writing.finish(&destination, &given)?;
        written.pending.extend(recording(args, made)?);
        Ok(written)
    };
    let mut written = match prepared() {
        Ok(written) => written,
        Err(message) => return Err(all_made.remove(0).refuse(message)),
    };
    written.pending.extend(page.take());
    let mut json = json.take().unwrap_or(Output::Nowhere);
    for output in [&mut joints_file, &mut json] {
        if matches!(output, Output::File(_)) {
            written.pending.extend(std::mem::replace(output, Output::Nowhere).into_pending());
        }
    }
    let mut diff = diff;
    if matches!(diff, DiffTo::File(_))
        && let DiffTo::File(pending) = std::mem::replace(&mut diff, DiffTo::Nowhere)
    {
        written.pending.push(pending);
    }
    if let Err(message) = place_all(std::mem::take(&mut written.pending)) {
        return Ok(Err(message.into()));
    }
    // Each of several files by its name; the verdict, which comes last, sums them up.
    if written.emitted.len() > 1 {
        for (path, size) in &written.emitted {
            console.say(format_args!("wrote {} ({size} bytes)", path.display()));
        }
    }
    for made in &all_made {
        if let Some(text) = made.size_note() {
            console.say(text);
        }
    }
    let other = destination.other_clock().map(|path| path.display().to_string());
    if let Some(text) = other.and_then(|other| made.embedded_clock_note(&other)) {
        console.say(text);
    }
    Ok(show(console, &all_made, args, &mut diff, &written, is_quiet, [joints_file, json]))
}

/// What goes to standard output: the difference, the tables, the verdict; or a result.
fn show(
    console: &mut Console,
    all_made: &[Compensated<'_>],
    args: &Args,
    diff: &mut DiffTo,
    written: &Written,
    is_quiet: bool,
    [joints, json]: [Output; 2],
) -> anyhow::Result<()> {
    let files = written_line(written, all_made.iter().map(Compensated::warnings).sum());
    let shown = (|| -> anyhow::Result<()> {
        diff.show(console)?;
        if let Some(module) = &written.standard {
            console.out().write_all(module)?;
        }
        joints.stream(console, |out| Ok(Compensated::write_joints(all_made, out)?))?;
        json.stream(console, |out| Ok(write_json(all_made, out)?))?;
        if is_quiet {
            return Ok(console.out().flush()?);
        }
        for (k, made) in all_made.iter().enumerate() {
            if let Some(of) = args.task.get(k) {
                writeln!(console.out(), "{}: {}", of.task, made.robot.name)?;
            }
            made.write_review(console.out(), args.all)?;
        }
        writeln!(console.out(), "{files}")?;
        Ok(console.out().flush()?)
    })();
    match shown {
        Ok(()) if is_quiet => {
            console.say(files);
            Ok(())
        }
        Ok(()) => Ok(()),
        Err(error) => {
            let cause = error.downcast::<std::io::Error>().unwrap_or_else(std::io::Error::other);
            let said = match written.standard {
                Some(_) => no_output(&cause).help("the program was not written whole"),
                None => no_output(&cause).help(format!("what it would have shown is lost; {files}")),
            };
            Err(said.into())
        }
    }
}

/// What happened, for scripts: of one robot the object of the contract, of several a list of them, `{"tasks": [...]}`.
fn write_json(all_made: &[Compensated<'_>], out: &mut dyn Write) -> std::io::Result<()> {
    if let [made] = all_made
        && made.task.is_none()
    {
        return made.write_json(out);
    }
    let one = |made: &Compensated<'_>| -> std::io::Result<serde_json::Value> {
        let mut json = made.json()?;
        json["task"] = made.task.as_deref().into();
        json["robot"] = made.robot.name.as_str().into();
        Ok(json)
    };
    let tasks = all_made.iter().map(one).collect::<std::io::Result<Vec<_>>>()?;
    serde_json::to_writer_pretty(&mut *out, &serde_json::json!({ "tasks": tasks }))?;
    out.write_all(b"\n")
}

/// The last line of the verdict: what was written, and how many warnings there are.
fn written_line(written: &Written, warnings: usize) -> String {
    let warnings = match warnings {
        0 => String::new(),
        n => format!("; {}, see above", report::counted(n, "warning")),
    };
    match written.emitted.as_slice() {
        [] => format!("nothing is corrected, the program is written as it was{warnings}"),
        [(path, size)] if written.standard.is_some() => {
            format!("wrote {} ({size} bytes){warnings}", shown_path(path))
        }
        [(path, size)] => format!("wrote {} ({size} bytes){warnings}", path.display()),
        [(first, _), ..] => {
            let bytes: usize = written.emitted.iter().map(|(_, size)| size).sum();
            let count = written.emitted.len();
            let lists = written.emitted.iter().filter(|(path, _)| is_pgf(path));
            let lists: String =
                lists.map(|(path, _)| format!("; {} lists the new module, too", path.display())).collect();
            format!(
                "wrote {} and {} more {}, {bytes} bytes in all{lists}{warnings}",
                first.display(),
                count - 1,
                report::plural(count - 1, "file")
            )
        }
    }
}

#[cfg(not(feature = "mcap"))]
fn recording(_: &Args, _: &Compensated<'_>) -> Result<Vec<Pending>, Diagnostic> {
    Ok(Vec::new())
}

/// The recording and the arm beside it, whole but not yet in their places.
#[cfg(feature = "mcap")]
fn recording(args: &Args, made: &Compensated<'_>) -> Result<Vec<Pending>, Diagnostic> {
    let Some(path) = &args.mcap else { return Ok(Vec::new()) };
    let [mut file, mut arm] = [Pending::new(path)?, Pending::new(&path.with_extension("urdf"))?];
    let bytes = made.recording()?.mcap().map_err(|cause| no_output(&cause))?;
    file.fill(&bytes)?;
    arm.fill(report::urdf(made.robot).as_bytes())?;
    Ok(vec![file, arm])
}

fn shown_path(path: &Path) -> String {
    if path == Path::new("-") { "standard output".to_owned() } else { path.display().to_string() }
}

fn no_output(cause: &std::io::Error) -> Diagnostic {
    Diagnostic::error("output::unwritable", format!("standard output cannot be written: {cause}"))
}

#[cfg(test)]
mod tests;
