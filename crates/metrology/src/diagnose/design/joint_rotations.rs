//! Candidates that only turn one joint, by the thousand: their products come by matrix products.

use super::matrix::Design;
use super::products::Products;
use crate::diagnose::dataset::Dataset;
use crate::diagnose::effects::Candidate;
use nalgebra::DMatrix;
use rayon::prelude::*;

/// Candidates that only turn one joint: there are many, and their products come by matrix products.
#[derive(Clone, Debug)]
pub struct Turning {
    joint: usize,
    /// Indices into the candidates.
    pub members: Vec<usize>,
    /// Angles per prior sigma: two rows for each member, a column for each observation in the order of groups.
    angles: DMatrix<f64>,
}

impl Design {
    /// Angles of the candidates that only turn `joint`: one row for each parameter, one column for each
    /// observation in the order of groups.
    #[must_use]
    pub fn turning(&self, dataset: &Dataset, candidates: &[Candidate], joint: usize) -> Turning {
        let members: Vec<usize> = (0..candidates.len())
            .filter(|&c| {
                let variant = &candidates[c].variant;
                variant.joint == Some(joint)
                    && dataset
                        .observations
                        .first()
                        .is_some_and(|s| candidates[c].effect().angles(variant, s).is_some())
            })
            .collect();
        let mut angles = DMatrix::zeros(2 * members.len(), self.order.len());
        for (mut column, &i) in angles.column_iter_mut().zip(&self.order) {
            for (k, &c) in members.iter().enumerate() {
                let candidate = &candidates[c];
                let here = candidate
                    .effect()
                    .angles(&candidate.variant, &dataset.observations[i])
                    .unwrap_or_default();
                for a in 0..2 {
                    column[2 * k + a] = here[a] * candidate.prior_sigma.get(a).copied().unwrap_or(0.0);
                }
            }
        }
        Turning { joint, members, angles }
    }

    /// Products of all members of `turning` with themselves, into `products`.
    pub fn begin_turning(&self, turning: &Turning, products: &mut [Products]) {
        let squares = &self.turn_squares[turning.joint];
        for (k, &c) in turning.members.iter().enumerate() {
            let mut own = Vec::with_capacity(self.groups.len() * 4);
            for rows in &self.groups {
                let mut sums = [0.0; 3];
                let observations =
                    rows.start / self.rows_per_observation..rows.end / self.rows_per_observation;
                for (observation, w) in observations.clone().zip(&squares[observations]) {
                    let (s, c) =
                        (turning.angles[(2 * k, observation)], turning.angles[(2 * k + 1, observation)]);
                    sums[0] += w * s * s;
                    sums[1] += w * s * c;
                    sums[2] += w * c * c;
                }
                own.extend([sums[0], sums[1], sums[1], sums[2]]);
            }
            products[c] = Products { p: 2, own, cross: Vec::new(), groups: self.groups.len() };
        }
    }

    /// Brings the members' products up to date with columns appended since: one matrix product per group.
    pub fn extend_turning(&self, turning: &Turning, products: &mut [Products]) {
        let Some(first) = turning.members.first().and_then(|&c| products.get(c)) else { return };
        let known = first.columns();
        let columns = &self.turn_products[turning.joint][known..];
        if columns.is_empty() {
            return;
        }
        let crossed: Vec<DMatrix<f64>> = self
            .groups
            .par_iter()
            .map(|rows| {
                let observations =
                    rows.start / self.rows_per_observation..rows.end / self.rows_per_observation;
                let with = DMatrix::from_fn(observations.len(), columns.len(), |r, c| {
                    columns[c][observations.start + r]
                });
                turning.angles.columns(observations.start, observations.len()) * with
            })
            .collect();
        for (k, &c) in turning.members.iter().enumerate() {
            let to = &mut products[c].cross;
            to.reserve(2 * columns.len() * crossed.len());
            for column in 0..columns.len() {
                to.extend(crossed.iter().flat_map(|from| [from[(2 * k, column)], from[(2 * k + 1, column)]]));
            }
        }
    }
}
