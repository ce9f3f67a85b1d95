//! Where a payload's centre lies off the measured point: one place for all causes that give under it.
//!
//! To first order each cause has three columns of its own for it, its give times the offset. The exact arm has one offset, so that
//! these columns are products of two parameters there.

use inference::dataset::Dataset;
use inference::effects::{Candidate, EffectVariant};
use inference::normal_equations::{ModelColumns, NormalEquations, Solution};
use nalgebra::{DVector, Vector3};
use robot_model::deform::EffectKind;
use robot_model::deform::gravity::Loads;
use robot_model::robot::Joints;
use std::ops::Range;

/// The furthest that a payload's centre is taken to lie off the measured point, metres.
const FURTHEST_M: f64 = 0.5;

/// Where a candidate's three parameters stand that move the payload's centre.
#[must_use]
pub(super) fn centre_at(candidate: &Candidate, joints: usize) -> Option<Range<usize>> {
    let EffectVariant { joint, refined, .. } = candidate.variant;
    let n = candidate.prior_sigma.len();
    let before = match candidate.kind {
        EffectKind::JointCompliance => 1 + joints - joint?.index() + if refined { 2 } else { 0 },
        EffectKind::LinkBending => 1 + joints - joint?.index(),
        EffectKind::BaseTilt => 2 + joints + if refined { 2 } else { 0 },
        EffectKind::PayloadMass => n - 3,
        _ => return None,
    };
    // A base on an inclined face has one parameter more.
    (n >= before + 3).then(|| n - 3..n)
}

/// A cause that gives under the payload.
struct Giving {
    /// Where its columns begin, those of the give first.
    start: usize,
    /// Its columns that move the payload's centre.
    centre: Range<usize>,
    /// Size of the give's prior over that of each centre column's, 1/m.
    per_m: [f64; 3],
    give: Give,
}

/// What the payload's centre acts on.
enum Give {
    /// A spring's: the first column.
    Spring,
    /// Of a base both of its springs' mean.
    Base,
    /// All joints' under a mass too many: the mass, and what each joint but the first gives beyond the usual, as masses of so many kg a
    /// column.
    Mass(Vec<f64>),
}

impl Giving {
    /// A cause of this `kind` that has its columns from `start` on, in units of `sigma`, and among them those of the `centre`.
    fn new(kind: EffectKind, start: usize, sigma: &[f64], centre: Range<usize>) -> Self {
        Self {
            start,
            per_m: std::array::from_fn(|k| sigma[0] / sigma[centre.start + k]),
            give: match kind {
                EffectKind::BaseTilt => Give::Base,
                EffectKind::PayloadMass => Give::Mass(sigma[..centre.start].to_vec()),
                _ => Give::Spring,
            },
            centre: start + centre.start..start + centre.end,
        }
    }

    /// The size, over its prior's, that the three columns are taken with: of a mass the largest of all joints'.
    fn size(&self, values: &DVector<f64>) -> f64 {
        let value = |k: usize| values[self.start + k];
        match &self.give {
            Give::Spring => value(0),
            Give::Base => 0.5 * (value(0) + value(1)),
            Give::Mass(kg) => {
                let largest = |most: f64, each: f64| if each.abs() > most.abs() { each } else { most };
                self.masses_kg(kg, values).fold(0.0, largest) / kg[0]
            }
        }
    }

    /// The mass too many that each joint gives under, over the largest of all joints'; `None` where there is none.
    fn shares(&self, values: &DVector<f64>) -> Option<Joints> {
        let Give::Mass(kg) = &self.give else { return None };
        let largest_kg = self.size(values) * kg[0];
        let share = |mass_kg: f64| mass_kg / largest_kg;
        (largest_kg != 0.0).then(|| self.masses_kg(kg, values).map(share).collect())
    }

    /// The mass too many as each joint gives under it, kg.
    fn masses_kg<'a>(&self, kg: &'a [f64], values: &'a DVector<f64>) -> impl Iterator<Item = f64> + 'a {
        let (start, mass) = (self.start, values[self.start] * kg[0]);
        std::iter::once(mass)
            .chain(kg.iter().enumerate().skip(1).map(move |(k, kg)| mass + values[start + k] * kg))
    }
}

/// All causes of a model that give under the payload.
pub(super) struct PayloadCentre {
    giving: Vec<Giving>,
}

impl PayloadCentre {
    /// Of the causes of `columns`.
    #[must_use]
    pub(super) fn new(columns: &ModelColumns<'_>) -> Self {
        let joints = columns.dataset.joints();
        let giving = columns.causes.iter().zip(columns.of_causes()).filter_map(|(candidate, range)| {
            let centre = centre_at(candidate, joints)?;
            Some(Giving::new(candidate.kind, range.start, &candidate.prior_sigma, centre))
        });
        Self { giving: giving.collect() }
    }

    /// Whether it is a product of parameters: of several causes, or of joints that give each in its own way.
    #[must_use]
    pub(super) fn is_product(&self) -> bool {
        self.giving.len() > 1 || self.giving.iter().any(|giving| matches!(giving.give, Give::Mass(_)))
    }

    /// The offset, flange frame, metres, that the causes' own columns come nearest to; these are set to it.
    pub(super) fn agreed_m(&self, values: &mut DVector<f64>) -> Vector3<f64> {
        let (mut sum, mut weight) = (Vector3::zeros(), 0.0);
        for giving in &self.giving {
            // To first order a mass has its columns with all joints as soft as usual.
            let size = match giving.give {
                Give::Mass(_) => values[giving.start],
                _ => giving.size(values),
            };
            for ((to, column), per_m) in sum.iter_mut().zip(giving.centre.clone()).zip(giving.per_m) {
                *to += size * values[column] / per_m;
            }
            weight += size * size;
        }
        let off_m = if weight > 0.0 { sum / weight } else { sum };
        let off_m = off_m.cap_magnitude(FURTHEST_M);
        self.set(values, &off_m);
        off_m
    }

    /// Sets the columns of all causes to one offset.
    pub(super) fn set(&self, values: &mut DVector<f64>, off_m: &Vector3<f64>) {
        for giving in &self.giving {
            let size = giving.size(values);
            for ((column, off), per_m) in giving.centre.clone().zip(off_m.iter()).zip(giving.per_m) {
                values[column] = size * off * per_m;
            }
        }
    }

    /// `dataset` with what a mass too many does there where `values` and `off_m` put it; `None` where no mass is among the causes.
    #[must_use]
    pub(super) fn dataset_at(
        &self,
        dataset: &Dataset,
        (values, off_m): (&DVector<f64>, &Vector3<f64>),
    ) -> Option<Dataset> {
        let mass = self.giving.iter().find(|giving| matches!(giving.give, Give::Mass(_)))?;
        let mut dataset = dataset.clone();
        if let Some(shares) = mass.shares(values) {
            dataset.payload_share = shares;
        }
        for observation in &mut dataset.observations {
            let joints = observation.joints();
            let Loads { unit_torque_n_m, unit_lever_n, .. } = &mut observation.loads;
            for (torque, lever) in unit_torque_n_m.iter_mut().zip(unit_lever_n).take(joints) {
                *torque += Vector3::from(*lever).dot(off_m);
            }
        }
        Some(dataset)
    }

    /// One step of Gauss-Newton with the offset as one parameter for all causes: `normal` holds the products of all columns, and
    /// with what the arm under `values` and `off_m` leaves. `None` where they have no solution.
    #[must_use]
    pub(super) fn step(
        &self,
        normal: &NormalEquations,
        precisions: &[f64],
        (values, off_m): (&DVector<f64>, &Vector3<f64>),
    ) -> Option<(Solution, Vector3<f64>)> {
        let n = values.len();
        let precisions = DVector::from_column_slice(precisions);
        let mut gram = normal.gram.clone();
        gram.set_diagonal(&(gram.diagonal() + &precisions));
        let gradient = &normal.rhs - precisions.component_mul(values);
        // The offset's three columns come last.
        let mut gram = gram.resize(n + 3, n + 3, 0.0);
        let mut gradient = gradient.resize_vertically(n + 3, 0.0);
        let chains = self.chains(values, off_m);
        for &(from, to, factor) in &chains {
            let column = factor * gram.column(from);
            gram.column_mut(to).axpy(1.0, &column, 1.0);
            gradient[to] += factor * gradient[from];
        }
        for &(from, to, factor) in &chains {
            let row = factor * gram.row(from);
            gram.row_mut(to).iter_mut().zip(row.iter()).for_each(|(to, value)| *to += value);
        }
        // What follows from others is no parameter of its own.
        for column in self.giving.iter().flat_map(|giving| giving.centre.clone()) {
            gram.column_mut(column).fill(0.0);
            gram.row_mut(column).fill(0.0);
            (gram[(column, column)], gradient[column]) = (1.0, 0.0);
        }
        let mut at = values.clone().resize_vertically(n + 3, 0.0);
        at.rows_mut(n, 3).copy_from(off_m);
        let rhs = gradient + &gram * &at;
        let mut solution = NormalEquations { gram, rhs }.solve(&vec![0.0; n + 3])?;
        let off_m = Vector3::from(solution.values.fixed_rows::<3>(n)).cap_magnitude(FURTHEST_M);
        solution.values = solution.values.rows(0, n).into_owned();
        self.set(&mut solution.values, &off_m);
        Some((solution, off_m))
    }

    /// How each centre column follows from other columns: its place, the other's, and its derivative by that.
    fn chains(&self, values: &DVector<f64>, off_m: &Vector3<f64>) -> Vec<(usize, usize, f64)> {
        let mut all = Vec::new();
        for giving in &self.giving {
            let size = giving.size(values);
            // A mass's own columns are taken where the offset puts it already.
            let give: &[(usize, f64)] = match giving.give {
                Give::Spring => &[(0, 1.0)],
                Give::Base => &[(0, 0.5), (1, 0.5)],
                Give::Mass(_) => &[],
            };
            for (k, (column, per_m)) in giving.centre.clone().zip(giving.per_m).enumerate() {
                all.push((column, values.len() + k, size * per_m));
                all.extend(give.iter().map(|(i, part)| (column, giving.start + i, part * off_m[k] * per_m)));
            }
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::evenly_spread;
    use inference::effects::testable_effects;

    /// A spring, a base, and a mass whose second joint gives twice as much; four columns before them, two behind.
    fn three() -> (PayloadCentre, DVector<f64>) {
        let giving = |start: usize, centre: usize, give: Give| Giving {
            start,
            centre: centre..centre + 3,
            per_m: [2.0, 3.0, 5.0],
            give,
        };
        let all = vec![
            giving(4, 6, Give::Spring),
            giving(9, 11, Give::Base),
            giving(14, 17, Give::Mass(vec![0.5, 0.25, 0.25])),
        ];
        let mut values = DVector::from_fn(22, |i, _| 0.3 + 0.01 * i as f64);
        (values[14], values[15], values[16]) = (3.0, 6.0, 0.0);
        (PayloadCentre { giving: all }, values)
    }

    /// By central differences of what `set` writes; of a mass by the offset alone.
    #[test]
    fn columns_of_the_centre_follow_from_give_and_offset() {
        let (centre, values) = three();
        let off_m = Vector3::new(0.04, -0.02, 0.03);
        let written = |column: usize, step: f64| {
            let (mut values, mut off_m) = (values.clone(), off_m);
            if column < 22 {
                values[column] += step;
            } else {
                off_m[column - 22] += step;
            }
            centre.set(&mut values, &off_m);
            values
        };
        let mut sums = vec![0.0; 22 * 25];
        centre.chains(&values, &off_m).iter().for_each(|&(from, to, by)| sums[from * 25 + to] += by);
        for to in (0..25).filter(|to| ![14, 15, 16].contains(to)) {
            let slope = (written(to, 1e-6) - written(to, -1e-6)) / 2e-6;
            for from in (6..9).chain(11..14).chain(17..20) {
                let expected = if to == from { 0.0 } else { slope[from] };
                assert!((sums[from * 25 + to] - expected).abs() < 1e-8, "{from} by {to}");
            }
        }
        // 6 * 0.25 kg more than the mass of 1.5 kg at the second joint: 3 kg, which are 6 columns of half a kilogram.
        assert_eq!(centre.giving[2].size(&values), 6.0);
    }

    /// Each joint gives c m (t + l . off) under its own share m of the mass, and c m l by the offset: summed by hand.
    #[test]
    fn a_mass_turns_each_joint_by_its_own_share_about_the_offset() {
        let mut dataset = evenly_spread(4);
        dataset.observations.iter_mut().for_each(|observation| observation.payload_kg = Some(2.0));
        (dataset.channels.payload, dataset.largest_payload_kg) = (true, 2.0);
        let all = testable_effects(&dataset).candidates;
        let candidate = all.iter().find(|candidate| candidate.kind == EffectKind::PayloadMass).unwrap();
        let sigma = &candidate.prior_sigma;
        let giving = Giving::new(EffectKind::PayloadMass, 0, sigma, 6..9);
        let centre = PayloadCentre { giving: vec![giving] };
        let masses_kg = [1.2, 0.3, 2.0, 1.1, -0.4, 1.7];
        let values = (0..9).map(|k| match k {
            0 => masses_kg[0] / sigma[0],
            1..6 => (masses_kg[k] - masses_kg[0]) / sigma[k],
            _ => 0.0,
        });
        let values = DVector::from_iterator(9, values);
        let off_m = Vector3::new(0.04, -0.02, 0.03);
        let there = centre.dataset_at(&dataset, (&values, &off_m)).unwrap();
        for (before, observation) in dataset.observations.iter().zip(&there.observations) {
            let mut signature = Vec::new();
            candidate.scaled_signature(there.at(observation), &mut signature);
            let expected = |part: &dyn Fn(usize) -> f64| {
                let mut all = [0.0; 6];
                for (j, compliance) in [8e-6, 8e-6, 8e-6, 8e-5, 8e-5, 8e-5].into_iter().enumerate() {
                    let turn = compliance * masses_kg[j] * part(j);
                    all.iter_mut().zip(before.jacobian_column(j)).for_each(|(all, by)| *all += turn * by);
                }
                all
            };
            let loads = &before.loads;
            let turned =
                expected(&|j| loads.unit_torque_n_m[j] + Vector3::from(loads.unit_lever_n[j]).dot(&off_m));
            let chains = centre.chains(&values, &off_m);
            for i in 0..6 {
                let own: f64 = (0..6).map(|k| values[k] * signature[k][i]).sum();
                assert!((own - turned[i]).abs() < 1e-15, "{own} {}", turned[i]);
                for &(column, to, factor) in &chains {
                    let by_offset = expected(&|j| loads.unit_lever_n[j][to - 9])[i];
                    assert!((factor * signature[column][i] - by_offset).abs() < 1e-15, "{column}");
                }
            }
        }
    }
}
