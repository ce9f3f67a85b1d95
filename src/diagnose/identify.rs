//! What was found, as a model: the causes and the geometry behind them, refitted on the arm as it really moves.
//!
//! The search works on first-order signatures; here the same parameters, with the same size priors, are fitted again to the
//! residuals of the exact arm (Gauss-Newton, the signatures as Jacobian).

use super::design::{Design, Whitening};
use super::effects::{COMPLIANCE, Candidate, SOFT};
use super::linearise::Linear;
use super::model::{Fit, Model, solve};
use super::scene::{Driver, Motion, Scene};
use super::search::Chosen;
use crate::deform::identified::{Hangs, Identified, Kind, Mounting, Seen, Shape, Term, Value, When};
use crate::deform::{Conditions, DeformedArm, Payload};
use crate::kinematics::{Chain, FrameOffsets};
use crate::measure::{Measurements, RegisterError, Registration, Station, Stations, register};
use crate::robot::Robot;
use nalgebra::{Isometry3, Vector3};
use rayon::prelude::*;
use std::sync::Arc;

const ROUNDS: usize = 3;

/// The model of what `model` found.
#[must_use]
pub(super) fn identify(
    measurements: &Measurements,
    robot: &Robot,
    stations: &Stations,
    linear: &Linear,
    model: &Model<'_>,
    tool_m: Option<Vector3<f64>>,
) -> Option<Identified> {
    let scene = &linear.scene;
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let ratio = Some(model.reached.geometry_ratio);
    let candidates: Vec<&Candidate> =
        model.chosen.iter().map(|c| &model.library.candidates[c.candidate]).collect();
    let first = solve(&model.design, &atoms, &model.chosen, ratio);
    let mut found = Found {
        geometry: model.design.geometry.clone().map(|c| first.coefficients[c - 1]).collect(),
        causes: model
            .chosen
            .iter()
            .map(|c| c.columns.iter().map(|&k| first.coefficients[k - 1]).collect())
            .collect(),
    };
    let shared = Arc::new(robot.clone());
    let mut identified = Identified {
        robot: robot.name.clone(),
        sigma_m: Some(model.reached.sigma_m),
        seen: seen(measurements.rows.len(), stations),
        ..Identified::default()
    };
    let mut fit = first;
    let mut columns: Vec<Vec<usize>> = model.chosen.iter().map(|c| c.columns.clone()).collect();
    let mut centre_m = agree_on_centre(&candidates, &mut found);
    for _ in 0..ROUNDS {
        identified.terms = terms(scene, &candidates, &found, None);
        let so_far = Arc::new(identified.clone());
        let (residuals, _) = left_over(&shared, stations, &so_far, linear, tool_m, centre_m).ok()?;
        // Residual plus what the parameters already take, to first order: the prior then pulls on the whole.
        let mut design = design_of(scene, &residuals, stations.targets, model);
        columns = candidates.iter().map(|c| design.append(design.columns_of(scene, c)).collect()).collect();
        let coefficients = coefficients(&design, &columns, &found);
        let taken = design.residuals(&coefficients);
        let restored: Vec<Motion> = residuals
            .iter()
            .zip(&taken)
            .map(|(left, without)| std::array::from_fn(|k| 2.0 * left[k] - without[k]))
            .collect();
        let mut design = design_of(scene, &restored, stations.targets, model);
        for candidate in &candidates {
            design.append(design.columns_of(scene, candidate));
        }
        let chosen: Vec<Chosen> = model
            .chosen
            .iter()
            .zip(&columns)
            .map(|(c, columns)| Chosen { columns: columns.clone(), ..c.clone() })
            .collect();
        fit = solve(&design, &[0], &chosen, ratio);
        found = Found {
            geometry: design.geometry.clone().map(|c| fit.coefficients[c - 1]).collect(),
            causes: columns.iter().map(|of| of.iter().map(|&k| fit.coefficients[k - 1]).collect()).collect(),
        };
        centre_m = agree_on_centre(&candidates, &mut found);
    }
    let sigmas = Sigmas {
        fit: &fit,
        geometry_start: model.design.geometry.start,
        columns: &columns,
        sigma_m: model.reached.sigma_m,
    };
    identified.terms = terms(scene, &candidates, &found, Some(&sigmas));
    let whole = Arc::new(identified.clone());
    let (_, registration) = left_over(&shared, stations, &whole, linear, tool_m, centre_m).ok()?;
    identified.mounting = Some(Mounting {
        instrument_from_base: registration.instrument_from_base,
        tools_m: registration.tools_m,
    });
    identified.as_written().ok()
}

/// Scaled parameters.
struct Found {
    geometry: Vec<f64>,
    causes: Vec<Vec<f64>>,
}

struct Sigmas<'a> {
    fit: &'a Fit,
    geometry_start: usize,
    columns: &'a [Vec<usize>],
    sigma_m: f64,
}

impl Sigmas<'_> {
    fn of(&self, column: usize) -> Option<f64> {
        let i = self.fit.columns.iter().position(|c| *c == column)?;
        Some(self.sigma_m * self.fit.covariance[(i, i)].max(0.0).sqrt())
    }
}

fn design_of(scene: &Scene, residuals: &[Motion], targets: usize, model: &Model<'_>) -> Design {
    let whitening: Whitening = model.design.whitening().clone();
    Design::new(scene, residuals, targets, whitening, &vec![0; scene.sites.len()])
}

/// One for each column after the data.
fn coefficients(design: &Design, columns: &[Vec<usize>], found: &Found) -> Vec<f64> {
    let mut all = vec![0.0; design.width() - 1];
    for (column, value) in design.geometry.clone().zip(&found.geometry) {
        all[column - 1] = *value;
    }
    for (of, values) in columns.iter().zip(&found.causes) {
        for (column, value) in of.iter().zip(values) {
            all[column - 1] = *value;
        }
    }
    all
}

/// Measured minus predicted by the model at every station, base axes, and the registration that goes with it.
fn left_over(
    robot: &Arc<Robot>,
    stations: &Stations,
    model: &Arc<Identified>,
    linear: &Linear,
    tool_m: Option<Vector3<f64>>,
    payload_off_m: Vector3<f64>,
) -> Result<(Vec<Motion>, Registration), RegisterError> {
    let payload_m: Vec<Vector3<f64>> =
        linear.registration.tools_m.iter().map(|tool_m| tool_m + payload_off_m).collect();
    let (scaled, poses) = predicted(robot, &stations.stations, model, &payload_m);
    let registration = register(&scaled, &poses, stations.targets, tool_m)?;
    let left = scaled.iter().zip(&poses).map(|(s, pose)| registration.residual(s, pose)).collect();
    Ok((left, registration))
}

/// The stations as a true instrument would have seen them, and the flange poses of the model there, with the
/// payload's centre at `payload_m` for each target.
pub(super) fn predicted(
    robot: &Arc<Robot>,
    stations: &[Station],
    model: &Arc<Identified>,
    payload_m: &[Vector3<f64>],
) -> (Vec<Station>, Vec<Isometry3<f64>>) {
    let scale: f64 =
        model.terms.iter().filter(|t| t.kind == Kind::InstrumentScale).map(|t| t.value(0)).sum::<f64>() + 1.0;
    let start = When { t_min: 0.0, joint_temperature_c: None };
    let arm = DeformedArm::of_model(robot, &FrameOffsets::default(), model, start);
    // Of all this only the base's own motion moves a nest.
    let of_base = |t: &&Term| matches!(t.kind, Kind::BaseDrift | Kind::BaseStep);
    let base =
        Identified { terms: model.terms.iter().filter(of_base).cloned().collect(), ..(**model).clone() };
    let base = DeformedArm::of_model(robot, &FrameOffsets::default(), &Arc::new(base), start);
    let zero = [0.0; 6];
    let flange_from_base = Chain::nominal(robot).forward(&zero).inverse();
    let poses = stations
        .par_iter()
        .map(|station| {
            let when = When {
                t_min: station.t_min.unwrap_or(0.0),
                joint_temperature_c: station.joint_temperature_c,
            };
            let cog_m = payload_m.get(station.target).map_or([0.0; 3], |t| [t.x, t.y, t.z]);
            let conditions = Conditions {
                payload: Payload { mass_kg: station.payload_kg.unwrap_or(0.0), cog_m },
                direction: station.direction.unwrap_or_default(),
            };
            if !station.seen.by_arm() {
                return base.at(when).under(&Conditions::default()).forward(&zero) * flange_from_base;
            }
            arm.at(when).under(&conditions).forward(&station.q_rad)
        })
        .collect();
    let scaled = stations.iter().map(|s| Station { seen: s.seen.scaled(1.0 / scale), ..s.clone() }).collect();
    (scaled, poses)
}

fn terms(scene: &Scene, candidates: &[&Candidate], found: &Found, sigmas: Option<&Sigmas<'_>>) -> Vec<Term> {
    let mut terms = Vec::new();
    for (i, (candidate, values)) in candidates.iter().zip(&found.causes).enumerate() {
        let known = sigmas.and_then(|s| s.columns.get(i).map(|columns| (s, columns)));
        let values: Vec<Value> = values
            .iter()
            .zip(&candidate.usual)
            .enumerate()
            .map(|(k, (value, usual))| Value {
                value: value * usual,
                sigma: known.and_then(|(s, columns)| s.of(*columns.get(k)?)).map(|s| s * usual),
            })
            .collect();
        terms.extend(term(scene, candidate, values));
    }
    if found.geometry.iter().any(|g| *g != 0.0) {
        for (link, row) in found.geometry.chunks(6).enumerate() {
            let values = row
                .iter()
                .enumerate()
                .map(|(k, value)| Value {
                    value: value * Design::tolerance(k),
                    sigma: sigmas
                        .and_then(|s| s.of(s.geometry_start + 6 * link + k))
                        .map(|s| s * Design::tolerance(k)),
                })
                .collect();
            terms.push(Term { cause: false, ..Term::plain(Kind::LinkGeometry, Some(link), values) });
        }
    }
    terms
}

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
    let n = candidate.usual.len();
    let there = match Kind::named(candidate.effect().name())? {
        Kind::JointCompliance => n > 7 - candidate.form.joint?,
        kind => kind == Kind::PayloadMass,
    };
    there.then(|| n - 3..n)
}

/// The payload's centre off the measured point, flange frame, on which all causes agree best; their
/// parameters are set to it.
fn agree_on_centre(candidates: &[&Candidate], found: &mut Found) -> Vector3<f64> {
    const FURTHEST_M: f64 = 0.5;
    let (mut sum, mut weight) = (Vector3::zeros(), 0.0);
    for (candidate, values) in candidates.iter().zip(&found.causes) {
        if let Some(at) = centre_at(candidate) {
            for (to, k) in sum.iter_mut().zip(at) {
                *to += values[0] * values[k] * candidate.usual[k] / candidate.usual[0];
            }
            weight += values[0] * values[0];
        }
    }
    let off_m = if weight > 0.0 { sum / weight } else { sum };
    let off_m = off_m.cap_magnitude(FURTHEST_M);
    for (candidate, values) in candidates.iter().zip(&mut found.causes) {
        for (k, off) in centre_at(candidate).into_iter().flatten().zip(off_m.iter()) {
            values[k] = values[0] * candidate.usual[0] * off / candidate.usual[k];
        }
    }
    off_m
}

/// A candidate's parameters, in the order of its motions, as a term.
fn term(scene: &Scene, candidate: &Candidate, values: Vec<Value>) -> Option<Term> {
    let kind = Kind::named(candidate.effect().name())?;
    let form = &candidate.form;
    let hangs = match (kind, form.variant) {
        (Kind::PayloadMass, 1) => Hangs::Always,
        (Kind::PayloadMass, 2) => Hangs::PerKilogram,
        _ => Hangs::WhereLoaded,
    };
    let values = match kind {
        // Where the payload's centre lies is no part of the robot.
        Kind::JointCompliance => by_link(values, 1, form.joint?, 7),
        Kind::LinkBending => by_link(values, 2, form.joint? + 1, 8),
        Kind::PayloadMass => {
            let share = if hangs == Hangs::PerKilogram { 1.0 / scene.largest_payload_kg } else { 1.0 };
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
        Kind::ToolDrift | Kind::ToolStep => values.into_iter().take(3).collect(),
        _ => values,
    };
    let shape = match form.driver {
        Driver::None => Shape::Always,
        Driver::Exponential { tau_min } => Shape::Exponential { tau_min },
        Driver::TwoLags { tau_min } => Shape::TwoLags { tau_min },
        Driver::Linear => {
            let [from_min, to_min] = scene.time_min?;
            Shape::Linear { from_min, to_min }
        }
        Driver::Step { t0_min } => Shape::Step { t0_min },
        Driver::Temperature => {
            let ranges = scene.joint_temperature_c?;
            Shape::Temperature { from_c: ranges.map(|r| r[0]), to_c: ranges.map(|r| r[1]) }
        }
    };
    let held =
        (kind == Kind::Backlash && form.variant > 0).then(|| super::effects::held_above_n_m(form, scene));
    Some(Term {
        joint_b: form.joint_b,
        n: form.n,
        shape,
        held_above_n_m: held,
        hangs,
        ..Term::plain(kind, form.joint, values)
    })
}

fn seen(rows: usize, stations: &Stations) -> Seen {
    let all = &stations.stations;
    let range = |of: &dyn Fn(&Station) -> Option<f64>| -> Option<[f64; 2]> {
        all.iter().filter_map(of).fold(None, |range, value| match range {
            None => Some([value, value]),
            Some([low, high]) => Some([f64::min(low, value), f64::max(high, value)]),
        })
    };
    let warm = all.iter().any(|s| s.joint_temperature_c.is_some());
    Seen {
        rows,
        q_rad: std::array::from_fn(|j| range(&|s| s.seen.by_arm().then_some(s.q_rad[j])).unwrap_or_default()),
        t_min: range(&|s| s.t_min),
        joint_temperature_c: warm.then(|| {
            std::array::from_fn(|j| range(&|s| s.joint_temperature_c.map(|t| t[j])).unwrap_or_default())
        }),
        payload_kg: range(&|s| s.payload_kg),
    }
}
