//! The search: the best effect above the alarm is added, then the next; each is tried against all others in
//! its own place; what falls below is dropped.

use super::design::{Design, Products, Sums, Turning};
use super::effects::Candidate;
use super::evidence::{Background, Projected, Reached};
use super::kernel::Kernel;
use super::marginal::{Noise, log_sum};
use super::scene::Scene;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Prior probability that nothing is there, and that something outside the library is.
pub const NULL_PRIOR: f64 = 0.5;
/// See [`NULL_PRIOR`].
pub const UNEXPLAINED_PRIOR: f64 = 0.1;
/// An effect is added when it is this much likelier than nothing, nats.
pub const ALARM_NATS: f64 = 5.0;
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
/// Rounds of adding and trying in turn.
const PASSES: usize = 3;
/// Candidates that are looked at after their upper bounds.
const LONG_LIST: usize = 320;
/// Candidates that are evaluated in full after a first look.
const SHORT_LIST: usize = 96;
/// Numbers that the columns of all candidates may take to be kept: 600 MB.
const MOST_KEPT: usize = 75_000_000;

/// Whitened columns of one candidate.
type Columns = Vec<Vec<f64>>;

/// A kernel's features.
pub type ColumnsOf<'a> = dyn Fn(Kernel) -> Vec<Vec<f64>> + Sync + 'a;

/// What the search looks at: candidates with their products, and kernels.
pub struct Library<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Candidates.
    pub candidates: &'a [Candidate],
    /// Their products with the design.
    pub products: Vec<Products>,
    /// ln prior of each.
    pub log_prior: Vec<f64>,
    /// Columns of the design that the products cover.
    width: usize,
    /// Candidates that come many at once, by joint.
    turning: Vec<Turning>,
    /// Columns of the other candidates, where there is room to keep them.
    columns: Vec<Option<Columns>>,
    /// Kernels.
    pub kernels: Vec<Structure>,
}

/// A kernel over the data.
pub struct Structure {
    /// Which.
    pub kernel: Kernel,
    /// Its features as columns.
    columns: Vec<Vec<f64>>,
    /// Their products with the design.
    pub products: Products,
    /// ln prior.
    pub log_prior: f64,
}

/// A candidate over the background of a search, with what is needed to follow it.
struct Follower {
    candidate: usize,
    sums: Sums,
    projected: Projected,
}

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

impl<'a> Library<'a> {
    /// Computes the products of all candidates with `design`.
    #[must_use]
    pub fn new(design: &Design, scene: &'a Scene, candidates: &'a [Candidate]) -> Self {
        let turning: Vec<Turning> =
            (0..6_usize).into_par_iter().map(|j| design.turning(scene, candidates, j)).collect();
        let mut many = vec![false; candidates.len()];
        turning.iter().flat_map(|t| &t.members).for_each(|&c| many[c] = true);
        let single = |c: usize| design.columns_of(scene, &candidates[c]);
        let parameters: usize =
            candidates.iter().zip(&many).filter(|(_, many)| !**many).map(|(c, _)| c.usual.len()).sum();
        let keep = parameters * scene.sites.len() * scene.rows_per_site <= MOST_KEPT;
        let (mut products, columns): (Vec<Products>, Vec<Option<Columns>>) = (0..candidates.len())
            .into_par_iter()
            .map(|c| {
                if many[c] {
                    return (Products::none(), None);
                }
                let columns = single(c);
                (design.products(&columns), keep.then_some(columns))
            })
            .unzip();
        for turning in &turning {
            design.begin_turning(turning, &mut products);
            design.extend_turning(turning, &mut products);
        }
        let effects: BTreeSet<usize> = candidates.iter().map(|c| c.effect).collect();
        let family = ((1.0 - NULL_PRIOR - UNEXPLAINED_PRIOR) / effects.len().max(1) as f64).ln();
        let log_prior = candidates.iter().map(|c| family + c.weight.ln()).collect();
        Self {
            scene,
            candidates,
            products,
            log_prior,
            width: design.width(),
            turning,
            columns,
            kernels: Vec::new(),
        }
    }

    /// Adds `list` of kernels, each with its share of the prior of what no effect explains.
    pub fn add_kernels(&mut self, design: &Design, list: Vec<(Kernel, f64)>, columns: &ColumnsOf<'_>) {
        let more: Vec<Structure> = list
            .into_par_iter()
            .map(|(kernel, weight)| {
                let columns = columns(kernel);
                let products = design.products(&columns);
                Structure { kernel, columns, products, log_prior: (UNEXPLAINED_PRIOR * weight).ln() }
            })
            .filter(|structure| structure.products.p > 0)
            .collect();
        self.kernels.extend(more);
    }

    /// Brings all products up to date with columns appended to `design`.
    pub fn extend(&mut self, design: &Design) {
        if self.width == design.width() {
            return;
        }
        self.width = design.width();
        let (scene, candidates) = (self.scene, self.candidates);
        for turning in &self.turning {
            design.extend_turning(turning, &mut self.products);
        }
        let mut many = vec![false; candidates.len()];
        self.turning.iter().flat_map(|t| &t.members).for_each(|&c| many[c] = true);
        let columns = &self.columns;
        self.products.par_iter_mut().enumerate().filter(|(c, _)| !many[*c]).for_each(|(c, products)| {
            match &columns[c] {
                Some(columns) => design.extend(products, columns),
                None => design.extend(products, &design.columns_of(scene, &candidates[c])),
            }
        });
        self.kernels.par_iter_mut().for_each(|s| design.extend(&mut s.products, &s.columns));
    }

    /// All candidates over `background`.
    fn follow(&self, background: &Background, subset: &[usize]) -> Vec<Follower> {
        (0..self.candidates.len())
            .into_par_iter()
            .map(|candidate| {
                let sums = self.products[candidate].sum(subset);
                let projected = background.project(&sums);
                Follower { candidate, sums, projected }
            })
            .collect()
    }

    /// Every hypothesis over `background`, but the candidates in `without`.
    #[must_use]
    pub fn scan(&self, background: &Background, subset: &[usize], without: &[usize]) -> Slot {
        let followers = self.follow(background, subset);
        let open: Vec<&Follower> = followers.iter().filter(|f| !without.contains(&f.candidate)).collect();
        self.rank(background, subset, &open, true)
    }

    /// Every kernel over `background`, weighed against nothing.
    #[must_use]
    pub fn scan_kernels(&self, background: &Background, subset: &[usize]) -> Slot {
        self.rank(background, subset, &[], true)
    }

    /// ln evidence of one candidate over nothing.
    #[must_use]
    pub fn gain(&self, background: &Background, subset: &[usize], candidate: usize) -> f64 {
        let projected = background.project(&self.products[candidate].sum(subset));
        background.evidence(&projected).log_evidence - background.null().log_evidence
    }

    /// Every hypothesis over `background`, its candidates already projected.
    fn rank(
        &self,
        background: &Background,
        subset: &[usize],
        followers: &[&Follower],
        kernels: bool,
    ) -> Slot {
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
        let firsts = score(&long, &|p| background.first_look(p, &looks));
        let order = best(firsts, long, if kernels { SHORT_LIST } else { SHORT_LIST / 2 });
        let mut ranked: Vec<(Hypothesis, f64, Reached)> = order
            .par_iter()
            .map(|&i| {
                let Follower { candidate: c, projected, .. } = followers[i];
                let reached = background.evidence(projected);
                (Hypothesis::Effect(*c), reached.log_evidence + self.log_prior[*c], reached)
            })
            .collect();
        if kernels {
            let scanned: Vec<_> = self
                .kernels
                .par_iter()
                .enumerate()
                .map(|(k, s)| {
                    let reached = background.evidence(&background.project(&s.products.sum(subset)));
                    (Hypothesis::Kernel(k), reached.log_evidence + s.log_prior, reached)
                })
                .collect();
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

    /// Best candidate of `slot` and its effect's ln evidence over nothing, the prior within the effect included.
    fn best_effect(&self, slot: &Slot) -> Option<(usize, f64, Reached)> {
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
        let mut chosen: Vec<Chosen> = Vec::new();
        let mut background = Background::new(design, subset, &[], noise);
        let mut followers = self.follow(&background, subset);
        // What was ever near the top: only these can take another's place.
        let mut near: BTreeSet<usize> = BTreeSet::new();
        let null = background.null();
        let uncalibrated = null.geometry_ratio * null.sigma_m > FAR_OFF;
        for _ in 0..PASSES {
            loop {
                let open: Vec<&Follower> = followers
                    .iter()
                    .filter(|f| self.allowed(f.candidate, &chosen))
                    .filter(|f| uncalibrated && chosen.is_empty() || !self.all_offsets(f.candidate))
                    .collect();
                let slot = self.rank(&background, subset, &open, false);
                near.extend(slot.ranked.iter().filter_map(|(h, _, _)| match h {
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
                let Some((candidate, gain, reached)) = best else { break };
                if gain < alarm_nats || background.freedom() < 12.0 {
                    break;
                }
                let mut added = Vec::new();
                let first = if self.all_offsets(candidate) {
                    self.single_offsets().into_iter().map(|c| (c, gain, reached)).collect()
                } else {
                    vec![(candidate, gain, reached)]
                };
                for (candidate, gain, reached) in first.into_iter().chain(self.more_lines(&slot, candidate)) {
                    let columns = self.place(design, place, candidate);
                    added.extend(columns.iter().copied());
                    let size_ratio = reached.size_ratio;
                    chosen.push(Chosen { candidate, columns, gain_nats: gain, size_ratio });
                }
                self.extend(design);
                background.grow(design, subset, &added);
                self.catch_up(&background, subset, &mut followers);
            }
            if chosen.len() < 2 || chosen.len() > MOST_CAUSES + 1 {
                break;
            }
            let before: Vec<usize> = chosen.iter().map(|c| c.candidate).collect();
            self.swap(design, subset, noise, place, &mut chosen, &near, &mut followers);
            if before == chosen.iter().map(|c| c.candidate).collect::<Vec<_>>() {
                break;
            }
            background = Background::new(design, subset, &flat(&chosen, None), noise);
            followers.par_iter_mut().for_each(|f| {
                self.products[f.candidate].sum_more(subset, &mut f.sums);
                f.projected = background.project(&f.sums);
            });
        }
        self.drop_offsets(design, subset, noise, &mut chosen);
        chosen
    }

    /// Takes out the joint offsets that came with the others and are not needed.
    fn drop_offsets(&self, design: &Design, subset: &[usize], noise: Noise, chosen: &mut Vec<Chosen>) {
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

    /// Brings the followers up to date with a background that has grown.
    fn catch_up(&self, background: &Background, subset: &[usize], followers: &mut [Follower]) {
        followers.par_iter_mut().for_each(|f| {
            self.products[f.candidate].sum_more(subset, &mut f.sums);
            background.update(&mut f.projected, &f.sums);
        });
    }

    /// Further gear lines of the same scan that are so clear, and so far from each other, that they need
    /// not wait for the next: a real gear has dozens.
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

    /// Each chosen effect against all that were ever near, in its place.
    #[allow(clippy::too_many_arguments, reason = "the state of one search")]
    fn swap(
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
            let steps = this.form.t0_min().is_some() && this.form.t0_min() != other.form.t0_min();
            !same || steps
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
