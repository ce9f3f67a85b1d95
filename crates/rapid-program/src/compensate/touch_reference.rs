//! What the warm arm does at a fixed point that is touched: its joints there and where it settles.

use super::placement::Placement;
use crate::program::FixedPoint;
use nalgebra::Vector3;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::{Conditions, Deformation, DeformedArm};
use robot_model::kinematics::{Chain, ClosedForm, Configuration, solve};
use robot_model::robot::Robot;
use robot_model::units::mm_from_m;

/// A point whose settled correction is smaller tells nothing of the warmth, metres.
const LEAST_M: f64 = 0.02e-3;

/// A fixed point as the cold and the settled arm have it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TouchReference {
    /// Nominal joints there, radians.
    pub q_rad: [f64; 6],
    /// By how much the settled arm must be told to go elsewhere to touch it, in the work object's axes, metres.
    pub settled_m: Vector3<f64>,
}

impl TouchReference {
    /// Of a point on an arm that settles as a table says; each coordinate where it is searched, `radius_m` beside the
    /// point along its axis: over a sphere the drift differs by some per cent.
    ///
    /// # Errors
    /// `touch::point` where the arm does not get there as it is configured or hardly moves there as it warms,
    /// `touch::robhold` where the robot does not hold the tool alone.
    pub fn of(
        point: &FixedPoint,
        radius_m: f64,
        (robot, deformation): (&Robot, &Deformation),
    ) -> Result<Self, Diagnostic> {
        let error = |code, text: &str| Err(Diagnostic::error(code, format!("--touch: {text}")));
        let placement = Placement::of_data(&point.tool, &point.wobj);
        let Ok(placement @ Placement::ToolOnFlange { .. }) = placement else {
            return error("touch::robhold", "the robot must hold the tool, and the work object stand fixed");
        };
        let Ok(closed) = ClosedForm::new(robot) else {
            return error("touch::point", "the arm's joints at the point cannot be found");
        };
        let there = placement.base_from_flange(&point.target.object_from_tcp);
        let conf = &point.target.conf;
        let conf = Configuration { cf1: conf.cf1, cf4: conf.cf4, cf6: conf.cf6, cfx: conf.cfx };
        let solutions = closed.solutions(&there);
        let Some(found) = solutions.iter().find(|s| closed.agrees(&conf, &s.q_rad)) else {
            return error("touch::point", "the arm does not reach the point as its confdata say");
        };
        let settled = DeformedArm::of_table(robot, &deformation.settled());
        let nominal = Chain::nominal(robot);
        let shift_m = |axis: usize| {
            let mut goal = point.target.object_from_tcp;
            goal.translation.vector[axis] += radius_m;
            let there = placement.base_from_flange(&goal);
            let warm = solve(&settled.under(&Conditions::default()), &there, &found.q_rad).ok()?;
            let told = placement.object_from_tcp(&nominal.forward(&warm.q_rad));
            Some(told.translation.vector[axis] - goal.translation.vector[axis])
        };
        let (Some(x), Some(y), Some(z)) = (shift_m(0), shift_m(1), shift_m(2)) else {
            return error("touch::point", "the warm arm does not get to the point");
        };
        let settled_m = Vector3::new(x, y, z);
        if settled_m.norm() < LEAST_M {
            let (moves_mm, least_mm) = (mm_from_m(settled_m.norm()), mm_from_m(LEAST_M));
            let text = format!(
                "the point moves by {moves_mm:.4} mm as the arm warms, under {least_mm} mm: it tells nothing"
            );
            return error("touch::point", &text);
        }
        Ok(Self { q_rad: found.q_rad, settled_m })
    }
}
