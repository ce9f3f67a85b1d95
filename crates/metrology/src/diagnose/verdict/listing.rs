//! Causes as they are listed: each once, the likeliest first, their slots numbered without gaps; knows nothing of evidence.

use crate::diagnose::outcome::Cause;
use robot_model::deform::EffectKind;

/// What is less likely than this is not listed.
pub const WORTH_SAYING: f64 = 0.005;

/// The causes of all slots in the order of a list. A scale of the instrument brings its twin, a scale of all links.
#[must_use]
pub fn listed(mut causes: Vec<Cause>) -> Vec<Cause> {
    for a in (1..causes.len()).rev() {
        if causes[..a].iter().any(|b: &Cause| same(b, &causes[a])) {
            causes.remove(a);
        }
    }
    let scale = causes.iter().find(|c| c.effect == EffectKind::InstrumentScale).map(|c| c.slot);
    if let Some(slot) = scale
        && !causes.iter().any(|c| c.effect == EffectKind::LinkGeometry)
    {
        // A scale of the instrument and a scale of all links are one and the same to these data.
        causes.push(Cause { slot, ..Cause::of(EffectKind::LinkGeometry, 0.0) });
    }
    let thousandths = |p: f64| (1000.0 * p).round();
    causes.sort_by(|a, b| {
        let size = |c: &Cause| c.rms_mm.unwrap_or(0.0);
        thousandths(b.posterior).total_cmp(&thousandths(a.posterior)).then(size(b).total_cmp(&size(a)))
    });
    let has_scale = scale.is_some();
    causes.retain(|c| c.posterior > WORTH_SAYING || has_scale && c.effect == EffectKind::LinkGeometry);
    renumber(&mut causes);
    causes
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

/// Each rival once, and none that is a cause itself in another place.
#[must_use]
pub fn rejected(alternatives: Vec<Cause>, causes: &[Cause]) -> Vec<Cause> {
    let mut rejected: Vec<Cause> = Vec::new();
    for rival in alternatives {
        if !causes.iter().chain(&rejected).any(|named| same(named, &rival)) {
            rejected.push(rival);
        }
    }
    rejected
}

#[cfg(test)]
mod tests {
    use super::*;
    use robot_model::robot::Axis;

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
