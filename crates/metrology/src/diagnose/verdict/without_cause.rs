//! The verdict on a model without a cause: noise, slow noise, structure of no cause, scatter, or geometry.

use super::cause_group::{OpenSlot, SlotScan, spoken_for};
use super::judgement::Judgement;
use super::listing::WORTH_SAYING;
use super::noise::{
    MAX_RESIDUAL_SHARE, MOSTLY_SLOW, SLOW_AS_NOISE, SLOW_NOISE, SMOOTH_NATS, Scatter, Slowness, slow_noise,
    slowness, smoothness_nats,
};
use super::size::cause;
use super::structure::{LikeliestStructure, likeliest_structure, location_of_gp, over_time};
use super::wording::{only_missing, structure_reason};
use crate::diagnose::model::FittedModel;
use crate::diagnose::outcome::{Location, Verdict};
use inference::gp_alternative::GpAlternative;
use inference::linearise::rms_m;
use inference::missing_channel::MissingChannel;
use statistics::ALARM_NATS;

/// Judges what is left where the search chose nothing.
pub(super) fn without_cause(fitted: &mut FittedModel<'_>, rest: &SlotScan, scatter: Scatter) -> Judgement {
    let ranking = &rest.ranking;
    let (mut cause_groups, others) = spoken_for(&fitted.workspace, ranking);
    // Without one that the data speak for, those that they speak against least.
    let candidates = if cause_groups.is_empty() { &others } else { &cause_groups };
    let mut causes = Vec::new();
    for cause_group in candidates.iter().take(3).filter(|g| g.probability > WORTH_SAYING) {
        causes.push(cause(fitted, &[], None, cause_group));
    }
    cause_groups.extend(others);
    let mut judgement = Judgement {
        verdict: Verdict::NothingAboveNoise,
        reason: "no effect of the library stands out of the noise".to_owned(),
        causes,
        alternatives: Vec::new(),
        location: Location::default(),
        missing_channel: None,
        open: vec![OpenSlot::new(None, &cause_groups, 1)],
        reduced_chi_square: None,
    };
    let slowness = slowness(fitted, &[]);
    let found = likeliest_structure(&fitted.workspace, ranking).filter(|found| found.gain_nats > ALARM_NATS);
    let slow = slowness == Slowness::WithinNoise && found.is_none()
        || found.is_some_and(|found| slow_noise(fitted, found.gp_alternative));
    if slow {
        SLOW_NOISE.clone_into(&mut judgement.reason);
    } else if slowness == Slowness::AsOfNoise {
        SLOW_AS_NOISE.clone_into(&mut judgement.reason);
    }
    // Slow noise that is fitted beside it is no part of what geometry gains; slow noise that is not could be all of it.
    let geometry = rest.geometry_gain_nats > ALARM_NATS && (!slow || fitted.model.slow.is_some());
    let found = found.filter(|_| !slow);
    let timed = fitted.linear.dataset.time_min.is_some();
    if found.is_none() && is_structure(fitted, slowness, geometry) {
        judgement.verdict = Verdict::UnexplainedStructure;
        judgement.location = over_time(fitted, &[]);
        judgement.reason = structure_reason(GpAlternative::Time, timed);
        judgement.missing_channel = MissingChannel::of(GpAlternative::Time, timed);
    } else if let Some(LikeliestStructure { gp_alternative, .. }) = found {
        judgement.verdict = Verdict::UnexplainedStructure;
        judgement.location = location_of_gp(fitted, &[], gp_alternative);
        let likeliest = fitted.workspace.library.gp_alternatives[gp_alternative].gp_alternative;
        judgement.reason = structure_reason(likeliest, timed);
        judgement.missing_channel = MissingChannel::of(likeliest, timed);
    } else if scatter.chi.is_some() || scatter.along.is_some() {
        judgement.verdict = Verdict::UnexplainedScatter;
        judgement.location.joint = scatter.along.map(|a| a.joint);
        judgement.reason = scatter.reason(&fitted.linear.dataset);
        judgement.missing_channel = only_missing(&fitted.linear.dataset);
    } else if geometry {
        judgement.verdict = Verdict::Geometry;
        "small errors of all joints' geometry take the gap; none stands out"
            .clone_into(&mut judgement.reason);
    }
    judgement
}

/// Whether what is slow is structure over time: not where it is small against what `geometry` takes, and no more than noise may have, unless
/// it is more than the noise that is known and clearly a function of time.
fn is_structure(fitted: &FittedModel<'_>, slowness: Slowness, geometry: bool) -> bool {
    let Slowness::Structure { rms_m: slow_m, noise_known } = slowness else { return false };
    let FittedModel { model, linear, .. } = fitted;
    let before_m = rms_m(&linear.nominal, |i| !model.outliers[i]);
    let of_geometry_m = (before_m.powi(2) - 3.0 * model.noise_m().powi(2)).max(0.0).sqrt();
    let mostly_slow = model.slow.is_some_and(|slow| slow.size > MOSTLY_SLOW);
    !geometry
        || mostly_slow
        || slow_m > MAX_RESIDUAL_SHARE * of_geometry_m
        || noise_known && smoothness_nats(fitted, &[]) > SMOOTH_NATS
}
