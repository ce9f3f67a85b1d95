//! A candidate along its own directions, where its parameters part: what each takes of the data, and what its freedom costs.

use nalgebra::{DMatrix, DVector};

/// Eigenvalues of a candidate's matrix with its products with the data turned into its eigenvectors.
#[derive(Clone)]
pub(super) enum Pairs {
    /// Of one or two parameters; a missing second is zero, which takes and prices nothing.
    Few([(f64, f64); 2]),
    /// Of three parameters and more.
    Many(Vec<(f64, f64)>),
}

impl Pairs {
    pub(super) fn of_two([a, b, d]: [f64; 3], with_y: [f64; 2]) -> Self {
        let angle = 0.5 * (2.0 * b).atan2(a - d);
        let (s, c) = angle.sin_cos();
        let first = a * c * c + 2.0 * b * s * c + d * s * s;
        Self::Few([(first, c * with_y[0] + s * with_y[1]), (a + d - first, c * with_y[1] - s * with_y[0])])
    }

    pub(super) fn of(own: DMatrix<f64>, with_y: &DVector<f64>) -> Self {
        if own.nrows() == 1 {
            return Self::Few([(own[(0, 0)], with_y[0]), (0.0, 0.0)]);
        }
        let eigen = own.symmetric_eigen();
        let turned = eigen.eigenvectors.transpose() * with_y;
        Self::Many(eigen.eigenvalues.iter().copied().zip(turned.iter().copied()).collect())
    }

    /// What a candidate of this size takes off the squares: never less for a larger one.
    pub(super) fn taken(&self, size: f64) -> f64 {
        let s2 = size * size;
        self.iter().map(|&(h, u)| s2 / (1.0 + s2 * h.max(0.0)) * u * u).sum()
    }

    /// For each of `sizes`: it, what it takes off the squares, and what it adds to ln evidence; into `terms`.
    pub(super) fn size_terms<'s>(
        &self,
        sizes: impl Iterator<Item = &'s f64>,
        terms: &mut Vec<(f64, f64, f64)>,
    ) {
        terms.clear();
        terms.extend(sizes.map(|&size| {
            let s2 = size * size;
            let mut off = 0.0;
            let mut log_det = 0.0;
            let mut det = 1.0_f64;
            for &(h, u) in self.iter() {
                let h = h.max(0.0);
                off += s2 / (1.0 + s2 * h) * u * u;
                det *= 1.0 + s2 * h;
                // One logarithm for many factors, short of overflow.
                if det > 1e100 {
                    log_det += det.ln();
                    det = 1.0;
                }
            }
            (size, off, -0.5 * (log_det + det.ln()))
        }));
    }
}

impl std::ops::Deref for Pairs {
    type Target = [(f64, f64)];

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Few(pairs) => pairs,
            Self::Many(pairs) => pairs,
        }
    }
}
