//! A joint turns by a little more or less than it says: gear ratio, encoder scale.

use super::effect::{Candidate, Effect, EffectVariant};
use super::rigid::{Motion, of_arm};
use crate::dataset::{DataPoint, Dataset};
use crate::size_unit::SizeUnit;
use robot_model::deform::EffectKind;

/// The Jacobian's column J_j times q_j. With a constant of its own where the zero of the scale is not the model's: an encoder counts
/// from its mark, a joint is zeroed in some posture.
pub(super) struct JointGain;

/// Usual size of the gain.
const USUAL: f64 = 6e-5;
/// Where the scale's zero usually lies off the model's, rad and m.
const ZERO_OFF: [f64; 2] = [1.0, 0.3];

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
            .flat_map(|j| {
                let constant = USUAL * dataset.by_kind(j, ZERO_OFF[0], ZERO_OFF[1]);
                let plain = EffectVariant::of_joint(j);
                let variants =
                    Candidate::without_and_with_constant(EffectKind::JointGain, plain, [USUAL, constant]);
                variants.map(|one| Candidate { about_own_zero: one.variant.refined, ..one })
            })
            .collect()
    }
    fn motion(&self, variant: &EffectVariant) -> Option<Motion> {
        variant.joint.map(Motion::Joint)
    }
    fn factors(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<f64>) {
        out.push(at.observation.q_rad[of_arm(variant.joint, at.observation)]);
        out.extend(variant.refined.then_some(1.0));
    }
}
