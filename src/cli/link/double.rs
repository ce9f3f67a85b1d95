//! `driftpost link double`: a strict double of a controller on this computer.

use crate::cli::{Console, Outcome, files, interrupt};
use anyhow::Context;
use clap::ValueEnum;
use rws_double::{Double, Options, Personality};
use std::path::PathBuf;
use std::process::Command;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

/// What stands for the double's address in a command.
const HOST: &str = "HOST";

/// Options of `link double`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Which RobotWare.
    #[arg(long, value_enum, default_value_t = RobotWare::Seven)]
    robotware: RobotWare,

    /// Port on this computer; 0 for one that is free.
    #[arg(long, default_value_t = 0)]
    port: u16,

    /// A module that is loaded in its task T_ROB1; may be given more than once.
    #[arg(long, value_name = "FILE")]
    module: Vec<PathBuf>,

    /// It is in manual mode, and its operator says yes.
    #[arg(long)]
    manual: bool,

    /// Its program runs.
    #[arg(long)]
    running: bool,

    /// A command to run against it, HOST in it being its address; then it ends. Without one it serves until it is interrupted.
    #[arg(last = true, value_name = "COMMAND")]
    command: Vec<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum RobotWare {
    /// IRC5: digest over HTTP.
    #[value(name = "6")]
    Six,
    /// OmniCore: TLS.
    #[value(name = "7")]
    Seven,
    /// OmniCore with control stations.
    #[value(name = "8")]
    Eight,
}

/// Runs `link double`.
///
/// # Errors
/// A port that is taken, a module that cannot be read, a command that cannot be run.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let personality = match args.robotware {
        RobotWare::Six => Personality::Rw6,
        RobotWare::Seven => Personality::Rw7,
        RobotWare::Eight => Personality::Rw8,
    };
    let double = Double::start(&Options { port: args.port, ..Options::new(personality) })
        .with_context(|| format!("no double can be started at port {}", args.port))?;
    for path in &args.module {
        let bytes = files::read(path, "module")?;
        double.with(|controller| controller.load(&String::from_utf8_lossy(&bytes), "ProgMod"));
    }
    double.with(|controller| {
        controller.mode = if args.manual { "MANR" } else { "AUTO" };
        controller.execution = if args.running { "running" } else { "stopped" };
    });
    let outcome = match args.command.split_first() {
        None => serve(&double, personality, console)?,
        Some((program, arguments)) => against(&double, program, arguments)?,
    };
    for hit in double.hits() {
        console.note(format_args!("refused, as it could move or change a robot: {hit}"));
    }
    Ok(if double.hits().is_empty() { outcome } else { Outcome::Refused })
}

/// Serves until it is interrupted.
fn serve(double: &Double, personality: Personality, console: &mut Console) -> anyhow::Result<Outcome> {
    writeln!(console.out(), "{}", double.root())?;
    console.out().flush()?;
    console.note(format_args!(
        "a double of {personality}; user \"Default User\", password \"robotics\"; Ctrl-C ends it"
    ));
    let stop = Arc::new(AtomicBool::new(false));
    interrupt::hand_over(&stop);
    while !stop.load(Ordering::Relaxed) {
        thread::sleep(Duration::from_millis(50));
    }
    Ok(Outcome::Done)
}

/// Runs one command; what is known of controllers is kept out of the user's own file.
fn against(double: &Double, program: &str, arguments: &[String]) -> anyhow::Result<Outcome> {
    let known = tempfile::tempdir()?;
    let arguments = arguments.iter().map(|argument| argument.replace(HOST, &double.root()));
    let status = Command::new(program)
        .args(arguments)
        .env("DRIFTPOST_LINK_KNOWN", known.path().join("known_controllers"))
        .status()
        .with_context(|| format!("{program} cannot be run"))?;
    Ok(match status.code() {
        Some(0) => Outcome::Done,
        Some(1) => Outcome::Difference,
        _ => Outcome::Refused,
    })
}
