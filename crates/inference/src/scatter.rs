//! Scatter that runs along a joint: what an effect looks like whose channel is not in the file.
//!
//! A joint that stands now here, now there (play without its direction, warmth without its time) moves the
//! point along its Jacobian column; an instrument scatters in all directions alike, or along its beam more or less than across it.

use crate::dataset::{Dataset, Observation, Twist};
use crate::marginal::{Marginal, NoiseIntegral, NoisePrior};
use nalgebra::{Matrix3, Vector3};
use robot_model::robot::Axis;
use statistics::{ALARM_NATS, log_sum};

/// Scatter of a joint, seen through the residuals of the best model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointScatter {
    /// The joint along whose motion it runs.
    pub joint: Axis,
    /// How much likelier than scatter of the instrument alone, nats, over all joints.
    pub gain_nats: f64,
    /// Its rms at the measured point, metres.
    pub rms_m: f64,
}

/// Standard deviations that are tried, radians.
const SIZES_RAD: std::ops::Range<i32> = 0..12;
const SMALLEST_RAD: f64 = 4e-6;

/// Noise along the beam over noise across it, as a tracker (which measures lengths better than angles) or a camera (the other way round) may
/// have it, beside noise that is alike in all directions.
const BEAM_RATIOS: [f64; 8] = [0.2, 0.3, 0.45, 0.67, 1.5, 2.2, 3.3, 5.0];
/// How often noise is alike in all directions; else its directions are as often those of the beam as fixed ones.
const ALIKE: f64 = 0.5;

/// The residuals of the best model, and what is known of their noise.
pub struct Residuals<'a> {
    /// The arm at each station.
    pub dataset: &'a Dataset,
    /// What the model leaves at each station.
    pub residuals: &'a [Twist],
    /// Weight of each station: 1 = one row of usual noise.
    pub weights: &'a [f64],
    /// Stations that are set aside.
    pub outliers: &'a [bool],
    /// What is known of the noise.
    pub noise: &'a NoisePrior,
    /// How many parameters the model has taken.
    pub used: f64,
    /// Where the instrument stands, in the base.
    pub instrument_m: Vector3<f64>,
}

/// The joint along which residuals scatter most.
///
/// e ~ N(0, sigma^2 C / w + s^2 J J'), sigma integrated out, C of determinant 1: alike in all directions or along one axis more or less than
/// across it; the inverse by Sherman and Morrison (1950).
#[must_use]
pub fn along_joints(given: &Residuals<'_>) -> Option<JointScatter> {
    let Residuals { dataset, residuals, weights, outliers, noise, used, .. } = *given;
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
    let stations: Vec<StationScatter> = kept
        .iter()
        .map(|&i| StationScatter::of(&dataset.observations[i], &residuals[i], weights[i]))
        .collect();
    let marginal = noise.marginal_over(free);
    let of =
        |noise: &dyn Fn(usize) -> Option<NoiseAxis>| over_noise(&stations, noise, &marginal, free / rows);
    let alike = of(&|_| None);
    let total_weight = kept.iter().map(|&i| weights[i]).sum::<f64>().max(1e-12);
    let found = |gain_nats: f64, best: &TriedJoint| JointScatter {
        joint: Axis::at(best.joint),
        gain_nats,
        rms_m: best.size_rad * (best.lever2 / total_weight).sqrt(),
    };
    let alone = found(alike.along - alike.plain, &alike.best);
    if alone.gain_nats <= ALARM_NATS {
        return Some(alone);
    }
    // Other noise may look like it: both are asked under every noise that there may be.
    let mut tried = vec![(ALIKE.ln(), alike)];
    let fixed = principal_axes(&stations);
    let price = (kept.len() as f64).ln();
    let share = ((1.0 - ALIKE) / (2 * BEAM_RATIOS.len()) as f64).ln();
    for ratio in BEAM_RATIOS {
        let beam = |k: usize| {
            let along = dataset.observations[kept[k]].point_m - given.instrument_m;
            Some(NoiseAxis { axis: along.try_normalize(1e-9)?, ratio })
        };
        tried.push((share, of(&beam)));
        for axis in fixed {
            tried.push((share - price, of(&|_| Some(NoiseAxis { axis, ratio }))));
        }
    }
    let along = log_sum(tried.iter().map(|(prior, noise)| prior + noise.along));
    let plain = log_sum(tried.iter().map(|(prior, noise)| prior + noise.plain));
    let likeliest = tried.iter().max_by(|a, b| (a.0 + a.1.along).total_cmp(&(b.0 + b.1.along)))?;
    Some(found(along - plain, &likeliest.1.best))
}

/// Noise that differs along one axis.
#[derive(Clone, Copy)]
struct NoiseAxis {
    axis: Vector3<f64>,
    /// Its size along the axis over that across it.
    ratio: f64,
}

impl NoiseAxis {
    /// `v` in units of this noise, whose covariance has the determinant 1.
    fn whitened(&self, v: &Vector3<f64>) -> Vector3<f64> {
        let along = self.axis * self.axis.dot(v);
        (v - along) * self.ratio.cbrt() + along * self.ratio.powf(-2.0 / 3.0)
    }
}

/// The residual of a station and how its point moves with each joint, as far as they are seen.
struct StationScatter {
    weight: f64,
    /// Whether all three coordinates are seen.
    is_point: bool,
    residual: Vector3<f64>,
    columns: Vec<Vector3<f64>>,
}

impl StationScatter {
    fn of(observation: &Observation, residual: &Twist, weight: f64) -> Self {
        let shift = |m: &Twist| Vector3::new(m[0], m[1], m[2]);
        let column = |joint| shift(&observation.observed(observation.jacobian_column(joint)));
        Self {
            weight,
            is_point: observation.rows(3) == 3,
            residual: shift(residual),
            columns: (0..observation.q_rad.len()).map(column).collect(),
        }
    }
}

/// A joint that scatters by so much.
#[derive(Clone, Copy)]
struct TriedJoint {
    joint: usize,
    size_rad: f64,
    gain_nats: f64,
    /// Sum of the weighted squares of its lever.
    lever2: f64,
}

/// How likely residuals are under one noise.
struct UnderNoise {
    /// ln likelihood of the noise alone.
    plain: f64,
    /// The same where a joint scatters beside it, over all joints and sizes.
    along: f64,
    best: TriedJoint,
}

fn over_noise(
    stations: &[StationScatter],
    noise: &dyn Fn(usize) -> Option<NoiseAxis>,
    marginal: &Marginal,
    left_share: f64,
) -> UnderNoise {
    let noises: Vec<Option<NoiseAxis>> =
        stations.iter().enumerate().map(|(k, station)| noise(k).filter(|_| station.is_point)).collect();
    let whitened = |k: usize, v: &Vector3<f64>| noises[k].map_or(*v, |noise| noise.whitened(v));
    let residuals: Vec<Vector3<f64>> =
        stations.iter().enumerate().map(|(k, station)| whitened(k, &station.residual)).collect();
    let squares: f64 = stations.iter().zip(&residuals).map(|(s, e)| s.weight * e.norm_squared()).sum();
    let NoiseIntegral { log: plain, sigma_m } = marginal.at(squares);
    let joints = stations.first().map_or(0, |station| station.columns.len());
    let mut tried: Vec<TriedJoint> = Vec::new();
    for joint in 0..joints {
        // (e.J)^2 and J^2 of each station, whitened.
        let along: Vec<(f64, f64)> = stations
            .iter()
            .enumerate()
            .map(|(k, station)| {
                let v = whitened(k, &station.columns[joint]);
                (station.weight * residuals[k].dot(&v), station.weight * v.norm_squared())
            })
            .collect();
        let lever2 = stations.iter().map(|s| s.weight * s.columns[joint].norm_squared()).sum();
        for size in SIZES_RAD {
            let size_rad = SMALLEST_RAD * 1.6_f64.powi(size);
            let ratio = (size_rad / sigma_m).powi(2);
            let (mut off, mut log_det) = (0.0, 0.0);
            for (ev, vv) in &along {
                off += ratio * ev * ev / (1.0 + ratio * vv);
                log_det += (ratio * vv).ln_1p();
            }
            // Parameters took their share of the scatter: of the determinant as of the rows.
            let gain_nats = marginal.at(squares - off).log - plain - 0.5 * log_det * left_share;
            tried.push(TriedJoint { joint, size_rad, gain_nats, lever2 });
        }
    }
    let total = log_sum(tried.iter().map(|t| t.gain_nats)) - (tried.len() as f64).ln();
    let none = TriedJoint { joint: 0, size_rad: 0.0, gain_nats: f64::NEG_INFINITY, lever2: 0.0 };
    let best = tried.into_iter().fold(none, |a, b| if b.gain_nats > a.gain_nats { b } else { a });
    UnderNoise { plain, along: plain + total, best }
}

/// The axes along which points scatter least and most.
fn principal_axes(stations: &[StationScatter]) -> [Vector3<f64>; 2] {
    let points = stations.iter().filter(|station| station.is_point);
    let covariance: Matrix3<f64> = points.map(|s| s.residual * s.residual.transpose() * s.weight).sum();
    let eigen = covariance.symmetric_eigen();
    let (least, most) = (eigen.eigenvalues.imin(), eigen.eigenvalues.imax());
    [least, most].map(|k| eigen.eigenvectors.column(k).into_owned())
}
