//! What is to be measured, where the robot may go for it, and why there may be no plan.

use crate::admissible::{Restriction, Space};
use nalgebra::Vector3;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::robot::Axis;
use thiserror::Error;

/// What is to be measured.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanOptions {
    /// The measured point in the flange's frame, metres.
    pub tool_m: Vector3<f64>,
    /// Measurements of poses, repeats among them.
    pub n: usize,
    /// Of these, how many come back to a pose: they tell the noise.
    pub repeats: usize,
    /// Single joints moved in small steps, after the poses and beside `n`.
    pub sweeps: Sweeps,
    /// Payloads to measure with, one after the other, kg.
    pub payloads_kg: Vec<f64>,
    /// Nests on the base, looked at every ten poses.
    pub nests: usize,
    /// Expected noise of one coordinate, one sigma, metres.
    pub sigma_m: f64,
    /// Time that one measurement takes, minutes.
    pub each_min: f64,
    /// Where the robot may go.
    pub space: Space,
    /// The same seed gives the same plan.
    pub seed: u64,
}

/// Why there is no plan.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PlanError {
    /// Too few measurements for any answer.
    #[error("{n} measurements with {repeats} repeats are too few: 12 different poses at least, 60 say a lot")]
    TooFew {
        /// Measurements that were asked for.
        n: usize,
        /// How many of these repeat a pose.
        repeats: usize,
    },
    /// Hardly a pose is allowed.
    #[error("of {tried} poses tried only {found} are allowed ({restriction}): give the robot more room")]
    NoRoom {
        /// Poses that were tried.
        tried: usize,
        /// Poses that were allowed.
        found: usize,
        /// The restriction that refused most poses.
        restriction: Restriction,
    },
    /// Nowhere can a joint be moved so far.
    #[error(
        "joint {joint} cannot be swept so far in any pose that is allowed: fewer or smaller steps, or more room"
    )]
    NoSweep {
        /// The joint that has no room for it.
        joint: Axis,
    },
}

impl PlanError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::TooFew { .. } => "plan::too-few",
            Self::NoRoom { .. } => "plan::no-room",
            Self::NoSweep { .. } => "plan::no-sweep",
        }
    }
}

impl From<PlanError> for Diagnostic {
    fn from(error: PlanError) -> Self {
        Self::error(error.code(), error.to_string())
    }
}

/// Sweeps of joints, each from one pose.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sweeps {
    /// Joints that are moved alone, in this order.
    pub joints: Vec<Axis>,
    /// Number of poses of each sweep.
    pub n: usize,
    /// From pose to pose.
    pub step_rad: f64,
}
