//! What the search looks at: candidates with their products, and kernels.

use super::{NULL_PRIOR, UNEXPLAINED_PRIOR};
use crate::diagnose::design::{Design, Products, Sums, Turning};
use crate::diagnose::effects::Candidate;
use crate::diagnose::evidence::{Background, Projected};
use crate::diagnose::kernel::{self, Kernel};
use crate::diagnose::scene::Scene;
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Numbers that the columns of all candidates may take to be kept: 320 MB.
const MOST_KEPT: usize = 40_000_000;
/// Features of kernels are kept for no more stations than this: 80 MB.
const MOST_SITES_KEPT: usize = 1000;
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
    /// Its features as columns, where they are kept.
    columns: Option<Columns>,
    /// Their products with the design, over all its atoms.
    pub sums: Sums,
    /// ln prior.
    pub log_prior: f64,
}

/// A candidate over the background of a search, with what is needed to follow it.
pub(super) struct Follower {
    pub candidate: usize,
    pub sums: Sums,
    pub projected: Projected,
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
        let mut room = MOST_KEPT / (scene.sites.len() * scene.rows_per_site).max(1);
        let keep: Vec<bool> = candidates
            .iter()
            .zip(&many)
            .map(|(c, many)| {
                let fits = !many && c.usual.len() <= room;
                room -= if fits { c.usual.len() } else { 0 };
                fits
            })
            .collect();
        let (mut products, columns): (Vec<Products>, Vec<Option<Columns>>) = (0..candidates.len())
            .into_par_iter()
            .map(|c| {
                if many[c] {
                    return (Products::none(), None);
                }
                let columns = single(c);
                (design.products(&columns), keep[c].then_some(columns))
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
        // Those of a cause in the model cannot be computed again from the scene alone.
        let small = self.scene.sites.len() <= MOST_SITES_KEPT;
        let keep = |kernel: Kernel| small || matches!(kernel, Kernel::Varying(_));
        let more: Vec<Structure> = list
            .into_par_iter()
            .map(|(kernel, weight)| {
                let columns = columns(kernel);
                let sums = design.sums(&columns);
                let log_prior = (UNEXPLAINED_PRIOR * weight).ln();
                Structure { kernel, columns: keep(kernel).then_some(columns), sums, log_prior }
            })
            .filter(|structure| !structure.sums.own.is_empty())
            .collect();
        self.kernels.extend(more);
    }

    /// Gives back the memory of many columns; they are computed again where they are needed.
    pub fn forget_columns(&mut self) {
        let kept: usize = self.columns.iter().flatten().flatten().map(Vec::len).sum();
        if kept > MOST_KEPT / 4 {
            self.columns.iter_mut().for_each(|columns| *columns = None);
        }
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
        self.kernels.par_iter_mut().for_each(|s| match &s.columns {
            Some(columns) => design.extend_sums(&mut s.sums, columns),
            None => design.extend_sums(&mut s.sums, &kernel::columns(s.kernel, design, scene)),
        });
    }

    /// All candidates over `background`.
    pub(super) fn follow(&self, background: &Background, subset: &[usize]) -> Vec<Follower> {
        (0..self.candidates.len())
            .into_par_iter()
            .map(|candidate| {
                let sums = self.products[candidate].sum(subset);
                let projected = background.project(&sums);
                Follower { candidate, sums, projected }
            })
            .collect()
    }

    /// Brings the followers up to date with a background that has grown.
    pub(super) fn catch_up(&self, background: &Background, subset: &[usize], followers: &mut [Follower]) {
        followers.par_iter_mut().for_each(|f| {
            self.products[f.candidate].sum_more(subset, &mut f.sums);
            background.update(&mut f.projected, &f.sums);
        });
    }
}
