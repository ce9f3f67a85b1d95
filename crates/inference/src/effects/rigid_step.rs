//! Base or instrument moved at one moment: a knock, a new set-up; or the target on the flange: reseated, knocked.

use super::effect::{Candidate, Effect, EffectVariant};
use super::over_time::{no_room_for_a_step, step_times};
use super::rigid::{Motion, RigidBody};
use crate::dataset::{DataPoint, Dataset};
use crate::size_unit::SizeUnit;
use crate::time_course::TimeCourse;
use robot_model::deform::EffectKind;
use robot_model::deform::identified::Growth;
use robot_model::units::mm_from_m;

/// A rigid motion of one side of the arm from t0 on, t0 scanned.
pub(super) struct RigidStep {
    kind: EffectKind,
    body: RigidBody,
    source: &'static str,
}

/// Usual size of each of the motion's parameters, metres or, about a metre's lever, radians.
const USUAL_M: f64 = 1e-4;

/// Arm and instrument move against each other, on whichever side of them it is.
pub(super) const BASE_STEP: RigidStep = RigidStep {
    kind: EffectKind::BaseStep,
    body: RigidBody::Base,
    source: "rigid motion between two registrations",
};

/// The measured point moves along the flange's axes; with orientation the target turns, too.
pub(super) const TOOL_STEP: RigidStep = RigidStep {
    kind: EffectKind::ToolStep,
    body: RigidBody::Tool,
    source: "rigid motion of the target on the flange",
};

impl Effect for RigidStep {
    fn kind(&self) -> EffectKind {
        self.kind
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
        self.source
    }
    fn time(&self) -> TimeCourse {
        TimeCourse::Step
    }
    fn untestable(&self, dataset: &Dataset) -> Option<String> {
        no_room_for_a_step(dataset)
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        let parameters = self.body.parameters(dataset);
        step_times(dataset)
            .into_iter()
            .map(|t0_min| Candidate {
                n_reported: 3,
                display_scale: mm_from_m(1.0),
                ..Candidate::new(
                    self.kind,
                    EffectVariant { growth: Growth::Step { t0_min }, ..EffectVariant::PLAIN },
                    vec![USUAL_M; parameters],
                )
            })
            .collect()
    }
    fn motion(&self, _variant: &EffectVariant) -> Option<Motion> {
        Some(Motion::Body(self.body))
    }
    fn factors(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<f64>) {
        out.push(variant.growth.at(&at.observation.moment(), None));
    }
}
