//! A robot as scripts read it.

use robot_model::robot::{JointKind, SerialArm};
use robot_model::units::{deg_from_rad, mm_from_m};
use serde_json::{Value, json};

/// A robot as JSON: axes in the base at joints of 0, ranges in degrees or mm.
#[must_use]
pub fn robot_json(robot: &SerialArm) -> Value {
    let joints = robot.joints.iter().map(|joint| {
        let (kind, in_unit): (_, fn(f64) -> f64) = match joint.kind {
            JointKind::Revolute => ("revolute", deg_from_rad),
            JointKind::Prismatic => ("prismatic", mm_from_m),
        };
        json!({
            "type": kind,
            "axis": <[f64; 3]>::from(joint.axis.into_inner()),
            "range": joint.range_rad.map(|range| range.map(in_unit)),
        })
    });
    json!({ "name": robot.name, "source": robot.source, "joints": joints.collect::<Vec<Value>>() })
}
