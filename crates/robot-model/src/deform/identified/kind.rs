//! The effects that a model can hold: their parameters, in order, with name and unit in the file.

use crate::units::{deg_from_rad, m_from_mm, mm_from_m, rad_from_deg};

/// Which effect.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// A joint's zero.
    JointOffset,
    /// The frame that follows a link.
    LinkGeometry,
    /// A joint gives under gravity's torque.
    JointCompliance,
    /// A link bends under gravity's moment.
    LinkBending,
    /// The base gives under the arm's moment.
    BaseTilt,
    /// Gear, once per turn.
    GearEccentricity,
    /// Gear, twice per turn.
    GearSecondHarmonic,
    /// Gear, n times per turn.
    GearMesh,
    /// Gear, 1, 2, 3 ... times per turn at once.
    GearSpectrum,
    /// A joint turns too far in proportion.
    JointGain,
    /// A joint turns another.
    JointCoupling,
    /// Play.
    Backlash,
    /// Links grow with warmth.
    ThermalLinkGrowth,
    /// A joint's zero drifts with warmth.
    ThermalJointDrift,
    /// The base drifts.
    BaseDrift,
    /// The base moved once.
    BaseStep,
    /// The instrument reads long.
    InstrumentScale,
    /// The target creeps on the flange.
    ToolDrift,
    /// The target moved once.
    ToolStep,
    /// The payload weighs more than declared.
    PayloadMass,
}

/// Unit of a parameter: what one unit of the file is in SI.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// `_mm`.
    Millimetre,
    /// `_deg`.
    Degree,
    /// `_ppm`.
    PartsPerMillion,
    /// Written as it is.
    Plain,
}

impl Unit {
    /// SI from the file's number.
    #[must_use]
    pub fn si(self, file: f64) -> f64 {
        match self {
            Self::Millimetre => m_from_mm(file),
            Self::Degree => rad_from_deg(file),
            Self::PartsPerMillion => file * 1e-6,
            Self::Plain => file,
        }
    }

    /// The file's number from SI.
    #[must_use]
    pub fn file(self, si: f64) -> f64 {
        match self {
            Self::Millimetre => mm_from_m(si),
            Self::Degree => deg_from_rad(si),
            Self::PartsPerMillion => si * 1e6,
            Self::Plain => si,
        }
    }
}

/// A parameter: its key in the file and its unit.
pub type Parameter = (&'static str, Unit);

const FRAME: [Parameter; 6] = [
    ("dx_mm", Unit::Millimetre),
    ("dy_mm", Unit::Millimetre),
    ("dz_mm", Unit::Millimetre),
    ("rx_deg", Unit::Degree),
    ("ry_deg", Unit::Degree),
    ("rz_deg", Unit::Degree),
];
const LINKS: [Parameter; 6] = [
    ("link1_rad_per_n_m", Unit::Plain),
    ("link2_rad_per_n_m", Unit::Plain),
    ("link3_rad_per_n_m", Unit::Plain),
    ("link4_rad_per_n_m", Unit::Plain),
    ("link5_rad_per_n_m", Unit::Plain),
    ("link6_rad_per_n_m", Unit::Plain),
];
const JOINTS: [Parameter; 6] = [
    ("joint1_rad_per_n_m", Unit::Plain),
    ("joint2_rad_per_n_m", Unit::Plain),
    ("joint3_rad_per_n_m", Unit::Plain),
    ("joint4_rad_per_n_m", Unit::Plain),
    ("joint5_rad_per_n_m", Unit::Plain),
    ("joint6_rad_per_n_m", Unit::Plain),
];
const COMPLIANCE: Parameter = ("rad_per_n_m", Unit::Plain);
const UNEVEN: Parameter = ("uneven_rad_per_n_m", Unit::Plain);
const TILT: [Parameter; 2] = [("x_rad_per_n_m", Unit::Plain), ("y_rad_per_n_m", Unit::Plain)];
const PER_LINK: [Parameter; 7] = joined([COMPLIANCE], LINKS);
const PER_BEND: [Parameter; 8] = joined([COMPLIANCE, UNEVEN], LINKS);
const PER_TILT: [Parameter; 8] = joined(TILT, LINKS);
const PER_JOINT: [Parameter; 7] = joined([("kg", Unit::Plain)], JOINTS);
const GEAR: [Parameter; 2] = [("sin_deg", Unit::Degree), ("cos_deg", Unit::Degree)];

/// `first`, then `each`; N = A + 6.
const fn joined<const A: usize, const N: usize>(
    first: [Parameter; A],
    each: [Parameter; 6],
) -> [Parameter; N] {
    assert!(N == A + each.len());
    let mut all = [each[0]; N];
    let mut i = 0;
    while i < N {
        all[i] = if i < A { first[i] } else { each[i - A] };
        i += 1;
    }
    all
}

/// All, in the order of the documentation.
pub(super) const ALL: [Kind; 20] = [
    Kind::JointOffset,
    Kind::LinkGeometry,
    Kind::JointCompliance,
    Kind::LinkBending,
    Kind::BaseTilt,
    Kind::GearEccentricity,
    Kind::GearSecondHarmonic,
    Kind::GearMesh,
    Kind::GearSpectrum,
    Kind::JointGain,
    Kind::JointCoupling,
    Kind::Backlash,
    Kind::ThermalLinkGrowth,
    Kind::ThermalJointDrift,
    Kind::BaseDrift,
    Kind::BaseStep,
    Kind::InstrumentScale,
    Kind::ToolDrift,
    Kind::ToolStep,
    Kind::PayloadMass,
];

impl Kind {
    /// Whether a program that asks at run time can hold it.
    #[must_use]
    pub fn is_known_at_run_time(self) -> bool {
        let beyond =
            [Self::Backlash, Self::LinkBending, Self::BaseTilt, Self::PayloadMass, Self::GearSpectrum];
        !beyond.contains(&self)
    }

    /// The effect's name in every file.
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
            Self::BaseDrift => "base_drift",
            Self::BaseStep => "base_step",
            Self::InstrumentScale => "instrument_scale",
            Self::ToolDrift => "tool_drift",
            Self::ToolStep => "tool_step",
            Self::PayloadMass => "payload_mass",
        }
    }

    /// The effect of that name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// Its parameters, in the order of a term's values. A spectrum has as many as it likes, a sine and a cosine in turn.
    #[must_use]
    pub fn parameters(self) -> &'static [Parameter] {
        match self {
            Self::JointOffset => &[("offset_deg", Unit::Degree)],
            Self::LinkGeometry | Self::BaseDrift | Self::BaseStep => &FRAME,
            Self::JointCompliance => &PER_LINK,
            Self::LinkBending => &PER_BEND,
            Self::BaseTilt => &PER_TILT,
            Self::GearEccentricity | Self::GearSecondHarmonic | Self::GearMesh => &GEAR,
            Self::JointGain | Self::JointCoupling => &[("gain", Unit::Plain)],
            Self::Backlash => &[("gap_deg", Unit::Degree)],
            Self::ThermalLinkGrowth => {
                &[("growth_ppm", Unit::PartsPerMillion), ("constant_ppm", Unit::PartsPerMillion)]
            }
            Self::GearSpectrum => &[],
            Self::ThermalJointDrift => &[("drift_deg", Unit::Degree), ("constant_deg", Unit::Degree)],
            Self::InstrumentScale => &[("scale_ppm", Unit::PartsPerMillion)],
            Self::ToolDrift | Self::ToolStep => FRAME.split_at(3).0,
            Self::PayloadMass => &PER_JOINT,
        }
    }

    /// Whether it names a joint (or link), and whether it must.
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
        )
    }

    /// Whether its joint may be left out: then it is of all.
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
                | Self::PayloadMass
        )
    }
}
