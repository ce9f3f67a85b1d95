//! A link bends under what hangs beyond it.

use super::effect::{Candidate, Effect, EffectVariant};
use super::rigid::{LEVER_M, MASS_ERROR, SHORTEST_LINK_M, sag_per_load};
use crate::dataset::{DataPoint, Dataset, Observation, Twist};
use crate::size_unit::SizeUnit;
use robot_model::deform::EffectKind;
use robot_model::deform::gravity::{BeamDeflection, Wrench};
use robot_model::robot::Axis;

/// The frame after link i turns and sinks as the end of a cantilever under end moment and end force; it may give
/// more at one end than at the other, or bend by the end moment alone; each link's share of the load may be wrong, and the
/// payload's centre elsewhere.
pub(super) struct LinkBending;

/// How far a link's end usually turns under the largest load of the measurement, radians: a third of a joint's sag.
const BEND_RAD: f64 = 1.5e-4;

/// How far the shares of an uneven cantilever usually lie from those of an even one: a hinge at its tip is at
/// -1/2, -1/2, -1/3, one at its root at 1/2, 1/2, 2/3.
const UNEVEN: f64 = 0.3;

/// Share of the links that bend by the moment at their end alone: the part that gives is short against the lever of what hangs
/// beyond it, or lies in the bearing at its end.
const BY_MOMENT: f64 = 0.3;

/// A joint whose axis is at no larger angle to the link after it than this, radians, turns along the link.
const ALONG_RAD: f64 = 0.05;

/// Whether joint `i` (from 0) and the next stand apart.
fn is_beam(dataset: &Dataset, i: usize) -> bool {
    dataset.of_arm().next().is_some_and(|o| (o.origins_m[i + 1] - o.origins_m[i]).norm() > SHORTEST_LINK_M)
}

/// The link before `link`, where the joint between them turns along `link`: both are one beam then, for where along its own axis a joint
/// stands is in no kinematics, and a forearm of which one robot file makes link 4 is link 3 in another.
#[must_use]
pub fn one_beam_with(dataset: &Dataset, link: Axis) -> Option<Axis> {
    let i = link.index();
    let observation = dataset.of_arm().next()?;
    let before = i.checked_sub(1)?;
    let along_m = observation.origins_m[i + 1] - observation.origins_m[i];
    let turns_along = observation.axes[i].cross(&along_m).norm() <= ALONG_RAD.sin() * along_m.norm();
    (turns_along && is_beam(dataset, i) && !dataset.slides[i]).then(|| Axis::at(before))
}

impl Effect for LinkBending {
    fn kind(&self) -> EffectKind {
        EffectKind::LinkBending
    }
    fn unit(&self) -> SizeUnit {
        SizeUnit::RadianPerNewtonMetre
    }
    fn usual_size(&self) -> &'static str {
        "5 to 30 % of the joints' sag"
    }
    /// Springs under one load take each other back where the poses do not tell them apart: each may be further off than all of them.
    fn furthest_sigmas(&self) -> f64 {
        300.0
    }
    fn source(&self) -> &'static str {
        "Euler-Bernoulli cantilever; Khalil and Besnard 2002"
    }
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate> {
        let joints = dataset.joints();
        (0..joints - 1)
            // Where a joint at its root or tip slides, how much of the link is a beam changes: left to geometry.
            .filter(|&i| !dataset.slides[i] && !dataset.slides[i + 1])
            .filter(|&i| is_beam(dataset, i))
            .flat_map(|i| {
                let slope_n_m = |o: &Observation| {
                    let [even, ..] = o.loads.beyond[i + 1].bend(&o.origins_m[i], &o.origins_m[i + 1]);
                    even.slope_n_m.norm()
                };
                let largest_n_m = dataset.observations.iter().map(slope_n_m).fold(0.0, f64::max);
                let prior_sigma = sag_per_load(BEND_RAD, largest_n_m);
                let mut sizes = vec![prior_sigma, UNEVEN * prior_sigma];
                sizes.extend(std::iter::repeat_n(MASS_ERROR * prior_sigma, joints - 1 - i));
                if dataset.largest_payload_kg > 0.0 {
                    sizes.extend([LEVER_M * prior_sigma; 3]);
                }
                // It stands for the link before it too, where that has no length of its own.
                let before =
                    one_beam_with(dataset, Axis::at(i)).filter(|before| !is_beam(dataset, before.index()));
                let links = if before.is_some() { 2.0 } else { 1.0 };
                [(false, 1.0 - BY_MOMENT), (true, BY_MOMENT)].map(|(refined, weight)| Candidate {
                    sign_constrained: true,
                    n_reported: 1,
                    weight: links * weight,
                    ..Candidate::new(
                        EffectKind::LinkBending,
                        EffectVariant { refined, ..EffectVariant::of_joint(i) },
                        sizes.clone(),
                    )
                })
            })
            .collect()
    }
    fn signature(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<Twist>) {
        let observation = at.observation;
        let i = variant.joint.map_or(0, Axis::index).min(observation.joints() - 2);
        let (from_m, to_m) = (observation.origins_m[i], observation.origins_m[i + 1]);
        let moved = |bend: &BeamDeflection| {
            let mut twist = observation.rotation_about(&bend.slope_n_m, &to_m);
            twist.iter_mut().zip(bend.deflection_m_n_m.iter()).for_each(|(to, deflection)| *to += deflection);
            twist
        };
        let [even, uneven, force] = observation.loads.beyond[i + 1].bend(&from_m, &to_m);
        let mut plain = moved(&even);
        if variant.refined {
            plain.iter_mut().zip(moved(&force)).for_each(|(to, by)| *to -= by);
        }
        out.extend([plain, moved(&uneven)]);
        for link in &observation.loads.link_beyond[i + 1][i + 1..observation.joints()] {
            let [even, ..] = link.bend(&from_m, &to_m);
            out.push(moved(&even));
        }
        if at.dataset.largest_payload_kg > 0.0 {
            let payload_kg = observation.payload_kg.unwrap_or(0.0);
            out.extend(observation.loads.unit_lever_moment_n.map(|moment_n| {
                let further = Wrench { moment_n_m: moment_n * payload_kg, weight_n: 0.0 };
                let [even, ..] = further.bend(&from_m, &to_m);
                moved(&even)
            }));
        }
    }
}
