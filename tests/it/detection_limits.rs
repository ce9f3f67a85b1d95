//! From which size on an effect would have been seen, and which effects would have to be absurdly large.

use crate::recipe::rows_each_minute;
use measurements::Measurements;
use metrology::diagnose::{DiagnosisOptions, Findings, Verdict, diagnose};
use nalgebra::Vector3;
use robot_model::deform::EffectKind;
use robot_model::robot::{Axis, Robot, SerialArm};

const SIGMA_MM: f64 = 0.02;
const ROWS: usize = 100;

/// What is said of a sound arm whose point is so far off the axis of joint 6.
fn sound_arm(off_axis_m: f64) -> Findings {
    let tool_m = [off_axis_m, 0.0, 0.1];
    let csv = rows_each_minute(ROWS, tool_m, SIGMA_MM, 8, |_| [0.0; 6]);
    let options = DiagnosisOptions { tool_m: Some(Vector3::from(tool_m)), sigma_m: Some(1e-3 * SIGMA_MM) };
    let robot = Robot::built_in("irb140").unwrap();
    diagnose(&Measurements::from_csv(csv.as_bytes()).unwrap(), &SerialArm::from(&robot), &options)
}

/// A gear that errs by a radian moves a point that is 0.03 mm off its axis by 0.03 mm: a hundred rows of 0.02 mm do not show less than
/// 4 sigma / (d sqrt(N)), a quarter of a radian, which no gear errs by. Of a point 60 mm off the same rows show an eight-thousandth part.
#[test]
fn what_would_have_to_be_absurdly_large_cannot_be_tested() {
    let joint_6 = Axis::numbered(6).unwrap();
    let found = sound_arm(3e-5);
    assert_eq!(found.verdict, Verdict::NothingAboveNoise, "{}", found.reason);
    for effect in [EffectKind::GearEccentricity, EffectKind::JointGain] {
        let of_joint = |joint| found.detectable.iter().find(|d| d.effect == effect && d.joint == Some(joint));
        assert_eq!(of_joint(joint_6), None, "{effect}");
        let seen = of_joint(Axis::numbered(2).unwrap()).unwrap();
        assert!(seen.size < 1e-3, "{seen:?}");
        let hidden = found.untestable_detail.iter().find(|u| u.effect == effect).unwrap();
        assert_eq!(hidden.joints, [joint_6], "{hidden:?}");
        let from = hidden.reason.split("from ").nth(1).and_then(|rest| rest.split(' ').next()).unwrap();
        let floor = 4.0 * SIGMA_MM / (0.03 * (ROWS as f64).sqrt());
        // A gain counts by the angle turned, two radians and less.
        let least = if effect == EffectKind::JointGain { floor / 2.1 } else { floor };
        assert!(from.parse::<f64>().unwrap() > least, "{hidden:?}");
        // The others are shown.
        assert!(!found.untestable.contains(&effect), "{:?}", found.untestable);
    }
    let far_off = sound_arm(0.06);
    let seen = far_off
        .detectable
        .iter()
        .find(|d| d.effect == EffectKind::GearEccentricity && d.joint == Some(joint_6));
    assert!(seen.is_some_and(|seen| seen.size < 1e-3), "{seen:?}");
}
