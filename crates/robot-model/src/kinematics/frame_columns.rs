//! A frame in the base by its axes and its origin, each held as one thing to compute with: a register of four, or three numbers.

use super::lanes::Column;
use super::matrix::{Mat3, Vec3, column};

/// Axes and origin (m) of a frame in the base.
pub(super) struct FrameColumns<C> {
    pub(super) axes: [C; 3],
    pub(super) origin_m: C,
}

impl<C: Column> FrameColumns<C> {
    #[inline(always)]
    pub(super) fn start(rotation: &Mat3, position_m: &Vec3) -> Self {
        Self {
            axes: [
                C::load(&column(rotation, 0)),
                C::load(&column(rotation, 1)),
                C::load(&column(rotation, 2)),
            ],
            origin_m: C::load(position_m),
        }
    }

    /// Turns about z, by the angle's sine and cosine.
    #[inline(always)]
    pub(super) fn turn(&mut self, &(s, c): &(C, C)) {
        let [x, y, _] = self.axes;
        self.axes[0] = x * c + y * s;
        self.axes[1] = y * c - x * s;
    }

    /// Turns about z, then about the new x by +90 deg: the new y is the old z, the new z against the old y.
    #[inline(always)]
    pub(super) fn turn_and_tilt(&mut self, &(s, c): &(C, C)) {
        let [x, y, z] = self.axes;
        self.axes = [x * c + y * s, z, x * s - y * c];
    }

    /// Into the next frame.
    #[inline(always)]
    pub(super) fn advance(&mut self, rotation: &Mat3, position_m: &Vec3) {
        self.origin_m = self.origin_m + self.along(position_m);
        self.axes = [
            self.along(&column(rotation, 0)),
            self.along(&column(rotation, 1)),
            self.along(&column(rotation, 2)),
        ];
    }

    /// The axes, each times its number, added up.
    #[inline(always)]
    pub(super) fn along(&self, [x, y, z]: &Vec3) -> C {
        self.axes[0] * C::splat(*x) + self.axes[1] * C::splat(*y) + self.axes[2] * C::splat(*z)
    }
}
