//! What effects that change over the measurement share: times at which a step may lie, how a drift may grow, and whether the arm stood
//! as its model says before.

use super::effect::{Candidate, EffectVariant};
use crate::dataset::{Dataset, NUMBERS_OF_POINT};
use robot_model::deform::identified::Growth;
use robot_model::deform::{EffectKind, GrowthLaw};
use robot_model::units::h_from_min;

/// Why an effect of time cannot be seen.
pub(super) fn no_clock(dataset: &Dataset) -> Option<String> {
    dataset.clock.is_none().then(|| {
        "the file has no usable time (t_min), and repeats of its poses stand all over it, so that the order of the rows tells none".to_owned()
    })
}

/// How long a measurement without times is taken to have lasted.
const USUAL_HOURS: f64 = 2.0;

/// A way in which base or target may drift over a measurement.
pub(super) struct DriftPrior {
    /// How it grows over the measurement.
    pub growth: Growth,
    /// Prior weight beside the other ways.
    pub weight: f64,
    /// Prior standard deviation of a shift when it has grown, metres: 30 um per hour.
    pub grown_m: f64,
}

/// How base and target may drift over a measurement.
pub(super) fn drifts(dataset: &Dataset) -> Vec<DriftPrior> {
    let Some([from_min, to_min]) = dataset.time_min.or(dataset.clock) else { return Vec::new() };
    let span_min = to_min - from_min;
    // Without times the measurement is taken to have lasted as long as most do.
    let hours = dataset.time_min.map_or(USUAL_HOURS, |_| h_from_min(span_min));
    let settling = |share: f64| Growth::Law(GrowthLaw::Exp { tau_min: share * span_min });
    let grown_m = 3e-5 * hours.clamp(0.5, 4.0);
    // What settles within half an hour does so in a thirtieth of a long day, too.
    let settle = SETTLING_SHARES.map(|(share, weight)| (settling(share), weight));
    let all = std::iter::once((Growth::Linear { from_min, to_min }, 0.7)).chain(settle);
    all.map(|(growth, weight)| DriftPrior { growth, weight, grown_m }).collect()
}

/// Time constants with which base or target may settle, as shares of the whole measurement, and their prior weights: where the nearest is a half
/// off, what is left of a large drift looks like a step.
const SETTLING_SHARES: [(f64, f64); 7] =
    [(0.03, 0.03), (0.05, 0.03), (0.08, 0.03), (0.13, 0.05), (0.21, 0.05), (0.34, 0.06), (0.55, 0.05)];

/// The effect `kind` of a change over time, of these usual sizes: for an arm that stood as its model says before it changed, and for one that was
/// calibrated warm, or after a jump, and so has a constant beside it. In a large set with the constant alone: the variants without it cost memory, and
/// so many rows tell a constant of nothing.
pub(super) fn changes(
    dataset: &Dataset,
    kind: EffectKind,
    plain: EffectVariant,
    sizes: [f64; 2],
) -> impl Iterator<Item = Candidate> {
    let is_large = dataset.observations.len() > LARGE_SET;
    let variants = Candidate::without_and_with_constant(kind, plain, sizes).into_iter();
    variants.filter(move |candidate| candidate.variant.refined || !is_large)
}

/// Fewest numbers on each side of a step: twice as many as a rigid motion has parameters. Four points or touches have them, and twelve lengths.
const MIN_BESIDE_STEP: usize = 4 * NUMBERS_OF_POINT;
/// Fewest between two steps: what two motions take between them may be one or two false readings.
const MIN_BETWEEN_STEPS: usize = 6 * NUMBERS_OF_POINT;

/// Why a step cannot be seen.
pub(super) fn no_room_for_a_step(dataset: &Dataset) -> Option<String> {
    no_clock(dataset).or_else(|| {
        step_times(dataset).is_empty().then(|| {
            format!(
                "a step needs {} stops or {MIN_BESIDE_STEP} lengths before it and as many after it, at times that differ",
                MIN_BESIDE_STEP / NUMBERS_OF_POINT
            )
        })
    })
}

/// A stop of the arm, on the clock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StopTime {
    /// When the first of its readings was made: minutes or places in the file.
    from: f64,
    /// When the last was.
    to: f64,
    /// How many numbers it has for a motion of the whole arm, at most three.
    numbers: usize,
}

/// Whether steps at two times are so near to each other that what lies between them may be false readings instead; `stops` by
/// [`stop_times`].
pub fn steps_too_near(stops: &[StopTime], t0_min: f64, other_t0_min: f64) -> bool {
    let (low, high) = (t0_min.min(other_t0_min), t0_min.max(other_t0_min));
    let between = stops.iter().filter(|stop| low < stop.from && stop.to < high);
    (1..MIN_BETWEEN_STEPS).contains(&between.map(|stop| stop.numbers).sum())
}

/// Times at which a step may lie.
pub(super) fn step_times(dataset: &Dataset) -> Vec<f64> {
    if dataset.clock.is_none() {
        return Vec::new();
    }
    let most = if dataset.observations.len() > LARGE_SET { MAX_STEP_TIMES / 3 } else { MAX_STEP_TIMES };
    thinned(step_moments(dataset), most)
}

/// All moments at which a step may lie, in order: minutes or places in the file.
#[must_use]
pub fn step_moments(dataset: &Dataset) -> Vec<f64> {
    gaps(stop_times(dataset), MIN_BESIDE_STEP)
}

/// At most `most` of these, evenly.
fn thinned(moments: Vec<f64>, most: usize) -> Vec<f64> {
    let step = moments.len().div_ceil(most).max(1);
    moments.into_iter().step_by(step).collect()
}

/// When each stop's first and last reading was made.
#[must_use]
pub fn stop_times(dataset: &Dataset) -> Vec<StopTime> {
    let of_stop = |stop: &Vec<usize>| {
        let times = stop.iter().map(|&i| dataset.observations[i].clock());
        let (from, to) =
            times.fold((f64::INFINITY, f64::NEG_INFINITY), |(from, to), t| (from.min(t), to.max(t)));
        StopTime { from, to, numbers: dataset.numbers(stop) }
    };
    dataset.stops.iter().map(of_stop).collect()
}

/// As many as there are gaps in an ordinary set; in larger ones the gaps near a step that is found are tried then.
const MAX_STEP_TIMES: usize = 240;
/// In a set of more observations than this every step tried costs too much memory and time.
const LARGE_SET: usize = 2000;

/// Middle times between stops with so many numbers or more `aside`, before and after.
fn gaps(mut stops: Vec<StopTime>, aside: usize) -> Vec<f64> {
    sorting::by(&mut stops, |a, b| a.from.total_cmp(&b.from));
    let all: usize = stops.iter().map(|stop| stop.numbers).sum();
    let mut before = 0;
    stops
        .windows(2)
        .filter(|pair| {
            before += pair[0].numbers;
            before >= aside && all - before >= aside && pair[1].from > pair[0].to
        })
        .map(|pair| 0.5 * (pair[0].to + pair[1].from))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{EffectVariant, LARGE_SET, MAX_STEP_TIMES, StopTime, changes, gaps, steps_too_near, thinned};
    use crate::dataset::evenly_spread;
    use robot_model::deform::EffectKind;

    /// Half of the prior each, the size that is reported the change's; a large set has the second alone.
    #[test]
    fn a_change_is_weighed_with_and_without_a_constant() {
        for (stations, expected) in
            [(60, vec![(1, false, 0.5), (2, true, 0.5)]), (LARGE_SET + 1, vec![(2, true, 0.5)])]
        {
            let dataset = evenly_spread(stations);
            let variants = changes(&dataset, EffectKind::JointStep, EffectVariant::of_joint(2), [1e-4, 3e-4]);
            let variants: Vec<_> = variants
                .inspect(|c| assert!(c.prior_sigma[0] == 1e-4 && c.n_reported == 1))
                .map(|c| (c.prior_sigma.len(), c.variant.refined, c.weight))
                .collect();
            assert_eq!(variants, expected);
        }
    }

    /// A stop of so many numbers.
    fn stop(from: f64, to: f64, numbers: usize) -> StopTime {
        StopTime { from, to, numbers }
    }

    /// 150 observations a minute apart, in any order: every gap but the outer three.
    #[test]
    fn a_step_is_looked_for_in_every_gap_of_an_ordinary_set() {
        let at = |minute: f64| stop(minute, minute, 3);
        let stops: Vec<StopTime> = (0..150).rev().map(|minute| at(f64::from(minute))).collect();
        let expected: Vec<f64> = (3..146).map(|minute| f64::from(minute) + 0.5).collect();
        assert_eq!(thinned(gaps(stops.clone(), 12), MAX_STEP_TIMES), expected);
        assert_eq!(thinned(gaps(stops, 12), 50).len(), 48, "every third of 143");
        assert_eq!(gaps(vec![at(1.0); 9], 12), Vec::<f64>::new(), "all at once");
        // Several targets at each stop, the last half a minute after the first: no step while the arm stands.
        let stops = (0..9).map(|minute| stop(minute.into(), f64::from(minute) + 0.5, 3)).collect();
        assert_eq!(gaps(stops, 12), [3.75, 4.75]);
    }

    /// Lengths of a wire, a minute apart: twelve on each side of a step, and eighteen between two.
    #[test]
    fn a_step_needs_three_lengths_for_a_point() {
        let lengths: Vec<StopTime> = (0..26).map(|minute| stop(minute.into(), minute.into(), 1)).collect();
        assert_eq!(gaps(lengths.clone(), 12), [11.5, 12.5, 13.5]);
        assert!(steps_too_near(&lengths, 3.5, 20.5), "seventeen");
        assert!(!steps_too_near(&lengths, 3.5, 21.5) && !steps_too_near(&lengths, 3.5, 3.7));
    }
}
