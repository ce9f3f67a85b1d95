//! `driftpost completions`: a script for the user's shell.

use super::{Cli, Console, Outcome};
use clap::CommandFactory;
use clap_complete::Shell;

/// Command line of `driftpost completions`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The shell.
    pub shell: Shell,
}

/// Runs `completions`.
///
/// # Errors
/// A standard output that cannot be written.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "driftpost", &mut script);
    console.out().write_all(&script)?;
    console.out().flush()?;
    Ok(Outcome::Done)
}
