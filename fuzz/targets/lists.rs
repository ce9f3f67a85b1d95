//! Any list of targets, or of joints that a post-processor knows, is read or refused.

use nalgebra::UnitQuaternion;
use rapid_compensation::compensate::{JointsHint, targets};

/// Targets with and without orientations of their own, and joints: poses of finite numbers or an error.
pub fn lists(data: &[u8]) {
    for orientation in [None, Some(UnitQuaternion::identity())] {
        let poses = targets::read(data, orientation.as_ref()).unwrap_or_default();
        for pose in poses {
            let numbers = pose.base_from_flange.to_homogeneous();
            assert!(numbers.iter().all(|number| number.is_finite()), "{}: {numbers}", pose.name);
        }
    }
    drop(JointsHint::read(data));
}
