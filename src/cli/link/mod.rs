//! `driftpost link`: what a controller says of itself, and the little that may be written to it.
//!
//! Nothing here or below can start, stop or move a robot: `robot_link` has no request for it.

mod check;
mod connection;
mod data;
mod double;
mod info;
mod push;
mod question;
mod watch;

use super::{Console, Outcome, interrupt};
use clap::Subcommand;
use driftpost::application::link_message;
use robot_link::LinkError;

/// Command line of `driftpost link`.
#[derive(Debug, clap::Args)]
pub struct Args {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// What a controller is and how it stands: RobotWare, robot, options, mode, tasks, modules, the state of corrected programs.
    Info(info::Args),
    /// Put a program's targets to the controller's own kinematics: poses, branches, configurations. Nothing moves.
    Check(Box<check::Args>),
    /// Show what would be written into HOME; with --yes write it, with --load exchange the modules while RAPID stands still.
    Push(push::Args),
    /// Values of the data of corrected programs.
    Get(data::GetArgs),
    /// Write one of them: tcMode, say.
    Set(data::SetArgs),
    /// State, bucket or share, minute and messages of corrected programs, as they change.
    Watch(watch::Args),
    /// A strict double of a controller on this computer, to try the other commands on; it has no arm.
    Double(double::Args),
    /// Print every request that this program can send to a controller.
    Requests,
}

/// Runs `link`.
///
/// # Errors
/// `link::*`.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let ended = match &args.command {
        Command::Info(args) => info::run(args, console),
        Command::Check(args) => check::run(args, console),
        Command::Push(args) => push::run(args, console),
        Command::Get(args) => data::get(args, console),
        Command::Set(args) => data::set(args, console),
        Command::Watch(args) => watch::run(args, console),
        Command::Double(args) => double::run(args, console),
        Command::Requests => requests(console),
    };
    match ended {
        // By now everything is given back and the session has ended.
        Err(error) if error.downcast_ref::<LinkError>() == Some(&LinkError::Interrupted) => {
            interrupt::leave()
        }
        Err(error) => Err(match error.downcast::<LinkError>() {
            Ok(error) => anyhow::Error::from(link_message(&error)),
            Err(other) => other,
        }),
        done => done,
    }
}

/// The table of requests as it is in the program.
fn requests(console: &mut Console) -> anyhow::Result<Outcome> {
    for request in robot_link::requests::ALL {
        writeln!(console.out(), "{} ({:?})", request.name, request.effect)?;
        for dialect in robot_link::Dialect::ALL {
            let form = request.form(dialect).unwrap_or("-");
            writeln!(console.out(), "  {dialect}: {form}")?;
        }
    }
    Ok(Outcome::Done)
}
