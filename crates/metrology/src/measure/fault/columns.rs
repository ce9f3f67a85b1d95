//! Faults that the cells show before any geometry: points that stand still, columns in another unit, a pose_id that names
//! no pose.

use super::{Fault, FaultKind};
use crate::measure::{MeasurementRow, Measurements, Reading};
use robot_model::deform::gravity::links;
use robot_model::robot::SerialArm;
use robot_model::units::{celsius_from_fahrenheit, celsius_from_kelvin, kg_from_g};
use std::collections::BTreeMap;

/// Joints of one pose differ by less than this, radians.
const SAME_RAD: f64 = 0.01;
/// Fewer rows than this with one point may be a copied line; they are set aside by the search.
const FEWEST_FROZEN: usize = 3;
/// Joints of one arm are never further apart in temperature, K.
const APART_K: f64 = 15.0;
/// In the right unit they are nearer to each other than this, K.
const NEAR_K: f64 = 10.0;
/// Fewer rows than this say nothing of a unit.
const FEWEST_ROWS: usize = 3;

/// What the cells alone contradict, of the rows that `used` names.
#[must_use]
pub fn find_in_cells(measurements: &Measurements, used: &[usize], robot: &SerialArm) -> Option<Fault> {
    let rows: Vec<&MeasurementRow> = used.iter().filter_map(|&i| measurements.rows.get(i)).collect();
    frozen(&rows)
        .or_else(|| pose_names(measurements, &rows))
        .or_else(|| payload(&rows, robot))
        .or_else(|| temperatures(&rows))
}

fn apart(a: &MeasurementRow, b: &MeasurementRow) -> bool {
    a.q_rad.iter().zip(&b.q_rad).any(|(a, b)| (a - b).abs() > SAME_RAD)
}

/// One point to the last digit, at joints that differ.
fn frozen(rows: &[&MeasurementRow]) -> Option<Fault> {
    let mut seen: BTreeMap<([u64; 3], usize), Vec<&MeasurementRow>> = BTreeMap::new();
    for row in rows {
        if let Reading::Point { position_m } = row.reading {
            let bits = [position_m.x, position_m.y, position_m.z].map(f64::to_bits);
            seen.entry((bits, row.target)).or_default().push(row);
        }
    }
    let still = seen.values().filter(|same| {
        let poses =
            same.iter().enumerate().filter(|(k, row)| same[..*k].iter().all(|before| apart(row, before)));
        poses.count() >= FEWEST_FROZEN
    });
    let lines: Vec<u64> = still.flatten().map(|row| row.line).collect();
    (!lines.is_empty()).then(|| {
        Fault::in_rows(
            FaultKind::FrozenPoint,
            "x_mm, y_mm, z_mm",
            lines,
            |count, which| format!("{count} rows ({which}) have one point to the last digit, though their joints differ: the instrument stood still"),
        )
    })
}

/// Rows of one pose_id at joints that differ.
fn pose_names(measurements: &Measurements, rows: &[&MeasurementRow]) -> Option<Fault> {
    if !measurements.channels.pose_id {
        return None;
    }
    let mut first: BTreeMap<usize, &MeasurementRow> = BTreeMap::new();
    let (mut repeats, mut lines) = (0, Vec::new());
    for row in rows.iter().filter(|row| row.reading.involves_arm()) {
        let known = first.entry(row.pose).or_insert(row);
        if known.line != row.line {
            repeats += 1;
            if apart(row, known) {
                lines.push(row.line);
            }
        }
    }
    (lines.len() >= FEWEST_ROWS && 2 * lines.len() > repeats).then(|| {
        Fault::in_rows(FaultKind::PoseNames, "pose_id", lines, |count, which| {
            format!("{count} rows ({which}) share a pose_id with rows whose joints differ by more than half a degree: rows of one pose_id repeat one pose")
        })
    })
}

/// A payload that weighs more than all that moves of the arm.
fn payload(rows: &[&MeasurementRow], robot: &SerialArm) -> Option<Fault> {
    let arm_kg: f64 = links(robot.geometry()).iter().map(|link| link.mass_kg).sum();
    let heavy: Vec<&&MeasurementRow> =
        rows.iter().filter(|row| row.payload_kg.is_some_and(|kg| kg > arm_kg)).collect();
    let largest_kg = heavy.iter().filter_map(|row| row.payload_kg).fold(0.0, f64::max);
    (!heavy.is_empty()).then(|| {
        let lines = heavy.iter().map(|row| row.line).collect();
        let grams = if kg_from_g(largest_kg) < 0.5 * arm_kg { ": are they grams?" } else { "" };
        Fault::in_rows(FaultKind::PayloadBeyondArm, "payload_kg", lines, |count, which| {
            format!(
                "{count} rows ({which}) have a payload of up to {largest_kg:.0} kg, more than all moving links of {} weigh ({arm_kg:.0} kg){grams}",
                robot.name
            )
        })
    })
}

/// Degrees Celsius from another unit.
type Celsius = fn(f64) -> f64;

/// One joint's temperature in another unit than the others'.
fn temperatures(rows: &[&MeasurementRow]) -> Option<Fault> {
    let units: [(&str, Celsius); 2] =
        [("degrees Fahrenheit", celsius_from_fahrenheit), ("kelvin", celsius_from_kelvin)];
    let joints = rows.iter().find_map(|row| row.joint_temperature_c).map_or(0, |all| all.len());
    (0..joints).find_map(|j| {
        units.iter().find_map(|(name, celsius)| {
            let wrong = |row: &&&MeasurementRow| {
                row.joint_temperature_c.is_some_and(|all| {
                    let mut others: Vec<f64> = (0..joints).filter(|k| *k != j).map(|k| all[k]).collect();
                    others.sort_by(f64::total_cmp);
                    let middle = others[others.len() / 2];
                    (all[j] - middle).abs() > APART_K && (celsius(all[j]) - middle).abs() < NEAR_K
                })
            };
            let lines: Vec<u64> = rows.iter().filter(wrong).map(|row| row.line).collect();
            (lines.len() >= FEWEST_ROWS).then(|| {
                let column = format!("temp_j{}_c", j + 1);
                Fault::in_rows(FaultKind::ColumnUnits, &column.clone(), lines, |count, which| {
                    format!("column {column} is in {name} in {count} rows ({which})")
                })
            })
        })
    })
}
