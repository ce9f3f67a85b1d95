//! Performance after ISO 9283 of a whole measurement file: pose by pose, and over time.

use super::iso9283::{Accuracy, Repeatability, accuracy, barycentre_m, orientation, repeatability};
use super::station::pose_numbers;
use super::{
    FreeParameters, Measurements, Reading, RegisterError, Registration, Station, check_rows, gather,
    register, register_with,
};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Joints, SerialArm};
use std::collections::BTreeMap;

/// Rows of one pose further apart than this are another time of the drift test.
const SAME_TIME_MIN: f64 = 10.0;

/// Why a file's performance cannot be judged.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PerformanceError {
    /// Base and tool cannot be fitted.
    #[error(transparent)]
    Register(#[from] RegisterError),
    /// Touches and lengths only.
    #[error("the file has no measured points: fixed points and lengths say nothing of accuracy")]
    NoPoints,
    /// The rows contradict the robot.
    #[error("{reason}")]
    Fault {
        /// In what way, as a sentence.
        reason: String,
    },
}

/// In what frame commanded and attained poses are compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ComparisonFrame {
    /// Base and tool are fitted first: what is left is the arm's.
    Fitted,
    /// The base is fitted; the tool is there in the flange's frame, metres.
    BaseFitted(Vector3<f64>),
    /// The instrument shows the base's own frame; the tool is there.
    AsMeasured(Vector3<f64>),
}

/// One pose at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PerformanceAtTime {
    /// First minute, where it is recorded.
    pub t_min: Option<f64>,
    /// Accuracy of the pose at that time.
    pub accuracy: Accuracy,
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
    /// Joint angles as commanded, joint 1 first, radians.
    pub q_rad: Joints,
    /// Barycentre in the base, metres.
    pub barycentre_m: Vector3<f64>,
    /// Accuracy of all rows of the pose.
    pub accuracy: Accuracy,
    /// Of all rows, two and more.
    pub repeatability: Option<Repeatability>,
    /// AP_a, AP_b, AP_c and RP_a, RP_b, RP_c, radians, where the orientation was measured.
    pub orientation_rad: Option<([f64; 3], Option<[f64; 3]>)>,
    /// By time, where it was measured at several.
    pub times: Vec<PerformanceAtTime>,
}

impl PosePerformance {
    /// dAP_p: largest change of AP_p from the first time on, metres.
    #[must_use]
    pub fn drift_of_accuracy_m(&self) -> Option<f64> {
        let first = self.times.first()?.accuracy.ap_m;
        self.times.iter().skip(1).map(|t| (t.accuracy.ap_m - first).abs()).reduce(f64::max)
    }

    /// dRP_l: largest change of RP_l from the first time on, metres.
    #[must_use]
    pub fn drift_of_repeatability_m(&self) -> Option<f64> {
        let mut known = self.times.iter().filter_map(|t| t.repeatability).map(|r| r.rp_m);
        let first = known.next()?;
        known.map(|rp| (rp - first).abs()).reduce(f64::max)
    }
}

/// Performance of the robot in a whole file.
#[derive(Clone, Debug, PartialEq)]
pub struct Performance {
    /// In the order of the first rows.
    pub poses: Vec<PosePerformance>,
    /// Largest distance between the barycentres of one pose come to from several sides, metres: vAP_p.
    pub multi_directional_m: Option<f64>,
    /// The registration in which they were compared.
    pub registration: Registration,
}

/// The performance of `robot` in `measurements`, its nominal arm being what was commanded.
///
/// # Errors
/// [`PerformanceError`]
pub fn performance(
    measurements: &Measurements,
    robot: &SerialArm,
    compared: ComparisonFrame,
) -> Result<Performance, PerformanceError> {
    let checked = check_rows(measurements, robot);
    if let Some(fault) = checked.fault {
        return Err(PerformanceError::Fault { reason: fault.reason });
    }
    if !measurements.rows.iter().any(|row| matches!(row.reading, Reading::Point { .. })) {
        return Err(PerformanceError::NoPoints);
    }
    let gathered = gather(measurements, &checked.used);
    let chain = SerialChain::nominal(robot);
    let registration = registered(&gathered.stations, gathered.targets, &chain, compared)?;
    let numbers = pose_numbers(measurements, &checked.used);
    type Side = (usize, usize, Option<Joints<i8>>, u64);
    let mut groups: BTreeMap<Side, Vec<usize>> = BTreeMap::new();
    for (&row, &pose) in checked.used.iter().zip(&numbers) {
        let Some(r) = measurements.rows.get(row).filter(|r| matches!(r.reading, Reading::Point { .. }))
        else {
            continue;
        };
        let payload = r.payload_kg.map_or(u64::MAX, f64::to_bits);
        groups.entry((pose, r.target, r.direction, payload)).or_default().push(row);
    }
    let mut all: Vec<PosePerformance> = groups
        .iter()
        .filter_map(|((pose, ..), rows)| pose_performance(measurements, &chain, &registration, *pose, rows))
        .collect();
    all.sort_by_key(|p| p.line);
    let mut sides: BTreeMap<(usize, usize), Vec<Vector3<f64>>> = BTreeMap::new();
    for p in &all {
        sides.entry((p.pose, p.target)).or_default().push(p.barycentre_m);
    }
    let apart = |points: &Vec<Vector3<f64>>| {
        let pairs =
            points.iter().enumerate().flat_map(|(i, a)| points[i + 1..].iter().map(move |b| (a - b).norm()));
        pairs.reduce(f64::max)
    };
    Ok(Performance {
        multi_directional_m: sides.values().filter_map(apart).reduce(f64::max),
        poses: all,
        registration,
    })
}

fn registered(
    stations: &[Station],
    targets: usize,
    chain: &SerialChain,
    compared: ComparisonFrame,
) -> Result<Registration, RegisterError> {
    let flange: Vec<Isometry3<f64>> = stations.iter().map(|s| s.pose(chain)).collect();
    let tools = |tool_m: Vector3<f64>| vec![tool_m; targets];
    match compared {
        ComparisonFrame::Fitted => register(stations, &flange, targets, None),
        ComparisonFrame::BaseFitted(tool_m) => {
            register_with(stations, &flange, &tools(tool_m), FreeParameters::Base)
        }
        ComparisonFrame::AsMeasured(tool_m) => {
            register_with(stations, &flange, &tools(tool_m), FreeParameters::Nothing(Isometry3::identity()))
        }
    }
}

fn pose_performance(
    measurements: &Measurements,
    chain: &SerialChain,
    registration: &Registration,
    pose: usize,
    rows: &[usize],
) -> Option<PosePerformance> {
    let rows: Vec<&super::MeasurementRow> = rows.iter().filter_map(|&i| measurements.rows.get(i)).collect();
    let first = *rows.first()?;
    let flange = chain.forward(&first.q_rad);
    let tool_m = registration.tools_m.get(first.target).copied().unwrap_or_default();
    let command_m = flange.translation.vector + flange.rotation * tool_m;
    let in_base = |row: &super::MeasurementRow| {
        let seen = row.reading.position_m()?;
        Some(registration.instrument_from_base.inverse_transform_point(&seen.into()).coords)
    };
    let attained: Vec<Vector3<f64>> = rows.iter().filter_map(|row| in_base(row)).collect();
    let turned: Option<Vec<UnitQuaternion<f64>>> = rows
        .iter()
        .map(|row| Some(registration.instrument_from_base.rotation.inverse() * row.orientation?))
        .collect();
    let commanded = registration.flange_from_sensor.map(|sensor| flange.rotation * sensor);
    let mut times: Vec<PerformanceAtTime> = Vec::new();
    let mut block: Vec<Vector3<f64>> = Vec::new();
    let mut since: Option<f64> = None;
    for (k, (row, at)) in rows.iter().zip(&attained).enumerate() {
        let apart = matches!((since, row.t_min), (Some(a), Some(b)) if b - a > SAME_TIME_MIN);
        if apart || k == 0 {
            times.extend(at_time(since, &command_m, &block));
            block.clear();
            since = row.t_min;
        }
        block.push(*at);
    }
    times.extend(at_time(since, &command_m, &block));
    Some(PosePerformance {
        line: first.line,
        id: first.id.clone(),
        pose,
        target: first.target,
        q_rad: first.q_rad,
        barycentre_m: barycentre_m(&attained)?,
        accuracy: accuracy(&command_m, &attained)?,
        repeatability: repeatability(&attained),
        orientation_rad: commanded.zip(turned).and_then(|(command, turned)| orientation(&command, &turned)),
        times,
    })
}

fn at_time(
    t_min: Option<f64>,
    command_m: &Vector3<f64>,
    block: &[Vector3<f64>],
) -> Option<PerformanceAtTime> {
    Some(PerformanceAtTime {
        t_min,
        accuracy: accuracy(command_m, block)?,
        repeatability: repeatability(block),
    })
}
