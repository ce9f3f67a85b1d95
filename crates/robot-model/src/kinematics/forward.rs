//! One pose of one arm on vectors: sines and cosines of all joints side by side, and the columns of the flange's frame each in a vector.
//!
//! The answer is that of [`Chain::pose`], to the bit: each number comes of the same operations in the same order.

use super::chain::{Chain, Pose, Step};
use super::dispatch::{Kernel, is_wide, on_quickest};
use super::lanes::{Column, Lanes, Wide};
use super::matrix::{self, norm};
use nalgebra::{Isometry3, Matrix3};

impl Chain {
    /// Pose of the flange in the base at joints of radians.
    #[must_use]
    pub fn forward(&self, q_rad: &[f64; 6]) -> Isometry3<f64> {
        if !is_wide() {
            return self.pose(q_rad).isometry();
        }
        // Column by column, as it was stored: a load across two stores would wait for both.
        let [x, y, z, origin_m] = forward_one(self, q_rad);
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

/// Compiled once, here: as in `chains`.
#[inline(never)]
fn forward_one(chain: &Chain, q_rad: &[f64; 6]) -> [[f64; 4]; 4] {
    on_quickest(ForwardOne { chain, q_rad })
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
        let mut at = Columns::<V::Column>::start(base_from_first);
        for (i, next) in behind.iter().enumerate() {
            at.turn(sin[i], cos[i]);
            at.advance(next);
        }
        let [x, y, z] = at.axes;
        [x.store(), y.store(), z.store(), at.origin_m.store()]
    }
}

/// A frame in the base: its axes and its origin, a vector each.
struct Columns<C> {
    axes: [C; 3],
    origin_m: C,
}

impl<C: Column> Columns<C> {
    #[inline(always)]
    fn start(step: &Step) -> Self {
        let [a, b, c] = &step.rotation;
        let [x, y, z] = step.position_m;
        Self {
            axes: [
                C::load(&[a[0], b[0], c[0], 0.0]),
                C::load(&[a[1], b[1], c[1], 0.0]),
                C::load(&[a[2], b[2], c[2], 0.0]),
            ],
            origin_m: C::load(&[x, y, z, 0.0]),
        }
    }

    /// Turns about z, by the angle's sine and cosine.
    #[inline(always)]
    fn turn(&mut self, sin: f64, cos: f64) {
        let (s, c) = (C::splat(sin), C::splat(cos));
        let [x, y, _] = self.axes;
        self.axes[0] = x * c + y * s;
        self.axes[1] = y * c - x * s;
    }

    /// Into the next frame.
    #[inline(always)]
    fn advance(&mut self, step: &Step) {
        let [a, b, c] = &step.rotation;
        self.origin_m = self.origin_m + self.along(&step.position_m);
        self.axes = [
            self.along(&[a[0], b[0], c[0]]),
            self.along(&[a[1], b[1], c[1]]),
            self.along(&[a[2], b[2], c[2]]),
        ];
    }

    /// The axes, each times its number, added up.
    #[inline(always)]
    fn along(&self, [x, y, z]: &[f64; 3]) -> C {
        self.axes[0] * C::splat(*x) + self.axes[1] * C::splat(*y) + self.axes[2] * C::splat(*z)
    }
}

#[cfg(test)]
mod tests {
    use super::super::dispatch::{self, Width};
    use super::*;
    use crate::kinematics::{FrameOffsets, NominalFrames};
    use crate::robot::Robot;

    #[test]
    fn every_width_gives_the_bits_of_the_chain() {
        let bits =
            |pose: Pose| (pose.rotation.map(|row| row.map(f64::to_bits)), pose.position_m.map(f64::to_bits));
        for name in Robot::built_in_names() {
            let frames = NominalFrames::of(&Robot::built_in(name).unwrap());
            for size in [0.0, 1e-4, 0.3] {
                let offset = |i: usize, j: usize| size * ((i * 6 + j) as f64 * 0.7 + 0.3).sin();
                let chain = frames
                    .chain(&FrameOffsets(std::array::from_fn(|i| std::array::from_fn(|j| offset(i, j)))));
                for n in 0..100 {
                    // Whole turns, nothing and multiples of a quarter among them.
                    let mut q_rad: [f64; 6] =
                        std::array::from_fn(|j| 9.0 * (f64::from(n) * 1.3 + (j * j) as f64).sin());
                    q_rad[n as usize % 6] =
                        [0.0, -0.0, std::f64::consts::FRAC_PI_2, -1e-9, 100.0][n as usize % 5];
                    let expected = bits(chain.pose(&q_rad));
                    for width in Width::all() {
                        let [x, y, z, p] = dispatch::on(width, ForwardOne { chain: &chain, q_rad: &q_rad });
                        let found = Pose {
                            rotation: std::array::from_fn(|k| [x[k], y[k], z[k]]),
                            position_m: std::array::from_fn(|k| p[k]),
                        };
                        assert_eq!(bits(found), expected, "{name} {size} {q_rad:?} {width:?}");
                    }
                    let there = chain.pose(&q_rad).isometry();
                    assert_eq!(chain.forward(&q_rad), there);
                }
            }
        }
    }
}
