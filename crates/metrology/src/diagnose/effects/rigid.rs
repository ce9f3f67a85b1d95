//! What signatures of several effects share: a joint that turns, a base or a target that moves rigidly.

use crate::diagnose::dataset::{Dataset, Observation, Twist, scaled};

/// How far from the measured point a payload's centre usually lies, metres: the file does not say.
pub const LEVER_M: f64 = 0.08;
/// How wrong a link's mass in the robot file may be, as a ratio.
pub const MASS_ERROR: f64 = 0.3;

/// No part of an arm gives more than this, rad/(N.m), however little its load is.
const SOFTEST: f64 = 1e-3;

/// Prior standard deviation of a compliance, rad/(N.m), of what usually turns by `angle_rad` under `largest_n_m`.
#[must_use]
pub fn sag_per_load(angle_rad: f64, largest_n_m: f64) -> f64 {
    (angle_rad / largest_n_m.max(1e-9)).min(SOFTEST)
}

/// The geometric Jacobian's column of `joint` times `angle`.
pub fn turn_joint(observation: &Observation, joint: Option<usize>, angle: f64, out: &mut Vec<Twist>) {
    out.push(scaled(observation.jacobian_column(of_arm(joint, observation)), angle));
}

/// Joint `joint`, from 0, where the arm has it, else its last.
#[must_use]
pub fn of_arm(joint: Option<usize>, observation: &Observation) -> usize {
    joint.unwrap_or(0).min(observation.joints() - 1)
}

/// What stands on one side of the arm and moves rigidly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RigidBody {
    /// The base: three shifts, three turns about its origin.
    Base,
    /// The target on the flange: three shifts in the flange's axes and, where the orientation is measured, three turns (without it
    /// a turn of the target is a shift).
    Tool,
}

impl RigidBody {
    /// Its motion at `observation` per unit of each parameter, times `factor`, pushed onto `out`.
    pub fn signature(self, dataset: &Dataset, observation: &Observation, factor: f64, out: &mut Vec<Twist>) {
        match self {
            Self::Base => out.extend((0..6).map(|k| scaled(observation.frame_offset(0, k), factor))),
            Self::Tool => {
                for k in 0..3 {
                    let axis = observation.flange.column(k);
                    out.push(scaled([axis[0], axis[1], axis[2], 0.0, 0.0, 0.0], factor));
                }
                if dataset.rows_per_observation == 6 {
                    for k in 0..3 {
                        // About the measured point itself: its shift stands above.
                        let axis = observation.flange.column(k);
                        out.push(scaled([0.0, 0.0, 0.0, axis[0], axis[1], axis[2]], factor));
                    }
                }
            }
        }
    }
}
