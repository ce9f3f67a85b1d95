//! Features of functions of any shape: bumps at places far from each other, and the few of them that say most.

use super::dataset::{Dataset, Observation};
use super::design::inner_products;
use nalgebra::DMatrix;

/// Usual size of the structure at the point, metres.
const PRIOR_SIGMA_M: f64 = 1e-4;
/// Most features kept for a GP alternative.
const MOST_FEATURES: usize = 28;

/// How far `at` lies from each of `centres`, as a bump of this length: 1 there, 0 far off.
pub(super) fn bumps(at: &[f64], centres: &[Vec<f64>], length: f64) -> Vec<f64> {
    centres
        .iter()
        .map(|centre| {
            let d2: f64 = centre.iter().zip(at).map(|(c, x)| (c - x) * (c - x)).sum();
            (-0.5 * d2 / (length * length)).exp()
        })
        .collect()
}

/// Points far from each other, one after the other (Gonzalez 1985).
pub(super) fn farthest_points(
    dataset: &Dataset,
    at: impl Fn(&Observation) -> Vec<f64>,
    most: usize,
) -> Vec<Vec<f64>> {
    let points: Vec<Vec<f64>> = dataset.observations.iter().map(at).collect();
    let mut far = vec![f64::INFINITY; points.len()];
    let mut chosen = Vec::new();
    let mut next = 0;
    while chosen.len() < most.min(points.len()) {
        let centre = points[next].clone();
        for (d, point) in far.iter_mut().zip(&points) {
            let d2: f64 = centre.iter().zip(point).map(|(a, b)| (a - b) * (a - b)).sum();
            *d = d.min(d2);
        }
        chosen.push(centre);
        let mut best = 0.0;
        for (i, d) in far.iter().enumerate() {
            if *d > best {
                best = *d;
                next = i;
            }
        }
        if best <= 0.0 {
            break;
        }
    }
    chosen
}

/// Principal features, largest first, sized so that the structure is [`PRIOR_SIGMA_M`] on average.
pub(super) fn compress(columns: &DMatrix<f64>) -> DMatrix<f64> {
    let (rows, n) = columns.shape();
    if n == 0 || rows == 0 {
        return DMatrix::zeros(rows, 0);
    }
    let eigen = inner_products(columns.as_view(), columns.as_view()).symmetric_eigen();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
    let top = eigen.eigenvalues[order[0]];
    if top <= 0.0 {
        return DMatrix::zeros(rows, 0);
    }
    order.truncate(MOST_FEATURES);
    order.retain(|&i| eigen.eigenvalues[i] > 1e-6 * top);
    let mean_square = eigen.eigenvalues.iter().sum::<f64>() / (rows as f64 / 3.0);
    let scale = PRIOR_SIGMA_M / mean_square.sqrt();
    columns * (eigen.eigenvectors.select_columns(&order) * scale)
}
