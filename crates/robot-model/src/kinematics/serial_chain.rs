//! Forward kinematics of a serial arm of any number of joints that turn or slide, nominal or with offsets.
//!
//! The same chain as [`Chain`](super::Chain)'s, step for step: of six turning joints both give the same bits. There is no inverse
//! here: what is measured needs none.

use super::chain::turned_to_z;
use super::matrix::{self, Mat3, Vec3, add, cross, mul, scale, sub, transpose};
use super::real::Real;
use super::steps::{Step, Walk};
use crate::robot::{JointKind, Joints, MOST_JOINTS, SerialArm};
use nalgebra::Isometry3;

/// Six numbers for each joint's frame: `[dx, dy, dz]` in metres, `[rx, ry, rz]` in radians, before the joint's own motion. Row i is
/// joint i + 1; the flange's row follows the last joint's.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SerialOffsets(pub [[f64; 6]; MOST_JOINTS + 1]);

/// What the chains of one arm share whatever its frames' offsets are.
#[derive(Clone, Debug, PartialEq)]
pub struct SerialFrames {
    /// Frame i in frame i-1 as the robot file says; the flange follows the last joint.
    steps: [Step; MOST_JOINTS + 1],
    /// The turned frame of each joint, whose z is its axis, in its own.
    joint_from_turned: Joints<Mat3>,
    turned_from_joint: Joints<Mat3>,
    kinds: Joints<JointKind>,
}

/// A serial arm with constant frames.
#[derive(Clone, Debug, PartialEq)]
pub struct SerialChain {
    /// Frame i in frame i-1, both turned so that joints turn about z or slide along it.
    steps: [Step; MOST_JOINTS + 1],
    turned_from_joint: Joints<Mat3>,
    kinds: Joints<JointKind>,
}

impl SerialFrames {
    /// The constant frames between the joints of `arm`.
    #[must_use]
    pub fn of(arm: &SerialArm) -> Self {
        let joint_from_turned: Joints<Mat3> =
            arm.joints.iter().map(|joint| turned_to_z((*joint.axis).into())).collect();
        let frames = arm.joints.iter().map(|joint| &joint.previous_from_joint);
        let mut steps = [Step::default(); MOST_JOINTS + 1];
        for (step, nominal) in steps.iter_mut().zip(frames.chain([&arm.last_from_flange])) {
            *step = Step::of(nominal);
        }
        let turned_from_joint = joint_from_turned.map(|t| transpose(&t));
        Self { steps, joint_from_turned, turned_from_joint, kinds: arm.kinds() }
    }

    /// The arm with every frame moved by its offsets.
    #[must_use]
    pub fn chain(&self, offsets: &SerialOffsets) -> SerialChain {
        let mut steps = self.steps;
        for (i, step) in steps.iter_mut().enumerate().take(self.kinds.len() + 1) {
            let previous = i.checked_sub(1).map(|i| &self.turned_from_joint[i]);
            *step = step.moved(&offsets.0[i], previous, self.joint_from_turned.get(i));
        }
        SerialChain { steps, turned_from_joint: self.turned_from_joint, kinds: self.kinds }
    }
}

impl SerialChain {
    /// The arm as its robot file says.
    #[must_use]
    pub fn nominal(arm: &SerialArm) -> Self {
        SerialFrames::of(arm).chain(&SerialOffsets::default())
    }

    /// Number of joints, 4 to 7.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.kinds.len()
    }

    /// `base_from_flange`. Joints in radians, those that slide in metres; joints that are missing stand at zero.
    #[must_use]
    pub fn forward(&self, q_rad: &[f64]) -> Isometry3<f64> {
        let (rotation, position_m) = self.walk(q_rad, |_, _, _| ());
        matrix::isometry(&rotation, &position_m)
    }

    /// `base_from_joint` of each joint after its motion, joint 1 first, then `base_from_flange`.
    #[must_use]
    pub fn frames(&self, q_rad: &[f64]) -> Vec<Isometry3<f64>> {
        let mut frames = Vec::with_capacity(self.joints() + 1);
        self.walk(q_rad, |i, rotation, position_m| {
            let joint = self.turned_from_joint.get(i).map(|turned| mul(rotation, turned));
            frames.push(matrix::isometry(joint.as_ref().unwrap_or(rotation), position_m));
        });
        frames
    }

    /// `base_from_flange` and the geometric Jacobian at the flange's origin in base axes: a column vx vy vz wx wy wz for each
    /// joint, per radian or, where it slides, per metre.
    #[must_use]
    pub fn forward_and_jacobian(&self, q_rad: &[f64]) -> (Isometry3<f64>, Joints<[f64; 6]>) {
        let mut lines = Joints::all(self.joints(), ([0.0; 3], [0.0; 3]));
        let (rotation, position_m) = self.walk(q_rad, |i, rotation, position_m| {
            if let Some(line) = lines.get_mut(i) {
                *line = (matrix::column(rotation, 2), *position_m);
            }
        });
        let column = |(kind, (axis, origin_m)): (&JointKind, &(Vec3, Vec3))| match kind {
            JointKind::Revolute => {
                let [vx, vy, vz] = cross(axis, &sub(&position_m, origin_m));
                [vx, vy, vz, axis[0], axis[1], axis[2]]
            }
            JointKind::Prismatic => [axis[0], axis[1], axis[2], 0.0, 0.0, 0.0],
        };
        let jacobian = self.kinds.iter().zip(&lines).map(column).collect();
        (matrix::isometry(&rotation, &position_m), jacobian)
    }

    /// Calls `visit(i, rotation, position)` with each turned frame after its joint's motion, the flange last.
    fn walk(&self, q_rad: &[f64], mut visit: impl FnMut(usize, &Mat3, &Vec3)) -> (Mat3, Vec3) {
        let mut at = Walk::start(&self.steps[0]);
        for (i, step) in self.steps.iter().enumerate().take(self.joints() + 1) {
            if i > 0 {
                at.advance(step);
            }
            match (self.kinds.get(i), q_rad.get(i)) {
                (Some(JointKind::Revolute), Some(q_rad)) => at.turn(&Real::sin_cos(*q_rad)),
                (Some(JointKind::Prismatic), Some(along_m)) => {
                    at.0.position_m =
                        add(&at.0.position_m, &scale(&matrix::column(&at.0.rotation, 2), *along_m));
                }
                _ => {}
            }
            visit(i, &at.0.rotation, &at.0.position_m);
        }
        (at.0.rotation, at.0.position_m)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinematics::{Chain, FrameOffsets};
    use crate::robot::Robot;
    use crate::robot::dh::tests::craig;
    use nalgebra::{Matrix4, Rotation3, Vector3};

    fn arm(text: &str) -> SerialArm {
        SerialArm::from_toml(text).unwrap()
    }

    #[test]
    fn six_turning_joints_give_the_same_bits_as_the_chain_of_a_six_axis_arm() {
        let q_rad = [0.4, -0.3, 0.7, -1.2, 0.9, 2.1];
        let rows: [[f64; 6]; 8] =
            std::array::from_fn(|i| std::array::from_fn(|j| 1e-2 * ((i * 6 + j) as f64).sin()));
        for name in Robot::built_in_names() {
            let robot = Robot::built_in(name).unwrap();
            let six = Chain::with_offsets(&robot, &FrameOffsets(rows[..7].try_into().unwrap()));
            let any = SerialFrames::of(&SerialArm::from(&robot)).chain(&SerialOffsets(rows));
            assert_eq!(any.forward(&q_rad), six.forward(&q_rad));
            assert_eq!(any.frames(&q_rad)[..], six.frames(&q_rad));
        }
    }

    #[test]
    fn a_scara_stands_where_its_two_links_and_its_spindle_put_it() {
        let chain = SerialChain::nominal(&arm(include_str!("../../../../fixtures/robots/scara.toml")));
        let [q1, q2, z_m, q4]: [f64; 4] = [0.5, -1.1, -0.08, 0.7];
        let there = chain.forward(&[q1, q2, z_m, q4]);
        // Two links of 325 and 275 mm in the plane, the spindle goes down from 340 mm, the flange is 20 mm below it.
        let x = 0.325 * q1.cos() + 0.275 * (q1 + q2).cos();
        let y = 0.325 * q1.sin() + 0.275 * (q1 + q2).sin();
        let expected = Vector3::new(x, y, 0.34 + z_m - 0.02);
        assert!((there.translation.vector - expected).norm() < 1e-15, "{}", there.translation.vector);
        let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), q1 + q2 + q4);
        assert!((there.rotation.to_rotation_matrix().matrix() - turn.matrix()).norm() < 1e-15);
    }

    #[test]
    fn seven_joints_stand_where_published_denavit_hartenberg_parameters_say() {
        use std::f64::consts::FRAC_PI_2;
        // Franka Emika, Panda: Denavit-Hartenberg parameters (Craig's convention), a and d in metres, alpha in radians.
        let published: [[f64; 3]; 8] = [
            [0.0, 0.0, 0.333],
            [0.0, -FRAC_PI_2, 0.0],
            [0.0, FRAC_PI_2, 0.316],
            [0.0825, FRAC_PI_2, 0.0],
            [-0.0825, -FRAC_PI_2, 0.384],
            [0.0, FRAC_PI_2, 0.0],
            [0.088, FRAC_PI_2, 0.0],
            [0.0, 0.0, 0.107],
        ];
        let chain = SerialChain::nominal(&arm(include_str!("../../../../fixtures/robots/seven_axes.toml")));
        for k in 0..5 {
            let q_rad: Joints = Joints::from_fn(7, |j| 1.3 * ((5 * k + 3 * j + 1) as f64).sin());
            let expected = published.iter().enumerate().fold(Matrix4::identity(), |m, (i, [a, alpha, d])| {
                m * craig([*a, *alpha, *d, q_rad.get(i).copied().unwrap_or(0.0)])
            });
            let there = chain.forward(&q_rad).to_matrix();
            assert!((there - expected).norm() < 1e-14, "{there} {expected}");
        }
    }

    #[test]
    fn jacobian_is_the_derivative_of_forward() {
        for (text, q_rad) in [
            (include_str!("../../../../fixtures/robots/scara.toml"), &[0.5, -1.1, -0.08, 0.7][..]),
            (
                include_str!("../../../../fixtures/robots/seven_axes.toml"),
                &[0.4, 0.3, 0.7, -1.2, 0.9, 2.1, 0.2],
            ),
        ] {
            let chain = SerialChain::nominal(&arm(text));
            let (_, jacobian) = chain.forward_and_jacobian(q_rad);
            for j in 0..q_rad.len() {
                let at = |h: f64| {
                    let mut q_rad = q_rad.to_vec();
                    q_rad[j] += h;
                    chain.forward(&q_rad)
                };
                let (minus, plus) = (at(-1e-6), at(1e-6));
                let v = (plus.translation.vector - minus.translation.vector) / 2e-6;
                let w = (plus.rotation * minus.rotation.inverse()).scaled_axis() / 2e-6;
                for k in 0..3 {
                    assert!((jacobian[j][k] - v[k]).abs() < 1e-8, "v{k} of joint {}", j + 1);
                    assert!((jacobian[j][k + 3] - w[k]).abs() < 1e-8, "w{k} of joint {}", j + 1);
                }
            }
        }
    }

    #[test]
    fn a_palletiser_stands_where_its_upright_plane_puts_it() {
        // Four joints: a turning column, shoulder and elbow in an upright plane, and a turning flange.
        let chain = SerialChain::nominal(&arm(include_str!("../../../../fixtures/robots/palletiser.toml")));
        let [q1, q2, q3]: [f64; 3] = [0.6, 0.3, 0.5];
        let there = chain.forward(&[q1, q2, q3, -0.4]).translation.vector;
        // Both angles are counted from upright and level, forward and down; the flange hangs on the forearm's end.
        let forearm = q2 + q3;
        let out = 0.4 + 1.25 * q2.sin() + 1.5 * forearm.cos() + 0.25 * -forearm.sin();
        let up = 0.8 + 1.25 * q2.cos() - 1.5 * forearm.sin() - 0.25 * forearm.cos();
        let expected = Vector3::new(out * q1.cos(), out * q1.sin(), up);
        assert!((there - expected).norm() < 1e-15, "{there} {expected}");
    }
}
