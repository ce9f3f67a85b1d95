//! What moves the target about the last joint's axis: the joint's own zero, or the target on its flange. One target tells them apart by
//! nothing but the course over time, where that is the joint's temperature and no law of time.

use super::cause_group::CauseGroup;
use crate::diagnose::model::Workspace;
use inference::effects::Candidate;
use inference::search::{Hypothesis, HypothesisRanking};
use robot_model::deform::EffectKind;
use robot_model::deform::identified::Growth;
use robot_model::robot::Axis;

/// Gives a target that has slipped, or creeps, on the flange about the last joint's axis the odds of a jump, or a drift, of that joint's
/// zero: one and the same motion, of which a shift of any direction would be likelier to be another.
pub(super) fn share_slip(
    workspace: &Workspace<'_>,
    ranking: &HypothesisRanking,
    cause_groups: &mut Vec<CauseGroup>,
) {
    let candidates = &workspace.library.candidates;
    let Some(first) = cause_groups.first() else { return };
    let turn = &candidates[first.best];
    let last = workspace.library.dataset.joints().checked_sub(1).map(Axis::at);
    if turn.variant.joint != last {
        return;
    }
    let (of_target, open_to_both) = match turn.kind {
        EffectKind::JointStep => (EffectKind::ToolStep, first.probability),
        EffectKind::ThermalJointDrift if workspace.library.dataset.has_one_point() => {
            (EffectKind::ToolDrift, probability_over_time(candidates, ranking, turn).min(first.probability))
        }
        _ => return,
    };
    let known = cause_groups.iter().position(|g| candidates[g.best].kind == of_target);
    let same_growth = |c: &Candidate| c.kind == of_target && c.variant.growth == turn.variant.growth;
    let of_kind = |c: &Candidate| c.kind == of_target;
    let slip = match turn.kind {
        EffectKind::JointStep => candidates.iter().position(same_growth),
        _ => known
            .map(|at| cause_groups[at].best)
            .or_else(|| candidates.iter().position(same_growth))
            .or_else(|| candidates.iter().position(of_kind)),
    };
    let Some(slip) = slip else { return };
    let slipped = known.map_or(0.0, |at| cause_groups[at].probability);
    if slipped.max(open_to_both) <= 0.0 {
        return;
    }
    if let Some(at) = known {
        cause_groups.remove(at);
    }
    let first = &mut cause_groups[0];
    let CauseGroup { probability, gain_nats, size_ratio, .. } = *first;
    let [turns, slips] = shared(probability, slipped, open_to_both);
    first.probability = turns;
    let slipped = CauseGroup { best: slip, probability: slips, gain_nats, size_ratio, lines: Vec::new() };
    cause_groups.push(slipped);
    sorting::by(cause_groups, |a, b| b.probability.total_cmp(&a.probability));
}

/// The probabilities of a joint's turn and of the same motion of the target, which come to what `turned` and `slipped` are together; `open_to_both`:
/// of the turn in those courses that the target may take as well, no more than `turned`.
fn shared(turned: f64, slipped: f64, open_to_both: f64) -> [f64; 2] {
    let slips = slipped.max(open_to_both);
    let scale = (turned + slipped) / (turned + slips);
    [turned * scale, slips * scale]
}

/// The probability of those drifts of the joint that `turn` is a variant of which grow by laws of time alone, as a target does that creeps.
fn probability_over_time(candidates: &[Candidate], ranking: &HypothesisRanking, turn: &Candidate) -> f64 {
    let is_law = |c: usize| {
        let Candidate { variant, .. } = &candidates[c];
        candidates[c].cause_key() == turn.cause_key() && matches!(variant.growth, Growth::Law(_))
    };
    let by_laws =
        ranking.ranked.iter().filter(|r| matches!(r.hypothesis, Hypothesis::Effect(c) if is_law(c)));
    by_laws.map(|r| r.probability).sum()
}

#[cfg(test)]
mod tests {
    use super::shared;

    /// By hand: without temperatures each course is open to both, and each has half; of a drift a quarter of whose odds is for
    /// a law of time, one part in five; of one that follows its temperature alone, what the target has by itself.
    #[test]
    fn what_turns_about_the_last_axis_is_shared_as_far_as_time_goes() {
        for (turned, slipped, odds, expected) in
            [(0.9, 0.1, 0.9, [0.5, 0.5]), (0.8, 0.0, 0.2, [0.64, 0.16]), (0.6, 0.4, 0.0, [0.6, 0.4])]
        {
            let [turn, slip] = shared(turned, slipped, odds);
            assert!((turn - expected[0]).abs() < 1e-12 && (slip - expected[1]).abs() < 1e-12);
        }
    }
}
