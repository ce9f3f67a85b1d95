//! `driftpost link push`: corrected modules into the controller's HOME, and into the task where that is asked for twice.

use super::connection::Connection;
use super::question::is_yes;
use crate::cli::program_input::ProgramInput;
use crate::cli::{Console, Outcome};
use driftpost::application::{OwnData, check_modules, is_own_name};
use driftpost::report::{self, LocatedDiagnostic};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::Diagnostic;
use rapid_syntax::tree::{FileItem, ModuleItem};
use robot_link::{Execution, LoadedModule, Session};
use std::path::PathBuf;

/// Lines of a difference that are shown.
const DIFF_LINES: usize = 60;
/// Data of ours that a loaded module is asked for.
const ASKED: usize = 8;

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

/// A module to be sent.
struct Sent {
    file: String,
    module: String,
    bytes: Vec<u8>,
    /// Names of our own data that it declares, as far as they are asked for.
    own: Vec<String>,
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
    let modules = sources.iter().map(sent).collect::<Result<Vec<_>, _>>()?;
    let mut session = args.connection.open(console)?;
    let mut there = Vec::new();
    for module in &modules {
        there.push(shown(module, &mut session, console)?);
    }
    if !args.yes {
        session.end()?;
        writeln!(console.out(), "dry run: nothing was written; --yes writes")?;
        let is_same = there.iter().all(|there| *there == There::Same);
        return Ok(if is_same { Outcome::Done } else { Outcome::Difference });
    }
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
    let outcome = if args.load { load(args, &modules, &mut session, console)? } else { Outcome::Done };
    session.end()?;
    Ok(outcome)
}

fn sent(source: &SourceFile) -> Result<Sent, Diagnostic> {
    let tree = source.whole_tree();
    let text = |range| String::from_utf8_lossy(source.text(range)).into_owned();
    let found = tree.items.iter().find_map(|item| match item {
        FileItem::Module(module) => Some(module),
        _ => None,
    });
    let Some(module) = found else {
        let message = format!("{} holds no module", source.path);
        return Err(Diagnostic::error("input::no-module", message).help("give a module"));
    };
    let declared = module.items.iter().filter_map(|item| match item {
        ModuleItem::Data(data) => Some(text(data.name)),
        _ => None,
    });
    Ok(Sent {
        file: source.path.rsplit('/').next().unwrap_or(&source.path).to_owned(),
        module: text(module.name),
        bytes: source.bytes.to_vec(),
        own: declared.filter(|name| is_own_name(name)).take(ASKED).collect(),
    })
}

/// Says what would become of what is there.
fn shown(module: &Sent, session: &mut Session, console: &mut Console) -> anyhow::Result<There> {
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

/// Exchanges the modules, asked for again.
fn load(
    args: &Args,
    modules: &[Sent],
    session: &mut Session,
    console: &mut Console,
) -> anyhow::Result<Outcome> {
    let task = task(args.task.as_deref(), session)?;
    match session.execution()? {
        Execution::Stopped => {}
        other => return Err(robot_link::LinkError::Running(other.to_string()).into()),
    }
    let loaded = session.modules(&task)?;
    let mut replaces = Vec::new();
    for module in modules {
        replaces.push(is_replaced(module, &task, &loaded, session)?);
    }
    for (module, replaces) in modules.iter().zip(&replaces) {
        let how = if *replaces { "in place of the corrected module of this name" } else { "as a new module" };
        console.say(format_args!("{} into {task}, {how}", module.module));
    }
    let is_sure = args.confirmed || is_yes("RAPID stands still. Load?", session, console)?;
    if !is_sure {
        console.say("nothing was loaded: it was not confirmed (--confirmed in scripts)");
        return Ok(Outcome::Refused);
    }
    let before = OwnData::of_task(session, &task, &loaded)?;
    let mut tell = |text: &str| console.say(text);
    session.with_right(&mut tell, |session| {
        let mut all = modules.iter().zip(&replaces);
        all.try_for_each(|(module, replaces)| {
            session.exchange_module(&task, &module.module, &module.file, *replaces)
        })
    })?;
    for module in modules {
        writeln!(console.out(), "{}: loaded into {task}", module.module)?;
    }
    let minute = before.iter().flat_map(|own| &own.values).find(|(name, _)| name == "tcMinute");
    if let Some((_, minute)) = minute {
        console.say(format_args!(
            "the warm-up state begins anew: it was at minute {minute}; `tcStartAt {minute}` takes it up"
        ));
    }
    Ok(Outcome::Done)
}

/// The task that is named, or the only one that moves an arm.
fn task(named: Option<&str>, session: &mut Session) -> anyhow::Result<String> {
    if let Some(named) = named {
        return Ok(named.to_owned());
    }
    let tasks = session.tasks()?;
    let mut moving = tasks.into_iter().filter(|task| task.moves && task.is_active);
    match (moving.next(), moving.next()) {
        (Some(one), None) => Ok(one.name),
        _ => {
            let text = "the controller has no task, or several, that move an arm";
            Err(Diagnostic::error("link::which-task", text).help("name one with --task").into())
        }
    }
}

/// Whether a corrected module of the name is loaded and goes; one that is not ours is never taken out.
fn is_replaced(
    module: &Sent,
    task: &str,
    loaded: &[LoadedModule],
    session: &mut Session,
) -> anyhow::Result<bool> {
    if !loaded.iter().any(|l| l.name.eq_ignore_ascii_case(&module.module)) {
        return Ok(false);
    }
    for name in &module.own {
        if session.property(task, &module.module, name)?.is_some() {
            return Ok(true);
        }
    }
    let text =
        format!("{} is loaded in {task} and is no corrected module: it is not taken out", module.module);
    let help = "save it on the pendant if need be and unload it there, then run again";
    Err(Diagnostic::error("link::not-ours", text).help(help).into())
}
