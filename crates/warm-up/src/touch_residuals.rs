//! What is left of every touch under a fitted warm-up, and which touches look false.

use super::history::{Standstill, ThermalHistory, warmth};
use super::parameters::PARAMETERS;
use super::point::Point;
use nalgebra::{SVector, Vector3};
use statistics::{MEDIAN_NORM_3D, upper_median};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// Longer than so many standard deviations of one coordinate a touch looks false: by chance one of 65,000 is.
pub(super) const FALSE_SIGMAS: f64 = 5.0;
/// Where more of the touches than this are false, all of them count.
pub(super) const MOST_ASIDE: f64 = 0.15;
/// A false touch is off those before and after it by more than this share of what it is off the fit: others only go as their neighbours do.
const OFF_NEIGHBOURS: f64 = 0.5;
/// And by so many standard deviations: by chance one of 34 is.
const OFF_NEIGHBOURS_SIGMAS: f64 = 3.0;

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
    /// The fit counts it: it does not look false, or it goes as those before and after it do, or too many do.
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
        let cold_at = |place: Range<usize>| {
            let kept: Vec<usize> = place.filter(|&i| !aside.contains(&point.lines[i])).collect();
            let sum_m: Vector3<f64> = kept.iter().map(|&i| point.observed_m[i] - drift_m(i)).sum();
            sum_m / kept.len().max(1) as f64
        };
        let of_place = |place: Range<usize>| std::iter::repeat_n(cold_at(place.clone()), place.len());
        let cold_m: Vec<Vector3<f64>> = point.places().into_iter().flat_map(of_place).collect();
        all.extend((0..n).map(|i| {
            let before_m = point.observed_m[i] - cold_m[i];
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
    sorting::by(&mut all, |a, b| a.t_min.total_cmp(&b.t_min).then(a.line.cmp(&b.line)));
    let lengths_m: Vec<f64> = all.iter().map(|touch| touch.after_m.norm()).collect();
    for (touch, looks_false) in all.iter_mut().zip(false_ones(&lengths_m)) {
        touch.looks_false = looks_false;
    }
    all
}

/// The lines to set aside next of those that look false.
pub(super) fn false_lines(all: &[TouchResidual], aside: &BTreeSet<u64>) -> BTreeSet<u64> {
    let look_false = all.iter().filter(|touch| touch.looks_false).map(|touch| touch.line).collect();
    next_lines(all, aside, &look_false)
}

/// The lines to set aside next of those that look false and stand alone.
pub(super) fn accident_lines(all: &[TouchResidual], aside: &BTreeSet<u64>) -> BTreeSet<u64> {
    next_lines(all, aside, &alone(all))
}

/// Of the lines that are false those that are aside, and of the others those at least half as far off as the furthest: near ones may only
/// seem so while far ones pull at the fit.
fn next_lines(all: &[TouchResidual], aside: &BTreeSet<u64>, are_false: &BTreeSet<u64>) -> BTreeSet<u64> {
    let others = all.iter().filter(|touch| !aside.contains(&touch.line));
    let furthest_m = others
        .filter(|touch| are_false.contains(&touch.line))
        .map(|touch| touch.after_m.norm())
        .fold(0.0, f64::max);
    let is_next = |touch: &&TouchResidual| {
        are_false.contains(&touch.line)
            && (aside.contains(&touch.line) || touch.after_m.norm() >= furthest_m / 2.0)
    };
    all.iter().filter(is_next).map(|touch| touch.line).collect()
}

/// The lines that look false beside the touches before and after them, too. Where the arm, or a point, does not go as the fit has it, touches
/// look false as their neighbours do: setting them aside one by one would hide it.
fn alone(all: &[TouchResidual]) -> BTreeSet<u64> {
    let mut by_point: BTreeMap<&str, Vec<&TouchResidual>> = BTreeMap::new();
    for touch in all {
        by_point.entry(&touch.point).or_default().push(touch);
    }
    let lengths_m: Vec<f64> = all.iter().map(|touch| touch.after_m.norm()).collect();
    let sigma_m = typical_sigma_m(&lengths_m);
    let of_point = |own: &Vec<&TouchResidual>| {
        let left_m: Vec<Vector3<f64>> = own.iter().map(|touch| touch.after_m).collect();
        let counts: Vec<bool> = own.iter().map(|touch| touch.counts).collect();
        let is_alone = |k: &usize| own[*k].looks_false && is_off_neighbours(&left_m, &counts, *k, sigma_m);
        (0..own.len()).filter(is_alone).map(|k| own[k].line).collect::<Vec<u64>>()
    };
    by_point.values().flat_map(of_point).collect()
}

/// Whether what is left of one touch of a point is more than what is left of its neighbours lets expect. One neighbour that does not count is
/// passed over on each side, no more: beside a step touches would be set aside one after the other.
fn is_off_neighbours(left_m: &[Vector3<f64>], counts: &[bool], k: usize, sigma_m: f64) -> bool {
    let own_m = left_m[k];
    let before: Vec<usize> = (0..k).rev().take(3).filter(|&j| counts[j]).collect();
    let after: Vec<usize> = (k + 1..left_m.len()).take(3).filter(|&j| counts[j]).collect();
    let least_m = OFF_NEIGHBOURS * own_m.norm();
    let is_off = |expected_m: Vector3<f64>, variances: f64| {
        let sigmas_m = OFF_NEIGHBOURS_SIGMAS * sigma_m * variances.sqrt();
        (own_m - expected_m).norm() > least_m.max(sigmas_m)
    };
    // With neighbours on one side, as the first and last: neither as the next one nor further on as that goes.
    let one_sided = |side: &[usize]| match *side {
        [next, second, ..] => {
            is_off(left_m[next], 2.0) && (own_m - (left_m[next] * 2.0 - left_m[second])).norm() > least_m
        }
        [next] => is_off(left_m[next], 2.0),
        [] => true,
    };
    let nearest = |side: &[usize]| side.first().copied().filter(|j| j.abs_diff(k) <= 2);
    match (nearest(&before), nearest(&after)) {
        (Some(before), Some(after)) => is_off((left_m[before] + left_m[after]) / 2.0, 1.5),
        (Some(_), None) => one_sided(&before),
        (None, _) => one_sided(&after),
    }
}

/// Which lengths are beyond what the middle one lets expect.
fn false_ones(lengths_m: &[f64]) -> Vec<bool> {
    let sigma_m = typical_sigma_m(lengths_m);
    lengths_m.iter().map(|length_m| *length_m > FALSE_SIGMAS * sigma_m).collect()
}

/// One standard deviation of a coordinate by the middle one of lengths, metres.
pub(super) fn typical_sigma_m(lengths_m: &[f64]) -> f64 {
    upper_median(&mut lengths_m.to_vec()).map_or(0.0, |middle_m| middle_m / MEDIAN_NORM_3D)
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

    /// Sigma is 1: what decays by a tenth a touch, as a second lag does, goes on, and so does what stays 20 off; a single touch that is does not.
    #[test]
    fn a_touch_is_alone_where_its_neighbours_do_not_go_on_to_it() {
        let along_x =
            |lengths: &[f64]| lengths.iter().map(|x| Vector3::new(*x, 0.0, 0.0)).collect::<Vec<_>>();
        let all = [true; 20];
        let decays = along_x(&(0..20).map(|k| 20.0 * 0.9_f64.powi(k)).collect::<Vec<_>>());
        assert!((0..20).all(|k| !is_off_neighbours(&decays, &all, k, 1.0)));
        for at in [0, 1, 7, 19] {
            let mut single = vec![0.0; 20];
            single[at] = 20.0;
            assert!(is_off_neighbours(&along_x(&single), &all, at, 1.0), "{at}");
        }
        let mut step = vec![0.0; 10];
        step.extend([20.0; 10]);
        assert!((11..20).all(|k| !is_off_neighbours(&along_x(&step), &all, k, 1.0)));
    }

    /// Two that follow one another: the nearer one counts beside the further one, and does not once that is set aside. Of a step, 10 off before it
    /// and 10 off behind, the touches from the third on count whatever is set aside beside it.
    #[test]
    fn a_touch_is_alone_beside_one_that_does_not_count() {
        let along_x =
            |lengths: &[f64]| lengths.iter().map(|x| Vector3::new(*x, 0.0, 0.0)).collect::<Vec<_>>();
        let mut two = vec![0.0; 20];
        (two[7], two[8]) = (18.0, 20.0);
        let (two, mut counts) = (along_x(&two), [true; 20]);
        assert!(!is_off_neighbours(&two, &counts, 7, 1.0) && is_off_neighbours(&two, &counts, 8, 1.0));
        counts[8] = false;
        assert!(is_off_neighbours(&two, &counts, 7, 1.0));
        counts[7] = false;
        assert!(is_off_neighbours(&two, &counts, 7, 1.0) && is_off_neighbours(&two, &counts, 8, 1.0));
        let step = along_x(&[vec![-10.0; 10], vec![10.0; 10]].concat());
        for aside in [vec![9], vec![10], vec![9, 10], vec![8, 9], vec![8, 9, 10, 11]] {
            let counts: Vec<bool> = (0..20).map(|k| !aside.contains(&k)).collect();
            let goes_along = |k: usize| !is_off_neighbours(&step, &counts, k, 1.0);
            assert!((0..8).chain(12..20).all(goes_along), "{aside:?}");
        }
    }
}
