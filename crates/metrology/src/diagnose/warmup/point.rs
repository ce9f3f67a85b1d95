//! The touches of one point, as the fit and its residuals need them.

use super::history::{Standstill, ThermalHistory, warmth};
use super::posterior::Sums;
use nalgebra::{Matrix3xX, Vector3};

/// The touches of one point in one pose.
pub(super) struct Point {
    pub(super) index: usize,
    pub(super) q_rad: [f64; 6],
    pub(super) signature: Matrix3xX<f64>,
    pub(super) lines: Vec<u64>,
    pub(super) t_min: Vec<f64>,
    pub(super) observed_m: Vec<Vector3<f64>>,
}

impl Point {
    /// What the likelihood needs of them under a history of warmth.
    pub(super) fn sums(&self, history: &ThermalHistory, stops: &[Standstill]) -> Sums {
        let grown = warmth(history, stops, &self.t_min);
        Sums::new(&self.signature, &grown, &self.observed_m)
    }
}
