//! Numbers the kernels are written over: one `f64`, or several side by side.
//!
//! Both give the same bits: every operation is IEEE's own, none is fused, and the sine is computed here, so that a result
//! depends neither on the machine nor on which other poses it was computed with.

use std::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// What the kernels need of a number.
pub(crate) trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
{
    fn splat(value: f64) -> Self;
    fn reciprocal(self) -> Self;
    /// `yes` where `self` is more than one half, `no` elsewhere.
    fn choose(self, yes: Self, no: Self) -> Self;

    /// The nearest whole number, for sizes under 2^51.
    #[inline(always)]
    fn rounded(self) -> Self {
        let magic = Self::splat(6_755_399_441_055_744.0);
        (self + magic) - magic
    }

    /// Sine and cosine to one unit in the last place up to a million radians: Cody and Waite's reduction, 1980; the
    /// polynomials of fdlibm, Sun Microsystems, 1993.
    #[expect(clippy::excessive_precision, reason = "as published")]
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let c = Self::splat;
        let n = (self * c(std::f64::consts::FRAC_2_PI)).rounded();
        // π/2 in three parts, the first two with 33 bits: their products with n are exact.
        let x = self - n * c(1.570_796_326_734_125_614_17);
        let x = x - n * c(6.077_100_506_303_965_976_60e-11);
        let x = x - n * c(2.022_266_248_795_950_631_54e-21);
        let z = x * x;
        let sin = x + x
            * z
            * (c(-1.666_666_666_666_663_243_48e-1)
                + z * (c(8.333_333_333_322_489_461_24e-3)
                    + z * (c(-1.984_126_982_985_794_931_34e-4)
                        + z * (c(2.755_731_370_707_006_767_89e-6)
                            + z * (c(-2.505_076_025_340_686_341_95e-8)
                                + z * c(1.589_690_995_211_550_102_21e-10))))));
        let r = z
            * (c(4.166_666_666_666_660_190_37e-2)
                + z * (c(-1.388_888_888_887_410_957_49e-3)
                    + z * (c(2.480_158_728_947_672_941_78e-5)
                        + z * (c(-2.755_731_435_139_066_330_35e-7)
                            + z * (c(2.087_572_321_298_174_827_90e-9)
                                + z * c(-1.135_964_755_778_819_482_65e-11))))));
        let half = z * c(0.5);
        let w = c(1.0) - half;
        let cos = w + ((c(1.0) - w - half) + z * r);
        // The quadrant, 0 to 3, and its two bits.
        let k = n - c(4.0) * (n * c(0.25) - c(0.375)).rounded();
        let high = (k * c(0.5) - c(0.25)).rounded();
        let low = k - c(2.0) * high;
        let differ = (low - high) * (low - high);
        let sine = low.choose(cos, sin) * (c(1.0) - c(2.0) * high);
        let cosine = low.choose(sin, cos) * (c(1.0) - c(2.0) * differ);
        (sine, cosine)
    }
}

impl Real for f64 {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn reciprocal(self) -> Self {
        1.0 / self
    }

    #[inline(always)]
    fn choose(self, yes: Self, no: Self) -> Self {
        if self > 0.5 { yes } else { no }
    }
}

/// Several numbers side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lanes<const N: usize>(pub(crate) [f64; N]);

macro_rules! elementwise {
    ($trait:ident, $method:ident, $assign_trait:ident, $assign:ident, $op:tt) => {
        impl<const N: usize> $trait for Lanes<N> {
            type Output = Self;
            #[inline(always)]
            fn $method(mut self, other: Self) -> Self {
                for (a, b) in self.0.iter_mut().zip(&other.0) {
                    *a $op *b;
                }
                self
            }
        }
        impl<const N: usize> $assign_trait for Lanes<N> {
            #[inline(always)]
            fn $assign(&mut self, other: Self) {
                for (a, b) in self.0.iter_mut().zip(&other.0) {
                    *a $op *b;
                }
            }
        }
    };
}

elementwise!(Add, add, AddAssign, add_assign, +=);
elementwise!(Sub, sub, SubAssign, sub_assign, -=);
elementwise!(Mul, mul, MulAssign, mul_assign, *=);

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(mut self) -> Self {
        for a in &mut self.0 {
            *a = -*a;
        }
        self
    }
}

impl<const N: usize> Real for Lanes<N> {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self([value; N])
    }

    #[inline(always)]
    fn reciprocal(mut self) -> Self {
        for a in &mut self.0 {
            *a = 1.0 / *a;
        }
        self
    }

    #[inline(always)]
    fn choose(self, yes: Self, no: Self) -> Self {
        let mut chosen = no;
        for ((chosen, yes), which) in chosen.0.iter_mut().zip(&yes.0).zip(&self.0) {
            *chosen = if *which > 0.5 { *yes } else { *chosen };
        }
        chosen
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sine_and_cosine_are_the_standard_librarys_to_the_last_place() {
        let mut worst = 0.0_f64;
        let angles = (-200_000..=200_000).map(|i| f64::from(i) * 1.234_567e-4);
        let quarters = (-40..=40).map(|i| f64::from(i) * std::f64::consts::FRAC_PI_4);
        for x in angles.chain(quarters).chain([1e-9, -1e-300, 0.0, 1e5, -1e5]) {
            let (s, c) = Real::sin_cos(x);
            worst = worst.max((s - x.sin()).abs()).max((c - x.cos()).abs());
        }
        assert!(worst <= 2.0_f64.powi(-53), "{worst:e}");
    }

    #[test]
    fn lanes_give_the_bits_of_one_number() {
        let x: [f64; 8] = std::array::from_fn(|i| (i as f64 - 3.3) * 1.7);
        let (s, c) = Lanes(x).sin_cos();
        let t = (Lanes(x) * s - c).reciprocal();
        for (i, x) in x.into_iter().enumerate() {
            let (one_s, one_c) = Real::sin_cos(x);
            assert_eq!((s.0[i], c.0[i]), (one_s, one_c));
            assert_eq!(t.0[i], 1.0 / (x * one_s - one_c));
        }
    }
}
