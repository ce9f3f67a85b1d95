//! A gear line's own harmonics: its double frequency is part of the gear and no second cause, and without a large third it has no corners.

use crate::diagnose::model::{FittedModel, Model};
use inference::design::Design;
use inference::effects::{OVERTONE_WEIGHT, line, line_with_overtone};
use inference::evidence::NuisanceModel;
use inference::linear_fit::{LinearFit, solve};
use inference::linearise::Linearised;
use inference::search::{ChosenCause, NULL_PRIOR};
use robot_model::deform::EffectKind;
use robot_model::robot::Axis;
use statistics::log_sum;

/// Largest size of a double frequency that is the gear's own, over the line's: the upper end of what is usual, see
/// `OVERTONE` in `effects/gear_harmonic.rs`.
const LARGEST: f64 = 0.2;
/// Third harmonic of what has steps or corners, over its first: a third of a square wave's or a sawtooth's.
const LEAST_OF_CORNERS: f64 = 0.25;
/// Size of a harmonic over its prior's that is as good as free.
const FREE_RATIO: f64 = 100.0;

/// Places in `chosen` of lines at twice the periods of another line of the same gear, of a fifth of its size or less.
#[must_use]
pub(super) fn overtones(fitted: &FittedModel<'_>, chosen: &[ChosenCause]) -> Vec<usize> {
    let FittedModel { model, workspace, .. } = fitted;
    let line_of = |one: &ChosenCause| {
        let candidate = &workspace.library.candidates[one.candidate];
        let joint_and_n = candidate.variant.joint.zip(candidate.variant.n);
        joint_and_n.filter(|_| candidate.kind == EffectKind::GearMesh)
    };
    let lines: Vec<_> = chosen.iter().map(line_of).collect();
    let doubles = |i: usize, k: usize| {
        lines[i].zip(lines[k]).is_some_and(|((joint, n), (of, m))| joint == of && m == 2 * n)
    };
    let pairs: Vec<(usize, usize)> = (0..chosen.len())
        .flat_map(|i| (0..chosen.len()).map(move |k| (i, k)))
        .filter(|&(i, k)| doubles(i, k))
        .collect();
    if pairs.is_empty() {
        return Vec::new();
    }
    let groups = workspace.design.all_groups();
    let fit = solve(&workspace.design, &groups, chosen, Some(model.peak.geometry_ratio));
    let is_own = |&(i, k): &(usize, usize)| {
        let sigma = amplitude_sigma(&fit, &chosen[k], model.peak.sigma_m);
        amplitude(&fit, &chosen[k]) <= LARGEST * amplitude(&fit, &chosen[i]) + sigma
    };
    pairs.into_iter().filter(is_own).map(|(_, k)| k).collect()
}

/// Amplitude of a line, over the prior's, which is the same for all lines.
fn amplitude(fit: &LinearFit, line: &ChosenCause) -> f64 {
    line.columns.iter().map(|c| fit.coefficients[c - 1].powi(2)).sum::<f64>().sqrt()
}

/// Its standard deviation where the noise is `sigma_m`.
fn amplitude_sigma(fit: &LinearFit, line: &ChosenCause, sigma_m: f64) -> f64 {
    let at = fit.columns.iter().position(|c| Some(c) == line.columns.first());
    sigma_m * at.map_or(0.0, |at| fit.covariance[(at, at)].max(0.0).sqrt())
}

/// Whether what turns `joint` `n` times per turn has steps or corners: beside `others` its third harmonic may be a quarter of the first or more.
#[must_use]
pub(super) fn has_corners(
    (linear, model, design): (&Linearised, &Model, &mut Design),
    others: &[ChosenCause],
    (joint, n): (Axis, u32),
) -> bool {
    let width = design.width();
    let harmonics: Vec<ChosenCause> = (1..=3)
        .map(|k| {
            let columns = design.columns_of(&linear.dataset, &line(joint, k * n));
            let columns = design.append(&columns).collect();
            // As free as the data leave it.
            ChosenCause { candidate: 0, columns, gain_nats: 0.0, size_ratio: FREE_RATIO / model.peak.sigma_m }
        })
        .collect();
    let chosen: Vec<ChosenCause> = others.iter().chain(&harmonics).cloned().collect();
    let fit = solve(design, &design.all_groups(), &chosen, Some(model.peak.geometry_ratio));
    design.truncate(width);
    let third_sigma = amplitude_sigma(&fit, &harmonics[2], model.peak.sigma_m);
    amplitude(&fit, &harmonics[2]) + 2.0 * third_sigma >= LEAST_OF_CORNERS * amplitude(&fit, &harmonics[0])
}

/// ln odds of the line in place `i` of `chosen` over nothing beside `nuisance`, as its gear may have a double frequency of its own; of
/// one of the `overtones`, what it adds to its gear's.
#[must_use]
pub(super) fn line_odds(
    fitted: &FittedModel<'_>,
    nuisance: &NuisanceModel,
    (chosen, i): (&[ChosenCause], usize),
    overtones: &[usize],
) -> f64 {
    let FittedModel { workspace, linear, .. } = fitted;
    let design = &workspace.design;
    let c = chosen[i].candidate;
    let candidate = &workspace.library.candidates[c];
    let plain = workspace.library.gain(nuisance, &design.all_groups(), c);
    if overtones.contains(&i) {
        return plain + OVERTONE_WEIGHT.ln();
    }
    let gain = match (candidate.kind, candidate.variant.joint, candidate.variant.n) {
        (EffectKind::GearMesh, Some(joint), Some(n)) => {
            let sums = design.sums(&design.columns_of(&linear.dataset, &line_with_overtone(joint, n)));
            let both =
                nuisance.evidence(&nuisance.project(&sums)).log_evidence - nuisance.null().log_evidence;
            log_sum([plain + (1.0 - OVERTONE_WEIGHT).ln(), both + OVERTONE_WEIGHT.ln()])
        }
        _ => plain,
    };
    gain + workspace.library.log_prior[c] - NULL_PRIOR.ln()
}
