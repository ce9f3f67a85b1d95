//! When a step is likely to lie: between any two rows alike, and in a pause the likelier the longer it is.

use super::effect::Candidate;
use crate::dataset::Dataset;
use robot_model::deform::identified::Growth;

/// Share of the prior that goes by rows; the rest goes by the time between them. Things are knocked while somebody measures, and overnight.
const BY_ROWS: f64 = 0.5;

/// Prior density of a step's moment over the gaps between rows.
pub(super) struct StepMoment {
    /// The moments of rows, each once, in order: minutes or places in the file.
    moments: Vec<f64>,
}

impl StepMoment {
    pub(super) fn new(dataset: &Dataset) -> Self {
        let mut moments: Vec<f64> = dataset.observations.iter().map(|o| o.clock()).collect();
        sorting::numbers(&mut moments);
        moments.dedup();
        Self { moments }
    }

    /// Weights a variant that steps by the gap in which it does, over what gaps have in the mean.
    pub(super) fn weigh(&self, candidate: &mut Candidate) {
        if let Growth::Step { t0_min } = candidate.variant.growth {
            candidate.weight *= self.weight(t0_min);
        }
    }

    fn weight(&self, t0_min: f64) -> f64 {
        let behind = self.moments.partition_point(|moment| *moment < t0_min);
        let around = behind.checked_sub(1).and_then(|before| self.moments.get(before..=behind));
        let (Some([before, after]), Some(first), Some(last)) =
            (around, self.moments.first(), self.moments.last())
        else {
            return 1.0;
        };
        let gaps = (self.moments.len() - 1) as f64;
        BY_ROWS + (1.0 - BY_ROWS) * gaps * (after - before) / (last - first)
    }
}

#[cfg(test)]
mod tests {
    use super::StepMoment;

    /// Thirty rows a minute apart on each of two days, a night of 1400 minutes between them: of 59 gaps the night's has half of a
    /// fifty-ninth, and half of 1400 / 1458 of all.
    #[test]
    fn a_night_is_likelier_than_a_minute() {
        let day = |from: f64| (0..30).map(move |minute| from + f64::from(minute));
        let moment = StepMoment { moments: day(0.0).chain(day(1429.0)).collect() };
        let night = 59.0 * (0.5 / 59.0 + 0.5 * 1400.0 / 1458.0);
        assert!((moment.weight(729.0) - night).abs() < 1e-12);
        let minute = 59.0 * (0.5 / 59.0 + 0.5 / 1458.0);
        assert!((moment.weight(10.5) - minute).abs() < 1e-12);
        assert!((night + 58.0 * minute - 59.0).abs() < 1e-9, "all together what they had");
    }
}
