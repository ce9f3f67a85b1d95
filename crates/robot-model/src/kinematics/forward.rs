//! One pose of one arm on vectors: sines and cosines of all joints side by side, and the columns of the flange's frame each in a vector.
//!
//! The answer is that of [`Chain::pose`], to the bit: each number comes of the same operations in the same order, or of those of them that
//! change it (`right_angled.rs`; then zeros are positive).

use super::chain::Chain;
use super::dispatch::{Kernel, is_wide, on_quickest};
use super::frame_columns::FrameColumns;
use super::lanes::{Column, Lanes, Register, Three, Wide};
use super::matrix::{self, norm};
use super::real::Real;
use super::right_angled::{self, RightAngled};
use super::steps::{Pose, sin_cos};
use nalgebra::{Isometry3, Matrix3};

impl Chain {
    /// Pose of the flange in the base at joints of radians.
    #[must_use]
    pub fn forward(&self, q_rad: &[f64; 6]) -> Isometry3<f64> {
        if !is_wide() {
            return one_by_one(self, q_rad);
        }
        // Column by column, as it was stored: a load across two stores would wait for both.
        let [x, y, z, origin_m] = match &self.right_angled {
            Some(arm) => right_angled_one(arm, q_rad),
            None => forward_one(self, q_rad),
        };
        let m = Matrix3::new(x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]);
        matrix::isometry_of(m, [origin_m[0], origin_m[1], origin_m[2]])
    }

    /// How far the flange stands from `base_from_flange`: metres, and the angle in radians, exact where it is tiny.
    #[must_use]
    pub fn distance(&self, q_rad: &[f64; 6], base_from_flange: &Isometry3<f64>) -> (f64, f64) {
        let [vx, vy, vz, wx, wy, wz] = Pose::of(base_from_flange).twist_from(&self.flange(q_rad));
        (norm(&[vx, vy, vz]), norm(&[wx, wy, wz]))
    }

    /// [`Chain::pose`] of one pose, on vectors where the machine has them.
    #[inline]
    pub(super) fn flange(&self, q_rad: &[f64; 6]) -> Pose {
        if !is_wide() {
            return self.pose(q_rad);
        }
        let [x, y, z, origin_m] = forward_one(self, q_rad);
        Pose {
            rotation: [[x[0], y[0], z[0]], [x[1], y[1], z[1]], [x[2], y[2], z[2]]],
            position_m: [origin_m[0], origin_m[1], origin_m[2]],
        }
    }
}

impl RightAngled {
    /// Pose of the flange in the base, for one number a joint or lanes of several.
    #[inline(always)]
    pub(super) fn pose<T: Real>(&self, q_rad: &[T; 6]) -> Pose<T> {
        let [a, b, c, d, e, f] = sin_cos(q_rad);
        let sin_cos = [
            three(self.turned(0, a)),
            three(self.turned(1, b)),
            three(self.turned(2, c)),
            three(self.turned(3, d)),
            three(self.turned(4, e)),
            three(self.turned(5, f)),
        ];
        let zero = right_angled::zero(q_rad);
        let FrameColumns { axes: [Three(x), Three(y), Three(z)], origin_m } =
            self.flange(&sin_cos, Three([zero, zero, zero]));
        Pose { rotation: matrix::transpose(&[x, y, z]), position_m: origin_m.0 }
    }
}

#[inline(always)]
fn three<T: Real>((sin, cos): (T, T)) -> (Three<T>, Three<T>) {
    (Three([sin, sin, sin]), Three([cos, cos, cos]))
}

// Compiled once, here: as in `chains`.

#[inline(never)]
fn forward_one(chain: &Chain, q_rad: &[f64; 6]) -> [[f64; 4]; 4] {
    on_quickest(ForwardOne { chain, q_rad })
}

#[inline(never)]
fn right_angled_one(arm: &RightAngled, q_rad: &[f64; 6]) -> [[f64; 4]; 4] {
    on_quickest(RightAngledOne { arm, q_rad })
}

/// Where the machine has no vectors. Apart, so that its registers are not put by where it has.
#[inline(never)]
fn one_by_one(chain: &Chain, q_rad: &[f64; 6]) -> Isometry3<f64> {
    match &chain.right_angled {
        Some(arm) => arm.pose(q_rad).isometry(),
        None => chain.pose(q_rad).isometry(),
    }
}

struct ForwardOne<'a> {
    chain: &'a Chain,
    q_rad: &'a [f64; 6],
}

impl Kernel for ForwardOne<'_> {
    /// Axes and origin of the flange's frame in the base; the fourth number of each is nothing.
    type Output = [[f64; 4]; 4];

    #[inline(always)]
    fn run<V: Wide>(self) -> [[f64; 4]; 4] {
        let [a, b, c, d, e, f] = *self.q_rad;
        let (sin, cos) = V::load(&Lanes([a, b, c, d, e, f, 0.0, 0.0])).sin_cos();
        let (Lanes(sin), Lanes(cos)) = (sin.store(), cos.store());
        let [base_from_first, behind @ ..] = &self.chain.steps;
        let mut at = FrameColumns::<V::Column>::start(&base_from_first.rotation, &base_from_first.position_m);
        for (i, next) in behind.iter().enumerate() {
            at.turn(&(V::Column::splat(sin[i]), V::Column::splat(cos[i])));
            at.advance(&next.rotation, &next.position_m);
        }
        stored(at)
    }
}

struct RightAngledOne<'a> {
    arm: &'a RightAngled,
    q_rad: &'a [f64; 6],
}

impl Kernel for RightAngledOne<'_> {
    /// The same figures of the flange as [`ForwardOne`] gives.
    type Output = [[f64; 4]; 4];

    #[inline(always)]
    fn run<V: Wide>(self) -> [[f64; 4]; 4] {
        let [a, b, c, d, e, f] = *self.q_rad;
        let (sin, cos) = V::load(&Lanes([a, b, c, d, e, f, 0.0, 0.0])).sin_cos();
        let (sin, cos) = V::turned_by_quarters(V::load(&Lanes(self.arm.quarters())), sin, cos);
        let (Lanes(sin), Lanes(cos)) = (sin.store(), cos.store());
        let at = |i: usize| (V::Column::splat(sin[i]), V::Column::splat(cos[i]));
        let zero = V::Column::splat(right_angled::zero(self.q_rad));
        stored(self.arm.flange(&[at(0), at(1), at(2), at(3), at(4), at(5)], zero))
    }
}

#[inline(always)]
fn stored<C: Register>(at: FrameColumns<C>) -> [[f64; 4]; 4] {
    let [x, y, z] = at.axes;
    [x.store(), y.store(), z.store(), at.origin_m.store()]
}

#[cfg(test)]
mod tests {
    use super::super::dispatch::{self, Width};
    use super::*;
    use crate::kinematics::{FrameOffsets, NominalFrames};
    use crate::robot::Robot;

    fn bits(pose: &Pose) -> ([[u64; 3]; 3], [u64; 3]) {
        (pose.rotation.map(|row| row.map(f64::to_bits)), pose.position_m.map(f64::to_bits))
    }

    fn pose_of([x, y, z, p]: [[f64; 4]; 4]) -> Pose {
        Pose {
            rotation: std::array::from_fn(|k| [x[k], y[k], z[k]]),
            position_m: std::array::from_fn(|k| p[k]),
        }
    }

    /// Whole turns, nothing and multiples of a quarter among them.
    fn joints(n: u32) -> [f64; 6] {
        let mut q_rad: [f64; 6] = std::array::from_fn(|j| 9.0 * (f64::from(n) * 1.3 + (j * j) as f64).sin());
        let special = [0.0, -0.0, std::f64::consts::FRAC_PI_2, -1e-9, 100.0];
        q_rad[n as usize % 6] = special[n as usize % 5];
        if n % 9 == 1 {
            q_rad = std::array::from_fn(|j| special[(n as usize / 9 + j) % 4]);
        }
        q_rad
    }

    #[test]
    fn every_width_gives_the_bits_of_the_chain() {
        for name in Robot::built_in_names() {
            let frames = NominalFrames::of(&Robot::built_in(name).unwrap());
            for size in [0.0, 1e-4, 0.3] {
                let offset = |i: usize, j: usize| size * ((i * 6 + j) as f64 * 0.7 + 0.3).sin();
                let chain = frames
                    .chain(&FrameOffsets(std::array::from_fn(|i| std::array::from_fn(|j| offset(i, j)))));
                for q_rad in (0..100).map(joints) {
                    let expected = chain.pose(&q_rad);
                    for width in Width::all() {
                        let found = dispatch::on(width, ForwardOne { chain: &chain, q_rad: &q_rad });
                        assert_eq!(
                            bits(&pose_of(found)),
                            bits(&expected),
                            "{name} {size} {q_rad:?} {width:?}"
                        );
                    }
                    assert_eq!(chain.forward(&q_rad), expected.isometry());
                }
            }
        }
    }

    #[test]
    fn a_right_angled_arm_has_the_bits_of_its_chain_with_zeros_positive() {
        let mut robots: Vec<Robot> =
            Robot::built_in_names().iter().filter_map(|name| Robot::built_in(name)).collect();
        // One whose joints 2, 3 and 5 turn the other way, too.
        let odd =
            include_str!("../robot/built_in/irb140.toml").replace("axis = [0, 1, 0]", "axis = [0, -1, 0]");
        robots.push(Robot::from_toml(&odd).unwrap());
        for robot in &robots {
            let mut offsets = FrameOffsets::default();
            for shift_m in [0.0, 1e-3] {
                for (i, row) in offsets.0.iter_mut().enumerate() {
                    (row[0], row[1], row[2]) = (shift_m * i as f64, -shift_m, 0.3 * shift_m);
                }
                let chain = NominalFrames::of(robot).chain(&offsets);
                let arm = chain.right_angled.as_ref().unwrap();
                for q_rad in (0..200).map(joints) {
                    let there = chain.pose(&q_rad);
                    let expected = Pose {
                        rotation: there.rotation.map(|row| row.map(|value| value + 0.0)),
                        position_m: there.position_m.map(|value| value + 0.0),
                    };
                    let what = format!("{} {q_rad:?}", robot.name);
                    assert_eq!(bits(&arm.pose(&q_rad)), bits(&expected), "{what}");
                    for width in Width::all() {
                        let found = dispatch::on(width, RightAngledOne { arm, q_rad: &q_rad });
                        assert_eq!(bits(&pose_of(found)), bits(&expected), "{what} {width:?}");
                    }
                    assert_eq!(chain.forward(&q_rad), expected.isometry());
                }
            }
        }
    }

    #[test]
    fn an_arm_is_right_angled_to_the_last_digit_or_not_at_all() {
        let frames = NominalFrames::of(&Robot::built_in("irb140").unwrap());
        for (i, j) in (1..7).flat_map(|i| (3..6).map(move |j| (i, j))) {
            let mut offsets = FrameOffsets::default();
            offsets.0[i][j] = 1e-12;
            assert!(frames.chain(&offsets).right_angled.is_none(), "frame {i}, number {j}");
        }
        let mut offsets = FrameOffsets::default();
        offsets.0[3][0] = f64::INFINITY;
        assert!(frames.chain(&offsets).right_angled.is_none());
    }

    #[test]
    fn joints_that_are_no_numbers_give_none() {
        let chain = Chain::nominal(&Robot::built_in("irb140").unwrap());
        for (j, none) in (0..6).flat_map(|j| [f64::NAN, f64::INFINITY].map(|none| (j, none))) {
            let mut q_rad = [0.0; 6];
            q_rad[j] = none;
            let there = chain.forward(&q_rad);
            let all = there.translation.vector.iter().chain(there.rotation.coords.iter());
            assert!(all.into_iter().all(|number| number.is_nan()), "joint {}: {there}", j + 1);
        }
    }
}
