//! How far apart two explanations of the same rows lie at poses not yet measured, and the poses that part them most.
//!
//! Were a true, with the size these rows give it, b would be fitted to it beside registration, geometry and the other causes. What
//! b then misses at new poses, over the noise and b's own uncertainty there, squared, is L: ln odds of a over b grow by L / 2 on
//! average. The bound on choosing wrongly (Bhattacharyya 1943; Kailath 1967), sum over pairs of sqrt(p_a p_b) exp(-L / 8), is made
//! small pose by pose.

use super::rival_model::{Coefficient, Prediction, RivalModel};
use nalgebra::{DMatrix, DVector};

/// Two explanations: columns of the normal matrix.
#[derive(Clone)]
pub(super) struct Pair {
    /// Weight of confusing the two.
    pub weight: f64,
    /// Columns of the one that is taken to be true, with their coefficients.
    pub signal: Vec<Coefficient>,
    /// Which of the models it is the signal of.
    pub model: usize,
    /// Which of the models is fitted to it.
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

/// What each pair misses at each pose of a pool, while poses are taken.
pub(super) struct Separation {
    sigma_m: f64,
    /// Rows of a pose.
    rows: usize,
    poses: usize,
    pairs: Vec<Pair>,
    /// What each rival's model knows of the rows of the pool.
    models: Vec<Prediction>,
    /// For each pair, pose by pose and row by row: what the rival misses, metres.
    missed_m: Vec<Vec<f64>>,
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
                pool.iter().flatten().map(row).collect()
            })
            .collect();
        let rows = pool.first().map_or(0, Vec::len);
        let models = models.iter().zip(&factors).map(|(m, f)| Prediction::new(m, f, pool, rows)).collect();
        let lambda = vec![0.0; pairs.len()];
        Some(Self { sigma_m, rows, poses: pool.len(), lambda, pairs, models, missed_m })
    }

    /// L of pair `k` beyond what the doubt about its shape leaves open, from each pair's L.
    fn beyond_doubt(&self, k: usize, lambda: &impl Fn(usize) -> f64) -> f64 {
        let doubt = self.pairs[k].shape;
        lambda(k) - doubt.map_or(0.0, |shape| shape.share * (shape.lambda + lambda(shape.over_nothing)))
    }

    /// The bound on choosing wrongly, with each pair's L.
    fn bound(&self, lambda: &impl Fn(usize) -> f64) -> f64 {
        let pairs = self.pairs.iter().enumerate().filter(|(_, pair)| pair.weight > 0.0);
        pairs.map(|(k, pair)| pair.weight * (-self.beyond_doubt(k, lambda) / 8.0).exp()).sum()
    }

    /// L over the poses taken of the two of each number, whichever is true; where one contains the other, it is only the
    /// richer that can be told.
    pub(super) fn parted(&self) -> Vec<f64> {
        let all = self.pairs.iter().filter_map(|pair| pair.both).max().map_or(0, |last| last + 1);
        let mut sums = vec![0.0; all];
        for (k, pair) in self.pairs.iter().enumerate() {
            if let Some(both) = pair.both {
                sums[both] += pair.truth * self.beyond_doubt(k, &|k| self.lambda[k]).max(0.0);
            }
        }
        sums
    }

    /// The bound over the poses taken.
    pub(super) fn confusion(&self) -> f64 {
        self.bound(&|k| self.lambda[k])
    }

    /// What pose `i` adds to the L of pair `k`: what the rival misses there, and, where it leaves more open than the true one does, the
    /// price of that: together twice the Kullback-Leibler divergence of what the rival foretells from what the true one does.
    fn gain(&self, k: usize, i: usize) -> f64 {
        let pair = &self.pairs[k];
        let n = self.rows;
        let (truth, rival) = (&self.models[pair.model].covers[i], &self.models[pair.fitted].covers[i]);
        let missed = &self.missed_m[k][i * n..(i + 1) * n];
        let (mut square, mut trace) = (0.0, 0.0);
        for r in 0..n {
            for c in 0..n {
                let inverse = rival.inverse[r * n + c];
                square += inverse * missed[r] * missed[c] / (self.sigma_m * self.sigma_m);
                trace += inverse * truth.covariance[r * n + c];
            }
        }
        let left_open = rival.log_determinant - truth.log_determinant;
        let price = if left_open > 0.0 { left_open + trace - n as f64 } else { 0.0 };
        square + if price.is_finite() { price.max(0.0) } else { 0.0 }
    }

    /// The pose that lowers the bound most; `None` of none.
    pub(super) fn best(&self, open: impl Fn(usize) -> bool) -> Option<usize> {
        (0..self.poses)
            .filter(|i| open(*i))
            .map(|i| {
                let lambda: Vec<f64> =
                    (0..self.pairs.len()).map(|k| self.lambda[k] + self.gain(k, i)).collect();
                (self.bound(&|k| lambda[k]), i)
            })
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, i)| i)
    }

    /// Takes pose `i`: what is known of every other pose follows (a Kalman filter's update, row by row).
    pub(super) fn add_pose(&mut self, i: usize) {
        for k in 0..self.pairs.len() {
            self.lambda[k] += self.gain(k, i);
        }
        for index in i * self.rows..(i + 1) * self.rows {
            // Rivals share their models: each model is held against the row once.
            let with_row: Vec<Vec<f64>> =
                self.models.iter().map(|model| model.products_with(index, self.rows * self.poses)).collect();
            for (pair, missed_m) in self.pairs.iter().zip(&mut self.missed_m) {
                let with_row = &with_row[pair.fitted];
                let share = missed_m[index] / (1.0 + with_row[index]);
                missed_m.iter_mut().zip(with_row).for_each(|(to, along)| *to -= along * share);
            }
            for (model, with_row) in self.models.iter_mut().zip(&with_row) {
                let square = with_row[index];
                if square <= 0.0 {
                    continue;
                }
                let row = model.row(index).to_vec();
                // (1 + w w')^(-1/2) = 1 - a w w'
                let a = (1.0 - 1.0 / (1.0 + square).sqrt()) / square;
                for (w, along) in model.spread.chunks_exact_mut(model.width).zip(with_row) {
                    let by = a * along;
                    w.iter_mut().zip(&row).for_each(|(w, row)| *w -= by * row);
                }
            }
        }
        for model in &mut self.models {
            model.cover(self.rows, self.poses);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::rival_model::FittedColumn;
    use super::*;

    fn flat(column: usize) -> FittedColumn {
        FittedColumn { column, precision: 0.0 }
    }

    /// A column whose coefficient is known.
    fn known(column: usize) -> FittedColumn {
        FittedColumn { column, precision: 1e15 }
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
        let parabola = RivalModel { columns: vec![flat(1), flat(2), known(3)] };
        let pair = Pair {
            weight: 1.0,
            signal: vec![Coefficient { column: 3, size: 1.0 }],
            model: 1,
            fitted: 0,
            truth: 1.0,
            both: Some(0),
            shape: None,
        };
        let pool: Vec<Vec<Vec<f64>>> =
            [0.5, 2.0_f64].iter().map(|x| vec![vec![0.0, 1.0, *x, x * x]]).collect();
        let mut separation = Separation::new(&gram, &[line, parabola], vec![pair], &pool, 1.0).unwrap();
        assert_eq!(separation.best(|_| true), Some(1));
        assert!((separation.gain(0, 1) - 10.0 / 3.0).abs() < 1e-6);
        separation.add_pose(1);
        assert!((separation.parted()[0] - 10.0 / 3.0).abs() < 1e-6);
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
        let pair = |fitted, both, shape| {
            let (signal, truth) = (signal.clone(), 1.0);
            Pair { weight: 1.0, signal, model: fitted, fitted, truth, both, shape }
        };
        let doubt = ShapeDoubt { share: 0.25, lambda: 2.0, over_nothing: 0 };
        let pairs = vec![pair(0, None, None), pair(1, Some(0), Some(doubt))];
        let pool = vec![vec![row(10.0)]];
        let mut separation = Separation::new(&gram, &[nothing, mean], pairs, &pool, 1.0).unwrap();
        separation.add_pose(0);
        let parted = separation.parted()[0];
        assert!((parted - (75.0 - 0.25 * (2.0 + 100.0))).abs() < 1e-4, "{parted}");
    }

    /// What foretells nothing against a mean known to 1/3 from three rows of 0: a fourth row of 0 refutes neither, but the mean leaves
    /// 4/3 open where nothing leaves 1, for which it pays ln(4/3) + 3/4 - 1.
    #[test]
    fn a_rival_that_holds_the_cause_pays_for_what_it_leaves_open() {
        let rows = [[0.0, 1.0]; 3];
        let gram = DMatrix::from_fn(2, 2, |r, c| rows.iter().map(|row| row[r] * row[c]).sum());
        let (nothing, mean) = (RivalModel { columns: vec![] }, RivalModel { columns: vec![flat(1)] });
        let of = |model, fitted, both| Pair {
            weight: 1.0,
            signal: Vec::new(),
            model,
            fitted,
            truth: 1.0,
            both: Some(both),
            shape: None,
        };
        let pairs = vec![of(0, 1, 0), of(1, 0, 1)];
        let pool = vec![vec![rows[0].to_vec()]];
        let mut separation = Separation::new(&gram, &[nothing, mean], pairs, &pool, 1.0).unwrap();
        separation.add_pose(0);
        let parted = separation.parted();
        assert!((parted[0] - ((4.0_f64 / 3.0).ln() + 0.75 - 1.0)).abs() < 1e-6, "{parted:?}");
        assert!(parted[1].abs() < 1e-12, "what it leaves open refutes nothing: {parted:?}");
    }
}
