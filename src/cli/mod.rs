//! Arguments, files, progress, exit codes; one file per subcommand. No formulas.
//!
//! A subcommand is a file with `Args` (clap) and `run(&Args, &mut Console) -> anyhow::Result<Outcome>`,
//! one variant of `Command` and one line of `dispatch`.
//! An error that leaves `run` is best a [`Diagnostic`]: its help line is
//! shown then, and its code stands in `docs/MESSAGES.md`.

mod console;
mod copies;
mod destination;
pub mod emitted_settings;
pub mod files;
mod idle;
mod interrupt;
mod left_over;
pub mod measured;
pub mod minutes;
pub mod model;
pub mod number;
pub mod other_robot;
mod other_tasks;
mod outcome;
mod overwriting;
pub mod page;
mod pending;
mod program_at;
pub mod program_input;
mod results;
mod sealed;
mod settings;
pub mod shared;
mod simulate_hints;
pub mod state;
mod stops;
mod suggest;
mod writing;

pub mod accuracy;
pub mod closed_loop;
pub mod compare_measurements;
pub mod compensate;
pub mod completions;
pub mod diagnose;
pub mod diff;
pub mod exam;
pub mod fit;
pub mod golden;
pub mod inspect;
#[cfg(feature = "link")]
pub mod link;
pub mod man;
pub mod plan;
pub mod report;
pub mod restore;
pub mod robot;
pub mod simulate;
pub mod synth;
pub mod tabulate;
pub mod validate;

pub use console::Console;
pub use outcome::Outcome;

use crate::report::LocatedDiagnostic;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{ArgMatches, Args as _, CommandFactory, FromArgMatches, Parser, Subcommand};
use driftpost::{Compensation, ProgramFiles};
use rapid_syntax::diagnostic::Diagnostic;
use settings::Settings;
use std::cell::RefCell;
use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::rc::Rc;

/// Drift compensation for ABB RAPID programs, and diagnosis of why a robot does not stand where its
/// model says.
///
/// Exit codes: 0 done; 1 found a difference or out of tolerance; 2 could not, or refused.
/// Results go to standard output, messages and progress to standard error.
#[derive(Debug, Parser)]
#[command(name = "driftpost", version, arg_required_else_help = true, max_term_width = 110)]
struct Cli {
    /// Defaults of the options, a TOML file. Read by accuracy, closed-loop, compare-measurements, compensate, diagnose, fit, plan, state,
    /// tabulate and validate [default: driftpost.toml, found upwards from what these work on, else from the working folder].
    #[arg(long, value_name = "FILE", global = true, help_heading = "Settings")]
    settings: Option<PathBuf>,

    /// Show every option with its value and where that comes from, and do nothing.
    #[arg(long, global = true, help_heading = "Settings")]
    show_settings: bool,

    /// Say nothing but errors; a command that writes a program shows only what was asked for with `-`, one that tells something still tells it.
    #[arg(short, long, global = true, help_heading = "Settings")]
    quiet: bool,

    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Compensate a RAPID program for thermal drift: RAPID in, RAPID out, and the difference to review.
    Compensate(Box<compensate::Args>),
    /// Compare a folder of cases with what is expected of them; --update rewrites the expected files.
    Golden(golden::Args),
    /// List a program's motions: targets, tools, work objects, what can be compensated, and why not.
    Inspect(inspect::Args),
    /// Compare two programs: the text, every motion and bucket in mm and deg, and all that is no target.
    ///
    /// Exit 0: they are the same, or nothing differs but the targets that a compensated program's comment block declares; 1: else.
    Diff(diff::Args),
    /// Make a page of a result's JSON: one HTML file that opens in any browser, offline.
    Report(report::Args),
    /// Get the original of a compensated module back.
    Restore(restore::Args),
    /// Show a robot, or write it as a robot file (TOML) or a URDF description.
    Robot(robot::Args),
    /// Execute a program on the deformed robot: where the TCP really is, against what was meant.
    Simulate(Box<simulate::Args>),
    /// Diagnose a folder of sealed measurement sets and score the answers against the truth.
    Exam(exam::Args),
    /// Make measurement sets of a virtual robot with effects of your choice, the truth sealed beside them.
    Synth(synth::Args),
    /// Joints of a list of targets at every minute of warm-up, as CSV.
    Tabulate(Box<tabulate::Args>),
    /// Diagnose measurements: which unmodelled effect opens the gap between robot and model, and when that
    /// cannot be said.
    Diagnose(diagnose::Args),
    /// Fit a deformation table to fixed points touched over a warm-up and one stop.
    Fit(fit::Args),
    /// How warm a robot is, as touches of fixed points tell it: its amount of drift and its time constants, and how often to touch.
    State(state::Args),
    /// Pose accuracy, repeatability and drift after ISO 9283; go or no go against limits.
    Accuracy(accuracy::Args),
    /// What has changed between two measurements of one robot, after a crash, say.
    #[command(alias = "changed")]
    CompareMeasurements(compare_measurements::Args),
    /// Choose poses to measure, so that effects can be told apart; a sheet to fill in and RAPID to run.
    Plan(plan::Args),
    /// The whole loop closed on a virtual robot: inject an effect, measure, diagnose, compensate, measure again.
    #[command(alias = "rehearse")]
    ClosedLoop(closed_loop::Args),
    /// Apply an identified model to measurements that it has not seen.
    Validate(validate::Args),
    /// Ask a controller, over Robot Web Services: what it is, its own kinematics, files into HOME. It cannot move the robot.
    #[cfg(feature = "link")]
    Link(Box<link::Args>),
    /// Print what makes a shell complete commands and options.
    Completions(completions::Args),
    /// Write the manual pages, one for each command.
    Man(man::Args),
}

/// Options that name a result, beside those that end in `-out`.
const OUTPUTS: [&str; 7] = ["json", "csv", "diff", "joints_csv", "mcap", "output", "report"];

fn dispatch(command: &Command, console: &mut Console) -> anyhow::Result<Outcome> {
    match command {
        Command::Accuracy(args) => accuracy::run(args, console),
        Command::ClosedLoop(args) => closed_loop::run(args, console),
        Command::CompareMeasurements(args) => compare_measurements::run(args, console),
        Command::Compensate(args) => compensate::run(args, console),
        Command::Diff(args) => diff::run(args, console),
        Command::Completions(args) => completions::run(args, console),
        Command::Man(args) => man::run(args, console),
        Command::Golden(args) => golden::run(args, console),
        Command::Inspect(args) => inspect::run(args, console),
        #[cfg(feature = "link")]
        Command::Link(args) => link::run(args, console),
        Command::Report(args) => report::run(args, console),
        Command::Robot(args) => robot::run(args, console),
        Command::Restore(args) => restore::run(args, console),
        Command::Simulate(args) => simulate::run(args, console),
        Command::Exam(args) => exam::run(args, console),
        Command::Synth(args) => synth::run(args, console),
        Command::Tabulate(args) => tabulate::run(args, console),
        Command::Diagnose(args) => diagnose::run(args, console),
        Command::Fit(args) => fit::run(args, console),
        Command::State(args) => state::run(args, console),
        Command::Plan(args) => plan::run(args, console),
        Command::Validate(args) => validate::run(args, console),
    }
}

/// Refuses results in the place of inputs or of each other, as far as the command line names them.
fn keep_apart(matches: &ArgMatches) -> Result<(), Diagnostic> {
    let Some((_, mut given)) = matches.subcommand() else { return Ok(()) };
    while let Some((_, inner)) = given.subcommand() {
        given = inner;
    }
    let (mut inputs, mut outputs): (Vec<PathBuf>, Vec<PathBuf>) = (Vec::new(), Vec::new());
    for id in given.ids() {
        let name = id.as_str();
        let paths = given.try_get_many::<PathBuf>(name).ok().flatten().into_iter().flatten().cloned();
        let is_output = name.ends_with("_out") || OUTPUTS.contains(&name);
        // What --diff says in words is no path.
        let is_word =
            |path: &PathBuf| name == "diff" && ["short", "none"].iter().any(|word| path == Path::new(word));
        let paths = paths.filter(|path| !is_word(path));
        if is_output { outputs.extend(paths) } else { inputs.extend(paths) }
    }
    inputs.extend(given.try_get_one::<String>("robot").ok().flatten().map(PathBuf::from));
    // A .pgf stands for the modules that it lists.
    let folders =
        inputs.iter().filter(|path| path.extension().is_some_and(|e| e.eq_ignore_ascii_case("pgf")));
    let folders: Vec<PathBuf> = folders.filter_map(|path| Some(path.parent()?.to_path_buf())).collect();
    inputs.extend(folders);
    let inputs: Vec<&Path> = inputs.iter().map(PathBuf::as_path).collect();
    let outputs: Vec<&Path> = outputs.iter().map(PathBuf::as_path).collect();
    files::keep_apart(&inputs, &outputs)
}

/// The command that is nearest to one that is not there, where clap itself (`help compensat`) says nothing of it.
fn near_command(error: &clap::Error, words: &[OsString]) -> Option<String> {
    if error.kind() != ErrorKind::InvalidSubcommand || error.get(ContextKind::SuggestedSubcommand).is_some() {
        return None;
    }
    let Some(ContextValue::String(wanted)) = error.get(ContextKind::InvalidSubcommand) else { return None };
    let names = |command: &clap::Command| -> Vec<String> {
        command.get_subcommands().map(|command| command.get_name().to_owned()).collect()
    };
    let command = Cli::command();
    let group =
        |group: &&clap::Command| group.has_subcommands() && words.iter().any(|word| word == group.get_name());
    let known = names(command.get_subcommands().find(group).unwrap_or(&command));
    suggest::nearest(wanted, known.iter().map(String::as_str)).map(str::to_owned)
}

/// Runs the program on the process's own arguments.
#[must_use]
pub fn run() -> ExitCode {
    interrupt::install();
    run_with(std::env::args_os().collect()).into()
}

/// Runs the program on the words of a command line, of which the first is its own name.
#[must_use]
pub fn run_with(words: Vec<OsString>) -> Outcome {
    run_on(&words, &mut Console::of_process())
}

/// What a run would have written, and the errors among it.
#[derive(Debug)]
pub struct Captured {
    /// How the command ended.
    pub outcome: Outcome,
    /// What it wrote to standard output.
    pub output: Vec<u8>,
    /// What it wrote to standard error.
    pub messages: Vec<u8>,
    /// The errors that are told in `messages`.
    pub errors: Vec<LocatedDiagnostic>,
}

/// As [`run_with`], with what is written kept.
#[must_use]
pub fn run_captured(words: &[OsString]) -> Captured {
    let (out, err) = (Kept::default(), Kept::default());
    let mut console = Console::collecting(out.clone(), err.clone());
    let outcome = run_on(words, &mut console);
    let errors = console.take_errors();
    drop(console);
    Captured { outcome, output: out.0.take(), messages: err.0.take(), errors }
}

/// Bytes that are kept.
#[derive(Clone, Default)]
struct Kept(Rc<RefCell<Vec<u8>>>);

impl Write for Kept {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0.borrow_mut().extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

/// The compensation that options of `compensate` ask for, each as on the command line (`--tolerance-mm=0.02`).
///
/// # Errors
/// `option::usage`, or what is wrong with a file that they name.
pub fn compensation(options: &[String]) -> Result<Compensation, Diagnostic> {
    let words = ["compensate", "-"].into_iter().map(OsString::from).chain(options.iter().map(OsString::from));
    let command = compensate::Args::augment_args(clap::Command::new("compensate"));
    let args = command
        .allow_negative_numbers(true)
        .try_get_matches_from(words)
        .and_then(|matches| compensate::Args::from_arg_matches(&matches));
    let args = args.map_err(|error| console::usage(&error.to_string()))?;
    args.check()?;
    args.compensation(None)
}

/// The modules that arguments name: modules, a folder, or a `.pgf`.
///
/// # Errors
/// `input::*`, naming the file.
pub fn program(paths: &[PathBuf]) -> Result<ProgramFiles, Diagnostic> {
    Ok(program_input::ProgramInput::read(paths)?.program())
}

fn run_on(words: &[OsString], console: &mut Console) -> Outcome {
    let command = Cli::command().mut_subcommands(|command| command.allow_negative_numbers(true));
    let (matches, settings) = match parse(&command, words) {
        Ok(parsed) => parsed,
        Err(ParseFailure::Settings(message)) => return console.fail(&message.into()),
        Err(ParseFailure::Usage(error)) => {
            let ended = console.usage(&error);
            if let Some(near) = near_command(&error, words) {
                console.note(format_args!("did you mean '{near}'?"));
            }
            return ended;
        }
    };
    let cli = match Cli::from_arg_matches(&matches) {
        Ok(cli) => cli,
        Err(error) => return console.usage(&error),
    };
    console.set_quiet(cli.quiet);
    console.report(settings.warning());
    let shown = matches.subcommand().filter(|_| cli.show_settings);
    let outcome = match shown.and_then(|(name, given)| Some((command.find_subcommand(name)?, given))) {
        Some((command, given)) => write!(console.out(), "{}", settings.table(command, given))
            .map(|()| Outcome::Done)
            .map_err(anyhow::Error::from),
        None => {
            keep_apart(&matches).map_err(anyhow::Error::from).and_then(|()| dispatch(&cli.command, console))
        }
    };
    let outcome = outcome.unwrap_or_else(|error| console.fail(&error));
    console.finish(outcome)
}

/// Why nothing is run.
enum ParseFailure {
    Usage(clap::Error),
    Settings(Diagnostic),
}

/// The command line, with the defaults of the settings in it.
fn parse(command: &clap::Command, words: &[OsString]) -> Result<(ArgMatches, Settings), ParseFailure> {
    let parsed = |words: &[OsString]| command.clone().try_get_matches_from(words);
    let as_written = parsed(words);
    // What is missing may stand in the settings.
    let first = match &as_written {
        Ok(matches) => Some(matches.clone()),
        Err(_) => command.clone().ignore_errors(true).try_get_matches_from(words).ok(),
    };
    let settings = first.map(|first| Settings::find(command, &first)).transpose();
    let settings = settings.map_err(ParseFailure::Settings)?.unwrap_or_default();
    if !settings.are_given() {
        return as_written.map(|matches| (matches, settings)).map_err(ParseFailure::Usage);
    }
    match parsed(&settings.add_to(words)) {
        Ok(matches) => Ok((matches, settings)),
        Err(error) => Err(settings.blame(&error).map_or(ParseFailure::Usage(error), ParseFailure::Settings)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_well_formed() {
        Cli::command().debug_assert();
    }
}
