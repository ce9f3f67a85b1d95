//! What the warm arm does at a fixed point that is touched: its joints there and where it settles.

use super::branch::configuration;
use super::conditions::payload_of;
use super::placement::Placement;
use nalgebra::Vector3;
use rapid_program::FixedPoint;
use rapid_program::data::LoadData;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::identified::{Identified, ThermalState};
use robot_model::deform::{Conditions, Deformation, DeformedArm};
use robot_model::kinematics::{Chain, ClosedForm, solve};
use robot_model::robot::Robot;
use robot_model::units::mm_from_m;
use std::sync::Arc;

/// A point whose settled correction is smaller tells nothing of the warmth, metres.
const LEAST_M: f64 = 0.02e-3;

/// A fixed point as the cold and the settled arm have it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TouchReference {
    /// Nominal joints there, radians.
    pub q_rad: [f64; 6],
    /// By how much the cold arm must be told to go elsewhere to touch it, in the work object's axes, metres.
    pub cold_m: Vector3<f64>,
    /// By how much further the settled one must be, metres.
    pub settled_m: Vector3<f64>,
}

/// The arm that touches.
#[derive(Clone, Copy, Debug)]
pub struct TouchingArm<'a> {
    /// The cold arm, each joint where it is built.
    pub robot: &'a Robot,
    /// How its frames move as it warms.
    pub deformation: &'a Deformation,
    /// An identified model on top, whose drift follows the same law.
    pub model: Option<&'a Identified>,
    /// What is on the flange where it is not the tool's own load, kg.
    pub payload_kg: Option<f64>,
}

impl TouchingArm<'_> {
    /// The cold and the settled arm.
    fn cold_and_settled(&self) -> [DeformedArm; 2] {
        let offsets = [self.deformation.offsets_at(0.0), self.deformation.settled()];
        let Some(model) = self.model else {
            return offsets.map(|offsets| DeformedArm::of_table(self.robot, &offsets));
        };
        let (robot, model) = (Arc::new(self.robot.clone()), Arc::new(model.for_programs().0));
        let mut t_min = [0.0, f64::INFINITY].into_iter();
        offsets.map(|offsets| {
            let when =
                ThermalState { t_min: t_min.next().unwrap_or(f64::INFINITY), joint_temperature_c: None };
            DeformedArm::of_model(&robot, &offsets, &model, when)
        })
    }
}

impl TouchReference {
    /// Of a point on an arm that settles as its table and its model say; each coordinate where it is searched, `radius_m` beside the
    /// point along its axis: over a sphere the drift differs by some per cent.
    ///
    /// # Errors
    /// `touch::point` where the arm does not get there as it is configured or hardly moves there as it warms,
    /// `touch::robhold` where the robot does not hold the tool alone.
    pub fn of(point: &FixedPoint, radius_m: f64, arm: &TouchingArm<'_>) -> Result<Self, Diagnostic> {
        let error = |code, text: &str| Err(Diagnostic::error(code, format!("--touch: {text}")));
        let placement = Placement::of_data(&point.tool, &point.wobj);
        let Ok(placement @ Placement::ToolOnFlange { .. }) = placement else {
            return error("touch::robhold", "the robot must hold the tool, and the work object stand fixed");
        };
        let Ok(closed) = ClosedForm::new(arm.robot) else {
            return error("touch::point", "the arm's joints at the point cannot be found");
        };
        let there = placement.base_from_flange(&point.target.object_from_tcp);
        let conf = configuration(point.target.conf);
        let solutions = closed.solutions(&there);
        let Some(found) = solutions.iter().find(|s| closed.agrees(&conf, &s.q_rad)) else {
            return error("touch::point", "the arm does not reach the point as its confdata say");
        };
        let [cold, settled] = arm.cold_and_settled();
        let nominal = Chain::nominal(arm.robot);
        let payload = payload_of((Some(&point.tool), None), LoadData::default(), arm.payload_kg);
        let conditions = Conditions { payload, ..Conditions::default() };
        let shift_m = |arm: &DeformedArm, axis: usize| {
            let mut goal = point.target.object_from_tcp;
            goal.translation.vector[axis] += radius_m;
            let there = placement.base_from_flange(&goal);
            let there = solve(&arm.under(&conditions), &there, &found.q_rad).ok()?;
            let reached = placement.object_from_tcp(&nominal.forward(&there.q_rad));
            Some(reached.translation.vector[axis] - goal.translation.vector[axis])
        };
        let shift_m = |arm| Some(Vector3::new(shift_m(arm, 0)?, shift_m(arm, 1)?, shift_m(arm, 2)?));
        let (Some(cold_m), Some(settled_m)) = (shift_m(&cold), shift_m(&settled)) else {
            return error("touch::point", "the deformed arm does not get to the point");
        };
        let settled_m = settled_m - cold_m;
        if settled_m.norm() < LEAST_M {
            let (moves_mm, least_mm) = (mm_from_m(settled_m.norm()), mm_from_m(LEAST_M));
            let text = format!(
                "the point moves by {moves_mm:.4} mm as the arm warms, under {least_mm} mm: it tells nothing"
            );
            return error("touch::point", &text);
        }
        Ok(Self { q_rad: found.q_rad, cold_m, settled_m })
    }
}
