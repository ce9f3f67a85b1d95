//! The arm's constants as the routine needs them: each joint turns about x, y or z of its frame.

use nalgebra::{Matrix3, Vector3};
use robot_model::robot::Robot;

/// An axis this near to x, y or z is it.
const SAME: f64 = 1e-12;

/// A frame in the one before it. The frames of joints about odd axes are turned so that the joint is about their z.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FixedFrame {
    /// Axes of the frame before, as the robot file has them, in those that are used here.
    pub used_from_filed: Matrix3<f64>,
    /// Its origin in the frame before, metres.
    pub place_m: Vector3<f64>,
    /// The fixed rotation: this frame's axes in the one before.
    pub rotation: Matrix3<f64>,
    /// 0, 1, 2 for x, y, z and the sign; none for the flange.
    pub axis: Option<(usize, f64)>,
    /// The joint's own frame, as the robot file has it, in the one used here.
    pub turned: Matrix3<f64>,
}

/// Joints 1 to 6 and the flange.
pub(super) fn steps(robot: &Robot) -> [FixedFrame; 7] {
    let turned: [(Matrix3<f64>, usize, f64); 6] =
        std::array::from_fn(|i| principal(&robot.joints[i].axis.into_inner()));
    std::array::from_fn(|i| {
        let frame = robot.joints.get(i).map_or(&robot.joint6_from_flange, |j| &j.previous_from_joint);
        let used_from_filed = if i == 0 { Matrix3::identity() } else { turned[i - 1].0.transpose() };
        let (own, axis) = match turned.get(i) {
            Some((own, axis, sign)) => (*own, Some((*axis, *sign))),
            None => (Matrix3::identity(), None),
        };
        let fixed = frame.rotation.to_rotation_matrix().into_inner();
        FixedFrame {
            used_from_filed,
            place_m: used_from_filed * frame.translation.vector,
            rotation: (used_from_filed * fixed * own).map(|x| if x.abs() < SAME { 0.0 } else { x }),
            axis,
            turned: own.transpose(),
        }
    })
}

/// Axes in which `axis` is one of the three, which one, and its sign.
fn principal(axis: &Vector3<f64>) -> (Matrix3<f64>, usize, f64) {
    if let Some(k) = (0..3).find(|&k| (axis[k].abs() - 1.0).abs() < SAME) {
        return (Matrix3::identity(), k, axis[k].signum());
    }
    let x = Vector3::ith(axis.iamin(), 1.0).cross(axis).normalize();
    (Matrix3::from_columns(&[x, axis.cross(&x), *axis]), 2, 1.0)
}

/// Rows first, as plain arrays.
pub(super) fn rows(rotation: &Matrix3<f64>) -> [[f64; 3]; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| rotation[(i, j)]))
}
