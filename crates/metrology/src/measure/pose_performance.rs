//! Performance of one pose after ISO 9283, at all times together and at each.

use super::iso9283::{
    Accuracy, OrientationPerformance, Repeatability, accuracy, barycentre_m, orientation, repeatability,
};
use super::{MeasurementRow, Measurements, Registration};
use nalgebra::{Isometry3, Point3, UnitQuaternion, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::Joints;

/// Rows of one pose further apart than this are another time of the drift test.
const SAME_TIME_MIN: f64 = 10.0;

/// One pose at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PerformanceAtTime {
    /// First minute, where it is recorded.
    pub t_min: Option<f64>,
    /// Accuracy of the pose at that time.
    pub accuracy: Option<Accuracy>,
    /// Repeatability then, of two and more.
    pub repeatability: Option<Repeatability>,
}

/// One commanded pose, come to from one side with one payload.
#[derive(Clone, Debug, PartialEq)]
pub struct PosePerformance {
    /// The first row's line.
    pub line: u64,
    /// Its name, where the file has one.
    pub id: Option<String>,
    /// Number of the pose: one pose come to from several sides is several of these.
    pub pose: usize,
    /// Index of the reflector or stylus.
    pub target: usize,
    /// Sign of each joint's last motion before the pose, where it is recorded.
    pub direction: Option<Joints<i8>>,
    /// Mass of the payload as declared, kg.
    pub payload_kg: Option<f64>,
    /// First and last minute, where they are recorded.
    pub minutes: Option<[f64; 2]>,
    /// Joint angles as commanded, joint 1 first, radians.
    pub q_rad: Joints,
    /// Barycentre in the base, metres.
    pub barycentre_m: Vector3<f64>,
    /// Accuracy of all rows of the pose.
    pub accuracy: Option<Accuracy>,
    /// Of all rows, two and more.
    pub repeatability: Option<Repeatability>,
    /// Accuracy and repeatability of the orientation, where it was measured.
    pub orientation: Option<OrientationPerformance>,
    /// By time, where it was measured at several.
    pub times: Vec<PerformanceAtTime>,
}

impl PosePerformance {
    /// Whether one of the two begins before the other has ended for so long that it is another time of the drift test.
    pub(super) fn is_at_the_time_of(&self, other: &Self) -> bool {
        let Some(([from, to], [other_from, other_to])) = self.minutes.zip(other.minutes) else { return true };
        other_from - to <= SAME_TIME_MIN && from - other_to <= SAME_TIME_MIN
    }

    /// dAP_p: largest change of AP_p from the first time on, metres.
    #[must_use]
    pub fn drift_of_accuracy_m(&self) -> Option<f64> {
        let first = self.times.first()?.accuracy?.ap_m;
        let later = self.times.iter().skip(1).filter_map(|t| t.accuracy);
        later.map(|accuracy| (accuracy.ap_m - first).abs()).reduce(f64::max)
    }

    /// dRP_l: largest change of RP_l from the first time on, metres.
    #[must_use]
    pub fn drift_of_repeatability_m(&self) -> Option<f64> {
        let mut known = self.times.iter().filter_map(|t| t.repeatability).map(|r| r.rp_m);
        let first = known.next()?;
        known.map(|rp| (rp - first).abs()).reduce(f64::max)
    }
}

/// The performance of the pose that `rows`, in order of time, repeat.
pub(super) fn pose_performance(
    measurements: &Measurements,
    chain: &SerialChain,
    registration: Option<&Registration>,
    pose: usize,
    rows: &[usize],
) -> Option<PosePerformance> {
    let rows: Vec<&MeasurementRow> = rows.iter().filter_map(|&i| measurements.rows.get(i)).collect();
    let first = *rows.iter().min_by_key(|row| row.line)?;
    let flange = chain.forward(&first.q_rad);
    let command_m = registration.map(|registration| {
        let tool_m = registration.tools_m.get(first.target).copied().unwrap_or_default();
        flange.translation.vector + flange.rotation * tool_m
    });
    // Without a base in the instrument's own frame: distances between repeats are the same.
    let base_from_instrument =
        registration.map_or_else(Isometry3::identity, |r| r.instrument_from_base.inverse());
    let in_base = |row: &MeasurementRow| {
        let seen = row.reading.position_m()?;
        Some((base_from_instrument * Point3::from(seen)).coords)
    };
    let attained: Vec<Vector3<f64>> = rows.iter().filter_map(|row| in_base(row)).collect();
    let turned: Option<Vec<UnitQuaternion<f64>>> =
        rows.iter().map(|row| Some(base_from_instrument.rotation * row.orientation?)).collect();
    let commanded = registration.and_then(|r| r.flange_from_sensor).map(|sensor| flange.rotation * sensor);
    let mut times: Vec<PerformanceAtTime> = Vec::new();
    let mut block: Vec<Vector3<f64>> = Vec::new();
    let mut since: Option<f64> = None;
    for (k, (row, at)) in rows.iter().zip(&attained).enumerate() {
        let apart = matches!((since, row.t_min), (Some(a), Some(b)) if b - a > SAME_TIME_MIN);
        if apart || k == 0 {
            times.extend(at_time(since, command_m.as_ref(), &block));
            block.clear();
            since = row.t_min;
        }
        block.push(*at);
    }
    times.extend(at_time(since, command_m.as_ref(), &block));
    Some(PosePerformance {
        line: first.line,
        id: first.id.clone(),
        pose,
        target: first.target,
        direction: first.direction,
        payload_kg: first.payload_kg,
        minutes: rows
            .first()
            .and_then(|row| row.t_min)
            .zip(rows.last().and_then(|row| row.t_min))
            .map(|(from, to)| [from, to]),
        q_rad: first.q_rad,
        barycentre_m: barycentre_m(&attained)?,
        accuracy: command_m.and_then(|command_m| accuracy(&command_m, &attained)),
        repeatability: repeatability(&attained),
        orientation: commanded.zip(turned).and_then(|(command, turned)| orientation(&command, &turned)),
        times,
    })
}

fn at_time(
    t_min: Option<f64>,
    command_m: Option<&Vector3<f64>>,
    block: &[Vector3<f64>],
) -> Option<PerformanceAtTime> {
    barycentre_m(block)?;
    Some(PerformanceAtTime {
        t_min,
        accuracy: command_m.and_then(|command_m| accuracy(command_m, block)),
        repeatability: repeatability(block),
    })
}
