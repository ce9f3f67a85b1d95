//! Candidates that are all one motion, of a joint or of a body, times numbers that differ from observation to observation: there
//! are thousands, their products come by matrix products, and the motion's columns are made once for all of them.

use super::matrix::{Design, by_observation};
use super::products::Products;
use crate::dataset::Dataset;
use crate::effects::{Candidate, Motion, RigidBody};
use nalgebra::DMatrix;
use robot_model::robot::Axis;
use std::ops::Range;

/// Columns of the design whose products with all members come at once: thousands of members with all of them take memory that is
/// asked for anew each time.
const COLUMNS_AT_ONCE: usize = 24;
/// Observations whose factors are widened to full numbers at once, for the same reason.
const OBSERVATIONS_AT_ONCE: usize = 64;

/// The candidates of one motion.
#[derive(Clone, Debug)]
pub struct ScaledMotions {
    /// Indices into the candidates.
    pub members: Vec<usize>,
    /// Parameters of each member.
    parameters: Vec<Vec<Parameter>>,
    /// Whitened columns of the motion itself.
    plain: DMatrix<f64>,
    /// A row for each number that scales it, a column for each observation in the order of groups. There are thousands of rows:
    /// rounded to a part in 10^7 they take half the memory, and all products and columns come from the same numbers.
    factors: DMatrix<f32>,
}

/// A parameter's column is one of the plain ones times a factor at each observation, times the prior sigma.
#[derive(Clone, Copy, Debug)]
struct Parameter {
    plain: usize,
    factor: usize,
    sigma: f64,
}

impl ScaledMotions {
    /// Whitened columns of the `k`-th member, scaled by their prior sigma.
    #[must_use]
    pub fn columns(&self, k: usize, rows_per_observation: usize) -> DMatrix<f64> {
        let of_parameter = &self.parameters[k];
        DMatrix::from_fn(self.plain.nrows(), of_parameter.len(), |row, a| {
            let Parameter { plain, factor, sigma } = of_parameter[a];
            self.plain[(row, plain)] * f64::from(self.factors[(factor, row / rows_per_observation)]) * sigma
        })
    }

    /// Products of each factor with itself, with the next, and so on as far as a member's factors lie apart, times `squares` of the plain
    /// columns, summed over `observations`: for each distance factors x squares.
    fn squares_of_factors(&self, observations: Range<usize>, squares: &[Vec<f64>]) -> Vec<DMatrix<f64>> {
        let count = self.factors.nrows();
        let apart = |member: &Vec<Parameter>| Some(member.last()?.factor - member.first()?.factor);
        let farthest = self.parameters.iter().filter_map(apart).max().unwrap_or(0);
        let mut sums = vec![DMatrix::zeros(count, squares.len()); farthest + 1];
        for from in observations.clone().step_by(OBSERVATIONS_AT_ONCE) {
            let some = OBSERVATIONS_AT_ONCE.min(observations.end - from);
            let squares = DMatrix::from_fn(some, squares.len(), |r, c| squares[c][from + r]);
            let factors = self.factors.columns(from, some).map(f64::from);
            let mut products = DMatrix::zeros(count, some);
            for (apart, sums) in sums.iter_mut().enumerate() {
                let pairs = factors.as_slice().iter().zip(&factors.as_slice()[apart..]);
                products.as_mut_slice().iter_mut().zip(pairs).for_each(|(to, (a, b))| *to = a * b);
                sums.gemm(1.0, &products, &squares, 1.0);
            }
        }
        sums
    }
}

impl Design {
    /// Those of the `candidates` that are asked for, by index, and are each one motion scaled: by joint and by body.
    #[must_use]
    pub fn scaled_motions_of(
        &self,
        dataset: &Dataset,
        candidates: &[Candidate],
        is_asked: &dyn Fn(usize) -> bool,
    ) -> Vec<ScaledMotions> {
        let joints = (0..dataset.joints()).map(|j| Motion::Joint(Axis::at(j)));
        let bodies = [RigidBody::Base, RigidBody::Tool].map(Motion::Body);
        let motions: Vec<Motion> = joints.chain(bodies).collect();
        let motion_of =
            |(at, c): (usize, &Candidate)| is_asked(at).then(|| c.effect().motion(&c.variant)).flatten();
        let motion_of: Vec<Option<Motion>> = candidates.iter().enumerate().map(motion_of).collect();
        parallel::map(motions.len(), &|at| {
            let is_member = |c: &usize| motion_of[*c] == Some(motions[at]);
            let members = (0..candidates.len()).filter(is_member).collect();
            self.scaled_motions(dataset, candidates, motions[at], members)
        })
    }

    /// Those of the `candidates` that are `motion`, scaled: `members`, by index.
    fn scaled_motions(
        &self,
        dataset: &Dataset,
        candidates: &[Candidate],
        motion: Motion,
        members: Vec<usize>,
    ) -> ScaledMotions {
        let width = match motion {
            Motion::Joint(_) => 1,
            Motion::Body(_) => members.first().map_or(0, |&c| candidates[c].prior_sigma.len()),
        };
        let plain =
            self.stack(dataset, width, |_, observation, out| motion.plain(dataset.at(observation), out));
        let mut factors_before = 0;
        let parameters = members
            .iter()
            .map(|&c| {
                let sigmas = candidates[c].prior_sigma.iter().copied().enumerate();
                let from = factors_before;
                let parameter = |(a, sigma)| match motion {
                    Motion::Joint(_) => Parameter { plain: 0, factor: from + a, sigma },
                    Motion::Body(_) => Parameter { plain: a, factor: from, sigma },
                };
                let parameters: Vec<Parameter> = sigmas.map(parameter).collect();
                factors_before = parameters.last().map_or(from, |last| last.factor + 1);
                parameters
            })
            .collect();
        let mut factors = Vec::with_capacity(factors_before * self.order.len());
        let mut of_observation = Vec::with_capacity(factors_before);
        let effects: Vec<_> =
            members.iter().map(|&c| (candidates[c].effect(), &candidates[c].variant)).collect();
        for &i in &self.order {
            of_observation.clear();
            let at = dataset.at(&dataset.observations[i]);
            for (effect, variant) in &effects {
                effect.factors(variant, at, &mut of_observation);
            }
            factors.extend(of_observation.iter().map(|factor| *factor as f32));
        }
        let factors = DMatrix::from_vec(factors_before, self.order.len(), factors);
        ScaledMotions { members, parameters, plain, factors }
    }

    /// Scales the `k`-th member of `motions` as `candidate`, another variant of the same cause and of the same priors, does.
    pub fn scale_anew(
        &self,
        dataset: &Dataset,
        motions: &mut ScaledMotions,
        k: usize,
        candidate: &Candidate,
    ) {
        let Some(first) = motions.parameters[k].first().map(|parameter| parameter.factor) else { return };
        let mut of_observation = Vec::new();
        for (&i, mut factors) in self.order.iter().zip(motions.factors.column_iter_mut()) {
            of_observation.clear();
            let at = dataset.at(&dataset.observations[i]);
            candidate.effect().factors(&candidate.variant, at, &mut of_observation);
            for (to, factor) in factors.rows_mut(first, of_observation.len()).iter_mut().zip(&of_observation)
            {
                *to = *factor as f32;
            }
        }
    }

    /// Products of all members of `motions` with themselves, into `products`.
    pub fn begin_scaled(&self, motions: &ScaledMotions, products: &mut [Products]) {
        let width = motions.plain.ncols();
        let squares: Vec<Vec<f64>> = (0..width * width)
            .map(|k| {
                let [a, b] = [k / width, k % width].map(|k| motions.plain.column(k));
                by_observation(a.as_slice(), b.as_slice(), self.rows_per_observation)
            })
            .collect();
        let of_groups: Vec<Vec<DMatrix<f64>>> = parallel::map(self.groups.len(), &|group| {
            motions.squares_of_factors(self.observations(&self.groups[group]), &squares)
        });
        for (&c, member) in motions.members.iter().zip(&motions.parameters) {
            let p = member.len();
            let mut own = Vec::with_capacity(self.groups.len() * p * p);
            for squares in &of_groups {
                for (a, b) in member.iter().flat_map(|a| member.iter().map(move |b| (a, b))) {
                    let [low, high] = [a.factor.min(b.factor), a.factor.max(b.factor)];
                    let sum = squares[high - low][(low, a.plain * width + b.plain)];
                    own.push(sum * a.sigma * b.sigma);
                }
            }
            products[c] = Products::begun(p, own, self.groups.len());
        }
    }

    /// Brings the members' products up to date with columns appended since: one matrix product for each group.
    pub fn extend_scaled(&self, motions: &ScaledMotions, products: &mut [Products]) {
        let Some(first) = motions.members.first().and_then(|&c| products.get(c)) else { return };
        let known = first.columns();
        for &c in &motions.members {
            products[c].reserve(self.room_beyond(known));
        }
        let mut from = known;
        while from < self.width() {
            let to = self.width().min(from + COLUMNS_AT_ONCE);
            self.extend_scaled_by(motions, from..to, products);
            from = to;
        }
        for &c in &motions.members {
            products[c].sum_all();
        }
    }

    /// Adds the members' products with these columns of the design.
    fn extend_scaled_by(&self, motions: &ScaledMotions, columns: Range<usize>, products: &mut [Products]) {
        let width = motions.plain.ncols();
        let by_observation: Vec<Vec<f64>> = parallel::map(columns.len() * width, &|pair| {
            let (column, plain) = (self.column(columns.start + pair / width), pair % width);
            by_observation(motions.plain.column(plain).as_slice(), column, self.rows_per_observation)
        });
        let of_group = |rows: &Range<usize>| {
            let observations = self.observations(rows);
            let mut crossed = DMatrix::zeros(motions.factors.nrows(), by_observation.len());
            for from in observations.clone().step_by(OBSERVATIONS_AT_ONCE) {
                let some = OBSERVATIONS_AT_ONCE.min(observations.end - from);
                let with = DMatrix::from_fn(some, by_observation.len(), |r, c| by_observation[c][from + r]);
                let factors = motions.factors.columns(from, some).map(f64::from);
                crossed.gemm(1.0, &factors, &with, 1.0);
            }
            crossed
        };
        let crossed: Vec<DMatrix<f64>> =
            parallel::map(self.groups.len(), &|group| of_group(&self.groups[group]));
        let (count, groups) = (motions.factors.nrows(), self.groups.len());
        for (&c, member) in motions.members.iter().zip(&motions.parameters) {
            let to = &mut products[c].cross;
            let (known, p) = (to.len(), member.len());
            to.resize(known + columns.len() * groups * p, 0.0);
            for (a, parameter) in member.iter().enumerate() {
                let first = parameter.plain * count + parameter.factor;
                for (group, of) in crossed.iter().enumerate() {
                    let to = to[known + group * p + a..].iter_mut().step_by(groups * p);
                    let of = of.as_slice()[first..].iter().step_by(width * count);
                    to.zip(of).for_each(|(to, of)| *to = of * parameter.sigma);
                }
            }
        }
    }

    /// The observations of a group's rows, in the order of groups.
    fn observations(&self, rows: &Range<usize>) -> Range<usize> {
        rows.start / self.rows_per_observation..rows.end / self.rows_per_observation
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::{Twist, evenly_spread};
    use crate::design::Whitening;
    use crate::effects::testable_effects;

    /// Sixty stations over an hour, in three groups that take turns, of unequal weights.
    fn problem() -> (Dataset, Design) {
        let dataset = evenly_spread(60);
        let residuals: Vec<Twist> = (0..60).map(|i| Twist([1e-4 * f64::from(i % 7); 6])).collect();
        let whitening = Whitening::independent((0..60).map(|i| 1.0 + f64::from(i % 4)).collect(), 0.2);
        let group_of: Vec<usize> = (0..60).map(|i| i % 3).collect();
        let design = Design::new(&dataset, &residuals, 1, whitening, &group_of);
        (dataset, design)
    }

    /// Against the products of each candidate's own columns, also with a column that came later; and those columns.
    #[test]
    fn scaled_motions_have_the_products_of_their_columns() {
        let (dataset, design) = problem();
        let all = testable_effects(&dataset).candidates;
        for motions in design.scaled_motions_of(&dataset, &all, &|_| true) {
            let mut design = design.clone();
            let motion = all[motions.members[0]].effect().motion(&all[motions.members[0]].variant);
            assert!(motions.members.len() > 3, "{motion:?}: {}", motions.members.len());
            let mut products = vec![Products::none(); all.len()];
            design.begin_scaled(&motions, &mut products);
            design.extend_scaled(&motions, &mut products);
            design.append(&DMatrix::from_fn(180, 1, |r, _| (r % 11) as f64 - 5.0));
            design.extend_scaled(&motions, &mut products);
            for (k, &c) in motions.members.iter().enumerate() {
                let columns = design.columns_of(&dataset, &all[c]);
                let off = motions.columns(k, design.rows_per_observation) - &columns;
                assert!(off.amax() <= 1e-7 * columns.amax(), "{motion:?} {c}");
                let by_columns = design.products(&motions.columns(k, design.rows_per_observation));
                assert_eq!(products[c].p, by_columns.p);
                let pairs = products[c].own.iter().zip(&by_columns.own);
                for (a, b) in pairs.chain(products[c].cross.iter().zip(&by_columns.cross)) {
                    assert!((a - b).abs() <= 1e-12 * (1.0 + b.abs()), "{motion:?} {c}: {a} {b}");
                }
                assert_eq!(products[c].cross.len(), by_columns.cross.len());
            }
        }
    }
}
