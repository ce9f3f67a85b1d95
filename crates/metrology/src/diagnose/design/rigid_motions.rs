//! Candidates that are one rigid motion, of the base or of the target, times a number for each observation: steps and drifts. Their
//! products come by matrix products, and their columns are made once for all of them.

use super::matrix::{Design, by_observation};
use super::products::Products;
use crate::diagnose::dataset::Dataset;
use crate::diagnose::effects::{Candidate, RigidBody};
use nalgebra::DMatrix;
use rayon::prelude::*;
use std::ops::Range;

/// The steps and drifts of one body.
#[derive(Clone, Debug)]
pub struct RigidMotions {
    /// Indices into the candidates.
    pub members: Vec<usize>,
    /// Prior standard deviation of each member's parameters.
    sigmas: Vec<Vec<f64>>,
    /// Whitened columns of the plain motion, per unit of each parameter.
    plain: Vec<Vec<f64>>,
    /// Growth: a row for each member, a column for each observation in the order of groups.
    growths: DMatrix<f64>,
}

impl Design {
    /// The candidates that are a growing motion of `body`.
    #[must_use]
    pub fn rigid_motions(
        &self,
        dataset: &Dataset,
        candidates: &[Candidate],
        body: RigidBody,
    ) -> RigidMotions {
        let members: Vec<usize> =
            (0..candidates.len()).filter(|&c| candidates[c].effect().moves() == Some(body)).collect();
        let sigmas: Vec<Vec<f64>> = members.iter().map(|&c| candidates[c].prior_sigma.clone()).collect();
        let width = sigmas.first().map_or(0, Vec::len);
        let plain =
            self.stack(dataset, width, |_, observation, out| body.signature(dataset, observation, 1.0, out));
        let growths = DMatrix::from_fn(members.len(), self.order.len(), |k, position| {
            let state = dataset.observations[self.order[position]].thermal_state();
            candidates[members[k]].variant.growth.at(&state, None)
        });
        RigidMotions { members, sigmas, plain, growths }
    }

    /// Products of all members of `motions` with themselves, into `products`.
    pub fn begin_rigid(&self, motions: &RigidMotions, products: &mut [Products]) {
        let p = motions.plain.len();
        let squares: Vec<Vec<f64>> = (0..p * p)
            .map(|k| by_observation(&motions.plain[k / p], &motions.plain[k % p], self.rows_per_observation))
            .collect();
        let own_growths = motions.growths.map(|growth| growth * growth);
        let own = self.with_growths(&own_growths, &squares);
        for (k, (&c, sigma)) in motions.members.iter().zip(&motions.sigmas).enumerate() {
            let of_group = |of: &DMatrix<f64>| {
                (0..p * p).map(|ab| of[(k, ab)] * sigma[ab / p] * sigma[ab % p]).collect()
            };
            let own: Vec<Vec<f64>> = own.iter().map(of_group).collect();
            products[c] = Products { p, own: own.concat(), cross: Vec::new(), groups: self.groups.len() };
        }
    }

    /// Brings the members' products up to date with columns appended since.
    pub fn extend_rigid(&self, motions: &RigidMotions, products: &mut [Products]) {
        let Some(first) = motions.members.first().and_then(|&c| products.get(c)) else { return };
        let (p, known) = (first.p, first.columns());
        let new = &self.columns[known..];
        let by_observation: Vec<Vec<f64>> = new
            .par_iter()
            .flat_map_iter(|b| motions.plain.iter().map(|a| by_observation(a, b, self.rows_per_observation)))
            .collect();
        let crossed = self.with_growths(&motions.growths, &by_observation);
        for (k, (&c, sigma)) in motions.members.iter().zip(&motions.sigmas).enumerate() {
            let to = &mut products[c].cross;
            to.reserve(p * new.len() * crossed.len());
            for column in 0..new.len() {
                for of in &crossed {
                    to.extend((0..p).map(|a| of[(k, column * p + a)] * sigma[a]));
                }
            }
        }
    }

    /// For each group the sums over its observations of `growths` (members x observations) times `numbers`, one list for each
    /// column of the answer.
    fn with_growths(&self, growths: &DMatrix<f64>, numbers: &[Vec<f64>]) -> Vec<DMatrix<f64>> {
        let of_group = |rows: &Range<usize>| {
            let observations = rows.start / self.rows_per_observation..rows.end / self.rows_per_observation;
            let numbers = DMatrix::from_fn(observations.len(), numbers.len(), |r, c| {
                numbers[c][observations.start + r]
            });
            growths.columns(observations.start, observations.len()) * numbers
        };
        self.groups.par_iter().map(of_group).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::dataset::evenly_spread;
    use crate::diagnose::design::Whitening;
    use crate::diagnose::effects::candidates;

    /// Sixty stations over an hour, in three groups that take turns, of unequal weights.
    fn problem() -> (Dataset, Design) {
        let dataset = evenly_spread(60);
        let residuals: Vec<[f64; 6]> = (0..60).map(|i| [1e-4 * f64::from(i % 7); 6]).collect();
        let whitening = Whitening::independent((0..60).map(|i| 1.0 + f64::from(i % 4)).collect(), 0.2);
        let group_of: Vec<usize> = (0..60).map(|i| i % 3).collect();
        let design = Design::new(&dataset, &residuals, 1, whitening, &group_of);
        (dataset, design)
    }

    /// Against the products of each candidate's own columns, also with a column that came later.
    #[test]
    fn steps_and_drifts_have_the_products_of_their_columns() {
        let (dataset, mut design) = problem();
        let all = candidates(&dataset).0;
        for body in [RigidBody::Base, RigidBody::Tool] {
            let motions = design.rigid_motions(&dataset, &all, body);
            assert!(motions.members.len() > 3, "{body:?}: {}", motions.members.len());
            let mut products = vec![Products::none(); all.len()];
            design.begin_rigid(&motions, &mut products);
            design.extend_rigid(&motions, &mut products);
            design.append(vec![(0..180).map(|r| f64::from(r % 11) - 5.0).collect()]);
            design.extend_rigid(&motions, &mut products);
            for &c in &motions.members {
                let by_columns = design.products(&design.columns_of(&dataset, &all[c]));
                assert_eq!(products[c].p, by_columns.p);
                let pairs = products[c].own.iter().zip(&by_columns.own);
                for (a, b) in pairs.chain(products[c].cross.iter().zip(&by_columns.cross)) {
                    assert!((a - b).abs() <= 1e-12 * (1.0 + b.abs()), "{body:?} {c}: {a} {b}");
                }
                assert_eq!(products[c].cross.len(), by_columns.cross.len());
            }
        }
    }
}
