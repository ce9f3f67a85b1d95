//! The best model of the data: search for causes and estimation of the noise in turn, until both stand still.
//!
//! Knows the search as one call, and nothing of verdicts.

use super::model::{FittedModel, Model, Workspace};
use super::outlier_history::OutlierHistory;
use inference::dataset::{Dataset, Twist};
use inference::design::{Design, SharedError, VisitScatter, Whitening};
use inference::effects::Candidate;
use inference::evidence::NuisanceModel;
use inference::linear_fit::solve;
use inference::linearise::{Linearised, shift_m, turn_rad};
use inference::marginal::NoisePrior;
use inference::robust_weights::{FALSE_SIGMAS, RobustWeights};
use inference::search::{ChosenCause, Library, NearTop, cause_columns};
use inference::slow_noise::{self, SlowNoise};
use inference::time_course::TimeCourse;
use statistics::{ALARM_NATS, upper_median};
use std::collections::BTreeMap;
use std::sync::Arc;

const ROUNDS: usize = 4;
/// Rounds at most, where steps turn out to rest on false readings.
const MOST_ROUNDS: usize = 6;
/// Rounds of weights before any cause is looked for.
const START_ROUNDS: usize = 2;
/// A step that needs no more stations than these cannot be told from as many false readings.
const FEW: usize = 3;
/// Pose-to-pose scatter over scatter of repeats, squared, assumed at first.
const INITIAL_VARIANCE_RATIO: f64 = 0.5;
/// Distance at which an orientation error counts as the position error beside it, where no orientation is measured, metres.
const USUAL_LENGTH_M: f64 = 0.2;

/// What the search is over.
#[derive(Clone, Copy)]
pub(super) struct SearchProblem<'a> {
    /// The arm at every station, with its residuals.
    pub linear: &'a Linearised,
    /// Variants of effects that may be causes.
    pub candidates: &'a [Candidate],
    /// What is known of the noise before the fit.
    pub noise: NoisePrior,
    /// Number of targets on the tool.
    pub targets: usize,
}

/// Searches: without slow noise at first and, where what is constant leaves some, with it; the likelier of both answers stands. Steps
/// can be had in the place of what only wanders, and the other way round.
#[must_use]
pub(super) fn best_model<'a>(problem: &SearchProblem<'a>) -> FittedModel<'a> {
    let start = NoiseEstimates::of_bare_data(problem);
    let plain = beside_shared(problem, NoiseEstimates { slow: None, ..start.clone() });
    let in_time = |c: &ChosenCause| problem.candidates[c.candidate].effect().time() != TimeCourse::Constant;
    let constant: Vec<ChosenCause> = plain.model.chosen.iter().filter(|c| !in_time(c)).cloned().collect();
    if constant.len() == plain.model.chosen.len() {
        return plain;
    }
    // A large cause hides in the bare data what is slow beside it.
    let beside =
        slow_noise::likeliest(&plain.workspace.design, &problem.linear.dataset, &constant, problem.noise);
    let slow = if constant.is_empty() { start.slow } else { beside.or(start.slow) };
    if slow.is_none() {
        return plain;
    }
    let start = NoiseEstimates { slow, ..start };
    let plain_odds = plain.log_odds();
    let plain = WithoutLibrary::of(plain);
    let wandering = beside_shared(problem, start);
    if wandering.model.slow.is_some() && wandering.log_odds() > plain_odds {
        return wandering;
    }
    drop(wandering);
    plain.with_library()
}

/// A search's result while another runs: candidates' columns take hundreds of megabytes in a large set, those of one search at a time.
struct WithoutLibrary<'a> {
    linear: &'a Linearised,
    model: Model,
    design: Design,
    candidates: Arc<Vec<Candidate>>,
    near_top: NearTop,
    column_index: BTreeMap<usize, Vec<usize>>,
}

impl<'a> WithoutLibrary<'a> {
    fn of(fitted: FittedModel<'a>) -> Self {
        let FittedModel { linear, model, workspace: Workspace { design, library, column_index } } = fitted;
        let Library { candidates, near_top, .. } = library;
        Self { linear, model, design, candidates, near_top, column_index }
    }

    fn with_library(self) -> FittedModel<'a> {
        let Self { linear, model, design, candidates, near_top, column_index } = self;
        let mut library = Library::new(&design, &linear.dataset, candidates);
        library.near_top = near_top;
        FittedModel { linear, model, workspace: Workspace { design, library, column_index } }
    }
}

/// Searches from `start`, in which the targets of a visit share nothing: what they share is what causes leave. Where they do, causes may
/// have taken that for theirs before it was known: the search begins anew from all that the bare data let them share, and the
/// likelier of both answers stands.
fn beside_shared<'a>(problem: &SearchProblem<'a>, start: NoiseEstimates) -> FittedModel<'a> {
    let shared = start.bare_shared;
    let plain = settled(problem, start.clone());
    if shared == SharedError::default() || plain.model.chosen.is_empty() {
        return plain;
    }
    let evidence = plain.log_evidence();
    let plain = WithoutLibrary::of(plain);
    let sharing = settled(problem, NoiseEstimates { shared, ..start });
    if sharing.log_evidence() > evidence {
        return sharing;
    }
    drop(sharing);
    plain.with_library()
}

/// What one round takes for the noise; the next takes what this one's residuals say of it.
#[derive(Clone)]
struct NoiseEstimates {
    /// Pose-to-pose variance that neither repeats show nor visits share, over that of repeats.
    variance_ratio: f64,
    /// Distance at which an orientation error counts as the position error beside it, metres.
    characteristic_length_m: f64,
    /// Stations that do not go with the model.
    robust: RobustWeights,
    /// Noise that is the same for neighbouring rows.
    slow: Option<SlowNoise>,
    /// What the targets of a visit share.
    shared: SharedError,
    /// The most that they may share: what registration and geometry leave, with all that is wrong with the arm.
    bare_shared: SharedError,
    /// What is known of the rest.
    known: NoisePrior,
}

impl NoiseEstimates {
    /// About registration and geometry alone.
    fn of_bare_data(problem: &SearchProblem<'_>) -> Self {
        let SearchProblem { linear, noise, targets, .. } = *problem;
        let dataset = &linear.dataset;
        let mut start = Self {
            variance_ratio: INITIAL_VARIANCE_RATIO,
            characteristic_length_m: characteristic_length_m(linear, &linear.residuals)
                .unwrap_or(USUAL_LENGTH_M),
            robust: RobustWeights::at_first(linear),
            slow: None,
            // Beside what no cause explains yet it would be all that is wrong with the arm: it is judged by what causes leave.
            shared: SharedError::default(),
            bare_shared: SharedError::default(),
            known: noise,
        };
        let base_weights = start.base_weights(dataset);
        for round in 1..=START_ROUNDS {
            let weights = start.weights(&base_weights);
            let whitening = Whitening::independent(weights, start.characteristic_length_m);
            let design = Design::of_all(dataset, &linear.residuals, targets, whitening);
            let groups = design.all_groups();
            let ratio = NuisanceModel::new(&design, &groups, &[], noise).null().geometry_ratio;
            let fit = solve(&design, &groups, &[], Some(ratio));
            let residuals = design.residuals(&fit.coefficients);
            start.robust = RobustWeights::of(linear, &residuals, &base_weights);
            if round == START_ROUNDS {
                let by_repeats = Whitening::independent(base_weights.clone(), start.characteristic_length_m);
                let visits = VisitScatter::of(dataset, &by_repeats, &residuals, &start.robust.outliers);
                (start.known, start.bare_shared) = beside_visits(noise, visits, dataset, &base_weights, 1.0);
                start.slow = slow_noise::likeliest(&design, dataset, &[], start.known);
            }
        }
        start
    }

    /// Weight of each station by the number of its repeats.
    fn base_weights(&self, dataset: &Dataset) -> Vec<f64> {
        let ratio = self.variance_ratio;
        dataset.observations.iter().map(|s| (ratio + 1.0) / (ratio + 1.0 / s.repeats as f64)).collect()
    }

    fn weights(&self, base_weights: &[f64]) -> Vec<f64> {
        base_weights.iter().zip(&self.robust.weights).map(|(a, b)| a * b).collect()
    }

    /// Whether another round would hardly find anything else. Once there, slow noise settles its size with the causes; coming or
    /// going asks for another round.
    fn agrees_with(&self, other: &Self, dataset: &Dataset) -> bool {
        let near = |one: f64, other: f64| (one - other).abs() < 0.2 * (other + 0.1);
        let lengths = self.characteristic_length_m / other.characteristic_length_m;
        self.robust.outliers == other.robust.outliers
            && self.slow.is_some() == other.slow.is_some()
            && near(self.variance_ratio, other.variance_ratio)
            && near(self.shared.at_targets(dataset), other.shared.at_targets(dataset))
            && lengths.ln().abs() < 0.15
    }
}

/// Searches and weighs in turn from `start` until both stand still.
fn settled<'a>(problem: &SearchProblem<'a>, start: NoiseEstimates) -> FittedModel<'a> {
    let dataset = &problem.linear.dataset;
    let mut assumed = start;
    let mut history = OutlierHistory::new(dataset.observations.len());
    let mut round = 0;
    loop {
        let fitted = searched(problem, &assumed);
        let carried = steps_of_few(&fitted);
        let seen = seen_in(&fitted, &assumed, &carried, &mut history);
        round += 1;
        let unsettled = !carried.is_empty() || seen.slow.is_some() != assumed.slow.is_some();
        let is_last = round >= ROUNDS && !unsettled || round == MOST_ROUNDS;
        if is_last || seen.agrees_with(&assumed, dataset) {
            return fitted;
        }
        assumed = seen;
    }
}

/// The search for causes under one estimate of the noise.
fn searched<'a>(problem: &SearchProblem<'a>, assumed: &NoiseEstimates) -> FittedModel<'a> {
    let SearchProblem { linear, candidates, targets, .. } = *problem;
    let (dataset, noise) = (&linear.dataset, assumed.known);
    let base_weights = assumed.base_weights(dataset);
    let whitening = Whitening {
        weights: assumed.weights(&base_weights),
        characteristic_length_m: assumed.characteristic_length_m,
        shared: assumed.shared,
    };
    let mut design = Design::of_all(dataset, &linear.residuals, targets, whitening);
    if let Some(slow) = assumed.slow {
        slow.put(&mut design, dataset);
    }
    let mut library = Library::new(&design, dataset, Arc::new(candidates.to_vec()));
    let groups = design.all_groups();
    let mut column_index = BTreeMap::new();
    let chosen = library.search(&mut design, &groups, noise, &mut column_index, ALARM_NATS, &[]);
    let peak = NuisanceModel::new(&design, &groups, &cause_columns(&chosen, None), noise).null();
    let fit = solve(&design, &groups, &chosen, Some(peak.geometry_ratio));
    let model = Model {
        residuals: design.residuals(&fit.coefficients),
        chosen,
        targets,
        noise,
        given: problem.noise,
        base_weights,
        outliers: assumed.robust.outliers.clone(),
        peak,
        slow: assumed.slow,
        shared_ratio: assumed.shared.at_targets(dataset),
    };
    FittedModel { linear, model, workspace: Workspace { design, library, column_index } }
}

/// What a model's residuals say of the noise, where `assumed` was taken for it; the stations that are `carried` by a step are false.
fn seen_in(
    fitted: &FittedModel<'_>,
    assumed: &NoiseEstimates,
    carried: &[CarriedStation],
    history: &mut OutlierHistory,
) -> NoiseEstimates {
    let FittedModel { linear, model, workspace } = fitted;
    let dataset = &linear.dataset;
    let robust = RobustWeights::of(linear, &model.residuals, &model.base_weights);
    let mut robust = history.settled(&assumed.robust, robust);
    for station in carried {
        (robust.weights[station.index], robust.outliers[station.index]) = (station.weight, true);
    }
    // Where poses are repeated a row of weight 1 scatters by `variance_ratio` + 1 times what repeats do.
    let is_repeated = dataset.observations.iter().any(|station| station.repeats > 1);
    let of_a_row = if is_repeated { assumed.variance_ratio + 1.0 } else { 1.0 };
    let by_repeats = Whitening::independent(model.base_weights.clone(), assumed.characteristic_length_m);
    let visits = VisitScatter::of(dataset, &by_repeats, &model.residuals, &robust.outliers);
    let (known, shared) = beside_visits(model.given, visits, dataset, &model.base_weights, of_a_row);
    let shared_variance = shared.at_targets(dataset) * of_a_row;
    NoiseEstimates {
        variance_ratio: pose_variance_ratio(linear, model, &robust.outliers, shared_variance)
            .unwrap_or(assumed.variance_ratio),
        characteristic_length_m: characteristic_length_m(linear, &model.residuals)
            .unwrap_or(assumed.characteristic_length_m),
        robust,
        slow: slow_noise::likeliest(&workspace.design, dataset, &model.chosen, model.noise),
        shared,
        bare_shared: assumed.bare_shared,
        known,
    }
}

/// `noise` with what `visits` show of the instrument's own, and what the targets of a visit share beside it. A row of weight 1 scatters by
/// `of_a_row` times what is known, as variances.
fn beside_visits(
    noise: NoisePrior,
    visits: Option<VisitScatter>,
    dataset: &Dataset,
    base_weights: &[f64],
    of_a_row: f64,
) -> (NoisePrior, SharedError) {
    let Some(visits) = visits else { return (noise, SharedError::default()) };
    let known = noise.beside_visits(visits.own_m2 / of_reading(dataset, base_weights), visits.freedom);
    // What was known holds from below, unless the visits have just corrected it.
    let least_m2 =
        known.known.filter(|_| known == noise).map_or(0.0, |known| known.sigma_m.powi(2) * of_a_row);
    (known, visits.shared(least_m2))
}

/// Variance of a row of weight 1 over that of a reading, where nothing but the readings' noise is in it.
fn of_reading(dataset: &Dataset, base_weights: &[f64]) -> f64 {
    let stations = dataset.observations.iter().zip(base_weights);
    let sum: f64 = stations.map(|(station, weight)| weight / station.repeats as f64).sum();
    sum / dataset.observations.len().max(1) as f64
}

/// Distance at which an orientation error looks like the position error beside it, metres; `None` where no orientation is measured.
fn characteristic_length_m(linear: &Linearised, residuals: &[Twist]) -> Option<f64> {
    if linear.dataset.rows_per_observation < 6 {
        return None;
    }
    let mut place: Vec<f64> = residuals.iter().map(shift_m).collect();
    let mut turn: Vec<f64> = residuals.iter().map(turn_rad).collect();
    let [place_m, turn_rad] = [&mut place, &mut turn].map(|all| upper_median(all).unwrap_or(0.0));
    let ratio = place_m / turn_rad.max(1e-12);
    Some(ratio.clamp(1e-3, 10.0))
}

/// A station that is far off without a step, which gains nothing but with it and its like.
struct CarriedStation {
    index: usize,
    /// The robust weight that it is then worth.
    weight: f64,
}

/// Stations that are far off without a step of base or target, where the step gains nothing but with them: false readings
/// side by side in time, which it would take along.
fn steps_of_few(fitted: &FittedModel<'_>) -> Vec<CarriedStation> {
    let FittedModel { model, workspace, .. } = fitted;
    let (design, chosen) = (&workspace.design, &model.chosen);
    let groups = design.all_groups();
    let noise_m = model.peak.sigma_m * (1.0 + model.shared_ratio).sqrt();
    let squares = |residuals: &[Twist], i: usize| model.base_weights[i] * shift_m(&residuals[i]).powi(2);
    let mut carried = Vec::new();
    let steps = |c: &ChosenCause| workspace.library.candidates[c.candidate].variant.t0_min().is_some();
    for (k, _) in chosen.iter().enumerate().filter(|(_, c)| steps(c)) {
        let others: Vec<ChosenCause> =
            chosen.iter().enumerate().filter(|(other, _)| *other != k).map(|(_, c)| c.clone()).collect();
        let fit = solve(design, &groups, &others, Some(model.peak.geometry_ratio));
        let without = design.residuals(&fit.coefficients);
        let gain = |i: usize| (squares(&without, i) - squares(&model.residuals, i)) / (2.0 * noise_m.powi(2));
        let mut gains: Vec<(usize, f64)> = (0..without.len()).map(|i| (i, gain(i))).collect();
        sorting::by(&mut gains, |a, b| b.1.total_cmp(&a.1));
        let (few, rest) = gains.split_at(FEW.min(gains.len()));
        let [few_nats, rest_nats] = [few, rest].map(|part| part.iter().map(|(_, gain)| gain).sum::<f64>());
        if few_nats < ALARM_NATS || rest_nats >= ALARM_NATS {
            continue;
        }
        let limit_m = FALSE_SIGMAS * noise_m;
        carried.extend(few.iter().filter_map(|&(index, _)| {
            let far_m = squares(&without, index).sqrt();
            (far_m > limit_m).then(|| CarriedStation { index, weight: (limit_m / far_m).powi(4) })
        }));
    }
    carried
}

/// Pose-to-pose variance that neither repeats show nor visits share, over that of repeats, the `shared` one given; `None` where too
/// few poses are repeated.
fn pose_variance_ratio(linear: &Linearised, model: &Model, outliers: &[bool], shared: f64) -> Option<f64> {
    let sigma_m = model.noise.known?.sigma_m;
    let repeated: Vec<(f64, f64)> = linear
        .dataset
        .observations
        .iter()
        .zip(&model.residuals)
        .zip(outliers)
        .filter(|((s, _), out)| s.repeats > 1 && !**out)
        .map(|((s, m), _)| (shift_m(m).powi(2) / s.rows(3) as f64, 1.0 / s.repeats as f64))
        .collect();
    if repeated.len() < 5 {
        return None;
    }
    let n = repeated.len() as f64;
    let seen = repeated.iter().map(|r| r.0).sum::<f64>() / n;
    let expected = repeated.iter().map(|r| r.1).sum::<f64>() / n;
    Some((seen / (sigma_m * sigma_m) - expected - shared).clamp(0.0, 30.0))
}
