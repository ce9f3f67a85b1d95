//! The design matrix: whitened columns with their meaning, and their products over groups of observations.

use super::inner_products::inner_products;
use super::registration;
use super::visits::Visits;
use super::whitening::Whitening;
use crate::dataset::{Dataset, Observation, Twist, scaled};
use crate::effects::Candidate;
use nalgebra::{DMatrix, DMatrixView};
use std::borrow::{Borrow, Cow};
use std::ops::Range;

/// Manufacturing tolerance of a joint's frame: metres, and radians.
const TOLERANCE: [f64; 2] = [1.5e-4, 2.5e-4];

/// Columns of slow noise in the design; an empty range where there is none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SlowColumns {
    /// Where they stand in the design.
    pub columns: Range<usize>,
    /// Their prior standard deviation over the noise's.
    pub size_ratio: f64,
}

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
    /// Whether all observations are touches of fixed points.
    pub touches_alone: bool,
    /// A row for each row of an observation in the order of groups.
    columns: DMatrix<f64>,
    /// Columns of registration, flat prior.
    pub registration: Range<usize>,
    /// Columns of geometry, scaled by tolerance.
    pub geometry: Range<usize>,
    slow: SlowColumns,
    /// Columns that it is going to have, as far as that is known: candidates' products make room for them at once.
    expected_width: usize,
    /// Products of all columns for each group.
    gram: Vec<DMatrix<f64>>,
}

/// Observations in the order of groups.
struct Grouped {
    order: Vec<usize>,
    /// Rows of each group.
    groups: Vec<Range<usize>>,
    /// Numbers measured in each group.
    counts: Vec<usize>,
}

impl Grouped {
    fn new(dataset: &Dataset, group_of: &[usize]) -> Self {
        let d = dataset.rows_per_observation;
        let mut order: Vec<usize> = (0..dataset.observations.len()).collect();
        sorting::by_key(&mut order, |&i| (group_of.get(i).copied().unwrap_or(0), i));
        let mut groups: Vec<Range<usize>> = Vec::new();
        let mut counts: Vec<usize> = Vec::new();
        let mut last = None;
        for (position, &i) in order.iter().enumerate() {
            let rows = position * d..(position + 1) * d;
            let measured = dataset.observations[i].rows(d);
            match (groups.last_mut(), counts.last_mut()) {
                (Some(group), Some(count)) if last == Some(group_of[i]) => {
                    group.end = rows.end;
                    *count += measured;
                }
                _ => {
                    last = Some(group_of[i]);
                    groups.push(rows);
                    counts.push(measured);
                }
            }
        }
        Self { order, groups, counts }
    }
}

impl Design {
    /// The design of `residuals` (metres and radians, base axes) at the observations of the dataset, all in one group.
    #[must_use]
    pub fn of_all(dataset: &Dataset, residuals: &[Twist], targets: usize, whitening: Whitening) -> Self {
        Self::new(dataset, residuals, targets, whitening, &vec![0; dataset.observations.len()])
    }

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
        let Grouped { order, groups, counts } = Grouped::new(dataset, group_of);
        let d = dataset.rows_per_observation;
        let mut design = Self {
            visits: Visits::new(dataset, &whitening, &order),
            whitening,
            order,
            groups,
            rows_per_observation: d,
            counts,
            touches_alone: dataset.touches_alone,
            columns: DMatrix::zeros(0, 0),
            registration: 0..0,
            geometry: 0..0,
            slow: SlowColumns::default(),
            expected_width: 0,
            gram: Vec::new(),
        };
        design.gram = vec![DMatrix::zeros(0, 0); design.groups.len()];
        design.columns = design.stack(dataset, 1, |i, _, out| out.push(residuals[i]));
        let flat = design.stack(dataset, registration::width(dataset, targets), |_, observation, out| {
            registration::twists(dataset.at(observation), targets, out);
        });
        let geometry = design.stack(dataset, 6 * (dataset.joints() - 1), |_, observation, out| {
            for frame in 1..dataset.joints() {
                for k in 0..6 {
                    out.push(scaled(observation.frame_offset(frame, k), TOLERANCE[k / 3]));
                }
            }
        });
        design.registration = 1..1 + flat.ncols();
        design.geometry = design.registration.end..design.registration.end + geometry.ncols();
        let parts = [flat, geometry];
        let width = parts.iter().map(DMatrix::ncols).sum();
        design.place(width, parts.len(), |_, part| Cow::Borrowed(&parts[part]));
        design
    }

    /// Weights of the stations.
    #[must_use]
    pub fn whitening(&self) -> &Whitening {
        &self.whitening
    }

    /// Takes columns of the design for slow noise.
    pub fn set_slow(&mut self, slow: SlowColumns) {
        self.slow = slow;
    }

    /// Columns of slow noise.
    #[must_use]
    pub fn slow(&self) -> SlowColumns {
        self.slow.clone()
    }

    /// Says that `more` columns are going to be appended.
    pub fn expect(&mut self, more: usize) {
        self.expected_width = self.width() + more;
    }

    /// Columns beyond those `known` that there is to be room for.
    pub(super) fn room_beyond(&self, known: usize) -> usize {
        self.width().max(self.expected_width).saturating_sub(known)
    }

    /// Number of columns, the data's among them.
    #[must_use]
    pub fn width(&self) -> usize {
        self.columns.ncols()
    }

    /// A column, whitened, its rows in the order of groups.
    pub(super) fn column(&self, column: usize) -> &[f64] {
        let rows = self.columns.nrows();
        &self.columns.as_slice()[column * rows..(column + 1) * rows]
    }

    /// The columns from number `from` on.
    #[must_use]
    pub fn columns_from(&self, from: usize) -> DMatrixView<'_, f64> {
        self.columns.columns(from, self.width() - from)
    }

    /// Number of cross-validation groups of rows.
    #[must_use]
    pub fn groups(&self) -> usize {
        self.groups.len()
    }

    /// The numbers of all groups: the whole of the data, as a subset.
    #[must_use]
    pub fn all_groups(&self) -> Vec<usize> {
        (0..self.groups.len()).collect()
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

    /// Products of one column with all over a subset of groups.
    #[must_use]
    pub fn gram_column(&self, subset: &[usize], column: usize) -> Vec<f64> {
        let mut sum = vec![0.0; self.width()];
        for &a in subset {
            sum.iter_mut().zip(&self.gram[a].column(column)).for_each(|(to, from)| *to += from);
        }
        sum
    }

    /// Adds columns and their products; gives their place.
    pub fn append(&mut self, columns: &DMatrix<f64>) -> Range<usize> {
        self.append_parts(columns.ncols(), 1, |_, _| Cow::Borrowed(columns))
    }

    /// Puts `parts` parts of `width` columns in all behind the columns. Each part is made when its place is there, so that many
    /// columns are never in memory twice; the design that makes it has no columns meanwhile.
    pub fn append_parts<'a>(
        &mut self,
        width: usize,
        parts: usize,
        part: impl Fn(&Self, usize) -> Cow<'a, DMatrix<f64>>,
    ) -> Range<usize> {
        let start = self.width();
        self.place(width, parts, part);
        start..self.width()
    }

    /// Takes off the columns from number `width` on.
    pub fn truncate(&mut self, width: usize) {
        let columns = std::mem::replace(&mut self.columns, DMatrix::zeros(0, 0));
        self.columns = columns.resize_horizontally(width, 0.0);
        self.gram.iter_mut().for_each(|gram| {
            *gram = std::mem::replace(gram, DMatrix::zeros(0, 0)).resize(width, width, 0.0);
        });
    }

    /// Puts the parts of `more` columns behind the columns, and multiplies what has no products yet.
    fn place<'a>(&mut self, more: usize, parts: usize, part: impl Fn(&Self, usize) -> Cow<'a, DMatrix<f64>>) {
        let known = self.gram.first().map_or(0, DMatrix::ncols);
        let mut at = self.width();
        let width = at + more;
        let columns = std::mem::replace(&mut self.columns, DMatrix::zeros(0, 0));
        let mut columns = columns.resize_horizontally(width, 0.0);
        for number in 0..parts {
            let part = part(self, number);
            columns.columns_mut(at, part.ncols()).copy_from(&part);
            at += part.ncols();
        }
        debug_assert_eq!(at, width);
        self.columns = columns;
        let all = &self.columns;
        let groups = &self.groups;
        parallel::for_each_mut(&mut self.gram, &|group, gram| {
            let all = all.rows(groups[group].start, groups[group].len());
            let new = inner_products(all.columns(known, width - known), all);
            let old = std::mem::replace(gram, DMatrix::zeros(0, 0));
            *gram = old.resize(width, width, 0.0);
            for (a, row) in (known..width).zip(new.row_iter()) {
                for (b, value) in row.iter().enumerate().take(a + 1) {
                    gram[(a, b)] = *value;
                    gram[(b, a)] = *value;
                }
            }
        });
    }

    /// A candidate's columns, scaled by their prior sigma.
    #[must_use]
    pub fn columns_of(&self, dataset: &Dataset, candidate: &Candidate) -> DMatrix<f64> {
        self.stack(dataset, candidate.prior_sigma.len(), |_, observation, out| {
            candidate.scaled_signature(dataset.at(observation), out);
        })
    }

    /// Whitened columns of `width` motions for each observation.
    #[must_use]
    pub fn stack(
        &self,
        dataset: &Dataset,
        width: usize,
        twists: impl Fn(usize, &Observation, &mut Vec<Twist>),
    ) -> DMatrix<f64> {
        let d = self.rows_per_observation;
        let rows = self.order.len() * d;
        let mut columns = vec![0.0; rows * width];
        let mut buffer = Vec::with_capacity(width);
        for (position, &i) in self.order.iter().enumerate() {
            buffer.clear();
            twists(i, &dataset.observations[i], &mut buffer);
            for (column, twist) in columns.chunks_exact_mut(rows.max(1)).zip(&buffer) {
                let twist = dataset.observations[i].observed(*twist);
                let rows = &mut column[position * d..(position + 1) * d];
                rows.iter_mut().zip(self.whitening.rows(i, twist, d)).for_each(|(to, value)| *to = value);
            }
        }
        columns.chunks_exact_mut(rows.max(1)).for_each(|column| self.visits.whiten(column));
        DMatrix::from_vec(rows, width, columns)
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
        let mut out = self.column(column).to_vec();
        for (rows, &i) in out.chunks_exact_mut(d).zip(&self.order) {
            let factor = factor(&dataset.observations[i]);
            rows.iter_mut().for_each(|v| *v *= factor);
        }
        out
    }

    /// ln of the determinant of the matrix that the rows are whitened by.
    #[must_use]
    pub fn log_determinant(&self) -> f64 {
        let d = self.rows_per_observation;
        let length = (d.saturating_sub(3)) as f64 * self.whitening.characteristic_length_m.ln();
        let of_row = |&i: &usize| 0.5 * d as f64 * self.whitening.weights[i].max(1e-24).ln() + length;
        self.order.iter().map(of_row).sum::<f64>() + self.visits.log_determinant()
    }

    /// Residual of `coefficients` (one for each column after the data) at each observation, unwhitened: metres, radians.
    #[must_use]
    pub fn residuals(&self, coefficients: &[f64]) -> Vec<Twist> {
        let mut left = self.left(coefficients);
        self.visits.restore(&mut left);
        self.without_weights(&left)
    }

    /// The same in units of each target's own noise: what the targets of a visit share is scaled down to it.
    #[must_use]
    pub fn independent_residuals(&self, coefficients: &[f64]) -> Vec<Twist> {
        self.without_weights(&self.left(coefficients))
    }

    /// What `coefficients` leave of the data column.
    fn left(&self, coefficients: &[f64]) -> Vec<f64> {
        let mut left = self.column(0).to_vec();
        for (c, column) in coefficients.iter().zip(1..).filter(|(c, _)| **c != 0.0) {
            left.iter_mut().zip(self.column(column)).for_each(|(left, value)| *left -= c * value);
        }
        left
    }

    fn without_weights(&self, left: &[f64]) -> Vec<Twist> {
        let d = self.rows_per_observation;
        let mut out = vec![Twist::default(); self.order.len()];
        for (rows, &i) in left.chunks_exact(d).zip(&self.order) {
            let root = self.whitening.weights[i].sqrt().max(1e-12);
            for (k, (to, value)) in out[i].iter_mut().zip(rows).enumerate() {
                *to = value / root / if k < 3 { 1.0 } else { self.whitening.characteristic_length_m };
            }
        }
        out
    }
}

/// One matrix of the columns of all of `parts`, which have the same rows.
#[must_use]
pub fn side_by_side(parts: &[impl Borrow<DMatrix<f64>>]) -> DMatrix<f64> {
    let rows = parts.first().map_or(0, |part| part.borrow().nrows());
    let width = parts.iter().map(|part| part.borrow().ncols()).sum();
    let mut numbers = Vec::with_capacity(rows * width);
    parts.iter().for_each(|part| numbers.extend_from_slice(part.borrow().as_slice()));
    DMatrix::from_vec(rows, width, numbers)
}

/// Products of two columns, summed over each observation's rows.
pub(super) fn by_observation(a: &[f64], b: &[f64], rows_per_observation: usize) -> Vec<f64> {
    a.chunks_exact(rows_per_observation)
        .zip(b.chunks_exact(rows_per_observation))
        .map(|(x, y)| x.iter().zip(y).map(|(x, y)| x * y).sum())
        .collect()
}
