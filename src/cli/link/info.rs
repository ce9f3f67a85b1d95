//! `driftpost link info`: what a controller is and how it stands.

use super::connection::Connection;
use crate::cli::files::Output;
use crate::cli::{Console, Outcome};
use driftpost::application::LinkInfo;
use std::path::PathBuf;

/// Options of `link info`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The host, who logs in, and how its certificate is pinned.
    #[command(flatten)]
    connection: Connection,

    /// The same as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    json: Option<PathBuf>,
}

/// Runs `link info`.
///
/// # Errors
/// `link::*`.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let json = Output::new(args.json.as_deref())?;
    let mut session = args.connection.open(console)?;
    let found = LinkInfo::of(&mut session)?;
    session.end()?;
    if !json.is_standard() {
        found.write(console.out())?;
    }
    json.write_json(console, &found.json())?;
    Ok(Outcome::Done)
}
