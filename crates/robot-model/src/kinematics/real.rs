//! Numbers the kernels are written over: one `f64`, or eight side by side (`lanes`).
//!
//! Both give the same bits: every operation is IEEE's own, none is fused, and the sine is computed here, so that a result
//! depends neither on the machine nor on which other poses it was computed with.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number of less than 2^51 is rounded to a whole one where this is added, which then stands in the lowest bits.
pub(crate) const WHOLE: f64 = 6_755_399_441_055_744.0;

/// What the kernels need of a number.
pub(crate) trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    fn splat(value: f64) -> Self;
    fn square_root(self) -> Self;
    fn size(self) -> Self;
    /// One where `self` is at most `limit`, zero elsewhere and where either is no number.
    fn at_most(self, limit: Self) -> Self;
    /// `yes` where `self` is more than one half, `no` elsewhere.
    fn choose(self, yes: Self, no: Self) -> Self;

    /// The larger of the two; `other` where either is no number.
    fn larger(self, other: Self) -> Self;
    /// `sin` and `cos` of an angle when it has grown by so many quarter turns as the lowest two bits of `quarters` say.
    fn turned_by_quarters(quarters: Self, sin: Self, cos: Self) -> (Self, Self);

    /// The nearest whole number, for sizes under 2^51.
    #[inline(always)]
    fn rounded(self) -> Self {
        let magic = Self::splat(WHOLE);
        (self + magic) - magic
    }

    /// Sine and cosine to one unit in the last place up to a million radians: Cody and Waite's reduction, 1980; the
    /// polynomials of fdlibm, Sun Microsystems, 1993.
    #[expect(clippy::excessive_precision, reason = "as published")]
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let c = Self::splat;
        let quarters = self * c(std::f64::consts::FRAC_2_PI) + c(WHOLE);
        let n = quarters - c(WHOLE);
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
        Self::turned_by_quarters(quarters, sin, cos)
    }

    /// The angle of the direction (`x`, `self`) to two units in the last place, in [-π, π]; zero where both are: fdlibm's
    /// arctangent, Sun Microsystems, 1993, up to an eighth of a turn.
    #[expect(clippy::excessive_precision, reason = "as published")]
    #[inline(always)]
    fn angle(self, x: Self) -> Self {
        let c = Self::splat;
        let (one, zero) = (c(1.0), c(0.0));
        let (high, wide) = (self.size(), x.size());
        // The smaller over the larger, or what is left of it past 22.5 degrees.
        let steep = one - high.at_most(wide);
        let (small, large) = (steep.choose(wide, high), steep.choose(high, wide));
        let past = one - small.at_most(large * c(0.414_213_562_373_095_05));
        let over = past.choose(small + large, large);
        let t = past.choose(small - large, small) / over.at_most(zero).choose(one, over);
        let z = t * t;
        let w = z * z;
        let even = z
            * (c(3.333_333_333_333_293_180_27e-1)
                + w * (c(1.428_571_427_250_346_637_11e-1)
                    + w * (c(9.090_887_133_436_506_561_96e-2)
                        + w * (c(6.661_073_137_387_531_206_69e-2)
                            + w * (c(4.976_877_994_615_932_360_17e-2)
                                + w * c(1.628_582_011_536_578_236_23e-2))))));
        let odd = w
            * (c(-1.999_999_999_987_648_324_76e-1)
                + w * (c(-1.111_111_040_546_235_578_80e-1)
                    + w * (c(-7.691_876_205_044_829_994_95e-2)
                        + w * (c(-5.833_570_133_790_573_486_45e-2)
                            + w * c(-3.653_157_274_421_691_552_70e-2)))));
        let bend = t * (even + odd);
        // π/4 and π/2, each with the part that one number has no room for.
        let angle = past.choose(
            c(std::f64::consts::FRAC_PI_4) - ((bend - c(3.061_616_997_868_383_017_93e-17)) - t),
            t - bend,
        );
        let angle = steep
            .choose(c(std::f64::consts::FRAC_PI_2) - (angle - c(6.123_233_995_736_766_035_87e-17)), angle);
        let back = one - zero.at_most(x);
        let angle =
            back.choose(c(std::f64::consts::PI) - (angle - c(1.224_646_799_147_353_207_17e-16)), angle);
        (one - zero.at_most(self)).choose(-angle, angle)
    }
}

impl Real for f64 {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn square_root(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn size(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn at_most(self, limit: Self) -> Self {
        if self <= limit { 1.0 } else { 0.0 }
    }

    #[inline(always)]
    fn choose(self, yes: Self, no: Self) -> Self {
        if self > 0.5 { yes } else { no }
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    #[inline(always)]
    fn turned_by_quarters(quarters: Self, sin: Self, cos: Self) -> (Self, Self) {
        let k = quarters.to_bits();
        let (sine, cosine) = if k & 1 == 0 { (sin, cos) } else { (cos, sin) };
        // The sine's sign changes in quadrants 2 and 3, the cosine's in 1 and 2.
        let changed = |value: f64, k: u64| Self::from_bits(value.to_bits() ^ ((k & 2) << 62));
        (changed(sine, k), changed(cosine, k.wrapping_add(1)))
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
    fn the_angle_of_a_direction_is_the_standard_librarys_to_two_last_places() {
        let mut worst = 0.0_f64;
        for i in -100_000..=100_000 {
            let (y, x) = (f64::from(i) * 3.141e-5).sin_cos();
            for (y, x) in [(y, x), (1e-9 * y, 1e3 * x), (1e-160 * y, 1e-160 * x), (x * x, y)] {
                let expected = y.atan2(x);
                worst = worst.max((Real::angle(y, x) - expected).abs() / expected.abs().max(1e-300));
            }
        }
        assert!(worst <= 2.0 * f64::EPSILON, "{worst:e}");
        use std::f64::consts::{FRAC_PI_2, PI};
        for (y, x, angle) in [
            (0.0, 0.0, 0.0),
            (0.0, 2.0, 0.0),
            (0.0, -2.0, PI),
            (3.0, 0.0, FRAC_PI_2),
            (-3.0, 0.0, -FRAC_PI_2),
            (1.0, 1.0, PI / 4.0),
        ] {
            assert_eq!(Real::angle(y, x), angle, "{y} {x}");
        }
        assert!(Real::angle(f64::NAN, 1.0).is_nan());
    }
}
