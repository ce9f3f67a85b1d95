//! Scatter that runs along a joint: what an effect looks like whose channel is not in the file.
//!
//! A joint that stands now here, now there (play without its direction, warmth without its time) moves the
//! point along its Jacobian column; an instrument scatters in all directions alike.

use super::dataset::{Dataset, Twist};
use super::linearise::shift_m;
use super::marginal::{NoiseIntegral, NoisePrior, log_sum};
use nalgebra::Vector3;
use robot_model::robot::Axis;

/// Scatter of a joint, seen through the residuals of the best model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct JointScatter {
    /// The joint along whose motion it runs.
    pub joint: Axis,
    /// How much likelier than scatter that is alike in all directions, nats, over all joints.
    pub gain_nats: f64,
    /// Its rms at the measured point, metres.
    pub rms_m: f64,
}

/// Standard deviations that are tried, radians.
const SIZES_RAD: std::ops::Range<i32> = 0..12;
const SMALLEST_RAD: f64 = 4e-6;

/// The joint along which the residuals scatter most, in stations that are not `outliers`; `weights` are
/// those of the stations, `used` the parameters that the model has taken.
///
/// e ~ N(0, sigma^2 / w + s^2 J J'), sigma integrated out; the inverse by Sherman and Morrison (1950).
#[must_use]
pub(super) fn along_joints(
    dataset: &Dataset,
    residuals: &[Twist],
    weights: &[f64],
    outliers: &[bool],
    noise: &NoisePrior,
    used: f64,
) -> Option<JointScatter> {
    // The targets of a visit show one scatter of a joint: one of them each.
    let mut first = vec![true; residuals.len()];
    for visit in &dataset.visits {
        visit.iter().filter(|&&i| !outliers[i]).skip(1).for_each(|&i| first[i] = false);
    }
    let kept: Vec<usize> = (0..residuals.len()).filter(|&i| first[i] && !outliers[i]).collect();
    let rows = kept.iter().map(|&i| dataset.observations[i].rows(3)).sum::<usize>() as f64;
    let free = rows - used;
    if kept.len() < 12 || free < 0.3 * rows {
        return None;
    }
    let squares: f64 = kept.iter().map(|&i| weights[i] * shift_m(&residuals[i]).powi(2)).sum();
    let marginal = noise.marginal_over(free);
    let NoiseIntegral { log: plain, sigma_m } = marginal.at(squares);
    let mut tried = Vec::new();
    for joint in 0..dataset.joints() {
        // (e.J)^2 and J^2 of each station, whitened.
        let along: Vec<(f64, f64)> = kept
            .iter()
            .map(|&i| {
                let observation = &dataset.observations[i];
                let (m, e) = (observation.observed(observation.jacobian_column(joint)), &residuals[i]);
                let v = Vector3::new(m[0], m[1], m[2]);
                let e = Vector3::new(e[0], e[1], e[2]);
                (weights[i] * e.dot(&v), weights[i] * v.norm_squared())
            })
            .collect();
        for k in SIZES_RAD {
            let size_rad = SMALLEST_RAD * 1.6_f64.powi(k);
            let ratio = (size_rad / sigma_m).powi(2);
            let (mut off, mut log_det) = (0.0, 0.0);
            for (ev, vv) in &along {
                off += ratio * ev * ev / (1.0 + ratio * vv);
                log_det += (ratio * vv).ln_1p();
            }
            // Parameters took their share of the scatter: of the determinant as of the rows.
            let gain = marginal.at(squares - off).log - plain - 0.5 * log_det * free / rows;
            let mean = along.iter().map(|a| a.1).sum::<f64>() / weights_of(&kept, weights);
            tried.push((joint, gain, size_rad * mean.sqrt()));
        }
    }
    let best = tried.iter().copied().reduce(|a, b| if b.1 > a.1 { b } else { a })?;
    let total = log_sum(tried.iter().map(|t| t.1)) - (tried.len() as f64).ln();
    Some(JointScatter { joint: Axis::at(best.0), gain_nats: total, rms_m: best.2 })
}

fn weights_of(kept: &[usize], weights: &[f64]) -> f64 {
    kept.iter().map(|&i| weights[i]).sum::<f64>().max(1e-12)
}
