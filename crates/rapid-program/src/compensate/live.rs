//! Targets that are known at run time alone: what the deformed model at run time is made of, and which motions can ask it.

use super::Options;
use super::correct::{JOINT_CHANGE_DEG, no_figures};
use super::model::Model;
use super::placement::keep;
use super::plan::{Form, PlannedMotion, Status};
use crate::program::Program;
use crate::program::motion::{Keep, Motion, Path, Target, TargetValue};
use crate::schedule::TimeFunctions;
use robot_model::deform::identified::Identified;
use robot_model::kinematics::{Configuration, FrameOffsets};
use robot_model::robot::Robot;
use robot_model::units::rad_from_deg;
use std::sync::Arc;

/// What a program needs to hold the deformed model.
#[derive(Clone, Debug)]
pub struct LiveBasis {
    /// The constructive model.
    pub robot: Robot,
    /// For each time function what its node moves the frames by.
    pub offsets: Vec<FrameOffsets>,
    /// An identified model, on top of the table.
    pub identified: Option<Arc<Identified>>,
    /// A correction that moves the TCP by more is not made, metres.
    pub max_correction_m: f64,
    /// A correction that turns the TCP by more is not made, radians.
    pub max_correction_rad: f64,
    /// A joint of a joint target that would change by more is near a singularity, radians.
    pub max_joint_change_rad: f64,
}

impl LiveBasis {
    pub(super) fn new(model: &Model, functions: &TimeFunctions, options: &Options) -> Self {
        Self {
            robot: model.robot().clone(),
            offsets: functions.nodes.iter().map(|&node| model.offsets(node)).collect(),
            identified: model.identified.clone(),
            max_correction_m: options.max_correction_m,
            max_correction_rad: options.max_correction_rad,
            max_joint_change_rad: rad_from_deg(JOINT_CHANGE_DEG),
        }
    }

    /// Why RAPID cannot hold it.
    fn lacks(&self) -> Option<Keep> {
        let names = self.identified.as_ref().map(|model| model.beyond_run_time()).unwrap_or_default();
        (!names.is_empty()).then(|| {
            let names = names.join(", ");
            keep(
                "keep::live-model",
                format!("a program that asks at run time cannot hold of the model: {names}"),
            )
        })
    }
}

/// The plan of a motion whose values are known at run time alone; `None` where something else keeps it.
pub(super) fn run_time(
    program: &Program,
    motion: &Motion,
    live: &LiveBasis,
) -> Option<Result<PlannedMotion, Keep>> {
    if !motion.run_time {
        return None;
    }
    let why_not = of_controller(program, motion).or_else(|| live.lacks()).or_else(|| {
        // Then the controller goes to the solution that is nearest, whatever confdata says.
        (motion.setup.path != Path::AbsJoint && motion.setup.conf_monitored != Some(true)).then(|| {
            keep(
                "keep::live-configuration",
                "its target is known at run time alone, and where ConfL or ConfJ is off its configuration may not be the one \
                 that is reached",
            )
        })
    });
    Some(match why_not {
        Some(why) => Err(why),
        None => Ok(PlannedMotion { status: Status::Compensated, form: Form::Live, ..no_figures() }),
    })
}

/// The form of a known motion where `live` is asked for: one whose written configuration is not the one that is reached takes
/// `ramp`, and so does one for which the controller or the model lacks something.
pub(super) fn form_of_known(
    program: &Program,
    (motion, joints): (&Motion, &[[f64; 6]]),
    live: &LiveBasis,
    model: &Model,
) -> Form {
    let values = motion.targets.iter().flat_map(Target::values);
    let agrees = joints.iter().zip(values).all(|(q_rad, value)| match value {
        TargetValue::Rob(target) => {
            let conf = target.conf;
            let written = Configuration { cf1: conf.cf1, cf4: conf.cf4, cf6: conf.cf6, cfx: conf.cfx };
            model.closed.agrees(&written, q_rad)
        }
        TargetValue::Joint(_) | TargetValue::FromJoints(_) => true,
    });
    let held_by_robot = motion.setup.tool.as_ref().is_none_or(|tool| tool.robhold);
    let fits = agrees && held_by_robot && of_controller(program, motion).is_none() && live.lacks().is_none();
    if fits { Form::Live } else { Form::Ramp }
}

/// What the controller that the program is for lacks.
fn of_controller(program: &Program, motion: &Motion) -> Option<Keep> {
    let path = &program.file(motion.file).path;
    let s4c = path.rsplit('.').next().is_some_and(|extension| extension.eq_ignore_ascii_case("prg"));
    s4c.then(|| keep("keep::live-controller", "an S4C controller has no CalcJointT to ask at run time"))
}
