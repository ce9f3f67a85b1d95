//! Options that several commands have.

use super::model;
use super::number::positive;
use crate::application::joints_rad;
use measurements::Touches;
use metrology::diagnose::DiagnosisOptions;
use nalgebra::Vector3;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::robot::{Axis, Robot, SerialArm};
use robot_model::units::{deg_from_rad, m_from_mm};

/// The robot, by name, file or backup.
#[derive(Debug, clap::Args)]
pub struct RobotName {
    /// A built-in robot's name, a robot file (TOML), a URDF description (FILE.urdf, or FILE.urdf:LINK with the link that is the flange),
    /// or a table of Denavit-Hartenberg parameters (dh:FILE.csv, mdh:FILE.csv by Craig's convention).
    #[arg(
        id = "robot",
        long = "robot",
        value_name = "NAME|FILE",
        default_value = "irb140",
        help_heading = "Robot and deformation"
    )]
    pub name: String,
}

impl RobotName {
    /// The six-axis robot that is named.
    ///
    /// # Errors
    /// What is wrong with the name or the file; `robot::six-axis` for an arm of other joints.
    pub fn load(&self) -> Result<Robot, Diagnostic> {
        model::robot(&self.name)
    }

    /// The arm that is named, of four to seven joints.
    ///
    /// # Errors
    /// What is wrong with the name or the file.
    pub fn load_arm(&self) -> Result<SerialArm, Diagnostic> {
        model::arm(&self.name)
    }
}

/// What programs are compared or executed with; what is left out is as the header of an emitted module says.
#[derive(Debug, clap::Args)]
pub struct ProgramSettings {
    /// A built-in robot's name, a robot file (TOML), FILE.urdf or FILE.urdf:LINK [default: as the emitted module says, else irb140].
    #[arg(id = "robot", long = "robot", value_name = "NAME|FILE", help_heading = "Robot and program")]
    pub robot: Option<String>,

    /// Value of a tool that no given module declares [default: as the emitted module says].
    #[arg(long, value_name = "NAME=DATA", value_parser = name_and_value, allow_hyphen_values = true, help_heading = "Robot and program")]
    pub tool: Vec<(String, String)>,

    /// Value of a work object that no given module declares [default: as the emitted module says].
    #[arg(long, value_name = "NAME=DATA", value_parser = name_and_value, allow_hyphen_values = true, help_heading = "Robot and program")]
    pub wobj: Vec<(String, String)>,

    /// Joints with which the arm stands when the entry is called, deg [default: as the emitted module says].
    #[arg(long, value_name = "Q1,..,Q6", value_parser = joint_angles, allow_hyphen_values = true, help_heading = "Robot and program")]
    pub start_joints: Option<JointAngles>,
}

/// Angles of the joints, radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointAngles(pub [f64; 6]);

impl JointAngles {
    /// Refuses joints at which a robot cannot stand.
    ///
    /// # Errors
    /// `option::range`, naming the first such joint.
    pub fn check(&self, robot: &Robot) -> Result<(), Diagnostic> {
        /// A start that was read from a display and stands on the end of a range is no mistake.
        const ROUNDED_RAD: f64 = 1e-3;
        for (axis, (q_rad, joint)) in self.0.iter().zip(&robot.joints).enumerate() {
            let Some([from, to]) = joint.range_rad else { continue };
            if *q_rad < from - ROUNDED_RAD || *q_rad > to + ROUNDED_RAD {
                let [q, from, to] = [*q_rad, from, to].map(deg_from_rad);
                let text = format!(
                    "--start-joints: joint {} at {q:.1} deg is outside its range {from:.1} to {to:.1} deg",
                    Axis::at(axis)
                );
                let help =
                    format!("give the joints in degrees, and the robot with --robot (it is {})", robot.name);
                return Err(Diagnostic::error("option::range", text).help(help));
            }
        }
        Ok(())
    }
}

/// Six angles in degrees.
///
/// # Errors
/// Anything else, as a sentence.
pub fn joint_angles(text: &str) -> Result<JointAngles, String> {
    joints_rad(text).map(JointAngles)
}

/// `NAME=VALUE`.
///
/// # Errors
/// No name, as a sentence.
pub fn name_and_value(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((name, value)) if !name.trim_end_matches(':').trim().is_empty() => {
            Ok((name.trim_end_matches(':').trim().to_owned(), value.trim().to_owned()))
        }
        _ => Err("write NAME=VALUE, the value as RAPID does".to_owned()),
    }
}

/// What is known of a measurement besides its file.
#[derive(Debug, clap::Args)]
pub struct PriorKnowledgeArgs {
    /// Place of the measured target in the flange's frame, mm, known to about 1 mm.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub tool: Option<String>,

    /// Noise of one coordinate, mm, as stated; repeats in the file count beside it.
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    pub sigma_mm: Option<f64>,
}

impl PriorKnowledgeArgs {
    /// The same, as the diagnosis takes it.
    ///
    /// # Errors
    /// A tool that is not three numbers, a noise that is not positive.
    pub fn options(&self) -> Result<DiagnosisOptions, Diagnostic> {
        let tool_m = self.tool.as_deref().map(tool).transpose()?;
        positive(&[("--sigma-mm", self.sigma_mm)])?;
        Ok(DiagnosisOptions { tool_m, sigma_m: self.sigma_mm.map(m_from_mm) })
    }
}

/// How far a tool's tip or a target may be from the flange, mm: nearer, metres were given; farther, micrometres.
const TOOL_MM: std::ops::Range<f64> = 1.0..1e4;

/// `X,Y,Z` in mm as a place in the flange's frame, metres.
///
/// # Errors
/// Anything that is not three numbers, and what is no place in mm.
pub fn tool(text: &str) -> Result<Vector3<f64>, Diagnostic> {
    let wrong = || {
        Diagnostic::error("diagnose::tool", format!("--tool {text}: three numbers are needed, x,y,z in mm"))
            .help("for example --tool -12,0,80; leave it out where the target's place is not known")
    };
    let numbers: Vec<f64> =
        text.split(',').map(|n| n.trim().parse().map_err(|_| wrong())).collect::<Result<_, _>>()?;
    let [x, y, z] = numbers[..] else { return Err(wrong()) };
    if !numbers.iter().all(|n| n.is_finite()) {
        return Err(wrong());
    }
    let far_mm = x.hypot(y).hypot(z);
    if far_mm > 0.0 && !TOOL_MM.contains(&far_mm) {
        return Err(Diagnostic::error(
            "diagnose::tool",
            format!("--tool {text}: that is {far_mm} mm from the flange; the numbers are millimetres"),
        ));
    }
    Ok(Vector3::new(x, y, z).map(m_from_mm))
}

/// That the tip is taken to be at the flange's centre, where nothing names it and touches do not tell it by themselves.
pub fn no_tool(tool: Option<&str>, touches: &Touches) -> Option<Diagnostic> {
    let are_touched = touches.touches.iter().all(|touch| touch.measured_m.is_none());
    (tool.is_none() && are_touched).then(|| {
        Diagnostic::warning(
            "fit::no-tool",
            "no --tool: the tip is taken to be at the flange's centre, and the drift of that is what the touches are read as",
        )
        .help("--tool X,Y,Z names its place in the flange's frame, mm, to about a millimetre; --tool 0,0,0 says that it is there")
    })
}
