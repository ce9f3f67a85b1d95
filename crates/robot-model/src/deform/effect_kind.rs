//! The effects by name: every cause of a gap between robot and model that the contract (measurements, models, diagnoses)
//! knows, as one enum with its name in every file.
//!
//! Which parameters an effect has in a model, and what it does, is not known here.

use serde::{Serialize, Serializer};
use std::fmt;
use std::str::FromStr;

/// An effect of the contract, by kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum EffectKind {
    /// A joint's zero is off by a constant angle.
    JointOffset,
    /// The frame that follows a link is shifted and turned.
    LinkGeometry,
    /// A joint's gear gives way under gravity's torque.
    JointCompliance,
    /// A link bends under gravity's moment.
    LinkBending,
    /// The base gives way under the arm's overturning moment.
    BaseTilt,
    /// Transmission error of a gear, once per turn of the joint.
    GearEccentricity,
    /// Transmission error of a gear, twice per turn of the joint.
    GearSecondHarmonic,
    /// Transmission error of a gear, n times per turn of the joint.
    GearMesh,
    /// Transmission error of a gear, 1, 2, 3 ... times per turn at once; in models only.
    GearSpectrum,
    /// A joint turns too far in proportion to its angle.
    JointGain,
    /// A joint's angle turns another joint in proportion.
    JointCoupling,
    /// Play in a joint's gear.
    Backlash,
    /// Links grow as they warm up.
    ThermalLinkGrowth,
    /// A joint's zero drifts as the joint warms up.
    ThermalJointDrift,
    /// A joint's zero jumped once.
    JointStep,
    /// The base drifts in the instrument's frame.
    BaseDrift,
    /// The base moved once in the instrument's frame.
    BaseStep,
    /// The instrument's lengths are scaled.
    InstrumentScale,
    /// The target creeps on the flange.
    ToolDrift,
    /// The target moved once on the flange.
    ToolStep,
    /// The payload weighs more than declared.
    PayloadMass,
    /// Joints in the file are rounded: a fault of the data, never a term of a model.
    JointRounding,
    /// Measured axes are swapped: a fault of the data, never a term of a model.
    SwappedAxes,
}

/// A name that no effect has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no effect named {0}")]
pub struct UnknownEffect(pub String);

impl EffectKind {
    /// Every kind, in the order of the documentation.
    pub const ALL: [Self; 23] = [
        Self::JointOffset,
        Self::LinkGeometry,
        Self::JointCompliance,
        Self::LinkBending,
        Self::BaseTilt,
        Self::GearEccentricity,
        Self::GearSecondHarmonic,
        Self::GearMesh,
        Self::GearSpectrum,
        Self::JointGain,
        Self::JointCoupling,
        Self::Backlash,
        Self::ThermalLinkGrowth,
        Self::ThermalJointDrift,
        Self::JointStep,
        Self::BaseDrift,
        Self::BaseStep,
        Self::InstrumentScale,
        Self::ToolDrift,
        Self::ToolStep,
        Self::PayloadMass,
        Self::JointRounding,
        Self::SwappedAxes,
    ];

    /// The effect's name in every file and message; [`Display`](fmt::Display) writes it, [`FromStr`] reads it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::JointOffset => "joint_offset",
            Self::LinkGeometry => "link_geometry",
            Self::JointCompliance => "joint_compliance",
            Self::LinkBending => "link_bending",
            Self::BaseTilt => "base_tilt",
            Self::GearEccentricity => "gear_eccentricity",
            Self::GearSecondHarmonic => "gear_second_harmonic",
            Self::GearMesh => "gear_mesh",
            Self::GearSpectrum => "gear_spectrum",
            Self::JointGain => "joint_gain",
            Self::JointCoupling => "joint_coupling",
            Self::Backlash => "backlash",
            Self::ThermalLinkGrowth => "thermal_link_growth",
            Self::ThermalJointDrift => "thermal_joint_drift",
            Self::JointStep => "joint_step",
            Self::BaseDrift => "base_drift",
            Self::BaseStep => "base_step",
            Self::InstrumentScale => "instrument_scale",
            Self::ToolDrift => "tool_drift",
            Self::ToolStep => "tool_step",
            Self::PayloadMass => "payload_mass",
            Self::JointRounding => "joint_rounding",
            Self::SwappedAxes => "swapped_axes",
        }
    }

    /// Whether a model can hold it: faults of a data file are no property of a robot.
    #[must_use]
    pub fn is_model_term(self) -> bool {
        !matches!(self, Self::JointRounding | Self::SwappedAxes)
    }

    /// Whether a program that computes its corrections at run time can hold it.
    #[must_use]
    pub fn is_known_at_run_time(self) -> bool {
        let beyond =
            [Self::Backlash, Self::LinkBending, Self::BaseTilt, Self::PayloadMass, Self::GearSpectrum];
        !beyond.contains(&self)
    }

    /// Whether it belongs to one joint (or the link that follows it).
    #[must_use]
    pub fn takes_joint(self) -> bool {
        !matches!(
            self,
            Self::BaseTilt
                | Self::BaseDrift
                | Self::BaseStep
                | Self::InstrumentScale
                | Self::ToolDrift
                | Self::ToolStep
                | Self::PayloadMass
                | Self::JointRounding
                | Self::SwappedAxes
        )
    }

    /// Whether its joint number names the link that follows that joint.
    #[must_use]
    pub fn is_of_link(self) -> bool {
        matches!(self, Self::LinkGeometry | Self::LinkBending | Self::ThermalLinkGrowth)
    }

    /// Whether its joint may be left out, which means all joints.
    #[must_use]
    pub fn may_be_of_all(self) -> bool {
        self == Self::ThermalLinkGrowth
    }

    /// Whether gravity's loads drive it.
    #[must_use]
    pub fn needs_load(self) -> bool {
        matches!(self, Self::JointCompliance | Self::LinkBending | Self::BaseTilt | Self::PayloadMass)
    }

    /// Whether it turns joints only, and so leaves every frame where it is.
    #[must_use]
    pub fn only_turns(self) -> bool {
        matches!(
            self,
            Self::JointOffset
                | Self::JointCompliance
                | Self::GearEccentricity
                | Self::GearSecondHarmonic
                | Self::GearMesh
                | Self::GearSpectrum
                | Self::JointGain
                | Self::JointCoupling
                | Self::Backlash
                | Self::ThermalJointDrift
                | Self::JointStep
                | Self::PayloadMass
        )
    }

    /// Whether it moves the robot's base or what is on the flange, which measurements show as one with the instrument and its target.
    #[must_use]
    pub fn is_of_mounting(self) -> bool {
        matches!(self, Self::BaseDrift | Self::BaseStep | Self::ToolDrift | Self::ToolStep)
    }
}

impl fmt::Display for EffectKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for EffectKind {
    type Err = UnknownEffect;

    fn from_str(name: &str) -> Result<Self, UnknownEffect> {
        Self::ALL.into_iter().find(|kind| kind.name() == name).ok_or_else(|| UnknownEffect(name.to_owned()))
    }
}

impl Serialize for EffectKind {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_is_read_from_the_name_it_writes_and_no_name_stands_for_two() {
        let names: std::collections::BTreeSet<String> =
            EffectKind::ALL.iter().map(ToString::to_string).collect();
        assert_eq!(names.len(), EffectKind::ALL.len());
        for kind in EffectKind::ALL {
            assert_eq!(kind.to_string().parse(), Ok(kind));
        }
        assert_eq!("gear".parse::<EffectKind>(), Err(UnknownEffect("gear".to_owned())));
    }
}
