//! A link is not as drawn: the next joint's frame is shifted and turned on it.

use super::effect::{Candidate, Effect, EffectVariant};
use super::rigid::of_arm;
use crate::diagnose::dataset::{DataPoint, Dataset, Twist};
use crate::diagnose::size_unit::SizeUnit;
use robot_model::deform::EffectKind;
use robot_model::units::mm_from_m;

/// Three shifts and three turns of the frame that follows link i, in the link's axes.
pub(super) struct LinkGeometry;

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
        (0..dataset.joints())
            .map(|i| Candidate {
                n_reported: 3,
                display_scale: mm_from_m(1.0),
                ..Candidate::new(
                    EffectKind::LinkGeometry,
                    EffectVariant::of_joint(i),
                    vec![2e-4, 2e-4, 2e-4, 3e-4, 3e-4, 3e-4],
                )
            })
            .collect()
    }
    fn signature(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<Twist>) {
        let link = of_arm(variant.joint, at.observation);
        for k in 0..6 {
            out.push(at.observation.frame_offset(link + 1, k));
        }
    }
}
