//! Which causes base and target, which are unknown, leave anything of.

use super::outcome::Untestable;
use inference::dataset::{Dataset, Twist};
use inference::design::{Design, Products, Whitening};
use inference::effects::{Candidate, UntestableEffect, testable_effects};
use inference::evidence::NuisanceModel;
use inference::linearise::Linearised;
use inference::marginal::NoisePrior;
use robot_model::deform::EffectKind;
use std::collections::BTreeMap;

/// Of which less than this share is left by the registration: no signal.
pub(super) const INVISIBLE: f64 = 1e-7;
/// Observations that are asked first what the registration leaves, and the share that they leave of what all of them surely show: the
/// signal in those few is hardly less than a thousandth of the whole, and [`INVISIBLE`] is a thousandth of this.
const ASKED_FIRST: usize = 200;
const PLAIN: f64 = 1e-4;
/// Distance at which an orientation counts while it is only asked what leaves a signal at all, metres.
const USUAL_LENGTH_M: f64 = 0.2;

/// Candidates that leave a signal beside the registration, and the effects that these data cannot show.
pub(super) struct VisibleCandidates {
    /// The candidates that leave one.
    pub candidates: Vec<Candidate>,
    /// Effects that leave none, with the reason.
    pub untestable: Vec<Untestable>,
}

/// Base and target beside the observations of a data set, all alike: what they leave of a candidate's signal.
struct RegistrationVisibility<'a> {
    dataset: &'a Dataset,
    design: Design,
    nuisance: NuisanceModel,
}

impl<'a> RegistrationVisibility<'a> {
    fn new(dataset: &'a Dataset, residuals: &[Twist], targets: usize, noise: NoisePrior) -> Self {
        let n = dataset.observations.len();
        let whitening = Whitening::independent(vec![1.0; n], USUAL_LENGTH_M);
        let design = Design::of_all(dataset, residuals, targets, whitening);
        let nuisance = NuisanceModel::new(&design, &[0], &[], noise);
        Self { dataset, design, nuisance }
    }

    /// Shares of the candidates that are one motion scaled, but for lines of gears: thousands of steps, whose products come together and
    /// by factors rounded to a part in 10^7, which is nothing beside [`PLAIN`]. `None` of all others.
    fn scaled_shares(&self, candidates: &[Candidate]) -> Vec<Option<f64>> {
        let Self { dataset, design, nuisance } = self;
        let mut shares = vec![None; candidates.len()];
        let mut products = vec![Products::none(); candidates.len()];
        for motions in design.scaled_motions_of(dataset, candidates, &|c| !is_line(&candidates[c])) {
            design.begin_scaled(&motions, &mut products);
            design.extend_scaled(&motions, &mut products);
            for &member in &motions.members {
                shares[member] = Some(nuisance.visible(&products[member].sum(&[0])));
            }
        }
        shares
    }

    /// Share of a candidate's signal that is left.
    fn share(&self, candidate: &Candidate) -> f64 {
        let columns = self.design.columns_of(self.dataset, candidate);
        self.nuisance.visible(&self.design.products(&columns).sum(&[0]))
    }
}

/// Takes out the candidates whose signal the registration, with so many `targets`, takes whole.
pub(super) fn visible(linear: &Linearised, targets: usize, noise: NoisePrior) -> VisibleCandidates {
    let Linearised { dataset, residuals, .. } = linear;
    let whole = RegistrationVisibility::new(dataset, residuals, targets, noise);
    // There are many candidates, and may be many rows: what some of them show all of them do.
    let step = dataset.observations.len().div_ceil(ASKED_FIRST).max(1);
    let some = (step > 1).then(|| dataset.every(step));
    let some_residuals: Vec<Twist> = residuals.iter().step_by(step).copied().collect();
    let some = some.as_ref().map(|some| RegistrationVisibility::new(some, &some_residuals, targets, noise));
    let testable = testable_effects(dataset);
    let scaled = some.as_ref().unwrap_or(&whole).scaled_shares(&testable.candidates);
    let mut candidates = Vec::new();
    let mut untestable: Vec<Untestable> = Vec::new();
    for (candidate, scaled) in testable.candidates.into_iter().zip(scaled) {
        let first = scaled.or_else(|| some.as_ref().map(|some| some.share(&candidate)));
        let is_plain = is_line(&candidate) || first.is_some_and(|share| share > PLAIN);
        let share = if is_plain { 1.0 } else { whole.share(&candidate) };
        if share > INVISIBLE {
            candidates.push(candidate);
            continue;
        }
        let effect = candidate.kind;
        let joint = candidate.variant.joint;
        let reason = "its signal lies wholly inside base and target, which are unknown".to_owned();
        match untestable.iter_mut().find(|h| h.effect == effect) {
            Some(h) => h.joints.extend(joint.filter(|j| !h.joints.contains(j))),
            None => {
                let joints = joint.into_iter().collect();
                untestable.push(Untestable { effect, joints, reason, lacks_channel: false });
            }
        }
    }
    share_weights(&mut candidates);
    // What one variant hides another may show.
    let is_shown = |effect, joint| candidates.iter().any(|c| c.kind == effect && c.variant.joint == joint);
    untestable.retain_mut(|hidden| {
        let effect = hidden.effect;
        let of_joints = !hidden.joints.is_empty();
        hidden.joints.retain(|joint| !is_shown(effect, Some(*joint)));
        if of_joints { !hidden.joints.is_empty() } else { !is_shown(effect, None) }
    });
    let of_kind = |UntestableEffect { kind, reason }| Untestable {
        effect: kind,
        joints: Vec::new(),
        reason,
        lacks_channel: true,
    };
    untestable.extend(testable.untestable.into_iter().map(of_kind));
    VisibleCandidates { candidates, untestable }
}

/// Lines of a gear never lie in the registration; there are thousands.
fn is_line(candidate: &Candidate) -> bool {
    candidate.kind == EffectKind::GearMesh
}

/// Makes the weights of each effect's candidates come to 1 again: what is asked is which cause opens a gap, and those that open none have
/// no share in it.
fn share_weights(candidates: &mut [Candidate]) {
    let mut totals: BTreeMap<EffectKind, f64> = BTreeMap::new();
    for candidate in &*candidates {
        *totals.entry(candidate.kind).or_default() += candidate.weight;
    }
    candidates.iter_mut().for_each(|candidate| candidate.weight /= totals[&candidate.kind]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::evenly_spread;

    /// What a part of the rows shows is no less than a part of what all of them show, so whatever is plain there is seen by all.
    #[test]
    fn what_some_rows_show_plainly_all_of_them_do() {
        let dataset = evenly_spread(900);
        let some = dataset.every(5);
        assert_eq!(some.observations.len(), 180);
        let noise = NoisePrior { known: None, from_repeats: false, stated_more_m: None };
        let sight = |dataset| RegistrationVisibility::new(dataset, &vec![Twist([1e-4; 6]); 900], 1, noise);
        let (whole, some) =
            (sight(&dataset), RegistrationVisibility::new(&some, &[Twist([1e-4; 6]); 180], 1, noise));
        let (mut plain, mut hidden) = (0, 0);
        for candidate in testable_effects(&dataset).candidates {
            if candidate.kind == EffectKind::GearMesh {
                continue;
            }
            let is_plain = some.share(&candidate) > PLAIN;
            plain += usize::from(is_plain);
            let share = whole.share(&candidate);
            hidden += usize::from(share <= INVISIBLE);
            assert!(!is_plain || share > INVISIBLE, "{:?} {:?}: {share}", candidate.kind, candidate.variant);
        }
        // An offset of joint 1 and of joint 6 and what else base and target take; most causes are plain.
        assert!(hidden >= 2 && plain > 100, "{hidden} {plain}");
    }

    /// Offsets of joints 1 and 6 open no gap beside base and target: the four others share the effect's prior, and each effect's comes to one.
    #[test]
    fn what_opens_no_gap_has_no_share() {
        let mut candidates = testable_effects(&evenly_spread(60)).candidates;
        let is_offset = |c: &Candidate| c.kind == EffectKind::JointOffset && c.variant.joint.is_some();
        let before: Vec<f64> = candidates.iter().filter(|c| is_offset(c)).map(|c| c.weight).collect();
        let hidden =
            |c: &Candidate| is_offset(c) && c.variant.joint.is_some_and(|j| [0, 5].contains(&j.index()));
        candidates.retain(|c| !hidden(c));
        share_weights(&mut candidates);
        let of = |kind| candidates.iter().filter(move |c| c.kind == kind).map(|c| c.weight);
        for kind in candidates.iter().map(|c| c.kind) {
            assert!((of(kind).sum::<f64>() - 1.0).abs() < 1e-9, "{kind:?}");
        }
        // Six single joints and all at a tenth of one's weight: each has 4.1 parts where it had 6.1.
        assert_eq!(before.len(), 6);
        let first = candidates.iter().find(|c| is_offset(c)).unwrap().weight;
        assert!((first / before[0] - 6.1 / 4.1).abs() < 1e-9, "{first} {before:?}");
    }
}
