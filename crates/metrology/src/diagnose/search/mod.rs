//! The search: the best effect above the alarm is added, then the next; each is tried against all others in
//! its own place; what falls below is dropped.

mod change;
mod library;
mod rank;

pub use library::Library;
pub use rank::{Hypothesis, Slot};

use super::design::Design;
use super::effects::{Candidate, steps_too_near};
use super::evidence::{Background, Reached};
use super::marginal::Noise;
use change::Search;
use library::Follower;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Prior probability that nothing is there, and that something outside the library is.
pub const NULL_PRIOR: f64 = 0.5;
/// See [`NULL_PRIOR`].
pub const UNEXPLAINED_PRIOR: f64 = 0.1;
/// An effect is added when it is this much likelier than nothing, nats.
pub const ALARM_NATS: f64 = 5.0;
/// Share of it that a further effect has to pass: where one effect is at work, more are.
const BESIDE: f64 = 0.8;
/// And dropped when it falls under this.
pub const DROP_NATS: f64 = 3.0;
/// Most causes that are not gear lines, and most gear lines.
const MOST_CAUSES: usize = 4;
const MOST_LINES: usize = 80;
/// Gear lines that are added together when each is this clear.
const LINES_AT_ONCE: usize = 7;
const CLEAR_NATS: f64 = 25.0;
/// An arm whose geometry is this many tolerances off, all joints together, was never calibrated.
const FAR_OFF: f64 = 1.5;
/// Nothing is added where fewer numbers than this are left to contradict it.
const FEWEST_FREE: f64 = 12.0;
/// With more causes than this each is not tried against all others.
const MOST_SWAPPED: usize = 8;
/// Rounds of adding and trying in turn.
const PASSES: usize = 3;

/// One cause in the model.
#[derive(Clone, Debug)]
pub struct Chosen {
    /// Index into the candidates.
    pub candidate: usize,
    /// Its columns in the design.
    pub columns: Vec<usize>,
    /// ln evidence over nothing in its place, when it was added.
    pub gain_nats: f64,
    /// Best s / sigma.
    pub size_ratio: f64,
}

impl Library<'_> {
    /// Adds effects while one passes `alarm_nats`; then tries each against all others in its place, drops what
    /// falls under, and, where that changed anything, goes on.
    ///
    /// `design` gains the chosen effects' columns; `place` remembers where.
    pub fn search(
        &mut self,
        design: &mut Design,
        subset: &[usize],
        noise: Noise,
        place: &mut BTreeMap<usize, Vec<usize>>,
        alarm_nats: f64,
    ) -> Vec<Chosen> {
        let mut background = Background::new(design, subset, &[], noise);
        let followers = self.follow(&background, subset);
        let null = background.null();
        let uncalibrated = null.geometry_ratio * null.sigma_m > FAR_OFF;
        let (chosen, near) = (Vec::new(), BTreeSet::new());
        let mut search = Search { design, subset, noise, place, chosen, near, followers };
        for pass in 0..PASSES {
            self.add_while(&mut search, &mut background, alarm_nats, uncalibrated);
            let many = search.chosen.len() > MOST_SWAPPED;
            // Over a fold the lines are chosen anew, but not settled: that takes as long as all the rest.
            let settled = pass > 0 || subset.len() < search.design.atoms();
            if search.chosen.len() < 2 || many && settled {
                break;
            }
            let candidates =
                |search: &Search<'_>| search.chosen.iter().map(|c| c.candidate).collect::<Vec<_>>();
            let before = candidates(&search);
            if many {
                self.settle_lines(&mut search);
            } else {
                self.swap(&mut search);
                self.merge(&mut search);
            }
            if before == candidates(&search) {
                break;
            }
            background = search.background(&search.chosen);
            search.followers.par_iter_mut().for_each(|f| {
                self.products[f.candidate].sum_more(subset, &mut f.sums);
                f.projected = background.project(&f.sums);
            });
        }
        self.drop_offsets(&mut search);
        search.chosen
    }

    /// Adds the best effect, and the next, while it passes `alarm_nats`.
    fn add_while(
        &mut self,
        search: &mut Search<'_>,
        background: &mut Background,
        alarm_nats: f64,
        uncalibrated: bool,
    ) {
        loop {
            let beside = if search.chosen.is_empty() { 1.0 } else { BESIDE };
            let alarm_nats = beside * alarm_nats;
            let open: Vec<&Follower> = search
                .followers
                .iter()
                .filter(|f| self.allowed(f.candidate, &search.chosen))
                .filter(|f| uncalibrated && search.chosen.is_empty() || !self.all_offsets(f.candidate))
                .collect();
            let slot = self.rank(background, &open, false);
            search.near.extend(slot.ranked.iter().filter_map(|(h, _, _)| match h {
                Hypothesis::Effect(c) => Some(*c),
                _ => None,
            }));
            // Zero offsets come first where the arm was never calibrated: all else is seen beside them.
            let offsets = slot.ranked.iter().find_map(|(h, _, r)| match h {
                Hypothesis::Effect(c) if self.all_offsets(*c) => {
                    Some((*c, r.log_evidence - slot.null.log_evidence, *r))
                }
                _ => None,
            });
            let best = offsets.filter(|o| o.1 > alarm_nats).or_else(|| self.best_effect(&slot));
            let Some((candidate, gain, reached)) = best else { return };
            if gain < alarm_nats || background.freedom() < FEWEST_FREE {
                return;
            }
            let mut first = vec![(candidate, gain, reached)];
            if self.all_offsets(candidate) {
                first = self.single_offsets().into_iter().map(|c| (c, gain, reached)).collect();
            }
            let sure = first.len();
            let wanted: Vec<Chosen> = first
                .into_iter()
                .chain(self.more_lines(&slot, candidate))
                .map(|(candidate, gain_nats, reached)| {
                    let columns = self.place(search.design, search.place, candidate);
                    Chosen { candidate, columns, gain_nats, size_ratio: reached.size_ratio }
                })
                .collect();
            self.extend(search.design);
            for (i, mut one) in wanted.into_iter().enumerate() {
                // A further line may be the shadow of those before it: it must be clear beside them.
                if i >= sure {
                    if background.freedom() < FEWEST_FREE {
                        break;
                    }
                    let projected = background.project(&self.products[one.candidate].sum(search.subset));
                    let reached = self.evidence(background, &projected, one.candidate);
                    one.gain_nats = reached.log_evidence - background.null().log_evidence;
                    one.size_ratio = reached.size_ratio;
                    if one.gain_nats < CLEAR_NATS {
                        continue;
                    }
                }
                background.grow(search.design, search.subset, &one.columns);
                search.chosen.push(one);
            }
            self.catch_up(background, search.subset, &mut search.followers);
        }
    }

    /// Further gear lines of the same scan that are so clear, and so far from each other, that they need
    /// hardly wait for the next: a real gear has dozens.
    fn more_lines(&self, slot: &Slot, first: usize) -> Vec<(usize, f64, Reached)> {
        let mut lines: Vec<usize> = vec![first];
        let mut more = Vec::new();
        for (hypothesis, _, reached) in &slot.ranked {
            let Hypothesis::Effect(c) = *hypothesis else { continue };
            let form = &self.candidates[c].form;
            let gain = reached.log_evidence + self.candidates[c].weight.ln() - slot.null.log_evidence;
            let far = lines.iter().all(|&l| {
                let other = &self.candidates[l].form;
                other.n.is_some()
                    && (other.joint != form.joint || other.n.unwrap_or(0).abs_diff(form.n.unwrap_or(0)) > 3)
            });
            if form.n.is_none() || gain < CLEAR_NATS || !far || more.len() == LINES_AT_ONCE {
                continue;
            }
            lines.push(c);
            more.push((c, gain, *reached));
        }
        more
    }

    /// Whether `candidate` is the offsets of all joints at once.
    fn all_offsets(&self, candidate: usize) -> bool {
        let this = &self.candidates[candidate];
        this.effect().name() == "joint_offset" && this.form.joint.is_none()
    }

    /// The offsets of single joints.
    fn single_offsets(&self) -> Vec<usize> {
        let offset = |c: &usize| self.candidates[*c].effect().name() == "joint_offset";
        (0..self.candidates.len()).filter(|c| offset(c) && !self.all_offsets(*c)).collect()
    }

    /// Whether `candidate` may join: not twice the same, not too many.
    fn allowed(&self, candidate: usize, chosen: &[Chosen]) -> bool {
        let this = &self.candidates[candidate];
        let line = |c: &Candidate| c.effect().name() == "gear_mesh";
        let offset = |c: &Candidate| c.effect().name() == "joint_offset";
        let count = |of: &dyn Fn(&Candidate) -> bool| {
            chosen.iter().filter(|c| of(&self.candidates[c.candidate])).count()
        };
        let lines = count(&line);
        let room = if line(this) {
            lines < MOST_LINES
        } else {
            offset(this) || chosen.len() - lines - count(&offset) < MOST_CAUSES
        };
        room && chosen.iter().all(|c| {
            let other = &self.candidates[c.candidate];
            let same = other.effect == this.effect
                && other.form.joint == this.form.joint
                && other.form.joint_b == this.form.joint_b
                && other.form.n == this.form.n;
            let steps = this.form.t0_min().zip(other.form.t0_min());
            if steps.is_some_and(|(t0_min, other)| steps_too_near(self.scene, t0_min, other)) {
                return false;
            }
            !same || steps.is_some_and(|(t0_min, other)| t0_min != other)
        })
    }

    /// The candidate's columns in the design, appended when new; [`Self::extend`] has to follow.
    pub fn place(
        &mut self,
        design: &mut Design,
        place: &mut BTreeMap<usize, Vec<usize>>,
        candidate: usize,
    ) -> Vec<usize> {
        if let Some(columns) = place.get(&candidate) {
            return columns.clone();
        }
        let columns = design.columns_of(self.scene, &self.candidates[candidate]);
        let at: Vec<usize> = design.append(columns).collect();
        place.insert(candidate, at.clone());
        at
    }
}

/// Columns of all chosen but `without`.
#[must_use]
pub fn flat(chosen: &[Chosen], without: Option<usize>) -> Vec<usize> {
    chosen
        .iter()
        .enumerate()
        .filter(|(i, _)| Some(*i) != without)
        .flat_map(|(_, c)| c.columns.iter().copied())
        .collect()
}
