//! Products of many columns with many columns.

use nalgebra::{DMatrix, DMatrixView};

/// nalgebra multiplies matrices with a dimension below this without blocks.
const NARROW: usize = 6;

/// Rows that are multiplied at one go: the turned copy of them stays small.
const BLOCK: usize = 4096;

/// Sum of products, in eight running sums: one alone waits for each product before the next.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (a8, b8) = (a.chunks_exact(8), b.chunks_exact(8));
    let tail: f64 = a8.remainder().iter().zip(b8.remainder()).map(|(x, y)| x * y).sum();
    for (x, y) in a8.zip(b8) {
        for k in 0..8 {
            sums[k] += x[k] * y[k];
        }
    }
    sums.iter().sum::<f64>() + tail
}

/// Products of the columns of `a` with those of `b`.
pub fn inner_products(a: DMatrixView<'_, f64>, b: DMatrixView<'_, f64>) -> DMatrix<f64> {
    // Narrow matrices are not multiplied in blocks, and a column is then as long as a row of the turned one is wide.
    if a.ncols().min(b.ncols()) < NARROW {
        return a.tr_mul(&b);
    }
    let mut sum = DMatrix::zeros(a.ncols(), b.ncols());
    for from in (0..a.nrows()).step_by(BLOCK) {
        let rows = BLOCK.min(a.nrows() - from);
        sum.gemm(1.0, &a.rows(from, rows).transpose(), &b.rows(from, rows), 1.0);
    }
    sum
}
