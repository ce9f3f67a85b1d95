//! What is left of every touch under a fitted warm-up, and which touches look false.

use super::history::{Standstill, ThermalHistory, warmth};
use super::parameters::PARAMETERS;
use super::point::Point;
use nalgebra::{SVector, Vector3};
use std::collections::BTreeSet;

/// The median length of a vector of three normal coordinates, in their standard deviation (the root of chi-square's median at 3).
const MEDIAN_LENGTH: f64 = 1.538_172_3;
/// Longer than so many standard deviations of one coordinate a touch looks false: by chance one of 65,000 is.
const FALSE_SIGMAS: f64 = 5.0;

/// One touch beside the fit.
#[derive(Clone, Debug, PartialEq)]
pub struct TouchResidual {
    /// Line in the file.
    pub line: u64,
    /// Name of the touched point.
    pub point: String,
    /// Minutes since the cold start.
    pub t_min: f64,
    /// How far the tool had moved since the cold arm, as touched, base axes, metres; the cold arm's place is the fit's.
    pub before_m: Vector3<f64>,
    /// What the fitted deformation leaves of it.
    pub after_m: Vector3<f64>,
    /// It lies further off than noise takes a touch.
    pub looks_false: bool,
    /// The fit counts it: it does not look false, or too many do.
    pub counts: bool,
}

/// Every touch of `points`, in the order of time, beside the fit to all but those of the lines `aside`.
pub(super) fn touch_residuals(
    points: &[Point],
    aside: &BTreeSet<u64>,
    names: &[String],
    history: &ThermalHistory,
    stops: &[Standstill],
    settled: &[f64; PARAMETERS],
) -> Vec<TouchResidual> {
    let settled = SVector::from(*settled);
    let mut all = Vec::new();
    for point in points {
        let grown = warmth(history, stops, &point.t_min);
        let settled_m = &point.signature * settled;
        let drift_m = |i: usize| settled_m * grown[i];
        let n = point.t_min.len();
        let kept: Vec<usize> = (0..n).filter(|&i| !aside.contains(&point.lines[i])).collect();
        let sum_m: Vector3<f64> = kept.iter().map(|&i| point.observed_m[i] - drift_m(i)).sum();
        let cold_m = sum_m / kept.len().max(1) as f64;
        all.extend((0..n).map(|i| {
            let before_m = point.observed_m[i] - cold_m;
            TouchResidual {
                line: point.lines[i],
                point: names.get(point.index).cloned().unwrap_or_default(),
                t_min: point.t_min[i],
                before_m,
                after_m: before_m - drift_m(i),
                looks_false: false,
                counts: !aside.contains(&point.lines[i]),
            }
        }));
    }
    all.sort_by(|a, b| a.t_min.total_cmp(&b.t_min).then(a.line.cmp(&b.line)));
    let lengths_m: Vec<f64> = all.iter().map(|touch| touch.after_m.norm()).collect();
    for (touch, looks_false) in all.iter_mut().zip(false_ones(&lengths_m)) {
        touch.looks_false = looks_false;
    }
    all
}

/// The lines to set aside next: those aside that look false still, and of the others those that do and are at least half as far off as the
/// furthest: near ones may only seem so while far ones pull at the fit.
pub(super) fn false_lines(all: &[TouchResidual], aside: &BTreeSet<u64>) -> BTreeSet<u64> {
    let others = all.iter().filter(|touch| !aside.contains(&touch.line));
    let furthest_m = others.map(|touch| touch.after_m.norm()).fold(0.0, f64::max);
    let is_next = |touch: &&TouchResidual| {
        touch.looks_false && (aside.contains(&touch.line) || touch.after_m.norm() >= furthest_m / 2.0)
    };
    all.iter().filter(is_next).map(|touch| touch.line).collect()
}

/// Which lengths are beyond what the middle one lets expect.
fn false_ones(lengths_m: &[f64]) -> Vec<bool> {
    let mut sorted = lengths_m.to_vec();
    sorted.sort_by(f64::total_cmp);
    let sigma_m = sorted.get(sorted.len() / 2).map_or(0.0, |middle_m| middle_m / MEDIAN_LENGTH);
    lengths_m.iter().map(|length_m| *length_m > FALSE_SIGMAS * sigma_m).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lengths of 1 to 9 hundredths and one far off: the middle one is 6, sigma 3.9, five of them 19.5 hundredths.
    #[test]
    fn what_is_five_sigmas_off_looks_false_however_far_it_is() {
        let near: Vec<f64> = (1..=9).map(|i| f64::from(i) * 1e-5).collect();
        for (length_m, is_false) in [(19e-5, false), (20e-5, true), (1.0, true)] {
            let all = [near.clone(), vec![length_m]].concat();
            let mut wanted = vec![false; 9];
            wanted.push(is_false);
            assert_eq!(false_ones(&all), wanted, "{length_m}");
        }
        assert!(false_ones(&[]).is_empty());
    }
}
