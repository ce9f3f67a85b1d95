//! The diagnosis from measurements to verdict: checks, registration, linearisation, search, judgement.

use super::effects::Candidate;
use super::evidence::NuisanceModel;
use super::linearise::{Linearised, linearise};
use super::marginal::NoisePrior;
use super::model::{Model, Workspace};
use super::options::Options;
use super::outcome::{Cause, Detectable, Findings, NoiseEstimate, RowResidual, Untestable, Verdict, Warning};
use super::rounding::Suspicion;
use super::{
    dataset, design, effects, false_row, heldout, identify, model, next_measurements, noise_fault, rounding,
    search, verdict, zeros,
};
use crate::measure::{
    Fault, FaultKind, Measurements, PartFault, Row, Stations, alone, check_rows, describe_move, find_fault,
    find_in_cells, find_in_rows, find_joint_columns, find_pose_names, gather, register,
};
use nalgebra::{Isometry3, Point3};
use robot_model::deform::EffectKind;
use robot_model::deform::identified::Identified;
use robot_model::kinematics::SerialChain;
use robot_model::robot::SerialArm;
use robot_model::units::{m_from_mm, mm_from_m};
use std::borrow::Cow;

/// Fewer stations or poses than these say nothing.
const FEWEST_STATIONS: usize = 12;
const FEWEST_POSES: usize = 8;
/// Geometry this many tolerances off, all joints together, is no mere nuisance any more.
const BEYOND: f64 = 1.0;
/// Of which less than this share is left by the registration: no signal.
const INVISIBLE: f64 = 1e-7;

/// Why a drift over rows is in no model.
const UNTIMED: &str = "what drifts from row to row cannot be carried to another file without times (t_min)";

/// Diagnoses `measurements` of `robot`.
#[must_use]
pub fn diagnose(measurements: &Measurements, robot: &SerialArm, options: &Options) -> Findings {
    examine(measurements, robot, options, None)
}

/// As [`diagnose`], with what was found as a model; `None` where nothing could be fitted.
#[must_use]
pub fn diagnose_and_identify(
    measurements: &Measurements,
    robot: &SerialArm,
    options: &Options,
) -> (Findings, Option<Identified>) {
    let mut identified = None;
    let diagnosis = examine(measurements, robot, options, Some(&mut identified));
    if let Some(model) = &mut identified {
        model.verdict = diagnosis.verdict.name().to_owned();
        model.region_held_out_m = diagnosis
            .shrink
            .region_block
            .as_ref()
            .map(|region| [region.before_rms_mm, region.after_rms_mm].map(m_from_mm));
    }
    (diagnosis, identified)
}

fn examine(
    measurements: &Measurements,
    robot: &SerialArm,
    options: &Options,
    identified: Option<&mut Option<Identified>>,
) -> Findings {
    let checked = check_rows(measurements, robot);
    let mut warnings: Vec<Warning> =
        measurements.warnings.iter().chain(&checked.warnings).map(Warning::from).collect();
    let rows = measurements.rows.len();
    let finish = |mut d: Findings, warnings: Vec<Warning>| {
        d.rows = rows;
        d.warnings = warnings;
        d
    };
    let columns_meant = |fault: Fault| match fault.kind {
        FaultKind::JointsOutOfRange => {
            let rows = alone(measurements, &checked.used);
            find_joint_columns(robot, &rows, measurements.targets.len().max(1)).unwrap_or(fault)
        }
        _ => fault,
    };
    let fault = checked.fault.clone().map(columns_meant);
    let fault = fault.or_else(|| find_in_cells(measurements, &checked.used, robot));
    if let Some(fault) = &fault {
        return finish(faulty(fault), warnings);
    }
    let mut measurements = Cow::Borrowed(measurements);
    match find_in_rows(
        robot,
        &each_row(&measurements, &checked.used, robot),
        measurements.targets.len().max(1),
        options.tool_m,
    ) {
        Some(PartFault::Fault(fault)) => return finish(faulty(&fault), warnings),
        Some(PartFault::Moved { from, first_from_second }) => {
            let second = checked.used.get(from..).unwrap_or_default();
            let line = second.first().and_then(|&row| measurements.rows.get(row)).map_or(0, |row| row.line);
            warnings.push(Warning {
                code: "measure::instrument-moved",
                message: describe_move(&first_from_second, line),
            });
            seen_from_first_stand(measurements.to_mut(), second, &first_from_second);
        }
        None => {}
    }
    let measurements = measurements.as_ref();
    if let Some(fault) = find_pose_names(measurements, &checked.used) {
        return finish(faulty(&fault), warnings);
    }
    let mut stations = gather(measurements, &checked.used);
    stations.channels.time &= checked.time_usable;
    if !stations.channels.time {
        stations.stations.iter_mut().for_each(|s| s.t_min = None);
    }
    let poses: std::collections::BTreeSet<usize> = stations.stations.iter().map(|s| s.pose).collect();
    if stations.stations.len() < FEWEST_STATIONS || poses.len() < FEWEST_POSES {
        let reason = format!(
            "{} different poses are too few: base and target alone take 9 unknowns; 30 spread poses say something, 60 a lot",
            poses.len()
        );
        return finish(Findings::without_causes(Verdict::InsufficientData, reason), warnings);
    }
    let chain = SerialChain::nominal(robot);
    let flange: Vec<Isometry3<f64>> = stations.stations.iter().map(|s| s.pose(&chain)).collect();
    let registration = match register(&stations.stations, &flange, stations.targets, options.tool_m) {
        Ok(registration) => registration,
        Err(error) => {
            return finish(Findings::without_causes(Verdict::InsufficientData, error.to_string()), warnings);
        }
    };
    if let Some(fault) =
        find_fault(robot, &stations.stations, stations.targets, &registration, options.tool_m)
    {
        return finish(faulty(&fault), warnings);
    }
    let channels = stations.channels;
    let linear = match linearise(robot, &stations, &registration, options.tool_m, channels) {
        Ok(linear) => linear,
        Err(error) => {
            return finish(Findings::without_causes(Verdict::InsufficientData, error.to_string()), warnings);
        }
    };
    let noise = NoisePrior::new(stations.repeats.as_ref(), options.sigma_m);
    if let (true, Some(seen)) =
        (NoisePrior::contradicted(stations.repeats.as_ref(), options.sigma_m), stations.repeats)
    {
        warnings.push(Warning {
            code: "diagnose::noise",
            message: format!(
                "the repeats scatter by {:.4} mm in one coordinate, which is not the noise that was stated; the repeats are believed",
                mm_from_m(seen.sigma_m)
            ),
        });
    }
    let mut diagnosis = evaluate(measurements, robot, &stations, &linear, noise, options, identified);
    diagnosis.tool_mm = registration.tools_m.first().map(|t| [t.x, t.y, t.z].map(mm_from_m));
    diagnosis.stations = stations.stations.len();
    warnings.append(&mut diagnosis.warnings);
    finish(diagnosis, warnings)
}

/// Each row on its own, with the nominal arm's flange pose.
fn each_row(measurements: &Measurements, used: &[usize], robot: &SerialArm) -> Vec<Row> {
    let chain = SerialChain::nominal(robot);
    alone(measurements, used).into_iter().map(|station| Row { pose: station.pose(&chain), station }).collect()
}

/// Takes the readings of `rows` into the frame of the instrument's first stand; what that leaves is registered with them.
fn seen_from_first_stand(
    measurements: &mut Measurements,
    rows: &[usize],
    first_from_second: &Isometry3<f64>,
) {
    for &index in rows {
        let Some(row) = measurements.rows.get_mut(index) else { continue };
        if let Some(position_m) = row.reading.position_m() {
            row.reading =
                row.reading.with_coordinates_m((first_from_second * Point3::from(position_m)).coords);
            row.orientation = row.orientation.map(|turn| first_from_second.rotation * turn);
            row.stand = 1;
        }
    }
}

fn faulty(fault: &Fault) -> Findings {
    let mut diagnosis = Findings::without_causes(Verdict::DataFault, fault.reason.clone());
    let kind = match fault.kind {
        FaultKind::SwappedAxes => Some(EffectKind::SwappedAxes),
        FaultKind::RoundedJoints => Some(EffectKind::JointRounding),
        _ => None,
    };
    diagnosis.causes.extend(kind.map(|kind| Cause::of(kind, 1.0)));
    diagnosis.fault = Some(fault.clone());
    diagnosis
}

fn evaluate(
    measurements: &Measurements,
    robot: &SerialArm,
    stations: &Stations,
    linear: &Linearised,
    noise: NoisePrior,
    options: &Options,
    identified: Option<&mut Option<Identified>>,
) -> Findings {
    let (all, mut untestable) = effects::candidates(&linear.dataset);
    let folds = heldout::folds(&linear.dataset);
    let (candidates, mut detail) = visible(linear, all, stations.targets, noise);
    let (model, mut workspace) = model::build(linear, &candidates, noise, stations.targets, &folds.group_of);
    if let Some(fault) = rounding::find(measurements, robot, linear, &model, &workspace, Suspicion::None)
        .or_else(|| too_many_false(measurements, stations, &model))
    {
        return faulty(&fault);
    }
    let judgement = verdict::judge(&model, &mut workspace, linear);
    if let Some(fault) = noise_fault::noise_beyond_stated(
        measurements,
        robot,
        stations,
        linear,
        &model,
        &workspace,
        &judgement,
    ) {
        return faulty(&fault);
    }
    let (mut no_model, mut untimed) = (None, false);
    if let Some(to) = identified {
        let identify = |model: &Model, workspace: &Workspace<'_>| {
            identify::identify(measurements, robot, stations, linear, model, workspace, options.tool_m)
        };
        let dataset = &linear.dataset;
        let found = if identify::drifts_by_rows(dataset, &candidates, &model.chosen) {
            untimed = true;
            let mut timeless = candidates.clone();
            // Nor steps: together they would climb as the drift does.
            timeless.retain(|candidate| !identify::is_by_rows(dataset, candidate));
            let (model, workspace) =
                model::build(linear, &timeless, noise, stations.targets, &folds.group_of);
            identify(&model, &workspace)
        } else {
            identify(&model, &workspace)
        };
        match found {
            Ok(identified) => *to = Some(identified),
            Err(why) if untimed => no_model = Some(format!("{why}; {UNTIMED}")),
            Err(why) => no_model = Some(why.to_string()),
        }
    }
    workspace.library.gp_alternatives.clear();
    // Far beyond tolerance the arm was never calibrated: its geometry is then part of the answer.
    let far_off = model.peak.geometry_ratio * model.peak.sigma_m > BEYOND;
    let mut diagnosis = Findings::without_causes(judgement.verdict, judgement.reason);
    if untimed && no_model.is_none() {
        diagnosis.warnings.push(Warning {
            code: "diagnose::untimed",
            message: format!("{UNTIMED}: the model is fitted without it"),
        });
    }
    diagnosis.no_model = no_model;
    diagnosis.shrink = heldout::shrink(&model, &mut workspace, linear, &folds);
    if let Some(region) = &diagnosis.shrink.region_block
        && !model.chosen.is_empty()
        && region.after_rms_mm >= region.before_rms_mm
    {
        diagnosis.warnings.push(Warning {
            code: "diagnose::region",
            message: format!(
                "in a region of the workspace held out whole the model is no better than none ({:.3} mm before, {:.3} mm after): it holds where was measured, and nowhere else",
                region.before_rms_mm, region.after_rms_mm
            ),
        });
    }
    detail.extend(untestable.drain(..).map(|hidden| Untestable {
        effect: hidden.kind,
        joints: Vec::new(),
        reason: hidden.reason,
    }));
    let scale_named = judgement.causes.iter().any(|cause| cause.effect == EffectKind::InstrumentScale);
    if model.peak.geometry_ratio > 0.0 && !scale_named {
        detail.push(Untestable {
            effect: EffectKind::InstrumentScale,
            joints: Vec::new(),
            reason: "the links' lengths are free within their tolerance, and a small scale lies inside them: a scale bar tells"
                .to_owned(),
        });
    }
    let mut names: Vec<EffectKind> = detail.iter().map(|d| d.effect).collect();
    names.sort_by_key(|kind| kind.name());
    names.dedup();
    diagnosis.untestable = names;
    diagnosis.untestable_detail = detail;
    diagnosis.zeros_alone = far_off.then(|| zeros::zeros(&model, &mut workspace)).flatten();
    diagnosis.noise = NoiseEstimate {
        repeats_sigma_mm: noise.known.map(|(sigma_m, _)| mm_from_m(sigma_m)),
        repeats_freedom: stations.repeats.map_or(0, |r| r.degrees_of_freedom),
        model_sigma_mm: Some(mm_from_m(model.noise_m())),
        shared_sigma_mm: (model.shared_ratio > 0.0)
            .then(|| mm_from_m(model.peak.sigma_m * model.shared_ratio.sqrt())),
        reduced_chi_square: judgement.reduced_chi_square,
        geometry_tolerances: Some(model.peak.geometry_ratio * model.peak.sigma_m),
    };
    (diagnosis.next_measurements, diagnosis.next_step) = next_measurements::next_measurements(
        robot,
        &model,
        &mut workspace,
        linear,
        &judgement.open,
        judgement.verdict,
        options,
    );
    diagnosis.next_reason.clone_from(&diagnosis.next_step.reason);
    diagnosis.causes = judgement.causes;
    diagnosis.alternatives = judgement.alternatives;
    diagnosis.place = judgement.place;
    diagnosis.detectable = detectable(&model, &workspace);
    diagnosis.false_rows = false_row::false_rows(measurements, stations, linear, &model);
    diagnosis.false_lines = diagnosis.false_rows.iter().map(|row| row.line).collect();
    diagnosis.residuals = residuals(measurements, robot, linear, stations, &model, &workspace);
    diagnosis
}

/// More than this share of the rows is not false by chance.
const FALSE_SHARE: f64 = 0.2;

/// A file of which more than a fifth would have to be set aside.
fn too_many_false(measurements: &Measurements, stations: &Stations, model: &Model) -> Option<Fault> {
    let far = stations.stations.iter().zip(&model.outliers).filter(|(_, out)| **out);
    let rows = far.flat_map(|(station, _)| &station.rows).chain(&stations.false_rows);
    let lines: Vec<u64> = rows.filter_map(|&row| measurements.rows.get(row)).map(|row| row.line).collect();
    let used =
        stations.stations.iter().map(|station| station.rows.len()).sum::<usize>() + stations.false_rows.len();
    (lines.len() as f64 > FALSE_SHARE * used as f64).then(|| {
        Fault::in_rows(FaultKind::TooManyFalse, "x_mm, y_mm, z_mm", lines, |count, which| {
            format!("{count} of {used} rows ({which}) do not go with the others, each in its own way: look at them before anything else")
        })
    })
}

/// Candidates that leave a signal beside the registration, and those that do not.
fn visible(
    linear: &Linearised,
    all: Vec<Candidate>,
    targets: usize,
    noise: NoisePrior,
) -> (Vec<Candidate>, Vec<Untestable>) {
    let n = linear.dataset.observations.len();
    let whitening = design::Whitening::independent(vec![1.0; n], 0.2);
    let design = design::Design::new(&linear.dataset, &linear.residuals, targets, whitening, &vec![0; n]);
    let nuisance = NuisanceModel::new(&design, &[0], &[], noise);
    let mut kept = Vec::new();
    let mut hidden: Vec<Untestable> = Vec::new();
    for candidate in all {
        // Lines of a gear never lie in the registration; there are thousands.
        let line = candidate.kind == EffectKind::GearMesh;
        let share = if line {
            1.0
        } else {
            let columns = design.columns_of(&linear.dataset, &candidate);
            nuisance.visible(&design.products(&columns).sum(&[0]))
        };
        if share > INVISIBLE {
            kept.push(candidate);
            continue;
        }
        let effect = candidate.kind;
        let joint = candidate.variant.joint;
        let reason = "its signal lies wholly inside base and target, which are unknown".to_owned();
        match hidden.iter_mut().find(|h| h.effect == effect) {
            Some(h) => h.joints.extend(joint.filter(|j| !h.joints.contains(j))),
            None => hidden.push(Untestable { effect, joints: joint.into_iter().collect(), reason }),
        }
    }
    (kept, hidden)
}

/// For each effect and joint the size that would have passed the alarm.
fn detectable(model: &Model, workspace: &Workspace<'_>) -> Vec<Detectable> {
    let groups: Vec<usize> = (0..workspace.design.groups()).collect();
    let also = search::cause_columns(&model.chosen, None);
    let nuisance = NuisanceModel::new(&workspace.design, &groups, &also, model.noise);
    let mut seen: Vec<Detectable> = Vec::new();
    for (candidate, products) in workspace.library.candidates.iter().zip(&workspace.library.products) {
        let effect = candidate.effect();
        let joint = candidate.variant.joint;
        let known = seen.iter().any(|d| d.effect == effect.kind() && d.joint == joint);
        if known || candidate.variant.joint_b.is_some() {
            continue;
        }
        let sums = products.sum(&groups);
        let strength = nuisance.strength(&nuisance.project(&sums), model.peak.geometry_ratio);
        // Less is what rounding leaves of a signal that lies wholly in base and target.
        if strength * strength > INVISIBLE * sums.own[(0, 0)] {
            // Half the squared signal over noise must pass the alarm and the price of its parameters.
            let needed = (2.0 * (search::ALARM_NATS + 3.0)).sqrt() * model.peak.sigma_m;
            let prior_sigma = candidate.prior_sigma.first().copied().unwrap_or(0.0);
            let size = needed / strength * prior_sigma * candidate.display_scale;
            seen.push(Detectable { effect: effect.kind(), joint, size, unit: candidate.unit() });
        }
    }
    seen
}

fn residuals(
    measurements: &Measurements,
    robot: &SerialArm,
    linear: &Linearised,
    stations: &Stations,
    model: &Model,
    workspace: &Workspace<'_>,
) -> Vec<RowResidual> {
    let groups: Vec<usize> = (0..workspace.design.groups()).collect();
    let before = workspace.design.residuals(
        &model::solve(&workspace.design, &groups, &[], None).without_slow(&workspace.design).coefficients,
    );
    let mm = |m: &dataset::Twist| [m[0], m[1], m[2]].map(mm_from_m);
    let mut all = Vec::new();
    let chain = SerialChain::nominal(robot);
    for (i, station) in stations.stations.iter().enumerate() {
        // Of the nominal arm, as `tool_mm` is: the fitted arm's tool may lie far off along a direction that the poses hardly tell.
        let point = linear.registration.predicted_m(station, &station.pose(&chain));
        for row in station.rows.iter().filter_map(|&r| measurements.rows.get(r)) {
            all.push(RowResidual {
                line: row.line,
                id: row.id.clone(),
                q_deg: robot.in_deg_or_mm(&row.q_rad),
                t_min: row.t_min,
                point_mm: [point.x, point.y, point.z].map(mm_from_m),
                before_mm: mm(&before[i]),
                after_mm: mm(&model.residuals[i]),
                outlier: model.outliers[i],
            });
        }
    }
    all.sort_by_key(|r| r.line);
    all
}
