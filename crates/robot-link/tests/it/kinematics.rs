//! The controller's kinematics as the client reads it; numbers of RoboDK's export of Cube45 and of ABB's data sheet.

use crate::bench::{double, is_left_clean, open};
use robot_link::{Configuration, Frame, Unit};
use rws_double::Personality;

/// `MoveL [400,300,250]`, `[0,0,-1,1]`, and the joints that the export's MoveAbsJ stands there with.
const AT: Frame = Frame {
    position_m: [0.4, 0.3, 0.25],
    orientation: [std::f64::consts::FRAC_1_SQRT_2, 0.0, std::f64::consts::FRAC_1_SQRT_2, 0.0],
};
const JOINTS_DEG: [f64; 6] = [41.845_157, 44.625_236, 25.881_2, 43.530_476, -75.605_869, -13.287_258];

#[test]
fn poses_and_joints_are_those_of_an_export() {
    for personality in Personality::ALL {
        let double = double(personality);
        let mut session = open(&double);
        let unit = Unit::new("ROB_1").unwrap();
        let q_rad = JOINTS_DEG.map(f64::to_radians);
        let pose = session.forward(&unit, &q_rad, &Frame::IDENTITY).unwrap();
        let apart = |a: &Frame, b: &Frame| {
            (0..3).map(|i| (a.position_m[i] - b.position_m[i]).abs()).fold(0.0, f64::max)
        };
        assert!(apart(&pose.frame, &AT) < 2e-8, "{pose:?}");
        assert_eq!(pose.configuration, Configuration([0, 0, -1, 1]));
        // 0.1 m further along the tool, which points down the base's x axis here.
        let tool = Frame { position_m: [0.0, 0.0, 0.1], ..Frame::IDENTITY };
        let further = session.forward(&unit, &q_rad, &tool).unwrap();
        assert!((further.frame.position_m[0] - 0.5).abs() < 1e-6, "{further:?}");
        let joints =
            session.inverse(&unit, &AT, Configuration([0, 0, -1, 1]), &q_rad, &Frame::IDENTITY).unwrap();
        for (q, expected) in joints.q_rad.iter().zip(q_rad) {
            assert!((q - expected).abs() < 2e-6, "{joints:?}");
        }
        let all = session.solutions(&unit, &AT, Configuration([0; 4]), &Frame::IDENTITY).unwrap();
        assert!(all.len() >= 2, "{all:?}");
        let far = Frame { position_m: [2.0, 0.0, 0.0], ..AT };
        let error =
            session.inverse(&unit, &far, Configuration([0; 4]), &q_rad, &Frame::IDENTITY).unwrap_err();
        assert_eq!(error.code(), "link::reach");
        assert_eq!(session.joints_now_deg(&unit).unwrap(), [10.0, 20.0, -10.0, 30.0, 40.0, 50.0]);
        let (position_mm, _) = session.flange_now_mm(&unit).unwrap();
        let now = session
            .forward(&unit, &[10.0, 20.0, -10.0, 30.0, 40.0, 50.0].map(f64::to_radians), &Frame::IDENTITY)
            .unwrap();
        for (mm, m) in position_mm.iter().zip(now.frame.position_m) {
            assert!((mm / 1000.0 - m).abs() < 1e-6);
        }
        session.end().unwrap();
        is_left_clean(&double);
    }
}

#[test]
fn a_controller_that_does_not_calculate_is_no_failure() {
    for personality in Personality::ALL {
        let double = double(personality);
        double.with(|c| c.offers_kinematics = false);
        let mut session = open(&double);
        let error = session.forward(&Unit::new("ROB_1").unwrap(), &[0.0; 6], &Frame::IDENTITY).unwrap_err();
        assert_eq!(error.code(), "link::not-offered");
    }
}
