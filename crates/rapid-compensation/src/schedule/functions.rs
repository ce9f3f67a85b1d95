//! Functions of time that scale a few fixed corrections: what the forms `ramp` and `live` hold in place of buckets.
//!
//! A correction at moment t is the sum over r of `f_r(t)` times the correction that is exact at node r. The functions
//! are cardinal: `f_r` is 1 at its own node and 0 at the others, so that every fixed correction is one that the arm
//! really needs at some moment.

use super::Moment;
use nalgebra::{DMatrix, DVector};

/// A few functions of the warm-up minute (or of degrees above a table's lowest temperature).
#[derive(Clone, Debug, PartialEq)]
pub struct TimeFunctions {
    /// For each function the moment at which it is 1 and the others are 0.
    pub nodes: Vec<Moment>,
    /// How they go between.
    pub course: Course,
}

/// How functions of time go.
#[derive(Clone, Debug, PartialEq)]
pub enum Course {
    /// One function: the share s of the growth law. Its node is the settled state.
    Share,
    /// Two functions of the share: s(2s - 1), with its node at the settled state, and 4s(1 - s), with its node where half
    /// of the drift has come: what a correction has of second order in the drift is met as well.
    ShareSquared,
    /// Two functions of the share: s, with its node at the settled state, and 1 - s, with its node at the cold one, where the arm is
    /// off already.
    FromCold,
    /// Three functions of the share: s(2s - 1), 4s(1 - s) and (1 - s)(1 - 2s), with their nodes at the settled state, where half of
    /// the drift has come, and at the cold one.
    FromColdSquared,
    /// Linear between knots, held before the first and after the last.
    Knots {
        /// Minutes of the knots, ascending.
        at_min: Vec<f64>,
        /// For each knot the value of each function.
        values: Vec<Vec<f64>>,
    },
}

impl TimeFunctions {
    /// One function, the share of the growth law.
    #[must_use]
    pub fn share() -> Self {
        Self { nodes: vec![Moment::Settled], course: Course::Share }
    }

    /// Two functions of the share; half of the drift has come at `half_min`.
    #[must_use]
    pub fn share_squared(half_min: f64) -> Self {
        Self { nodes: vec![Moment::Settled, Moment::Minute(half_min)], course: Course::ShareSquared }
    }

    /// Two functions of the share, of an arm that is off when it is cold.
    #[must_use]
    pub fn from_cold() -> Self {
        Self { nodes: vec![Moment::Settled, Moment::Minute(0.0)], course: Course::FromCold }
    }

    /// Three functions of the share, of an arm that is off when it is cold; half of the drift has come at `half_min`.
    #[must_use]
    pub fn from_cold_squared(half_min: f64) -> Self {
        let nodes = vec![Moment::Settled, Moment::Minute(half_min), Moment::Minute(0.0)];
        Self { nodes, course: Course::FromColdSquared }
    }

    /// How many there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.nodes.len()
    }

    /// Their values where `share` of the growth law has come, at `t_min` of the warm-up (infinite = settled).
    #[must_use]
    pub fn at(&self, share: f64, t_min: f64) -> Vec<f64> {
        match &self.course {
            Course::Share => vec![share],
            Course::ShareSquared => vec![share * (2.0 * share - 1.0), 4.0 * share * (1.0 - share)],
            Course::FromCold => vec![share, 1.0 - share],
            Course::FromColdSquared => vec![
                share * (2.0 * share - 1.0),
                4.0 * share * (1.0 - share),
                (1.0 - share) * (1.0 - 2.0 * share),
            ],
            Course::Knots { at_min, values } => {
                let after = at_min.partition_point(|&knot| knot <= t_min);
                match (after.checked_sub(1), values.get(after)) {
                    (Some(before), Some(b)) => {
                        let (a, from, to) = (&values[before], at_min[before], at_min[after]);
                        let s = (t_min - from) / (to - from);
                        a.iter().zip(b).map(|(a, b)| a + (b - a) * s).collect()
                    }
                    (None, Some(only)) => only.clone(),
                    (Some(last), None) => values[last].clone(),
                    (None, None) => vec![0.0; self.count()],
                }
            }
        }
    }

    /// The fewest functions that meet all `courses` within `tolerance`: `courses` has a row for each quantity (any unit in
    /// which `tolerance` is given) and a column for each of the moments `at_min`, ascending; the last column is the settled
    /// state. Nodes are chosen among the moments.
    ///
    /// The functions span the leading right singular vectors; nodes are the pivots of a Gaussian elimination over them
    /// (Chaturantabut and Sorensen, 2010, discrete empirical interpolation).
    #[must_use]
    pub fn of_courses(courses: &DMatrix<f64>, at_min: &[f64], tolerance: f64) -> Self {
        let most = courses.ncols().min(courses.nrows()).clamp(1, MOST_FUNCTIONS);
        let svd = courses.clone().svd(false, true);
        let right = svd.v_t.unwrap_or_else(|| DMatrix::zeros(0, courses.ncols()));
        let mut best = Self::constant_zero(at_min);
        for rank in 1..=most.min(right.nrows()) {
            let Some(functions) = Self::of_rank(&right, rank, at_min) else { break };
            let worst = functions.worst(courses);
            best = functions;
            if worst <= tolerance {
                break;
            }
        }
        best
    }

    fn constant_zero(at_min: &[f64]) -> Self {
        let values = vec![vec![1.0]; at_min.len()];
        Self { nodes: vec![Moment::Settled], course: Course::Knots { at_min: at_min.to_vec(), values } }
    }

    fn of_rank(right: &DMatrix<f64>, rank: usize, at_min: &[f64]) -> Option<Self> {
        let mut nodes: Vec<usize> = Vec::with_capacity(rank);
        for r in 0..rank {
            let row = right.row(r).transpose();
            let residual = if nodes.is_empty() {
                row
            } else {
                let at_nodes = DMatrix::from_fn(nodes.len(), nodes.len(), |i, k| right[(k, nodes[i])]);
                let wanted = DVector::from_fn(nodes.len(), |i, _| row[nodes[i]]);
                let weights = at_nodes.lu().solve(&wanted)?;
                let mut rest = row;
                for k in 0..nodes.len() {
                    rest -= right.row(k).transpose() * weights[k];
                }
                rest
            };
            // Of equal ones the last: the settled state where a function holds to the end.
            let pivot = (0..residual.len()).fold(0, |best, k| {
                if residual[k].abs() >= residual[best].abs() * (1.0 - 1e-9) { k } else { best }
            });
            nodes.push(pivot);
        }
        // The functions at the nodes, a row a node: its inverse makes them cardinal.
        let at_nodes = DMatrix::from_fn(rank, rank, |i, k| right[(k, nodes[i])]);
        let cardinal = at_nodes.try_inverse()?;
        let values = (0..right.ncols())
            .map(|t| {
                let here = DMatrix::from_fn(1, rank, |_, k| right[(k, t)]);
                (here * &cardinal).iter().copied().collect()
            })
            .collect();
        let last = at_min.len().checked_sub(1)?;
        let moment = |&k: &usize| if k == last { Moment::Settled } else { Moment::Minute(at_min[k]) };
        Some(Self {
            nodes: nodes.iter().map(moment).collect(),
            course: Course::Knots { at_min: at_min.to_vec(), values },
        })
    }

    /// The largest distance of any quantity from what the functions make of it.
    fn worst(&self, courses: &DMatrix<f64>) -> f64 {
        let Course::Knots { at_min, values } = &self.course else { return 0.0 };
        let column = |node: &Moment| match node {
            Moment::Settled => at_min.len().saturating_sub(1),
            Moment::Minute(t) => at_min.iter().position(|at| at == t).unwrap_or(0),
        };
        let nodes: Vec<usize> = self.nodes.iter().map(column).collect();
        let mut worst = 0.0_f64;
        for (t, values) in values.iter().enumerate() {
            for i in 0..courses.nrows() {
                let made: f64 = nodes.iter().zip(values).map(|(&node, f)| courses[(i, node)] * f).sum();
                worst = worst.max((made - courses[(i, t)]).abs());
            }
        }
        worst
    }
}

/// More functions than this are not worth their corrections.
const MOST_FUNCTIONS: usize = 12;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cardinal_functions_of_the_share_keep_what_is_linear_and_what_is_square() {
        let functions = TimeFunctions::share_squared(77.0);
        for share in [0.0, 0.1, 0.5, 0.73, 1.0] {
            let f = functions.at(share, 0.0);
            assert!((f[0] + f[1] * 0.5 - share).abs() < 1e-15);
            assert!((f[0] + f[1] * 0.25 - share * share).abs() < 1e-15);
        }
        assert_eq!(TimeFunctions::share().at(0.25, 3.0), [0.25]);
        // From the cold arm on: what is constant is kept, and linear, and square.
        let (two, three) = (TimeFunctions::from_cold(), TimeFunctions::from_cold_squared(77.0));
        for share in [0.0, 0.1, 0.5, 0.73, 1.0, 1.3] {
            let (f, g) = (two.at(share, 0.0), three.at(share, 0.0));
            assert!((f[0] + f[1] - 1.0).abs() < 1e-15 && f[0] == share);
            assert!((g[0] + g[1] + g[2] - 1.0).abs() < 1e-14);
            assert!((g[0] + g[1] * 0.5 - share).abs() < 1e-14);
            assert!((g[0] + g[1] * 0.25 - share * share).abs() < 1e-14);
        }
    }

    #[test]
    fn two_lags_of_different_lengths_take_two_functions() {
        let at_min: Vec<f64> = (0..=40).map(|k| f64::from(k) * 10.0).collect();
        let lag = |t: f64, tau: f64| 1.0 - (-t / tau).exp();
        let amounts = [[0.2, 0.0], [0.1, -0.05], [0.0, 0.3], [0.15, 0.15]];
        let courses = DMatrix::from_fn(amounts.len(), at_min.len(), |i, k| {
            amounts[i][0] * lag(at_min[k], 20.0) + amounts[i][1] * lag(at_min[k], 90.0)
        });
        let functions = TimeFunctions::of_courses(&courses, &at_min, 1e-9);
        assert_eq!(functions.count(), 2);
        // At its own node each is 1 and the other 0.
        for (r, node) in functions.nodes.iter().enumerate() {
            let t_min = match node {
                Moment::Minute(t) => *t,
                Moment::Settled => f64::INFINITY,
            };
            let f = functions.at(0.0, t_min);
            assert!((f[r] - 1.0).abs() < 1e-9 && f[1 - r].abs() < 1e-9, "{f:?}");
        }
        assert_eq!(TimeFunctions::of_courses(&courses, &at_min, 1.0).count(), 1);
    }

    #[test]
    fn knots_are_held_outside() {
        let course = Course::Knots { at_min: vec![10.0, 20.0], values: vec![vec![0.0], vec![1.0]] };
        let functions = TimeFunctions { nodes: vec![Moment::Settled], course };
        for (t, value) in [(0.0, 0.0), (10.0, 0.0), (15.0, 0.5), (20.0, 1.0), (f64::INFINITY, 1.0)] {
            assert_eq!(functions.at(0.0, t), [value], "{t}");
        }
    }
}
