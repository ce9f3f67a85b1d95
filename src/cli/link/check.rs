//! `driftpost link check`: a program's targets put to the controller's own kinematics.

use super::connection::Connection;
use crate::application::check_modules;
use crate::cli::files::Output;
use crate::cli::number::positive;
use crate::cli::program_input::ProgramInput;
use crate::cli::shared::ProgramSettings;
use crate::cli::{Console, Outcome, emitted_settings};
use crate::report::LocatedDiagnostic;
use driftpost::application::{EmittedSettings, LinkCheck, LinkCheckError, LinkChecked};
use rapid_program::Program;
use rapid_syntax::diagnostic::Diagnostic;
use robot_link::Unit;
use std::path::PathBuf;

/// Options of `link check`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// A module, a folder of them, or a .pgf; original or corrected.
    #[arg(value_name = "PROGRAM")]
    program: PathBuf,

    /// The host, who logs in, and how its certificate is pinned.
    #[command(flatten)]
    connection: Connection,

    /// Robot, tools, work objects and start.
    #[command(flatten)]
    settings: ProgramSettings,

    /// The arm's mechanical unit.
    #[arg(long, value_name = "UNIT", default_value = "ROB_1")]
    unit: String,

    /// Ask for every element of scheduled targets, and show every target.
    #[arg(long)]
    all: bool,

    /// Poses further apart do not agree, mm.
    #[arg(long, value_name = "MM", default_value_t = LinkCheck::TOLERANCE_MM)]
    tolerance_mm: f64,

    /// Angles and joints further apart do not agree, degrees.
    #[arg(long, value_name = "DEG", default_value_t = LinkCheck::TOLERANCE_DEG)]
    tolerance_deg: f64,

    /// All figures as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    json: Option<PathBuf>,
}

/// Runs `link check`.
///
/// # Errors
/// A program that cannot be read, a robot that is not known, `link::*`.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    positive(&[("--tolerance-mm", Some(args.tolerance_mm)), ("--tolerance-deg", Some(args.tolerance_deg))])?;
    let json = Output::new(args.json.as_deref())?;
    let given = ProgramInput::read(std::slice::from_ref(&args.program))?;
    let program = given.program();
    let emitted_settings = EmittedSettings::of(&[&program], None);
    let robot = emitted_settings::robot(&emitted_settings, args.settings.robot.as_deref())?;
    let overrides = emitted_settings.overrides(&args.settings.tool, &args.settings.wobj);
    let start_rad = emitted_settings.start_rad(args.settings.start_joints.map(|joints| joints.0))?;
    let sources = program.sources();
    if let Err(message) = check_modules(&sources) {
        console.explain(&[LocatedDiagnostic::new(message, &sources)], true);
        return Ok(Outcome::Refused);
    }
    let program = Program::read(sources, &overrides);
    let mut check = LinkCheck::new(Unit::new(&args.unit)?);
    check.all = args.all;
    (check.tolerance_mm, check.tolerance_deg) = (args.tolerance_mm, args.tolerance_deg);
    let mut session = args.connection.open(console)?;
    let identity = session.identity()?;
    if identity.absolute_accuracy == Some(true) {
        console
            .note("warning: Absolute Accuracy is on; whether the controller's answers hold it is not known");
    }
    let checked = console
        .while_busy("asking the controller", || check.run(&mut session, &program, &robot, start_rad))
        .map_err(|error| match error {
            LinkCheckError::Robot(error) => anyhow::Error::from(Diagnostic::from(error)),
            LinkCheckError::Link(error) => error.into(),
        })?;
    session.end()?;
    if !json.is_standard() {
        let robot = identity.robot.as_deref().unwrap_or("(unknown robot)");
        writeln!(console.out(), "{robot} at {}, {}", args.connection.host, identity.dialect)?;
        write!(console.out(), "{}", checked.text(args.all))?;
    }
    json.write_json(console, &checked.json_of(&args.connection.host, &identity))?;
    Ok(match (checked.agrees(), &checked) {
        (Some(true), _) | (None, LinkChecked::NotOffered(_)) => Outcome::Done,
        (Some(false), _) => Outcome::Difference,
        (None, _) => Outcome::Refused,
    })
}
