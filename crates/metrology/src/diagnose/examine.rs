//! From measurements to what can be evaluated: checks of the file, one stand of the instrument, stations, registration.
//!
//! What is wrong with the file itself is said here; knows nothing of evidence.

use super::evaluate::{Evaluation, Prepared, evaluate};
use super::linearise::{linearise, turned};
use super::marginal::NoisePrior;
use super::measured_robot::MeasuredRobot;
use super::options::DiagnosisOptions;
use super::outcome::{Findings, Verdict, Warning};
use crate::measure::{
    Fault, FaultKind, Measurements, PartFault, PosedRow, RegisterError, RowCheck, Station, Stations, alone,
    check_rows, describe_move, find_fault, find_in_cells, find_in_orientations, find_in_rows,
    find_joint_columns, find_pose_names, gather, register,
};
use nalgebra::{Isometry3, Point3};
use robot_model::deform::identified::{FoundBy, Identified};
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Joints, SerialArm};
use robot_model::units::mm_from_m;
use std::borrow::Cow;
use std::collections::BTreeSet;

/// Fewer stations or poses than these say nothing.
const FEWEST_STATIONS: usize = 12;
const FEWEST_POSES: usize = 8;

/// Diagnoses `measurements` of `robot`.
#[must_use]
pub fn diagnose(measurements: &Measurements, robot: &SerialArm, options: &DiagnosisOptions) -> Findings {
    examine(measurements, robot, options, false).diagnosis
}

/// As [`diagnose`], with what was found as a model; `None` where nothing could be fitted.
#[must_use]
pub fn diagnose_and_identify(
    measurements: &Measurements,
    robot: &SerialArm,
    options: &DiagnosisOptions,
) -> (Findings, Option<Identified>) {
    let Evaluation { diagnosis, identified } = examine(measurements, robot, options, true);
    let found_by = Some(FoundBy::Diagnosis(diagnosis.verdict));
    let identified = identified.map(|model| Identified { found_by, ..model });
    (diagnosis, identified)
}

/// The diagnosis, and the model where `wants_model`: on a thread of the pool, which its thousands of parallel steps would otherwise have
/// to wake one by one.
fn examine(
    measurements: &Measurements,
    robot: &SerialArm,
    options: &DiagnosisOptions,
    wants_model: bool,
) -> Evaluation {
    rayon::scope(|_| examine_in_pool(measurements, robot, options, wants_model))
}

fn examine_in_pool(
    measurements: &Measurements,
    robot: &SerialArm,
    options: &DiagnosisOptions,
    wants_model: bool,
) -> Evaluation {
    let checked = check_rows(measurements, robot);
    let mut warnings: Vec<Warning> =
        measurements.warnings.iter().chain(&checked.warnings).map(Warning::from).collect();
    let evaluation = from_one_stand(measurements, robot, &checked, options).and_then(|seen| {
        warnings.extend(seen.warning);
        let stations = usable_stations(&seen.measurements, &checked, options.sigma_m)?;
        let measured = MeasuredRobot { robot, measurements: &seen.measurements, stations: &stations };
        evaluated(measured, seen.elsewhere.as_ref(), options, wants_model)
    });
    let mut evaluation =
        evaluation.unwrap_or_else(|unusable| Evaluation::without_model(unusable.diagnosis()));
    warnings.append(&mut evaluation.diagnosis.warnings);
    evaluation.diagnosis.warnings = warnings;
    evaluation.diagnosis.rows = measurements.rows.len();
    evaluation
}

/// Why measurements cannot be evaluated.
enum Unusable {
    /// The file contradicts itself or the robot.
    Fault(Box<Fault>),
    /// Too few or too alike poses, as a sentence.
    TooLittle(String),
}

impl From<Fault> for Unusable {
    fn from(fault: Fault) -> Self {
        Self::Fault(Box::new(fault))
    }
}

impl From<RegisterError> for Unusable {
    fn from(error: RegisterError) -> Self {
        Self::TooLittle(error.to_string())
    }
}

impl Unusable {
    /// What a diagnosis says of such a file.
    fn diagnosis(self) -> Findings {
        match self {
            Self::Fault(fault) => Findings::of_fault(*fault),
            Self::TooLittle(reason) => Findings::without_causes(Verdict::InsufficientData, reason),
        }
    }
}

/// Measurements as one stand of the instrument sees them.
struct OneStand<'a> {
    measurements: Cow<'a, Measurements>,
    /// That the instrument was moved in between.
    warning: Option<Warning>,
    /// That one joint stands elsewhere in a part of the rows.
    elsewhere: Option<JointElsewhere>,
}

impl<'a> OneStand<'a> {
    /// Measurements as they are.
    fn plain(measurements: &'a Measurements) -> Self {
        Self { measurements: Cow::Borrowed(measurements), warning: None, elsewhere: None }
    }
}

/// One joint that stands elsewhere than the file says in some rows, further than a registration bears.
struct JointElsewhere {
    /// The joint, counted from 0.
    joint: usize,
    /// The rows, as indices into the file's.
    rows: BTreeSet<usize>,
    /// Where it stands less where the file says, radians.
    by_rad: f64,
}

impl JointElsewhere {
    /// By how much each joint stands elsewhere at each station.
    fn turns(&self, stations: &[Station], joints: usize) -> Vec<Joints> {
        let at = |station: &Station| {
            let has = station.rows.iter().all(|row| self.rows.contains(row));
            Joints::from_fn(joints, |j| if has && j == self.joint { self.by_rad } else { 0.0 })
        };
        stations.iter().map(at).collect()
    }
}

/// Looks for what the rows alone can tell, and takes those of a moved instrument into one frame.
fn from_one_stand<'a>(
    measurements: &'a Measurements,
    robot: &SerialArm,
    checked: &RowCheck,
    options: &DiagnosisOptions,
) -> Result<OneStand<'a>, Unusable> {
    let targets = measurements.targets.len().max(1);
    let columns_meant = |fault: Fault| match fault.kind {
        FaultKind::JointsOutOfRange => {
            let rows = each_row(measurements, &checked.used, robot);
            let stations: Vec<Station> = rows.iter().map(|row| row.station.clone()).collect();
            find_joint_columns(robot, &stations, targets)
                .or_else(|| match find_in_rows(robot, &rows, targets, options.tool_m) {
                    Some(PartFault::Fault(of_some_rows)) => Some(of_some_rows),
                    Some(PartFault::Moved { .. } | PartFault::JointElsewhere { .. }) | None => None,
                })
                .unwrap_or(fault)
        }
        _ => fault,
    };
    let fault = checked.fault.clone().map(columns_meant);
    if let Some(fault) = fault.or_else(|| find_in_cells(measurements, &checked.used, robot)) {
        return Err(fault.into());
    }
    let rows = each_row(measurements, &checked.used, robot);
    match find_in_rows(robot, &rows, targets, options.tool_m) {
        None => Ok(OneStand::plain(measurements)),
        Some(PartFault::JointElsewhere { joint, rows, by_rad }) => {
            let rows = checked.used.get(rows).unwrap_or_default().iter().copied().collect();
            let elsewhere = Some(JointElsewhere { joint, rows, by_rad });
            Ok(OneStand { elsewhere, ..OneStand::plain(measurements) })
        }
        Some(PartFault::Fault(fault)) => Err(fault.into()),
        Some(PartFault::Moved { from, first_from_second }) => {
            let second = checked.used.get(from..).unwrap_or_default();
            let line = second.first().and_then(|&row| measurements.rows.get(row)).map_or(0, |row| row.line);
            Ok(OneStand {
                measurements: Cow::Owned(seen_from_first_stand(measurements, second, &first_from_second)),
                warning: Some(Warning {
                    code: "measure::instrument-moved",
                    message: describe_move(&first_from_second, line),
                }),
                elsewhere: None,
            })
        }
    }
}

/// Each row on its own, with the nominal arm's flange pose.
fn each_row(measurements: &Measurements, used: &[usize], robot: &SerialArm) -> Vec<PosedRow> {
    let chain = SerialChain::nominal(robot);
    alone(measurements, used)
        .into_iter()
        .map(|station| PosedRow { pose: station.pose(&chain), station })
        .collect()
}

/// The readings of `rows` in the frame of the instrument's first stand; what that leaves is registered with them.
fn seen_from_first_stand(
    measurements: &Measurements,
    rows: &[usize],
    first_from_second: &Isometry3<f64>,
) -> Measurements {
    let mut measurements = measurements.clone();
    for &index in rows {
        let Some(row) = measurements.rows.get_mut(index) else { continue };
        if let Some(position_m) = row.reading.position_m() {
            row.reading =
                row.reading.with_coordinates_m((first_from_second * Point3::from(position_m)).coords);
            row.orientation = row.orientation.map(|turn| first_from_second.rotation * turn);
            row.stand = 1;
        }
    }
    measurements
}

/// The stations of the rows that can be used, where those are enough.
fn usable_stations(
    measurements: &Measurements,
    checked: &RowCheck,
    stated_m: Option<f64>,
) -> Result<Stations, Unusable> {
    if let Some(fault) = find_pose_names(measurements, &checked.used) {
        return Err(fault.into());
    }
    let mut stations = gather(measurements, &checked.used, stated_m);
    stations.channels.time &= checked.time_usable;
    if !stations.channels.time {
        stations.stations.iter_mut().for_each(|s| s.t_min = None);
    }
    let poses: BTreeSet<usize> = stations.stations.iter().map(|s| s.pose).collect();
    if stations.stations.len() < FEWEST_STATIONS || poses.len() < FEWEST_POSES {
        return Err(Unusable::TooLittle(format!(
            "{} different poses are too few: base and target alone take 9 unknowns; 30 spread poses say something, 60 a lot",
            poses.len()
        )));
    }
    Ok(stations)
}

/// Where the repeats speak against the noise that was stated.
fn contradicted_noise(stations: &Stations, options: &DiagnosisOptions) -> Option<Warning> {
    let seen = stations.repeats?;
    NoisePrior::contradicted(Some(&seen), options.sigma_m).then(|| {
        let so = if options.sigma_m.is_some_and(|stated_m| stated_m > seen.sigma_m) {
            "less than the noise that was stated; they are believed, and what is slow may be as large as stated"
        } else {
            "which is not the noise that was stated; the repeats are believed"
        };
        let seen_mm = mm_from_m(seen.sigma_m);
        Warning {
            code: "diagnose::noise",
            message: format!("the repeats scatter by {seen_mm:.4} mm in one coordinate, {so}"),
        }
    })
}

/// Registers base and target, and evaluates what that leaves.
fn evaluated(
    measured: MeasuredRobot<'_>,
    elsewhere: Option<&JointElsewhere>,
    options: &DiagnosisOptions,
    wants_model: bool,
) -> Result<Evaluation, Unusable> {
    let MeasuredRobot { robot, stations, .. } = measured;
    let chain = SerialChain::nominal(robot);
    let turns =
        elsewhere.map(|found| found.turns(&stations.stations, robot.joints.len())).unwrap_or_default();
    let standing = turned(&stations.stations, &turns);
    let flange: Vec<Isometry3<f64>> = standing.iter().map(|s| s.pose(&chain)).collect();
    if let Some(fault) = find_in_orientations(&standing, &flange, stations.targets, options.tool_m) {
        return Err(fault.into());
    }
    let registration = register(&standing, &flange, stations.targets, options.tool_m)?;
    if let Some(fault) = find_fault(robot, &standing, stations.targets, &registration, options.tool_m) {
        return Err(fault.into());
    }
    let linear = linearise(robot, stations, &registration, options.tool_m, turns)?;
    let noise = NoisePrior::new(stations.repeats.as_ref(), options.sigma_m);
    let mut evaluation = evaluate(&Prepared { measured, linear: &linear, noise, options }, wants_model);
    let contradicted = contradicted_noise(stations, options);
    evaluation.diagnosis.warnings.splice(0..0, contradicted);
    evaluation.diagnosis.tool_mm = registration.tools_m.first().map(|t| [t.x, t.y, t.z].map(mm_from_m));
    evaluation.diagnosis.stations = stations.stations.len();
    Ok(evaluation)
}
