//! The verdict: what the evidence says, what it cannot tell apart, and when it must not say anything.

mod group;
mod noise;
mod size;
mod structure;
mod words;

pub use words::{describe, describe_candidate};

use super::effects;
use super::evidence::Background;
use super::linearise::Linear;
use super::model::Model;
use super::outcome::{Cause, Verdict, Where};
use super::search::{ALARM_NATS, Chosen, Hypothesis, Slot};
use group::{credible, groups, join_nested, scan};
use noise::{LEFT_OVER, SLOW_NOISE, Scatter, joint_scatter, reduced_chi_square, slow_noise};
use size::{cause, cause_unfitted, line_among_many, moved_m, total_rms_m};
use structure::{
    MANY, SMALL_BESIDE, add_kernels, kernel_share, left_over_m, odds_over_causes, place_of_kernel, region_of,
    rival_share, shape_of_lines, structure as structure_in, structure_odds, varying_cause,
};
use words::{in_short, structure_reason};

/// Structure of no cause that is this likely beside the causes makes them uncertain; likelier than they, it wins.
const KERNEL_RIVALS: f64 = 0.2;
/// A set larger than this, with structure of no cause as likely, is no set.
const LARGE_SET: usize = 6;

/// The verdict and what it rests on.
pub struct Judged {
    /// Verdict.
    pub verdict: Verdict,
    /// One sentence.
    pub reason: String,
    /// Ranked causes.
    pub causes: Vec<Cause>,
    /// Rivals found wanting.
    pub rivals: Vec<Cause>,
    /// Where.
    pub place: Where,
    /// Candidates of the likeliest cause and its likeliest rival.
    pub pair: Option<(usize, Option<usize>)>,
    /// Scatter against repeats.
    pub reduced_chi_square: Option<f64>,
}

/// A candidate's probability is one among the library's effects; where the verdict is that none of them explains the data, it
/// is halved: even odds at best that the verdict is wrong and the candidate right.
const AS_A_CANDIDATE: f64 = 0.5;

/// Judges the model.
#[must_use]
pub fn judge(model: &mut Model<'_>, linear: &Linear) -> Judged {
    let chosen = model.chosen.clone();
    model.library.forget_columns();
    add_kernels(model, linear, &chosen);
    let (rest, geometry_gain) = scan(model, &chosen, None);
    let chi = reduced_chi_square(model, linear, &chosen);
    let along = joint_scatter(model, linear).filter(|j| j.gain_nats > ALARM_NATS);
    let scatter = Scatter { chi: chi.filter(|&(value, limit)| value > limit).map(|c| c.0), along };
    let mut judged = if chosen.is_empty() {
        without_cause(model, linear, &rest, geometry_gain, scatter)
    } else {
        with_causes(model, linear, &chosen, &rest, scatter)
    };
    judged.reduced_chi_square = chi.map(|c| c.0);
    if matches!(judged.verdict, Verdict::UnexplainedStructure | Verdict::UnexplainedScatter) {
        for candidate in &mut judged.causes {
            candidate.posterior *= AS_A_CANDIDATE;
        }
    }
    judged
}

fn without_cause(
    model: &mut Model<'_>,
    linear: &Linear,
    slot: &Slot,
    geometry_gain: f64,
    scatter: Scatter,
) -> Judged {
    let groups = groups(model, slot);
    let mut causes = Vec::new();
    for group in groups.iter().take(3).filter(|g| g.probability > 0.001) {
        causes.push(cause(model, linear, &[], None, group));
    }
    let mut judged = Judged {
        verdict: Verdict::NothingAboveNoise,
        reason: "no effect of the library stands out of the noise".to_owned(),
        causes,
        rivals: Vec::new(),
        place: Where::default(),
        pair: groups.first().map(|g| (g.best, groups.get(1).map(|h| h.best))),
        reduced_chi_square: None,
    };
    let found = structure_in(model, slot).filter(|(gain, _)| *gain > ALARM_NATS);
    let slow = found.is_some_and(|(_, kernel)| slow_noise(model, linear, kernel));
    if slow {
        SLOW_NOISE.clone_into(&mut judged.reason);
    }
    if let Some((_, kernel)) = found.filter(|_| !slow) {
        judged.verdict = Verdict::UnexplainedStructure;
        judged.place = place_of_kernel(model, linear, &[], kernel);
        judged.reason =
            structure_reason(model.library.kernels[kernel].kernel, linear.scene.time_min.is_some());
    } else if scatter.chi.is_some() || scatter.along.is_some() {
        judged.verdict = Verdict::UnexplainedScatter;
        judged.place.joint = scatter.along.map(|a| a.joint + 1);
        judged.reason = scatter.reason();
    } else if geometry_gain > ALARM_NATS {
        judged.verdict = Verdict::Geometry;
        "small errors of all joints' geometry take the gap; none stands out".clone_into(&mut judged.reason);
    }
    judged
}

fn with_causes(
    model: &mut Model<'_>,
    linear: &Linear,
    chosen: &[Chosen],
    rest: &Slot,
    scatter: Scatter,
) -> Judged {
    let mut causes = Vec::new();
    let mut rivals = Vec::new();
    let mut pair = None;
    let mut clear = 0;
    let mut kernel_wins: Option<usize> = None;
    let mut needed = 0;
    let mut lost = 0;
    for i in 0..chosen.len() {
        if chosen.len() > MANY && model.library.candidates[chosen[i].candidate].form.n.is_some() {
            causes.push(line_among_many(model, linear, chosen, i));
            needed += 1;
            clear += 1;
            continue;
        }
        let (slot, _) = scan(model, chosen, Some(i));
        let mut groups = groups(model, &slot);
        join_nested(model, &mut groups);
        let Some(first) = groups.first() else { continue };
        let near = credible(&groups);
        let nothing = slot.ranked.iter().find(|r| r.0 == Hypothesis::Null).map_or(0.0, |r| r.1);
        if nothing > first.probability.max(kernel_share(&slot)) {
            // Beside the others it is no longer needed.
            continue;
        }
        needed += 1;
        let kernels = rival_share(model, &slot, first.best);
        let causes_share: f64 = near.iter().map(|g| g.probability).sum();
        if kernels > causes_share || near.len() > LARGE_SET && kernels > first.probability {
            kernel_wins = structure_in(model, &slot).map(|s| s.1);
            lost += 1;
        }
        clear += usize::from(near.len() == 1 && kernels < KERNEL_RIVALS * causes_share);
        if i == 0 {
            pair = Some((first.best, groups.get(1).map(|g| g.best)));
        }
        for group in &near {
            causes.push(cause(model, linear, chosen, Some(i), group));
        }
        for group in groups.iter().skip(near.len()).take(3) {
            rivals.push(cause_unfitted(model, group));
        }
    }
    for a in (1..causes.len()).rev() {
        if causes[..a].iter().any(|b: &Cause| same(b, &causes[a])) {
            causes.remove(a);
        }
    }
    let scale = causes.iter().any(|c| c.effect == "instrument_scale");
    if scale && !causes.iter().any(|c| c.effect == "link_geometry") {
        // A scale of the instrument and a scale of all links are one and the same to these data.
        causes.push(Cause::of(effects::LIBRARY[1], 0.0));
    }
    let thousandths = |p: f64| (1000.0 * p).round();
    causes.sort_by(|a, b| {
        let size = |c: &Cause| c.rms_mm.unwrap_or(0.0);
        thousandths(b.posterior).total_cmp(&thousandths(a.posterior)).then(size(b).total_cmp(&size(a)))
    });

    let rivals = wanting(rivals, &causes);
    let cause_rms_m = total_rms_m(model, chosen);
    let left = structure_in(model, rest).filter(|(gain, _)| *gain > ALARM_NATS);
    let left_rms_m = left.map_or(0.0, |(_, k)| left_over_m(rest, k));
    let odds = odds_over_causes(model, chosen);
    let together = chosen.len() > 1 && odds > 0.0;
    // Structure alone that is likelier than the causes with structure beside them.
    let all = odds > structure_in(model, rest).map_or(0.0, |(gain, _)| structure_odds(gain).max(0.0));
    let shape = shape_of_lines(model, chosen);
    let varies = varying_cause(model, rest);
    kernel_wins = shape.or(varies).or(kernel_wins);
    // Structure that stays small beside the causes does not make them wrong.
    let beside = left.is_some() && left_rms_m < SMALL_BESIDE * cause_rms_m;
    // Causes that most of them structure could replace are no causes but its parts.
    let parts = lost > 1 && 2 * lost > needed && left.is_some();
    let alone = (kernel_wins.is_some() || together) && !beside || all || parts || shape.or(varies).is_some();

    let mut place = Where { joint: causes.first().and_then(|c| c.joint), ..Where::default() };
    place.time = causes.first().map(|c| c.time);
    place.region = region_of(linear, &moved_m(model, linear, chosen));
    let (verdict, reason) = if alone || left_rms_m > LEFT_OVER * cause_rms_m {
        let kernel = kernel_wins.or(left.map(|l| l.1)).or_else(|| {
            let atoms: Vec<usize> = (0..model.design.atoms()).collect();
            let bare = Background::new(&model.design, &atoms, &[], model.noise);
            structure_in(model, &model.library.scan_kernels(&bare)).map(|s| s.1)
        });
        let reason = kernel.map_or_else(String::new, |k| {
            structure_reason(model.library.kernels[k].kernel, linear.scene.time_min.is_some())
        });
        match kernel {
            Some(kernel) if slow_noise(model, linear, kernel) => {
                place = Where::default();
                (Verdict::NothingAboveNoise, SLOW_NOISE.to_owned())
            }
            Some(kernel) => {
                place = place_of_kernel(model, linear, &[], kernel);
                (Verdict::UnexplainedStructure, reason)
            }
            None => (Verdict::UnexplainedStructure, reason),
        }
    } else if scatter.rivals(model, linear, cause_rms_m) {
        place.joint = scatter.along.map(|a| a.joint + 1);
        (Verdict::UnexplainedScatter, scatter.reason())
    } else if clear < needed.min(2) || scale {
        (Verdict::Ambiguous, format!("these data cannot tell apart: {}", in_short(&causes)))
    } else if needed > 1 {
        let apart = match needed - clear {
            0 => String::new(),
            1 => "; for one of them these data leave a choice".to_owned(),
            unclear => format!("; for {unclear} of them these data leave a choice"),
        };
        (Verdict::Several, format!("{needed} causes, each needed: {}{apart}", in_short(&causes)))
    } else if causes.is_empty() {
        (Verdict::NothingAboveNoise, "what stood out of the noise did not bear a second look".to_owned())
    } else {
        (Verdict::Explained, causes.first().map(describe).unwrap_or_default())
    };
    Judged { verdict, reason, causes, rivals, place, pair, reduced_chi_square: None }
}

fn same(a: &Cause, b: &Cause) -> bool {
    a.effect == b.effect && a.joint == b.joint && a.joint_b == b.joint_b && a.n == b.n && a.t0_min == b.t0_min
}

/// Each rival once, and none that is a cause itself in another place.
fn wanting(rivals: Vec<Cause>, causes: &[Cause]) -> Vec<Cause> {
    let mut wanting: Vec<Cause> = Vec::new();
    for rival in rivals {
        if !causes.iter().chain(&wanting).any(|named| same(named, &rival)) {
            wanting.push(rival);
        }
    }
    wanting
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_named_is_not_ruled_out_in_another_place() {
        let of =
            |effect: usize, joint| Cause { joint: Some(joint), ..Cause::of(effects::LIBRARY[effect], 0.5) };
        let left = wanting(vec![of(0, 2), of(1, 4), of(0, 2), of(0, 3)], &[of(1, 4), of(2, 2)]);
        let named: Vec<_> = left.iter().map(|c| (c.effect, c.joint)).collect();
        let first = effects::LIBRARY[0].name();
        assert_eq!(named, [(first, Some(2)), (first, Some(3))]);
    }
}
