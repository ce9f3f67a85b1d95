//! The target creeps on the flange: glue, a warm spindle.

use super::effect::{Candidate, Effect, EffectVariant};
use super::over_time::{DriftPrior, drifts, no_clock};
use super::rigid::{Motion, RigidBody};
use crate::diagnose::dataset::{DataPoint, Dataset};
use crate::diagnose::size_unit::SizeUnit;
use crate::diagnose::time_course::TimeCourse;
use robot_model::deform::EffectKind;
use robot_model::units::mm_from_m;

/// A shift of the measured point in the flange's axes, with orientation also a turn, that grows over the measurement.
pub(super) struct ToolDrift;

impl Effect for ToolDrift {
    fn kind(&self) -> EffectKind {
        EffectKind::ToolDrift
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::Millimetre
    }
    fn usual_size(&self) -> &'static str {
        "5 to 50 um per hour"
    }
    fn source(&self) -> &'static str {
        "rigid motion of the target on the flange"
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
                    EffectKind::ToolDrift,
                    EffectVariant { growth, ..EffectVariant::PLAIN },
                    vec![grown_m; dataset.rows_per_observation],
                )
            })
            .collect()
    }
    fn motion(&self, _variant: &EffectVariant) -> Option<Motion> {
        Some(Motion::Body(RigidBody::Tool))
    }
    fn factors(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<f64>) {
        out.push(variant.growth.at(&at.observation.thermal_state(), None));
    }
}
