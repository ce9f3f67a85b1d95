//! What stands in one slot of the model, cause by cause: all variants of one effect in one joint together.

use crate::diagnose::model::{FittedModel, Workspace};
use inference::effects::CauseKey;
use inference::evidence::NuisanceModel;
use inference::gear_lines::{AngleSpectra, is_one_bend};
use inference::search::{
    ChosenCause, Hypothesis, HypothesisRanking, NULL_PRIOR, RankedHypothesis, cause_columns,
};
use robot_model::deform::EffectKind;
use statistics::log_sum;

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
    /// The lines of its gear that it may be, the likeliest first; none of what is no line.
    pub lines: Vec<LineShare>,
}

/// One of the lines that a cause may be.
pub(crate) struct LineShare {
    /// Index of its likeliest candidate.
    pub candidate: usize,
    /// Its part of the cause's probability.
    pub share: f64,
}

impl CauseGroup {
    /// The cause as each of the lines that cannot be ruled out, the likeliest first; what is no line as it is.
    pub(super) fn by_line(&self) -> Vec<Self> {
        let Self { best, probability, gain_nats, size_ratio, .. } = *self;
        let whole = LineShare { candidate: best, share: 1.0 };
        let lines = &self.lines[..credible_shares(self.lines.iter().map(|line| line.share))];
        let lines = if lines.is_empty() { std::slice::from_ref(&whole) } else { lines };
        let of_line = |line: &LineShare| Self {
            best: line.candidate,
            probability: probability * line.share,
            gain_nats,
            size_ratio,
            lines: Vec::new(),
        };
        lines.iter().map(of_line).collect()
    }
}

/// A slot of the model whose cause is not beyond doubt.
pub(crate) struct OpenSlot {
    /// Index of the cause that was chosen; `None`: none was.
    pub slot: Option<usize>,
    /// Causes that cannot be ruled out there, the likeliest first; where one alone is left, it and the next.
    pub alternatives: Vec<AlternativeCause>,
    /// Whether a balancing spring or cylinder may stand there too, of which poses tell nothing.
    pub or_balancing: bool,
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
            .flat_map(CauseGroup::by_line)
            .map(|g| AlternativeCause {
                candidate: g.best,
                probability: g.probability.clamp(1e-9, 1.0),
                size_ratio: g.size_ratio,
            })
            .collect();
        Self { slot, alternatives, or_balancing: false }
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
    let mut found: Vec<(CauseKey, CauseGroup)> = Vec::new();
    for RankedHypothesis { hypothesis, probability, peak } in &ranking.ranked {
        let Hypothesis::Effect(c) = hypothesis else { continue };
        let this = workspace.library.candidates[*c].cause_key();
        let at = found.iter().position(|(k, _)| *k == this).unwrap_or_else(|| {
            let cause_group = CauseGroup {
                best: *c,
                probability: 0.0,
                gain_nats: peak.log_evidence - ranking.null.log_evidence,
                size_ratio: peak.size_ratio,
                lines: Vec::new(),
            };
            found.push((this, cause_group));
            found.len() - 1
        });
        let cause_group = &mut found[at].1;
        cause_group.probability += probability;
        add_line(workspace, &mut cause_group.lines, *c, *probability);
    }
    let mut cause_groups: Vec<CauseGroup> = found.into_iter().map(|(_, g)| g).collect();
    for CauseGroup { probability, lines, .. } in &mut cause_groups {
        lines.iter_mut().for_each(|line| line.share /= probability.max(f64::MIN_POSITIVE));
        sorting::by(lines, |a, b| b.share.total_cmp(&a.share));
    }
    sorting::by(&mut cause_groups, |a, b| b.probability.total_cmp(&a.probability));
    cause_groups
}

/// The same, in those that the data speak for and all others: what they say nothing of, as of a scale where the geometry is free, keeps
/// its prior, and may be likelier than all that small evidence is shared among.
#[must_use]
pub(super) fn spoken_for(
    workspace: &Workspace<'_>,
    ranking: &HypothesisRanking,
) -> (Vec<CauseGroup>, Vec<CauseGroup>) {
    let (candidates, log_prior) = (&workspace.library.candidates, &workspace.library.log_prior);
    let null = ranking.ranked.iter().find(|ranked| ranked.hypothesis == Hypothesis::Null);
    let null = null.map_or(0.0, |null| null.probability / NULL_PRIOR);
    let is_spoken_for = |group: &CauseGroup| {
        let key = candidates[group.best].cause_key();
        let own = candidates.iter().zip(log_prior).filter(|(candidate, _)| candidate.cause_key() == key);
        group.probability > null * own.map(|(_, log_prior)| log_prior.exp()).sum::<f64>()
    };
    cause_groups(workspace, ranking).into_iter().partition(is_spoken_for)
}

/// Counts the probability of `candidate` to the line that it is, where it is one: over a short range near periods are one bend.
fn add_line(workspace: &Workspace<'_>, lines: &mut Vec<LineShare>, candidate: usize, probability: f64) {
    let candidates = &workspace.library.candidates;
    let variant = &candidates[candidate].variant;
    let (EffectKind::GearMesh, Some(n), Some(joint)) = (candidates[candidate].kind, variant.n, variant.joint)
    else {
        return;
    };
    let is_same = |line: &&mut LineShare| {
        let other = candidates[line.candidate].variant.n;
        other.is_some_and(|other| is_one_bend(workspace.library.dataset, joint, n, other))
    };
    match lines.iter_mut().find(is_same) {
        Some(line) => line.share += probability,
        None => lines.push(LineShare { candidate, share: probability }),
    }
}

/// A gear line where there are dozens, in place `i` of `chosen`: each stood far out when it was added, and none has an alternative but
/// its like at the same angles.
#[must_use]
pub(super) fn line_among_many(
    fitted: &FittedModel<'_>,
    chosen: &[ChosenCause],
    i: usize,
    spectra: &mut AngleSpectra,
) -> CauseGroup {
    let FittedModel { model, workspace, .. } = fitted;
    let Workspace { design, library, .. } = workspace;
    let one = &chosen[i];
    let odds = one.gain_nats + library.log_prior[one.candidate] - NULL_PRIOR.ln();
    let mut line = CauseGroup {
        best: one.candidate,
        probability: 1.0 / (1.0 + (-odds).exp()),
        gain_nats: one.gain_nats,
        size_ratio: one.size_ratio,
        lines: Vec::new(),
    };
    let aliases = library.aliases(one.candidate, spectra);
    if aliases.is_empty() {
        return line;
    }
    let groups = design.all_groups();
    let nuisance = NuisanceModel::new(design, &groups, &cause_columns(chosen, Some(i)), model.noise);
    let weights: Vec<(usize, f64)> = std::iter::once(one.candidate)
        .chain(aliases)
        .map(|c| (c, library.gain(&nuisance, &groups, c) + library.log_prior[c]))
        .collect();
    let total = log_sum(weights.iter().map(|weight| weight.1));
    line.lines.extend(
        weights.into_iter().map(|(candidate, weight)| LineShare { candidate, share: (weight - total).exp() }),
    );
    sorting::by(&mut line.lines, |a, b| b.share.total_cmp(&a.share));
    line
}

/// Joins to the likeliest cause the alternative that holds it as a special case: what the alternative adds is not needed, and
/// the simpler of two nested explanations is the one to name.
pub(super) fn join_nested(workspace: &Workspace<'_>, cause_groups: &mut Vec<CauseGroup>) {
    let Some(first) = cause_groups.first() else { return };
    let of_first = &workspace.library.candidates[first.best];
    let simple = of_first.cause_key();
    let length_alone = simple.kind == EffectKind::LinkGeometry && of_first.variant.refined;
    let nests = |g: &CauseGroup| {
        let rich = &workspace.library.candidates[g.best];
        // What changes without a constant of its own is no offset at any size.
        let holds_offset = rich.variant.refined && has_own_offset(rich.kind);
        let holds_length = rich.variant.refined && rich.kind == EffectKind::ThermalLinkGrowth;
        simple.joint == rich.variant.joint
            && (simple.kind == EffectKind::JointOffset && holds_offset || length_alone && holds_length)
    };
    let more: f64 = cause_groups.iter().filter(|g| nests(g)).map(|g| g.probability).sum();
    cause_groups.retain(|g| !nests(g));
    cause_groups[0].probability += more;
}

/// Whether a refined variant of this effect has a constant turn of its joint.
fn has_own_offset(kind: EffectKind) -> bool {
    matches!(kind, EffectKind::ThermalJointDrift | EffectKind::JointStep | EffectKind::JointGain)
}

/// Takes from the first cause's odds what rests on the exact shape of bending or tilt alone, where it and an alternative are both of what
/// gives under load.
pub(super) fn doubt_shapes(workspace: &Workspace<'_>, cause_groups: &mut [CauseGroup]) {
    let kinds: Vec<EffectKind> =
        cause_groups.iter().map(|g| workspace.library.candidates[g.best].kind).collect();
    let Some(first) = cause_groups.first() else { return };
    let mut probabilities: Vec<f64> = cause_groups.iter().map(|g| g.probability).collect();
    let shared: Vec<bool> = kinds.iter().map(|&kind| shapes_in_doubt(kinds[0], kind)).collect();
    raise_alternatives(&mut probabilities, &shared, SHAPE_KNOWN_TO, first.gain_nats);
    for (group, probability) in cause_groups.iter_mut().zip(probabilities) {
        group.probability = probability;
    }
    sorting::by(cause_groups, |a, b| b.probability.total_cmp(&a.probability));
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
fn raise_alternatives(probabilities: &mut [f64], shared: &[bool], s: f64, gain_nats: f64) {
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

/// The likeliest groups that together make up nearly all of the causes' probability; the likeliest alone where structure is likelier than all of
/// them by more than a double holds.
#[must_use]
pub(super) fn credible(cause_groups: &[CauseGroup]) -> Vec<&CauseGroup> {
    let count = credible_shares(cause_groups.iter().map(|g| g.probability));
    cause_groups.iter().take(count.max(1)).collect()
}

/// How many of these probabilities, the largest first, together make up nearly all.
fn credible_shares(probabilities: impl Iterator<Item = f64> + Clone) -> usize {
    let total: f64 = probabilities.clone().sum();
    let first = probabilities.clone().next().unwrap_or(0.0);
    let mut sum = 0.0;
    probabilities
        .take_while(|&p| {
            let more = sum < CREDIBLE * total && p >= RIVAL * first;
            sum += p;
            more
        })
        .count()
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

#[cfg(test)]
mod tests {
    use super::raise_alternatives;

    /// A gain of 100 ln 2 nats and a shape known to a tenth double an alternative's odds: .6 : .2 : .2 becomes .6 : .4 : .2.
    #[test]
    fn a_rough_shape_gives_its_alternatives_back_their_odds() {
        let mut probabilities = [0.6, 0.2, 0.2];
        raise_alternatives(&mut probabilities, &[true, true, false], 0.1, 100.0 * 2.0_f64.ln());
        for (p, by_hand) in probabilities.iter().zip([0.5, 1.0 / 3.0, 1.0 / 6.0]) {
            assert!((p - by_hand).abs() < 1e-12, "{probabilities:?}");
        }
    }

    /// However much was gained, nothing that is shared becomes likelier than the first; what explains nothing keeps its odds.
    #[test]
    fn a_rival_comes_level_at_most() {
        let mut level = [0.9, 0.1];
        raise_alternatives(&mut level, &[true, true], 0.1, 1e6);
        assert!((level[0] - 0.5).abs() < 1e-12 && (level[1] - 0.5).abs() < 1e-12, "{level:?}");
        let mut kept = [0.9, 0.1];
        raise_alternatives(&mut kept, &[true, true], 0.1, -5.0);
        assert_eq!(kept, [0.9, 0.1]);
    }
}
