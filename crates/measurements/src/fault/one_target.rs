//! One of several targets whose rows alone do not go with the robot.

use super::far_rows::{PartFault, PosedRow};
use super::{Fault, find_fault, find_in_rows};
use crate::{Station, register};
use nalgebra::Isometry3;
use robot_model::robot::SerialArm;

/// What is wrong with the rows of one target, where those of each other one go with the robot; `names`: what the file calls the targets.
#[must_use]
pub fn find_in_one_target(robot: &SerialArm, rows: &[PosedRow], names: &[String]) -> Option<Fault> {
    if names.len() < 2 {
        return None;
    }
    let mut faults = Vec::new();
    for (target, name) in names.iter().enumerate() {
        let own: Vec<PosedRow> = rows
            .iter()
            .filter(|row| row.station.target == target)
            .map(|row| PosedRow { station: Station { target: 0, ..row.station.clone() }, pose: row.pose })
            .collect();
        if let Some(fault) = of_alone(robot, &own)? {
            let lines = own.iter().map(|row| row.station.line).collect();
            faults.push((name, lines, fault));
        }
    }
    // Where several do not go with it the robot does not.
    let [(name, lines, fault)] = <[(&String, Vec<u64>, Fault); 1]>::try_from(faults).ok()?;
    let lines = if fault.lines.is_empty() { lines } else { fault.lines };
    Some(Fault { lines, reason: format!("of target {name} alone: {}", fault.reason), ..fault })
}

/// What rows of one target contradict; no answer of too few.
fn of_alone(robot: &SerialArm, rows: &[PosedRow]) -> Option<Option<Fault>> {
    if let Some(PartFault::Fault(fault)) = find_in_rows(robot, rows, 1, None) {
        return Some(Some(fault));
    }
    let stations: Vec<Station> = rows.iter().map(|row| row.station.clone()).collect();
    let poses: Vec<Isometry3<f64>> = rows.iter().map(|row| row.pose).collect();
    let registration = register(&stations, &poses, 1, None).ok()?;
    Some(find_fault(robot, &stations, 1, &registration, None))
}
