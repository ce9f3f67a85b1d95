//! The constructive model of a six-axis arm: every joint's frame at its real place, axes, ranges, masses.
//!
//! Knows nothing of RAPID. Robots come from TOML (see [`Robot::from_toml`]) or URDF ([`Robot::from_urdf`]); several are built in.

mod backup;
mod built_in;
mod error;
mod file;
mod kind;
mod range;
mod urdf;
mod write;

pub use backup::BackedUp;
pub use error::RobotError;
pub use kind::same_type;
pub use range::OutOfRange;

use nalgebra::{Isometry3, Unit, Vector3};

/// One joint of the constructive model.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// This joint's frame in the previous one, at the zero pose: `previous_from_joint`. Metres.
    pub previous_from_joint: Isometry3<f64>,
    /// Axis in the joint's own frame.
    pub axis: Unit<Vector3<f64>>,
    /// Range, radians; `None` where the robot file gives none.
    pub range_rad: Option<[f64; 2]>,
}

/// A moving link, for gravity effects: link i follows joint i.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Centre of mass in the joint's frame at the zero pose, metres.
    pub com_m: [f64; 3],
}

/// A six-axis arm.
#[derive(Clone, Debug, PartialEq)]
pub struct Robot {
    /// Its name.
    pub name: String,
    /// Where the numbers come from.
    pub source: String,
    /// The six joints from the base outward.
    pub joints: [Joint; 6],
    /// The flange (tool0) in the frame of joint 6. Metres.
    pub joint6_from_flange: Isometry3<f64>,
    /// Masses, where the robot file gives them; link i follows joint i.
    pub links: Option<[Link; 6]>,
}
