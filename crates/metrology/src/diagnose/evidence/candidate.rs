//! A candidate over a nuisance model: what is left of it, and its evidence.

use super::prior::size_prior;
use super::{EvidencePeak, NuisanceModel};
use crate::diagnose::design::Sums;
use nalgebra::{DMatrix, DVector};

/// A candidate over a nuisance model; [`NuisanceModel::update`] follows a nuisance model that has grown.
pub(crate) struct Projected {
    pub(super) own: DMatrix<f64>,
    with_y: DVector<f64>,
    /// With the geometry's columns.
    pub(super) geometry: DMatrix<f64>,
    /// How many of the nuisance model's directions are projected out.
    known: usize,
}

impl NuisanceModel {
    /// A candidate with the nuisance model's flat columns projected out.
    #[must_use]
    pub(crate) fn project(&self, sums: &Sums) -> Projected {
        let p = sums.own.nrows();
        let geometry = DMatrix::from_fn(self.geometry.len(), p, |g, a| sums.cross[(a, self.geometry[g])]);
        let mut projected = Projected {
            own: sums.own.clone(),
            with_y: sums.cross.column(0).into_owned(),
            geometry,
            known: 0,
        };
        self.update(&mut projected, sums);
        projected
    }

    /// Projects out the directions that the nuisance model has gained.
    pub(crate) fn update(&self, candidate: &mut Projected, sums: &Sums) {
        match sums.own.nrows() {
            0 => {}
            1 => self.update_of(candidate, sums, [0.0; 1]),
            2 => self.update_of(candidate, sums, [0.0; 2]),
            3 => self.update_of(candidate, sums, [0.0; 3]),
            6 => self.update_of(candidate, sums, [0.0; 6]),
            p => self.update_of(candidate, sums, vec![0.0; p]),
        }
    }

    /// The same with room for one number of each parameter: an array where their count is a constant.
    fn update_of(&self, candidate: &mut Projected, sums: &Sums, mut hat: impl AsMut<[f64]>) {
        let hat = hat.as_mut();
        let p = hat.len();
        for direction in &self.directions[candidate.known..] {
            hat.fill(0.0);
            let columns = sums.cross.as_slice().chunks_exact(p);
            for (d, column) in direction.weights.iter().zip(columns).filter(|(d, _)| **d != 0.0) {
                for (to, from) in hat.iter_mut().zip(column) {
                    *to += d * from;
                }
            }
            let own = candidate.own.as_mut_slice().chunks_exact_mut(p);
            for ((own, with_y), along) in own.zip(candidate.with_y.as_mut_slice()).zip(&*hat) {
                *with_y -= along * direction.y;
                for (to, other) in own.iter_mut().zip(&*hat) {
                    *to -= along * other;
                }
            }
            for (a, along) in hat.iter().enumerate() {
                candidate.geometry.column_mut(a).axpy(-along, &direction.geometry, 1.0);
            }
        }
        candidate.known = self.directions.len();
    }

    /// What the flat columns, and geometry at `ratio`, take of a candidate, given as `projected` and by its `sums`: (directions x
    /// parameters), so that the products of two candidates lose the products of these.
    #[must_use]
    pub(crate) fn taken(&self, projected: &Projected, sums: &Sums, ratio: f64) -> DMatrix<f64> {
        let p = sums.own.nrows();
        let flat = self.directions.len();
        let mut taken = DMatrix::zeros(flat + self.lambda.len(), p);
        for (k, direction) in self.directions.iter().enumerate() {
            let columns = sums.cross.as_slice().chunks_exact(p.max(1));
            for (d, column) in direction.weights.iter().zip(columns).filter(|(d, _)| **d != 0.0) {
                for (a, from) in column.iter().enumerate() {
                    taken[(k, a)] += d * from;
                }
            }
        }
        let with_geometry = &self.turn * &projected.geometry;
        for (k, weight) in self.geometry_shares(ratio).enumerate() {
            taken.row_mut(flat + k).copy_from(&(weight * with_geometry.row(k)));
        }
        taken
    }

    /// The same of the data.
    #[must_use]
    pub(crate) fn taken_of_data(&self, ratio: f64) -> DVector<f64> {
        let geometry = self.geometry_shares(ratio).zip(self.gy.iter()).map(|(weight, g)| weight * g);
        DVector::from_iterator(
            self.directions.len() + self.lambda.len(),
            self.directions.iter().map(|direction| direction.y).chain(geometry),
        )
    }

    /// Roots of the share that geometry at `ratio` takes along each of its directions.
    fn geometry_shares(&self, ratio: f64) -> impl Iterator<Item = f64> + '_ {
        let r2 = ratio * ratio;
        self.lambda.iter().map(move |l| (r2 / (1.0 + r2 * l)).sqrt())
    }

    /// Share of the candidate's own signal that the flat columns leave.
    #[must_use]
    pub(crate) fn visible(&self, sums: &Sums) -> f64 {
        let projected = self.project(sums);
        let whole = sums.own.trace();
        if whole > 0.0 { (projected.own.trace() / whole).max(0.0) } else { 0.0 }
    }

    /// Length of a candidate's first column that registration and geometry at `ratio` leave.
    #[must_use]
    pub(crate) fn strength(&self, candidate: &Projected, ratio: f64) -> f64 {
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
    pub(crate) fn evidence(&self, candidate: &Projected) -> EvidencePeak {
        let with_geometry = &self.turn * &candidate.geometry;
        self.over_ratios(self.signal_of_unit_size(candidate), |ratio, terms| {
            self.size_terms(candidate, &with_geometry, ratio, 1, terms);
        })
    }

    /// The few ratios round the null's best at which [`Self::screening_evidence`] looks.
    #[must_use]
    pub(crate) fn screening_grid(&self, null: &EvidencePeak) -> Vec<ScreeningPoint> {
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
    pub(crate) fn evidence_upper_bound(
        &self,
        candidate: &Projected,
        screening_grid: &[ScreeningPoint],
    ) -> f64 {
        let with_geometry = &self.turn * &candidate.geometry;
        screening_grid
            .iter()
            .map(|point| {
                let off: f64 = self
                    .pairs(candidate, &with_geometry, point.ratio)
                    .iter()
                    .filter(|(h, _)| *h > 0.0)
                    .map(|(h, u)| u * u / h)
                    .sum();
                point.base + self.marginal.at(point.q - off).0
            })
            .fold(f64::NEG_INFINITY, f64::max)
    }

    /// A quick estimate of the evidence: the best of few ratios, sizes in steps of four.
    #[must_use]
    pub(crate) fn screening_evidence(
        &self,
        candidate: &Projected,
        screening_grid: &[ScreeningPoint],
    ) -> EvidencePeak {
        let with_geometry = &self.turn * &candidate.geometry;
        let signal_of_unit_size = self.signal_of_unit_size(candidate);
        let mut best = EvidencePeak::NONE;
        let mut terms = Vec::with_capacity(self.size_ratios.len());
        for point in screening_grid {
            self.size_terms(candidate, &with_geometry, point.ratio, 2, &mut terms);
            for &(size, off, gain) in &terms {
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
    fn pairs(&self, candidate: &Projected, with_geometry: &DMatrix<f64>, ratio: f64) -> Pairs {
        if candidate.own.nrows() == 2 {
            return self.two_pairs(candidate, with_geometry, ratio);
        }
        let (own, with_y) = self.reduced(candidate, with_geometry, ratio);
        Pairs::of(own, &with_y)
    }

    /// The same of two parameters, as the thousands of gear lines have.
    fn two_pairs(&self, candidate: &Projected, with_geometry: &DMatrix<f64>, ratio: f64) -> Pairs {
        let mut own = [candidate.own[(0, 0)], candidate.own[(0, 1)], candidate.own[(1, 1)]];
        let mut with_y = [candidate.with_y[0], candidate.with_y[1]];
        if ratio > 0.0 {
            let r2 = ratio * ratio;
            for (k, l) in self.lambda.iter().enumerate() {
                let f = r2 / (1.0 + r2 * l);
                let row = [with_geometry[(k, 0)], with_geometry[(k, 1)]];
                let by = [f * row[0], f * row[1]];
                with_y[0] -= by[0] * self.gy[k];
                with_y[1] -= by[1] * self.gy[k];
                own[0] -= by[0] * row[0];
                own[1] -= by[0] * row[1];
                own[2] -= by[1] * row[1];
            }
        }
        Pairs::of_two(own, with_y)
    }

    /// The candidate with itself and with the data, geometry at `ratio` out.
    pub(super) fn reduced(
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
    pub(crate) fn sign(&self, candidate: &Projected, peak: &EvidencePeak) -> f64 {
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

    /// For each size ratio, or every `step`-th: it, what it takes off the squares, and what it adds to ln evidence; into `terms`.
    fn size_terms(
        &self,
        candidate: &Projected,
        with_geometry: &DMatrix<f64>,
        ratio: f64,
        step: usize,
        terms: &mut Vec<(f64, f64, f64)>,
    ) {
        let pairs = self.pairs(candidate, with_geometry, ratio);
        terms.clear();
        terms.extend(self.size_ratios.iter().step_by(step).map(|&size| {
            let s2 = size * size;
            let mut off = 0.0;
            let mut log_det = 0.0;
            let mut det = 1.0_f64;
            for &(h, u) in pairs.iter() {
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

/// One geometry ratio prepared for a first look.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScreeningPoint {
    ratio: f64,
    q: f64,
    base: f64,
    sigma_m: f64,
}

/// Eigenvalues of a candidate's matrix with its products with the data turned into its eigenvectors.
enum Pairs {
    /// Of one or two parameters; a missing second is zero, which takes and prices nothing.
    Few([(f64, f64); 2]),
    /// Of three parameters and more.
    Many(Vec<(f64, f64)>),
}

impl Pairs {
    fn of_two([a, b, d]: [f64; 3], with_y: [f64; 2]) -> Self {
        let angle = 0.5 * (2.0 * b).atan2(a - d);
        let (s, c) = angle.sin_cos();
        let first = a * c * c + 2.0 * b * s * c + d * s * s;
        Self::Few([(first, c * with_y[0] + s * with_y[1]), (a + d - first, c * with_y[1] - s * with_y[0])])
    }

    fn of(own: DMatrix<f64>, with_y: &DVector<f64>) -> Self {
        if own.nrows() == 1 {
            return Self::Few([(own[(0, 0)], with_y[0]), (0.0, 0.0)]);
        }
        let eigen = own.symmetric_eigen();
        let turned = eigen.eigenvectors.transpose() * with_y;
        Self::Many(eigen.eigenvalues.iter().copied().zip(turned.iter().copied()).collect())
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
