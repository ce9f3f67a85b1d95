//! Faults that the cells show before any geometry: points that stand still, columns in another unit, a pose_id that names
//! no pose.

use super::{Fault, FaultKind, frozen};
use crate::temperature_columns;
use crate::{MeasurementRow, Measurements, Reading};
use robot_model::deform::gravity::links;
use robot_model::robot::{JointKind, SerialArm};
use robot_model::units::{celsius_from_fahrenheit, celsius_from_kelvin, kg_from_g, min_from_s};
use statistics::upper_median;
use std::collections::BTreeMap;

/// Fewer rows than this with one point may be a copied line; they are set aside by the search.
const FEWEST_FROZEN: usize = 3;
/// Joints of one arm are never further apart in temperature, K.
const APART_K: f64 = 15.0;
/// In the right unit they are nearer to each other than this, K.
const NEAR_K: f64 = 10.0;
/// No arm is all as hot as this, in its coldest joint, °C: rooms for robots are of 5 to 45 °C (ISO 9283 tests at 20 °C, data
/// sheets of ABB's arms end at 45 °C), and what warms it warms each joint by another amount.
const HOT_C: f64 = 55.0;
/// The seals and the grease of an arm end well below this, °C: where all joints are as hot the numbers are something else.
const NO_ARM_C: f64 = 120.0;
/// As cold as this, in the other unit, is a room, °C.
const ROOM_C: [f64; 2] = [5.0, 45.0];
/// Steps of time in seconds are between these many times the ones before, in minutes: 60, where the work goes on as before.
const SECONDS_A_MINUTE: [f64; 2] = [48.0, 75.0];
/// The next row comes within so many usual steps of the one before.
const LATER_STEPS: f64 = 4.0;
/// Fewer rows on either side say nothing of how fast time goes there.
const FEWEST_STAMPS: usize = 8;
/// Fewer rows than this say nothing of a unit.
const FEWEST_ROWS: usize = 3;

/// What the cells alone contradict, of the rows that `used` names.
#[must_use]
pub fn find_in_cells(measurements: &Measurements, used: &[usize], robot: &SerialArm) -> Option<Fault> {
    let rows: Vec<&MeasurementRow> = used.iter().filter_map(|&i| measurements.rows.get(i)).collect();
    frozen_points(&rows, &measurements.joint_kinds)
        .or_else(|| frozen::all_joints(&rows, robot))
        .or_else(|| payload(&rows, robot))
        .or_else(|| seconds(&rows))
        .or_else(|| temperatures(&rows))
        .or_else(|| hot_arm(&rows))
}

/// One point to the last digit, at joints that differ.
fn frozen_points(rows: &[&MeasurementRow], kinds: &[JointKind]) -> Option<Fault> {
    let mut seen: BTreeMap<([u64; 3], usize), Vec<&MeasurementRow>> = BTreeMap::new();
    for row in rows {
        if let Reading::Point { position_m } = row.reading {
            let bits = [position_m.x, position_m.y, position_m.z].map(f64::to_bits);
            seen.entry((bits, row.target)).or_default().push(row);
        }
    }
    let still = seen.values().filter(|same| {
        let poses = same
            .iter()
            .enumerate()
            .filter(|(k, row)| same[..*k].iter().all(|before| row.is_apart_from(before, kinds)));
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

/// Rows of one pose_id at joints that differ, of the rows that `used` names; after what the points contradict, for joints in another
/// unit differ as well.
#[must_use]
pub fn find_pose_names(measurements: &Measurements, used: &[usize]) -> Option<Fault> {
    if !measurements.channels.pose_id {
        return None;
    }
    let kinds = &measurements.joint_kinds;
    let rows = used.iter().filter_map(|&i| measurements.rows.get(i));
    let mut first: BTreeMap<usize, &MeasurementRow> = BTreeMap::new();
    let (mut repeats, mut lines) = (0, Vec::new());
    for row in rows.filter(|row| row.reading.involves_arm()) {
        let known = first.entry(row.pose).or_insert(row);
        if known.line != row.line {
            repeats += 1;
            if row.is_apart_from(known, kinds) {
                lines.push(row.line);
            }
        }
    }
    (lines.len() >= FEWEST_ROWS && 2 * lines.len() > repeats).then(|| {
        Fault::in_rows(FaultKind::PoseNames, "pose_id", lines, |count, which| {
            let or_slide = if kinds.iter().any(|kind| kind.slides()) { " or a millimetre" } else { "" };
            format!("{count} rows ({which}) share a pose_id with rows whose joints differ by more than half a degree{or_slide}: rows of one pose_id repeat one pose")
        })
    })
}

/// Minutes up to some row and seconds from there on: the stamps leap by so much that they go on where they were as minutes.
fn seconds(rows: &[&MeasurementRow]) -> Option<Fault> {
    let stamps: Option<Vec<(f64, u64)>> = rows.iter().map(|row| Some((row.t_min?, row.line))).collect();
    find_in_stamps(&stamps?)
}

/// The same of minutes with their lines.
#[must_use]
pub fn find_in_stamps(stamps: &[(f64, u64)]) -> Option<Fault> {
    let step = |k: usize| stamps[k].0 - stamps[k - 1].0;
    let usual = |steps: std::ops::Range<usize>| {
        upper_median(&mut steps.map(step).filter(|step| *step > 0.0).collect::<Vec<f64>>())
    };
    let n = stamps.len();
    let leaps = |from: &usize| {
        let on = min_from_s(stamps[*from].0) - stamps[from - 1].0;
        // Of nearly all rows this alone says no; the usual steps are asked of all rows before and after.
        if on < 0.0 {
            return false;
        }
        let Some((before, after)) = usual(1..*from).zip(usual(from + 1..n)) else { return false };
        let times = after / before;
        (0.0..LATER_STEPS * before).contains(&on)
            && step(*from) > LATER_STEPS * before
            && (SECONDS_A_MINUTE[0]..SECONDS_A_MINUTE[1]).contains(&times)
    };
    let from = (FEWEST_STAMPS..n.saturating_sub(FEWEST_STAMPS)).find(leaps)?;
    let lines = stamps.get(from..)?.iter().map(|(_, line)| *line).collect();
    Some(Fault::in_rows(FaultKind::ColumnUnits, "t_min", lines, |count, which| {
        format!(
            "column t_min is in seconds in {count} rows ({which}): as minutes they go on where the rows before end"
        )
    }))
}

/// A payload that weighs more than all that moves of the arm.
fn payload(rows: &[&MeasurementRow], robot: &SerialArm) -> Option<Fault> {
    let arm_kg: f64 = links(robot.geometry()).iter().map(|link| link.mass_kg).sum();
    let heavy: Vec<&&MeasurementRow> =
        rows.iter().filter(|row| row.payload_kg.is_some_and(|kg| kg > arm_kg)).collect();
    let largest_kg = heavy.iter().filter_map(|row| row.payload_kg).fold(0.0, f64::max);
    (!heavy.is_empty()).then(|| {
        let lines = heavy.iter().map(|row| row.line).collect();
        let grams = if kg_from_g(largest_kg) < 0.5 * arm_kg { " (are they grams?)" } else { "" };
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
                    let others = (0..joints).filter(|k| *k != j).map(|k| all[k]);
                    let Some(middle) = upper_median(&mut others.collect::<Vec<f64>>()) else { return false };
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

/// All joints' temperatures in another unit, from the first row on or from one row to another.
fn hot_arm(rows: &[&MeasurementRow]) -> Option<Fault> {
    let units: [(&str, Celsius); 2] =
        [("degrees Fahrenheit", celsius_from_fahrenheit), ("kelvin", celsius_from_kelvin)];
    let coldest = |row: &MeasurementRow| {
        row.joint_temperature_c.map(|all| all.iter().copied().fold(f64::INFINITY, f64::min))
    };
    let hot = |row: &MeasurementRow| coldest(row).is_some_and(|coldest| coldest > HOT_C);
    let which: Vec<&MeasurementRow> = rows.iter().copied().filter(|row| hot(row)).collect();
    let least = which.iter().filter_map(|row| coldest(row)).reduce(f64::min)?;
    let is_room = |celsius: &Celsius| (ROOM_C[0]..=ROOM_C[1]).contains(&celsius(least));
    let unit = units.into_iter().find(|(_, celsius)| is_room(celsius)).map(|(name, _)| name);
    if unit.is_none() && least < NO_ARM_C {
        return None;
    }
    // An arm that warms up comes there by and by.
    let measured = || rows.iter().filter(|row| row.joint_temperature_c.is_some());
    let jumps = measured()
        .zip(measured().skip(1))
        .filter(|(a, b)| hot(a) != hot(b))
        .all(|(a, b)| coldest(a).zip(coldest(b)).is_some_and(|(a, b)| (a - b).abs() > APART_K));
    (which.len() >= FEWEST_ROWS && jumps).then(|| {
        let joints = which.first().and_then(|row| row.joint_temperature_c).map_or(0, |all| all.len());
        let lines = which.iter().map(|row| row.line).collect();
        let column = temperature_columns(joints);
        Fault::in_rows(FaultKind::ColumnUnits, &column, lines, |count, which| {
            let unit = unit.map_or("in another unit, or have lost a decimal point,".to_owned(), |name| format!("in {name}"));
            format!("the joints are {least:.0} °C warm or more in {count} rows ({which}), as no arm is: the columns {column} are {unit} there")
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of one pose_id whose slide stands 5 mm apart are of several poses; half a millimetre is how it was read.
    #[test]
    fn a_slide_that_stands_millimetres_apart_is_of_another_pose() {
        let reason = |step_mm: f64| {
            let mut text = "pose_id,q1_deg,q2_deg,q3_mm,q4_deg,x_mm,y_mm,z_mm\n".to_owned();
            for k in 0..8 {
                text += &format!("A,10,20,{},30,400,{k},100\n", 50.0 + step_mm * f64::from(k % 2));
            }
            let measured = Measurements::from_csv(text.as_bytes()).unwrap();
            find_pose_names(&measured, &(0..8).collect::<Vec<_>>()).map(|fault| fault.reason)
        };
        assert_eq!(reason(0.5), None);
        assert!(reason(5.0).unwrap().contains("by more than half a degree or a millimetre"));
    }
}
