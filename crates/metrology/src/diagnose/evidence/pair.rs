//! Two candidates at once, each with a size of its own that is integrated: what the first takes alone, and how large it must then
//! be, is not held against it beside the second.

use super::candidate::Projected;
use super::prior::size_prior;
use super::{NuisanceModel, log_add};
use crate::diagnose::design::Sums;
use nalgebra::{DMatrix, DVector};

/// Doublings to either side of the sizes at which a pair was seen; where the best lies at an end, it is gone on from there.
const DOUBLINGS: i32 = 2;
const MOST_STEPS: usize = 4;

/// What two candidates reach together.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PairPeak {
    /// ln evidence, up to a constant shared by all on the same nuisance model.
    pub log_evidence: f64,
    /// Best s / sigma of each.
    pub size_ratios: [f64; 2],
    /// By how many standard deviations the first parameter of each is positive there.
    pub signs: [f64; 2],
}

/// The products of two candidates side by side: `second`'s with the design hold those with the first, whose columns stand at `at`.
#[must_use]
pub(crate) fn joined(first: &Sums, second: &Sums, at: &[usize]) -> Sums {
    let (a, b) = (first.own.nrows(), second.own.nrows());
    let width = first.cross.ncols().min(second.cross.ncols());
    let own = DMatrix::from_fn(a + b, a + b, |r, c| match (r < a, c < a) {
        (true, true) => first.own[(r, c)],
        (false, false) => second.own[(r - a, c - a)],
        (false, true) => second.cross[(r - a, at[c])],
        (true, false) => second.cross[(c - a, at[r])],
    });
    let cross = DMatrix::from_fn(a + b, width, |r, c| match r < a {
        true => first.cross[(r, c)],
        false => second.cross[(r - a, c)],
    });
    Sums { own, cross }
}

impl NuisanceModel {
    /// Evidence of two candidates, `both` side by side with `first` parameters of the first, sizes summed about the best, which is
    /// looked for from `near` on.
    #[must_use]
    pub(crate) fn evidence_of_two(&self, both: &Projected, first: usize, near: [f64; 2]) -> PairPeak {
        let mut peak = self.evidence_about(both, first, near);
        let mut from = near;
        for _ in 0..MOST_STEPS {
            let end = |k: usize| (peak.size_ratios[k] / from[k]).log2().abs() > f64::from(DOUBLINGS) - 0.5;
            if !(end(0) || end(1)) {
                break;
            }
            from = peak.size_ratios;
            peak = self.evidence_about(both, first, from);
        }
        peak
    }

    /// The same with sizes summed about `near` alone.
    pub(super) fn evidence_about(&self, both: &Projected, first: usize, near: [f64; 2]) -> PairPeak {
        let p = both.own.nrows();
        let with_geometry = self.along_geometry(both);
        let signal = |from: usize, to: usize| {
            ((from..to).map(|k| both.own[(k, k)]).sum::<f64>().max(0.0) / self.m).sqrt()
        };
        let signals = [signal(0, first), signal(first, p)];
        let sizes = near.map(|near| (-DOUBLINGS..=DOUBLINGS).map(move |k| near * f64::from(k).exp2()));
        let mut total = f64::NEG_INFINITY;
        let mut best = (f64::NEG_INFINITY, 0.0, near, 0.0);
        for (&ratio, &(q, log_det)) in self.ratios.iter().zip(&self.at_ratios) {
            let (own, with_y) = self.reduced(both, &with_geometry, ratio);
            for s in sizes[0].clone() {
                for t in sizes[1].clone() {
                    let scale = |k: usize| if k < first { s } else { t };
                    let normal = normal_matrix(&own, scale);
                    let Some(cholesky) = normal.cholesky() else { continue };
                    let lower = cholesky.l_dirty();
                    let half_log_det: f64 = (0..p).map(|k| lower[(k, k)].ln()).sum();
                    let mut half = DVector::from_fn(p, |k, _| scale(k) * with_y[k]);
                    lower.solve_lower_triangular_mut(&mut half);
                    let (log, sigma_m) = self.marginal.at(q - half.norm_squared());
                    let log = log - 0.5 * log_det - half_log_det
                        + super::geometry_prior(ratio * sigma_m)
                        + size_prior(s * sigma_m, s * signals[0])
                        + size_prior(t * sigma_m, t * signals[1]);
                    total = log_add(total, log);
                    if log > best.0 {
                        best = (log, ratio, [s, t], sigma_m);
                    }
                }
            }
        }
        let (_, ratio, size_ratios, sigma_m) = best;
        PairPeak {
            log_evidence: total - 0.5 * self.slow_log_det,
            size_ratios,
            signs: self.signs(both, &with_geometry, first, (ratio, size_ratios, sigma_m)),
        }
    }

    /// By how many standard deviations the first parameter of each is positive at the peak.
    fn signs(
        &self,
        both: &Projected,
        with_geometry: &DMatrix<f64>,
        first: usize,
        (ratio, [s, t], sigma_m): (f64, [f64; 2], f64),
    ) -> [f64; 2] {
        let (own, with_y) = self.reduced(both, with_geometry, ratio);
        let scale = |k: usize| if k < first { s } else { t };
        let Some(covariance) = normal_matrix(&own, scale).cholesky().map(|c| c.inverse()) else {
            return [0.0; 2];
        };
        let scaled = DVector::from_fn(with_y.len(), |k, _| scale(k) * with_y[k]);
        [0, first].map(|k| {
            let mean = (covariance.row(k) * &scaled)[0];
            mean / (sigma_m * covariance[(k, k)].max(1e-300).sqrt())
        })
    }
}

/// I + S `own` S with sizes S on the diagonal.
fn normal_matrix(own: &DMatrix<f64>, scale: impl Fn(usize) -> f64) -> DMatrix<f64> {
    DMatrix::from_fn(own.nrows(), own.ncols(), |r, c| {
        scale(r) * scale(c) * own[(r, c)] + f64::from(u8::from(r == c))
    })
}
