//! One explanation of rows: the columns that it is fitted with, and how surely the fit foretells rows not yet measured.

use inference::design::dot;
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
    /// Of a symmetric covariance of `n` rows.
    fn new(covariance: Vec<f64>, n: usize) -> Self {
        // What nothing is known of parts nothing.
        let unknown = || (vec![0.0; n * n], f64::INFINITY);
        let (inverse, log_determinant) = inverse_and_log_determinant(&covariance, n).unwrap_or_else(unknown);
        Self { covariance, inverse, log_determinant }
    }
}

/// Of a symmetric matrix of a few rows, swept (Goodnight 1979): there are hundreds of poses for each that is taken. `None` where it is not
/// positive definite.
fn inverse_and_log_determinant(matrix: &[f64], n: usize) -> Option<(Vec<f64>, f64)> {
    let mut swept = matrix.to_vec();
    let mut log_determinant = 0.0;
    for k in 0..n {
        let pivot = swept[k * n + k];
        if pivot.is_nan() || pivot <= 0.0 {
            return None;
        }
        log_determinant += pivot.ln();
        for i in (0..n).filter(|&i| i != k) {
            let share = swept[i * n + k] / pivot;
            for j in (0..n).filter(|&j| j != k) {
                swept[i * n + j] -= share * swept[k * n + j];
            }
        }
        for i in (0..n).filter(|&i| i != k) {
            swept[i * n + k] /= pivot;
            swept[k * n + i] = swept[i * n + k];
        }
        swept[k * n + k] = -1.0 / pivot;
    }
    swept.iter_mut().for_each(|value| *value = -*value);
    Some((swept, log_determinant))
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
            let mut covariance = vec![0.0; rows * rows];
            for c in 0..rows {
                for r in c..rows {
                    let both = dot(row(r), row(c)) + f64::from(u8::from(r == c));
                    (covariance[r * rows + c], covariance[c * rows + r]) = (both, both);
                }
            }
            Cover::new(covariance, rows)
        };
        self.covers = (0..poses).map(of).collect();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the dense inverse and determinant, up to a pose's six rows; a matrix that is not definite has none.
    #[test]
    fn a_swept_matrix_is_inverted() {
        for n in [1, 3, 6] {
            let root = DMatrix::from_fn(n, n, |r, c| ((r * 7 + c * 5 + r * c) % 9) as f64 / 4.0 - 0.8);
            let matrix = root.tr_mul(&root) + DMatrix::identity(n, n);
            let (inverse, log_determinant) = inverse_and_log_determinant(matrix.as_slice(), n).unwrap();
            assert!((log_determinant - matrix.determinant().ln()).abs() < 1e-12, "{n}");
            let product = matrix * DMatrix::from_vec(n, n, inverse);
            assert!((product - DMatrix::identity(n, n)).amax() < 1e-12, "{n}");
        }
        assert!(inverse_and_log_determinant(&[1.0, 2.0, 2.0, 1.0], 2).is_none());
    }
}
