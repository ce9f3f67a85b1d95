//! `driftpost state`: the thermal state of a robot from touches of fixed points.

use super::measured::MeasurementArgs;
use super::number::{minutes, positive};
use super::other_robot::OtherRobotArgs;
use super::results::Results;
use super::shared::{RobotName, no_tool, tool};
use super::stops::StopArgs;
use super::{Console, Outcome, files, model};
use driftpost::application::{StateError, StateEstimation};
use nalgebra::Vector3;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::units::m_from_mm;
use std::path::PathBuf;

/// Command line of `driftpost state`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Touches: fixed_id, t_min, q1_deg..q6_deg; the first of each point with the arm cold.
    #[command(flatten)]
    pub source: MeasurementArgs,

    /// The robot that was touched.
    #[command(flatten)]
    pub robot: RobotName,

    /// Place of the touching tip in the flange's frame, mm.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub tool: Option<String>,

    /// Deformation table (CSV) with --growth [default: the reference paper's Table 2, built in].
    #[arg(long, value_name = "FILE")]
    pub deformation: Option<PathBuf>,

    /// How a static table grows: exp:TAU or two-stage:TAU.
    #[arg(long, value_name = "LAW", allow_hyphen_values = true)]
    pub growth: Option<String>,

    /// An identified model (TOML) whose terms grow by one law, instead of a deformation table.
    #[arg(long, value_name = "FILE", conflicts_with = "deformation")]
    pub model: Option<PathBuf>,

    /// Whose deformation it may be.
    #[command(flatten)]
    pub accepted: OtherRobotArgs,

    /// Time constant of cooling to begin with, minutes [default: the model's, or the growth law's].
    #[arg(long, value_name = "MIN", allow_negative_numbers = true)]
    pub tau_cool: Option<f64>,

    /// One standard deviation of a coordinate of a touch.
    #[arg(long, value_name = "MM", default_value_t = StateEstimation::SIGMA_MM, allow_negative_numbers = true)]
    pub sigma_mm: f64,

    /// When the robot stood.
    #[command(flatten)]
    pub stop: StopArgs,

    /// How often to touch, and which point tells most.
    #[arg(long)]
    pub plan: bool,

    /// Everything a script needs, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// Runs `state`.
///
/// # Errors
/// A file that cannot be read or written, touches that say nothing.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    console.keep_warnings();
    positive(&[("--sigma-mm", Some(args.sigma_mm))])?;
    minutes(&[("--tau-cool", args.tau_cool)])?;
    let robot = args.robot.load()?;
    let mut job = match &args.model {
        Some(path) => {
            let identified = model::identified_alone(path, args.growth.as_deref())?.model;
            args.accepted.check(&robot, false, Some(&identified), console)?;
            StateEstimation::with_model(robot, &identified)
        }
        None => {
            args.accepted.check(&robot, args.deformation.is_none(), None, console)?;
            let table = model::deformation(args.deformation.as_deref(), args.growth.as_deref())?;
            StateEstimation::new(robot, &table)
        }
    };
    job.tool_m = args.tool.as_deref().map(tool).transpose()?.unwrap_or_else(Vector3::zeros);
    job.stops = args.stop.stops()?;
    job.sigma_m = m_from_mm(args.sigma_mm);
    job.tau_cool_min = args.tau_cool.or(job.tau_cool_min);
    let (touches, given) = args.source.touches(console)?;
    args.stop.check_before(touches.span_min()[1])?;
    console.report(no_tool(args.tool.as_deref(), &touches));
    let json = files::Output::new(args.json.as_deref())?;
    let found = job.run(&touches).map_err(|error| match error {
        // Of the deformation, whatever the touches are.
        StateError::NoLaw => Diagnostic::from(error),
        of_touches => given.in_file(of_touches),
    })?;
    given.report(&found.state.warnings, console);
    let results = Results::new(found.json(), found.text(args.plan)).with_warnings(console);
    results.write(json, console)?;
    Ok(Outcome::Done)
}
