//! Noise that was stated beside what repeats, base and tool, or the best model say of it.

use super::model::FittedModel;
use super::options::DiagnosisOptions;
use super::outcome::{Verdict, Warning};
use super::verdict::Judgement;
use inference::marginal::NoisePrior;
use measurements::{Reading, Registration, Stations};
use robot_model::units::mm_from_m;
use statistics::MEDIAN_NORM_3D;

/// Noise that is stated as so many times what is left without any cause is none.
const OVERSTATED: f64 = 2.0;
/// Variance about the best model over the one stated, from which on it is worth a word: noise that is stated by eye is a tenth or two off.
const UNDERSTATED: f64 = 1.5;

/// Where the repeats speak against the noise that was stated.
#[must_use]
pub(super) fn contradicted_noise(stations: &Stations, options: &DiagnosisOptions) -> Option<Warning> {
    let seen = stations.repeats?;
    NoisePrior::contradicted(Some(&seen), options.sigma_m).then(|| {
        let so = if options.sigma_m.is_some_and(|stated_m| stated_m > seen.sigma_m) {
            "less than the noise that was stated; they are believed, and what is slow may be as large as stated"
        } else {
            "which is not the noise that was stated; the repeats are believed"
        };
        let seen_mm = mm_from_m(seen.sigma_m);
        Warning {
            code: "diagnose::noise",
            message: format!("the repeats scatter by {seen_mm:.4} mm in one coordinate, {so}"),
        }
    })
}

/// Where base and tool alone leave less than the noise that was stated.
#[must_use]
pub(super) fn overstated_noise(
    stations: &Stations,
    registration: &Registration,
    options: &DiagnosisOptions,
) -> Option<Warning> {
    let stated_m = options.sigma_m.filter(|_| stations.repeats.is_none())?;
    let are_points = stations.stations.iter().all(|s| matches!(s.reading, Reading::Point { .. }));
    let left_m = registration.median_m / MEDIAN_NORM_3D;
    (are_points && OVERSTATED * left_m < stated_m).then(|| {
        let [stated_mm, left_mm] = [stated_m, left_m].map(mm_from_m);
        Warning {
            code: "diagnose::noise",
            message: format!(
                "with base and tool fitted and nothing else the points scatter by {left_mm:.4} mm in one coordinate, less than the noise of \
                 {stated_mm:.4} mm that was stated: no noise is taken as known"
            ),
        }
    })
}

/// Where the points scatter about the best model clearly more than the noise that was stated, and the verdict does not say so itself.
#[must_use]
pub(super) fn understated_noise(fitted: &FittedModel<'_>, judgement: &Judgement) -> Option<Warning> {
    let noise = fitted.model.noise;
    let stated = noise.known.filter(|_| !noise.from_repeats)?;
    let chi = judgement.reduced_chi_square?;
    let is_verdict = matches!(
        judgement.verdict,
        Verdict::UnexplainedStructure | Verdict::UnexplainedScatter | Verdict::InsufficientData
    );
    (!is_verdict && chi.value > UNDERSTATED && chi.is_no_chance()).then(|| Warning {
        code: "diagnose::noise",
        message: format!(
            "about the best model the points scatter by {:.4} mm in one coordinate, {:.1} times the noise that was stated: either it is larger \
             than stated, or something small that no effect of the library follows is left; some poses measured twice would tell",
            mm_from_m(stated.sigma_m) * chi.value.sqrt(),
            chi.value.sqrt()
        ),
    })
}
