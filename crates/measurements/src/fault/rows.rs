//! Rows that the others contradict: from some row on in another unit, one row late, from another stand of the instrument.
//!
//! Rows far off what most of the others agree with are tried with what could have happened to them, one explanation at a time.

use super::by_name::sorted_by_name;
use super::change::{Change, changes};
use super::far_rows::{FEWEST, FarRows, MOST, Part, PartFault, PosedRow, best_part};
use super::frozen;
use super::late::{all_late, column_late};
use super::whole::find_in_columns;
use super::{FURTHEST_ZERO_RAD, Fault, FaultKind};
use crate::Station;
use nalgebra::{Isometry3, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Axis, SerialArm};
use robot_model::units::{deg_from_rad, mm_from_m};
use statistics::median;
use std::f64::consts::{PI, TAU};
use std::ops::Range;

/// So many rows tell by how much a joint is off.
const SEEN_ROWS: usize = 25;
/// One of this many parts of the rows is a stand of the instrument, or a mounting of the target.
const LEAST_STAND: usize = 6;
/// What rows are off in the middle by once they are explained, as a share of what is far: an angle that is a tenth less fits some rows by chance.
const EXPLAINED: f64 = 0.3;
/// So many rows one after the other are not far by chance each.
const FEWEST_IN_A_STRETCH: usize = 12;
/// Readings nearer to each other than this are one, metres: what instruments scatter by where nothing moves.
const STILL_M: f64 = 2e-4;
/// So many far rows with the reading of the row before are no chance.
const FEWEST_STILL: usize = 2;

/// Looks for a part of `rows` that does not go with the rest, or all of them shifted against their joints; `None` where all go
/// together or nothing goes at all.
#[must_use]
pub fn find_in_rows(
    robot: &SerialArm,
    rows: &[PosedRow],
    targets: usize,
    tool_m: Option<Vector3<f64>>,
) -> Option<PartFault> {
    let part = best_part(rows, targets, tool_m);
    let near = part.as_ref().map_or(0, |part| part.near);
    let most_are_near = 2 * near > rows.len();
    // Where what is wrong is wrong in all rows, those of some poses may still fit a registration of their own.
    if 10 * near < 9 * rows.len() {
        let stations: Vec<Station> = rows.iter().map(|row| row.station.clone()).collect();
        if let Some(fault) = find_in_columns(robot, &stations, targets) {
            return Some(PartFault::Fault(fault));
        }
    }
    let found = part.and_then(|part| in_part(robot, rows, targets, &part));
    if found.is_some() || most_are_near {
        return found;
    }
    let stations: Vec<Station> = rows.iter().map(|row| row.station.clone()).collect();
    let poses: Vec<Isometry3<f64>> = rows.iter().map(|row| row.pose).collect();
    all_late(&stations, &poses, targets)
        .or_else(|| sorted_by_name(&stations, &poses, targets))
        .or_else(|| column_late(robot, &stations, targets))
        .map(PartFault::Fault)
}

/// The rows that lie far off what most of the others agree with, one after the other, whatever the reason.
#[must_use]
pub fn find_apart(
    robot: &SerialArm,
    rows: &[PosedRow],
    targets: usize,
    tool_m: Option<Vector3<f64>>,
) -> Option<Fault> {
    let part = best_part(rows, targets, tool_m)?;
    let off = FarRows::of(robot, rows, &part);
    let stretch = off.stretch();
    let inside = off.far.iter().filter(|i| stretch.contains(i)).count();
    let is_apart = inside as f64 > MOST * off.far.len() as f64 && 10 * part.near >= 3 * rows.len();
    is_apart.then(|| {
        let lines = rows[stretch].iter().map(|row| row.station.line).collect();
        Fault::in_rows(FaultKind::TooManyFalse, "x_mm, y_mm, z_mm", lines, |count, which| {
            format!(
                "{count} rows ({which}) do not go with the others, which fit the model of {} by {:.2} mm: the arm, its tool, the instrument or what the \
                 columns hold is another there",
                robot.name,
                mm_from_m(off.middle_m)
            )
        })
    })
}

/// What is wrong with the rows that are far off `part`.
fn in_part(robot: &SerialArm, rows: &[PosedRow], targets: usize, part: &Part) -> Option<PartFault> {
    let off = FarRows::of(robot, rows, part);
    let (first, last) = (off.far.first().copied()?, off.far.last().copied()?);
    if off.far.len() < FEWEST {
        return off.still();
    }
    if let Some(coded) = off.coded() {
        return Some(coded);
    }
    if let Some(pasted) = off.pasted_points() {
        return Some(pasted);
    }
    let columns = off.copied().or_else(|| off.single_columns()).or_else(|| off.exchanged_targets(targets));
    let here_and_there = (off.far.len() as f64) < MOST * (last - first + 1) as f64
        && off.stretch().len() < FEWEST_IN_A_STRETCH;
    if columns.is_some() || (here_and_there && !off.are_late()) {
        return columns.or_else(|| off.still()).or_else(|| off.frozen_joint()).or_else(|| off.late_column());
    }
    // One of several stands has its share of the rows.
    let is_stand = LEAST_STAND * part.near >= rows.len();
    off.late()
        .or_else(|| off.late_column())
        .or_else(|| off.still())
        .or_else(
            || if is_stand { off.elsewhere(targets).map(|found| off.or_last_joint(found)) } else { None },
        )
        // A turn about the first joint's axis may as well be the instrument's; repeats have the angle of the row before as a column has that
        // stands still.
        .or_else(|| off.joint_elsewhere())
        .or_else(|| off.frozen_joint())
        .or_else(|| if is_stand { off.moved_in_part(targets) } else { None })
}

impl FarRows<'_> {
    /// A unit or sign that is another in these rows.
    fn single_columns(&self) -> Option<PartFault> {
        let chain = SerialChain::nominal(self.robot);
        let off_m = |change: &Change, i: usize| {
            let mut station = self.rows[i].station.clone();
            (change.change)(&mut station);
            self.registration.residual_m(&station, &station.pose(&chain)).norm()
        };
        let explained = |change: Change| (self.near_as(|i| Some(off_m(&change, i))), change);
        let (which, change) = self
            .best(changes(self.robot, self.rows.iter().map(|row| &row.station)).into_iter().map(explained))?;
        let left_m = median(&mut which.iter().map(|&i| off_m(&change, i)).collect::<Vec<f64>>());
        (left_m < EXPLAINED * self.limit_m).then(|| {
            self.fault(change.kind, &change.column, &which, |count, lines| {
                format!("in {count} rows ({lines}) {}", change.description)
            })
        })
    }

    /// Readings of one target under another's name.
    fn exchanged_targets(&self, targets: usize) -> Option<PartFault> {
        let Self { rows, registration, .. } = *self;
        let off_m = |i: usize, target: usize| {
            let station = Station { target, ..rows[i].station.clone() };
            registration.residual_m(&station, &rows[i].pose).norm()
        };
        let others = |i: usize| (0..targets).filter(move |target| *target != rows[i].station.target);
        let nearest = |i: usize| others(i).map(|target| off_m(i, target)).reduce(f64::min);
        let which = self.near_as(nearest);
        self.are_most(&which).then(|| {
            self.fault(FaultKind::ExchangedTargets, "target", &which, |count, lines| {
                format!("in {count} rows ({lines}) the point is where another target is: the names in column target are exchanged, or the targets were")
            })
        })
    }

    /// The reading of the row before, but for the noise, where the arm stood elsewhere.
    fn still(&self) -> Option<PartFault> {
        let Self { rows, registration, .. } = self;
        let of_the_row_before = |i: &usize| {
            let Some(before) = i.checked_sub(1).map(|before| &rows[before]) else { return false };
            let row = &rows[*i];
            let readings_m = [&row.station, &before.station].map(|station| station.reading.position_m());
            let [Some(here_m), Some(there_m)] = readings_m else { return false };
            let moved_m = registration.residual_m(&row.station, &before.pose)
                - registration.residual_m(&row.station, &row.pose);
            row.station.target == before.station.target
                && (here_m - there_m).norm() < STILL_M
                && moved_m.norm() > self.limit_m
        };
        let which: Vec<usize> = self.far.iter().copied().filter(of_the_row_before).collect();
        (which.len() >= FEWEST_STILL).then(|| {
            self.fault(FaultKind::FrozenPoint, "x_mm, y_mm, z_mm", &which, |count, lines| {
                format!("{count} rows ({lines}) have the point of the row before, though the arm had moved: the instrument stood still")
            })
        })
    }

    /// One joint's column with the value of the row before, where other angles of that joint alone put the points.
    fn frozen_joint(&self) -> Option<PartFault> {
        let Self { robot, rows, registration, .. } = *self;
        let chain = SerialChain::nominal(robot);
        let explained = |j: usize| {
            let which = self.near_as(|i| {
                // Repeats, and other targets, are seen from the same joints.
                let here = rows[i].station.q_rad.map(f64::to_bits);
                let moved = rows[..i].iter().rev().find(|row| row.station.q_rad.map(f64::to_bits) != here);
                let before = &moved?.station;
                let stands_still = before.q_rad[j].to_bits() == rows[i].station.q_rad[j].to_bits();
                stands_still.then(|| frozen::refitted(robot, &chain, registration, &rows[i].station, j).off_m)
            });
            (which, j)
        };
        let (which, j) = self.best((0..robot.joints.len()).map(explained))?;
        Some(PartFault::Fault(frozen::one_joint(robot, j, self.lines(&which))))
    }

    /// A target that is mounted anew, or the last joint that is counted from elsewhere, where that moves it as far: the same to all points.
    fn or_last_joint(&self, found: PartFault) -> PartFault {
        match (&found, self.joint_elsewhere()) {
            (PartFault::Remounted { .. }, Some(PartFault::Fault(fault))) => PartFault::Fault(fault),
            _ => found,
        }
    }

    /// The rows up to the last one that is far, or from the first one on: the registration may be of what is behind or before.
    fn side(&self) -> Option<Range<usize>> {
        let (first, last) = (*self.far.first()?, *self.far.last()?);
        Some(if first == 0 { 0..last + 1 } else { first..self.rows.len() })
    }

    /// One joint's angle off by the same in all rows to one side of some row: its zero has jumped, or the column has.
    fn joint_elsewhere(&self) -> Option<PartFault> {
        let Self { robot, rows, registration, .. } = *self;
        let chain = SerialChain::nominal(robot);
        let side = self.side()?;
        if (self.far.len() as f64) < MOST * side.len() as f64 {
            return None;
        }
        let tried = (0..robot.joints.len()).filter(|&j| !robot.joints[j].kind.slides()).map(|j| {
            let seen = self.far.iter().step_by(self.far.len().div_ceil(SEEN_ROWS)).map(|&i| {
                let station = &rows[i].station;
                frozen::refitted(robot, &chain, registration, station, j).q_rad - station.q_rad[j]
            });
            // A whole turn is none.
            let by_rad =
                median(&mut seen.map(|by_rad| (by_rad + PI).rem_euclid(TAU) - PI).collect::<Vec<f64>>());
            let which = self.near_as(|i| {
                let mut station = rows[i].station.clone();
                station.q_rad[j] += by_rad;
                Some(registration.residual_m(&station, &station.pose(&chain)).norm())
            });
            (which, (j, by_rad))
        });
        let (which, (joint, by_rad)) = self.best(tried)?;
        if by_rad.abs() < FURTHEST_ZERO_RAD {
            return Some(PartFault::JointElsewhere { joint, rows: side, by_rad });
        }
        let column = robot.column(Axis::at(joint));
        Some(self.fault(FaultKind::JointColumns, &column, &which, |count, lines| {
            let target = match joint + 1 == robot.joints.len() {
                true => ", or the target was turned about that joint's axis",
                false => "",
            };
            format!(
                "in {count} rows ({lines}) column {column} is off by {:+.2} deg{target}",
                -deg_from_rad(by_rad)
            )
        }))
    }
}
