//! How an answer compares with the truth of its set: yes or no, set by set; counts nothing.

use super::answer::{Answer, Cause};
use super::effect::Effect;
use super::mixture::{WEAK_RHO, WEAK_ROWS};
use super::truth::{QuestionKind, Truth};

/// An effect is weak by design where its size is within this share of the weak class's.
const WEAK_WITHIN: f64 = 0.05;

/// An answer names causes and stands by them.
pub(super) fn names_a_cause(answer: &Answer) -> bool {
    matches!(answer.verdict.as_str(), "explained" | "several")
}

/// An answer finds a cause, told apart from its rivals or not.
pub(super) fn finds_a_cause(answer: &Answer) -> bool {
    names_a_cause(answer) || answer.verdict == "ambiguous"
}

/// Whether a cause is the `k`-th effect of the truth.
pub(super) fn names_effect(truth: &Truth, k: usize, cause: &Cause) -> bool {
    truth.effects.get(k).is_some_and(|t| t.effect.name() == Some(cause.effect.as_str()))
}

/// Whether a cause is one of the small effects that stand beside those asked about, in the same joint: it is there, and nobody
/// asked for it.
pub(super) fn is_small(truth: &Truth, cause: &Cause) -> bool {
    truth.small.iter().any(|small| {
        let joint = small.effect.joint();
        small.effect.name() == Some(cause.effect.as_str()) && (joint.is_none() || joint == cause.joint)
    })
}

/// The causes that are marked, the most probable first: all but small effects.
pub(super) fn marked<'a>(truth: &'a Truth, answer: &'a Answer) -> impl Iterator<Item = &'a Cause> {
    answer.causes.iter().filter(|cause| !is_small(truth, cause))
}

/// The first cause is the first effect.
pub(super) fn first_right(truth: &Truth, answer: &Answer) -> bool {
    marked(truth, answer).next().is_some_and(|c| names_effect(truth, 0, c))
}

/// A cause is found where none was asked about; not a small one, nor a set of causes that holds one.
pub(super) fn false_alarm(truth: &Truth, answer: &Answer) -> bool {
    match answer.verdict.as_str() {
        "ambiguous" => !answer.causes.iter().any(|cause| is_small(truth, cause)),
        _ => names_a_cause(answer) && (answer.causes.is_empty() || marked(truth, answer).next().is_some()),
    }
}

/// A cause is one of the effects.
pub(super) fn any_right(truth: &Truth, cause: &Cause) -> bool {
    (0..truth.effects.len()).any(|k| names_effect(truth, k, cause))
}

/// A cause is a harmonic of a gear's line that was put in, at two or three times its frequency: part of that effect, and none of
/// its own.
pub(super) fn is_harmonic(truth: &Truth, cause: &Cause) -> bool {
    truth.effects.iter().any(|put| match put.effect {
        Effect::GearMesh { joint, n, .. } => {
            put.effect.name() == Some(cause.effect.as_str())
                && cause.joint == Some(joint)
                && cause.n.is_some_and(|named| named == 2 * n || named == 3 * n)
        }
        _ => false,
    })
}

/// A cause is named first, with nine parts in ten, and is none of the effects.
pub(super) fn confident_and_wrong(truth: &Truth, answer: &Answer) -> bool {
    names_a_cause(answer)
        && marked(truth, answer)
            .next()
            .is_some_and(|c| c.posterior.is_some_and(|p| p >= 0.9) && !any_right(truth, c))
}

/// The answer to a question of one effect is a set of causes: of one, where it is told apart from its rivals.
pub(super) fn gives_a_set(truth: &Truth, answer: &Answer) -> bool {
    truth.kind == QuestionKind::One && matches!(answer.verdict.as_str(), "explained" | "ambiguous")
}

/// Share of what an oracle that knows the effect takes off that the diagnosis takes off.
pub(super) fn shrink_share(truth: &Truth, answer: &Answer) -> Option<f64> {
    let shrink = answer.shrink?;
    let possible = truth.before_rms_mm - truth.oracle_rms_mm;
    let taken_off = shrink.before_rms_mm? - shrink.causes_only_rms_mm?;
    (possible > 0.1 * truth.before_rms_mm).then(|| taken_off / possible)
}

/// Size of the first effect over the noise.
pub(super) fn rho(truth: &Truth) -> f64 {
    truth.effects.first().map_or(0.0, |e| e.rho)
}

/// Whether a question is of the weak class: one effect at half the noise in thirty rows.
pub(super) fn is_weak(truth: &Truth) -> bool {
    truth.kind == QuestionKind::One
        && truth.n == WEAK_ROWS
        && (rho(truth) / WEAK_RHO - 1.0).abs() < WEAK_WITHIN
}

/// The answer is that no effect of the library explains the data.
pub(super) fn says_outside(answer: &Answer) -> bool {
    answer.verdict.starts_with("unexplained")
}
