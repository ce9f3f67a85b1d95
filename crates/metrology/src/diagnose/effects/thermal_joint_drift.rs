//! A joint's zero drifts as its gear and motor warm up.

use super::effect::{Candidate, Effect, EffectVariant};
use super::rigid::Motion;
use super::thermal;
use crate::diagnose::dataset::{DataPoint, Dataset};
use crate::diagnose::size_unit::SizeUnit;
use crate::diagnose::time_course::TimeCourse;
use robot_model::deform::EffectKind;

/// J_j times warm-up, plus a constant of its own.
pub(super) struct ThermalJointDrift;

impl Effect for ThermalJointDrift {
    fn kind(&self) -> EffectKind {
        EffectKind::ThermalJointDrift
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::Radian
    }
    fn usual_size(&self) -> &'static str {
        "0.02 to 0.3 mrad"
    }
    fn source(&self) -> &'static str {
        "Heisel, Richter, Wurst 1997; Gong, Yuan, Ni 2000, Nongeometric error identification"
    }
    fn time(&self) -> TimeCourse {
        TimeCourse::Drift
    }
    fn untestable(&self, dataset: &Dataset) -> Option<String> {
        thermal::untestable(dataset)
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        (0..dataset.joints())
            .flat_map(|j| {
                let one = Candidate {
                    n_reported: 1,
                    ..Candidate::new(
                        EffectKind::ThermalJointDrift,
                        EffectVariant::of_joint(j),
                        dataset.by_kind(j, vec![1.2e-4, 4e-4], vec![6e-5, 2e-4]),
                    )
                };
                let one = dataset.by_kind(j, one.clone(), one.of_slide(SizeUnit::Millimetre));
                thermal::growths(dataset, &one)
            })
            .collect()
    }
    fn motion(&self, variant: &EffectVariant) -> Option<Motion> {
        variant.joint.map(Motion::Joint)
    }
    fn factors(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<f64>) {
        out.extend([variant.growth.at(&at.observation.thermal_state(), variant.joint), 1.0]);
    }
}
