//! What is chosen, tried again: each cause against its alternatives, gear lines against their neighbours, two against one.

use super::chosen::{ChosenCause, DROP_NATS, NULL_PRIOR, cause_columns};
use super::library::{Library, TrackedCandidate};
use super::ranking::{BestEffect, HypothesisRanking};
use crate::design::Design;
use crate::effects::Candidate;
use crate::evidence::{EvidencePeak, NuisanceModel};
use crate::marginal::NoisePrior;
use robot_model::deform::EffectKind;
use robot_model::robot::Axis;
use std::collections::{BTreeMap, BTreeSet};

/// With more causes than this each is not tried against all others.
pub(super) const MOST_SWAPPED: usize = 8;

/// So many periods per turn to either side of a line are its neighbours.
const NEIGHBOURS: u32 = 5;

/// Offsets of so many joints stay together: an arm that was never calibrated.
const OFFSETS_TOGETHER: usize = 4;

/// The state of one search.
pub(super) struct Search<'s> {
    pub design: &'s mut Design,
    pub subset: &'s [usize],
    pub noise: NoisePrior,
    /// Where columns stand in the design.
    pub column_index: &'s mut BTreeMap<usize, Vec<usize>>,
    pub chosen: Vec<ChosenCause>,
    /// What was ever near the top: only these can take another's place.
    pub near: BTreeSet<usize>,
    /// All that are searched, by their numbers.
    pub tracked: Vec<TrackedCandidate>,
}

impl Search<'_> {
    /// One of those that are searched.
    pub(super) fn tracked(&self, candidate: usize) -> &TrackedCandidate {
        &self.tracked[self.tracked.partition_point(|tracked| tracked.candidate < candidate)]
    }

    /// The same, to be put over another nuisance model.
    pub(super) fn tracked_mut(&mut self, candidate: usize) -> Option<&mut TrackedCandidate> {
        let at = self.tracked.partition_point(|tracked| tracked.candidate < candidate);
        self.tracked.get_mut(at).filter(|tracked| tracked.candidate == candidate)
    }

    /// What is chosen, but those in the places `without`.
    pub(super) fn others(&self, without: &[usize]) -> Vec<ChosenCause> {
        let kept = self.chosen.iter().enumerate().filter(|(i, _)| !without.contains(i));
        kept.map(|(_, one)| one.clone()).collect()
    }

    /// The nuisance model of `chosen`.
    pub(super) fn nuisance(&self, chosen: &[ChosenCause]) -> NuisanceModel {
        NuisanceModel::new(self.design, self.subset, &cause_columns(chosen, None), self.noise)
    }
}

impl Library<'_> {
    /// All that was ever near beside `others`, by its evidence.
    fn rank_near(
        &self,
        search: &mut Search<'_>,
        others: &[ChosenCause],
    ) -> (NuisanceModel, HypothesisRanking) {
        let nuisance = search.nuisance(others);
        let near = &search.near;
        let is_near = |tracked: &&mut TrackedCandidate| near.contains(&tracked.candidate);
        let tracked: Vec<&mut TrackedCandidate> = search.tracked.iter_mut().filter(is_near).collect();
        self.project_anew(&nuisance, search.subset, tracked);
        let open: Vec<&TrackedCandidate> = search
            .near
            .iter()
            .filter(|&&c| self.allowed(c, others) && !self.of_all_joints(c))
            .map(|&c| search.tracked(c))
            .collect();
        let ranking = self.rank(&nuisance, &open, false);
        (nuisance, ranking)
    }

    /// Puts `candidate` into place `i`.
    pub(super) fn replace(&mut self, search: &mut Search<'_>, i: usize, best: BestEffect) {
        let BestEffect { candidate, own_nats, peak, .. } = best;
        let columns = self.columns_in_design(search.design, search.column_index, &[candidate]).concat();
        self.extend(search.design);
        search.chosen[i] =
            ChosenCause { candidate, columns, gain_nats: own_nats, size_ratio: peak.size_ratio };
    }

    /// Each chosen effect against all that were ever near, in its place.
    pub(super) fn swap(&mut self, search: &mut Search<'_>) {
        let mut i = 0;
        while i < search.chosen.len() {
            let others = search.others(&[i]);
            let (nuisance, ranking) = self.rank_near(search, &others);
            let best = self.best_effect(&ranking);
            match best.map(|best| self.settled_best(search, &nuisance, &ranking, best)) {
                Some(best) if best.gain_nats < DROP_NATS => {
                    search.chosen.remove(i);
                    continue;
                }
                Some(best) => self.replace(search, i, best),
                None => {}
            }
            i += 1;
        }
    }

    /// Each of many gear lines against its neighbours, now that the others stand beside it: over a part of a turn
    /// near periods look alike, and the first were chosen when nothing else was there.
    pub(super) fn settle_lines(&mut self, search: &mut Search<'_>) {
        let mut i = 0;
        let mut whole = search.nuisance(&search.chosen);
        while i < search.chosen.len() {
            let this = search.chosen[i].candidate;
            let variant = self.candidates[this].variant;
            let Some(n) = variant.n else {
                i += 1;
                continue;
            };
            let nuisance = whole
                .without(search.design, search.subset, &search.chosen[i].columns)
                .unwrap_or_else(|| search.nuisance(&search.others(&[i])));
            let bare = nuisance.null().log_evidence;
            let best = (0..self.candidates.len())
                .filter(|&c| {
                    let other = &self.candidates[c].variant;
                    other.joint == variant.joint && other.n.is_some_and(|m| m.abs_diff(n) <= NEIGHBOURS)
                })
                .filter(|&c| c == this || search.chosen.iter().all(|other| other.candidate != c))
                .map(|c| (c, nuisance.evidence(&nuisance.project(&self.products[c].sum(search.subset)))))
                .reduce(|a, b| {
                    let odds = |x: &(usize, EvidencePeak)| x.1.log_evidence + self.log_prior[x.0];
                    if odds(&b) > odds(&a) { b } else { a }
                });
            match best {
                Some((_, peak)) if peak.log_evidence - bare < DROP_NATS => {
                    search.chosen.remove(i);
                    whole = nuisance;
                    continue;
                }
                Some((candidate, peak)) => {
                    let gain_nats = peak.log_evidence - bare;
                    self.replace(search, i, BestEffect { candidate, gain_nats, own_nats: gain_nats, peak });
                    if candidate != this {
                        whole = nuisance;
                        whole.grow(search.design, search.subset, &search.chosen[i].columns);
                    }
                }
                None => {}
            }
            i += 1;
        }
    }

    /// Puts the causes of `start`, each tried against all that were near, in the place of what was found, where these data find them
    /// likelier: one cause after the other may end at others. Where nothing was found nothing is tried.
    pub(super) fn restart(&mut self, search: &mut Search<'_>, start: &[ChosenCause]) {
        let causes = |chosen: &[ChosenCause]| -> BTreeSet<_> {
            let cause = |c: &ChosenCause| {
                let Candidate { kind, variant, .. } = &self.candidates[c.candidate];
                (*kind, variant.joint, variant.joint_b, variant.n)
            };
            chosen.iter().map(cause).collect()
        };
        let tried = !search.chosen.is_empty() && (1..=MOST_SWAPPED).contains(&start.len());
        if !tried || causes(&search.chosen) == causes(start) {
            return;
        }
        let found_odds = self.odds_of_chosen(search);
        search.near.extend(start.iter().map(|c| c.candidate));
        let found = std::mem::replace(&mut search.chosen, start.to_vec());
        self.swap(search);
        if self.odds_of_chosen(search) <= found_odds {
            search.chosen = found;
        }
    }

    /// ln odds of all that is chosen over nothing, one after the other.
    fn odds_of_chosen(&self, search: &Search<'_>) -> f64 {
        let mut nuisance = search.nuisance(&[]);
        let mut odds = 0.0;
        for one in &search.chosen {
            odds += self.odds(self.gain(&nuisance, search.subset, one.candidate), one.candidate);
            nuisance.grow(search.design, search.subset, &one.columns);
        }
        odds
    }

    /// Two causes in one joint, two that give way under load, or two that move the target over time, against any one that was ever near, in
    /// the place of both: a shape can be taken for the sum of two others.
    pub(super) fn merge(&mut self, search: &mut Search<'_>) {
        let joint = |of: &ChosenCause| self.candidates[of.candidate].variant.joint;
        let loaded = |of: &ChosenCause| self.candidates[of.candidate].kind.needs_load();
        let shifts = |of: &ChosenCause| self.moves_target(of.candidate);
        let chosen = &search.chosen;
        let pairs: Vec<(usize, usize)> = (0..chosen.len())
            .flat_map(|k| (0..k).map(move |i| (i, k)))
            .filter(|&(i, k)| {
                joint(&chosen[i]).is_some() && joint(&chosen[i]) == joint(&chosen[k])
                    || loaded(&chosen[i]) && loaded(&chosen[k])
                    || shifts(&chosen[i]) && shifts(&chosen[k])
            })
            .collect();
        for (i, k) in pairs.into_iter().rev() {
            let others = search.others(&[i, k]);
            let (nuisance, ranking) = self.rank_near(search, &others);
            let Some(best) = self.best_effect(&ranking) else { continue };
            let candidate = best.candidate;
            let odds = |gain: f64, c: usize| gain + self.log_prior[c] - NULL_PRIOR.ln();
            let (first, second) = (search.chosen[i].candidate, search.chosen[k].candidate);
            let single = odds(best.peak.log_evidence - ranking.null.log_evidence, candidate);
            let pair = self.evidence_of_two(&nuisance, search.subset, [&search.chosen[i], &search.chosen[k]]);
            let both = odds(pair.log_evidence - ranking.null.log_evidence, first) + odds(0.0, second);
            if candidate != first && candidate != second && single > both {
                self.replace(search, i, best);
                search.chosen.remove(k);
                return;
            }
        }
    }

    /// Whether `candidate` moves the target against the last link over time: by itself, or as the last joint turns.
    fn moves_target(&self, candidate: usize) -> bool {
        let Candidate { kind, variant, .. } = &self.candidates[candidate];
        let last = self.dataset.joints().checked_sub(1).map(Axis::at);
        match kind {
            EffectKind::ToolDrift | EffectKind::ToolStep => true,
            EffectKind::ThermalJointDrift | EffectKind::JointStep => variant.joint == last,
            _ => false,
        }
    }

    /// `candidate` as it would be chosen over `nuisance`.
    #[must_use]
    pub fn chosen(
        &self,
        nuisance: &NuisanceModel,
        subset: &[usize],
        candidate: usize,
        columns: &[usize],
    ) -> ChosenCause {
        let projected = nuisance.project(&self.products[candidate].sum(subset));
        let peak = self.evidence(nuisance, &projected, candidate);
        ChosenCause {
            candidate,
            columns: columns.to_vec(),
            gain_nats: peak.log_evidence - nuisance.null().log_evidence,
            size_ratio: peak.size_ratio,
        }
    }

    /// Takes out the joint offsets that came with the others and are not needed.
    pub(super) fn drop_offsets(&self, search: &mut Search<'_>) {
        let mut i = 0;
        while i < search.chosen.len() {
            let c = search.chosen[i].candidate;
            if self.candidates[c].kind == EffectKind::JointOffset && search.chosen.len() > OFFSETS_TOGETHER {
                let nuisance = search.nuisance(&search.others(&[i]));
                if self.gain(&nuisance, search.subset, c) < DROP_NATS {
                    search.chosen.remove(i);
                    continue;
                }
            }
            i += 1;
        }
    }
}
