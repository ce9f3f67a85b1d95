//! All hypotheses for one place of the model, by their evidence.

use super::NULL_PRIOR;
use super::library::{Follower, Library};
use crate::diagnose::evidence::{Background, Look, Projected, Reached};
use crate::diagnose::marginal::{log_sum, normal_below};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Candidates that are looked at after their upper bounds.
const LONG_LIST: usize = 320;
/// Candidates that are evaluated in full after a first look.
const SHORT_LIST: usize = 96;
/// A kernel this far behind is not looked at again.
const FAR_BEHIND_NATS: f64 = 7.0;

/// Probability that an effect has the sign that physics gives it: a controller may take off too much of it.
const RIGHT_SIGN: f64 = 0.9;

/// What stands in one place of the model, and how likely.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hypothesis {
    /// Nothing.
    Null,
    /// A candidate, by index.
    Effect(usize),
    /// A kernel, by index.
    Kernel(usize),
}

/// All hypotheses for one place, likeliest first, with ln posterior weights that sum to 1.
#[derive(Clone, Debug)]
pub struct Slot {
    /// Hypothesis, probability, what it reached.
    pub ranked: Vec<(Hypothesis, f64, Reached)>,
    /// Evidence with nothing here.
    pub null: Reached,
}

impl Library<'_> {
    /// Every hypothesis over `background` of all atoms, `subset`, but the candidates in `without`.
    #[must_use]
    pub fn scan(&self, background: &Background, subset: &[usize], without: &[usize]) -> Slot {
        let followers = self.follow(background, subset);
        let open: Vec<&Follower> = followers.iter().filter(|f| !without.contains(&f.candidate)).collect();
        self.rank(background, &open, true)
    }

    /// Every kernel over `background` of all atoms, weighed against nothing.
    #[must_use]
    pub fn scan_kernels(&self, background: &Background) -> Slot {
        self.rank(background, &[], true)
    }

    /// ln evidence of one candidate over nothing.
    #[must_use]
    pub fn gain(&self, background: &Background, subset: &[usize], candidate: usize) -> f64 {
        let projected = background.project(&self.products[candidate].sum(subset));
        self.evidence(background, &projected, candidate).log_evidence - background.null().log_evidence
    }

    /// Evidence of a candidate, the sign that physics gives it included.
    pub(super) fn evidence(
        &self,
        background: &Background,
        projected: &Projected,
        candidate: usize,
    ) -> Reached {
        let mut reached = background.evidence(projected);
        if self.candidates[candidate].positive {
            reached.log_evidence += sign_nats(background.sign(projected, &reached));
        }
        reached
    }

    /// Every hypothesis over `background`, its candidates already projected.
    pub(super) fn rank(&self, background: &Background, followers: &[&Follower], kernels: bool) -> Slot {
        let null = background.null();
        let looks = background.looks(&null);
        let best = |scores: Vec<f64>, among: Vec<usize>, most: usize| {
            let mut order: Vec<(usize, f64)> = among.into_iter().zip(scores).collect();
            order.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
            order.truncate(most);
            order.into_iter().map(|(i, _)| i).collect::<Vec<usize>>()
        };
        let all: Vec<usize> = (0..followers.len()).collect();
        let score = |among: &[usize], of: &(dyn Fn(&Projected) -> f64 + Sync)| -> Vec<f64> {
            among
                .par_iter()
                .map(|&i| of(&followers[i].projected) + self.log_prior[followers[i].candidate])
                .collect()
        };
        let bounds = score(&all, &|p| background.bound(p, &looks));
        let long = best(bounds, all, LONG_LIST);
        let firsts = score(&long, &|p| background.first_look(p, &looks).log_evidence);
        let seen: Vec<usize> = best(firsts, long, LONG_LIST);
        let most = if kernels { SHORT_LIST } else { SHORT_LIST / 3 };
        // Thousands of gear lines must not push out the one form of an effect that explains as much.
        let mut kinds = BTreeSet::new();
        let order: Vec<usize> = seen
            .into_iter()
            .enumerate()
            .filter(|(rank, i)| {
                let this = &self.candidates[followers[*i].candidate];
                kinds.insert((this.effect, this.form.joint, this.form.joint_b)) || *rank < most
            })
            .map(|(_, i)| i)
            .collect();
        let mut ranked: Vec<(Hypothesis, f64, Reached)> = order
            .par_iter()
            .map(|&i| {
                let Follower { candidate: c, projected, .. } = followers[i];
                let reached = self.evidence(background, projected, *c);
                (Hypothesis::Effect(*c), reached.log_evidence + self.log_prior[*c], reached)
            })
            .collect();
        if kernels {
            let scanned = self.scanned(background, &looks, &null);
            ranked.extend(scanned);
        }
        ranked.push((Hypothesis::Null, null.log_evidence + NULL_PRIOR.ln(), null));
        let total = log_sum(ranked.iter().map(|r| r.1));
        for entry in &mut ranked {
            entry.1 = (entry.1 - total).exp();
        }
        ranked.sort_by(|a, b| b.1.total_cmp(&a.1));
        Slot { ranked, null }
    }

    /// Every kernel by its evidence: in full what comes near the best of them or nothing, a first look for the others.
    fn scanned(
        &self,
        background: &Background,
        looks: &[Look],
        null: &Reached,
    ) -> Vec<(Hypothesis, f64, Reached)> {
        let seen: Vec<(Projected, Reached)> = self
            .kernels
            .par_iter()
            .map(|s| {
                let projected = background.project(&s.sums);
                let first = background.first_look(&projected, looks);
                (projected, first)
            })
            .collect();
        let best = seen
            .iter()
            .zip(&self.kernels)
            .map(|((_, first), s)| first.log_evidence + s.log_prior)
            .fold(null.log_evidence + NULL_PRIOR.ln(), f64::max);
        seen.par_iter()
            .zip(&self.kernels)
            .enumerate()
            .map(|(k, ((projected, first), s))| {
                let near = first.log_evidence + s.log_prior > best - FAR_BEHIND_NATS;
                let reached = if near { background.evidence(projected) } else { *first };
                (Hypothesis::Kernel(k), reached.log_evidence + s.log_prior, reached)
            })
            .collect()
    }

    /// Best candidate of `slot` and its effect's ln evidence over nothing, the prior within the effect included.
    pub(super) fn best_effect(&self, slot: &Slot) -> Option<(usize, f64, Reached)> {
        let (best, reached) = slot.ranked.iter().find_map(|(h, _, r)| match h {
            Hypothesis::Effect(c) => Some((*c, *r)),
            _ => None,
        })?;
        Some((best, self.effect_gain(slot, best), reached))
    }

    /// ln evidence of the whole effect that `candidate` belongs to, over nothing.
    #[must_use]
    pub fn effect_gain(&self, slot: &Slot, candidate: usize) -> f64 {
        let effect = self.candidates[candidate].effect;
        log_sum(slot.ranked.iter().filter_map(|(h, _, r)| match h {
            Hypothesis::Effect(c) if self.candidates[*c].effect == effect => {
                Some(r.log_evidence + self.candidates[*c].weight.ln())
            }
            _ => None,
        })) - slot.null.log_evidence
    }
}

/// What the right sign adds to ln evidence, and the wrong one takes off it; `z`: by how many standard deviations the size
/// is positive.
fn sign_nats(z: f64) -> f64 {
    let positive = normal_below(z);
    (2.0 * (RIGHT_SIGN * positive + (1.0 - RIGHT_SIGN) * (1.0 - positive))).ln()
}

#[cfg(test)]
mod tests {
    use super::sign_nats;

    /// A sign that the data do not tell says nothing; one that they tell has nine times the weight of the other.
    #[test]
    fn the_sign_of_physics_counts_where_the_data_tell_it() {
        assert!(sign_nats(0.0).abs() < 1e-6);
        assert!((sign_nats(9.0) - 1.8_f64.ln()).abs() < 1e-12);
        assert!((sign_nats(-9.0) - 0.2_f64.ln()).abs() < 1e-12);
    }
}
