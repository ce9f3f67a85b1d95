//! The design matrix: whitened columns with their meaning, and their products over groups of observations.

use super::registration;
use super::visits::Visits;
use super::whitening::Whitening;
use crate::diagnose::dataset::{Dataset, Observation, Twist, scaled};
use crate::diagnose::effects::Candidate;
use nalgebra::DMatrix;
use std::ops::Range;

/// Manufacturing tolerance of a joint's frame: metres, and radians.
const TOLERANCE: [f64; 2] = [1.5e-4, 2.5e-4];

/// Columns with their meaning: data first, then registration, geometry, and what was added.
#[derive(Clone, Debug)]
pub struct Design {
    whitening: Whitening,
    visits: Visits,
    /// Observations in the order of groups.
    pub(super) order: Vec<usize>,
    /// Rows of each group.
    pub(super) groups: Vec<Range<usize>>,
    pub(super) rows_per_observation: usize,
    /// Numbers measured in each group.
    counts: Vec<usize>,
    pub(super) columns: Vec<Vec<f64>>,
    /// Columns of registration, flat prior.
    pub registration: Range<usize>,
    /// Columns of geometry, scaled by tolerance.
    pub geometry: Range<usize>,
    /// Columns of slow noise, and their prior standard deviation over the noise's.
    slow: (Range<usize>, f64),
    /// Products of all columns for each group.
    gram: Vec<DMatrix<f64>>,
    /// Whitened columns of each joint turning.
    turns: Vec<Vec<f64>>,
    /// Each of these with itself, and with every column, observation by observation.
    pub(super) turn_squares: Vec<Vec<f64>>,
    pub(super) turn_products: Vec<Vec<Vec<f64>>>,
}

impl Design {
    /// The design of `residuals` (metres and radians, base axes) at the observations of the dataset; `group_of` numbers
    /// each observation's group from 0.
    #[must_use]
    pub fn new(
        dataset: &Dataset,
        residuals: &[Twist],
        targets: usize,
        whitening: Whitening,
        group_of: &[usize],
    ) -> Self {
        let mut order: Vec<usize> = (0..dataset.observations.len()).collect();
        order.sort_by_key(|&i| (group_of.get(i).copied().unwrap_or(0), i));
        let d = dataset.rows_per_observation;
        let mut groups: Vec<Range<usize>> = Vec::new();
        let mut counts: Vec<usize> = Vec::new();
        let mut last = None;
        for (position, &i) in order.iter().enumerate() {
            let rows = position * d..(position + 1) * d;
            let measured = dataset.observations[i].rows(d);
            if last == Some(group_of[i]) {
                if let Some(count) = counts.last_mut() {
                    *count += measured;
                }
                if let Some(group) = groups.last_mut() {
                    group.end = rows.end;
                }
            } else {
                last = Some(group_of[i]);
                counts.push(measured);
                groups.push(rows);
            }
        }
        let mut design = Self {
            visits: Visits::new(dataset, &whitening, &order),
            whitening,
            order,
            groups,
            rows_per_observation: d,
            counts,
            columns: Vec::new(),
            registration: 0..0,
            geometry: 0..0,
            slow: (0..0, 0.0),
            gram: Vec::new(),
            turns: Vec::new(),
            turn_squares: Vec::new(),
            turn_products: vec![Vec::new(); dataset.joints()],
        };
        let mut columns = design.stack(dataset, 1, |i, _, out| out.push(residuals[i]));
        let flat = design.stack(dataset, registration::width(dataset, targets), |_, observation, out| {
            registration::twists(dataset, observation, targets, out);
        });
        let geometry = design.stack(dataset, 6 * (dataset.joints() - 1), |_, observation, out| {
            for frame in 1..dataset.joints() {
                for k in 0..6 {
                    out.push(scaled(observation.frame_offset(frame, k), TOLERANCE[k / 3]));
                }
            }
        });
        design.registration = 1..1 + flat.len();
        design.geometry = design.registration.end..design.registration.end + geometry.len();
        columns.extend(flat);
        columns.extend(geometry);
        design.columns = columns;
        design.turns = design.stack(dataset, dataset.joints(), |_, observation, out| {
            out.extend((0..observation.joints()).map(|j| observation.jacobian_column(j)));
        });
        design.turn_squares = design.turns.iter().map(|t| by_observation(t, t, d)).collect();
        design.multiply_turns();
        design.gram = (0..design.groups.len()).map(|a| design.gram_of(a)).collect();
        design
    }

    /// Weights of the stations.
    #[must_use]
    pub fn whitening(&self) -> &Whitening {
        &self.whitening
    }

    /// Takes `columns` for slow noise of `ratio` standard deviations over the noise's.
    pub fn set_slow(&mut self, columns: Range<usize>, ratio: f64) {
        self.slow = (columns, ratio);
    }

    /// Columns of slow noise, and their prior standard deviation over the noise's; none: an empty range.
    #[must_use]
    pub fn slow(&self) -> (Range<usize>, f64) {
        self.slow.clone()
    }

    /// Number of columns of the registration.
    #[must_use]
    pub fn width(&self) -> usize {
        self.columns.len()
    }

    /// Number of cross-validation groups of rows.
    #[must_use]
    pub fn groups(&self) -> usize {
        self.groups.len()
    }

    /// Numbers measured in a subset of groups.
    #[must_use]
    pub fn rows(&self, subset: &[usize]) -> usize {
        subset.iter().filter_map(|&a| self.counts.get(a)).sum()
    }

    /// Offset `k` of frame `i` is column `geometry.start + 6 (i - 1) + k`, per this many SI units.
    #[must_use]
    pub fn tolerance(k: usize) -> f64 {
        TOLERANCE[usize::from(k >= 3)]
    }

    /// Products of all columns over a subset of groups.
    #[must_use]
    pub fn gram(&self, subset: &[usize]) -> DMatrix<f64> {
        let mut sum = DMatrix::zeros(self.width(), self.width());
        for &a in subset {
            sum += &self.gram[a];
        }
        sum
    }

    /// Adds columns and their products; gives their place.
    pub fn append(&mut self, columns: Vec<Vec<f64>>) -> Range<usize> {
        let start = self.columns.len();
        self.columns.extend(columns);
        self.multiply_turns();
        self.gram = (0..self.groups.len()).map(|a| self.gram_of(a)).collect();
        start..self.columns.len()
    }

    /// A candidate's columns, scaled by their prior sigma.
    #[must_use]
    pub fn columns_of(&self, dataset: &Dataset, candidate: &Candidate) -> Vec<Vec<f64>> {
        self.stack(dataset, candidate.prior_sigma.len(), |_, observation, out| {
            candidate.scaled_signature(dataset, observation, out);
        })
    }

    /// Whitened columns of `width` motions for each observation.
    #[must_use]
    pub fn stack(
        &self,
        dataset: &Dataset,
        width: usize,
        twists: impl Fn(usize, &Observation, &mut Vec<Twist>),
    ) -> Vec<Vec<f64>> {
        let d = self.rows_per_observation;
        let mut columns = vec![vec![0.0; self.order.len() * d]; width];
        let mut buffer = Vec::with_capacity(width);
        for (position, &i) in self.order.iter().enumerate() {
            buffer.clear();
            twists(i, &dataset.observations[i], &mut buffer);
            for (column, twist) in columns.iter_mut().zip(&buffer) {
                let twist = dataset.observations[i].observed(*twist);
                let rows = &mut column[position * d..(position + 1) * d];
                rows.iter_mut().zip(self.whitening.rows(i, twist, d)).for_each(|(to, value)| *to = value);
            }
        }
        columns.iter_mut().for_each(|column| self.visits.whiten(column));
        columns
    }

    /// A column times a number for each observation.
    #[must_use]
    pub fn modulated(
        &self,
        dataset: &Dataset,
        column: usize,
        factor: impl Fn(&Observation) -> f64,
    ) -> Vec<f64> {
        let d = self.rows_per_observation;
        let mut out = self.columns[column].clone();
        for (rows, &i) in out.chunks_exact_mut(d).zip(&self.order) {
            let factor = factor(&dataset.observations[i]);
            rows.iter_mut().for_each(|v| *v *= factor);
        }
        out
    }

    /// Residual of `coefficients` (one for each column after the data) at each observation, unwhitened: metres, radians.
    #[must_use]
    pub fn residuals(&self, coefficients: &[f64]) -> Vec<Twist> {
        let d = self.rows_per_observation;
        let mut left = self.columns[0].clone();
        for (c, column) in coefficients.iter().zip(&self.columns[1..]).filter(|(c, _)| **c != 0.0) {
            left.iter_mut().zip(column).for_each(|(left, value)| *left -= c * value);
        }
        self.visits.restore(&mut left);
        let mut out = vec![[0.0; 6]; self.order.len()];
        for (rows, &i) in left.chunks_exact(d).zip(&self.order) {
            let root = self.whitening.weights[i].sqrt().max(1e-12);
            for (k, (to, value)) in out[i].iter_mut().zip(rows).enumerate() {
                *to = value / root / if k < 3 { 1.0 } else { self.whitening.arm_m };
            }
        }
        out
    }

    fn gram_of(&self, group: usize) -> DMatrix<f64> {
        let rows = self.groups[group].clone();
        let n = self.columns.len();
        let known = self.gram.get(group).map_or(0, DMatrix::nrows);
        let mut gram = DMatrix::zeros(n, n);
        for a in 0..n {
            for b in a..n {
                let value = match self.gram.get(group) {
                    Some(old) if b < known => old[(a, b)],
                    _ => dot(&self.columns[a][rows.clone()], &self.columns[b][rows.clone()]),
                };
                gram[(a, b)] = value;
                gram[(b, a)] = value;
            }
        }
        gram
    }

    fn multiply_turns(&mut self) {
        let d = self.rows_per_observation;
        for (turn, products) in self.turns.iter().zip(&mut self.turn_products) {
            for column in &self.columns[products.len()..] {
                products.push(by_observation(turn, column, d));
            }
        }
    }
}

/// Products of two columns, summed over each observation's rows.
pub(super) fn by_observation(a: &[f64], b: &[f64], rows_per_observation: usize) -> Vec<f64> {
    a.chunks_exact(rows_per_observation)
        .zip(b.chunks_exact(rows_per_observation))
        .map(|(x, y)| x.iter().zip(y).map(|(x, y)| x * y).sum())
        .collect()
}

/// Sum of products, in eight running sums: fast, and the same for every number of threads.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (a8, b8) = (a.chunks_exact(8), b.chunks_exact(8));
    let tail: f64 = a8.remainder().iter().zip(b8.remainder()).map(|(x, y)| x * y).sum();
    for (x, y) in a8.zip(b8) {
        for k in 0..8 {
            sums[k] += x[k] * y[k];
        }
    }
    sums.iter().sum::<f64>() + tail
}
