//! The parameters that each effect has in a model, in order, with their keys and units in the file.

use crate::deform::EffectKind;
use crate::robot::JointKind;
use crate::units::{deg_from_rad, m_from_mm, mm_from_m, ppm_from_ratio, rad_from_deg, ratio_from_ppm};

/// Unit of a parameter in the model file; inside it is SI.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Keys that end in `_mm`; metres inside.
    Millimetre,
    /// Keys that end in `_deg`; radians inside.
    Degree,
    /// Keys that end in `_ppm`; a ratio inside.
    PartsPerMillion,
    /// Written as it is: rad/(N.m), kg, or a ratio.
    Plain,
}

impl Unit {
    /// SI value of the file's number.
    #[must_use]
    pub fn si(self, file: f64) -> f64 {
        match self {
            Self::Millimetre => m_from_mm(file),
            Self::Degree => rad_from_deg(file),
            Self::PartsPerMillion => ratio_from_ppm(file),
            Self::Plain => file,
        }
    }

    /// The file's number for an SI value.
    #[must_use]
    pub fn file(self, si: f64) -> f64 {
        match self {
            Self::Millimetre => mm_from_m(si),
            Self::Degree => deg_from_rad(si),
            Self::PartsPerMillion => ppm_from_ratio(si),
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
const LINK_7: Parameter = ("link7_rad_per_n_m", Unit::Plain);
const COMPLIANCE: Parameter = ("rad_per_n_m", Unit::Plain);
const UNEVEN: Parameter = ("uneven_rad_per_n_m", Unit::Plain);
const END_FORCE: Parameter = ("force_rad_per_n_m", Unit::Plain);
const TILT: [Parameter; 2] = [("x_rad_per_n_m", Unit::Plain), ("y_rad_per_n_m", Unit::Plain)];
/// Shift of joint 1's frame along x and y under the moment that turns it: over the turn's compliance the height of joint 1's origin above
/// what the base turns about.
const TILT_SHIFT: [Parameter; 2] = [("shift_x_m_per_n_m", Unit::Plain), ("shift_y_m_per_n_m", Unit::Plain)];
const PER_LINK: [Parameter; 7] = joined([COMPLIANCE], LINKS, []);
/// Beside the linear spring one in proportion to the torque's square, and one to its root, both with its sign.
const PER_SPRING: [Parameter; 10] = {
    let mut all = [HARDENING; 10];
    let mut i = 0;
    while i < PER_LINK.len() {
        all[i] = PER_LINK[i];
        i += 1;
    }
    all[8] = SOFTENING;
    all[9] = LINK_7;
    all
};
const HARDENING: Parameter = ("hardening_rad_per_n_m_squared", Unit::Plain);
const SOFTENING: Parameter = ("softening_rad_per_root_n_m", Unit::Plain);
/// The same of a joint that slides: it gives way along its axis under the force along it.
const SLIDING_SPRING: [Parameter; 10] = [
    ("m_per_n", Unit::Plain),
    ("link1_m_per_n", Unit::Plain),
    ("link2_m_per_n", Unit::Plain),
    ("link3_m_per_n", Unit::Plain),
    ("link4_m_per_n", Unit::Plain),
    ("link5_m_per_n", Unit::Plain),
    ("link6_m_per_n", Unit::Plain),
    ("hardening_m_per_n_squared", Unit::Plain),
    ("softening_m_per_root_n", Unit::Plain),
    ("link7_m_per_n", Unit::Plain),
];
const PER_BEND: [Parameter; 10] = joined([COMPLIANCE, UNEVEN, END_FORCE], LINKS, [LINK_7]);
const PER_TILT: [Parameter; 12] =
    joined(TILT, LINKS, [LINK_7, TILT_SHIFT[0], TILT_SHIFT[1], TILT_ABOUT_AXIS_1]);
/// Turn about joint 1's axis under the moment about it.
const TILT_ABOUT_AXIS_1: Parameter = ("axis1_rad_per_n_m", Unit::Plain);
const PER_JOINT: [Parameter; 8] =
    joined([("kg", Unit::Plain)], JOINTS, [("joint7_rad_per_n_m", Unit::Plain)]);
const GEAR: [Parameter; 2] = [("sin_deg", Unit::Degree), ("cos_deg", Unit::Degree)];

/// `first`, then `each`, then `last`; N = A + 6 + B.
const fn joined<const A: usize, const B: usize, const N: usize>(
    first: [Parameter; A],
    each: [Parameter; 6],
    last: [Parameter; B],
) -> [Parameter; N] {
    assert!(N == A + each.len() + B);
    let mut all = [each[0]; N];
    let mut i = 0;
    while i < N {
        all[i] = if i < A {
            first[i]
        } else if i < A + each.len() {
            each[i - A]
        } else {
            last[i - A - each.len()]
        };
        i += 1;
    }
    all
}

impl EffectKind {
    /// Its parameters in a model, in the order of a term's values, for a joint that turns or slides; none are listed for a
    /// spectrum, which has any number of sines and cosines in turn.
    #[must_use]
    pub fn parameters(self, joint: JointKind) -> &'static [Parameter] {
        match self {
            Self::JointOffset if joint.slides() => &[("offset_mm", Unit::Millimetre)],
            Self::JointCompliance if joint.slides() => &SLIDING_SPRING,
            Self::Backlash if joint.slides() => &[("gap_mm", Unit::Millimetre)],
            Self::ThermalJointDrift if joint.slides() => {
                &[("drift_mm", Unit::Millimetre), ("constant_mm", Unit::Millimetre)]
            }
            Self::JointStep if joint.slides() => {
                &[("step_mm", Unit::Millimetre), ("constant_mm", Unit::Millimetre)]
            }
            Self::JointOffset => &[("offset_deg", Unit::Degree)],
            Self::LinkGeometry | Self::BaseDrift | Self::BaseStep => &FRAME,
            Self::JointCompliance => &PER_SPRING,
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
            Self::JointStep => &[("step_deg", Unit::Degree), ("constant_deg", Unit::Degree)],
            Self::InstrumentScale => &[("scale_ppm", Unit::PartsPerMillion)],
            Self::ToolDrift | Self::ToolStep => FRAME.split_at(3).0,
            Self::PayloadMass => &PER_JOINT,
            Self::JointRounding | Self::SwappedAxes => &[],
        }
    }
}
