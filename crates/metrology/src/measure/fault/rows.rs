//! Rows that the others contradict: from some row on in another unit, one row late, from another stand of the instrument.
//!
//! A registration of most of the file is looked for in parts of it; rows far off it are tried with what could have
//! happened to them, one explanation at a time.

use super::whole::{Change, changes};
use super::{Fault, FaultKind};
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
/// Fewer rows register no second stand of the instrument.
const FEWEST_OF_STAND: usize = 10;

/// One row as a station of its own, and the flange pose of the nominal arm.
pub struct Row {
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

/// Looks for a part of `rows` that does not go with the rest; `None` where all go together or nothing goes at all.
#[must_use]
pub fn find_in_rows(
    robot: &SerialArm,
    rows: &[Row],
    targets: usize,
    tool_m: Option<Vector3<f64>>,
) -> Option<PartFault> {
    let (registration, off_m) = best_part(rows, targets, tool_m)?;
    let mut sorted = off_m.clone();
    sorted.sort_by(f64::total_cmp);
    // The middle of the better half: the other half may be false.
    let middle_m = sorted.get(sorted.len() / 4).copied().unwrap_or(0.0);
    let limit_m = FAR_M.max(FAR_TIMES * middle_m);
    let far: Vec<usize> = (0..rows.len()).filter(|&i| off_m[i] > limit_m).collect();
    if far.len() < FEWEST || 2 * far.len() > rows.len() + rows.len() / 3 {
        return None;
    }
    let first = far.first().copied().unwrap_or(0);
    let last = far.last().copied().unwrap_or(0);
    if (far.len() as f64) < MOST * (last - first + 1) as f64 && !is_late(rows, &registration, &far, limit_m) {
        return single_columns(robot, rows, &registration, &far, limit_m);
    }
    single_columns(robot, rows, &registration, &far, limit_m)
        .or_else(|| late(rows, &registration, &far, limit_m))
        .or_else(|| moved(rows, &registration, targets, &far, limit_m))
}

/// The registration of a part of the file that most rows agree with, and how far each row is off it.
fn best_part(rows: &[Row], targets: usize, tool_m: Option<Vector3<f64>>) -> Option<(Registration, Vec<f64>)> {
    let n = rows.len();
    let parts = [
        (0, n),
        (0, n / 2),
        (n / 2, n),
        (n / 4, 3 * n / 4),
        (0, n / 4),
        (n / 4, n / 2),
        (n / 2, 3 * n / 4),
        (3 * n / 4, n),
    ];
    let mut best: Option<(usize, Registration, Vec<f64>)> = None;
    for (from, to) in parts.into_iter().filter(|(from, to)| to - from >= FEWEST_OF_STAND) {
        let step = (to - from).div_ceil(PART_ROWS).max(1);
        let part: Vec<&Row> = rows[from..to].iter().step_by(step).collect();
        let stations: Vec<Station> = part.iter().map(|row| row.station.clone()).collect();
        let poses: Vec<Isometry3<f64>> = part.iter().map(|row| row.pose).collect();
        let Ok(registration) = register(&stations, &poses, targets, tool_m) else { continue };
        let off_m: Vec<f64> =
            rows.iter().map(|row| registration.residual_m(&row.station, &row.pose).norm()).collect();
        let near = off_m.iter().filter(|off_m| **off_m < FAR_M).count();
        let all = (from, to) == (0, n) && 100 * near >= 98 * n;
        if best.as_ref().is_none_or(|(most, _, _)| near > *most) {
            best = Some((near, registration, off_m));
        }
        if all {
            break;
        }
    }
    best.filter(|(near, _, _)| 4 * near >= n).map(|(_, registration, off_m)| (registration, off_m))
}

fn fault(
    kind: FaultKind,
    column: &str,
    rows: &[Row],
    which: &[usize],
    said: impl Fn(usize, &str) -> String,
) -> PartFault {
    let lines = which.iter().map(|&i| rows[i].station.line).collect();
    PartFault::Fault(Fault::in_rows(kind, column, lines, said))
}

/// A unit or sign that is another in these rows.
fn single_columns(
    robot: &SerialArm,
    rows: &[Row],
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
            format!("in {count} rows ({lines}) {}", change.says)
        })
    })
}

/// How many of the far rows have the point of the row `by` places before (negative: after).
fn explained_by(
    rows: &[Row],
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

fn is_late(rows: &[Row], registration: &Registration, far: &[usize], limit_m: f64) -> bool {
    [1, -1]
        .into_iter()
        .any(|by| explained_by(rows, registration, far, limit_m, by).len() as f64 >= MOST * far.len() as f64)
}

fn late(rows: &[Row], registration: &Registration, far: &[usize], limit_m: f64) -> Option<PartFault> {
    [(1, "before"), (-1, "after")].into_iter().find_map(|(by, side)| {
        let which = explained_by(rows, registration, far, limit_m, by);
        (which.len() >= FEWEST && which.len() as f64 >= MOST * far.len() as f64).then(|| {
            fault(FaultKind::RowsShifted, "x_mm, y_mm, z_mm", rows, &which, |count, lines| {
                format!("in {count} rows ({lines}) the point is that of the row {side}: points and joints are shifted by one row")
            })
        })
    })
}

/// From one row on all is elsewhere, rigidly.
fn moved(
    rows: &[Row],
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
