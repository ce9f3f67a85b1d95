//! The chain of an arm with as few products as its right angles and zeros leave: by it the closed form's answers are proved.
//!
//! Each frame is `Trans(p) Rz(a) Rx(tilt) Rz(b)` in the one before, and what turns about z joins the joints on both sides. A nominal
//! arm's axes are parallel or perpendicular: then a tilt costs nothing, and most of `p` is zero.

use super::chain::Chain;
use super::matrix::Mat3;
use super::real::Real;
use super::steps::{Pose, Walk};

/// An arm of six joints with constant frames, as [`Chain`] to rounding.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SparseChain {
    /// SparseJoint 1 at rest in the base.
    base_from_first: Pose,
    joints: [SparseJoint; 6],
    /// By which the flange is turned behind the last tilt: sine and cosine.
    last: (f64, f64),
}

/// A joint with the way to the frame behind it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct SparseJoint {
    /// What stands about its axis already, radians.
    shift_rad: f64,
    /// The next frame's origin.
    position_m: [f64; 3],
    tilt: Tilt,
}

/// How the next axis is tilted about x.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Tilt {
    /// By nothing: both axes are parallel.
    #[default]
    None,
    /// By +90 deg: the new y is the old z.
    Right,
    /// By -90 deg: the new z is the old y.
    Left,
    /// By an angle of such a sine and cosine.
    By(f64, f64),
}

/// Rounding of a right angle.
const ROUNDING: f64 = 1e-15;

impl SparseChain {
    /// The arm of `chain`: rotations are split into turns about z, x and z, and those about z go to the joints before and behind.
    pub(super) fn of(chain: &Chain) -> Self {
        let [first, behind @ ..] = &chain.steps;
        let mut joints = [SparseJoint::default(); 6];
        let mut turned_rad = 0.0;
        for (joint, step) in joints.iter_mut().zip(behind) {
            let ZxZ { a_rad, tilt, b_rad } = ZxZ::of(&step.rotation);
            let (sin, cos) = a_rad.sin_cos();
            let [x, y, z] = step.position_m;
            let position_m = [cos * x + sin * y, cos * y - sin * x, z];
            *joint = SparseJoint { shift_rad: turned_rad + a_rad, position_m, tilt };
            turned_rad = b_rad;
        }
        let base_from_first = Pose { rotation: first.rotation, position_m: first.position_m };
        Self { base_from_first, joints, last: turned_rad.sin_cos() }
    }

    /// Pose of the flange in the base.
    #[inline(always)]
    pub(super) fn pose<T: Real>(&self, q_rad: &[T; 6]) -> Pose<T> {
        let mut at = Walk(self.base_from_first.splat::<T>());
        for (q_rad, joint) in q_rad.iter().zip(&self.joints) {
            at.turn(&(*q_rad + T::splat(joint.shift_rad)).sin_cos());
            for (k, along_m) in joint.position_m.iter().enumerate() {
                if along_m.abs() > 0.0 {
                    at.shift(k, *along_m);
                }
            }
            at.tilt(joint.tilt);
        }
        let (sin, cos) = self.last;
        at.turn(&(T::splat(sin), T::splat(cos)));
        at.0
    }
}

impl<T: Real> Walk<T> {
    /// Moves the frame along its own axis number `axis` (0 = x) by `by_m`.
    #[inline(always)]
    fn shift(&mut self, axis: usize, by_m: f64) {
        let Pose { rotation, position_m } = &mut self.0;
        for (position_m, row) in position_m.iter_mut().zip(rotation) {
            *position_m = *position_m + row[axis] * T::splat(by_m);
        }
    }

    /// Turns the frame about its own x axis.
    #[inline(always)]
    fn tilt(&mut self, tilt: Tilt) {
        for row in &mut self.0.rotation {
            let [_, y, z] = *row;
            (row[1], row[2]) = match tilt {
                Tilt::None => (y, z),
                Tilt::Right => (z, -y),
                Tilt::Left => (-z, y),
                Tilt::By(sin, cos) => {
                    let (sin, cos) = (T::splat(sin), T::splat(cos));
                    (y * cos + z * sin, z * cos - y * sin)
                }
            };
        }
    }
}

/// A rotation as `Rz(a) Rx(tilt) Rz(b)`.
struct ZxZ {
    a_rad: f64,
    tilt: Tilt,
    b_rad: f64,
}

impl ZxZ {
    fn of(rotation: &Mat3) -> Self {
        // The third column is (sin a sin tilt, -cos a sin tilt, cos tilt); of parallel axes a may be anything.
        let [[_, _, x], [_, _, y], [_, _, cos]] = *rotation;
        let a_rad = if x.hypot(y) > 0.0 { x.atan2(-y) } else { 0.0 };
        let (sin_a, cos_a) = a_rad.sin_cos();
        // What is left of the first row when a is taken off is (cos b, -sin b, 0).
        let first = |k: usize| cos_a * rotation[0][k] + sin_a * rotation[1][k];
        let b_rad = (-first(1)).atan2(first(0));
        let sin = sin_a * x - cos_a * y;
        let tilt = match (sin.abs() < ROUNDING, cos.abs() < ROUNDING) {
            (true, _) if cos > 0.0 => Tilt::None,
            (_, true) if sin > 0.0 => Tilt::Right,
            (_, true) => Tilt::Left,
            _ => Tilt::By(sin, cos),
        };
        Self { a_rad, tilt, b_rad }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinematics::{FrameOffsets, NominalFrames};
    use crate::robot::Robot;

    #[test]
    fn it_is_the_chain_nominal_and_deformed() {
        let mut right_angles = 0;
        for name in Robot::built_in_names() {
            let frames = NominalFrames::of(&Robot::built_in(name).unwrap());
            for size in [0.0, 1e-9, 1e-5, 1e-2] {
                let offsets = |i: usize| size * ((i * i) as f64 * 0.7 + 0.3).sin();
                let chain = frames.chain(&FrameOffsets(std::array::from_fn(|i| {
                    std::array::from_fn(|j| offsets(6 * i + j))
                })));
                let sparse = SparseChain::of(&chain);
                let is_right = |joint: &SparseJoint| !matches!(joint.tilt, Tilt::By(..));
                right_angles += usize::from(size == 0.0 && sparse.joints.iter().all(is_right));
                for n in 0..100 {
                    let q_rad: [f64; 6] =
                        std::array::from_fn(|j| 4.0 * (f64::from(n) * 1.3 + (j * j) as f64).sin());
                    let off = chain.pose(&q_rad).twist_from(&sparse.pose(&q_rad));
                    let off = off.iter().fold(0.0, |most: f64, off| most.max(off.abs()));
                    assert!(off < 1e-14, "{name} {size} {q_rad:?}: {off:e}");
                }
            }
        }
        assert_eq!(
            right_angles,
            Robot::built_in_names().len(),
            "all nominal axes are parallel or perpendicular"
        );
    }
}
