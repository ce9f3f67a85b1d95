//! The target moved on the flange at one moment: reseated, knocked.

use super::effect::{Candidate, Effect, EffectVariant};
use super::over_time::{no_clock, step_times};
use super::rigid::{Motion, RigidBody};
use crate::diagnose::dataset::{DataPoint, Dataset};
use crate::diagnose::size_unit::SizeUnit;
use crate::diagnose::time_course::TimeCourse;
use robot_model::deform::EffectKind;
use robot_model::deform::identified::Growth;
use robot_model::units::mm_from_m;

/// A shift of the measured point in the flange's axes, with orientation also a turn, from t0 on, t0 scanned.
pub(super) struct ToolStep;

impl Effect for ToolStep {
    fn kind(&self) -> EffectKind {
        EffectKind::ToolStep
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::Millimetre
    }
    fn usual_size(&self) -> &'static str {
        "any size"
    }
    fn furthest_sigmas(&self) -> f64 {
        f64::INFINITY
    }
    fn source(&self) -> &'static str {
        "rigid motion of the target on the flange"
    }
    fn time(&self) -> TimeCourse {
        TimeCourse::Step
    }
    fn untestable(&self, dataset: &Dataset) -> Option<String> {
        no_clock(dataset)
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        step_times(dataset)
            .into_iter()
            .map(|t0_min| Candidate {
                n_reported: 3,
                display_scale: mm_from_m(1.0),
                ..Candidate::new(
                    EffectKind::ToolStep,
                    EffectVariant { growth: Growth::Step { t0_min }, ..EffectVariant::PLAIN },
                    vec![1e-4; dataset.rows_per_observation],
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
