//! Performance after ISO 9283 of a whole measurement file: pose by pose, and over time.

use super::pose_performance::{PosePerformance, pose_performance};
use super::register::to_judge_poses_in;
use super::station::pose_numbers;
use super::{
    FreeParameters, Measurements, OneStand, Reading, RegisterError, Registration, RowCheck, Station,
    Stations, check_cycles, from_sound_file, gather, register, register_with, tool_apart,
};
use nalgebra::{Isometry3, Vector3};
use rapid_syntax::diagnostic::{Diagnostic, first_few, plural};
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Joints, SerialArm};
use robot_model::units::mm_from_m;
use statistics::median;
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

/// Cycles without which nothing is said of one of them.
const FEWEST_CYCLES: usize = 3;
/// A cycle is far off by so many times the middle distance, and by so much at least, metres.
const FAR_TIMES: f64 = 20.0;
const FAR_M: f64 = 1e-3;
/// Of fewer cycles than this the middle distance is known too badly, and it has to be off by as many times as much.
const FEW_CYCLES: usize = 5;
const FURTHER_OF_FEW: f64 = 5.0;
/// AP that is smaller by less than this share for what was fitted is not worth a word.
const WORTH_TELLING: f64 = 0.1;
/// Of more rows so many are asked whether they contradict the robot; each asks the others.
const MOST_CHECKED: usize = 6000;
/// Lines that a message lists at most.
const LISTED: usize = 12;

/// Why a file's performance cannot be judged.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PerformanceError {
    /// Base and tool cannot be fitted.
    #[error(transparent)]
    Register(#[from] RegisterError),
    /// Touches and lengths only.
    #[error("the file has no measured points: fixed points and lengths say nothing of accuracy")]
    NoPoints,
    /// One place on the flange is known, and the file has several targets.
    #[error(
        "the file has points of {} targets ({}), and --tool is the place of one: those of the others are not known",
        targets.len(),
        targets.join(", ")
    )]
    SeveralTargets {
        /// Their names as the column `target` has them.
        targets: Vec<String>,
    },
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
            Self::SeveralTargets { .. } => "measure::several-targets",
            Self::Fault { .. } => "measure::fault",
        }
    }
}

impl From<PerformanceError> for Diagnostic {
    fn from(error: PerformanceError) -> Self {
        let message = Self::error(error.code(), error.to_string());
        match error {
            PerformanceError::SeveralTargets { .. } => message.help(
                "--register base,tool fits the place of each; or judge one alone: only = { column = \"target\", is = [\"NAME\"] } in a column \
                 map (--columns)",
            ),
            PerformanceError::Register(_) => message.help(
                "accuracy needs more poses; repeatability does not, but rows that repeat one pose with joints as the encoders read them \
                 need one `pose_id`",
            ),
            _ => message,
        }
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

/// Performance of the robot in a whole file.
#[derive(Clone, Debug, PartialEq)]
pub struct Performance {
    /// In the order of the first rows.
    pub poses: Vec<PosePerformance>,
    /// Largest distance between the barycentres of one pose come to from several sides with one payload, metres: vAP_p; `None` where
    /// the file tells no sides.
    pub multi_directional_m: Option<f64>,
    /// The registration in which they were compared; `None` where so few poses place no base: repeatability alone is given.
    pub registration: Option<Registration>,
    /// Lines of the rows that are not judged: the robot cannot have their joints.
    pub lines_left_out: Vec<u64>,
    /// What a person should look at in the rows.
    pub warnings: Vec<Diagnostic>,
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
    let checked = check_cycles(measurements, robot);
    if let Some(fault) = checked.fault {
        return Err(PerformanceError::Fault { reason: fault.reason });
    }
    if !measurements.rows.iter().any(|row| matches!(row.reading, Reading::Point { .. })) {
        return Err(PerformanceError::NoPoints);
    }
    if compared != ComparisonFrame::Fitted {
        one_target(measurements)?;
    }
    let measurements = with_usable_times(measurements, checked.time_usable);
    let seen = judged(&measurements, robot, &checked)?;
    let measurements = &*seen.measurements;
    if compared != ComparisonFrame::Fitted {
        // One that was put elsewhere in the middle of the file is a second one, whose place is not known.
        one_target(measurements)?;
    }
    let used = in_order_of_time(measurements, &seen.used);
    let gathered = gather(measurements, &used, None);
    let chain = SerialChain::nominal(robot);
    let registration = match registered(&gathered.stations, gathered.targets, &chain, compared) {
        Ok(registration) => Some(registration),
        Err(_) if gathered.stations.iter().any(|station| station.rows.len() > 1) => None,
        Err(error) => return Err(error.into()),
    };
    let poses = pose_by_pose(measurements, &used, &chain, registration.as_ref());
    let few = registration.as_ref().and_then(|_| few_poses(&gathered.stations, gathered.targets, compared));
    let apart = tool_elsewhere(&gathered, &chain, compared);
    let unsettled = registration.as_ref().and_then(unsettled);
    let far = far_cycles(measurements, &used);
    let left_out = checked.out_of_range.iter().filter_map(|&row| measurements.rows.get(row));
    Ok(Performance {
        multi_directional_m: multi_directional_m(&poses),
        poses,
        registration,
        lines_left_out: left_out.map(|row| row.line).collect(),
        warnings: checked
            .warnings
            .into_iter()
            .chain(seen.warnings)
            .chain(few)
            .chain(apart)
            .chain(unsettled)
            .chain(far)
            .collect(),
    })
}

/// That what is fitted takes much of the accuracy of so few poses: of 3 numbers a pose each that is fitted takes one from the sum of squares.
fn few_poses(stations: &[Station], targets: usize, compared: ComparisonFrame) -> Option<Diagnostic> {
    let (what, fitted, less) = match compared {
        ComparisonFrame::Fitted => (
            "base and target",
            FreeParameters::All.unknowns(targets),
            "fit less (--register base, or none) where target and base are known",
        ),
        ComparisonFrame::BaseFitted(_) => (
            "the base",
            FreeParameters::Base.unknowns(targets),
            "fit nothing (--register none) where the base is known",
        ),
        ComparisonFrame::AsMeasured(_) => return None,
    };
    let poses = placed_poses(stations);
    let seen = 3 * poses;
    let smaller_by = 1.0 - (1.0 - fitted as f64 / seen as f64).max(0.0).sqrt();
    (smaller_by > WORTH_TELLING).then(|| {
        let text = format!(
            "{what} ({fitted} numbers) are fitted to the {seen} of {} poses: AP comes out smaller than it is, by some {:.0} % in the middle of many such \
             measurements",
            poses,
            100.0 * smaller_by
        );
        Diagnostic::warning("measure::few-poses", text)
            .help(format!("measure more poses, spread ones; or {less}"))
    })
}

/// How many poses, of each target, base and target are fitted to.
fn placed_poses(stations: &[Station]) -> usize {
    stations.iter().map(|s| (s.pose, s.target)).collect::<BTreeSet<_>>().len()
}

/// That the fit in which the poses were compared has not come to rest: AP holds what is left of it.
fn unsettled(registration: &Registration) -> Option<Diagnostic> {
    (!registration.converged).then(|| {
        Diagnostic::warning(
            "measure::registration",
            "the fit of base and target does not come to rest: AP and its drift hold what is left of it",
        )
        .help("measure more poses, spread ones; or fit less (--register base, or none) where target and base are known")
    })
}

/// That the points have the one target elsewhere than it is taken to be: all of the difference counts as the arm's.
fn tool_elsewhere(gathered: &Stations, chain: &SerialChain, compared: ComparisonFrame) -> Option<Diagnostic> {
    let Stations { stations, targets: 1, .. } = gathered else { return None };
    let (ComparisonFrame::BaseFitted(tool_m) | ComparisonFrame::AsMeasured(tool_m)) = compared else {
        return None;
    };
    let flange: Vec<Isometry3<f64>> = stations.iter().map(|station| station.pose(chain)).collect();
    let fitted = register(stations, &flange, 1, None).ok()?;
    // A pose from both sides, or with two payloads, shows the target in one place.
    let poses: BTreeSet<usize> = stations.iter().map(|station| station.pose).collect();
    let apart = tool_apart(&fitted, 1, Some(tool_m), poses.len())?;
    let [x, y, z] = <[f64; 3]>::from(apart.fitted_m).map(mm_from_m);
    let text = format!(
        "the points say that the target is at ({x:.1}, {y:.1}, {z:.1}) mm from the flange, {:.1} mm from --tool: AP holds the difference",
        mm_from_m(apart.apart_m)
    );
    Some(
        Diagnostic::warning("measure::tool-apart", text)
            .help("is --tool in mm, and of this target? --register base,tool fits its place"),
    )
}

/// The rows that are judged: those of one stand of the instrument, which do not contradict the robot.
fn judged<'a>(
    measurements: &'a Measurements,
    robot: &SerialArm,
    checked: &RowCheck,
) -> Result<OneStand<'a>, PerformanceError> {
    let every = checked.used.len().div_ceil(MOST_CHECKED).max(1);
    let some = RowCheck { used: checked.used.iter().copied().step_by(every).collect(), ..checked.clone() };
    let seen = from_sound_file(measurements, robot, &some)
        .map_err(|fault| PerformanceError::Fault { reason: fault.reason })?;
    if every == 1 {
        return Ok(seen);
    }
    // What was moved, or is no reading, is neither taken back nor left out in rows that were not asked.
    let advice = |warning: &Diagnostic| match warning.code {
        "measure::instrument-moved" | "measure::target-moved" => Some("judge the parts apart"),
        "measure::code-for-none" => Some("leave those cells empty, and those of the other rows that hold it"),
        _ => None,
    };
    if let Some((found, advice)) = seen.warnings.iter().find_map(|w| Some((w, advice(w)?))) {
        return Err(PerformanceError::Fault { reason: format!("{}; {advice}", found.message) });
    }
    let mut whole = OneStand::as_it_is(measurements, checked.used.clone());
    whole.warnings = seen.warnings;
    Ok(whole)
}

/// Refuses points of several targets, of which one has a known place.
fn one_target(measurements: &Measurements) -> Result<(), PerformanceError> {
    let points = measurements.rows.iter().filter(|row| matches!(row.reading, Reading::Point { .. }));
    let targets: BTreeSet<usize> = points.map(|row| row.target).collect();
    if targets.len() < 2 {
        return Ok(());
    }
    let name = |target| match measurements.targets.get(target).map_or("", String::as_str) {
        "" => "one without a name".to_owned(),
        name => name.to_owned(),
    };
    Err(PerformanceError::SeveralTargets { targets: targets.into_iter().map(name).collect() })
}

/// The measurements without minutes where these cannot be trusted.
fn with_usable_times(measurements: &Measurements, time_usable: bool) -> Cow<'_, Measurements> {
    let mut measurements = Cow::Borrowed(measurements);
    if !time_usable {
        measurements.to_mut().rows.iter_mut().for_each(|row| row.t_min = None);
    }
    measurements
}

/// The rows of the arm that `used` names, in the order of their minutes; without any, in the file's. A nest on the base is no pose: seen in a
/// place of its own it tells nothing of base and target, and would only pull the weights of the points.
fn in_order_of_time(measurements: &Measurements, used: &[usize]) -> Vec<usize> {
    let t_min = |row: usize| measurements.rows.get(row).and_then(|row| row.clock_min()).unwrap_or_default();
    let of_arm = |&row: &usize| measurements.rows.get(row).is_some_and(|row| row.reading.involves_arm());
    let mut used: Vec<usize> = used.iter().copied().filter(of_arm).collect();
    sorting::by(&mut used, |a, b| t_min(*a).total_cmp(&t_min(*b)));
    used
}

/// Single cycles that lie so far from the others of their pose that it is no arm that came there: a reading of something else.
fn far_cycles(measurements: &Measurements, used: &[usize]) -> Option<Diagnostic> {
    type Cycle = (u64, Vector3<f64>);
    let mut of_pose: BTreeMap<(usize, usize), Vec<Cycle>> = BTreeMap::new();
    for (&row, pose) in used.iter().zip(pose_numbers(measurements, used)) {
        let Some(row) = measurements.rows.get(row) else { continue };
        if let Reading::Point { position_m } = row.reading {
            of_pose.entry((pose, row.target)).or_default().push((row.line, position_m));
        }
    }
    let far = of_pose.values().filter(|cycles| cycles.len() >= FEWEST_CYCLES).flat_map(|cycles| {
        let middle =
            Vector3::from_fn(|k, _| median(&mut cycles.iter().map(|(_, at)| at[k]).collect::<Vec<f64>>()));
        let off_m: Vec<f64> = cycles.iter().map(|(_, at)| (at - middle).norm()).collect();
        let further = if cycles.len() < FEW_CYCLES { FURTHER_OF_FEW } else { 1.0 };
        let limit_m = further * (FAR_TIMES * median(&mut off_m.clone())).max(FAR_M);
        let is_far = cycles.iter().zip(off_m).filter(move |(_, off_m)| *off_m > limit_m);
        is_far.map(|((line, _), off_m)| (*line, off_m)).collect::<Vec<(u64, f64)>>()
    });
    let mut far: Vec<(u64, f64)> = far.collect();
    sorting::by_key(&mut far, |(line, _)| *line);
    let (_, furthest_m) = far.iter().copied().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let lines: Vec<u64> = far.iter().map(|(line, _)| *line).collect();
    let shown = format!("{} {}", plural(lines.len(), "line"), first_few(&lines, LISTED));
    Some(
        Diagnostic::warning(
            "measure::far-cycle",
            format!(
                "{shown}: up to {:.1} mm from the other cycles of the pose, and counted",
                mm_from_m(furthest_m)
            ),
        )
        .help("AP and RP are made by it: take the row out if the instrument, not the robot, was at fault"),
    )
}

/// The performance of each pose from each side with each payload, in the order of their first rows.
fn pose_by_pose(
    measurements: &Measurements,
    used: &[usize],
    chain: &SerialChain,
    registration: Option<&Registration>,
) -> Vec<PosePerformance> {
    type Side = (usize, usize, Option<Joints<i8>>, u64);
    let mut groups: BTreeMap<Side, Vec<usize>> = BTreeMap::new();
    for (&row, pose) in used.iter().zip(pose_numbers(measurements, used)) {
        let Some(r) = measurements.rows.get(row).filter(|r| matches!(r.reading, Reading::Point { .. }))
        else {
            continue;
        };
        let payload = r.payload_kg.map_or(u64::MAX, f64::to_bits);
        groups.entry((pose, r.target, r.direction, payload)).or_default().push(row);
    }
    let mut all: Vec<PosePerformance> = groups
        .iter()
        .filter_map(|((pose, ..), rows)| pose_performance(measurements, chain, registration, *pose, rows))
        .collect();
    sorting::by_key(&mut all, |p| p.line);
    all
}

/// vAP_p: largest distance between the barycentres of one pose come to from several sides, as the directions of its rows tell them. A side
/// with another payload or at another time sags or drifts besides.
fn multi_directional_m(poses: &[PosePerformance]) -> Option<f64> {
    let mut sides: BTreeMap<(usize, usize, Option<u64>), Vec<&PosePerformance>> = BTreeMap::new();
    for p in poses.iter().filter(|p| p.direction.is_some()) {
        sides.entry((p.pose, p.target, p.payload_kg.map(f64::to_bits))).or_default().push(p);
    }
    let apart = |sides: &Vec<&PosePerformance>| {
        let pairs = sides.iter().enumerate().flat_map(|(i, a)| sides[i + 1..].iter().map(move |b| (a, b)));
        let pairs = pairs.filter(|(a, b)| a.is_at_the_time_of(b));
        pairs.map(|(a, b)| (a.barycentre_m - b.barycentre_m).norm()).reduce(f64::max)
    };
    sides.values().filter_map(apart).reduce(f64::max)
}

fn registered(
    stations: &[Station],
    targets: usize,
    chain: &SerialChain,
    compared: ComparisonFrame,
) -> Result<Registration, RegisterError> {
    let flange: Vec<Isometry3<f64>> = stations.iter().map(|s| s.pose(chain)).collect();
    let tools = |tool_m: Vector3<f64>| vec![tool_m; targets];
    let (fit, free) = match compared {
        ComparisonFrame::Fitted => (register(stations, &flange, targets, None)?, FreeParameters::All),
        ComparisonFrame::BaseFitted(tool_m) => {
            let free = FreeParameters::Base;
            (register_with(stations, &flange, &tools(tool_m), free)?, free)
        }
        ComparisonFrame::AsMeasured(tool_m) => {
            let free = FreeParameters::Nothing(Isometry3::identity());
            (register_with(stations, &flange, &tools(tool_m), free)?, free)
        }
    };
    Ok(to_judge_poses_in(fit, stations, &flange, free, placed_poses(stations)))
}

#[cfg(test)]
mod tests;
