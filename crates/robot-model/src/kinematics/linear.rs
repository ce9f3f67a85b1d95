//! Six equations in six unknowns, on plain arrays.

use super::matrix::{Mat3, Vec3, add, adjugate, apply, mul, scale, sub};
use super::real::Real;

pub(crate) type Vec6 = [f64; 6];
pub(crate) type Mat6 = [[f64; 6]; 6];

/// Newton's step of an arm: `jacobian x = twist`, rows vx vy vz wx wy wz; with it the determinants of the wrist's block and of
/// what is left for the first three joints, whose product is the Jacobian's. No pivoting: joints 4 to 6 must be able to turn
/// the flange about any axis, else the step is not finite or far too long.
#[inline(always)]
pub(crate) fn newton_step<T: Real>(jacobian: &[[T; 6]; 6], twist: &[T; 6]) -> ([T; 6], [T; 2]) {
    let (v1, v2) = (block(jacobian, 0, 0), block(jacobian, 0, 3));
    let (w1, w2) = (block(jacobian, 3, 0), block(jacobian, 3, 3));
    let ([vx, vy, vz, wx, wy, wz], minus, one) = (*twist, T::splat(-1.0), T::splat(1.0));
    let turn = [wx, wy, wz];
    let (wrist, wrist_det) = adjugate(&w2);
    let wrist = scale_rows(&wrist, one / wrist_det);
    let carried = scale_rows(&mul(&v2, &wrist), minus);
    let shifted = mul(&carried, &w1);
    let arm: Mat3<T> = [add(&v1[0], &shifted[0]), add(&v1[1], &shifted[1]), add(&v1[2], &shifted[2])];
    let (inverse, arm_det) = adjugate(&arm);
    let [q1, q2, q3] = scale(&apply(&inverse, &add(&[vx, vy, vz], &apply(&carried, &turn))), one / arm_det);
    let [q4, q5, q6] = apply(&wrist, &sub(&turn, &apply(&w1, &[q1, q2, q3])));
    ([q1, q2, q3, q4, q5, q6], [wrist_det, arm_det])
}

#[inline(always)]
fn block<T: Real>(a: &[[T; 6]; 6], row: usize, column: usize) -> Mat3<T> {
    [three(&a[row], column), three(&a[row + 1], column), three(&a[row + 2], column)]
}

#[inline(always)]
fn three<T: Real>(row: &[T; 6], column: usize) -> Vec3<T> {
    [row[column], row[column + 1], row[column + 2]]
}

#[inline(always)]
fn scale_rows<T: Real>(a: &Mat3<T>, s: T) -> Mat3<T> {
    [scale(&a[0], s), scale(&a[1], s), scale(&a[2], s)]
}

/// Determinants this small, of unit vectors and of metres, are nothing but rounding.
pub(crate) const SINGULAR: f64 = 1e-9;

/// Newton's step and the sign of the Jacobian's determinant; `None` in a singularity.
#[inline]
pub(crate) fn regular_newton_step(jacobian: &Mat6, twist: &Vec6) -> Option<(Vec6, f64)> {
    let (step, [wrist, arm]) = newton_step(jacobian, twist);
    (wrist.abs() > SINGULAR && arm.abs() > SINGULAR).then(|| (step, (wrist * arm).signum()))
}

/// `(aᵀ a + damping) x = aᵀ b`: Levenberg's step. `None` where rounding has eaten the matrix.
pub(crate) fn solve_damped(a: &Mat6, b: &Vec6, damping: f64) -> Option<Vec6> {
    let mut normal = [[0.0; 6]; 6];
    let mut right = [0.0; 6];
    for (row, b) in a.iter().zip(b) {
        for i in 0..6 {
            right[i] += row[i] * b;
            for j in 0..6 {
                normal[i][j] += row[i] * row[j];
            }
        }
    }
    for (i, row) in normal.iter_mut().enumerate() {
        row[i] += damping;
    }
    eliminate(normal, right)
}

/// `a x = b` by elimination with partial pivoting.
fn eliminate(mut a: Mat6, mut b: Vec6) -> Option<Vec6> {
    for k in 0..6 {
        let best = (k..6).fold(k, |best, i| if a[i][k].abs() > a[best][k].abs() { i } else { best });
        a.swap(k, best);
        b.swap(k, best);
        if a[k][k].is_nan() || a[k][k].abs() < 1e-18 {
            return None;
        }
        let (pivot_row, pivot_b) = (a[k], b[k]);
        for (row, b) in a.iter_mut().zip(&mut b).skip(k + 1) {
            let factor = row[k] / pivot_row[k];
            for (value, above) in row.iter_mut().zip(&pivot_row).skip(k) {
                *value -= factor * above;
            }
            *b -= factor * pivot_b;
        }
    }
    for k in (0..6).rev() {
        for j in k + 1..6 {
            b[k] -= a[k][j] * b[j];
        }
        b[k] /= a[k][k];
    }
    Some(b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix6, Vector6};

    fn example() -> (Mat6, Vec6) {
        let a =
            std::array::from_fn(|i| std::array::from_fn(|j| ((i * j * j + 3 * i + 7 * j + 1) as f64).sin()));
        (a, [0.3, -1.0, 0.5, 2.0, -0.25, 1.5])
    }

    #[test]
    fn newtons_step_is_nalgebras_solution_and_the_determinants_multiply_to_its() {
        let (mut a, b) = example();
        for swap in [false, true] {
            if swap {
                a.swap(0, 1);
            }
            let m = Matrix6::from_fn(|i, j| a[i][j]);
            let (x, [wrist, arm]) = newton_step(&a, &b);
            let expected = m.lu().solve(&Vector6::from(b)).unwrap();
            assert!((Vector6::from(x) - expected).norm() < 1e-10 * expected.norm());
            assert!((wrist * arm / m.determinant() - 1.0).abs() < 1e-10);
        }
    }

    #[test]
    fn a_singular_matrix_has_a_damped_solution_only() {
        let (mut a, b) = example();
        a[4] = a[3];
        let (_, [wrist, _]) = newton_step(&a, &b);
        assert!(wrist.abs() < SINGULAR);
        let m = Matrix6::from_fn(|i, j| a[i][j]);
        let expected =
            (m.transpose() * m + Matrix6::identity() * 0.1).lu().solve(&(m.transpose() * Vector6::from(b)));
        let x = solve_damped(&a, &b, 0.1).unwrap();
        assert!((Vector6::from(x) - expected.unwrap()).norm() < 1e-12);
    }
}
