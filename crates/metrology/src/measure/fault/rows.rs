//! Rows that the others contradict: from some row on in another unit, one row late, from another stand of the instrument.
//!
//! A registration of most of the file is looked for in parts of it; rows far off it are tried with what could have
//! happened to them, one explanation at a time.

use super::frozen;
use super::whole::{Change, all_shifted, changes};
use super::{Fault, FaultKind};
use crate::measure::initial_guess::with_fixed_points_beyond;
use crate::measure::{FreeParameters, Reading, Registration, Station, register, register_with};
use nalgebra::{Isometry3, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::SerialArm;
use robot_model::units::mm_from_m;

/// Further off than this, and than so many times the middle row, is no error of an arm, metres.
const FAR_M: f64 = 8e-3;
const FAR_TIMES: f64 = 12.0;
/// Fewer such rows are single false readings.
const FEWEST: usize = 3;
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
    all_shifted(&stations, &poses, targets).map(PartFault::Fault)
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
    let still = || still(rows, registration, &far, limit_m);
    if far.len() < FEWEST {
        return still();
    }
    let (first, last) = (far.first().copied()?, far.last().copied()?);
    let columns = single_columns(robot, rows, registration, &far, limit_m);
    let here_and_there = (far.len() as f64) < MOST * (last - first + 1) as f64;
    if columns.is_some() || (here_and_there && !is_late(rows, registration, &far, limit_m)) {
        return columns.or_else(still).or_else(|| frozen_joint(robot, rows, registration, &far, limit_m));
    }
    // One of two stands has half of the rows.
    let half = 4 * near >= rows.len();
    late(rows, registration, &far, limit_m)
        .or_else(still)
        .or_else(|| frozen_joint(robot, rows, registration, &far, limit_m))
        .or_else(|| if half { moved(rows, registration, targets, &far, limit_m) } else { None })
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

fn fault(
    kind: FaultKind,
    column: &str,
    rows: &[PosedRow],
    which: &[usize],
    describe: impl Fn(usize, &str) -> String,
) -> PartFault {
    let lines = which.iter().map(|&i| rows[i].station.line).collect();
    PartFault::Fault(Fault::in_rows(kind, column, lines, describe))
}

/// A unit or sign that is another in these rows.
fn single_columns(
    robot: &SerialArm,
    rows: &[PosedRow],
    registration: &Registration,
    far: &[usize],
    limit_m: f64,
) -> Option<PartFault> {
    let chain = SerialChain::nominal(robot);
    let explained = |change: &Change| -> Vec<usize> {
        let fits = |i: &usize| {
            let mut station = rows[*i].station.clone();
            (change.change)(&mut station);
            registration.residual_m(&station, &station.pose(&chain)).norm() < limit_m
        };
        far.iter().copied().filter(fits).collect()
    };
    let tried = changes(robot).into_iter().map(|change| (explained(&change), change));
    let (which, change) = tried.reduce(|best, next| if next.0.len() > best.0.len() { next } else { best })?;
    (which.len() >= FEWEST && which.len() as f64 >= MOST * far.len() as f64).then(|| {
        fault(change.kind, &change.column, rows, &which, |count, lines| {
            format!("in {count} rows ({lines}) {}", change.description)
        })
    })
}

/// How many of the far rows have the point of the row `by` places before (negative: after).
fn explained_by(
    rows: &[PosedRow],
    registration: &Registration,
    far: &[usize],
    limit_m: f64,
    by: isize,
) -> Vec<usize> {
    let fits = |i: &usize| {
        i.checked_add_signed(-by)
            .and_then(|other| rows.get(other))
            .is_some_and(|other| registration.residual_m(&rows[*i].station, &other.pose).norm() < limit_m)
    };
    far.iter().copied().filter(fits).collect()
}

fn is_late(rows: &[PosedRow], registration: &Registration, far: &[usize], limit_m: f64) -> bool {
    [1, -1]
        .into_iter()
        .any(|by| explained_by(rows, registration, far, limit_m, by).len() as f64 >= MOST * far.len() as f64)
}

fn late(rows: &[PosedRow], registration: &Registration, far: &[usize], limit_m: f64) -> Option<PartFault> {
    [(1, "before"), (-1, "after")].into_iter().find_map(|(by, side)| {
        let which = explained_by(rows, registration, far, limit_m, by);
        (which.len() >= FEWEST && which.len() as f64 >= MOST * far.len() as f64).then(|| {
            fault(FaultKind::RowsShifted, "x_mm, y_mm, z_mm", rows, &which, |count, lines| {
                format!("in {count} rows ({lines}) the point is that of the row {side}: points and joints are shifted by one row")
            })
        })
    })
}

/// The reading of the row before, but for the noise, where the arm stood elsewhere.
fn still(rows: &[PosedRow], registration: &Registration, far: &[usize], limit_m: f64) -> Option<PartFault> {
    let of_the_row_before = |i: &usize| {
        let Some(before) = i.checked_sub(1).map(|before| &rows[before]) else { return false };
        let row = &rows[*i];
        let readings_m = [&row.station, &before.station].map(|station| station.reading.position_m());
        let [Some(here_m), Some(there_m)] = readings_m else { return false };
        let moved_m = registration.residual_m(&row.station, &before.pose)
            - registration.residual_m(&row.station, &row.pose);
        row.station.target == before.station.target
            && (here_m - there_m).norm() < STILL_M
            && moved_m.norm() > limit_m
    };
    let which: Vec<usize> = far.iter().copied().filter(of_the_row_before).collect();
    (which.len() >= FEWEST_STILL).then(|| {
        fault(FaultKind::FrozenPoint, "x_mm, y_mm, z_mm", rows, &which, |count, lines| {
            format!("{count} rows ({lines}) have the point of the row before, though the arm had moved: the instrument stood still")
        })
    })
}

/// One joint's column with the value of the row before, where other angles of that joint alone put the points.
fn frozen_joint(
    robot: &SerialArm,
    rows: &[PosedRow],
    registration: &Registration,
    far: &[usize],
    limit_m: f64,
) -> Option<PartFault> {
    let chain = SerialChain::nominal(robot);
    let explained = |j: usize| -> Vec<usize> {
        let stands_still = |i: &usize| {
            let before = i.checked_sub(1).map(|before| rows[before].station.q_rad[j].to_bits());
            before == Some(rows[*i].station.q_rad[j].to_bits())
        };
        let fits =
            |i: &usize| frozen::refitted(robot, &chain, registration, &rows[*i].station, j).off_m < limit_m;
        far.iter().copied().filter(|i| stands_still(i) && fits(i)).collect()
    };
    let tried = (0..robot.joints.len()).map(|j| (explained(j), j));
    let (which, j) = tried.reduce(|best, next| if next.0.len() > best.0.len() { next } else { best })?;
    (which.len() >= FEWEST && which.len() as f64 >= MOST * far.len() as f64).then(|| {
        let lines = which.iter().map(|&i| rows[i].station.line).collect();
        PartFault::Fault(frozen::one_joint(robot, j, lines))
    })
}

/// From one row on all is elsewhere, rigidly.
fn moved(
    rows: &[PosedRow],
    registration: &Registration,
    targets: usize,
    far: &[usize],
    limit_m: f64,
) -> Option<PartFault> {
    let first = *far.first()?;
    // The stand may be the first or the second of the two that the registration is of.
    let (from, to) = if first == 0 { (0, far.last()? + 1) } else { (first, rows.len()) };
    let inside = || (from..to).filter(|&i| matches!(rows[i].station.reading, Reading::Point { .. }));
    let count = inside().count();
    if count < FEWEST_OF_STAND || (far.len() as f64) < 0.9 * count as f64 {
        return None;
    }
    let stations: Vec<Station> = inside().map(|i| rows[i].station.clone()).collect();
    let poses: Vec<Isometry3<f64>> = inside().map(|i| rows[i].pose).collect();
    let tools = registration.tools_m.get(..targets)?;
    let second = register_with(&stations, &poses, tools, FreeParameters::Base).ok()?;
    if second.median_m > 0.5 * limit_m {
        return None;
    }
    let there = registration.instrument_from_base * second.instrument_from_base.inverse();
    Some(match first {
        0 => PartFault::Moved { from: to, first_from_second: there.inverse() },
        _ => PartFault::Moved { from, first_from_second: there },
    })
}

/// By how much the instrument has moved, in words.
#[must_use]
pub fn describe_move(first_from_second: &Isometry3<f64>, line: u64) -> String {
    format!(
        "from line {line} on the instrument stands elsewhere (its frame has moved by {:.0} mm and turned by {:.2} deg): the base is registered in each stand on its own",
        mm_from_m(first_from_second.translation.vector.norm()),
        robot_model::units::deg_from_rad(first_from_second.rotation.angle())
    )
}
