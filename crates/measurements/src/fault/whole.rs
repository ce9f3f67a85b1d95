//! What is wrong with all rows at once: units, axes, columns, robot and tool, tried one by one.

use super::FURTHEST_ZERO_RAD;
use super::change::{Change, DEG_PER_GON, LENGTHS, TURN_RAD, changes};
use super::trials::{few, left_m, most_m, trial};
use super::{Fault, FaultKind, frozen, pasted, scale};
use crate::register::register_from_usual_starts;
use crate::{Reading, Registration, Station};
use nalgebra::Vector3;
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Axis, Robot, SerialArm};
use robot_model::units::{deg_from_rad, m_from_mm, mm_from_m, rad_from_deg};
use statistics::MEDIAN_NORM_3D;
use std::f64::consts::{PI, TAU};

/// A registered robot leaves less than this in the middle, however badly calibrated.
pub(super) const SOUND_M: f64 = 4e-3;
/// What is left beyond this with no explanation is no measurement of this robot.
const HOPELESS_M: f64 = 10e-3;
/// An explanation must leave this share of the distance or less.
const EXPLAINED: f64 = 0.2;
/// Of explanations that leave about as much the more usual one holds, which is tried first.
const CLEARLY: f64 = 0.7;
/// Zeros of a joint that are tried over a turn, before the best is narrowed down.
const ZEROS: usize = 12;
/// Steps of the golden section from there, each to 0.618 of the last: from 60 deg to under 0.01 deg.
const ZERO_NARROWINGS: usize = 20;
/// Nearer to the named tool than this it is the same, and no fault, metres.
pub const TOOL_M: f64 = 5e-3;
/// What an arm's own errors may make the points miss a tool by that is held: over a few degrees a joint that is off moves them as a tool does.
const HELD_M: f64 = 1.5e-3;

/// One column, or two, in another unit, order or sign or from another zero, where that is what makes the points fit.
#[must_use]
pub fn find_in_columns(robot: &SerialArm, stations: &[Station], targets: usize) -> Option<Fault> {
    let stations = few(stations);
    let left_m = left_m(robot, &stations, targets).filter(|left_m| *left_m > SOUND_M)?;
    let trial = Trial { robot, stations, targets, left_m };
    trial.cells().or_else(|| trial.zero())
}

/// Looks for a reason why `registration` leaves what it leaves.
#[must_use]
pub fn find_fault(
    robot: &SerialArm,
    stations: &[Station],
    targets: usize,
    registration: &Registration,
    tool_m: Option<Vector3<f64>>,
) -> Option<Fault> {
    let chain = SerialChain::nominal(robot);
    let mut off_m: Vec<f64> =
        stations.iter().map(|s| registration.residual_m(s, &s.pose(&chain)).norm()).collect();
    let left_m = most_m(&mut off_m);
    if left_m > SOUND_M {
        let trial = Trial::of(robot, trial(stations), targets, left_m);
        let found = trial
            .cells()
            .or_else(|| trial.other_robot())
            .or_else(|| trial.frozen_joint(stations))
            .or_else(|| trial.zero());
        if found.is_some() {
            return found;
        }
        if left_m > HOPELESS_M {
            if let Some(fault) = pasted::find(robot, stations) {
                return Some(fault);
            }
            return Some(Fault::of_all(
                FaultKind::NothingFits,
                None,
                format!(
                    "with base and tool fitted most points still miss the model of {} by up to {:.1} mm: wrong robot, \
                     wrong joint columns, or points and joints that do not belong together",
                    robot.name,
                    mm_from_m(left_m)
                ),
            ));
        }
    }
    if let Some(fault) = scale::find_scale(robot, stations, targets, registration) {
        return Some(fault);
    }
    let apart = tool_apart(registration, targets, tool_m, stations.len())?;
    let ToolApart { fitted_m: fitted, apart_m, held_m } = apart;
    (held_m > HELD_M).then(|| {
        Fault::of_all(
            FaultKind::WrongTool,
            None,
            format!(
                "the points say the tool is at ({:.1}, {:.1}, {:.1}) mm from the flange, {:.1} mm from the one given",
                mm_from_m(fitted.x),
                mm_from_m(fitted.y),
                mm_from_m(fitted.z),
                mm_from_m(apart_m)
            ),
        )
    })
}

/// A target that is elsewhere than the tool that was given.
#[derive(Clone, Copy, Debug)]
pub struct ToolApart {
    /// Where the points say that it is, flange frame, metres.
    pub fitted_m: Vector3<f64>,
    /// How far that is from where it was given, metres.
    pub apart_m: f64,
    /// What the points would miss by, rms, were it held there, metres.
    held_m: f64,
}

/// Three numbers a pose, of which base and target take nine: three poses leave nothing by which their place could be judged.
const FEWEST_FOR_TOOL: usize = 4;

/// The one target of so many `stations`, where the points say clearly that it is not at `tool_m`.
#[must_use]
pub fn tool_apart(
    registration: &Registration,
    targets: usize,
    tool_m: Option<Vector3<f64>>,
    stations: usize,
) -> Option<ToolApart> {
    if stations < FEWEST_FOR_TOOL {
        return None;
    }
    let fitted_m = *registration.tools_m.first()?;
    let apart_m = (fitted_m - tool_m?).norm();
    let per_noise = registration.tool_sigma_m / (registration.median_m.max(1e-12) / MEDIAN_NORM_3D);
    let held_m = apart_m / (per_noise * (stations as f64).sqrt());
    // Base and target are fitted: what is left is smaller than the noise by the root of the share that they take.
    let poses = stations as f64;
    let sigma_m = registration.tool_sigma_m * (poses / (poses - (FEWEST_FOR_TOOL - 1) as f64)).sqrt();
    let is_apart = targets == 1 && apart_m > TOOL_M + 3.0 * sigma_m;
    is_apart.then_some(ToolApart { fitted_m, apart_m, held_m })
}

pub(super) fn explains(left_m: Option<f64>, before_m: f64) -> bool {
    left_m.is_some_and(|left_m| left_m < (EXPLAINED * before_m).min(2.0 * SOUND_M))
}

/// A part of the stations on which changes of the file are tried.
struct Trial<'a> {
    robot: &'a SerialArm,
    stations: Vec<Station>,
    targets: usize,
    /// What is left without a change, metres.
    left_m: f64,
}

impl<'a> Trial<'a> {
    /// Of some `stations` of a file that leaves `all_left_m`: an explanation must leave less than these do as they are, which may be little
    /// where most of the false rows are not among them.
    fn of(robot: &'a SerialArm, stations: Vec<Station>, targets: usize, all_left_m: f64) -> Self {
        let own_left_m = left_m(robot, &stations, targets).unwrap_or(all_left_m);
        Self { robot, stations, targets, left_m: all_left_m.min(own_left_m) }
    }
}

impl Trial<'_> {
    fn with(&self, change: impl Fn(&mut Station)) -> Option<f64> {
        let mut changed = self.stations.clone();
        changed.iter_mut().for_each(change);
        left_m(self.robot, &changed, self.targets)
    }

    fn turning(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.robot.joints.len()).filter(|&j| !self.robot.joints[j].kind.slides())
    }

    fn in_degrees(&self, station: &mut Station) {
        self.turning().for_each(|j| station.q_rad[j] = deg_from_rad(station.q_rad[j]));
    }

    /// Units, axes and columns of all rows.
    fn cells(&self) -> Option<Fault> {
        self.units().or_else(|| self.axes()).or_else(|| self.columns())
    }

    fn units(&self) -> Option<Fault> {
        let largest_rad = self
            .stations
            .iter()
            .flat_map(|s| self.turning().map(|j| s.q_rad[j]))
            .fold(0.0, |a: f64, q| a.max(q.abs()));
        let radians = largest_rad < rad_from_deg(TURN_RAD);
        let columns = self.robot.columns();
        let joints = || Some(columns.as_str());
        if radians && explains(self.with(|s| self.in_degrees(s)), self.left_m) {
            return Some(Fault::of_all(
                FaultKind::JointUnits,
                joints(),
                "the joints are in radians, the columns say degrees",
            ));
        }
        let in_gon = |s: &mut Station| self.turning().for_each(|j| s.q_rad[j] *= DEG_PER_GON);
        if explains(self.with(in_gon), self.left_m) {
            return Some(Fault::of_all(
                FaultKind::JointUnits,
                joints(),
                "the joints are in gon, the columns say degrees",
            ));
        }
        for (scale, name) in LENGTHS.into_iter().chain([(0.001, "micrometres")]) {
            let left = self.with(|s| s.reading = s.reading.scaled(scale));
            if explains(left, self.left_m) || (left.is_some_and(|l| l < SOUND_M) && scale > 1.0) {
                let reason = format!("the measured points are in {name}, the columns say mm");
                return Some(Fault::of_all(FaultKind::PositionUnits, Some("x_mm, y_mm, z_mm"), reason));
            }
        }
        let both = self.with(|s| {
            self.in_degrees(s);
            s.reading = s.reading.scaled(1.0 / m_from_mm(1.0));
        });
        (radians && both.is_some_and(|left| left < SOUND_M)).then(|| {
            let reason = "the joints are in radians and the points in metres, the columns say degrees and mm";
            Fault::of_all(FaultKind::JointUnits, joints(), reason)
        })
    }

    /// Every other order or sign is a turn, which the registration takes: only the mirror shows.
    fn axes(&self) -> Option<Fault> {
        let mirrored = self.with(|s| {
            if let Reading::Point { position_m } | Reading::Nest { position_m, .. } = &mut s.reading {
                position_m.swap_rows(0, 1);
            }
            s.orientation = None;
        });
        explains(mirrored, self.left_m).then(|| {
            let reason =
                "the measured points are mirrored: two of x, y, z are swapped, or one has the wrong sign";
            Fault::of_all(FaultKind::SwappedAxes, Some("x_mm, y_mm, z_mm"), reason)
        })
    }

    /// One column, or two, in another unit, with the other sign, in each other's place.
    fn columns(&self) -> Option<Fault> {
        let of_columns =
            |change: &Change| matches!(change.kind, FaultKind::ColumnUnits | FaultKind::JointColumns);
        let tried = changes(self.robot, self.stations.iter()).into_iter().filter(of_columns);
        let tried = tried.filter_map(|change| self.with(&change.change).map(|left_m| (left_m, change)));
        let (left_m, change) =
            tried.reduce(|best, next| if next.0 < CLEARLY * best.0 { next } else { best })?;
        explains(Some(left_m), self.left_m)
            .then(|| Fault::of_all(change.kind, Some(&change.column), change.description))
    }

    /// A column that is the same in all rows, of a joint that moved.
    fn frozen_joint(&self, all: &[Station]) -> Option<Fault> {
        let of_arm = || all.iter().filter(|s| s.reading.involves_arm());
        let first = of_arm().next()?.q_rad;
        let stands_still = |j: &usize| of_arm().all(|s| s.q_rad[*j].to_bits() == first[*j].to_bits());
        (0..self.robot.joints.len()).filter(stands_still).find_map(|j| {
            let free = frozen::with_free_joint(self.robot, &self.stations, j, |stations, poses| {
                register_from_usual_starts(stations, poses, self.targets, None).ok()
            })?;
            let is_it = explains(left_m(self.robot, &free, self.targets), self.left_m);
            is_it.then(|| frozen::one_joint(self.robot, j, of_arm().map(|s| s.line).collect()))
        })
    }

    /// One joint that is counted from elsewhere.
    fn zero(&self) -> Option<Fault> {
        let left_m = |j: usize, by_rad: f64| self.with(|s| s.q_rad[j] += by_rad).unwrap_or(f64::INFINITY);
        let step_rad = TAU / ZEROS as f64;
        // The zeros of the first and the last joint are base and target.
        let inner = self.turning().filter(|j| (1..self.robot.joints.len() - 1).contains(j));
        let tried = inner.flat_map(|j| (0..ZEROS).map(move |k| (j, k as f64 * step_rad - PI)));
        let (_, j, near_rad) = tried
            .map(|(j, by_rad)| (left_m(j, by_rad), j, by_rad))
            .reduce(|best, next| if next.0 < best.0 { next } else { best })?;
        let around = [near_rad - step_rad, near_rad + step_rad];
        let by_rad = frozen::narrowed(around, ZERO_NARROWINGS, |by_rad| left_m(j, by_rad));
        // What is less may be a cause: it is weighed against the others.
        let is_another = by_rad.abs() > FURTHEST_ZERO_RAD || self.left_m > HOPELESS_M;
        (is_another && explains(Some(left_m(j, by_rad)), self.left_m)).then(|| {
            let column = self.robot.column(Axis::at(j));
            let reason = format!(
                "column {column} is off by {:+.1} deg in all rows: joint {} is counted from another zero, or its revolution counter is",
                -deg_from_rad(by_rad),
                Axis::at(j)
            );
            Fault::of_all(FaultKind::JointColumns, Some(&column), reason)
        })
    }

    fn other_robot(&self) -> Option<Fault> {
        let names = Robot::built_in_names().iter().chain(Robot::built_in_with_offset_wrist());
        let others = names.filter_map(|name| {
            let other = SerialArm::built_in(name).filter(|other| other.name != self.robot.name)?;
            left_m(&other, &self.stations, self.targets).map(|left_m| (left_m, name))
        });
        let (left_m, name) = others.reduce(|best, next| if next.0 < best.0 { next } else { best })?;
        explains(Some(left_m), self.left_m).then(|| {
            Fault::of_all(
                FaultKind::WrongRobot,
                None,
                format!(
                    "the points fit {name} ({:.2} mm), not {} ({:.1} mm)",
                    mm_from_m(left_m),
                    self.robot.name,
                    mm_from_m(self.left_m)
                ),
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Isometry3;

    /// By hand: 100 stations of noise 0.1 mm. Poses all over the reach tell the target to a hundredth of that times 1.3, so that one 6 mm away
    /// is missed by 4.6 mm at each; poses within some degrees tell it to 0.1 mm, and miss one 10 mm away by 1 mm, as an arm that is off may.
    #[test]
    fn how_far_points_miss_a_tool_that_is_held_goes_by_the_poses() {
        let apart = |sigma_mm: f64, apart_mm: f64| {
            let mut registration = Registration::assumed(
                Isometry3::identity(),
                vec![Vector3::new(m_from_mm(apart_mm), 0.0, 0.0)],
                Vec::new(),
            );
            registration.median_m = 1e-4 * MEDIAN_NORM_3D;
            registration.tool_sigma_m = m_from_mm(sigma_mm);
            tool_apart(&registration, 1, Some(Vector3::zeros()), 100)
        };
        let wide = apart(0.013, 6.0).unwrap();
        assert!((mm_from_m(wide.held_m) - 6.0 / 1.3).abs() < 1e-9 && wide.held_m > HELD_M);
        let narrow = apart(0.1, 10.0).unwrap();
        assert!((mm_from_m(narrow.held_m) - 1.0).abs() < 1e-9 && narrow.held_m < HELD_M);
        assert!(apart(0.1, 5.2).is_none(), "three standard deviations beyond 5 mm");
    }

    /// By hand: of 12 numbers base and target take 9, so that 0.1 mm is 0.2 mm, and three times that lie 5.6 mm away; three poses leave nothing.
    #[test]
    fn few_poses_tell_the_place_of_a_tool_less_exactly_and_three_not_at_all() {
        let apart = |apart_mm: f64, stations: usize| {
            let mut registration = Registration::assumed(
                Isometry3::identity(),
                vec![Vector3::new(m_from_mm(apart_mm), 0.0, 0.0)],
                Vec::new(),
            );
            registration.median_m = 1e-4 * MEDIAN_NORM_3D;
            registration.tool_sigma_m = 1e-4;
            tool_apart(&registration, 1, Some(Vector3::zeros()), stations).is_some()
        };
        assert!(!apart(5.55, 4) && apart(5.65, 4));
        assert!(!apart(100.0, 3) && !apart(100.0, 1));
    }
}
