//! A joint's zero jumps at one moment: an encoder reset, a belt that skipped, a flange that slipped about joint 6.

use super::effect::{Candidate, Effect, EffectVariant};
use super::over_time::{changes, no_room_for_a_step, step_times};
use super::rigid::Motion;
use crate::dataset::{DataPoint, Dataset};
use crate::size_unit::SizeUnit;
use crate::time_course::TimeCourse;
use robot_model::deform::EffectKind;
use robot_model::deform::identified::Growth;

/// J_j from t0 on, t0 scanned; beside a constant of its own where the arm was not calibrated before the jump.
pub(super) struct JointStep;

impl Effect for JointStep {
    fn kind(&self) -> EffectKind {
        EffectKind::JointStep
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
        "Mooring, Roth, Driels, Fundamentals of Manipulator Calibration, 1991, ch. 2: joint offsets before and after"
    }
    fn time(&self) -> TimeCourse {
        TimeCourse::Step
    }
    fn untestable(&self, dataset: &Dataset) -> Option<String> {
        no_room_for_a_step(dataset)
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        let times = step_times(dataset);
        (0..dataset.joints())
            .flat_map(|j| {
                let size = dataset.by_kind(j, 4e-4, 2e-4);
                times.iter().flat_map(move |&t0_min| {
                    let plain =
                        EffectVariant { growth: Growth::Step { t0_min }, ..EffectVariant::of_joint(j) };
                    changes(dataset, EffectKind::JointStep, plain, [size, size])
                        .map(move |one| dataset.by_kind(j, one.clone(), one.of_slide(SizeUnit::Millimetre)))
                })
            })
            .collect()
    }
    fn motion(&self, variant: &EffectVariant) -> Option<Motion> {
        variant.joint.map(Motion::Joint)
    }
    fn factors(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<f64>) {
        out.push(variant.growth.at(&at.observation.moment(), None));
        out.extend(variant.refined.then_some(1.0));
    }
}
