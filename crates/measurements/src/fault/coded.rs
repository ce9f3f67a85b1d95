//! One number in many rows where a reading should be, within what the column holds elsewhere: 0 where nothing was read.

use super::far_rows::{FarRows, PartFault};
use crate::Station;
use crate::column_names::POINT;
use crate::rows::SAME_POSE;
use robot_model::robot::{Axis, SerialArm};
use robot_model::units::mm_from_m;
use std::collections::{BTreeMap, BTreeSet};

/// Fewer rows with one number are no code.
const FEWEST: usize = 3;
/// A code lies in rows apart from each other: rows one after the other were not read anew.
const MOST_IN_A_RUN: f64 = 0.5;
/// Share of the rows with the number that are far off: where the arm stood near there, some are near.
const FAR_SHARE: f64 = 0.6;

/// A cell of a row as the file has it.
struct Cell {
    column: String,
    /// In the column's unit.
    value: f64,
}

fn cells(robot: &SerialArm, station: &Station) -> Vec<Cell> {
    let written = robot.in_deg_or_mm(&station.q_rad);
    let joints = written
        .iter()
        .enumerate()
        .map(|(j, value)| Cell { column: robot.column(Axis::at(j)), value: *value });
    let point_m = station.reading.position_m();
    let point = point_m.iter().flat_map(|point_m| {
        POINT
            .iter()
            .zip(point_m.iter())
            .map(|(column, value_m)| Cell { column: (*column).to_owned(), value: mm_from_m(*value_m) })
    });
    joints.chain(point).collect()
}

impl FarRows<'_> {
    /// Most of the far rows have one and the same number in one column, or in several, and hardly any other row has it.
    pub(super) fn coded(&self) -> Option<PartFault> {
        let mut with: BTreeMap<(String, u64), Vec<usize>> = BTreeMap::new();
        for (i, row) in self.rows.iter().enumerate() {
            for cell in cells(self.robot, &row.station) {
                with.entry((cell.column, cell.value.to_bits())).or_default().push(i);
            }
        }
        let is_code = |which: &[usize]| {
            let far = which.iter().filter(|i| self.is_far(**i)).count();
            let runs = 1 + which.windows(2).filter(|pair| pair[1] != pair[0] + 1).count();
            which.len() >= FEWEST
                && far as f64 >= FAR_SHARE * which.len() as f64
                && runs as f64 > MOST_IN_A_RUN * which.len() as f64
                && self.others_stand_elsewhere(which)
        };
        let coded: Vec<((String, u64), Vec<usize>)> =
            with.into_iter().filter(|(_, which)| is_code(which)).collect();
        let rows: BTreeSet<usize> = coded.iter().flat_map(|(_, which)| which.iter().copied()).collect();
        let values: BTreeSet<u64> = coded.iter().map(|((_, bits), _)| *bits).collect();
        let one_value = values.first().filter(|_| values.len() == 1)?;
        let far: Vec<usize> = rows.iter().copied().filter(|i| self.is_far(*i)).collect();
        if !self.are_most(&far) {
            return None;
        }
        let rows = rows.into_iter().collect();
        let columns: Vec<String> = coded.into_iter().map(|((column, _), _)| column).collect();
        Some(PartFault::Coded { rows, column: columns.join(", "), value: f64::from_bits(*one_value) })
    }

    /// Whether these rows differ elsewhere: repeats of one pose have all their joints in common.
    fn others_stand_elsewhere(&self, which: &[usize]) -> bool {
        let mut stations = which.iter().map(|&i| &self.rows[i].station);
        let Some(first) = stations.next() else { return false };
        let (first_m, kinds) = (first.reading.position_m(), self.robot.kinds());
        stations.any(|station| {
            let apart_m = first_m.zip(station.reading.position_m()).map_or(0.0, |(a, b)| (a - b).norm());
            apart_m > self.limit_m || !SAME_POSE.holds(&kinds, &first.q_rad, &station.q_rad)
        })
    }
}
