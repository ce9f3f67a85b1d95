//! A gear line's own double frequency: part of the gear, and no second cause.

use crate::diagnose::effects::{OVERTONE_WEIGHT, line_with_overtone};
use crate::diagnose::evidence::NuisanceModel;
use crate::diagnose::linear_fit::{LinearFit, solve};
use crate::diagnose::marginal::log_sum;
use crate::diagnose::model::FittedModel;
use crate::diagnose::search::{ChosenCause, NULL_PRIOR};
use robot_model::deform::EffectKind;

/// Largest size of a double frequency that is the gear's own, over the line's: the upper end of what is usual, see
/// `OVERTONE` in `effects/gear_harmonic.rs`.
const LARGEST: f64 = 0.2;

/// Places in `chosen` of lines at twice the periods of another line of the same gear, of a fifth of its size or less.
#[must_use]
pub(super) fn overtones(fitted: &FittedModel<'_>, chosen: &[ChosenCause]) -> Vec<usize> {
    let FittedModel { model, workspace, .. } = fitted;
    let line = |one: &ChosenCause| {
        let candidate = &workspace.library.candidates[one.candidate];
        let joint_and_n = candidate.variant.joint.zip(candidate.variant.n);
        joint_and_n.filter(|_| candidate.kind == EffectKind::GearMesh)
    };
    let lines: Vec<_> = chosen.iter().map(line).collect();
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
    // Prior sigmas are the same for all lines.
    let size = |fit: &LinearFit, i: usize| {
        chosen[i].columns.iter().map(|c| fit.coefficients[c - 1].powi(2)).sum::<f64>().sqrt()
    };
    let sigma = |k: usize| {
        let at = fit.columns.iter().position(|c| Some(c) == chosen[k].columns.first());
        model.peak.sigma_m * at.map_or(0.0, |at| fit.covariance[(at, at)].max(0.0).sqrt())
    };
    let is_own = |&(i, k): &(usize, usize)| size(&fit, k) <= LARGEST * size(&fit, i) + sigma(k);
    pairs.into_iter().filter(is_own).map(|(_, k)| k).collect()
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
