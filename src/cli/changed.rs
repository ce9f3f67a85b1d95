//! `driftpost changed`: what has changed between two measurements of one robot.

use super::number::positive;
use super::{Console, Outcome, diagnose, files, measured, model};
use crate::diagnose::{Changed, ChangedError, Options, changed};
use crate::diagnostic::Diagnostic;
use crate::report::changed as report;
use crate::units::m_from_mm;
use std::io::Write;
use std::path::PathBuf;

/// Options of `changed`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Measurements before.
    #[arg(value_name = "BEFORE")]
    pub before: PathBuf,

    /// Measurements after, of the same poses with the same target.
    #[arg(value_name = "AFTER")]
    pub after: PathBuf,

    /// A built-in robot's name, or a robot file (TOML).
    #[arg(long, value_name = "NAME|FILE", default_value = "irb140")]
    pub robot: String,

    /// Place of the measured target in the flange's frame, mm, known to about 1 mm.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub tool: Option<String>,

    /// Noise of one coordinate, mm, where it is known better than the repeats say it.
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    pub sigma_mm: Option<f64>,

    /// Another layout of both files (TOML, docs/MEASURING.md).
    #[arg(long, value_name = "MAP.toml")]
    pub columns: Option<PathBuf>,

    /// Exit 1 only where the points, or the tool, have moved by more than this [default: by more than the noise].
    #[arg(long, value_name = "MM")]
    pub limit_mm: Option<f64>,

    /// Everything a script needs, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// Runs `changed`.
///
/// # Errors
/// A file that cannot be read or written, too few poses in both.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    positive(&[("--sigma-mm", args.sigma_mm), ("--limit-mm", args.limit_mm)])?;
    let robot = model::robot(&args.robot)?;
    let options = Options {
        tool_m: args.tool.as_deref().map(diagnose::tool).transpose()?,
        sigma_m: args.sigma_mm.map(m_from_mm),
    };
    let json = files::Output::new(args.json.as_deref())?;
    let before = measured::of_file(&args.before, args.columns.as_deref())?;
    let after = measured::of_file(&args.after, args.columns.as_deref())?;
    let found = changed(&before, &after, &robot, &options).map_err(|error| refused(&error))?;
    let said = verdict(&found, args.limit_mm);
    let takes_standard_output = json.is_standard();
    json.write(console, || Ok(format!("{:#}\n", report::json(&found, said)).into_bytes()))?;
    let to: &mut dyn Write = if takes_standard_output { console.err() } else { console.out() };
    report::write(to, &found, said)?;
    Ok(if said { Outcome::Difference } else { Outcome::Done })
}

fn verdict(found: &Changed, limit_mm: Option<f64>) -> bool {
    let Some(limit_m) = limit_mm.map(m_from_mm) else { return found.is_changed };
    let largest = found.worst.first().map_or(0.0, |w| w.2);
    let tool = found.tools_moved_m.iter().map(|(by, _)| by.norm()).fold(0.0, f64::max);
    found.is_changed && (largest > limit_m || tool > limit_m)
}

fn refused(error: &ChangedError) -> Diagnostic {
    let code = match error {
        ChangedError::TooFew { .. } => "changed::too-few",
        ChangedError::Fault { .. } => "measure::fault",
        ChangedError::Register(_) => "measure::registration",
    };
    Diagnostic::error(code, error.to_string())
        .help("measure the same poses with the same target each time, 30 spread ones")
}
