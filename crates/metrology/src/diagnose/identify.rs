//! What was found, as a model: the causes and the geometry behind them, refitted on the arm as it really moves.
//!
//! The search works on first-order signatures; here the same parameters, with the same size priors, are fitted again to the
//! residuals of the exact arm (Gauss-Newton, the signatures as Jacobian).

use super::dataset::Twist;
use super::linearise::Linearised;
use super::model::{Model, Workspace};
use super::normal_equations::ModelColumns;
use super::search::ChosenCause;
use super::spectrum;
use super::terms::{agree_on_centre, terms};
use crate::measure::{Measurements, RegisterError, Registration, Station, Stations, register};
use nalgebra::{Isometry3, Vector3};
use rayon::prelude::*;
use robot_model::deform::EffectKind;
use robot_model::deform::identified::{Identified, MeasuredRange, Mounting, Term, ThermalState};
use robot_model::deform::{Conditions, DeformedArm, Payload};
use robot_model::kinematics::{Chain, FrameOffsets};
use robot_model::robot::Robot;
use std::sync::Arc;

const ROUNDS: usize = 3;

/// The model of what `model` found.
#[must_use]
pub(super) fn identify(
    measurements: &Measurements,
    robot: &Robot,
    stations: &Stations,
    linear: &Linearised,
    model: &Model,
    workspace: &Workspace<'_>,
    tool_m: Option<Vector3<f64>>,
) -> Option<Identified> {
    let dataset = &linear.dataset;
    let candidates = workspace.library.candidates;
    let lines = spectrum::spectra(candidates, &model.chosen);
    let in_spectrum = |c: &&ChosenCause| {
        let variant = candidates[c.candidate].variant;
        variant.n.is_some() && lines.iter().any(|(joint, _)| variant.joint == Some(*joint))
    };
    let (named, chosen): (Vec<&ChosenCause>, Vec<&ChosenCause>) = model.chosen.iter().partition(in_spectrum);
    let columns = ModelColumns {
        dataset,
        whitening: workspace.design.whitening(),
        targets: stations.targets,
        causes: chosen.iter().map(|c| &candidates[c.candidate]).collect(),
        lines,
    };
    let sigma_m = model.peak.sigma_m;
    let ratio = model.peak.geometry_ratio;
    let causes: Vec<f64> = chosen.iter().map(|c| (3.0 * c.size_ratio).powi(-2)).collect();
    // Without geometry in the model its columns are held at nothing.
    let geometry = if ratio > 0.0 { ratio.powi(-2) } else { NOTHING };
    let precisions_at = |size_rad| spectrum::precisions(&columns, geometry, &causes, sigma_m, size_rad);
    let size_rad = match columns.lines.is_empty() {
        true => 1.0,
        false => spectrum::size_rad(&columns, &linear.residuals, &model.outliers, precisions_at),
    };
    let precisions = precisions_at(size_rad);
    let all: Vec<usize> = (0..dataset.observations.len()).collect();
    let mut normal = columns.sum(&all, &linear.residuals);
    let (mut solved, _) = normal.solve(&precisions, false)?;
    let robot = Arc::new(robot.clone());
    let mut identified = Identified {
        robot: robot.name.clone(),
        sigma_m: Some(sigma_m),
        measured_range: measured_range(measurements.rows.len(), stations),
        ..Identified::default()
    };
    let mut centre_m = agree_on_centre(&columns, &mut solved);
    let mut sigmas = None;
    for round in 1..=ROUNDS {
        identified.terms = terms(&columns, &named, candidates, &solved, None);
        let so_far = Arc::new(identified.clone());
        let (residuals, _) = residuals_of(&robot, stations, &so_far, linear, tool_m, centre_m).ok()?;
        // Residual plus what the parameters already take, to first order: the prior then pulls on the whole.
        solved.rows_mut(0, columns.registration().end).fill(0.0);
        normal.rhs = columns.rhs(&all, &residuals) + &normal.gram * &solved;
        (solved, sigmas) = normal.solve(&precisions, round == ROUNDS)?;
        centre_m = agree_on_centre(&columns, &mut solved);
    }
    let sigmas = sigmas.map(|all| all.into_iter().map(|sigma| sigma_m * sigma).collect::<Vec<f64>>());
    identified.terms = terms(&columns, &named, candidates, &solved, sigmas.as_deref());
    let whole = Arc::new(identified.clone());
    let (_, registration) = residuals_of(&robot, stations, &whole, linear, tool_m, centre_m).ok()?;
    identified.mounting = Some(Mounting {
        instrument_from_base: registration.instrument_from_base,
        tools_m: registration.tools_m,
    });
    identified.as_written().ok()
}

/// Precision of what is not to be moved, over the noise's.
const NOTHING: f64 = 1e18;

/// Measured minus predicted by the model at every station, base axes, and the registration that goes with it.
fn residuals_of(
    robot: &Arc<Robot>,
    stations: &Stations,
    model: &Arc<Identified>,
    linear: &Linearised,
    tool_m: Option<Vector3<f64>>,
    payload_off_m: Vector3<f64>,
) -> Result<(Vec<Twist>, Registration), RegisterError> {
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
        model.terms.iter().filter(|t| t.kind == EffectKind::InstrumentScale).map(|t| t.value(0)).sum::<f64>()
            + 1.0;
    let start = ThermalState { t_min: 0.0, joint_temperature_c: None };
    let arm = DeformedArm::of_model(robot, &FrameOffsets::default(), model, start);
    // Of all this only the base's own motion moves a nest.
    let of_base = |t: &&Term| matches!(t.kind, EffectKind::BaseDrift | EffectKind::BaseStep);
    let base =
        Identified { terms: model.terms.iter().filter(of_base).cloned().collect(), ..(**model).clone() };
    let base = DeformedArm::of_model(robot, &FrameOffsets::default(), &Arc::new(base), start);
    let zero = [0.0; 6];
    let flange_from_base = Chain::nominal(robot).forward(&zero).inverse();
    let poses = stations
        .par_iter()
        .map(|station| {
            let when = ThermalState {
                t_min: station.t_min.unwrap_or(0.0),
                joint_temperature_c: station.joint_temperature_c,
            };
            let cog_m = payload_m.get(station.target).map_or([0.0; 3], |t| [t.x, t.y, t.z]);
            let conditions = Conditions {
                payload: Payload { mass_kg: station.payload_kg.unwrap_or(0.0), cog_m },
                direction: station.direction.unwrap_or_default(),
            };
            if !station.reading.involves_arm() {
                return base.at(when).under(&Conditions::default()).forward(&zero) * flange_from_base;
            }
            arm.at(when).under(&conditions).forward(&station.q_rad)
        })
        .collect();
    let scaled =
        stations.iter().map(|s| Station { reading: s.reading.scaled(1.0 / scale), ..s.clone() }).collect();
    (scaled, poses)
}

fn measured_range(rows: usize, stations: &Stations) -> MeasuredRange {
    let all = &stations.stations;
    let range = |of: &dyn Fn(&Station) -> Option<f64>| -> Option<[f64; 2]> {
        all.iter().filter_map(of).fold(None, |range, value| match range {
            None => Some([value, value]),
            Some([low, high]) => Some([f64::min(low, value), f64::max(high, value)]),
        })
    };
    let warm = all.iter().any(|s| s.joint_temperature_c.is_some());
    MeasuredRange {
        rows,
        q_rad: std::array::from_fn(|j| {
            range(&|s| s.reading.involves_arm().then_some(s.q_rad[j])).unwrap_or_default()
        }),
        t_min: range(&|s| s.t_min),
        joint_temperature_c: warm.then(|| {
            std::array::from_fn(|j| range(&|s| s.joint_temperature_c.map(|t| t[j])).unwrap_or_default())
        }),
        payload_kg: range(&|s| s.payload_kg),
    }
}
