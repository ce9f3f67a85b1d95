//! A link is not as drawn: the next joint's frame is shifted and turned on it.

use super::effect::{Candidate, Effect, EffectVariant};
use super::rigid::{SHORTEST_LINK_M, of_arm};
use crate::dataset::{DataPoint, Dataset, Observation, Twist};
use crate::size_unit::SizeUnit;
use nalgebra::Vector3;
use robot_model::deform::EffectKind;
use robot_model::units::mm_from_m;

/// Three shifts and three turns of the frame that follows link i, in the link's axes; or, refined, a shift along the link alone.
pub(super) struct LinkGeometry;

/// Share of the links that are as drawn but for their length: a spacer, a scale of the drawing, what stays of a warm-up.
const LENGTH_ALONE: f64 = 0.2;

/// The direction of link `i` (from 0) in the axes of the frame that follows it, the last link's that of the flange; `None` where it
/// has no length.
#[must_use]
pub fn along_link(observation: &Observation, i: usize) -> Option<Vector3<f64>> {
    let along_m = observation.origins_m[i + 1] - observation.carried_m[i];
    (observation.parents[i + 1].transpose() * along_m).try_normalize(SHORTEST_LINK_M)
}

impl Effect for LinkGeometry {
    fn kind(&self) -> EffectKind {
        EffectKind::LinkGeometry
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::Millimetre
    }
    fn usual_size(&self) -> &'static str {
        "0.05 to 0.5 mm and 0.1 to 0.5 mrad"
    }
    fn source(&self) -> &'static str {
        "Hayati and Mirmirani 1985; Mooring, Roth, Driels 1991, ch. 2"
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        // Where a joint slides along the link its zero is the same.
        let slides = |i: usize| dataset.slides[i] || dataset.slides.get(i + 1).is_some_and(|slides| *slides);
        let has_length =
            |i: usize| !slides(i) && dataset.of_arm().next().is_some_and(|o| along_link(o, i).is_some());
        let whole = |i: usize| Candidate {
            n_reported: 3,
            display_scale: mm_from_m(1.0),
            weight: 1.0 - LENGTH_ALONE,
            ..Candidate::new(
                EffectKind::LinkGeometry,
                EffectVariant::of_joint(i),
                vec![2e-4, 2e-4, 2e-4, 3e-4, 3e-4, 3e-4],
            )
        };
        let length = |i: usize| Candidate {
            n_reported: 1,
            display_scale: mm_from_m(1.0),
            weight: LENGTH_ALONE,
            ..Candidate::new(
                EffectKind::LinkGeometry,
                EffectVariant { refined: true, ..EffectVariant::of_joint(i) },
                vec![2e-4],
            )
        };
        let joints = 0..dataset.joints();
        joints.clone().map(whole).chain(joints.filter(|&i| has_length(i)).map(length)).collect()
    }
    fn signature(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<Twist>) {
        let link = of_arm(variant.joint, at.observation);
        if variant.refined {
            let along = along_link(at.observation, link).unwrap_or_default();
            let shift = at.observation.parents[link + 1] * along;
            out.push(Twist([shift.x, shift.y, shift.z, 0.0, 0.0, 0.0]));
            return;
        }
        for k in 0..6 {
            out.push(at.observation.frame_offset(link + 1, k));
        }
    }
}
