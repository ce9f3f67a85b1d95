//! An arm whose geometry is far off was never calibrated: what the joints' zeros alone would take of its gap.
//!
//! Geometry wide enough to hold them leaves the evidence little to tell offsets by, and they are then not named as causes.
//! They are still the first thing to look at, and the cheapest to mend.

use super::model::{FittedModel, Workspace};
use super::outcome::{JointZero, JointZeros};
use inference::linear_fit::solve;
use inference::linearise::shift_m;
use inference::search::ChosenCause;
use robot_model::deform::EffectKind;
use robot_model::units::mm_from_m;
use std::sync::Arc;

/// Zeros that take less than this share of the gap's square are not worth a word.
const WORTH: f64 = 0.3;

/// The zeros fitted with base and target alone; none where they take little.
pub(super) fn zeros(fitted: &mut FittedModel<'_>) -> Option<JointZeros> {
    let FittedModel { model, workspace, .. } = fitted;
    let candidates = Arc::clone(&workspace.library.candidates);
    let offsets: Vec<usize> = (0..candidates.len())
        .filter(|&c| candidates[c].kind == EffectKind::JointOffset && candidates[c].variant.joint.is_some())
        .collect();
    let Workspace { design, library, column_index } = &mut *workspace;
    let columns = library.columns_in_design(design, column_index, &offsets);
    // Free: what they would be if they were all.
    let free = |(candidate, columns)| ChosenCause { candidate, columns, gain_nats: 0.0, size_ratio: 1e9 };
    let chosen: Vec<ChosenCause> = offsets.into_iter().zip(columns).map(free).collect();
    workspace.library.extend(&workspace.design);
    let groups = workspace.design.all_groups();
    let rms_m = |chosen: &[ChosenCause]| {
        let fit = solve(&workspace.design, &groups, chosen, None);
        let left = workspace.design.residuals(&fit.coefficients);
        let kept = || left.iter().zip(&model.outliers).filter(|(_, out)| !**out).map(|(m, _)| shift_m(m));
        ((kept().map(|d| d * d).sum::<f64>() / kept().count().max(1) as f64).sqrt(), fit)
    };
    let (before_m, _) = rms_m(&[]);
    let (after_m, fit) = rms_m(&chosen);
    if after_m * after_m > (1.0 - WORTH) * before_m * before_m {
        return None;
    }
    let zero = |c: &ChosenCause| {
        let candidate = &candidates[c.candidate];
        let value = fit.coefficients[c.columns[0] - 1] * candidate.prior_sigma.first()?;
        Some(JointZero { joint: candidate.variant.joint?, offset_rad: value })
    };
    Some(JointZeros {
        before_rms_mm: mm_from_m(before_m),
        after_rms_mm: mm_from_m(after_m),
        joints: chosen.iter().filter_map(zero).collect(),
    })
}
