//! Rows that say to the last digit what an earlier one says: copies, which are no measurements.

use super::MeasurementRow;
use std::collections::{BTreeMap, BTreeSet};

/// Fewer rows than this that say the same are no paste.
const FEWEST_PASTED: usize = 6;
/// Of the rows of a block that stand at the moments of earlier ones so many read the same to the last digit, where the block was pasted.
const PASTED: f64 = 0.5;
/// Readings that are all written in such steps come out alike in honest repeats too, metres: there all of them have to.
const COARSE_M: f64 = 1e-4;
/// How far off a whole number of steps a number may be, steps.
const WHOLE: f64 = 1e-6;

/// Rows by whether an earlier one says the same to the last digit.
pub(super) struct DistinctRows {
    /// Indices of the rows that say something else.
    pub used: Vec<usize>,
    /// Lines of the others.
    pub copies: Vec<u64>,
}

impl DistinctRows {
    pub(super) fn of(rows: &[MeasurementRow]) -> Self {
        let mut seen = BTreeSet::new();
        let mut found = Self { used: Vec::with_capacity(rows.len()), copies: Vec::new() };
        for (index, row) in rows.iter().enumerate() {
            if seen.insert((moment(row), reading(row))) {
                found.used.push(index);
            } else {
                found.copies.push(row.line);
            }
        }
        found
    }
}

/// Whether `block` is `rows` pasted once more, whole or a part of it: what stands at the same minute and pose, all else alike, reads the same
/// there. A second measurement has noise of its own, and of one that reads in coarse steps a row or two differ at least.
pub(super) fn is_pasted(rows: &[MeasurementRow], block: &[MeasurementRow]) -> bool {
    let mut readings: BTreeMap<Vec<u64>, BTreeSet<Vec<u64>>> = BTreeMap::new();
    for row in rows {
        readings.entry(moment(row)).or_default().insert(reading(row));
    }
    let counterparts = || block.iter().filter_map(|row| Some((row, readings.get(&moment(row))?)));
    let equal = counterparts().filter(|(row, earlier)| earlier.contains(&reading(row))).count();
    let needed = if block.iter().all(is_coarse) { 1.0 } else { PASTED };
    equal >= FEWEST_PASTED && equal as f64 >= needed * counterparts().count() as f64
}

fn is_coarse(row: &MeasurementRow) -> bool {
    let coordinates_m = row.reading.coordinates().map(|read| read.value_m).unwrap_or_default();
    coordinates_m.iter().all(|value_m| {
        let steps = value_m / COARSE_M;
        (steps - steps.round()).abs() < WHOLE
    })
}

/// When, where and how a row was measured, to the last digit.
fn moment(row: &MeasurementRow) -> Vec<u64> {
    let mut key: Vec<u64> = row.q_rad.iter().map(|v| v.to_bits()).collect();
    key.push(row.reading.fixed_point().map_or(u64::MAX, |fixed_point| fixed_point as u64));
    key.push(u64::from(row.reading.involves_arm()));
    // The same minute of two sessions is not the same moment.
    key.push(row.clock_min().map_or(0, f64::to_bits));
    key.push(row.payload_kg.map_or(0, f64::to_bits));
    key.push(row.target as u64);
    // Each of these is recorded in all rows of a file or in none.
    key.extend(row.direction.iter().flat_map(|signs| signs.iter().map(|sign| u64::from(*sign as u8))));
    key.extend(row.joint_temperature_c.iter().flat_map(|all| all.iter().map(|v| v.to_bits())));
    key
}

/// What it read, to the last digit.
fn reading(row: &MeasurementRow) -> Vec<u64> {
    let coordinates_m = row.reading.coordinates().map(|read| read.value_m).unwrap_or_default();
    let mut key: Vec<u64> = coordinates_m.iter().map(|v| v.to_bits()).collect();
    key.extend(row.orientation.iter().flat_map(|turn| turn.coords.iter().map(|v| v.to_bits())));
    key
}
