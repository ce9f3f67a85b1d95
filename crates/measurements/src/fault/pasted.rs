//! Columns that cannot be what their names say where nothing fits: one pasted over another, in all rows or in some, one sorted by itself.

use super::far_rows::{FarRows, PartFault};
use super::{Fault, FaultKind};
use crate::Station;
use crate::column_names::POINT;
use robot_model::robot::{Axis, SerialArm};
use std::collections::{BTreeMap, BTreeSet};

/// Columns of fewer different numbers may be the same, or rise from row to row, without a mistake.
const FEWEST_DIFFERENT: usize = 8;

/// One column as the stations have it.
struct Column {
    kind: FaultKind,
    name: String,
    values: Vec<f64>,
}

impl Column {
    fn is_the_same_as(&self, other: &Self) -> bool {
        let bits = |column: &Self| column.values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        self.kind == other.kind && bits(self) == bits(other)
    }

    fn is_sorted(&self) -> bool {
        self.values.is_sorted() || self.values.iter().rev().is_sorted()
    }

    fn differs(&self) -> bool {
        self.values.iter().map(|value| value.to_bits()).collect::<BTreeSet<_>>().len() >= FEWEST_DIFFERENT
    }
}

/// A column that is another one's copy, or that alone among its like rises, or falls, from row to row.
pub(super) fn find(robot: &SerialArm, stations: &[Station]) -> Option<Fault> {
    let arm: Vec<&Station> = stations.iter().filter(|station| station.reading.involves_arm()).collect();
    let joints = (0..robot.joints.len()).map(|j| Column {
        kind: FaultKind::JointColumns,
        name: robot.column(Axis::at(j)),
        values: arm.iter().map(|station| station.q_rad[j]).collect(),
    });
    let coordinates = POINT.into_iter().enumerate().map(|(k, name)| Column {
        kind: FaultKind::NothingFits,
        name: name.to_owned(),
        values: arm.iter().filter_map(|station| Some(station.reading.position_m()?[k])).collect(),
    });
    let columns: Vec<Column> = joints.chain(coordinates).filter(Column::differs).collect();
    let copied = columns.iter().enumerate().find_map(|(k, column)| {
        let other = columns[..k].iter().find(|other| column.is_the_same_as(other))?;
        let names = format!("{}, {}", other.name, column.name);
        let reason = format!(
            "the columns {} and {} hold the same numbers in all rows: one was pasted over the other",
            other.name, column.name
        );
        Some(Fault::of_all(column.kind, Some(&names), reason))
    });
    let sorted = || {
        let mut sorted = columns.iter().filter(|column| column.is_sorted());
        let column = sorted.next().filter(|_| sorted.next().is_none())?;
        let reason = format!(
            "column {0} alone rises, or falls, from row to row: it was sorted by itself",
            column.name
        );
        Some(Fault::of_all(FaultKind::RowsShifted, Some(&column.name), reason))
    };
    copied.or_else(sorted)
}

impl FarRows<'_> {
    /// Points that are to the last digit those of other rows, each of another one, as of a block that was pasted over another.
    pub(super) fn pasted_points(&self) -> Option<PartFault> {
        let bits =
            |i: usize| Some(<[f64; 3]>::from(self.rows[i].station.reading.position_m()?).map(f64::to_bits));
        let mut rows_of: BTreeMap<[u64; 3], Vec<usize>> = BTreeMap::new();
        for (i, bits) in (0..self.rows.len()).filter_map(|i| Some((i, bits(i)?))) {
            rows_of.entry(bits).or_default().push(i);
        }
        let source = |i: usize| {
            let others = rows_of.get(&bits(i)?)?;
            others.iter().copied().find(|&other| other != i && !self.far.contains(&other))
        };
        let pairs: Vec<(usize, usize)> = self
            .far
            .iter()
            .filter_map(|&i| Some((i, source(i)?)))
            .filter(|(i, of)| i.abs_diff(*of) > 1)
            .collect();
        let which: Vec<usize> = pairs.iter().map(|(i, _)| *i).collect();
        let sources: BTreeSet<usize> = pairs.iter().map(|(_, of)| *of).collect();
        // One point at many poses is a reflector that stood still.
        if sources.len() < which.len() || !self.are_most(&which) {
            return None;
        }
        let (first, last) = (sources.first()?, sources.last()?);
        let [first, last] = [first, last].map(|&i| self.rows[i].station.line);
        Some(self.fault(FaultKind::NothingFits, "x_mm, y_mm, z_mm", &which, |count, lines| {
            format!(
                "in {count} rows ({lines}) the points are to the last digit those of lines {first} to {last}, measured at other joints: they were \
                 pasted over what was there"
            )
        }))
    }

    /// Two coordinates that are the same number to the last digit in most of the far rows, as no two readings are by chance.
    pub(super) fn copied(&self) -> Option<PartFault> {
        let tried = [(0, 1), (0, 2), (1, 2)].into_iter().map(|(a, b)| {
            let is_copied = |i: &usize| {
                let point_m = self.rows[*i].station.reading.position_m();
                point_m
                    .is_some_and(|point_m| point_m[a] != 0.0 && point_m[a].to_bits() == point_m[b].to_bits())
            };
            (self.far.iter().copied().filter(is_copied).collect(), [POINT[a], POINT[b]])
        });
        let (which, [one, other]) = self.best(tried)?;
        Some(self.fault(FaultKind::NothingFits, &format!("{one}, {other}"), &which, |count, lines| {
            format!(
                "in {count} rows ({lines}) the columns {one} and {other} hold the same number: one was pasted over the other"
            )
        }))
    }
}
