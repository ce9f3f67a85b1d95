//! What can disturb the virtual robot: the effects of the library, and some that no library has.
//!
//! Knows names, units and usual sizes; what an effect does to the arm stands in `disturb`.

use super::harmonics::Harmonics;
use super::row_fault::RowFault;
use super::smooth::{MovedPart, SmoothFunction};
use nalgebra::{Point3, Vector3};
use robot_model::robot::Joints;
use serde::{Deserialize, Serialize};

/// Where the robot is and how it came there.
#[derive(Clone, Copy, Debug)]
pub struct ArmState {
    /// Joint angles as commanded, joint 1 first, radians.
    pub q_rad: Joints,
    /// Since cold start, minutes.
    pub t_min: f64,
    /// Since the cold start of the first row, minutes: what was moved once stays so on another day.
    pub clock_min: f64,
    /// Sign of each joint's last motion.
    pub direction: Joints<i8>,
    /// What hangs on the flange, kg.
    pub payload_kg: f64,
    /// Its centre in the flange frame, metres.
    pub payload_at_m: Point3<f64>,
    /// How much warmer each joint is than at cold start, K.
    pub warmer_k: Joints,
    /// Torque of gravity about each joint, N·m.
    pub torque_n_m: Joints,
    /// Where the nominal arm's measured point stands in the base frame, metres.
    pub point_m: Vector3<f64>,
}

/// One effect; joints count from 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "effect", rename_all = "snake_case")]
#[allow(
    missing_docs,
    reason = "the variants are the effects of the measurement format, their fields its columns"
)]
pub enum Effect {
    JointOffset {
        joint: usize,
    },
    LinkGeometry {
        joint: usize,
        direction: [f64; 6],
    },
    JointCompliance {
        joint: usize,
    },
    LinkBending {
        joint: usize,
    },
    BaseTilt,
    GearEccentricity {
        joint: usize,
        phase_rad: f64,
        #[serde(default, skip_serializing_if = "Harmonics::is_none")]
        harmonics: Harmonics,
    },
    GearSecondHarmonic {
        joint: usize,
        phase_rad: f64,
        #[serde(default, skip_serializing_if = "Harmonics::is_none")]
        harmonics: Harmonics,
    },
    GearMesh {
        joint: usize,
        n: u32,
        phase_rad: f64,
        #[serde(default, skip_serializing_if = "Harmonics::is_none")]
        harmonics: Harmonics,
    },
    JointGain {
        joint: usize,
    },
    JointCoupling {
        joint: usize,
        joint_b: usize,
    },
    Backlash {
        joint: usize,
        holding_n_m: f64,
    },
    ThermalLinkGrowth {
        joint: usize,
    },
    ThermalJointDrift {
        joint: usize,
    },
    BaseDrift {
        direction: [f64; 6],
    },
    BaseStep {
        t0_min: f64,
        direction: [f64; 6],
    },
    InstrumentScale,
    ToolDrift {
        direction: [f64; 6],
    },
    ToolStep {
        t0_min: f64,
        direction: [f64; 6],
    },
    JointStep {
        joint: usize,
        t0_min: f64,
    },
    PayloadMass,
    JointRounding,
    SwappedAxes,
    /// A fault of the file in some of its rows or one of its columns, from this share of the rows on.
    RowFault {
        fault: RowFault,
        from: f64,
    },
    /// Outside the library: a joint that jumps by steps along its travel.
    SquareWave {
        joint: usize,
        n: u32,
        phase_rad: f64,
    },
    /// Outside: a hose that pulls the wrist sideways by axes 4 and 6 together.
    CablePull {
        direction: [f64; 3],
    },
    /// Outside: one region of the workspace in which everything is shifted.
    LocalBump {
        center_m: [f64; 3],
        radius_m: f64,
        direction: [f64; 3],
    },
    /// Outside: a random smooth function of joint angles, position or time.
    SmoothFunction(SmoothFunction),
    /// Outside: a joint that is off by a product of two others' angles.
    CrossTerm {
        joint: usize,
        a: usize,
        b: usize,
    },
}

/// An effect with its size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SizedEffect {
    /// What is at work.
    pub effect: Effect,
    /// How large it is, in the effect's own SI unit.
    pub amplitude: f64,
}

/// A column that an effect cannot be seen without.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Channel {
    /// Minutes since cold start: `t_min`.
    Time,
    /// Directions of approach: `dir1` to `dir6`.
    Direction,
    /// Payload as declared: `payload_kg`.
    Payload,
}

impl Effect {
    /// Its name in the measurement format; `None` for effects outside the library.
    #[must_use]
    pub fn name(&self) -> Option<&'static str> {
        let is_outside = matches!(
            self,
            Self::RowFault { .. }
                | Self::SquareWave { .. }
                | Self::CablePull { .. }
                | Self::LocalBump { .. }
                | Self::SmoothFunction(_)
                | Self::CrossTerm { .. }
        );
        (!is_outside).then(|| self.spec_name())
    }

    /// The name under which a user asks for it, those outside the library too.
    #[must_use]
    pub const fn spec_name(&self) -> &'static str {
        match self {
            Self::JointOffset { .. } => "joint_offset",
            Self::LinkGeometry { .. } => "link_geometry",
            Self::JointCompliance { .. } => "joint_compliance",
            Self::LinkBending { .. } => "link_bending",
            Self::BaseTilt => "base_tilt",
            Self::GearEccentricity { .. } => "gear_eccentricity",
            Self::GearSecondHarmonic { .. } => "gear_second_harmonic",
            Self::GearMesh { .. } => "gear_mesh",
            Self::JointGain { .. } => "joint_gain",
            Self::JointCoupling { .. } => "joint_coupling",
            Self::Backlash { .. } => "backlash",
            Self::ThermalLinkGrowth { .. } => "thermal_link_growth",
            Self::ThermalJointDrift { .. } => "thermal_joint_drift",
            Self::BaseDrift { .. } => "base_drift",
            Self::BaseStep { .. } => "base_step",
            Self::InstrumentScale => "instrument_scale",
            Self::ToolDrift { .. } => "tool_drift",
            Self::ToolStep { .. } => "tool_step",
            Self::JointStep { .. } => "joint_step",
            Self::PayloadMass => "payload_mass",
            Self::JointRounding => "joint_rounding",
            Self::SwappedAxes => "swapped_axes",
            Self::RowFault { .. } => "row_fault",
            Self::SquareWave { .. } => "square_wave",
            Self::CablePull { .. } => "cable_pull",
            Self::LocalBump { .. } => "local_bump",
            Self::SmoothFunction(_) => "smooth_function",
            Self::CrossTerm { .. } => "cross_term",
        }
    }

    /// The joint it sits in, from 1.
    #[must_use]
    pub fn joint(&self) -> Option<usize> {
        match *self {
            Self::JointOffset { joint }
            | Self::LinkGeometry { joint, .. }
            | Self::JointCompliance { joint }
            | Self::LinkBending { joint }
            | Self::GearEccentricity { joint, .. }
            | Self::GearSecondHarmonic { joint, .. }
            | Self::GearMesh { joint, .. }
            | Self::JointGain { joint }
            | Self::JointCoupling { joint, .. }
            | Self::Backlash { joint, .. }
            | Self::ThermalLinkGrowth { joint }
            | Self::ThermalJointDrift { joint }
            | Self::JointStep { joint, .. }
            | Self::SquareWave { joint, .. }
            | Self::CrossTerm { joint, .. }
            | Self::SmoothFunction(SmoothFunction { moves: MovedPart::Joint(joint), .. }) => Some(joint),
            _ => None,
        }
    }

    /// The column without which it cannot be told from scatter.
    #[must_use]
    pub fn channel(&self) -> Option<Channel> {
        match self {
            Self::Backlash { .. } => Some(Channel::Direction),
            Self::ThermalLinkGrowth { .. }
            | Self::ThermalJointDrift { .. }
            | Self::BaseDrift { .. }
            | Self::BaseStep { .. }
            | Self::ToolDrift { .. }
            | Self::ToolStep { .. }
            | Self::JointStep { .. } => Some(Channel::Time),
            _ => None,
        }
    }

    /// Usual sizes, lower and upper, in the effect's own unit (SI).
    #[must_use]
    pub fn usual(&self) -> [f64; 2] {
        match self {
            Self::JointOffset { .. } | Self::JointStep { .. } => [1e-4, 2e-3],
            Self::LinkGeometry { .. } => [5e-5, 5e-4],
            Self::JointCompliance { joint } if *joint > 3 => [20e-6, 200e-6],
            Self::JointCompliance { .. } => [2e-6, 20e-6],
            Self::LinkBending { .. } | Self::BaseTilt => [2e-7, 5e-6],
            Self::GearEccentricity { .. } | Self::GearSecondHarmonic { .. } | Self::GearMesh { .. } => {
                [2e-5, 3e-4]
            }
            Self::JointGain { .. } => [1e-5, 2e-4],
            Self::JointCoupling { .. } => [1e-5, 1e-3],
            Self::Backlash { joint, .. } if *joint > 3 => [5e-5, 5e-4],
            Self::Backlash { .. } => [2e-5, 2e-4],
            Self::ThermalLinkGrowth { .. } => [11e-6, 23e-6],
            Self::ThermalJointDrift { .. } => [2e-5, 3e-4],
            Self::BaseDrift { .. } | Self::ToolDrift { .. } => [5e-6, 5e-5],
            Self::BaseStep { .. } | Self::ToolStep { .. } => [1e-5, 5e-4],
            Self::InstrumentScale => [1e-5, 1e-4],
            Self::PayloadMass => [0.2, 2.0],
            Self::JointRounding | Self::SwappedAxes | Self::RowFault { .. } => [1.0, 1.0],
            Self::SquareWave { .. }
            | Self::CrossTerm { .. }
            | Self::CablePull { .. }
            | Self::LocalBump { .. }
            | Self::SmoothFunction(_) => [2e-5, 1e-3],
        }
    }

    /// The unit of its size in the measurement format.
    #[must_use]
    pub fn unit(&self) -> &'static str {
        match self {
            Self::JointCompliance { .. } | Self::LinkBending { .. } | Self::BaseTilt => "rad/(N.m)",
            Self::JointGain { .. } | Self::JointCoupling { .. } => "1",
            Self::ThermalLinkGrowth { .. } | Self::InstrumentScale => "ppm",
            Self::PayloadMass => "kg",
            Self::JointOffset { .. }
            | Self::GearEccentricity { .. }
            | Self::GearSecondHarmonic { .. }
            | Self::GearMesh { .. }
            | Self::Backlash { .. }
            | Self::ThermalJointDrift { .. }
            | Self::JointStep { .. }
            | Self::SquareWave { .. }
            | Self::CrossTerm { .. }
            | Self::SmoothFunction(SmoothFunction { moves: MovedPart::Joint(_), .. }) => "rad",
            _ => "mm",
        }
    }

    /// Whether an arm of so many joints has the joints that it names.
    #[must_use]
    pub fn fits(&self, joints: usize) -> bool {
        match *self {
            Self::JointOffset { joint }
            | Self::LinkGeometry { joint, .. }
            | Self::JointCompliance { joint }
            | Self::GearEccentricity { joint, .. }
            | Self::GearSecondHarmonic { joint, .. }
            | Self::GearMesh { joint, .. }
            | Self::JointGain { joint }
            | Self::Backlash { joint, .. }
            | Self::ThermalLinkGrowth { joint }
            | Self::ThermalJointDrift { joint }
            | Self::JointStep { joint, .. }
            | Self::SquareWave { joint, .. } => joint <= joints,
            Self::LinkBending { joint } => joint < joints,
            Self::JointCoupling { joint, joint_b } => joint.max(joint_b) <= joints,
            Self::CrossTerm { joint, a, b } => joint.max(a).max(b) <= joints,
            // Hoses of a wrist, and functions drawn for six joints.
            Self::CablePull { .. } | Self::SmoothFunction(_) => joints == 6,
            _ => true,
        }
    }
}
