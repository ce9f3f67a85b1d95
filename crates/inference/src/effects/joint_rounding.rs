//! Joints written with too few decimals.

use super::effect::{Candidate, Effect};
use crate::dataset::Dataset;
use crate::size_unit::SizeUnit;
use robot_model::deform::EffectKind;

/// Joints in the file are rounded: uniform errors of each joint, looked for by the data checks.
pub(super) struct JointRounding;

impl Effect for JointRounding {
    fn kind(&self) -> EffectKind {
        EffectKind::JointRounding
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::Radian
    }
    fn usual_size(&self) -> &'static str {
        "0.1 deg gives about 0.5 mm"
    }
    fn source(&self) -> &'static str {
        "uniform rounding error, variance step^2 / 12"
    }
    /// None: it is a fault of the file, looked for before any effect.
    fn candidates(&self, _dataset: &Dataset) -> Vec<Candidate> {
        Vec::new()
    }
}
