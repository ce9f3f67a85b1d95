//! The exam's mixture: how often which kind of question is asked, and of what size.

use super::draw::Draw;
use super::effect::{Channel, Effect};
use super::generate::Recipe;
use super::poses::{Recorded, Spread};
use super::truth::Kind;
use std::f64::consts::TAU;

/// A kind of question, drawn: one effect 50 %, two 15 %, none 15 %, outside the library 15 % (of which a third
/// is a missing channel), faults 5 %.
fn kind(draw: &mut Draw) -> Kind {
    match draw.uniform(0.0, 1.0) {
        u if u < 0.50 => Kind::One,
        u if u < 0.65 => Kind::Two,
        u if u < 0.80 => Kind::None,
        u if u < 0.90 => Kind::Outside,
        u if u < 0.95 => Kind::MissingChannel,
        _ => Kind::Fault,
    }
}

fn unit6(draw: &mut Draw) -> [f64; 6] {
    let raw: [f64; 6] = std::array::from_fn(|_| draw.normal());
    let norm = raw.iter().map(|x| x * x).sum::<f64>().sqrt();
    raw.map(|x| x / norm)
}

fn unit3(draw: &mut Draw) -> [f64; 3] {
    let [x, y, z] = draw.normal3();
    let norm = (x * x + y * y + z * z).sqrt();
    [x / norm, y / norm, z / norm]
}

/// An effect of the library, none of those that lie wholly inside the registration.
#[must_use]
pub fn library_effect(draw: &mut Draw, last_min: f64) -> Effect {
    let joint = 1 + draw.below(6);
    let inner = 2 + draw.below(4);
    let phase_rad = draw.uniform(0.0, TAU);
    let t0_min = draw.uniform(0.25, 0.75) * last_min;
    match draw.below(18) {
        0 => Effect::JointOffset { joint: inner },
        1 => Effect::LinkGeometry { joint: inner, direction: unit6(draw) },
        2 | 3 => Effect::JointCompliance { joint: 2 + draw.below(5) },
        4 => Effect::LinkBending { joint: 1 + draw.below(4) },
        5 => Effect::BaseTilt,
        6 => Effect::GearEccentricity { joint, phase_rad },
        7 => Effect::GearSecondHarmonic { joint, phase_rad },
        8 => Effect::GearMesh { joint, n: 3 + draw.below(118) as u32, phase_rad },
        9 => Effect::JointGain { joint },
        10 => Effect::JointCoupling { joint: 4 + draw.below(2), joint_b: 6 },
        11 => Effect::Backlash { joint, holding_n_m: draw.log_uniform(2.0, 200.0) },
        12 => Effect::ThermalLinkGrowth { joint: 1 + draw.below(5) },
        13 => Effect::ThermalJointDrift { joint: 1 + draw.below(5) },
        14 => Effect::BaseDrift { direction: unit6(draw) },
        15 => Effect::BaseStep { t0_min, direction: unit6(draw) },
        16 => Effect::ToolStep { t0_min, direction: unit6(draw) },
        _ if draw.chance(0.5) => Effect::ToolDrift { direction: unit6(draw) },
        _ => Effect::PayloadMass,
    }
}

fn outside_effect(draw: &mut Draw) -> Effect {
    let joint = 1 + draw.below(5);
    match draw.below(4) {
        0 => Effect::SquareWave { joint, n: 2 + draw.below(5) as u32, phase_rad: draw.uniform(0.0, TAU) },
        1 => Effect::CablePull { direction: unit3(draw) },
        2 => Effect::LocalBump { center_m: [0.5, 0.1, 0.4], radius_m: 0.18, direction: unit3(draw) },
        _ => Effect::CrossTerm { joint, a: 1 + draw.below(5), b: 1 + draw.below(5) },
    }
}

/// The recipe of data set number `number`, of at most `most_rows` rows.
#[must_use]
pub fn recipe(number: usize, most_rows: usize, draw: &mut Draw) -> Recipe {
    let kind = kind(draw);
    let n = [30, 60, 100, 150, 300][draw.below(5)].min(most_rows);
    let spread = match draw.below(10) {
        0..=5 => Spread::Wide,
        6 | 7 => Spread::Cube,
        8 => Spread::Narrow,
        _ => Spread::Sweeps,
    };
    let sigma_mm = draw.log_uniform(0.01, 0.05);
    let all = Recorded { temperature: draw.chance(0.5), orientation: draw.chance(0.3), ..Recorded::NOTED };
    let rho = |draw: &mut Draw| draw.log_uniform(0.3, 5.0);
    let last_min = n as f64;
    let mut recorded = all;
    let mut effects = Vec::new();
    match kind {
        Kind::One => effects.push((library_effect(draw, last_min), rho(draw))),
        Kind::Two => {
            let first = library_effect(draw, last_min);
            let second = loop {
                let other = library_effect(draw, last_min);
                if other.name() != first.name() {
                    break other;
                }
            };
            effects.push((first, draw.log_uniform(1.0, 5.0)));
            effects.push((second, draw.log_uniform(1.0, 5.0)));
        }
        Kind::None => {}
        Kind::Outside => effects.push((outside_effect(draw), draw.log_uniform(1.0, 5.0))),
        Kind::MissingChannel => {
            let effect = loop {
                let effect = library_effect(draw, last_min);
                if effect.channel().is_some() {
                    break effect;
                }
            };
            match effect.channel() {
                Some(Channel::Direction) => recorded.direction = false,
                Some(Channel::Time) => (recorded.time, recorded.temperature) = (false, false),
                Some(Channel::Payload) | None => recorded.payload = false,
            }
            effects.push((effect, draw.log_uniform(1.0, 5.0)));
        }
        Kind::Fault => {
            let fault = if draw.chance(0.5) { Effect::JointRounding } else { Effect::SwappedAxes };
            effects.push((fault, 1.0));
        }
    }
    let misstated = if kind == Kind::None && draw.chance(0.3) { 1.0 / 1.4 } else { 1.0 };
    Recipe {
        name: format!("set_{number:04}"),
        kind,
        effects,
        n,
        repeats: if draw.chance(0.6) { n / 6 } else { 0 },
        sigma_mm,
        stated_sigma_mm: draw.chance(0.5).then_some(sigma_mm * misstated),
        spread,
        recorded,
        slowness: if kind == Kind::None && draw.chance(0.4) { draw.uniform(0.6, 0.95) } else { 0.0 },
        outliers: if draw.chance(0.15) { 0.04 } else { 0.0 },
        geometry: if draw.chance(0.5) { draw.uniform(0.1, 0.5) } else { 0.0 },
        payloads_kg: if draw.chance(0.5) { [0.0, 3.0] } else { [1.0, 1.0] },
    }
}

/// An effect of the weak class is this large against the noise, and measured in so many rows.
pub const WEAK_RHO: f64 = 0.5;
/// See [`WEAK_RHO`].
pub const WEAK_ROWS: usize = 30;

/// The recipe of one weak effect: the mixture's questions of one effect, at half the noise in 30 rows.
#[must_use]
pub fn weak_recipe(number: usize, draw: &mut Draw) -> Recipe {
    loop {
        let mut recipe = recipe(number, WEAK_ROWS, draw);
        if recipe.kind == Kind::One {
            recipe.effects.iter_mut().for_each(|(_, rho)| *rho = WEAK_RHO);
            return recipe;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_weak_question_is_one_effect_of_half_the_noise_in_thirty_rows() {
        let spreads: Vec<Spread> = (0..40)
            .map(|number| {
                let recipe = weak_recipe(number, &mut Draw::new(8, number as u64));
                assert_eq!((recipe.kind, recipe.n, recipe.effects.len()), (Kind::One, 30, 1));
                assert_eq!(recipe.effects[0].1, 0.5);
                assert!(recipe.repeats <= 5);
                recipe.spread
            })
            .collect();
        assert!(spreads.contains(&Spread::Wide) && spreads.contains(&Spread::Cube), "{spreads:?}");
    }
}
