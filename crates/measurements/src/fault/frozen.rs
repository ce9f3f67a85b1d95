//! Joint columns that stand still in rows in which the arm moved: a read-back that hung, a column that was filled down.

use super::{Fault, FaultKind};
use crate::{MeasurementRow, Registration, Station};
use nalgebra::{Isometry3, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Axis, SerialArm};
use std::collections::BTreeMap;

/// Points at the same joints further from each other than this are no repeats, metres: noise, play and what a pose repeats by are less.
const APART_M: f64 = 2e-3;
/// So many of them in a row are no single knock.
const FEWEST: usize = 3;
/// Angles of a turn at which a joint is tried, before the best is narrowed down.
const STARTS: usize = 36;
/// Steps of the golden section, each to 0.618 of the last: from 20 deg to under 1e-6 deg.
const NARROWINGS: usize = 36;
/// What a joint without a range is tried over: half a turn, or so many metres, to either side.
const FREE: f64 = std::f64::consts::PI;
/// Rounds of registration and of the joint's angles in turn.
const ROUNDS: usize = 40;

/// Rows after one another in which all joints are the same to the last digit though the points lie apart.
pub(super) fn all_joints(rows: &[&MeasurementRow], robot: &SerialArm) -> Option<Fault> {
    let rows: Vec<&MeasurementRow> = rows.iter().copied().filter(|row| row.reading.involves_arm()).collect();
    let runs = rows.chunk_by(|a, b| a.q_rad.map(f64::to_bits) == b.q_rad.map(f64::to_bits));
    let moved = runs.filter(|run| {
        let mut apart: BTreeMap<usize, Vec<Vector3<f64>>> = BTreeMap::new();
        for row in *run {
            let Some(point_m) = row.reading.position_m() else { continue };
            let known = apart.entry(row.target).or_default();
            if known.iter().all(|other_m| (other_m - point_m).norm() > APART_M) {
                known.push(point_m);
            }
        }
        apart.values().any(|points| points.len() >= FEWEST)
    });
    let lines: Vec<u64> = moved.flatten().map(|row| row.line).collect();
    (!lines.is_empty()).then(|| {
        let columns = robot.columns();
        Fault::in_rows(FaultKind::FrozenJoints, &columns.clone(), lines, |count, which| {
            format!(
                "in {count} rows ({which}) all joints stand still to the last digit while the points lie apart: {columns} were not read anew (or the rows saw \
                 several targets: column target)"
            )
        })
    })
}

/// Where joint `j` must have stood for `station` to see what it saw, and what that leaves.
pub(super) struct Refitted {
    /// Angle, radians; metres where the joint slides.
    pub(super) q_rad: f64,
    /// What is left, metres.
    pub(super) off_m: f64,
}

/// Joint `j` at the place in its range that leaves least of `station` under `registration`.
pub(super) fn refitted(
    robot: &SerialArm,
    chain: &SerialChain,
    registration: &Registration,
    station: &Station,
    j: usize,
) -> Refitted {
    let mut at = station.clone();
    let mut off_m = |q_rad: f64| {
        at.q_rad[j] = q_rad;
        registration.residual_m(&at, &at.pose(chain)).norm()
    };
    let [low, high] = robot.joints[j].range_rad.unwrap_or([-FREE, FREE]);
    let step = (high - low) / STARTS as f64;
    let starts = (0..=STARTS).map(|k| low + step * k as f64);
    let tried = starts.map(|q_rad| (q_rad, off_m(q_rad)));
    let (middle, _) =
        tried.reduce(|best, next| if next.1 < best.1 { next } else { best }).unwrap_or((low, 0.0));
    // Beyond its end the joint cannot have stood, however well the point would fit there.
    let around = [(middle - step).max(low), (middle + step).min(high)];
    let q_rad = narrowed(around, NARROWINGS, &mut off_m);
    Refitted { q_rad, off_m: off_m(q_rad) }
}

/// Where `off_m` is least between two places, by so many `steps` of the golden section (Kiefer 1953).
pub(super) fn narrowed(
    [mut low, mut high]: [f64; 2],
    steps: usize,
    mut off_m: impl FnMut(f64) -> f64,
) -> f64 {
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    for _ in 0..steps {
        let [a, b] = [high - golden * (high - low), low + golden * (high - low)];
        if off_m(a) < off_m(b) { high = b } else { low = a }
    }
    0.5 * (low + high)
}

/// `stations` with joint `j` of each where it must have stood, base and target fitted with it in turn by `register`; `None` where that fits nothing.
pub(super) fn with_free_joint(
    robot: &SerialArm,
    stations: &[Station],
    j: usize,
    register: impl Fn(&[Station], &[Isometry3<f64>]) -> Option<Registration>,
) -> Option<Vec<Station>> {
    let chain = SerialChain::nominal(robot);
    let mut stations = stations.to_vec();
    for _ in 0..ROUNDS {
        let poses: Vec<Isometry3<f64>> = stations.iter().map(|s| s.pose(&chain)).collect();
        let registration = register(&stations, &poses)?;
        for station in stations.iter_mut().filter(|s| s.reading.involves_arm()) {
            station.q_rad[j] = refitted(robot, &chain, &registration, station, j).q_rad;
        }
    }
    Some(stations)
}

/// The fault of one column in some rows.
pub(super) fn one_joint(robot: &SerialArm, j: usize, lines: Vec<u64>) -> Fault {
    let column = robot.column(Axis::at(j));
    Fault::in_rows(FaultKind::FrozenJoints, &column.clone(), lines, |count, which| {
        format!(
            "in {count} rows ({which}) column {column} stands still to the last digit, while the points lie where other angles of joint {} alone put them: it \
             was not read anew",
            Axis::at(j)
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Reading;
    use nalgebra::Point3;
    use robot_model::robot::Joints;

    /// A point as it were seen with joint 2 five degrees beyond its end.
    #[test]
    fn a_joint_is_looked_for_within_its_range_alone() {
        let robot = SerialArm::built_in("irb140").unwrap();
        let chain = SerialChain::nominal(&robot);
        let tool_m = Vector3::new(0.0, 0.0, 0.1);
        let registration = Registration::assumed(Isometry3::identity(), vec![tool_m], Vec::new());
        let [low, high] = robot.joints[1].range_rad.unwrap();
        for (end_rad, beyond_rad) in [(low, -0.0873), (high, 0.0873)] {
            let q_rad = Joints::from([0.2, end_rad + beyond_rad, 0.1, 0.3, 0.5, 0.0]);
            let position_m = (chain.forward(&q_rad) * Point3::from(tool_m)).coords;
            let station = Station::bare(0, q_rad, Reading::Point { position_m });
            let found = refitted(&robot, &chain, &registration, &station, 1);
            assert!((low..=high).contains(&found.q_rad), "{}", found.q_rad);
            assert!((found.q_rad - end_rad).abs() < 1e-6 && found.off_m > 0.01, "{}", found.off_m);
        }
    }
}
