//! The whole spectrum of a gear in place of its lines, and its size, for a model that is to hold elsewhere.
//!
//! Over the part of a turn that a joint moved, near periods look alike: the search names one of them. Carried to another
//! part of the turn the wrong one is as bad as none. Where a joint has several lines, the model therefore has all
//! periods, each with the same small prior, which spreads what cannot be told apart. The size of that prior is chosen by
//! transfer: each joint's lowest and highest fifth of its angles, and the last fifth of the time, are held out whole.
//! Random folds hardly tell sizes apart, and evidence prefers one five times as large (docs/FIELD_RESULTS.md). A gear that has a few
//! lines and no more keeps them: held at the spectrum's small size they would be left to all other periods, which fill the gaps between
//! the rows with something else.

use crate::dataset::{Dataset, Twist};
use crate::design::Whitening;
use crate::effects::Candidate;
use crate::normal_equations::{JointLines, LINE_RAD, ModelColumns, NormalEquations};
use crate::search::ChosenCause;
use robot_model::robot::Axis;
use std::collections::{BTreeMap, BTreeSet};

/// A joint with so many lines has a spectrum; one or two stand for themselves.
const FEWEST_LINES: usize = 3;
/// Periods per turn that a spectrum goes up to; lines named beyond are in it too.
const HIGHEST: u32 = 80;
/// Prior standard deviations of a line that are tried, radians.
pub const SIZES_RAD: [f64; 6] = [1e-4, 3e-5, 1e-5, 3e-6, 1e-6, 3e-7];
/// Share of the stations held out at each end of a joint's range and of the time.
const SHARE: usize = 5;
/// Share of what the spectrum leaves where it was held out under which the lines by themselves are taken. They were chosen with those
/// stations, and look better there than they are: of a UR10 (docs/FIELD_RESULTS.md), without the lowest fifth of joint 1's angles, the many lines left 0.75 of what
/// the spectrum did, and 4.5 times as much in that fifth. Where a virtual gear had a few lines they left 0.25 to 0.66.
pub const LINES_LEAVE: f64 = 0.7;
/// More stations than this are thinned out while the size is chosen.
const MOST_STATIONS: usize = 3000;

/// The spectra of all joints whose gears have several lines among the causes.
#[must_use]
pub fn spectra(candidates: &[Candidate], chosen: &[ChosenCause]) -> Vec<JointLines> {
    let mut named: BTreeMap<Axis, BTreeSet<u32>> = BTreeMap::new();
    for variant in chosen.iter().map(|c| candidates[c.candidate].variant) {
        if let (Some(joint), Some(n)) = (variant.joint, variant.n) {
            named.entry(joint).or_default().insert(n);
        }
    }
    named.retain(|_, lines| lines.len() >= FEWEST_LINES);
    let all = |lines: BTreeSet<u32>| (1..=HIGHEST).chain(lines).collect::<BTreeSet<u32>>();
    let of_joint = |(joint, lines)| JointLines { joint, periods: all(lines).into_iter().collect() };
    named.into_iter().map(of_joint).collect()
}

/// Precision of every column: `geometry` and `causes` as given, lines by `size_rad`.
#[must_use]
pub fn precisions(
    columns: &ModelColumns<'_>,
    geometry: f64,
    causes: &[f64],
    sigma_m: f64,
    size_rad: f64,
) -> Vec<f64> {
    let mut all = vec![0.0; columns.registration().end];
    all.resize(columns.geometry().end, geometry);
    for (range, precision) in columns.of_causes().into_iter().zip(causes) {
        all.resize(range.end, *precision);
    }
    let line = (sigma_m * LINE_RAD / size_rad).powi(2);
    all.resize(columns.of_lines().last().map_or(all.len(), |r| r.end), line);
    all
}

/// The size of a line, of those given in falling order, that transfers best: least logarithm of the held-out errors, on average over
/// what is held out, and that average.
#[must_use]
pub fn transfer(
    columns: &ModelColumns<'_>,
    (residuals, outliers): (&[Twist], &[bool]),
    sizes_rad: &[f64],
    precisions_at: &dyn Fn(f64) -> Vec<f64>,
) -> (f64, f64) {
    let kept = thinned(columns.dataset);
    // Thinned out, each station stands for several.
    let factor = columns.dataset.observations.len() as f64 / kept.len().max(1) as f64;
    let whitening = Whitening {
        weights: columns.whitening.weights.iter().map(|w| w * factor).collect(),
        ..columns.whitening.clone()
    };
    let columns = ModelColumns {
        whitening: &whitening,
        causes: columns.causes.clone(),
        lines: columns.lines.clone(),
        ..*columns
    };
    let whole = columns.sum(&kept, residuals);
    let held: Vec<(Vec<usize>, NormalEquations)> = ends(columns.dataset, &kept)
        .into_iter()
        .map(|part| {
            let train = whole.without(&columns.sum(&part, residuals));
            (part.into_iter().filter(|&i| !outliers[i]).collect(), train)
        })
        .collect();
    let mut best = (f64::INFINITY, sizes_rad[0]);
    for &size_rad in sizes_rad {
        let precisions = precisions_at(size_rad);
        let left = |(part, train): &(Vec<usize>, NormalEquations)| {
            let solved = train.solve(&precisions)?.values;
            let squares = columns.squares_m2(part, residuals, &solved);
            let mean = squares.iter().sum::<f64>() / squares.len().max(1) as f64;
            Some(0.5 * mean.max(1e-18).ln())
        };
        let scores: Vec<f64> =
            parallel::map(held.len(), &|at| left(&held[at])).into_iter().flatten().collect();
        let score = scores.iter().sum::<f64>() / scores.len().max(1) as f64;
        if score > best.0 {
            // One valley: the first time it rises is its floor.
            break;
        }
        best = (score, size_rad);
    }
    best
}

/// Every so many-th station.
fn thinned(dataset: &Dataset) -> Vec<usize> {
    (0..dataset.observations.len())
        .step_by(dataset.observations.len().div_ceil(MOST_STATIONS).max(1))
        .collect()
}

/// Of `kept` the lowest and the highest fifth of each joint's angles, and the last fifth of the time.
fn ends(dataset: &Dataset, kept: &[usize]) -> Vec<Vec<usize>> {
    let count = kept.len() / SHARE;
    let sorted = |value: &dyn Fn(usize) -> f64| {
        let mut order = kept.to_vec();
        sorting::by(&mut order, |&a, &b| value(a).total_cmp(&value(b)).then(a.cmp(&b)));
        order
    };
    let mut parts = Vec::new();
    for j in dataset.turning() {
        let order = sorted(&|i| dataset.observations[i].q_rad[j]);
        parts.push(order[..count].to_vec());
        parts.push(order[order.len() - count..].to_vec());
    }
    if dataset.time_min.is_some() {
        let order = sorted(&|i| dataset.observations[i].clock());
        parts.push(order[order.len() - count..].to_vec());
    }
    parts.retain(|part| !part.is_empty());
    parts
}
