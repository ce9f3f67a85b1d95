//! `driftpost inspect`: what a program's motions are, and which can be compensated.

use super::files::Output;
use super::program_input::ProgramInput;
use super::{Console, Outcome};
use clap::ValueEnum;
use driftpost::application::Inspection;
use std::path::PathBuf;

/// Command line of `driftpost inspect`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// RAPID modules, a folder of them, or a .pgf; names are resolved across all of them.
    #[arg(required = true, value_name = "PROGRAM")]
    pub program: Vec<PathBuf>,

    /// Form of the list.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,

    /// Show every motion and every message, however many there are.
    #[arg(long)]
    pub all: bool,

    /// The list as JSON, beside what --format gives; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// Form of a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// A table for people.
    Text,
    /// For scripts.
    Json,
    /// For spreadsheets.
    Csv,
}

/// Runs `inspect`.
///
/// # Errors
/// Files that cannot be read, or hold no module.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let json = Output::new(args.json.as_deref())?;
    let given = ProgramInput::read(&args.program)?;
    console.explain(&given.warnings(), args.all);
    let inspected = match Inspection::new().run(&given.program()) {
        Ok(inspected) => inspected,
        Err(why) => {
            console.explain(&[*why], true);
            return Ok(Outcome::Refused);
        }
    };
    console.explain(&inspected.messages, args.all);
    let pretty = || format!("{:#}\n", inspected.json()).into_bytes();
    if !json.is_standard() {
        match args.format {
            Format::Text => inspected.write(console.out(), args.all)?,
            Format::Csv => inspected.write_csv(console.out())?,
            Format::Json => console.out().write_all(&pretty())?,
        }
    }
    json.write(console, || Ok(pretty()))?;
    Ok(Outcome::Done)
}
