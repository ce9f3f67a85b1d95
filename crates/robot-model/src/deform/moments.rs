//! The deformed arm at several moments, solved for all of them at a time.

use super::arm::{Conditions, DeformedArm};
use crate::kinematics::{ArmsJoints, Chains, FlangePoints, SolveError, Solved, solve};
use nalgebra::{Isometry3, Vector3};

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

    /// Calls `visit` for each moment with where a point of the flange's frame stands in the base, metres, `q_rad` being the
    /// commanded joints: what [`ArmUnder::point_m`](super::ArmUnder::point_m) answers for it, to the bit.
    pub fn points_m(
        &self,
        conditions: &Conditions,
        q_rad: ArmsJoints<'_>,
        on_flange_m: &Vector3<f64>,
        mut visit: impl FnMut(Vector3<f64>),
    ) {
        match &self.chains {
            Some(chains) => chains.points_m(q_rad, on_flange_m, visit),
            None => {
                for (k, arm) in self.arms.iter().enumerate() {
                    visit(arm.under(conditions).point_m(q_rad.of(k), on_flange_m));
                }
            }
        }
    }
}

impl DeformedArm {
    /// Calls `visit` for each pose in its order with the joints at which the arm stands there, on the branch of those beside it:
    /// what [`solve`] answers, to the bit. `conditions` are those of each pose, none standing for the default.
    pub fn solve_each_from(
        &self,
        poses: &[(Isometry3<f64>, [f64; 6])],
        conditions: &[Conditions],
        mut visit: impl FnMut(Result<Solved, SolveError>),
    ) {
        if let Some(chain) = self.constant() {
            return chain.solve_each_from(poses, visit);
        }
        let plain = Conditions::default();
        for (k, (base_from_flange, start_q_rad)) in poses.iter().enumerate() {
            let under = self.under(conditions.get(k).unwrap_or(&plain));
            visit(solve(&under, base_from_flange, start_q_rad));
        }
    }

    /// Calls `visit` for each of these joints in their order with `base_from_flange`; `conditions` are those of each, none standing
    /// for the default: what [`ArmUnder::forward`](super::ArmUnder::forward) answers for it, to the bit.
    pub fn forward_each(
        &self,
        q_rad: &[[f64; 6]],
        conditions: &[Conditions],
        mut visit: impl FnMut(Isometry3<f64>),
    ) {
        if let Some(chain) = self.constant() {
            return chain.forward_each(q_rad, visit);
        }
        let plain = Conditions::default();
        for (k, q_rad) in q_rad.iter().enumerate() {
            visit(self.under(conditions.get(k).unwrap_or(&plain)).forward(q_rad));
        }
    }

    /// Calls `visit` for each point with where it stands in the base, metres; `conditions` are those of each, none standing for
    /// the default: what [`ArmUnder::point_m`](super::ArmUnder::point_m) answers for it, to the bit.
    pub fn points_m(
        &self,
        points: &FlangePoints,
        conditions: &[Conditions],
        mut visit: impl FnMut(Vector3<f64>),
    ) {
        if let Some(chain) = self.constant() {
            return chain.points_m(points, visit);
        }
        let plain = Conditions::default();
        for (k, (q_rad, on_flange_m)) in points.as_slice().iter().enumerate() {
            visit(self.under(conditions.get(k).unwrap_or(&plain)).point_m(q_rad, on_flange_m));
        }
    }
}
