//! Targets that are known at run time alone: which motions can ask the deformed model.

use super::branch::configuration;
use super::conditions;
use super::live_basis::LiveBasis;
use super::model::Model;
use super::options::Options;
use super::placement::skip;
use super::plan::{Form, PlannedMotion};
use super::warm_joints::JOINT_CHANGE_DEG;
use crate::schedule::TimeFunctions;
use rapid_program::Program;
use rapid_program::motion::{Motion, Path, SkipReason, Target, TargetValue};
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
        && stationary_tool(motion).is_none()
        && own_load
        && of_controller(program, motion).is_none()
        && live.lacks().is_none();
    if fits { Form::Live } else { Form::Ramp }
}

/// Why the model cannot be asked where nobody checks confdata: the controller then goes to the solution that is nearest, whatever they say.
fn open_configuration(motion: &Motion) -> Option<SkipReason> {
    (motion.setup.path != Path::AbsJoint && motion.setup.conf_monitored != Some(true)).then(|| {
        let own = motion.skip_reason.as_deref().map(|why| format!("{}; ", why.reason));
        let reason = format!(
            "{}where ConfL or ConfJ is off the configuration may not be the one that is reached, so that run time cannot be \
             asked",
            own.unwrap_or_default()
        );
        skip("keep::live-configuration", reason)
    })
}

/// Why the model cannot be asked where the robot holds the work object: the arm that is asked carries the tool.
fn stationary_tool(motion: &Motion) -> Option<SkipReason> {
    let tool_stands = motion.setup.tool.as_ref().is_some_and(|tool| !tool.robhold);
    let object_is_held = motion.setup.wobj.as_ref().is_some_and(|wobj| wobj.robhold);
    (tool_stands || object_is_held).then(|| {
        skip(
            "keep::live-stationary-tool",
            "its target is known at run time alone, and the tool is stationary: what is asked at run time holds for a \
             tool that the robot carries",
        )
    })
}

/// What the controller that the program is for lacks.
fn of_controller(program: &Program, motion: &Motion) -> Option<SkipReason> {
    let path = &program.file(motion.file).path;
    let s4c = path.rsplit('.').next().is_some_and(|extension| extension.eq_ignore_ascii_case("prg"));
    s4c.then(|| skip("keep::live-controller", "an S4C controller has no CalcJointT to ask at run time"))
}
