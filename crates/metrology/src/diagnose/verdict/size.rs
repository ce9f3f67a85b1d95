//! Causes with their sizes, fitted beside the others.

use super::group::Group;
use crate::diagnose::effects::Candidate;
use crate::diagnose::linearise::{Linear, norm3};
use crate::diagnose::model::{Fit, Model, solve};
use crate::diagnose::outcome::Cause;
use crate::diagnose::search::{Chosen, NULL_PRIOR};
use robot_model::units::mm_from_m;

/// A cause with its size: fitted in place `i` of `chosen`, or alone.
pub fn cause(
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

/// A gear line where there are dozens: each stood far out when it was added, none has a rival but its like.
pub fn line_among_many(model: &mut Model<'_>, linear: &Linear, chosen: &[Chosen], i: usize) -> Cause {
    let one = &chosen[i];
    let odds = one.gain_nats + model.library.log_prior[one.candidate] - NULL_PRIOR.ln();
    let group =
        Group { best: one.candidate, probability: 1.0 / (1.0 + (-odds).exp()), gain_nats: one.gain_nats };
    cause(model, linear, chosen, Some(i), &group)
}

/// A cause without its size.
#[must_use]
pub fn cause_unfitted(model: &Model<'_>, group: &Group) -> Cause {
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

/// How far all of `chosen` together move the point at each station, metres.
#[must_use]
pub fn moved_m(model: &Model<'_>, linear: &Linear, chosen: &[Chosen]) -> Vec<f64> {
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

/// What `chosen` take off the residuals beyond registration and geometry, 3-D rms, metres.
#[must_use]
pub fn total_rms_m(model: &Model<'_>, chosen: &[Chosen]) -> f64 {
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let ratio = Some(model.reached.geometry_ratio);
    let left = |chosen: &[Chosen]| {
        let fit = solve(&model.design, &atoms, chosen, ratio);
        let residuals = model.design.residuals(&fit.coefficients);
        let kept: Vec<f64> =
            residuals.iter().zip(&model.outliers).filter(|(_, out)| !**out).map(|(m, _)| norm3(m)).collect();
        rms(&kept).powi(2)
    };
    (left(&[]) - left(chosen)).max(0.0).sqrt()
}

/// Root mean square.
#[must_use]
pub fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|v| v * v).sum::<f64>() / values.len().max(1) as f64).sqrt()
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

/// How far the effect moves the point at each station, metres.
fn moved_by(linear: &Linear, candidate: &Candidate, columns: &[usize], fit: &Fit) -> Vec<f64> {
    let mut buffer = Vec::new();
    linear
        .scene
        .sites
        .iter()
        .map(|site| {
            buffer.clear();
            candidate.effect().motions(&candidate.form, &linear.scene, site, &mut buffer);
            // What a warm-up effect adds as a constant of its own is no part of it.
            let constant = candidate.effect().unit() != "mm" && candidate.effect().time() == "drift";
            let counted = if constant { candidate.counted } else { buffer.len() };
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
