//! Causes as they are listed: each once, the likeliest first, their slots numbered without gaps; knows nothing of evidence.

use inference::cause::Cause;
use robot_model::deform::EffectKind;

/// What is less likely than this is not listed.
pub(super) const WORTH_SAYING: f64 = 0.005;

/// The causes of all slots in the order of a list: by probability, and among those that are as likely to the thousandth by size. A scale of
/// the instrument brings its twin, a scale of all links.
#[must_use]
pub(super) fn listed(mut causes: Vec<Cause>) -> Vec<Cause> {
    for a in (1..causes.len()).rev() {
        if causes[..a].iter().any(|b: &Cause| same(b, &causes[a])) {
            causes.remove(a);
        }
    }
    causes.retain(|c| c.posterior > WORTH_SAYING);
    share_scale_with_links(&mut causes);
    let thousandths = |p: f64| (1000.0 * p).round();
    sorting::by(&mut causes, |a, b| {
        let size = |c: &Cause| c.rms_mm.unwrap_or(0.0);
        thousandths(b.posterior).total_cmp(&thousandths(a.posterior)).then(size(b).total_cmp(&size(a)))
    });
    renumber(&mut causes);
    causes
}

/// A scale of the instrument and a scale of all links are one and the same to these data: where the first is named alone, the links
/// stand beside it with half of its probability.
fn share_scale_with_links(causes: &mut Vec<Cause>) {
    let Some(at) = causes.iter().position(|c| c.effect == EffectKind::InstrumentScale) else { return };
    // One link by itself is another cause.
    if !causes.iter().any(|c| c.effect == EffectKind::LinkGeometry && c.joint.is_none()) {
        causes[at].posterior *= 0.5;
        let (slot, posterior) = (causes[at].slot, causes[at].posterior);
        causes.insert(at + 1, Cause { slot, ..Cause::of(EffectKind::LinkGeometry, posterior) });
    }
}

/// Takes from the probabilities of each slot what they come to above 1: the difference of two large logarithms is known to some 1e-12.
pub(super) fn at_most_one(causes: &mut [Cause]) {
    let slots = causes.iter().map(|c| c.slot).max().unwrap_or(0);
    for slot in 0..=slots {
        let mut of_slot: Vec<&mut Cause> = causes.iter_mut().filter(|c| c.slot == slot).collect();
        let sum: f64 = of_slot.iter().map(|c| c.posterior).sum();
        let rounding = f64::EPSILON * of_slot.len() as f64;
        if sum + rounding > 1.0 {
            let most = if of_slot.len() == 1 { 1.0 } else { 1.0 - 2.0 * rounding };
            of_slot.iter_mut().for_each(|c| c.posterior = (c.posterior * most / sum).min(1.0));
        }
    }
}

/// Gives a cause that stands behind one of the same thousandth, which is larger at the tool, no more than that one has: a list that is ranked
/// by probability is so to its last digit.
pub(super) fn never_rising(causes: &mut [Cause]) {
    for at in 1..causes.len() {
        causes[at].posterior = causes[at].posterior.min(causes[at - 1].posterior);
    }
}

/// Slots in the order of their likeliest causes, without gaps.
fn renumber(causes: &mut [Cause]) {
    let mut order: Vec<usize> = Vec::new();
    for cause in causes.iter() {
        if !order.contains(&cause.slot) {
            order.push(cause.slot);
        }
    }
    for cause in causes {
        cause.slot = 1 + order.iter().position(|slot| *slot == cause.slot).unwrap_or(0);
    }
}

fn same(a: &Cause, b: &Cause) -> bool {
    a.effect == b.effect
        && a.joint == b.joint
        && a.joint_b == b.joint_b
        && a.n == b.n
        && a.from_line == b.from_line
}

/// Each alternative once, and none that is a cause itself in another place.
#[must_use]
pub(super) fn rejected(alternatives: Vec<Cause>, causes: &[Cause]) -> Vec<Cause> {
    let mut rejected: Vec<Cause> = Vec::new();
    for alternative in alternatives {
        if !causes.iter().chain(&rejected).any(|named| same(named, &alternative)) {
            rejected.push(alternative);
        }
    }
    rejected
}

#[cfg(test)]
mod tests {
    use super::*;
    use robot_model::robot::Axis;

    /// Slots with one, three and two causes, 1e-12 too likely each: no order of adding comes to more than 1; what was less stays.
    #[test]
    fn no_slot_is_likelier_than_one() {
        let cause = |slot, posterior| Cause { slot, ..Cause::of(EffectKind::JointOffset, posterior) };
        let too_much = 1.0 + 2e-12;
        let mut causes: Vec<Cause> = vec![
            cause(1, too_much),
            cause(2, 0.7 * too_much),
            cause(2, 0.2 * too_much),
            cause(2, 0.1 * too_much),
            cause(3, 0.5),
            cause(3, 0.25),
        ];
        at_most_one(&mut causes);
        let p: Vec<f64> = causes.iter().map(|c| c.posterior).collect();
        assert!(p[0] <= 1.0 && p[0] > 1.0 - 1e-15);
        for [a, b, c] in [[1, 2, 3], [1, 3, 2], [2, 3, 1], [3, 2, 1]] {
            assert!(p[a] + p[b] + p[c] <= 1.0, "{p:?}");
        }
        assert!((p[1] - 0.7).abs() < 1e-14);
        assert_eq!(p[4..], [0.5, 0.25]);
    }

    /// By hand: 0.999_8 and 0.999_6 are both 1.000, so the larger comes first; nothing behind is likelier than what stands before it.
    #[test]
    fn no_cause_is_likelier_than_the_one_before_it() {
        let cause = |effect, slot, rms_mm, posterior| Cause {
            slot,
            rms_mm: Some(rms_mm),
            ..Cause::of(effect, posterior)
        };
        let mut listed = listed(vec![
            cause(EffectKind::JointOffset, 1, 0.1, 0.999_8),
            cause(EffectKind::BaseTilt, 2, 0.3, 0.999_6),
            cause(EffectKind::Backlash, 3, 0.9, 0.7),
            cause(EffectKind::PayloadMass, 4, 0.9, 0.001),
        ]);
        never_rising(&mut listed);
        let named: Vec<_> = listed.iter().map(|c| (c.effect, c.slot, c.posterior)).collect();
        let expected = [
            (EffectKind::BaseTilt, 1, 0.999_6),
            (EffectKind::JointOffset, 2, 0.999_6),
            (EffectKind::Backlash, 3, 0.7),
        ];
        assert_eq!(named, expected);
    }

    /// What the data cannot part shares its probability, and nothing is named at 0.
    #[test]
    fn a_scale_and_the_links_are_as_likely_as_each_other() {
        let mut causes = vec![
            Cause { slot: 2, ..Cause::of(EffectKind::InstrumentScale, 0.9) },
            Cause::of(EffectKind::BaseTilt, 0.8),
            Cause { slot: 2, joint: Axis::numbered(2), ..Cause::of(EffectKind::LinkGeometry, 0.1) },
        ];
        share_scale_with_links(&mut causes);
        let named: Vec<_> = causes.iter().map(|c| (c.effect, c.slot, c.posterior)).collect();
        let expected = [
            (EffectKind::InstrumentScale, 2, 0.45),
            (EffectKind::LinkGeometry, 2, 0.45),
            (EffectKind::BaseTilt, 1, 0.8),
            (EffectKind::LinkGeometry, 2, 0.1),
        ];
        assert_eq!(named, expected);
    }

    #[test]
    fn what_is_named_is_not_ruled_out_in_another_place() {
        use EffectKind::{JointCompliance, JointOffset, LinkGeometry};
        let of = |kind: EffectKind, joint| Cause { joint: Axis::numbered(joint), ..Cause::of(kind, 0.5) };
        let left = rejected(
            vec![of(JointOffset, 2), of(LinkGeometry, 4), of(JointOffset, 2), of(JointOffset, 3)],
            &[of(LinkGeometry, 4), of(JointCompliance, 2)],
        );
        let named: Vec<_> = left.iter().map(|c| (c.effect, c.joint)).collect();
        assert_eq!(named, [(JointOffset, Axis::numbered(2)), (JointOffset, Axis::numbered(3))]);
    }
}
