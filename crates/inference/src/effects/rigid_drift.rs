//! Base and instrument drift apart: stand, floor, tripod; or the target creeps on the flange: glue, a warm spindle.

use super::effect::{Candidate, Effect, EffectVariant};
use super::over_time::{DriftPrior, drifts, no_clock};
use super::rigid::{Motion, RigidBody};
use crate::dataset::{DataPoint, Dataset};
use crate::size_unit::SizeUnit;
use crate::time_course::TimeCourse;
use robot_model::deform::EffectKind;
use robot_model::units::mm_from_m;

/// A rigid motion of one side of the arm that grows over the measurement.
pub(super) struct RigidDrift {
    kind: EffectKind,
    body: RigidBody,
    source: &'static str,
}

/// Arm and instrument move against each other, on whichever side of them it is.
pub(super) const BASE_DRIFT: RigidDrift = RigidDrift {
    kind: EffectKind::BaseDrift,
    body: RigidBody::Base,
    source: "stability of tripods and floors under laser trackers, ISO 10360-10:2021",
};

/// The measured point moves along the flange's axes; with orientation the target turns, too.
pub(super) const TOOL_DRIFT: RigidDrift = RigidDrift {
    kind: EffectKind::ToolDrift,
    body: RigidBody::Tool,
    source: "rigid motion of the target on the flange",
};

impl Effect for RigidDrift {
    fn kind(&self) -> EffectKind {
        self.kind
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::Millimetre
    }
    fn usual_size(&self) -> &'static str {
        "5 to 50 um per hour"
    }
    fn source(&self) -> &'static str {
        self.source
    }
    fn time(&self) -> TimeCourse {
        TimeCourse::Drift
    }
    fn untestable(&self, dataset: &Dataset) -> Option<String> {
        no_clock(dataset)
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        let parameters = self.body.parameters(dataset);
        drifts(dataset)
            .into_iter()
            .map(|DriftPrior { growth, weight, grown_m }| Candidate {
                n_reported: 3,
                display_scale: mm_from_m(1.0),
                weight,
                ..Candidate::new(
                    self.kind,
                    EffectVariant { growth, ..EffectVariant::PLAIN },
                    vec![grown_m; parameters],
                )
            })
            .collect()
    }
    fn motion(&self, _variant: &EffectVariant) -> Option<Motion> {
        Some(Motion::Body(self.body))
    }
    fn factors(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<f64>) {
        out.push(variant.growth.at(&at.observation.thermal_state(), None));
    }
}
