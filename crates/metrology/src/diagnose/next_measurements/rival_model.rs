//! One explanation of rows: the columns that it is fitted with, and how surely the fit foretells rows not yet measured.

use crate::diagnose::design::dot;
use nalgebra::{Cholesky, DMatrix, DVector};

/// A column of the normal matrix with its coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Coefficient {
    /// Which column of the normal matrix.
    pub column: usize,
    /// Its coefficient, in prior sigmas.
    pub size: f64,
}

/// A column of the normal matrix with the precision of its prior over the noise's; 0 of a flat one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FittedColumn {
    /// Which column of the normal matrix.
    pub column: usize,
    /// Noise variance over the prior's.
    pub precision: f64,
}

/// The columns that one explanation is fitted with, and their precisions over the noise's.
pub(super) struct RivalModel {
    /// Columns of the normal matrix, with their precisions.
    pub columns: Vec<FittedColumn>,
}

impl RivalModel {
    pub(super) fn cholesky(&self, gram: &DMatrix<f64>) -> Option<Cholesky<f64, nalgebra::Dyn>> {
        let n = self.columns.len();
        let mut normal =
            DMatrix::from_fn(n, n, |r, c| gram[(self.columns[r].column, self.columns[c].column)]);
        for (i, FittedColumn { precision, .. }) in self.columns.iter().enumerate() {
            // A little regularisation: directions that the poses do not determine stay where they are.
            normal[(i, i)] += precision + 1e-9 * normal[(i, i)] + 1e-18;
        }
        normal.cholesky()
    }

    /// Square that the fit to `signal` leaves, with the noise's unit.
    pub(super) fn square_left(&self, gram: &DMatrix<f64>, signal: &[Coefficient]) -> Option<f64> {
        let with = |column: usize| signal.iter().map(|c| gram[(column, c.column)] * c.size).sum::<f64>();
        let right = DVector::from_iterator(self.columns.len(), self.columns.iter().map(|c| with(c.column)));
        let own: f64 = signal.iter().map(|c| with(c.column) * c.size).sum();
        Some((own - right.dot(&self.cholesky(gram)?.solve(&right))).max(0.0))
    }

    /// Coefficients of the fit to the data, which are column 0.
    pub(super) fn fitted(&self, gram: &DMatrix<f64>) -> Option<Vec<f64>> {
        let right =
            DVector::from_iterator(self.columns.len(), self.columns.iter().map(|c| gram[(c.column, 0)]));
        Some(self.cholesky(gram)?.solve(&right).iter().copied().collect())
    }
}

/// How surely one model foretells the rows of each pose of the pool.
pub(super) struct Prediction {
    /// Columns of the model.
    pub width: usize,
    /// Pose by pose and row by row: the row in axes in which the model's uncertainty is round.
    pub spread: Vec<f64>,
    /// How surely the rows of each pose are foretold.
    pub covers: Vec<Cover>,
}

/// The covariance of a pose's rows over the noise's variance, row by row.
pub(super) struct Cover {
    pub covariance: Vec<f64>,
    pub inverse: Vec<f64>,
    pub log_determinant: f64,
}

impl Cover {
    fn new(covariance: DMatrix<f64>) -> Self {
        let flat = covariance.as_slice().to_vec();
        let n = covariance.nrows();
        // What nothing is known of parts nothing.
        let unknown = (vec![0.0; n * n], f64::INFINITY);
        let (inverse, log_determinant) = covariance.cholesky().map_or(unknown, |factor| {
            let log = factor.l_dirty().diagonal().iter().map(|d| 2.0 * d.ln()).sum();
            (factor.inverse().as_slice().to_vec(), log)
        });
        Self { covariance: flat, inverse, log_determinant }
    }
}

impl Prediction {
    pub(super) fn new(
        model: &RivalModel,
        factor: &Cholesky<f64, nalgebra::Dyn>,
        pool: &[Vec<Vec<f64>>],
        rows: usize,
    ) -> Self {
        let (width, lower) = (model.columns.len(), factor.l());
        let mut spread = Vec::with_capacity(pool.len() * rows * width);
        for row in pool.iter().flatten() {
            let z = DVector::from_iterator(width, model.columns.iter().map(|c| row[c.column]));
            let z = lower.solve_lower_triangular(&z).unwrap_or(z);
            spread.extend(z.iter());
        }
        let mut prediction = Self { width, spread, covers: Vec::new() };
        prediction.cover(rows, pool.len());
        prediction
    }

    pub(super) fn row(&self, index: usize) -> &[f64] {
        &self.spread[index * self.width..(index + 1) * self.width]
    }

    /// Products of each of the first `count` rows with row `index`.
    pub(super) fn products_with(&self, index: usize, count: usize) -> Vec<f64> {
        (0..count).map(|row| dot(self.row(row), self.row(index))).collect()
    }

    pub(super) fn cover(&mut self, rows: usize, poses: usize) {
        let of = |pose: usize| {
            let row = |r| self.row(pose * rows + r);
            let mut covariance = DMatrix::identity(rows, rows);
            for c in 0..rows {
                for r in c..rows {
                    covariance[(r, c)] += dot(row(r), row(c));
                }
            }
            covariance.fill_upper_triangle_with_lower_triangle();
            Cover::new(covariance)
        };
        self.covers = (0..poses).map(of).collect();
    }
}
