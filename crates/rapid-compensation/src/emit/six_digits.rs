//! Numbers as a controller writes them when it saves a module: with six significant digits.

/// The powers of ten that double precision holds exactly.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// A number as it is read again when a controller has saved it; half a digit goes to the even one. One that was saved already is the same.
#[must_use]
pub(super) fn six_digits(value: f32) -> f32 {
    let size = f64::from(value).abs();
    let is_short = size < 1e6 && size.fract() == 0.0;
    if is_short || !size.is_finite() {
        return value;
    }
    let scale = 5 - decade(size);
    let power = POWERS.get(scale.unsigned_abs() as usize).copied().unwrap_or(1e22);
    let rounded = if scale >= 0 {
        (size * power).round_ties_even() / power
    } else {
        (size / power).round_ties_even() * power
    };
    rounded.copysign(f64::from(value)) as f32
}

/// The power of ten at or below a positive `size`. All numbers of an array are asked: a search among powers is a fifth of a logarithm's work.
fn decade(size: f64) -> i32 {
    // A single lies on one side of a power, or is it: rounding of this product moves none across.
    let (raised, by) = if size < 1.0 { (size * 1e10, 10) } else { (size, 0) };
    match POWERS.partition_point(|power| *power <= raised) {
        0 => size.log10().floor() as i32,
        at if at == POWERS.len() => size.log10().floor() as i32,
        at => at as i32 - 1 - by,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every single that is a power of ten, and those beside it.
    #[test]
    fn decades_are_those_of_the_logarithm() {
        for power in -37..38 {
            let near = format!("1e{power}").parse::<f32>().unwrap();
            for single in [near.next_down(), near, near.next_up()] {
                let size = f64::from(single);
                // By the digits that are written: the exponent of scientific notation.
                let written = format!("{size:.20e}");
                let exponent: i32 = written.split('e').nth(1).unwrap().parse().unwrap();
                assert_eq!(decade(size), exponent, "{single:e}");
            }
        }
    }

    #[test]
    fn what_was_saved_once_is_the_same_when_it_is_saved_again() {
        let mut bits = 12_345_u32;
        for _ in 0..20_000 {
            bits = bits.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let value = (bits as f32 / 4_294_967_296.0 - 0.5) * 10_f32.powi((bits >> 5) as i32 % 9 - 4);
            let saved: f32 = format!("{value:.5e}").parse().unwrap();
            assert_eq!(six_digits(value), saved, "{value}");
            assert_eq!(six_digits(saved), saved, "{value}");
        }
        for (value, saved) in [
            (0.996_194_7, 0.996_195_f32),
            (-0.577_350_26, -0.577_35),
            (1234.564, 1234.56),
            (1000.125, 1000.12),
            (9e9, 9e9),
            (-3.0, -3.0),
            (0.0, 0.0),
        ] {
            assert_eq!(six_digits(value), saved, "{value}");
        }
    }
}
