//! Stations: rows that repeat one pose under the same conditions, as one mean; their scatter is the noise.

use super::repeats::{Repeats, apart_where_contradictory, centre, false_repeats, repeats};
use super::rounds::{FlangeTurn, Rounds};
use super::rows::JointTolerance;
use super::{Channels, MeasurementRow, Measurements, Reading};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::Joints;
use std::collections::BTreeMap;

/// Repeats further apart than this are different stations, and of another time of the drift test: drift between them is signal, not noise.
pub(super) const SAME_TIME_MIN: f64 = 10.0;
/// A fixed point touched again with all joints as near as this is the same pose.
const SAME_TOUCH: JointTolerance = JointTolerance { rad: 5e-3, m: 1e-3 };
/// Joints read back scatter by less than this between repeats, radians; metres where they slide, as far as such a turn moves a point at 1 m.
const SAME_JOINT_RAD: f64 = 2e-4;
/// Joint temperatures within this are the same.
const SAME_TEMPERATURE_C: f64 = 0.5;

/// The mean of rows that repeat one pose in the same direction, with the same payload, at about one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Station {
    /// Commanded pose; stations of one pose stay together in every fold.
    pub pose: usize,
    /// Index of the reflector or stylus.
    pub target: usize,
    /// Which stand of the instrument saw it, from 0.
    pub stand: usize,
    /// Minutes since cold start.
    pub t_min: Option<f64>,
    /// How long before that of the file's last cold start the clock of [`Self::t_min`] began, minutes: 0 where the file has one.
    pub earlier_min: f64,
    /// Joints, radians, those that slide metres; at a nest where the arm stood, 0 where its row does not say.
    pub q_rad: Joints,
    /// What was measured, the mean of the rows.
    pub reading: Reading,
    /// Measured orientation in the instrument's frame.
    pub orientation: Option<UnitQuaternion<f64>>,
    /// Sign of each joint's last motion.
    pub direction: Option<Joints<i8>>,
    /// Mass of the payload as declared, kg.
    pub payload_kg: Option<f64>,
    /// Temperature of each joint.
    pub joint_temperature_c: Option<Joints>,
    /// Line in the file of its first row.
    pub line: u64,
    /// Rows in the mean, as indices into the file's rows.
    pub rows: Vec<usize>,
}

impl Station {
    /// One row of the first target, number `pose` of its file, of which nothing else is recorded.
    #[must_use]
    pub fn bare(pose: usize, q_rad: Joints, reading: Reading) -> Self {
        Self {
            pose,
            target: 0,
            stand: 0,
            t_min: None,
            earlier_min: 0.0,
            q_rad,
            reading,
            orientation: None,
            direction: None,
            payload_kg: None,
            joint_temperature_c: None,
            line: 0,
            rows: vec![pose],
        }
    }

    /// Middle of its rows' places in the file.
    #[must_use]
    pub fn row(&self) -> f64 {
        self.rows.iter().map(|&r| r as f64).sum::<f64>() / self.rows.len().max(1) as f64
    }

    /// Minutes on a clock that goes on over all sessions, since the last cold start.
    #[must_use]
    pub fn clock_min(&self) -> Option<f64> {
        self.t_min.map(|t_min| t_min - self.earlier_min)
    }

    /// `base_from_flange` of the arm `chain`; at a nest, where no arm takes part, the base itself.
    #[must_use]
    pub fn pose(&self, chain: &SerialChain) -> Isometry3<f64> {
        if self.reading.involves_arm() { chain.forward(&self.q_rad) } else { Isometry3::identity() }
    }
}

/// A measurement file gathered into stations.
#[derive(Clone, Debug)]
pub struct Stations {
    /// In the order of their first rows.
    pub stations: Vec<Station>,
    /// Noise from repeats; `None` where nothing was repeated.
    pub repeats: Option<Repeats>,
    /// Optional columns that are complete.
    pub channels: Channels,
    /// Number of reflectors, one at least.
    pub targets: usize,
    /// Number of fixed points.
    pub fixed_points: usize,
    /// Rows left out as false repeats.
    pub false_rows: Vec<usize>,
}

/// Pose, target, place, direction and payload (as bits): what repeats share.
type Condition = (usize, usize, Option<usize>, Option<Joints<i8>>, u64);

/// Gathers the rows that `used` names; `stated_m`: the noise of one coordinate as stated, metres, which helps to tell whether repeats
/// contradict each other.
#[must_use]
pub fn gather(measurements: &Measurements, used: &[usize], stated_m: Option<f64>) -> Stations {
    gathered(measurements, used, stated_m, None)
}

/// As [`gather`], where the arm tells what turns with its flange: rounds between which a target moved are no repeats. `base_from_flange` of each
/// row comes from `chain`, and the axes from the rotation of `instrument_from_base`.
#[must_use]
pub fn gather_about(
    measurements: &Measurements,
    used: &[usize],
    stated_m: Option<f64>,
    (chain, instrument_from_base): (&SerialChain, &UnitQuaternion<f64>),
) -> Stations {
    let turn = |row: &MeasurementRow| {
        let has_point = matches!(row.reading, Reading::Point { .. });
        has_point.then(|| (instrument_from_base * chain.forward(&row.q_rad).rotation).inverse())
    };
    gathered(measurements, used, stated_m, Some(&turn))
}

fn gathered(
    measurements: &Measurements,
    used: &[usize],
    stated_m: Option<f64>,
    flange: Option<FlangeTurn<'_>>,
) -> Stations {
    let rows = &measurements.rows;
    let poses = pose_numbers(measurements, used);
    let mut open: BTreeMap<Condition, usize> = BTreeMap::new();
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (&index, &pose) in used.iter().zip(&poses) {
        let Some(row) = rows.get(index) else { continue };
        let payload = row.payload_kg.map_or(u64::MAX, f64::to_bits);
        let key = (pose, row.target, row.reading.fixed_point(), row.direction, payload);
        match open.get(&key).and_then(|&g| groups.get_mut(g)) {
            Some(group) if group.first().and_then(|&f| rows.get(f)).is_some_and(|f| is_repeat(f, row)) => {
                group.push(index);
            }
            _ => {
                open.insert(key, groups.len());
                groups.push(vec![index]);
            }
        }
    }
    let pose_of: BTreeMap<usize, usize> = used.iter().copied().zip(poses).collect();
    let rounds = Rounds::of(rows, &groups, flange);
    if let Some(rounds) = rounds.as_ref().filter(|rounds| rounds.changed) {
        groups = rounds.apart(&groups);
    }
    let false_rows = false_repeats(rows, &groups);
    for group in &mut groups {
        group.retain(|index| false_rows.binary_search(index).is_err());
    }
    groups.retain(|group| !group.is_empty());
    // Repeats of other rounds tell which of one round contradict each other, and how much noise there is.
    let mut groups = apart_where_contradictory(rows, groups, stated_m);
    let repeats = repeats(rows, &groups);
    if let Some(rounds) = rounds {
        groups = rounds.apart(&groups);
    }
    Stations {
        repeats,
        stations: groups.iter().filter_map(|group| mean(rows, group, &pose_of)).collect(),
        channels: measurements.channels,
        targets: measurements.targets.len().max(1),
        fixed_points: measurements.fixed_points.len(),
        false_rows,
    }
}

/// Each row that `used` names as a station of its own.
#[must_use]
pub fn alone(measurements: &Measurements, used: &[usize]) -> Vec<Station> {
    let pose_of: BTreeMap<usize, usize> = used.iter().map(|&index| (index, index)).collect();
    used.iter().filter_map(|&index| mean(&measurements.rows, &[index], &pose_of)).collect()
}

/// The pose of each kept row: its `pose_id`, or, without that column, equal joints; a nest is a pose of its own, one for each stand of the arm.
pub(super) fn pose_numbers(measurements: &Measurements, used: &[usize]) -> Vec<usize> {
    let rows = used.iter().filter_map(|&i| measurements.rows.get(i));
    if measurements.channels.pose_id {
        return rows.map(|row| row.pose).collect();
    }
    let mut seen: BTreeMap<Joints<u64>, usize> = BTreeMap::new();
    let mut nests: BTreeMap<(usize, Joints<u64>), usize> = BTreeMap::new();
    let mut touched: BTreeMap<usize, Vec<(Joints, usize)>> = BTreeMap::new();
    let mut next = 0;
    rows.map(|row| {
        let pose = match row.reading {
            Reading::Nest { fixed_point, .. } => {
                *nests.entry((fixed_point, row.q_rad.map(f64::to_bits))).or_insert(next)
            }
            Reading::Touch { fixed_point } => {
                let known = touched.entry(fixed_point).or_default();
                let near = |q: &Joints| SAME_TOUCH.holds(&measurements.joint_kinds, q, &row.q_rad);
                match known.iter().find(|(q, _)| near(q)) {
                    Some((_, pose)) => *pose,
                    None => {
                        known.push((row.q_rad, next));
                        next
                    }
                }
            }
            Reading::Point { .. } | Reading::Length { .. } => {
                *seen.entry(row.q_rad.map(f64::to_bits)).or_insert(next)
            }
        };
        next = next.max(pose + 1);
        pose
    })
    .collect()
}

fn is_repeat(a: &MeasurementRow, b: &MeasurementRow) -> bool {
    // The scatter of touches lies in their joints: their mean would hide it.
    if matches!(a.reading, Reading::Touch { .. }) {
        return false;
    }
    let warmth = match (a.joint_temperature_c, b.joint_temperature_c) {
        (Some(a), Some(b)) => a.iter().zip(&b).all(|(a, b)| (a - b).abs() <= SAME_TEMPERATURE_C),
        _ => true,
    };
    Standing::of_row(a).may_be(&Standing::of_row(b)) && warmth && a.stand == b.stand
}

/// Where an arm stood, and when.
pub struct Standing<'a> {
    /// Joints at which the arm stood, rad.
    pub q_rad: &'a Joints,
    /// Minutes on a clock that goes on over all sessions, where the file has times.
    pub t_min: Option<f64>,
}

impl<'a> Standing<'a> {
    fn of_row(row: &'a MeasurementRow) -> Self {
        Self { q_rad: &row.q_rad, t_min: row.clock_min() }
    }

    /// Whether the arm may not have moved between the two.
    pub fn may_be(&self, other: &Standing<'_>) -> bool {
        let joints = self.q_rad.iter().zip(other.q_rad).all(|(a, b)| (a - b).abs() < SAME_JOINT_RAD);
        let time = match (self.t_min, other.t_min) {
            (Some(a), Some(b)) => (a - b).abs() <= SAME_TIME_MIN,
            _ => true,
        };
        joints && time
    }
}

fn mean(rows: &[MeasurementRow], group: &[usize], pose_of: &BTreeMap<usize, usize>) -> Option<Station> {
    let first_index = *group.first()?;
    let first = rows.get(first_index)?;
    let members: Vec<&MeasurementRow> = group.iter().filter_map(|&i| rows.get(i)).collect();
    let n = members.len() as f64;
    let average = |value: &dyn Fn(&MeasurementRow) -> Option<f64>| -> Option<f64> {
        members.iter().map(|row| value(row)).sum::<Option<f64>>().map(|sum| sum / n)
    };
    let orientation = first.orientation.map(|start| {
        let turn: Vector3<f64> = members
            .iter()
            .filter_map(|row| row.orientation)
            .map(|o| (o * start.inverse()).scaled_axis())
            .sum::<Vector3<f64>>()
            / n;
        UnitQuaternion::from_scaled_axis(turn) * start
    });
    let mut q_rad = first.q_rad;
    for (j, q) in q_rad.iter_mut().enumerate() {
        *q = members.iter().map(|row| row.q_rad[j]).sum::<f64>() / n;
    }
    let joint_temperature_c = first.joint_temperature_c.map(|first| {
        Joints::from_fn(first.len(), |j| {
            members.iter().filter_map(|row| row.joint_temperature_c).map(|t| t[j]).sum::<f64>() / n
        })
    });
    Some(Station {
        pose: *pose_of.get(&first_index)?,
        target: first.target,
        stand: first.stand,
        t_min: average(&|row| row.t_min),
        earlier_min: first.earlier_min,
        q_rad,
        reading: first.reading.with_coordinates_m(centre(rows, group)),
        orientation,
        direction: first.direction,
        payload_kg: first.payload_kg,
        joint_temperature_c,
        line: first.line,
        rows: group.to_vec(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(rows: &[(&str, f64, f64)]) -> Measurements {
        let mut text = "pose_id,t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
        for (pose, t_min, x_mm) in rows {
            text.push_str(&format!("{pose},{t_min},0,0,0,0,0,0,{x_mm},0,0\n"));
        }
        Measurements::from_csv(text.as_bytes()).unwrap()
    }

    #[test]
    fn repeats_of_one_pose_become_their_mean_and_their_scatter_the_noise() {
        let m = file(&[("A", 0.0, 1.0), ("A", 1.0, 3.0), ("B", 2.0, 5.0), ("B", 3.0, 5.0)]);
        let s = gather(&m, &[0, 1, 2, 3], None);
        assert_eq!(s.stations.len(), 2);
        assert!((s.stations[0].reading.position_m().unwrap().x - 0.002).abs() < 1e-15);
        assert_eq!(s.stations[0].t_min, Some(0.5));
        let repeats = s.repeats.unwrap();
        // Deviations are +-1 mm in x of the first pair alone: 2 mm^2 over 3 (n-1) = 6 degrees of freedom.
        assert_eq!(repeats.degrees_of_freedom, 6);
        assert!((repeats.sigma_m - 1e-3 * (2.0_f64 / 6.0).sqrt()).abs() < 1e-15);
    }

    #[test]
    fn repeats_far_apart_in_time_are_stations_of_their_own_but_one_pose() {
        let m = file(&[("A", 0.0, 1.0), ("A", 60.0, 3.0)]);
        let s = gather(&m, &[0, 1], None);
        assert_eq!(s.stations.len(), 2);
        assert_eq!(s.stations[0].pose, s.stations[1].pose);
        assert!(s.repeats.is_none());
    }

    #[test]
    fn a_false_repeat_is_named_and_left_out() {
        let mut rows: Vec<(&str, f64, f64)> = Vec::new();
        for k in 0..8 {
            rows.push(("A", 0.0, f64::from(k % 4) * 0.01));
        }
        rows.push(("A", 0.0, 10.0));
        let s = gather(&file(&rows), &(0..9).collect::<Vec<_>>(), None);
        assert_eq!(s.false_rows, [8]);
        assert!(s.stations[0].reading.position_m().unwrap().x < 1e-4);
    }
}
