//! The arm and its targets as the page draws them: frames in mm and degrees, long lists flat.

use super::embed::Decimals;
use nalgebra::{Isometry3, Vector3};
use rapid_compensation::compensate::{DriftPoint, TcpDrift};
use robot_model::robot::{JointKind, SerialArm};
use robot_model::units::{deg_from_rad, mm_from_m};
use serde::Serialize;
use serde_json::{Value, json};

/// The constructive model, in the words of a robot file.
pub(super) fn robot(arm: &SerialArm) -> Value {
    let joints: Vec<Value> = arm
        .joints
        .iter()
        .map(|joint| {
            let mut frame = frame(&joint.previous_from_joint);
            frame["axis"] = json!(joint.axis.as_slice());
            frame["type"] = json!(joint.kind);
            match joint.kind {
                JointKind::Revolute => {
                    frame["range_deg"] = json!(joint.range_rad.map(|range| range.map(deg_from_rad)));
                }
                JointKind::Prismatic => {
                    frame["range_mm"] = json!(joint.range_rad.map(|range| range.map(mm_from_m)));
                }
            }
            frame
        })
        .collect();
    json!({ "name": arm.name, "source": arm.source, "joint": joints, "flange": frame(&arm.last_from_flange) })
}

fn frame(pose: &Isometry3<f64>) -> Value {
    let (roll, pitch, yaw) = pose.rotation.euler_angles();
    let origin_mm: Vec<f64> = pose.translation.vector.iter().map(|&m| mm_from_m(m)).collect();
    let rpy_deg = [roll, pitch, yaw].map(deg_from_rad);
    json!({ "origin_mm": origin_mm, "rpy_deg": rpy_deg })
}

/// How the arm deforms: at minute `t[i]` by the sum over k of `shares[k][i]` times `offsets[k]`, rows of
/// dx, dy, dz in mm and rx, ry, rz in deg, and each target's error by the same sum of its own vectors.
#[derive(Serialize)]
pub(super) struct Course {
    t: Decimals<4>,
    shares: Vec<Decimals<7>>,
    offsets: Vec<Vec<Decimals<9>>>,
    has_model: bool,
    /// What `t` is counted from where it is a temperature, degrees Celsius.
    from_c: Option<f64>,
}

impl Course {
    pub(super) fn new(drift: &TcpDrift, from_c: Option<f64>) -> Self {
        let row = |row: &[f64; 6]| {
            let units = row.iter().enumerate();
            Decimals(units.map(|(k, &v)| if k < 3 { mm_from_m(v) } else { deg_from_rad(v) }).collect())
        };
        Self {
            t: Decimals(drift.t_min.clone()),
            shares: drift.shares.iter().map(|share| Decimals(share.clone())).collect(),
            offsets: drift.offsets.iter().map(|table| table.0.iter().map(row).collect()).collect(),
            has_model: drift.has_model,
            from_c,
        }
    }
}

/// Targets, one after the other in each list.
#[derive(Serialize)]
pub(super) struct Points {
    /// Index of the motion.
    motion: Vec<usize>,
    /// Which of the motion's values.
    value: Vec<usize>,
    /// Which of `tools` goes there.
    tool: Vec<usize>,
    /// Tools in the flange's frame, mm.
    tools: Vec<Decimals<4>>,
    /// Six for each, deg.
    q_deg: Decimals<4>,
    /// Three for each, mm in the base.
    p_mm: Decimals<3>,
    /// Three for each and each node of the course, mm in the base.
    e_mm: Decimals<5>,
}

impl Points {
    pub(super) fn new(points: &[&DriftPoint]) -> Self {
        let mut all = Self {
            motion: Vec::new(),
            value: Vec::new(),
            tool: Vec::new(),
            tools: Vec::new(),
            q_deg: Decimals(Vec::new()),
            p_mm: Decimals(Vec::new()),
            e_mm: Decimals(Vec::new()),
        };
        let mut known: Vec<Vector3<f64>> = Vec::new();
        for point in points {
            let tool_m = Vector3::from(point.flange_point_m);
            let tool = known.iter().rposition(|one| *one == tool_m).unwrap_or_else(|| {
                known.push(tool_m);
                all.tools.push(Decimals(tool_m.iter().map(|&m| mm_from_m(m)).collect()));
                known.len() - 1
            });
            all.motion.push(point.motion.index());
            all.value.push(point.value);
            all.tool.push(tool);
            all.q_deg.0.extend(point.q_rad.map(deg_from_rad));
            all.p_mm.0.extend(point.target_point_m.map(mm_from_m));
            all.e_mm.0.extend(point.displacements_m.iter().flatten().map(|&m| mm_from_m(m)));
        }
        all
    }
}
