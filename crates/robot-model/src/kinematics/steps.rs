//! What a chain is made of: a frame in the one before, a pose, and the way from the base to the flange.

use super::matrix::{self, Mat3, Vec3, add, apply, column, mul, rows, rx_ry_rz, sub};
use super::real::Real;
use nalgebra::Isometry3;

/// A pose as plain arrays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pose<T = f64> {
    pub rotation: Mat3<T>,
    pub position_m: Vec3<T>,
}

impl Pose {
    pub(crate) fn of(base_from_flange: &Isometry3<f64>) -> Self {
        Self {
            rotation: rows(&base_from_flange.rotation),
            position_m: base_from_flange.translation.vector.into(),
        }
    }

    pub(super) fn isometry(&self) -> Isometry3<f64> {
        matrix::isometry(&self.rotation, &self.position_m)
    }

    /// The same in all lanes.
    #[inline(always)]
    pub(crate) fn splat<T: Real>(&self) -> Pose<T> {
        Pose { rotation: matrix::splat_rows(&self.rotation), position_m: matrix::splat(&self.position_m) }
    }

    /// The twist in base axes that takes `other` here: metres, then the rotation vector in radians.
    #[inline]
    pub(crate) fn twist_from(&self, other: &Self) -> [f64; 6] {
        let [vx, vy, vz] = sub(&self.position_m, &other.position_m);
        let [wx, wy, wz] = matrix::rotation_vector(&self.rotation, &other.rotation);
        [vx, vy, vz, wx, wy, wz]
    }
}

/// A joint's frame, or the flange's, in the one before.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Step<T = f64> {
    pub(super) rotation: Mat3<T>,
    pub(super) position_m: Vec3<T>,
}

impl Step {
    pub(super) fn of(nominal: &Isometry3<f64>) -> Self {
        Self { rotation: rows(&nominal.rotation), position_m: nominal.translation.vector.into() }
    }

    /// Moved by its offsets, from the previous turned frame, to its own turned one.
    pub(super) fn moved(&self, offsets: &[f64; 6], previous: Option<&Mat3>, turned: Option<&Mat3>) -> Self {
        let [dx, dy, dz, rx, ry, rz] = *offsets;
        let mut rotation = mul(&rx_ry_rz(rx, ry, rz), &self.rotation);
        let mut position_m = add(&self.position_m, &[dx, dy, dz]);
        if let Some(previous) = previous {
            rotation = mul(previous, &rotation);
            position_m = apply(previous, &position_m);
        }
        if let Some(turned) = turned {
            rotation = mul(&rotation, turned);
        }
        Self { rotation, position_m }
    }

    #[inline(always)]
    pub(super) fn splat<T: Real>(&self) -> Step<T> {
        Step { rotation: matrix::splat_rows(&self.rotation), position_m: matrix::splat(&self.position_m) }
    }
}

/// Where the frames of an arm are kept.
pub(super) trait Frames<T> {
    /// Frame `i` in frame `i - 1`, both turned so that joints turn about z; 6 is the flange.
    fn step(&self, i: usize) -> Step<T>;
}

/// Sines and cosines of all joints.
#[inline(always)]
pub(super) fn sin_cos<T: Real>(q_rad: &[T; 6]) -> [(T, T); 6] {
    let [a, b, c, d, e, f] = q_rad;
    [a.sin_cos(), b.sin_cos(), c.sin_cos(), d.sin_cos(), e.sin_cos(), f.sin_cos()]
}

/// The way from the base to the flange.
pub(super) struct Walk<T>(pub(super) Pose<T>);

impl<T: Real> Walk<T> {
    #[inline(always)]
    pub(super) fn to_flange(frames: &impl Frames<T>, sin_cos: &[(T, T); 6]) -> Pose<T> {
        let mut at = Self::start(&frames.step(0));
        for (i, sin_cos) in sin_cos.iter().enumerate() {
            at.turn(sin_cos);
            at.advance(&frames.step(i + 1));
        }
        at.0
    }

    #[inline(always)]
    pub(super) fn start(step: &Step<T>) -> Self {
        Self(Pose { rotation: step.rotation, position_m: step.position_m })
    }

    /// Past a joint into the frame behind it; the joint's axis and origin.
    #[inline(always)]
    pub(super) fn joint(&mut self, sin_cos: &(T, T), next: &Step<T>) -> (Vec3<T>, Vec3<T>) {
        let line = (column(&self.0.rotation, 2), self.0.position_m);
        self.turn(sin_cos);
        self.advance(next);
        line
    }

    /// Into the next frame.
    #[inline(always)]
    pub(super) fn advance(&mut self, step: &Step<T>) {
        let Pose { rotation, position_m } = &mut self.0;
        *position_m = add(position_m, &apply(rotation, &step.position_m));
        *rotation = mul(rotation, &step.rotation);
    }

    /// Turns about z, by the angle's sine and cosine.
    #[inline(always)]
    pub(super) fn turn(&mut self, &(s, c): &(T, T)) {
        for row in &mut self.0.rotation {
            let [x, y, _] = *row;
            row[0] = x * c + y * s;
            row[1] = y * c - x * s;
        }
    }
}
