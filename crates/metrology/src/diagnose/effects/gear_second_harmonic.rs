//! A gear or bearing is oval, a strain-wave gear's error: twice per turn of the joint.

use super::effect::{Candidate, Effect, EffectVariant};
use super::rigid::turn_joint;
use crate::diagnose::dataset::{Dataset, Observation, Twist};
use robot_model::deform::EffectKind;

/// J_j times a sine and a cosine of 2 q_j.
pub struct GearSecondHarmonic;

impl Effect for GearSecondHarmonic {
    fn kind(&self) -> EffectKind {
        EffectKind::GearSecondHarmonic
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
                    EffectKind::GearSecondHarmonic,
                    EffectVariant { n: Some(2), ..EffectVariant::of_joint(j) },
                    vec![1e-4, 1e-4],
                )
            })
            .collect()
    }
    fn angles(&self, variant: &EffectVariant, observation: &Observation) -> Option<[f64; 2]> {
        let q_rad = observation.q_rad[variant.joint.unwrap_or(0).min(5)];
        Some((f64::from(variant.n.unwrap_or(2)) * q_rad).sin_cos().into())
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
