//! Normal equations of everything at once: registration, geometry, causes, and whole spectra of gears.
//!
//! The hundreds of columns of a spectrum are never kept: each is its joint's turn times a number for each station, so
//! that their products need one number for each pair of joints and station.

use crate::dataset::{Dataset, Twist, scaled};
use crate::design::registration;
use crate::design::{Design, Visits, Whitening};
use crate::effects::Candidate;
use nalgebra::{DMatrix, DVector};
use robot_model::robot::Axis;
use std::ops::Range;

/// Lines of a gear are counted in these, radians.
pub const LINE_RAD: f64 = 1e-4;

/// Which columns, in the order: registration, geometry, causes, lines joint by joint (sine and cosine in turn).
pub struct ModelColumns<'a> {
    /// The arm at every station.
    pub dataset: &'a Dataset,
    /// Weights of the observations.
    pub whitening: &'a Whitening,
    /// Targets on the tool.
    pub targets: usize,
    /// Causes that are no lines of a spectrum.
    pub causes: Vec<&'a Candidate>,
    /// Joints whose gears have a whole spectrum.
    pub lines: Vec<JointLines>,
}

/// The lines of one joint's gear that are fitted together.
#[derive(Clone, Debug, PartialEq)]
pub struct JointLines {
    /// The joint that they turn with.
    pub joint: Axis,
    /// Periods per turn of each line, ascending.
    pub periods: Vec<u32>,
}

/// Sums over some stations.
pub struct NormalEquations {
    /// Products of all columns.
    pub gram: DMatrix<f64>,
    /// Products with the residuals.
    pub rhs: DVector<f64>,
}

/// The most probable value of every column.
pub struct Solution {
    /// In the units of the columns.
    pub values: DVector<f64>,
    /// Lower triangular root of the normal equations' matrix.
    root: DMatrix<f64>,
}

impl Solution {
    /// Standard deviation of each value at unit noise; `None` where one is not determined.
    #[must_use]
    pub fn sigmas(&self) -> Option<Vec<f64>> {
        let n = self.root.nrows();
        let inverse = self.root.solve_lower_triangular(&DMatrix::identity(n, n))?;
        Some(inverse.column_iter().map(|column| column.norm()).collect())
    }
}

/// Whitened columns at some stations.
struct WhitenedRows {
    /// Registration, geometry, causes: rows of each station together.
    plain: DMatrix<f64>,
    /// Each spectrum joint's turn: one column.
    turns: DMatrix<f64>,
    /// Sines and cosines of each spectrum joint: a row for each station.
    angles: Vec<DMatrix<f64>>,
    /// Whitened residuals at the observations.
    data: DVector<f64>,
    visits: Visits,
}

impl WhitenedRows {
    /// One number for each station: the turn of spectrum joint `a` times a column, over the station's rows.
    fn along(&self, a: usize, other: &[f64], rows_per_observation: usize) -> Vec<f64> {
        let turn = self.turns.column(a);
        let pairs =
            turn.as_slice().chunks_exact(rows_per_observation).zip(other.chunks_exact(rows_per_observation));
        pairs.map(|(x, y)| x.iter().zip(y).map(|(x, y)| x * y).sum()).collect()
    }

    fn rhs_into(&self, at: &[Range<usize>], rows_per_observation: usize, rhs: &mut DVector<f64>) {
        rhs.rows_mut(0, self.plain.ncols()).copy_from(&self.plain.tr_mul(&self.data));
        for (a, columns) in at.iter().enumerate() {
            let data = DVector::from_vec(self.along(a, self.data.as_slice(), rows_per_observation));
            rhs.rows_mut(columns.start, columns.len()).copy_from(&self.angles[a].tr_mul(&data));
        }
    }
}

impl ModelColumns<'_> {
    /// Range of the columns of registration.
    #[must_use]
    pub fn registration(&self) -> Range<usize> {
        0..registration::width(self.dataset, self.targets)
    }

    /// Columns of geometry, in tolerances.
    #[must_use]
    pub fn geometry(&self) -> Range<usize> {
        let start = self.registration().end;
        start..start + 6 * (self.dataset.joints() - 1)
    }

    /// Columns of each cause, in prior sigmas.
    #[must_use]
    pub fn of_causes(&self) -> Vec<Range<usize>> {
        ranges(self.geometry().end, self.causes.iter().map(|c| c.prior_sigma.len()))
    }

    /// Columns of each spectrum, in [`LINE_RAD`].
    #[must_use]
    pub fn of_lines(&self) -> Vec<Range<usize>> {
        let start = self.of_causes().last().map_or(self.geometry().end, |r| r.end);
        ranges(start, self.lines.iter().map(|of| 2 * of.periods.len()))
    }

    fn rows(&self, observations: &[usize], residuals: &[Twist]) -> WhitenedRows {
        let d = self.dataset.rows_per_observation;
        let width = self.of_causes().last().map_or(self.geometry().end, |r| r.end);
        let mut rows = WhitenedRows {
            plain: DMatrix::zeros(observations.len() * d, width),
            turns: DMatrix::zeros(observations.len() * d, self.lines.len()),
            angles: self
                .lines
                .iter()
                .map(|of| DMatrix::zeros(observations.len(), 2 * of.periods.len()))
                .collect(),
            data: DVector::zeros(observations.len() * d),
            visits: Visits::new(self.dataset, self.whitening, observations),
        };
        let mut twists: Vec<Twist> = Vec::with_capacity(width);
        for (row, &i) in observations.iter().enumerate() {
            let observation = &self.dataset.observations[i];
            twists.clear();
            registration::twists(self.dataset.at(observation), self.targets, &mut twists);
            for frame in 1..self.dataset.joints() {
                twists
                    .extend((0..6).map(|k| scaled(observation.frame_offset(frame, k), Design::tolerance(k))));
            }
            for cause in &self.causes {
                cause.scaled_signature(self.dataset.at(observation), &mut twists);
            }
            let weighted = |twist: Twist| self.whitening.rows(i, observation.observed(twist), d);
            for (column, twist) in twists.iter().enumerate() {
                weighted(*twist).enumerate().for_each(|(k, v)| rows.plain[(row * d + k, column)] = v);
            }
            for (column, JointLines { joint, .. }) in self.lines.iter().enumerate() {
                let turn = scaled(observation.jacobian_column(joint.index()), LINE_RAD);
                weighted(turn).enumerate().for_each(|(k, v)| rows.turns[(row * d + k, column)] = v);
            }
            weighted(residuals[i]).enumerate().for_each(|(k, v)| rows.data[row * d + k] = v);
            for (angles, JointLines { joint, periods }) in rows.angles.iter_mut().zip(&self.lines) {
                for (k, n) in periods.iter().enumerate() {
                    let (sin, cos) = (f64::from(*n) * observation.q_rad[joint.index()]).sin_cos();
                    (angles[(row, 2 * k)], angles[(row, 2 * k + 1)]) = (sin, cos);
                }
            }
        }
        // All stations of a visit have the same joints: their angles stay factors of the whitened turns.
        rows.plain.column_iter_mut().for_each(|mut column| rows.visits.whiten(column.as_mut_slice()));
        rows.turns.column_iter_mut().for_each(|mut column| rows.visits.whiten(column.as_mut_slice()));
        rows.visits.whiten(rows.data.as_mut_slice());
        rows
    }

    /// The sums over `observations`.
    #[must_use]
    pub fn sum(&self, observations: &[usize], residuals: &[Twist]) -> NormalEquations {
        let d = self.dataset.rows_per_observation;
        let rows = self.rows(observations, residuals);
        let (at, plain) = (self.of_lines(), rows.plain.ncols());
        let width = at.last().map_or(plain, |r| r.end);
        let mut normal = NormalEquations { gram: DMatrix::zeros(width, width), rhs: DVector::zeros(width) };
        normal.gram.view_mut((0, 0), (plain, plain)).copy_from(&(rows.plain.transpose() * &rows.plain));
        rows.rhs_into(&at, d, &mut normal.rhs);
        let along = |a: usize, other: &[f64]| rows.along(a, other, d);
        let pairs: Vec<(usize, usize)> =
            (0..at.len()).flat_map(|a| (a..at.len()).map(move |b| (a, b))).collect();
        let blocks: Vec<DMatrix<f64>> = parallel::map(pairs.len(), &|pair| {
            let (a, b) = pairs[pair];
            let factors = along(a, rows.turns.column(b).as_slice());
            let mut weighted = rows.angles[b].clone();
            for mut column in weighted.column_iter_mut() {
                column.iter_mut().zip(&factors).for_each(|(v, f)| *v *= f);
            }
            rows.angles[a].transpose() * &weighted
        });
        for (&(a, b), block) in pairs.iter().zip(&blocks) {
            normal.gram.view_mut((at[a].start, at[b].start), block.shape()).copy_from(block);
            let (low, high) = ((at[b].start, at[a].start), (block.ncols(), block.nrows()));
            normal.gram.view_mut(low, high).copy_from(&block.transpose());
        }
        for (a, columns) in at.iter().enumerate() {
            let mut with_plain = DMatrix::zeros(observations.len(), plain);
            for (mut to, from) in with_plain.column_iter_mut().zip(rows.plain.column_iter()) {
                to.copy_from_slice(&along(a, from.as_slice()));
            }
            let block = with_plain.transpose() * &rows.angles[a];
            normal.gram.view_mut((0, columns.start), block.shape()).copy_from(&block);
            normal.gram.view_mut((columns.start, 0), (columns.len(), plain)).copy_from(&block.transpose());
        }
        normal
    }

    /// Products of all columns with `residuals`.
    #[must_use]
    pub fn rhs(&self, observations: &[usize], residuals: &[Twist]) -> DVector<f64> {
        let rows = self.rows(observations, residuals);
        let (at, plain) = (self.of_lines(), rows.plain.ncols());
        let mut rhs = DVector::zeros(at.last().map_or(plain, |r| r.end));
        rows.rhs_into(&at, self.dataset.rows_per_observation, &mut rhs);
        rhs
    }

    /// Squared distances that `solved` leaves at `observations`, metres.
    #[must_use]
    pub fn squares_m2(&self, observations: &[usize], residuals: &[Twist], solved: &DVector<f64>) -> Vec<f64> {
        let d = self.dataset.rows_per_observation;
        let rows = self.rows(observations, residuals);
        let mut left = rows.data - &rows.plain * solved.rows(0, rows.plain.ncols());
        for ((a, columns), angles) in self.of_lines().into_iter().enumerate().zip(&rows.angles) {
            let turned = angles * solved.rows(columns.start, columns.len());
            for (i, turned) in turned.iter().enumerate() {
                for k in i * d..(i + 1) * d {
                    left[k] -= turned * rows.turns[(k, a)];
                }
            }
        }
        rows.visits.restore(left.as_mut_slice());
        let fixed_point = |(rows, &i): (&[f64], &usize)| {
            rows.iter().take(3).map(|v| v * v).sum::<f64>() / self.whitening.weights[i]
        };
        left.as_slice().chunks_exact(d).zip(observations).map(fixed_point).collect()
    }
}

impl NormalEquations {
    /// The most probable values under `precisions` (noise variance over each column's); `None` where they have no solution.
    #[must_use]
    pub fn solve(&self, precisions: &[f64]) -> Option<Solution> {
        let root = self.root(precisions)?;
        let values = root.tr_solve_lower_triangular(&root.solve_lower_triangular(&self.rhs)?)?;
        Some(Solution { values, root })
    }

    /// The lower triangular root of all products with `precisions` on their diagonal.
    fn root(&self, precisions: &[f64]) -> Option<DMatrix<f64>> {
        let mut sum = self.gram.clone();
        for (i, precision) in precisions.iter().enumerate() {
            // A little regularisation: directions that the poses do not determine stay where they are.
            sum[(i, i)] += precision + 1e-10 * sum[(i, i)] + 1e-18;
        }
        lower_root(sum)
    }

    /// Less the sums over a part of the stations.
    #[must_use]
    pub fn without(&self, part: &Self) -> Self {
        Self { gram: &self.gram - &part.gram, rhs: &self.rhs - &part.rhs }
    }
}

/// Columns that are eliminated at a time.
const BLOCK: usize = 64;

/// The lower triangular L with L L' = `sum`, block by block, so that nearly all of it is a matrix product (Golub and Van
/// Loan 2013, ch. 4.2.9): for a thousand columns some ten times quicker than column by column.
fn lower_root(mut sum: DMatrix<f64>) -> Option<DMatrix<f64>> {
    let n = sum.nrows();
    for start in (0..n).step_by(BLOCK) {
        let width = BLOCK.min(n - start);
        let rest = start + width;
        let corner = sum.view((start, start), (width, width)).into_owned().cholesky()?.unpack();
        if rest < n {
            let below = sum.view((rest, start), (n - rest, width)).transpose();
            let below = corner.solve_lower_triangular(&below)?;
            let panel = below.transpose();
            sum.view_mut((rest, rest), (n - rest, n - rest)).gemm(-1.0, &panel, &below, 1.0);
            sum.view_mut((rest, start), (n - rest, width)).copy_from(&panel);
        }
        sum.view_mut((start, start), (width, width)).copy_from(&corner);
    }
    sum.fill_upper_triangle(0.0, 1);
    Some(sum)
}

fn ranges(start: usize, widths: impl Iterator<Item = usize>) -> Vec<Range<usize>> {
    widths
        .scan(start, |at, width| {
            let range = *at..*at + width;
            *at = range.end;
            Some(range)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::evenly_spread;

    #[test]
    fn the_lower_root_multiplies_back() {
        // More than two blocks of a matrix that is surely positive definite.
        let any = DMatrix::from_fn(150, 150, |r, c| ((r * 37 + c * 101) % 89) as f64 / 89.0);
        let sum = &any * any.transpose() + DMatrix::identity(150, 150);
        let lower = lower_root(sum.clone()).unwrap();
        assert!((&lower * lower.transpose() - &sum).norm() < 1e-11 * sum.norm());
        assert!((0..150).all(|c| (0..c).all(|r| lower[(r, c)] == 0.0)));
        assert!(lower_root(-sum).is_none());
    }

    /// Two joints' lines put into the residuals by hand, with unequal weights: the sums find them again, and leave nothing.
    #[test]
    fn lines_put_in_are_found() {
        let dataset = evenly_spread(120);
        let whitening = Whitening::independent((0..120).map(|i| 1.0 + f64::from(i % 3)).collect(), 0.2);
        let columns = ModelColumns {
            dataset: &dataset,
            whitening: &whitening,
            targets: 1,
            causes: Vec::new(),
            lines: vec![
                JointLines { joint: Axis::at(1), periods: vec![3, 7] },
                JointLines { joint: Axis::at(2), periods: vec![5] },
            ],
        };
        let residuals: Vec<Twist> = dataset
            .observations
            .iter()
            .map(|observation| {
                let second =
                    2e-4 * (7.0 * observation.q_rad[1]).sin() - 1e-4 * (3.0 * observation.q_rad[1]).cos();
                let third = 5e-5 * (5.0 * observation.q_rad[2]).cos();
                let (a, b) = (observation.jacobian_column(1), observation.jacobian_column(2));
                Twist(std::array::from_fn(|k| second * a[k] + third * b[k]))
            })
            .collect();
        let all: Vec<usize> = (0..120).collect();
        let normal = columns.sum(&all, &residuals);
        assert_eq!(normal.gram.ncols(), 9 + 30 + 6);
        assert!((&normal.gram - normal.gram.transpose()).norm() < 1e-12 * normal.gram.norm());
        assert!((columns.rhs(&all, &residuals) - &normal.rhs).norm() == 0.0);
        let mut precisions = vec![0.0; 45];
        precisions[columns.geometry()].fill(1e-3);
        let solution = normal.solve(&precisions).unwrap();
        let (solved, sigmas) = (&solution.values, solution.sigmas().unwrap());
        let expected = [0.0, -1.0, 2.0, 0.0, 0.0, 0.5];
        for (at, expected) in (columns.of_lines()[0].start..).zip(expected) {
            assert!((solved[at] - expected).abs() < 1e-5, "{at}: {} {expected}", solved[at]);
        }
        let mut sum = normal.gram.clone();
        precisions.iter().enumerate().for_each(|(i, p)| sum[(i, i)] += p);
        let inverse = sum.try_inverse().unwrap();
        for (at, sigma) in columns.of_lines()[1].clone().zip(&sigmas[columns.of_lines()[1].start..]) {
            assert!((sigma / inverse[(at, at)].sqrt() - 1.0).abs() < 1e-3);
        }
        let left = columns.squares_m2(&all, &residuals, solved);
        assert!(left.iter().all(|m2| m2.sqrt() < 1e-9), "{left:?}");
        // A part taken away is a part never added.
        let (first, second) = all.split_at(70);
        let rest = normal.without(&columns.sum(second, &residuals));
        assert!((rest.gram - columns.sum(first, &residuals).gram).norm() < 1e-9 * normal.gram.norm());
    }
}
