//! The size of a cause in a linear fit.

use crate::diagnose::effects::Candidate;
use crate::diagnose::linear_fit::LinearFit;

/// The size in the cause's unit, with its standard deviation, of the `columns` that `candidate` has in a fit.
#[must_use]
pub(super) fn size_of(candidate: &Candidate, columns: &[usize], fit: &LinearFit, sigma_m: f64) -> (f64, f64) {
    let values: Vec<f64> = columns
        .iter()
        .zip(&candidate.prior_sigma)
        .take(candidate.n_reported)
        .map(|(&c, prior_sigma)| fit.coefficients[c - 1] * prior_sigma * candidate.display_scale)
        .collect();
    let size = values.iter().map(|v| v * v).sum::<f64>().sqrt();
    let at: Vec<Option<usize>> = columns.iter().map(|c| fit.columns.iter().position(|x| x == c)).collect();
    let mut variance = 0.0;
    for (a, (ia, ua)) in at.iter().zip(&candidate.prior_sigma).enumerate().take(candidate.n_reported) {
        for (b, (ib, ub)) in at.iter().zip(&candidate.prior_sigma).enumerate().take(candidate.n_reported) {
            if let (Some(ia), Some(ib)) = (ia, ib) {
                let slope = values[a] * values[b] / size.max(1e-300).powi(2);
                variance += slope * fit.covariance[(*ia, *ib)] * ua * ub * candidate.display_scale.powi(2);
            }
        }
    }
    (size, sigma_m * variance.max(0.0).sqrt())
}
