//! Least squares over some of the design's columns, at given priors; knows nothing of evidence.

use crate::design::{Design, SlowColumns};
use crate::search::ChosenCause;
use nalgebra::{DMatrix, DVector};

/// A fit of some of the design's columns.
#[derive(Clone, Debug)]
pub struct LinearFit {
    /// One for each column after the data; 0 for columns that take no part.
    pub coefficients: Vec<f64>,
    /// Columns that take part.
    pub columns: Vec<usize>,
    /// Their covariance at unit noise.
    pub covariance: DMatrix<f64>,
}

impl LinearFit {
    /// The coefficients without those of slow noise: what registration, geometry and causes take.
    #[must_use]
    pub fn without_slow(mut self, design: &Design) -> Self {
        for column in design.slow().columns {
            self.coefficients[column - 1] = 0.0;
        }
        self
    }
}

/// Fits registration, geometry (with `geometry_ratio`; none without it), slow noise and causes over `subset`.
#[must_use]
pub fn solve(
    design: &Design,
    subset: &[usize],
    chosen: &[ChosenCause],
    geometry_ratio: Option<f64>,
) -> LinearFit {
    let gram = design.gram(subset);
    let mut columns: Vec<(usize, f64)> = design.registration.clone().map(|c| (c, 0.0)).collect();
    if let Some(ratio) = geometry_ratio.filter(|r| *r > 0.0) {
        columns.extend(design.geometry.clone().map(|c| (c, 1.0 / (ratio * ratio))));
    }
    let SlowColumns { columns: slow, size_ratio: ratio } = design.slow();
    if ratio > 0.0 {
        columns.extend(slow.map(|c| (c, 1.0 / (ratio * ratio))));
    }
    for cause in chosen {
        let ratio = 3.0 * cause.size_ratio;
        columns.extend(cause.columns.iter().map(|&c| (c, 1.0 / (ratio * ratio))));
    }
    let n = columns.len();
    let mut normal = DMatrix::from_fn(n, n, |r, c| gram[(columns[r].0, columns[c].0)]);
    for (i, (_, precision)) in columns.iter().enumerate() {
        // A little regularisation: directions that the poses do not determine stay where they are.
        normal[(i, i)] += precision + 1e-10 * normal[(i, i)] + 1e-18;
    }
    let right = DVector::from_fn(n, |r, _| gram[(columns[r].0, 0)]);
    let mut coefficients = vec![0.0; design.width() - 1];
    let mut covariance = DMatrix::zeros(n, n);
    if let Some(cholesky) = normal.cholesky() {
        let solved = cholesky.solve(&right);
        covariance = cholesky.inverse();
        for ((column, _), value) in columns.iter().zip(solved.iter()) {
            coefficients[column - 1] = *value;
        }
    }
    LinearFit { coefficients, columns: columns.into_iter().map(|c| c.0).collect(), covariance }
}
