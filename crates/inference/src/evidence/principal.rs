//! A candidate along its own directions, where its parameters part: what each takes of the data, and what its freedom costs.

use super::tridiagonal::Tridiagonal;

/// A candidate along one eigenvector of its products with itself.
#[derive(Clone, Copy)]
pub(super) struct PrincipalDirection {
    /// Eigenvalue: the square of its signal, registration and geometry out.
    pub eigenvalue: f64,
    /// Product of its signal with the data.
    pub with_y: f64,
}

impl PrincipalDirection {
    /// A parameter that is not there: it takes nothing and costs nothing.
    const MISSING: Self = Self { eigenvalue: 0.0, with_y: 0.0 };
}

/// A candidate in parameters of which each goes with few others.
#[derive(Clone)]
pub(super) enum PrincipalDirections {
    /// One or two parameters along their eigenvectors; the second may be missing.
    Few([PrincipalDirection; 2]),
    /// Three parameters and more.
    Many(Tridiagonal),
}

/// What a candidate of one size does to the evidence.
#[derive(Clone, Copy)]
pub(super) struct SizeTerm {
    /// The size, s / sigma.
    pub ratio: f64,
    /// What it takes off the squares of the data.
    pub explained: f64,
    /// The Occam factor (MacKay 1992): what its freedom adds to ln evidence, at most 0.
    pub log_occam: f64,
}

impl SizeTerm {
    /// That of no candidate at all.
    pub(super) const NOTHING: Self = Self { ratio: 0.0, explained: 0.0, log_occam: 0.0 };
}

impl PrincipalDirections {
    /// Of a matrix of two parameters, its upper triangle row by row, in closed form.
    pub(super) fn of_two([a, b, d]: [f64; 3], with_y: [f64; 2]) -> Self {
        let angle = 0.5 * (2.0 * b).atan2(a - d);
        let (s, c) = angle.sin_cos();
        let first = a * c * c + 2.0 * b * s * c + d * s * s;
        Self::Few([
            PrincipalDirection { eigenvalue: first, with_y: c * with_y[0] + s * with_y[1] },
            PrincipalDirection { eigenvalue: a + d - first, with_y: c * with_y[1] - s * with_y[0] },
        ])
    }

    /// A candidate of one parameter, which is its own direction.
    pub(super) fn of_one(eigenvalue: f64, with_y: f64) -> Self {
        Self::Few([PrincipalDirection { eigenvalue, with_y }, PrincipalDirection::MISSING])
    }

    /// What a candidate of size `ratio` takes off the squares: never less for a larger one.
    pub(super) fn explained(&self, ratio: f64) -> f64 {
        self.explained_of_variance(ratio * ratio, |_| ())
    }

    /// The same where its parameters have the variance `s2`; `pivot` is handed the factors of the determinant of their covariance
    /// beside the noise's.
    fn explained_of_variance(&self, s2: f64, mut pivot: impl FnMut(f64)) -> f64 {
        match self {
            Self::Few(directions) => directions
                .iter()
                .map(|PrincipalDirection { eigenvalue, with_y }| {
                    let factor = 1.0 + s2 * eigenvalue.max(0.0);
                    pivot(factor);
                    s2 / factor * with_y * with_y
                })
                .sum(),
            Self::Many(chain) => chain.explained(s2, pivot),
        }
    }

    /// What a candidate of each of these sizes does, into `terms`.
    pub(super) fn size_terms<'s>(&self, ratios: impl Iterator<Item = &'s f64>, terms: &mut Vec<SizeTerm>) {
        terms.clear();
        terms.extend(ratios.map(|&ratio| self.size_term(ratio)));
    }

    /// What a candidate of size `ratio` does.
    pub(super) fn size_term(&self, ratio: f64) -> SizeTerm {
        let mut log_det = 0.0;
        let mut det = 1.0_f64;
        let explained = self.explained_of_variance(ratio * ratio, |factor| {
            det *= factor;
            // One logarithm for many factors, short of overflow.
            if det > 1e100 {
                log_det += det.ln();
                det = 1.0;
            }
        });
        SizeTerm { ratio, explained, log_occam: -0.5 * (log_det + det.ln()) }
    }
}
