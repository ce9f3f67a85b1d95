//! What goes to and fro over time: an air conditioning, a cooler, the sun.
//!
//! Noise whose neighbours are alike has more of all that is slow, but no line in its spectrum: a line is held against the
//! spectrum round it (Thomson 1982, Spectrum estimation and harmonic analysis, sec. XIII), and what is white or merely slow has none.

use inference::dataset::{Dataset, Twist};
use nalgebra::{DMatrix, DVector};
use statistics::variance_ratio;
use std::f64::consts::PI;

/// Half cycles over the measurement: fewer are a drift, more than these nobody samples.
const FEWEST: u32 = 3;
const MOST: u32 = 80;
/// Stations for each half cycle.
const STATIONS_PER_HALF: usize = 2;
/// Half cycles to either side of a line that are its own, and those beyond that it is held against.
const MAIN_LOBE: u32 = 2;
const NEIGHBOURHOOD: u32 = 7;
/// A line stands out where chance would have it once in three hundred spectra (normal quantile, for some tens of lines).
const STANDS_OUT: f64 = 3.7;
/// In a larger set what comes back after hours is mostly the arm, which comes back too.
const MOST_STATIONS: usize = 2000;

/// A line of the residuals' spectrum over time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SpectralLine {
    /// Half cycles over the measurement.
    pub half_cycles: u32,
    /// Its share of the lines that were looked at.
    pub share: f64,
}

/// Lines that stand out of the spectrum of `residuals` in stations that are not `outliers`.
#[must_use]
pub(super) fn significant_peaks(
    dataset: &Dataset,
    residuals: &[Twist],
    outliers: &[bool],
) -> Vec<SpectralLine> {
    let kept: Vec<usize> = (0..residuals.len()).filter(|&i| !outliers[i]).collect();
    if kept.len() > MOST_STATIONS {
        return Vec::new();
    }
    let last = MOST.min((kept.len() / STATIONS_PER_HALF) as u32);
    let progress: Vec<f64> = kept.iter().map(|&i| dataset.progress(&dataset.observations[i])).collect();
    let powers: Vec<f64> = (FEWEST..=last).map(|k| power(&progress, &kept, residuals, k)).collect();
    let count = powers.len();
    let found = (0..count).filter(|&at| {
        let round: Vec<f64> = (0..count)
            .filter(|other| (MAIN_LOBE + 1..=NEIGHBOURHOOD).contains(&(other.abs_diff(at) as u32)))
            .map(|other| powers[other])
            .collect();
        let mean = round.iter().sum::<f64>() / round.len().max(1) as f64;
        // Half cycles next to each other share half of what they see.
        let freedom = 3.0 * round.len() as f64;
        let highest =
            powers.iter().skip(at.saturating_sub(MAIN_LOBE as usize)).take(2 * MAIN_LOBE as usize + 1);
        freedom > 0.0
            && powers[at] >= highest.fold(0.0, |a: f64, b| a.max(*b))
            && powers[at] > variance_ratio(STANDS_OUT, 6.0, freedom) * mean
    });
    let line = |at| SpectralLine { half_cycles: FEWEST + at as u32, share: 1.0 / count as f64 };
    found.map(line).collect()
}

/// Sum of squares that a sine of `half_cycles` takes of the residuals, all three coordinates, beside a constant (Lomb 1976).
fn power(progress: &[f64], kept: &[usize], residuals: &[Twist], half_cycles: u32) -> f64 {
    let waves = DMatrix::from_fn(progress.len(), 3, |i, wave| {
        let at = PI * f64::from(half_cycles) * progress[i];
        [1.0, at.sin(), at.cos()][wave]
    });
    let Some(inverse) = waves.tr_mul(&waves).try_inverse() else { return 0.0 };
    let along = |axis: usize| {
        let of_axis = DVector::from_iterator(kept.len(), kept.iter().map(|&i| residuals[i][axis]));
        let seen = waves.tr_mul(&of_axis);
        let constant = seen[0] * seen[0] / progress.len() as f64;
        (&inverse * &seen).dot(&seen) - constant
    };
    (0..3).map(along).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::evenly_spread;

    /// Numbers of about unit variance without a pattern.
    fn noise(k: usize) -> f64 {
        let x = (k as f64 * 12.9898).sin() * 43_758.547;
        3.0_f64.sqrt() * (2.0 * (x - x.floor()) - 1.0)
    }

    /// Rows of noise of 20 um, each coordinate `memory` times the row's before, and a wave of `half_cycles` of `size` times that.
    fn lines(seed: usize, memory: f64, (half_cycles, size): (f64, f64)) -> Vec<u32> {
        let dataset = evenly_spread(100);
        let mut residuals = vec![Twist::default(); 100];
        let mut last = [0.0; 3];
        for (i, residual) in residuals.iter_mut().enumerate() {
            let wave = size * (PI * half_cycles * dataset.progress(&dataset.observations[i])).sin();
            for (axis, last) in last.iter_mut().enumerate() {
                *last = memory * *last + (1.0 - memory * memory).sqrt() * noise(1000 * seed + 3 * i + axis);
                residual[axis] = 2e-5 * (*last + wave);
            }
        }
        significant_peaks(&dataset, &residuals, &[false; 100])
            .into_iter()
            .map(|line| line.half_cycles)
            .collect()
    }

    /// Of 60 sets of noise, white or slow, one or none has a line; a wave as large as the noise is found where it is.
    #[test]
    fn a_line_is_told_from_noise_that_is_slow() {
        for memory in [0.0, 0.5, 0.9] {
            let false_alarms = (0..60).filter(|&seed| !lines(seed, memory, (0.0, 0.0)).is_empty()).count();
            assert!(false_alarms <= 1, "{memory}: {false_alarms}");
        }
        for seed in 0..10 {
            let found = lines(seed, 0.5, (25.0, 1.4));
            assert!(found.iter().any(|k| k.abs_diff(25) <= 1), "{found:?}");
        }
    }
}
