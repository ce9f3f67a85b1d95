//! Calibration against poses made by the definition of the frames, written out with nalgebra, and against the theory of least squares.

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal};
use robot_model::kinematics::{
    CalibrateError, CalibrationOptions, Chain, FrameOffsets, MeasuredPose, calibrate,
};
use robot_model::robot::Robot;

/// Of the 36 offsets those that a flange's pose can tell: a shift along, and a turn about, the axis of joint 1 to 5 is one of the
/// next frame as well.
const TOLD: f64 = 36.0 - 10.0;

fn forward(robot: &Robot, offsets: &FrameOffsets, q_rad: &[f64; 6]) -> Isometry3<f64> {
    let mut base_from_here = Isometry3::identity();
    for (j, joint) in robot.joints.iter().enumerate() {
        let [dx, dy, dz, rx, ry, rz] = offsets.0[j];
        let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), rx)
            * UnitQuaternion::from_axis_angle(&Vector3::y_axis(), ry)
            * UnitQuaternion::from_axis_angle(&Vector3::z_axis(), rz);
        let origin_m = joint.previous_from_joint.translation.vector + Vector3::new(dx, dy, dz);
        base_from_here = base_from_here
            * Translation3::from(origin_m)
            * turn
            * joint.previous_from_joint.rotation
            * UnitQuaternion::from_axis_angle(&joint.axis, q_rad[j]);
    }
    base_from_here * robot.joint6_from_flange
}

fn random_joints(robot: &Robot, rng: &mut ChaCha8Rng) -> [f64; 6] {
    std::array::from_fn(|j| {
        let [low, high] = robot.joints[j].range_rad.unwrap_or([-3.0, 3.0]);
        rng.random_range(low..high)
    })
}

fn normal(sigma: f64, rng: &mut ChaCha8Rng) -> f64 {
    Normal::new(0.0, sigma).unwrap().sample(rng)
}

/// Shifts of half a millimetre and turns of a milliradian; none of the flange.
fn random_offsets(rng: &mut ChaCha8Rng) -> FrameOffsets {
    let mut offsets = FrameOffsets::default();
    for row in &mut offsets.0[..6] {
        *row = std::array::from_fn(|j| normal(if j < 3 { 5e-4 } else { 1e-3 }, rng));
    }
    offsets
}

/// Poses at random joints, with noise of metres and radians.
fn measured(
    robot: &Robot,
    truth: &FrameOffsets,
    poses: usize,
    noise: [f64; 2],
    rng: &mut ChaCha8Rng,
) -> Vec<MeasuredPose> {
    let one = |_| {
        let q_rad = random_joints(robot, rng);
        let there = forward(robot, truth, &q_rad);
        let [shift_m, turn_rad] = noise.map(|sigma| Vector3::from_fn(|_, _| normal(sigma, rng)));
        let base_from_flange = Isometry3::from_parts(
            Translation3::from(there.translation.vector + shift_m),
            UnitQuaternion::from_scaled_axis(turn_rad) * there.rotation,
        );
        MeasuredPose { q_rad, base_from_flange }
    };
    (0..poses).map(one).collect()
}

#[test]
fn offsets_of_exact_poses_predict_other_poses_exactly() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    for name in ["irb140", "irb1600-1.45", "irb6700"] {
        let robot = Robot::built_in(name).unwrap();
        let truth = random_offsets(&mut rng);
        let exact = measured(&robot, &truth, 60, [0.0; 2], &mut rng);
        let options = CalibrationOptions { sigma_m: 1e-9, sigma_rad: 1e-9, ..CalibrationOptions::default() };
        let found = calibrate(&robot, &exact, &options).unwrap();
        let (calibrated, nominal) = (Chain::with_offsets(&robot, &found.offsets), Chain::nominal(&robot));
        let mut worst_nominal_m = 0.0;
        for _ in 0..200 {
            let q_rad = random_joints(&robot, &mut rng);
            let there = forward(&robot, &truth, &q_rad);
            let (m, rad) = calibrated.distance(&q_rad, &there);
            assert!(m < 1e-9 && rad < 1e-9, "{name}: {m} m, {rad} rad");
            worst_nominal_m = f64::max(worst_nominal_m, nominal.distance(&q_rad, &there).0);
        }
        assert!(worst_nominal_m > 1e-3, "{worst_nominal_m}");
    }
}

/// Of n poses with six numbers each, in their standard deviations, least squares leave 6n less the numbers fitted on average; in
/// one set twice that is the variance.
#[test]
fn what_is_left_is_what_theory_says() {
    let robot = Robot::built_in("irb140").unwrap();
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    let options =
        CalibrationOptions { prior_shift_m: 0.3, prior_turn_rad: 0.3, ..CalibrationOptions::default() };
    let (poses, sets) = (20, 100);
    let costs = (0..sets).map(|_| {
        let noise = [options.sigma_m, options.sigma_rad];
        let noisy = measured(&robot, &FrameOffsets::default(), poses, noise, &mut rng);
        calibrate(&robot, &noisy, &options).unwrap().cost
    });
    let mean = costs.sum::<f64>() / f64::from(sets);
    let expected = 6.0 * poses as f64 - TOLD;
    let error = (2.0 * expected / f64::from(sets)).sqrt();
    assert!((mean - expected).abs() < 3.0 * error, "{mean}, not {expected} within {error}");
}

#[test]
fn positions_alone_predict_positions() {
    let robot = Robot::built_in("irb140").unwrap();
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let truth = random_offsets(&mut rng);
    let mut points = measured(&robot, &truth, 100, [2e-5, 0.0], &mut rng);
    // Orientations that nobody measured.
    points.iter_mut().for_each(|pose| pose.base_from_flange.rotation = UnitQuaternion::identity());
    let options = CalibrationOptions { sigma_rad: f64::INFINITY, ..CalibrationOptions::default() };
    let found = calibrate(&robot, &points, &options).unwrap();
    let noise_m = 2e-5 * 3.0_f64.sqrt();
    // Of 300 numbers the root of the mean square is known to a share of 1/sqrt(600).
    let most_m = noise_m * (1.0 + 3.0 / 600.0_f64.sqrt());
    assert!(found.rms_rad == 0.0 && found.rms_m < most_m, "{found:?}");
    let calibrated = Chain::with_offsets(&robot, &found.offsets);
    let squares = (0..200).map(|_| {
        let q_rad = random_joints(&robot, &mut rng);
        let there_m = forward(&robot, &truth, &q_rad).translation.vector;
        (calibrated.forward(&q_rad).translation.vector - there_m).norm_squared()
    });
    // 26 numbers fitted to 300: less than the noise is carried to other poses.
    let rms_m = (squares.sum::<f64>() / 200.0).sqrt();
    assert!(rms_m < noise_m, "{rms_m}");
}

#[test]
fn what_makes_no_calibration_is_said() {
    let robot = Robot::built_in("irb140").unwrap();
    let mut rng = ChaCha8Rng::seed_from_u64(4);
    let options = CalibrationOptions::default();
    let mut poses = measured(&robot, &FrameOffsets::default(), 5, [0.0; 2], &mut rng);
    assert_eq!(calibrate(&robot, &[], &options), Err(CalibrateError::NoPoses));
    for bad in [0.0, -1.0, f64::NAN] {
        let options = CalibrationOptions { sigma_m: bad, ..options };
        assert_eq!(calibrate(&robot, &poses, &options), Err(CalibrateError::Options), "{bad}");
    }
    poses[3].q_rad[2] = f64::NAN;
    assert_eq!(calibrate(&robot, &poses, &options), Err(CalibrateError::NotFinite(3)));
}
