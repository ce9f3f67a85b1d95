//! One of several targets on the flange that was knocked: it shows between the targets of one visit, whatever the arm does.

use super::far_rows::PosedRow;
use crate::{Reading, Registration, Standing, Station, register};
use nalgebra::{Isometry3, Matrix3, Vector3};
use robot_model::units::mm_from_m;
use statistics::median;

/// Fewer visits before or after the knock tell no place.
const FEWEST_VISITS: usize = 4;
/// A target that was moved by more is another one, or its column is, metres.
const FURTHEST_M: f64 = 0.03;
/// How much likelier the knock must make the readings than nothing, and than anything else that could have moved the targets, nats.
const CLEAR_NATS: f64 = 25.0;
const APART_NATS: f64 = 8.0;
/// Visits around one that say what it should be like.
const NEIGHBOURS: usize = 2;
/// Further from these than so many times the middle visit is a false reading.
const FALSE_TIMES: f64 = 6.0;

/// A target that sits elsewhere from a row on while the others sit where they sat.
#[derive(Clone, Debug, PartialEq)]
pub struct MovedTarget {
    /// Which one, as the file numbers them; `None` where there are two, of which either may have moved.
    pub target: Option<usize>,
    /// The first row after it moved, as an index into the rows.
    pub from: usize,
    /// How far it has moved beside the others, metres.
    pub by_m: f64,
}

/// Rows of one pose, one after the other, that have each target once.
struct Visit {
    /// For each target, as the file numbers them, its row.
    rows: Vec<usize>,
    /// For each target how far it is from its place on the flange, beside what all share, metres in the flange's frame.
    off_m: Vec<Vector3<f64>>,
}

/// Looks for a target that was knocked; `as_named`: for each row the target that the file names.
///
/// Within a visit the mean over its targets is taken off, and with it where the arm stood; what is left is least squares with one step,
/// tried for each target at each visit, against a turn of all of them on the flange.
#[must_use]
pub fn find_moved_target(rows: &[PosedRow], as_named: &[usize], targets: usize) -> Option<MovedTarget> {
    let named = as_named.iter().max()? + 1;
    if named < 2 {
        return None;
    }
    let stations: Vec<Station> = rows.iter().map(|row| row.station.clone()).collect();
    let poses: Vec<Isometry3<f64>> = rows.iter().map(|row| row.pose).collect();
    let registration = register(&stations, &poses, targets, None).ok()?;
    let visits = without_false_ones(visits(rows, as_named, named, &registration));
    let steps = Steps::new(&visits, &tools_m(&visits, rows, &registration))?;
    steps.knock(&visits)
}

/// Whole visits of all targets, each target about its own middle.
fn visits(rows: &[PosedRow], as_named: &[usize], named: usize, registration: &Registration) -> Vec<Visit> {
    let off_m = |i: &usize| {
        let PosedRow { station, pose } = &rows[*i];
        let seen_m = registration.seen_on_flange_m(station, pose)?;
        matches!(station.reading, Reading::Point { .. })
            .then_some(seen_m - registration.tools_m.get(station.target)?)
    };
    let mut all = Vec::new();
    let mut open: Vec<Option<usize>> = vec![None; named];
    let mut before: Option<Standing<'_>> = None;
    for (i, (row, &target)) in rows.iter().zip(as_named).enumerate() {
        let standing = Standing { q_rad: &row.station.q_rad, t_min: row.station.clock_min() };
        if !before.is_some_and(|before| before.may_be(&standing)) || open[target].is_some() {
            open = vec![None; named];
        }
        before = Some(standing);
        open[target] = Some(i);
        if let Some(rows) = open.iter().copied().collect::<Option<Vec<usize>>>() {
            if let Some(off_m) = rows.iter().map(off_m).collect::<Option<Vec<_>>>() {
                all.push(Visit { rows, off_m });
            }
            open = vec![None; named];
        }
    }
    for visit in &mut all {
        beside_mean(&mut visit.off_m);
    }
    all
}

/// Each without the mean of all.
fn beside_mean(off_m: &mut [Vector3<f64>]) {
    let mean = off_m.iter().sum::<Vector3<f64>>() / off_m.len().max(1) as f64;
    off_m.iter_mut().for_each(|off| *off -= mean);
}

/// Without visits that are unlike those around them: a step is like those on its side.
fn without_false_ones(visits: Vec<Visit>) -> Vec<Visit> {
    let around = |i: usize| {
        let last = visits.len().saturating_sub(1);
        let here = i.saturating_sub(NEIGHBOURS)..=(i + NEIGHBOURS).min(last);
        let middle = |target: usize, axis: usize| {
            let mut values: Vec<f64> = visits[here.clone()].iter().map(|v| v.off_m[target][axis]).collect();
            median(&mut values)
        };
        let off = |(target, at): (usize, &Vector3<f64>)| {
            (0..3).map(|a| (at[a] - middle(target, a)).powi(2)).sum::<f64>()
        };
        visits[i].off_m.iter().enumerate().map(off).sum::<f64>().sqrt()
    };
    let unlike_m: Vec<f64> = (0..visits.len()).map(around).collect();
    let limit_m = FALSE_TIMES * median(&mut unlike_m.clone());
    visits
        .into_iter()
        .zip(unlike_m)
        .filter(|(_, unlike_m)| *unlike_m <= limit_m)
        .map(|(visit, _)| visit)
        .collect()
}

/// Where each target sits on the flange beside the middle of them, metres.
fn tools_m(visits: &[Visit], rows: &[PosedRow], registration: &Registration) -> Vec<Vector3<f64>> {
    let of_visit = |visit: &Visit| -> Vec<Vector3<f64>> {
        let place =
            |&i: &usize| registration.tools_m.get(rows[i].station.target).copied().unwrap_or_default();
        visit.rows.iter().map(place).collect()
    };
    let mut tools_m = visits.first().map(of_visit).unwrap_or_default();
    beside_mean(&mut tools_m);
    tools_m
}

/// What one step at each visit takes of the squares, metres².
struct Steps {
    /// By visit that it begins with: for each target its sum from there on, and what a turn of all on the flange takes.
    at: Vec<(Vec<Vector3<f64>>, f64)>,
    /// The sum of all squares.
    all_m2: f64,
    targets: usize,
}

impl Steps {
    fn new(visits: &[Visit], tools_m: &[Vector3<f64>]) -> Option<Self> {
        let (n, targets) = (visits.len(), tools_m.len());
        if n < 2 * FEWEST_VISITS {
            return None;
        }
        let mean = |t: usize| visits.iter().map(|v| v.off_m[t]).sum::<Vector3<f64>>() / n as f64;
        let means: Vec<Vector3<f64>> = (0..targets).map(mean).collect();
        let off = |i: usize, t: usize| visits[i].off_m[t] - means[t];
        let all_m2 = (0..n)
            .flat_map(|i| (0..targets).map(move |t| (i, t)))
            .map(|(i, t)| off(i, t).norm_squared())
            .sum();
        // The turning inertia of the targets: what a turn moves them by.
        let inertia = tools_m
            .iter()
            .map(|t| Matrix3::identity() * t.norm_squared() - t * t.transpose())
            .sum::<Matrix3<f64>>();
        let inverse = inertia.pseudo_inverse(1e-3 * inertia.norm()).ok()?;
        let mut sums = vec![Vector3::zeros(); targets];
        let mut at = vec![(sums.clone(), 0.0); n];
        for i in (0..n).rev() {
            for (t, sum) in sums.iter_mut().enumerate() {
                *sum += off(i, t);
            }
            let turning: Vector3<f64> = tools_m.iter().zip(&sums).map(|(tool, sum)| tool.cross(sum)).sum();
            let turned_m2 = (turning.transpose() * inverse * turning).x / share(i, n).max(f64::MIN_POSITIVE);
            at[i] = (sums.clone(), turned_m2);
        }
        Some(Self { at, all_m2, targets })
    }

    /// What a step of target `t` alone that begins at visit `i` takes.
    fn alone_m2(&self, i: usize, t: usize) -> f64 {
        self.at[i].0[t].norm_squared() / (share(i, self.at.len()) * self.of_one())
    }

    /// The square that a unit step of one target keeps beside the mean of all.
    fn of_one(&self) -> f64 {
        1.0 - 1.0 / self.targets as f64
    }

    fn knock(&self, visits: &[Visit]) -> Option<MovedTarget> {
        let n = self.at.len();
        let places = || FEWEST_VISITS..=n - FEWEST_VISITS;
        let best_of = |t: usize| {
            let each = places().map(|i| (self.alone_m2(i, t), i));
            each.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(m2, i)| (m2, i, t))
        };
        let mut best: Vec<(f64, usize, usize)> = (0..self.targets).filter_map(best_of).collect();
        sorting::by(&mut best, |a, b| b.0.total_cmp(&a.0));
        let (taken_m2, i, t) = *best.first()?;
        let turned_m2 = places().map(|i| self.at[i].1).fold(0.0, f64::max);
        // Of two it is the distance between them that has changed.
        let other_m2 = if self.targets > 2 { best.get(1)?.0 } else { 0.0 };
        let free = (3 * (n - 1) * (self.targets - 1)) as f64;
        let variance_m2 = (self.all_m2 - taken_m2) / free;
        let nats = |m2: f64| 0.5 * m2 / variance_m2;
        let by_m = self.at[i].0[t].norm() / (share(i, n) * self.of_one());
        let is_clear = nats(taken_m2) > CLEAR_NATS + ((n * self.targets) as f64).ln()
            && nats(taken_m2 - turned_m2.max(other_m2)) > APART_NATS
            && by_m < FURTHEST_M;
        let target = (self.targets > 2).then_some(t);
        let from =
            target.map_or_else(|| visits[i].rows.iter().min().copied(), |t| visits[i].rows.get(t).copied());
        is_clear.then_some(MovedTarget { target, from: from?, by_m })
    }
}

/// The square sum of a step without its mean that begins at visit `i` of `n`.
fn share(i: usize, n: usize) -> f64 {
    (i * (n - i)) as f64 / n as f64
}

/// Which target moved and by how much, in words; `line`: the first where it has.
#[must_use]
pub fn describe_knock(name: &str, by_m: f64, line: u64) -> String {
    format!(
        "from line {line} on {name} sits {:.2} mm from where it sat before, beside the other targets: it is taken as another target there",
        mm_from_m(by_m)
    )
}
