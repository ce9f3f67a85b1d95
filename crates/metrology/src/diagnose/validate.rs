//! A model against measurements that it has not seen.

use super::identify::{PredictedStations, predicted};
use measurements::{
    FreeParameters, Measurements, RegisterError, Registration, Station, describe_false_repeats, gather,
    register_near, register_with,
};
use nalgebra::{Isometry3, Vector3};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::GrowthLaw;
use robot_model::deform::identified::Identified;
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Axis, SerialArm};
use robot_model::units::{mm_from_m, rad_from_deg};
use serde::Serialize;
use std::sync::Arc;
use warm_up::{Standstill, warm_minutes};

/// What of the registration is fitted again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RefitScope {
    /// Base and tool are fitted again.
    BaseAndTool,
    /// The base; the tool is the model's.
    Base,
    /// Nothing is fitted: base and tool are as the model has them.
    Nothing,
}

/// Why a model cannot be validated.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ValidateError {
    /// Too few or too alike poses.
    #[error(transparent)]
    Register(#[from] RegisterError),
    /// The file's joints are not the arm's.
    #[error("{reason}")]
    Joints {
        /// Which the file has and which the arm.
        reason: String,
    },
    /// The model's joints are not the arm's.
    #[error("the model is of an arm of {known} joints, which do not move as those of {robot} do")]
    ModelJoints {
        /// Joints of the model.
        known: usize,
        /// Name of the arm.
        robot: String,
    },
    /// The model does not say how the target hung on the flange.
    #[error("the model has no [mounting]: only --register base,tool can be used")]
    NoMounting,
    /// The model has fewer targets.
    #[error("the model knows {known} targets, the file has {found}: use --register base,tool")]
    Targets {
        /// Targets that the model has mountings of.
        known: usize,
        /// Targets in the measurement file.
        found: usize,
    },
}

impl ValidateError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Register(error) => error.code(),
            Self::Joints { .. } => "measure::fault",
            Self::ModelJoints { .. } => "model::joints",
            Self::NoMounting | Self::Targets { .. } => "model::mounting",
        }
    }
}

impl From<ValidateError> for Diagnostic {
    fn from(error: ValidateError) -> Self {
        Self::error(error.code(), error.to_string())
    }
}

/// Statistics of the distances between the points that were measured and where they were expected, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct DistanceStatistics {
    /// Root mean square distance, mm.
    pub rms_mm: f64,
    /// Mean distance, mm.
    pub mean_mm: f64,
    /// Largest distance, mm.
    pub max_mm: f64,
}

/// The model's and the nominal arm's distances over some of the poses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct PoseSubset {
    /// Number of poses compared; readings of one pose within ten minutes are one, their mean.
    pub n: usize,
    /// How many readings these are.
    pub readings: usize,
    /// Distances that the model leaves.
    #[serde(flatten)]
    pub model: DistanceStatistics,
    /// Distances that the nominal arm leaves.
    pub nominal: DistanceStatistics,
}

/// What a model leaves of measurements that it has not seen.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Validation {
    /// All poses of the file.
    #[serde(flatten)]
    pub all: PoseSubset,
    /// Those within the joint ranges in which the model was found.
    pub inside: PoseSubset,
    /// Poses with a joint outside those ranges.
    pub outside: PoseSubset,
    /// Each outside joint with how many poses: `[joint, poses]`.
    pub joints_outside: Vec<(Axis, usize)>,
    /// Rows with the largest distance: line and mm.
    pub worst: Vec<(u64, f64)>,
    /// That readings far from the others of their pose were left out.
    #[serde(skip)]
    pub left_out: Option<Diagnostic>,
}

/// A joint this far outside the range is still inside.
const SLACK_DEG: f64 = 1.0;
/// The same of one that slides, metres.
const SLACK_M: f64 = 1e-3;

/// Applies `model` to the rows of `measurements` that `used` names, all in the frame of one stand of the instrument, the registration that `which` names fitted again; the robot stood in `stops`, which counts where the
/// model's drift follows one law.
///
/// # Errors
/// [`ValidateError`]
pub fn validate(
    (measurements, used): (&Measurements, &[usize]),
    robot: &SerialArm,
    model: &Identified,
    which: RefitScope,
    stops: &[Standstill],
) -> Result<Validation, ValidateError> {
    if model.joint_kinds != robot.kinds() {
        return Err(ValidateError::ModelJoints { known: model.joint_kinds.len(), robot: robot.name.clone() });
    }
    let mut gathered = gather(measurements, used, None);
    set_warm_minutes(&mut gathered.stations, model, stops);
    let (stations, targets) = (&gathered.stations, gathered.targets);
    let chain = SerialChain::nominal(robot);
    let nominal: Vec<Isometry3<f64>> = stations.iter().map(|s| s.pose(&chain)).collect();
    let start = registered(stations, &nominal, targets, model, which)?;
    let payload_m = model.mounting.as_ref().and_then(|mounting| mounting.payload_m);
    let payload_m = payload_m.unwrap_or_else(|| start.payload_m());
    let PredictedStations { stations: seen, poses } =
        predicted(&Arc::new(robot.clone()), stations, &Arc::new(model.clone()), payload_m);
    let fitted = registered(&seen, &poses, targets, model, which)?;
    let mut rows: Vec<Distance> = Vec::new();
    for i in (0..stations.len()).filter(|&i| stations[i].reading.involves_arm()) {
        let place = Distance {
            line: stations[i].rows.first().and_then(|&r| measurements.rows.get(r)).map_or(0, |r| r.line),
            weight: stations[i].rows.len(),
            model_m: fitted.residual_m(&seen[i], &poses[i]).norm(),
            nominal_m: start.residual_m(&stations[i], &nominal[i]).norm(),
            outside: (0..robot.joints.len()).filter(|&j| outside(model, &stations[i], j)).collect(),
        };
        rows.push(place);
    }
    let mut worst: Vec<(u64, f64)> = rows.iter().map(|d| (d.line, mm_from_m(d.model_m))).collect();
    sorting::by(&mut worst, |a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
    worst.truncate(10);
    Ok(Validation {
        all: part(rows.iter()),
        inside: part(rows.iter().filter(|d| d.outside.is_empty())),
        outside: part(rows.iter().filter(|d| !d.outside.is_empty())),
        joints_outside: (0..robot.joints.len())
            .map(|j| (Axis::at(j), rows.iter().filter(|d| d.outside.contains(&j)).count()))
            .filter(|(_, poses)| *poses > 0)
            .collect(),
        worst,
        left_out: describe_false_repeats(measurements, &gathered),
    })
}

/// The law and the time constant of cooling by which a model's drift follows the robot's warmth; `None` where it follows several laws, or the
/// clock alone.
#[must_use]
pub fn warming(model: &Identified) -> Option<(GrowthLaw, f64)> {
    let law = model.warm_up_law()?.law;
    if !model.drifts_beside(law).is_empty() {
        return None;
    }
    Some((law, model.tau_cool_min.or(law.tau_min())?))
}

/// On the model's own clock: a robot that stood is as warm as one that has worked since it was cold for some minutes less.
fn set_warm_minutes(stations: &mut [Station], model: &Identified, stops: &[Standstill]) {
    let Some((law, tau_cool_min)) = warming(model).filter(|_| !stops.is_empty()) else { return };
    for station in stations {
        let warm = |t_min: f64| warm_minutes(law, tau_cool_min, stops, &[t_min]).first().copied();
        station.t_min = station.t_min.and_then(warm);
    }
}

struct Distance {
    line: u64,
    weight: usize,
    model_m: f64,
    nominal_m: f64,
    outside: Vec<usize>,
}

fn outside(model: &Identified, station: &Station, j: usize) -> bool {
    let seen = model.measured_range.q_rad.as_ref();
    let Some([low, high]) = seen.and_then(|q_rad| q_rad.get(j).copied()) else { return false };
    let slides = model.joint_kinds.get(j).is_some_and(|kind| kind.slides());
    let slack_rad = if slides { SLACK_M } else { rad_from_deg(SLACK_DEG) };
    let q_rad = station.q_rad[j];
    q_rad < low - slack_rad || q_rad > high + slack_rad
}

fn part<'a>(rows: impl Iterator<Item = &'a Distance> + Clone) -> PoseSubset {
    let distances = |of: fn(&Distance) -> f64| {
        let n: usize = rows.clone().map(|d| d.weight).sum();
        let over = 1.0 / n.max(1) as f64;
        // The sum of no numbers is -0.
        let weighted = |f: &dyn Fn(f64) -> f64| {
            rows.clone().map(|d| f(of(d)) * d.weight as f64).fold(0.0, |sum, one| sum + one) * over
        };
        DistanceStatistics {
            rms_mm: mm_from_m(weighted(&|m| m * m).sqrt()),
            mean_mm: mm_from_m(weighted(&|m| m)),
            max_mm: mm_from_m(rows.clone().map(of).fold(0.0, f64::max)),
        }
    };
    PoseSubset {
        n: rows.clone().count(),
        readings: rows.clone().map(|d| d.weight).sum(),
        model: distances(|d| d.model_m),
        nominal: distances(|d| d.nominal_m),
    }
}

/// Base and tools: fitted, or as the model has them.
fn registered(
    stations: &[Station],
    poses: &[Isometry3<f64>],
    targets: usize,
    model: &Identified,
    which: RefitScope,
) -> Result<Registration, ValidateError> {
    let known = || -> Result<(Isometry3<f64>, Vec<Vector3<f64>>), ValidateError> {
        let mounting = model.mounting.as_ref().ok_or(ValidateError::NoMounting)?;
        if mounting.tools_m.len() != targets {
            return Err(ValidateError::Targets { known: mounting.tools_m.len(), found: targets });
        }
        Ok((mounting.instrument_from_base, mounting.tools_m.clone()))
    };
    match which {
        RefitScope::BaseAndTool => {
            let tools_m = model.mounting.as_ref().map(|mounting| mounting.tools_m.as_slice());
            Ok(register_near(stations, poses, targets, tools_m)?)
        }
        RefitScope::Base => Ok(register_with(stations, poses, &known()?.1, FreeParameters::Base)?),
        RefitScope::Nothing => {
            let (instrument_from_base, tools_m) = known()?;
            Ok(register_with(stations, poses, &tools_m, FreeParameters::Nothing(instrument_from_base))?)
        }
    }
}
