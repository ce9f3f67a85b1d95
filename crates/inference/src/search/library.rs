//! What the search looks at: candidates with their products, and GP alternatives.

use super::chosen::{NULL_PRIOR, UNEXPLAINED_PRIOR};
use crate::dataset::Dataset;
use crate::design::{Design, Products, ScaledMotions, Sums};
use crate::effects::{Candidate, StopTime, stop_times};
use crate::evidence::{NuisanceModel, Projected};
use crate::gp_alternative::{self, GpAlternative, WeightedAlternative};
use nalgebra::DMatrix;
use robot_model::deform::EffectKind;
use robot_model::robot::Joints;
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::sync::Arc;

/// Numbers that the columns of all candidates may take to be kept: 320 MB.
const MOST_KEPT: usize = 40_000_000;
/// The same where much else is there: 80 MB.
const FEW_KEPT: usize = MOST_KEPT / 4;
/// Features of GP alternatives are kept for no more stations than this: 80 MB.
const MAX_OBSERVATIONS_KEPT: usize = 1000;
/// Candidates that are looked at in one go, by products of matrices that stay in the processor's nearest memory.
pub(super) const AT_ONCE: usize = 64;
/// So many lines of gears are a spectrum's.
const SEVERAL_LINES: usize = 3;
/// Computes the features of a GP alternative.
pub(super) type ColumnsOf<'a> = dyn Fn(GpAlternative) -> DMatrix<f64> + Sync + 'a;

/// Angles nearer than this are the same to a gear's line, radians: a tenth of a tooth's width at the highest order.
const SAME_ANGLE_RAD: f64 = 2e-3;

/// Different angles that each joint stood at.
fn angles(dataset: &Dataset) -> Joints<usize> {
    Joints::from_fn(dataset.joints(), |j| {
        let cell = |q_rad: f64| (q_rad / SAME_ANGLE_RAD).round() as i64;
        dataset.of_arm().map(|s| cell(s.q_rad[j])).collect::<BTreeSet<i64>>().len()
    })
}

/// What the search looks at: candidates with their products, and GP alternatives.
pub struct Library<'a> {
    /// The observations that columns are computed at.
    pub dataset: &'a Dataset,
    /// Every variant of every effect that the data can show.
    pub candidates: Arc<Vec<Candidate>>,
    /// The same as they were before laws were settled.
    pub(super) listed: Arc<Vec<Candidate>>,
    /// Products with the design, of those that are searched.
    pub products: Vec<Products>,
    /// ln prior of each.
    pub log_prior: Vec<f64>,
    /// Columns of the design that the products cover.
    width: usize,
    /// Candidates that come many at once, by joint and by body.
    scaled: Vec<ScaledMotions>,
    /// Where each candidate's columns come from.
    sources: Vec<ColumnSource>,
    /// Functions outside the library that explanations are held against, as Gaussian processes.
    pub gp_alternatives: Vec<Structure>,
    /// Different angles that each joint stood at.
    pub(super) angles: Joints<usize>,
    /// When the readings of each stop were made.
    pub(super) stops: Vec<StopTime>,
    /// Which candidates are searched.
    is_searched: Vec<bool>,
    /// What the search over all data has seen near the top.
    pub near_top: NearTop,
}

/// What a search over all data has seen near the top: over a part of the data nothing else is looked at, as what is far behind with all of
/// them is not first with four fifths.
#[derive(Clone, Debug, Default)]
pub struct NearTop {
    /// Candidates that were weighed in full in some place.
    pub(super) candidates: BTreeSet<usize>,
    /// Pairs of causes that were weighed in the place of one.
    pub(super) pairs: Vec<[usize; 2]>,
}

/// Where a candidate's whitened columns come from.
#[derive(Clone)]
enum ColumnSource {
    /// They are those of a motion, scaled: which motion, and the candidate's place among its members.
    Scaled { motion: usize, member: usize },
    /// They were computed and are kept.
    Kept(DMatrix<f64>),
    /// They are computed when they are needed: there is no room for them.
    Computed,
}

/// A GP alternative over the data.
pub struct Structure {
    /// Which alternative it is.
    pub gp_alternative: GpAlternative,
    /// Its features as columns, where they are kept.
    columns: Option<DMatrix<f64>>,
    /// Their products with the design, over all its groups.
    pub sums: Sums,
    /// ln of the prior probability.
    pub log_prior: f64,
}

/// A candidate over the nuisance model of a search, with what is needed to follow it.
pub(super) struct TrackedCandidate {
    pub candidate: usize,
    pub sums: Sums,
    pub projected: Projected,
}

impl<'a> Library<'a> {
    /// Computes the products of all candidates with `design`.
    #[must_use]
    pub fn new(design: &Design, dataset: &'a Dataset, candidates: Arc<Vec<Candidate>>) -> Self {
        let all = vec![true; candidates.len()];
        Self::keeping(MOST_KEPT, design, dataset, candidates, all)
    }

    /// Those of the candidates that are searched, where columns may take so many numbers to be kept.
    fn keeping(
        most_kept: usize,
        design: &Design,
        dataset: &'a Dataset,
        candidates: Arc<Vec<Candidate>>,
        is_searched: Vec<bool>,
    ) -> Self {
        let scaled = design.scaled_motions_of(dataset, &candidates, &|c| is_searched[c]);
        let mut sources: Vec<ColumnSource> = vec![ColumnSource::Computed; candidates.len()];
        for (motion, scaled) in scaled.iter().enumerate() {
            for (member, &c) in scaled.members.iter().enumerate() {
                sources[c] = ColumnSource::Scaled { motion, member };
            }
        }
        let room = most_kept / (dataset.observations.len() * dataset.rows_per_observation).max(1);
        let keep = kept_within(room, &candidates, &|c| {
            is_searched[c] && matches!(sources[c], ColumnSource::Computed)
        });
        let computed = parallel::map(sources.len(), &|c| match sources[c] {
            ColumnSource::Computed if is_searched[c] => {
                let columns = design.columns_of(dataset, &candidates[c]);
                (design.products(&columns), keep[c].then_some(columns))
            }
            _ => (Products::none(), None),
        });
        let mut products = Vec::with_capacity(computed.len());
        for (source, (of_this, kept)) in sources.iter_mut().zip(computed) {
            products.push(of_this);
            if let Some(columns) = kept {
                *source = ColumnSource::Kept(columns);
            }
        }
        for motions in &scaled {
            design.begin_scaled(motions, &mut products);
            design.extend_scaled(motions, &mut products);
        }
        let effects: BTreeSet<EffectKind> = candidates.iter().map(|c| c.kind).collect();
        let family = ((1.0 - NULL_PRIOR - UNEXPLAINED_PRIOR) / effects.len().max(1) as f64).ln();
        let log_prior = candidates.iter().map(|c| family + c.weight.ln()).collect();
        Self {
            dataset,
            listed: Arc::clone(&candidates),
            candidates,
            products,
            log_prior,
            width: design.width(),
            scaled,
            sources,
            gp_alternatives: Vec::new(),
            angles: angles(dataset),
            stops: stop_times(dataset),
            is_searched,
            near_top: NearTop::default(),
        }
    }

    /// What the search over all data has seen near the top, and `chosen`, over another design of the same stations, without GP alternatives
    /// and with few columns kept: for searches over parts of the data. Beside several lines of gears all lines: many are about as likely, and
    /// which of them are taken is a part of what poses held out judge.
    #[must_use]
    pub fn of_near_top(mut self, design: &Design, chosen: &[usize]) -> Self {
        let near_top = std::mem::take(&mut self.near_top);
        let mut is_searched = vec![false; self.candidates.len()];
        let near = near_top.candidates.iter().chain(near_top.pairs.iter().flatten()).chain(chosen);
        for c in near.copied().chain(self.single_offsets()) {
            is_searched[c] = true;
        }
        let is_line = |c: usize| self.candidates[c].kind == EffectKind::GearMesh;
        let has_spectrum = chosen.iter().filter(|&&c| is_line(c)).count() >= SEVERAL_LINES;
        for (c, is_searched) in is_searched.iter_mut().enumerate() {
            *is_searched |= self.all_offsets(c) || has_spectrum && is_line(c);
        }
        let (dataset, candidates) = (self.dataset, Arc::clone(&self.candidates));
        // Before as much is asked for again.
        drop(self);
        Self { near_top, ..Self::keeping(FEW_KEPT, design, dataset, candidates, is_searched) }
    }

    /// Adds `list` of GP alternatives, each with its share of the prior of what no effect explains.
    pub fn add_gp_alternatives(
        &mut self,
        design: &Design,
        list: Vec<WeightedAlternative>,
        columns: &ColumnsOf<'_>,
    ) {
        // Those of a cause in the model cannot be computed again from the dataset alone.
        let small = self.dataset.observations.len() <= MAX_OBSERVATIONS_KEPT;
        let keep = |gp_alternative: GpAlternative| {
            small || matches!(gp_alternative, GpAlternative::TimeVaryingCause(_))
        };
        let more = parallel::map(list.len(), &|at| {
            let WeightedAlternative { gp_alternative, weight } = list[at];
            let columns = columns(gp_alternative);
            if columns.is_empty() {
                return None;
            }
            let sums = design.sums(&columns);
            let log_prior = (UNEXPLAINED_PRIOR * weight).ln();
            Some(Structure {
                gp_alternative,
                columns: keep(gp_alternative).then_some(columns),
                sums,
                log_prior,
            })
        });
        self.gp_alternatives.extend(more.into_iter().flatten());
    }

    /// A candidate's whitened columns.
    pub(super) fn columns_at(&self, design: &Design, candidate: usize) -> Cow<'_, DMatrix<f64>> {
        match &self.sources[candidate] {
            ColumnSource::Scaled { motion, member } => {
                Cow::Owned(self.scaled[*motion].columns(*member, self.dataset.rows_per_observation))
            }
            ColumnSource::Kept(columns) => Cow::Borrowed(columns),
            ColumnSource::Computed => {
                Cow::Owned(design.columns_of(self.dataset, &self.candidates[candidate]))
            }
        }
    }

    /// Puts another variant of the same cause, of as many parameters, in the place of a candidate.
    pub(super) fn put(&mut self, design: &Design, at: usize, candidate: Candidate) {
        self.log_prior[at] += (candidate.weight / self.candidates[at].weight).ln();
        let columns = match &mut self.sources[at] {
            ColumnSource::Scaled { motion, member } => {
                let motions = &mut self.scaled[*motion];
                design.scale_anew(self.dataset, motions, *member, &candidate);
                motions.columns(*member, self.dataset.rows_per_observation)
            }
            ColumnSource::Kept(columns) => {
                *columns = design.columns_of(self.dataset, &candidate);
                columns.clone()
            }
            ColumnSource::Computed => design.columns_of(self.dataset, &candidate),
        };
        self.products[at] = design.products(&columns);
        Arc::make_mut(&mut self.candidates)[at] = candidate;
    }

    /// Gives back the memory of many columns; they are computed again where they are needed.
    pub fn forget_columns(&mut self) {
        let kept = |source: &ColumnSource| match source {
            ColumnSource::Kept(columns) => columns.len(),
            _ => 0,
        };
        if self.sources.iter().map(kept).sum::<usize>() > FEW_KEPT {
            let sources = self.sources.iter_mut().filter(|source| kept(source) > 0);
            sources.for_each(|source| *source = ColumnSource::Computed);
        }
    }

    /// Brings all products up to date with columns appended to `design`.
    pub fn extend(&mut self, design: &Design) {
        if self.width == design.width() {
            return;
        }
        self.width = design.width();
        let (dataset, candidates) = (self.dataset, &self.candidates);
        for motions in &self.scaled {
            design.extend_scaled(motions, &mut self.products);
        }
        let (sources, is_searched) = (&self.sources, &self.is_searched);
        parallel::for_each_mut(&mut self.products, &|c, products| match &sources[c] {
            ColumnSource::Scaled { .. } => {}
            ColumnSource::Kept(columns) => design.extend(products, columns),
            ColumnSource::Computed if !is_searched[c] => {}
            ColumnSource::Computed => design.extend(products, &design.columns_of(dataset, &candidates[c])),
        });
        parallel::for_each_mut(&mut self.gp_alternatives, &|_, s| match &s.columns {
            Some(columns) => design.extend_sums(&mut s.sums, columns),
            None => {
                design.extend_sums(&mut s.sums, &gp_alternative::columns(s.gp_alternative, design, dataset));
            }
        });
    }

    /// Brings the products of `these` candidates up to date, for a trial: [`Self::truncate_these`] has to follow before all others are.
    pub(super) fn extend_these(&mut self, design: &Design, these: &[usize]) {
        for &c in these {
            let mut products = std::mem::replace(&mut self.products[c], Products::none());
            design.extend(&mut products, &self.columns_at(design, c));
            self.products[c] = products;
        }
    }

    /// Takes off what a trial has added to the products of `these` candidates.
    pub(super) fn truncate_these(&mut self, these: &[usize], width: usize) {
        these.iter().for_each(|&c| self.products[c].truncate(width));
    }

    /// Takes off the products with the design's columns from number `width` on.
    pub fn truncate(&mut self, width: usize) {
        self.width = self.width.min(width);
        self.products.iter_mut().for_each(|products| products.truncate(width));
        for structure in &mut self.gp_alternatives {
            let cross = std::mem::replace(&mut structure.sums.cross, DMatrix::zeros(0, 0));
            let width = width.min(cross.ncols());
            structure.sums.cross = cross.resize_horizontally(width, 0.0);
        }
    }

    /// All that are searched over `nuisance`, by their numbers.
    pub(super) fn track(&self, nuisance: &NuisanceModel, subset: &[usize]) -> Vec<TrackedCandidate> {
        let searched: Vec<usize> = (0..self.candidates.len()).filter(|&c| self.is_searched[c]).collect();
        let tracked = parallel::map_chunks(&searched, AT_ONCE, &|_, some| {
            let sums: Vec<Sums> = some.iter().map(|&c| self.products[c].sum(subset)).collect();
            let projected = nuisance.project_together(&sums.iter().collect::<Vec<_>>());
            let of_one = |((&candidate, sums), projected)| TrackedCandidate { candidate, sums, projected };
            some.iter().zip(sums).zip(projected).map(of_one).collect::<Vec<_>>()
        });
        tracked.into_iter().flatten().collect()
    }

    /// Puts tracked candidates over another nuisance model.
    pub(super) fn project_anew(
        &self,
        nuisance: &NuisanceModel,
        subset: &[usize],
        mut tracked: Vec<&mut TrackedCandidate>,
    ) {
        for one in &mut tracked {
            self.products[one.candidate].sum_more(subset, &mut one.sums);
        }
        let projected = nuisance.project_together(&tracked.iter().map(|one| &one.sums).collect::<Vec<_>>());
        for (one, projected) in tracked.into_iter().zip(projected) {
            one.projected = projected;
        }
    }

    /// Brings the tracked candidates up to date with a nuisance model that has grown.
    pub(super) fn update_tracked(
        &self,
        nuisance: &NuisanceModel,
        subset: &[usize],
        tracked: &mut [TrackedCandidate],
    ) {
        parallel::for_each_mut(tracked, &|_, f| {
            self.products[f.candidate].sum_more(subset, &mut f.sums);
            nuisance.update(&mut f.projected, &f.sums);
        });
    }
}

/// Which of the `candidates` that are `computed` are kept, the first that so many columns hold.
fn kept_within(mut room: usize, candidates: &[Candidate], is_computed: &dyn Fn(usize) -> bool) -> Vec<bool> {
    let fits = |(c, candidate): (usize, &Candidate)| {
        let fits = is_computed(c) && candidate.prior_sigma.len() <= room;
        room -= if fits { candidate.prior_sigma.len() } else { 0 };
        fits
    };
    candidates.iter().enumerate().map(fits).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::{Twist, evenly_spread};
    use crate::design::Whitening;

    /// Twelve places: of the 24 at which a bump is looked for half are not there, and the others are looked at.
    #[test]
    fn an_alternative_that_the_data_cannot_show_is_left_out() {
        let dataset = evenly_spread(12);
        let whitening = Whitening::independent(vec![1.0; 12], 0.2);
        let design = Design::of_all(&dataset, &[Twist([1e-4; 6]); 12], 1, whitening);
        let mut library = Library::new(&design, &dataset, Arc::default());
        let list = gp_alternative::gp_alternatives(dataset.joints());
        let bumps = |of: &mut dyn Iterator<Item = GpAlternative>| {
            of.filter(|alternative| matches!(alternative, GpAlternative::LocalBump(..))).count()
        };
        assert_eq!(bumps(&mut list.iter().map(|one| one.gp_alternative)), 72);
        library.add_gp_alternatives(&design, list, &|one| gp_alternative::columns(one, &design, &dataset));
        assert_eq!(bumps(&mut library.gp_alternatives.iter().map(|one| one.gp_alternative)), 36);
        assert!(library.gp_alternatives.iter().all(|one| one.sums.cross.ncols() == design.width()));
    }
}
