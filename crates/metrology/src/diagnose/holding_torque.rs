//! The torque above which gravity, not the last motion, decides on which side of its play a joint lies: between the torques that the search
//! tries, where the rows between those fit best.

use super::dataset::{Dataset, scaled};
use super::effects::{Candidate, GravityHold};
use super::linear_fit::solve;
use super::linearise::shift_m;
use super::model::FittedModel;
use std::borrow::Cow;

/// The dataset of `fitted`, with the torques that hold its play as the rows near them say.
#[must_use]
pub(super) fn with_holding_torques<'a>(fitted: &FittedModel<'a>) -> Cow<'a, Dataset> {
    let FittedModel { linear, model, workspace } = fitted;
    let mut dataset = Cow::Borrowed(&linear.dataset);
    let is_held = |candidate: &Candidate| candidate.variant.gravity_hold != GravityHold::Never;
    if !model.chosen.iter().any(|cause| is_held(&workspace.library.candidates[cause.candidate])) {
        return dataset;
    }
    let groups = workspace.design.all_groups();
    let fit = solve(&workspace.design, &groups, &model.chosen, Some(model.peak.geometry_ratio));
    for cause in &model.chosen {
        let candidate = &workspace.library.candidates[cause.candidate];
        let GravityHold::Above { limit, .. } = candidate.variant.gravity_hold else { continue };
        let Some((joint, &column)) = candidate.variant.joint.zip(cause.columns.first()) else { continue };
        let size = fit.coefficients[column - 1] * candidate.prior_sigma[0];
        let torques_n_m = between_neighbours(&dataset, &model.outliers, joint.index(), limit);
        // What the rows near it leave with the play held above `torque_n_m`, square metres.
        let left_m2 = |torque_n_m: f64| -> f64 {
            let mut tried = linear.dataset.clone();
            tried.torque_limit_n_m[joint.index()][limit] = torque_n_m;
            let of_row = |&(row, _): &(usize, f64)| {
                let observation = &linear.dataset.observations[row];
                let [now, then] = [&linear.dataset, &tried].map(|dataset| {
                    let mut signature = Vec::new();
                    candidate.effect().signature(&candidate.variant, dataset.at(observation), &mut signature);
                    scaled(signature[0], size)
                });
                let mut left = model.residuals[row];
                left.iter_mut().zip(now.iter().zip(then.iter())).for_each(|(left, (a, b))| *left += a - b);
                shift_m(&left).powi(2)
            };
            torques_n_m.iter().map(of_row).sum()
        };
        let midway = torques_n_m.windows(2).map(|pair| 0.5 * (pair[0].1 + pair[1].1));
        let best =
            midway.map(|torque_n_m| (left_m2(torque_n_m), torque_n_m)).min_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((_, torque_n_m)) = best {
            dataset.to_mut().torque_limit_n_m[joint.index()][limit] = torque_n_m;
        }
    }
    dataset
}

/// Rows that are not set aside and lie between the torques of joint `j` tried before and after `limit`, with their torques, ascending.
fn between_neighbours(dataset: &Dataset, outliers: &[bool], j: usize, limit: usize) -> Vec<(usize, f64)> {
    let limits = &dataset.torque_limit_n_m[j];
    let below = limits.iter().copied().filter(|other| *other < limits[limit]).fold(0.0, f64::max);
    let above = limits.iter().copied().filter(|other| *other > limits[limit]).fold(f64::INFINITY, f64::min);
    let torque = |row: usize| dataset.observations[row].loads.torque_n_m[j].abs();
    let mut rows: Vec<(usize, f64)> = (0..dataset.observations.len())
        .filter(|&row| !outliers[row] && (below..=above).contains(&torque(row)))
        .map(|row| (row, torque(row)))
        .collect();
    rows.sort_by(|a, b| a.1.total_cmp(&b.1));
    rows
}
