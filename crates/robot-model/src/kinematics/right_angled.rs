//! The chain of an arm whose axes stand as those of nearly every six-axis arm as built: axis 2 across axis 1, axis 3 along axis 2, axes 4 and
//! 5 each across the one before, axis 6 across axis 5, the flange's z along axis 6; each exactly.
//!
//! Frames between such joints are turned by quarter turns alone. A product by one or zero changes nothing, so it is not made: what
//! comes out are the numbers of the whole chain to the bit, but for the sign of a zero, which here is always positive.

use super::frame_columns::FrameColumns;
use super::lanes::{Column, LANES};
use super::matrix::{Mat3, Vec3, mul};
use super::real::{Real, WHOLE};
use super::steps::Step;

/// Whether the axis behind each joint stands across it; else it stands along it.
const ACROSS: [bool; 6] = [true, false, true, true, true, false];

/// A quarter turn about x, Rx(90 deg).
const TILT: Mat3 = [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]];

/// An arm of six joints whose constant frames are `Trans(p) Rz(a)` or `Trans(p) Rz(a) Rx(90 deg) Rz(b)`, a and b being quarter turns.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct RightAngled {
    /// Joint 1 at rest in the base.
    base_from_first: Step,
    /// How many quarter turns stand about each axis already, 0 to 3, in the lowest bits of numbers as [`Real::turned_by_quarters`] asks for.
    quarters: [f64; LANES],
    /// The next frame's origin along the axes behind the joint, metres: before the tilt where there is none, else behind it.
    positions_m: [Vec3; 6],
}

impl RightAngled {
    /// Nothing where an axis stands otherwise.
    pub(super) fn of(steps: &[Step; 7]) -> Option<Self> {
        let [first, behind @ ..] = steps;
        let mut quarters = [WHOLE; LANES];
        let mut positions_m = [[0.0; 3]; 6];
        let mut before = 0;
        for (i, step) in behind.iter().enumerate() {
            let (a, b) = quarter_turns(&step.rotation, ACROSS[i])?;
            let [x, y, z] = step.position_m;
            if !(x + y + z).is_finite() {
                return None;
            }
            let (sin, cos) = SIN_COS[a];
            let [x, y] = [cos * x + sin * y, cos * y - sin * x];
            positions_m[i] = if ACROSS[i] { [x, z, -y] } else { [x, y, z] };
            quarters[i] = WHOLE + ((before + a) % 4) as f64;
            before = b;
        }
        Some(Self { base_from_first: *first, quarters, positions_m })
    }

    /// Sine and cosine of joint `joint`'s angle as of all that stands about its axis.
    #[inline(always)]
    pub(super) fn turned<T: Real>(&self, joint: usize, (sin, cos): (T, T)) -> (T, T) {
        T::turned_by_quarters(T::splat(self.quarters[joint]), sin, cos)
    }

    /// The quarter turns of all joints as numbers side by side; two more for nothing.
    #[inline(always)]
    pub(super) fn quarters(&self) -> [f64; LANES] {
        self.quarters
    }

    /// The flange's frame by sines and cosines of [`turned`](Self::turned) angles. `zero` is added to all there is: it makes zeros
    /// positive, and no number of all that there is when it is none.
    #[inline(always)]
    pub(super) fn flange<C: Column>(&self, sin_cos: &[(C, C); 6], zero: C) -> FrameColumns<C> {
        let Step { rotation, position_m } = &self.base_from_first;
        let mut at = FrameColumns::start(rotation, position_m);
        for i in 0..6 {
            let [p, q, r] = self.positions_m[i];
            if ACROSS[i] {
                at.turn_and_tilt(&sin_cos[i]);
                // In the order of the axes before the tilt: sums are rounded.
                let [x, y, z] = at.axes;
                at.origin_m = at.origin_m + (x * C::splat(p) + z * C::splat(r) + y * C::splat(q));
            } else {
                at.turn(&sin_cos[i]);
                at.origin_m = at.origin_m + at.along(&[p, q, r]);
            }
        }
        let [x, y, z] = at.axes;
        FrameColumns { axes: [x + zero, y + zero, z + zero], origin_m: at.origin_m + zero }
    }
}

/// A positive zero; no number where one of the joints is none.
#[inline(always)]
pub(super) fn zero<T: Real>(q_rad: &[T; 6]) -> T {
    let [a, b, c, d, e, f] = *q_rad;
    ((a + b) + (c + d) + (e + f)) * T::splat(0.0) + T::splat(0.0)
}

/// Sine and cosine of none to three quarter turns.
const SIN_COS: [(f64, f64); 4] = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)];

/// a and b of `Rz(a) Rx(90 deg) Rz(b)`, or of `Rz(a)` where the next axis does not stand across, in quarter turns.
fn quarter_turns(rotation: &Mat3, across: bool) -> Option<(usize, usize)> {
    let quarter = |sin: f64, cos: f64| SIN_COS.iter().position(|of| *of == (sin, cos));
    let about_z = |quarters: usize| {
        let (sin, cos) = SIN_COS[quarters];
        [[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]]
    };
    let [[xx, _, zx], [xy, _, zy], [xz, ..]] = *rotation;
    let (a, b, product) = if across {
        let a = quarter(zx, -zy)?;
        let (sin, cos) = SIN_COS[a];
        let b = quarter(xz, cos * xx + sin * xy)?;
        (a, b, mul(&mul(&about_z(a), &TILT), &about_z(b)))
    } else {
        let a = quarter(xy, xx)?;
        (a, 0, about_z(a))
    };
    (product == *rotation).then_some((a, b))
}
