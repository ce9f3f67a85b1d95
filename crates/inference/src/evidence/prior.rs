//! What is believed of sizes before the data are seen, and the grids over which they are summed.

use crate::marginal::{NoisePrior, SIGMA_M};
use nalgebra::DVector;
use statistics::normal_pdf;

/// Prior weight of geometry exactly as drawn.
pub(super) const NO_GEOMETRY: f64 = 0.25;

/// Touches of fixed points measure no length: an arm of half the size closes upon its points twice as well, noise and all. No error is believed there
/// that is more than so many times as large as it usually is.
pub(super) const MOST_OF_TOUCHES: f64 = 24.0;
/// Signal of the smallest geometry that is looked at, over the noise.
const SMALLEST_RHO: f64 = 0.18;
/// Signal of the largest, over what the data have beside registration.
const LARGEST_OF_LEFT: f64 = 32.0;
/// ln prior mass of what is not believed at all.
const NEVER: f64 = -1e6;

/// Smallest size that is looked at, in prior sigmas.
const SMALLEST: f64 = 1.0 / 64.0;

/// Rms signal over `m` rows of geometry of one tolerance, with squares `lambda` along its own directions.
pub(super) fn geometry_signal(m: f64, lambda: &DVector<f64>) -> f64 {
    (lambda.sum().max(0.0) / m).sqrt()
}

/// Factor-of-two grids that cover what the data can mean, ascending.
pub(super) struct RatioGrids {
    /// s_g/sigma of geometry, 0 first.
    pub geometry: Vec<f64>,
    /// s/sigma of a candidate.
    pub size: Vec<f64>,
}

impl RatioGrids {
    /// Grids for `m` rows whose squares are `yy`, and geometry with squares `lambda` along its own directions and products `gy`
    /// with the data.
    pub(super) fn new(noise: &NoisePrior, m: f64, yy: f64, lambda: &DVector<f64>, gy: &DVector<f64>) -> Self {
        let explained: f64 = lambda.iter().zip(gy.iter()).map(|(l, g)| g * g / l).sum();
        // Rounding may leave a little less than nothing.
        let high_m = (yy.max(0.0) / m).sqrt().clamp(SIGMA_M[0], SIGMA_M[1]);
        let left = ((yy - explained).max(0.0) / m).sqrt() / 2.0;
        let low_m = noise.known.map_or(left, |known| known.sigma_m.min(high_m)).clamp(SIGMA_M[0], high_m);
        let doubling = |from: f64, to: f64| {
            let steps = (to / from).log2().ceil().max(0.0) as i32;
            (0..=steps).map(move |k| from * f64::from(k).exp2())
        };
        // What is a sixth of the noise is as good as none, and what is many times all that is left is none of these data's.
        let signal = geometry_signal(m, lambda).max(1e-300);
        let smallest = (0.25 / high_m).min(SMALLEST_RHO / signal);
        let largest = (24.0 / low_m).min(LARGEST_OF_LEFT * high_m / low_m / signal).max(smallest);
        Self {
            geometry: std::iter::once(0.0).chain(doubling(smallest, largest)).collect(),
            size: doubling(SMALLEST / high_m, 24.0 / low_m).collect(),
        }
    }
}

/// Prior weight of geometry in proportion to the noise.
const GEOMETRY_BY_NOISE: f64 = 0.3;
/// Sigma of ln rho.
const RHO_SPREAD: f64 = 1.1;
/// A normal distribution's mass up to x sigmas is 1 / (1 + exp(-1.702 x)) within 0.01 (Bowling and others, 2009).
const PER_LOGISTIC: f64 = 1.702 / RHO_SPREAD;

/// ln prior mass of one factor-of-two cell at `s_g`, whose signal is `rho` times the noise: about the tolerance, with a tail for arms never
/// calibrated, or, of one that was, so much as these data just begin to ask for; none beyond `most`. Without the last a single link
/// or zero, whose size may be in proportion to the noise, would stand for what little all of them are off together.
pub(super) fn geometry_prior(s_g: f64, rho: f64, most: f64) -> f64 {
    if s_g <= 0.0 {
        return NO_GEOMETRY.ln();
    }
    if s_g > most {
        return NEVER;
    }
    let x = s_g.ln();
    let by_tolerance = 0.85 * normal_pdf(x, -0.3, 0.8) + 0.15 * normal_pdf(x, 1.6, 1.0);
    // Noise of millimetres is no reason for links that are off by as much: what is in proportion to it stays under the tolerance, and
    // where data are so poor that little of it does, the others have its weight.
    let signal_of_tolerance = rho / s_g;
    let by_noise = GEOMETRY_BY_NOISE / (1.0 + signal_of_tolerance.powf(-PER_LOGISTIC));
    let seen = if s_g < 1.0 { GEOMETRY_BY_NOISE * in_proportion_to_noise(rho) } else { 0.0 };
    let density = (1.0 - by_noise) * by_tolerance + seen;
    ((1.0 - NO_GEOMETRY) * density * std::f64::consts::LN_2).max(1e-12).ln()
}

/// Density over ln rho of a signal that is `rho` times the noise, where nothing else is known of it.
fn in_proportion_to_noise(rho: f64) -> f64 {
    normal_pdf(rho.max(1e-9).ln(), 0.0, RHO_SPREAD)
}

/// Prior weight of sizes in proportion to the noise.
const BY_NOISE: f64 = 0.5;

/// ln prior mass of one factor-of-two cell at size `s` times usual, whose signal is `rho` times the noise. What is looked
/// for is of its usual size, or so large that these data just begin to ask for it, whatever is usual; beyond `most` it is not believed.
pub(super) fn size_prior(s: f64, rho: f64, most: f64) -> f64 {
    if s > most {
        return NEVER;
    }
    let x = s.max(1e-9).ln();
    let prior_sigma = 0.8 * normal_pdf(x, 0.0, 0.9) + 0.2 * normal_pdf(x, 1.2, 1.3);
    let density = (1.0 - BY_NOISE) * prior_sigma + BY_NOISE * in_proportion_to_noise(rho);
    (density * std::f64::consts::LN_2).max(1e-12).ln()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cells of a factor of two, however much signal one usual size has: mass 1 in all, and a signal as large as the noise
    /// keeps weight where it is far below what is usual.
    #[test]
    fn sizes_share_one_and_what_is_small_but_seen_is_not_shut_out() {
        for signal_of_unit_size in [0.01, 1.0, 300.0] {
            let total: f64 = (-60..60)
                .map(|k| f64::from(k).exp2())
                .map(|s| size_prior(s, s * signal_of_unit_size, f64::INFINITY).exp())
                .sum();
            assert!((total - 1.0).abs() < 1e-3, "{total}");
        }
        // Geometry of all joints, likewise, beside none at all.
        for signal_of_tolerance in [0.01, 1.0, 300.0] {
            let total: f64 = (-60..60)
                .map(|k| f64::from(k).exp2())
                .map(|s| geometry_prior(s, s * signal_of_tolerance, f64::INFINITY).exp())
                .sum();
            // Cells of a factor of two cut the part by noise somewhere about the tolerance.
            assert!((total - (1.0 - NO_GEOMETRY)).abs() < 0.05, "{total}");
        }
        // 1/300 of usual: 6.3 standard deviations of the prior sigmas, but the middle of those by the noise:
        // ln(0.5 ln 2 / (1.1 sqrt(2 pi)))
        let seen = size_prior(1.0 / 300.0, 1.0, f64::INFINITY);
        let middle = (0.5 * std::f64::consts::LN_2 / (1.1 * std::f64::consts::TAU.sqrt())).ln();
        assert!((seen - middle).abs() < 1e-2, "{seen} {middle}");
    }
}
