//! Every gap between two stops near a step that was found, where a search has tried some of the gaps only.
//!
//! A step in the gap next to its own leaves rows that look false, and in a long file enough of them for a second step.

use super::model::FittedModel;
use inference::effects::{Candidate, CauseKey, step_moments};
use robot_model::deform::identified::Growth;

/// `candidates`, those of `fitted` in their order, with all gaps from the moment tried before a step that was chosen to the one tried behind it;
/// `None` where no step was chosen, or all gaps have been tried.
#[must_use]
pub(super) fn with_finer_steps(candidates: &[Candidate], fitted: &FittedModel<'_>) -> Option<Vec<Candidate>> {
    let dataset = &fitted.linear.dataset;
    let chosen = fitted.model.chosen.iter().map(|cause| &candidates[cause.candidate]);
    let steps: Vec<(CauseKey, f64)> =
        chosen.filter_map(|cause| Some((cause.cause_key(), cause.variant.t0_min()?))).collect();
    if steps.is_empty() {
        return None;
    }
    let all = step_moments(dataset);
    let mut tried: Vec<f64> = candidates.iter().filter_map(|candidate| candidate.variant.t0_min()).collect();
    sorting::numbers(&mut tried);
    tried.dedup();
    if all.len() <= tried.len() {
        return None;
    }
    let place = |t0_min: f64| tried.partition_point(|moment| *moment < t0_min);
    let is_near = |candidate: &Candidate, t0_min: f64| {
        let key = candidate.cause_key();
        let this = place(t0_min);
        steps.iter().any(|(of, found_min)| {
            let found = place(*found_min);
            *of == key && (this == found || this + 1 == found)
        })
    };
    let mut finer = Vec::with_capacity(candidates.len());
    for candidate in candidates {
        match candidate.variant.t0_min().filter(|&t0_min| is_near(candidate, t0_min)) {
            None => finer.push(candidate.clone()),
            Some(t0_min) => finer.extend(until_next(candidate, t0_min, &tried, &all)),
        }
    }
    Some(finer)
}

/// The candidate in its own gap and in all up to the next that was tried, which share its weight.
fn until_next(candidate: &Candidate, t0_min: f64, tried: &[f64], all: &[f64]) -> Vec<Candidate> {
    let next_min = tried.iter().copied().find(|moment| *moment > t0_min).unwrap_or(f64::INFINITY);
    let from = all.partition_point(|moment| *moment < t0_min);
    let gaps = &all[from..all.partition_point(|moment| *moment < next_min).max(from)];
    let at = |gap: &f64| {
        let mut finer = candidate.clone();
        finer.variant.growth = Growth::Step { t0_min: *gap };
        finer.weight /= gaps.len() as f64;
        finer
    };
    gaps.iter().map(at).collect()
}
