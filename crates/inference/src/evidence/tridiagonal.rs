//! A symmetric matrix as a chain beside a vector: turned so that the vector lies along the first parameter, and each parameter goes
//! with the next alone (Householder 1958). What a ridge of any size makes of both is one sweep, without any eigenvector.

use super::accumulate::add_columns;
use nalgebra::{DMatrix, DVector};

/// A candidate's products with itself as a chain that begins along the data.
#[derive(Clone)]
pub(super) struct Tridiagonal {
    /// Of each parameter with itself.
    diagonal: Vec<f64>,
    /// Square of what each has with the one before it; the first with the data.
    squares: Vec<f64>,
}

impl Tridiagonal {
    /// Of a candidate's products with itself and with the data.
    pub(super) fn of(mut own: DMatrix<f64>, with_y: &DVector<f64>) -> Self {
        let p = own.nrows();
        let (mut diagonal, mut squares) = (Vec::with_capacity(p), Vec::with_capacity(p));
        let mut axis = with_y.as_slice().to_vec();
        let mut image = vec![0.0; p];
        for k in 0..p {
            squares.push(axis[k..].iter().map(|x| x * x).sum());
            turn(&mut own, k, &mut axis[k..], &mut image[k..], squares[k]);
            diagonal.push(own[(k, k)]);
            axis[k + 1..].copy_from_slice(&own.column(k).as_slice()[k + 1..]);
        }
        Self { diagonal, squares }
    }

    /// What a candidate whose parameters have the variance `s2` takes off the squares; `pivot` is handed the factors of the determinant
    /// of 1 + `s2` times the matrix, none of which is below 1 but by rounding.
    pub(super) fn explained(&self, s2: f64, mut pivot: impl FnMut(f64)) -> f64 {
        // The chain's own determinant over that of the rest of it: y' (1 / s2 + A)^-1 y is a continued fraction.
        let mut below = 0.0;
        for (own, square) in self.diagonal.iter().zip(&self.squares).rev() {
            let factor = (1.0 + s2 * own - below).max(1.0);
            pivot(factor);
            below = s2 * s2 * square / factor;
        }
        if s2 > 0.0 { below / s2 } else { 0.0 }
    }
}

/// Reflects the parameters from `k` on so that `axis`, of this square, lies along the first of them; `image` is room for as many.
fn turn(own: &mut DMatrix<f64>, k: usize, axis: &mut [f64], image: &mut [f64], square: f64) {
    if axis.len() < 2 || square <= 0.0 {
        return;
    }
    let p = own.nrows();
    let length = square.sqrt();
    // From the side that is farther off.
    let first = axis[0];
    axis[0] += if first > 0.0 { length } else { -length };
    let scale = 1.0 / (square + length * first.abs());
    let columns = || own.as_slice()[k * p..].chunks_exact(p).map(|column| &column[k..]);
    image.fill(0.0);
    add_columns(image, axis, columns());
    image.iter_mut().for_each(|x| *x *= scale);
    let half = 0.5 * scale * image.iter().zip(&*axis).map(|(x, a)| x * a).sum::<f64>();
    image.iter_mut().zip(&*axis).for_each(|(x, a)| *x -= half * a);
    let columns = own.as_mut_slice()[k * p..].chunks_exact_mut(p);
    for (column, (a, x)) in columns.zip(axis.iter().zip(&*image)) {
        for (to, (axis, image)) in column[k..].iter_mut().zip(axis.iter().zip(&*image)) {
            *to -= a * image + x * axis;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against dense inverses and determinants: matrices of three to nine parameters, one with a column that is the sum of two others, and
    /// data along nothing.
    #[test]
    fn a_chain_explains_what_the_whole_matrix_does() {
        for (p, singular, size) in [(3, false, 1.0), (6, false, 1.0), (9, true, 1.0), (4, false, 0.0)] {
            let mut columns =
                DMatrix::from_fn(20, p, |r, c| ((r * 7 + c * 13 + r * c * c) % 11) as f64 / 4.0 - 1.2);
            if singular {
                let sum = columns.column(0) + columns.column(1);
                columns.set_column(p - 1, &sum);
            }
            let own = columns.tr_mul(&columns);
            let with_y = columns.tr_mul(&DVector::from_fn(20, |r, _| size * (1.0 - 0.3 * r as f64)));
            let chain = Tridiagonal::of(own.clone(), &with_y);
            for s2 in [1e-4_f64, 0.3, 40.0] {
                let ridge = DMatrix::identity(p, p) + &own * s2;
                let explained = s2 * with_y.dot(&(ridge.clone().try_inverse().unwrap() * &with_y));
                let mut log_det = 0.0;
                let swept = chain.explained(s2, |factor| log_det += factor.ln());
                assert!(
                    (swept - explained).abs() <= 1e-10 * explained.abs(),
                    "{p} {s2}: {swept} {explained}"
                );
                assert!((log_det - ridge.determinant().ln()).abs() < 1e-10, "{p} {s2}: {log_det}");
            }
        }
    }
}
