//! A joint turns by a little more or less than it says: gear ratio, encoder scale.

use super::effect::{Candidate, Effect, EffectVariant};
use super::rigid::{Motion, of_arm};
use crate::diagnose::dataset::{DataPoint, Dataset};
use crate::diagnose::size_unit::SizeUnit;
use robot_model::deform::EffectKind;

/// The Jacobian's column J_j times q_j.
pub struct JointGain;

impl Effect for JointGain {
    fn kind(&self) -> EffectKind {
        EffectKind::JointGain
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::One
    }
    fn usual_size(&self) -> &'static str {
        "1e-5 to 2e-4"
    }
    fn source(&self) -> &'static str {
        "Whitney, Lozinski, Rourke 1986, Industrial robot forward calibration method and results"
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        (0..dataset.joints())
            .map(|j| Candidate::new(EffectKind::JointGain, EffectVariant::of_joint(j), vec![6e-5]))
            .collect()
    }
    fn motion(&self, variant: &EffectVariant) -> Option<Motion> {
        variant.joint.map(Motion::Joint)
    }
    fn factors(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<f64>) {
        out.push(at.observation.q_rad[of_arm(variant.joint, at.observation)]);
    }
}
