//! One joint drives another a little: coupled wrist gears with a wrong ratio.

use super::effect::{Candidate, Effect, EffectVariant};
use super::rigid::{Motion, of_arm};
use crate::dataset::{DataPoint, Dataset};
use crate::size_unit::SizeUnit;
use robot_model::deform::EffectKind;
use robot_model::robot::Axis;
use robot_model::units::m_from_mm;

/// The driven joint's Jacobian column J_b times the driving joint's angle q_a.
pub(super) struct JointCoupling;

impl Effect for JointCoupling {
    fn kind(&self) -> EffectKind {
        EffectKind::JointCoupling
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::One
    }
    fn usual_size(&self) -> &'static str {
        "1e-5 to 1e-3"
    }
    fn source(&self) -> &'static str {
        "Whitney, Lozinski, Rourke 1986"
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        let mut all = Vec::new();
        let joints = dataset.joints();
        for a in 0..joints {
            for b in (0..joints).filter(|&b| b != a) {
                let variant = EffectVariant { joint_b: Some(Axis::at(b)), ..EffectVariant::of_joint(a) };
                // Gears couple neighbours, above all in the wrist.
                let weight = match (a.abs_diff(b), a.min(b)) {
                    (1, 3..) => 4.0,
                    (1, _) | (2, 3) => 2.0,
                    _ => 0.5,
                };
                let one =
                    Candidate { weight, ..Candidate::new(EffectKind::JointCoupling, variant, vec![1e-4]) };
                all.push(match (dataset.slides[a], dataset.slides[b]) {
                    (false, true) => one.of_slide(SizeUnit::MillimetrePerRadian),
                    (true, false) => Candidate {
                        display_scale: m_from_mm(1.0),
                        own_unit: Some(SizeUnit::RadianPerMillimetre),
                        ..one
                    },
                    _ => one,
                });
            }
        }
        all
    }
    fn motion(&self, variant: &EffectVariant) -> Option<Motion> {
        variant.joint_b.map(Motion::Joint)
    }
    fn factors(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<f64>) {
        out.push(at.observation.q_rad[of_arm(variant.joint, at.observation)]);
    }
}
