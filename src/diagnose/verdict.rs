//! The verdict: what the evidence says, what it cannot tell apart, and when it must not say anything.

use super::effects::{self, Candidate};
use super::evidence::{Background, log_sum};
use super::kernel::{self, Kernel};
use super::linearise::{Linear, norm3};
use super::model::{Fit, Model, solve};
use super::outcome::{Cause, Region, Verdict, Where};
use super::search::{ALARM_NATS, Chosen, Hypothesis, Slot, UNEXPLAINED_PRIOR, flat};
use crate::units::mm_from_m;

/// A rival this likely, against the likeliest, cannot be told apart.
const RIVAL: f64 = 0.03;
/// A reduced chi-square above this against the repeats is scatter that the model does not know.
const SCATTER: f64 = 1.5;
/// With more causes than this each gear line is not tried against all others again.
const MANY: usize = 8;
/// Structure left that is larger than this share of the causes makes them doubtful.
const LEFT_OVER: f64 = 0.5;
/// And structure smaller than this share leaves them in their right, even where it could replace one.
const SMALL_BESIDE: f64 = 0.25;

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

/// What forms of one cause share.
type Key = (usize, Option<usize>, Option<usize>);

fn key(c: &Candidate) -> Key {
    (c.effect, c.form.joint, c.form.joint_b)
}

/// A cause over all its forms in one slot.
struct Group {
    best: usize,
    probability: f64,
    gain_nats: f64,
}

fn groups(model: &Model<'_>, slot: &Slot) -> Vec<Group> {
    let mut found: Vec<(Key, Group)> = Vec::new();
    for (hypothesis, probability, reached) in &slot.ranked {
        let Hypothesis::Effect(c) = hypothesis else { continue };
        let this = key(&model.library.candidates[*c]);
        match found.iter_mut().find(|(k, _)| *k == this) {
            Some((_, group)) => group.probability += probability,
            None => found.push((
                this,
                Group {
                    best: *c,
                    probability: *probability,
                    gain_nats: reached.log_evidence - slot.null.log_evidence,
                },
            )),
        }
    }
    let mut groups: Vec<Group> = found.into_iter().map(|(_, g)| g).collect();
    groups.sort_by(|a, b| b.probability.total_cmp(&a.probability));
    groups
}

fn kernel_share(slot: &Slot) -> f64 {
    slot.ranked.iter().filter(|(h, _, _)| matches!(h, Hypothesis::Kernel(_))).map(|r| r.1).sum()
}

/// ln evidence of structure over nothing, priors within the kernels included; and the likeliest kernel.
fn structure(model: &Model<'_>, slot: &Slot) -> Option<(f64, usize)> {
    let gain = log_sum(slot.ranked.iter().filter_map(|(h, _, r)| match h {
        Hypothesis::Kernel(k) => Some(r.log_evidence + model.library.kernels[*k].2 - UNEXPLAINED_PRIOR.ln()),
        _ => None,
    })) - slot.null.log_evidence;
    let best = slot.ranked.iter().find_map(|(h, _, _)| match h {
        Hypothesis::Kernel(k) => Some(*k),
        _ => None,
    })?;
    Some((gain, best))
}

fn scan(model: &Model<'_>, chosen: &[Chosen], without: Option<usize>) -> (Slot, f64) {
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let background = Background::new(&model.design, &atoms, &flat(chosen, without), model.noise);
    let taken: Vec<usize> =
        chosen.iter().enumerate().filter(|(i, _)| Some(*i) != without).map(|(_, c)| c.candidate).collect();
    let among: Vec<usize> = (0..model.library.candidates.len()).filter(|c| !taken.contains(c)).collect();
    (model.library.scan(&background, &atoms, &among, true), background.geometry_gain())
}

/// Judges the model.
#[must_use]
pub fn judge(model: &mut Model<'_>, linear: &Linear) -> Judged {
    model.library.add_kernels(&model.design);
    let chosen = model.chosen.clone();
    let (rest, geometry_gain) = scan(model, &chosen, None);
    let chi = reduced_chi_square(model, linear);
    let scatter = chi.filter(|&(value, limit)| value > limit).map(|c| c.0);
    let mut judged = if chosen.is_empty() {
        without_cause(model, linear, &rest, geometry_gain, scatter)
    } else {
        with_causes(model, linear, &chosen, &rest, scatter)
    };
    judged.reduced_chi_square = chi.map(|c| c.0);
    judged
}

fn without_cause(
    model: &mut Model<'_>,
    linear: &Linear,
    slot: &Slot,
    geometry_gain: f64,
    scatter: Option<f64>,
) -> Judged {
    let groups = groups(model, slot);
    let mut causes = Vec::new();
    for group in groups.iter().take(3).filter(|g| g.probability > 0.02) {
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
    let structure = structure(model, slot).filter(|(gain, _)| *gain > ALARM_NATS);
    if let Some((_, kernel)) = structure {
        judged.verdict = Verdict::UnexplainedStructure;
        judged.place = place_of_kernel(model, linear, &[], kernel);
        judged.reason = structure_reason(model.library.kernels[kernel].0);
    } else if let Some(chi) = scatter {
        judged.verdict = Verdict::UnexplainedScatter;
        judged.reason = scatter_reason(chi);
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
    scatter: Option<f64>,
) -> Judged {
    let mut causes = Vec::new();
    let mut rivals = Vec::new();
    let mut pair = None;
    let mut told_apart = true;
    let mut kernel_wins: Option<usize> = None;
    for i in 0..chosen.len() {
        if chosen.len() > MANY && model.library.candidates[chosen[i].candidate].form.n.is_some() {
            causes.push(line_among_many(model, linear, chosen, i));
            continue;
        }
        let (slot, _) = scan(model, chosen, Some(i));
        let groups = groups(model, &slot);
        let Some(first) = groups.first() else { continue };
        if kernel_share(&slot) > first.probability {
            kernel_wins = structure(model, &slot).map(|s| s.1);
        }
        let near: Vec<&Group> =
            groups.iter().filter(|g| g.probability >= RIVAL * first.probability).collect();
        told_apart &= near.len() == 1;
        if i == 0 {
            pair = Some((first.best, groups.get(1).map(|g| g.best)));
        }
        for group in &near {
            causes.push(cause(model, linear, chosen, Some(i), group));
        }
        for group in groups.iter().filter(|g| g.probability < RIVAL * first.probability).take(3) {
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
    causes.sort_by(|a, b| b.posterior.total_cmp(&a.posterior));

    let cause_rms_m = total_rms_m(model, linear, chosen);
    let left = structure(model, rest).filter(|(gain, _)| *gain > ALARM_NATS);
    let left_rms_m = left.map_or(0.0, |(_, k)| left_over_m(model, rest, k));
    let together = chosen.len() > 1 && kernel_takes_all(model, chosen);
    // Structure that stays small beside the causes does not make them wrong.
    let beside = left.is_some() && left_rms_m < SMALL_BESIDE * cause_rms_m;
    let alone = (kernel_wins.is_some() || together) && !beside;

    let mut place = Where { joint: causes.first().and_then(|c| c.joint), ..Where::default() };
    place.time = causes.first().map(|c| c.time);
    place.region = region_of(linear, &moved_m(model, linear, chosen));
    let names = causes.iter().map(describe).collect::<Vec<_>>();
    let (verdict, reason) = if alone || left_rms_m > LEFT_OVER * cause_rms_m {
        let kernel = kernel_wins.or(left.map(|l| l.1)).or_else(|| {
            let (bare, _) = scan(model, &[], None);
            structure(model, &bare).map(|s| s.1)
        });
        let reason = kernel.map_or_else(String::new, |k| structure_reason(model.library.kernels[k].0));
        if let Some(kernel) = kernel {
            place = place_of_kernel(model, linear, &[], kernel);
        }
        (Verdict::UnexplainedStructure, reason)
    } else if let Some(chi) = scatter.filter(|_| scatter_rivals(model, linear, cause_rms_m)) {
        (Verdict::UnexplainedScatter, scatter_reason(chi))
    } else if !told_apart || scale {
        (Verdict::Ambiguous, format!("these data cannot tell apart: {}", names.join(", or ")))
    } else if chosen.len() > 1 {
        (Verdict::Several, format!("{} causes, each needed: {}", chosen.len(), names.join("; ")))
    } else {
        (Verdict::Explained, names.first().cloned().unwrap_or_default())
    };
    Judged { verdict, reason, causes, rivals, place, pair, reduced_chi_square: None }
}

/// A gear line where there are dozens: each stood far out when it was added, none has a rival but its like.
fn line_among_many(model: &mut Model<'_>, linear: &Linear, chosen: &[Chosen], i: usize) -> Cause {
    let one = &chosen[i];
    let odds = one.gain_nats + model.library.log_prior[one.candidate] - super::search::NULL_PRIOR.ln();
    let group =
        Group { best: one.candidate, probability: 1.0 / (1.0 + (-odds).exp()), gain_nats: one.gain_nats };
    cause(model, linear, chosen, Some(i), &group)
}

fn same(a: &Cause, b: &Cause) -> bool {
    a.effect == b.effect && a.joint == b.joint && a.joint_b == b.joint_b && a.n == b.n && a.t0_min == b.t0_min
}

fn cause_unfitted(model: &Model<'_>, group: &Group) -> Cause {
    let candidate = &model.library.candidates[group.best];
    let effect = candidate.effect();
    Cause {
        joint: candidate.form.joint.map(|j| j + 1),
        joint_b: candidate.form.joint_b.map(|j| j + 1),
        n: candidate.form.n,
        t0_min: candidate.form.t0_min(),
        evidence_nats: Some(group.gain_nats),
        ..Cause::of(effect, group.probability)
    }
}

/// A cause with its size: fitted in place `i` of `chosen`, or alone.
fn cause(
    model: &mut Model<'_>,
    linear: &Linear,
    chosen: &[Chosen],
    i: Option<usize>,
    group: &Group,
) -> Cause {
    let columns = model.library.place(&mut model.design, &mut model.place, group.best);
    model.library.extend(&model.design);
    let size_ratio = i.and_then(|i| chosen.get(i)).map_or(1.0 / model.reached.sigma_m, |c| c.size_ratio);
    let this =
        Chosen { candidate: group.best, columns: columns.clone(), gain_nats: group.gain_nats, size_ratio };
    let mut all: Vec<Chosen> = chosen.to_vec();
    match i {
        Some(i) => all[i] = this,
        None => all.push(this),
    }
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let fit = solve(&model.design, &atoms, &all, Some(model.reached.geometry_ratio));
    let candidate = &model.library.candidates[group.best];
    let (size, sigma) = size_of(candidate, &columns, &fit, model.reached.sigma_m);
    let moved: Vec<f64> = moved_by(linear, candidate, &columns, &fit);
    let mut cause = cause_unfitted(model, group);
    cause.size = Some(size);
    cause.sigma = Some(sigma);
    cause.rms_mm = Some(mm_from_m(rms(&moved)));
    cause
}

fn size_of(candidate: &Candidate, columns: &[usize], fit: &Fit, sigma_m: f64) -> (f64, f64) {
    let values: Vec<f64> = columns
        .iter()
        .zip(&candidate.usual)
        .take(candidate.counted)
        .map(|(&c, usual)| fit.coefficients[c - 1] * usual * candidate.factor)
        .collect();
    let size = values.iter().map(|v| v * v).sum::<f64>().sqrt();
    let at: Vec<Option<usize>> = columns.iter().map(|c| fit.columns.iter().position(|x| x == c)).collect();
    let mut variance = 0.0;
    for (a, (ia, ua)) in at.iter().zip(&candidate.usual).enumerate().take(candidate.counted) {
        for (b, (ib, ub)) in at.iter().zip(&candidate.usual).enumerate().take(candidate.counted) {
            if let (Some(ia), Some(ib)) = (ia, ib) {
                let slope = values[a] * values[b] / size.max(1e-300).powi(2);
                variance += slope * fit.covariance[(*ia, *ib)] * ua * ub * candidate.factor.powi(2);
            }
        }
    }
    (size, sigma_m * variance.max(0.0).sqrt())
}

/// How far the counted parameters move the point at each station, metres.
fn moved_by(linear: &Linear, candidate: &Candidate, columns: &[usize], fit: &Fit) -> Vec<f64> {
    let mut buffer = Vec::new();
    linear
        .scene
        .sites
        .iter()
        .map(|site| {
            buffer.clear();
            candidate.effect().motions(&candidate.form, &linear.scene, site, &mut buffer);
            let counted = buffer.len().min(if candidate.effect().unit() == "mm" {
                buffer.len()
            } else {
                candidate.counted
            });
            let mut sum = [0.0; 6];
            for ((motion, &column), usual) in buffer.iter().zip(columns).zip(&candidate.usual).take(counted) {
                for (to, from) in sum.iter_mut().zip(motion) {
                    *to += fit.coefficients[column - 1] * usual * from;
                }
            }
            norm3(&sum)
        })
        .collect()
}

fn moved_m(model: &Model<'_>, linear: &Linear, chosen: &[Chosen]) -> Vec<f64> {
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let fit = solve(&model.design, &atoms, chosen, Some(model.reached.geometry_ratio));
    let mut total = vec![0.0_f64; linear.scene.sites.len()];
    for one in chosen {
        let candidate = &model.library.candidates[one.candidate];
        for (sum, moved) in total.iter_mut().zip(moved_by(linear, candidate, &one.columns, &fit)) {
            *sum = sum.hypot(moved);
        }
    }
    total
}

fn total_rms_m(model: &Model<'_>, linear: &Linear, chosen: &[Chosen]) -> f64 {
    // What the causes take off beyond registration, not their raw size.
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let ratio = Some(model.reached.geometry_ratio);
    let left = |chosen: &[Chosen]| {
        let fit = solve(&model.design, &atoms, chosen, ratio);
        let residuals = model.design.residuals(&fit.coefficients);
        let kept: Vec<f64> =
            residuals.iter().zip(&model.outliers).filter(|(_, out)| !**out).map(|(m, _)| norm3(m)).collect();
        rms(&kept).powi(2)
    };
    let _ = linear;
    (left(&[]) - left(chosen)).max(0.0).sqrt()
}

fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|v| v * v).sum::<f64>() / values.len().max(1) as f64).sqrt()
}

/// How large the structure is that a kernel takes after the causes, 3-D rms, metres.
fn left_over_m(model: &Model<'_>, slot: &Slot, kernel: usize) -> f64 {
    let sigma_with = slot
        .ranked
        .iter()
        .find(|(h, _, _)| *h == Hypothesis::Kernel(kernel))
        .map_or(slot.null.sigma_m, |r| r.2.sigma_m);
    let _ = model;
    (3.0 * (slot.null.sigma_m.powi(2) - sigma_with.powi(2)).max(0.0)).sqrt()
}

/// Whether one kernel alone is likelier than all causes together.
fn kernel_takes_all(model: &Model<'_>, chosen: &[Chosen]) -> bool {
    let (bare, _) = scan(model, &[], None);
    let Some((gain, _)) = structure(model, &bare) else { return false };
    let mut total = 0.0;
    for k in 0..chosen.len() {
        let (slot, _) = scan(model, &chosen[..k], None);
        let c = chosen[k].candidate;
        total += slot.gain(Hypothesis::Effect(c)).unwrap_or(chosen[k].gain_nats) + model.library.log_prior[c]
            - super::search::NULL_PRIOR.ln();
    }
    gain + UNEXPLAINED_PRIOR.ln() - super::search::NULL_PRIOR.ln() > total
}

/// Scatter beyond the repeats that is not small against what the causes take.
fn scatter_rivals(model: &Model<'_>, linear: &Linear, cause_rms_m: f64) -> bool {
    let Some((sigma_m, _)) = model.noise.known else { return false };
    let kept: Vec<f64> = model
        .residuals
        .iter()
        .zip(&model.outliers)
        .filter(|(_, out)| !**out)
        .map(|(m, _)| norm3(m))
        .collect();
    let expected = linear.scene.sites.iter().map(|s| 3.0 * sigma_m.powi(2) / s.repeats as f64).sum::<f64>()
        / linear.scene.sites.len() as f64;
    let excess = (rms(&kept).powi(2) - expected).max(0.0).sqrt();
    excess > LEFT_OVER * cause_rms_m
}

/// Scatter about the model over what the repeats allow, and the limit for as many repeats as there are.
fn reduced_chi_square(model: &Model<'_>, linear: &Linear) -> Option<(f64, f64)> {
    let (sigma_m, freedom) = model.noise.known?;
    let mut sum = 0.0;
    let mut rows = 0.0;
    for ((m, site), out) in model.residuals.iter().zip(&linear.scene.sites).zip(&model.outliers) {
        if !*out {
            sum += norm3(m).powi(2) * site.repeats as f64;
            rows += 3.0;
        }
    }
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let background = Background::new(&model.design, &atoms, &flat(&model.chosen, None), model.noise);
    let used = background.parameters(model.reached.geometry_ratio);
    let free: f64 = (rows - used).max(6.0);
    Some((sum / (sigma_m * sigma_m) / free, SCATTER + 1.5 * (2.0 / freedom + 2.0 / free).sqrt()))
}

fn place_of_kernel(model: &Model<'_>, linear: &Linear, chosen: &[Chosen], kernel: usize) -> Where {
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let fit = solve(&model.design, &atoms, chosen, Some(model.reached.geometry_ratio));
    let left: Vec<f64> = model.design.residuals(&fit.coefficients).iter().map(norm3).collect();
    let kind = model.library.kernels[kernel].0;
    Where {
        joint: match kind {
            Kernel::Joint(j) | Kernel::JointFine(j) | Kernel::Joints(j) => Some(j + 1),
            _ => None,
        },
        time: Some(match kind {
            Kernel::Time | Kernel::TimeFine => "drift",
            _ => "constant",
        }),
        region: region_of(linear, &left),
    }
}

fn region_of(linear: &Linear, moved_m: &[f64]) -> Region {
    let (centre, radius_m) = kernel::region(&linear.scene, moved_m);
    Region { center_mm: [centre.x, centre.y, centre.z].map(mm_from_m), radius_mm: mm_from_m(radius_m) }
}

fn structure_reason(kernel: Kernel) -> String {
    let of = match kernel {
        Kernel::Joint(j) | Kernel::JointFine(j) => format!("the angle of joint {}", j + 1),
        Kernel::Joints(j) => format!("joint {}, depending on all joints' angles", j + 1),
        Kernel::AllJoints => "the angles of several joints".to_owned(),
        Kernel::Workspace | Kernel::WorkspaceFine => "the place in the workspace".to_owned(),
        Kernel::Time | Kernel::TimeFine => "time".to_owned(),
    };
    format!("the gap has a structure that no effect of the library takes; it follows {of}")
}

fn scatter_reason(chi: f64) -> String {
    format!(
        "poses scatter {:.1} times as much as their repeats, and nothing that is recorded explains it: a channel is missing",
        chi.sqrt()
    )
}

/// A candidate in words.
#[must_use]
pub fn describe_candidate(candidate: &Candidate) -> String {
    let form = &candidate.form;
    let one = |j: Option<usize>| j.map(|j| j + 1);
    describe(&Cause {
        joint: one(form.joint),
        joint_b: one(form.joint_b),
        n: form.n,
        t0_min: form.t0_min(),
        ..Cause::of(candidate.effect(), 0.0)
    })
}

/// A cause in words.
#[must_use]
pub fn describe(cause: &Cause) -> String {
    let mut text = cause.effect.to_owned();
    match (cause.joint, cause.joint_b) {
        (Some(a), Some(b)) => text.push_str(&format!(" from joint {a} to joint {b}")),
        (Some(a), None) => {
            let what = if cause.effect.starts_with("link") || cause.effect == "thermal_link_growth" {
                "link"
            } else {
                "joint"
            };
            text.push_str(&format!(" of {what} {a}"));
        }
        _ => {}
    }
    if let Some(n) = cause.n.filter(|_| cause.effect == "gear_mesh") {
        text.push_str(&format!(", {n} per turn"));
    }
    if let Some(t0_min) = cause.t0_min {
        text.push_str(&format!(" at minute {t0_min:.1}"));
    }
    text
}
