//! A joint's zero drifts as its gear and motor warm up.

use super::effect::{Candidate, Effect, EffectVariant};
use super::over_time::changes;
use super::rigid::Motion;
use super::thermal;
use crate::dataset::{DataPoint, Dataset};
use crate::size_unit::SizeUnit;
use crate::time_course::TimeCourse;
use robot_model::deform::EffectKind;

/// J_j times warm-up; beside a constant of its own where the arm was not calibrated cold.
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
                let sizes = dataset.by_kind(j, [1.2e-4, 4e-4], [6e-5, 2e-4]);
                changes(dataset, EffectKind::ThermalJointDrift, EffectVariant::of_joint(j), sizes)
                    .map(move |one| dataset.by_kind(j, one.clone(), one.of_slide(SizeUnit::Millimetre)))
                    .flat_map(|one| thermal::growths(dataset, &one))
            })
            .collect()
    }
    fn motion(&self, variant: &EffectVariant) -> Option<Motion> {
        variant.joint.map(Motion::Joint)
    }
    fn factors(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<f64>) {
        out.push(variant.growth.at(&at.observation.thermal_state(), variant.joint));
        out.extend(variant.refined.then_some(1.0));
    }
}
