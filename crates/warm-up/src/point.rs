//! The touches of one point, as the fit and its residuals need them.

use super::history::{Standstill, ThermalHistory, warmth};
use super::posterior::Sums;
use nalgebra::{Matrix3xX, Vector3};
use std::collections::BTreeSet;
use std::ops::Range;

/// The touches of one point in one pose.
pub(super) struct Point {
    pub(super) index: usize,
    pub(super) q_rad: [f64; 6],
    pub(super) signature: Matrix3xX<f64>,
    pub(super) lines: Vec<u64>,
    pub(super) t_min: Vec<f64>,
    pub(super) observed_m: Vec<Vector3<f64>>,
    /// From each of these minutes on it is in another place, to which it was knocked, or moved together with the others; ascending.
    pub(super) moved_min: Vec<f64>,
}

impl Point {
    /// Without the touches of these lines.
    pub(super) fn without(&self, lines: &BTreeSet<u64>) -> Self {
        let kept = || (0..self.lines.len()).filter(|&i| !lines.contains(&self.lines[i]));
        Self {
            index: self.index,
            q_rad: self.q_rad,
            signature: self.signature.clone(),
            lines: kept().map(|i| self.lines[i]).collect(),
            t_min: kept().map(|i| self.t_min[i]).collect(),
            observed_m: kept().map(|i| self.observed_m[i]).collect(),
            moved_min: self.moved_min.clone(),
        }
    }

    /// From this minute on it is in another place.
    pub(super) fn moves_at(&mut self, minute: f64) {
        self.moved_min.push(minute);
        sorting::numbers(&mut self.moved_min);
        self.moved_min.dedup();
    }

    /// Its touches by the place in which it stood: all in one, but where it moved.
    pub(super) fn places(&self) -> Vec<Range<usize>> {
        let first = |minute: &f64| self.t_min.partition_point(|t| t < minute);
        let from = std::iter::once(0).chain(self.moved_min.iter().map(first));
        let to = self.moved_min.iter().map(first).chain([self.t_min.len()]);
        from.zip(to).map(|(from, to)| from..to).collect()
    }

    /// What the likelihood needs of them under a history of warmth.
    pub(super) fn sums(&self, history: &ThermalHistory, stops: &[Standstill]) -> Sums {
        let grown = warmth(history, stops, &self.t_min);
        let mut sums = Sums::none(&self.signature);
        for place in self.places() {
            sums.add_place(&grown[place.clone()], &self.observed_m[place]);
        }
        sums
    }
}
