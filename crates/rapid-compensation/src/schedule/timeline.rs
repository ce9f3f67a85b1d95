//! The minutes that drift is straight between, and when it is over.

use super::choose::ScheduleError;
use super::curve::{Curve, horizon_min};
use super::drift::{Drift, Moment};

/// Targets that are taken in one after the other before all are.
const MAX_ROUNDS: usize = 16;

/// When some targets drift: minutes so close that the drift is straight between them, and when it is over.
#[derive(Clone, Debug, PartialEq)]
pub struct Timeline {
    /// Minutes, ascending, from 0; at the last of them everything has settled.
    pub at_min: Vec<f64>,
    /// From here on what is still to come is under the tolerance.
    pub until_min: f64,
}

impl Timeline {
    /// Its minutes as moments.
    pub fn moments(&self) -> impl Iterator<Item = Moment> + '_ {
        let last = self.at_min.len().saturating_sub(1);
        self.at_min
            .iter()
            .enumerate()
            .map(move |(k, &t)| if k == last { Moment::Settled } else { Moment::Minute(t) })
    }
}

/// The timeline of `targets`: straight to `sag_m` between its minutes, settled to `tolerance_m` at its end.
///
/// # Errors
/// [`ScheduleError::NeverSettles`].
pub fn timeline(
    drift: &dyn Drift,
    targets: &[usize],
    sag_m: f64,
    tolerance_m: f64,
) -> Result<Timeline, ScheduleError> {
    if targets.is_empty() {
        return Ok(Timeline { at_min: vec![0.0], until_min: 0.0 });
    }
    let (displacements_m, knots_min) = (drift.displacements_m(targets), drift.knots_min());
    let horizon_min = horizon_min(&displacements_m, knots_min, sag_m).ok_or(ScheduleError::NeverSettles)?;
    let curve = Curve::sample(&displacements_m, knots_min, horizon_min, sag_m);
    Ok(Timeline { until_min: curve.settles_within(tolerance_m), at_min: curve.into_minutes(sag_m) })
}

/// The same for all targets where one law lets them drift: each goes its share of its own way at the same time, so the one with
/// the longest way bends most and settles last. That every other has settled by then is looked at, and who has not is taken in.
///
/// # Errors
/// As [`timeline`].
pub fn timeline_of_one_law(
    drift: &dyn Drift,
    sag_m: f64,
    tolerance_m: f64,
) -> Result<Timeline, ScheduleError> {
    let furthest = |from: Moment| {
        let found = drift.furthest(&[(from, Moment::Settled)]).first().copied();
        found.filter(|(target, _)| *target < drift.targets())
    };
    let mut active: Vec<usize> = furthest(Moment::Minute(0.0)).iter().map(|(target, _)| *target).collect();
    for _ in 0..MAX_ROUNDS {
        let found = timeline(drift, &active, sag_m, tolerance_m)?;
        match furthest(Moment::Minute(found.until_min)) {
            Some((target, rest_m)) if rest_m > tolerance_m && !active.contains(&target) => {
                active.push(target);
            }
            _ => return Ok(found),
        }
    }
    timeline(drift, &(0..drift.targets()).collect::<Vec<usize>>(), sag_m, tolerance_m)
}
