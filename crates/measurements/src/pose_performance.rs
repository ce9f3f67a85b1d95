//! Performance of one pose after ISO 9283, at all times together and at each.

use super::iso9283::{
    Accuracy, OrientationPerformance, Repeatability, accuracy, barycentre_m, orientation, repeatability,
};
use super::station::SAME_TIME_MIN;
use super::{MeasurementRow, Measurements, Registration};
use nalgebra::{Point3, UnitQuaternion, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::Joints;

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
    /// The first row's `id`, where the file has one.
    pub id: Option<String>,
    /// Its `pose_id`, where the file has one.
    pub pose_id: Option<String>,
    /// Number of the pose: one pose come to from several sides is several of these.
    pub pose: usize,
    /// Index of the reflector or stylus.
    pub target: usize,
    /// Sign of each joint's last motion before the pose, where it is recorded.
    pub direction: Option<Joints<i8>>,
    /// Mass of the payload as declared, kg.
    pub payload_kg: Option<f64>,
    /// First and last minute since the cold start of their session, where they are recorded.
    pub minutes: Option<[f64; 2]>,
    /// The same on a clock that goes on over all sessions: minutes of two days are no common time.
    pub(super) clock_min: Option<[f64; 2]>,
    /// Joint angles of the first row, joint 1 first, radians.
    pub q_rad: Joints,
    /// Whether those of other rows differ, as encoders read them.
    pub joints_differ: bool,
    /// Barycentre in the base, metres.
    pub barycentre_m: Vector3<f64>,
    /// Accuracy of all rows of the pose: the mean of what each is off where its own joints put the target.
    pub accuracy: Option<Accuracy>,
    /// Of all rows, two and more: of the points as attained, whatever the joints read.
    pub repeatability: Option<Repeatability>,
    /// Accuracy and repeatability of the orientation, where it was measured.
    pub orientation: Option<OrientationPerformance>,
    /// By time, where it was measured at several.
    pub times: Vec<PerformanceAtTime>,
}

impl PosePerformance {
    /// What the file calls it.
    #[must_use]
    pub fn name(&self) -> Option<&str> {
        self.pose_id.as_deref().or(self.id.as_deref())
    }

    /// Whether one of the two begins before the other has ended for so long that it is another time of the drift test.
    pub(super) fn is_at_the_time_of(&self, other: &Self) -> bool {
        let times = self.clock_min.zip(other.clock_min);
        let Some(([from, to], [other_from, other_to])) = times else { return true };
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
    let cycles: Vec<Cycle> = rows.iter().filter_map(|row| Cycle::of(row, chain, registration)).collect();
    let points = points_m(&cycles);
    let first_and_last = |of: fn(&MeasurementRow) -> Option<f64>| {
        rows.first().and_then(|row| of(row)).zip(rows.last().and_then(|row| of(row))).map(<[f64; 2]>::from)
    };
    Some(PosePerformance {
        line: first.line,
        id: first.id.clone(),
        pose_id: first.pose_id.clone(),
        pose,
        target: first.target,
        direction: first.direction,
        payload_kg: first.payload_kg,
        minutes: first_and_last(|row| row.t_min),
        clock_min: first_and_last(MeasurementRow::clock_min),
        q_rad: first.q_rad,
        joints_differ: rows.iter().any(|row| row.q_rad != first.q_rad),
        barycentre_m: barycentre_m(&points)?,
        accuracy: accuracy_of(&cycles),
        repeatability: repeatability(&points),
        orientation: orientation_of(&cycles),
        times: by_time(&cycles),
    })
}

/// A pose as it was attained once.
struct Cycle {
    t_min: Option<f64>,
    /// Minutes on a clock that goes on over all sessions.
    clock_min: Option<f64>,
    /// In the base, metres; without one in the instrument's own frame, in which distances between repeats are the same.
    point_m: Vector3<f64>,
    /// From where its own joints put the target, metres; `None` without a base.
    off_m: Option<Vector3<f64>>,
    turn: Option<Turn>,
}

/// A measured orientation in the base's axes.
struct Turn {
    attained: UnitQuaternion<f64>,
    /// As its own joints put the sensor.
    command: UnitQuaternion<f64>,
}

impl Cycle {
    fn of(row: &MeasurementRow, chain: &SerialChain, registration: Option<&Registration>) -> Option<Self> {
        let seen = Point3::from(row.reading.position_m()?);
        let (t_min, clock_min) = (row.t_min, row.clock_min());
        let Some(registration) = registration else {
            return Some(Self { t_min, clock_min, point_m: seen.coords, off_m: None, turn: None });
        };
        let base_from_instrument = registration.instrument_from_base.inverse();
        let flange = chain.forward(&row.q_rad);
        let tool_m = registration.tools_m.get(row.target).copied().unwrap_or_default();
        let point_m = (base_from_instrument * seen).coords;
        Some(Self {
            t_min,
            clock_min,
            point_m,
            off_m: Some(point_m - (flange.translation.vector + flange.rotation * tool_m)),
            turn: row.orientation.zip(registration.flange_from_sensor).map(|(seen, sensor)| Turn {
                attained: base_from_instrument.rotation * seen,
                command: flange.rotation * sensor,
            }),
        })
    }
}

fn points_m(cycles: &[Cycle]) -> Vec<Vector3<f64>> {
    cycles.iter().map(|cycle| cycle.point_m).collect()
}

/// Each cycle against its own command: read from the encoders, the joints of one pose differ, and with them where the arm believed to be.
fn accuracy_of(cycles: &[Cycle]) -> Option<Accuracy> {
    let off_m: Option<Vec<Vector3<f64>>> = cycles.iter().map(|cycle| cycle.off_m).collect();
    accuracy(&Vector3::zeros(), &off_m?)
}

/// Accuracy against each cycle's own command, repeatability of the orientations as attained.
fn orientation_of(cycles: &[Cycle]) -> Option<OrientationPerformance> {
    let turns: Vec<&Turn> = cycles.iter().map(|cycle| cycle.turn.as_ref()).collect::<Option<_>>()?;
    let off: Vec<UnitQuaternion<f64>> =
        turns.iter().map(|turn| turn.attained * turn.command.inverse()).collect();
    let attained: Vec<UnitQuaternion<f64>> = turns.iter().map(|turn| turn.attained).collect();
    let of_commands = orientation(&UnitQuaternion::identity(), &off)?;
    let of_attained = orientation(&turns.first()?.command, &attained)?;
    Some(OrientationPerformance { rp_rad: of_attained.rp_rad, ..of_commands })
}

/// The cycles of each time, which are in order of time.
fn by_time(mut cycles: &[Cycle]) -> Vec<PerformanceAtTime> {
    let mut times = Vec::new();
    while let Some(first) = cycles.first() {
        let is_later =
            |c: &Cycle| matches!((first.clock_min, c.clock_min), (Some(a), Some(b)) if b - a > SAME_TIME_MIN);
        let (block, later) = cycles.split_at(cycles.iter().position(is_later).unwrap_or(cycles.len()));
        times.push(PerformanceAtTime {
            t_min: first.t_min,
            accuracy: accuracy_of(block),
            repeatability: repeatability(&points_m(block)),
        });
        cycles = later;
    }
    times
}
