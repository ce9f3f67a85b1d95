//! Corrections that take axis 1, 4 or 6 over the border of the quadrant that confdata names.
//!
//! The source's confdata stay as they are, and the corrected joint stands a hundredth of a degree beyond: a controller that is
//! told to check configurations may stop there.

use super::branch::configuration;
use super::messages::span_of;
use rapid_program::motion::{Motion, TargetValue};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::kinematics::outside_quadrant_rad;
use robot_model::robot::Axis;
use robot_model::units::deg_from_rad;

/// A joint that a correction takes over its quadrant's border.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crossing {
    /// Axis 1, 4 or 6.
    axis: Axis,
    /// The quadrant that confdata names.
    quadrant: i32,
    /// The joint as corrected, radians.
    q_rad: f64,
}

impl Crossing {
    /// The one of a target that the controller checks, where there is one.
    pub(super) fn of(
        motion: &Motion,
        value: &TargetValue,
        nominal_rad: &[f64; 6],
        corrected_rad: &[[f64; 6]],
    ) -> Option<Self> {
        let TargetValue::Rob(target) = value else { return None };
        if motion.setup.conf_monitored == Some(false) {
            return None;
        }
        configuration(target.conf).quadrants().into_iter().find_map(|(axis, quadrant)| {
            let is_outside = |q_rad: f64| outside_quadrant_rad(q_rad, quadrant) > 0.0;
            let inside = !is_outside(nominal_rad[axis.index()]);
            let out =
                corrected_rad.iter().map(|q_rad| q_rad[axis.index()]).filter(|&q_rad| is_outside(q_rad));
            let change_rad = |q_rad: &f64| (q_rad - nominal_rad[axis.index()]).abs();
            let farthest = out.max_by(|a, b| change_rad(a).total_cmp(&change_rad(b)));
            farthest.filter(|_| inside).map(|q_rad| Self { axis, quadrant, q_rad })
        })
    }

    /// The warning of its motion.
    pub(super) fn message(&self, motion: &Motion) -> Diagnostic {
        let Self { axis, quadrant, q_rad } = self;
        let text = format!(
            "line {}: the correction takes axis {axis} to {:.4} deg, over the border of the quadrant that cf{axis} = {quadrant} names; \
             {} is checked there",
            motion.line,
            deg_from_rad(*q_rad),
            motion.setup.kind
        );
        Diagnostic::warning("conf::border", text).at(span_of(motion)).help(
            "the target's numbers stay; a controller that takes quadrants to the letter stops at such a target: try it in manual \
             mode, or program ConfL\\Off or ConfJ\\Off there",
        )
    }
}
