//! Scatter between two states that nothing in the file tells apart: a joint now on one side of its play and now on the other, a load
//! that hangs there at some rows and not at others and under which a joint or the base gives, a target or a base that stands now here and
//! now there. Which of these it is says which channel is missing.
//!
//! Of each station the state is unknown, either as likely as the other: e = c v + s h v + noise with s = -1 or 1, of which the sum over
//! both is exp(-(e - c v)^2 / 2 sigma^2 - h^2 v^2 / 2 sigma^2) cosh(h v (e - c v) / sigma^2). Held against s of a normal distribution, which
//! is noise that is larger along one motion, as an instrument's is.

use crate::diagnose::model::FittedModel;
use inference::dataset::{Observation, Twist};
use inference::effects::{RigidBody, base_tilt_per_kg, give_per_kg};
use inference::marginal::{Marginal, NoiseIntegral};
use nalgebra::Vector3;
use robot_model::robot::Axis;
use statistics::log_sum;

/// Half distances of the two states that are tried: of a joint, radians or metres, of a load, kilograms of usual compliance, of a body
/// metres.
const SIZES: std::ops::Range<i32> = 0..16;
const SMALLEST_TURN: f64 = 4e-6;
const SMALLEST_LOAD_KG: f64 = 0.05;
const SMALLEST_SHIFT_M: f64 = 4e-6;
/// Each size over the one before it.
const STEP: f64 = 1.6;
/// Rounds until the noise and the states fit each other.
const ROUNDS: usize = 12;
/// Fewer stations than this say nothing of how they are spread.
const FEWEST: usize = 12;

/// What is in two states.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum State {
    /// On which side of its play a joint lies.
    Side(Axis),
    /// What hangs at the tool: a joint of the arm gives under it.
    Load(Axis),
    /// What hangs at the tool: the base tilts under it.
    LoadOnBase,
    /// Where a body lies, along a direction (unit vector) of its own axes: a mount with play, a target of which there are two.
    Place(RigidBody, Vector3<f64>),
}

/// Scatter between two states.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TwoStates {
    /// What is in two states.
    pub state: State,
    /// From one state to the other: radians, metres of what slides or is shifted, kilograms of usual compliance.
    pub distance: f64,
    /// ln evidence over noise alone, larger noise than stated among it, of all that could be in two states, nats.
    pub gain_nats: f64,
    /// The same of noise that is larger along one axis of the base or the target, in the place of two states.
    pub scattered_nats: f64,
    /// The noise beside them, metres.
    pub sigma_m: f64,
}

/// How what moves is spread about its middle.
#[derive(Clone, Copy, Debug)]
enum Spread {
    /// On either side at one distance, as what is loose and tips over.
    TwoStates,
    /// Most near the middle, as what moves by many causes.
    Normal,
}

/// What a station says of its own place, in units of the half distance.
struct Placed {
    mean: f64,
    /// Mean of the square.
    square: f64,
    /// What it costs to say so, nats.
    price: f64,
}

/// What one station says of two states, by its weight.
#[derive(Clone, Copy, Debug)]
struct Along {
    /// Its residual times the motion from the middle to one state.
    seen: f64,
    /// Square of that motion.
    motion: f64,
}

/// Two states at one distance.
#[derive(Clone, Copy, Debug)]
struct Weighed {
    /// ln evidence over noise alone, nats.
    gain_nats: f64,
    /// Half the distance that fits the stations best, each at its expected state.
    fitted_half: f64,
    /// The noise beside it, metres.
    sigma_m: f64,
}

/// The noise that states are held against.
struct Plain {
    marginal: Marginal,
    /// Of all residuals, by weight.
    squares: f64,
    /// ln evidence of noise alone.
    log: f64,
    sigma_m: f64,
    /// Share of the rows that the model has not used up.
    free: f64,
}

/// Scatter of `residuals` between two states, of which the missing direction or payload would tell; `used` parameters are fitted.
#[must_use]
pub(super) fn two_states(fitted: &FittedModel<'_>, residuals: &[Twist], used: f64) -> Option<TwoStates> {
    let FittedModel { model, linear, .. } = fitted;
    let dataset = &linear.dataset;
    let kept: Vec<usize> = (0..residuals.len()).filter(|&i| !model.outliers[i]).collect();
    let rows = kept.iter().map(|&i| dataset.observations[i].rows(3)).sum::<usize>() as f64;
    let left = rows - used;
    if kept.len() < FEWEST || left < 0.3 * rows {
        return None;
    }
    let weight = |i: usize| model.base_weights[i];
    let squares: f64 = kept.iter().map(|&i| weight(i) * product(&residuals[i], &residuals[i])).sum();
    let marginal = model.noise.marginal_over(left);
    let NoiseIntegral { log, sigma_m } = marginal.at(squares);
    let plain = Plain { marginal, squares, log, sigma_m, free: left / rows };
    let joints = || (0..dataset.joints()).map(Axis::at);
    let sides = joints().filter(|_| !dataset.channels.direction).map(State::Side);
    let loads = joints().map(State::Load).chain([State::LoadOnBase]).filter(|_| !dataset.channels.payload);
    let bodies = [RigidBody::Tool, RigidBody::Base].into_iter();
    let places = bodies.flat_map(|body| directions().map(move |along| State::Place(body, along)));
    let mut tried = Vec::new();
    for state in sides.chain(loads).chain(places) {
        let motions = kept.iter().map(|&i| (i, state.motion(&dataset.observations[i])));
        let along = motions.map(|(i, motion)| Along {
            seen: weight(i) * product(&motion, &residuals[i]),
            motion: weight(i) * product(&motion, &motion),
        });
        let along = about_their_mean(along.collect());
        tried.extend(SIZES.map(|k| {
            let half = state.smallest() * STEP.powi(k);
            let Weighed { gain_nats, fitted_half, sigma_m } = plain.weigh(&along, half, Spread::TwoStates);
            // What scatters along a joint's motion, or as under a load, is one that stands or hangs differently; along an axis it is noise.
            let scattered_nats = match state {
                State::Place(..) => plain.weigh(&along, half, Spread::Normal).gain_nats,
                State::Side(_) | State::Load(_) | State::LoadOnBase => f64::NEG_INFINITY,
            };
            TwoStates { state, distance: 2.0 * fitted_half, gain_nats, scattered_nats, sigma_m }
        }));
    }
    let best = tried.iter().copied().reduce(|a, b| if b.gain_nats > a.gain_nats { b } else { a })?;
    let all = |of: fn(&TwoStates) -> f64| log_sum(tried.iter().map(of)) - (tried.len() as f64).ln();
    let (gain_nats, scattered_nats) = (all(|one| one.gain_nats), all(|one| one.scattered_nats));
    Some(TwoStates { gain_nats, scattered_nats, ..best })
}

impl State {
    /// How far the point moves at `observation` for one unit, as it is observed.
    fn motion(self, observation: &Observation) -> Twist {
        observation.observed(match self {
            Self::Side(axis) => observation.jacobian_column(axis.index()),
            Self::Load(axis) => give_per_kg(observation, axis.index()..axis.index() + 1),
            Self::LoadOnBase => base_tilt_per_kg(observation),
            Self::Place(body, along) => body.shift(observation, &along),
        })
    }

    /// Smallest half distance that is tried.
    fn smallest(self) -> f64 {
        match self {
            Self::Side(_) => SMALLEST_TURN,
            Self::Load(_) | Self::LoadOnBase => SMALLEST_LOAD_KG,
            Self::Place(..) => SMALLEST_SHIFT_M,
        }
    }
}

impl Plain {
    /// ln evidence over noise alone of what is `spread` by `half` to either side, held from below: each station at its expected place, less
    /// what it costs to say so (Jordan, Ghahramani, Jaakkola, Saul 1999, eq. 6).
    fn weigh(&self, along: &[Along], half: f64, spread: Spread) -> Weighed {
        let mut integral = NoiseIntegral { log: self.log, sigma_m: self.sigma_m };
        let mut weighed = Weighed { gain_nats: f64::NEG_INFINITY, fitted_half: half, sigma_m: self.sigma_m };
        for _ in 0..ROUNDS {
            let variance = integral.sigma_m.powi(2);
            let (mut taken, mut apart, mut price) = (0.0, 0.0, 0.0);
            for a in along {
                let placed = spread.placed(half * a.seen / variance, half * half * a.motion / variance);
                taken += half * a.seen * placed.mean;
                apart += half * half * a.motion * placed.square;
                price += placed.price;
            }
            // Parameters took their share of the distances.
            let squares = self.squares + self.free * apart - 2.0 * taken;
            integral = self.marginal.at(squares.max(1e-3 * self.squares));
            let fitted_half = half * taken / apart.max(1e-300);
            let gain_nats = integral.log - self.log - price;
            weighed = Weighed { gain_nats, fitted_half, sigma_m: integral.sigma_m };
        }
        weighed
    }
}

/// Axes, and halfway between two and between three of them: no direction is more than 28 deg from one of these.
fn directions() -> impl Iterator<Item = Vector3<f64>> {
    let steps = || [-1.0, 0.0, 1.0].into_iter();
    let all =
        steps().flat_map(move |x| steps().flat_map(move |y| steps().map(move |z| Vector3::new(x, y, z))));
    // Of two that are opposite the one whose first number that is not 0 is positive.
    all.filter(|v| v.iter().find(|&&c| c != 0.0).is_some_and(|&c| c > 0.0)).map(|v| v.normalize())
}

impl Spread {
    /// Where a station lies that sees `seen` of what moves by `motion`, both over the noise.
    fn placed(self, seen: f64, motion: f64) -> Placed {
        match self {
            Self::TwoStates => {
                let mean = seen.tanh();
                Placed { mean, square: 1.0, price: seen * mean - ln_cosh(seen) }
            }
            Self::Normal => {
                let variance = 1.0 / (1.0 + motion);
                let mean = variance * seen;
                let square = mean * mean + variance;
                Placed { mean, square, price: 0.5 * (square - 1.0 - variance.ln()) }
            }
        }
    }
}

/// The stations about the middle of the two states.
fn about_their_mean(along: Vec<Along>) -> Vec<Along> {
    let seen: f64 = along.iter().map(|a| a.seen).sum();
    let middle = seen / along.iter().map(|a| a.motion).sum::<f64>().max(1e-300);
    along.into_iter().map(|a| Along { seen: a.seen - middle * a.motion, ..a }).collect()
}

fn ln_cosh(x: f64) -> f64 {
    x.abs() + (-2.0 * x.abs()).exp().ln_1p() - std::f64::consts::LN_2
}

/// Of the points' shifts.
fn product(a: &Twist, b: &Twist) -> f64 {
    (0..3).map(|axis| a[axis] * b[axis]).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use inference::marginal::NoisePrior;

    const LEVER_M: f64 = 0.5;
    const HALF_RAD: f64 = 2e-4;

    fn side(i: usize) -> f64 {
        if i * 7919 % 13 < 6 { -1.0 } else { 1.0 }
    }

    /// 60 stations `half_rad` to either side, of levers of 0.5 m in noise of `sigma_m` in each coordinate, and noise alone of all of it.
    fn stations(half_rad: f64, sigma_m: f64) -> (Vec<Along>, Plain) {
        let share = |k: usize| ((k as f64 * 12.9898).sin() * 43_758.547).rem_euclid(1.0);
        // Twelve even numbers from 0 to 1: mean 6, variance 1.
        let noise_m = |k: usize| sigma_m * ((1..=12).map(|n| share(12 * k + n)).sum::<f64>() - 6.0);
        let along_m = |i: usize| LEVER_M * half_rad * side(i) + noise_m(3 * i);
        let square = |i| along_m(i).powi(2) + noise_m(3 * i + 1).powi(2) + noise_m(3 * i + 2).powi(2);
        let along = |i| Along { seen: LEVER_M * along_m(i), motion: LEVER_M * LEVER_M };
        let squares = (0..60).map(square).sum();
        let marginal =
            NoisePrior { known: None, from_repeats: false, stated_more_m: None }.marginal_over(180.0);
        let NoiseIntegral { log, sigma_m } = marginal.at(squares);
        let plain = Plain { marginal, squares, log, sigma_m, free: 1.0 };
        (about_their_mean((0..60).map(along).collect()), plain)
    }

    /// Each five times the noise from the middle: 60 of 180 squares are 25 times the noise's larger.
    #[test]
    fn a_gap_is_told_with_its_size() {
        let (along, plain) = stations(HALF_RAD, 2e-5);
        let Weighed { gain_nats, fitted_half, sigma_m } = plain.weigh(&along, HALF_RAD, Spread::TwoStates);
        assert!((sigma_m - 2e-5).abs() < 0.2 * 2e-5, "{sigma_m}");
        assert!((fitted_half - HALF_RAD).abs() < 0.05 * HALF_RAD, "{fitted_half}");
        // ln of how much larger noise alone is, for each row, less ln 2 for each side.
        let by_hand = 90.0 * ((180.0 + 25.0 * 60.0) / 180.0_f64).ln() - 60.0 * 2.0_f64.ln();
        assert!((gain_nats - by_hand).abs() < 0.1 * by_hand, "{gain_nats} {by_hand}");
        // Normally spread, each station costs half of ln (1 + 25) in place of ln 2, and that its place is on no side but about it.
        let scattered = plain.weigh(&along, HALF_RAD, Spread::Normal).gain_nats;
        assert!(scattered < gain_nats - 20.0 && scattered > 0.3 * gain_nats, "{scattered} {gain_nats}");
    }

    /// Of noise alone, and of a gap under it, no distance gains what an alarm asks.
    #[test]
    fn sides_that_are_not_there_cost_what_they_gain() {
        for half_rad in [0.0, 2e-5] {
            let (along, plain) = stations(half_rad, 2e-5);
            for k in SIZES {
                let half = SMALLEST_TURN * STEP.powi(k);
                let Weighed { gain_nats, .. } = plain.weigh(&along, half, Spread::TwoStates);
                assert!(gain_nats < 1.0, "{half_rad} {half} {gain_nats}");
            }
        }
    }
}
