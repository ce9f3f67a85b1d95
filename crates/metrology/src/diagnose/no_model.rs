//! What is no model: terms of sizes that cannot be, and an arm that does not stand where it was measured.

use super::heldout::{floor_m, independent_floor_m};
use super::model::FittedModel;
use super::verdict::{describe_candidate, reported};
use inference::dataset::{Dataset, Twist, scaled};
use inference::effects::{Candidate, CauseKey};
use inference::linearise::shift_m;
use inference::normal_equations::ModelColumns;
use inference::search::ChosenCause;
use measurements::RegisterError;
use nalgebra::DVector;
use robot_model::deform::identified::{Estimate, Identified, Term};
use robot_model::robot::Axis;
use robot_model::units::mm_from_m;

/// Why no model is made of what was found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(super) enum NoModel {
    /// The normal equations have no solution.
    #[error("its parameters cannot be solved for")]
    NotSolved,
    /// The exact arm under the model does not stand where it was measured.
    #[error(
        "it leaves {left_mm:.3} mm of its own rows, rms, where noise{as_stated} leaves {floor_mm:.3} mm and base and tool alone {before_mm:.3} mm"
    )]
    Misses {
        /// What the exact arm under the model leaves, 3-D rms.
        left_mm: f64,
        /// What the noise alone would leave, 3-D rms.
        floor_mm: f64,
        /// What registration alone leaves.
        before_mm: f64,
        /// That the noise is as it was stated, in words; else it is the model's own.
        as_stated: &'static str,
    },
    /// A term far beyond its usual size.
    #[error(
        "{term} came out at {times:.0} times its usual size: it takes what is something else, or these poses do not tell it"
    )]
    Beyond {
        /// Whose term it is.
        cause: CauseKey,
        /// Periods per turn of a gear line.
        n: Option<u32>,
        /// The term in words.
        term: String,
        /// How many times its usual size it came out at.
        times: f64,
    },
    /// What takes the gap at the poses measured leaves it at others.
    #[error(
        "at poses held out it leaves {after_mm:.3} mm of {before_mm:.3} mm: it follows the poses measured, not the arm"
    )]
    NotCarried {
        /// 3-D rms there without the model, mm.
        before_mm: f64,
        /// 3-D rms there with the model, mm.
        after_mm: f64,
    },
    /// What has stepped and what drifts are on clocks of their own, and a model has one.
    #[error(
        "the file has several cold starts, between which something stepped, and something drifts since each: a model has one clock; diagnose each \
         session by itself"
    )]
    SeveralStarts,
    /// A term whose size is known without any doubt, as only that of one of two equal columns is.
    #[error("{term}: its size is known to the last digit, which no measurement does")]
    NoSigma {
        /// The term in words.
        term: String,
    },
    /// A gear line of which nobody can say which it is: those that it may be are the same at the angles measured alone.
    #[error(
        "lines of {periods} periods per turn of joint {joint} are the same numbers at the angles measured and differ between them: measure \
         joint {joint} at angles in between"
    )]
    Aliases {
        /// The joint whose gear it is.
        joint: Axis,
        /// Periods per turn of the lines, in words.
        periods: String,
    },
    /// The arm under the model cannot be registered.
    #[error(transparent)]
    Register(#[from] RegisterError),
    /// The file would not be read back.
    #[error("it cannot be written: {problem}")]
    Unwritable {
        /// What reading it back says.
        problem: String,
    },
}

/// What a model may leave of its own rows, over what noise leaves.
const OWN_ROWS: f64 = 1.5;
/// Squares of an effect that moves nothing, square metres.
const NO_MOTION_M2: f64 = 1e-16;

/// Whether the terms of a model are of sizes that can be, each known as well as a measurement can tell.
///
/// # Errors
/// The first that is not.
pub(super) fn is_usual(
    columns: &ModelColumns<'_>,
    values: &DVector<f64>,
    named: &[&ChosenCause],
    candidates: &[Candidate],
    identified: &Identified,
) -> Result<(), NoModel> {
    let in_model = columns.causes.iter().zip(columns.of_causes()).map(|(candidate, range)| {
        let values = values.rows(range.start, range.len());
        (*candidate, times_usual(columns.dataset, candidate, values.as_slice()))
    });
    let lines = named.iter().map(|c| &candidates[c.candidate]).map(|candidate| {
        let variant = &candidate.variant;
        let is_this = |term: &&Term| term.cause && term.joint == variant.joint && term.n == variant.n;
        let size = identified.terms.iter().find(is_this).map_or(0.0, Term::size);
        (candidate, size / candidate.prior_sigma[0])
    });
    for (candidate, times) in in_model.chain(lines) {
        if times > candidate.effect().furthest_sigmas() {
            let term = describe_candidate(candidate, columns.dataset);
            return Err(NoModel::Beyond {
                cause: candidate.cause_key(),
                n: candidate.variant.n,
                term,
                times,
            });
        }
    }
    for term in identified.terms.iter().filter(|term| term.cause) {
        let known = |value: &Estimate| value.value != 0.0 && value.sigma == Some(0.0);
        if term.values.iter().any(known) {
            let joint = term.joint.map_or_else(String::new, |joint| format!(" of joint {joint}"));
            return Err(NoModel::NoSigma { term: format!("{}{joint}", term.kind) });
        }
    }
    Ok(())
}

/// Why the only cause of a fit makes no model, as far as that shows before one is made: it is far beyond its usual size.
#[must_use]
pub(super) fn only_cause_beyond(fitted: &FittedModel<'_>) -> Option<NoModel> {
    let FittedModel { linear, model, workspace } = fitted;
    let [cause] = model.chosen.as_slice() else { return None };
    let candidate = workspace.library.candidates.get(cause.candidate)?;
    let fit = fitted.fit(&model.chosen);
    // The data's column has no coefficient.
    let values: Option<Vec<f64>> =
        cause.columns.iter().map(|&column| fit.coefficients.get(column - 1).copied()).collect();
    let times = times_usual(&linear.dataset, candidate, &values?);
    let is_beyond = times > candidate.effect().furthest_sigmas();
    is_beyond.then(|| NoModel::Beyond {
        cause: candidate.cause_key(),
        n: candidate.variant.n,
        term: describe_candidate(candidate, &linear.dataset),
        times,
    })
}

/// What a candidate whose parameters are `values`, in prior sigmas, does to the points, over what its prior leads one to expect: of a base that tilts
/// under masses that are not as guessed the whole tilt counts, not a part of it that another takes back.
fn times_usual(dataset: &Dataset, candidate: &Candidate, values: &[f64]) -> f64 {
    let counted = reported(candidate, values.len());
    let (mut moved, mut usual) = (0.0, 0.0);
    let mut signature = Vec::new();
    for observation in &dataset.observations {
        signature.clear();
        candidate.effect().signature(&candidate.variant, dataset.at(observation), &mut signature);
        let mut sum = Twist::default();
        let all = signature.iter().zip(values).zip(&candidate.prior_sigma).take(counted);
        for (k, ((twist, value), prior_sigma)) in all.enumerate() {
            let one = scaled(*twist, *prior_sigma);
            sum.iter_mut().zip(one.iter()).for_each(|(to, from)| *to += value * from);
            usual += if k < candidate.n_reported { shift_m(&one).powi(2) } else { 0.0 };
        }
        moved += shift_m(&sum).powi(2);
    }
    // What turns a target without moving it is told by its parameters.
    let largest =
        values.iter().take(candidate.n_reported).fold(0.0, |most: f64, value| most.max(value.abs()));
    if usual > NO_MOTION_M2 { (moved / usual).sqrt() } else { largest }
}

/// Whether what a model leaves of its own rows is no more than noise, as stated or, where nobody stated any, as large as the model's own, and
/// less than was there before: 3-D rms, metres.
///
/// # Errors
/// [`NoModel::Misses`], where it leaves more.
pub(super) fn holds(
    left_m: f64,
    before_m: f64,
    fitted: &FittedModel<'_>,
    stated_m: Option<f64>,
) -> Result<(), NoModel> {
    // Where repeats scatter by more than is stated they are believed.
    let repeated_m = fitted.model.given.known.map_or(0.0, |known| known.sigma_m);
    let stated_m = stated_m.map(|stated_m| independent_floor_m(fitted, stated_m.max(repeated_m)));
    let floor_m = stated_m.unwrap_or_else(|| floor_m(fitted));
    if left_m > OWN_ROWS * floor_m || left_m > before_m {
        let [left_mm, floor_mm, before_mm] = [left_m, floor_m, before_m].map(mm_from_m);
        let as_stated = if stated_m.is_some() { " as stated" } else { "" };
        return Err(NoModel::Misses { left_mm, floor_mm, before_mm, as_stated });
    }
    Ok(())
}
