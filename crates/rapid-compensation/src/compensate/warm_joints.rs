//! The joints with which the warm arm stands where a point is meant to be.

use super::model::Model;
use super::placement::skip;
use super::resolved::Point;
use nalgebra::Isometry3;
use rapid_program::motion::SkipReason;
use robot_model::deform::{Conditions, DeformedArm, DeformedArms};
use robot_model::kinematics::{SolveError, Solved, solve};
use robot_model::robot::Axis;
use robot_model::units::{deg_from_rad, rad_from_deg};

/// A joint that would change by more is near a singularity, degrees.
pub(super) const JOINT_CHANGE_DEG: f64 = 1.0;
/// Nearer than this to where two branches meet joints change much faster than the tool: degrees of wrist and elbow, metres of
/// the wrist centre from axis 1.
const NEAR_DEG: f64 = 10.0;
const NEAR_M: f64 = 0.05;

/// The joints with which `arm` stands where the point is meant to be, or why the point is kept.
pub(super) fn warm_joints(
    point: &Point,
    arm: &DeformedArm,
    model: &Model<'_>,
) -> Result<[f64; 6], SkipReason> {
    let solved = solve(&arm.under(&point.conditions), &point.base_from_flange, &point.q_rad);
    allowed(point, solved, model)
}

/// The same for each of several moments.
pub(super) fn warm_joints_each(
    point: &Point,
    arms: &DeformedArms,
    model: &Model<'_>,
) -> impl Iterator<Item = Result<[f64; 6], SkipReason>> {
    let solved = arms.solve(&point.conditions, &point.base_from_flange, &point.q_rad);
    solved.into_iter().map(|solved| allowed(point, solved, model))
}

/// The same for each of many points.
pub(super) fn warm_joints_of(
    points: &[&Point<'_>],
    arm: &DeformedArm,
    model: &Model<'_>,
) -> Vec<Result<[f64; 6], SkipReason>> {
    let poses: Vec<_> = points.iter().map(|point| (point.base_from_flange, point.q_rad)).collect();
    let conditions: Vec<Conditions> = points.iter().map(|point| point.conditions).collect();
    let mut each = points.iter();
    let mut found = Vec::with_capacity(points.len());
    arm.solve_each_from(&poses, &conditions, |solved| {
        found.extend(each.next().map(|point| allowed(point, solved, model)));
    });
    found
}

/// Where the nominal controller is sent so that the warm arm stands where a point is meant to be, or why the point is kept.
pub(super) type CommandedOrSkipped = Result<CommandedJoints, SkipReason>;

/// Joints, and what the nominal controller takes them for.
#[derive(Clone, Copy, Debug)]
pub(super) struct CommandedJoints {
    /// The joints that the controller is sent to, radians.
    pub(super) q_rad: [f64; 6],
    /// Where these joints put the nominal arm's flange.
    pub(super) base_from_flange: Isometry3<f64>,
}

/// The same for each of many points.
pub(super) fn commanded_joints_of_each(
    points: &[&Point<'_>],
    arm: &DeformedArm,
    model: &Model<'_>,
) -> Vec<CommandedOrSkipped> {
    let warm = warm_joints_of(points, arm, model);
    let known: Vec<[f64; 6]> = warm.iter().flatten().copied().collect();
    let mut frames = Vec::with_capacity(known.len());
    model.nominal.forward_each(&known, |base_from_flange| frames.push(base_from_flange));
    let mut frames = frames.into_iter();
    let mut sent = |q_rad| CommandedJoints { q_rad, base_from_flange: frames.next().unwrap_or_default() };
    warm.into_iter().map(|q_rad| q_rad.map(&mut sent)).collect()
}

/// Joints that were found for a point, where a correction may go there.
fn allowed(
    point: &Point,
    solved: Result<Solved, SolveError>,
    model: &Model<'_>,
) -> Result<[f64; 6], SkipReason> {
    let q_rad = solved
        .map_err(|error| skip("reach::deformed", format!("the warm arm does not get there: {error}")))?
        .q_rad;
    let (joint, change_rad) = q_rad
        .iter()
        .zip(&point.q_rad)
        .map(|(a, b)| (a - b).abs())
        .enumerate()
        .fold((0, 0.0), |most, next| if next.1 > most.1 { next } else { most });
    if change_rad > rad_from_deg(JOINT_CHANGE_DEG) {
        let (axis, change_deg) = (Axis::at(joint), deg_from_rad(change_rad));
        return Err(if is_near_singularity(model, &point.q_rad) {
            let text = format!("axis {axis} would change by {change_deg:.3} deg: too near a singularity");
            skip("singular::joint-change", text)
        } else {
            let text = format!(
                "axis {axis} would change by {change_deg:.3} deg, more than the {JOINT_CHANGE_DEG} deg that a correction may"
            );
            skip("keep::joint-change", text)
        });
    }
    Ok(q_rad)
}

/// Whether joints change much there for a small shift: close to one of the arm's three singularities.
fn is_near_singularity(model: &Model<'_>, q_rad: &[f64; 6]) -> bool {
    let posture = model.closed.posture(q_rad);
    posture.wrist_rad.abs() < rad_from_deg(NEAR_DEG)
        || posture.elbow_rad.abs() < rad_from_deg(NEAR_DEG)
        || posture.shoulder_m.abs() < NEAR_M
}
