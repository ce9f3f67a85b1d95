//! A gear or encoder disc runs out of centre: an error once per turn of the joint; or a gear or bearing is oval, a strain-wave gear's
//! error: twice per turn.

use super::effect::{Candidate, Effect, EffectVariant};
use super::rigid::turn_joint;
use crate::diagnose::dataset::{Dataset, Observation, Twist};
use robot_model::deform::EffectKind;

/// J_j times a sine and a cosine of n q_j.
pub struct GearHarmonic {
    kind: EffectKind,
    /// Periods per turn of the joint.
    n: u32,
}

/// An error of one period per turn of the joint.
pub const GEAR_ECCENTRICITY: GearHarmonic = GearHarmonic { kind: EffectKind::GearEccentricity, n: 1 };

/// An error of two periods per turn of the joint.
pub const GEAR_SECOND_HARMONIC: GearHarmonic = GearHarmonic { kind: EffectKind::GearSecondHarmonic, n: 2 };

impl Effect for GearHarmonic {
    fn kind(&self) -> EffectKind {
        self.kind
    }
    fn unit(&self) -> &'static str {
        "rad"
    }
    fn usual_size(&self) -> &'static str {
        "0.02 to 0.3 mrad"
    }
    fn source(&self) -> &'static str {
        "Judd and Knasinski 1990, A technique to calibrate industrial robots with experimental verification"
    }
    fn candidates(&self, _dataset: &Dataset) -> Vec<Candidate> {
        (0..6)
            .map(|j| {
                Candidate::new(
                    self.kind,
                    EffectVariant { n: Some(self.n), ..EffectVariant::of_joint(j) },
                    vec![1e-4, 1e-4],
                )
            })
            .collect()
    }
    fn angles(&self, variant: &EffectVariant, observation: &Observation) -> Option<[f64; 2]> {
        let q_rad = observation.q_rad[variant.joint.unwrap_or(0).min(5)];
        Some((f64::from(variant.n.unwrap_or(self.n)) * q_rad).sin_cos().into())
    }
    fn signature(
        &self,
        variant: &EffectVariant,
        _dataset: &Dataset,
        observation: &Observation,
        out: &mut Vec<Twist>,
    ) {
        for angle in self.angles(variant, observation).into_iter().flatten() {
            turn_joint(observation, variant.joint, angle, out);
        }
    }
}
