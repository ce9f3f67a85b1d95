//! `driftpost validate`: an identified model against measurements that it has not seen.

use super::measured::MeasurementArgs;
use super::number::positive;
use super::results::Results;
use super::shared::RobotName;
use super::stops::StopArgs;
use super::{Console, Outcome, files, model};
use clap::ValueEnum;
use driftpost::application::{ModelCheck, ValidateError};
use metrology::diagnose::RefitScope;
use std::path::PathBuf;

/// Command line of `driftpost validate`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Where measurements come from.
    #[command(flatten)]
    pub source: MeasurementArgs,

    /// The robot that was measured.
    #[command(flatten)]
    pub robot: RobotName,

    /// The identified model (TOML).
    #[arg(long, value_name = "FILE")]
    pub model: PathBuf,

    /// What of base and tool is fitted again; the rest is the model's.
    #[arg(long, value_enum, default_value_t = RefitScopeName::BaseTool)]
    pub register: RefitScopeName,

    /// When the robot stood, for a model whose drift follows its warmth.
    #[command(flatten)]
    pub stop: StopArgs,

    /// Exit 1 where the rms distance is more than this.
    #[arg(long, value_name = "MM")]
    pub limit_mm: Option<f64>,

    /// Everything a script needs, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// What is fitted again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum RefitScopeName {
    /// Base and tool.
    #[value(name = "base,tool")]
    BaseTool,
    /// The base alone.
    Base,
    /// Nothing.
    None,
}

/// Runs `validate`.
///
/// # Errors
/// A file that cannot be read or written, or a registration that cannot be had.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    console.keep_warnings();
    positive(&[("--limit-mm", args.limit_mm)])?;
    let robot = args.robot.load_arm()?;
    let mut job = ModelCheck::new(robot, model::identified(&args.model)?.model);
    job.limit_mm = args.limit_mm;
    job.stops = args.stop.stops()?;
    job.refit = match args.register {
        RefitScopeName::BaseTool => RefitScope::BaseAndTool,
        RefitScopeName::Base => RefitScope::Base,
        RefitScopeName::None => RefitScope::Nothing,
    };
    let json = files::Output::new(args.json.as_deref())?;
    let (measurements, given) = args.source.read(console)?;
    let times_min = measurements.rows.iter().filter_map(|row| row.t_min);
    if let Some(last_min) = times_min.reduce(f64::max) {
        args.stop.check_before(last_min)?;
    }
    console.report(job.warning().into_iter().chain(job.seen_before(&given.sha256)));
    let found = job.run(&measurements).map_err(|error| match error {
        ValidateError::ModelJoints { .. } | ValidateError::NoMounting => {
            model::in_file(&args.model.display().to_string(), error.into())
        }
        of_measurements => given.in_file(of_measurements),
    })?;
    given.report(&found.warnings, console);
    Results::new(found.json(), found.text()).with_warnings(console).write(json, console)?;
    Ok(if found.holds() { Outcome::Done } else { Outcome::Difference })
}
