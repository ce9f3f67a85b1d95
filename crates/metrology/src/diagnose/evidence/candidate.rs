//! A candidate over a nuisance model: what is left of it, and its evidence.

use super::prior::size_prior;
use super::{EvidencePeak, NuisanceModel};
use crate::diagnose::design::Sums;
use nalgebra::{DMatrix, DVector};

/// A candidate over a nuisance model; [`NuisanceModel::update`] follows a nuisance model that has grown.
pub struct Projected {
    own: DMatrix<f64>,
    with_y: DVector<f64>,
    /// With the geometry's columns.
    geometry: DMatrix<f64>,
    /// Along each of the nuisance model's directions.
    hat: Vec<DVector<f64>>,
}

impl NuisanceModel {
    /// A candidate with the nuisance model's flat columns projected out.
    #[must_use]
    pub fn project(&self, sums: &Sums) -> Projected {
        let p = sums.own.nrows();
        let geometry = DMatrix::from_fn(self.geometry.len(), p, |g, a| sums.cross[(a, self.geometry[g])]);
        let mut projected = Projected {
            own: sums.own.clone(),
            with_y: sums.cross.column(0).into_owned(),
            geometry,
            hat: Vec::with_capacity(self.directions.len()),
        };
        self.update(&mut projected, sums);
        projected
    }

    /// Projects out the directions that the nuisance model has gained.
    pub fn update(&self, candidate: &mut Projected, sums: &Sums) {
        let p = sums.own.nrows();
        for k in candidate.hat.len()..self.directions.len() {
            let mut hat = DVector::<f64>::zeros(p);
            for (c, d) in self.directions[k].iter().enumerate().filter(|(_, d)| **d != 0.0) {
                for a in 0..p {
                    hat[a] += d * sums.cross[(a, c)];
                }
            }
            for a in 0..p {
                candidate.with_y[a] -= hat[a] * self.y_hat[k];
                for b in 0..p {
                    candidate.own[(a, b)] -= hat[a] * hat[b];
                }
                candidate.geometry.column_mut(a).axpy(-hat[a], &self.geometry_hat[k], 1.0);
            }
            candidate.hat.push(hat);
        }
    }

    /// Share of the candidate's own signal that the flat columns leave.
    #[must_use]
    pub fn visible(&self, sums: &Sums) -> f64 {
        let projected = self.project(sums);
        let whole = sums.own.trace();
        if whole > 0.0 { (projected.own.trace() / whole).max(0.0) } else { 0.0 }
    }

    /// Length of a candidate's first column that registration and geometry at `ratio` leave.
    #[must_use]
    pub fn strength(&self, candidate: &Projected, ratio: f64) -> f64 {
        let r2 = ratio * ratio;
        let mut own = candidate.own[(0, 0)];
        let with_geometry = &self.turn * candidate.geometry.column(0);
        for (l, g) in self.lambda.iter().zip(with_geometry.iter()) {
            own -= r2 / (1.0 + r2 * l) * g.powi(2);
        }
        own.max(0.0).sqrt()
    }

    /// Evidence of a projected candidate.
    #[must_use]
    pub fn evidence(&self, candidate: &Projected) -> EvidencePeak {
        let with_geometry = &self.turn * &candidate.geometry;
        self.over_ratios(self.signal_of_unit_size(candidate), |ratio| {
            self.size_terms(candidate, &with_geometry, ratio)
        })
    }

    /// The few ratios round the null's best at which [`Self::screening_evidence`] looks.
    #[must_use]
    pub fn screening_grid(&self, null: &EvidencePeak) -> Vec<ScreeningPoint> {
        [0.0, null.geometry_ratio, 0.25 * null.geometry_ratio]
            .into_iter()
            .map(|ratio| {
                let (log, sigma_m) = self.at_ratio(ratio);
                let (q, _) = self.with_ratio(ratio);
                ScreeningPoint {
                    ratio,
                    q,
                    base: log - self.marginal.at(q).0 - 0.5 * self.slow_log_det,
                    sigma_m,
                }
            })
            .collect()
    }

    /// No evidence of the candidate at these ratios is above this: its whole signal at no price.
    #[must_use]
    pub fn evidence_upper_bound(&self, candidate: &Projected, screening_grid: &[ScreeningPoint]) -> f64 {
        let with_geometry = &self.turn * &candidate.geometry;
        screening_grid
            .iter()
            .map(|point| {
                let off: f64 = self
                    .pairs(candidate, &with_geometry, point.ratio)
                    .into_iter()
                    .filter(|(h, _)| *h > 0.0)
                    .map(|(h, u)| u * u / h)
                    .sum();
                point.base + self.marginal.at(point.q - off).0
            })
            .fold(f64::NEG_INFINITY, f64::max)
    }

    /// A quick estimate of the evidence: the best of few ratios, sizes in steps of four.
    #[must_use]
    pub fn screening_evidence(
        &self,
        candidate: &Projected,
        screening_grid: &[ScreeningPoint],
    ) -> EvidencePeak {
        let with_geometry = &self.turn * &candidate.geometry;
        let signal_of_unit_size = self.signal_of_unit_size(candidate);
        let mut best = EvidencePeak::NONE;
        for point in screening_grid {
            let terms = self.size_terms(candidate, &with_geometry, point.ratio);
            for (size, off, gain) in terms.into_iter().step_by(2) {
                let (log, sigma_m) = self.marginal.at(point.q - off);
                let log =
                    point.base + log + gain + size_prior(size * point.sigma_m, size * signal_of_unit_size);
                if log > best.log_evidence {
                    best = EvidencePeak {
                        log_evidence: log,
                        sigma_m,
                        geometry_ratio: point.ratio,
                        size_ratio: size,
                    };
                }
            }
        }
        best
    }

    /// Root mean square over the rows of the signal of one prior sigma, metres.
    fn signal_of_unit_size(&self, candidate: &Projected) -> f64 {
        (candidate.own.trace().max(0.0) / self.m).sqrt()
    }

    /// The candidate's signal and its product with the data along its own directions, geometry at `ratio` out.
    fn pairs(&self, candidate: &Projected, with_geometry: &DMatrix<f64>, ratio: f64) -> Vec<(f64, f64)> {
        let (own, with_y) = self.reduced(candidate, with_geometry, ratio);
        diagonal(own, &with_y)
    }

    /// The candidate with itself and with the data, geometry at `ratio` out.
    fn reduced(
        &self,
        candidate: &Projected,
        with_geometry: &DMatrix<f64>,
        ratio: f64,
    ) -> (DMatrix<f64>, DVector<f64>) {
        let p = candidate.own.nrows();
        let mut own = candidate.own.clone();
        let mut with_y = candidate.with_y.clone();
        if ratio > 0.0 {
            let r2 = ratio * ratio;
            for (k, l) in self.lambda.iter().enumerate() {
                let f = r2 / (1.0 + r2 * l);
                let row = with_geometry.row(k);
                for a in 0..p {
                    let fa = f * row[a];
                    with_y[a] -= fa * self.gy[k];
                    for b in 0..p {
                        own[(a, b)] -= fa * row[b];
                    }
                }
            }
        }
        (own, with_y)
    }

    /// By how many standard deviations the candidate's first parameter is positive where it `peak` most.
    #[must_use]
    pub fn sign(&self, candidate: &Projected, peak: &EvidencePeak) -> f64 {
        let with_geometry = &self.turn * &candidate.geometry;
        let (mut own, with_y) = self.reduced(candidate, &with_geometry, peak.geometry_ratio);
        let precision = peak.size_ratio.max(1e-12).powi(-2);
        for a in 0..own.nrows() {
            own[(a, a)] += precision;
        }
        let Some(covariance) = own.cholesky().map(|c| c.inverse()) else { return 0.0 };
        let mean = (covariance.row(0) * &with_y)[0];
        mean / (peak.sigma_m * covariance[(0, 0)].max(1e-300).sqrt())
    }

    /// For each size ratio: it, what it takes off the squares, and what it adds to ln evidence.
    fn size_terms(
        &self,
        candidate: &Projected,
        with_geometry: &DMatrix<f64>,
        ratio: f64,
    ) -> Vec<(f64, f64, f64)> {
        let pairs = self.pairs(candidate, with_geometry, ratio);
        self.size_ratios
            .iter()
            .map(|&size| {
                let s2 = size * size;
                let mut off = 0.0;
                let mut log_det = 0.0;
                let mut det = 1.0_f64;
                for &(h, u) in &pairs {
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
            })
            .collect()
    }
}

/// One geometry ratio prepared for a first look.
#[derive(Clone, Copy, Debug)]
pub struct ScreeningPoint {
    ratio: f64,
    q: f64,
    base: f64,
    sigma_m: f64,
}

/// Eigenvalues of `own` with `with_y` turned into its eigenvectors.
fn diagonal(own: DMatrix<f64>, with_y: &DVector<f64>) -> Vec<(f64, f64)> {
    match own.nrows() {
        1 => vec![(own[(0, 0)], with_y[0])],
        2 => {
            let (a, b, d) = (own[(0, 0)], own[(0, 1)], own[(1, 1)]);
            let angle = 0.5 * (2.0 * b).atan2(a - d);
            let (s, c) = angle.sin_cos();
            let first = a * c * c + 2.0 * b * s * c + d * s * s;
            vec![(first, c * with_y[0] + s * with_y[1]), (a + d - first, c * with_y[1] - s * with_y[0])]
        }
        _ => {
            let eigen = own.symmetric_eigen();
            let turned = eigen.eigenvectors.transpose() * with_y;
            eigen.eigenvalues.iter().copied().zip(turned.iter().copied()).collect()
        }
    }
}
