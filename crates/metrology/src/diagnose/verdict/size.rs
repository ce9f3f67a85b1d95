//! Causes with their sizes, fitted beside the others.

use super::cause_group::CauseGroup;
use super::fitted_size::size_of;
use super::law_spread::law_spread;
use crate::diagnose::model::{FittedModel, Workspace};
use inference::cause::Cause;
use inference::dataset::Twist;
use inference::design::Design;
use inference::effects::Candidate;
use inference::linear_fit::{LinearFit, solve};
use inference::linearise::{Linearised, rms_m, shift_m};
use inference::search::ChosenCause;
use inference::size_unit::SizeUnit;
use inference::time_course::TimeCourse;
use nalgebra::{DMatrix, DVector};
use robot_model::units::mm_from_m;

/// A cause with its size: fitted in place `i` of `chosen`, or alone.
pub(super) fn cause(
    fitted: &mut FittedModel<'_>,
    chosen: &[ChosenCause],
    i: Option<usize>,
    cause_group: &CauseGroup,
) -> Cause {
    let FittedModel { model, workspace, linear } = fitted;
    let Workspace { design, library, column_index } = &mut *workspace;
    let columns = library.columns_in_design(design, column_index, &[cause_group.best]).concat();
    let chosen_here = i.and_then(|i| chosen.get(i));
    let size_ratio = chosen_here.map_or(1.0 / model.peak.sigma_m, |c| c.size_ratio);
    let this = ChosenCause {
        candidate: cause_group.best,
        columns: columns.clone(),
        gain_nats: cause_group.gain_nats,
        size_ratio,
    };
    let mut all: Vec<ChosenCause> = chosen.to_vec();
    match i {
        Some(i) => all[i] = this,
        None => all.push(this),
    }
    let mut others = all.clone();
    others.remove(i.unwrap_or(chosen.len()));
    let groups = workspace.design.all_groups();
    let ratio = Some(model.peak.geometry_ratio);
    let fit = solve(&workspace.design, &groups, &all, ratio);
    let without = solve(&workspace.design, &groups, &others, ratio);
    let left_m = |fit: &LinearFit| left_rms_m(&workspace.design, &model.outliers, fit);
    let of_gap_m = (left_m(&without).powi(2) - left_m(&fit).powi(2)).max(0.0).sqrt();
    let candidate = &workspace.library.candidates[cause_group.best];
    let (size, sigma_of_fit) = size_of(candidate, &columns, &fit, model.peak.sigma_m);
    let moved: Vec<f64> = moved_by(linear, candidate, &columns, &fit).iter().map(shift_m).collect();
    let mut cause = cause_unfitted(workspace, cause_group);
    cause.rms_of_gap_mm = Some(mm_from_m(of_gap_m));
    cause.size = Some(size);
    cause.rms_mm = Some(mm_from_m(rms(&moved)));
    cause.rms_seen_mm = Some(mm_from_m(rms(&seen_m(&workspace.design, &groups, candidate, &columns, &fit))));
    let at = i.unwrap_or(chosen.len());
    cause.sigma = Some(sigma_of_fit.hypot(law_spread(fitted, &all, at, size)));
    cause
}

/// A cause without its size.
#[must_use]
pub(super) fn cause_unfitted(workspace: &Workspace<'_>, cause_group: &CauseGroup) -> Cause {
    let candidate = &workspace.library.candidates[cause_group.best];
    Cause {
        joint: candidate.variant.joint,
        joint_b: candidate.variant.joint_b,
        n: candidate.variant.n,
        t0_min: candidate.variant.t0_min().and_then(|t0| workspace.library.dataset.minute_of(t0)),
        from_line: candidate.variant.t0_min().and_then(|t0| workspace.library.dataset.line_from(t0)),
        evidence_nats: Some(cause_group.gain_nats),
        unit: candidate.unit(),
        usual: candidate.usual_size(),
        ..Cause::of(candidate.kind, cause_group.probability)
    }
}

/// How far all of `chosen` together move the point at each station, metres: what two of them do against each other counts as what is left.
#[must_use]
pub(super) fn moved_m(fitted: &FittedModel<'_>, chosen: &[ChosenCause]) -> Vec<f64> {
    let FittedModel { model, workspace, linear } = fitted;
    let groups = workspace.design.all_groups();
    let fit = solve(&workspace.design, &groups, chosen, Some(model.peak.geometry_ratio));
    let mut total = vec![Twist::default(); linear.dataset.observations.len()];
    for one in chosen {
        let candidate = &workspace.library.candidates[one.candidate];
        for (sum, moved) in total.iter_mut().zip(moved_by(linear, candidate, &one.columns, &fit)) {
            sum.iter_mut().zip(moved.iter()).for_each(|(to, from)| *to += from);
        }
    }
    total.iter().map(shift_m).collect()
}

/// What `chosen` take off the residuals beyond registration and geometry, 3-D rms, metres.
#[must_use]
pub(super) fn total_rms_m(fitted: &FittedModel<'_>, chosen: &[ChosenCause]) -> f64 {
    let FittedModel { model, workspace, .. } = fitted;
    let groups = workspace.design.all_groups();
    let ratio = Some(model.peak.geometry_ratio);
    let left = |chosen: &[ChosenCause]| {
        let fit = solve(&workspace.design, &groups, chosen, ratio);
        left_rms_m(&workspace.design, &model.outliers, &fit).powi(2)
    };
    (left(&[]) - left(chosen)).max(0.0).sqrt()
}

/// What a fit leaves of the stations that are not set aside, 3-D rms, metres.
fn left_rms_m(design: &Design, outliers: &[bool], fit: &LinearFit) -> f64 {
    rms_m(&design.residuals(&fit.coefficients), |i| !outliers[i])
}

/// Root mean square of the values; 0 of none.
#[must_use]
pub(super) fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|v| v * v).sum::<f64>() / values.len().max(1) as f64).sqrt()
}

/// How far the effect moves the point at each station where base and target are placed anew beside it, metres.
fn seen_m(
    design: &Design,
    groups: &[usize],
    candidate: &Candidate,
    columns: &[usize],
    fit: &LinearFit,
) -> Vec<f64> {
    let own = &columns[..reported(candidate, columns.len())];
    let gram = design.gram(groups);
    let placed: Vec<usize> = design.registration.clone().collect();
    let normal = DMatrix::from_fn(placed.len(), placed.len(), |r, c| {
        // Directions that the poses do not determine stay where they are.
        gram[(placed[r], placed[c])] * if r == c { 1.0 + 1e-10 } else { 1.0 }
            + if r == c { 1e-18 } else { 0.0 }
    });
    let along = DVector::from_fn(placed.len(), |r, _| {
        own.iter().map(|&c| gram[(placed[r], c)] * fit.coefficients[c - 1]).sum::<f64>()
    });
    let mut coefficients = vec![0.0; fit.coefficients.len()];
    for &c in own {
        coefficients[c - 1] = fit.coefficients[c - 1];
    }
    if let Some(cholesky) = normal.cholesky() {
        for (c, value) in placed.iter().zip(cholesky.solve(&along).iter()) {
            coefficients[c - 1] = -value;
        }
    }
    let without = design.residuals(&vec![0.0; coefficients.len()]);
    let moved = design.residuals(&coefficients);
    without.iter().zip(&moved).map(|(a, b)| shift_m(&Twist(std::array::from_fn(|k| a[k] - b[k])))).collect()
}

/// How many of an effect's columns are its own: what a warm-up effect adds as a constant is no part of it.
#[must_use]
pub(in crate::diagnose) fn reported(candidate: &Candidate, columns: usize) -> usize {
    let constant =
        candidate.effect().unit() != SizeUnit::Millimetre && candidate.effect().time() == TimeCourse::Drift;
    if constant { candidate.n_reported } else { columns }
}

/// How the effect moves the point at each station.
fn moved_by(linear: &Linearised, candidate: &Candidate, columns: &[usize], fit: &LinearFit) -> Vec<Twist> {
    let mut buffer = Vec::new();
    linear
        .dataset
        .observations
        .iter()
        .map(|observation| {
            buffer.clear();
            candidate.effect().signature(&candidate.variant, linear.dataset.at(observation), &mut buffer);
            let n_reported = reported(candidate, buffer.len());
            let mut sum = Twist::default();
            for ((twist, &column), prior_sigma) in
                buffer.iter().zip(columns).zip(&candidate.prior_sigma).take(n_reported)
            {
                for (to, from) in sum.iter_mut().zip(twist) {
                    *to += fit.coefficients[column - 1] * prior_sigma * from;
                }
            }
            sum
        })
        .collect()
}
