//! The verdict: what the evidence says, what it cannot tell apart, and when it must not say anything.

mod cause_group;
mod cycles;
mod noise;
mod size;
mod structure;
mod wording;

pub use cause_group::{OpenPlace, SHAPE_KNOWN_TO, shapes_in_doubt};
pub use wording::{GearBand, describe, describe_candidate, gear_bands};

use super::evidence::NuisanceModel;
use super::gp_alternative::GpAlternative;
use super::model::{FittedModel, Workspace};
use super::outcome::{Cause, Location, Verdict};
use super::search::{ALARM_NATS, ChosenCause, Hypothesis, HypothesisRanking};
use cause_group::{CauseGroup, cause_groups, credible, doubt_shapes, join_nested, scan};
use noise::{
    MAX_RESIDUAL_SHARE, ReducedChiSquare, SLOW_NOISE, Scatter, Slowness, joint_scatter, reduced_chi_square,
    slow_noise, slowness,
};
use robot_model::deform::EffectKind;
use size::{cause, cause_unfitted, line_among_many, moved_m, rms, total_rms_m};
use structure::{
    MANY_CAUSES, SMALL_BESIDE, add_gp_alternatives, alternative_share, gp_alternative_share, left_over_m,
    location_of_gp, odds_over_causes, over_time, region_of, shape_of_lines, structure as structure_in,
    structure_odds, varying_cause,
};
use wording::{in_short, structure_reason, switched_reason};

/// Structure of no cause that is this likely beside the causes makes them uncertain; likelier than they, it wins.
const GP_ALTERNATIVE_SHARE: f64 = 0.2;
/// A set larger than this, with structure of no cause as likely, is no set.
const LARGE_SET: usize = 6;

/// What is less likely than this is not listed.
const WORTH_SAYING: f64 = 0.005;
/// A cause that is alone in its place and less likely than this is not told apart from what is not in the library.
const LIKELIER_THAN_NOT: f64 = 0.5;
/// Of a bent spring that may as well be play: as likely as that.
const AS_MUCH_PLAY: f64 = 0.5;
/// More moments than this at which something jumped are no knocks: something was switched.
const MOST_STEPS: usize = 2;

/// The verdict and what it rests on.
pub struct Judgement {
    /// The verdict on the data.
    pub verdict: Verdict,
    /// The verdict in one sentence.
    pub reason: String,
    /// Causes in order of probability, the likeliest first.
    pub causes: Vec<Cause>,
    /// The likeliest explanations that were rejected.
    pub alternatives: Vec<Cause>,
    /// Where the gap lies: joint, time, region.
    pub place: Location,
    /// The places of the model with the causes that may stand there.
    pub open: Vec<OpenPlace>,
    /// Residual variance over the variance of the repeats.
    pub reduced_chi_square: Option<f64>,
}

/// A candidate's probability is one among the library's effects; where the verdict is that none of them explains the data, it
/// is halved: even odds at best that the verdict is wrong and the candidate right.
const AS_A_CANDIDATE: f64 = 0.5;

/// Judges the best model of the data.
#[must_use]
pub fn judge(fitted: &mut FittedModel<'_>) -> Judgement {
    let chosen = fitted.model.chosen.clone();
    fitted.workspace.library.forget_columns();
    add_gp_alternatives(fitted);
    let (rest, geometry_gain) = scan(fitted, &chosen, None);
    let chi = reduced_chi_square(fitted, &chosen);
    let along = joint_scatter(fitted).filter(|j| j.gain_nats > ALARM_NATS);
    let scatter = Scatter { chi: chi.filter(ReducedChiSquare::is_exceeded).map(|chi| chi.value), along };
    let mut judgement = if chosen.is_empty() {
        without_cause(fitted, &rest, geometry_gain, scatter)
    } else {
        with_causes(fitted, &chosen, &rest, scatter)
    };
    judgement.reduced_chi_square = chi.map(|chi| chi.value);
    if matches!(judgement.verdict, Verdict::UnexplainedStructure | Verdict::UnexplainedScatter) {
        for candidate in &mut judgement.causes {
            candidate.posterior *= AS_A_CANDIDATE;
        }
    }
    judgement
}

fn without_cause(
    fitted: &mut FittedModel<'_>,
    ranking: &HypothesisRanking,
    geometry_gain: f64,
    scatter: Scatter,
) -> Judgement {
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
        place: Location::default(),
        open: vec![OpenPlace::new(None, &cause_groups, 1)],
        reduced_chi_square: None,
    };
    let slowness = slowness(fitted, &[]);
    let found = structure_in(&fitted.workspace, ranking).filter(|(gain, _)| *gain > ALARM_NATS);
    let slow = slowness == Slowness::WithinNoise && found.is_none()
        || found.is_some_and(|(_, gp_alternative)| slow_noise(fitted, gp_alternative));
    if slow {
        SLOW_NOISE.clone_into(&mut judgement.reason);
    }
    if let (Slowness::Structure { .. }, None) = (slowness, found) {
        judgement.verdict = Verdict::UnexplainedStructure;
        judgement.place = over_time(fitted, &[]);
        judgement.reason = structure_reason(GpAlternative::Time, fitted.linear.dataset.time_min.is_some());
    } else if let Some((_, gp_alternative)) = found.filter(|_| !slow) {
        judgement.verdict = Verdict::UnexplainedStructure;
        judgement.place = location_of_gp(fitted, &[], gp_alternative);
        judgement.reason = structure_reason(
            fitted.workspace.library.gp_alternatives[gp_alternative].gp_alternative,
            fitted.linear.dataset.time_min.is_some(),
        );
    } else if scatter.chi.is_some() || scatter.along.is_some() {
        judgement.verdict = Verdict::UnexplainedScatter;
        judgement.place.joint = scatter.along.map(|a| a.joint);
        judgement.reason = scatter.reason(&fitted.linear.dataset);
    } else if geometry_gain > ALARM_NATS && !slow {
        judgement.verdict = Verdict::Geometry;
        "small errors of all joints' geometry take the gap; none stands out"
            .clone_into(&mut judgement.reason);
    }
    judgement
}

fn with_causes(
    fitted: &mut FittedModel<'_>,
    chosen: &[ChosenCause],
    rest: &HypothesisRanking,
    scatter: Scatter,
) -> Judgement {
    let mut causes = Vec::new();
    let mut alternatives = Vec::new();
    let mut open = Vec::new();
    let mut clear = 0;
    let mut winning_gp: Option<usize> = None;
    let mut needed = 0;
    let mut lost = Vec::new();
    let mut named = Vec::new();
    for i in 0..chosen.len() {
        if chosen.len() > MANY_CAUSES
            && fitted.workspace.library.candidates[chosen[i].candidate].variant.n.is_some()
        {
            let line = line_among_many(fitted, chosen, i);
            causes.push(Cause { slot: i + 1, ..line });
            needed += 1;
            clear += 1;
            continue;
        }
        let (ranking, _) = scan(fitted, chosen, Some(i));
        let mut cause_groups = cause_groups(&fitted.workspace, &ranking);
        join_nested(&fitted.workspace, &mut cause_groups);
        doubt_shapes(&fitted.workspace, &mut cause_groups);
        let Some(first) = cause_groups.first() else { continue };
        let near = credible(&cause_groups);
        let nothing =
            ranking.ranked.iter().find(|r| r.hypothesis == Hypothesis::Null).map_or(0.0, |r| r.probability);
        if nothing > first.probability.max(gp_alternative_share(&ranking)) {
            // Beside the others it is no longer needed.
            continue;
        }
        if is_named(&fitted.workspace, first, &named) {
            // The same cause once more, in another variant: what the first leaves of it.
            continue;
        }
        named.push(first.best);
        needed += 1;
        let gp_alternatives = alternative_share(&fitted.workspace, &ranking, first.best);
        let causes_share: f64 = near.iter().map(|g| g.probability).sum();
        if gp_alternatives > causes_share || near.len() > LARGE_SET && gp_alternatives > first.probability {
            winning_gp = structure_in(&fitted.workspace, &ranking).map(|s| s.1);
            lost.push(i);
        }
        let play_too = looks_like_play(fitted, first.best);
        clear += usize::from(
            near.len() == 1
                && !play_too
                && first.probability >= LIKELIER_THAN_NOT
                && gp_alternatives < GP_ALTERNATIVE_SHARE * causes_share,
        );
        open.push(OpenPlace::new(Some(i), &cause_groups, near.len()));
        for cause_group in &near {
            let found = cause(fitted, chosen, Some(i), cause_group);
            causes.push(Cause { slot: i + 1, ..found });
        }
        if play_too && let Some(spring) = causes.iter_mut().find(|c| c.slot == i + 1) {
            // Of the two the file prefers neither; the spring stands first.
            spring.posterior *= AS_MUCH_PLAY;
            let (joint, posterior) = (spring.joint, spring.posterior);
            causes.push(Cause { joint, slot: i + 1, ..Cause::of(EffectKind::Backlash, posterior) });
        }
        for cause_group in cause_groups.iter().skip(near.len()).take(3) {
            alternatives.push(cause_unfitted(&fitted.workspace, cause_group));
        }
    }
    for a in (1..causes.len()).rev() {
        if causes[..a].iter().any(|b: &Cause| same(b, &causes[a])) {
            causes.remove(a);
        }
    }
    let scale = causes.iter().any(|c| c.effect == EffectKind::InstrumentScale);
    if scale && !causes.iter().any(|c| c.effect == EffectKind::LinkGeometry) {
        // A scale of the instrument and a scale of all links are one and the same to these data.
        let slot = causes.iter().find(|c| c.effect == EffectKind::InstrumentScale).map_or(1, |c| c.slot);
        causes.push(Cause { slot, ..Cause::of(EffectKind::LinkGeometry, 0.0) });
    }
    let thousandths = |p: f64| (1000.0 * p).round();
    causes.sort_by(|a, b| {
        let size = |c: &Cause| c.rms_mm.unwrap_or(0.0);
        thousandths(b.posterior).total_cmp(&thousandths(a.posterior)).then(size(b).total_cmp(&size(a)))
    });

    let likely = |c: &Cause| c.posterior > WORTH_SAYING || scale && c.effect == EffectKind::LinkGeometry;
    causes.retain(likely);
    renumber(&mut causes);
    let alternatives = rejected(alternatives, &causes);
    let cause_rms_m = total_rms_m(fitted, chosen);
    let left = structure_in(&fitted.workspace, rest).filter(|(gain, _)| *gain > ALARM_NATS);
    let spread = fitted.model.visit_spread(&fitted.linear.dataset).sqrt();
    let left_rms_m = left.map_or(0.0, |(_, k)| spread * left_over_m(rest, k));
    let odds = odds_over_causes(fitted, chosen);
    let together = chosen.len() > 1 && odds > 0.0;
    // Structure alone that is likelier than the causes with structure beside them.
    let all =
        odds > structure_in(&fitted.workspace, rest).map_or(0.0, |(gain, _)| structure_odds(gain).max(0.0));
    let shape = shape_of_lines(fitted, chosen);
    let varies = varying_cause(&fitted.workspace, rest);
    winning_gp = shape.or(varies).or(winning_gp);
    // Structure that stays small beside the causes does not make them wrong.
    let beside = left.is_some() && left_rms_m < SMALL_BESIDE * cause_rms_m;
    // Causes that most of them structure could replace are no causes but its parts.
    let parts = lost.len() > 1 && 2 * lost.len() > needed && left.is_some();
    // Nor does structure that stands where a small one of them would.
    let kept: Vec<ChosenCause> =
        (0..chosen.len()).filter(|i| !lost.contains(i)).map(|i| chosen[i].clone()).collect();
    let kept_rms_m = if lost.is_empty() { cause_rms_m } else { total_rms_m(fitted, &kept) };
    let lost_rms_m = (cause_rms_m.powi(2) - kept_rms_m.powi(2)).max(0.0).sqrt();
    if lost_rms_m < MAX_RESIDUAL_SHARE * cause_rms_m {
        winning_gp = None;
    }
    let alone = (winning_gp.is_some() || together) && !beside || all || parts || shape.or(varies).is_some();

    let mut switched: Vec<u64> = chosen
        .iter()
        .filter_map(|c| fitted.workspace.library.candidates[c.candidate].variant.t0_min())
        .filter_map(|t0| fitted.linear.dataset.line_from(t0))
        .collect();
    switched.sort_unstable();
    switched.dedup();
    let slowness = slowness(fitted, chosen);
    let moved_m = moved_m(fitted, chosen);
    // Where nothing says how much noise there is, slow scatter as large as all that the causes move may be noise.
    let largest_slow_m = match slowness {
        Slowness::Structure { noise_known: false, .. } => cause_rms_m.max(rms(&moved_m)),
        _ => MAX_RESIDUAL_SHARE * cause_rms_m,
    };

    let mut place = Location { joint: causes.first().and_then(|c| c.joint), ..Location::default() };
    place.time = causes.first().map(|c| c.time);
    place.region = region_of(fitted.linear, &moved_m);
    let (verdict, reason) = if alone || left_rms_m > MAX_RESIDUAL_SHARE * cause_rms_m {
        let gp_alternative = winning_gp.or(left.map(|l| l.1)).or_else(|| {
            let groups = fitted.workspace.design.all_groups();
            let bare = NuisanceModel::new(&fitted.workspace.design, &groups, &[], fitted.model.noise);
            structure_in(&fitted.workspace, &fitted.workspace.library.rank_gp_alternatives(&bare))
                .map(|s| s.1)
        });
        let reason = gp_alternative.map_or_else(String::new, |k| {
            structure_reason(
                fitted.workspace.library.gp_alternatives[k].gp_alternative,
                fitted.linear.dataset.time_min.is_some(),
            )
        });
        match gp_alternative {
            Some(gp_alternative) => {
                place = location_of_gp(fitted, &[], gp_alternative);
                (Verdict::UnexplainedStructure, reason)
            }
            None => (Verdict::UnexplainedStructure, reason),
        }
    } else if let Slowness::Structure { rms_m, .. } = slowness
        && rms_m > largest_slow_m
    {
        place = over_time(fitted, chosen);
        (
            Verdict::UnexplainedStructure,
            structure_reason(GpAlternative::Time, fitted.linear.dataset.time_min.is_some()),
        )
    } else if !matches!(slowness, Slowness::Structure { .. }) && scatter.is_comparable(fitted, cause_rms_m) {
        place.joint = scatter.along.map(|a| a.joint);
        (Verdict::UnexplainedScatter, scatter.reason(&fitted.linear.dataset))
    } else if switched.len() > MOST_STEPS {
        place = over_time(fitted, &[]);
        (Verdict::UnexplainedStructure, switched_reason(&switched, &fitted.linear.dataset))
    } else if causes.is_empty() && matches!(slowness, Slowness::Structure { .. }) {
        place = over_time(fitted, &[]);
        (
            Verdict::UnexplainedStructure,
            structure_reason(GpAlternative::Time, fitted.linear.dataset.time_min.is_some()),
        )
    } else if causes.is_empty() {
        (Verdict::NothingAboveNoise, "what stood out of the noise did not bear a second look".to_owned())
    } else if clear < needed.min(2) || scale {
        (Verdict::Ambiguous, format!("these data leave a choice: {}", in_short(&causes)))
    } else if needed > 1 {
        (Verdict::Several, format!("{needed} causes, each needed: {}", in_short(&causes)))
    } else {
        (Verdict::Explained, causes.first().map(describe).unwrap_or_default())
    };
    Judgement { verdict, reason, causes, alternatives, place, open, reduced_chi_square: None }
}

/// Whether a candidate is a spring that hardens or softens in a file without directions of approach: play whose side gravity
/// decides at most poses has the same shape.
fn looks_like_play(fitted: &FittedModel<'_>, candidate: usize) -> bool {
    let FittedModel { workspace, linear, .. } = fitted;
    let candidate = &workspace.library.candidates[candidate];
    candidate.kind == EffectKind::JointCompliance
        && candidate.variant.refined
        && !linear.dataset.channels.direction
}

/// Whether one of the candidates `named` is the same cause as the first of another place: not of steps, which are many, nor of lines.
fn is_named(workspace: &Workspace<'_>, first: &CauseGroup, named: &[usize]) -> bool {
    let this = &workspace.library.candidates[first.best];
    let alone = this.variant.t0_min().is_none() && this.kind != EffectKind::GearMesh;
    alone
        && named.iter().map(|&c| &workspace.library.candidates[c]).any(|other| {
            other.kind == this.kind
                && other.variant.joint == this.variant.joint
                && other.variant.joint_b == this.variant.joint_b
        })
}

/// Slots in the order of their likeliest causes, without gaps.
fn renumber(causes: &mut [Cause]) {
    let mut order: Vec<usize> = Vec::new();
    for cause in causes.iter() {
        if !order.contains(&cause.slot) {
            order.push(cause.slot);
        }
    }
    for cause in causes {
        cause.slot = 1 + order.iter().position(|slot| *slot == cause.slot).unwrap_or(0);
    }
}

fn same(a: &Cause, b: &Cause) -> bool {
    a.effect == b.effect
        && a.joint == b.joint
        && a.joint_b == b.joint_b
        && a.n == b.n
        && a.from_line == b.from_line
}

/// Each rival once, and none that is a cause itself in another place.
fn rejected(alternatives: Vec<Cause>, causes: &[Cause]) -> Vec<Cause> {
    let mut rejected: Vec<Cause> = Vec::new();
    for rival in alternatives {
        if !causes.iter().chain(&rejected).any(|named| same(named, &rival)) {
            rejected.push(rival);
        }
    }
    rejected
}

#[cfg(test)]
mod tests {
    use super::*;
    use robot_model::robot::Axis;

    #[test]
    fn what_is_named_is_not_ruled_out_in_another_place() {
        use EffectKind::{JointCompliance, JointOffset, LinkGeometry};
        let of = |kind: EffectKind, joint| Cause { joint: Axis::numbered(joint), ..Cause::of(kind, 0.5) };
        let left = rejected(
            vec![of(JointOffset, 2), of(LinkGeometry, 4), of(JointOffset, 2), of(JointOffset, 3)],
            &[of(LinkGeometry, 4), of(JointCompliance, 2)],
        );
        let named: Vec<_> = left.iter().map(|c| (c.effect, c.joint)).collect();
        assert_eq!(named, [(JointOffset, Axis::numbered(2)), (JointOffset, Axis::numbered(3))]);
    }
}
