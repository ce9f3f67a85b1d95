//! Sizes of causes that are named beside another because they are one and the same to any poses: each as it would be in the other's place.

use super::cause_group::CauseGroup;
use super::doubt::beam;
use super::size::{cause, rms};
use crate::diagnose::model::FittedModel;
use inference::cause::Cause;
use inference::dataset::Observation;
use inference::evidence::NuisanceModel;
use inference::linearise::Linearised;
use inference::search::{ChosenCause, cause_columns};
use nalgebra::Vector3;
use robot_model::deform::EffectKind;
use robot_model::units::{mm_from_m, ratio_from_ppm};

/// Fits the link that is one beam with the one that `group` bends, in place `i` of `chosen`, where it is named there without a size.
pub(super) fn fit_beam(
    fitted: &mut FittedModel<'_>,
    chosen: &[ChosenCause],
    i: usize,
    group: &CauseGroup,
    causes: &mut [Cause],
) {
    let Some([before, link]) = beam(fitted, group.best) else { return };
    let is_first =
        |c: &&Cause| c.slot == i + 1 && c.effect == EffectKind::LinkBending && c.joint == Some(link);
    let first = causes.iter().find(is_first).cloned();
    let is_twin = |c: &&mut Cause| {
        let is_bent = c.effect == EffectKind::LinkBending && c.joint == Some(before);
        c.slot == i + 1 && is_bent && c.size.is_none()
    };
    let Some(named) = causes.iter_mut().find(is_twin) else { return };
    let candidates = &fitted.workspace.library.candidates;
    let refined = candidates[group.best].variant.refined;
    let bends = (0..candidates.len())
        .filter(|&c| candidates[c].kind == EffectKind::LinkBending)
        .find(|&c| candidates[c].variant.joint == Some(before) && candidates[c].variant.refined == refined);
    let Some(best) = bends else {
        // In this robot's file it has no length of its own: the beam is the other one, under another name.
        if let Some(Cause { size, sigma, rms_mm, rms_seen_mm, rms_of_gap_mm, evidence_nats, .. }) = first {
            *named =
                Cause { size, sigma, rms_mm, rms_seen_mm, rms_of_gap_mm, evidence_nats, ..named.clone() };
        }
        return;
    };
    let design = &fitted.workspace.design;
    let groups = design.all_groups();
    let nuisance = NuisanceModel::new(design, &groups, &cause_columns(chosen, Some(i)), fitted.model.noise);
    let twin = CauseGroup {
        best,
        probability: named.posterior,
        gain_nats: fitted.workspace.library.gain(&nuisance, &groups, best),
        size_ratio: group.size_ratio,
        lines: Vec::new(),
    };
    let (slot, posterior) = (named.slot, named.posterior);
    *named = Cause { slot, posterior, ..cause(fitted, chosen, Some(i), &twin) };
}

/// Gives a scale of all links, where it is named beside one of the instrument, the size that this one has: each link longer by the same share.
pub(super) fn fit_links_scale(linear: &Linearised, causes: &mut [Cause]) {
    let scale = causes.iter().find(|c| c.effect == EffectKind::InstrumentScale).cloned();
    let links = causes.iter_mut().find(|c| c.effect == EffectKind::LinkGeometry && c.joint.is_none());
    let Some((scale, links)) = scale.zip(links.filter(|links| links.size.is_none())) else { return };
    let mm_per_ppm = |length_m: f64| ratio_from_ppm(1.0) * mm_from_m(length_m);
    let Some(first) = linear.dataset.of_arm().next() else { return };
    let all_links_mm = mm_per_ppm(along_links_m(first).map(|along| along.norm_squared()).sum::<f64>().sqrt());
    let reach_m = |observation| along_links_m(observation).sum::<Vector3<f64>>().norm();
    let reaches_m: Vec<f64> = linear.dataset.of_arm().map(reach_m).collect();
    links.size = scale.size.map(|ppm| ppm * all_links_mm);
    links.sigma = scale.sigma.map(|ppm| ppm * all_links_mm);
    links.rms_mm = scale.size.map(|ppm| ppm * mm_per_ppm(rms(&reaches_m)));
    // To these data they are the same.
    links.rms_seen_mm = scale.rms_seen_mm;
    links.rms_of_gap_mm = scale.rms_of_gap_mm;
    links.evidence_nats = scale.evidence_nats;
}

/// From the root of each link to its tip, base axes, metres.
fn along_links_m(observation: &Observation) -> impl Iterator<Item = Vector3<f64>> + '_ {
    (0..observation.joints()).map(|i| observation.origins_m[i + 1] - observation.carried_m[i])
}
