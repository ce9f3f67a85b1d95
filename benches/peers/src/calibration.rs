//! The calibration of 36 offsets from 500 poses that Ceres is given as well.

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use robot_model::kinematics::{CalibrationOptions, Chain, FrameOffsets, MeasuredPose};
use robot_model::robot::Robot;
use std::fmt::Write as _;

const POSES: usize = 500;

/// A number in -1 to 1 that looks random: the same on every machine.
fn scattered(k: usize) -> f64 {
    let x = (k as f64 * 12.9898 + 4.1414).sin() * 43758.5453;
    2.0 * (x - x.floor()) - 1.0
}

/// Poses of an arm whose frames stand up to half a millimetre and a milliradian off, measured with noise of the options' size.
pub fn measured(robot: &Robot, options: &CalibrationOptions) -> Vec<MeasuredPose> {
    let mut truth = FrameOffsets::default();
    for (i, row) in truth.0[..6].iter_mut().enumerate() {
        *row = std::array::from_fn(|j| scattered(6 * i + j) * if j < 3 { 5e-4 } else { 1e-3 });
    }
    let arm = Chain::with_offsets(robot, &truth);
    let one = |n: usize| {
        let at = |k: usize| scattered(1000 + 12 * n + k);
        let q_rad = std::array::from_fn(|j| {
            let [low, high] = robot.joints[j].range_rad.unwrap_or([-3.0, 3.0]);
            low + (high - low) * 0.5 * (1.0 + at(j))
        });
        let there = arm.forward(&q_rad);
        let noise = |k: usize, sigma: f64| Vector3::from_fn(|i, _| 3.0_f64.sqrt() * sigma * at(k + i));
        let base_from_flange = Isometry3::from_parts(
            Translation3::from(there.translation.vector + noise(6, options.sigma_m)),
            UnitQuaternion::from_scaled_axis(noise(9, options.sigma_rad)) * there.rotation,
        );
        MeasuredPose { q_rad, base_from_flange }
    };
    (0..POSES).map(one).collect()
}

/// Four standard deviations and the number of poses; seven frames as rows, origin and axis; each pose as joints, rows and origin.
pub fn export(robot: &Robot, measured: &[MeasuredPose], options: &CalibrationOptions) -> String {
    let CalibrationOptions { sigma_m, sigma_rad, prior_shift_m, prior_turn_rad } = options;
    let mut text =
        format!("{sigma_m:?} {sigma_rad:?} {prior_shift_m:?} {prior_turn_rad:?} {}\n", measured.len());
    let mut write = |numbers: &mut dyn Iterator<Item = f64>| {
        numbers.for_each(|number| _ = write!(text, "{number:?} "));
        text.push('\n');
    };
    let pose = |pose: &Isometry3<f64>| {
        let rows = pose.rotation.to_rotation_matrix().matrix().transpose();
        let numbers: Vec<f64> = rows.iter().chain(pose.translation.vector.iter()).copied().collect();
        numbers
    };
    for joint in &robot.joints {
        write(&mut pose(&joint.previous_from_joint).into_iter().chain(joint.axis.iter().copied()));
    }
    write(&mut pose(&robot.joint6_from_flange).into_iter().chain([0.0; 3]));
    for one in measured {
        write(&mut one.q_rad.into_iter().chain(pose(&one.base_from_flange)));
    }
    text
}
