//! Structure of no named cause beside the causes: is there any, where, and could it replace them.

use super::size::total_rms_m;
use crate::diagnose::effects::Candidate;
use crate::diagnose::evidence::{Background, Reached};
use crate::diagnose::kernel::{self, Kernel};
use crate::diagnose::linearise::{Linear, norm3};
use crate::diagnose::marginal::log_sum;
use crate::diagnose::model::{Model, solve};
use crate::diagnose::outcome::{Region, Where};
use crate::diagnose::search::{
    ALARM_NATS, Chosen, DROP_NATS, Hypothesis, NULL_PRIOR, Slot, UNEXPLAINED_PRIOR, flat,
};
use robot_model::units::mm_from_m;
use std::collections::{BTreeMap, BTreeSet};

/// More lines of one joint than this are many gears, not one shape.
const MOST_OVERTONES: usize = 10;
/// Share of periodic shapes in structure of no named cause; each period pays for the scan as a line of it does.
const PERIOD_WEIGHT: f64 = 0.05;
/// Prior of one cause that varies, over that of all other structure.
const VARYING_WEIGHT: f64 = 0.1;
/// And structure smaller than this share leaves them in their right, even where it could replace one.
pub const SMALL_BESIDE: f64 = 0.25;
/// With more causes than this each gear line is not tried against all others again.
pub const MANY: usize = 8;

/// Probability of all structure in a slot.
#[must_use]
pub fn kernel_share(slot: &Slot) -> f64 {
    slot.ranked.iter().filter(|(h, _, _)| matches!(h, Hypothesis::Kernel(_))).map(|r| r.1).sum()
}

/// Whether `kernel` is a mere shape of `candidate`: a joint that turns slowly over time, somehow, is what a joint does that
/// drifts as it warms.
fn is_shape_of(model: &Model<'_>, kernel: usize, candidate: usize) -> bool {
    let this = &model.library.candidates[candidate];
    let warming = (this.effect().name() == "thermal_joint_drift").then_some(this.form.joint).flatten();
    matches!(model.library.kernels[kernel].kernel, Kernel::JointTime(j) if Some(j) == warming)
}

/// Probability of the structure in a slot that is no mere shape of `candidate`.
#[must_use]
pub fn rival_share(model: &Model<'_>, slot: &Slot, candidate: usize) -> f64 {
    let rival = |(h, _, _): &&(Hypothesis, f64, Reached)| matches!(h, Hypothesis::Kernel(k) if !is_shape_of(model, *k, candidate));
    slot.ranked.iter().filter(rival).map(|r| r.1).sum()
}

/// ln evidence of structure over nothing, priors within the kernels included; and the likeliest kernel.
pub fn structure(model: &Model<'_>, slot: &Slot) -> Option<(f64, usize)> {
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

/// Structure that no effect takes: everywhere, and round the causes that were found.
pub fn add_kernels(model: &mut Model<'_>, linear: &Linear, chosen: &[Chosen]) {
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
    let of_line = |joint: usize, n: u32| {
        let form = |c: &&Candidate| c.form.joint == Some(joint) && c.form.n == Some(n);
        model.library.candidates.iter().find(form).map_or(0.0, |c| c.weight)
    };
    for (joint, n) in periods {
        let weight = 0.5 * PERIOD_WEIGHT * of_line(joint, n);
        list.extend([(Kernel::Periodic(joint, n), weight), (Kernel::Steps(joint, n), weight)]);
    }
    if scene.time_min.is_none() && chosen.len() <= MANY {
        list.extend((0..chosen.len()).map(|i| (Kernel::Varying(i), VARYING_WEIGHT)));
    }
    let design = &model.design;
    model.library.add_kernels(design, list, &|kernel| match kernel {
        Kernel::Varying(i) => kernel::varying(design, scene, &chosen[i].columns),
        other => kernel::columns(other, design, scene),
    });
}

/// A kernel that is likelier than all lines of one joint's gear together: steps and teeth of one shape, not
/// many gears.
pub fn shape_of_lines(model: &Model<'_>, chosen: &[Chosen]) -> Option<usize> {
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let whole_m = total_rms_m(model, chosen);
    for (joint, lines) in lines_by_joint(model, chosen) {
        let rest: Vec<Chosen> =
            (0..chosen.len()).filter(|i| !lines.contains(i)).map(|i| chosen[i].clone()).collect();
        let taken_m = (whole_m.powi(2) - total_rms_m(model, &rest).powi(2)).max(0.0).sqrt();
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
                Kernel::Periodic(j, _) | Kernel::Steps(j, _) | Kernel::Joint(j) | Kernel::JointFine(j) => {
                    j == joint
                }
                _ => false,
            };
            if fits {
                let reached = background.evidence(&background.project(&structure.sums));
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
        if let Some((_, kernel)) = best.filter(|(odds, _)| *odds > together + DROP_NATS) {
            return Some(kernel);
        }
    }
    None
}

/// A cause that must have grown or faded over rows whose time is not known: then it is not the cause.
pub fn varying_cause(model: &Model<'_>, rest: &Slot) -> Option<usize> {
    rest.ranked.iter().find_map(|(h, _, reached)| match h {
        Hypothesis::Kernel(k) if matches!(model.library.kernels[*k].kernel, Kernel::Varying(_)) => {
            (reached.log_evidence - rest.null.log_evidence > ALARM_NATS).then_some(*k)
        }
        _ => None,
    })
}

/// How large the structure is that a kernel takes after the causes, 3-D rms, metres.
pub fn left_over_m(slot: &Slot, kernel: usize) -> f64 {
    let sigma_with = slot
        .ranked
        .iter()
        .find(|(h, _, _)| *h == Hypothesis::Kernel(kernel))
        .map_or(slot.null.sigma_m, |r| r.2.sigma_m);
    (3.0 * (slot.null.sigma_m.powi(2) - sigma_with.powi(2)).max(0.0)).sqrt()
}

/// ln odds of structure alone, of no cause a mere shape, over all causes together.
pub fn odds_over_causes(model: &Model<'_>, chosen: &[Chosen]) -> f64 {
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let over = |k: usize| Background::new(&model.design, &atoms, &flat(&chosen[..k], None), model.noise);
    let slot = model.library.scan_kernels(&over(0));
    let structure = log_sum(slot.ranked.iter().filter_map(|(h, _, reached)| match h {
        Hypothesis::Kernel(k) if !chosen.iter().any(|c| is_shape_of(model, *k, c.candidate)) => {
            Some(reached.log_evidence + model.library.kernels[*k].log_prior - NULL_PRIOR.ln())
        }
        _ => None,
    })) - slot.null.log_evidence;
    let mut causes = 0.0;
    for (k, one) in chosen.iter().enumerate() {
        let c = one.candidate;
        causes += model.library.gain(&over(k), &atoms, c) + model.library.log_prior[c] - NULL_PRIOR.ln();
    }
    structure - causes
}

/// ln odds of structure over nothing from its ln evidence.
#[must_use]
pub fn structure_odds(gain_nats: f64) -> f64 {
    gain_nats + UNEXPLAINED_PRIOR.ln() - NULL_PRIOR.ln()
}

/// Where the structure lies.
#[must_use]
pub fn place_of_kernel(model: &Model<'_>, linear: &Linear, chosen: &[Chosen], kernel: usize) -> Where {
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let fit = solve(&model.design, &atoms, chosen, Some(model.reached.geometry_ratio));
    let left: Vec<f64> = model.design.residuals(&fit.coefficients).iter().map(norm3).collect();
    let kind = model.library.kernels[kernel].kernel;
    Where {
        joint: match kind {
            Kernel::Joint(j)
            | Kernel::JointFine(j)
            | Kernel::Driven(_, j)
            | Kernel::Joints(j)
            | Kernel::Pair(_, _, j)
            | Kernel::JointTime(j)
            | Kernel::Periodic(j, _)
            | Kernel::Steps(j, _) => Some(j + 1),
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

/// Where in the workspace stations move most.
#[must_use]
pub fn region_of(linear: &Linear, moved_m: &[f64]) -> Region {
    let (centre, radius_m) = kernel::region(&linear.scene, moved_m);
    Region { center_mm: [centre.x, centre.y, centre.z].map(mm_from_m), radius_mm: mm_from_m(radius_m) }
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

fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}
