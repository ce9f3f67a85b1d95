//! Features of functions of any shape: bumps at places far from each other, and the few of them that say most.

use crate::dataset::{Dataset, Observation};
use crate::design::inner_products;
use nalgebra::{DMatrix, DVector, Dyn, SymmetricEigen};

/// Usual size of the structure at the point, metres.
const PRIOR_SIGMA_M: f64 = 1e-4;
/// Most features kept for a GP alternative.
const MOST_FEATURES: usize = 28;
/// Eigenvalues that differ by less than this share are the same.
const SAME_EIGENVALUE: f64 = 1e-6;

/// How far `at` lies from each of `centres`, as a bump of this length: 1 there, 0 far off.
pub fn bumps(at: &[f64], centres: &[Vec<f64>], length: f64) -> Vec<f64> {
    centres
        .iter()
        .map(|centre| {
            let d2: f64 = centre.iter().zip(at).map(|(c, x)| (c - x) * (c - x)).sum();
            (-0.5 * d2 / (length * length)).exp()
        })
        .collect()
}

/// Points far from each other, one after the other (Gonzalez 1985).
pub fn farthest_points(
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

/// Principal features, largest first, sized so that the structure is `PRIOR_SIGMA_M` on average.
pub fn compress(columns: &DMatrix<f64>) -> DMatrix<f64> {
    let (rows, n) = columns.shape();
    if n == 0 || rows == 0 {
        return DMatrix::zeros(rows, 0);
    }
    let eigen = eigen_by_parts(&inner_products(columns.as_view(), columns.as_view()));
    let mut order: Vec<usize> = (0..n).collect();
    sorting::by(&mut order, |&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
    let top = eigen.eigenvalues[order[0]];
    if top <= 0.0 {
        return DMatrix::zeros(rows, 0);
    }
    // The same shift along three axes has one eigenvalue three times, and its vectors are as rounding turns them: all of them, or none.
    let left_out = order.get(MOST_FEATURES).map_or(0.0, |&i| eigen.eigenvalues[i]);
    order.truncate(MOST_FEATURES);
    order.retain(|&i| eigen.eigenvalues[i] > 1e-6 * top);
    let distinct = order.partition_point(|&i| eigen.eigenvalues[i] > left_out * (1.0 + SAME_EIGENVALUE));
    // Of features that are all the same any will do.
    if distinct > 0 {
        order.truncate(distinct);
    }
    let mean_square = eigen.eigenvalues.iter().sum::<f64>() / (rows as f64 / 3.0);
    let scale = PRIOR_SIGMA_M / mean_square.sqrt();
    columns * (eigen.eigenvectors.select_columns(&order) * scale)
}

/// Eigenvalues and eigenvectors of a symmetric matrix, part by part: shifts along three axes of which none has to do with another are three
/// matrices of a third, which take a ninth of the time.
fn eigen_by_parts(matrix: &DMatrix<f64>) -> SymmetricEigen<f64, Dyn> {
    let n = matrix.nrows();
    let mut eigenvalues = DVector::zeros(n);
    let mut eigenvectors = DMatrix::zeros(n, n);
    let mut open: Vec<usize> = (0..n).collect();
    while let Some(&first) = open.first() {
        let mut part = vec![first];
        let mut seen = 0;
        while let Some(&row) = part.get(seen) {
            seen += 1;
            open.retain(|&column| column != row);
            let joined =
                open.iter().filter(|&&column| matrix[(row, column)] != 0.0 && !part.contains(&column));
            let joined: Vec<usize> = joined.copied().collect();
            part.extend(joined);
        }
        sorting::ascending(&mut part);
        let of = DMatrix::from_fn(part.len(), part.len(), |r, c| matrix[(part[r], part[c])]);
        let eigen = of.symmetric_eigen();
        for (k, &column) in part.iter().enumerate() {
            eigenvalues[column] = eigen.eigenvalues[k];
            for (r, &row) in part.iter().enumerate() {
                eigenvectors[(row, column)] = eigen.eigenvectors[(r, k)];
            }
        }
    }
    SymmetricEigen { eigenvectors, eigenvalues }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Twelve shifts of different size, each along three axes: 36 features, of which 28 have room. What is kept is the same whichever way
    /// the three of a size are turned, and so whatever rounding makes of them.
    #[test]
    fn features_of_one_size_are_kept_together_or_not_at_all() {
        let columns = DMatrix::from_fn(36, 36, |r, c| if r == c { 1.0 / (1 + c / 3) as f64 } else { 0.0 });
        let (s, c) = 0.7_f64.sin_cos();
        let mut turned = columns.clone();
        for shift in 0..12 {
            let [a, b] = [3 * shift, 3 * shift + 1].map(|k| columns.column(k).into_owned());
            turned.set_column(3 * shift, &(&a * c + &b * s));
            turned.set_column(3 * shift + 1, &(&b * c - &a * s));
        }
        let [plain, turned] = [columns, turned].map(|columns| compress(&columns));
        assert_eq!(plain.ncols(), 27);
        let off = &plain * plain.transpose() - &turned * turned.transpose();
        assert!(off.amax() < 1e-12 * PRIOR_SIGMA_M * PRIOR_SIGMA_M * 36.0, "{}", off.amax());
        // The largest nine, each along three axes.
        for r in 0..36 {
            assert_eq!((&plain * plain.transpose())[(r, r)] > 0.0, r < 27, "{r}");
        }
    }

    /// Forty features of one size: 28 of them, as no other choice is better.
    #[test]
    fn of_features_that_are_all_of_one_size_as_many_are_kept_as_there_is_room_for() {
        assert_eq!(compress(&DMatrix::identity(40, 40)).ncols(), MOST_FEATURES);
    }
}
