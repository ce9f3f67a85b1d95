//! Base or instrument moved at one moment: a knock, a new set-up.

use super::effect::{Candidate, Effect, EffectVariant};
use super::over_time::{no_clock, step_times};
use super::rigid::{Motion, RigidBody};
use crate::diagnose::dataset::{DataPoint, Dataset};
use crate::diagnose::size_unit::SizeUnit;
use crate::diagnose::time_course::TimeCourse;
use robot_model::deform::EffectKind;
use robot_model::deform::identified::Growth;
use robot_model::units::mm_from_m;

/// A rigid motion of the base from t0 on, t0 scanned.
pub(super) struct BaseStep;

impl Effect for BaseStep {
    fn kind(&self) -> EffectKind {
        EffectKind::BaseStep
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
        "rigid motion between two registrations"
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
                    EffectKind::BaseStep,
                    EffectVariant { growth: Growth::Step { t0_min }, ..EffectVariant::PLAIN },
                    vec![1e-4, 1e-4, 1e-4, 1e-4, 1e-4, 1e-4],
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
