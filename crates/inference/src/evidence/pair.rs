//! Two candidates at once, each with a size of its own that is integrated: what the first takes alone, and how large it must then
//! be, is not held against it beside the second.

use super::about_zero::SizeAndConstant;
use super::candidate::{Projected, ReducedProducts};
use super::prior::{geometry_prior, size_prior};
use super::sum::{EvidencePeak, EvidenceSum};
use super::{GeometryTerm, NuisanceModel};
use crate::design::Sums;
use crate::marginal::NoiseIntegral;
use nalgebra::{DMatrix, DVector};

/// Doublings to either side of the sizes at which a pair was seen; where the best lies at an end, it is gone on from there.
const DOUBLINGS: i32 = 2;
const MOST_STEPS: usize = 4;

/// What two candidates reach together.
#[derive(Clone, Copy, Debug)]
pub struct PairPeak {
    /// ln evidence, up to a constant shared by all on the same nuisance model.
    pub log_evidence: f64,
    /// Best s / sigma of each.
    pub size_ratios: [f64; 2],
    /// By how many standard deviations the first parameter of each is positive there.
    pub signs: [f64; 2],
    /// What it adds to the evidence there if the second of two parameters is the first about a zero of its own.
    pub about_zero_nats: [f64; 2],
}

/// The products of two candidates side by side: `second`'s with the design hold those with the first, whose columns stand at `at`.
#[must_use]
pub fn joined(first: &Sums, second: &Sums, at: &[usize]) -> Sums {
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
    pub fn evidence_of_two(&self, both: &Projected, first: usize, near: [f64; 2]) -> PairPeak {
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
        let mut sum = EvidenceSum::new(near);
        for geometry in &self.geometry_terms {
            let reduced = self.reduced(both, &with_geometry, geometry.ratio);
            for s in sizes[0].clone() {
                for t in sizes[1].clone() {
                    if let Some(term) = self.pair_term(geometry, &reduced, first, [s, t], signals) {
                        sum.add(term);
                    }
                }
            }
        }
        let peak = sum.peak(self.slow_log_det);
        self.pair_peak(both, &with_geometry, first, &peak)
    }

    /// What two candidates of these sizes reach beside geometry of one, which has left them `reduced`. `signals` are those of one
    /// usual size of each.
    fn pair_term(
        &self,
        geometry: &GeometryTerm,
        reduced: &ReducedProducts,
        first: usize,
        size_ratio: [f64; 2],
        signals: [f64; 2],
    ) -> Option<EvidencePeak<[f64; 2]>> {
        let [s, t] = size_ratio;
        let scale = |k: usize| if k < first { s } else { t };
        let p = reduced.with_y.len();
        let cholesky = normal_matrix(&reduced.own, scale).cholesky()?;
        let lower = cholesky.l_dirty();
        let half_log_det: f64 = (0..p).map(|k| lower[(k, k)].ln()).sum();
        let mut half = DVector::from_fn(p, |k, _| scale(k) * reduced.with_y[k]);
        lower.solve_lower_triangular_mut(&mut half);
        let NoiseIntegral { log, sigma_m } = self.marginal.at(geometry.squares - half.norm_squared());
        let log_evidence = log - 0.5 * geometry.log_det - half_log_det
            + geometry_prior(geometry.ratio * sigma_m, geometry.rho, self.most_size)
            + size_prior(s * sigma_m, s * signals[0], self.most_size)
            + size_prior(t * sigma_m, t * signals[1], self.most_size);
        Some(EvidencePeak { log_evidence, sigma_m, geometry_ratio: geometry.ratio, size_ratio })
    }

    /// The peak with what is known of the parameters of each there.
    fn pair_peak(
        &self,
        both: &Projected,
        with_geometry: &DMatrix<f64>,
        first: usize,
        peak: &EvidencePeak<[f64; 2]>,
    ) -> PairPeak {
        let (log_evidence, size_ratios) = (peak.log_evidence, peak.size_ratio);
        let unknown = PairPeak { log_evidence, size_ratios, signs: [0.0; 2], about_zero_nats: [0.0; 2] };
        let ReducedProducts { own, with_y } = self.reduced(both, with_geometry, peak.geometry_ratio);
        let [s, t] = peak.size_ratio;
        let scale = |k: usize| if k < first { s } else { t };
        let Some(covariance) = normal_matrix(&own, scale).cholesky().map(|c| c.inverse()) else {
            return unknown;
        };
        let scaled = DVector::from_fn(with_y.len(), |k, _| scale(k) * with_y[k]);
        let mean = &covariance * scaled;
        let signs = [0, first].map(|k| mean[k] / (peak.sigma_m * covariance[(k, k)].max(1e-300).sqrt()));
        let about_zero_nats = [0..first, first..with_y.len()].map(|of| match of.len() {
            2 => {
                let [k, l] = [of.start, of.start + 1];
                // Both over their prior sigma, in metres of noise.
                let covariance = [(k, k), (k, l), (l, l)].map(|at| covariance[at] * peak.sigma_m.powi(2));
                SizeAndConstant { mean: [mean[k], mean[l]], covariance, spread: peak.sigma_m }.nats()
            }
            _ => 0.0,
        });
        PairPeak { signs, about_zero_nats, ..unknown }
    }
}

/// I + S `own` S with sizes S on the diagonal.
fn normal_matrix(own: &DMatrix<f64>, scale: impl Fn(usize) -> f64) -> DMatrix<f64> {
    DMatrix::from_fn(own.nrows(), own.ncols(), |r, c| {
        scale(r) * scale(c) * own[(r, c)] + f64::from(u8::from(r == c))
    })
}
