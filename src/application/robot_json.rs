//! A robot as scripts read it.

use crate::report::rounded;
use nalgebra::Isometry3;
use robot_model::robot::{JointKind, SerialArm};
use robot_model::units::{deg_from_rad, mm_from_m};
use serde_json::{Value, json};

/// A robot as JSON: each joint's frame in the one before it (origin, and roll, pitch, yaw about fixed axes), its axis there, ranges in degrees or mm.
#[must_use]
pub fn robot_json(robot: &SerialArm) -> Value {
    let joints = robot.joints.iter().map(|joint| {
        let (kind, in_unit): (_, fn(f64) -> f64) = match joint.kind {
            JointKind::Revolute => ("revolute", deg_from_rad),
            JointKind::Prismatic => ("prismatic", mm_from_m),
        };
        json!({
            "type": kind,
            "origin_mm": in_mm(&joint.previous_from_joint),
            "rpy_deg": rpy_deg(&joint.previous_from_joint),
            "axis": <[f64; 3]>::from(joint.axis.into_inner()),
            "range": joint.range_rad.map(|range| range.map(in_unit)),
        })
    });
    let flange =
        json!({ "origin_mm": in_mm(&robot.last_from_flange), "rpy_deg": rpy_deg(&robot.last_from_flange) });
    json!({
        "name": robot.name, "source": robot.source,
        "joints": joints.collect::<Vec<Value>>(), "flange": flange,
    })
}

/// Roll, pitch and yaw of a frame about fixed axes, as URDF and a robot file have them, degrees.
pub(crate) fn rpy_deg(frame: &Isometry3<f64>) -> [f64; 3] {
    <[f64; 3]>::from(frame.rotation.euler_angles()).map(|angle_rad| rounded(deg_from_rad(angle_rad)))
}

fn in_mm(frame: &Isometry3<f64>) -> [f64; 3] {
    <[f64; 3]>::from(frame.translation.vector).map(|m| rounded(mm_from_m(m)))
}
