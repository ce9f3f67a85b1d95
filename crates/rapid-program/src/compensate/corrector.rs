//! The corrected targets of a plan, computed when they are asked for.
//!
//! Each bucket's joints are solved from the nominal ones alone, as [`correct`](mod@super::correct) does when it looks whether
//! they may be sent: in whatever order they are asked for, the numbers are the same.

use super::model::{Model, WarmBucket};
use super::placement::Placement;
use super::plan::{Corrected, Corrector, PlannedMotion, PlannedTarget};
use crate::program::motion::{Motion, TargetValue};
use nalgebra::Isometry3;
use robot_model::deform::DeformedArm;
use robot_model::kinematics::{Chain, solve};

/// The arm as the controller believes it, and as it is at each bucket's minute.
#[derive(Debug)]
pub(super) struct WarmArms {
    nominal: Chain,
    at: Vec<DeformedArm>,
}

impl WarmArms {
    pub(super) fn new(model: &Model, warm: &[WarmBucket]) -> Self {
        Self { nominal: model.nominal.clone(), at: warm.iter().map(|bucket| bucket.at.clone()).collect() }
    }

    fn target(
        &self,
        placement: &Placement,
        value: &TargetValue,
        planned: &PlannedTarget,
        arm: &DeformedArm,
    ) -> Option<Corrected> {
        let nominal_q_rad = &planned.nominal_q_rad;
        let base_from_flange = match value {
            TargetValue::Rob(pose) => placement.base_from_flange(&pose.object_from_tcp),
            TargetValue::Joint(_) | TargetValue::FromJoints(_) => self.nominal.forward(nominal_q_rad),
        };
        let q_rad = solve(&arm.under(&planned.conditions), &base_from_flange, nominal_q_rad).ok()?.q_rad;
        if matches!(value, TargetValue::Joint(_)) {
            return Some(Corrected::Joints { q_rad });
        }
        let meant = placement.object_from_tcp(&base_from_flange);
        Some(as_written(&placement.object_from_tcp(&self.nominal.forward(&q_rad)), &meant))
    }
}

impl Corrector for WarmArms {
    fn corrected(&self, motion: &Motion, planned: &PlannedMotion, bucket: usize) -> Option<Vec<Corrected>> {
        let arm = self.at.get(bucket)?;
        let placement = Placement::of(motion).ok()?;
        let values = motion.targets.iter().flat_map(|target| target.values());
        values
            .zip(&planned.targets)
            .map(|(value, planned)| self.target(&placement, value, planned, arm))
            .collect()
    }
}

/// The frame as numbers, the quaternion with the sign of the original's so that successive buckets and
/// targets do not flip.
fn as_written(object_from_tcp: &Isometry3<f64>, meant: &Isometry3<f64>) -> Corrected {
    let q = object_from_tcp.rotation.quaternion();
    let sign = if q.dot(meant.rotation.quaternion()) < 0.0 { -1.0 } else { 1.0 };
    let t = &object_from_tcp.translation.vector;
    Corrected::Pose {
        position_m: [t.x, t.y, t.z],
        orientation_wxyz: [sign * q.w, sign * q.i, sign * q.j, sign * q.k],
    }
}
