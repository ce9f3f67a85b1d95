//! What a program that asks the deformed model at run time must hold.

use super::placement::skip;
use rapid_program::motion::SkipReason;
use robot_model::deform::identified::Identified;
use robot_model::kinematics::FrameOffsets;
use robot_model::robot::Robot;
use std::sync::Arc;

/// What a program needs to hold the deformed model.
#[derive(Clone, Debug)]
pub struct LiveBasis {
    /// The constructive model of the arm.
    pub robot: Robot,
    /// For each time function what its node moves the frames by.
    pub offsets: Vec<FrameOffsets>,
    /// An identified model, on top of the table.
    pub identified: Option<Arc<Identified>>,
    /// What hangs on the flange in place of the tool's own load, kg, where it was given.
    pub payload_kg: Option<f64>,
    /// A correction that moves the TCP by more is not made, metres.
    pub max_correction_m: f64,
    /// A correction that turns the TCP by more is not made, radians.
    pub max_correction_rad: f64,
    /// A joint of a joint target that would change by more is near a singularity, radians.
    pub max_joint_change_rad: f64,
}

impl LiveBasis {
    /// Why RAPID cannot hold it.
    pub(super) fn lacks(&self) -> Option<SkipReason> {
        let names = self.identified.as_ref().map(|model| model.beyond_run_time()).unwrap_or_default();
        (!names.is_empty()).then(|| {
            let names = names.join(", ");
            skip(
                "keep::live-model",
                format!("a program that asks at run time cannot hold of the model: {names}"),
            )
        })
    }
}
