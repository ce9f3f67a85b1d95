//! What `tcTouch` is to touch, as it is asked for, and what that means in a program.

use rapid_compensation::compensate::{TouchReference, TouchingArm};
use rapid_compensation::emit::{Touch, TouchBy, TouchFrames};
use rapid_program::{Overrides, Program};
use rapid_syntax::diagnostic::Diagnostic;

/// A fixed point at which a program measures its thermal state.
#[derive(Clone, Debug, PartialEq)]
pub struct TouchRequest {
    /// What it is called.
    pub name: String,
    /// Names of the target, the tool and the work object.
    pub point: [String; 3],
    /// How the point is found.
    pub by: TouchBy,
    /// One standard deviation of a coordinate of what is found, metres.
    pub sigma_m: f64,
    /// Each touch is written to a file on the controller, as `driftpost state` reads it.
    pub log: bool,
}

impl TouchRequest {
    /// Why a touch tells nothing of an arm that drifts by more laws than one, or not at all.
    fn of_one_law(arm: &TouchingArm<'_>) -> Result<(), Diagnostic> {
        let (Some(model), Some(law)) = (arm.model, arm.deformation.growth()) else { return Ok(()) };
        if arm.deformation.one_law(Some(model)).is_some() {
            return Ok(());
        }
        let beside = model.for_programs().0.drifts_beside(*law);
        let text = if beside.is_empty() {
            "--touch: nothing of the model grows as the robot warms, so that a touch tells nothing".to_owned()
        } else {
            let beside = beside.join(", ");
            format!("--touch: a touch tells one share, and the drift follows more laws than {law}: {beside}")
        };
        let help =
            "give a model whose terms grow by one law (and --growth, if any, that law), or leave --touch out";
        Err(Diagnostic::error("touch::clock", text).help(help))
    }

    /// The point in a program of a robot that settles as its table and its model say.
    ///
    /// # Errors
    /// `touch::clock` where the drift follows no one law, `touch::point` and `touch::robhold` where the names or the arm's joints
    /// there are not known.
    pub fn of(
        &self,
        program: &Program,
        overrides: &Overrides,
        arm: &TouchingArm<'_>,
    ) -> Result<Touch, Diagnostic> {
        Self::of_one_law(arm)?;
        let point = program.fixed_point(overrides, self.point.each_ref().map(String::as_str))?;
        let (radius_m, routine) = match &self.by {
            TouchBy::Search { radius_m, .. } => (*radius_m, None),
            TouchBy::Routine(name) => (0.0, program.local_procedure(name)),
        };
        let TouchReference { q_rad, cold_m, settled_m } = TouchReference::of(&point, radius_m, arm)?;
        let conf = point.target.conf;
        Ok(Touch {
            name: self.name.clone(),
            point: self.point.clone(),
            by: self.by.clone(),
            sigma_m: self.sigma_m,
            log: self.log,
            local: point.local.into_iter().chain(routine).collect(),
            frames: TouchFrames {
                object_from_tcp: point.target.object_from_tcp,
                conf: [conf.cf1, conf.cf4, conf.cf6, conf.cfx],
                flange_from_tcp: point.tool.frame_from_tcp,
                base_from_object: point.wobj.frame_from_object(),
            },
            q_rad,
            cold_m,
            settled_m,
        })
    }
}
