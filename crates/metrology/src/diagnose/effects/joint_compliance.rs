//! A joint's gear gives under gravity's torque.

use super::effect::{Candidate, Effect, EffectVariant};
use super::rigid::{LEVER_M, MASS_ERROR, Motion, of_arm, sag_per_load};
use crate::diagnose::dataset::{DataPoint, Dataset};
use crate::diagnose::size_unit::SizeUnit;
use robot_model::deform::EffectKind;

/// J_j times the torque about joint j, or the force along one that slides; each link's share may be wrong, and the payload's centre elsewhere.
pub(super) struct JointCompliance;

/// How wrong a mass may be that was only guessed: gears are the softest part of an arm, and so it is they that get
/// the benefit of the doubt; bending and tilt have to show with the guess.
const GUESS_ERROR: f64 = 1.0;

/// How far a joint usually sags under a large torque of the measurement, radians: as an angle it holds for an arm of 25 kg as
/// for one of a ton, and whether the masses are known or guessed.
const SAG_RAD: f64 = 5e-4;

/// The same of a joint that slides, along its axis, metres.
const SAG_M: f64 = 1e-4;
/// No spindle or guide gives more than this, m/N, however little its load is.
const SOFTEST_M_N: f64 = 1e-5;

/// How far from linear a spring may be, over its linear part, and the share of those that are.
const BENT: f64 = 0.5;
const BENT_WEIGHT: f64 = 0.2;

impl Effect for JointCompliance {
    fn kind(&self) -> EffectKind {
        EffectKind::JointCompliance
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::RadianPerNewtonMetre
    }
    fn usual_size(&self) -> &'static str {
        "0.2 to 1 mrad under the largest torque: 2 to 20 urad/(N.m) in the arm, 20 to 200 in the wrist"
    }
    /// Springs under one load take each other back where the poses do not tell them apart: each may be further off than all of them.
    fn furthest_sigmas(&self) -> f64 {
        300.0
    }
    fn source(&self) -> &'static str {
        "Khalil and Besnard 2002, Geometric calibration of robots with flexible joints and links"
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        let error = if dataset.masses_known { MASS_ERROR } else { GUESS_ERROR };
        let joints = dataset.joints();
        (0..joints)
            .filter(|&j| dataset.observations.iter().any(|s| s.loads.torque_n_m[j].abs() > 1e-6))
            .flat_map(|j| {
                let largest = dataset.large_torque_n_m(j);
                let prior_sigma =
                    dataset.by_kind(j, sag_per_load(SAG_RAD, largest), (SAG_M / largest).min(SOFTEST_M_N));
                [(false, 1.0 - BENT_WEIGHT), (true, BENT_WEIGHT)].map(|(refined, weight)| {
                    let mut sizes = vec![prior_sigma];
                    sizes.extend(std::iter::repeat_n(error * prior_sigma, joints - j));
                    if refined {
                        sizes.extend([BENT * prior_sigma; 2]);
                    }
                    if dataset.largest_payload_kg > 0.0 {
                        sizes.extend([LEVER_M * prior_sigma; 3]);
                    }
                    let variant = EffectVariant { refined, ..EffectVariant::of_joint(j) };
                    let one = Candidate {
                        sign_constrained: true,
                        n_reported: 1,
                        weight,
                        ..Candidate::new(EffectKind::JointCompliance, variant, sizes)
                    };
                    dataset.by_kind(j, one.clone(), one.of_slide(SizeUnit::MillimetrePerNewton))
                })
            })
            .collect()
    }
    fn motion(&self, variant: &EffectVariant) -> Option<Motion> {
        variant.joint.map(Motion::Joint)
    }
    fn factors(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<f64>) {
        let DataPoint { dataset, observation } = at;
        let j = of_arm(variant.joint, observation);
        let torque_n_m = observation.loads.torque_n_m[j];
        out.push(torque_n_m);
        out.extend((j..observation.joints()).map(|k| observation.loads.link_torque_n_m[j][k]));
        if variant.refined {
            // A spring that hardens or softens, each as large as the linear one at the largest torque.
            let largest_n_m = dataset.large_torque_n_m(j);
            out.push(torque_n_m * torque_n_m.abs() / largest_n_m);
            out.push(torque_n_m.signum() * (torque_n_m.abs() * largest_n_m).sqrt());
        }
        if dataset.largest_payload_kg > 0.0 {
            let payload_kg = observation.payload_kg.unwrap_or(0.0);
            out.extend((0..3).map(|k| payload_kg * observation.loads.unit_lever_n[j][k]));
        }
    }
}
