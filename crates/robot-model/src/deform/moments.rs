//! The deformed arm at several moments, solved for all of them at a time.

use super::arm::{Conditions, DeformedArm};
use crate::kinematics::{Chains, SolveError, Solved, solve};
use nalgebra::Isometry3;

/// An arm at several moments.
#[derive(Clone, Debug)]
pub struct DeformedArms {
    arms: Vec<DeformedArm>,
    /// Their frames, where these move with the moment alone.
    chains: Option<Chains>,
}

impl DeformedArms {
    /// In the order of their moments.
    #[must_use]
    pub fn new(arms: Vec<DeformedArm>) -> Self {
        let chains: Option<Vec<_>> = arms.iter().map(|arm| arm.constant().cloned()).collect();
        Self { chains: chains.map(Chains::new), arms }
    }

    /// The arm at each moment.
    #[must_use]
    pub fn as_slice(&self) -> &[DeformedArm] {
        &self.arms
    }

    /// For each moment the joints at which the arm stands in `base_from_flange`, on the branch of `start_q_rad`: what
    /// [`solve`] answers for it, to the bit.
    #[must_use]
    pub fn solve(
        &self,
        conditions: &Conditions,
        base_from_flange: &Isometry3<f64>,
        start_q_rad: &[f64; 6],
    ) -> Vec<Result<Solved, SolveError>> {
        let mut found = Vec::with_capacity(self.arms.len());
        match &self.chains {
            Some(chains) => chains.solve(base_from_flange, start_q_rad, |solved| found.push(solved)),
            None => found.extend(
                self.arms.iter().map(|arm| solve(&arm.under(conditions), base_from_flange, start_q_rad)),
            ),
        }
        found
    }
}
