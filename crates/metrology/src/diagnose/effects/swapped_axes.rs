//! Two measured axes swapped, or one mirrored.

use super::effect::{Candidate, Effect, EffectVariant};
use crate::diagnose::dataset::{Dataset, Observation, Twist};
use robot_model::deform::EffectKind;

/// Measured points are mirrored, looked for by the data checks.
pub struct SwappedAxes;

impl Effect for SwappedAxes {
    fn kind(&self) -> EffectKind {
        EffectKind::SwappedAxes
    }
    fn unit(&self) -> &'static str {
        "1"
    }
    fn usual_size(&self) -> &'static str {
        "hundreds of mm"
    }
    fn source(&self) -> &'static str {
        "a mirror is no rigid motion"
    }
    /// None: it is a fault of the file, looked for before any effect.
    fn candidates(&self, _dataset: &Dataset) -> Vec<Candidate> {
        Vec::new()
    }
    fn signature(
        &self,
        _variant: &EffectVariant,
        _dataset: &Dataset,
        _observation: &Observation,
        _out: &mut Vec<Twist>,
    ) {
    }
}
