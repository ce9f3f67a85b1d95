//! Two measured axes swapped, or one mirrored.

use super::effect::{Candidate, Effect};
use crate::dataset::Dataset;
use crate::size_unit::SizeUnit;
use robot_model::deform::EffectKind;

/// Measured points are mirrored, looked for by the data checks.
pub(super) struct SwappedAxes;

impl Effect for SwappedAxes {
    fn kind(&self) -> EffectKind {
        EffectKind::SwappedAxes
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::One
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
}
