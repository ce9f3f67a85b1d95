//! The search: the best effect above the alarm is added, then the next; each is tried against all others in
//! its own place; what falls below is dropped.

use super::design::{Design, Products};
use super::effects::Candidate;
use super::evidence::{Background, Noise, Reached, log_sum};
use super::kernel::Kernel;
use super::scene::Scene;
use rayon::prelude::*;
use std::collections::BTreeMap;

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
/// Candidates that are evaluated in full after a first look.
const SHORT_LIST: usize = 96;

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
    /// Kernels with products and ln prior.
    pub kernels: Vec<(Kernel, Products, f64)>,
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

impl Slot {
    /// ln evidence of `which` over nothing.
    #[must_use]
    pub fn gain(&self, which: Hypothesis) -> Option<f64> {
        self.ranked
            .iter()
            .find(|(h, _, _)| *h == which)
            .map(|(_, _, r)| r.log_evidence - self.null.log_evidence)
    }
}

impl<'a> Library<'a> {
    /// Computes the products of all candidates with `design`.
    #[must_use]
    pub fn new(design: &Design, scene: &'a Scene, candidates: &'a [Candidate]) -> Self {
        let products = design.all_products(scene, candidates);
        let effects: std::collections::BTreeSet<usize> = candidates.iter().map(|c| c.effect).collect();
        let family = ((1.0 - NULL_PRIOR - UNEXPLAINED_PRIOR) / effects.len().max(1) as f64).ln();
        let log_prior = candidates.iter().map(|c| family + c.weight.ln()).collect();
        Self { scene, candidates, products, log_prior, width: design.width(), kernels: Vec::new() }
    }

    /// Adds the kernels' products.
    pub fn add_kernels(&mut self, design: &Design) {
        let list = super::kernel::kernels(self.scene);
        self.kernels = list
            .into_par_iter()
            .map(|(kernel, weight)| {
                let columns = super::kernel::columns(kernel, design, self.scene);
                (kernel, design.products(&columns), (UNEXPLAINED_PRIOR * weight).ln())
            })
            .filter(|(_, products, _)| products.p > 0)
            .collect();
    }

    /// Brings all products up to date with columns appended to `design`.
    pub fn extend(&mut self, design: &Design) {
        if self.width == design.width() {
            return;
        }
        self.width = design.width();
        let (scene, candidates) = (self.scene, self.candidates);
        self.products.par_iter_mut().zip(candidates).for_each(|(products, candidate)| {
            design.extend_candidate(products, scene, candidate);
        });
        self.kernels.par_iter_mut().for_each(|(kernel, products, _)| {
            design.extend(products, &super::kernel::columns(*kernel, design, scene));
        });
    }

    /// Every hypothesis over `background`; `among` limits the candidates.
    #[must_use]
    pub fn scan(&self, background: &Background, subset: &[usize], among: &[usize], kernels: bool) -> Slot {
        let null = background.null();
        let projected: Vec<_> = among
            .par_iter()
            .map(|&c| {
                let sums = self.products[c].sum(subset);
                let projected = background.project(&sums);
                let first = background.first_look(&projected, &null) + self.log_prior[c];
                (c, projected, first)
            })
            .collect();
        let mut order: Vec<usize> = (0..projected.len()).collect();
        order.sort_by(|&a, &b| projected[b].2.total_cmp(&projected[a].2).then(a.cmp(&b)));
        order.truncate(SHORT_LIST);
        let mut ranked: Vec<(Hypothesis, f64, Reached)> = order
            .par_iter()
            .map(|&i| {
                let (c, projected, _) = &projected[i];
                let reached = background.evidence(projected);
                (Hypothesis::Effect(*c), reached.log_evidence + self.log_prior[*c], reached)
            })
            .collect();
        if kernels {
            let scanned: Vec<_> = self
                .kernels
                .par_iter()
                .enumerate()
                .map(|(k, (_, products, log_prior))| {
                    let reached = background.evidence(&background.project(&products.sum(subset)));
                    (Hypothesis::Kernel(k), reached.log_evidence + log_prior, reached)
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

    /// Adds effects while one passes the alarm, tries each against all in its place, drops what falls under.
    ///
    /// `design` gains the chosen effects' columns; `place` remembers where.
    pub fn search(
        &mut self,
        design: &mut Design,
        subset: &[usize],
        noise: Noise,
        among: &[usize],
        place: &mut BTreeMap<usize, Vec<usize>>,
    ) -> Vec<Chosen> {
        let mut chosen: Vec<Chosen> = Vec::new();
        let mut swaps = 0;
        loop {
            let background = Background::new(design, subset, &flat(&chosen, None), noise);
            let open: Vec<usize> = among.iter().copied().filter(|&c| self.allowed(c, &chosen)).collect();
            let slot = self.scan(&background, subset, &open, false);
            let Some((candidate, gain, reached)) = self.best_effect(&slot) else { break };
            if gain < ALARM_NATS || background.freedom() < 12.0 {
                break;
            }
            for (candidate, gain, reached) in
                std::iter::once((candidate, gain, reached)).chain(self.more_lines(&slot, candidate))
            {
                let columns = self.place(design, place, candidate);
                chosen.push(Chosen { candidate, columns, gain_nats: gain, size_ratio: reached.size_ratio });
            }
            self.extend(design);
            if chosen.len() > 1 && chosen.len() <= MOST_CAUSES + 1 && swaps < 8 {
                swaps += 1;
                self.swap(design, subset, noise, among, place, &mut chosen);
            }
        }
        chosen
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

    /// Each chosen effect against all others in its place.
    fn swap(
        &mut self,
        design: &mut Design,
        subset: &[usize],
        noise: Noise,
        among: &[usize],
        place: &mut BTreeMap<usize, Vec<usize>>,
        chosen: &mut Vec<Chosen>,
    ) {
        let mut i = 0;
        while i < chosen.len() {
            let background = Background::new(design, subset, &flat(chosen, Some(i)), noise);
            let others: Vec<Chosen> =
                chosen.iter().enumerate().filter(|(k, _)| *k != i).map(|(_, c)| c.clone()).collect();
            let open: Vec<usize> = among.iter().copied().filter(|&c| self.allowed(c, &others)).collect();
            let slot = self.scan(&background, subset, &open, false);
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

    /// Whether `candidate` may join: not twice the same, not too many.
    fn allowed(&self, candidate: usize, chosen: &[Chosen]) -> bool {
        let this = &self.candidates[candidate];
        let line = |c: &Candidate| c.effect().name() == "gear_mesh";
        let lines = chosen.iter().filter(|c| line(&self.candidates[c.candidate])).count();
        let room = if line(this) { lines < MOST_LINES } else { chosen.len() - lines < MOST_CAUSES };
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
