//! The chain: forward kinematics and the geometric Jacobian of a nominal or deformed arm.
//!
//! `T_i = Trans(p_i + d_i) Rx(rx) Ry(ry) Rz(rz) R_i Rot(axis_i, q_i)`, with `p_i`, `R_i` the joint's frame in the
//! robot file and `d_i`, `rx ry rz` its offsets. Every frame is turned once, on construction, so that its joint
//! turns about its own z: then a joint costs two products of columns instead of a general rotation.

use super::matrix::{self, Mat3, Vec3, cross, mul, sub, transpose};
use super::real::Real;
use super::right_angled::RightAngled;
use super::steps::{Frames, Pose, Step, Walk, sin_cos};
use crate::robot::Robot;
use nalgebra::Isometry3;

/// Six numbers for each joint frame: `[dx, dy, dz]` in metres, `[rx, ry, rz]` in radians, before the joint's own
/// rotation. Rows 0 to 5 are joints 1 to 6, row 6 the flange.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FrameOffsets(pub [[f64; 6]; 7]);

/// An arm whose pose and Jacobian can be had at any joints: what the numeric inverse needs.
///
/// [`Chain`] is one; a model whose frames move with the joints (gravity, gear harmonics) is another.
pub trait ArmKinematics {
    /// `base_from_flange` and the geometric Jacobian there.
    ///
    /// The Jacobian may leave out terms that are small against the arm's length (how an effect changes
    /// with the joints): the solver then takes a step more, its answer is no worse.
    fn pose_and_jacobian(&self, q_rad: &[f64; 6]) -> PoseAndJacobian;
}

/// A flange pose and the Jacobian there, as plain arrays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseAndJacobian {
    /// Rotation of the flange in the base, rows first.
    pub rotation: [[f64; 3]; 3],
    /// Origin of the flange in the base, metres.
    pub position_m: [f64; 3],
    /// Rows vx vy vz (m/rad) wx wy wz (rad/rad) at the flange origin in base axes; columns joints.
    pub jacobian: [[f64; 6]; 6],
}

impl PoseAndJacobian {
    pub(crate) fn pose(&self) -> Pose {
        Pose { rotation: self.rotation, position_m: self.position_m }
    }
}

/// The six joints' axes and frame origins in the base, and the flange.
pub(crate) struct Lines<T = f64> {
    pub axes: [Vec3<T>; 6],
    pub origins_m: [Vec3<T>; 6],
    pub flange: Pose<T>,
}

impl<T: Real> Lines<T> {
    /// Of frames and of the joints' sines and cosines.
    #[inline(always)]
    pub(super) fn of(frames: &impl Frames<T>, sin_cos: &[(T, T); 6]) -> Self {
        let [a, b, c, d, e, f] = sin_cos;
        let mut at = Walk::start(&frames.step(0));
        let (axis1, origin1_m) = at.joint(a, &frames.step(1));
        let (axis2, origin2_m) = at.joint(b, &frames.step(2));
        let (axis3, origin3_m) = at.joint(c, &frames.step(3));
        let (axis4, origin4_m) = at.joint(d, &frames.step(4));
        let (axis5, origin5_m) = at.joint(e, &frames.step(5));
        let (axis6, origin6_m) = at.joint(f, &frames.step(6));
        Self {
            axes: [axis1, axis2, axis3, axis4, axis5, axis6],
            origins_m: [origin1_m, origin2_m, origin3_m, origin4_m, origin5_m, origin6_m],
            flange: at.0,
        }
    }

    /// The geometric Jacobian at the flange: rows vx vy vz wx wy wz, columns joints.
    #[inline(always)]
    pub(crate) fn jacobian(&self) -> [[T; 6]; 6] {
        let v = [
            self.velocity(0),
            self.velocity(1),
            self.velocity(2),
            self.velocity(3),
            self.velocity(4),
            self.velocity(5),
        ];
        [
            across(&v, 0),
            across(&v, 1),
            across(&v, 2),
            across(&self.axes, 0),
            across(&self.axes, 1),
            across(&self.axes, 2),
        ]
    }

    /// Of the flange's origin as joint `j` turns.
    #[inline(always)]
    fn velocity(&self, j: usize) -> Vec3<T> {
        cross(&self.axes[j], &sub(&self.flange.position_m, &self.origins_m[j]))
    }
}

/// One component of six vectors.
#[inline(always)]
fn across<T: Real>(v: &[Vec3<T>; 6], k: usize) -> [T; 6] {
    [v[0][k], v[1][k], v[2][k], v[3][k], v[4][k], v[5][k]]
}

/// An arm of six joints with constant frames.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// Frame i in frame i-1, both turned so that joints turn about z; the last is the flange.
    pub(super) steps: [Step; 7],
    /// The joint's own frame in its turned one.
    pub(super) turned_from_joint: [Mat3; 6],
    /// The same arm where it is of this kind.
    pub(super) right_angled: Option<RightAngled>,
}

/// What the chains of one robot share whatever its frames' offsets are.
#[derive(Clone, Debug, PartialEq)]
pub struct NominalFrames {
    /// Frame i in frame i-1 as the robot file says; the last is the flange.
    steps: [Step; 7],
    /// The turned frame of each joint in its own.
    joint_from_turned: [Mat3; 6],
    turned_from_joint: [Mat3; 6],
}

impl NominalFrames {
    /// The constant frames between the joints of `robot`.
    #[must_use]
    pub fn of(robot: &Robot) -> Self {
        let joint_from_turned: [Mat3; 6] =
            std::array::from_fn(|i| turned_to_z((*robot.joints[i].axis).into()));
        let steps = std::array::from_fn(|i| {
            Step::of(
                robot.joints.get(i).map_or(&robot.joint6_from_flange, |joint| &joint.previous_from_joint),
            )
        });
        Self { steps, joint_from_turned, turned_from_joint: joint_from_turned.map(|t| transpose(&t)) }
    }

    /// The arm with every frame moved by its offsets.
    #[must_use]
    pub fn chain(&self, offsets: &FrameOffsets) -> Chain {
        let steps = std::array::from_fn(|i| {
            let previous = i.checked_sub(1).map(|i| &self.turned_from_joint[i]);
            self.steps[i].moved(&offsets.0[i], previous, self.joint_from_turned.get(i))
        });
        let right_angled = RightAngled::of(&steps);
        Chain { steps, turned_from_joint: self.turned_from_joint, right_angled }
    }
}

impl Chain {
    /// The arm as its robot file says.
    #[must_use]
    pub fn nominal(robot: &Robot) -> Self {
        Self::with_offsets(robot, &FrameOffsets::default())
    }

    /// The arm with every frame moved by its offsets; many of one robot come cheaper from [`NominalFrames`].
    #[must_use]
    pub fn with_offsets(robot: &Robot, offsets: &FrameOffsets) -> Self {
        NominalFrames::of(robot).chain(offsets)
    }

    /// `base_from_flange` and the geometric Jacobian at the flange origin in base axes: rows vx vy vz (m/rad) wx
    /// wy wz (rad/rad), columns joints.
    #[must_use]
    pub fn forward_and_jacobian(&self, q_rad: &[f64; 6]) -> (Isometry3<f64>, [[f64; 6]; 6]) {
        let there = self.pose_and_jacobian(q_rad);
        (matrix::isometry(&there.rotation, &there.position_m), there.jacobian)
    }

    /// `base_from_joint1` to `base_from_joint6`, each after its joint's rotation, and `base_from_flange`.
    #[must_use]
    pub fn frames(&self, q_rad: &[f64; 6]) -> [Isometry3<f64>; 7] {
        let mut frames = [Isometry3::identity(); 7];
        let mut at = Walk::start(&self.steps[0]);
        for (i, sin_cos) in sin_cos(q_rad).iter().enumerate() {
            at.turn(sin_cos);
            frames[i] = matrix::isometry(&mul(&at.0.rotation, &self.turned_from_joint[i]), &at.0.position_m);
            at.advance(&self.steps[i + 1]);
        }
        frames[6] = matrix::isometry(&at.0.rotation, &at.0.position_m);
        frames
    }

    /// Pose of the flange in the base, for one number a joint or lanes of several.
    #[inline(always)]
    pub(crate) fn pose<T: Real>(&self, q_rad: &[T; 6]) -> Pose<T> {
        Walk::to_flange(self, &sin_cos(q_rad))
    }

    /// The joints' axes and origins.
    #[inline(always)]
    pub(crate) fn lines<T: Real>(&self, q_rad: &[T; 6]) -> Lines<T> {
        Lines::of(self, &sin_cos(q_rad))
    }
}

impl<T: Real> Frames<T> for Chain {
    #[inline(always)]
    fn step(&self, i: usize) -> Step<T> {
        self.steps[i].splat()
    }
}

impl ArmKinematics for Chain {
    #[inline]
    fn pose_and_jacobian(&self, q_rad: &[f64; 6]) -> PoseAndJacobian {
        let lines = self.lines(q_rad);
        let Pose { rotation, position_m } = lines.flange;
        PoseAndJacobian { rotation, position_m, jacobian: lines.jacobian() }
    }
}

/// A rotation whose third column is `axis`: a permutation, so exact, where the axis is x, y or z.
pub(super) fn turned_to_z(axis: Vec3) -> Mat3 {
    let smallest = (0..3).fold(0, |best, k| if axis[k].abs() < axis[best].abs() { k } else { best });
    let mut helper = [0.0; 3];
    helper[smallest] = 1.0;
    let x = cross(&helper, &axis);
    let x = matrix::scale(&x, 1.0 / matrix::norm(&x));
    let y = cross(&axis, &x);
    [[x[0], y[0], axis[0]], [x[1], y[1], axis[1]], [x[2], y[2], axis[2]]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Rotation3, Translation3, UnitQuaternion, Vector3};

    const Q_RAD: [f64; 6] = [0.4, -0.3, 0.7, -1.2, 0.9, 2.1];

    fn offsets() -> FrameOffsets {
        FrameOffsets(std::array::from_fn(|i| std::array::from_fn(|j| 1e-2 * ((i * 6 + j) as f64).sin())))
    }

    /// The definition, written out with nalgebra.
    fn by_definition(robot: &Robot, offsets: &FrameOffsets, q_rad: &[f64; 6]) -> Isometry3<f64> {
        let mut base_from_here = Isometry3::identity();
        for (i, [dx, dy, dz, rx, ry, rz]) in offsets.0.into_iter().enumerate() {
            let frame = robot.joints.get(i).map_or(robot.joint6_from_flange, |j| j.previous_from_joint);
            let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), rx)
                * UnitQuaternion::from_axis_angle(&Vector3::y_axis(), ry)
                * UnitQuaternion::from_axis_angle(&Vector3::z_axis(), rz);
            base_from_here = base_from_here
                * Translation3::from(frame.translation.vector + Vector3::new(dx, dy, dz))
                * turn
                * frame.rotation;
            if let Some(joint) = robot.joints.get(i) {
                base_from_here *= UnitQuaternion::from_axis_angle(&joint.axis, q_rad[i]);
            }
        }
        base_from_here
    }

    fn distance(a: &Isometry3<f64>, b: &Isometry3<f64>) -> f64 {
        (a.translation.vector - b.translation.vector).norm() + a.rotation.angle_to(&b.rotation)
    }

    #[test]
    fn zero_pose_of_the_irb140_is_the_sum_of_its_lengths() {
        let chain = Chain::nominal(&Robot::built_in("irb140").unwrap());
        let at = chain.forward(&[0.0; 6]);
        assert!(
            (at.translation.vector - Vector3::new(0.070 + 0.380 + 0.065, 0.0, 0.352 + 0.360)).norm() < 1e-15
        );
        let down = Rotation3::from_axis_angle(&Vector3::y_axis(), std::f64::consts::FRAC_PI_2);
        assert!(at.rotation.angle_to(&UnitQuaternion::from(down)) < 1e-15);
    }

    #[test]
    fn forward_is_the_definition_for_every_built_in_robot_and_odd_axes() {
        let odd = include_str!("../robot/built_in/irb140.toml")
            .replacen("axis = [0, 1, 0]", "rpy_deg = [10, 20, -30]\naxis = [0.3, -1, 0.2]", 1)
            .replacen("axis = [1, 0, 0]", "axis = [-1, 0, 0]", 1);
        let mut robots: Vec<Robot> =
            Robot::built_in_names().iter().filter_map(|name| Robot::built_in(name)).collect();
        robots.push(Robot::from_toml(&odd).unwrap());
        for robot in &robots {
            let chain = Chain::with_offsets(robot, &offsets());
            let expected = by_definition(robot, &offsets(), &Q_RAD);
            assert!(distance(&chain.forward(&Q_RAD), &expected) < 1e-13, "{}", robot.name);
            assert!(distance(&chain.frames(&Q_RAD)[6], &expected) < 1e-13);
        }
    }

    #[test]
    fn frames_are_the_joints_own() {
        let robot = Robot::built_in("irb120").unwrap();
        let frames = Chain::nominal(&robot).frames(&[0.0; 6]);
        for (i, frame) in frames.iter().enumerate().take(6) {
            assert!(frame.rotation.angle() < 1e-15, "joint {}", i + 1);
        }
        assert!(
            (frames[3].translation.vector - Vector3::new(0.0, 0.0, 0.290 + 0.270 + 0.070)).norm() < 1e-15
        );
    }

    #[test]
    fn jacobian_is_the_derivative_of_forward() {
        let robot = Robot::built_in("irb2600").unwrap();
        let chain = Chain::with_offsets(&robot, &offsets());
        let (_, jacobian) = chain.forward_and_jacobian(&Q_RAD);
        let h_rad = 1e-6;
        for j in 0..6 {
            let (mut minus, mut plus) = (Q_RAD, Q_RAD);
            minus[j] -= h_rad;
            plus[j] += h_rad;
            let (minus, plus) = (chain.forward(&minus), chain.forward(&plus));
            let v = (plus.translation.vector - minus.translation.vector) / (2.0 * h_rad);
            let w = (plus.rotation * minus.rotation.inverse()).scaled_axis() / (2.0 * h_rad);
            for k in 0..3 {
                assert!((jacobian[k][j] - v[k]).abs() < 1e-8, "v{k} of joint {}", j + 1);
                assert!((jacobian[k + 3][j] - w[k]).abs() < 1e-8, "w{k} of joint {}", j + 1);
            }
        }
    }
}
