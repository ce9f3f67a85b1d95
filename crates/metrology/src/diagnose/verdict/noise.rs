//! Scatter that the model does not know, and noise that is only slow.

use super::wording::missing_channels;
use crate::diagnose::model::FittedModel;
use inference::dataset::Dataset;
use inference::evidence::NuisanceModel;
use inference::gp_alternative::GpAlternative;
use inference::linear_fit::solve;
use inference::linearise::{rms_m, shift_m};
use inference::marginal::{KnownNoise, NoisePrior};
use inference::scatter::{self, JointScatter, Residuals};
use inference::search::{ChosenCause, cause_columns};
use inference::smoothness::smooth_over_rough_nats;
use statistics::variance_ratio;

/// A reduced chi-square above this against the repeats is scatter that the model does not know.
const SCATTER: f64 = 1.5;
/// Scatter beyond a noise that is only stated, not seen in repeats, counts from this reduced chi-square on.
const STATED_SCATTER: f64 = 2.8;
/// Few repeats may by chance show less noise than there is: scatter counts from where that happens two times in a
/// thousand (normal quantile).
const BY_CHANCE: f64 = 2.878;
/// Structure left that is larger than this share of the causes makes them doubtful.
pub(super) const MAX_RESIDUAL_SHARE: f64 = 0.5;
/// Variance over the one stated that says that the statement holds. An autoregressive process keeps less than this beside its slow
/// waves, whatever its correlation from .6 on.
const AS_STATED: std::ops::Range<f64> = 0.72..1.5;
/// Scatter that nobody stated is noise with slow parts as far as these are no more than so many times what is not slow: of noise that is
/// the row's before to a share of .6 to .95, a fifth and more is quick.
pub(super) const MOSTLY_SLOW: f64 = 2.0;
/// ln of 20 to 1: what is slow is clearly a function of time or, the other way round, noise that is slow itself.
pub(super) const SMOOTH_NATS: f64 = 3.0;
/// All scatter over the variance stated, from which on what is slow is not of it.
const ON_TOP: f64 = 1.35;
/// The reason that [`slow_noise`] gives.
pub(super) const SLOW_NOISE: &str = "no effect of the library stands out of the noise; rows measured one after the other share \
     part of it, but together they scatter no more than the noise allows";

/// The same where nothing says how much noise there is.
pub(super) const SLOW_AS_NOISE: &str = "no effect of the library stands out of the noise; rows measured one after the other share part of it, as slow \
     noise does: how much noise there is is neither stated nor repeated";

/// Scatter that the model does not know.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scatter {
    /// Reduced chi-square against the noise, where it is too large.
    pub chi: Option<f64>,
    /// Scatter along one joint, where it passes the alarm.
    pub along: Option<JointScatter>,
}

impl Scatter {
    /// Whether it is not small against what the causes take.
    #[must_use]
    pub(super) fn is_comparable(&self, fitted: &FittedModel<'_>, cause_rms_m: f64) -> bool {
        self.along.is_some_and(|a| a.rms_m > MAX_RESIDUAL_SHARE * cause_rms_m)
            || self.chi.is_some() && excess_m(fitted) > MAX_RESIDUAL_SHARE * cause_rms_m
    }

    /// The scatter as a sentence for people.
    #[must_use]
    pub(super) fn reason(&self, dataset: &Dataset) -> String {
        let what = match (self.along, self.chi) {
            (Some(a), _) => format!("poses scatter along joint {}", a.joint),
            (None, Some(chi)) => format!("poses scatter {:.1} times as much as the noise allows", chi.sqrt()),
            (None, None) => "poses scatter".to_owned(),
        };
        format!("{what}, and nothing that is recorded explains it: {}", missing_channels(dataset))
    }
}

/// How many of the parameters of a model are the points': orientation has rows of its own, and with it half of them are.
#[must_use]
pub(super) fn points_share(dataset: &Dataset) -> f64 {
    3.0 / dataset.rows_per_observation as f64
}

/// Scatter of the residuals along a joint.
#[must_use]
pub(super) fn joint_scatter(fitted: &FittedModel<'_>) -> Option<JointScatter> {
    let FittedModel { model, workspace, linear } = fitted;
    let groups = workspace.design.all_groups();
    let nuisance =
        NuisanceModel::new(&workspace.design, &groups, &cause_columns(&model.chosen, None), model.noise);
    let used = points_share(&linear.dataset) * nuisance.parameters(model.peak.geometry_ratio);
    scatter::along_joints(&Residuals {
        dataset: &linear.dataset,
        residuals: &model.residuals,
        weights: &model.base_weights,
        outliers: &model.outliers,
        noise: &model.noise,
        used,
        instrument_m: linear.registration.instrument_from_base.inverse().translation.vector,
    })
}

/// Noise of a reading that is allowed for: variances of what readings at one time show, and of what they share.
#[derive(Clone, Copy, Debug)]
struct AllowedNoise {
    quick_m2: f64,
    slow_m2: f64,
}

impl AllowedNoise {
    /// What is known to be of `sigma_m`, and what was stated beyond that, which is slow.
    fn of(noise: &NoisePrior, sigma_m: f64) -> Self {
        let quick_m2 = sigma_m.powi(2);
        let stated_m2 = noise.stated_more_m.map_or(quick_m2, |stated_m| stated_m.powi(2));
        Self { quick_m2, slow_m2: (stated_m2 - quick_m2).max(0.0) }
    }

    /// Variance of one coordinate of the mean of so many readings at one time.
    fn of_mean_m2(self, readings: usize) -> f64 {
        self.slow_m2 + self.quick_m2 / readings as f64
    }
}

/// Scatter beyond the noise as known, 3-D rms, metres.
fn excess_m(fitted: &FittedModel<'_>) -> f64 {
    let FittedModel { model, linear, .. } = fitted;
    let Some(KnownNoise { sigma_m, .. }) = model.noise.known else { return 0.0 };
    let allowed = AllowedNoise::of(&model.noise, sigma_m);
    let expected =
        linear.dataset.observations.iter().map(|s| 3.0 * allowed.of_mean_m2(s.repeats)).sum::<f64>()
            / linear.dataset.observations.len() as f64
            + 3.0 * model.shared_ratio * model.peak.sigma_m.powi(2);
    (rms_m(&model.residuals, |i| !model.outliers[i]).powi(2) - expected).max(0.0).sqrt()
}

/// Scatter about a model over what the noise as known allows, as a variance.
#[derive(Clone, Copy, Debug)]
pub(in crate::diagnose) struct ReducedChiSquare {
    /// Squares left per degree of freedom, over the noise's variance.
    pub value: f64,
    /// Above this it is no chance, for as many repeats as there are.
    pub limit: f64,
    /// Degrees of freedom that the model leaves.
    pub freedom: f64,
}

impl ReducedChiSquare {
    /// Whether there is more scatter than chance would give.
    #[must_use]
    pub(super) fn is_exceeded(&self) -> bool {
        self.value > self.limit
    }

    /// Whether chance would hardly give it if the noise were just as it is known.
    #[must_use]
    pub(in crate::diagnose) fn is_no_chance(&self) -> bool {
        self.value > variance_ratio(BY_CHANCE, self.freedom, f64::INFINITY)
    }
}

/// Scatter about a model of `chosen` over what the repeats allow, and the limit for as many repeats as there are.
#[must_use]
pub(super) fn reduced_chi_square(
    fitted: &FittedModel<'_>,
    chosen: &[ChosenCause],
) -> Option<ReducedChiSquare> {
    let FittedModel { model, workspace, linear } = fitted;
    let KnownNoise { sigma_m, freedom } = model.noise.known?;
    let allowed = AllowedNoise::of(&model.noise, sigma_m);
    let groups = workspace.design.all_groups();
    let nuisance = NuisanceModel::new(&workspace.design, &groups, &cause_columns(chosen, None), model.noise);
    let ratio = nuisance.null().geometry_ratio;
    let fit = solve(&workspace.design, &groups, chosen, Some(ratio)).without_slow(&workspace.design);
    let mut sum = 0.0;
    let mut rows = 0.0;
    // Where the arm stood is what targets of a visit share: no repeat and no statement of the instrument's noise knows of it.
    let residuals = workspace.design.independent_residuals(&fit.coefficients);
    for ((m, observation), out) in residuals.iter().zip(&linear.dataset.observations).zip(&model.outliers) {
        if !*out {
            sum += shift_m(m).powi(2) / allowed.of_mean_m2(observation.repeats);
            rows += observation.rows(3) as f64;
        }
    }
    // All of them, with orientation too: its rows weigh less than the points where they tell the same parameters.
    let free: f64 = (rows - nuisance.parameters(ratio)).max(6.0);
    let spread = 1.5 * (2.0 / freedom + 2.0 / free).sqrt();
    let limit = if model.noise.from_repeats {
        (SCATTER + spread).max(variance_ratio(BY_CHANCE, free, freedom))
    } else {
        STATED_SCATTER + spread
    };
    Some(ReducedChiSquare { value: sum / free, limit, freedom: free })
}

/// What slow noise means beside `chosen`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Slowness {
    /// The residuals have no slow noise.
    None,
    /// All scatter together is no more than the repeats or the statement allow.
    WithinNoise,
    /// Neither says how much noise there is, and what is slow is no more of it than of an autoregressive process.
    AsOfNoise,
    /// It is more than they allow, or nothing says how much they are; 3-D rms, metres.
    Structure {
        /// Of the slow part.
        rms_m: f64,
        /// Whether repeats or a statement say how much noise there is.
        noise_known: bool,
    },
}

/// Whether slow noise beside `chosen` is noise, or structure over time.
#[must_use]
pub(super) fn slowness(fitted: &FittedModel<'_>, chosen: &[ChosenCause]) -> Slowness {
    let model = &fitted.model;
    let Some(slow) = model.slow else { return Slowness::None };
    let chi = reduced_chi_square(fitted, chosen);
    match chi {
        Some(chi) if !chi.is_exceeded() && !beyond_statement(fitted, chosen, chi.value) => {
            Slowness::WithinNoise
        }
        None if slow.size <= MOSTLY_SLOW && smoothness_nats(fitted, chosen) <= SMOOTH_NATS => {
            Slowness::AsOfNoise
        }
        _ => Slowness::Structure {
            rms_m: slow.size * model.peak.sigma_m * 3.0_f64.sqrt(),
            noise_known: chi.is_some(),
        },
    }
}

/// Whether `gp_alternative` is only noise that is slow: the same for neighbouring rows, but all in all, with no cause
/// in the model, no larger than the repeats or the statement say. Where that noise is clearly rough, a line of its spectrum is chance.
#[must_use]
pub(super) fn slow_noise(fitted: &FittedModel<'_>, gp_alternative: usize) -> bool {
    let FittedModel { model, workspace, linear } = fitted;
    let over_time = match workspace.library.gp_alternatives[gp_alternative].gp_alternative {
        GpAlternative::Time | GpAlternative::TimeFine | GpAlternative::ToolTime => true,
        GpAlternative::Cycle(_) => model.slow.is_some() && smoothness_nats(fitted, &[]) < -SMOOTH_NATS,
        _ => false,
    };
    over_time
        && linear.dataset.neighbours_in_time
        && reduced_chi_square(fitted, &[])
            .is_some_and(|chi| !chi.is_exceeded() && !beyond_statement(fitted, &[], chi.value))
}

/// Whether what is slow beside `chosen` comes on top of the noise that was stated, where all together are `total` times the statement's
/// variance. A statement may be 1.4 times off, and then all noise is; but where noise that is not slow alone is as large as stated, the
/// statement holds, and what is slow is none of it. What goes from row to row as noise does rather than as a function of time is all noise,
/// and more of it than stated; causes beside it are not given up for less than a clear function of time.
fn beyond_statement(fitted: &FittedModel<'_>, chosen: &[ChosenCause], total: f64) -> bool {
    let model = &fitted.model;
    let Some(stated) = model.noise.known.filter(|_| !model.noise.from_repeats) else { return false };
    model.slow.is_some()
        && comes_on_top((model.peak.sigma_m / stated.sigma_m).powi(2), total)
        && smoothness_nats(fitted, chosen) > if chosen.is_empty() { 0.0 } else { SMOOTH_NATS }
}

/// ln of how much likelier what `chosen` leave is of a smooth function of time beside white noise than of noise that is slow itself.
#[must_use]
pub(super) fn smoothness_nats(fitted: &FittedModel<'_>, chosen: &[ChosenCause]) -> f64 {
    smooth_over_rough_nats(&fitted.linear.dataset, &fitted.residuals_beside(chosen), &fitted.model.outliers)
}

/// The same of variances over the one stated: `fast` of what is not slow, and `total`.
fn comes_on_top(fast: f64, total: f64) -> bool {
    AS_STATED.contains(&fast) && total > ON_TOP
}

#[cfg(test)]
mod tests {
    use super::{AllowedNoise, comes_on_top};
    use inference::marginal::NoisePrior;
    use std::f64::consts::PI;

    /// Readings at one time scatter by 3, 5 are stated: 4 are slow, and the mean of nine keeps 16 + 9 / 9 of 25.
    #[test]
    fn the_mean_of_readings_keeps_what_is_slow() {
        let noise = |stated_more_m| NoisePrior { known: None, from_repeats: true, stated_more_m };
        let mean_m2 = |stated_m| AllowedNoise::of(&noise(stated_m), 3.0).of_mean_m2(9);
        assert_eq!((mean_m2(Some(5.0)), mean_m2(None)), (17.0, 1.0));
    }

    /// Of an autoregressive process of unit variance the share at frequencies under f per row is 2/pi atan(tan(pi f) (1 + r) / (1 - r))
    /// (integral of its spectrum); 40 half periods, or one for six rows, are slow. Stated 5 % of sigma too low, or right: noise. As
    /// much on top of white noise as stated: none.
    #[test]
    fn noise_that_is_slow_as_a_whole_does_not_come_on_top_of_what_is_stated() {
        for rows in [30.0_f64, 60.0, 100.0, 300.0] {
            for r in [0.6, 0.75, 0.9, 0.95] {
                let f = 0.5 * (rows / 6.0).floor().min(40.0) / rows;
                let slow = 2.0 / PI * ((PI * f).tan() * (1.0 + r) / (1.0 - r)).atan();
                for total in [1.0, 1.1] {
                    assert!(!comes_on_top(total * (1.0 - slow), total), "{rows} {r}");
                }
            }
        }
        assert!(comes_on_top(1.0, 2.0));
        // All of it 1.4 times the statement, and white but for a little.
        assert!(!comes_on_top(1.9, 2.0));
    }
}
