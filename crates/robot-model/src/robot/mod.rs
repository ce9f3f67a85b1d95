//! The constructive model of a serial arm: every joint's frame at its real place, axes, ranges, masses.
//!
//! Knows nothing of RAPID. Arms come from TOML (see [`SerialArm::from_toml`]) or URDF ([`SerialArm::from_urdf`]); ABB's of
//! six independent axes are built in. A [`Robot`] has six joints that turn, a [`SerialArm`] four to seven that turn or slide.

mod axis;
mod backup;
mod built_in;
pub(crate) mod dh;
mod digest;
mod error;
mod file;
mod joints;
mod kind;
mod range;
mod refused;
mod serial_arm;
mod size;
mod source;
mod urdf;
mod write;

pub use axis::Axis;
pub use backup::{BackedUp, BaseFrame};
pub use dh::DhConvention;
pub use digest::RobotDigest;
pub use error::RobotError;
pub use joints::{FEWEST_JOINTS, Joints, MOST_JOINTS};
pub use kind::{same_type, type_in};
pub use range::OutOfRange;
pub use serial_arm::{ArmGeometry, JointKind, SerialArm};
pub use source::RobotSource;

use nalgebra::{Isometry3, Unit, Vector3};

/// One joint of the constructive model.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// This joint's frame in the previous one, at the zero pose: `previous_from_joint`. Metres.
    pub previous_from_joint: Isometry3<f64>,
    /// Axis in the joint's own frame.
    pub axis: Unit<Vector3<f64>>,
    /// Whether it turns or shifts.
    pub kind: JointKind,
    /// Range, radians, of a joint that slides metres; `None` where the robot file gives none.
    pub range_rad: Option<[f64; 2]>,
}

/// A moving link, for gravity effects: link i follows joint i.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Link {
    /// Mass that moves with the joint, kg.
    pub mass_kg: f64,
    /// Centre of mass in the joint's frame at the zero pose, metres.
    pub com_m: [f64; 3],
}

/// A six-axis arm: six joints that turn.
#[derive(Clone, Debug, PartialEq)]
pub struct Robot {
    /// Name shown in messages and headers.
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
