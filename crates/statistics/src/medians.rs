//! Medians, and what they are of normal noise.

/// Median of the absolute value of a normal variate of standard deviation 1.
pub const MEDIAN_ABS_1D: f64 = 0.674_489_75;
/// Median of the length of three normal variates of standard deviation 1: the root of the median of chi-square of three degrees.
pub const MEDIAN_NORM_3D: f64 = 1.538_172_25;
/// Three quarters of such lengths are shorter.
pub const UPPER_QUARTILE_NORM_3D: f64 = 2.026_905_3;
/// The median of many normal variates scatters by so much more than their mean: the root of half of pi.
pub const MEDIAN_SCATTER: f64 = 1.253_314_1;

/// Middle value, of an even number the mean of the two; 0 of none. `values` are sorted.
#[must_use]
pub fn median(values: &mut [f64]) -> f64 {
    sorting::numbers(values);
    match values.len() {
        0 => 0.0,
        n if n % 2 == 1 => values[n / 2],
        n => 0.5 * (values[n / 2 - 1] + values[n / 2]),
    }
}

/// Middle value, of an even number the greater of the two: one of `values`, which are sorted.
#[must_use]
pub fn upper_median(values: &mut [f64]) -> Option<f64> {
    sorting::numbers(values);
    values.get(values.len() / 2).copied()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normal_cdf;

    #[test]
    fn middle_values_are_found_in_any_order() {
        assert_eq!((median(&mut [3.0, 1.0, 2.0]), upper_median(&mut [3.0, 1.0, 2.0])), (2.0, Some(2.0)));
        assert_eq!(
            (median(&mut [4.0, 1.0, 3.0, 2.0]), upper_median(&mut [4.0, 1.0, 3.0, 2.0])),
            (2.5, Some(3.0))
        );
        assert_eq!((median(&mut []), upper_median(&mut [])), (0.0, None));
    }

    /// P(|x| < r) = erf(r/√2) - √(2/π) r exp(-r²/2) in three dimensions, erf(r/√2) in one.
    #[test]
    fn constants_are_quantiles_of_the_normal_distribution() {
        let within_1d = |r: f64| 2.0 * normal_cdf(r) - 1.0;
        let within_3d =
            |r: f64| within_1d(r) - (2.0 / std::f64::consts::PI).sqrt() * r * (-0.5 * r * r).exp();
        assert!((within_1d(MEDIAN_ABS_1D) - 0.5).abs() < 3e-7);
        assert!((within_3d(MEDIAN_NORM_3D) - 0.5).abs() < 3e-7);
        assert!((within_3d(UPPER_QUARTILE_NORM_3D) - 0.75).abs() < 3e-7);
        assert!((MEDIAN_SCATTER.powi(2) - std::f64::consts::FRAC_PI_2).abs() < 1e-6);
    }
}
