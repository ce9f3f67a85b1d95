//! Models and tables that belong to another robot than the one that is named.

use rapid_syntax::diagnostic::{Diagnostic, Severity};
use robot_model::deform::identified::Identified;
use robot_model::robot::{ArmGeometry, Robot, RobotDigest, same_type};

/// The robot that the built-in deformation table is of.
pub(super) const PAPER_ROBOT: &str = "irb140";

/// A warning where a model was found on another robot, or with another file of it.
#[must_use]
pub fn model_of_another_robot(model: &Identified, name: &str, arm: &ArmGeometry<'_>) -> Option<Diagnostic> {
    let same = model.robot.is_empty() || model.robot == name || same_type(&model.robot, name) == Some(true);
    if !same {
        let text = format!("the model is of {}, the robot is {name}", model.robot);
        let help = "name the robot it was found on with --robot";
        return Some(Diagnostic::warning("model::robot", text).help(help));
    }
    let (found, now) = (model.robot_digest?, RobotDigest::of(arm));
    let text = if found.geometry != now.geometry {
        format!(
            "the model was found with another robot file of {name}: other dimensions, or mounted otherwise (rpy_deg of joint 1)"
        )
    } else if found.masses != now.masses && model.needs_load() {
        format!(
            "the model was found with another robot file of {name}: other masses of its links, or none, and gravity is in the model"
        )
    } else {
        return None;
    };
    let help = "name the file it was found with by --robot: what it leaves with another nobody knows";
    Some(Diagnostic::warning("model::robot-file", text).help(help))
}

/// A warning where the table is the built-in one, and the robot not the one that it was measured on.
#[must_use]
pub fn default_table_of_another_robot(robot: &Robot) -> Option<Diagnostic> {
    let is_papers = Robot::built_in(PAPER_ROBOT).is_some_and(|papers| papers.same_arm(robot));
    let text = format!("the built-in deformation table is an IRB 140's, the robot is {}", robot.name);
    (!is_papers).then(|| {
        Diagnostic::warning("deform::other-robot", text).help("give a table of this robot with --deformation")
    })
}

/// The same as an error, with what takes it all the same.
#[must_use]
pub fn refusal(mut message: Diagnostic) -> Diagnostic {
    message.severity = Severity::Error;
    let help = message.help.take().unwrap_or_default();
    message.help = Some(format!("{help}; --allow-other-robot takes it all the same"));
    message
}
