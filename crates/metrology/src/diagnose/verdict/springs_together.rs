//! Other causes beside springs and bends: where all joints give a little, each by a spring of its own, a search that adds one cause at a
//! time takes the largest of them one by one, and for the rest a payload that seems to weigh more, or an error that goes with one joint's angle.

use super::cause_group::{CauseGroup, SHAPE_KNOWN_TO};
use super::structure::causes_log_odds;
use crate::diagnose::model::{FittedModel, Workspace};
use inference::evidence::NuisanceModel;
use inference::search::{ChosenCause, cause_columns};
use robot_model::deform::EffectKind;
use statistics::log_sum;
use std::sync::Arc;

/// A cause less likely than this in its place is no question.
const ASKED: f64 = 0.01;

/// How many causes that give under load make a cause doubtful that is what springs of other joints may be taken for; `None` for another.
fn fewest_beside(kind: EffectKind) -> Option<usize> {
    match kind {
        EffectKind::PayloadMass => Some(1),
        EffectKind::GearEccentricity
        | EffectKind::GearSecondHarmonic
        | EffectKind::JointGain
        | EffectKind::JointCoupling => Some(2),
        _ => None,
    }
}

/// Takes from the likeliest such cause among the `cause_groups` of `slot`, beside whatever gives under load in other places, what the
/// springs of all joints have in the place of all of these, and gives it to the spring that explains most in this one: so they are named
/// in a ranking as well.
pub(super) fn share_springs(
    fitted: &mut FittedModel<'_>,
    chosen: &[ChosenCause],
    slot: usize,
    cause_groups: &mut Vec<CauseGroup>,
) {
    let candidates = Arc::clone(&fitted.workspace.library.candidates);
    let asked = cause_groups
        .iter()
        .position(|group| group.probability > ASKED && fewest_beside(candidates[group.best].kind).is_some());
    let Some(at) = asked else { return };
    let doubted = cause_groups[at].best;
    let key = candidates[doubted].cause_key();
    // A cause in two variants is one.
    let is_other = |k: &usize| *k != slot && candidates[chosen[*k].candidate].cause_key() != key;
    let others: Vec<ChosenCause> = (0..chosen.len()).filter(is_other).map(|k| chosen[k].clone()).collect();
    let Some(share) = springs_alone(fitted, &others, doubted) else { return };
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
    sorting::by(cause_groups, |a, b| b.probability.total_cmp(&a.probability));
}

/// Probability of the springs of all joints alone, among these, the same with the candidate `doubted`, and that cause with those of
/// `others` that give under load; `None` where none of these does, or not enough joints are under load.
fn springs_alone(fitted: &mut FittedModel<'_>, others: &[ChosenCause], doubted: usize) -> Option<f64> {
    let Workspace { design, library, column_index } = &mut fitted.workspace;
    let candidates = &library.candidates;
    let gives = |c: &&ChosenCause| {
        matches!(candidates[c.candidate].kind, EffectKind::JointCompliance | EffectKind::LinkBending)
    };
    let springs = (0..candidates.len()).find(|&c| library.all_springs(c))?;
    let (loads, rest): (Vec<&ChosenCause>, Vec<&ChosenCause>) = others.iter().partition(gives);
    if loads.len() < fewest_beside(candidates[doubted].kind)? {
        return None;
    }
    let [springs, cause] = [springs, doubted].map(|candidate| {
        let columns = library.columns_in_design(design, column_index, &[candidate]).concat();
        ChosenCause { candidate, columns, gain_nats: 0.0, size_ratio: 0.0 }
    });
    library.extend(design);
    let rest: Vec<ChosenCause> = rest.into_iter().cloned().collect();
    let nuisance = beside(fitted, &rest);
    let odds =
        |causes: &[&ChosenCause]| causes_log_odds(fitted, &mut nuisance.clone(), causes.iter().copied());
    let alone = odds(&[&springs]);
    let with_it = odds(&[&springs, &cause]);
    let apart = odds(&[&loads[..], &[&cause]].concat());
    // Masses, and so the shapes of springs, are known to a part: odds that rest on a hundredth of the gain decide nothing.
    let other = log_sum([with_it, apart]);
    let raised = other.max((other + SHAPE_KNOWN_TO.powi(2) * alone.max(0.0)).min(alone));
    Some(1.0 / (1.0 + (raised - alone).exp()))
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
