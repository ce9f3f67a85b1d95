//! The joints with which the warm arm stands where a point is meant to be.

use super::nominal::Point;
use super::placement::keep;
use crate::program::motion::SkipReason;
use robot_model::deform::DeformedArm;
use robot_model::kinematics::solve;
use robot_model::units::{deg_from_rad, rad_from_deg};

/// A joint that would change by more is near a singularity, degrees.
pub(super) const JOINT_CHANGE_DEG: f64 = 1.0;

/// The joints with which `arm` stands where the point is meant to be, or why the point is kept.
pub(super) fn warm_joints(point: &Point, arm: &DeformedArm) -> Result<[f64; 6], SkipReason> {
    let q_rad = solve(&arm.under(&point.conditions), &point.base_from_flange, &point.q_rad)
        .map_err(|error| keep("reach::deformed", format!("the warm arm does not get there: {error}")))?
        .q_rad;
    let (joint, change_rad) = q_rad
        .iter()
        .zip(&point.q_rad)
        .map(|(a, b)| (a - b).abs())
        .enumerate()
        .fold((0, 0.0), |most, next| if next.1 > most.1 { next } else { most });
    if change_rad > rad_from_deg(JOINT_CHANGE_DEG) {
        return Err(keep(
            "singular::joint-change",
            format!(
                "axis {} would change by {:.3} deg: too near a singularity",
                joint + 1,
                deg_from_rad(change_rad)
            ),
        ));
    }
    Ok(q_rad)
}
