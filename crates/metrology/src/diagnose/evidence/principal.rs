//! A candidate along its own directions, where its parameters part: what each takes of the data, and what its freedom costs.

use nalgebra::{DMatrix, DVector};
use std::ops::Deref;

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

/// All directions of a candidate.
#[derive(Clone)]
pub(super) enum PrincipalDirections {
    /// Of one or two parameters; the second may be missing.
    Few([PrincipalDirection; 2]),
    /// Of three parameters and more.
    Many(Vec<PrincipalDirection>),
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

    /// Of a candidate's products with itself and with the data.
    pub(super) fn of(own: DMatrix<f64>, with_y: &DVector<f64>) -> Self {
        if own.nrows() == 1 {
            let only = PrincipalDirection { eigenvalue: own[(0, 0)], with_y: with_y[0] };
            return Self::Few([only, PrincipalDirection::MISSING]);
        }
        let eigen = own.symmetric_eigen();
        let turned = eigen.eigenvectors.transpose() * with_y;
        let pairs = eigen.eigenvalues.iter().zip(turned.iter());
        Self::Many(pairs.map(|(&eigenvalue, &with_y)| PrincipalDirection { eigenvalue, with_y }).collect())
    }

    /// What a candidate of size `ratio` takes off the squares: never less for a larger one.
    pub(super) fn explained(&self, ratio: f64) -> f64 {
        let s2 = ratio * ratio;
        self.iter().map(|d| s2 / (1.0 + s2 * d.eigenvalue.max(0.0)) * d.with_y * d.with_y).sum()
    }

    /// What a candidate does whose size costs nothing: squares of the data, all directions in which there is signal taken.
    pub(super) fn explained_at_no_price(&self) -> f64 {
        let seen = self.iter().filter(|along| along.eigenvalue > 0.0);
        seen.map(|along| along.with_y * along.with_y / along.eigenvalue).sum()
    }

    /// What a candidate of each of these sizes does, into `terms`.
    pub(super) fn size_terms<'s>(&self, ratios: impl Iterator<Item = &'s f64>, terms: &mut Vec<SizeTerm>) {
        terms.clear();
        terms.extend(ratios.map(|&ratio| self.size_term(ratio)));
    }

    /// What a candidate of size `ratio` does.
    pub(super) fn size_term(&self, ratio: f64) -> SizeTerm {
        let s2 = ratio * ratio;
        let mut explained = 0.0;
        let mut log_det = 0.0;
        let mut det = 1.0_f64;
        for direction in self.iter() {
            let (h, u) = (direction.eigenvalue.max(0.0), direction.with_y);
            explained += s2 / (1.0 + s2 * h) * u * u;
            det *= 1.0 + s2 * h;
            // One logarithm for many factors, short of overflow.
            if det > 1e100 {
                log_det += det.ln();
                det = 1.0;
            }
        }
        SizeTerm { ratio, explained, log_occam: -0.5 * (log_det + det.ln()) }
    }
}

impl Deref for PrincipalDirections {
    type Target = [PrincipalDirection];

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Few(directions) => directions,
            Self::Many(directions) => directions,
        }
    }
}
