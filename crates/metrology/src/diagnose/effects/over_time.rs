//! What effects that change over the measurement share: times at which a step may lie, and how a drift may grow.

use crate::diagnose::dataset::Dataset;
use robot_model::deform::GrowthLaw;
use robot_model::deform::identified::Growth;
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
    [(Growth::Linear { from_min, to_min }, 0.7), (settling(0.15), 0.1), (settling(0.4), 0.2)]
        .map(|(growth, weight)| DriftPrior { growth, weight, grown_m })
        .into()
}

/// Fewest observations on each side of a step: their three numbers each are twice as many as a rigid motion has parameters.
const MIN_BESIDE_STEP: usize = 4;
/// Fewest between two steps: what two motions take between them may be one or two false readings.
const MIN_BETWEEN_STEPS: usize = 6;

/// Whether steps at two times are so near to each other that what lies between them may be false readings instead.
pub(crate) fn steps_too_near(dataset: &Dataset, t0_min: f64, other_t0_min: f64) -> bool {
    let (low, high) = (t0_min.min(other_t0_min), t0_min.max(other_t0_min));
    let between = dataset.observations.iter().map(|s| s.clock()).filter(|t| low < *t && *t < high).count();
    0 < between && between < MIN_BETWEEN_STEPS
}

/// Times at which a step may lie.
pub(super) fn step_times(dataset: &Dataset) -> Vec<f64> {
    if dataset.clock.is_none() {
        return Vec::new();
    }
    let times: Vec<f64> = dataset.observations.iter().map(|s| s.clock()).collect();
    let most = if times.len() > LARGE_SET { MAX_STEP_TIMES / 3 } else { MAX_STEP_TIMES };
    gaps(times, most, MIN_BESIDE_STEP)
}

/// As many as there are gaps in an ordinary set: a step that is put into the wrong gap leaves rows behind that look like
/// a second step.
const MAX_STEP_TIMES: usize = 240;
/// In a set of more observations than this every step tried costs too much memory and time.
const LARGE_SET: usize = 2000;

/// Middle times between observations, at most `most`, with `aside` observations or more on each side.
fn gaps(mut times: Vec<f64>, most: usize, aside: usize) -> Vec<f64> {
    times.sort_by(f64::total_cmp);
    if times.len() < 2 * aside {
        return Vec::new();
    }
    let middles: Vec<f64> = times
        .windows(2)
        .skip(aside - 1)
        .take(times.len() + 1 - 2 * aside)
        .filter(|w| w[1] > w[0])
        .map(|w| 0.5 * (w[0] + w[1]))
        .collect();
    let step = middles.len().div_ceil(most).max(1);
    middles.into_iter().step_by(step).collect()
}

#[cfg(test)]
mod tests {
    use super::{MAX_STEP_TIMES, gaps};

    /// 150 observations a minute apart, in any order: every gap but the outer three.
    #[test]
    fn a_step_is_looked_for_in_every_gap_of_an_ordinary_set() {
        let times: Vec<f64> = (0..150).rev().map(f64::from).collect();
        let expected: Vec<f64> = (3..146).map(|minute| f64::from(minute) + 0.5).collect();
        assert_eq!(gaps(times.clone(), MAX_STEP_TIMES, 4), expected);
        assert_eq!(gaps(times, 50, 4).len(), 48, "every third of 143");
        assert_eq!(gaps(vec![1.0; 9], 50, 4), Vec::<f64>::new(), "all at once");
    }
}
