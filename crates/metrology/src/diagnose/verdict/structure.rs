//! Structure of no named cause beside the causes: is there any, where, and could it replace them.

use super::cycles;
use super::overtones::{has_corners, line_odds, overtones};
use super::size::total_rms_m;
use crate::diagnose::model::{FittedModel, Model, Workspace};
use crate::diagnose::outcome::{Location, Region};
use inference::dataset::NUMBERS_OF_POINT;
use inference::effects::Candidate;
use inference::evidence::{EvidencePeak, NuisanceModel};
use inference::gp_alternative::{self, Ball, GpAlternative, WeightedAlternative};
use inference::gp_over_time;
use inference::gp_tool;
use inference::linear_fit::solve;
use inference::linearise::{Linearised, shift_m};
use inference::search::{
    ChosenCause, DROP_NATS, Hypothesis, HypothesisRanking, NULL_PRIOR, RankedHypothesis, UNEXPLAINED_PRIOR,
};
use inference::time_course::TimeCourse;
use robot_model::deform::EffectKind;
use robot_model::robot::Axis;
use robot_model::units::mm_from_m;
use statistics::{ALARM_NATS, log_sum};
use std::collections::{BTreeMap, BTreeSet};

/// More lines of one joint than this are many gears, not one shape.
const MOST_OVERTONES: usize = 10;
/// Share of periodic shapes in structure of no named cause; each period pays for the scan as a line of it does.
const PERIOD_WEIGHT: f64 = 0.05;
/// Share of a load that comes and goes unrecorded, and of what goes to and fro, in structure of no named cause.
const HIDDEN_LOAD_WEIGHT: f64 = 0.1;
const CYCLE_WEIGHT: f64 = 0.1;
/// Share of what comes and goes with the payload that is written, beside compliance, in structure of no named cause.
const WITH_LOAD_WEIGHT: f64 = 0.03;
/// Prior of one cause that varies, over that of all other structure.
const VARYING_WEIGHT: f64 = 0.1;
/// Structure beside the causes whose rms is under this share of theirs does not call them into doubt, even where a GP
/// alternative could replace one of them.
pub(super) const NEGLIGIBLE_STRUCTURE_RATIO: f64 = 0.25;
/// With more causes than this each gear line is not tried against all others again.
pub(super) const MANY_CAUSES: usize = 8;

/// Probability of all structure in a ranking.
#[must_use]
pub(super) fn gp_alternative_share(ranking: &HypothesisRanking) -> f64 {
    ranking
        .ranked
        .iter()
        .filter(|RankedHypothesis { hypothesis: h, .. }| matches!(h, Hypothesis::GpAlternative(_)))
        .map(|r| r.probability)
        .sum()
}

/// Whether `gp_alternative` is a mere shape of `candidate`: a joint that turns slowly over time, somehow, is what a joint does that
/// drifts as it warms.
fn is_shape_of(workspace: &Workspace<'_>, gp_alternative: usize, candidate: usize) -> bool {
    let this = &workspace.library.candidates[candidate];
    let warming = (this.kind == EffectKind::ThermalJointDrift).then_some(this.variant.joint).flatten();
    match workspace.library.gp_alternatives[gp_alternative].gp_alternative {
        GpAlternative::JointTime(j) | GpAlternative::JointTimeFine(j) => Some(j) == warming,
        _ => false,
    }
}

/// Causes of one place that together are less likely than this leave no choice between them: a set has the truth in it.
const LEAST_OF_PLACE: f64 = 0.25;

/// Probability of the structure in a ranking that is no mere shape of `candidate`, whose place has causes of probability `causes_share` together: a
/// course like the cause's own speaks for the cause, unless hardly anything else does.
#[must_use]
pub(super) fn alternative_share(
    workspace: &Workspace<'_>,
    ranking: &HypothesisRanking,
    candidate: usize,
    causes_share: f64,
) -> f64 {
    if causes_share < LEAST_OF_PLACE {
        return gp_alternative_share(ranking);
    }
    let alternative = |RankedHypothesis { hypothesis: h, .. }: &&RankedHypothesis| matches!(h, Hypothesis::GpAlternative(k) if !is_shape_of(workspace, *k, candidate));
    ranking.ranked.iter().filter(alternative).map(|r| r.probability).sum()
}

/// Structure of no cause, and its likeliest form.
#[derive(Clone, Copy, Debug)]
pub(super) struct LikeliestStructure {
    /// ln evidence of all structure over nothing, priors within the GP alternatives included.
    pub gain_nats: f64,
    /// Index of the likeliest GP alternative.
    pub gp_alternative: usize,
}

/// The structure in a ranking; `None` where no GP alternative was ranked.
#[must_use]
pub(super) fn likeliest_structure(
    workspace: &Workspace<'_>,
    ranking: &HypothesisRanking,
) -> Option<LikeliestStructure> {
    let log_prior = |k: usize| workspace.library.gp_alternatives[k].log_prior;
    let terms =
        ranking.gp_alternatives().map(|(k, peak)| peak.log_evidence + log_prior(k) - UNEXPLAINED_PRIOR.ln());
    let gain_nats = log_sum(terms) - ranking.null.log_evidence;
    let (gp_alternative, _) = ranking.gp_alternatives().next()?;
    Some(LikeliestStructure { gain_nats, gp_alternative })
}

/// Steps and teeth of the gears that lines were found of, each at the periods of its lines and at what these have in common.
fn shapes_of_gears(
    linear: &Linearised,
    model: &Model,
    workspace: &mut Workspace<'_>,
) -> Vec<WeightedAlternative> {
    let chosen = model.chosen.as_slice();
    let mut list = Vec::new();
    let mut periods: BTreeSet<(Axis, u32)> = BTreeSet::new();
    for (joint, lines) in
        lines_by_joint(workspace, chosen).into_iter().filter(|(_, l)| l.len() <= MOST_OVERTONES)
    {
        let orders: Vec<u32> = lines
            .iter()
            .filter_map(|&i| workspace.library.candidates[chosen[i].candidate].variant.n)
            .collect();
        let common = orders.iter().copied().fold(0, greatest_common_divisor);
        periods.extend(orders.into_iter().chain([common]).filter(|n| *n > 0).map(|n| (joint, n)));
    }
    let of_line = |joint: Axis, n: u32| {
        let variant = |c: &&Candidate| c.variant.joint == Some(joint) && c.variant.n == Some(n);
        workspace.library.candidates.iter().find(variant).map_or(0.0, |c| c.weight)
    };
    for (joint, n) in periods {
        let of_joint = |cause: &&ChosenCause| {
            let variant = workspace.library.candidates[cause.candidate].variant;
            variant.joint == Some(joint) && variant.n.is_some()
        };
        let others: Vec<ChosenCause> = chosen.iter().filter(|cause| !of_joint(cause)).cloned().collect();
        if !has_corners((linear, model, &mut workspace.design), &others, (joint, n)) {
            continue;
        }
        let weight = 0.5 * PERIOD_WEIGHT * of_line(joint, n);
        list.extend(
            [GpAlternative::Periodic(joint, n), GpAlternative::SquareWave(joint, n)]
                .map(|shape| shape.weighing(weight)),
        );
    }
    list
}

/// Structure that no effect takes: everywhere, and round the causes that were found.
pub(super) fn add_gp_alternatives(fitted: &mut FittedModel<'_>) {
    let FittedModel { model, workspace, linear } = fitted;
    let (dataset, chosen) = (&linear.dataset, model.chosen.as_slice());
    let mut list = gp_alternative::gp_alternatives(dataset.joints());
    list.extend(shapes_of_gears(linear, model, workspace));
    // A step has its course already; varied, it is all that base or target could do over the rows.
    let is_no_step =
        |i: &usize| workspace.library.candidates[chosen[*i].candidate].variant.t0_min().is_none();
    if dataset.time_min.is_none() && chosen.len() <= MANY_CAUSES {
        list.extend(
            (0..chosen.len())
                .filter(is_no_step)
                .map(|i| GpAlternative::TimeVaryingCause(i).weighing(VARYING_WEIGHT)),
        );
    }
    // Rows without times are often in the order of their places, and what the arm gives there is all its sag.
    if !dataset.channels.payload && dataset.time_min.is_some() {
        list.push(GpAlternative::HiddenLoad.weighing(HIDDEN_LOAD_WEIGHT));
    }
    if dataset
        .observations
        .iter()
        .any(|o| o.payload_kg.is_some_and(|kg| kg < 0.5 * dataset.largest_payload_kg))
    {
        list.extend(
            [GpAlternative::LoadedTarget, GpAlternative::LoadedZeros]
                .map(|one| one.weighing(WITH_LOAD_WEIGHT)),
        );
    }
    let plays = chosen.iter().map(|cause| &workspace.library.candidates[cause.candidate]);
    let plays =
        plays.filter(|cause| cause.kind == EffectKind::Backlash).filter_map(|cause| cause.variant.joint);
    list.extend(plays.map(|joint| GpAlternative::LoadedPlay(joint).weighing(WITH_LOAD_WEIGHT)));
    let cycles = cycles::significant_peaks(dataset, &model.residuals, &model.outliers);
    list.extend(
        cycles
            .into_iter()
            .map(|line| GpAlternative::Cycle(line.half_cycles).weighing(CYCLE_WEIGHT * line.share)),
    );
    let design = &workspace.design;
    workspace.library.add_gp_alternatives(design, list, &|gp_alternative| match gp_alternative {
        GpAlternative::TimeVaryingCause(i) => {
            gp_over_time::time_varying_columns(design, dataset, &chosen[i].columns)
        }
        GpAlternative::WanderingScale => {
            let instrument_m = linear.registration.instrument_from_base.inverse().translation.vector;
            gp_tool::wandering_scale_columns(design, dataset, instrument_m)
        }
        other => gp_alternative::columns(other, design, dataset),
    });
}

/// A GP alternative that is likelier than all lines of one joint's gear together: steps and teeth of one shape, not
/// many gears.
pub(super) fn shape_of_lines(fitted: &FittedModel<'_>, chosen: &[ChosenCause]) -> Option<usize> {
    let FittedModel { model, workspace, .. } = fitted;
    let groups = workspace.design.all_groups();
    let whole_m = total_rms_m(fitted, chosen);
    let overtones = overtones(fitted, chosen);
    for (joint, lines) in lines_by_joint(workspace, chosen) {
        let rest: Vec<ChosenCause> =
            (0..chosen.len()).filter(|i| !lines.contains(i)).map(|i| chosen[i].clone()).collect();
        let taken_m = (whole_m.powi(2) - total_rms_m(fitted, &rest).powi(2)).max(0.0).sqrt();
        if lines.len() > MOST_OVERTONES || taken_m < NEGLIGIBLE_STRUCTURE_RATIO * whole_m {
            continue;
        }
        let others: Vec<usize> = (0..chosen.len())
            .filter(|i| !lines.contains(i))
            .flat_map(|i| chosen[i].columns.iter().copied())
            .collect();
        let mut nuisance = NuisanceModel::new(&workspace.design, &groups, &others, model.noise);
        let bare = nuisance.null().log_evidence;
        let mut best: Option<(f64, usize)> = None;
        for (k, structure) in workspace.library.gp_alternatives.iter().enumerate() {
            let fits = match structure.gp_alternative {
                GpAlternative::Periodic(j, n) | GpAlternative::SquareWave(j, n) => {
                    j == joint && !lacks_odd_harmonics(workspace, chosen, &lines, n)
                }
                GpAlternative::Joint(j) | GpAlternative::JointFine(j) => j == joint,
                _ => false,
            };
            if fits {
                let peak = nuisance.evidence(&nuisance.project(&structure.sums));
                let odds = peak.log_evidence - bare + structure.log_prior - NULL_PRIOR.ln();
                if best.is_none_or(|(b, _)| odds > b) {
                    best = Some((odds, k));
                }
            }
        }
        let mut together = 0.0;
        for &i in &lines {
            together += line_odds(fitted, &nuisance, (chosen, i), &overtones);
            nuisance.grow(&workspace.design, &groups, &chosen[i].columns);
        }
        if let Some((_, gp_alternative)) = best.filter(|(odds, _)| *odds > together + DROP_NATS) {
            return Some(gp_alternative);
        }
    }
    None
}

/// Steps and corners show in odd harmonics: a square has a third of its amplitude at three times its periods per turn, a saw tooth too. Lines of
/// a gear that are so many, none of them an odd multiple of `n` periods but the first, are smooth.
fn lacks_odd_harmonics(workspace: &Workspace<'_>, chosen: &[ChosenCause], lines: &[usize], n: u32) -> bool {
    /// Of fewer lines the odd ones may be those that are not seen.
    const ENOUGH: usize = 3;
    let periods = lines.iter().filter_map(|&i| workspace.library.candidates[chosen[i].candidate].variant.n);
    let multiple = |m: u32| (m.is_multiple_of(n)).then_some(m / n);
    lines.len() >= ENOUGH && periods.map(multiple).all(|k| k.is_some_and(|k| k == 1 || k.is_multiple_of(2)))
}

/// A cause that must have grown or faded over rows whose time is not known: then it is not the cause.
pub(super) fn varying_cause(workspace: &Workspace<'_>, rest: &HypothesisRanking) -> Option<usize> {
    let varies = |k: usize| {
        let of = workspace.library.gp_alternatives[k].gp_alternative;
        matches!(of, GpAlternative::TimeVaryingCause(_))
    };
    let clear = |peak: &EvidencePeak| rest.over_null_nats(peak) > ALARM_NATS;
    rest.gp_alternatives().find(|(k, peak)| varies(*k) && clear(peak)).map(|(k, _)| k)
}

/// Play of a joint that grows or shrinks with the torque on it, clearly and by more than hardly anything of what the play does: friction.
pub(super) fn loaded_play(
    fitted: &FittedModel<'_>,
    chosen: &[ChosenCause],
    rest: &HypothesisRanking,
) -> Option<usize> {
    let library = &fitted.workspace.library;
    // A sigma is of all rows of a station, its orientation's too, which see little of what joints near the base do.
    let of_points = (fitted.linear.dataset.rows_per_observation as f64 / NUMBERS_OF_POINT as f64).sqrt();
    let is_friction = |(k, peak): &(usize, EvidencePeak)| {
        let GpAlternative::LoadedPlay(joint) = library.gp_alternatives[*k].gp_alternative else {
            return false;
        };
        let play = chosen.iter().find(|cause| {
            let candidate = &library.candidates[cause.candidate];
            candidate.kind == EffectKind::Backlash && candidate.variant.joint == Some(joint)
        });
        let play_m = play.map_or(0.0, |play| total_rms_m(fitted, std::slice::from_ref(play)));
        let left_m = of_points * left_over_m(rest, *k);
        rest.over_null_nats(peak) > ALARM_NATS && left_m > NEGLIGIBLE_STRUCTURE_RATIO * play_m
    };
    rest.gp_alternatives().find(is_friction).map(|(k, _)| k)
}

/// How large the structure is that a GP alternative takes after the causes, 3-D rms, metres.
pub(super) fn left_over_m(ranking: &HypothesisRanking, gp_alternative: usize) -> f64 {
    let with = ranking.gp_alternatives().find(|(k, _)| *k == gp_alternative);
    let sigma_with = with.map_or(ranking.null.sigma_m, |(_, peak)| peak.sigma_m);
    (3.0 * (ranking.null.sigma_m.powi(2) - sigma_with.powi(2)).max(0.0)).sqrt()
}

/// ln odds of structure alone, of no cause a mere shape, over all causes together.
pub(super) fn odds_over_causes(fitted: &FittedModel<'_>, chosen: &[ChosenCause]) -> f64 {
    let FittedModel { model, workspace, .. } = fitted;
    let groups = workspace.design.all_groups();
    let mut nuisance = NuisanceModel::new(&workspace.design, &groups, &[], model.noise);
    let ranking = workspace.library.rank_gp_alternatives(&nuisance);
    let mere_shape = |k: usize| chosen.iter().any(|c| is_shape_of(workspace, k, c.candidate));
    let log_prior = |k: usize| workspace.library.gp_alternatives[k].log_prior;
    let terms = ranking
        .gp_alternatives()
        .filter(|(k, _)| !mere_shape(*k))
        .map(|(k, peak)| peak.log_evidence + log_prior(k) - NULL_PRIOR.ln());
    let structure = log_sum(terms) - ranking.null.log_evidence;
    structure - causes_log_odds(fitted, &mut nuisance, chosen)
}

/// ln odds over nothing of `causes`, one after the other, over `nuisance`, which has them in the end.
pub(super) fn causes_log_odds<'a>(
    fitted: &FittedModel<'_>,
    nuisance: &mut NuisanceModel,
    causes: impl IntoIterator<Item = &'a ChosenCause>,
) -> f64 {
    let Workspace { design, library, .. } = &fitted.workspace;
    let groups = design.all_groups();
    let mut odds = 0.0;
    for one in causes {
        let c = one.candidate;
        odds += library.gain(nuisance, &groups, c) + library.log_prior[c] - NULL_PRIOR.ln();
        nuisance.grow(design, &groups, &one.columns);
    }
    odds
}

/// ln odds of structure over nothing from its ln evidence.
#[must_use]
pub(super) fn structure_odds(gain_nats: f64) -> f64 {
    gain_nats + UNEXPLAINED_PRIOR.ln() - NULL_PRIOR.ln()
}

/// Where the structure lies.
#[must_use]
pub(super) fn location_of_gp(
    fitted: &FittedModel<'_>,
    chosen: &[ChosenCause],
    gp_alternative: usize,
) -> Location {
    let FittedModel { model, workspace, linear } = fitted;
    let groups = workspace.design.all_groups();
    let fit = solve(&workspace.design, &groups, chosen, Some(model.peak.geometry_ratio));
    let left: Vec<f64> = workspace.design.residuals(&fit.coefficients).iter().map(shift_m).collect();
    let kind = workspace.library.gp_alternatives[gp_alternative].gp_alternative;
    Location {
        joint: match kind {
            GpAlternative::Joint(j)
            | GpAlternative::JointFine(j)
            | GpAlternative::Driven(_, j)
            | GpAlternative::Joints(j)
            | GpAlternative::Pair(_, _, j)
            | GpAlternative::JointTime(j)
            | GpAlternative::JointTimeFine(j)
            | GpAlternative::LoadedPlay(j)
            | GpAlternative::Periodic(j, _)
            | GpAlternative::SquareWave(j, _) => Some(j),
            _ => None,
        },
        time: Some(match kind {
            GpAlternative::Time
            | GpAlternative::TimeFine
            | GpAlternative::ToolTime
            | GpAlternative::JointTime(_)
            | GpAlternative::JointTimeFine(_)
            | GpAlternative::HiddenLoad
            | GpAlternative::Cycle(_)
            | GpAlternative::WanderingScale
            | GpAlternative::TimeVaryingCause(_) => TimeCourse::Drift,
            _ => TimeCourse::Constant,
        }),
        region: region_of(linear, &left),
    }
}

/// Where structure over time lies that is no function of its own in the ranking.
#[must_use]
pub(super) fn over_time(fitted: &FittedModel<'_>, chosen: &[ChosenCause]) -> Location {
    let left: Vec<f64> = fitted.residuals_beside(chosen).iter().map(shift_m).collect();
    Location { joint: None, time: Some(TimeCourse::Drift), region: region_of(fitted.linear, &left) }
}

/// Where in the workspace stations move most.
#[must_use]
pub(super) fn region_of(linear: &Linearised, moved_m: &[f64]) -> Region {
    let Ball { centre_m: c, radius_m } = gp_alternative::region(&linear.dataset, moved_m);
    Region { center_mm: [c.x, c.y, c.z].map(mm_from_m), radius_mm: mm_from_m(radius_m) }
}

/// Places in `chosen` of lines of each joint's gear.
fn lines_by_joint(workspace: &Workspace<'_>, chosen: &[ChosenCause]) -> BTreeMap<Axis, Vec<usize>> {
    let mut lines: BTreeMap<Axis, Vec<usize>> = BTreeMap::new();
    for (i, one) in chosen.iter().enumerate() {
        let variant = &workspace.library.candidates[one.candidate].variant;
        if let (Some(joint), Some(_)) = (variant.joint, variant.n) {
            lines.entry(joint).or_default().push(i);
        }
    }
    lines
}

fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}
