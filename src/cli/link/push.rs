//! `driftpost link push`: corrected modules into the controller's HOME, and into the task where that is asked for twice.

use super::connection::Connection;
use super::question::is_yes;
use crate::application::{EmittedState, check_modules};
use crate::cli::program_input::ProgramInput;
use crate::cli::{Console, Outcome};
use crate::report::{self, LocatedDiagnostic};
use driftpost::application::{Loading, LoadingError, ModuleUpload};
use robot_link::{Execution, LinkError, Session};
use std::path::PathBuf;

/// Lines of a difference that are shown.
const DIFF_LINES: usize = 60;

/// Options of `link push`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// A module, a folder of them, or a .pgf.
    #[arg(value_name = "PROGRAM")]
    program: PathBuf,

    /// The host, who logs in, and how its certificate is pinned.
    #[command(flatten)]
    connection: Connection,

    /// Write the files into HOME; without it nothing is written, and what would be is shown.
    #[arg(long)]
    yes: bool,

    /// Then load the modules in place of those of the same names, while RAPID stands still; asks again.
    #[arg(long, requires = "yes")]
    load: bool,

    /// The answer to that question, for scripts.
    #[arg(long, requires = "load")]
    confirmed: bool,

    /// The task to load into [default: the one that moves an arm].
    #[arg(long, value_name = "TASK")]
    task: Option<String>,
}

/// What stands in HOME under its name.
#[derive(Clone, Copy, PartialEq, Eq)]
enum There {
    Nothing,
    Same,
    Other,
}

/// Runs `link push`.
///
/// # Errors
/// A program that cannot be read, `link::*`.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let given = ProgramInput::read(std::slice::from_ref(&args.program))?;
    let sources = given.program().sources();
    if let Err(message) = check_modules(&sources) {
        console.explain(&[LocatedDiagnostic::new(message, &sources)], true);
        return Ok(Outcome::Refused);
    }
    let modules = sources.iter().map(ModuleUpload::of).collect::<Result<Vec<_>, _>>()?;
    let mut session = args.connection.open(console)?;
    let mut there = Vec::new();
    for module in &modules {
        there.push(shown(module, &mut session, console)?);
    }
    if !args.yes {
        would_load(args, &modules, &mut session, console)?;
        session.end()?;
        writeln!(console.out(), "dry run: nothing was written; --yes writes")?;
        let is_same = there.iter().all(|there| *there == There::Same);
        return Ok(if is_same { Outcome::Done } else { Outcome::Difference });
    }
    // What cannot be loaded is told before anything is written.
    let loading = if args.load { Some(may_load(args, &modules, &mut session)?) } else { None };
    for (module, there) in modules.iter().zip(&there) {
        if *there != There::Same {
            session.write_file(&module.file, &module.bytes)?;
            writeln!(
                console.out(),
                "{}: {} bytes written, read back, the same",
                module.file,
                module.bytes.len()
            )?;
        }
    }
    let outcome = match loading {
        Some(loading) => load(args, &modules, &loading, &mut session, console)?,
        None => Outcome::Done,
    };
    session.end()?;
    Ok(outcome)
}

/// Says what would become of what is there.
fn shown(module: &ModuleUpload, session: &mut Session, console: &mut Console) -> anyhow::Result<There> {
    let Some(bytes) = session.file(&module.file)? else {
        writeln!(console.out(), "{}: new in HOME, {} bytes", module.file, module.bytes.len())?;
        return Ok(There::Nothing);
    };
    if bytes == module.bytes {
        writeln!(console.out(), "{}: is in HOME already, the same {} bytes", module.file, bytes.len())?;
        return Ok(There::Same);
    }
    writeln!(console.out(), "{}: another is in HOME:", module.file)?;
    let mut cut = report::Cut::new(console.out(), DIFF_LINES);
    report::write_texts(&mut cut, &format!("HOME/{}", module.file), &module.file, &bytes, &module.bytes)?;
    let dropped = cut.dropped;
    if dropped > 0 {
        writeln!(console.out(), "... and {dropped} more {}", report::plural(dropped, "line"))?;
    }
    Ok(There::Other)
}

/// Says what loading would meet; where the task is not known, that.
fn would_load(
    args: &Args,
    modules: &[ModuleUpload],
    session: &mut Session,
    console: &mut Console,
) -> anyhow::Result<()> {
    match Loading::of(modules, args.task.as_deref(), session) {
        Ok(loading) => Ok(write!(console.out(), "{}", loading.text(modules))?),
        Err(LoadingError::Task(why)) => {
            Ok(writeln!(console.out(), "what --load would meet is not known: {}", why.message)?)
        }
        Err(LoadingError::Link(error)) => Err(error.into()),
    }
}

/// What is met, where RAPID stands still and everything can be loaded.
fn may_load(args: &Args, modules: &[ModuleUpload], session: &mut Session) -> anyhow::Result<Loading> {
    let loading = Loading::of(modules, args.task.as_deref(), session).map_err(in_command)?;
    match session.execution()? {
        Execution::Stopped => {}
        other => return Err(LinkError::Running(other.to_string()).into()),
    }
    loading.replaces()?;
    Ok(loading)
}

/// Exchanges the modules, asked for again.
fn load(
    args: &Args,
    modules: &[ModuleUpload],
    loading: &Loading,
    session: &mut Session,
    console: &mut Console,
) -> anyhow::Result<Outcome> {
    let (task, replaces) = (&loading.task, loading.replaces()?);
    write!(console.out(), "{}", loading.text(modules))?;
    let is_sure = args.confirmed || is_yes("RAPID stands still. Load?", session, console)?;
    if !is_sure {
        console.note("nothing was loaded: it was not confirmed (--confirmed in scripts)");
        return Ok(Outcome::Refused);
    }
    let before = EmittedState::of_task(session, task, &loading.loaded)?;
    let mut on_notice = |text: &str| console.note(text);
    session.with_right(&mut on_notice, |session| {
        let mut all = modules.iter().zip(&replaces);
        all.try_for_each(|(module, replaces)| {
            session.exchange_module(task, &module.module, &module.file, *replaces)
        })
    })?;
    for module in modules {
        writeln!(console.out(), "{}: loaded into {task}", module.module)?;
    }
    let minute = before.iter().flat_map(|own| &own.values).find(|(name, _)| name == "tcMinute");
    if let Some((_, minute)) = minute {
        console.note(format_args!(
            "the warm-up state begins anew: it was at minute {minute}; `tcStartAt {minute}` takes it up"
        ));
    }
    Ok(Outcome::Done)
}

/// An error of the controller stays one: an interruption is no failure.
fn in_command(error: LoadingError) -> anyhow::Error {
    match error {
        LoadingError::Task(message) => message.into(),
        LoadingError::Link(error) => error.into(),
    }
}
