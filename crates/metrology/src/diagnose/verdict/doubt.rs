//! What has the same shape as the likeliest cause of a place by the nature of arms and files, whatever was measured.

use crate::diagnose::balancing::has_its_shape;
use crate::diagnose::model::FittedModel;
use inference::cause::Cause;
use inference::effects::one_beam_with;
use robot_model::deform::EffectKind;
use robot_model::deform::identified::Growth;
use robot_model::robot::Axis;

/// A cause that is alone in its place and less likely than this is not told apart from what is not in the library.
pub(in crate::diagnose) const LIKELIER_THAN_NOT: f64 = 0.5;
/// Of a cause and what has its shape: one is as likely as the other.
pub(super) const EVEN: f64 = 0.5;

/// What may as well stand in the place of a cause.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Doubt {
    /// Play of the joint: the cause is a spring that hardens or softens in a file without directions of approach, and play whose side
    /// gravity decides at most poses has the same shape.
    play_too: bool,
    /// Whatever else changed over the same hours: the cause follows temperatures in rows without times.
    by_temperature: bool,
    /// A rail that sags where the arm stands on it: the cause is a stand that tilts, of an arm whose first joint slides.
    rail_too: bool,
    /// A balancing spring or cylinder: the cause goes with the angle of joint 2 of an arm that may have one.
    balancing_too: bool,
}

impl Doubt {
    /// What may as well be there as `candidate`.
    pub(super) fn of(fitted: &FittedModel<'_>, candidate: usize) -> Self {
        let dataset = &fitted.linear.dataset;
        let candidate = &fitted.workspace.library.candidates[candidate];
        let variant = &candidate.variant;
        let bent_spring = candidate.kind == EffectKind::JointCompliance && variant.refined;
        Self {
            play_too: bent_spring && !dataset.channels.direction,
            by_temperature: dataset.time_min.is_none()
                && matches!(variant.growth, Growth::Temperature { .. }),
            rail_too: candidate.kind == EffectKind::BaseTilt && !dataset.turning().any(|joint| joint == 0),
            balancing_too: dataset.may_be_balanced && has_its_shape(candidate.kind, variant.joint),
        }
    }

    /// Whether nothing else has the cause's shape by itself.
    pub(super) fn is_none(self) -> bool {
        self == Self::default()
    }

    /// Whether a balancing spring or cylinder may be there instead.
    pub(super) fn is_of_balancing(self) -> bool {
        self.balancing_too
    }

    /// Gives what has the same shape as the first cause of `slot` half of its probability, and stands it beside the cause where it has a
    /// name; returns whether the cause is no longer likelier than not.
    pub(super) fn share(self, causes: &mut Vec<Cause>, slot: usize) -> bool {
        let Some(at) = causes.iter().position(|c| c.slot == slot) else { return false };
        if self.by_temperature || self.rail_too {
            causes[at].posterior *= EVEN;
        }
        if self.balancing_too {
            // Which of the shapes that it may be taken for is likelier says nothing of it.
            let of_slot = causes.iter_mut().filter(|c| c.slot == slot && has_its_shape(c.effect, c.joint));
            of_slot.for_each(|cause| cause.posterior *= EVEN);
        }
        if self.play_too {
            causes[at].posterior *= EVEN;
        }
        let Cause { joint, posterior, .. } = causes[at];
        if self.play_too {
            // Of the two the file prefers neither; the spring stands first.
            causes.push(Cause { joint, slot, ..Cause::of(EffectKind::Backlash, posterior) });
        }
        !self.is_none() && causes[at].posterior < LIKELIER_THAN_NOT
    }
}

/// The link before the one that `candidate` bends, and that link, where they are one beam.
pub(super) fn beam(fitted: &FittedModel<'_>, candidate: usize) -> Option<[Axis; 2]> {
    let candidate = &fitted.workspace.library.candidates[candidate];
    let link = candidate.variant.joint.filter(|_| candidate.kind == EffectKind::LinkBending)?;
    Some([one_beam_with(&fitted.linear.dataset, link)?, link])
}

/// Gives two links of `slot` that are one beam the same probability, the one that is not named yet too.
pub(super) fn share_beam(causes: &mut Vec<Cause>, slot: usize, [before, link]: [Axis; 2]) {
    let of = |causes: &[Cause], link: Axis| {
        let is_this =
            |c: &Cause| c.slot == slot && c.effect == EffectKind::LinkBending && c.joint == Some(link);
        causes.iter().position(is_this)
    };
    let Some(named) = of(causes, link) else { return };
    let twin = of(causes, before).unwrap_or_else(|| {
        causes.push(Cause { joint: Some(before), slot, ..Cause::of(EffectKind::LinkBending, 0.0) });
        causes.len() - 1
    });
    let shared = EVEN * (causes[named].posterior + causes[twin].posterior);
    causes[named].posterior = shared;
    causes[twin].posterior = shared;
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bending(link: usize, slot: usize, posterior: f64) -> Cause {
        Cause { joint: Axis::numbered(link), slot, ..Cause::of(EffectKind::LinkBending, posterior) }
    }

    /// By hand: .9 alone is .45 twice, .6 beside .2 is .4 twice; another slot keeps its own.
    #[test]
    fn links_that_are_one_beam_are_as_likely_as_each_other() {
        let beam = [Axis::at(2), Axis::at(3)];
        let mut alone = vec![bending(4, 1, 0.9), bending(3, 2, 0.7)];
        share_beam(&mut alone, 1, beam);
        let named = |causes: &[Cause]| -> Vec<_> {
            causes.iter().map(|c| (c.joint.unwrap(), c.slot, (1e6 * c.posterior).round() / 1e6)).collect()
        };
        assert_eq!(named(&alone), [(Axis::at(3), 1, 0.45), (Axis::at(2), 2, 0.7), (Axis::at(2), 1, 0.45)]);
        let mut both = vec![bending(4, 1, 0.6), bending(3, 1, 0.2)];
        share_beam(&mut both, 1, beam);
        assert_eq!(named(&both), [(Axis::at(3), 1, 0.4), (Axis::at(2), 1, 0.4)]);
    }

    /// By hand: .6 and .3 of one place are half; what joint 2 does in another place, and another joint in this one, keeps its own.
    #[test]
    fn balancing_has_half_of_every_shape_that_it_may_be_taken_for() {
        let cause = |effect, joint, slot, posterior| Cause {
            joint: Axis::numbered(joint),
            slot,
            ..Cause::of(effect, posterior)
        };
        let mut causes = vec![
            cause(EffectKind::JointGain, 2, 1, 0.6),
            cause(EffectKind::GearEccentricity, 2, 1, 0.3),
            cause(EffectKind::GearEccentricity, 3, 1, 0.1),
            cause(EffectKind::GearEccentricity, 2, 2, 0.9),
        ];
        assert!(Doubt { balancing_too: true, ..Doubt::default() }.share(&mut causes, 1));
        let shared: Vec<f64> = causes.iter().map(|c| (1e6 * c.posterior).round() / 1e6).collect();
        assert_eq!(shared, [0.3, 0.15, 0.1, 0.9]);
    }

    #[test]
    fn a_stand_that_tilts_may_as_well_be_its_rail() {
        let mut causes = vec![Cause { slot: 1, ..Cause::of(EffectKind::BaseTilt, 0.9) }];
        assert!(Doubt { rail_too: true, ..Doubt::default() }.share(&mut causes, 1));
        assert_eq!(causes.iter().map(|c| c.posterior).collect::<Vec<_>>(), [0.45]);
    }

    #[test]
    fn without_doubt_a_cause_keeps_its_probability() {
        let mut causes = vec![bending(2, 1, 0.3)];
        assert!(!Doubt::default().share(&mut causes, 1));
        assert_eq!(causes.iter().map(|c| c.posterior).collect::<Vec<_>>(), [0.3]);
    }
}
