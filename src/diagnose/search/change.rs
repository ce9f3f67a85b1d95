//! What is chosen, tried again: each cause against its rivals, gear lines against their neighbours, two against one.

use super::library::{Follower, Library};
use super::{Chosen, DROP_NATS, MOST_CAUSES, NULL_PRIOR, flat};
use crate::diagnose::design::Design;
use crate::diagnose::evidence::{Background, Reached};
use crate::diagnose::marginal::Noise;
use std::collections::{BTreeMap, BTreeSet};

/// So many periods per turn to either side of a line are its neighbours.
const NEIGHBOURS: u32 = 5;

impl Library<'_> {
    /// Each chosen effect against all that were ever near, in its place.
    #[allow(clippy::too_many_arguments, reason = "the state of one search")]
    pub(super) fn swap(
        &mut self,
        design: &mut Design,
        subset: &[usize],
        noise: Noise,
        place: &mut BTreeMap<usize, Vec<usize>>,
        chosen: &mut Vec<Chosen>,
        near: &BTreeSet<usize>,
        followers: &mut [Follower],
    ) {
        let mut i = 0;
        while i < chosen.len() {
            let background = Background::new(design, subset, &flat(chosen, Some(i)), noise);
            let others: Vec<Chosen> =
                chosen.iter().enumerate().filter(|(k, _)| *k != i).map(|(_, c)| c.clone()).collect();
            for &c in near {
                self.products[c].sum_more(subset, &mut followers[c].sums);
                followers[c].projected = background.project(&followers[c].sums);
            }
            let open: Vec<&Follower> =
                near.iter().filter(|&&c| self.allowed(c, &others)).map(|&c| &followers[c]).collect();
            let slot = self.rank(&background, subset, &open, false);
            match self.best_effect(&slot) {
                Some((_, gain, _)) if gain < DROP_NATS => {
                    chosen.remove(i);
                    continue;
                }
                Some((candidate, gain, reached)) => {
                    let columns = self.place(design, place, candidate);
                    self.extend(design);
                    chosen[i] =
                        Chosen { candidate, columns, gain_nats: gain, size_ratio: reached.size_ratio };
                }
                None => {}
            }
            i += 1;
        }
    }

    /// Each of many gear lines against its neighbours, now that the others stand beside it: over a part of a turn
    /// near periods look alike, and the first were chosen when nothing else was there.
    pub(super) fn settle_lines(
        &mut self,
        design: &mut Design,
        subset: &[usize],
        noise: Noise,
        place: &mut BTreeMap<usize, Vec<usize>>,
        chosen: &mut Vec<Chosen>,
    ) {
        let mut i = 0;
        while i < chosen.len() {
            let form = self.candidates[chosen[i].candidate].form;
            let Some(n) = form.n else {
                i += 1;
                continue;
            };
            let near: Vec<usize> = (0..self.candidates.len())
                .filter(|&c| {
                    let other = &self.candidates[c].form;
                    other.joint == form.joint && other.n.is_some_and(|m| m.abs_diff(n) <= NEIGHBOURS)
                })
                .filter(|&c| c == chosen[i].candidate || chosen.iter().all(|other| other.candidate != c))
                .collect();
            let background = Background::new(design, subset, &flat(chosen, Some(i)), noise);
            let bare = background.null().log_evidence;
            let best = near
                .into_iter()
                .map(|c| (c, background.evidence(&background.project(&self.products[c].sum(subset)))))
                .reduce(|a, b| {
                    let odds = |x: &(usize, Reached)| x.1.log_evidence + self.log_prior[x.0];
                    if odds(&b) > odds(&a) { b } else { a }
                });
            match best {
                Some((_, reached)) if reached.log_evidence - bare < DROP_NATS => {
                    chosen.remove(i);
                    continue;
                }
                Some((candidate, reached)) => {
                    let columns = self.place(design, place, candidate);
                    self.extend(design);
                    let gain_nats = reached.log_evidence - bare;
                    chosen[i] = Chosen { candidate, columns, gain_nats, size_ratio: reached.size_ratio };
                }
                None => {}
            }
            i += 1;
        }
    }

    /// Two causes in one joint against any one that was ever near, in the place of both: a shape can be taken
    /// for the sum of two others.
    #[allow(clippy::too_many_arguments, reason = "the state of one search")]
    pub(super) fn merge(
        &mut self,
        design: &mut Design,
        subset: &[usize],
        noise: Noise,
        place: &mut BTreeMap<usize, Vec<usize>>,
        chosen: &mut Vec<Chosen>,
        near: &BTreeSet<usize>,
        followers: &mut [Follower],
    ) {
        let joint = |of: &Chosen| self.candidates[of.candidate].form.joint;
        let pairs: Vec<(usize, usize)> = (0..chosen.len())
            .flat_map(|k| (0..k).map(move |i| (i, k)))
            .filter(|&(i, k)| joint(&chosen[i]).is_some() && joint(&chosen[i]) == joint(&chosen[k]))
            .collect();
        for (i, k) in pairs.into_iter().rev() {
            let others: Vec<Chosen> =
                (0..chosen.len()).filter(|&x| x != i && x != k).map(|x| chosen[x].clone()).collect();
            let mut background = Background::new(design, subset, &flat(&others, None), noise);
            for &c in near {
                self.products[c].sum_more(subset, &mut followers[c].sums);
                followers[c].projected = background.project(&followers[c].sums);
            }
            let open: Vec<&Follower> =
                near.iter().filter(|&&c| self.allowed(c, &others)).map(|&c| &followers[c]).collect();
            let slot = self.rank(&background, subset, &open, false);
            let Some((candidate, gain, reached)) = self.best_effect(&slot) else { continue };
            let odds = |gain: f64, c: usize| gain + self.log_prior[c] - NULL_PRIOR.ln();
            let (first, second) = (chosen[i].candidate, chosen[k].candidate);
            let single = odds(reached.log_evidence - slot.null.log_evidence, candidate);
            let mut both = odds(self.gain(&background, subset, first), first);
            background.grow(design, subset, &chosen[i].columns);
            both += odds(self.gain(&background, subset, second), second);
            if candidate != first && candidate != second && single > both {
                let columns = self.place(design, place, candidate);
                self.extend(design);
                chosen[i] = Chosen { candidate, columns, gain_nats: gain, size_ratio: reached.size_ratio };
                chosen.remove(k);
                return;
            }
        }
    }

    /// Takes out the joint offsets that came with the others and are not needed.
    pub(super) fn drop_offsets(
        &self,
        design: &Design,
        subset: &[usize],
        noise: Noise,
        chosen: &mut Vec<Chosen>,
    ) {
        let mut i = 0;
        while i < chosen.len() {
            let c = chosen[i].candidate;
            if self.candidates[c].effect().name() == "joint_offset" && chosen.len() > MOST_CAUSES {
                let background = Background::new(design, subset, &flat(chosen, Some(i)), noise);
                if self.gain(&background, subset, c) < DROP_NATS {
                    chosen.remove(i);
                    continue;
                }
            }
            i += 1;
        }
    }
}
