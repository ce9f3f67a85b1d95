//! The exam's mixture: how often which kind of question is asked, and of what size.

use super::effect::{Channel, Effect};
use super::gaps::Gaps;
use super::harmonics::{Harmonic, Harmonics};
use super::poses::{Recorded, Spread};
use super::recipe::{Recipe, RequestedEffect};
use super::rng::Rng;
use super::row_fault::RowFault;
use super::smooth::SmoothFunction;
use super::truth::QuestionKind;
use std::f64::consts::TAU;

/// A kind of question, drawn: one effect 50 %, two 15 %, none 15 %, outside the library 15 % (of which a third
/// is a missing channel), faults 5 %.
fn kind(rng: &mut Rng) -> QuestionKind {
    match rng.uniform(0.0, 1.0) {
        u if u < 0.50 => QuestionKind::One,
        u if u < 0.65 => QuestionKind::Two,
        u if u < 0.80 => QuestionKind::None,
        u if u < 0.90 => QuestionKind::Outside,
        u if u < 0.95 => QuestionKind::MissingChannel,
        _ => QuestionKind::Fault,
    }
}

fn unit6(rng: &mut Rng) -> [f64; 6] {
    let raw: [f64; 6] = std::array::from_fn(|_| rng.normal());
    let norm = raw.iter().map(|x| x * x).sum::<f64>().sqrt();
    raw.map(|x| x / norm)
}

/// Half of the lines of gears have harmonics: 10 to 20 % of the line at twice its frequency, and three in ten of these
/// [`THIRD`] of it at three times.
fn harmonics(rng: &mut Rng) -> Harmonics {
    if rng.chance(0.5) {
        return Harmonics::NONE;
    }
    let second = Harmonic { share: rng.uniform(0.1, 0.2), phase_rad: rng.uniform(0.0, TAU) };
    let has_third = rng.chance(0.3);
    let third = Harmonic { share: THIRD, phase_rad: rng.uniform(0.0, TAU) };
    Harmonics { second, third: if has_third { third } else { Harmonic::NONE } }
}

/// The share of a gear's line that its third harmonic has.
const THIRD: f64 = 0.05;

/// An effect of the library, none of those that lie wholly inside the registration.
#[must_use]
pub fn library_effect(rng: &mut Rng, last_min: f64) -> Effect {
    let joint = 1 + rng.below(6);
    let inner = 2 + rng.below(4);
    let phase_rad = rng.uniform(0.0, TAU);
    let t0_min = rng.uniform(0.25, 0.75) * last_min;
    match rng.below(19) {
        0 => Effect::JointOffset { joint: inner },
        1 => Effect::LinkGeometry { joint: inner, direction: unit6(rng) },
        2 | 3 => Effect::JointCompliance { joint: 2 + rng.below(5) },
        4 => Effect::LinkBending { joint: 1 + rng.below(4) },
        5 => Effect::BaseTilt,
        6 => Effect::GearEccentricity { joint, phase_rad, harmonics: harmonics(rng) },
        7 => Effect::GearSecondHarmonic { joint, phase_rad, harmonics: harmonics(rng) },
        8 => Effect::GearMesh { joint, n: 3 + rng.below(118) as u32, phase_rad, harmonics: harmonics(rng) },
        9 => Effect::JointGain { joint },
        10 => Effect::JointCoupling { joint: 4 + rng.below(2), joint_b: 6 },
        11 => Effect::Backlash { joint, holding_n_m: rng.log_uniform(2.0, 200.0) },
        12 => Effect::ThermalLinkGrowth { joint: 1 + rng.below(5) },
        13 => Effect::ThermalJointDrift { joint: 1 + rng.below(5) },
        14 => Effect::BaseDrift { direction: unit6(rng) },
        15 => Effect::BaseStep { t0_min, direction: unit6(rng) },
        16 => Effect::ToolStep { t0_min, direction: unit6(rng) },
        17 => Effect::JointStep { joint: inner, t0_min },
        _ if rng.chance(0.5) => Effect::ToolDrift { direction: unit6(rng) },
        _ => Effect::PayloadMass,
    }
}

/// The effects of a question of this kind, in a run of `last_min` minutes.
fn asked(kind: QuestionKind, last_min: f64, rng: &mut Rng) -> Vec<RequestedEffect> {
    let clear = |effect: Effect, rng: &mut Rng| RequestedEffect { effect, rho: rng.log_uniform(1.0, 5.0) };
    match kind {
        QuestionKind::One => {
            vec![RequestedEffect { effect: library_effect(rng, last_min), rho: rng.log_uniform(0.3, 5.0) }]
        }
        QuestionKind::Two => {
            let first = library_effect(rng, last_min);
            let second = loop {
                let other = library_effect(rng, last_min);
                if other.name() != first.name() {
                    break other;
                }
            };
            vec![clear(first, rng), clear(second, rng)]
        }
        QuestionKind::None => Vec::new(),
        QuestionKind::Outside => {
            let shape = Effect::SmoothFunction(SmoothFunction::draw(rng, last_min));
            vec![clear(shape, rng)]
        }
        QuestionKind::MissingChannel => {
            let effect = loop {
                let effect = library_effect(rng, last_min);
                if effect.channel().is_some() {
                    break effect;
                }
            };
            vec![clear(effect, rng)]
        }
        QuestionKind::Fault => {
            let effect = match rng.below(2 + RowFault::ALL.len()) {
                0 => Effect::JointRounding,
                1 => Effect::SwappedAxes,
                _ => row_fault(rng),
            };
            vec![RequestedEffect { effect, rho: 1.0 }]
        }
    }
}

/// A fault of rows or columns, from the second to the seventh tenth of the rows on where it is one of rows.
fn row_fault(rng: &mut Rng) -> Effect {
    let fault = RowFault::ALL[rng.below(RowFault::ALL.len())];
    Effect::RowFault { fault, from: rng.uniform(0.2, 0.7) }
}

/// In about a third of the sets one or two effects of the library stand beside those `asked`, under names of their own, of a
/// twentieth to a quarter of the noise: no arm has one thing wrong alone.
fn small(
    kind: QuestionKind,
    asked: &[RequestedEffect],
    last_min: f64,
    rng: &mut Rng,
) -> Vec<RequestedEffect> {
    let mut small: Vec<RequestedEffect> = Vec::new();
    let wanted = if rng.chance(0.35) { 1 + rng.below(2) } else { 0 };
    while small.len() < wanted {
        let (effect, rho) = (library_effect(rng, last_min), rng.log_uniform(0.05, 0.25));
        if asked.iter().chain(&small).all(|other| other.effect.name() != effect.name()) {
            small.push(RequestedEffect { effect, rho });
        }
    }
    if kind == QuestionKind::Fault { Vec::new() } else { small }
}

/// How much each row's noise is like the row's before: in two fifths of the sets without effect, a fifth of those of one or two
/// and a tenth of those outside the library it is slow.
fn slowness(kind: QuestionKind, rng: &mut Rng) -> f64 {
    let share = match kind {
        QuestionKind::None => 0.4,
        QuestionKind::One | QuestionKind::Two => 0.2,
        QuestionKind::Outside => 0.1,
        QuestionKind::MissingChannel | QuestionKind::Fault => 0.0,
    };
    if rng.chance(share) { rng.uniform(0.6, 0.95) } else { 0.0 }
}

/// In a twentieth of the sets a joint or a coordinate has no number in some rows.
fn gaps(kind: QuestionKind, rng: &mut Rng) -> Option<Gaps> {
    let wanted = rng.chance(0.05);
    let column = match rng.below(9) {
        axis @ 0..3 => ["x_mm", "y_mm", "z_mm"][axis].to_owned(),
        joint => format!("q{}_deg", joint - 2),
    };
    let (share, as_nan) = (rng.uniform(0.03, 0.15), rng.chance(0.5));
    // Within the integers that JSON readers keep exactly.
    let gaps = Gaps { column, share, as_nan, seed: rng.below(1 << 52) as u64 };
    (wanted && kind != QuestionKind::Fault).then_some(gaps)
}

/// What is recorded where these effects are at work: the column that a fault is of, too.
fn recorded_with(effects: &[RequestedEffect], all: Recorded) -> Recorded {
    let has = |wanted| {
        effects.iter().any(|asked| matches!(asked.effect, Effect::RowFault { fault, .. } if fault == wanted))
    };
    Recorded {
        temperature: all.temperature || has(RowFault::Fahrenheit),
        payload: all.payload || has(RowFault::Grams),
        ..all
    }
}

/// What is recorded where a channel is missing: without times no temperatures either.
fn without(channel: Channel, all: Recorded) -> Recorded {
    match channel {
        Channel::Direction => Recorded { direction: false, ..all },
        Channel::Time => Recorded { time: false, temperature: false, ..all },
        Channel::Payload => Recorded { payload: false, ..all },
    }
}

/// The recipe of data set number `number`, of at most `most_rows` rows.
#[must_use]
pub fn recipe(number: usize, most_rows: usize, rng: &mut Rng) -> Recipe {
    let kind = kind(rng);
    let n = [30, 60, 100, 150, 300][rng.below(5)].min(most_rows);
    let spread = match rng.below(10) {
        0..=5 => Spread::Wide,
        6 | 7 => Spread::Cube,
        8 => Spread::Narrow,
        _ => Spread::Sweeps,
    };
    let sigma_mm = rng.log_uniform(0.01, 0.05);
    let all = Recorded { temperature: rng.chance(0.5), orientation: rng.chance(0.3), ..Recorded::NOTED };
    let effects = asked(kind, n as f64, rng);
    let recorded = match (kind, effects.first().and_then(|asked| asked.effect.channel())) {
        (QuestionKind::MissingChannel, Some(channel)) => without(channel, all),
        _ => recorded_with(&effects, all),
    };
    let small = small(kind, &effects, n as f64, rng);
    let misstated = if kind == QuestionKind::None && rng.chance(0.3) { 1.0 / 1.4 } else { 1.0 };
    Recipe {
        name: format!("set_{number:04}"),
        kind,
        effects,
        small,
        n,
        repeats: if rng.chance(0.6) { n / 6 } else { 0 },
        sigma_mm,
        stated_sigma_mm: rng.chance(0.5).then_some(sigma_mm * misstated),
        spread,
        recorded,
        slowness: slowness(kind, rng),
        outliers: if rng.chance(0.15) { 0.04 } else { 0.0 },
        geometry: if rng.chance(0.5) { rng.uniform(0.1, 0.5) } else { 0.0 },
        payloads_kg: if rng.chance(0.5) { [0.0, 3.0] } else { [1.0, 1.0] },
        gaps: gaps(kind, rng),
    }
}

/// An effect of the weak class is this large against the noise, and measured in so many rows.
pub const WEAK_RHO: f64 = 0.5;
/// Rows of a set of the weak class.
pub const WEAK_ROWS: usize = 30;

/// The recipe of one weak effect: the mixture's questions of one effect, at half the noise in 30 rows, in white noise and with
/// nothing beside it but geometry: the bound that it is held against knows no more.
#[must_use]
pub fn weak_recipe(number: usize, rng: &mut Rng) -> Recipe {
    loop {
        let mut recipe = recipe(number, WEAK_ROWS, rng);
        if recipe.kind == QuestionKind::One {
            recipe.effects.iter_mut().for_each(|asked| asked.rho = WEAK_RHO);
            return Recipe { small: Vec::new(), slowness: 0.0, gaps: None, ..recipe };
        }
    }
}

/// The recipe of one accident: half a joint's zero that jumps, half a fault of rows or of one column; all else as the
/// mixture draws it.
#[must_use]
pub fn accident_recipe(number: usize, most_rows: usize, rng: &mut Rng) -> Recipe {
    loop {
        let mut recipe = recipe(number, most_rows, rng);
        if recipe.kind != QuestionKind::One {
            continue;
        }
        let Some(RequestedEffect { rho, .. }) = recipe.effects.pop() else { continue };
        let accident = if rng.chance(0.5) {
            let t0_min = rng.uniform(0.25, 0.75) * recipe.n as f64;
            RequestedEffect { effect: Effect::JointStep { joint: 2 + rng.below(4), t0_min }, rho }
        } else {
            recipe.kind = QuestionKind::Fault;
            (recipe.small, recipe.slowness, recipe.gaps) = (Vec::new(), 0.0, None);
            RequestedEffect { effect: row_fault(rng), rho: 1.0 }
        };
        recipe.small.retain(|small| small.effect.name() != accident.effect.name());
        recipe.effects.push(accident);
        recipe.recorded = recorded_with(&recipe.effects, recipe.recorded);
        return recipe;
    }
}

#[cfg(test)]
mod tests;
