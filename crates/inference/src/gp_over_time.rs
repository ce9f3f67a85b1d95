//! Structure over time that has a shape of its own: a load that comes and goes, what goes to and fro, a cause that grows.

use crate::dataset::{Dataset, Observation, Twist, scaled};
use crate::design::Design;
use crate::effects::give_per_kg;
use crate::gp_features::{bumps, compress};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;

/// Functions of time that a load may follow that comes and goes.
const HIDDEN_LOAD_CENTRES: usize = 24;

/// The usual give of arm and wrist, each of which may be stiffer or softer, under a load at the tool times functions of time of this length, a share of the
/// measurement.
pub fn hidden_load_columns(design: &Design, dataset: &Dataset, length: f64) -> DMatrix<f64> {
    let centres: Vec<Vec<f64>> =
        (0..HIDDEN_LOAD_CENTRES).map(|k| vec![k as f64 / (HIDDEN_LOAD_CENTRES - 1) as f64]).collect();
    let wrist = dataset.joints().saturating_sub(3);
    compress(&design.stack(dataset, 2 * centres.len(), |_, observation, out| {
        let parts = [0..wrist, wrist..observation.joints()].map(|joints| give_per_kg(observation, joints));
        for f in bumps(&[dataset.progress(observation)], &centres, length) {
            out.extend(parts.map(|part| scaled(part, f)));
        }
    }))
}

/// A shift along each axis to and fro, `half_cycles` times over the measurement.
pub fn cycle_columns(design: &Design, dataset: &Dataset, half_cycles: u32) -> DMatrix<f64> {
    let rate = PI * f64::from(half_cycles);
    compress(&design.stack(dataset, 6, |_, observation, out| {
        let (sin, cos) = (rate * dataset.progress(observation)).sin_cos();
        for axis in 0..3 {
            for wave in [sin, cos] {
                let mut shift = Twist::default();
                shift[axis] = wave;
                out.push(shift);
            }
        }
    }))
}

/// `cause`'s columns times slow functions of the measurement's progress without their mean: what a cause
/// that is not constant leaves beside its mean.
#[must_use]
pub fn time_varying_columns(design: &Design, dataset: &Dataset, cause: &[usize]) -> DMatrix<f64> {
    const WAVES: i32 = 3;
    let mut all: Vec<DVector<f64>> = Vec::new();
    for k in 1..=WAVES {
        let wave = |observation: &Observation| {
            (PI * f64::from(k) * dataset.progress(observation)).cos() / f64::from(k)
        };
        all.extend(cause.iter().map(|&column| design.modulated(dataset, column, wave).into()));
    }
    compress(&DMatrix::from_columns(&all))
}
