//! A candidate over a nuisance model: what is left of it, with itself, with the data and with geometry.

use super::accumulate::add_columns;
use super::principal::PrincipalDirections;
use super::tridiagonal::Tridiagonal;
use super::{EvidencePeak, NuisanceModel};
use crate::design::{Sums, side_by_side};
use nalgebra::{DMatrix, DVector};
use std::ops::Range;

/// With more parameters than these a product of whole matrices is quicker than one of columns.
const MOST_BY_COLUMNS: usize = 5;

/// A candidate over a nuisance model; [`NuisanceModel::update`] follows a nuisance model that has grown.
pub struct Projected {
    pub(super) own: DMatrix<f64>,
    pub(super) with_y: DVector<f64>,
    /// With the geometry's columns.
    pub(super) geometry: DMatrix<f64>,
    /// How many of the nuisance model's directions are projected out.
    pub(super) known: usize,
}

/// What geometry of one size leaves of a candidate.
pub(super) struct ReducedProducts {
    /// Its products with itself, symmetric: parameters x parameters.
    pub own: DMatrix<f64>,
    /// Its products with the data.
    pub with_y: DVector<f64>,
}

/// A pivot over its diagonal's number below which a column is rounding of those before it.
const LEAST_PIVOT: f64 = 1e-9;

impl NuisanceModel {
    /// A candidate with the nuisance model's flat columns projected out.
    #[must_use]
    pub fn project(&self, sums: &Sums) -> Projected {
        let p = sums.own.nrows();
        let mut geometry = Vec::with_capacity(self.geometry.len() * p);
        for a in 0..p {
            let of_parameter = &sums.cross.as_slice()[a..];
            geometry.extend(self.geometry.iter().map(|column| of_parameter[column * p]));
        }
        let mut projected = Projected {
            own: sums.own.clone(),
            with_y: sums.cross.column(0).into_owned(),
            geometry: DMatrix::from_vec(self.geometry.len(), p, geometry),
            known: 0,
        };
        self.update(&mut projected, sums);
        projected
    }

    /// Projects out the directions that the nuisance model has gained.
    pub fn update(&self, candidate: &mut Projected, sums: &Sums) {
        match sums.own.nrows() {
            0 => {}
            1 => self.update_of(candidate, sums, [0.0; 1]),
            2 => self.update_of(candidate, sums, [0.0; 2]),
            3 => self.update_of(candidate, sums, [0.0; 3]),
            6 => self.update_of(candidate, sums, [0.0; 6]),
            p => self.update_of(candidate, sums, vec![0.0; p]),
        }
    }

    /// The same with room for one number of each parameter: an array where their count is a constant.
    fn update_of(&self, candidate: &mut Projected, sums: &Sums, mut hat: impl AsMut<[f64]>) {
        let hat = hat.as_mut();
        let p = hat.len();
        let new = &self.directions[candidate.known..];
        // What is projected out along each direction, parameter by parameter.
        let mut shares = vec![0.0; p * new.len()];
        for (k, direction) in new.iter().enumerate() {
            hat.fill(0.0);
            let Range { start, end } = direction.support;
            let columns = sums.cross.as_slice()[start * p..].chunks_exact(p);
            let weights = &direction.weights[start..end];
            for (d, column) in weights.iter().zip(columns).filter(|(d, _)| **d != 0.0) {
                for (to, from) in hat.iter_mut().zip(column) {
                    *to += d * from;
                }
            }
            let own = candidate.own.as_mut_slice().chunks_exact_mut(p);
            for (a, ((own, with_y), along)) in own.zip(candidate.with_y.as_mut_slice()).zip(&*hat).enumerate()
            {
                *with_y -= along * direction.y;
                for (to, other) in own.iter_mut().zip(&*hat) {
                    *to -= along * other;
                }
                shares[a * new.len() + k] = -along;
            }
        }
        let geometry = candidate.geometry.as_mut_slice().chunks_exact_mut(self.geometry.len().max(1));
        for (column, shares) in geometry.zip(shares.chunks_exact(new.len().max(1))) {
            add_columns(column, shares, new.iter().map(|direction| direction.geometry.as_slice()));
        }
        candidate.known = self.directions.len();
    }

    /// What the flat columns, and geometry at `ratio`, absorb of a candidate, given as `projected` and by its `sums`: (directions x
    /// parameters), so that the products of two candidates lose the products of these.
    #[must_use]
    pub fn absorbed(&self, projected: &Projected, sums: &Sums, ratio: f64) -> DMatrix<f64> {
        let p = sums.own.nrows();
        let flat = self.directions.len();
        let mut absorbed = DMatrix::zeros(flat + self.lambda.len(), p);
        for (k, direction) in self.directions.iter().enumerate() {
            let columns = sums.cross.as_slice().chunks_exact(p.max(1));
            for (d, column) in direction.weights.iter().zip(columns).filter(|(d, _)| **d != 0.0) {
                for (a, from) in column.iter().enumerate() {
                    absorbed[(k, a)] += d * from;
                }
            }
        }
        let with_geometry = self.along_geometry(projected);
        for (k, weight) in self.geometry_shares(ratio).enumerate() {
            absorbed.row_mut(flat + k).copy_from(&(weight * with_geometry.row(k)));
        }
        absorbed
    }

    /// The same of the data.
    #[must_use]
    pub fn absorbed_of_data(&self, ratio: f64) -> DVector<f64> {
        let geometry = self.geometry_shares(ratio).zip(self.gy.iter()).map(|(weight, g)| weight * g);
        DVector::from_iterator(
            self.directions.len() + self.lambda.len(),
            self.directions.iter().map(|direction| direction.y).chain(geometry),
        )
    }

    /// Roots of the share that geometry at `ratio` takes along each of its directions.
    fn geometry_shares(&self, ratio: f64) -> impl Iterator<Item = f64> + '_ {
        let r2 = ratio * ratio;
        self.lambda.iter().map(move |l| (r2 / (1.0 + r2 * l)).sqrt())
    }

    /// Share of the candidate's own signal that the flat columns leave.
    #[must_use]
    pub fn visible(&self, sums: &Sums) -> f64 {
        let projected = self.project(sums);
        let whole = sums.own.trace();
        if whole > 0.0 { (projected.own.trace() / whole).max(0.0) } else { 0.0 }
    }

    /// Length of a candidate's first column that registration and geometry at `ratio` leave.
    #[must_use]
    pub fn strength(&self, candidate: &Projected, ratio: f64) -> f64 {
        let r2 = ratio * ratio;
        let mut own = candidate.own[(0, 0)];
        let with_geometry = &self.turn * candidate.geometry.column(0);
        for (l, g) in self.lambda.iter().zip(with_geometry.iter()) {
            own -= r2 / (1.0 + r2 * l) * g.powi(2);
        }
        own.max(0.0).sqrt()
    }

    /// A candidate's products with geometry along geometry's own directions: (directions x parameters).
    pub(super) fn along_geometry(&self, candidate: &Projected) -> DMatrix<f64> {
        self.turned(&candidate.geometry)
    }

    /// The same of many candidates.
    pub(super) fn along_geometry_together(&self, candidates: &[&Projected]) -> Vec<DMatrix<f64>> {
        let geometries: Vec<&DMatrix<f64>> = candidates.iter().map(|candidate| &candidate.geometry).collect();
        let along = self.turned(&side_by_side(&geometries));
        let mut at = 0;
        let of_one = |geometry: &&DMatrix<f64>| {
            let from = at;
            at += geometry.ncols();
            along.columns(from, geometry.ncols()).into_owned()
        };
        geometries.iter().map(of_one).collect()
    }

    /// Products with geometry, turned to geometry's own directions.
    fn turned(&self, from: &DMatrix<f64>) -> DMatrix<f64> {
        let width = from.ncols();
        if width > MOST_BY_COLUMNS {
            return &self.turn * from;
        }
        let mut along = DMatrix::zeros(self.turn.nrows(), width);
        let rows = self.turn.nrows().max(1);
        for (a, to) in along.as_mut_slice().chunks_exact_mut(rows).enumerate() {
            add_columns(to, from.column(a).as_slice(), self.turn.as_slice().chunks_exact(rows));
        }
        along
    }

    /// Root mean square over the rows of the signal of one prior sigma, metres.
    pub(super) fn signal_of_unit_size(&self, candidate: &Projected) -> f64 {
        (candidate.own.trace().max(0.0) / self.m).sqrt()
    }

    /// What the candidate explains where its sizes cost nothing, geometry at `ratio` out: squares of the data. By elimination; by its own
    /// directions where its columns tell nearly the same.
    pub(super) fn explained_at_no_price(
        &self,
        candidate: &Projected,
        with_geometry: &DMatrix<f64>,
        ratio: f64,
    ) -> f64 {
        match candidate.own.nrows() {
            1 => {
                let ([[own]], [with_y]) = self.reduced_few(candidate, with_geometry, ratio);
                if own > 0.0 { with_y * with_y / own } else { 0.0 }
            }
            2 => {
                let ([[a, b], [_, d]], [u, v]) = self.reduced_few(candidate, with_geometry, ratio);
                let (left, rest) = (d - b * b / a, v - b * u / a);
                if a > 0.0 && left > LEAST_PIVOT * d {
                    return u * u / a + rest * rest / left;
                }
                explained_by_directions(
                    DMatrix::from_row_slice(2, 2, &[a, b, b, d]),
                    &DVector::from_vec(vec![u, v]),
                )
            }
            _ => {
                let ReducedProducts { own, with_y } = self.reduced(candidate, with_geometry, ratio);
                explained_by_elimination(own.clone(), &with_y)
                    .unwrap_or_else(|| explained_by_directions(own, &with_y))
            }
        }
    }

    /// The candidate along its own directions, geometry at `ratio` out.
    pub(super) fn principal_directions(
        &self,
        candidate: &Projected,
        with_geometry: &DMatrix<f64>,
        ratio: f64,
    ) -> PrincipalDirections {
        match candidate.own.nrows() {
            1 => {
                let ([[own]], [with_y]) = self.reduced_few(candidate, with_geometry, ratio);
                PrincipalDirections::of_one(own, with_y)
            }
            2 => {
                let ([[a, b], [_, d]], with_y) = self.reduced_few(candidate, with_geometry, ratio);
                PrincipalDirections::of_two([a, b, d], with_y)
            }
            _ => {
                let ReducedProducts { own, with_y } = self.reduced(candidate, with_geometry, ratio);
                PrincipalDirections::Many(Tridiagonal::of(own, &with_y))
            }
        }
    }

    /// As [`Self::reduced`] of one or two parameters, as the thousands of gear lines have, the upper triangle of the products with itself.
    fn reduced_few<const P: usize>(
        &self,
        candidate: &Projected,
        with_geometry: &DMatrix<f64>,
        ratio: f64,
    ) -> ([[f64; P]; P], [f64; P]) {
        let mut own: [[f64; P]; P] = std::array::from_fn(|a| std::array::from_fn(|b| candidate.own[(a, b)]));
        let mut with_y: [f64; P] = std::array::from_fn(|a| candidate.with_y[a]);
        if ratio > 0.0 {
            let r2 = ratio * ratio;
            let n = self.lambda.len();
            let (lambda, gy) = (self.lambda.as_slice(), &self.gy.as_slice()[..n]);
            let columns: [&[f64]; P] = std::array::from_fn(|a| &with_geometry.as_slice()[a * n..(a + 1) * n]);
            for (k, (l, gy)) in lambda.iter().zip(gy).enumerate() {
                let f = r2 / (1.0 + r2 * l);
                let row: [f64; P] = std::array::from_fn(|a| columns[a][k]);
                for a in 0..P {
                    let by = f * row[a];
                    with_y[a] -= by * gy;
                    for b in a..P {
                        own[a][b] -= by * row[b];
                    }
                }
            }
        }
        (own, with_y)
    }

    /// The candidate with itself and with the data, geometry at `ratio` out.
    pub(super) fn reduced(
        &self,
        candidate: &Projected,
        with_geometry: &DMatrix<f64>,
        ratio: f64,
    ) -> ReducedProducts {
        let p = candidate.own.nrows();
        let mut own = candidate.own.clone();
        let mut with_y = candidate.with_y.clone();
        if ratio > 0.0 {
            let r2 = ratio * ratio;
            let mut shares = with_geometry.transpose();
            for (row, l) in shares.as_mut_slice().chunks_exact_mut(p.max(1)).zip(self.lambda.iter()) {
                let f = r2 / (1.0 + r2 * l);
                row.iter_mut().for_each(|row| *row *= f);
            }
            let shares = || shares.as_slice().chunks_exact(p.max(1));
            let mut by: Vec<f64> = self.gy.iter().map(|gy| -gy).collect();
            add_columns(with_y.as_mut_slice(), &by, shares());
            // From the diagonal down: the matrix is symmetric.
            for (b, column) in own.as_mut_slice().chunks_exact_mut(p.max(1)).enumerate() {
                by.iter_mut().zip(with_geometry.column(b).iter()).for_each(|(by, row)| *by = -row);
                add_columns(&mut column[b..], &by, shares().map(|share| &share[b..]));
            }
            own.fill_upper_triangle_with_lower_triangle();
        }
        ReducedProducts { own, with_y }
    }

    /// By how many standard deviations the candidate's first parameter is positive where it `peak` most.
    #[must_use]
    pub(super) fn sign(
        &self,
        candidate: &Projected,
        with_geometry: &DMatrix<f64>,
        peak: &EvidencePeak,
    ) -> f64 {
        let ReducedProducts { mut own, with_y } = self.reduced(candidate, with_geometry, peak.geometry_ratio);
        let precision = peak.size_ratio.max(1e-12).powi(-2);
        for a in 0..own.nrows() {
            own[(a, a)] += precision;
        }
        let Some(covariance) = own.cholesky().map(|c| c.inverse()) else { return 0.0 };
        let mean = (covariance.row(0) * &with_y)[0];
        mean / (peak.sigma_m * covariance[(0, 0)].max(1e-300).sqrt())
    }
}

/// y' A^+ y of a symmetric A along those of its eigenvectors in which there is signal.
fn explained_by_directions(own: DMatrix<f64>, with_y: &DVector<f64>) -> f64 {
    let eigen = own.symmetric_eigen();
    let along = eigen.eigenvectors.tr_mul(with_y);
    let seen = eigen.eigenvalues.iter().zip(&along).filter(|(square, _)| **square > 0.0);
    seen.map(|(square, with_y)| with_y * with_y / square).sum()
}

/// y' A^-1 y of a symmetric A; `None` where a pivot of its Cholesky factor is rounding.
fn explained_by_elimination(own: DMatrix<f64>, with_y: &DVector<f64>) -> Option<f64> {
    let diagonal = own.diagonal();
    let lower = own.cholesky()?.unpack_dirty();
    let is_rounding = |k: usize| lower[(k, k)].powi(2) <= LEAST_PIVOT * diagonal[k];
    if (0..diagonal.len()).any(is_rounding) {
        return None;
    }
    lower.solve_lower_triangular(with_y).map(|half| half.norm_squared())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the inverse of three matrices, one of them near singular; and none where a column is the sum of two others.
    #[test]
    fn elimination_explains_what_the_inverse_does() {
        for p in [3, 6, 9] {
            let columns =
                DMatrix::from_fn(20, p, |r, c| ((r * 7 + c * 13 + r * c * c) % 11) as f64 / 4.0 - 1.2);
            let mut own = columns.tr_mul(&columns);
            let with_y = DVector::from_fn(p, |a, _| 1.0 - 0.3 * a as f64);
            let exact = with_y.dot(&(own.clone().try_inverse().unwrap() * &with_y));
            let explained = explained_by_elimination(own.clone(), &with_y).unwrap();
            assert!((explained - exact).abs() < 1e-9 * exact, "{p}: {explained} {exact}");
            let last = own.column(0) + own.column(1);
            own.set_column(p - 1, &last);
            let row = own.row(0) + own.row(1);
            own.set_row(p - 1, &row);
            assert!(explained_by_elimination(own, &with_y).is_none(), "{p}");
        }
    }
}
