//! A target that has moved round the last axis, and a zero of that axis that has: the points are the same.

use super::compare::MeasurementComparison;
use nalgebra::{Isometry3, Point3, Vector3};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Axis, Joints, SerialArm};
use robot_model::units::deg_from_rad;

/// A shift of the tool beyond this many standard deviations is one.
const SURE: f64 = 4.0;
/// Where the axis lies on the flange is known to this share of how far it moves a target.
const AXIS_SHARE: f64 = 0.05;
/// The turn by which the axis is found, radians.
const STEP_RAD: f64 = 0.5;

/// That the zero of the last axis explains how the targets have moved on the flange.
#[must_use]
pub fn last_zero(comparison: &MeasurementComparison, robot: &SerialArm) -> Option<Diagnostic> {
    let tools_m = &comparison.tools_m;
    let moved = &comparison.tools_moved_m;
    let is_moved = moved.iter().any(|(by, sigma)| by.norm() > SURE * sigma);
    let last = robot.joints.len().checked_sub(1)?;
    if !is_moved || moved.len() != tools_m.len() || robot.joints[last].kind.slides() {
        return None;
    }
    let chain = SerialChain::nominal(robot);
    let turned_by = |by_rad: f64| -> Isometry3<f64> {
        let at = |q_rad: f64| {
            chain.forward(&Joints::from_fn(robot.joints.len(), |j| if j == last { q_rad } else { 0.0 }))
        };
        at(0.0).inverse() * at(by_rad)
    };
    let by_turn =
        |tool_m: &Vector3<f64>, by_rad: f64| (turned_by(by_rad) * Point3::from(*tool_m)).coords - tool_m;
    // What a small turn moves each target by, per radian.
    let per_rad = |tool_m: &Vector3<f64>| {
        (by_turn(tool_m, STEP_RAD / 500.0) - by_turn(tool_m, -STEP_RAD / 500.0)) / (STEP_RAD / 250.0)
    };
    let levers: Vec<Vector3<f64>> = tools_m.iter().map(per_rad).collect();
    let square: f64 = levers.iter().map(Vector3::norm_squared).sum();
    let along: f64 = levers.iter().zip(moved).map(|(lever, (by, _))| lever.dot(by)).sum();
    let turn_rad = (square > 0.0).then(|| along / square)?;
    let explains = tools_m.iter().zip(moved).all(|(tool_m, (by, sigma))| {
        (by - by_turn(tool_m, turn_rad)).norm() < SURE * sigma + AXIS_SHARE * by.norm()
    });
    explains.then(|| {
        let axis = Axis::at(last);
        Diagnostic::warning(
            "changed::last-zero",
            format!(
                "the target has moved round axis {axis}, or the zero of axis {axis} has by {:+.4} deg: the points are the same either way",
                deg_from_rad(turn_rad)
            ),
        )
        .help("look at the axis's synchronization mark; a target that nobody touched has not moved")
    })
}
