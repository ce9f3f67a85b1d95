//! Rows that the others contradict: from some row on in another unit, one row late, from another stand of the instrument.
//!
//! A registration of most of the file is looked for in parts of it; rows far off it are tried with what could have
//! happened to them, one explanation at a time.

use super::frozen;
use super::whole::{Change, all_shifted, changes, joint_shifted};
use super::{Fault, FaultKind};
use crate::measure::initial_guess::with_fixed_points_beyond;
use crate::measure::{FreeParameters, Reading, Registration, Station, median, register, register_with};
use nalgebra::{Isometry3, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Axis, SerialArm};
use robot_model::units::{deg_from_rad, mm_from_m};
use std::f64::consts::{PI, TAU};
use std::ops::Range;

/// Further off than this, and than so many times the middle row, is no error of an arm, metres.
const FAR_M: f64 = 8e-3;
const FAR_TIMES: f64 = 12.0;
/// Fewer such rows are single false readings.
const FEWEST: usize = 3;
/// So many rows tell by how much a joint is off.
const SEEN_ROWS: usize = 25;
/// A zero that has jumped by more is no slip of a gear or a belt, radians: the column is another one.
const FURTHEST_ZERO_RAD: f64 = 0.09;
/// Share of the far rows that one explanation must explain, and of the rows in its stretch of the file that are far.
const MOST: f64 = 0.6;
/// Rows used to register a part of the file.
const PART_ROWS: usize = 120;
/// Fewer rows register no part of a file, of 9 unknowns.
const FEWEST_OF_PART: usize = 8;
/// Fewer rows register no second stand of the instrument, of 6 unknowns.
const FEWEST_OF_STAND: usize = 6;
/// Readings nearer to each other than this are one, metres: what instruments scatter by where nothing moves.
const STILL_M: f64 = 2e-4;
/// So many far rows with the reading of the row before are no chance.
const FEWEST_STILL: usize = 2;

/// One row as a station of its own, and the flange pose of the nominal arm.
pub struct PosedRow {
    /// The row as a station of its own.
    pub station: Station,
    /// Pose of the flange in the base by the nominal arm.
    pub pose: Isometry3<f64>,
}

/// What is wrong with a part of the rows.
pub enum PartFault {
    /// Nothing can be said of the arm.
    Fault(Fault),
    /// From this row (index into `rows`) on the instrument stood elsewhere: the first stand from the second.
    Moved {
        /// Index of the first row of the second stand.
        from: usize,
        /// Takes readings of the second stand into the frame of the first.
        first_from_second: Isometry3<f64>,
    },
    /// In these rows (indices into `rows`) one joint stands elsewhere than the file says, by the same angle in all.
    JointElsewhere {
        /// The joint, counted from 0.
        joint: usize,
        /// The rows, one after the other.
        rows: Range<usize>,
        /// Where it stands less where the file says, radians.
        by_rad: f64,
    },
}

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
    let most_are_near = part.as_ref().is_some_and(|part| 2 * part.near > rows.len());
    let found = part.and_then(|part| in_part(robot, rows, targets, &part));
    if found.is_some() || most_are_near {
        return found;
    }
    let stations: Vec<Station> = rows.iter().map(|row| row.station.clone()).collect();
    let poses: Vec<Isometry3<f64>> = rows.iter().map(|row| row.pose).collect();
    all_shifted(&stations, &poses, targets)
        .or_else(|| joint_shifted(robot, &stations, targets))
        .map(PartFault::Fault)
}

/// A registration that a part of the file agrees with.
struct Part {
    registration: Registration,
    /// How far each row is off it, metres.
    off_m: Vec<f64>,
    /// How many rows are near.
    near: usize,
}

/// What is wrong with the rows that are far off `part`.
fn in_part(robot: &SerialArm, rows: &[PosedRow], targets: usize, part: &Part) -> Option<PartFault> {
    let Part { registration, off_m, near } = part;
    let mut sorted = off_m.clone();
    sorted.sort_by(f64::total_cmp);
    // The middle of the nearer ones: most rows may be false.
    let middle_m = sorted.get(near / 2).copied().unwrap_or(0.0);
    let limit_m = FAR_M.max(FAR_TIMES * middle_m);
    let far: Vec<usize> = (0..rows.len()).filter(|&i| off_m[i] > limit_m).collect();
    let (first, last) = (far.first().copied()?, far.last().copied()?);
    let off = FarRows { robot, rows, registration, far, limit_m };
    if off.far.len() < FEWEST {
        return off.still();
    }
    let columns = off.single_columns().or_else(|| off.exchanged_targets(targets));
    let here_and_there = (off.far.len() as f64) < MOST * (last - first + 1) as f64;
    if columns.is_some() || (here_and_there && !off.is_late()) {
        return columns.or_else(|| off.still()).or_else(|| off.frozen_joint()).or_else(|| off.late_joint());
    }
    // One of two stands has half of the rows.
    let half = 4 * near >= rows.len();
    off.late()
        .or_else(|| off.late_joint())
        .or_else(|| off.still())
        .or_else(|| off.frozen_joint())
        .or_else(|| if half { off.moved(targets) } else { None })
        // A turn about the first joint's axis may as well be the instrument's.
        .or_else(|| off.joint_elsewhere())
}

/// The registration of a part of the file that most rows agree with.
fn best_part(rows: &[PosedRow], targets: usize, tool_m: Option<Vector3<f64>>) -> Option<Part> {
    let n = rows.len();
    let mut parts = vec![(0, n), (0, n / 2), (n / 2, n), (n / 4, 3 * n / 4)];
    for pieces in [4, 8] {
        parts.extend((0..pieces).map(|k| (k * n / pieces, (k + 1) * n / pieces)));
    }
    for rows in [2 * FEWEST_OF_PART, FEWEST_OF_PART].into_iter().filter(|rows| *rows < n) {
        parts.extend([(0, rows), (n - rows, n)]);
    }
    let all: Vec<Station> = rows.iter().map(|row| row.station.clone()).collect();
    let all_poses: Vec<Isometry3<f64>> = rows.iter().map(|row| row.pose).collect();
    let mut best: Option<Part> = None;
    for (from, to) in parts.into_iter().filter(|(from, to)| to - from >= FEWEST_OF_PART) {
        let step = (to - from).div_ceil(PART_ROWS).max(1);
        let part: Vec<&PosedRow> = rows[from..to].iter().step_by(step).collect();
        let stations: Vec<Station> = part.iter().map(|row| row.station.clone()).collect();
        let poses: Vec<Isometry3<f64>> = part.iter().map(|row| row.pose).collect();
        let Ok(registration) = register(&stations, &poses, targets, tool_m) else { continue };
        let registration = with_fixed_points_beyond(&stations, registration, &all, &all_poses);
        let off_m: Vec<f64> =
            rows.iter().map(|row| registration.residual_m(&row.station, &row.pose).norm()).collect();
        let near = off_m.iter().filter(|off_m| **off_m < FAR_M).count();
        let all = (from, to) == (0, n) && 100 * near >= 98 * n;
        if best.as_ref().is_none_or(|best| near > best.near) {
            best = Some(Part { registration, off_m, near });
        }
        if all {
            break;
        }
    }
    best.filter(|part| part.near >= FEWEST_OF_PART && 8 * part.near >= n)
}

/// Rows that are far off a registration that others agree with.
struct FarRows<'a> {
    robot: &'a SerialArm,
    rows: &'a [PosedRow],
    registration: &'a Registration,
    /// Indices into `rows`, ascending.
    far: Vec<usize>,
    /// What is further off than this is far, metres.
    limit_m: f64,
}

impl FarRows<'_> {
    fn lines(&self, which: &[usize]) -> Vec<u64> {
        which.iter().map(|&i| self.rows[i].station.line).collect()
    }

    fn fault(
        &self,
        kind: FaultKind,
        column: &str,
        which: &[usize],
        describe: impl Fn(usize, &str) -> String,
    ) -> PartFault {
        PartFault::Fault(Fault::in_rows(kind, column, self.lines(which), describe))
    }

    /// The far rows that would be near as `changed`.
    fn near_as(&self, changed: impl Fn(usize) -> Option<f64>) -> Vec<usize> {
        let is_near = |i: &usize| changed(*i).is_some_and(|off_m| off_m < self.limit_m);
        self.far.iter().copied().filter(is_near).collect()
    }

    /// Whether these are enough of the far rows to explain them.
    fn are_most(&self, which: &[usize]) -> bool {
        which.len() >= FEWEST && which.len() as f64 >= MOST * self.far.len() as f64
    }

    /// Of several explanations, each with the rows that it explains, the one of most rows, if those are enough.
    fn best<T>(&self, tried: impl Iterator<Item = (Vec<usize>, T)>) -> Option<(Vec<usize>, T)> {
        tried
            .reduce(|best, next| if next.0.len() > best.0.len() { next } else { best })
            .filter(|(which, _)| self.are_most(which))
    }

    /// A unit or sign that is another in these rows.
    fn single_columns(&self) -> Option<PartFault> {
        let chain = SerialChain::nominal(self.robot);
        let off_m = |change: &Change, i: usize| {
            let mut station = self.rows[i].station.clone();
            (change.change)(&mut station);
            self.registration.residual_m(&station, &station.pose(&chain)).norm()
        };
        let explained = |change: Change| (self.near_as(|i| Some(off_m(&change, i))), change);
        let (which, change) = self.best(changes(self.robot).into_iter().map(explained))?;
        Some(self.fault(change.kind, &change.column, &which, |count, lines| {
            format!("in {count} rows ({lines}) {}", change.description)
        }))
    }

    /// The far rows that have the point of the row `by` places before (negative: after).
    fn explained_by(&self, by: isize) -> Vec<usize> {
        self.near_as(|i| {
            let other = i.checked_add_signed(-by).and_then(|other| self.rows.get(other))?;
            Some(self.registration.residual_m(&self.rows[i].station, &other.pose).norm())
        })
    }

    fn is_late(&self) -> bool {
        let most = MOST * self.far.len() as f64;
        [1, -1].into_iter().any(|by| self.explained_by(by).len() as f64 >= most)
    }

    fn late(&self) -> Option<PartFault> {
        [(1, "before"), (-1, "after")].into_iter().find_map(|(by, side)| {
            let which = self.explained_by(by);
            self.are_most(&which).then(|| {
                self.fault(FaultKind::RowsShifted, "x_mm, y_mm, z_mm", &which, |count, lines| {
                    format!("in {count} rows ({lines}) the point is that of the row {side}: points and joints are shifted by one row")
                })
            })
        })
    }

    /// One joint's column that is that of the row before, or after.
    fn late_joint(&self) -> Option<PartFault> {
        let Self { robot, rows, registration, .. } = *self;
        let chain = SerialChain::nominal(robot);
        let shifts = [(1, "before"), (-1, "after")];
        let tried = (0..robot.joints.len()).flat_map(|j| shifts.map(|(by, side)| (j, by, side)));
        let explained = |(j, by, side): (usize, isize, &'static str)| {
            let which = self.near_as(|i| {
                // What stands a row late is written a row further on.
                let written = rows.get(i.checked_add_signed(by)?)?;
                let mut station = rows[i].station.clone();
                station.q_rad[j] = written.station.q_rad[j];
                Some(registration.residual_m(&station, &station.pose(&chain)).norm())
            });
            (which, (j, side))
        };
        let (which, (j, side)) = self.best(tried.map(explained))?;
        let column = robot.column(Axis::at(j));
        Some(self.fault(FaultKind::RowsShifted, &column, &which, |count, lines| {
            format!("in {count} rows ({lines}) column {column} is that of the row {side}: it is shifted by one row")
        }))
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

    /// From one row on all is elsewhere, rigidly.
    fn moved(&self, targets: usize) -> Option<PartFault> {
        let Self { rows, registration, far, .. } = self;
        let Range { start: from, end: to } = self.side()?;
        let inside = || (from..to).filter(|&i| matches!(rows[i].station.reading, Reading::Point { .. }));
        let count = inside().count();
        if count < FEWEST_OF_STAND || (far.len() as f64) < 0.9 * count as f64 {
            return None;
        }
        let stations: Vec<Station> = inside().map(|i| rows[i].station.clone()).collect();
        let poses: Vec<Isometry3<f64>> = inside().map(|i| rows[i].pose).collect();
        let tools = registration.tools_m.get(..targets)?;
        let second = register_with(&stations, &poses, tools, FreeParameters::Base).ok()?;
        if second.median_m > 0.5 * self.limit_m {
            return None;
        }
        let there = registration.instrument_from_base * second.instrument_from_base.inverse();
        Some(match from {
            0 => PartFault::Moved { from: to, first_from_second: there.inverse() },
            _ => PartFault::Moved { from, first_from_second: there },
        })
    }
}

/// By how much the instrument has moved, in words.
#[must_use]
pub fn describe_move(first_from_second: &Isometry3<f64>, line: u64) -> String {
    format!(
        "from line {line} on the instrument stands elsewhere (its frame has moved by {:.0} mm and turned by {:.2} deg): the base is registered in each stand on its own",
        mm_from_m(first_from_second.translation.vector.norm()),
        deg_from_rad(first_from_second.rotation.angle())
    )
}
