//! What warm-up effects share: growth with time or with the joints' temperatures.

use super::effect::{Candidate, EffectVariant};
use super::over_time::no_clock;
use crate::dataset::Dataset;
use robot_model::deform::GrowthLaw;
use robot_model::deform::identified::Growth;
use robot_model::robot::Joints;

/// Time constants tried where only the time is known, minutes.
const TAUS_MIN: [f64; 6] = [8.0, 15.0, 30.0, 46.0, 80.0, 150.0];

/// Without minutes: time constants tried, as shares of the file.
const ROW_SHARES: [f64; 4] = [0.1, 0.25, 0.6, 1.5];

/// Joints that all warm by less than this say nothing of warm-up, K.
const LEAST_RISE_K: f64 = 0.3;

/// Why warm-up cannot be seen; `None` where it can.
pub(super) fn untestable(dataset: &Dataset) -> Option<String> {
    no_clock(dataset)
        .filter(|_| dataset.joint_temperature_c.is_none())
        .map(|why| format!("{why}; and there are no joint temperatures"))
}

/// `candidate` with every growth that the data allow.
pub(super) fn growths(dataset: &Dataset, candidate: &Candidate) -> Vec<Candidate> {
    let mut growths = Vec::new();
    let warms = |ranges: &Joints<[f64; 2]>| ranges.iter().any(|[low, high]| high - low > LEAST_RISE_K);
    if let Some(ranges) = dataset.joint_temperature_c.filter(warms) {
        growths.push((Growth::Temperature { from_c: ranges.map(|r| r[0]), to_c: ranges.map(|r| r[1]) }, 1.0));
    }
    if let Some([low, high]) = dataset.time_min {
        for tau_min in TAUS_MIN {
            // A shape that has settled before the first observation, or hardly begins, is a constant or a line.
            if tau_min > 0.1 * (high - low) && tau_min < 3.0 * high.max(1.0) || tau_min == 46.0 {
                growths.push((Growth::Law(GrowthLaw::Exp { tau_min }), 1.0 / 12.0));
                growths.push((Growth::Law(GrowthLaw::TwoStage { tau_min }), 1.0 / 12.0));
            }
        }
    }
    if let (None, Some([low, high])) = (dataset.time_min, dataset.clock) {
        // No minutes: shapes of warm-up over the file, whatever its pace.
        for share in ROW_SHARES {
            let tau_min = share * (high - low);
            growths.push((Growth::Law(GrowthLaw::Exp { tau_min }), 0.5 / ROW_SHARES.len() as f64));
            growths.push((Growth::Law(GrowthLaw::TwoStage { tau_min }), 0.5 / ROW_SHARES.len() as f64));
        }
    }
    growths
        .into_iter()
        .map(|(growth, weight)| Candidate {
            variant: EffectVariant { growth, ..candidate.variant },
            weight: weight * candidate.weight,
            ..candidate.clone()
        })
        .collect()
}
