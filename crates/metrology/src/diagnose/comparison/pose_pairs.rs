//! Poses that were measured both times: which go together, and what their differences are as points and as a file.

use super::scale_change::PointPair;
use measurements::{Channels, MeasurementRow, Measurements, Reading, Registration, Station, Stations};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::Joints;

/// Joints this near are the same pose.
pub(super) const SAME_RAD: f64 = 3.5e-4;

/// A pose in both files.
pub(super) struct Pair<'a> {
    /// Its first station in the file before.
    pub(super) before: &'a Station,
    /// The one that is alike in the file after.
    pub(super) after: &'a Station,
    /// `base_from_flange` of the nominal arm.
    pub(super) flange: Isometry3<f64>,
}

/// Each station before with the first one after that is alike and free.
pub(super) fn paired<'a>(
    old: &'a Stations,
    new: &'a Stations,
    before: &Measurements,
    after: &Measurements,
    chain: &SerialChain,
) -> Vec<Pair<'a>> {
    let mut free: Vec<&Station> =
        new.stations.iter().filter(|s| matches!(s.reading, Reading::Point { .. })).collect();
    let mut pairs = Vec::new();
    for station in old.stations.iter().filter(|s| matches!(s.reading, Reading::Point { .. })) {
        let alike = |other: &&Station| {
            let same = |a: Option<Joints<i8>>, b: Option<Joints<i8>>| a.is_none() || b.is_none() || a == b;
            let load = |a: Option<f64>, b: Option<f64>| a.is_none() || b.is_none() || a == b;
            station.q_rad.iter().zip(&other.q_rad).all(|(a, b)| (a - b).abs() < SAME_RAD)
                && before.targets.get(station.target) == after.targets.get(other.target)
                && same(station.direction, other.direction)
                && load(station.payload_kg, other.payload_kg)
        };
        if let Some(at) = free.iter().position(alike) {
            let other = free.remove(at);
            pairs.push(Pair { before: station, after: other, flange: chain.forward(&station.q_rad) });
        }
    }
    pairs
}

/// What the points have moved by, each with where its target sat.
pub(super) fn point_pairs(pairs: &[Pair<'_>], was: &Registration, moved: &[Vector3<f64>]) -> Vec<PointPair> {
    let point = |(pair, moved_m): (&Pair<'_>, &Vector3<f64>)| PointPair {
        pose: pair.flange,
        tool_m: was.tools_m.get(pair.before.target).copied().unwrap_or_default(),
        target: pair.before.target,
        moved_m: *moved_m,
    };
    pairs.iter().zip(moved).map(point).collect()
}

/// The differences as a measurement file of their own: the nominal arm, and what has changed.
pub(super) fn as_measurements(pairs: &[Pair<'_>], shown: &[Station], before: &Measurements) -> Measurements {
    let rows: Vec<MeasurementRow> = pairs
        .iter()
        .zip(shown)
        .enumerate()
        .map(|(i, (pair, shown))| MeasurementRow {
            line: i as u64 + 2,
            id: None,
            pose_id: None,
            pose: pair.before.pose,
            target: pair.before.target,
            stand: 0,
            t_min: None,
            earlier_min: 0.0,
            q_rad: pair.before.q_rad,
            reading: shown.reading.clone(),
            orientation: None::<UnitQuaternion<f64>>,
            direction: pair.before.direction,
            payload_kg: pair.before.payload_kg,
            joint_temperature_c: None,
        })
        .collect();
    Measurements {
        channels: Channels {
            pose_id: true,
            direction: rows.iter().all(|r| r.direction.is_some()),
            payload: rows.iter().all(|r| r.payload_kg.is_some()),
            ..Channels::default()
        },
        rows,
        targets: before.targets.clone(),
        fixed_points: Vec::new(),
        joint_kinds: before.joint_kinds,
        joint_decimals: 9,
        warnings: Vec::new(),
    }
}
