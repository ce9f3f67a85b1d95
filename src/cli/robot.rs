//! `driftpost robot`: a robot as a robot file or a URDF description.

use super::sealed::{Language, Sealed, TomlKind};
use super::shared::RobotName;
use super::{Console, Outcome, files};
use crate::application::rpy_deg;
use crate::report::rounded;
use nalgebra::Isometry3;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::robot::JointKind;
use robot_model::units::{deg_from_rad, mm_from_m};
use std::path::PathBuf;

/// Command line of `driftpost robot`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The robot that is shown.
    #[command(flatten)]
    pub robot: RobotName,

    /// Write it as a robot file (FILE.toml) or a URDF description (FILE.urdf) [default: show origins, axes and ranges of the joints].
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Overwrite a robot file that was changed by hand since it was written.
    #[arg(long, requires = "output")]
    pub force: bool,

    /// Name, joints, origins, axes and ranges as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// Where a frame stands in the one before it, as a robot file has it: `70 0 352 mm`, and how it is turned, where it is.
fn in_words(frame: &Isometry3<f64>) -> String {
    let numbers = |of: &[f64]| of.iter().map(f64::to_string).collect::<Vec<_>>().join(" ");
    let origin_mm = numbers(frame.translation.vector.map(|m| rounded(mm_from_m(m))).as_slice());
    match rpy_deg(frame) {
        [0.0, 0.0, 0.0] => format!("{origin_mm} mm"),
        turned => format!("{origin_mm} mm  rpy {} deg", numbers(&turned)),
    }
}

/// Runs `robot`.
///
/// # Errors
/// What is wrong with the robot, or with where it goes.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let robot = args.robot.load_arm()?;
    let json = files::Output::new(args.json.as_deref())?;
    let takes_standard_output = json.is_standard();
    json.write_json(console, &driftpost::application::robot_json(&robot))?;
    let Some(path) = &args.output else {
        if takes_standard_output {
            return Ok(Outcome::Done);
        }
        writeln!(console.out(), "{}\n{}", robot.name, robot.source)?;
        for (i, joint) in robot.joints.iter().enumerate() {
            let [x, y, z] = <[f64; 3]>::from(joint.axis.into_inner());
            let range = joint.range_rad.map_or_else(
                || "without end".to_owned(),
                |[low, high]| match joint.kind {
                    JointKind::Revolute => {
                        format!("{:.1} to {:.1} deg", deg_from_rad(low), deg_from_rad(high))
                    }
                    JointKind::Prismatic => {
                        format!("slides, {:.1} to {:.1} mm", mm_from_m(low), mm_from_m(high))
                    }
                },
            );
            let origin = in_words(&joint.previous_from_joint);
            writeln!(console.out(), "joint {}  origin {origin}  axis {x} {y} {z}  {range}", i + 1)?;
        }
        writeln!(console.out(), "flange   origin {}", in_words(&robot.last_from_flange))?;
        return Ok(Outcome::Done);
    };
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    match ending.as_deref() {
        Some("toml") => {
            Sealed::new(path, Language::Toml(TomlKind::Robot), args.force)?.write(&robot.to_toml())?;
        }
        Some("urdf") => files::Pending::new(path)?.write(robot.to_urdf().as_bytes())?,
        _ => {
            let text = format!("{} ends neither in .toml nor in .urdf", path.display());
            return Err(Diagnostic::error("robot::format", text).into());
        }
    }
    console.note(format_args!("wrote {}", path.display()));
    Ok(Outcome::Done)
}
