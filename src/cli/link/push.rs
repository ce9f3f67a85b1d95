//! `driftpost link push`: corrected modules into the controller's HOME, and into the task where that is asked for twice.

use super::connection::Connection;
use super::question::is_yes;
use crate::application::{EmittedState, check_modules};
use crate::cli::files::Output;
use crate::cli::program_input::ProgramInput;
use crate::cli::{Console, Outcome};
use crate::report::{self, LocatedDiagnostic};
use driftpost::application::{
    HomeFile, Loading, LoadingError, ModuleUpload, PushFailure, PushReport, link_message,
};
use rapid_syntax::diagnostic::Diagnostic;
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

    /// What is in HOME and in the task, and what was written and loaded, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    json: Option<PathBuf>,
}

/// What goes on at one controller.
struct Push<'c> {
    modules: Vec<ModuleUpload>,
    session: Session,
    console: &'c mut Console,
    /// Standard output is the JSON's.
    is_silent: bool,
    report: PushReport,
    /// What the task was found to have, where it was asked.
    loading: Option<Loading>,
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
    let json = Output::new(args.json.as_deref())?;
    let session = args.connection.open(console)?;
    let report = PushReport::default();
    let mut push = Push { modules, session, console, is_silent: json.is_standard(), report, loading: None };
    let done = if args.yes { push.write(args) } else { push.show(args) };
    let Push { modules, session, console, mut report, loading, .. } = push;
    let done = done.and_then(|outcome| {
        session.end()?;
        Ok(outcome)
    });
    report.error = done.as_ref().err().map(failure);
    // A script has to know what is at the controller now; where nothing was asked of it the message is all.
    if report.error.is_some() && !report.has_begun {
        return done;
    }
    let written = json.write_json(console, &report.json(&modules, loading.as_ref()));
    let outcome = done?;
    written?;
    Ok(outcome)
}

/// An error as scripts read it.
fn failure(error: &anyhow::Error) -> PushFailure {
    let of_link = || error.downcast_ref::<LinkError>().map(link_message);
    match error.downcast_ref::<Diagnostic>().cloned().or_else(of_link) {
        Some(message) => PushFailure { code: Some(message.code), message: message.message },
        None => PushFailure { code: None, message: format!("{error:#}") },
    }
}

impl Push<'_> {
    /// What would be written and loaded.
    fn show(&mut self, args: &Args) -> anyhow::Result<Outcome> {
        self.compare()?;
        self.loading = match Loading::of(&self.modules, args.task.as_deref(), &mut self.session) {
            Ok(loading) => {
                self.say(loading.text(&self.modules))?;
                Some(loading)
            }
            Err(LoadingError::Task(why)) => {
                self.say(format!("what --load would meet is not known: {}\n", why.message))?;
                None
            }
            Err(LoadingError::Link(error)) => return Err(error.into()),
        };
        self.say("dry run: nothing was written; --yes writes\n")?;
        Ok(if self.report.is_same() { Outcome::Done } else { Outcome::Difference })
    }

    fn write(&mut self, args: &Args) -> anyhow::Result<Outcome> {
        self.compare()?;
        // What cannot be loaded is told before anything is written.
        if args.load {
            self.loading = Some(may_load(args, &self.modules, &mut self.session)?);
        }
        for position in 0..self.modules.len() {
            if self.report.modules[position].home == HomeFile::Same {
                continue;
            }
            let ModuleUpload { file, bytes, .. } = &self.modules[position];
            self.report.has_begun = true;
            self.session.write_file(file, bytes)?;
            self.report.modules[position].is_written = true;
            let text = format!("{file}: {} bytes written, read back, the same\n", bytes.len());
            self.say(text)?;
        }
        match self.loading.clone() {
            Some(loading) => self.load(args, &loading),
            None => Ok(Outcome::Done),
        }
    }

    /// Says it as it is: lines of a module may be Latin-1.
    fn say(&mut self, text: impl AsRef<[u8]>) -> std::io::Result<()> {
        if self.is_silent { Ok(()) } else { self.console.out().write_all(text.as_ref()) }
    }

    /// Says what would become of what is in HOME.
    fn compare(&mut self) -> anyhow::Result<()> {
        for position in 0..self.modules.len() {
            let ModuleUpload { file, bytes, .. } = &self.modules[position];
            let found = self.session.file(file)?;
            let (home, text) = match &found {
                None => (HomeFile::New, format!("{file}: new in HOME, {} bytes\n", bytes.len()).into_bytes()),
                Some(found) if found == bytes => (
                    HomeFile::Same,
                    format!("{file}: is in HOME already, the same {} bytes\n", bytes.len()).into_bytes(),
                ),
                Some(found) => (HomeFile::Other, difference(file, found, bytes)?),
            };
            self.report.add(home);
            self.say(text)?;
        }
        Ok(())
    }

    /// Exchanges the modules, asked for again.
    fn load(&mut self, args: &Args, loading: &Loading) -> anyhow::Result<Outcome> {
        let (task, replaces) = (&loading.task, loading.replaces()?);
        self.say(loading.text(&self.modules))?;
        let Push { modules, session, console, report, .. } = self;
        let is_sure = args.confirmed || is_yes("RAPID stands still. Load?", session, console)?;
        if !is_sure {
            console.note("nothing was loaded: it was not confirmed (--confirmed in scripts)");
            return Ok(Outcome::Refused);
        }
        let before = EmittedState::of_task(session, task, &loading.loaded)?;
        let mut on_notice = |text: &str| console.note(text);
        report.has_begun = true;
        let done = session.with_right(&mut on_notice, |session| {
            let mut all = modules.iter().zip(&replaces).zip(&mut report.modules);
            all.try_for_each(|((module, replaces), pushed)| {
                session.exchange_module(task, &module.module, &module.file, *replaces)?;
                pushed.is_loaded = true;
                Ok(())
            })
        });
        let loaded = modules.iter().zip(&report.modules).filter(|(_, pushed)| pushed.is_loaded);
        let text: String =
            loaded.map(|(module, _)| format!("{}: loaded into {task}\n", module.module)).collect();
        self.say(text)?;
        done?;
        let mut values = before.into_iter().flat_map(|own| own.values);
        self.report.minute_before = values.find(|(name, _)| name == "tcMinute").map(|(_, minute)| minute);
        if let Some(minute) = &self.report.minute_before {
            self.console.note(format_args!(
                "the warm-up state begins anew: it was at minute {minute}; `tcStartAt {minute}` takes it up"
            ));
        }
        Ok(Outcome::Done)
    }
}

/// What is in HOME beside what is to come, line by line, cut to what one reads.
fn difference(file: &str, found: &[u8], bytes: &[u8]) -> anyhow::Result<Vec<u8>> {
    let mut out = format!("{file}: another is in HOME:\n").into_bytes();
    let mut cut = report::Cut::new(&mut out, DIFF_LINES);
    report::write_texts(&mut cut, &format!("HOME/{file}"), file, found, bytes)?;
    let dropped = cut.dropped;
    if dropped > 0 {
        out.extend(format!("... and {dropped} more {}\n", report::plural(dropped, "line")).into_bytes());
    }
    Ok(out)
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

/// An error of the controller stays one: an interruption is no failure.
fn in_command(error: LoadingError) -> anyhow::Error {
    match error {
        LoadingError::Task(message) => message.into(),
        LoadingError::Link(error) => error.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::difference;

    /// RAPID is Latin-1 on many controllers: what is shown of it are its own bytes.
    #[test]
    fn a_difference_has_the_bytes_of_the_files() {
        let shown = difference("a.mod", b"! caf\xe9\n", b"! tea\n").unwrap();
        assert!(shown.windows(6).any(|part| part == b"! caf\xe9"), "{}", String::from_utf8_lossy(&shown));
    }
}
