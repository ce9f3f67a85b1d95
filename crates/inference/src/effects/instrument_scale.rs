//! The instrument's lengths are scaled: air temperature and pressure, an uncalibrated scale.

use super::effect::{Candidate, Effect, EffectVariant};
use crate::dataset::{DataPoint, Dataset, Twist};
use crate::size_unit::SizeUnit;
use robot_model::deform::EffectKind;
use robot_model::units::ppm_from_ratio;

/// Distance times a number. Any fixed origin differs by a shift that the registration takes.
pub(super) struct InstrumentScale;

impl Effect for InstrumentScale {
    fn kind(&self) -> EffectKind {
        EffectKind::InstrumentScale
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::PartsPerMillion
    }
    fn usual_size(&self) -> &'static str {
        "1 ppm/K of air, 10 to 50 ppm"
    }
    fn source(&self) -> &'static str {
        "Ciddor 1996, Refractive index of air; ISO 10360-10:2021"
    }
    fn candidates(&self, _dataset: &Dataset) -> Vec<Candidate> {
        vec![Candidate {
            display_scale: ppm_from_ratio(1.0),
            ..Candidate::new(EffectKind::InstrumentScale, EffectVariant::PLAIN, vec![3e-5])
        }]
    }
    fn signature(&self, _variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<Twist>) {
        out.push(Twist([
            at.observation.point_m.x,
            at.observation.point_m.y,
            at.observation.point_m.z,
            0.0,
            0.0,
            0.0,
        ]));
    }
}
