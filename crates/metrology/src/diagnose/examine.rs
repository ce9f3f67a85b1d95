//! From measurements to what can be evaluated: checks of the file, one stand of the instrument, stations, registration.
//!
//! What is wrong with the file itself is said here; knows nothing of evidence.

use super::clock_reading::{ClockReading, gain_nats};
use super::cold_starts::cold_starts;
use super::evaluate::{Evaluation, Prepared, evaluate};
use super::measured_robot::MeasuredRobot;
use super::options::DiagnosisOptions;
use super::outcome::{Findings, Verdict, Warning};
use super::repeats_one_way::one_way;
use super::standstills::standstills;
use super::stated_noise::{contradicted_noise, overstated_noise};
use inference::effects::effect;
use inference::linearise::linearise;
use inference::marginal::NoisePrior;
use inference::time_course::TimeCourse;
use measurements::{
    Fault, Measurements, OneStand, RegisterError, RowCheck, StandError, Stations, check_rows,
    find_pose_names, from_one_stand, gather, gather_about, register, turned,
};
use nalgebra::Isometry3;
use robot_model::deform::identified::{FoundBy, Identified};
use robot_model::kinematics::SerialChain;
use robot_model::robot::SerialArm;
use robot_model::units::mm_from_m;
use std::collections::BTreeSet;

/// Fewer stations or poses than these say nothing.
const FEWEST_STATIONS: usize = 12;
const FEWEST_POSES: usize = 8;
/// Poses that are enough for what changes over time, where so many stations come back to them: each is held against itself.
const FEWEST_POSES_OVER_TIME: usize = 5;
const FEWEST_STATIONS_OVER_TIME: usize = 30;

/// Where cooling at a usual time constant is so much less likely, no other one is likelier than none, nats.
const HOPELESS_NATS: f64 = 20.0;

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
    let Evaluation { diagnosis, identified, .. } = examine(measurements, robot, options, true);
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
    parallel::within(&mut || examine_in_pool(measurements, robot, options, wants_model))
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
    let seen = from_one_stand(measurements, robot, &checked, options.tool_m).map_err(Unusable::from);
    let evaluation = seen.and_then(|seen| {
        warnings.extend(seen.warnings.iter().map(Warning::from));
        let stations = usable_stations(&seen, &checked, robot, options)?;
        let measured = MeasuredRobot { robot, measurements: &seen.measurements, stations: &stations };
        let mut evaluation = evaluated(measured, &seen, options, wants_model)?;
        if ClockReading::may_tell(&evaluation) {
            let at = |reading: &ClockReading| {
                let measured = MeasuredRobot { stations: &reading.stations, ..measured };
                evaluated(measured, &seen, options, wants_model).ok()
            };
            evaluation = likeliest_reading(&stations, evaluation, at);
        }
        match poses(&stations) < FEWEST_POSES && !changes_over_time(&evaluation.diagnosis) {
            true => Err(too_few(&stations)),
            false => Ok(evaluation),
        }
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

impl From<Box<Fault>> for Unusable {
    fn from(fault: Box<Fault>) -> Self {
        Self::Fault(fault)
    }
}

impl From<RegisterError> for Unusable {
    fn from(error: RegisterError) -> Self {
        Self::TooLittle(error.to_string())
    }
}

impl From<StandError> for Unusable {
    fn from(error: StandError) -> Self {
        match error {
            StandError::Fault(fault) => Self::Fault(fault),
            StandError::Register(error) => error.into(),
        }
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

/// Of the diagnosis of minutes as they are written and of those of other readings of them, which `evaluate` makes, the likeliest.
fn likeliest_reading(
    stations: &Stations,
    as_written: Evaluation,
    evaluate: impl Fn(&ClockReading) -> Option<Evaluation>,
) -> Evaluation {
    let mut likeliest = as_written;
    if let Some(reading) = cold_starts(stations)
        && let Some(anew) = evaluate(&reading)
    {
        likeliest = reading.likelier(likeliest, anew);
    }
    for reading in standstills(stations) {
        let Some(anew) = evaluate(&reading) else { break };
        let gain_nats = gain_nats(&likeliest, &anew);
        likeliest = reading.likelier(likeliest, anew);
        if gain_nats < -HOPELESS_NATS {
            break;
        }
    }
    likeliest
}

/// The stations of the rows that can be used, where those are enough.
fn usable_stations(
    seen: &OneStand<'_>,
    checked: &RowCheck,
    robot: &SerialArm,
    options: &DiagnosisOptions,
) -> Result<Stations, Unusable> {
    if let Some(fault) = find_pose_names(&seen.measurements, &seen.used) {
        return Err(fault.into());
    }
    let mut stations = in_rounds(seen, robot, options);
    stations.channels.time &= checked.time_usable;
    if !stations.channels.time {
        stations.stations.iter_mut().for_each(|s| s.t_min = None);
    }
    let poses = poses(&stations);
    let often = stations.channels.time && stations.stations.len() >= FEWEST_STATIONS_OVER_TIME;
    let enough = if often { FEWEST_POSES_OVER_TIME } else { FEWEST_POSES };
    if stations.stations.len() < FEWEST_STATIONS || poses < enough {
        return Err(too_few(&stations));
    }
    Ok(stations)
}

/// The stations of the rows that are used; rounds between which a target moved on the flange stand apart, as those do between which the base
/// did. Where nothing can be registered yet nobody knows how the flange stood to the instrument.
fn in_rounds(seen: &OneStand<'_>, robot: &SerialArm, options: &DiagnosisOptions) -> Stations {
    let stations = gather(&seen.measurements, &seen.used, options.sigma_m);
    if stations.stations.len() + stations.false_rows.len() == seen.used.len() {
        return stations;
    }
    let chain = SerialChain::nominal(robot);
    let flange: Vec<Isometry3<f64>> = stations.stations.iter().map(|station| station.pose(&chain)).collect();
    let fit = register(&stations.stations, &flange, stations.targets, options.tool_m);
    let axes = fit.map(|fit| fit.instrument_from_base.rotation);
    axes.map_or(stations, |axes| {
        gather_about(&seen.measurements, &seen.used, options.sigma_m, (&chain, &axes))
    })
}

/// How many poses stations stand in.
fn poses(stations: &Stations) -> usize {
    stations.stations.iter().map(|station| station.pose).collect::<BTreeSet<usize>>().len()
}

/// That poses are too few for what is the same from the first row to the last.
fn too_few(stations: &Stations) -> Unusable {
    let repeated = if stations.stations.len() >= FEWEST_STATIONS {
        "; how these repeat, and drift, is judged by driftpost accuracy"
    } else {
        ""
    };
    Unusable::TooLittle(format!(
        "{} different poses are too few: base and target alone take 9 unknowns; 30 spread poses say something, 60 a lot{repeated}",
        poses(stations)
    ))
}

/// Whether a diagnosis names causes that change over time, and no other.
fn changes_over_time(diagnosis: &Findings) -> bool {
    let is_named = diagnosis.verdict.names_causes();
    is_named && diagnosis.causes.iter().all(|cause| effect(cause.effect).time() != TimeCourse::Constant)
}

/// That what sags was weighed with masses that nobody stated.
fn guessed_masses(robot: &SerialArm, diagnosis: &Findings) -> Option<Warning> {
    let sags = diagnosis.causes.iter().any(|cause| cause.effect.needs_load());
    (sags && robot.geometry().links.is_none()).then(|| Warning {
        code: "diagnose::link-masses",
        message: format!(
            "the masses of the links of {} are not known and are guessed from its size: what sags otherwise than the guess says can be taken \
             for another cause beside it (link_bending, joint_gain, a gear line of the same joint), and the size of a spring is as far off as the \
             guess; [[link]] with mass_kg and com_mm in the robot file gives them",
            robot.name
        ),
    })
}

/// Registers base and target, and evaluates what that leaves.
fn evaluated(
    measured: MeasuredRobot<'_>,
    seen: &OneStand<'_>,
    options: &DiagnosisOptions,
    wants_model: bool,
) -> Result<Evaluation, Unusable> {
    let MeasuredRobot { robot, stations, .. } = measured;
    let turns = seen.elsewhere.as_ref().map(|found| found.turns(&stations.stations, robot.joints.len()));
    let turns = turns.unwrap_or_default();
    let standing = turned(&stations.stations, &turns);
    let registration = seen.registered(&standing, stations.targets, robot, options.tool_m)?;
    let overstated = overstated_noise(stations, &registration, options);
    let options = &DiagnosisOptions { sigma_m: options.sigma_m.filter(|_| overstated.is_none()), ..*options };
    let linear = linearise(robot, stations, &registration, options.tool_m, turns)?;
    if let Some(one_way) = one_way(measured.measurements, stations, &linear, options.sigma_m) {
        let apart = one_way.apart(measured.measurements, stations);
        let mut evaluation =
            evaluated(MeasuredRobot { stations: &apart, ..measured }, seen, options, wants_model)?;
        evaluation.diagnosis.warnings.insert(0, one_way.warning());
        return Ok(evaluation);
    }
    let noise = NoisePrior::new(stations.repeats.as_ref(), options.sigma_m);
    let mut evaluation = evaluate(&Prepared { measured, linear: &linear, noise, options }, wants_model);
    let guessed = guessed_masses(robot, &evaluation.diagnosis);
    evaluation.diagnosis.warnings.extend(guessed);
    let contradicted = contradicted_noise(stations, options);
    evaluation.diagnosis.warnings.splice(0..0, contradicted.or(overstated));
    evaluation.diagnosis.tool_mm = registration.tools_m.first().map(|t| [t.x, t.y, t.z].map(mm_from_m));
    evaluation.diagnosis.stations = stations.stations.len();
    Ok(evaluation)
}
