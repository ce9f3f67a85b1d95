//! What was solved for, as the terms of a model: from scaled columns to the file's values.

use super::dataset::Dataset;
use super::design::Design;
use super::effects::{COMPLIANCE, Candidate, EffectVariant, SOFT, held_above_n_m};
use super::normal_equations::{LINE_RAD, ModelColumns};
use super::search::ChosenCause;
use nalgebra::{DVector, Vector3};
use robot_model::deform::EffectKind;
use robot_model::deform::identified::{PayloadScaling, Term, Value};

/// What was solved for as terms: causes, the lines that were `named`, geometry, and the rest of the spectra.
#[must_use]
pub(super) fn terms(
    columns: &ModelColumns<'_>,
    named: &[&ChosenCause],
    candidates: &[Candidate],
    solved: &DVector<f64>,
    sigmas: Option<&[f64]>,
) -> Vec<Term> {
    let value = |column: usize, unit: f64| Value {
        value: solved[column] * unit,
        sigma: sigmas.and_then(|s| s.get(column)).map(|s| s * unit),
    };
    let mut terms = Vec::new();
    for (candidate, range) in columns.causes.iter().zip(columns.of_causes()) {
        let values = range
            .zip(&candidate.prior_sigma)
            .map(|(column, prior_sigma)| value(column, *prior_sigma))
            .collect();
        terms.extend(term(columns.dataset, candidate, values));
    }
    let mut spectra: Vec<Vec<Value>> = Vec::new();
    let mut lines = Vec::new();
    for ((joint, all), range) in columns.lines.iter().zip(columns.of_lines()) {
        let last = all.iter().max().map_or(0, |n| *n as usize);
        let none = Value { value: 0.0, sigma: sigmas.map(|_| 0.0) };
        let mut spectrum = vec![none; 2 * last];
        for (n, column) in all.iter().zip(range.step_by(2)) {
            let pair = [value(column, LINE_RAD), value(column + 1, LINE_RAD)];
            let is_this = |variant: &EffectVariant| variant.joint == Some(*joint) && variant.n == Some(*n);
            let name = named.iter().position(|c| is_this(&candidates[c.candidate].variant));
            match name {
                Some(rank) => lines.push((rank, pair.to_vec())),
                None => spectrum[2 * *n as usize - 2..2 * *n as usize].copy_from_slice(&pair),
            }
        }
        spectra.push(spectrum);
    }
    lines.sort_by_key(|(rank, _)| *rank);
    for (rank, values) in lines {
        terms.extend(term(columns.dataset, &candidates[named[rank].candidate], values));
    }
    let geometry: Vec<usize> = columns.geometry().collect();
    if geometry.iter().any(|&column| solved[column].abs() > LEAST_TOLERANCES) {
        for (link, row) in geometry.chunks(6).enumerate() {
            let values = row.iter().enumerate().map(|(k, &column)| value(column, Design::tolerance(k)));
            let term = Term::plain(EffectKind::LinkGeometry, Some(link), values.collect());
            terms.push(Term { cause: false, ..term });
        }
    }
    for ((joint, _), values) in columns.lines.iter().zip(spectra) {
        // A line that is named stands on its own; so does one beyond the spectrum's end.
        let end = values.iter().rposition(|v| v.value != 0.0).map_or(0, |last| last / 2 * 2 + 2);
        let values = values.into_iter().take(end).collect();
        terms.push(Term { cause: false, ..Term::plain(EffectKind::GearSpectrum, Some(*joint), values) });
    }
    terms
}

/// Geometry under so many tolerances is not there.
const LEAST_TOLERANCES: f64 = 1e-9;

/// The first `plain` values, then those of the links from `first` on, in a list of `all`.
fn by_link(values: Vec<Value>, plain: usize, first: usize, all: usize) -> Vec<Value> {
    let mut out = vec![Value::default(); all];
    for (k, value) in values.into_iter().enumerate() {
        if let Some(to) = out.get_mut(if k < plain { k } else { first + k }) {
            *to = value;
        }
    }
    out
}

/// Where a candidate's three parameters stand that move the payload's centre.
fn centre_at(candidate: &Candidate) -> Option<std::ops::Range<usize>> {
    let n = candidate.prior_sigma.len();
    let there = match candidate.kind {
        EffectKind::JointCompliance => n > 7 - candidate.variant.joint?,
        kind => kind == EffectKind::PayloadMass,
    };
    there.then(|| n - 3..n)
}

/// The payload's centre off the measured point, flange frame, on which all causes agree best; their
/// parameters are set to it.
pub(super) fn agree_on_centre(columns: &ModelColumns<'_>, solved: &mut DVector<f64>) -> Vector3<f64> {
    const FURTHEST_M: f64 = 0.5;
    let at: Vec<_> = columns.causes.iter().zip(columns.of_causes()).collect();
    let (mut sum, mut weight) = (Vector3::zeros(), 0.0);
    for (candidate, range) in &at {
        if let Some(centre) = centre_at(candidate) {
            let size = solved[range.start];
            for (to, k) in sum.iter_mut().zip(centre) {
                *to += size * solved[range.start + k] * candidate.prior_sigma[k] / candidate.prior_sigma[0];
            }
            weight += size * size;
        }
    }
    let off_m = if weight > 0.0 { sum / weight } else { sum };
    let off_m = off_m.cap_magnitude(FURTHEST_M);
    for (candidate, range) in &at {
        let size = solved[range.start] * candidate.prior_sigma[0];
        for (k, off) in centre_at(candidate).into_iter().flatten().zip(off_m.iter()) {
            solved[range.start + k] = size * off / candidate.prior_sigma[k];
        }
    }
    off_m
}

/// A candidate's parameters, in the order of its motions, as a term.
fn term(dataset: &Dataset, candidate: &Candidate, values: Vec<Value>) -> Option<Term> {
    let kind = candidate.kind;
    let variant = &candidate.variant;
    let payload_scaling = variant.payload_scaling;
    let values = match kind {
        // Where the payload's centre lies is no part of the robot.
        EffectKind::JointCompliance => by_link(values, 1, variant.joint?, 7),
        EffectKind::LinkBending => by_link(values, 2, variant.joint? + 1, 8),
        EffectKind::PayloadMass => {
            let share = if payload_scaling == PayloadScaling::PerKilogram {
                1.0 / dataset.largest_payload_kg
            } else {
                1.0
            };
            let kg = values.first().copied()?;
            let mut all = vec![Value { value: share * kg.value, sigma: kg.sigma.map(|sigma| share * sigma) }];
            for (j, give) in COMPLIANCE.iter().enumerate() {
                let extra = SOFT.iter().position(|&x| x == j).and_then(|k| values.get(k + 1));
                let value = share * give * (kg.value + extra.map_or(0.0, |e| e.value));
                all.push(Value { value, sigma: None });
            }
            all
        }
        // The model has a shift of the target, not its turn: the point is all that the model places.
        EffectKind::ToolDrift | EffectKind::ToolStep => values.into_iter().take(3).collect(),
        _ => values,
    };
    Some(Term {
        joint_b: variant.joint_b,
        n: variant.n,
        growth: variant.growth,
        held_above_n_m: held_above_n_m(variant, dataset),
        payload_scaling,
        ..Term::plain(kind, variant.joint, values)
    })
}
