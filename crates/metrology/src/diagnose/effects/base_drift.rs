//! Base and instrument drift apart: stand, floor, tripod.

use super::effect::{Candidate, Effect, EffectVariant};
use super::over_time::{DriftPrior, drifts, no_clock};
use super::rigid::{Motion, RigidBody};
use crate::diagnose::dataset::{DataPoint, Dataset};
use crate::diagnose::size_unit::SizeUnit;
use crate::diagnose::time_course::TimeCourse;
use robot_model::deform::EffectKind;
use robot_model::units::mm_from_m;

/// A rigid motion of the base that grows over the measurement.
pub(super) struct BaseDrift;

impl Effect for BaseDrift {
    fn kind(&self) -> EffectKind {
        EffectKind::BaseDrift
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::Millimetre
    }
    fn usual_size(&self) -> &'static str {
        "5 to 50 um per hour"
    }
    fn source(&self) -> &'static str {
        "stability of tripods and floors under laser trackers, ISO 10360-10:2021"
    }
    fn time(&self) -> TimeCourse {
        TimeCourse::Drift
    }
    fn untestable(&self, dataset: &Dataset) -> Option<String> {
        no_clock(dataset)
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        drifts(dataset)
            .into_iter()
            .map(|DriftPrior { growth, weight, grown_m }| Candidate {
                n_reported: 3,
                display_scale: mm_from_m(1.0),
                weight,
                ..Candidate::new(
                    EffectKind::BaseDrift,
                    EffectVariant { growth, ..EffectVariant::PLAIN },
                    vec![grown_m; 6],
                )
            })
            .collect()
    }
    fn motion(&self, _variant: &EffectVariant) -> Option<Motion> {
        Some(Motion::Body(RigidBody::Base))
    }
    fn factors(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<f64>) {
        out.push(variant.growth.at(&at.observation.thermal_state(), None));
    }
}
