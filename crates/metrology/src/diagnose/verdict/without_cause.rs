//! The verdict on a model without a cause: noise, slow noise, structure of no cause, scatter, or geometry.

use super::cause_group::{OpenSlot, SlotScan, cause_groups};
use super::judgement::Judgement;
use super::listing::WORTH_SAYING;
use super::noise::{SLOW_NOISE, Scatter, Slowness, slow_noise, slowness};
use super::size::cause;
use super::structure::{LikeliestStructure, likeliest_structure, location_of_gp, over_time};
use super::wording::structure_reason;
use crate::diagnose::gp_alternative::GpAlternative;
use crate::diagnose::model::FittedModel;
use crate::diagnose::outcome::{Location, Verdict};
use crate::diagnose::search::ALARM_NATS;

/// Judges what is left where the search chose nothing.
pub(super) fn without_cause(fitted: &mut FittedModel<'_>, rest: &SlotScan, scatter: Scatter) -> Judgement {
    let ranking = &rest.ranking;
    let cause_groups = cause_groups(&fitted.workspace, ranking);
    let mut causes = Vec::new();
    for cause_group in cause_groups.iter().take(3).filter(|g| g.probability > WORTH_SAYING) {
        causes.push(cause(fitted, &[], None, cause_group));
    }
    let mut judgement = Judgement {
        verdict: Verdict::NothingAboveNoise,
        reason: "no effect of the library stands out of the noise".to_owned(),
        causes,
        alternatives: Vec::new(),
        location: Location::default(),
        open: vec![OpenSlot::new(None, &cause_groups, 1)],
        reduced_chi_square: None,
    };
    let slowness = slowness(fitted, &[]);
    let found = likeliest_structure(&fitted.workspace, ranking).filter(|found| found.gain_nats > ALARM_NATS);
    let slow = slowness == Slowness::WithinNoise && found.is_none()
        || found.is_some_and(|found| slow_noise(fitted, found.gp_alternative));
    if slow {
        SLOW_NOISE.clone_into(&mut judgement.reason);
    }
    if let (Slowness::Structure { .. }, None) = (slowness, found) {
        judgement.verdict = Verdict::UnexplainedStructure;
        judgement.location = over_time(fitted, &[]);
        judgement.reason = structure_reason(GpAlternative::Time, fitted.linear.dataset.time_min.is_some());
    } else if let Some(LikeliestStructure { gp_alternative, .. }) = found.filter(|_| !slow) {
        judgement.verdict = Verdict::UnexplainedStructure;
        judgement.location = location_of_gp(fitted, &[], gp_alternative);
        judgement.reason = structure_reason(
            fitted.workspace.library.gp_alternatives[gp_alternative].gp_alternative,
            fitted.linear.dataset.time_min.is_some(),
        );
    } else if scatter.chi.is_some() || scatter.along.is_some() {
        judgement.verdict = Verdict::UnexplainedScatter;
        judgement.location.joint = scatter.along.map(|a| a.joint);
        judgement.reason = scatter.reason(&fitted.linear.dataset);
    } else if rest.geometry_gain_nats > ALARM_NATS && (!slow || fitted.model.slow.is_some()) {
        // Slow noise that is fitted beside it is no part of what geometry gains; slow noise that is not could be all of it.
        judgement.verdict = Verdict::Geometry;
        "small errors of all joints' geometry take the gap; none stands out"
            .clone_into(&mut judgement.reason);
    }
    judgement
}
