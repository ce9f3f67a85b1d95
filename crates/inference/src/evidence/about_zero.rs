//! A signal about a zero of its own: its constant is its size times how far off that zero lies, and no number by itself. A constant that
//! no such zero makes is another cause.

use super::candidate::{Projected, ReducedProducts};
use super::{EvidencePeak, NuisanceModel};
use nalgebra::DMatrix;
use statistics::log_sum;

/// Sizes that the average goes over, to either side of the middle, and how far, standard deviations.
const HALF: i32 = 40;
const REACH: f64 = 5.0;

/// What is known of a signal's size and its constant, in prior sigmas of each.
#[derive(Clone, Copy, Debug)]
pub(super) struct SizeAndConstant {
    /// The size that is likeliest, and the constant.
    pub mean: [f64; 2],
    /// Variance of the size, covariance, variance of the constant.
    pub covariance: [f64; 3],
    /// Standard deviation that the constant was given as a number by itself.
    pub spread: f64,
}

impl NuisanceModel {
    /// What it adds to ln evidence that the second of a candidate's two parameters is the first about a zero that is usually one off, both
    /// in prior sigmas, where they were integrated as independent of each other.
    #[must_use]
    pub(super) fn about_zero_nats(
        &self,
        candidate: &Projected,
        with_geometry: &DMatrix<f64>,
        peak: &EvidencePeak,
    ) -> f64 {
        if peak.size_ratio <= 0.0 || candidate.own.nrows() != 2 {
            return 0.0;
        }
        let ReducedProducts { mut own, with_y } = self.reduced(candidate, with_geometry, peak.geometry_ratio);
        let precision = peak.size_ratio.powi(-2);
        own[(0, 0)] += precision;
        own[(1, 1)] += precision;
        let Some(covariance) = own.cholesky().map(|c| c.inverse()) else { return 0.0 };
        let mean = &covariance * &with_y;
        let square_m2 = peak.sigma_m.powi(2);
        SizeAndConstant {
            mean: [mean[0], mean[1]],
            covariance: [(0, 0), (0, 1), (1, 1)].map(|at| covariance[at] * square_m2),
            spread: peak.size_ratio * peak.sigma_m,
        }
        .nats()
    }
}

impl SizeAndConstant {
    /// ln of the mean of N(constant; 0, size^2) / N(constant; 0, spread^2): over the constant in closed form, over the size by a sum.
    pub(super) fn nats(&self) -> f64 {
        let Self { mean: [size, constant], covariance: [size2, both, constant2], spread } = *self;
        let deviation = size2.max(f64::MIN_POSITIVE).sqrt();
        let own2 = (constant2 - both * both / size2.max(f64::MIN_POSITIVE)).max(1e-12 * spread * spread);
        let terms = (-HALF..=HALF).map(|k| {
            let z = REACH * f64::from(k) / f64::from(HALF);
            let at = size + z * deviation;
            let middle = constant + both / deviation * z;
            let size_square = (at * at).max(1e-12 * spread * spread);
            let precision = own2.recip() + size_square.recip() - spread.powi(-2);
            let exponent = 0.5 * (middle / own2).powi(2) / precision - 0.5 * middle * middle / own2;
            (
                -0.5 * z * z,
                0.5 * (spread * spread / size_square).ln() - 0.5 * (own2 * precision).ln() + exponent,
            )
        });
        let terms: Vec<(f64, f64)> = terms.collect();
        log_sum(terms.iter().map(|(weight, nats)| weight + nats))
            - log_sum(terms.iter().map(|(weight, _)| *weight))
    }
}

#[cfg(test)]
mod tests {
    use super::SizeAndConstant;

    /// Both well known: the ratio of two normal densities, ln(2 / 0.5) - 1 / (2 0.5^2) + 1 / (2 2^2) for a constant of 1 beside a size of 0.5.
    #[test]
    fn a_constant_is_as_likely_as_the_zero_that_makes_it() {
        let known = |size: f64, constant: f64| SizeAndConstant {
            mean: [size, constant],
            covariance: [1e-10, 0.0, 1e-10],
            spread: 2.0,
        };
        let by_hand = 4.0_f64.ln() - 2.0 + 0.125;
        assert!((known(0.5, 1.0).nats() - by_hand).abs() < 1e-4, "{}", known(0.5, 1.0).nats());
        assert!(known(2.0, 1.0).nats().abs() < 1e-4);
        assert!(known(0.2, 2.0).nats() < -40.0, "ten times as far off as usual");
    }

    /// Against a sum over both on a fine grid, where neither is well known and they go together.
    #[test]
    fn what_is_hardly_known_is_averaged() {
        let unsure = SizeAndConstant { mean: [0.4, 0.9], covariance: [0.04, 0.03, 0.09], spread: 1.0 };
        let normal = |x: f64, s: f64| (-0.5 * (x / s).powi(2)).exp() / s;
        let det = 0.04 * 0.09 - 0.03 * 0.03;
        let (mut sum, mut all) = (0.0, 0.0);
        for i in -600..=600 {
            for k in -600..=600 {
                let (a, b) = (f64::from(i) * 0.0025, f64::from(k) * 0.0033);
                let weight = (-0.5 * (0.09 * a * a - 0.06 * a * b + 0.04 * b * b) / det).exp();
                let (size, constant) = (0.4 + a, 0.9 + b);
                sum += weight * normal(constant, size.abs().max(1e-6)) / normal(constant, 1.0);
                all += weight;
            }
        }
        let exact: f64 = (sum / all).ln();
        assert!((unsure.nats() - exact).abs() < 0.02, "{} {exact}", unsure.nats());
    }
}
