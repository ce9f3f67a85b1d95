//! Two causes that may stand in the place of one: where the evidence hardly prefers the one, the answer is not sure of it.

use super::cause_group::{CREDIBLE, CauseGroup, SHAPE_KNOWN_TO, gives_under_load, has_rough_shape, key};
use crate::diagnose::evidence::NuisanceModel;
use crate::diagnose::model::{FittedModel, Workspace};
use crate::diagnose::search::{ChosenCause, NULL_PRIOR, cause_columns};

/// Two causes in the place of one.
pub(super) struct PairRival {
    /// Indices of both candidates.
    pub candidates: [usize; 2],
    /// ln odds of both over the likeliest single cause.
    odds: f64,
    gain_nats: f64,
    size_ratios: [f64; 2],
}

/// The pairs that the search weighed and that are nearly as likely in place `i` of `chosen` as the first of `groups`, likeliest first.
/// Where a shape is known to a tenth only, the odds that rest on it are no reason to rule a pair out.
#[must_use]
pub(super) fn pair_rivals(
    fitted: &FittedModel<'_>,
    chosen: &[ChosenCause],
    i: usize,
    groups: &[CauseGroup],
) -> Vec<PairRival> {
    let Some(first) = groups.first() else { return Vec::new() };
    let FittedModel { model, workspace, .. } = fitted;
    let Workspace { design, library, column_index } = workspace;
    let others: Vec<ChosenCause> =
        chosen.iter().enumerate().filter(|(k, _)| *k != i).map(|(_, c)| c.clone()).collect();
    let taken = |candidate: usize| {
        let this = key(&library.candidates[candidate]);
        others.iter().chain([&chosen[i]]).any(|c| key(&library.candidates[c.candidate]) == this)
    };
    let mut known: Vec<[usize; 2]> = library.near_pairs().to_vec();
    known.sort_unstable();
    known.dedup();
    known.retain(|pair| !pair.iter().any(|&c| taken(c) || !column_index.contains_key(&c)));
    if known.is_empty() {
        return Vec::new();
    }
    let all = design.all_groups();
    let bare = NuisanceModel::new(design, &all, &cause_columns(&others, None), model.noise);
    let nothing = bare.null().log_evidence;
    let single = first.gain_nats + library.log_prior[first.best];
    let mut rivals: Vec<PairRival> = known
        .into_iter()
        .map(|[a, b]| {
            let first_of_two = library.chosen(&bare, &all, a, &column_index[&a]);
            let mut beside = bare.clone();
            beside.grow(design, &all, &column_index[&a]);
            let second = library.chosen(&beside, &all, b, &column_index[&b]);
            let peak = library.evidence_of_two(&bare, &all, [&first_of_two, &second]);
            let gain_nats = peak.log_evidence - nothing;
            let odds = gain_nats + library.log_prior[a] + library.log_prior[b] - NULL_PRIOR.ln() - single;
            PairRival { candidates: [a, b], odds, gain_nats, size_ratios: peak.size_ratios }
        })
        .collect();
    let kind = |c: usize| library.candidates[c].kind;
    for rival in &mut rivals {
        let [a, b] = rival.candidates.map(kind);
        let of_load = gives_under_load(kind(first.best)) && gives_under_load(a) && gives_under_load(b);
        if of_load && [kind(first.best), a, b].into_iter().any(has_rough_shape) {
            let doubt = SHAPE_KNOWN_TO * SHAPE_KNOWN_TO * first.gain_nats.max(0.0);
            rival.odds = rival.odds.max((rival.odds + doubt).min(0.0));
        }
    }
    rivals.retain(|rival| rival.odds > ((1.0 - CREDIBLE) / CREDIBLE).ln());
    rivals.sort_by(|a, b| b.odds.total_cmp(&a.odds));
    rivals
}

/// Gives `pairs` their share of the probability of `groups`, half of it to each of the two causes that are then both there: what may
/// stand in one place adds up to what it did.
pub(super) fn join_pairs(workspace: &Workspace<'_>, groups: &mut Vec<CauseGroup>, pairs: &[PairRival]) {
    let candidates = &workspace.library.candidates;
    let Some(first) = groups.first().map(|g| g.probability) else { return };
    let before: f64 = groups.iter().map(|g| g.probability).sum();
    let of_pairs: f64 = pairs.iter().map(|pair| first * pair.odds.exp()).sum();
    let scale = before / (before + of_pairs);
    groups.iter_mut().for_each(|g| g.probability *= scale);
    for pair in pairs {
        let probability = 0.5 * scale * first * pair.odds.exp();
        for (k, best) in pair.candidates.into_iter().enumerate() {
            match groups.iter_mut().find(|g| key(&candidates[g.best]) == key(&candidates[best])) {
                Some(group) => group.probability += probability,
                None => groups.push(CauseGroup {
                    best,
                    probability,
                    gain_nats: pair.gain_nats,
                    size_ratio: pair.size_ratios[k],
                    beside: Some((pair.candidates[1 - k], pair.size_ratios[1 - k])),
                }),
            }
        }
    }
    groups.sort_by(|a, b| b.probability.total_cmp(&a.probability));
}
