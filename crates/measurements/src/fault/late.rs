//! Cells that stand some rows late, or early: points against joints, one joint's column, one coordinate's.

use super::far_rows::{FarRows, PartFault};
use super::trials::{few, left_m, most_left_m};
use super::whole::{SOUND_M, explains};
use super::{Fault, FaultKind};
use crate::Station;
use crate::column_names::POINT;
use nalgebra::Isometry3;
use rapid_syntax::diagnostic::counted;
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Axis, SerialArm};

/// Cells further off their row than this come from no loop that ran on, but from another table.
const FURTHEST: usize = 5;

/// By how many rows cells are late; negative: early.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Lateness(isize);

impl Lateness {
    /// All that are tried, the smallest first.
    pub(super) fn all() -> impl Iterator<Item = Self> {
        (1..=FURTHEST as isize).flat_map(|by| [Self(by), Self(-by)])
    }

    /// Whose cells stand in the row `i`.
    fn source(self, i: usize) -> Option<usize> {
        i.checked_add_signed(-self.0)
    }

    /// Where the cells of the row `i` stand.
    fn written(self, i: usize) -> Option<usize> {
        i.checked_add_signed(self.0)
    }

    /// "that of the row before: it is shifted by one row", `it` being what is late.
    fn in_words(self, it: &str) -> String {
        let side = if self.0 > 0 { "before" } else { "after" };
        match self.0.unsigned_abs() {
            1 => format!("that of the row {side}: {it} shifted by one row"),
            by => format!("that of {} {side}: {it} shifted by {by} rows", counted(by, "row")),
        }
    }
}

/// What of a row may be another row's, beside the whole point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LateColumn {
    /// The column of one joint, counted from 0.
    Joint(usize),
    /// One of x, y, z.
    Coordinate(usize),
}

impl LateColumn {
    fn all(robot: &SerialArm) -> impl Iterator<Item = Self> {
        (0..robot.joints.len()).map(Self::Joint).chain((0..POINT.len()).map(Self::Coordinate))
    }

    fn name(self, robot: &SerialArm) -> String {
        match self {
            Self::Joint(j) => robot.column(Axis::at(j)),
            Self::Coordinate(k) => POINT[k].to_owned(),
        }
    }

    /// `station` with this cell as it stands in `other`; `None` where the two have none in common.
    fn copied(self, station: &Station, other: &Station) -> Option<Station> {
        let mut copied = station.clone();
        match self {
            Self::Joint(j) => copied.q_rad[j] = other.q_rad[j],
            Self::Coordinate(k) => {
                let read_m = other.reading.position_m().filter(|_| station.target == other.target)?;
                copied.reading.position_mut()?[k] = read_m[k];
            }
        }
        Some(copied)
    }
}

impl FarRows<'_> {
    /// The far rows that have the point of another row.
    fn with_point_of_other(&self, late: Lateness) -> Vec<usize> {
        self.near_as(|i| {
            let (row, other) = (&self.rows[i].station, self.rows.get(late.source(i)?)?);
            // Its target's name may have stayed where the other's point has come.
            let of_other = Station { target: other.station.target, ..row.clone() };
            let off_m = |station: &Station| self.registration.residual_m(station, &other.pose).norm();
            Some(off_m(row).min(off_m(&of_other)))
        })
    }

    pub(super) fn are_late(&self) -> bool {
        Lateness::all().any(|late| self.are_most(&self.with_point_of_other(late)))
    }

    /// Points that are those of other rows.
    pub(super) fn late(&self) -> Option<PartFault> {
        let (which, late) = self.best(Lateness::all().map(|late| (self.with_point_of_other(late), late)))?;
        Some(self.fault(FaultKind::RowsShifted, &POINT.join(", "), &which, |count, lines| {
            format!("in {count} rows ({lines}) the point is {}", late.in_words("points and joints are"))
        }))
    }

    /// One column that is that of other rows.
    pub(super) fn late_column(&self) -> Option<PartFault> {
        let chain = SerialChain::nominal(self.robot);
        let tried = Lateness::all().flat_map(|late| LateColumn::all(self.robot).map(move |c| (late, c)));
        let explained = |(late, column): (Lateness, LateColumn)| {
            let which = self.near_as(|i| {
                let row = &self.rows[i].station;
                let off_m = |station: &Station, cell: &Station| {
                    let station = column.copied(station, cell)?;
                    Some(self.registration.residual_m(&station, &station.pose(&chain)).norm())
                };
                let written = self.rows.get(late.written(i)?)?;
                // Repeats have each other's cells: what stands here must be that of the other row as well.
                let source = self.rows.get(late.source(i)?)?;
                Some(off_m(row, &written.station)?.max(off_m(&source.station, row)?))
            });
            (which, (late, column))
        };
        let (which, (late, column)) = self.best(tried.map(explained))?;
        let column = column.name(self.robot);
        Some(self.fault(FaultKind::RowsShifted, &column, &which, |count, lines| {
            format!("in {count} rows ({lines}) column {column} is {}", late.in_words("it is"))
        }))
    }
}

/// Every row with the point of another row; `poses` are the flange's.
#[must_use]
pub(super) fn all_late(stations: &[Station], poses: &[Isometry3<f64>], targets: usize) -> Option<Fault> {
    let as_read_m = most_left_m(stations, poses, targets).filter(|left_m| *left_m > SOUND_M)?;
    let left = |late: Lateness| {
        let pairs = (0..stations.len()).filter_map(|i| stations.get(i).zip(poses.get(late.source(i)?)));
        let (stations, poses): (Vec<Station>, Vec<Isometry3<f64>>) =
            pairs.map(|(station, pose)| (station.clone(), *pose)).unzip();
        most_left_m(&stations, &poses, targets)
    };
    Lateness::all().find(|late| explains(left(*late), as_read_m)).map(|late| {
        Fault::of_all(
            FaultKind::RowsShifted,
            Some(&POINT.join(", ")),
            format!("in every row the point is {}", late.in_words("points and joints are")),
        )
    })
}

/// Every row with one column of another row.
#[must_use]
pub(super) fn column_late(robot: &SerialArm, stations: &[Station], targets: usize) -> Option<Fault> {
    let as_read_m = left_m(robot, &few(stations), targets).filter(|left_m| *left_m > SOUND_M)?;
    let left = |late: Lateness, column: LateColumn| {
        let with_own = |i: usize| column.copied(&stations[i], stations.get(late.written(i)?)?);
        let own: Vec<Station> = (0..stations.len()).filter_map(with_own).collect();
        left_m(robot, &few(&own), targets)
    };
    let tried = Lateness::all().flat_map(|late| LateColumn::all(robot).map(move |column| (late, column)));
    let (left_m, late, column) = tried
        .filter_map(|(late, column)| Some((left(late, column)?, late, column)))
        .reduce(|best, next| if next.0 < best.0 { next } else { best })?;
    explains(Some(left_m), as_read_m).then(|| {
        let column = column.name(robot);
        let reason = format!("in every row column {column} is {}", late.in_words("it is"));
        Fault::of_all(FaultKind::RowsShifted, Some(&column), reason)
    })
}
