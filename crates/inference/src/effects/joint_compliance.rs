//! A joint's gear gives under gravity's torque.

use super::effect::{Candidate, Effect, EffectVariant};
use super::rigid::{LEVER_M, MASS_ERROR, Motion, of_arm, sag_per_load};
use crate::dataset::{DataPoint, Dataset, Twist, scaled};
use crate::size_unit::SizeUnit;
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

/// The weight of all joints together beside that of one, and the fewest joints under load for it.
const TOGETHER_WEIGHT: f64 = 0.3;
const FEWEST_TOGETHER: usize = 3;

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
        let loaded = || (0..joints).filter(|&j| dataset.loaded[j]);
        let mut all: Vec<Candidate> = loaded()
            .flat_map(|j| {
                let prior_sigma = usual(dataset, j);
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
            .collect();
        // All at once, for an arm whose gears all give a little: in the place of another cause it is named by the joint that gives most.
        if loaded().count() >= FEWEST_TOGETHER {
            let mut sizes: Vec<f64> = loaded().map(|j| usual(dataset, j)).collect();
            sizes.extend(std::iter::repeat_n(error, joints));
            if dataset.largest_payload_kg > 0.0 {
                sizes.extend([LEVER_M; 3]);
            }
            all.push(Candidate {
                weight: TOGETHER_WEIGHT,
                ..Candidate::new(EffectKind::JointCompliance, EffectVariant::PLAIN, sizes)
            });
        }
        all
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
    fn signature(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<Twist>) {
        if let Some(motion) = self.motion(variant) {
            let mut factors = Vec::new();
            self.factors(variant, at, &mut factors);
            return motion.signature(at, &factors, out);
        }
        let DataPoint { dataset, observation } = at;
        let loads = &observation.loads;
        let loaded = || (0..observation.joints()).filter(|&j| dataset.loaded[j]);
        out.extend(loaded().map(|j| scaled(observation.jacobian_column(j), loads.torque_n_m[j])));
        // What is wrong of a mass is wrong for all joints: each as soft as usual.
        let mut together = |part: &dyn Fn(usize) -> f64| {
            let mut all = Twist::default();
            for j in loaded() {
                let turned = scaled(observation.jacobian_column(j), usual(dataset, j) * part(j));
                for (sum, part) in all.iter_mut().zip(turned) {
                    *sum += part;
                }
            }
            out.push(all);
        };
        for link in 0..observation.joints() {
            together(&|j| loads.link_torque_n_m[j][link]);
        }
        if dataset.largest_payload_kg > 0.0 {
            let payload_kg = observation.payload_kg.unwrap_or(0.0);
            (0..3).for_each(|k| together(&|j| payload_kg * loads.unit_lever_n[j][k]));
        }
    }
}

/// Prior standard deviation of a joint's compliance, rad/(N.m) or m/N.
fn usual(dataset: &Dataset, j: usize) -> f64 {
    let largest = dataset.large_torque_n_m(j);
    dataset.by_kind(j, sag_per_load(SAG_RAD, largest), (SAG_M / largest).min(SOFTEST_M_N))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::evenly_spread;

    /// A column for the spring of each joint that gravity turns, as it is alone, and one for each mass, which is as wrong for all of them.
    #[test]
    fn the_springs_of_all_joints_are_those_of_each() {
        let dataset = evenly_spread(20);
        let candidates = JointCompliance.candidates(&dataset);
        let of = |candidate: &Candidate| -> Vec<Vec<Twist>> {
            let signature = |observation| {
                let mut out = Vec::new();
                JointCompliance.signature(&candidate.variant, dataset.at(observation), &mut out);
                out
            };
            dataset.observations.iter().map(signature).collect()
        };
        let all = candidates.last().unwrap();
        assert_eq!(all.variant.joint, None);
        let singles: Vec<&Candidate> =
            candidates.iter().filter(|c| c.variant.joint.is_some() && !c.variant.refined).collect();
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * (1.0 + a.abs());
        for (together, i) in of(all).iter().zip(0..) {
            let alone: Vec<Vec<Twist>> = singles.iter().map(|single| of(single).swap_remove(i)).collect();
            for (column, alone) in together.iter().zip(&alone) {
                assert!(column.iter().zip(alone[0].iter()).all(|(a, b)| near(*a, *b)));
            }
            let masses = &together[singles.len()..singles.len() + dataset.joints()];
            for (link, mass) in masses.iter().enumerate() {
                for (axis, value) in mass.iter().enumerate() {
                    // A single spring has the shares of the links from its own on.
                    let share = |(single, alone): (&&Candidate, &Vec<Twist>)| {
                        let own = single.variant.joint.map_or(0, |joint| joint.index());
                        link.checked_sub(own).map_or(0.0, |k| single.prior_sigma[0] * alone[1 + k][axis])
                    };
                    let sum: f64 = singles.iter().zip(&alone).map(share).sum();
                    assert!(near(*value, sum), "{link} {axis}: {value} {sum}");
                }
            }
        }
    }
}
