//! The stand gives: the whole robot tilts under its own overturning moment.

use super::effect::{Candidate, Effect, EffectVariant};
use super::rigid::{LEVER_M, MASS_ERROR, sag_per_load};
use crate::dataset::scaled;
use crate::dataset::{DataPoint, Dataset, Observation, Twist};
use crate::size_unit::SizeUnit;
use nalgebra::Vector3;
use robot_model::deform::EffectKind;
use robot_model::deform::gravity::GRAVITY_M_S2;

/// Turn of the base about x and y through joint 1's origin, each by its own compliance times its moment; each link's share may be wrong. Of a mounting
/// face that is inclined a turn about joint 1's axis as well, under the moment about it: springs in the face have none, a pedestal below the
/// wedge turns about what is horizontal, and so about a part of that axis.
/// Refined it turns about what lies below that origin or above it: the mounting face, a pedestal's foot.
pub(super) struct BaseTilt;

/// How far a foundation usually turns under the largest moment of the measurement, radians.
const TILT_RAD: f64 = 1.5e-4;

/// How far what the base turns about usually lies below joint 1's origin or above it, metres: where on its axis a robot file puts joint 1
/// is free, its mounting face is 0.1 to 0.8 m below its shoulder, and pedestals are as high.
const PIVOT_M: f64 = 0.3;

/// Share of the bases that turn about something else than joint 1's origin.
const ELSEWHERE: f64 = 0.3;

/// What a foundation usually turns under a moment, rad/(N.m).
const USUAL_COMPLIANCE: f64 = 1e-6;

/// Sine and cosine of an inclination from which on a mounting face is inclined: one that is nearly level has no moment about joint 1's axis, and on a
/// wall a turn about that axis is one about what is horizontal.
const INCLINED: f64 = 0.1;

/// Whether the arm stands on a face that is inclined, and turns on it.
fn is_inclined(dataset: &Dataset) -> bool {
    let axis = dataset.of_arm().next().filter(|o| !o.slides[0]).map(|o| o.axes[0]);
    axis.is_some_and(|axis| axis.xy().norm() > INCLINED && axis.z.abs() > INCLINED)
}

/// How the base, of its usual compliance, tilts under one kilogram more at the measured point.
#[must_use]
pub fn base_tilt_per_kg(observation: &Observation) -> Twist {
    let lever_m = &observation.point_m;
    let turn = |n_m: f64, k: usize| scaled(observation.frame_offset(0, k), USUAL_COMPLIANCE * n_m);
    let (x, y) = (turn(-GRAVITY_M_S2 * lever_m.y, 3), turn(GRAVITY_M_S2 * lever_m.x, 4));
    Twist(std::array::from_fn(|i| x[i] + y[i]))
}

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
        let levers = if dataset.largest_payload_kg > 0.0 { 3 } else { 0 };
        let of = |refined: bool, weight: f64| {
            let shifts = std::iter::repeat_n(PIVOT_M * usual, if refined { 2 } else { 0 });
            let levers = std::iter::repeat_n(LEVER_M * usual, levers);
            let about_axis = std::iter::repeat_n(usual, usize::from(is_inclined(dataset)));
            let sizes = sizes.iter().copied().chain(about_axis).chain(shifts).chain(levers).collect();
            Candidate {
                sign_constrained: true,
                n_reported: 2,
                weight,
                ..Candidate::new(
                    EffectKind::BaseTilt,
                    EffectVariant { refined, ..EffectVariant::PLAIN },
                    sizes,
                )
            }
        };
        vec![of(false, 1.0 - ELSEWHERE), of(true, ELSEWHERE)]
    }
    fn signature(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<Twist>) {
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
        if is_inclined(at.dataset) {
            out.push(scaled(observation.jacobian_column(0), observation.loads.torque_n_m[0]));
        }
        if variant.refined {
            let moment = &observation.loads.base_moment_n_m;
            out.extend([
                scaled(observation.frame_offset(0, 0), moment.y),
                scaled(observation.frame_offset(0, 1), -moment.x),
            ]);
        }
        if at.dataset.largest_payload_kg > 0.0 {
            let payload_kg = observation.payload_kg.unwrap_or(0.0);
            out.extend(observation.loads.unit_lever_moment_n.map(|moment_n| both(&(moment_n * payload_kg))));
        }
    }
}
