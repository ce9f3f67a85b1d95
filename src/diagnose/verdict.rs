//! The verdict: what the evidence says, what it cannot tell apart, and when it must not say anything.

use super::effects::{self, Candidate};
use super::evidence::Background;
use super::kernel::{self, Kernel};
use super::linearise::{Linear, norm3};
use super::marginal::log_sum;
use super::model::{Fit, Model, solve};
use super::outcome::{Cause, Region, Verdict, Where};
use super::scatter::{self, JointScatter};
use super::search::{ALARM_NATS, Chosen, Hypothesis, NULL_PRIOR, Slot, UNEXPLAINED_PRIOR, flat};
use crate::units::mm_from_m;
use std::collections::{BTreeMap, BTreeSet};

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

/// More lines of one joint than this are many gears, not one shape.
const MOST_OVERTONES: usize = 6;
/// Prior of one period, and of one cause that varies, over that of all other structure: dozens are possible.
const PERIOD_WEIGHT: f64 = 0.01;
const VARYING_WEIGHT: f64 = 0.1;
/// Candidates that together are this likely among the causes make up the set that cannot be told apart.
const CREDIBLE: f64 = 0.95;
/// Structure of no cause must be this much likelier than a cause to take its place.
const KERNEL_ODDS: f64 = 3.0;
/// A set larger than this, with structure of no cause as likely, is no set.
const LARGE_SET: usize = 6;
/// Scatter beyond a noise that is only stated, not seen in repeats, counts from this reduced chi-square on.
const STATED_SCATTER: f64 = 2.8;

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

/// The likeliest groups that together make up nearly all of the causes' probability.
fn credible(groups: &[Group]) -> Vec<&Group> {
    let total: f64 = groups.iter().map(|g| g.probability).sum();
    let first = groups.first().map_or(0.0, |g| g.probability);
    let mut sum = 0.0;
    groups
        .iter()
        .take_while(|g| {
            let more = sum < CREDIBLE * total && g.probability >= RIVAL * first;
            sum += g.probability;
            more
        })
        .collect()
}

fn kernel_share(slot: &Slot) -> f64 {
    slot.ranked.iter().filter(|(h, _, _)| matches!(h, Hypothesis::Kernel(_))).map(|r| r.1).sum()
}

/// ln evidence of structure over nothing, priors within the kernels included; and the likeliest kernel.
fn structure(model: &Model<'_>, slot: &Slot) -> Option<(f64, usize)> {
    let gain = log_sum(slot.ranked.iter().filter_map(|(h, _, r)| match h {
        Hypothesis::Kernel(k) => {
            Some(r.log_evidence + model.library.kernels[*k].log_prior - UNEXPLAINED_PRIOR.ln())
        }
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
    (model.library.scan(&background, &atoms, &taken), background.geometry_gain())
}

/// Judges the model.
#[must_use]
pub fn judge(model: &mut Model<'_>, linear: &Linear) -> Judged {
    let chosen = model.chosen.clone();
    add_kernels(model, linear, &chosen);
    let (rest, geometry_gain) = scan(model, &chosen, None);
    let chi = reduced_chi_square(model, linear);
    let along = joint_scatter(model, linear).filter(|j| j.gain_nats > ALARM_NATS);
    let scatter = Scatter { chi: chi.filter(|&(value, limit)| value > limit).map(|c| c.0), along };
    let mut judged = if chosen.is_empty() {
        without_cause(model, linear, &rest, geometry_gain, scatter)
    } else {
        with_causes(model, linear, &chosen, &rest, scatter)
    };
    judged.reduced_chi_square = chi.map(|c| c.0);
    judged
}

/// Structure that no effect takes: everywhere, and round the causes that were found.
fn add_kernels(model: &mut Model<'_>, linear: &Linear, chosen: &[Chosen]) {
    let scene = &linear.scene;
    let mut list = kernel::kernels();
    let mut periods: BTreeSet<(usize, u32)> = BTreeSet::new();
    for (joint, lines) in lines_by_joint(model, chosen).into_iter().filter(|(_, l)| l.len() <= MOST_OVERTONES)
    {
        let orders: Vec<u32> =
            lines.iter().filter_map(|&i| model.library.candidates[chosen[i].candidate].form.n).collect();
        let common = orders.iter().copied().fold(0, greatest_common_divisor);
        periods.extend(orders.into_iter().chain([common]).filter(|n| *n > 0).map(|n| (joint, n)));
    }
    list.extend(periods.into_iter().map(|(joint, n)| (Kernel::Periodic(joint, n), PERIOD_WEIGHT)));
    if scene.time_min.is_none() && chosen.len() <= MANY {
        list.extend((0..chosen.len()).map(|i| (Kernel::Varying(i), VARYING_WEIGHT)));
    }
    let design = &model.design;
    model.library.add_kernels(design, list, &|kernel| match kernel {
        Kernel::Varying(i) => kernel::varying(design, scene, &chosen[i].columns),
        other => kernel::columns(other, design, scene),
    });
}

fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

/// Places in `chosen` of lines of each joint's gear.
fn lines_by_joint(model: &Model<'_>, chosen: &[Chosen]) -> BTreeMap<usize, Vec<usize>> {
    let mut lines: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (i, one) in chosen.iter().enumerate() {
        let form = &model.library.candidates[one.candidate].form;
        if let (Some(joint), Some(_)) = (form.joint, form.n) {
            lines.entry(joint).or_default().push(i);
        }
    }
    lines
}

/// A kernel that is likelier than all lines of one joint's gear together: steps and teeth of one shape, not
/// many gears.
fn shape_of_lines(model: &Model<'_>, linear: &Linear, chosen: &[Chosen]) -> Option<usize> {
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let whole_m = total_rms_m(model, linear, chosen);
    for (joint, lines) in lines_by_joint(model, chosen) {
        let rest: Vec<Chosen> =
            (0..chosen.len()).filter(|i| !lines.contains(i)).map(|i| chosen[i].clone()).collect();
        let taken_m = (whole_m.powi(2) - total_rms_m(model, linear, &rest).powi(2)).max(0.0).sqrt();
        if lines.len() > MOST_OVERTONES || taken_m < SMALL_BESIDE * whole_m {
            continue;
        }
        let mut others: Vec<usize> = (0..chosen.len())
            .filter(|i| !lines.contains(i))
            .flat_map(|i| chosen[i].columns.iter().copied())
            .collect();
        let background = Background::new(&model.design, &atoms, &others, model.noise);
        let bare = background.null().log_evidence;
        let mut best: Option<(f64, usize)> = None;
        for (k, structure) in model.library.kernels.iter().enumerate() {
            let fits = match structure.kernel {
                Kernel::Periodic(j, _) | Kernel::Joint(j) | Kernel::JointFine(j) => j == joint,
                _ => false,
            };
            if fits {
                let reached = background.evidence(&background.project(&structure.products.sum(&atoms)));
                let odds = reached.log_evidence - bare + structure.log_prior - NULL_PRIOR.ln();
                if best.is_none_or(|(b, _)| odds > b) {
                    best = Some((odds, k));
                }
            }
        }
        let mut together = 0.0;
        for &i in &lines {
            let background = Background::new(&model.design, &atoms, &others, model.noise);
            let c = chosen[i].candidate;
            together +=
                model.library.gain(&background, &atoms, c) + model.library.log_prior[c] - NULL_PRIOR.ln();
            others.extend(chosen[i].columns.iter().copied());
        }
        if let Some((_, kernel)) = best.filter(|(odds, _)| *odds > together) {
            return Some(kernel);
        }
    }
    None
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
    let mut told_apart = true;
    let mut kernel_wins: Option<usize> = None;
    let mut needed = 0;
    for i in 0..chosen.len() {
        if chosen.len() > MANY && model.library.candidates[chosen[i].candidate].form.n.is_some() {
            causes.push(line_among_many(model, linear, chosen, i));
            needed += 1;
            continue;
        }
        let (slot, _) = scan(model, chosen, Some(i));
        let groups = groups(model, &slot);
        let Some(first) = groups.first() else { continue };
        let near = credible(&groups);
        let nothing = slot.ranked.iter().find(|r| r.0 == Hypothesis::Null).map_or(0.0, |r| r.1);
        if nothing > first.probability.max(kernel_share(&slot)) {
            // Beside the others it is no longer needed.
            continue;
        }
        needed += 1;
        if kernel_share(&slot) > KERNEL_ODDS * first.probability
            || near.len() > LARGE_SET && kernel_share(&slot) > first.probability
        {
            kernel_wins = structure(model, &slot).map(|s| s.1);
        }
        told_apart &= near.len() == 1;
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

    let cause_rms_m = total_rms_m(model, linear, chosen);
    let left = structure(model, rest).filter(|(gain, _)| *gain > ALARM_NATS);
    let left_rms_m = left.map_or(0.0, |(_, k)| left_over_m(model, rest, k));
    let together = chosen.len() > 1 && kernel_takes_all(model, chosen);
    let shape = shape_of_lines(model, linear, chosen);
    let varies = varying_cause(model, rest);
    kernel_wins = shape.or(varies).or(kernel_wins);
    // Structure that stays small beside the causes does not make them wrong.
    let beside = left.is_some() && left_rms_m < SMALL_BESIDE * cause_rms_m;
    let alone = (kernel_wins.is_some() || together) && !beside || shape.or(varies).is_some();

    let mut place = Where { joint: causes.first().and_then(|c| c.joint), ..Where::default() };
    place.time = causes.first().map(|c| c.time);
    place.region = region_of(linear, &moved_m(model, linear, chosen));
    let names = causes.iter().map(describe).collect::<Vec<_>>();
    let (verdict, reason) = if alone || left_rms_m > LEFT_OVER * cause_rms_m {
        let kernel = kernel_wins.or(left.map(|l| l.1)).or_else(|| {
            let atoms: Vec<usize> = (0..model.design.atoms()).collect();
            let bare = Background::new(&model.design, &atoms, &[], model.noise);
            structure(model, &model.library.scan_kernels(&bare, &atoms)).map(|s| s.1)
        });
        let reason = kernel.map_or_else(String::new, |k| {
            structure_reason(model.library.kernels[k].kernel, linear.scene.time_min.is_some())
        });
        if let Some(kernel) = kernel {
            place = place_of_kernel(model, linear, &[], kernel);
        }
        (Verdict::UnexplainedStructure, reason)
    } else if scatter.rivals(model, linear, cause_rms_m) {
        place.joint = scatter.along.map(|a| a.joint + 1);
        (Verdict::UnexplainedScatter, scatter.reason())
    } else if !told_apart || scale {
        (Verdict::Ambiguous, format!("these data cannot tell apart: {}", in_short(&names)))
    } else if needed > 1 {
        (Verdict::Several, format!("{needed} causes, each needed: {}", in_short(&names)))
    } else if names.is_empty() {
        (Verdict::NothingAboveNoise, "what stood out of the noise did not bear a second look".to_owned())
    } else {
        (Verdict::Explained, names.first().cloned().unwrap_or_default())
    };
    Judged { verdict, reason, causes, rivals, place, pair, reduced_chi_square: None }
}

/// The first few names, and how many more there are.
fn in_short(names: &[String]) -> String {
    const SAID: usize = 6;
    let more = names.len().saturating_sub(SAID);
    let said = names[..names.len() - more].join("; ");
    if more > 0 { format!("{said}; and {more} more") } else { said }
}

/// A gear line where there are dozens: each stood far out when it was added, none has a rival but its like.
fn line_among_many(model: &mut Model<'_>, linear: &Linear, chosen: &[Chosen], i: usize) -> Cause {
    let one = &chosen[i];
    let odds = one.gain_nats + model.library.log_prior[one.candidate] - NULL_PRIOR.ln();
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

/// A cause that must have grown or faded over rows whose time is not known: then it is not the cause.
fn varying_cause(model: &Model<'_>, rest: &Slot) -> Option<usize> {
    rest.ranked.iter().find_map(|(h, _, reached)| match h {
        Hypothesis::Kernel(k) if matches!(model.library.kernels[*k].kernel, Kernel::Varying(_)) => {
            (reached.log_evidence - rest.null.log_evidence > ALARM_NATS).then_some(*k)
        }
        _ => None,
    })
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
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let over = |k: usize| Background::new(&model.design, &atoms, &flat(&chosen[..k], None), model.noise);
    let Some((gain, _)) = structure(model, &model.library.scan_kernels(&over(0), &atoms)) else {
        return false;
    };
    let mut total = 0.0;
    for (k, one) in chosen.iter().enumerate() {
        let c = one.candidate;
        total += model.library.gain(&over(k), &atoms, c) + model.library.log_prior[c] - NULL_PRIOR.ln();
    }
    gain + UNEXPLAINED_PRIOR.ln() - NULL_PRIOR.ln() > total
}

/// Scatter that the model does not know.
#[derive(Clone, Copy, Debug)]
struct Scatter {
    /// Reduced chi-square against the noise, where it is too large.
    chi: Option<f64>,
    /// Along a joint.
    along: Option<JointScatter>,
}

impl Scatter {
    /// Whether it is not small against what the causes take.
    fn rivals(&self, model: &Model<'_>, linear: &Linear, cause_rms_m: f64) -> bool {
        self.along.is_some_and(|a| a.rms_m > LEFT_OVER * cause_rms_m)
            || self.chi.is_some() && excess_m(model, linear) > LEFT_OVER * cause_rms_m
    }

    fn reason(&self) -> String {
        let what = match (self.along, self.chi) {
            (Some(a), _) => format!("poses scatter along joint {}", a.joint + 1),
            (None, Some(chi)) => format!("poses scatter {:.1} times as much as the noise allows", chi.sqrt()),
            (None, None) => "poses scatter".to_owned(),
        };
        format!("{what}, and nothing that is recorded explains it: a channel is missing")
    }
}

fn joint_scatter(model: &Model<'_>, linear: &Linear) -> Option<JointScatter> {
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let background = Background::new(&model.design, &atoms, &flat(&model.chosen, None), model.noise);
    // Orientation has rows of its own; half of the parameters are then the points'.
    let share = 3.0 / linear.scene.rows_per_site as f64;
    let used = share * background.parameters(model.reached.geometry_ratio);
    scatter::along_joints(
        &linear.scene,
        &model.residuals,
        &model.base_weights,
        &model.outliers,
        &model.noise,
        used,
    )
}

/// Scatter beyond the noise as known, 3-D rms, metres.
fn excess_m(model: &Model<'_>, linear: &Linear) -> f64 {
    let Some((sigma_m, _)) = model.noise.known else { return 0.0 };
    let kept: Vec<f64> = model
        .residuals
        .iter()
        .zip(&model.outliers)
        .filter(|(_, out)| !**out)
        .map(|(m, _)| norm3(m))
        .collect();
    let expected = linear.scene.sites.iter().map(|s| 3.0 * sigma_m.powi(2) / s.repeats as f64).sum::<f64>()
        / linear.scene.sites.len() as f64;
    (rms(&kept).powi(2) - expected).max(0.0).sqrt()
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
    let least = if model.noise.seen { SCATTER } else { STATED_SCATTER };
    Some((sum / (sigma_m * sigma_m) / free, least + 1.5 * (2.0 / freedom + 2.0 / free).sqrt()))
}

fn place_of_kernel(model: &Model<'_>, linear: &Linear, chosen: &[Chosen], kernel: usize) -> Where {
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let fit = solve(&model.design, &atoms, chosen, Some(model.reached.geometry_ratio));
    let left: Vec<f64> = model.design.residuals(&fit.coefficients).iter().map(norm3).collect();
    let kind = model.library.kernels[kernel].kernel;
    Where {
        joint: match kind {
            Kernel::Joint(j)
            | Kernel::JointFine(j)
            | Kernel::Joints(j)
            | Kernel::JointTime(j)
            | Kernel::Periodic(j, _) => Some(j + 1),
            _ => None,
        },
        time: Some(match kind {
            Kernel::Time
            | Kernel::TimeFine
            | Kernel::ToolTime
            | Kernel::JointTime(_)
            | Kernel::Varying(_) => "drift",
            _ => "constant",
        }),
        region: region_of(linear, &left),
    }
}

fn region_of(linear: &Linear, moved_m: &[f64]) -> Region {
    let (centre, radius_m) = kernel::region(&linear.scene, moved_m);
    Region { center_mm: [centre.x, centre.y, centre.z].map(mm_from_m), radius_mm: mm_from_m(radius_m) }
}

fn structure_reason(kernel: Kernel, timed: bool) -> String {
    let time = if timed { "time" } else { "the order of the rows; the time (t_min) is not in the file" };
    let of = match kernel {
        Kernel::Joint(j) | Kernel::JointFine(j) => format!("the angle of joint {}", j + 1),
        Kernel::Joints(j) => format!("joint {}, depending on all joints' angles", j + 1),
        Kernel::AllJoints => "the angles of several joints".to_owned(),
        Kernel::Workspace | Kernel::WorkspaceFine => "the place in the workspace".to_owned(),
        Kernel::Time | Kernel::TimeFine | Kernel::Varying(_) => time.to_owned(),
        Kernel::ToolTime => format!("the target on the flange, over {time}"),
        Kernel::JointTime(j) => format!("joint {}, over {time}", j + 1),
        Kernel::Periodic(j, n) => {
            format!("the angle of joint {}, {n} times per turn, with steps or corners", j + 1)
        }
    };
    format!("the gap has a structure that no effect of the library takes; it follows {of}")
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
