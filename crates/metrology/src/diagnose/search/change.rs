//! What is chosen, tried again: each cause against its rivals, gear lines against their neighbours, two against one.

use super::library::{Follower, Library};
use super::rank::Slot;
use super::{Chosen, DROP_NATS, MOST_CAUSES, NULL_PRIOR, flat};
use crate::diagnose::design::Design;
use crate::diagnose::evidence::{Background, Reached};
use crate::diagnose::marginal::Noise;
use std::collections::{BTreeMap, BTreeSet};

/// So many periods per turn to either side of a line are its neighbours.
const NEIGHBOURS: u32 = 5;

/// The state of one search.
pub(super) struct Search<'s> {
    pub design: &'s mut Design,
    pub subset: &'s [usize],
    pub noise: Noise,
    /// Where columns stand in the design.
    pub place: &'s mut BTreeMap<usize, Vec<usize>>,
    pub chosen: Vec<Chosen>,
    /// What was ever near the top: only these can take another's place.
    pub near: BTreeSet<usize>,
    pub followers: Vec<Follower>,
}

impl Search<'_> {
    /// What is chosen, but those in the places `without`.
    fn others(&self, without: &[usize]) -> Vec<Chosen> {
        let kept = self.chosen.iter().enumerate().filter(|(i, _)| !without.contains(i));
        kept.map(|(_, one)| one.clone()).collect()
    }

    /// The background of `chosen`.
    pub(super) fn background(&self, chosen: &[Chosen]) -> Background {
        Background::new(self.design, self.subset, &flat(chosen, None), self.noise)
    }
}

impl Library<'_> {
    /// All that was ever near beside `others`, by its evidence.
    fn rank_near(&self, search: &mut Search<'_>, others: &[Chosen]) -> (Background, Slot) {
        let background = search.background(others);
        for &c in &search.near {
            let follower = &mut search.followers[c];
            self.products[c].sum_more(search.subset, &mut follower.sums);
            follower.projected = background.project(&follower.sums);
        }
        let open: Vec<&Follower> =
            search.near.iter().filter(|&&c| self.allowed(c, others)).map(|&c| &search.followers[c]).collect();
        let slot = self.rank(&background, &open, false);
        (background, slot)
    }

    /// Puts `candidate` into place `i`.
    fn put(
        &mut self,
        search: &mut Search<'_>,
        i: usize,
        candidate: usize,
        gain_nats: f64,
        reached: &Reached,
    ) {
        let columns = self.place(search.design, search.place, candidate);
        self.extend(search.design);
        search.chosen[i] = Chosen { candidate, columns, gain_nats, size_ratio: reached.size_ratio };
    }

    /// Each chosen effect against all that were ever near, in its place.
    pub(super) fn swap(&mut self, search: &mut Search<'_>) {
        let mut i = 0;
        while i < search.chosen.len() {
            let others = search.others(&[i]);
            let (_, slot) = self.rank_near(search, &others);
            match self.best_effect(&slot) {
                Some((_, gain, _)) if gain < DROP_NATS => {
                    search.chosen.remove(i);
                    continue;
                }
                Some((candidate, gain, reached)) => self.put(search, i, candidate, gain, &reached),
                None => {}
            }
            i += 1;
        }
    }

    /// Each of many gear lines against its neighbours, now that the others stand beside it: over a part of a turn
    /// near periods look alike, and the first were chosen when nothing else was there.
    pub(super) fn settle_lines(&mut self, search: &mut Search<'_>) {
        let mut i = 0;
        while i < search.chosen.len() {
            let this = search.chosen[i].candidate;
            let form = self.candidates[this].form;
            let Some(n) = form.n else {
                i += 1;
                continue;
            };
            let background = search.background(&search.others(&[i]));
            let bare = background.null().log_evidence;
            let best = (0..self.candidates.len())
                .filter(|&c| {
                    let other = &self.candidates[c].form;
                    other.joint == form.joint && other.n.is_some_and(|m| m.abs_diff(n) <= NEIGHBOURS)
                })
                .filter(|&c| c == this || search.chosen.iter().all(|other| other.candidate != c))
                .map(|c| (c, background.evidence(&background.project(&self.products[c].sum(search.subset)))))
                .reduce(|a, b| {
                    let odds = |x: &(usize, Reached)| x.1.log_evidence + self.log_prior[x.0];
                    if odds(&b) > odds(&a) { b } else { a }
                });
            match best {
                Some((_, reached)) if reached.log_evidence - bare < DROP_NATS => {
                    search.chosen.remove(i);
                    continue;
                }
                Some((candidate, reached)) => {
                    self.put(search, i, candidate, reached.log_evidence - bare, &reached);
                }
                None => {}
            }
            i += 1;
        }
    }

    /// Two causes in one joint against any one that was ever near, in the place of both: a shape can be taken
    /// for the sum of two others.
    pub(super) fn merge(&mut self, search: &mut Search<'_>) {
        let joint = |of: &Chosen| self.candidates[of.candidate].form.joint;
        let chosen = &search.chosen;
        let pairs: Vec<(usize, usize)> = (0..chosen.len())
            .flat_map(|k| (0..k).map(move |i| (i, k)))
            .filter(|&(i, k)| joint(&chosen[i]).is_some() && joint(&chosen[i]) == joint(&chosen[k]))
            .collect();
        for (i, k) in pairs.into_iter().rev() {
            let others = search.others(&[i, k]);
            let (mut background, slot) = self.rank_near(search, &others);
            let Some((candidate, gain, reached)) = self.best_effect(&slot) else { continue };
            let odds = |gain: f64, c: usize| gain + self.log_prior[c] - NULL_PRIOR.ln();
            let (first, second) = (search.chosen[i].candidate, search.chosen[k].candidate);
            let single = odds(reached.log_evidence - slot.null.log_evidence, candidate);
            let mut both = odds(self.gain(&background, search.subset, first), first);
            background.grow(search.design, search.subset, &search.chosen[i].columns);
            both += odds(self.gain(&background, search.subset, second), second);
            if candidate != first && candidate != second && single > both {
                self.put(search, i, candidate, gain, &reached);
                search.chosen.remove(k);
                return;
            }
        }
    }

    /// Takes out the joint offsets that came with the others and are not needed.
    pub(super) fn drop_offsets(&self, search: &mut Search<'_>) {
        let mut i = 0;
        while i < search.chosen.len() {
            let c = search.chosen[i].candidate;
            if self.candidates[c].effect().name() == "joint_offset" && search.chosen.len() > MOST_CAUSES {
                let background = search.background(&search.others(&[i]));
                if self.gain(&background, search.subset, c) < DROP_NATS {
                    search.chosen.remove(i);
                    continue;
                }
            }
            i += 1;
        }
    }
}
