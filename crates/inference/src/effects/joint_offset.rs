//! A joint's zero is off: its encoder, its calibration mark.

use super::effect::{Candidate, Effect, EffectVariant};
use super::rigid::Motion;
use crate::dataset::{DataPoint, Dataset, Twist};
use crate::size_unit::SizeUnit;
use robot_model::deform::EffectKind;
use robot_model::robot::Axis;

/// J_j times a constant.
pub(super) struct JointOffset;

impl Effect for JointOffset {
    fn kind(&self) -> EffectKind {
        EffectKind::JointOffset
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::Radian
    }
    fn usual_size(&self) -> &'static str {
        "0.1 to 2 mrad"
    }
    /// A zero that was set by eye may be two degrees off.
    fn furthest_sigmas(&self) -> f64 {
        100.0
    }
    fn source(&self) -> &'static str {
        "Mooring, Roth, Driels, Fundamentals of Manipulator Calibration, 1991, ch. 2"
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        let sigmas = (0..dataset.joints()).map(|j| dataset.by_kind(j, 4e-4, 2e-4));
        let mut all: Vec<Candidate> = sigmas
            .clone()
            .enumerate()
            .map(|(j, sigma)| {
                let one = Candidate::new(EffectKind::JointOffset, EffectVariant::of_joint(j), vec![sigma]);
                dataset.by_kind(j, one.clone(), one.of_slide(SizeUnit::Millimetre))
            })
            .collect();
        // All at once, for an arm that was never calibrated: the search takes it apart again.
        all.push(Candidate {
            weight: 0.1,
            ..Candidate::new(EffectKind::JointOffset, EffectVariant::PLAIN, sigmas.collect())
        });
        all
    }
    fn motion(&self, variant: &EffectVariant) -> Option<Motion> {
        variant.joint.map(Motion::Joint)
    }
    fn factors(&self, _variant: &EffectVariant, _at: DataPoint<'_>, out: &mut Vec<f64>) {
        out.push(1.0);
    }
    fn signature(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<Twist>) {
        let joints = variant.joint.map_or(0..at.observation.joints(), |axis| axis.index()..axis.index() + 1);
        joints.for_each(|j| Motion::Joint(Axis::at(j)).signature(at, &[1.0], out));
    }
}
