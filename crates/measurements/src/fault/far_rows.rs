//! Rows that do not go with a registration that others agree with, and what may be said of them.
//!
//! The registration is looked for in parts of the file: of all rows it may be nobody's.

use super::{Fault, FaultKind};
use crate::initial_guess::with_fixed_points_beyond;
use crate::register::register_from_usual_starts;
use crate::{Registration, Station};
use nalgebra::{Isometry3, Vector3};
use robot_model::robot::SerialArm;
use std::ops::Range;

/// Further off than this, and than so many times the middle row, is no error of an arm, metres.
const FAR_M: f64 = 8e-3;
const FAR_TIMES: f64 = 12.0;
/// Fewer such rows are single false readings.
pub(super) const FEWEST: usize = 3;
/// Share of the far rows that one explanation must explain, and of the rows in its stretch of the file that are far.
pub(super) const MOST: f64 = 0.6;
/// Rows used to register a part of the file.
const PART_ROWS: usize = 120;
/// Fewer rows register no part of a file, of 9 unknowns.
const FEWEST_OF_PART: usize = 8;

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
    /// In these rows (indices into `rows`) the instrument stood elsewhere.
    Moved {
        /// The rows of the second stand, one after the other.
        rows: Range<usize>,
        /// Takes readings of the second stand into the frame of the first.
        first_from_second: Isometry3<f64>,
    },
    /// In these rows (indices into `rows`) the target sat elsewhere on the flange.
    Remounted {
        /// The rows, one after the other.
        rows: Range<usize>,
        /// How far from where it sat in the others, metres.
        by_m: f64,
    },
    /// These rows (indices into `rows`) hold one and the same number where they have no reading.
    Coded {
        /// The rows in the file's order, which others lie between.
        rows: Vec<usize>,
        /// The columns that it stands in.
        column: String,
        /// The number as the file has it, in the column's unit.
        value: f64,
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

/// A registration that a part of the file agrees with.
pub(super) struct Part {
    registration: Registration,
    /// How far each row is off it, metres.
    off_m: Vec<f64>,
    /// How many rows are near.
    pub(super) near: usize,
}

/// The registration of a part of the file that most rows agree with.
pub(super) fn best_part(rows: &[PosedRow], targets: usize, tool_m: Option<Vector3<f64>>) -> Option<Part> {
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
    let in_reach = in_reach(rows);
    let some_are_not = in_reach.len() < n;
    let of_range = |(from, to): (usize, usize)| (from..to).collect::<Vec<usize>>();
    let parts = some_are_not.then_some(in_reach).into_iter().chain(parts.into_iter().map(of_range));
    for part in parts.filter(|part| part.len() >= FEWEST_OF_PART) {
        let is_all = part.len() == n;
        let step = part.len().div_ceil(PART_ROWS).max(1);
        let part: Vec<&PosedRow> = part.iter().step_by(step).map(|&i| &rows[i]).collect();
        let stations: Vec<Station> = part.iter().map(|row| row.station.clone()).collect();
        let poses: Vec<Isometry3<f64>> = part.iter().map(|row| row.pose).collect();
        let tools_m = tool_m.map(|tool_m| vec![tool_m; targets]);
        let found = register_from_usual_starts(&stations, &poses, targets, tools_m.as_deref());
        let Ok(registration) = found else {
            continue;
        };
        let registration = with_fixed_points_beyond(&stations, registration, &all, &all_poses);
        let off_m: Vec<f64> =
            rows.iter().map(|row| registration.residual_m(&row.station, &row.pose).norm()).collect();
        let near = off_m.iter().filter(|off_m| **off_m < FAR_M).count();
        let all = is_all && 100 * near >= 98 * n;
        if best.as_ref().is_none_or(|best| near > best.near) {
            best = Some(Part { registration, off_m, near });
        }
        if all {
            break;
        }
    }
    best.filter(|part| part.near >= FEWEST_OF_PART && 8 * part.near >= n)
}

/// Room beyond what the flange's places allow: for the target on it, and a middle that is not theirs, metres.
const BESIDE_FLANGE_M: f64 = 1.0;

/// The rows whose point lies no further from the middle of all than the flange's places allow: a decimal mark too few puts a point where no
/// arm reaches, and a tenth of such rows leads every registration astray.
fn in_reach(rows: &[PosedRow]) -> Vec<usize> {
    let seen: Vec<Option<Vector3<f64>>> = rows.iter().map(|row| row.station.reading.position_m()).collect();
    let middle_of = |places: &mut dyn Iterator<Item = Vector3<f64>>| {
        let places: Vec<Vector3<f64>> = places.collect();
        Vector3::from_fn(|k, _| {
            statistics::median(&mut places.iter().map(|place| place[k]).collect::<Vec<f64>>())
        })
    };
    let flange = || rows.iter().map(|row| row.pose.translation.vector);
    let (flange_m, seen_m) = (middle_of(&mut flange()), middle_of(&mut seen.iter().copied().flatten()));
    let spread_m = flange().map(|place| (place - flange_m).norm()).fold(0.0, f64::max);
    let is_near = |seen: &Option<Vector3<f64>>| {
        seen.is_none_or(|place| (place - seen_m).norm() <= 2.0 * spread_m + BESIDE_FLANGE_M)
    };
    (0..rows.len()).filter(|&i| is_near(&seen[i])).collect()
}

/// Rows that are far off a registration that others agree with.
pub(super) struct FarRows<'a> {
    pub(super) robot: &'a SerialArm,
    pub(super) rows: &'a [PosedRow],
    pub(super) registration: &'a Registration,
    /// Indices into `rows`, ascending.
    pub(super) far: Vec<usize>,
    /// What is further off than this is far, metres.
    pub(super) limit_m: f64,
    /// How far the near ones are in the middle, metres.
    pub(super) middle_m: f64,
}

impl<'a> FarRows<'a> {
    pub(super) fn of(robot: &'a SerialArm, rows: &'a [PosedRow], part: &'a Part) -> Self {
        let mut sorted = part.off_m.clone();
        sorting::numbers(&mut sorted);
        // The middle of the nearer ones: most rows may be false.
        let middle_m = sorted.get(part.near / 2).copied().unwrap_or(0.0);
        let limit_m = FAR_M.max(FAR_TIMES * middle_m);
        let far = (0..rows.len()).filter(|&i| part.off_m[i] > limit_m).collect();
        Self { robot, rows, registration: &part.registration, far, limit_m, middle_m }
    }

    pub(super) fn is_far(&self, i: usize) -> bool {
        self.far.binary_search(&i).is_ok()
    }

    pub(super) fn lines(&self, which: &[usize]) -> Vec<u64> {
        which.iter().map(|&i| self.rows[i].station.line).collect()
    }

    pub(super) fn fault(
        &self,
        kind: FaultKind,
        column: &str,
        which: &[usize],
        describe: impl Fn(usize, &str) -> String,
    ) -> PartFault {
        PartFault::Fault(Fault::in_rows(kind, column, self.lines(which), describe))
    }

    /// The far rows that would be near as `changed`.
    pub(super) fn near_as(&self, changed: impl Fn(usize) -> Option<f64>) -> Vec<usize> {
        let is_near = |i: &usize| changed(*i).is_some_and(|off_m| off_m < self.limit_m);
        self.far.iter().copied().filter(is_near).collect()
    }

    /// Whether these are enough of the far rows to explain them.
    pub(super) fn are_most(&self, which: &[usize]) -> bool {
        which.len() >= FEWEST && which.len() as f64 >= MOST * self.far.len() as f64
    }

    /// Of several explanations, each with the rows that it explains, the one of most rows, if those are enough.
    pub(super) fn best<T>(&self, tried: impl Iterator<Item = (Vec<usize>, T)>) -> Option<(Vec<usize>, T)> {
        tried
            .reduce(|best, next| if next.0.len() > best.0.len() { next } else { best })
            .filter(|(which, _)| self.are_most(which))
    }
}
