//! The stations that explanations are tried on, and what a registration of them leaves.

use crate::Station;
use crate::register::register_from_usual_starts;
use nalgebra::Isometry3;
use robot_model::kinematics::SerialChain;
use robot_model::robot::SerialArm;
use std::collections::BTreeSet;

/// Stations used for the trials.
const TRIAL_STATIONS: usize = 80;
/// Stations used where dozens of explanations are tried one after the other.
const FEW_STATIONS: usize = 30;

/// What most of the distances stay under, metres: their median, or their 80 % quantile over 2.5 where that is more. Of 3-D normal noise the
/// quantile is 1.4 medians, so that it counts only where a fifth of the rows and more is far off.
pub(super) fn most_m(off_m: &mut [f64]) -> f64 {
    sorting::numbers(off_m);
    let at = |share: f64| off_m.get((share * off_m.len() as f64) as usize).copied().unwrap_or(0.0);
    at(0.5).max(at(0.8) / 2.5)
}

/// A few stations from all over the file, at steps of the golden section: every n-th of poses that come round again could
/// be the same pose each time.
pub(super) fn trial(stations: &[Station]) -> Vec<Station> {
    spread(stations, TRIAL_STATIONS)
}

/// As [`trial`], for explanations that are tried by the dozen.
pub(super) fn few(stations: &[Station]) -> Vec<Station> {
    spread(stations, FEW_STATIONS)
}

fn spread(stations: &[Station], most: usize) -> Vec<Station> {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let n = stations.len();
    if n <= most {
        return stations.to_vec();
    }
    let picked: BTreeSet<usize> =
        (0..most).map(|k| ((k as f64 * GOLDEN).fract() * n as f64) as usize).collect();
    picked.into_iter().filter_map(|index| stations.get(index)).cloned().collect()
}

/// What registered `stations` leave.
pub(super) fn left_m(robot: &SerialArm, stations: &[Station], targets: usize) -> Option<f64> {
    let chain = SerialChain::nominal(robot);
    let poses: Vec<Isometry3<f64>> = stations.iter().map(|s| s.pose(&chain)).collect();
    most_left_m(stations, &poses, targets)
}

/// The same with the flange's poses given.
pub(super) fn most_left_m(stations: &[Station], poses: &[Isometry3<f64>], targets: usize) -> Option<f64> {
    let fit = register_from_usual_starts(stations, poses, targets, None).ok()?;
    let mut off_m: Vec<f64> =
        stations.iter().zip(poses).map(|(s, pose)| fit.residual_m(s, pose).norm()).collect();
    Some(most_m(&mut off_m))
}
