//! The best model: weights round it, search over it, until both stand still.

use super::dataset::{Dataset, Twist};
use super::design::{Design, SharedError, Whitening};
use super::effects::Candidate;
use super::evidence::{EvidencePeak, NuisanceModel};
use super::linearise::{Linearised, shift_m};
use super::marginal::NoisePrior;
use super::search::{ALARM_NATS, ChosenCause, Library, NULL_PRIOR, cause_columns};
use super::set_aside::SetAside;
use super::slow_noise::{self, SlowNoise};
use super::time_course::TimeCourse;
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;
use std::ops::Range;

const ROUNDS: usize = 4;
/// Rounds at most, where steps turn out to rest on false readings.
const MOST_ROUNDS: usize = 6;
/// Rounds of weights before any cause is looked for.
const START_ROUNDS: usize = 2;
/// A station further than this many sigmas from the model, and alone there, is false.
const FALSE_SIGMAS: f64 = 4.5;
/// A step that needs no more stations than these cannot be told from as many false readings.
const FEW: usize = 3;
/// Pose-to-pose scatter over scatter of repeats, squared, assumed at first.
const INITIAL_VARIANCE_RATIO: f64 = 0.5;

/// The best model, constant once it is built.
pub struct Model {
    /// Causes in the model.
    pub chosen: Vec<ChosenCause>,
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
    /// Variance of what the targets of a visit share, at one coordinate of a target, over the noise's.
    pub shared_ratio: f64,
}

impl Model {
    /// Standard deviation of one coordinate about the model, all noise together, metres.
    #[must_use]
    pub fn noise_m(&self) -> f64 {
        let slow = self.slow.map_or(0.0, |slow| slow.size);
        self.peak.sigma_m * (1.0 + slow * slow + self.shared_ratio).sqrt()
    }

    /// Variance of the mean of a visit's targets, over that of as many independent rows: 1 where nothing is shared.
    #[must_use]
    pub fn visit_spread(&self, dataset: &Dataset) -> f64 {
        let weight = |visit: &Vec<usize>| visit.iter().map(|&i| self.base_weights[i]).sum::<f64>();
        let weights: f64 = dataset.visits.iter().map(weight).sum();
        1.0 + self.shared_ratio * weights / dataset.visits.len().max(1) as f64
    }
}

/// What is computed anew while a model is judged and held-out parts are fitted: columns and their products. It grows by
/// every candidate that is tried, and what it holds never changes the answer.
pub struct Workspace<'a> {
    /// The whitened columns and their products.
    pub design: Design,
    /// Candidates with their products with the design.
    pub library: Library<'a>,
    /// Where each candidate's columns stand in the design.
    pub column_index: BTreeMap<usize, Vec<usize>>,
}

impl Workspace<'_> {
    /// Takes back what was tried since the design had so many columns: thousands of products for each of them are of no more use.
    pub fn truncate(&mut self, width: usize) {
        self.design.truncate(width);
        self.library.truncate(width);
        self.column_index.retain(|_, columns| columns.iter().all(|&column| column < width));
    }
}

/// Searches over `linear` with `candidates`: without slow noise at first and, where the bare data have some, with it; the
/// likelier of both answers stands. Steps can be had in the place of what only wanders, and the other way round.
#[must_use]
pub fn build<'a>(
    linear: &'a Linearised,
    candidates: &'a [Candidate],
    noise: NoisePrior,
    targets: usize,
    group_of: &[usize],
) -> (Model, Workspace<'a>) {
    let start = Start::new(linear, noise, targets, group_of);
    let wanders = start.slow.is_some();
    let plain = settled(linear, candidates, noise, targets, group_of, Start { slow: None, ..start.clone() });
    let in_time = |c: &ChosenCause| candidates[c.candidate].effect().time() != TimeCourse::Constant;
    if !wanders || !plain.0.chosen.iter().any(in_time) {
        return plain;
    }
    let (plain, workspace) = plain;
    let plain_odds = odds_of(&plain, &workspace);
    // Products take hundreds of megabytes in a large set: those of one search at a time.
    let Workspace { design, library, column_index } = workspace;
    let near_pairs = library.into_near_pairs();
    let (wandering, workspace) = settled(linear, candidates, noise, targets, group_of, start);
    if wandering.slow.is_some() && odds_of(&wandering, &workspace) > plain_odds {
        return (wandering, workspace);
    }
    drop(workspace);
    let library = Library::new(&design, &linear.dataset, candidates).with_near_pairs(near_pairs);
    (plain, Workspace { design, library, column_index })
}

/// Where a search begins.
#[derive(Clone)]
struct Start {
    variance_ratio: f64,
    arm_m: f64,
    robust: Vec<f64>,
    outliers: Vec<bool>,
    /// Slow noise of the bare data.
    slow: Option<SlowNoise>,
}

impl Start {
    /// Weights about registration and geometry alone.
    fn new(linear: &Linearised, noise: NoisePrior, targets: usize, group_of: &[usize]) -> Self {
        let dataset = &linear.dataset;
        let (variance_ratio, arm_m) = (INITIAL_VARIANCE_RATIO, first_arm_m(linear));
        let base_weights: Vec<f64> = dataset
            .observations
            .iter()
            .map(|s| (variance_ratio + 1.0) / (variance_ratio + 1.0 / s.repeats as f64))
            .collect();
        let mut start = Self {
            variance_ratio,
            arm_m,
            robust: vec![1.0; dataset.observations.len()],
            outliers: vec![false; dataset.observations.len()],
            slow: None,
        };
        for _ in 0..START_ROUNDS {
            let weights = base_weights.iter().zip(&start.robust).map(|(a, b)| a * b).collect();
            let whitening = Whitening::independent(weights, arm_m);
            let design = Design::new(dataset, &linear.residuals, targets, whitening, group_of);
            let all_groups: Vec<usize> = (0..design.groups()).collect();
            let ratio = NuisanceModel::new(&design, &all_groups, &[], noise).null().geometry_ratio;
            let fit = solve(&design, &all_groups, &[], Some(ratio));
            (start.robust, start.outliers) =
                robust_weights(linear, &design.residuals(&fit.coefficients), &base_weights);
            start.slow = slow_noise::likeliest(&design, dataset, &[], noise);
        }
        start
    }
}

/// Prior odds of slow noise that repeats do not show.
const SLOW_PRIOR: f64 = 0.1;

/// ln odds of all that a model holds over nothing, one after the other.
#[must_use]
pub fn odds_of(model: &Model, workspace: &Workspace<'_>) -> f64 {
    let design = &workspace.design;
    let groups: Vec<usize> = (0..design.groups()).collect();
    let beside =
        |slow: (Range<usize>, f64)| NuisanceModel::with_slow(design, &groups, &[], model.noise, slow);
    let slow = if model.slow.is_some() { design.slow() } else { (0..0, 0.0) };
    let mut nuisance = beside(slow);
    let mut odds = 0.0;
    if model.slow.is_some() {
        let nothing = beside((0..0, 0.0)).null().log_evidence;
        odds += nuisance.null().log_evidence - nothing + SLOW_PRIOR.ln();
    }
    for one in &model.chosen {
        let gain = workspace.library.gain(&nuisance, &groups, one.candidate);
        odds += gain + workspace.library.log_prior[one.candidate] - NULL_PRIOR.ln();
        nuisance.grow(design, &groups, &one.columns);
    }
    odds
}

/// Searches and weighs in turn from `start` until both stand still.
fn settled<'a>(
    linear: &'a Linearised,
    candidates: &'a [Candidate],
    noise: NoisePrior,
    targets: usize,
    group_of: &[usize],
    start: Start,
) -> (Model, Workspace<'a>) {
    let dataset = &linear.dataset;
    let repeats: Vec<f64> = dataset.observations.iter().map(|s| s.repeats as f64).collect();
    let Start { mut variance_ratio, mut arm_m, mut robust, mut outliers, mut slow } = start;
    // Beside what no cause explains yet it would be all that is wrong with the arm: it is judged by what causes leave.
    let mut shared = SharedError::default();
    let mut set_aside = SetAside::new(outliers.len());
    let mut round = 0;
    loop {
        let base_weights: Vec<f64> =
            repeats.iter().map(|n| (variance_ratio + 1.0) / (variance_ratio + 1.0 / n)).collect();
        let weights = base_weights.iter().zip(&robust).map(|(a, b)| a * b).collect();
        let whitening = Whitening { weights, arm_m, shared };
        let mut design = Design::new(dataset, &linear.residuals, targets, whitening, group_of);
        if let Some(slow) = slow {
            slow.put(&mut design, dataset);
        }
        let mut library = Library::new(&design, dataset, candidates);
        let all_groups: Vec<usize> = (0..design.groups()).collect();
        let mut column_index = BTreeMap::new();
        let chosen = library.search(&mut design, &all_groups, noise, &mut column_index, ALARM_NATS);
        let nuisance = NuisanceModel::new(&design, &all_groups, &cause_columns(&chosen, None), noise);
        let peak = nuisance.null();
        let fit = solve(&design, &all_groups, &chosen, Some(peak.geometry_ratio));
        let residuals = design.residuals(&fit.coefficients);
        let (mut next_robust, mut next_outliers) = robust_weights(linear, &residuals, &base_weights);
        set_aside.settle((&robust, &outliers), (&mut next_robust, &mut next_outliers));
        let shared_ratio = shared.at_targets(dataset);
        let noise_m = peak.sigma_m * (1.0 + shared_ratio).sqrt();
        let carried = steps_of_few(
            &design,
            candidates,
            &chosen,
            (peak.geometry_ratio, noise_m),
            &base_weights,
            &residuals,
        );
        for &(i, weight) in &carried {
            (next_robust[i], next_outliers[i]) = (weight, true);
        }
        // A row of weight 1 scatters by `variance_ratio` + 1 times what repeats do.
        let least_m2 = noise.known.map_or(0.0, |(sigma_m, _)| sigma_m * sigma_m * (variance_ratio + 1.0));
        let by_repeats = Whitening::independent(base_weights.clone(), arm_m);
        let next_shared = SharedError::seen(dataset, &by_repeats, &residuals, &next_outliers, least_m2);
        let next_shared_ratio = next_shared.at_targets(dataset);
        let shared_variance = next_shared_ratio * (variance_ratio + 1.0);
        let next_variance_ratio = pose_variance_ratio(
            linear,
            &residuals,
            &noise,
            &next_outliers,
            (variance_ratio, shared_variance),
        );
        let next_arm = arm_of(linear, &residuals).unwrap_or(arm_m);
        let next_slow = slow_noise::likeliest(&design, dataset, &chosen, noise);
        round += 1;
        // Once there, its size settles with the causes; coming or going asks for another round.
        let steady = next_outliers == outliers
            && next_slow.is_some() == slow.is_some()
            && (next_variance_ratio - variance_ratio).abs() < 0.2 * (variance_ratio + 0.1)
            && (next_shared_ratio - shared_ratio).abs() < 0.2 * (shared_ratio + 0.1)
            && (next_arm / arm_m).ln().abs() < 0.15;
        let unsettled = !carried.is_empty() || next_slow.is_some() != slow.is_some();
        if steady || round >= ROUNDS && !unsettled || round == MOST_ROUNDS {
            let model = Model { chosen, noise, base_weights, outliers, residuals, peak, slow, shared_ratio };
            return (model, Workspace { design, library, column_index });
        }
        (robust, outliers, variance_ratio, arm_m) =
            (next_robust, next_outliers, next_variance_ratio, next_arm);
        (slow, shared) = (next_slow, next_shared);
    }
}

/// A fit of some of the design's columns.
#[derive(Clone, Debug)]
pub struct Fit {
    /// One for each column after the data; 0 for columns that take no part.
    pub coefficients: Vec<f64>,
    /// Columns that take part.
    pub columns: Vec<usize>,
    /// Their covariance at unit noise.
    pub covariance: DMatrix<f64>,
}

impl Fit {
    /// The coefficients without those of slow noise: what registration, geometry and causes take.
    #[must_use]
    pub fn without_slow(mut self, design: &Design) -> Self {
        for column in design.slow().0 {
            self.coefficients[column - 1] = 0.0;
        }
        self
    }
}

/// Fits registration, geometry (with `geometry_ratio`; none without it), slow noise and causes over `subset`.
#[must_use]
pub fn solve(design: &Design, subset: &[usize], chosen: &[ChosenCause], geometry_ratio: Option<f64>) -> Fit {
    let gram = design.gram(subset);
    let mut columns: Vec<(usize, f64)> = design.registration.clone().map(|c| (c, 0.0)).collect();
    if let Some(ratio) = geometry_ratio.filter(|r| *r > 0.0) {
        columns.extend(design.geometry.clone().map(|c| (c, 1.0 / (ratio * ratio))));
    }
    let (slow, ratio) = design.slow();
    if ratio > 0.0 {
        columns.extend(slow.map(|c| (c, 1.0 / (ratio * ratio))));
    }
    for cause in chosen {
        let ratio = 3.0 * cause.size_ratio;
        columns.extend(cause.columns.iter().map(|&c| (c, 1.0 / (ratio * ratio))));
    }
    let n = columns.len();
    let mut normal = DMatrix::from_fn(n, n, |r, c| gram[(columns[r].0, columns[c].0)]);
    for (i, (_, precision)) in columns.iter().enumerate() {
        // A little regularisation: directions that the poses do not determine stay where they are.
        normal[(i, i)] += precision + 1e-10 * normal[(i, i)] + 1e-18;
    }
    let right = DVector::from_fn(n, |r, _| gram[(columns[r].0, 0)]);
    let mut coefficients = vec![0.0; design.width() - 1];
    let mut covariance = DMatrix::zeros(n, n);
    if let Some(cholesky) = normal.cholesky() {
        let solved = cholesky.solve(&right);
        covariance = cholesky.inverse();
        for ((column, _), value) in columns.iter().zip(solved.iter()) {
            coefficients[column - 1] = *value;
        }
    }
    Fit { coefficients, columns: columns.into_iter().map(|c| c.0).collect(), covariance }
}

fn first_arm_m(linear: &Linearised) -> f64 {
    arm_of(linear, &linear.residuals).unwrap_or(0.2)
}

/// Distance at which an orientation error looks like the position error beside it.
fn arm_of(linear: &Linearised, residuals: &[Twist]) -> Option<f64> {
    if linear.dataset.rows_per_observation < 6 {
        return None;
    }
    let mut place: Vec<f64> = residuals.iter().map(shift_m).collect();
    let mut turn: Vec<f64> =
        residuals.iter().map(|m| (m[3] * m[3] + m[4] * m[4] + m[5] * m[5]).sqrt()).collect();
    let ratio = median(&mut place) / median(&mut turn).max(1e-12);
    Some(ratio.clamp(1e-3, 10.0))
}

/// Weights and who is false: far from the model, and alone there.
fn robust_weights(linear: &Linearised, residuals: &[Twist], base_weights: &[f64]) -> (Vec<f64>, Vec<bool>) {
    let distances: Vec<f64> =
        residuals.iter().zip(base_weights).map(|(m, w)| shift_m(m) * w.sqrt()).collect();
    // 1.54 sigma is the middle of a 3-D normal distance, 0.67 that of a number alone.
    let mut sigmas: Vec<f64> = distances
        .iter()
        .zip(&linear.dataset.observations)
        .map(|(d, observation)| d / if observation.rows(3) == 1 { 0.6745 } else { 1.54 })
        .collect();
    let sigma_m = median(&mut sigmas);
    let limit_m = FALSE_SIGMAS * sigma_m.max(1e-9);
    let outliers: Vec<bool> = (0..residuals.len())
        .map(|i| distances[i] > limit_m && !has_similar_neighbours(linear, residuals, i, limit_m))
        .collect();
    let weights = distances
        .iter()
        .zip(&outliers)
        .map(|(d, out)| if *out { (limit_m / d).powi(4) } else { 1.0 })
        .collect();
    (weights, outliers)
}

/// Stations that are far off without a step of base or target, where the step gains nothing but with them: false readings
/// side by side in time, which it would take along. With the weight that each is then worth.
fn steps_of_few(
    design: &Design,
    candidates: &[Candidate],
    chosen: &[ChosenCause],
    (geometry_ratio, noise_m): (f64, f64),
    base_weights: &[f64],
    residuals: &[Twist],
) -> Vec<(usize, f64)> {
    let all_groups: Vec<usize> = (0..design.groups()).collect();
    let squares = |residuals: &[Twist], i: usize| base_weights[i] * shift_m(&residuals[i]).powi(2);
    let mut carried = Vec::new();
    let steps = |c: &ChosenCause| candidates[c.candidate].variant.t0_min().is_some();
    for (k, _) in chosen.iter().enumerate().filter(|(_, c)| steps(c)) {
        let others: Vec<ChosenCause> =
            chosen.iter().enumerate().filter(|(other, _)| *other != k).map(|(_, c)| c.clone()).collect();
        let fit = solve(design, &all_groups, &others, Some(geometry_ratio));
        let without = design.residuals(&fit.coefficients);
        let gain = |i: usize| (squares(&without, i) - squares(residuals, i)) / (2.0 * noise_m.powi(2));
        let mut gains: Vec<(usize, f64)> = (0..without.len()).map(|i| (i, gain(i))).collect();
        gains.sort_by(|a, b| b.1.total_cmp(&a.1));
        let (few, rest) = gains.split_at(FEW.min(gains.len()));
        let [few_nats, rest_nats] = [few, rest].map(|part| part.iter().map(|(_, gain)| gain).sum::<f64>());
        if few_nats < ALARM_NATS || rest_nats >= ALARM_NATS {
            continue;
        }
        let limit_m = FALSE_SIGMAS * noise_m;
        carried.extend(few.iter().filter_map(|&(i, _)| {
            let far_m = squares(&without, i).sqrt();
            (far_m > limit_m).then(|| (i, (limit_m / far_m).powi(4)))
        }));
    }
    carried
}

/// Whether the nearest stations in place or time are off in much the same way: then it is structure, not a
/// false row.
fn has_similar_neighbours(linear: &Linearised, residuals: &[Twist], i: usize, limit_m: f64) -> bool {
    let observations = &linear.dataset.observations;
    let here = &residuals[i];
    let alike = |k: usize| {
        let along = (0..3).map(|x| here[x] * residuals[k][x]).sum::<f64>();
        shift_m(&residuals[k]) > 0.5 * limit_m && along > 0.7 * shift_m(here) * shift_m(&residuals[k])
    };
    // Most of the nearest: two false rows that happen to lie side by side do not excuse each other.
    let same_visit =
        linear.dataset.visits.iter().find(|visit| visit.contains(&i)).map_or(&[][..], Vec::as_slice);
    let most = |distance: &dyn Fn(usize) -> f64, count: usize| {
        let mut near: Vec<(f64, usize)> = (0..observations.len())
            .filter(|&k| k != i && !same_visit.contains(&k))
            .map(|k| (distance(k), k))
            .collect();
        let count = count.min(near.len().saturating_sub(1));
        near.select_nth_unstable_by(count, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        2 * near[..count].iter().filter(|(_, k)| alike(*k)).count() > count
    };
    let place = most(&|k| (observations[k].point_m - observations[i].point_m).norm_squared(), 3);
    let time = || {
        linear.dataset.time_min.is_some()
            && most(&|k| (observations[k].clock() - observations[i].clock()).abs(), 3)
    };
    place || time()
}

/// Pose-to-pose variance that neither repeats show nor visits share, over that of repeats; with `last` what it was and what is shared.
fn pose_variance_ratio(
    linear: &Linearised,
    residuals: &[Twist],
    noise: &NoisePrior,
    outliers: &[bool],
    (last, shared): (f64, f64),
) -> f64 {
    let Some((sigma_m, _)) = noise.known else { return last };
    let repeated: Vec<(f64, f64)> = linear
        .dataset
        .observations
        .iter()
        .zip(residuals)
        .zip(outliers)
        .filter(|((s, _), out)| s.repeats > 1 && !**out)
        .map(|((s, m), _)| (shift_m(m).powi(2) / s.rows(3) as f64, 1.0 / s.repeats as f64))
        .collect();
    if repeated.len() < 5 {
        return last;
    }
    let n = repeated.len() as f64;
    let seen = repeated.iter().map(|r| r.0).sum::<f64>() / n;
    let expected = repeated.iter().map(|r| r.1).sum::<f64>() / n;
    (seen / (sigma_m * sigma_m) - expected - shared).clamp(0.0, 30.0)
}

/// Upper median of the values; 0 of none.
#[must_use]
pub fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}
