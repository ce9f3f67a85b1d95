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

    /// What is known of each kind: the one place that a new one is described in.
    const fn facts(self) -> EffectFacts {
        match self {
            Self::JointOffset => EffectFacts::of("joint_offset", Place::Joint).turning_joints(),
            Self::LinkGeometry => EffectFacts::of("link_geometry", Place::Link),
            Self::JointCompliance => {
                EffectFacts::of("joint_compliance", Place::Joint).under_load().turning_joints()
            }
            Self::LinkBending => EffectFacts::of("link_bending", Place::Link).under_load().beyond_run_time(),
            Self::BaseTilt => EffectFacts::of("base_tilt", Place::Base).under_load().beyond_run_time(),
            Self::GearEccentricity => EffectFacts::of("gear_eccentricity", Place::Joint).turning_joints(),
            Self::GearSecondHarmonic => {
                EffectFacts::of("gear_second_harmonic", Place::Joint).turning_joints()
            }
            Self::GearMesh => EffectFacts::of("gear_mesh", Place::Joint).turning_joints(),
            Self::GearSpectrum => {
                EffectFacts::of("gear_spectrum", Place::Joint).turning_joints().beyond_run_time()
            }
            Self::JointGain => EffectFacts::of("joint_gain", Place::Joint).turning_joints(),
            Self::JointCoupling => EffectFacts::of("joint_coupling", Place::Joint).turning_joints(),
            Self::Backlash => EffectFacts::of("backlash", Place::Joint).turning_joints().beyond_run_time(),
            Self::ThermalLinkGrowth => EffectFacts::of("thermal_link_growth", Place::Link),
            Self::ThermalJointDrift => EffectFacts::of("thermal_joint_drift", Place::Joint).turning_joints(),
            Self::JointStep => EffectFacts::of("joint_step", Place::Joint).turning_joints(),
            Self::BaseDrift => EffectFacts::of("base_drift", Place::Base),
            Self::BaseStep => EffectFacts::of("base_step", Place::Base),
            Self::InstrumentScale => EffectFacts::of("instrument_scale", Place::Instrument),
            Self::ToolDrift => EffectFacts::of("tool_drift", Place::Target),
            Self::ToolStep => EffectFacts::of("tool_step", Place::Target),
            Self::PayloadMass => EffectFacts::of("payload_mass", Place::Payload)
                .under_load()
                .turning_joints()
                .beyond_run_time(),
            Self::JointRounding => EffectFacts::of("joint_rounding", Place::File),
            Self::SwappedAxes => EffectFacts::of("swapped_axes", Place::File),
        }
    }

    /// The effect's name in every file and message; [`Display`](fmt::Display) writes it, [`FromStr`] reads it.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.facts().name
    }

    /// Whether a model can hold it: faults of a data file are no property of a robot.
    #[must_use]
    pub fn is_model_term(self) -> bool {
        self.facts().place != Place::File
    }

    /// Whether a program that computes its corrections at run time can hold it.
    #[must_use]
    pub fn is_known_at_run_time(self) -> bool {
        self.facts().known_at_run_time
    }

    /// Whether it belongs to one joint (or the link that follows it).
    #[must_use]
    pub fn takes_joint(self) -> bool {
        matches!(self.facts().place, Place::Joint | Place::Link)
    }

    /// Whether its joint number names the link that follows that joint.
    #[must_use]
    pub fn is_of_link(self) -> bool {
        self.facts().place == Place::Link
    }

    /// Whether its joint may be left out, which means all joints.
    #[must_use]
    pub fn may_be_of_all(self) -> bool {
        self == Self::ThermalLinkGrowth
    }

    /// Whether gravity's loads drive it.
    #[must_use]
    pub fn needs_load(self) -> bool {
        self.facts().needs_load
    }

    /// Whether it turns joints only, and so leaves every frame where it is.
    #[must_use]
    pub fn only_turns(self) -> bool {
        self.facts().only_turns
    }

    /// Whether it moves the robot's base or what is on the flange, which measurements show as one with the instrument and its target.
    #[must_use]
    pub fn is_of_mounting(self) -> bool {
        matches!(self.facts().place, Place::Base | Place::Target) && !self.needs_load()
    }
}

/// What an effect is at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    Joint,
    Link,
    Base,
    Target,
    Payload,
    Instrument,
    /// The file of measurements, not the robot.
    File,
}

/// What is known of an effect, whatever file or arm it is in.
#[derive(Clone, Copy, Debug)]
struct EffectFacts {
    name: &'static str,
    place: Place,
    needs_load: bool,
    only_turns: bool,
    known_at_run_time: bool,
}

impl EffectFacts {
    /// An effect that no load drives, that moves frames, and that a program can compute.
    const fn of(name: &'static str, place: Place) -> Self {
        Self { name, place, needs_load: false, only_turns: false, known_at_run_time: true }
    }

    const fn under_load(self) -> Self {
        Self { needs_load: true, ..self }
    }

    const fn turning_joints(self) -> Self {
        Self { only_turns: true, ..self }
    }

    const fn beyond_run_time(self) -> Self {
        Self { known_at_run_time: false, ..self }
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
