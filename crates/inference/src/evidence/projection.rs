//! Many candidates over a nuisance model at once, by products of whole matrices: a search asks for thousands.

use super::NuisanceModel;
use super::candidate::Projected;
use crate::design::Sums;
use nalgebra::{DMatrix, DVector};

impl NuisanceModel {
    /// [`Self::project`] of many candidates.
    #[must_use]
    pub fn project_together(&self, candidates: &[&Sums]) -> Vec<Projected> {
        let used = self.directions.iter().map(|direction| direction.support.end).max().unwrap_or(0);
        let along = self.weights(used) * columns_of(candidates, 0..used);
        let mut geometry = columns_of(candidates, self.geometry.iter().copied());
        let of_geometry = DMatrix::from_fn(self.geometry.len(), self.directions.len(), |row, k| {
            self.directions[k].geometry[row]
        });
        geometry.gemm(-1.0, &of_geometry, &along, 1.0);
        let y = DVector::from_iterator(
            self.directions.len(),
            self.directions.iter().map(|direction| direction.y),
        );
        let mut first = 0;
        let of_one = |sums: &&Sums| {
            let (from, p) = (first, sums.own.nrows());
            first += p;
            let along = along.columns(from, p);
            let mut own = sums.own.clone();
            let mut with_y = sums.cross.column(0).into_owned();
            for a in 0..p {
                with_y[a] -= along.column(a).dot(&y);
                for b in a..p {
                    let product = along.column(a).dot(&along.column(b));
                    own[(a, b)] -= product;
                    if a != b {
                        own[(b, a)] -= product;
                    }
                }
            }
            Projected {
                own,
                with_y,
                geometry: geometry.columns(from, p).into_owned(),
                known: self.directions.len(),
            }
        };
        candidates.iter().map(of_one).collect()
    }

    /// Weights of the design's first columns in each direction: (directions x columns).
    fn weights(&self, columns: usize) -> DMatrix<f64> {
        DMatrix::from_fn(self.directions.len(), columns, |k, column| self.directions[k].weights[column])
    }
}

/// Products of all parameters of the candidates with these columns of the design: (columns x parameters).
fn columns_of(candidates: &[&Sums], columns: impl Iterator<Item = usize> + Clone) -> DMatrix<f64> {
    let count: usize = candidates.iter().map(|sums| sums.own.nrows()).sum();
    let mut numbers = Vec::with_capacity(count * columns.size_hint().0);
    for sums in candidates {
        let (p, cross) = (sums.own.nrows(), sums.cross.as_slice());
        for a in 0..p {
            numbers.extend(columns.clone().map(|column| cross[column * p + a]));
        }
    }
    DMatrix::from_vec(numbers.len() / count.max(1), count, numbers)
}
