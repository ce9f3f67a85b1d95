//! The stand gives: the whole robot tilts under its own overturning moment.

use super::effect::{Candidate, Effect, EffectVariant};
use super::rigid::MASS_ERROR;
use crate::diagnose::dataset::scaled;
use crate::diagnose::dataset::{Dataset, Observation, Twist};
use nalgebra::Vector3;
use robot_model::deform::EffectKind;

/// Turn of the base about x and y, each by its own compliance times its moment; each link's share may be wrong.
pub struct BaseTilt;

/// Prior standard deviation of the compliance, rad/(N.m).
const USUAL: f64 = 1e-6;

impl Effect for BaseTilt {
    fn kind(&self) -> EffectKind {
        EffectKind::BaseTilt
    }
    fn unit(&self) -> &'static str {
        "rad/(N.m)"
    }
    fn usual_size(&self) -> &'static str {
        "1e-4 rad per 100 N.m"
    }
    fn source(&self) -> &'static str {
        "foundation as two rotary springs at the base"
    }
    fn candidates(&self, _dataset: &Dataset) -> Vec<Candidate> {
        let mut sizes = vec![USUAL; 2];
        sizes.extend([MASS_ERROR * USUAL; 6]);
        vec![Candidate {
            sign_constrained: true,
            n_reported: 2,
            ..Candidate::new(EffectKind::BaseTilt, EffectVariant::PLAIN, sizes)
        }]
    }
    fn signature(
        &self,
        _variant: &EffectVariant,
        _dataset: &Dataset,
        observation: &Observation,
        out: &mut Vec<Twist>,
    ) {
        let about = |moment: &Vector3<f64>| {
            [
                scaled(observation.frame_offset(0, 3), moment.x),
                scaled(observation.frame_offset(0, 4), moment.y),
            ]
        };
        out.extend(about(&observation.loads.base_moment_n_m));
        for moment in &observation.loads.link_base_moment_n_m {
            let [x, y] = about(moment);
            out.push(std::array::from_fn(|i| x[i] + y[i]));
        }
    }
}
