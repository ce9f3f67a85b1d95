//! What `tcTouch` is to touch, as it is asked for, and what that means in a program.

use rapid_program::compensate::TouchReference;
use rapid_program::emit::{Touch, TouchBy};
use rapid_program::program::{Overrides, Program};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::Deformation;
use robot_model::robot::Robot;

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
}

impl TouchRequest {
    /// Why none is taken beside an identified model.
    pub(super) fn beside_model() -> Diagnostic {
        let text = "--touch: with --model the arm is off by more than a drift that grows by one law, and what of that a touch finds would be \
                    taken for warmth";
        Diagnostic::error("touch::clock", text)
            .help("leave --touch or --model out; a table with --growth is what a touch can tell of")
    }

    /// The point in a program of a robot that settles as a table says.
    ///
    /// # Errors
    /// `touch::point` and `touch::robhold`, where the names or the arm's joints there are not known.
    pub fn of(
        &self,
        program: &Program,
        overrides: &Overrides,
        models: (&Robot, &Deformation),
    ) -> Result<Touch, Diagnostic> {
        let point = program.fixed_point(overrides, self.point.each_ref().map(String::as_str))?;
        let radius_m = match &self.by {
            TouchBy::Search { radius_m, .. } => *radius_m,
            TouchBy::Routine(_) => 0.0,
        };
        let TouchReference { q_rad, settled_m } = TouchReference::of(&point, radius_m, models)?;
        Ok(Touch {
            name: self.name.clone(),
            point: self.point.clone(),
            by: self.by.clone(),
            sigma_m: self.sigma_m,
            local: point.local,
            q_rad,
            settled_m,
        })
    }
}
