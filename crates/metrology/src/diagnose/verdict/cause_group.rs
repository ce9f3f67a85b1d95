//! What stands in one slot of the model, cause by cause: all variants of one effect in one joint together.

use crate::diagnose::effects::Candidate;
use crate::diagnose::evidence::NuisanceModel;
use crate::diagnose::model::{FittedModel, Workspace};
use crate::diagnose::search::{ChosenCause, Hypothesis, HypothesisRanking, RankedHypothesis, cause_columns};
use robot_model::deform::EffectKind;
use robot_model::robot::Axis;

/// An alternative this likely, against the likeliest, cannot be told apart.
const RIVAL: f64 = 0.03;
/// Candidates that together are this likely among the causes make up the set that cannot be told apart.
const CREDIBLE: f64 = 0.95;

/// How well the shape of a beam's bending, or of a base's tilt, is known, as a share of its signal: walls, ribs and bearings are
/// in no robot file.
pub(crate) const SHAPE_KNOWN_TO: f64 = 0.1;

/// A cause over all its variants in one ranking.
pub(crate) struct CauseGroup {
    /// Index of its likeliest candidate.
    pub best: usize,
    /// Of all its variants.
    pub probability: f64,
    /// ln evidence of that variant over nothing.
    pub gain_nats: f64,
    /// Its best s / sigma.
    pub size_ratio: f64,
}

/// A slot of the model whose cause is not beyond doubt.
pub(crate) struct OpenSlot {
    /// Index of the cause that was chosen; `None`: none was.
    pub slot: Option<usize>,
    /// Causes that cannot be ruled out there, the likeliest first; where one alone is left, it and the next.
    pub alternatives: Vec<AlternativeCause>,
}

/// A cause that may stand in a slot.
pub(crate) struct AlternativeCause {
    /// Index of its likeliest candidate.
    pub candidate: usize,
    /// Among all that may stand there.
    pub probability: f64,
    /// Best s / sigma.
    pub size_ratio: f64,
}

impl OpenSlot {
    /// The slot of `groups`, of which the first `near` cannot be ruled out.
    pub(crate) fn new(slot: Option<usize>, groups: &[CauseGroup], near: usize) -> Self {
        let alternatives = groups
            .iter()
            .take(near.max(2))
            .map(|g| AlternativeCause {
                candidate: g.best,
                probability: g.probability.clamp(1e-9, 1.0),
                size_ratio: g.size_ratio,
            })
            .collect();
        Self { slot, alternatives }
    }

    /// How little is decided: entropy of the causes and of all else, nats.
    #[must_use]
    pub(crate) fn uncertainty(&self) -> f64 {
        let causes: f64 = self.alternatives.iter().map(|r| r.probability).sum();
        let all = self.alternatives.iter().map(|r| r.probability).chain([1.0 - causes]);
        all.filter(|p| *p > 0.0).map(|p| -p * p.ln()).sum()
    }
}

/// The causes of a ranking, likeliest first.
#[must_use]
pub(super) fn cause_groups(workspace: &Workspace<'_>, ranking: &HypothesisRanking) -> Vec<CauseGroup> {
    let mut found: Vec<(Key, CauseGroup)> = Vec::new();
    for RankedHypothesis { hypothesis, probability, peak } in &ranking.ranked {
        let Hypothesis::Effect(c) = hypothesis else { continue };
        let this = key(&workspace.library.candidates[*c]);
        match found.iter_mut().find(|(k, _)| *k == this) {
            Some((_, cause_group)) => cause_group.probability += probability,
            None => found.push((
                this,
                CauseGroup {
                    best: *c,
                    probability: *probability,
                    gain_nats: peak.log_evidence - ranking.null.log_evidence,
                    size_ratio: peak.size_ratio,
                },
            )),
        }
    }
    let mut cause_groups: Vec<CauseGroup> = found.into_iter().map(|(_, g)| g).collect();
    cause_groups.sort_by(|a, b| b.probability.total_cmp(&a.probability));
    cause_groups
}

/// Joins to the likeliest cause the alternative that holds it as a special case: what the alternative adds is not needed, and
/// the simpler of two nested explanations is the one to name.
pub(super) fn join_nested(workspace: &Workspace<'_>, cause_groups: &mut Vec<CauseGroup>) {
    let Some(first) = cause_groups.first() else { return };
    let simple = key(&workspace.library.candidates[first.best]);
    let nests = |g: &CauseGroup| {
        let rich = key(&workspace.library.candidates[g.best]);
        let holds_offset = matches!(rich.0, EffectKind::ThermalJointDrift | EffectKind::JointStep)
            || rich.0 == EffectKind::JointGain && workspace.library.candidates[g.best].variant.refined;
        simple.0 == EffectKind::JointOffset && holds_offset && simple.1 == rich.1
    };
    let more: f64 = cause_groups.iter().filter(|g| nests(g)).map(|g| g.probability).sum();
    cause_groups.retain(|g| !nests(g));
    cause_groups[0].probability += more;
}

/// Takes from the first cause's odds what rests on the exact shape of bending or tilt alone, where it and an alternative are both of what
/// gives under load.
pub(super) fn doubt_shapes(workspace: &Workspace<'_>, cause_groups: &mut [CauseGroup]) {
    let kinds: Vec<EffectKind> =
        cause_groups.iter().map(|g| workspace.library.candidates[g.best].kind).collect();
    let Some(first) = cause_groups.first() else { return };
    let mut probabilities: Vec<f64> = cause_groups.iter().map(|g| g.probability).collect();
    let shared: Vec<bool> = kinds.iter().map(|&kind| shapes_in_doubt(kinds[0], kind)).collect();
    raise_rivals(&mut probabilities, &shared, SHAPE_KNOWN_TO, first.gain_nats);
    for (group, probability) in cause_groups.iter_mut().zip(probabilities) {
        group.probability = probability;
    }
    cause_groups.sort_by(|a, b| b.probability.total_cmp(&a.probability));
}

/// Whether both give under load, and one of them in a shape that is known to [`SHAPE_KNOWN_TO`] only.
#[must_use]
pub(crate) fn shapes_in_doubt(one: EffectKind, other: EffectKind) -> bool {
    let rough = has_rough_shape(one) || has_rough_shape(other);
    gives_under_load(one) && gives_under_load(other) && rough
}

/// Whether an effect's shape under load is that of walls, ribs and bearings, which are in no robot file.
fn has_rough_shape(kind: EffectKind) -> bool {
    matches!(kind, EffectKind::LinkBending | EffectKind::BaseTilt)
}

/// Whether an effect is a give under load.
fn gives_under_load(kind: EffectKind) -> bool {
    has_rough_shape(kind) || kind == EffectKind::JointCompliance
}

/// The probabilities of causes, the first the likeliest, where the shape of the first's or of a `shared` alternative's signal is known to
/// a share `s` only: such a shape leaves s² of the `gain_nats` unexplained whichever of the two is true, so an alternative's odds grow by
/// exp(s² gain), to the first's own at most. The sum stays.
fn raise_rivals(probabilities: &mut [f64], shared: &[bool], s: f64, gain_nats: f64) {
    let before: f64 = probabilities.iter().sum();
    let Some((&mut first, alternatives)) = probabilities.split_first_mut() else { return };
    let odds = (s * s * gain_nats.max(0.0)).exp();
    for (alternative, _) in alternatives.iter_mut().zip(&shared[1..]).filter(|&(_, &shared)| shared) {
        *alternative = (*alternative * odds).min(first);
    }
    let after: f64 = probabilities.iter().sum();
    if after <= 0.0 {
        // Structure of no cause is likelier by more than a double can hold.
        return;
    }
    probabilities.iter_mut().for_each(|p| *p *= before / after);
}

/// The likeliest groups that together make up nearly all of the causes' probability.
#[must_use]
pub(super) fn credible(cause_groups: &[CauseGroup]) -> Vec<&CauseGroup> {
    let total: f64 = cause_groups.iter().map(|g| g.probability).sum();
    let first = cause_groups.first().map_or(0.0, |g| g.probability);
    let mut sum = 0.0;
    cause_groups
        .iter()
        .take_while(|g| {
            let more = sum < CREDIBLE * total && g.probability >= RIVAL * first;
            sum += g.probability;
            more
        })
        .collect()
}

/// Every hypothesis for one slot of the model.
#[derive(Clone, Debug)]
pub(super) struct SlotScan {
    /// All that may stand there, likeliest first.
    pub ranking: HypothesisRanking,
    /// How much the geometry's tolerances are needed beside the other causes, nats.
    pub geometry_gain_nats: f64,
}

/// Ranks every hypothesis in the slot `without` of the model (none: beside all that is chosen).
#[must_use]
pub(super) fn scan(fitted: &FittedModel<'_>, chosen: &[ChosenCause], without: Option<usize>) -> SlotScan {
    let FittedModel { model, workspace, .. } = fitted;
    let groups = workspace.design.all_groups();
    let nuisance =
        NuisanceModel::new(&workspace.design, &groups, &cause_columns(chosen, without), model.noise);
    let taken: Vec<usize> =
        chosen.iter().enumerate().filter(|(i, _)| Some(*i) != without).map(|(_, c)| c.candidate).collect();
    SlotScan {
        ranking: workspace.library.scan(&nuisance, &groups, &taken),
        geometry_gain_nats: nuisance.geometry_gain(),
    }
}

/// What variants of one cause share.
type Key = (EffectKind, Option<Axis>, Option<Axis>);

/// The cause that a candidate is a variant of.
fn key(c: &Candidate) -> Key {
    (c.kind, c.variant.joint, c.variant.joint_b)
}

#[cfg(test)]
mod tests {
    use super::raise_rivals;

    /// A gain of 100 ln 2 nats and a shape known to a tenth double an alternative's odds: .6 : .2 : .2 becomes .6 : .4 : .2.
    #[test]
    fn a_rough_shape_gives_its_rivals_back_their_odds() {
        let mut probabilities = [0.6, 0.2, 0.2];
        raise_rivals(&mut probabilities, &[true, true, false], 0.1, 100.0 * 2.0_f64.ln());
        for (p, by_hand) in probabilities.iter().zip([0.5, 1.0 / 3.0, 1.0 / 6.0]) {
            assert!((p - by_hand).abs() < 1e-12, "{probabilities:?}");
        }
    }

    /// However much was gained, nothing that is shared becomes likelier than the first; what explains nothing keeps its odds.
    #[test]
    fn a_rival_comes_level_at_most() {
        let mut level = [0.9, 0.1];
        raise_rivals(&mut level, &[true, true], 0.1, 1e6);
        assert!((level[0] - 0.5).abs() < 1e-12 && (level[1] - 0.5).abs() < 1e-12, "{level:?}");
        let mut kept = [0.9, 0.1];
        raise_rivals(&mut kept, &[true, true], 0.1, -5.0);
        assert_eq!(kept, [0.9, 0.1]);
    }
}
