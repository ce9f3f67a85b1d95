//! Targets that are known at run time alone: which motions can ask the deformed model.

use super::at_run_time::{of_controller, open_configuration, stationary_tool};
use super::branch::configuration;
use super::conditions;
use super::live_basis::LiveBasis;
use super::model::Model;
use super::options::Options;
use super::plan::{Form, PlannedMotion};
use super::warm_joints::JOINT_CHANGE_DEG;
use crate::schedule::TimeFunctions;
use rapid_program::Program;
use rapid_program::motion::{Motion, SkipReason, Target, TargetValue, WobjArgument};
use robot_model::units::rad_from_deg;

/// What a program must hold whose corrections are scaled by `functions`.
pub(super) fn basis(model: &Model<'_>, functions: &TimeFunctions, options: &Options) -> LiveBasis {
    LiveBasis {
        robot: model.robot().clone(),
        offsets: functions.nodes.iter().map(|&node| model.offsets(node)).collect(),
        identified: model.identified.clone(),
        payload_kg: model.payload_kg,
        max_correction_m: options.max_correction_m,
        max_correction_rad: options.max_correction_rad,
        max_joint_change_rad: rad_from_deg(JOINT_CHANGE_DEG),
    }
}

/// The plan of a motion whose values are known at run time alone; `None` where something else keeps it.
pub(super) fn run_time(
    program: &Program,
    motion: &Motion,
    live: &LiveBasis,
) -> Option<Result<PlannedMotion, SkipReason>> {
    if !motion.run_time {
        return None;
    }
    let why_not = of_controller(program, motion)
        .or_else(|| stationary_tool(motion))
        .or_else(|| live.lacks())
        .or_else(|| open_configuration(motion));
    Some(match why_not {
        Some(why) => Err(why),
        None => Ok(PlannedMotion::compensated(Form::Live)),
    })
}

/// Whether tool or work object come from a function: they are named in the question and in the motion, and it might answer otherwise, or count
/// on, when it is asked a second time.
fn asks_a_function(motion: &Motion) -> bool {
    let wobj = match &motion.setup.wobj_argument {
        Some(WobjArgument::Given(text) | WobjArgument::IfPresent(text)) => Some(text),
        None => None,
    };
    motion.setup.tool_argument.iter().chain(wobj).any(|text| text.contains(&b'('))
}

/// The form of a known motion where `live` is asked for: one whose written configuration is not the one that is reached takes
/// `ramp`, and so does one for which the controller or the model lacks something, or under another load than the tool's own.
pub(super) fn form_of_known(
    program: &Program,
    (motion, joints): (&Motion, &[[f64; 6]]),
    live: &LiveBasis,
    model: &Model,
) -> Form {
    let values = motion.targets.iter().flat_map(Target::values);
    let agrees = joints.iter().zip(values).all(|(q_rad, value)| match value {
        TargetValue::Rob(target) => model.closed.agrees(&configuration(target.conf), q_rad),
        TargetValue::Joint(_) | TargetValue::FromJoints(_) => true,
    });
    let own_load = !conditions::is_beyond_own_load(motion, model);
    let fits = agrees
        && !asks_a_function(motion)
        && stationary_tool(motion).is_none()
        && own_load
        && of_controller(program, motion).is_none()
        && live.lacks().is_none();
    if fits { Form::Live } else { Form::Ramp }
}
