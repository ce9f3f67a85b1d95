//! The stand gives: the whole robot tilts under its own overturning moment.

use super::effect::{Candidate, Effect, EffectVariant};
use super::rigid::{LEVER_M, MASS_ERROR, sag_per_load};
use crate::diagnose::dataset::scaled;
use crate::diagnose::dataset::{DataPoint, Dataset, Observation, Twist};
use crate::diagnose::size_unit::SizeUnit;
use nalgebra::Vector3;
use robot_model::deform::EffectKind;

/// Turn of the base about x and y, each by its own compliance times its moment; each link's share may be wrong.
pub(super) struct BaseTilt;

/// How far a foundation usually turns under the largest moment of the measurement, radians.
const TILT_RAD: f64 = 1.5e-4;

impl Effect for BaseTilt {
    fn kind(&self) -> EffectKind {
        EffectKind::BaseTilt
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::RadianPerNewtonMetre
    }
    fn usual_size(&self) -> &'static str {
        "1e-4 rad per 100 N.m"
    }
    /// Springs under one load take each other back where the poses do not tell them apart: each may be further off than all of them.
    fn furthest_sigmas(&self) -> f64 {
        300.0
    }
    fn source(&self) -> &'static str {
        "foundation as two rotary springs at the base"
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        let across_n_m = |o: &Observation| o.loads.base_moment_n_m.xy().norm();
        let largest_n_m = dataset.observations.iter().map(across_n_m).fold(0.0, f64::max);
        let usual = sag_per_load(TILT_RAD, largest_n_m);
        let mut sizes = vec![usual; 2];
        sizes.extend(std::iter::repeat_n(MASS_ERROR * usual, dataset.joints()));
        if dataset.largest_payload_kg > 0.0 {
            sizes.extend([LEVER_M * usual; 3]);
        }
        vec![Candidate {
            sign_constrained: true,
            n_reported: 2,
            ..Candidate::new(EffectKind::BaseTilt, EffectVariant::PLAIN, sizes)
        }]
    }
    fn signature(&self, _variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<Twist>) {
        let observation = at.observation;
        let about = |moment: &Vector3<f64>| {
            [
                scaled(observation.frame_offset(0, 3), moment.x),
                scaled(observation.frame_offset(0, 4), moment.y),
            ]
        };
        out.extend(about(&observation.loads.base_moment_n_m));
        let both = |moment: &Vector3<f64>| {
            let [x, y] = about(moment);
            Twist(std::array::from_fn(|i| x[i] + y[i]))
        };
        out.extend(observation.loads.link_base_moment_n_m[..observation.joints()].iter().map(both));
        if at.dataset.largest_payload_kg > 0.0 {
            let payload_kg = observation.payload_kg.unwrap_or(0.0);
            out.extend(observation.loads.unit_lever_moment_n.map(|moment_n| both(&(moment_n * payload_kg))));
        }
    }
}
