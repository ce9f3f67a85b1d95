//! Performance after ISO 9283 of a whole measurement file: pose by pose, and over time.

use super::iso9283::{
    Accuracy, OrientationPerformance, Repeatability, accuracy, barycentre_m, orientation, repeatability,
};
use super::station::pose_numbers;
use super::{
    FreeParameters, Measurements, Reading, RegisterError, Registration, Station, check_rows, gather,
    register, register_with,
};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use rapid_syntax::diagnostic::Diagnostic;
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

impl PerformanceError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Register(error) => error.code(),
            Self::NoPoints => "measure::no-points",
            Self::Fault { .. } => "measure::fault",
        }
    }
}

impl From<PerformanceError> for Diagnostic {
    fn from(error: PerformanceError) -> Self {
        Self::error(error.code(), error.to_string())
    }
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

/// Performance of the robot in a whole file.
#[derive(Clone, Debug, PartialEq)]
pub struct Performance {
    /// In the order of the first rows.
    pub poses: Vec<PosePerformance>,
    /// Largest distance between the barycentres of one pose come to from several sides, metres: vAP_p.
    pub multi_directional_m: Option<f64>,
    /// The registration in which they were compared; `None` where so few poses place no base: repeatability alone is given.
    pub registration: Option<Registration>,
}

/// The worst of all poses, metres.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WorstPerformance {
    /// Positioning accuracy AP_p of ISO 9283, metres.
    pub ap_m: Option<f64>,
    /// Repeatability RP_l of ISO 9283, metres.
    pub rp_m: Option<f64>,
    /// Drift of the accuracy, dAP_p of ISO 9283, metres.
    pub drift_m: Option<f64>,
}

impl Performance {
    /// The worst of all poses; `None` for what no pose tells.
    #[must_use]
    pub fn worst(&self) -> WorstPerformance {
        let most =
            |of: &dyn Fn(&PosePerformance) -> Option<f64>| self.poses.iter().filter_map(of).reduce(f64::max);
        WorstPerformance {
            ap_m: most(&|p| p.accuracy.map(|a| a.ap_m)),
            rp_m: most(&|p| p.repeatability.map(|r| r.rp_m)),
            drift_m: most(&|p| p.drift_of_accuracy_m()),
        }
    }
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
    let gathered = gather(measurements, &checked.used, None);
    let chain = SerialChain::nominal(robot);
    let registration = match registered(&gathered.stations, gathered.targets, &chain, compared) {
        Ok(registration) => Some(registration),
        Err(_) if gathered.stations.iter().any(|station| station.rows.len() > 1) => None,
        Err(error) => return Err(error.into()),
    };
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
        .filter_map(|((pose, ..), rows)| {
            pose_performance(measurements, &chain, registration.as_ref(), *pose, rows)
        })
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
    registration: Option<&Registration>,
    pose: usize,
    rows: &[usize],
) -> Option<PosePerformance> {
    let rows: Vec<&super::MeasurementRow> = rows.iter().filter_map(|&i| measurements.rows.get(i)).collect();
    let first = *rows.first()?;
    let flange = chain.forward(&first.q_rad);
    let command_m = registration.map(|registration| {
        let tool_m = registration.tools_m.get(first.target).copied().unwrap_or_default();
        flange.translation.vector + flange.rotation * tool_m
    });
    // Without a base in the instrument's own frame: distances between repeats are the same.
    let base_from_instrument =
        registration.map_or_else(Isometry3::identity, |r| r.instrument_from_base.inverse());
    let in_base = |row: &super::MeasurementRow| {
        let seen = row.reading.position_m()?;
        Some((base_from_instrument * nalgebra::Point3::from(seen)).coords)
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

#[cfg(test)]
mod tests {
    use super::*;

    /// One pose seen five times places no base: repeatability is the same in the instrument's frame. By hand, distances from the
    /// barycentre 1, 1, 1, 1, 0 mm: mean 0.8, S = sqrt(0.2), RP = 0.8 + 3 sqrt(0.2).
    #[test]
    fn a_single_repeated_pose_has_a_repeatability_and_no_accuracy() {
        let mut text = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
        for [x, y] in [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [0.0, 0.0]] {
            text += &format!("10,20,5,25,45,-20,{},{},600\n", 500.0 + x, 100.0 + y);
        }
        let measurements = Measurements::from_csv(text.as_bytes()).unwrap();
        let robot = SerialArm::built_in("irb140").unwrap();
        let found = performance(&measurements, &robot, ComparisonFrame::Fitted).unwrap();
        let [pose] = found.poses.as_slice() else { panic!("{} poses", found.poses.len()) };
        let rp_mm = 1e3 * pose.repeatability.unwrap().rp_m;
        assert!((rp_mm - (0.8 + 3.0 * 0.2_f64.sqrt())).abs() < 1e-9, "{rp_mm}");
        assert!(found.registration.is_none() && pose.accuracy.is_none());
        let once = text.lines().take(2).collect::<Vec<_>>().join("\n");
        let once = Measurements::from_csv(once.as_bytes()).unwrap();
        assert!(matches!(
            performance(&once, &robot, ComparisonFrame::Fitted),
            Err(PerformanceError::Register(_))
        ));
    }
}
