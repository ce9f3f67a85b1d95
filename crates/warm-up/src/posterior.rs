//! The linear problem for one history of warmth: sums per point, then a small Gaussian over the points' displacements.
//!
//! With the constants projected out each point tells s_k = A_k x + noise of variance sigma^2 / G_k, G_k the spread of its
//! warmth. The evidence is that of s ~ N(0, A S A' + D) times that of what is left about it (Rasmussen and Williams 2006,
//! ch. 2 and 5), over a grid of prior sizes.

use super::parameters::PARAMETERS;
use nalgebra::{Cholesky, DMatrix, DVector, Dyn, Matrix3xX, Vector3};

/// Prior sizes of shifts tried, metres, and of turns, radians.
const SHIFTS_M: [f64; 6] = [5e-6, 1e-5, 2e-5, 4e-5, 8e-5, 1.6e-4];
const TURNS_RAD: [f64; 6] = [1e-5, 2e-5, 4e-5, 8e-5, 1.6e-4, 3.2e-4];

/// What a warming arm usually does: shifts, turns, and how far that may be off, nats. A few hundredths of a millimetre and
/// of a mrad per joint (Heisel, Richter and Wurst 1997); within a factor of two in two of three cases.
const USUAL: [f64; 2] = [3e-5, 8e-5];
const USUAL_SPREAD: f64 = 0.7;

/// What the likelihood needs of the touches of one point.
#[derive(Clone, Debug)]
pub(super) struct Sums {
    signature: Matrix3xX<f64>,
    /// Sum of squared warmth about its mean.
    spread: f64,
    /// Sum of warmth about its mean times displacement, metres.
    cross_m: Vector3<f64>,
    /// Squared displacement about its mean.
    square_m2: f64,
    /// Touches beyond the one that each place of the point has to be known by.
    free: f64,
}

impl Sums {
    /// Of no touch yet.
    pub(super) fn none(signature: &Matrix3xX<f64>) -> Self {
        Self {
            signature: signature.clone(),
            spread: 0.0,
            cross_m: Vector3::zeros(),
            square_m2: 0.0,
            free: 0.0,
        }
    }

    /// Adds the touches of one place of the point: its constant is projected out of them.
    pub(super) fn add_place(&mut self, grown: &[f64], observed_m: &[Vector3<f64>]) {
        if grown.is_empty() {
            return;
        }
        let n = grown.len() as f64;
        let mean = grown.iter().sum::<f64>() / n;
        let mean_m = observed_m.iter().sum::<Vector3<f64>>() / n;
        for (g, observed) in grown.iter().zip(observed_m) {
            let (g, r) = (g - mean, observed - mean_m);
            self.spread += g * g;
            self.cross_m += r * g;
            self.square_m2 += r.norm_squared();
        }
        self.free += n - 1.0;
    }

    /// How far the point moves when settled, by its own touches, metres.
    pub(super) fn settled_m(&self) -> Vector3<f64> {
        self.cross_m / self.spread.max(1e-12)
    }

    /// What is left about that, squared, m2.
    fn left_m2(&self) -> f64 {
        (self.square_m2 - self.cross_m.norm_squared() / self.spread.max(1e-12)).max(0.0)
    }
}

/// What the touches say under one history of warmth.
#[derive(Clone, Debug)]
pub(super) struct Posterior {
    pub(super) log_evidence: f64,
    pub(super) mean: DVector<f64>,
    pub(super) covariance: DMatrix<f64>,
    pub(super) sigma_m: f64,
    /// Prior sizes of shifts and turns, averaged over the posterior.
    pub(super) prior: [f64; 2],
}

/// One size of the prior under one history: its weight, and what is needed for the values.
struct Weighed {
    log_evidence: f64,
    sizes: [f64; 2],
    cholesky: Cholesky<f64, Dyn>,
    solved: DVector<f64>,
}

/// Evidence of one history of warmth, every size of the prior taken in.
pub(super) fn log_evidence(points: &[Sums]) -> Option<f64> {
    let fits = weigh(points)?.fits;
    let most = fits.iter().map(|f| f.log_evidence).fold(f64::NEG_INFINITY, f64::max);
    let total: f64 = fits.iter().map(|f| (f.log_evidence - most).exp()).sum();
    Some(most + total.ln()).filter(|e| e.is_finite())
}

/// The same of no drift at all: every point stands still, and all that its touches scatter is noise.
pub(super) fn log_evidence_of_none(points: &[Sums]) -> f64 {
    let freedom: f64 = points.iter().map(|p| 3.0 * p.free).sum();
    let square_m2: f64 = points.iter().map(|p| p.square_m2).sum();
    let variance_m2 = (square_m2 / freedom).max(1e-14);
    -0.5 * freedom * (variance_m2.ln() + 1.0)
}

/// ln of the sum of the weights that [`log_evidence`] gives the sizes of the prior.
pub(super) fn log_weight_of_sizes() -> f64 {
    let far = |size: f64, usual: f64| -0.5 * ((size / usual).ln() / USUAL_SPREAD).powi(2);
    let shifts: f64 = SHIFTS_M.iter().map(|size| far(*size, USUAL[0]).exp()).sum();
    let turns: f64 = TURNS_RAD.iter().map(|size| far(*size, USUAL[1]).exp()).sum();
    shifts.ln() + turns.ln()
}

/// The linear problem of one history, under every size of the prior.
struct WeighedSizes {
    fits: Vec<Weighed>,
    /// Three rows for each point.
    signature: DMatrix<f64>,
    /// Noise of one coordinate of a touch, metres.
    sigma_m: f64,
}

/// Weighs every size of the prior; `None` where the warmth did not change.
fn weigh(points: &[Sums]) -> Option<WeighedSizes> {
    let rows = 3 * points.len();
    let mut signature = DMatrix::zeros(rows, PARAMETERS);
    let mut seen = DVector::zeros(rows);
    let mut spreads = DVector::zeros(rows);
    for (k, point) in points.iter().enumerate() {
        if point.spread < 1e-4 {
            return None;
        }
        signature.rows_mut(3 * k, 3).copy_from(&point.signature);
        seen.rows_mut(3 * k, 3).copy_from(&point.settled_m());
        spreads.rows_mut(3 * k, 3).fill(point.spread);
    }
    let freedom: f64 = points.iter().map(|p| 3.0 * (p.free - 1.0)).sum();
    let left_m2: f64 = points.iter().map(Sums::left_m2).sum();
    let sigma_m = (left_m2 / freedom).sqrt().max(1e-7);
    let noise = spreads.map(|g| sigma_m * sigma_m / g);
    // Evidence of what is left about the settled displacements, and of their own variance.
    let about = -0.5 * (freedom + rows as f64) * (sigma_m * sigma_m).ln() - 0.5 * freedom
        + 0.5 * noise.iter().map(|v| v.ln()).sum::<f64>();
    let squares: [DMatrix<f64>; 2] = [0, 1].map(|turn| {
        let mut sum = DMatrix::zeros(rows, rows);
        for i in (0..PARAMETERS).filter(|i| usize::from(i % 6 >= 3) == turn) {
            sum += signature.column(i) * signature.column(i).transpose();
        }
        sum
    });
    let mut fits = Vec::new();
    for shift_m in SHIFTS_M {
        for turn_rad in TURNS_RAD {
            let total = &squares[0] * (shift_m * shift_m)
                + &squares[1] * (turn_rad * turn_rad)
                + DMatrix::from_diagonal(&noise);
            let Some(cholesky) = total.cholesky() else { continue };
            let solved = cholesky.solve(&seen);
            let log_det: f64 = cholesky.l().diagonal().iter().map(|v| 2.0 * v.ln()).sum();
            let far =
                [(shift_m / USUAL[0]).ln(), (turn_rad / USUAL[1]).ln()].map(|f| (f / USUAL_SPREAD).powi(2));
            fits.push(Weighed {
                log_evidence: about - 0.5 * (seen.dot(&solved) + log_det + far[0] + far[1]),
                sizes: [shift_m, turn_rad],
                cholesky,
                solved,
            });
        }
    }
    Some(WeighedSizes { fits, signature, sigma_m })
}

/// What the touches say under one history of warmth; `None` where that did not change.
pub(super) fn posterior(points: &[Sums]) -> Option<Posterior> {
    let WeighedSizes { fits, signature, sigma_m } = weigh(points)?;
    let most = fits.iter().map(|f| f.log_evidence).fold(f64::NEG_INFINITY, f64::max);
    let total: f64 = fits.iter().map(|f| (f.log_evidence - most).exp()).sum();
    let mut mean = DVector::zeros(PARAMETERS);
    let mut second = DMatrix::zeros(PARAMETERS, PARAMETERS);
    let mut prior = [0.0; 2];
    for Weighed { log_evidence, sizes, cholesky, solved } in &fits {
        let weight = (log_evidence - most).exp() / total;
        if weight < 1e-6 {
            continue;
        }
        let sizes_of: DVector<f64> =
            DVector::from_fn(PARAMETERS, |i, _| sizes[usize::from(i % 6 >= 3)].powi(2));
        let spread = DMatrix::from_diagonal(&sizes_of) * signature.transpose();
        let one = &spread * solved;
        let covariance = DMatrix::from_diagonal(&sizes_of) - &spread * cholesky.solve(&spread.transpose());
        second += (covariance + &one * one.transpose()) * weight;
        mean += one * weight;
        for (to, size) in prior.iter_mut().zip(sizes) {
            *to += weight * size * size;
        }
    }
    let covariance = second - &mean * mean.transpose();
    let log_evidence = most + total.ln();
    log_evidence.is_finite().then(|| Posterior {
        log_evidence,
        mean,
        covariance,
        sigma_m,
        prior: prior.map(f64::sqrt),
    })
}
