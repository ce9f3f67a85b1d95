//! A payload's mass beside springs and bends: where all joints give a little, each by a spring of its own, a search that adds one cause
//! at a time takes the largest of them one by one, and a payload that seems to weigh more for the rest.

use super::cause_group::CauseGroup;
use super::structure::causes_log_odds;
use crate::diagnose::evidence::NuisanceModel;
use crate::diagnose::marginal::log_sum;
use crate::diagnose::model::{FittedModel, Workspace};
use crate::diagnose::search::{ChosenCause, cause_columns};
use robot_model::deform::EffectKind;

/// A payload less likely than this in its place is no question.
const ASKED: f64 = 0.01;

/// Takes from a payload's mass among the `cause_groups` of `slot`, beside whatever gives under load in other places, what the springs of
/// all joints have in the place of all of these, and gives it to the spring that explains most in this one: so they are named in a
/// ranking as well.
pub(super) fn share_springs(
    fitted: &mut FittedModel<'_>,
    chosen: &[ChosenCause],
    slot: usize,
    cause_groups: &mut Vec<CauseGroup>,
) {
    let candidates = fitted.workspace.library.candidates;
    let is_payload = |c: usize| candidates[c].kind == EffectKind::PayloadMass;
    let asked = cause_groups.iter().position(|group| is_payload(group.best) && group.probability > ASKED);
    // A payload in two variants is one.
    let is_other = |k: &usize| *k != slot && !is_payload(chosen[*k].candidate);
    let others: Vec<ChosenCause> = (0..chosen.len()).filter(is_other).map(|k| chosen[k].clone()).collect();
    let Some(at) = asked else { return };
    let payload = cause_groups[at].best;
    let Some(share) = springs_alone(fitted, &others, payload) else { return };
    let Some((spring, gain_nats)) = best_spring(fitted, &others) else { return };
    let moved = share * cause_groups[at].probability;
    cause_groups[at].probability -= moved;
    let key = candidates[spring].cause_key();
    match cause_groups.iter_mut().find(|group| candidates[group.best].cause_key() == key) {
        Some(group) => group.probability += moved,
        None => cause_groups.push(CauseGroup {
            best: spring,
            probability: moved,
            gain_nats,
            size_ratio: cause_groups[at].size_ratio,
            lines: Vec::new(),
        }),
    }
    cause_groups.sort_by(|a, b| b.probability.total_cmp(&a.probability));
}

/// Probability of the springs of all joints alone, among these, the same with the candidate `payload`, and that payload with those of
/// `others` that give under load; `None` where none of these does, or not enough joints are under load.
fn springs_alone(fitted: &mut FittedModel<'_>, others: &[ChosenCause], payload: usize) -> Option<f64> {
    let Workspace { design, library, column_index } = &mut fitted.workspace;
    let candidates = library.candidates;
    let gives = |c: &&ChosenCause| {
        matches!(candidates[c.candidate].kind, EffectKind::JointCompliance | EffectKind::LinkBending)
    };
    let springs = (0..candidates.len()).find(|&c| library.all_springs(c))?;
    let (loads, rest): (Vec<&ChosenCause>, Vec<&ChosenCause>) = others.iter().partition(gives);
    if loads.is_empty() {
        return None;
    }
    let [springs, payload] = [springs, payload].map(|candidate| {
        let columns = library.columns_in_design(design, column_index, &[candidate]).concat();
        ChosenCause { candidate, columns, gain_nats: 0.0, size_ratio: 0.0 }
    });
    library.extend(design);
    let rest: Vec<ChosenCause> = rest.into_iter().cloned().collect();
    let nuisance = beside(fitted, &rest);
    let odds =
        |causes: &[&ChosenCause]| causes_log_odds(fitted, &mut nuisance.clone(), causes.iter().copied());
    let alone = odds(&[&springs]);
    let with_payload = odds(&[&springs, &payload]);
    let apart = odds(&[&loads[..], &[&payload]].concat());
    Some((alone - log_sum([alone, with_payload, apart])).exp())
}

/// The single spring that explains most beside `others`, with its gain, nats.
fn best_spring(fitted: &FittedModel<'_>, others: &[ChosenCause]) -> Option<(usize, f64)> {
    let Workspace { design, library, .. } = &fitted.workspace;
    let taken: Vec<usize> = others.iter().map(|c| c.candidate).collect();
    let nuisance = beside(fitted, others);
    let groups = design.all_groups();
    let gains = library.single_springs(&taken).into_iter().map(|c| (c, library.gain(&nuisance, &groups, c)));
    gains.max_by(|a, b| a.1.total_cmp(&b.1))
}

/// The nuisance model with `others` in it.
fn beside(fitted: &FittedModel<'_>, others: &[ChosenCause]) -> NuisanceModel {
    let design = &fitted.workspace.design;
    NuisanceModel::new(design, &design.all_groups(), &cause_columns(others, None), fitted.model.noise)
}
