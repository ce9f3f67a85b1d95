//! One term: what an effect does to the joints and frames of the arm.
//!
//! First-order signatures as in the effects' library of the diagnosis: a turn of joint j is added to its angle, a frame
//! that moves gets it as offsets.

use super::ThermalState;
use crate::deform::gravity::{BeamDeflection, Loads};
use crate::deform::{EffectKind, GrowthLaw};
use crate::kinematics::SerialOffsets;
use crate::robot::{ArmGeometry, Axis, Joints, MOST_JOINTS};
use nalgebra::{Isometry3, Vector3};

/// Growth in time or temperature, 0 to about 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Growth {
    /// There from the cold start on, at full size.
    #[default]
    Always,
    /// With warm-up time, by a growth law.
    Law(GrowthLaw),
    /// From 0 to 1 between two minutes, held outside.
    Linear {
        /// The minute up to which it is 0.
        from_min: f64,
        /// The minute from which on it is 1.
        to_min: f64,
    },
    /// 0 before, 1 from then on.
    Step {
        /// Minute of the step since cold start.
        t0_min: f64,
    },
    /// A joint's temperature from `from_c` (0) to `to_c` (1), not held.
    Temperature {
        /// Temperature of each joint at which it is 0, degrees Celsius.
        from_c: Joints,
        /// Temperature of each joint at which it is 1, degrees Celsius.
        to_c: Joints,
    },
}

impl From<GrowthLaw> for Growth {
    fn from(law: GrowthLaw) -> Self {
        match law {
            GrowthLaw::None => Self::Always,
            law => Self::Law(law),
        }
    }
}

impl Growth {
    /// How far it has grown for joint `joint`, or on average over all.
    #[must_use]
    pub fn at(&self, when: &ThermalState, joint: Option<Axis>) -> f64 {
        let t_min = when.t_min;
        match *self {
            Self::Always => 1.0,
            Self::Law(law) => law.at(t_min),
            Self::Linear { from_min, to_min } => {
                ((t_min.min(to_min).max(from_min) - from_min) / (to_min - from_min)).clamp(0.0, 1.0)
            }
            Self::Step { t0_min } => f64::from(u8::from(t_min >= t0_min)),
            Self::Temperature { from_c, to_c } => {
                let Some(here) = when.joint_temperature_c else { return 0.0 };
                let joints = to_c.len().min(from_c.len()).min(here.len());
                let one = |j: usize| {
                    let rise_k = to_c[j] - from_c[j];
                    if rise_k.abs() > 1e-6 { (here[j] - from_c[j]) / rise_k } else { 0.0 }
                };
                let Some(last) = joints.checked_sub(1) else { return 0.0 };
                joint.map_or_else(
                    || (0..joints).map(one).sum::<f64>() / joints as f64,
                    |axis| one(axis.index().min(last)),
                )
            }
        }
    }
}

/// Where a payload that is heavier than declared hangs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PayloadScaling {
    /// Wherever a payload is declared.
    #[default]
    WhereLoaded,
    /// Always: a tool's own mass.
    Always,
    /// In proportion: the values are per kilogram declared.
    PerKilogram,
}

impl PayloadScaling {
    /// The factor on the values where `payload_kg` is declared.
    #[must_use]
    pub fn at(self, payload_kg: f64) -> f64 {
        match self {
            Self::WhereLoaded => f64::from(u8::from(payload_kg > 0.0)),
            Self::Always => 1.0,
            Self::PerKilogram => payload_kg,
        }
    }
}

/// A parameter's value and how well it is known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// The value in SI units.
    pub value: f64,
    /// One standard deviation, SI; `None` where it was not estimated.
    pub sigma: Option<f64>,
}

/// One effect with its values.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// Kind of the effect.
    pub kind: EffectKind,
    /// Joint or link; link i follows joint i.
    pub joint: Option<Axis>,
    /// The joint that is driven.
    pub joint_b: Option<Axis>,
    /// Periods per turn of a gear line.
    pub n: Option<u32>,
    /// Growth of the effect in time or temperature.
    pub growth: Growth,
    /// Backlash: above this torque gravity holds the teeth on one side, N.m; negative where gravity's side counts
    /// against the direction's (the joint lags behind its motor, and its load pulls it ahead).
    pub held_above_n_m: Option<f64>,
    /// Payload mass: where it hangs.
    pub payload_scaling: PayloadScaling,
    /// Named as a cause; otherwise it stands in the background of the causes.
    pub cause: bool,
    /// In the order of [`EffectKind::parameters`], SI; of a spectrum sine and cosine of 1, 2, 3 ... per turn. A gap below 0 is of a joint
    /// that stays behind its motion, as play leaves it.
    pub values: Vec<Estimate>,
}

impl Term {
    /// A cause that is there from the cold start on and has nothing besides its joint and values.
    #[must_use]
    pub fn plain(kind: EffectKind, joint: Option<Axis>, values: Vec<Estimate>) -> Self {
        Self {
            kind,
            joint,
            joint_b: None,
            n: None,
            growth: Growth::Always,
            held_above_n_m: None,
            payload_scaling: PayloadScaling::default(),
            cause: true,
            values,
        }
    }
}

/// The arm at one place, as terms see it.
pub(in crate::deform) struct PoseState<'a> {
    pub arm: ArmGeometry<'a>,
    pub when: &'a ThermalState,
    /// As many as the arm has joints, here and below.
    pub q_rad: &'a [f64],
    pub direction: &'a [i8],
    /// Loads, frames and flange of the nominal arm, where a term needs them.
    pub loads: Option<(&'a Loads, &'a [Isometry3<f64>])>,
    /// What hangs on the flange as declared.
    pub payload_kg: f64,
}

/// Where the values of a base that tilts have the shifts along x and y that go with its turns, behind the links' shares.
pub const TILT_SHIFT: [usize; 2] = [9, 10];
/// Where they have the turn about joint 1's axis under the moment about it. Springs that lie in an inclined mounting face give about axes in the face
/// alone: as those about x and y do, less what of that is about joint 1's axis.
pub const TILT_ABOUT_AXIS_1: usize = 11;

/// Which value of a joint's compliance is that of link `k` (from 0): those of links 1 to 6 follow the plain one, a seventh's stands
/// behind the spring's own two.
#[must_use]
pub fn compliance_of_link(k: usize) -> usize {
    if k < 6 { k + 1 } else { k + 3 }
}

/// What the terms do together.
#[derive(Clone, Debug, Default)]
pub(in crate::deform) struct ArmDelta {
    /// Added to the joints, radians; metres where they slide.
    pub turns_rad: [f64; MOST_JOINTS],
    /// d turn_i / d q_j of those that change fast with the joints.
    pub slopes: [[f64; MOST_JOINTS]; MOST_JOINTS],
    /// Added to the frames.
    pub offsets: SerialOffsets,
}

impl Term {
    /// The term's value `i`, SI; 0 where there is none.
    #[must_use]
    pub fn value(&self, i: usize) -> f64 {
        self.values.get(i).map_or(0.0, |v| v.value)
    }

    /// Length of the values, for comparison within one kind.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.values.iter().map(|v| v.value * v.value).sum::<f64>().sqrt()
    }

    /// Adds what the term does at `at`.
    pub(in crate::deform) fn add(&self, at: &PoseState<'_>, to: &mut ArmDelta) {
        let v = |i: usize| self.value(i);
        let joints = at.arm.joints.len();
        let joint = self.joint.map_or(0, Axis::index).min(joints - 1);
        let grown = self.growth.at(at.when, self.joint);
        match self.kind {
            EffectKind::JointOffset => to.turns_rad[joint] += v(0),
            EffectKind::LinkGeometry => self.add_frame(joint + 1, grown, to),
            EffectKind::BaseDrift | EffectKind::BaseStep => self.add_frame(0, grown, to),
            EffectKind::GearEccentricity | EffectKind::GearSecondHarmonic | EffectKind::GearMesh => {
                let n = f64::from(self.n.unwrap_or(1));
                let (sin, cos) = (n * at.q_rad[joint]).sin_cos();
                to.turns_rad[joint] += v(0) * sin + v(1) * cos;
                to.slopes[joint][joint] += n * (v(0) * cos - v(1) * sin);
            }
            EffectKind::GearSpectrum => {
                let (sin1, cos1) = at.q_rad[joint].sin_cos();
                let (mut sin, mut cos, mut n) = (sin1, cos1, 1.0);
                for pair in self.values.chunks_exact(2) {
                    let (a, b) = (pair[0].value, pair[1].value);
                    to.turns_rad[joint] += a * sin + b * cos;
                    to.slopes[joint][joint] += n * (a * cos - b * sin);
                    (sin, cos) = (sin * cos1 + cos * sin1, cos * cos1 - sin * sin1);
                    n += 1.0;
                }
            }
            EffectKind::JointGain => {
                to.turns_rad[joint] += v(0) * at.q_rad[joint];
                to.slopes[joint][joint] += v(0);
            }
            EffectKind::JointCoupling => {
                let driven = self.joint_b.map_or(0, Axis::index).min(joints - 1);
                to.turns_rad[driven] += v(0) * at.q_rad[joint];
                to.slopes[driven][joint] += v(0);
            }
            EffectKind::Backlash => {
                let mut side = at.direction.get(joint).map_or(0.0, |side| f64::from(*side));
                if let (Some(limit), Some((loads, _))) = (self.held_above_n_m, at.loads)
                    && loads.torque_n_m[joint].abs() > limit.abs()
                {
                    side = loads.torque_n_m[joint].signum() * limit.signum();
                }
                to.turns_rad[joint] += 0.5 * v(0) * side;
            }
            EffectKind::ThermalLinkGrowth => {
                for i in (0..joints).filter(|i| self.joint.is_none_or(|link| link.index() == *i)) {
                    let next = at.arm.after_link(i);
                    let strain = v(0) * self.growth.at(at.when, Some(Axis::at(i))) + v(1);
                    for (to, along) in to.offsets.0[i + 1].iter_mut().zip(next.translation.vector.iter()) {
                        *to += along * strain;
                    }
                }
            }
            EffectKind::ThermalJointDrift | EffectKind::JointStep => {
                to.turns_rad[joint] += v(0) * grown + v(1);
            }
            EffectKind::ToolDrift | EffectKind::ToolStep => {
                let shift = at.arm.last_from_flange.rotation * Vector3::new(v(0), v(1), v(2)) * grown;
                for (to, by) in to.offsets.0[joints].iter_mut().zip(shift.iter()) {
                    *to += by;
                }
            }
            EffectKind::InstrumentScale | EffectKind::JointRounding | EffectKind::SwappedAxes => {}
            EffectKind::JointCompliance
            | EffectKind::LinkBending
            | EffectKind::BaseTilt
            | EffectKind::PayloadMass => {
                if let Some((loads, frames)) = at.loads {
                    self.add_load((joint, joints), loads, frames, at.payload_kg, to);
                }
            }
        }
    }

    /// Moves one frame by the values times a factor.
    fn add_frame(&self, frame: usize, factor: f64, to: &mut ArmDelta) {
        if let Some(row) = to.offsets.0.get_mut(frame) {
            for (to, value) in row.iter_mut().zip(&self.values) {
                *to += value.value * factor;
            }
        }
    }

    fn add_load(
        &self,
        (joint, joints): (usize, usize),
        loads: &Loads,
        frames: &[Isometry3<f64>],
        payload_kg: f64,
        to: &mut ArmDelta,
    ) {
        let v = |i: usize| self.value(i);
        match self.kind {
            EffectKind::JointCompliance => {
                let links: f64 =
                    (0..joints).map(|k| v(compliance_of_link(k)) * loads.link_torque_n_m[joint][k]).sum();
                let torque = loads.torque_n_m[joint];
                let bent = v(7) * torque * torque.abs() + v(8) * torque.signum() * torque.abs().sqrt();
                to.turns_rad[joint] += v(0) * torque + links + bent;
            }
            EffectKind::PayloadMass => {
                let kg = self.payload_scaling.at(payload_kg);
                for (j, turn_rad) in to.turns_rad.iter_mut().enumerate().take(joints) {
                    *turn_rad += kg * v(j + 1) * loads.unit_torque_n_m[j];
                }
            }
            EffectKind::BaseTilt => self.add_tilt(joints, loads, to),
            EffectKind::LinkBending => {
                let link = joint.min(joints - 2);
                let ends = [frames[link].translation.vector, frames[link + 1].translation.vector];
                let (mut turn, mut deflection) = (Vector3::zeros(), Vector3::zeros());
                let mut add = |bend: &BeamDeflection, share: f64| {
                    turn += bend.slope_n_m * share;
                    deflection += bend.deflection_m_n_m * share;
                };
                for (k, bend) in loads.beyond[link + 1].bend(&ends[0], &ends[1]).iter().enumerate() {
                    add(bend, v(k));
                }
                for (k, part) in loads.link_beyond[link + 1].iter().enumerate().take(joints) {
                    let [even, ..] = part.bend(&ends[0], &ends[1]);
                    add(&even, v(k + 3));
                }
                let into = frames[link].rotation.inverse();
                let (shift, turn) = (into * deflection, into * turn);
                let row = &mut to.offsets.0[link + 1];
                for k in 0..3 {
                    row[k] += shift[k];
                    row[k + 3] += turn[k];
                }
            }
            _ => {}
        }
    }

    /// Turns and shifts the base, whose row of offsets is `base`, under the arm's moment.
    fn add_tilt(&self, joints: usize, loads: &Loads, to: &mut ArmDelta) {
        let v = |i: usize| self.value(i);
        to.turns_rad[0] += v(TILT_ABOUT_AXIS_1) * loads.torque_n_m[0];
        let base = &mut to.offsets.0[0];
        let moment = &loads.base_moment_n_m;
        let mut turn = Vector3::new(v(0), v(1), 0.0).component_mul(moment);
        for (k, of_link) in loads.link_base_moment_n_m.iter().enumerate().take(joints) {
            turn += of_link * v(k + 2);
        }
        base[3] += turn.x;
        base[4] += turn.y;
        // A turn about what lies below joint 1's origin carries that along: x under a turn about y, and -y about x.
        let [x, y] = TILT_SHIFT;
        base[0] += v(x) * moment.y;
        base[1] -= v(y) * moment.x;
    }
}
