//! The size of a cause in a linear fit.

use inference::effects::Candidate;
use inference::linear_fit::LinearFit;

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
    let numbers = values.len() as f64;
    let at: Vec<Option<usize>> = columns.iter().map(|c| fit.columns.iter().position(|x| x == c)).collect();
    let mut variance = 0.0;
    for (a, (ia, ua)) in at.iter().zip(&candidate.prior_sigma).enumerate().take(candidate.n_reported) {
        for (b, (ib, ub)) in at.iter().zip(&candidate.prior_sigma).enumerate().take(candidate.n_reported) {
            if let (Some(ia), Some(ib)) = (ia, ib) {
                let slope = match size > 0.0 {
                    true => (values[a] / size) * (values[b] / size),
                    // Of nothing no number leads: in the middle of all directions.
                    false => f64::from(u8::from(a == b)) / numbers,
                };
                variance += slope * fit.covariance[(*ia, *ib)] * ua * ub * candidate.display_scale.powi(2);
            }
        }
    }
    (size, sigma_m * variance.max(0.0).sqrt())
}
