//! Poses that were measured both times: which go together, and what their differences are as points and as a file.

use super::scale_change::PointPair;
use measurements::{Channels, MeasurementRow, Measurements, Reading, Registration, Station, Stations};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::Joints;
use std::collections::BTreeSet;

/// Joints this near are the same pose.
pub(super) const SAME_RAD: f64 = 3.5e-4;

/// A pose in both files.
pub(super) struct Pair {
    /// Its first station in the file before, its target counted among those that were measured both times.
    pub(super) before: Station,
    /// The one that is alike in the file after, of the same target.
    pub(super) after: Station,
    /// `base_from_flange` of the nominal arm before.
    pub(super) flange: Isometry3<f64>,
    /// The same after: joints that encoders read differ by what a point may move.
    pub(super) flange_after: Isometry3<f64>,
}

/// Poses in both files.
pub(super) struct Pairs {
    /// In the order of the file before.
    pub(super) all: Vec<Pair>,
    /// Names of the targets that were measured both times.
    pub(super) targets: Vec<String>,
}

/// Each station before with the first one after that is alike and free. A target that one file alone has is none of theirs: nothing would
/// say where it was the other time.
pub(super) fn paired(
    old: &Stations,
    new: &Stations,
    before: &Measurements,
    after: &Measurements,
    chain: &SerialChain,
) -> Pairs {
    let mut free: Vec<&Station> =
        new.stations.iter().filter(|s| matches!(s.reading, Reading::Point { .. })).collect();
    let mut found: Vec<(&Station, &Station)> = Vec::new();
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
            found.push((station, free.remove(at)));
        }
    }
    let targets: BTreeSet<usize> = found.iter().map(|(station, _)| station.target).collect();
    let numbered = |station: &Station, target| Station { target, ..station.clone() };
    let pair = |(station, other): (&Station, &Station)| {
        let target = targets.range(..station.target).count();
        Pair {
            before: numbered(station, target),
            after: numbered(other, target),
            flange: chain.forward(&station.q_rad),
            flange_after: chain.forward(&other.q_rad),
        }
    };
    let name = |target: &usize| before.targets.get(*target).cloned().unwrap_or_default();
    Pairs { all: found.into_iter().map(pair).collect(), targets: targets.iter().map(name).collect() }
}

/// Line of the first row of a station of `file`.
pub(super) fn first_line(file: &Measurements, station: &Station) -> u64 {
    station.rows.first().and_then(|&row| file.rows.get(row)).map_or(0, |row| row.line)
}

/// What the points have moved by, each with where its target sat.
pub(super) fn point_pairs(pairs: &[Pair], was: &Registration, moved: &[Vector3<f64>]) -> Vec<PointPair> {
    let point = |(pair, moved_m): (&Pair, &Vector3<f64>)| PointPair {
        pose: pair.flange,
        tool_m: was.tools_m.get(pair.before.target).copied().unwrap_or_default(),
        target: pair.before.target,
        moved_m: *moved_m,
    };
    pairs.iter().zip(moved).map(point).collect()
}

/// The differences as a measurement file of their own: the nominal arm, and what has changed. Its lines are those of the file `before`.
pub(super) fn as_measurements(pairs: &Pairs, shown: &[Station], before: &Measurements) -> Measurements {
    let rows: Vec<MeasurementRow> = pairs
        .all
        .iter()
        .zip(shown)
        .map(|(pair, shown)| MeasurementRow {
            line: first_line(before, &pair.before),
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
        targets: pairs.targets.clone(),
        fixed_points: Vec::new(),
        joint_kinds: before.joint_kinds,
        warnings: Vec::new(),
    }
}
