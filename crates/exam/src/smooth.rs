//! Shapes that no library of effects holds: random smooth functions of joint angles, of position and of time.
//!
//! A function is drawn, not chosen from a list: a sum of cosines whose frequencies come from a Student-t distribution (the
//! spectrum of a Matérn covariance of smoothness 5/2: Rahimi and Recht 2007; Rasmussen and Williams 2006, eq. 4.15), of random
//! length, of one, two or all inputs of a domain. It is as smooth as what warps, wanders and pulls on a real arm, and has no
//! form of its own that a diagnosis could know.

use super::rng::Rng;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// Cosines of one function.
const WAVES: usize = 24;
/// Degrees of freedom of the frequencies' Student-t distribution: twice the smoothness.
const SPECTRUM_FREEDOM: usize = 5;

/// What a random function depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Domain {
    /// The angle of one joint, from 1.
    JointAngle(usize),
    /// The angles of two joints, from 1.
    TwoJointAngles(usize, usize),
    /// The angles of all joints.
    AllJointAngles,
    /// Where the nominal arm's measured point stands in the base frame.
    Position,
    /// Minutes since the cold start.
    Time,
}

/// What a random function moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum MovedPart {
    /// One joint turns, from 1.
    Joint(usize),
    /// The measured point shifts in base axes, each axis by a function of its own.
    Point,
    /// The target shifts on the flange, each axis by a function of its own.
    Target,
}

/// A random smooth function, mean square about 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SmoothFunction {
    /// What it depends on.
    pub domain: Domain,
    /// What the function moves.
    pub moves: MovedPart,
    /// Distance over which it changes: radians, metres or minutes.
    pub length: f64,
    /// Seed of its cosines.
    pub seed: u64,
}

impl SmoothFunction {
    /// A function of a random domain for a run of `last_min` minutes.
    ///
    /// Lengths are a fraction of what the domain spans: longer ones are nearly straight lines, which gains, drifts and offsets
    /// of the library are.
    #[must_use]
    pub fn draw(rng: &mut Rng, last_min: f64) -> Self {
        let joint = 1 + rng.below(6);
        let other = |rng: &mut Rng, than: usize| 1 + (than + rng.below(5)) % 6;
        let (domain, moves, lengths) = match rng.below(6) {
            0 => (Domain::JointAngle(joint), MovedPart::Joint(joint), [0.2, 0.7]),
            1 => (Domain::JointAngle(joint), MovedPart::Joint(other(rng, joint)), [0.2, 0.7]),
            2 => {
                let second = other(rng, joint);
                (Domain::TwoJointAngles(joint, second), MovedPart::Joint(1 + rng.below(6)), [0.5, 1.5])
            }
            3 => (Domain::AllJointAngles, MovedPart::Target, [1.0, 2.5]),
            4 => (Domain::Position, MovedPart::Point, [0.1, 0.35]),
            _ if rng.chance(0.5) => (Domain::Time, MovedPart::Point, [0.08 * last_min, 0.3 * last_min]),
            _ => (Domain::Time, MovedPart::Joint(joint), [0.08 * last_min, 0.3 * last_min]),
        };
        let length = rng.log_uniform(lengths[0], lengths[1]);
        Self { domain, moves, length, seed: 0 }.reseeded(rng)
    }

    /// Another function of the same domain, target and length.
    #[must_use]
    pub fn reseeded(self, rng: &mut Rng) -> Self {
        // Within the integers that JSON readers keep exactly.
        Self { seed: rng.below(1 << 52) as u64, ..self }
    }

    /// Component `component` (0 to 2) of its value where the robot is at joints `q_rad`, its nominal point at `point_m`,
    /// `t_min` minutes after the cold start.
    #[must_use]
    pub fn value(&self, component: u64, q_rad: &[f64], point_m: &[f64; 3], t_min: f64) -> f64 {
        let at = self.inputs(q_rad, point_m, t_min);
        let mut rng = Rng::new(self.seed, component);
        let mut sum = 0.0;
        for _ in 0..WAVES {
            let spread: f64 = (0..SPECTRUM_FREEDOM).map(|_| rng.normal().powi(2)).sum();
            let heavy = (SPECTRUM_FREEDOM as f64 / spread).sqrt();
            let phase_rad: f64 = at.iter().map(|x| rng.normal() * heavy * x / self.length).sum();
            sum += (phase_rad + rng.uniform(0.0, TAU)).cos();
        }
        sum * (2.0 / WAVES as f64).sqrt()
    }

    fn inputs(&self, q_rad: &[f64], point_m: &[f64; 3], t_min: f64) -> Vec<f64> {
        match self.domain {
            Domain::JointAngle(joint) => vec![q_rad[joint - 1]],
            Domain::TwoJointAngles(a, b) => vec![q_rad[a - 1], q_rad[b - 1]],
            Domain::AllJointAngles => q_rad.to_vec(),
            Domain::Position => point_m.to_vec(),
            Domain::Time => vec![t_min],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Over many functions: mean 0, mean square 1, and, of neighbours at distance r, the Matérn correlation of smoothness
    /// 5/2, (1 + x + x²/3) e^-x with x = sqrt(5) r / length, which is written down here from the book.
    #[test]
    fn functions_have_the_moments_and_the_correlation_of_their_covariance() {
        const FUNCTIONS: u64 = 4000;
        let apart_rad = 0.4;
        let (mut sum, mut square, mut product) = (0.0, 0.0, 0.0);
        for seed in 0..FUNCTIONS {
            let function = SmoothFunction {
                domain: Domain::JointAngle(2),
                moves: MovedPart::Joint(2),
                length: 0.5,
                seed,
            };
            let at = |q2: f64| function.value(0, &[0.0, q2, 0.0, 0.0, 0.0, 0.0], &[0.0; 3], 0.0);
            let (here, there) = (at(0.3), at(0.3 + apart_rad));
            sum += here;
            square += here * here;
            product += here * there;
        }
        let n = FUNCTIONS as f64;
        let x = 5.0_f64.sqrt() * apart_rad / 0.5;
        let correlation = (1.0 + x + x * x / 3.0) * (-x).exp();
        // Four standard errors: 1/sqrt(n) of the mean, sqrt(2/n) of mean squares of nearly normal values.
        assert!((sum / n).abs() < 4.0 / n.sqrt(), "{}", sum / n);
        assert!((square / n - 1.0).abs() < 4.0 * (2.0 / n).sqrt(), "{}", square / n);
        assert!((product / n - correlation).abs() < 4.0 * (2.0 / n).sqrt(), "{} {correlation}", product / n);
    }

    #[test]
    fn the_same_seed_draws_the_same_functions_and_every_domain_comes() {
        let draw = |seed| SmoothFunction::draw(&mut Rng::new(seed, 0), 100.0);
        let all: Vec<SmoothFunction> = (0..200).map(draw).collect();
        assert_eq!(all, (0..200).map(draw).collect::<Vec<_>>());
        let comes = |wanted: fn(&Domain) -> bool| all.iter().any(|f| wanted(&f.domain));
        assert!(comes(|d| matches!(d, Domain::JointAngle(_))));
        assert!(comes(|d| matches!(d, Domain::TwoJointAngles(a, b) if a != b)));
        assert!(comes(|d| matches!(d, Domain::AllJointAngles)));
        assert!(comes(|d| matches!(d, Domain::Position)));
        assert!(comes(|d| matches!(d, Domain::Time)));
    }
}
