//! What a motion and the controller must have so that the model can be asked at run time.

use super::placement::skip;
use rapid_program::Program;
use rapid_program::motion::{Motion, Path, SkipReason};

/// Whether a motion that is kept for `why` could ask the model at run time, were a form asked for that does.
pub(super) fn could_ask(program: &Program, motion: &Motion, why: &SkipReason) -> bool {
    // Where it was asked for, the model was found to lack something.
    let was_refused = why.code == "keep::live-model";
    motion.run_time
        && !was_refused
        && of_controller(program, motion).is_none()
        && stationary_tool(motion).is_none()
        && open_configuration(motion).is_none()
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
