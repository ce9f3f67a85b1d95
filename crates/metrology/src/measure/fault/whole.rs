//! What is wrong with all rows at once: units, axes, columns, robot and tool, tried one by one.

use super::trials::{left_m, most_left_m, most_m, trial};
use super::{Fault, FaultKind, frozen, scale};
use crate::measure::column_names::POINT;
use crate::measure::{MIDDLE_OF_3D, Reading, Registration, Station, register};
use nalgebra::{Isometry3, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Axis, Robot, SerialArm};
use robot_model::units::{deg_from_rad, m_from_mm, mm_from_m, rad_from_deg};

/// A registered robot leaves less than this in the middle, however badly calibrated.
const SOUND_M: f64 = 4e-3;
/// What is left beyond this with no explanation is no measurement of this robot.
const HOPELESS_M: f64 = 10e-3;
/// An explanation must leave this share of the distance or less.
const EXPLAINED: f64 = 0.2;
/// Nearer to the named tool than this it is the same, and no fault.
const TOOL_M: f64 = 5e-3;
/// What an arm's own errors may make the points miss a tool by that is held: over a few degrees a joint that is off moves them as a tool does.
const HELD_M: f64 = 1.5e-3;
/// The units that points come in beside millimetres.
const LENGTHS: [(f64, &str); 4] =
    [(1000.0, "metres"), (304.8, "feet"), (25.4, "inches"), (10.0, "centimetres")];
/// Degrees of a gon, of which a turn has 400.
const DEG_PER_GON: f64 = 0.9;

/// What may have happened to a row, undone.
pub(super) struct Change {
    /// Kind of the fault.
    pub kind: FaultKind,
    /// Column, or columns, that it is in.
    pub column: String,
    /// What is wrong, as half a sentence.
    pub description: String,
    /// Takes the suspected fault out of a row.
    pub change: Box<dyn Fn(&mut Station)>,
}

/// What may have happened to rows or to a column: another unit, another sign.
#[must_use]
pub(super) fn changes(arm: &SerialArm) -> Vec<Change> {
    let mut all = Vec::new();
    for (factor, name) in LENGTHS {
        all.push(Change {
            kind: FaultKind::PositionUnits,
            column: POINT.join(", "),
            description: format!("the measured points are in {name}, the columns say mm"),
            change: Box::new(move |s| s.reading = s.reading.scaled(factor)),
        });
        for (k, axis) in POINT.into_iter().enumerate() {
            all.push(Change {
                kind: FaultKind::ColumnUnits,
                column: axis.to_owned(),
                description: format!("column {axis} is in {name}"),
                change: Box::new(move |s| on_axis(s, k, factor)),
            });
        }
    }
    for (k, axis) in POINT.into_iter().enumerate() {
        all.push(Change {
            kind: FaultKind::SwappedAxes,
            column: axis.to_owned(),
            description: format!("column {axis} has the other sign"),
            change: Box::new(move |s| on_axis(s, k, -1.0)),
        });
    }
    let turning: Vec<usize> = (0..arm.joints.len()).filter(|&j| !arm.joints[j].kind.slides()).collect();
    for &j in &turning {
        let column = arm.column(Axis::at(j));
        all.push(Change {
            kind: FaultKind::ColumnUnits,
            description: format!("column {column} is in radians"),
            column,
            change: Box::new(move |s| s.q_rad[j] = deg_from_rad(s.q_rad[j])),
        });
        let column = arm.column(Axis::at(j));
        all.push(Change {
            kind: FaultKind::JointColumns,
            description: format!("column {column} has the other sign"),
            column,
            change: Box::new(move |s| s.q_rad[j] = -s.q_rad[j]),
        });
    }
    all.push(Change {
        kind: FaultKind::JointUnits,
        column: arm.columns(),
        description: "the joints are in radians, the columns say degrees".to_owned(),
        change: Box::new(move |s| turning.iter().for_each(|&j| s.q_rad[j] = deg_from_rad(s.q_rad[j]))),
    });
    all
}

fn on_axis(station: &mut Station, k: usize, factor: f64) {
    if let Reading::Point { position_m } | Reading::Nest { position_m, .. } = &mut station.reading {
        position_m[k] *= factor;
    }
}

/// Joint columns in another order or counted the other way, where that is what makes the points fit.
#[must_use]
pub fn find_joint_columns(robot: &SerialArm, stations: &[Station], targets: usize) -> Option<Fault> {
    let stations = trial(stations);
    let left_m = left_m(robot, &stations, targets).filter(|left_m| *left_m > SOUND_M)?;
    Trial { robot, stations, targets, left_m }.joints()
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
        let trial = Trial { robot, stations: trial(stations), targets, left_m };
        let found = trial
            .units()
            .or_else(|| trial.axes())
            .or_else(|| trial.columns())
            .or_else(|| trial.joints())
            .or_else(|| trial.other_robot())
            .or_else(|| trial.frozen_joint(stations));
        if found.is_some() {
            return found;
        }
        if left_m > HOPELESS_M {
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

/// The one target of so many `stations`, where the points say clearly that it is not at `tool_m`.
#[must_use]
pub fn tool_apart(
    registration: &Registration,
    targets: usize,
    tool_m: Option<Vector3<f64>>,
    stations: usize,
) -> Option<ToolApart> {
    let fitted_m = *registration.tools_m.first()?;
    let apart_m = (fitted_m - tool_m?).norm();
    let per_noise = registration.tool_sigma_m / (registration.median_m.max(1e-12) / MIDDLE_OF_3D);
    let held_m = apart_m / (per_noise * (stations as f64).sqrt());
    let is_apart = targets == 1 && apart_m > TOOL_M + 3.0 * registration.tool_sigma_m;
    is_apart.then_some(ToolApart { fitted_m, apart_m, held_m })
}

fn explains(left_m: Option<f64>, before_m: f64) -> bool {
    left_m.is_some_and(|left_m| left_m < (EXPLAINED * before_m).min(2.0 * SOUND_M))
}

/// Every row with the point of the row before, or after; `poses` are the flange's.
#[must_use]
pub(super) fn all_shifted(stations: &[Station], poses: &[Isometry3<f64>], targets: usize) -> Option<Fault> {
    let last = stations.len().min(poses.len()).checked_sub(1)?;
    let left = |joints: usize, points: usize| {
        most_left_m(&stations[points..last + points], &poses[joints..last + joints], targets)
    };
    let as_read_m = left(0, 0).filter(|left_m| *left_m > SOUND_M)?;
    [(0, 1, "before"), (1, 0, "after")].into_iter().find_map(|(joints, points, side)| {
        explains(left(joints, points), as_read_m).then(|| {
            Fault::of_all(
                FaultKind::RowsShifted,
                Some("x_mm, y_mm, z_mm"),
                format!("in every row the point is that of the row {side}: points and joints are shifted by one row"),
            )
        })
    })
}

/// Every row with one joint's angle of the row before, or after.
#[must_use]
pub(super) fn joint_shifted(robot: &SerialArm, stations: &[Station], targets: usize) -> Option<Fault> {
    let as_read_m = left_m(robot, stations, targets).filter(|left_m| *left_m > SOUND_M)?;
    let last = stations.len().checked_sub(1)?;
    let shifted = |j: usize, joint: usize, row: usize| -> Vec<Station> {
        let mut shifted = stations[row..last + row].to_vec();
        for (station, other) in shifted.iter_mut().zip(&stations[joint..]) {
            station.q_rad[j] = other.q_rad[j];
        }
        shifted
    };
    let sides = [(1, 0, "before"), (0, 1, "after")];
    let tried = (0..robot.joints.len()).flat_map(|j| sides.map(|(joint, row, side)| (j, joint, row, side)));
    let (left, j, side) = tried
        .filter_map(|(j, joint, row, side)| Some((left_m(robot, &shifted(j, joint, row), targets)?, j, side)))
        .reduce(|best, next| if next.0 < best.0 { next } else { best })?;
    explains(Some(left), as_read_m).then(|| {
        let column = robot.column(Axis::at(j));
        let reason =
            format!("in every row column {column} is that of the row {side}: it is shifted by one row");
        Fault::of_all(FaultKind::RowsShifted, Some(&column), reason)
    })
}

/// A part of the stations on which changes of the file are tried.
struct Trial<'a> {
    robot: &'a SerialArm,
    stations: Vec<Station>,
    targets: usize,
    /// What is left without a change, metres.
    left_m: f64,
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

    fn units(&self) -> Option<Fault> {
        let largest_rad = self
            .stations
            .iter()
            .flat_map(|s| self.turning().map(|j| s.q_rad[j]))
            .fold(0.0, |a: f64, q| a.max(q.abs()));
        let radians = largest_rad < rad_from_deg(7.0);
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

    /// One column in another unit.
    fn columns(&self) -> Option<Fault> {
        let one = changes(self.robot).into_iter().filter(|change| change.kind == FaultKind::ColumnUnits);
        let tried = one.filter_map(|change| self.with(&change.change).map(|left_m| (left_m, change)));
        let (left_m, change) = tried.reduce(|best, next| if next.0 < best.0 { next } else { best })?;
        explains(Some(left_m), self.left_m)
            .then(|| Fault::of_all(change.kind, Some(&change.column), change.description))
    }

    fn joints(&self) -> Option<Fault> {
        let mut tried: Vec<(Option<f64>, String, String)> = Vec::new();
        let joints = self.robot.joints.len();
        for a in 0..joints {
            let flipped = self.with(|s| s.q_rad[a] = -s.q_rad[a]);
            tried.push((
                flipped,
                format!("joint {} is counted the other way round", Axis::at(a)),
                self.robot.column(Axis::at(a)),
            ));
            for b in (a + 1..joints).filter(|&b| self.robot.joints[a].kind == self.robot.joints[b].kind) {
                let swapped = self.with(|s| s.q_rad.swap(a, b));
                let columns =
                    format!("{}, {}", self.robot.column(Axis::at(a)), self.robot.column(Axis::at(b)));
                tried.push((
                    swapped,
                    format!("the columns of joints {} and {} are swapped", Axis::at(a), Axis::at(b)),
                    columns,
                ));
            }
        }
        let elbow = self.turning().filter(|j| [1, 2].contains(j)).count() == 2;
        for (sign, verb) in [(1.0, "added"), (-1.0, "taken off")].into_iter().filter(|_| elbow) {
            let coupled = self.with(|s| s.q_rad[2] += sign * s.q_rad[1]);
            let description = format!("joint 3 is counted from the horizontal: joint 2 has to be {verb}");
            tried.push((coupled, description, "q3_deg".to_owned()));
        }
        let known = tried
            .into_iter()
            .filter_map(|(left, description, column)| left.map(|left_m| (left_m, description, column)));
        let (left_m, description, column) =
            known.reduce(|best, next| if next.0 < best.0 { next } else { best })?;
        explains(Some(left_m), self.left_m)
            .then(|| Fault::of_all(FaultKind::JointColumns, Some(&column), description))
    }

    /// A column that is the same in all rows, of a joint that moved.
    fn frozen_joint(&self, all: &[Station]) -> Option<Fault> {
        let of_arm = || all.iter().filter(|s| s.reading.involves_arm());
        let first = of_arm().next()?.q_rad;
        let stands_still = |j: &usize| of_arm().all(|s| s.q_rad[*j].to_bits() == first[*j].to_bits());
        (0..self.robot.joints.len()).filter(stands_still).find_map(|j| {
            let free = frozen::with_free_joint(self.robot, &self.stations, j, |stations, poses| {
                register(stations, poses, self.targets, None).ok()
            })?;
            let is_it = explains(left_m(self.robot, &free, self.targets), self.left_m);
            is_it.then(|| frozen::one_joint(self.robot, j, of_arm().map(|s| s.line).collect()))
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
            registration.median_m = 1.54e-4;
            registration.tool_sigma_m = m_from_mm(sigma_mm);
            tool_apart(&registration, 1, Some(Vector3::zeros()), 100)
        };
        let wide = apart(0.013, 6.0).unwrap();
        assert!((mm_from_m(wide.held_m) - 6.0 / 1.3).abs() < 1e-9 && wide.held_m > HELD_M);
        let narrow = apart(0.1, 10.0).unwrap();
        assert!((mm_from_m(narrow.held_m) - 1.0).abs() < 1e-9 && narrow.held_m < HELD_M);
        assert!(apart(0.1, 5.2).is_none(), "three standard deviations beyond 5 mm");
    }
}
