//! A plan as CSV: the poses alone, and a sheet to be filled in with what is measured.

use super::{MeasurementPlan, MeasurementStep};
use robot_model::robot::{Axis, SerialArm};
use std::fmt::Write as _;

/// Names of the columns of joints and directions.
fn columns(robot: &SerialArm) -> String {
    let joints = (0..robot.joints.len()).map(|j| robot.column(Axis::at(j)));
    let directions = (1..=robot.joints.len()).map(|joint| format!("dir{joint}"));
    joints.chain(directions).collect::<Vec<String>>().join(",")
}

/// The poses, in the order of the run.
#[must_use]
pub fn poses_csv(plan: &MeasurementPlan, robot: &SerialArm) -> String {
    let mut out = format!("id,pose_id,{},payload_kg\n", columns(robot));
    for (k, step) in plan.steps.iter().enumerate() {
        if let MeasurementStep::Pose { pose, .. } = step {
            let _ = writeln!(out, "{},{},{}", k + 1, pose + 1, arm(step, robot)); // a String takes everything
        }
    }
    out
}

/// A measurement file whose measured columns are empty: fill in `t_min`, `x_mm`, `y_mm`, `z_mm`.
#[must_use]
pub fn template_csv(plan: &MeasurementPlan, robot: &SerialArm) -> String {
    let columns = columns(robot);
    let mut out = format!("id,pose_id,kind,fixed_id,t_min,{columns},payload_kg,x_mm,y_mm,z_mm\n");
    let empty = ",".repeat(2 * robot.joints.len() + 5);
    for (k, step) in plan.steps.iter().enumerate() {
        let _ = match step {
            MeasurementStep::Pose { pose, .. } => {
                writeln!(out, "{},{},pose,,,{},,,", k + 1, pose + 1, arm(step, robot))
            }
            MeasurementStep::Nest { nest } => {
                let nest = nest + 1;
                writeln!(out, "{},N{nest},base,N{nest}{empty}", k + 1)
            }
        };
    }
    out
}

/// Joints, directions and payload.
fn arm(step: &MeasurementStep, robot: &SerialArm) -> String {
    let MeasurementStep::Pose { q_rad, direction, payload_kg, .. } = step else { return String::new() };
    let joints = robot.in_deg_or_mm(q_rad).into_iter().map(|q| format!("{q:.4}"));
    let cells: Vec<String> = joints.chain(direction.iter().map(i8::to_string)).collect();
    format!("{},{payload_kg}", cells.join(","))
}
