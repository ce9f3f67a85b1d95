//! A plan as CSV: the poses alone, and a sheet to be filled in with what is measured.

use super::{MeasurementPlan, MeasurementStep};
use robot_model::units::deg_from_rad;
use std::fmt::Write as _;

const JOINTS: &str = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg";
const DIRECTIONS: &str = "dir1,dir2,dir3,dir4,dir5,dir6";

/// The poses, in the order of the run.
#[must_use]
pub fn poses_csv(plan: &MeasurementPlan) -> String {
    let mut out = format!("id,pose_id,{JOINTS},{DIRECTIONS},payload_kg\n");
    for (k, step) in plan.steps.iter().enumerate() {
        if let MeasurementStep::Pose { pose, .. } = step {
            let _ = writeln!(out, "{},{},{}", k + 1, pose + 1, arm(step)); // a String takes everything
        }
    }
    out
}

/// A measurement file whose measured columns are empty: fill in `t_min`, `x_mm`, `y_mm`, `z_mm`.
#[must_use]
pub fn template_csv(plan: &MeasurementPlan) -> String {
    let mut out = format!("id,pose_id,kind,fixed_id,t_min,{JOINTS},{DIRECTIONS},payload_kg,x_mm,y_mm,z_mm\n");
    for (k, step) in plan.steps.iter().enumerate() {
        let _ = match step {
            MeasurementStep::Pose { pose, .. } => {
                writeln!(out, "{},{},pose,,,{},,,", k + 1, pose + 1, arm(step))
            }
            MeasurementStep::Nest { nest } => {
                let nest = nest + 1;
                writeln!(out, "{},N{nest},base,N{nest},,,,,,,,,,,,,,,,,", k + 1)
            }
        };
    }
    out
}

/// Joints, directions and payload.
fn arm(step: &MeasurementStep) -> String {
    let MeasurementStep::Pose { q_rad, direction, payload_kg, .. } = step else { return String::new() };
    let joints = q_rad.map(|q| format!("{:.4}", deg_from_rad(q))).join(",");
    let signs = direction.map(|d| d.to_string()).join(",");
    format!("{joints},{signs},{payload_kg}")
}
