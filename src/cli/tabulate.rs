//! `driftpost tabulate`: joints of a list of targets at every minute of warm-up.

#![allow(
    rustdoc::broken_intra_doc_links,
    reason = "doc comments of options are their help texts: brackets are brackets"
)]

use super::files::{self, Output};
use super::minutes::Minutes;
use super::other_robot::OtherRobotArgs;
use super::results::Results;
use super::shared::RobotName;
use super::{Console, Outcome, model};
use anyhow::Context;
use driftpost::application::Tabulation;
use nalgebra::UnitQuaternion;
use rapid_compensation::compensate::targets;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::kinematics::Configuration;
use robot_model::units::rad_from_deg;
use serde_json::Value;
use std::path::PathBuf;

/// Command line of `driftpost tabulate`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Targets (CSV): name,x_mm,y_mm,z_mm[,rx_deg,ry_deg,rz_deg], or RoboDK's No. point,X[mm],Y[mm],Z[mm][,Ox[deg],Oy[deg],Oz[deg]].
    #[arg(value_name = "TARGETS.csv")]
    pub targets: PathBuf,

    /// The robot that is tabulated.
    #[command(flatten)]
    pub robot: RobotName,

    /// Roll, pitch, yaw of the flange about fixed axes, where the targets have positions only.
    #[arg(long, value_name = "RX,RY,RZ", value_parser = three, allow_hyphen_values = true)]
    pub orient_deg: Option<[f64; 3]>,

    /// The branch for all targets: cfx, and the whole turns nearest to the quadrants [default: nearest to the previous
    /// target's joints, the first nearest to zero].
    #[arg(long, value_name = "CF1,CF4,CF6,CFX", value_parser = confdata, allow_hyphen_values = true)]
    pub confdata: Option<Configuration>,

    /// Deformation table (CSV), static or scheduled [default: the reference paper's Table 2, built in].
    #[arg(long, value_name = "FILE")]
    pub deformation: Option<PathBuf>,

    /// How a static table grows with the warm-up minute: none, exp:TAU or two-stage:TAU
    /// [default: two-stage:46 for the built-in table; required with a static table of yours].
    #[arg(long, value_name = "LAW", allow_hyphen_values = true)]
    pub growth: Option<String>,

    /// Whose deformation it may be.
    #[command(flatten)]
    pub accepted: OtherRobotArgs,

    /// Warm-up minutes: FROM:TO:STEP, or a list such as 0,5,37.5.
    #[arg(long, value_name = "MINUTES", default_value = "0:180:1", allow_hyphen_values = true)]
    pub minutes: Minutes,

    /// The joints, as CSV; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub joints_csv: Option<PathBuf>,

    /// How far the targets are missed before and after, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// Runs `tabulate`.
///
/// # Errors
/// A file that cannot be read or written, or a target that the arm cannot stand on; nothing is written then.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let file = args.targets.display().to_string();
    let robot = args.robot.load()?;
    args.accepted.check(&robot, args.deformation.is_none(), None, console)?;
    let deformation = model::deformation(args.deformation.as_deref(), args.growth.as_deref())?;
    let mut job = Tabulation::new(robot, deformation);
    job.configuration = args.confdata;
    job.minutes.clone_from(&args.minutes.0);
    let orientation = args.orient_deg.map(|rpy_deg| {
        let [roll, pitch, yaw] = rpy_deg.map(rad_from_deg);
        UnitQuaternion::from_euler_angles(roll, pitch, yaw)
    });
    let bytes = files::read(&args.targets, "file of targets")?;
    if orientation.is_some() && targets::have_orientation(&bytes) {
        let text = format!("{file} has orientations of its own: --orient-deg is passed over");
        let message = Diagnostic::warning("targets::own-orientation", text).help("leave it out");
        console.report([message]);
    }
    let in_file = |error: Diagnostic| model::in_file(&file, error);
    let targets = targets::read(&bytes, orientation.as_ref()).map_err(|error| in_file(error.into()))?;
    let joints_csv = Output::new(args.joints_csv.as_deref())?;
    let json = Output::new(args.json.as_deref())?;

    let found = job.run(targets).map_err(|error| in_file(error.into()))?;

    // Of many targets and minutes: put together where somebody asks for it.
    let data = if json.is_wanted() { found.json() } else { Value::Null };
    let results = Results::new(data, found.text()).beside(&joints_csv);
    joints_csv.write(console, || {
        let mut text = Vec::new();
        found.write_joints(&file, &mut text).context("the table of joints")?;
        Ok(text)
    })?;
    results.write(json, console)?;
    Ok(Outcome::Done)
}

fn three(text: &str) -> Result<[f64; 3], String> {
    let fields: Vec<f64> = numbers(text)?;
    if fields.iter().any(|v| !v.is_finite()) {
        return Err("angles are finite numbers".to_owned());
    }
    fields
        .try_into()
        .map_err(|fields: Vec<f64>| format!("three angles are needed, there are {}", fields.len()))
}

fn confdata(text: &str) -> Result<Configuration, String> {
    match numbers::<i32>(text)?[..] {
        [cf1, cf4, cf6, cfx] if (0..8).contains(&cfx) => Ok(Configuration { cf1, cf4, cf6, cfx }),
        [_, _, _, cfx] => Err(format!("cfx is 0 to 7, not {cfx}")),
        ref other => Err(format!("four whole numbers are needed, there are {}", other.len())),
    }
}

fn numbers<T: std::str::FromStr>(text: &str) -> Result<Vec<T>, String> {
    let number = |field: &str| {
        field.trim().parse().map_err(|_| format!("`{}` is not a number of this kind", field.trim()))
    };
    text.split(',').map(number).collect()
}
