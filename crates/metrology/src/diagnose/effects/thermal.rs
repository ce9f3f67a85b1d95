//! What warm-up effects share: shapes in time or temperature.

use super::{Candidate, Form, NO_TIME, Scene};
use crate::diagnose::scene::Driver;

/// Time constants tried where only the time is known, minutes.
const TAUS_MIN: [f64; 6] = [8.0, 15.0, 30.0, 46.0, 80.0, 150.0];

/// Why warm-up cannot be seen.
pub(super) fn untestable(scene: &Scene) -> Option<String> {
    (scene.time_min.is_none() && scene.joint_temperature_c.is_none())
        .then(|| format!("{NO_TIME} and no joint temperatures"))
}

/// `candidate` in every shape that the data allow.
pub(super) fn shapes(scene: &Scene, candidate: &Candidate) -> Vec<Candidate> {
    let mut drivers = Vec::new();
    let warm =
        scene.joint_temperature_c.is_some_and(|ranges| ranges.iter().any(|[low, high]| high - low > 0.3));
    if warm {
        drivers.push((Driver::Temperature, 1.0));
    }
    if let Some([low, high]) = scene.time_min {
        for tau_min in TAUS_MIN {
            // A shape that has settled before the first station, or hardly begins, is a constant or a line.
            if tau_min > 0.1 * (high - low) && tau_min < 3.0 * high.max(1.0) || tau_min == 46.0 {
                drivers.push((Driver::Exponential { tau_min }, 1.0 / 12.0));
                drivers.push((Driver::TwoLags { tau_min }, 1.0 / 12.0));
            }
        }
    }
    drivers
        .into_iter()
        .map(|(driver, weight)| Candidate {
            form: Form { driver, ..candidate.form },
            weight: weight * candidate.weight,
            ..candidate.clone()
        })
        .collect()
}
