//! How long arms are: a description in another unit makes one that is a thousand times as long, or as short.

use super::SerialArm;
use crate::units::mm_from_m;

/// How long arms are along their joints, metres: the smallest fit on a table, the largest load cars. Outside, the file is in another unit.
const ARM_M: std::ops::Range<f64> = 0.05..50.0;

/// Why no arm is as long as `arm`, as half a sentence; `None` where there are such arms.
pub(super) fn beyond_any_arm(arm: &SerialArm) -> Option<String> {
    let joints = arm.joints.iter().map(|joint| joint.previous_from_joint.translation.vector.norm());
    let length_m = joints.sum::<f64>() + arm.last_from_flange.translation.vector.norm();
    (!ARM_M.contains(&length_m))
        .then(|| format!("from the base to the flange it is {:.4} mm along the joints", mm_from_m(length_m)))
}
