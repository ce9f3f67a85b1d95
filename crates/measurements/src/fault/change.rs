//! What people and programs do to the cells of a row: another unit, another sign, the cells of another column.

use super::FaultKind;
use crate::Station;
use crate::column_names::POINT;
use robot_model::robot::{Axis, SerialArm};
use robot_model::units::{deg_from_rad, rad_from_deg};
use std::f64::consts::TAU;

/// The units that points come in beside millimetres.
pub(super) const LENGTHS: [(f64, &str); 4] =
    [(1000.0, "metres"), (304.8, "feet"), (25.4, "inches"), (10.0, "centimetres")];
/// No angle in radians is larger.
pub(super) const TURN_RAD: f64 = 7.0;
/// Degrees of a gon, of which a turn has 400.
pub(super) const DEG_PER_GON: f64 = 0.9;

/// What may have happened to a row, undone.
pub(super) struct Change {
    /// Kind of the fault.
    pub kind: FaultKind,
    /// Column, or columns, that it is in.
    pub column: String,
    /// What is wrong, as half a sentence.
    pub description: String,
    /// Takes the suspected fault out of a row.
    pub change: Box<dyn Fn(&mut Station)>,
}

impl Change {
    fn new(
        kind: FaultKind,
        column: impl Into<String>,
        description: impl Into<String>,
        change: impl Fn(&mut Station) + 'static,
    ) -> Self {
        let (column, description) = (column.into(), description.into());
        Self { kind, column, description, change: Box::new(change) }
    }
}

/// What may have happened to some of these rows or to a column of `arm`'s, of what is alike the more usual first.
#[must_use]
pub(super) fn changes<'s>(arm: &SerialArm, rows: impl Iterator<Item = &'s Station> + Clone) -> Vec<Change> {
    let turning: Vec<usize> = (0..arm.joints.len()).filter(|&j| !arm.joints[j].kind.slides()).collect();
    let mut all = of_points();
    all.extend(without_marks(arm, &turning, rows));
    all.extend(of_single_joints(arm, &turning));
    all.extend(of_two_joints(arm));
    let columns = || arm.columns();
    for (name, degrees) in [("radians", deg_from_rad_of_a_turn as fn(f64) -> f64), ("gon", deg_from_gon)] {
        let joints = turning.clone();
        let description = format!("the joints are in {name}, the columns say degrees");
        all.push(Change::new(FaultKind::JointUnits, columns(), description, move |s| {
            joints.iter().for_each(|&j| s.q_rad[j] = degrees(s.q_rad[j]));
        }));
    }
    all
}

/// An angle that was read as degrees and is one of radians; more than a turn of them was none.
fn deg_from_rad_of_a_turn(read: f64) -> f64 {
    if read.abs() < rad_from_deg(TURN_RAD) { deg_from_rad(read) } else { read }
}

/// An angle that was read as degrees and is one of gons.
fn deg_from_gon(read: f64) -> f64 {
    DEG_PER_GON * read
}

fn of_points() -> Vec<Change> {
    let mut all = Vec::new();
    for (factor, name) in LENGTHS {
        let description = format!("the measured points are in {name}, the columns say mm");
        all.push(Change::new(FaultKind::PositionUnits, POINT.join(", "), description, move |s| {
            s.reading = s.reading.scaled(factor);
        }));
        for (k, axis) in POINT.into_iter().enumerate() {
            let description = format!("column {axis} is in {name}");
            all.push(Change::new(FaultKind::ColumnUnits, axis, description, move |s| on_axis(s, k, factor)));
        }
    }
    for (k, axis) in POINT.into_iter().enumerate() {
        let description = format!("column {axis} has the other sign");
        all.push(Change::new(FaultKind::SwappedAxes, axis, description, move |s| on_axis(s, k, -1.0)));
        let other = (k + 1) % POINT.len();
        let mut both = [axis, POINT[other]];
        sorting::ascending(&mut both);
        let description = format!("the columns {} and {} are swapped", both[0], both[1]);
        all.push(Change::new(FaultKind::SwappedAxes, both.join(", "), description, move |s| {
            if let Some(position_m) = s.reading.position_mut() {
                position_m.swap_rows(k, other);
            }
        }));
    }
    all
}

/// Decimals that a column is written with, the usual ones first: without its decimal mark a number is ten to their power times too large.
const DECIMALS: [i32; 6] = [3, 4, 2, 1, 5, 6];

/// Points no further off than this have their decimal marks: one less puts the nearest tracker's readings beyond it. And no joint turns further.
const FURTHEST_M: f64 = 3.0;
const MOST_RAD: f64 = 2.0 * TAU;

/// Columns whose decimal marks are lost: those that hold more than can be.
fn without_marks<'s>(
    arm: &SerialArm,
    turning: &[usize],
    rows: impl Iterator<Item = &'s Station> + Clone,
) -> Vec<Change> {
    let lost = |column: &str, scale: fn(&mut Station, usize, f64), at: usize| -> Vec<Change> {
        let of = |decimals: i32| {
            let times = 10_f64.powi(decimals);
            let description =
                format!("column {column} is {times} times too large: its decimal marks are lost");
            Change::new(FaultKind::ColumnUnits, column, description, move |s| scale(s, at, 1.0 / times))
        };
        DECIMALS.into_iter().map(of).collect()
    };
    let largest = |of: &dyn Fn(&Station) -> f64| rows.clone().map(|row| of(row).abs()).fold(0.0, f64::max);
    let mut all = Vec::new();
    for (k, axis) in POINT.into_iter().enumerate() {
        let read_m = |row: &Station| row.reading.position_m().map_or(0.0, |point_m| point_m[k]);
        if largest(&read_m) > FURTHEST_M {
            all.extend(lost(axis, on_axis, k));
        }
    }
    for &j in turning.iter().filter(|&&j| largest(&|row| row.q_rad[j]) > MOST_RAD) {
        all.extend(lost(&arm.column(Axis::at(j)), |s, j, factor| s.q_rad[j] *= factor, j));
    }
    all
}

fn on_axis(station: &mut Station, k: usize, factor: f64) {
    if let Some(position_m) = station.reading.position_mut() {
        position_m[k] *= factor;
    }
}

fn of_single_joints(arm: &SerialArm, turning: &[usize]) -> Vec<Change> {
    let mut all = Vec::new();
    for &j in turning {
        let column = arm.column(Axis::at(j));
        let of_joint = |kind, description: String, new: fn(f64) -> f64| {
            Change::new(kind, column.clone(), description, move |s| s.q_rad[j] = new(s.q_rad[j]))
        };
        all.extend([
            of_joint(
                FaultKind::ColumnUnits,
                format!("column {column} is in radians"),
                deg_from_rad_of_a_turn,
            ),
            of_joint(
                FaultKind::JointColumns,
                format!(
                    "column {column} has the other sign: joint {} is counted the other way round",
                    Axis::at(j)
                ),
                |q_rad| -q_rad,
            ),
            of_joint(FaultKind::ColumnUnits, format!("column {column} is in gon"), deg_from_gon),
        ]);
    }
    all
}

fn of_two_joints(arm: &SerialArm) -> Vec<Change> {
    let joints = arm.joints.len();
    let mut all = Vec::new();
    for a in 0..joints {
        for b in (a + 1..joints).filter(|&b| arm.joints[a].kind == arm.joints[b].kind) {
            let columns = format!("{}, {}", arm.column(Axis::at(a)), arm.column(Axis::at(b)));
            let description =
                format!("the columns of joints {} and {} are swapped", Axis::at(a), Axis::at(b));
            all.push(Change::new(FaultKind::JointColumns, columns, description, move |s| s.q_rad.swap(a, b)));
        }
    }
    let has_elbow = [1, 2].iter().all(|&j| arm.joints.get(j).is_some_and(|joint| !joint.kind.slides()));
    for (sign, verb) in [(1.0, "added"), (-1.0, "taken off")].into_iter().filter(|_| has_elbow) {
        let description = format!("joint 3 is counted from the horizontal: joint 2 has to be {verb}");
        all.push(Change::new(FaultKind::JointColumns, "q3_deg", description, move |s| {
            s.q_rad[2] += sign * s.q_rad[1];
        }));
    }
    all
}
