//! What a motion and the controller must have so that the model can be asked at run time.

use super::model::Model;
use super::placement::skip;
use rapid_program::Program;
use rapid_program::motion::{Motion, Path, SkipReason};
use std::sync::Arc;

/// Reasons that hold at run time too: those of the options, and that nobody knows how the tool is turned on an arc.
pub(super) const NOT_ASKED: [&str; 4] =
    ["keep::as-asked", "keep::moveabsj", "keep::absolute-accuracy", "keep::circle-orientation"];

/// How many motions that are kept, each for a reason, would ask the model at run time in the form `auto`.
pub(super) fn count_that_could_ask<'p>(
    program: &Program,
    model: &Model<'_>,
    kept: impl Iterator<Item = (&'p Motion, &'p Arc<SkipReason>)>,
) -> usize {
    if model.identified.as_ref().is_some_and(|identified| !identified.beyond_run_time().is_empty()) {
        return 0;
    }
    let could_ask = |(motion, why): &(&Motion, &Arc<SkipReason>)| {
        motion.run_time
            && !NOT_ASKED.contains(&why.code)
            && of_controller(program, motion).is_none()
            && stationary_tool(motion).is_none()
            && open_configuration(motion).is_none()
    };
    kept.filter(could_ask).count()
}

/// Why the model cannot be asked where nobody checks confdata: the controller then goes to the solution that is nearest, whatever they say.
pub(super) fn open_configuration(motion: &Motion) -> Option<SkipReason> {
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
pub(super) fn stationary_tool(motion: &Motion) -> Option<SkipReason> {
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
pub(super) fn of_controller(program: &Program, motion: &Motion) -> Option<SkipReason> {
    let path = &program.file(motion.file).path;
    let s4c = path.rsplit('.').next().is_some_and(|extension| extension.eq_ignore_ascii_case("prg"));
    s4c.then(|| skip("keep::live-controller", "an S4C controller has no CalcJointT to ask at run time"))
}
