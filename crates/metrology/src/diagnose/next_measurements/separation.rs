//! How far apart two explanations of the same rows lie at poses not yet measured, and the poses that part them most.
//!
//! Were a true, with the size these rows give it, b would be fitted to it beside registration, geometry and the other causes. What
//! b then misses at new poses, over the noise and b's own uncertainty there, squared, is L: ln odds of a over b grow by L / 2 on
//! average. The bound on choosing wrongly (Bhattacharyya 1943; Kailath 1967), sum over pairs of sqrt(p_a p_b) exp(-L / 8), is made
//! small pose by pose.

use nalgebra::{Cholesky, DMatrix, DVector};

/// A column of the normal matrix with its coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Coefficient {
    /// Which column of the normal matrix.
    pub column: usize,
    /// Its coefficient, in prior sigmas.
    pub size: f64,
}

/// A column of the normal matrix with the precision of its prior over the noise's; 0 of a flat one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FittedColumn {
    /// Which column of the normal matrix.
    pub column: usize,
    /// Noise variance over the prior's.
    pub precision: f64,
}

/// Two explanations: columns of the normal matrix.
#[derive(Clone)]
pub(super) struct Pair {
    /// Weight of confusing the two.
    pub weight: f64,
    /// Columns of the one that is taken to be true, with their coefficients.
    pub signal: Vec<Coefficient>,
    /// Which of the alternatives' models is fitted to it.
    pub fitted: usize,
    /// The probability that it is true, over both.
    pub truth: f64,
    /// Number of the two, whichever is true; `None` where it only measures what a cause gains over nothing.
    pub both: Option<usize>,
    /// Of causes whose shape is known to a share `s` only: what ln odds must pass before they part anything.
    pub shape: Option<ShapeDoubt>,
}

/// A shape known to a share s leaves s² of what the cause gains over nothing open between two causes, whichever is true.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ShapeDoubt {
    /// s², of the shape's share s.
    pub share: f64,
    /// L of the cause over nothing in the rows measured.
    pub lambda: f64,
    /// The pair of the same cause and nothing.
    pub over_nothing: usize,
}

/// The columns that one explanation is fitted with, and their precisions over the noise's.
pub(super) struct RivalModel {
    /// Columns of the normal matrix, with their precisions.
    pub columns: Vec<FittedColumn>,
}

impl RivalModel {
    fn cholesky(&self, gram: &DMatrix<f64>) -> Option<Cholesky<f64, nalgebra::Dyn>> {
        let n = self.columns.len();
        let mut normal =
            DMatrix::from_fn(n, n, |r, c| gram[(self.columns[r].column, self.columns[c].column)]);
        for (i, FittedColumn { precision, .. }) in self.columns.iter().enumerate() {
            // A little regularisation: directions that the poses do not determine stay where they are.
            normal[(i, i)] += precision + 1e-9 * normal[(i, i)] + 1e-18;
        }
        normal.cholesky()
    }

    /// Square that the fit to `signal` leaves, with the noise's unit.
    pub(super) fn square_left(&self, gram: &DMatrix<f64>, signal: &[Coefficient]) -> Option<f64> {
        let with = |column: usize| signal.iter().map(|c| gram[(column, c.column)] * c.size).sum::<f64>();
        let right = DVector::from_iterator(self.columns.len(), self.columns.iter().map(|c| with(c.column)));
        let own: f64 = signal.iter().map(|c| with(c.column) * c.size).sum();
        Some((own - right.dot(&self.cholesky(gram)?.solve(&right))).max(0.0))
    }

    /// Coefficients of the fit to the data, which are column 0.
    pub(super) fn fitted(&self, gram: &DMatrix<f64>) -> Option<Vec<f64>> {
        let right =
            DVector::from_iterator(self.columns.len(), self.columns.iter().map(|c| gram[(c.column, 0)]));
        Some(self.cholesky(gram)?.solve(&right).iter().copied().collect())
    }
}

/// What each pair misses at each pose of a pool, while poses are taken.
pub(super) struct Separation {
    sigma_m: f64,
    rows: usize,
    pairs: Vec<Pair>,
    /// For each alternative's model, pose and row: the row in axes in which its uncertainty is round.
    spread: Vec<Vec<Vec<DVector<f64>>>>,
    /// For each pair, pose and row: what the alternative misses, metres.
    missed_m: Vec<Vec<Vec<f64>>>,
    /// L of each pair over the poses taken.
    lambda: Vec<f64>,
}

impl Separation {
    /// `gram`: products of all columns over the rows measured; `pool`: for each pose its rows, a number for each column.
    pub(super) fn new(
        gram: &DMatrix<f64>,
        models: &[RivalModel],
        pairs: Vec<Pair>,
        pool: &[Vec<Vec<f64>>],
        sigma_m: f64,
    ) -> Option<Self> {
        let factors: Vec<_> = models.iter().map(|m| m.cholesky(gram)).collect::<Option<_>>()?;
        let spread = models
            .iter()
            .zip(&factors)
            .map(|(model, factor)| {
                let lower = factor.l();
                let row = |row: &Vec<f64>| {
                    let z = DVector::from_iterator(
                        model.columns.len(),
                        model.columns.iter().map(|c| row[c.column]),
                    );
                    lower.solve_lower_triangular(&z).unwrap_or(z)
                };
                pool.iter().map(|rows| rows.iter().map(row).collect()).collect()
            })
            .collect();
        let missed_m = pairs
            .iter()
            .map(|pair| {
                let (model, factor) = (&models[pair.fitted], &factors[pair.fitted]);
                let right = DVector::from_iterator(
                    model.columns.len(),
                    model.columns.iter().map(|c| {
                        pair.signal.iter().map(|of| gram[(c.column, of.column)] * of.size).sum::<f64>()
                    }),
                );
                let taken = factor.solve(&right);
                let row = |row: &Vec<f64>| {
                    let seen: f64 = pair.signal.iter().map(|of| row[of.column] * of.size).sum();
                    let fitted: f64 =
                        model.columns.iter().zip(taken.iter()).map(|(c, size)| row[c.column] * size).sum();
                    seen - fitted
                };
                pool.iter().map(|rows| rows.iter().map(row).collect()).collect()
            })
            .collect();
        let rows = pool.first().map_or(0, Vec::len);
        Some(Self { sigma_m, rows, lambda: vec![0.0; pairs.len()], pairs, spread, missed_m })
    }

    /// The bound on choosing wrongly, with `more` of each pair's L.
    fn bound(&self, more: impl Fn(usize) -> f64) -> f64 {
        self.pairs
            .iter()
            .enumerate()
            .map(|(k, pair)| pair.weight * (-(self.lambda[k] + more(k)) / 8.0).exp())
            .sum()
    }

    /// L over the poses taken, of the two that are parted least, whichever is true; where one contains the other, it is only the
    /// richer that can be told.
    pub(super) fn least(&self) -> f64 {
        let all = self.pairs.iter().filter_map(|pair| pair.both).max().map_or(0, |last| last + 1);
        let mut sums = vec![0.0; all];
        for (pair, lambda) in self.pairs.iter().zip(&self.lambda) {
            let doubt = pair
                .shape
                .map_or(0.0, |shape| shape.share * (shape.lambda + self.lambda[shape.over_nothing]));
            if let Some(both) = pair.both {
                sums[both] += pair.truth * (lambda - doubt).max(0.0);
            }
        }
        sums.into_iter().reduce(f64::min).unwrap_or(0.0)
    }

    /// The bound over the poses taken.
    pub(super) fn confusion(&self) -> f64 {
        self.bound(|_| 0.0)
    }

    /// What pose `i` adds to the L of pair `k`.
    fn gain(&self, k: usize, i: usize) -> f64 {
        let spread = &self.spread[self.pairs[k].fitted][i];
        let n = self.rows;
        let cover = DMatrix::from_fn(n, n, |r, c| spread[r].dot(&spread[c]) + f64::from(u8::from(r == c)));
        let missed = DVector::from_column_slice(&self.missed_m[k][i]);
        let Some(cholesky) = cover.cholesky() else { return 0.0 };
        missed.dot(&cholesky.solve(&missed)) / (self.sigma_m * self.sigma_m)
    }

    /// The pose that lowers the bound most; `None` of none.
    pub(super) fn best(&self, open: impl Fn(usize) -> bool) -> Option<usize> {
        let poses = self.missed_m.first().map_or(0, Vec::len);
        (0..poses)
            .filter(|i| open(*i))
            .map(|i| (self.bound(|k| self.gain(k, i)), i))
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, i)| i)
    }

    /// Takes pose `i`: what is known of every other pose follows (a Kalman filter's update, row by row).
    pub(super) fn add_pose(&mut self, i: usize) {
        for row in 0..self.rows {
            for k in 0..self.pairs.len() {
                let by = &self.spread[self.pairs[k].fitted];
                let known = 1.0 + by[i][row].norm_squared();
                let missed = self.missed_m[k][i][row];
                self.lambda[k] += missed * missed / known / (self.sigma_m * self.sigma_m);
                for (pose, spread) in self.missed_m[k].iter_mut().zip(by) {
                    for (to, w) in pose.iter_mut().zip(spread) {
                        *to -= w.dot(&by[i][row]) * missed / known;
                    }
                }
            }
            for spread in &mut self.spread {
                let along = spread[i][row].clone();
                let square = along.norm_squared();
                if square <= 0.0 {
                    continue;
                }
                // (1 + w w')^(-1/2) = 1 - a w w'
                let a = (1.0 - 1.0 / (1.0 + square).sqrt()) / square;
                for w in spread.iter_mut().flatten() {
                    let by = a * w.dot(&along);
                    w.axpy(-by, &along, 1.0);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(column: usize) -> FittedColumn {
        FittedColumn { column, precision: 0.0 }
    }

    /// By hand: a line through three points seen at x = -1, 0, 1 against a parabola of size 1 (mean and slope fitted): the
    /// parabola's fit by a mean is 2/3. At x = 2 it misses 4 - 2/3 = 10/3; the fit's variance there is 1/3 + 4/2, so that
    /// L = (10/3)^2 / (1 + 7/3) = 10/3.
    #[test]
    fn a_parabola_parts_from_a_line_where_the_line_leaves_it() {
        let x = [-1.0, 0.0, 1.0_f64];
        let rows: Vec<Vec<f64>> = x.iter().map(|x| vec![0.0, 1.0, *x, x * x]).collect();
        let gram = DMatrix::from_fn(4, 4, |r, c| rows.iter().map(|row| row[r] * row[c]).sum());
        let line = RivalModel { columns: [1, 2].map(flat).to_vec() };
        let pair = Pair {
            weight: 1.0,
            signal: vec![Coefficient { column: 3, size: 1.0 }],
            fitted: 0,
            truth: 1.0,
            both: Some(0),
            shape: None,
        };
        let pool: Vec<Vec<Vec<f64>>> =
            [0.5, 2.0_f64].iter().map(|x| vec![vec![0.0, 1.0, *x, x * x]]).collect();
        let mut separation = Separation::new(&gram, &[line], vec![pair], &pool, 1.0).unwrap();
        assert_eq!(separation.best(|_| true), Some(1));
        assert!((separation.gain(0, 1) - 10.0 / 3.0).abs() < 1e-6);
        separation.add_pose(1);
        assert!((separation.least() - 10.0 / 3.0).abs() < 1e-6);
        assert!((separation.confusion() - (-10.0_f64 / 24.0).exp()).abs() < 1e-6);
        // The same point again: with it twice the parabola misses 10/3 with variance 1/2 + 7/3 in its mean, in all
        // (10/3)^2 / (17/6) = 200/51.
        let again = separation.gain(0, 1);
        assert!((again - (200.0 / 51.0 - 10.0 / 3.0)).abs() < 1e-6, "{again}");
    }

    /// A line of slope 1 against a mean, of which a tenth's square is in doubt, over nothing: rows at -1, 0, 1 hold a square of 2
    /// over nothing and over a mean alike. At x = 10 it adds 100 over nothing; a mean of 0, known to 1/3, misses 10^2 / (4/3) = 75.
    #[test]
    fn a_shape_in_doubt_must_gain_more_than_its_doubt() {
        let row = |x: f64| vec![0.0, 1.0, x];
        let rows = [-1.0, 0.0, 1.0].map(row);
        let gram = DMatrix::from_fn(3, 3, |r, c| rows.iter().map(|row| row[r] * row[c]).sum());
        let (nothing, mean) = (RivalModel { columns: vec![] }, RivalModel { columns: vec![flat(1)] });
        let signal = vec![Coefficient { column: 2, size: 1.0 }];
        assert!((mean.square_left(&gram, &signal).unwrap() - 2.0).abs() < 1e-6);
        let pair = |fitted, both, shape| Pair {
            weight: 1.0,
            signal: signal.clone(),
            fitted,
            truth: 1.0,
            both,
            shape,
        };
        let doubt = ShapeDoubt { share: 0.25, lambda: 2.0, over_nothing: 0 };
        let pairs = vec![pair(0, None, None), pair(1, Some(0), Some(doubt))];
        let pool = vec![vec![row(10.0)]];
        let mut separation = Separation::new(&gram, &[nothing, mean], pairs, &pool, 1.0).unwrap();
        separation.add_pose(0);
        assert!((separation.least() - (75.0 - 0.25 * (2.0 + 100.0))).abs() < 1e-4, "{}", separation.least());
    }
}
