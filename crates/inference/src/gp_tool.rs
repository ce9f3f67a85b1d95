//! Structure that lies outside of the arm, or comes and goes with its load: a tool that gives, a target that sits otherwise under load,
//! joints whose zeros shift under load, an instrument whose scale wanders.

use crate::dataset::{Dataset, Observation, Twist, scaled};
use crate::design::Design;
use crate::gp_features::compress;
use nalgebra::{DMatrix, Vector3};
use std::f64::consts::TAU;

/// The payload at a row as a share of the largest in the file; 0 where none is written.
fn load_share(dataset: &Dataset, observation: &Observation) -> f64 {
    observation.payload_kg.map_or(0.0, |kg| kg / dataset.largest_payload_kg.max(f64::MIN_POSITIVE))
}

/// A shift of the target along axis `a` of the flange, of length `by`.
fn along_flange(observation: &Observation, a: usize, by: f64) -> Twist {
    let axis = observation.flange.column(a);
    Twist([by * axis[0], by * axis[1], by * axis[2], 0.0, 0.0, 0.0])
}

/// A tool or its flange that gives under its own weight and under the payload: the target moves along each axis of the flange by as much
/// as gravity pulls along each, a linear spring of any shape (a stiffness matrix fixed to the flange).
pub fn tool_sag_columns(design: &Design, dataset: &Dataset) -> DMatrix<f64> {
    let loaded = dataset.largest_payload_kg > 0.0;
    let columns = if loaded { 18 } else { 9 };
    compress(&design.stack(dataset, columns, |_, observation, out| {
        // Gravity pulls down; how much of it along axis b is the third part of that axis.
        let pull = |b: usize| -observation.flange[(2, b)];
        let weights = [1.0, load_share(dataset, observation)];
        for weight in &weights[..if loaded { 2 } else { 1 }] {
            for (a, b) in (0..3).flat_map(|a| (0..3).map(move |b| (a, b))) {
                out.push(along_flange(observation, a, weight * pull(b)));
            }
        }
    }))
}

/// A target that sits elsewhere on the flange as the payload is on: a shift along each of the flange's axes.
pub fn loaded_target_columns(design: &Design, dataset: &Dataset) -> DMatrix<f64> {
    compress(&design.stack(dataset, 3, |_, observation, out| {
        out.extend((0..3).map(|a| along_flange(observation, a, load_share(dataset, observation))));
    }))
}

/// Each joint's zero shifted as the payload is on.
pub fn loaded_zeros_columns(design: &Design, dataset: &Dataset) -> DMatrix<f64> {
    compress(&design.stack(dataset, dataset.joints(), |_, observation, out| {
        let share = load_share(dataset, observation);
        out.extend((0..dataset.joints()).map(|j| scaled(observation.jacobian_column(j), share)));
    }))
}

/// An instrument whose scale wanders: all places move away from where it stands in the base, evenly over time and with a bow.
pub fn wandering_scale_columns(
    design: &Design,
    dataset: &Dataset,
    instrument_m: Vector3<f64>,
) -> DMatrix<f64> {
    compress(&design.stack(dataset, 2, |_, observation, out| {
        let progress = dataset.progress(observation);
        let away = observation.point_m - instrument_m;
        for course in [2.0 * progress - 1.0, 0.5 * (TAU * progress).cos()] {
            out.push(Twist([course * away.x, course * away.y, course * away.z, 0.0, 0.0, 0.0]));
        }
    }))
}
