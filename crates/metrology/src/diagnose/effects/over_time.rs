//! What effects that change over the measurement share: times at which a step may lie, how a drift may grow, and whether the arm stood
//! as its model says before.

use super::effect::{Candidate, EffectVariant};
use crate::diagnose::dataset::Dataset;
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
    let Some([from_min, to_min]) = dataset.clock else { return Vec::new() };
    let span_min = to_min - from_min;
    // Without times the measurement is taken to have lasted as long as most do.
    let hours = dataset.time_min.map_or(USUAL_HOURS, |_| h_from_min(span_min));
    let settling = |share: f64| Growth::Law(GrowthLaw::Exp { tau_min: share * span_min });
    let grown_m = 3e-5 * hours.clamp(0.5, 4.0);
    // What settles within half an hour does so in a twentieth of a long day, too.
    [
        (Growth::Linear { from_min, to_min }, 0.7),
        (settling(0.05), 0.05),
        (settling(0.15), 0.1),
        (settling(0.4), 0.15),
    ]
    .map(|(growth, weight)| DriftPrior { growth, weight, grown_m })
    .into()
}

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

/// Fewest visits on each side of a step: the three numbers of a target each are twice as many as a rigid motion has parameters. More targets
/// of one visit say the same once more.
const MIN_BESIDE_STEP: usize = 4;
/// Fewest between two steps: what two motions take between them may be one or two false readings.
const MIN_BETWEEN_STEPS: usize = 6;

/// Whether steps at two times are so near to each other that what lies between them may be false readings instead; `visits` by
/// [`visit_times`].
pub(crate) fn steps_too_near(visits: &[(f64, f64)], t0_min: f64, other_t0_min: f64) -> bool {
    let (low, high) = (t0_min.min(other_t0_min), t0_min.max(other_t0_min));
    let is_between = |(from, to): &(f64, f64)| low < *from && *to < high;
    let between = visits.iter().filter(|visit| is_between(visit)).count();
    0 < between && between < MIN_BETWEEN_STEPS
}

/// Times at which a step may lie.
pub(super) fn step_times(dataset: &Dataset) -> Vec<f64> {
    if dataset.clock.is_none() {
        return Vec::new();
    }
    let most = if dataset.observations.len() > LARGE_SET { MAX_STEP_TIMES / 3 } else { MAX_STEP_TIMES };
    gaps(visit_times(dataset), most, MIN_BESIDE_STEP)
}

/// When the first and the last target of each visit was read.
#[must_use]
pub(crate) fn visit_times(dataset: &Dataset) -> Vec<(f64, f64)> {
    let of_visit = |visit: &Vec<usize>| {
        let times = visit.iter().map(|&i| dataset.observations[i].clock());
        times.fold((f64::INFINITY, f64::NEG_INFINITY), |(from, to), t| (from.min(t), to.max(t)))
    };
    dataset.visits.iter().map(of_visit).collect()
}

/// As many as there are gaps in an ordinary set: a step that is put into the wrong gap leaves rows behind that look like
/// a second step.
const MAX_STEP_TIMES: usize = 240;
/// In a set of more observations than this every step tried costs too much memory and time.
const LARGE_SET: usize = 2000;

/// Middle times between visits, at most `most`, with `aside` visits or more on each side.
fn gaps(mut visits: Vec<(f64, f64)>, most: usize, aside: usize) -> Vec<f64> {
    visits.sort_by(|a, b| a.0.total_cmp(&b.0));
    if visits.len() < 2 * aside {
        return Vec::new();
    }
    let middles: Vec<f64> = visits
        .windows(2)
        .skip(aside - 1)
        .take(visits.len() + 1 - 2 * aside)
        .map(|w| (w[0].1, w[1].0))
        .filter(|(before, after)| after > before)
        .map(|(before, after)| 0.5 * (before + after))
        .collect();
    let step = middles.len().div_ceil(most).max(1);
    middles.into_iter().step_by(step).collect()
}

#[cfg(test)]
mod tests {
    use super::{EffectVariant, LARGE_SET, MAX_STEP_TIMES, changes, gaps};
    use crate::diagnose::dataset::evenly_spread;
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

    /// 150 observations a minute apart, in any order: every gap but the outer three.
    #[test]
    fn a_step_is_looked_for_in_every_gap_of_an_ordinary_set() {
        let visits: Vec<(f64, f64)> =
            (0..150).rev().map(|minute| (f64::from(minute), f64::from(minute))).collect();
        let expected: Vec<f64> = (3..146).map(|minute| f64::from(minute) + 0.5).collect();
        assert_eq!(gaps(visits.clone(), MAX_STEP_TIMES, 4), expected);
        assert_eq!(gaps(visits, 50, 4).len(), 48, "every third of 143");
        assert_eq!(gaps(vec![(1.0, 1.0); 9], 50, 4), Vec::<f64>::new(), "all at once");
        // Several targets at each stop, the last half a minute after the first: no step while the arm stands.
        let stops = (0..9).map(|minute| (f64::from(minute), f64::from(minute) + 0.5)).collect();
        assert_eq!(gaps(stops, 50, 4), [3.75, 4.75]);
    }
}
