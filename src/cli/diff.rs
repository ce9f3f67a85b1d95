//! `driftpost diff`: two programs, line by line, motion by motion and bucket by bucket.

use super::files::Output;
use super::inspect::Format;
use super::program_input::ProgramInput;
use super::shared::ProgramSettings;
use super::{Console, Outcome, emitted_settings, model};
use driftpost::application::ProgramComparison;
use std::path::PathBuf;
use std::sync::Arc;

/// Command line of `driftpost diff`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The one program: a module, a folder, or a .pgf; as a rule the original.
    #[arg(value_name = "A")]
    pub before: PathBuf,

    /// The other, as a rule compensated.
    #[arg(value_name = "B")]
    pub after: PathBuf,

    /// Robot, tools, work objects and start.
    #[command(flatten)]
    pub settings: ProgramSettings,

    /// Joints that the motions of A end with (CSV: file,line,q1_deg..q6_deg, or a row q1_deg..q6_deg for each target in order), as it was compensated with.
    #[arg(long, value_name = "FILE", help_heading = "Robot and program")]
    pub joints_hint: Option<PathBuf>,

    /// Form of what is written; text begins with the lines that differ and ends with the verdict.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,

    /// Show every motion with every bucket, and every line that differs.
    #[arg(long)]
    pub all: bool,

    /// All figures as JSON, beside what --format gives; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// Runs `diff`.
///
/// # Errors
/// A program that cannot be read, a robot that is not known.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let json = Output::new(args.json.as_deref())?;
    let before = ProgramInput::read(std::slice::from_ref(&args.before))?;
    let after = ProgramInput::read(std::slice::from_ref(&args.after))?;
    let mut job = ProgramComparison::new(before.placed(), after.placed());
    let ProgramSettings { robot, tool, wobj, start_joints } = &args.settings;
    (job.tools, job.wobjs) = (tool.clone(), wobj.clone());
    job.start_rad = start_joints.map(|joints| joints.0);
    job.joints_hint = args.joints_hint.as_deref().map(model::joints_hint).transpose()?.map(Arc::new);
    console.report(job.order_warning());
    let found = job.run(|emitted_settings| {
        let robot = emitted_settings::robot(emitted_settings, robot.as_deref())?;
        // A model that is not at hand is no reason to compare nothing: the figures are left out.
        Ok((robot, emitted_settings::deformed(emitted_settings, None).ok().flatten()))
    })?;
    if !json.is_standard() {
        match args.format {
            Format::Text => found.write(console.out(), args.all)?,
            Format::Csv => found.write_csv(console.out())?,
            Format::Json => found.write_json(console.out())?,
        }
    }
    json.write(console, || {
        let mut text = Vec::new();
        found.write_json(&mut text)?;
        Ok(text)
    })?;
    Ok(if found.is_same() || found.is_as_declared() { Outcome::Done } else { Outcome::Difference })
}
