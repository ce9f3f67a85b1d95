//! The error that all targets of one visit share: the arm did not stand quite where it usually does there, and every reflector on it
//! shows that.
//!
//! A visit's rows, each times the root of its weight, have the covariance sigma^2 (I + U U'): noise of their own, and a random
//! rigid motion of the flange (a random effect; Laird and Ware 1982), which shifts all targets alike and turns them about
//! their centre. Shifts and turns are orthogonal there, so that the inverse root divides each of at most six directions by
//! its standard deviation and leaves the others as they are.

use super::whitening::{SharedError, Whitening};
use crate::dataset::{Dataset, Twist};
use nalgebra::{Matrix3, Vector3};

/// Most that is believed of a shift, in variances: an instrument reads to 0.01 mm, arms stand to 0.1 mm.
const MOST_SHIFT: f64 = 100.0;
/// The same of a turn, with targets 0.1 m from their centre.
const MOST_TURN: f64 = MOST_SHIFT / (0.1 * 0.1);
/// Targets nearer to their centre than this do not show a turn, metres.
const SMALLEST_M: f64 = 1e-3;
/// Fewer visits with several targets do not tell what those share.
const FEWEST_VISITS: usize = 5;

/// How visits with several targets scatter, by the analysis of variance (Searle, Casella and McCulloch 1992, ch. 3).
pub struct VisitScatter {
    /// Variance of what no rigid motion takes, of a row of weight 1, m^2.
    pub own_m2: f64,
    /// Degrees of freedom of that.
    pub freedom: usize,
    /// Along shifts and along turns: squares, how many directions, and what a shared variance of 1 would give.
    along: [(f64, f64, f64); 2],
}

impl VisitScatter {
    /// From the `residuals` of visits with several targets, those that are no `outliers`; `None` where there are too few such visits.
    #[must_use]
    pub fn of(
        dataset: &Dataset,
        whitening: &Whitening,
        residuals: &[Twist],
        outliers: &[bool],
    ) -> Option<Self> {
        let (mut own, mut freedom, mut visits) = (0.0, 0, 0);
        let mut along = [(0.0, 0.0, 0.0); 2];
        for visit in &dataset.visits {
            let kept: Vec<usize> = visit.iter().copied().filter(|&i| !outliers[i]).collect();
            if kept.len() < 2 {
                continue;
            }
            let d = dataset.rows_per_observation;
            let rows: Vec<f64> = kept.iter().flat_map(|&i| whitening.rows(i, residuals[i], d)).collect();
            let directions = directions(dataset, whitening, &kept);
            own += rows.iter().map(|v| v * v).sum::<f64>();
            freedom += rows.len() - directions.len();
            for direction in &directions {
                let square = direction.along(&rows).powi(2);
                own -= square;
                let (squares, count, strength) = &mut along[usize::from(direction.turns)];
                *squares += square;
                *count += 1.0;
                *strength += direction.strength;
            }
            visits += 1;
        }
        let is_enough = visits >= FEWEST_VISITS && freedom > 0;
        is_enough.then(|| Self { own_m2: own / freedom as f64, freedom, along })
    }

    /// What the targets of a visit share, where their own noise has at least the variance `least_m2`.
    #[must_use]
    pub fn shared(&self, least_m2: f64) -> SharedError {
        let own = self.own_m2.max(least_m2).max(1e-18);
        let [shift, turn] = self
            .along
            .map(|(squares, count, strength)| (squares - count * own) / (own * strength.max(1e-18)));
        SharedError { shift: shift.clamp(0.0, MOST_SHIFT), turn: turn.clamp(0.0, MOST_TURN) }
    }
}

impl SharedError {
    /// Variance of one coordinate of a target, mean over the visits.
    #[must_use]
    pub fn at_targets(&self, dataset: &Dataset) -> f64 {
        let squares = |visit: &Vec<usize>| {
            let points = || visit.iter().map(|&i| dataset.observations[i].point_m);
            let centre = points().sum::<Vector3<f64>>() / visit.len() as f64;
            points().map(|point| (point - centre).norm_squared()).sum::<f64>()
        };
        let count = dataset.visits.iter().map(Vec::len).sum::<usize>().max(1) as f64;
        // Of three turns two move a point, each by its distance.
        self.shift + self.turn * 2.0 / 3.0 * dataset.visits.iter().map(squares).sum::<f64>() / count
    }
}

/// The visits among some observations, as their rows stand in a column.
#[derive(Clone, Debug)]
pub struct Visits {
    visits: Vec<(Vec<usize>, Vec<Direction>)>,
    shared: SharedError,
    rows_per_observation: usize,
}

/// A rigid motion of a visit's targets.
#[derive(Clone, Debug)]
struct Direction {
    /// What it does to the visit's rows, as weighted, of length 1.
    rows: Vec<f64>,
    /// Squared length of those rows before they were scaled.
    strength: f64,
    turns: bool,
}

impl Direction {
    fn along(&self, rows: &[f64]) -> f64 {
        self.rows.iter().zip(rows).map(|(a, b)| a * b).sum()
    }
}

/// Shifts and turns about the centre of the targets at `observations`, which are of one visit.
fn directions(dataset: &Dataset, whitening: &Whitening, observations: &[usize]) -> Vec<Direction> {
    let d = dataset.rows_per_observation;
    let weight: f64 = observations.iter().map(|&i| whitening.weights[i]).sum();
    let point = |&i: &usize| dataset.observations[i].point_m;
    let centre = observations.iter().map(|i| whitening.weights[*i] * point(i)).sum::<Vector3<f64>>()
        / weight.max(1e-18);
    let rows = |motion: &dyn Fn(&usize) -> Twist| -> Vec<f64> {
        observations.iter().flat_map(|i| whitening.rows(*i, motion(i), d)).collect()
    };
    let turned = |axis: &Vector3<f64>| {
        rows(&|i| {
            let v = axis.cross(&(point(i) - centre));
            Twist([v.x, v.y, v.z, axis.x, axis.y, axis.z])
        })
    };
    let plain = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| turned(&axis));
    let gram = Matrix3::from_fn(|a, b| plain[a].iter().zip(&plain[b]).map(|(a, b)| a * b).sum());
    let shifts = (0..3).map(|k| {
        let mut shift = Twist::default();
        shift[k] = 1.0;
        (rows(&|_| shift), false)
    });
    let turns = gram.symmetric_eigen().eigenvectors;
    let turns = (0..3).map(|k| (turned(&turns.column(k).into_owned()), true));
    shifts
        .chain(turns)
        .filter_map(|(mut rows, turns)| {
            let strength = rows.iter().map(|v| v * v).sum::<f64>();
            rows.iter_mut().for_each(|v| *v /= strength.sqrt());
            // About a line of targets nothing turns, and one alone does not either.
            (strength > weight * SMALLEST_M * SMALLEST_M).then_some(Direction { rows, strength, turns })
        })
        .collect()
}

impl Visits {
    /// Of the observations that `order` names, in that order. None where nothing is shared.
    #[must_use]
    pub fn new(dataset: &Dataset, whitening: &Whitening, order: &[usize]) -> Self {
        let mut visits = Vec::new();
        if whitening.shared != SharedError::default() {
            let mut position_of = vec![None; dataset.observations.len()];
            for (position, &i) in order.iter().enumerate() {
                position_of[i] = Some(position);
            }
            for visit in &dataset.visits {
                let here = |&i: &usize| position_of[i].map(|position| (i, position));
                let (members, positions): (Vec<usize>, Vec<usize>) = visit.iter().filter_map(here).unzip();
                if !members.is_empty() {
                    visits.push((positions, directions(dataset, whitening, &members)));
                }
            }
        }
        Self { visits, shared: whitening.shared, rows_per_observation: dataset.rows_per_observation }
    }

    /// ln of the determinant of the matrix that [`whiten`](Self::whiten) multiplies by.
    pub fn log_determinant(&self) -> f64 {
        let directions = self.visits.iter().flat_map(|(_, directions)| directions);
        -directions.map(|direction| self.spread(direction).ln()).sum::<f64>()
    }

    /// Standard deviation along a direction, that of a target's own noise being 1.
    fn spread(&self, direction: &Direction) -> f64 {
        let shared = if direction.turns { self.shared.turn } else { self.shared.shift };
        (1.0 + shared * direction.strength).sqrt()
    }

    /// Takes the rows of a column, weighted, to rows whose errors are independent.
    pub fn whiten(&self, column: &mut [f64]) {
        self.scale(column, |spread| 1.0 / spread);
    }

    /// The other way round.
    pub fn restore(&self, column: &mut [f64]) {
        self.scale(column, |spread| spread);
    }

    fn scale(&self, column: &mut [f64], factor: impl Fn(f64) -> f64) {
        let d = self.rows_per_observation;
        let mut rows = Vec::new();
        for (positions, directions) in &self.visits {
            rows.clear();
            rows.extend(positions.iter().flat_map(|position| &column[position * d..(position + 1) * d]));
            for direction in directions {
                let more = (factor(self.spread(direction)) - 1.0) * direction.along(&rows);
                let changed = positions.iter().flat_map(|position| position * d..(position + 1) * d);
                changed.zip(&direction.rows).for_each(|(row, unit)| column[row] += more * unit);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::evenly_spread;
    use crate::design::Design;
    use crate::split_mix::SplitMix64;
    use nalgebra::DMatrix;

    const SHARED: SharedError = SharedError { shift: 2.5, turn: 300.0 };

    /// So many poses with three reflectors 0.1 m apart, of unequal weights, and ten poses with one.
    fn three_reflectors(poses: usize) -> (Dataset, Whitening) {
        let n = 3 * poses + 10;
        let mut dataset = evenly_spread(n);
        dataset.visits =
            (0..poses).map(|v| (3 * v..3 * v + 3).collect()).chain((3 * poses..n).map(|i| vec![i])).collect();
        for visit in dataset.visits.iter().take(poses) {
            for (k, off_m) in [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]].into_iter().enumerate() {
                dataset.observations[visit[k]] = dataset.observations[visit[0]].clone();
                dataset.observations[visit[k]].point_m += Vector3::from(off_m);
            }
        }
        let weights = (0..n).map(|i| 1.0 + (i % 4) as f64).collect();
        (dataset, Whitening { weights, characteristic_length_m: 0.2, shared: SHARED })
    }

    /// Against the covariance as written, inverted; of a turn its second moment about the centre of the targets.
    #[test]
    fn products_are_those_under_the_inverse_covariance() {
        let (dataset, whitening) = three_reflectors(10);
        let n = dataset.observations.len();
        let residuals: Vec<Twist> = (0..n)
            .map(|i| Twist([1e-4 * (i % 7) as f64, 2e-4, -1e-4 * (i % 5) as f64, 0.0, 0.0, 0.0]))
            .collect();
        // Three groups, none of which cuts a visit.
        let group_of: Vec<usize> = (0..n).map(|i| (i / 3) % 3).collect();
        let plain = Whitening::independent(vec![1.0; n], 0.2);
        let bare = Design::of_all(&dataset, &residuals, 1, plain);
        let design = Design::new(&dataset, &residuals, 1, whitening.clone(), &group_of);
        let mut covariance = DMatrix::zeros(3 * n, 3 * n);
        for visit in &dataset.visits {
            let weight: f64 = visit.iter().map(|&i| whitening.weights[i]).sum();
            let weighted = |&i: &usize| whitening.weights[i] * dataset.observations[i].point_m;
            let centre = visit.iter().map(weighted).sum::<Vector3<f64>>() / weight;
            let lever = |i: usize| (dataset.observations[i].point_m - centre).cross_matrix();
            for (&a, &b) in visit.iter().flat_map(|a| visit.iter().map(move |b| (a, b))) {
                let own = if a == b { 1.0 / whitening.weights[a] } else { 0.0 };
                let block = Matrix3::identity() * (own + SHARED.shift)
                    + lever(a) * lever(b).transpose() * SHARED.turn;
                covariance.view_mut((3 * a, 3 * b), (3, 3)).copy_from(&block);
            }
        }
        let columns = bare.columns_from(0);
        let expected = columns.transpose() * covariance.try_inverse().unwrap() * columns;
        let gram = design.gram(&[0, 1, 2]);
        assert!((&gram - &expected).norm() < 1e-10 * expected.norm(), "{}", (&gram - &expected).norm());
    }

    /// Residuals come back as they were put in.
    #[test]
    fn residuals_are_restored() {
        let (dataset, whitening) = three_reflectors(10);
        let n = dataset.observations.len();
        let residuals: Vec<Twist> =
            (0..n).map(|i| Twist([1e-4 * (i % 7) as f64, 2e-4, -1e-4, 0.0, 0.0, 0.0])).collect();
        let design = Design::of_all(&dataset, &residuals, 1, whitening);
        let left = design.residuals(&vec![0.0; design.width() - 1]);
        for (left, put_in) in left.iter().zip(&residuals) {
            assert!(left.iter().zip(put_in).all(|(a, b)| (a - b).abs() < 1e-15), "{left:?} {put_in:?}");
        }
    }

    /// Three hundred poses with three reflectors: 0.04 mm and 0.2 mrad shared by a pose, 0.02 mm each.
    #[test]
    fn what_reflectors_share_is_told_from_their_own_noise() {
        let (mut dataset, whitening) = three_reflectors(300);
        let mut random = SplitMix64::new(5);
        let n = dataset.observations.len();
        let mut residuals = vec![Twist::default(); n];
        for visit in &dataset.visits {
            let [shift, turn] = [4e-5, 2e-4].map(|sigma| Vector3::from_fn(|_, _| sigma * random.normal()));
            let centre = visit.iter().map(|&i| dataset.observations[i].point_m).sum::<Vector3<f64>>()
                / visit.len() as f64;
            for &i in visit {
                let own = Vector3::from_fn(|_, _| 2e-5 * random.normal()) / whitening.weights[i].sqrt();
                let moved = shift + turn.cross(&(dataset.observations[i].point_m - centre)) + own;
                residuals[i][..3].copy_from_slice(moved.as_slice());
            }
        }
        let seen = |dataset: &Dataset| VisitScatter::of(dataset, &whitening, &residuals, &vec![false; n]);
        let scatter = seen(&dataset).unwrap();
        let shared = scatter.shared(0.0);
        assert!((scatter.own_m2 / 4e-10 - 1.0).abs() < 0.1, "{}", scatter.own_m2);
        assert_eq!(scatter.freedom, 900);
        // Variances as 4 to 1 and, for 0.2 mrad over 0.02 mm, 100 per m^2; 900 numbers tell a variance to 5 %.
        assert!((shared.shift - 4.0).abs() < 0.6, "{shared:?}");
        assert!((shared.turn - 100.0).abs() < 15.0, "{shared:?}");
        dataset.visits = (0..n).map(|i| vec![i]).collect();
        assert!(seen(&dataset).is_none());
    }
}
