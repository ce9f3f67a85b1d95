//! Teeth, rollers, waves of a gear: an error many times per turn of the joint.

use super::effect::{Candidate, Effect, EffectVariant};
use super::gear_harmonic::OVERTONE;
use super::rigid::{Motion, of_arm};
use crate::dataset::{DataPoint, Dataset};
use crate::size_unit::SizeUnit;
use robot_model::deform::EffectKind;
use robot_model::robot::Axis;
use std::f64::consts::TAU;
use std::ops::RangeInclusive;

/// J_j times a sine and a cosine of n q_j, n scanned; refined, of 2 n q_j too.
pub(super) struct GearMesh;

/// Periods per turn that are tried.
pub const PERIODS: RangeInclusive<u32> = 3..=320;

impl Effect for GearMesh {
    fn kind(&self) -> EffectKind {
        EffectKind::GearMesh
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::Radian
    }
    fn usual_size(&self) -> &'static str {
        "0.02 to 0.3 mrad, 3 to 320 times per turn"
    }
    fn source(&self) -> &'static str {
        "Tuttle and Seering 1996 on harmonic drives; UR10 tracker data of Fraunhofer IPA"
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        let mut all = Vec::new();
        for j in dataset.turning() {
            let values = dataset.of_arm().map(|s| s.q_rad[j]);
            let low = values.clone().fold(f64::INFINITY, f64::min);
            let high = values.fold(f64::NEG_INFINITY, f64::max);
            // Less than 0.6 periods over the joint's range is a bend, not a line of its own.
            let lowest = (0.6 * TAU / (high - low).max(1e-3)).ceil().max(f64::from(*PERIODS.start()));
            let lowest = if lowest > f64::from(*PERIODS.end()) { continue } else { lowest as u32 };
            for n in lowest..=*PERIODS.end() {
                // Low orders are commoner than high ones.
                all.push(Candidate { weight: 1.0 / f64::from(n), ..line(Axis::at(j), n) });
            }
        }
        all
    }
    fn motion(&self, variant: &EffectVariant) -> Option<Motion> {
        variant.joint.map(Motion::Joint)
    }
    fn factors(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<f64>) {
        let q_rad = at.observation.q_rad[of_arm(variant.joint, at.observation)];
        for overtone in 1..=if variant.refined { 2 } else { 1 } {
            let order = f64::from(overtone * variant.n.unwrap_or(*PERIODS.start()));
            out.extend(<[f64; 2]>::from((order * q_rad).sin_cos()));
        }
    }
}

/// The line of `n` periods per turn of `joint`.
pub fn line(joint: Axis, n: u32) -> Candidate {
    let variant = EffectVariant { n: Some(n), ..EffectVariant::of_joint(joint.index()) };
    Candidate::new(EffectKind::GearMesh, variant, vec![1e-4, 1e-4])
}

/// The line of `n` periods per turn of `joint` with its own double frequency, of about `OVERTONE` of its size.
pub fn line_with_overtone(joint: Axis, n: u32) -> Candidate {
    let variant = EffectVariant { n: Some(n), refined: true, ..EffectVariant::of_joint(joint.index()) };
    let sizes = vec![1e-4, 1e-4, OVERTONE * 1e-4, OVERTONE * 1e-4];
    Candidate { n_reported: 2, ..Candidate::new(EffectKind::GearMesh, variant, sizes) }
}
