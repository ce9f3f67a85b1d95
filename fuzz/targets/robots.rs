//! Any description of a robot is read or refused.

#![allow(clippy::expect_used, reason = "a target stops where its promise is broken")]

use robot_model::robot::{BackedUp, DhConvention, SerialArm};

/// URDF, robot file, table of Denavit-Hartenberg parameters, a backup's robots: an arm or an error; what is written of an arm is read again.
pub fn robots(data: &[u8]) {
    for convention in [DhConvention::Standard, DhConvention::Modified] {
        SerialArm::from_dh(data, convention, "Fuzzed").iter().for_each(comes_back);
    }
    let Ok(text) = std::str::from_utf8(data) else { return };
    for arm in [
        SerialArm::from_urdf(text, None),
        SerialArm::from_urdf(text, Some("tool0")),
        SerialArm::from_toml(text),
    ] {
        arm.iter().for_each(comes_back);
    }
    drop(BackedUp::from_moc(text, None));
    drop(BackedUp::moved_bases(text));
}

/// Written in both formats and read again: as many joints, each as it was but for the last digits.
fn comes_back(arm: &SerialArm) {
    let again = [
        SerialArm::from_toml(&arm.to_toml()).expect("a robot file that was written is read"),
        SerialArm::from_urdf(&arm.to_urdf(), None).expect("a description that was written is read"),
    ];
    for again in again {
        assert_eq!(again.joints.len(), arm.joints.len());
        for (joint, was) in again.joints.iter().zip(&arm.joints) {
            let [place, before] = [joint, was].map(|joint| joint.previous_from_joint.translation.vector);
            let size_m = before.norm().max(1.0);
            assert!((place - before).norm() < 1e-9 * size_m, "{before:?} comes back as {place:?}");
            assert_eq!(joint.kind, was.kind);
        }
    }
}
