//! Columns eliminated, made orthogonal one after the other (Gram and Schmidt), and taken out again (Householder 1958).

use super::NuisanceModel;
use crate::design::{Design, SlowColumns, dot};
use nalgebra::{DMatrix, DVector, Dyn, SymmetricEigen};
use std::ops::Range;

/// Directions that the flat columns tell less than this share of the best are not told.
pub(super) const RANK: f64 = 1e-10;
/// A cause's column of whose square those before it leave no more than this share says nothing that they do not: at a thousandth of its
/// length the rest shows how factors were rounded (to 6e-8), more so with each such column before it. Made as long as the others it would
/// take out of the data a direction that another rounding turns, and an answer with it.
const CAUSE_RANK: f64 = 1e-6;

/// A direction that is projected out.
#[derive(Clone)]
pub(super) struct Direction {
    /// Weights of the design's columns.
    pub weights: Vec<f64>,
    /// The data along it.
    pub y: f64,
    /// The geometry's columns along it.
    pub geometry: DVector<f64>,
    /// Where its weights are not 0; set when all directions are there.
    pub support: Range<usize>,
}

/// Slow noise along its own principal directions, of no size yet.
pub(super) struct SlowSpectrum {
    columns: Range<usize>,
    /// Products of each flat direction with all columns.
    flat: Vec<Vec<f64>>,
    /// Of what the flat directions leave of the columns.
    eigen: SymmetricEigen<f64, Dyn>,
}

impl Direction {
    /// This direction `by` times as long.
    fn scaled(&self, by: f64) -> Self {
        Self {
            weights: self.weights.iter().map(|w| by * w).collect(),
            y: by * self.y,
            geometry: &self.geometry * by,
            support: 0..0,
        }
    }

    /// Adds `by` times another direction.
    fn add(&mut self, by: f64, other: &Self) {
        add_scaled(&mut self.weights, by, &other.weights);
        self.y += by * other.y;
        self.geometry.axpy(by, &other.geometry, 1.0);
    }

    pub(super) fn find_support(&mut self) {
        let told = |weight: &f64| *weight != 0.0;
        let end = self.weights.iter().rposition(told).map_or(0, |last| last + 1);
        self.support = self.weights.iter().position(told).unwrap_or(end)..end;
    }
}

impl NuisanceModel {
    /// The same nuisance model without `columns`, which were given as `also` or grown; `None` where that takes another
    /// elimination, because they told all of a column that was left out.
    ///
    /// What only these columns tell are the rows of the inverse of all products that belong to them. A reflection
    /// (Householder 1958) takes the directions to as many that hold it and the rest; the former are given back.
    #[must_use]
    pub fn without(&self, design: &Design, subset: &[usize], columns: &[usize]) -> Option<Self> {
        let mut rest = self.clone();
        rest.dependent.retain(|column| !columns.contains(column));
        let left_out: Vec<Vec<f64>> =
            rest.dependent.iter().map(|&column| design.gram_column(subset, column)).collect();
        for &column in columns.iter().filter(|column| !self.dependent.contains(column)) {
            let last = rest.directions.pop()?;
            let mut axis: Vec<f64> = rest.directions.iter().map(|d| d.weights[column]).collect();
            axis.push(last.weights[column]);
            let length = dot(&axis, &axis).sqrt();
            if length <= 0.0 {
                return None;
            }
            // Reflected onto the last direction, from the side that is farther off.
            let end = axis.len() - 1;
            let target = if axis[end] > 0.0 { -length } else { length };
            axis[end] -= target;
            let scale = 2.0 / dot(&axis, &axis);
            let mut along = last.scaled(axis[end]);
            for (by, direction) in axis.iter().zip(&rest.directions) {
                along.add(*by, direction);
            }
            for (by, direction) in axis.iter().zip(&mut rest.directions) {
                direction.add(-(scale * by), &along);
            }
            let mut told_alone = last;
            told_alone.add(-(scale * axis[end]), &along);
            let is_dependent = |(gram, column): (&Vec<f64>, &usize)| {
                dot(gram, &told_alone.weights).powi(2) > CAUSE_RANK * gram[*column]
            };
            if left_out.iter().zip(&rest.dependent).any(is_dependent) {
                return None;
            }
            let Direction { y, geometry, .. } = told_alone;
            rest.yy += y * y;
            rest.gy_raw.axpy(y, &geometry, 1.0);
            rest.gg += &geometry * geometry.transpose();
        }
        rest.finish();
        Some(rest)
    }

    /// One column after the other, made orthogonal to those before (Gram and Schmidt).
    pub(super) fn add(&mut self, gram: &DMatrix<f64>, also: &[usize]) {
        for direction in &mut self.directions {
            direction.weights.resize(gram.ncols(), 0.0);
        }
        for &column in also {
            let mut direction = vec![0.0; gram.ncols()];
            direction[column] = 1.0;
            let whole = gram[(column, column)];
            // Twice: the second pass takes out what rounding left of the first.
            for _ in 0..2 {
                let mut seen = times(gram, &direction);
                let SlowColumns { columns, size_ratio } = self.slow.clone();
                let precision = 1.0 / (size_ratio * size_ratio);
                columns.for_each(|column| seen[column] += precision * direction[column]);
                for known in &self.directions {
                    let along = dot(&known.weights, &seen);
                    add_scaled(&mut direction, -along, &known.weights);
                }
            }
            let left = dot(gram.column(column).as_slice(), &direction);
            if left > CAUSE_RANK * whole && left > 0.0 {
                let length = left.sqrt();
                direction.iter_mut().for_each(|d| *d /= length);
                self.push(gram, direction);
            } else {
                self.dependent.push(column);
            }
        }
    }

    /// Slow noise in `columns` along their principal directions, beside the flat ones.
    pub(super) fn slow_spectrum(&self, gram: &DMatrix<f64>, columns: Range<usize>) -> SlowSpectrum {
        let flat: Vec<Vec<f64>> = self.directions.iter().map(|d| times(gram, &d.weights)).collect();
        let left = |a: usize, b: usize| gram[(a, b)] - flat.iter().map(|seen| seen[a] * seen[b]).sum::<f64>();
        let n = columns.len();
        let eigen =
            DMatrix::from_fn(n, n, |r, c| left(columns.start + r, columns.start + c)).symmetric_eigen();
        SlowSpectrum { columns, flat, eigen }
    }

    /// Slow noise s ~ N(0, ratio^2 sigma^2) in its columns: along each of their principal directions with square l its share
    /// ratio^2 l / (1 + ratio^2 l) is taken out. With the prior's precision beside the products these directions have length 1, as
    /// the flat ones have.
    pub(super) fn add_slow(&mut self, gram: &DMatrix<f64>, spectrum: &SlowSpectrum, ratio: f64) {
        let SlowSpectrum { columns, flat, eigen } = spectrum;
        if columns.is_empty() || ratio <= 0.0 {
            return;
        }
        let from = self.directions.len();
        let least = RANK * eigen.eigenvalues.max();
        for (i, &square) in eigen.eigenvalues.iter().enumerate().filter(|(_, square)| **square > least) {
            let r2 = ratio * ratio * square;
            let scale = (r2 / (1.0 + r2) / square).sqrt();
            let mut direction = vec![0.0; gram.ncols()];
            for (k, column) in columns.clone().enumerate() {
                direction[column] = scale * eigen.eigenvectors[(k, i)];
            }
            let along: Vec<f64> = flat
                .iter()
                .map(|seen| columns.clone().map(|column| seen[column] * direction[column]).sum())
                .collect();
            for (known, along) in self.directions[..from].iter().zip(along) {
                add_scaled(&mut direction, -along, &known.weights);
            }
            self.slow_log_det += r2.ln_1p();
            self.push(gram, direction);
        }
        self.n_slow = self.directions.len() - from;
        self.slow = SlowColumns { columns: columns.clone(), size_ratio: ratio };
    }

    pub(super) fn push(&mut self, gram: &DMatrix<f64>, weights: Vec<f64>) {
        let along = |column: usize| dot(gram.column(column).as_slice(), &weights);
        let y = along(0);
        let geometry = DVector::from_iterator(self.geometry.len(), self.geometry.iter().map(|&g| along(g)));
        self.yy -= y * y;
        self.gg.ger(-1.0, &geometry, &geometry, 1.0);
        self.gy_raw.axpy(-y, &geometry, 1.0);
        self.directions.push(Direction { weights, y, geometry, support: 0..0 });
    }
}

/// Adds `by` times the numbers `from` to the numbers `to`.
fn add_scaled(to: &mut [f64], by: f64, from: &[f64]) {
    to.iter_mut().zip(from).for_each(|(to, from)| *to += by * from);
}

/// The product of `gram` with the sparse vector `x`.
fn times(gram: &DMatrix<f64>, x: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; gram.nrows()];
    for (c, x) in x.iter().enumerate().filter(|(_, x)| **x != 0.0) {
        add_scaled(&mut out, *x, gram.column(c).as_slice());
    }
    out
}
