//! A file that contradicts itself or the robot: units, axes, columns, robot and tool, tried one by one.

use super::{Reading, Registration, Station, register};
use nalgebra::{Isometry3, Vector3};
use robot_model::kinematics::Chain;
use robot_model::robot::Robot;
use robot_model::units::{deg_from_rad, m_from_mm, mm_from_m, rad_from_deg};
use std::collections::BTreeSet;

/// Kinds of contradictions that are looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaultKind {
    /// Points in metres, inches.
    PositionUnits,
    /// Joints are in radians, the columns say degrees.
    JointUnits,
    /// Measured axes swapped or one with the wrong sign.
    SwappedAxes,
    /// Joint columns swapped, or counted the other way.
    JointColumns,
    /// Joints outside the robot's range.
    JointsOutOfRange,
    /// Joints rounded more coarsely than the measurement.
    RoundedJoints,
    /// The tool is not the one named.
    WrongTool,
    /// The points fit another robot.
    WrongRobot,
    /// Nothing fits, reason not found.
    NothingFits,
}

/// A contradiction, and what it rests on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Kind of the contradiction.
    pub kind: FaultKind,
    /// One sentence for people.
    pub reason: String,
}

/// A registered robot leaves less than this in the middle, however badly calibrated.
const SOUND_M: f64 = 4e-3;
/// What is left beyond this with no explanation is no measurement of this robot.
const HOPELESS_M: f64 = 10e-3;
/// An explanation must leave this share of the distance or less.
const EXPLAINED: f64 = 0.2;
/// Further from the named tool than this is a fault.
const TOOL_M: f64 = 5e-3;
/// Stations used for the trials.
const TRIAL_STATIONS: usize = 80;

/// Looks for a reason why `registration` leaves what it leaves.
#[must_use]
pub fn find_fault(
    robot: &Robot,
    stations: &[Station],
    targets: usize,
    registration: &Registration,
    tool_m: Option<Vector3<f64>>,
) -> Option<Fault> {
    if registration.median_m > SOUND_M {
        let few = trial(stations);
        let found = units(robot, &few, targets, registration)
            .or_else(|| axes(robot, &few, targets, registration))
            .or_else(|| joints(robot, &few, targets, registration))
            .or_else(|| other_robot(robot, &few, targets, registration));
        if found.is_some() {
            return found;
        }
        if registration.median_m > HOPELESS_M {
            return Some(Fault {
                kind: FaultKind::NothingFits,
                reason: format!(
                    "with base and tool fitted the points still miss the model of {} by {:.1} mm in the middle: wrong robot, \
                     wrong joint columns, or points and joints that do not belong together",
                    robot.name,
                    mm_from_m(registration.median_m)
                ),
            });
        }
    }
    let (tool, fitted) = (tool_m?, registration.tools_m.first()?);
    let off_m = (fitted - tool).norm();
    (targets == 1 && off_m > TOOL_M + 3.0 * registration.tool_sigma_m).then(|| Fault {
        kind: FaultKind::WrongTool,
        reason: format!(
            "the points say the tool is at ({:.1}, {:.1}, {:.1}) mm from the flange, {:.1} mm from the one given",
            mm_from_m(fitted.x),
            mm_from_m(fitted.y),
            mm_from_m(fitted.z),
            mm_from_m(off_m)
        ),
    })
}

/// A few stations from all over the file, at steps of the golden section: every n-th of poses that come round again could
/// be the same pose each time.
fn trial(stations: &[Station]) -> Vec<Station> {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let n = stations.len();
    if n <= TRIAL_STATIONS {
        return stations.to_vec();
    }
    let picked: BTreeSet<usize> =
        (0..TRIAL_STATIONS).map(|k| ((k as f64 * GOLDEN).fract() * n as f64) as usize).collect();
    picked.into_iter().filter_map(|index| stations.get(index)).cloned().collect()
}

/// The middle distance that a changed file would leave, metres.
fn left_m(robot: &Robot, stations: &[Station], targets: usize) -> Option<f64> {
    let chain = Chain::nominal(robot);
    let poses: Vec<Isometry3<f64>> = stations.iter().map(|s| s.pose(&chain)).collect();
    register(stations, &poses, targets, None).ok().map(|fit| fit.median_m)
}

fn try_change(
    robot: &Robot,
    stations: &[Station],
    targets: usize,
    change: impl Fn(&mut Station),
) -> Option<f64> {
    let mut changed = stations.to_vec();
    changed.iter_mut().for_each(change);
    left_m(robot, &changed, targets)
}

fn explains(left_m: Option<f64>, scale: f64, registration: &Registration) -> bool {
    left_m.is_some_and(|left_m| left_m * scale < (EXPLAINED * registration.median_m).min(2.0 * SOUND_M))
}

fn units(robot: &Robot, stations: &[Station], targets: usize, registration: &Registration) -> Option<Fault> {
    let largest_rad = stations.iter().flat_map(|s| s.q_rad).fold(0.0, |a: f64, q| a.max(q.abs()));
    if largest_rad < rad_from_deg(7.0) {
        let left = try_change(robot, stations, targets, |s| s.q_rad = s.q_rad.map(deg_from_rad));
        if explains(left, 1.0, registration) {
            return Some(Fault {
                kind: FaultKind::JointUnits,
                reason: "the joints are in radians, the columns say degrees".to_owned(),
            });
        }
    }
    let scales = [(1000.0, "metres"), (25.4, "inches"), (10.0, "centimetres"), (0.001, "micrometres")];
    for (scale, name) in scales {
        let left = try_change(robot, stations, targets, |s| s.reading = s.reading.scaled(scale));
        if explains(left, 1.0, registration) || (left.is_some_and(|l| l < SOUND_M) && scale > 1.0) {
            return Some(Fault {
                kind: FaultKind::PositionUnits,
                reason: format!("the measured points are in {name}, the columns say mm"),
            });
        }
    }
    let both = try_change(robot, stations, targets, |s| {
        s.q_rad = s.q_rad.map(deg_from_rad);
        s.reading = s.reading.scaled(1.0 / m_from_mm(1.0));
    });
    (largest_rad < rad_from_deg(7.0) && both.is_some_and(|left| left < SOUND_M)).then(|| Fault {
        kind: FaultKind::JointUnits,
        reason: "the joints are in radians and the points in metres, the columns say degrees and mm"
            .to_owned(),
    })
}

/// Every other order or sign is a turn, which the registration takes: only the mirror shows.
fn axes(robot: &Robot, stations: &[Station], targets: usize, registration: &Registration) -> Option<Fault> {
    let mirrored = try_change(robot, stations, targets, |s| {
        if let Reading::Point { position_m } | Reading::Nest { position_m, .. } = &mut s.reading {
            position_m.swap_rows(0, 1);
        }
        s.orientation = None;
    });
    explains(mirrored, 1.0, registration).then(|| Fault {
        kind: FaultKind::SwappedAxes,
        reason: "the measured points are mirrored: two of x, y, z are swapped, or one has the wrong sign"
            .to_owned(),
    })
}

fn joints(robot: &Robot, stations: &[Station], targets: usize, registration: &Registration) -> Option<Fault> {
    let mut best: Option<(f64, String)> = None;
    let mut offer = |left: Option<f64>, what: String| {
        if let Some(left) = left
            && best.as_ref().is_none_or(|(b, _)| left < *b)
        {
            best = Some((left, what));
        }
    };
    for a in 0..6 {
        let flipped = try_change(robot, stations, targets, |s| s.q_rad[a] = -s.q_rad[a]);
        offer(flipped, format!("joint {} is counted the other way round", a + 1));
        for b in a + 1..6 {
            let swapped = try_change(robot, stations, targets, |s| s.q_rad.swap(a, b));
            offer(swapped, format!("the columns of joints {} and {} are swapped", a + 1, b + 1));
        }
    }
    let coupled = try_change(robot, stations, targets, |s| s.q_rad[2] += s.q_rad[1]);
    offer(coupled, "joint 3 is counted from the horizontal: joint 2 has to be added".to_owned());
    let coupled = try_change(robot, stations, targets, |s| s.q_rad[2] -= s.q_rad[1]);
    offer(coupled, "joint 3 is counted from the horizontal: joint 2 has to be taken off".to_owned());
    let (left, reason) = best?;
    explains(Some(left), 1.0, registration).then_some(Fault { kind: FaultKind::JointColumns, reason })
}

fn other_robot(
    robot: &Robot,
    stations: &[Station],
    targets: usize,
    registration: &Registration,
) -> Option<Fault> {
    let mut best: Option<(f64, &str)> = None;
    for name in Robot::built_in_names() {
        let Some(other) = Robot::built_in(name) else { continue };
        if other.name == robot.name {
            continue;
        }
        if let Some(left) = left_m(&other, stations, targets)
            && best.is_none_or(|(b, _)| left < b)
        {
            best = Some((left, name));
        }
    }
    let (left, name) = best?;
    explains(Some(left), 1.0, registration).then(|| Fault {
        kind: FaultKind::WrongRobot,
        reason: format!(
            "the points fit {name} ({:.2} mm), not {} ({:.1} mm)",
            mm_from_m(left),
            robot.name,
            mm_from_m(registration.median_m)
        ),
    })
}
