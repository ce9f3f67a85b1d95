//! A robot calibrated: its frames' offsets from measured flange poses, in mm and degrees.

use super::arm::{Arm, JOINTS, check, radians, read_poses, shape};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::kinematics::{CalibrateError, CalibrationOptions, MeasuredPose, calibrate};
use robot_model::units::{deg_from_rad, m_from_mm, mm_from_m, rad_from_deg};

/// How well poses are measured and how large offsets are, mm and degrees; each one standard deviation of one coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CalibrationSizes {
    /// Noise of a measured position.
    pub sigma_mm: f64,
    /// Noise of a measured orientation; `None` where positions alone were measured.
    pub sigma_deg: Option<f64>,
    /// Usual shift of a joint's frame.
    pub prior_shift_mm: f64,
    /// Usual turn of a joint's frame.
    pub prior_turn_deg: f64,
}

impl Default for CalibrationSizes {
    /// A laser tracker on an industrial arm.
    fn default() -> Self {
        let CalibrationOptions { sigma_m, sigma_rad, prior_shift_m, prior_turn_rad } =
            CalibrationOptions::default();
        Self {
            sigma_mm: mm_from_m(sigma_m),
            sigma_deg: Some(deg_from_rad(sigma_rad)),
            prior_shift_mm: mm_from_m(prior_shift_m),
            prior_turn_deg: deg_from_rad(prior_turn_rad),
        }
    }
}

/// The offsets that explain measured poses best.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CalibratedArm {
    /// A row for each joint as in a deformation table: shifts in mm, turns in degrees.
    pub offsets: [[f64; 6]; JOINTS],
    /// Root of the mean square of the distance between measured and calibrated positions.
    pub rms_mm: f64,
    /// The same of the angle between orientations; `None` where none were measured.
    pub rms_deg: Option<f64>,
    /// Steps that the fit took.
    pub steps: usize,
}

impl Arm {
    /// The offsets of the joints' frames that explain flange poses (n x 16) measured at joints (n x 6, degrees) best.
    ///
    /// # Errors
    /// `array::*`, naming row and column; `option::usage` where a size is not positive; `calibrate::not-settled`.
    pub fn calibrate(
        &self,
        q_deg: &[f64],
        poses: &[f64],
        sizes: &CalibrationSizes,
    ) -> Result<CalibratedArm, Diagnostic> {
        check("q", q_deg, JOINTS)?;
        let poses = read_poses(poses)?;
        let rows = q_deg.len() / JOINTS;
        if rows != poses.len() {
            return Err(shape(format!("q has {rows} rows, pose {}", poses.len())));
        }
        let measured: Vec<MeasuredPose> = q_deg
            .chunks(JOINTS)
            .zip(poses)
            .map(|(q_deg, base_from_flange)| MeasuredPose { q_rad: radians(q_deg), base_from_flange })
            .collect();
        let options = CalibrationOptions {
            sigma_m: m_from_mm(sizes.sigma_mm),
            sigma_rad: sizes.sigma_deg.map_or(f64::INFINITY, rad_from_deg),
            prior_shift_m: m_from_mm(sizes.prior_shift_mm),
            prior_turn_rad: rad_from_deg(sizes.prior_turn_deg),
        };
        let found = calibrate(self.robot(), &measured, &options).map_err(|error| refused(&error))?;
        let row = |i: usize| {
            let all = found.offsets.0[i];
            std::array::from_fn(|j| if j < 3 { mm_from_m(all[j]) } else { deg_from_rad(all[j]) })
        };
        let offsets: [[f64; JOINTS]; JOINTS] = std::array::from_fn(row);
        let furthest_mm = FURTHEST_MM.max(FURTHEST_PRIORS * sizes.prior_shift_mm);
        let far = (1..).zip(&offsets).find(|(_, row)| row[..3].iter().any(|mm| mm.abs() > furthest_mm));
        if let Some((joint, [x, y, z, ..])) = far {
            let text = format!(
                "the frame of joint {joint} would have to stand ({x:.1}, {y:.1}, {z:.1}) mm from where the robot has it"
            );
            return Err(Diagnostic::error("calibrate::not-settled", text).help(POSES));
        }
        Ok(CalibratedArm {
            offsets,
            rms_mm: mm_from_m(found.rms_m),
            rms_deg: sizes.sigma_deg.map(|_| deg_from_rad(found.rms_rad)),
            steps: found.steps,
        })
    }
}

/// No frame stands so far, mm, and so many times as far as is expected, from where its robot has it.
const FURTHEST_MM: f64 = 20.0;
const FURTHEST_PRIORS: f64 = 20.0;

/// What measured poses are.
const POSES: &str = "poses are the flange's in the robot's base frame, shifts in mm; joints as the controller shows them, degrees";

fn refused(error: &CalibrateError) -> Diagnostic {
    match error {
        CalibrateError::Options => Diagnostic::error(
            "option::usage",
            "sigma_mm, sigma_deg, prior_shift_mm and prior_turn_deg are positive",
        )
        .help("without orientations sigma_deg is left out (None)"),
        CalibrateError::NoPoses => {
            shape("q and pose have no row: a calibration needs measured poses".to_owned())
        }
        CalibrateError::NotFinite(row) => {
            Diagnostic::error("array::not-finite", format!("row {row} holds a number that is none"))
        }
        CalibrateError::NotSettled => {
            Diagnostic::error("calibrate::not-settled", error.to_string()).help(POSES)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::arm::POSE;
    use super::*;
    use robot_model::robot::Robot;

    /// Joint 1's frame stands 0.3 mm too high: every flange pose is that much higher, by hand.
    #[test]
    fn a_base_that_stands_too_high_is_found() {
        let arm = Arm::new(Robot::built_in("irb140").unwrap());
        let q_deg: Vec<f64> = (0..240).map(|i| 60.0 * f64::from(i * i % 97 - 48) / 48.0).collect();
        let mut poses = arm.forward(&q_deg).unwrap();
        poses.chunks_mut(POSE).for_each(|pose| pose[11] += 0.3);
        let found = arm.calibrate(&q_deg, &poses, &CalibrationSizes::default()).unwrap();
        // A rise of joint 1's frame and of joint 2's cannot be told apart: both have a half.
        assert!((found.offsets[0][2] + found.offsets[1][2] - 0.3).abs() < 1e-3, "{:?}", found.offsets);
        assert!(found.rms_mm < 1e-3 && found.rms_deg.unwrap() < 1e-4, "{found:?}");
        let positions = CalibrationSizes { sigma_deg: None, ..CalibrationSizes::default() };
        let found = arm.calibrate(&q_deg, &poses, &positions).unwrap();
        assert!(found.rms_deg.is_none() && found.rms_mm < 1e-3, "{found:?}");
    }

    #[test]
    fn shifts_in_metres_are_no_poses_of_the_arm() {
        let arm = Arm::new(Robot::built_in("irb140").unwrap());
        let q_deg: Vec<f64> = (0..240).map(|i| 60.0 * f64::from(i * i % 97 - 48) / 48.0).collect();
        let mut poses = arm.forward(&q_deg).unwrap();
        for pose in poses.chunks_mut(POSE) {
            [3, 7, 11].into_iter().for_each(|k| pose[k] /= 1000.0);
        }
        let refused = arm.calibrate(&q_deg, &poses, &CalibrationSizes::default()).unwrap_err();
        assert_eq!(refused.code, "calibrate::not-settled", "{}", refused.message);
    }

    /// Where nothing is off nothing is left to settle, whichever pose it is.
    #[test]
    fn a_pose_that_is_exact_has_no_offsets() {
        let arm = Arm::new(Robot::built_in("irb140").unwrap());
        for j5_deg in [10.0, 29.9, 30.0, 45.0] {
            for rows in [1, 2, 5] {
                let q_deg = [0.0, 0.0, 0.0, 0.0, j5_deg, 0.0].repeat(rows);
                let poses = arm.forward(&q_deg).unwrap();
                let found = arm.calibrate(&q_deg, &poses, &CalibrationSizes::default()).unwrap();
                assert!(found.rms_mm < 1e-9, "{j5_deg} {rows} {found:?}");
            }
        }
    }

    #[test]
    fn what_cannot_be_calibrated_is_told() {
        let arm = Arm::new(Robot::built_in("irb140").unwrap());
        let (q_deg, sizes) = ([10.0; 12], CalibrationSizes::default());
        let poses = arm.forward(&q_deg).unwrap();
        let code = |q: &[f64], poses: &[f64], sizes: &CalibrationSizes| {
            arm.calibrate(q, poses, sizes).unwrap_err().code
        };
        assert_eq!(code(&q_deg, &poses[..POSE], &sizes), "array::shape");
        assert_eq!(code(&[], &[], &sizes), "array::shape");
        assert_eq!(code(&[f64::NAN; 12], &poses, &sizes), "array::not-finite");
        for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(code(&q_deg, &poses, &CalibrationSizes { sigma_mm: wrong, ..sizes }), "option::usage");
        }
    }
}
