//! Joints written with too few decimals: their rounding error seen in the scatter.

use super::linearise::Linear;
use super::model::Model;
use crate::measure::{Fault, FaultKind, Measurements};
use crate::units::{mm_from_m, rad_from_deg};
use nalgebra::{Matrix3, Vector3};

/// More decimals than this cannot matter.
const FINE_DECIMALS: usize = 2;
/// Rounding must be likelier than plain noise by so much, nats.
const CLEAR_NATS: f64 = 8.0;

/// Whether the joints' decimals explain the scatter better than plain noise.
///
/// Joints commanded at round angles carry no rounding error: coarse decimals alone prove nothing.
#[must_use]
pub fn find(measurements: &Measurements, linear: &Linear, model: &Model<'_>) -> Option<Fault> {
    if measurements.joint_decimals > FINE_DECIMALS {
        return None;
    }
    let step_deg = 10.0_f64.powi(-(measurements.joint_decimals as i32));
    // Uniform over one step.
    let variance = rad_from_deg(step_deg).powi(2) / 12.0;
    let shapes: Vec<Matrix3<f64>> = linear
        .scene
        .sites
        .iter()
        .map(|site| {
            (0..6)
                .map(|j| {
                    let v = site.joint(j);
                    let v = Vector3::new(v[0], v[1], v[2]);
                    v * v.transpose() * variance
                })
                .sum()
        })
        .collect();
    let residuals: Vec<Vector3<f64>> =
        model.residuals.iter().map(|m| Vector3::new(m[0], m[1], m[2])).collect();
    let n = residuals.len() as f64;
    let plain_m2 = residuals.iter().map(Vector3::norm_squared).sum::<f64>() / (3.0 * n);
    let log_likelihood = |share: f64, noise_m2: f64| -> f64 {
        shapes
            .iter()
            .zip(&residuals)
            .map(|(shape, e)| {
                let c = shape * share + Matrix3::identity() * noise_m2.max(1e-14);
                c.cholesky()
                    .map_or(f64::NEG_INFINITY, |l| -0.5 * e.dot(&l.solve(e)) - 0.5 * l.determinant().ln())
            })
            .sum()
    };
    let expected_m2 = shapes.iter().map(Matrix3::trace).sum::<f64>() / (3.0 * n);
    if plain_m2 < 0.3 * expected_m2 {
        return None;
    }
    let plain = log_likelihood(0.0, plain_m2);
    let rounded = [0.05, 0.15, 0.4, 0.7]
        .into_iter()
        .map(|k| log_likelihood(0.9, k * plain_m2))
        .chain([log_likelihood(0.9, model.noise.known.map_or(1e-10, |(s, _)| s * s))])
        .fold(f64::NEG_INFINITY, f64::max);
    (rounded > plain + CLEAR_NATS).then(|| Fault {
        kind: FaultKind::RoundedJoints,
        reason: format!(
            "the joints are rounded to {step_deg} deg, and the points scatter just as that rounding would make them \
             ({:.2} mm rms): export the joints with at least 3 decimals",
            mm_from_m((3.0 * plain_m2).sqrt())
        ),
    })
}
