//! Six equations in six unknowns, on plain arrays.

pub(crate) type Vec6 = [f64; 6];
pub(crate) type Mat6 = [[f64; 6]; 6];

/// `a x = b` by elimination with partial pivoting; with it the sign of det a. `None` where a pivot is nothing but
/// rounding.
#[inline]
pub(crate) fn solve(a: &Mat6, b: &Vec6) -> Option<(Vec6, f64)> {
    let (mut a, mut b) = (*a, *b);
    let mut sign = 1.0;
    for k in 0..6 {
        let mut best = k;
        for i in k + 1..6 {
            if a[i][k].abs() > a[best][k].abs() {
                best = i;
            }
        }
        if best != k {
            a.swap(k, best);
            b.swap(k, best);
            sign = -sign;
        }
        let pivot = a[k][k];
        // Entries are lengths of an arm in metres and unit vectors.
        if pivot.is_nan() || pivot.abs() < 1e-14 {
            return None;
        }
        sign *= pivot.signum();
        let inverse = 1.0 / pivot;
        let (pivot_row, pivot_b) = (a[k], b[k]);
        for (row, b) in a.iter_mut().zip(&mut b).skip(k + 1) {
            let factor = row[k] * inverse;
            for (value, above) in row.iter_mut().zip(&pivot_row).skip(k + 1) {
                *value -= factor * above;
            }
            *b -= factor * pivot_b;
        }
        a[k][k] = inverse;
    }
    for k in (0..6).rev() {
        for j in k + 1..6 {
            b[k] -= a[k][j] * b[j];
        }
        b[k] *= a[k][k];
    }
    Some((b, sign))
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
    solve(&normal, &right).map(|(x, _)| x)
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
    fn solves_as_nalgebra_does_and_gives_the_sign_of_the_determinant() {
        let (mut a, b) = example();
        for swap in [false, true] {
            if swap {
                a.swap(0, 3);
            }
            let m = Matrix6::from_fn(|i, j| a[i][j]);
            let (x, sign) = solve(&a, &b).unwrap();
            let expected = m.lu().solve(&Vector6::from(b)).unwrap();
            assert!((Vector6::from(x) - expected).norm() < 1e-10 * expected.norm());
            assert_eq!(sign, m.determinant().signum());
        }
    }

    #[test]
    fn a_singular_matrix_has_no_solution_but_a_damped_one() {
        let (mut a, b) = example();
        a[4] = a[2];
        assert!(solve(&a, &b).is_none());
        let m = Matrix6::from_fn(|i, j| a[i][j]);
        let expected =
            (m.transpose() * m + Matrix6::identity() * 0.1).lu().solve(&(m.transpose() * Vector6::from(b)));
        let x = solve_damped(&a, &b, 0.1).unwrap();
        assert!((Vector6::from(x) - expected.unwrap()).norm() < 1e-12);
    }
}
