//! From linearised residuals to all that a diagnosis says: search, verdict, model, held-out errors, next measurements.
//!
//! Puts the answers of the other modules together; knows nothing of how the file was read and checked.

use super::balancing::balancing;
use super::detection_limit::DetectionLimits;
use super::false_row::false_rows;
use super::finer_steps::with_finer_steps;
use super::heldout;
use super::identification::{Identification, misses_stated};
use super::iterated_search::{SearchProblem, best_model};
use super::joint_turns::{are_curved, joint_turns};
use super::measured_robot::MeasuredRobot;
use super::model::FittedModel;
use super::next_measurements::next_measurements;
use super::no_model::{NoModel, only_cause_beyond};
use super::noise_fault::noise_beyond_stated;
use super::options::DiagnosisOptions;
use super::outcome::{ErrorReduction, Findings, NoiseEstimate, RowResidual, Untestable, Warning};
use super::play_ahead::play_ahead;
use super::rounding::{self, FaultPrior};
use super::stated_noise::understated_noise;
use super::step_fault::impossible_step;
use super::tool_apart::tool_elsewhere;
use super::verdict::{Judgement, judge, worse_elsewhere};
use super::visible::visible;
use super::zeros::zeros;
use inference::dataset::Twist;
use inference::linear_fit::solve;
use inference::linearise::{Linearised, linearise};
use inference::marginal::NoisePrior;
use inference::time_course::TimeCourse;
use measurements::{Fault, FaultKind, Reading, Station};
use rapid_syntax::diagnostic::counted;
use robot_model::deform::EffectKind;
use robot_model::deform::identified::{Growth, Identified};
use robot_model::kinematics::SerialChain;
use robot_model::units::mm_from_m;
use std::collections::BTreeSet;

/// A model that leaves more than this share of the gap at poses held out follows the poses measured alone.
const FOLLOWED: f64 = 0.9;
/// How often the arm is made linear about the joints as they are found turned.
const MOST_TURNED: usize = 2;
/// Geometry this many tolerances off, all joints together, is no mere nuisance any more.
const BEYOND: f64 = 1.0;
/// More than this share of the rows is not false by chance.
const FALSE_SHARE: f64 = 0.2;
/// Measurements, registered and linearised.
pub(super) struct Prepared<'a> {
    /// The measurements of the robot, as stations.
    pub measured: MeasuredRobot<'a>,
    /// The arm at every station, with its residuals.
    pub linear: &'a Linearised,
    /// What is known of the noise before the fit.
    pub noise: NoisePrior,
    /// What the caller knows beside the file.
    pub options: &'a DiagnosisOptions,
}

/// The diagnosis and, where one was wanted and found, the model.
pub(super) struct Evaluation {
    /// What is said of the data.
    pub diagnosis: Findings,
    /// What was found, as a model.
    pub identified: Option<Identified>,
    /// What the search has found; `None` where the file could not be evaluated.
    pub found: Option<FoundModel>,
}

/// Of the best model what another reading of the same file is held against.
pub(super) struct FoundModel {
    /// ln evidence of the data, but for what is the same whatever is taken for their noise.
    pub log_evidence: f64,
    /// Whether something in it drifts by the minutes: by a law of time, or in a line, which the beginning of one is.
    pub drifts: bool,
    /// Whether something in it changes over time, or its noise is slow: what a pause has bent may look so.
    pub changes: bool,
}

impl FoundModel {
    fn of(fitted: &FittedModel<'_>) -> Self {
        let candidates = &fitted.workspace.library.candidates;
        let chosen = || fitted.model.chosen.iter().map(|cause| &candidates[cause.candidate]);
        Self {
            log_evidence: fitted.log_evidence(),
            drifts: chosen().any(|one| matches!(one.variant.growth, Growth::Law(_) | Growth::Linear { .. })),
            changes: fitted.model.slow.is_some()
                || chosen().any(|candidate| candidate.effect().time() != TimeCourse::Constant),
        }
    }
}

impl Evaluation {
    /// A diagnosis of which no model can be made.
    #[must_use]
    pub(super) fn without_model(diagnosis: Findings) -> Self {
        Self { diagnosis, identified: None, found: None }
    }
}

/// Searches, judges and says what follows; a model only where `wants_model`.
#[must_use]
pub(super) fn evaluate(prepared: &Prepared<'_>, wants_model: bool) -> Evaluation {
    evaluate_about(prepared, wants_model, MOST_TURNED)
}

/// The same with the arm linear about the joints as the causes found have turned them, so many times at most: a zero that has jumped by a
/// degree leaves tenths of a millimetre of second order, which other causes would be found for.
fn evaluate_about(prepared: &Prepared<'_>, wants_model: bool, times: usize) -> Evaluation {
    let Prepared { measured, linear, noise, .. } = *prepared;
    let folds = heldout::folds(&linear.dataset);
    let visible = visible(linear, prepared.measured.stations.targets, prepared.noise);
    let finer_candidates;
    let mut problem =
        SearchProblem { linear, candidates: &visible.candidates, noise, targets: measured.stations.targets };
    let mut fitted = best_model(&problem);
    if let Some(turned) = about_found(prepared, &fitted).filter(|_| times > 0) {
        drop(fitted);
        return evaluate_about(&Prepared { linear: &turned, ..*prepared }, wants_model, times - 1);
    }
    if let Some(candidates) = with_finer_steps(&visible.candidates, &fitted) {
        finer_candidates = candidates;
        problem = SearchProblem { candidates: &finer_candidates, ..problem };
        drop(fitted);
        fitted = best_model(&problem);
    }
    let fault = rounding::find(measured, &fitted, FaultPrior::NoOtherFault);
    if let Some(fault) = fault.or_else(|| too_many_false(measured, &fitted)) {
        return Evaluation::without_model(Findings::of_fault(fault));
    }
    let mut judgement = judge(&mut fitted);
    let step = impossible_step(measured, &judgement.causes);
    if let Some(fault) = step.or_else(|| noise_beyond_stated(measured, &fitted, &judgement)) {
        return Evaluation::without_model(Findings::of_fault(fault));
    }
    let limits = DetectionLimits::of(&fitted);
    let found = Some(FoundModel::of(&fitted));
    let mut fitted = fitted.over_groups(&folds.group_of);
    let shrink = heldout::shrink(&mut fitted, &folds);
    if shrink.ratio.is_some_and(|ratio| ratio > FOLLOWED)
        && let Some(fault) = rounding::find(measured, &fitted, FaultPrior::FollowedHereAlone)
    {
        return Evaluation::without_model(Findings::of_fault(fault));
    }
    let held_against = judgement.hold_against(&shrink);
    let not_carried = held_against.or_else(|| worse_elsewhere(&shrink, judgement.verdict, &judgement.causes));
    let identification = wants_model.then(|| match not_carried {
        Some([before_mm, after_mm]) => Identification::none(NoModel::NotCarried { before_mm, after_mm }),
        None => {
            let judged = (&judgement, &folds, shrink.region_block);
            Identification::of(measured, prepared.options, &problem, &fitted, judged)
        }
    });
    let mut diagnosis = consequences(prepared, shrink, &mut fitted, (judgement, limits));
    name_untestable(&mut diagnosis, visible.untestable, &fitted);
    let Some(identification) = identification else {
        let why = misses_stated(&fitted, prepared.options).or_else(|| only_cause_beyond(&fitted));
        diagnosis.no_model = why.map(|why| why.to_string());
        return Evaluation { found, ..Evaluation::without_model(diagnosis) };
    };
    diagnosis.warnings.splice(0..0, identification.warnings());
    diagnosis.no_model = identification.no_model();
    Evaluation { diagnosis, identified: identification.found.ok(), found }
}

/// Puts what base and target take whole before what would have to be too large to be seen.
fn name_untestable(diagnosis: &mut Findings, hidden: Vec<Untestable>, fitted: &FittedModel<'_>) {
    let mut too_small = std::mem::take(&mut diagnosis.untestable_detail);
    let hidden: Vec<Untestable> = hidden.into_iter().chain(hidden_scale(diagnosis, fitted)).collect();
    // Of what hides whole, a scale among the links' lengths, no size needs to be known.
    too_small.retain(|entry| !hidden.iter().any(|h| h.effect == entry.effect && h.joints.is_empty()));
    // An effect that other joints show is not one that these data cannot show.
    let of_whole_arm = too_small.iter().filter(|entry| entry.joints.is_empty());
    diagnosis.untestable = hidden.iter().chain(of_whole_arm).map(|entry| entry.effect).collect();
    sorting::by_key(&mut diagnosis.untestable, |kind| kind.name());
    diagnosis.untestable.dedup();
    diagnosis.untestable_detail = hidden.into_iter().chain(too_small).collect();
}

/// The arm about the joints as the causes of `fitted` have turned them, where that is another one.
fn about_found(prepared: &Prepared<'_>, fitted: &FittedModel<'_>) -> Option<Linearised> {
    let Prepared { measured, linear, options, .. } = *prepared;
    let turns = joint_turns(fitted);
    if !are_curved(&turns, &linear.joint_turns, &linear.dataset, fitted.model.noise_m()) {
        return None;
    }
    linearise(measured.robot, measured.stations, &linear.registration, options.tool_m, turns).ok()
}

/// What follows from a judged model that carries as far as `shrink` says: what to measure next, what could have been seen, row by row.
fn consequences(
    prepared: &Prepared<'_>,
    shrink: ErrorReduction,
    fitted: &mut FittedModel<'_>,
    (judgement, limits): (Judgement, DetectionLimits),
) -> Findings {
    let Prepared { measured, linear, options, .. } = *prepared;
    let geometry_tolerances = fitted.model.peak.geometry_ratio * fitted.model.peak.sigma_m;
    // Far beyond tolerance the arm was never calibrated: its geometry is then part of the answer.
    let zeros_alone = (geometry_tolerances > BEYOND).then(|| zeros(fitted)).flatten();
    let next = next_measurements(measured.robot, fitted, &judgement, options);
    let false_rows = false_rows(measured, fitted);
    Findings {
        warnings: region_warning(&shrink, fitted)
            .into_iter()
            .chain(place_warning(&measured.stations.stations, fitted))
            .chain(understated_noise(fitted, &judgement))
            .chain(play_ahead(fitted, &judgement.causes))
            .chain(tool_elsewhere(linear, measured.stations.targets, options))
            .chain(balancing(linear.dataset.may_be_balanced, &judgement.causes))
            .collect(),
        shrink,
        zeros_alone,
        noise: noise_estimate(prepared, fitted, judgement.reduced_chi_square.map(|chi| chi.value)),
        next_measurements: next.measurements,
        next_reason: next.step.reason.clone(),
        next_step: next.step,
        causes: judgement.causes,
        alternatives: judgement.alternatives,
        location: judgement.location,
        missing_channel: judgement.missing_channel,
        detectable: limits.detectable,
        untestable_detail: limits.untestable,
        false_lines: false_rows.iter().map(|row| row.line).collect(),
        false_rows,
        residuals: residuals(measured, fitted),
        ..Findings::without_causes(judgement.verdict, judgement.reason)
    }
}

/// Where the model does not hold in a region that was held out whole.
fn region_warning(shrink: &ErrorReduction, fitted: &FittedModel<'_>) -> Option<Warning> {
    let region = shrink.region_block.as_ref()?;
    let is_worse = !fitted.model.chosen.is_empty() && region.after_rms_mm >= region.before_rms_mm;
    is_worse.then(|| Warning {
        code: "diagnose::region",
        message: format!(
            "in a region of the workspace held out whole the model is no better than none ({:.3} mm before, {:.3} mm after): it holds where was measured, and nowhere else",
            region.before_rms_mm, region.after_rms_mm
        ),
    })
}

/// Touches of fewer points than this are all about the same place.
const FEWEST_TOUCHED: usize = 3;

/// That nothing but one or two points was touched: an arm that is right there may be anything elsewhere.
fn place_warning(stations: &[Station], fitted: &FittedModel<'_>) -> Option<Warning> {
    let is_free = !fitted.model.chosen.is_empty() || fitted.model.peak.geometry_ratio > 0.0;
    let touched = stations.iter().map(|station| match station.reading {
        Reading::Touch { fixed_point } => Some(fixed_point),
        _ => None,
    });
    let points = touched.collect::<Option<BTreeSet<usize>>>()?.len();
    (is_free && points < FEWEST_TOUCHED).then(|| Warning {
        code: "diagnose::one-place",
        message: format!(
            "nothing but {} was touched: what is found holds about there, and may be worse than the nominal arm elsewhere",
            counted(points, "fixed point")
        ),
    })
}

fn noise_estimate(
    prepared: &Prepared<'_>,
    fitted: &FittedModel<'_>,
    reduced_chi_square: Option<f64>,
) -> NoiseEstimate {
    let model = &fitted.model;
    NoiseEstimate {
        repeats_sigma_mm: prepared.noise.known.map(|known| mm_from_m(known.sigma_m)),
        repeats_freedom: prepared.measured.stations.repeats.map_or(0, |r| r.degrees_of_freedom),
        model_sigma_mm: Some(mm_from_m(model.noise_m())),
        shared_sigma_mm: (model.shared_ratio > 0.0)
            .then(|| mm_from_m(model.peak.sigma_m * model.shared_ratio.sqrt())),
        reduced_chi_square,
        geometry_tolerances: Some(model.peak.geometry_ratio * model.peak.sigma_m),
    }
}

/// A file of which more than a fifth would have to be set aside.
fn too_many_false(measured: MeasuredRobot<'_>, fitted: &FittedModel<'_>) -> Option<Fault> {
    let stations = measured.stations;
    let far = stations.stations.iter().zip(&fitted.model.outliers).filter(|(_, out)| **out);
    let lines = measured.lines(far.flat_map(|(station, _)| &station.rows).chain(&stations.false_rows));
    let used =
        stations.stations.iter().map(|station| station.rows.len()).sum::<usize>() + stations.false_rows.len();
    (lines.len() as f64 > FALSE_SHARE * used as f64).then(|| {
        Fault::in_rows(FaultKind::TooManyFalse, "x_mm, y_mm, z_mm", lines, |count, which| {
            format!("{count} of {used} rows ({which}) do not go with the others, each in its own way: look at them before anything else")
        })
    })
}

/// The instrument's scale, where it hides in the links' lengths.
fn hidden_scale(diagnosis: &Findings, fitted: &FittedModel<'_>) -> Option<Untestable> {
    // Under another verdict it is the nearest candidate at best.
    let names = diagnosis.verdict.names_causes();
    let is_named = names && diagnosis.causes.iter().any(|cause| cause.effect == EffectKind::InstrumentScale);
    (fitted.model.peak.geometry_ratio > 0.0 && !is_named).then(|| Untestable {
        effect: EffectKind::InstrumentScale,
        joints: Vec::new(),
        reason: "the links' lengths are free within their tolerance, and a small scale lies inside them: a scale bar tells"
            .to_owned(),
        lacks_channel: false,
    })
}

/// Residuals of every row, with registration alone and with the model.
fn residuals(measured: MeasuredRobot<'_>, fitted: &FittedModel<'_>) -> Vec<RowResidual> {
    let MeasuredRobot { robot, measurements, stations } = measured;
    let FittedModel { linear, model, workspace } = fitted;
    let groups = workspace.design.all_groups();
    let before = workspace.design.residuals(
        &solve(&workspace.design, &groups, &[], None).without_slow(&workspace.design).coefficients,
    );
    let mm = |m: &Twist| [m[0], m[1], m[2]].map(mm_from_m);
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
    sorting::by_key(&mut all, |r| r.line);
    all
}
