//! What was found, as a model: the causes and the geometry behind them, refitted on the arm as it really moves.
//!
//! The search works on first-order signatures; here the same parameters, with the same size priors, are fitted again to the
//! residuals of the exact arm (Gauss-Newton, the signatures as Jacobian).

use super::holding_torque::with_holding_torques;
use super::measured_robot::MeasuredRobot;
use super::model::FittedModel;
use super::no_model::{NoModel, holds, is_usual};
use super::options::DiagnosisOptions;
use super::payload_centre::PayloadCentre;
use super::terms::terms;
use inference::dataset::{Dataset, Twist};
use inference::effects::{Candidate, EffectVariant, Motion};
use inference::linearise::{Linearised, rms_m};
use inference::normal_equations::{JointLines, ModelColumns};
use inference::search::ChosenCause;
use inference::spectrum;
use inference::time_course::TimeCourse;
use measurements::{RegisterError, Registration, Station, Stations, register};
use nalgebra::{DVector, Isometry3, Vector3};
use robot_model::deform::EffectKind;
use robot_model::deform::identified::{Growth, Identified, MeasuredRange, Mounting, Term, ThermalState};
use robot_model::deform::{DeformedSerialArm, Payload};
use robot_model::robot::{Joints, RobotDigest, SerialArm};
use std::sync::Arc;

const ROUNDS: usize = 3;
/// At most so many where a payload's centre is a product of parameters.
const CENTRE_ROUNDS: usize = 12;
/// A step that leaves less by under this share was the last.
const SETTLED: f64 = 1e-4;

/// The model of what was found in `fitted`.
///
/// # Errors
/// [`NoModel`]: what was found makes no model.
pub(super) fn identify(
    measured: MeasuredRobot<'_>,
    fitted: &FittedModel<'_>,
    options: &DiagnosisOptions,
) -> Result<Identified, NoModel> {
    let MeasuredRobot { robot, measurements, stations } = measured;
    let FittedModel { linear, model, workspace } = fitted;
    let dataset = &*with_holding_torques(fitted);
    let candidates = &workspace.library.candidates;
    let moments = steps_by_rows(dataset, candidates, &model.chosen)?;
    let Parameters { columns, named, chosen, size_rad } = parameters(fitted, dataset, stations.targets);
    let start = Identified {
        robot: robot.name.clone(),
        robot_digest: Some(RobotDigest::of(&robot.geometry())),
        joint_kinds: robot.kinds(),
        sigma_m: Some(model.peak.sigma_m),
        measured_range: measured_range(measurements.rows.len(), stations, robot.joints.len()),
        ..Identified::default()
    };
    let refit = Refit {
        robot: Arc::new(robot.clone()),
        stations: by_the_clock(stations, dataset, moments),
        fitted,
        columns,
        named,
        size_rad,
        options,
    };
    let RefitModel { mut identified, values, centre_m } = refit.solved(start, &precisions_of(&chosen))?;
    let whole = Arc::new(identified.clone());
    let ModelResiduals { residuals: left, registration } =
        refit.residuals_of(&refit.stations, &whole, centre_m)?;
    is_usual(&refit.columns, &values, &refit.named, candidates, &identified)?;
    let kept = |i: usize| !model.outliers[i];
    holds(rms_m(&left, kept), rms_m(&linear.nominal, kept), fitted, options.sigma_m)?;
    identified.mounting = Some(Mounting {
        instrument_from_base: registration.instrument_from_base,
        tools_m: registration.tools_m,
        payload_m: hangs_at_m(&identified, dataset, linear.registration.payload_m() + centre_m),
    });
    if dataset.time_min.is_none() || moments {
        refit.leave_clock(&mut identified, centre_m)?;
    }
    identified.as_written().map_err(|error| NoModel::Unwritable { problem: error.to_string() })
}

/// Which parameters a model has.
struct Parameters<'a> {
    columns: ModelColumns<'a>,
    /// Lines of spectra that have names.
    named: Vec<&'a ChosenCause>,
    /// What stands for itself.
    chosen: Vec<&'a ChosenCause>,
    /// Prior standard deviation of a spectrum's lines, radians.
    size_rad: f64,
}

/// The parameters of the model of what was found: a spectrum in the place of a joint's several lines, unless the lines by themselves transfer
/// clearly better.
fn parameters<'a>(fitted: &'a FittedModel<'_>, dataset: &'a Dataset, targets: usize) -> Parameters<'a> {
    let FittedModel { linear, model, workspace } = fitted;
    let candidates = &workspace.library.candidates;
    let with = |lines: Vec<JointLines>| {
        let in_spectrum = |c: &&ChosenCause| {
            let variant = candidates[c.candidate].variant;
            variant.n.is_some() && lines.iter().any(|of| variant.joint == Some(of.joint))
        };
        let (named, chosen): (Vec<&ChosenCause>, Vec<&ChosenCause>) =
            model.chosen.iter().partition(in_spectrum);
        let causes = chosen.iter().map(|c| &candidates[c.candidate]).collect();
        let whitening = workspace.design.whitening();
        let columns = ModelColumns { dataset, whitening, targets, causes, lines };
        Parameters { columns, named, chosen, size_rad: 1.0 }
    };
    let plain = with(Vec::new());
    let lines = spectrum::spectra(candidates, &model.chosen);
    if lines.is_empty() {
        return plain;
    }
    let geometry = geometry_precision(fitted);
    let mut spectral = with(lines);
    let transfer = |parameters: &Parameters<'_>, sizes_rad: &[f64]| {
        let causes = precisions_of(&parameters.chosen);
        let columns = &parameters.columns;
        spectrum::transfer(columns, (&linear.residuals, &model.outliers), sizes_rad, &|size_rad| {
            spectrum::precisions(columns, geometry, &causes, model.peak.sigma_m, size_rad)
        })
    };
    let (left_by_lines, _) = transfer(&plain, &[1.0]);
    let (left, size_rad) = transfer(&spectral, &spectrum::SIZES_RAD);
    if left_by_lines < left + spectrum::LINES_LEAVE.ln() {
        return plain;
    }
    spectral.size_rad = size_rad;
    spectral
}

/// Precisions of causes that were chosen.
fn precisions_of(chosen: &[&ChosenCause]) -> Vec<f64> {
    chosen.iter().map(|c| (3.0 * c.size_ratio).powi(-2)).collect()
}

/// Precision of a model's geometry; without any its columns are held at nothing.
fn geometry_precision(fitted: &FittedModel<'_>) -> f64 {
    let ratio = fitted.model.peak.geometry_ratio;
    if ratio > 0.0 { ratio.powi(-2) } else { NOTHING }
}

/// What is fitted again on the arm as it really moves.
struct Refit<'a> {
    robot: Arc<SerialArm>,
    /// With their places in the file as minutes where they have none.
    stations: Stations,
    fitted: &'a FittedModel<'a>,
    columns: ModelColumns<'a>,
    /// Lines of spectra that have names.
    named: Vec<&'a ChosenCause>,
    /// Prior standard deviation of a spectrum's lines, radians.
    size_rad: f64,
    options: &'a DiagnosisOptions,
}

/// A model with the parameters that it was made of.
struct RefitModel {
    identified: Identified,
    /// Sizes of all columns, each over that of its prior.
    values: DVector<f64>,
    /// The payload's centre off the measured point, flange frame, metres.
    centre_m: Vector3<f64>,
}

/// The step so far after which least is left.
struct BestStep {
    left_m: f64,
    values: DVector<f64>,
    centre_m: Vector3<f64>,
    /// Standard deviations of all columns at unit noise, where they are determined.
    sigmas: Option<Vec<f64>>,
}

impl Refit<'_> {
    /// The terms of `start`, by Gauss-Newton from nothing, the causes' sizes held by their precisions `causes`.
    fn solved(&self, start: Identified, causes: &[f64]) -> Result<RefitModel, NoModel> {
        let FittedModel { linear, model, .. } = self.fitted;
        let (columns, sigma_m) = (&self.columns, model.peak.sigma_m);
        let geometry = geometry_precision(self.fitted);
        let precisions = spectrum::precisions(columns, geometry, causes, sigma_m, self.size_rad);
        let all: Vec<usize> = (0..linear.dataset.observations.len()).collect();
        let mut normal = columns.sum(&all, &linear.residuals);
        let mut solution = normal.solve(&precisions).ok_or(NoModel::NotSolved)?;
        let mut identified = start;
        let centre = PayloadCentre::new(columns);
        let mut centre_m = centre.agreed_m(&mut solution.values);
        if centre.is_product() {
            return self.solved_with_centre(identified, &precisions, &centre, (solution.values, centre_m));
        }
        for _ in 0..ROUNDS {
            identified.terms = self.terms(&solution.values, None);
            let so_far = Arc::new(identified.clone());
            let residuals = self.residuals_of(&self.stations, &so_far, centre_m)?.residuals;
            // Residual plus what the parameters already take, to first order: the prior then pulls on the whole.
            solution.values.rows_mut(0, columns.registration().end).fill(0.0);
            normal.rhs = columns.rhs(&all, &residuals) + &normal.gram * &solution.values;
            solution = normal.solve(&precisions).ok_or(NoModel::NotSolved)?;
            centre_m = centre.agreed_m(&mut solution.values);
        }
        let sigmas = self.sigmas(solution.sigmas());
        identified.terms = self.terms(&solution.values, sigmas.as_deref());
        Ok(RefitModel { identified, values: solution.values, centre_m })
    }

    /// The same where the payload's centre is a product of parameters: from `values` on, each step halved until it leaves less.
    fn solved_with_centre(
        &self,
        mut identified: Identified,
        precisions: &[f64],
        centre: &PayloadCentre,
        (mut values, mut centre_m): (DVector<f64>, Vector3<f64>),
    ) -> Result<RefitModel, NoModel> {
        let FittedModel { linear, model, .. } = self.fitted;
        let all: Vec<usize> = (0..linear.dataset.observations.len()).collect();
        let mut best: Option<BestStep> = None;
        for _ in 0..CENTRE_ROUNDS {
            values.rows_mut(0, self.columns.registration().end).fill(0.0);
            identified.terms = self.terms(&values, None);
            let so_far = Arc::new(identified.clone());
            let left = self.residuals_of(&self.stations, &so_far, centre_m).map(|left| left.residuals);
            let left = left.map(|residuals| (rms_m(&residuals, |i| !model.outliers[i]), residuals));
            let (left_m, residuals) = match (left, &best) {
                (Ok(first), None) => first,
                (Ok(less), Some(best)) if less.0 <= best.left_m => less,
                (Err(error), None) => return Err(error.into()),
                // A step too far leaves more, or an arm that cannot even be registered.
                (_, Some(best)) => {
                    values = 0.5 * (values + &best.values);
                    centre_m = 0.5 * (centre_m + best.centre_m);
                    centre.set(&mut values, &centre_m);
                    continue;
                }
            };
            let is_settled = best.as_ref().is_some_and(|best| best.left_m - left_m < SETTLED * left_m);
            let moved = centre.dataset_at(self.columns.dataset, (&values, &centre_m));
            let columns = ModelColumns {
                dataset: moved.as_ref().unwrap_or(self.columns.dataset),
                causes: self.columns.causes.clone(),
                lines: self.columns.lines.clone(),
                ..self.columns
            };
            let normal = columns.sum(&all, &residuals);
            let Some((solution, next_m)) = centre.step(&normal, precisions, (&values, &centre_m)) else {
                break;
            };
            best = Some(BestStep { left_m, values, centre_m, sigmas: solution.sigmas() });
            if is_settled {
                break;
            }
            (values, centre_m) = (solution.values, next_m);
        }
        let BestStep { values, centre_m, sigmas, .. } = best.ok_or(NoModel::NotSolved)?;
        let sigmas = self.sigmas(sigmas);
        identified.terms = self.terms(&values, sigmas.as_deref());
        Ok(RefitModel { identified, values, centre_m })
    }

    /// Standard deviations under the model's noise of what has these at unit noise.
    fn sigmas(&self, at_unit_noise: Option<Vec<f64>>) -> Option<Vec<f64>> {
        let sigma_m = self.fitted.model.peak.sigma_m;
        at_unit_noise.map(|all| all.into_iter().map(|sigma| sigma_m * sigma).collect())
    }

    fn terms(&self, values: &DVector<f64>, sigmas: Option<&[f64]>) -> Vec<Term> {
        terms(&self.columns, &self.named, &self.fitted.workspace.library.candidates, values, sigmas)
    }

    fn residuals_of(
        &self,
        stations: &Stations,
        model: &Arc<Identified>,
        centre_m: Vector3<f64>,
    ) -> Result<ModelResiduals, RegisterError> {
        residuals_of(&self.robot, stations, model, self.fitted.linear, self.options.tool_m, centre_m)
    }

    /// Takes the order of rows, which means nothing to another file, out of a model: what has stepped stays as it stood at the end, and
    /// there the model has to hold.
    fn leave_clock(&self, identified: &mut Identified, centre_m: Vector3<f64>) -> Result<(), NoModel> {
        let FittedModel { linear, model, .. } = self.fitted;
        if let Some(last_step) = without_clock(identified) {
            let observations = &linear.dataset.observations;
            let is_since = |i: &usize| !model.outliers[*i] && observations[*i].clock() >= last_step;
            let since: Vec<usize> = (0..observations.len()).filter(is_since).collect();
            // Fewer say less than base and target take.
            if since.len() >= FEWEST_SINCE {
                let kept = since.iter().map(|&i| self.stations.stations[i].clone()).collect();
                let stations = Stations { stations: kept, ..self.stations.clone() };
                let stepped = Arc::new(identified.clone());
                let left = self.residuals_of(&stations, &stepped, centre_m)?.residuals;
                let before: Vec<Twist> = since.iter().map(|&i| linear.nominal[i]).collect();
                holds(rms_m(&left, |_| true), rms_m(&before, |_| true), self.fitted, self.options.sigma_m)?;
            }
        }
        // Base and target are registered again wherever the model is used.
        identified.terms.retain(|term| !term.kind.is_of_mounting());
        Ok(())
    }
}

/// Where the payload hung that the model's sag was fitted with, flange frame, metres: whoever compares with the model again needs it,
/// whether these data told it or it was taken to hang amid the targets, as `payload_m`. `None` where nothing gives under a payload.
fn hangs_at_m(model: &Identified, dataset: &Dataset, payload_m: Vector3<f64>) -> Option<Vector3<f64>> {
    (model.needs_load() && dataset.largest_payload_kg > 0.0).then_some(payload_m)
}

/// Fewest stations behind a step by which a model is judged.
const FEWEST_SINCE: usize = 12;

/// Whether something stepped at a moment that means nothing to another file: at a row, or on a clock over several cold starts.
///
/// # Errors
/// [`NoModel::SeveralStarts`]: something drifts by the minutes since each cold start beside it.
fn steps_by_rows(
    dataset: &Dataset,
    candidates: &[Candidate],
    chosen: &[ChosenCause],
) -> Result<bool, NoModel> {
    let variants = || chosen.iter().map(|cause| &candidates[cause.candidate].variant);
    let steps = variants().filter_map(EffectVariant::t0_min).any(|t0| dataset.minute_of(t0).is_none());
    let drifts = variants().any(|one| matches!(one.growth, Growth::Law(_) | Growth::Linear { .. }));
    if steps && drifts && dataset.several_starts {
        return Err(NoModel::SeveralStarts);
    }
    Ok(steps)
}

/// The stations, their places in the file as minutes where they have none, and where something steps at `moments` of a clock over several cold
/// starts that clock: as the signatures take them.
fn by_the_clock(stations: &Stations, dataset: &Dataset, moments: bool) -> Stations {
    let mut stations = stations.clone();
    if dataset.time_min.is_none() || moments {
        for (station, observation) in stations.stations.iter_mut().zip(&dataset.observations) {
            station.t_min = Some(observation.clock());
        }
    }
    stations
}

/// Whether `chosen` has a drift of the arm by the order of rows: such a clock means nothing to another file.
pub(super) fn drifts_by_rows(dataset: &Dataset, candidates: &[Candidate], chosen: &[ChosenCause]) -> bool {
    let mut chosen = chosen.iter().map(|cause| &candidates[cause.candidate]);
    chosen.any(|candidate| candidate.effect().time() == TimeCourse::Drift && is_by_rows(dataset, candidate))
}

/// Whether `candidate` is a drift or a step of the arm with the order of rows in the place of time.
pub(super) fn is_by_rows(dataset: &Dataset, candidate: &Candidate) -> bool {
    dataset.time_min.is_none()
        && candidate.effect().time() != TimeCourse::Constant
        && !matches!(candidate.effect().motion(&candidate.variant), Some(Motion::Body(_)))
        && !matches!(candidate.variant.growth, Growth::Temperature { .. })
}

/// Leaves what has stepped at some row as it stood at the end; the last such step of the arm, if any.
fn without_clock(model: &mut Identified) -> Option<f64> {
    let mut last = None;
    for term in model.terms.iter_mut().filter(|term| !term.kind.is_of_mounting()) {
        if let Growth::Step { t0_min } = term.growth {
            last = Some(last.map_or(t0_min, |last: f64| last.max(t0_min)));
            term.growth = Growth::Always;
        }
    }
    last
}

/// Precision of what is not to be moved, over the noise's.
const NOTHING: f64 = 1e18;

/// What an exact arm under a model leaves.
struct ModelResiduals {
    /// Measured minus predicted at every station, base axes.
    residuals: Vec<Twist>,
    /// The registration that goes with them.
    registration: Registration,
}

/// Registers the exact arm under the model, and compares.
fn residuals_of(
    robot: &Arc<SerialArm>,
    stations: &Stations,
    model: &Arc<Identified>,
    linear: &Linearised,
    tool_m: Option<Vector3<f64>>,
    payload_off_m: Vector3<f64>,
) -> Result<ModelResiduals, RegisterError> {
    let payload_m = linear.registration.payload_m() + payload_off_m;
    let PredictedStations { stations: scaled, poses } =
        predicted(robot, &stations.stations, model, payload_m);
    let registration = register(&scaled, &poses, stations.targets, tool_m)?;
    let residuals =
        scaled.iter().zip(&poses).map(|(s, pose)| Twist(registration.residual(s, pose))).collect();
    Ok(ModelResiduals { residuals, registration })
}

/// Stations against which an arm under a model is held.
pub(super) struct PredictedStations {
    /// As an instrument without an error of scale would have seen them.
    pub stations: Vec<Station>,
    /// The flange's pose in the base at each, by the model.
    pub poses: Vec<Isometry3<f64>>,
}

/// The arm under `model` at every station, the payload's centre at `payload_m`, flange frame.
pub(super) fn predicted(
    robot: &Arc<SerialArm>,
    stations: &[Station],
    model: &Arc<Identified>,
    payload_m: Vector3<f64>,
) -> PredictedStations {
    let scale: f64 =
        model.terms.iter().filter(|t| t.kind == EffectKind::InstrumentScale).map(|t| t.value(0)).sum::<f64>()
            + 1.0;
    let arm = DeformedSerialArm::new(robot, model);
    // Of all this only the base's own motion moves a nest.
    let of_base = |t: &&Term| matches!(t.kind, EffectKind::BaseDrift | EffectKind::BaseStep);
    let base =
        Identified { terms: model.terms.iter().filter(of_base).cloned().collect(), ..(**model).clone() };
    let base = DeformedSerialArm::new(robot, &Arc::new(base));
    let zero = Joints::all(robot.joints.len(), 0.0);
    let flange_from_base = arm.nominal().forward(&zero).inverse();
    let poses = parallel::map(stations.len(), &|at| {
        let station = &stations[at];
        let when = ThermalState {
            t_min: station.t_min.unwrap_or(0.0),
            joint_temperature_c: station.joint_temperature_c,
        };
        if !station.reading.involves_arm() {
            return base.forward(&zero, &when, &Payload::default(), &[]) * flange_from_base;
        }
        let payload = Payload { mass_kg: station.payload_kg.unwrap_or(0.0), cog_m: payload_m.into() };
        arm.forward(&station.q_rad, &when, &payload, &station.direction.unwrap_or_default())
    });
    let scaled =
        stations.iter().map(|s| Station { reading: s.reading.scaled(1.0 / scale), ..s.clone() }).collect();
    PredictedStations { stations: scaled, poses }
}

fn measured_range(rows: usize, stations: &Stations, joints: usize) -> MeasuredRange {
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
        q_rad: all.iter().any(|s| s.reading.involves_arm()).then(|| {
            Joints::from_fn(joints, |j| {
                range(&|s| s.reading.involves_arm().then_some(s.q_rad[j])).unwrap_or_default()
            })
        }),
        t_min: range(&|s| s.t_min),
        joint_temperature_c: warm.then(|| {
            Joints::from_fn(joints, |j| range(&|s| s.joint_temperature_c.map(|t| t[j])).unwrap_or_default())
        }),
        payload_kg: range(&|s| s.payload_kg),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::evenly_spread;

    /// A link that bends under a payload whose centre no parameter tells; without a payload, or without sag, there is none to tell.
    #[test]
    fn a_model_of_sag_says_where_the_payload_hung() {
        let amid_targets = Vector3::new(0.03, -0.02, 0.1);
        let of = |kind: EffectKind| Identified {
            terms: vec![Term::plain(kind, None, Vec::new())],
            ..Identified::default()
        };
        let bare = evenly_spread(12);
        let loaded = Dataset { largest_payload_kg: 5.0, ..evenly_spread(12) };
        let bends = of(EffectKind::LinkBending);
        assert_eq!(hangs_at_m(&bends, &loaded, amid_targets), Some(amid_targets));
        assert_eq!(hangs_at_m(&bends, &bare, amid_targets), None);
        assert_eq!(hangs_at_m(&of(EffectKind::JointOffset), &loaded, amid_targets), None);
    }
}
