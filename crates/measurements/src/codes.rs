//! Codes that stand where an instrument had no reading: -9999 in a coordinate, the same to the last digit at pose after pose.

use super::column_names::POINT;
use super::gaps::at_lines;
use super::{MeasurementRow, Reading};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::robot::JointKind;
use robot_model::units::mm_from_m;
use std::collections::{BTreeMap, BTreeSet};

/// Fewer rows than this with one number are no code; they are set aside as false readings, if they are.
const FEWEST: usize = 3;
/// A code lies beyond all other readings by more than so many times what those span.
const SPANS: f64 = 2.0;

/// Rows of `used` whose point holds a code in place of a coordinate, and what is said of them, column by column.
pub(super) fn codes(
    rows: &[MeasurementRow],
    used: &[usize],
    kinds: &[JointKind],
) -> (BTreeSet<usize>, Vec<Diagnostic>) {
    let (mut coded, mut warnings) = (BTreeSet::new(), Vec::new());
    for (value_m, of) in of_all_coordinates(rows, used, kinds) {
        warnings.push(warning("x_mm, y_mm, z_mm", value_m, rows, &of));
        coded.extend(of);
    }
    let used: Vec<usize> = used.iter().copied().filter(|i| !coded.contains(i)).collect();
    for (k, column) in POINT.into_iter().enumerate() {
        let read = used.iter().filter_map(|&i| match rows.get(i)?.reading {
            Reading::Point { position_m } => Some((i, position_m[k])),
            _ => None,
        });
        for (value_m, of) in of_column(rows, &read.collect::<Vec<_>>(), kinds) {
            warnings.push(warning(column, value_m, rows, &of));
            coded.extend(of);
        }
    }
    (coded, warnings)
}

fn warning(column: &str, value_m: f64, rows: &[MeasurementRow], of: &[usize]) -> Diagnostic {
    let lines: Vec<u64> = of.iter().filter_map(|&i| rows.get(i)).map(|row| row.line).collect();
    Diagnostic::warning("measure::code-for-none", describe_code(column, mm_from_m(value_m), &lines))
        .help("these rows are left out; leave the cells empty where the instrument saw nothing")
}

/// Numbers that stand in all three coordinates of a point, metres, each with its rows: 0, 0, 0.
fn of_all_coordinates(
    rows: &[MeasurementRow],
    used: &[usize],
    kinds: &[JointKind],
) -> Vec<(f64, Vec<usize>)> {
    let mut alike: BTreeMap<u64, Vec<usize>> = BTreeMap::new();
    for &i in used {
        if let Some(Reading::Point { position_m }) = rows.get(i).map(|row| &row.reading)
            && position_m.iter().all(|value_m| value_m.to_bits() == position_m.x.to_bits())
        {
            alike.entry(position_m.x.to_bits()).or_default().push(i);
        }
    }
    let is_code =
        |of: &[usize]| of.len() >= FEWEST && 2 * of.len() < used.len() && are_apart(rows, of, kinds);
    alike.into_iter().filter(|(_, of)| is_code(of)).map(|(bits, of)| (f64::from_bits(bits), of)).collect()
}

/// Whether the arm stood elsewhere in some of these rows.
fn are_apart(rows: &[MeasurementRow], of: &[usize], kinds: &[JointKind]) -> bool {
    let mut pose = of.iter().filter_map(|&i| rows.get(i));
    let first = pose.next();
    pose.any(|row| first.is_some_and(|first| row.is_apart_from(first, kinds)))
}

/// What is said of the rows at `lines`, in which `column` holds a code.
#[must_use]
pub fn describe_code(column: &str, value: f64, lines: &[u64]) -> String {
    format!(
        "column {column} is {value} to the last digit in {}, which lie far from all others: a code where there was no reading",
        at_lines(lines)
    )
}

/// The codes of one coordinate, metres, each with its rows.
fn of_column(rows: &[MeasurementRow], read: &[(usize, f64)], kinds: &[JointKind]) -> Vec<(f64, Vec<usize>)> {
    let mut alike: BTreeMap<u64, Vec<usize>> = BTreeMap::new();
    for (i, value_m) in read {
        alike.entry(value_m.to_bits()).or_default().push(*i);
    }
    let repeated: Vec<(u64, Vec<usize>)> =
        alike.into_iter().filter(|(_, of)| of.len() >= FEWEST && are_apart(rows, of, kinds)).collect();
    let is_repeated = |value_m: f64| repeated.iter().any(|(bits, _)| *bits == value_m.to_bits());
    let others = || read.iter().map(|(_, value_m)| *value_m).filter(|value_m| !is_repeated(*value_m));
    let [low, high] = [others().fold(f64::INFINITY, f64::min), others().fold(f64::NEG_INFINITY, f64::max)];
    // What is read once must be most of the column: a plane that is touched again and again has its coordinate, too.
    if 2 * others().count() <= read.len() {
        return Vec::new();
    }
    let beyond = SPANS * (high - low);
    let is_far = |value_m: f64| value_m < low - beyond || value_m > high + beyond;
    repeated
        .into_iter()
        .map(|(bits, of)| (f64::from_bits(bits), of))
        .filter(|(value_m, _)| is_far(*value_m))
        .collect()
}
