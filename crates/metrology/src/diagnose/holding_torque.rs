//! The torque above which gravity, not the last motion, decides on which side of its play a joint lies: between the rows' torques, where all
//! rows fit best.

use super::model::FittedModel;
use inference::dataset::{Dataset, Observation, scaled};
use inference::effects::{Candidate, GravityHold};
use inference::linearise::shift_m;
use std::borrow::Cow;

/// Sums of squares that differ by less than this share are the same.
const SAME: f64 = 1e-9;

/// What a row leaves, square metres, where gravity holds its play and where the last motion decides.
struct HeldRow {
    torque_n_m: f64,
    held_m2: f64,
    free_m2: f64,
}

/// The dataset of `fitted`, with the torques that hold its play as the rows say.
#[must_use]
pub(super) fn with_holding_torques<'a>(fitted: &FittedModel<'a>) -> Cow<'a, Dataset> {
    let FittedModel { linear, model, workspace } = fitted;
    let mut dataset = Cow::Borrowed(&linear.dataset);
    let is_held = |candidate: &Candidate| candidate.variant.gravity_hold != GravityHold::Never;
    if !model.chosen.iter().any(|cause| is_held(&workspace.library.candidates[cause.candidate])) {
        return dataset;
    }
    let fit = fitted.fit(&model.chosen);
    for cause in &model.chosen {
        let candidate = &workspace.library.candidates[cause.candidate];
        let GravityHold::Above { limit, .. } = candidate.variant.gravity_hold else { continue };
        let Some((joint, &column)) = candidate.variant.joint.zip(cause.columns.first()) else { continue };
        let j = joint.index();
        let size = fit.coefficients[column - 1] * candidate.prior_sigma[0];
        let rows = held_rows(fitted, candidate, (j, limit), size);
        if let Some(torque_n_m) = holding_torque_n_m(rows) {
            dataset.to_mut().torque_limit_n_m[j][limit] = torque_n_m;
        }
    }
    dataset
}

/// What the rows that are not set aside leave where the play of joint `j`, held above its `limit` and of this `size`, is held and where it is free.
fn held_rows(
    fitted: &FittedModel<'_>,
    candidate: &Candidate,
    (j, limit): (usize, usize),
    size: f64,
) -> Vec<HeldRow> {
    let FittedModel { linear, model, .. } = fitted;
    let above = |torque_n_m: f64| {
        let mut dataset = linear.dataset.clone();
        dataset.torque_limit_n_m[j][limit] = torque_n_m;
        dataset
    };
    let (always, never) = (above(0.0), above(f64::INFINITY));
    let moved = |dataset: &Dataset, observation: &Observation| {
        let mut signature = Vec::new();
        candidate.effect().signature(&candidate.variant, dataset.at(observation), &mut signature);
        scaled(signature[0], size)
    };
    let row = |i: usize| {
        let observation = &linear.dataset.observations[i];
        let now = moved(&linear.dataset, observation);
        let left_m2 = |then: &Dataset| {
            let then = moved(then, observation);
            let mut left = model.residuals[i];
            left.iter_mut().zip(now.iter().zip(then.iter())).for_each(|(left, (a, b))| *left += a - b);
            shift_m(&left).powi(2)
        };
        HeldRow {
            torque_n_m: observation.loads.torque_n_m[j].abs(),
            held_m2: left_m2(&always),
            free_m2: left_m2(&never),
        }
    };
    (0..model.residuals.len()).filter(|&i| !model.outliers[i]).map(row).collect()
}

/// The torque above which play is best held, N.m: in the middle of those between which no row says anything; `None` of a row or none.
fn holding_torque_n_m(mut rows: Vec<HeldRow>) -> Option<f64> {
    sorting::by(&mut rows, |a, b| a.torque_n_m.total_cmp(&b.torque_n_m));
    // What all rows leave where the first k of them are free.
    let mut left_m2: f64 = rows.iter().map(|row| row.held_m2).sum();
    let mut sums = Vec::new();
    for row in rows.iter().take(rows.len().saturating_sub(1)) {
        left_m2 += row.free_m2 - row.held_m2;
        sums.push(left_m2);
    }
    let least = sums.iter().copied().reduce(f64::min)?;
    let is_least = |sum: &f64| *sum <= least + SAME * least.abs();
    let first = sums.iter().position(is_least)?;
    let last = first + sums[first..].iter().take_while(|sum| is_least(sum)).count() - 1;
    Some(0.5 * (rows[first].torque_n_m + rows[last + 1].torque_n_m))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of 1 to 10 N.m. Those up to 3 say that they are free, those from 8 on that they are held, and the others nothing.
    #[test]
    fn where_no_row_says_anything_the_torque_is_in_the_middle() {
        let row = |k: u32| {
            let (held_m2, free_m2) = match k {
                1..=3 => (2.0, 1.0),
                8.. => (1.0, 2.0),
                _ => (1.0, 1.0),
            };
            HeldRow { torque_n_m: f64::from(k), held_m2, free_m2 }
        };
        let found = holding_torque_n_m((1..=10).rev().map(row).collect());
        assert_eq!(found, Some(0.5 * (3.0 + 8.0)));
        assert_eq!(holding_torque_n_m(vec![row(1)]), None);
    }
}
