//! The best model with what it was fitted to: what a diagnosis judges; knows nothing of how it was found.

use inference::dataset::{Dataset, Twist};
use inference::design::{Design, SlowColumns};
use inference::evidence::{EvidencePeak, NuisanceModel};
use inference::linear_fit::{LinearFit, solve};
use inference::linearise::Linearised;
use inference::marginal::NoisePrior;
use inference::search::{ChosenCause, Library, NULL_PRIOR};
use inference::slow_noise::SlowNoise;
use std::collections::BTreeMap;

/// The best model, constant once it is built.
pub(super) struct Model {
    /// Causes in the model.
    pub chosen: Vec<ChosenCause>,
    /// Number of targets on the tool.
    pub targets: usize,
    /// What was known of the noise before the fit.
    pub noise: NoisePrior,
    /// Weight of each station by the number of its repeats.
    pub base_weights: Vec<f64>,
    /// Stations set aside as false.
    pub outliers: Vec<bool>,
    /// Residuals of the best model, metres and radians in base axes.
    pub residuals: Vec<Twist>,
    /// Evidence of the best model's nuisance parameters.
    pub peak: EvidencePeak,
    /// Noise that is the same for neighbouring rows.
    pub slow: Option<SlowNoise>,
    /// What was known of the noise before any fit; `noise` beside it has what visits show of the instrument's own.
    pub given: NoisePrior,
    /// Variance of what the targets of a visit share, at one coordinate of a target, over the noise's.
    pub shared_ratio: f64,
}

impl Model {
    /// Standard deviation of one coordinate about the model, all noise together, metres.
    #[must_use]
    pub(super) fn noise_m(&self) -> f64 {
        let slow = self.slow.map_or(0.0, |slow| slow.size);
        self.peak.sigma_m * (1.0 + slow * slow + self.shared_ratio).sqrt()
    }

    /// Variance of the mean of a visit's targets, over that of as many independent rows: 1 where nothing is shared.
    #[must_use]
    pub(super) fn visit_spread(&self, dataset: &Dataset) -> f64 {
        let weight = |visit: &Vec<usize>| visit.iter().map(|&i| self.base_weights[i]).sum::<f64>();
        let weights: f64 = dataset.visits.iter().map(weight).sum();
        1.0 + self.shared_ratio * weights / dataset.visits.len().max(1) as f64
    }
}

/// What is computed anew while a model is judged and held-out parts are fitted: columns and their products. It grows by
/// every candidate that is tried, and what it holds never changes the answer.
pub(super) struct Workspace<'a> {
    /// The whitened columns and their products.
    pub design: Design,
    /// Candidates with their products with the design.
    pub library: Library<'a>,
    /// Where each candidate's columns stand in the design.
    pub column_index: BTreeMap<usize, Vec<usize>>,
}

impl Workspace<'_> {
    /// Takes back what was tried since the design had so many columns: thousands of products for each of them are of no more use.
    pub(super) fn truncate(&mut self, width: usize) {
        self.design.truncate(width);
        self.library.truncate(width);
        self.column_index.retain(|_, columns| columns.iter().all(|&column| column < width));
    }
}

/// The best model, the residuals that it was fitted to, and the columns that it is judged by.
pub(super) struct FittedModel<'a> {
    /// The arm at every station, with residuals that are linear in all parameters.
    pub linear: &'a Linearised,
    /// What the search has found.
    pub model: Model,
    /// Columns and products, which grow while the model is judged.
    pub workspace: Workspace<'a>,
}

/// Prior odds of slow noise that repeats do not show.
const SLOW_PRIOR: f64 = 0.1;

impl FittedModel<'_> {
    /// The same with products for each group of stations, `group_of` the group of each: a model is found and judged over all stations at once,
    /// without these, which are most of what there is to compute and to keep.
    #[must_use]
    pub(super) fn over_groups(self, group_of: &[usize]) -> Self {
        let Self { linear, mut model, workspace: Workspace { design, library, .. } } = self;
        let dataset = &linear.dataset;
        let whitening = design.whitening().clone();
        drop(design);
        let mut design = Design::new(dataset, &linear.residuals, model.targets, whitening, group_of);
        if let Some(slow) = model.slow {
            slow.put(&mut design, dataset);
        }
        design.expect(model.chosen.iter().map(|cause| cause.columns.len()).sum());
        let chosen: Vec<usize> = model.chosen.iter().map(|cause| cause.candidate).collect();
        let mut library = library.of_near_top(&design, &chosen);
        // Columns of what else was tried over all stations are not carried along: products of all that is searched with them would take more
        // memory than all the rest, and trying them again where a part of the stations asks for it takes no longer.
        let mut column_index = BTreeMap::new();
        library.columns_in_design(&mut design, &mut column_index, &chosen);
        library.extend(&design);
        for cause in &mut model.chosen {
            cause.columns.clone_from(&column_index[&cause.candidate]);
        }
        Self { linear, model, workspace: Workspace { design, library, column_index } }
    }

    /// Registration, geometry and `chosen` fitted to all stations, with the slow noise beside them.
    #[must_use]
    pub(super) fn fit(&self, chosen: &[ChosenCause]) -> LinearFit {
        let Self { model, workspace: Workspace { design, .. }, .. } = self;
        solve(design, &design.all_groups(), chosen, Some(model.peak.geometry_ratio))
    }

    /// What registration, geometry and `chosen` leave at each station, with all that is slow.
    #[must_use]
    pub(super) fn residuals_beside(&self, chosen: &[ChosenCause]) -> Vec<Twist> {
        let design = &self.workspace.design;
        design.residuals(&self.fit(chosen).without_slow(design).coefficients)
    }

    /// ln odds of all that the model holds over nothing, one after the other.
    #[must_use]
    pub(super) fn log_odds(&self) -> f64 {
        let Self { model, workspace, .. } = self;
        let design = &workspace.design;
        let groups = design.all_groups();
        let beside = |slow: SlowColumns| NuisanceModel::with_slow(design, &groups, &[], model.noise, slow);
        let mut nuisance = beside(if model.slow.is_some() { design.slow() } else { SlowColumns::default() });
        let mut odds = 0.0;
        if model.slow.is_some() {
            let nothing = beside(SlowColumns::default()).null().log_evidence;
            odds += nuisance.null().log_evidence - nothing + SLOW_PRIOR.ln();
        }
        for one in &model.chosen {
            let gain = workspace.library.gain(&nuisance, &groups, one.candidate);
            odds += gain + workspace.library.log_prior[one.candidate] - NULL_PRIOR.ln();
            nuisance.grow(design, &groups, &one.columns);
        }
        odds
    }

    /// ln evidence of the data, but for what is the same whatever is taken for their noise.
    #[must_use]
    pub(super) fn log_evidence(&self) -> f64 {
        let design = &self.workspace.design;
        let nothing = NuisanceModel::with_slow(
            design,
            &design.all_groups(),
            &[],
            self.model.noise,
            SlowColumns::default(),
        );
        nothing.null().log_evidence + self.log_odds() + design.log_determinant()
    }
}
