//! The model that is made of what was found: what of it cannot be in one, and why there is none.

use super::effects::Candidate;
use super::gear_lines::{AliasedLine, aliased_line, is_of_gear};
use super::identify::{drifts_by_rows, identify, is_by_rows};
use super::iterated_search::{SearchProblem, best_model};
use super::linearise::rms_m;
use super::measured_robot::MeasuredRobot;
use super::model::FittedModel;
use super::no_model::{NoModel, holds};
use super::options::DiagnosisOptions;
use super::outcome::{Verdict, Warning};
use super::spectrum;
use super::verdict::Judgement;
use robot_model::deform::identified::Identified;

/// Why a drift over rows is in no model.
const UNTIMED: &str = "what drifts from row to row cannot be carried to another file without times (t_min)";

/// Code of a term that the model is made without because of its size.
const BEYOND_USUAL: &str = "diagnose::beyond-usual";
/// Terms that a model is made without for that, at most.
const MOST_BEYOND: usize = 2;

/// What became of the model that was wanted.
pub(super) struct Identification {
    /// The model, or why there is none.
    pub found: Result<Identified, NoModel>,
    /// What was found and is not in it.
    left_out: Vec<LeftOut>,
}

/// What a model is made without, although it was found.
#[derive(Clone)]
struct LeftOut {
    code: &'static str,
    /// Why it cannot be in a model.
    why: String,
    /// What the model has nothing of.
    what: String,
}

impl Identification {
    /// The model of `fitted`; of a search without them, where something drifts by the order of rows or a gear line is one of several
    /// that the angles measured do not tell apart (but in a spectrum). Of such a line alone no model is made.
    #[must_use]
    pub(super) fn of(
        measured: MeasuredRobot<'_>,
        options: &DiagnosisOptions,
        problem: &SearchProblem<'_>,
        fitted: &FittedModel<'_>,
        judgement: &Judgement,
    ) -> Self {
        let linear = problem.linear;
        let mut left_out = Vec::new();
        let mut candidates = problem.candidates.to_vec();
        let spectra = spectrum::spectra(problem.candidates, &fitted.model.chosen);
        // In a spectrum all lines of the gear stand side by side, of one size: what is the same at the angles measured is shared out.
        let aliased = aliased_line(&linear.dataset, &judgement.causes)
            .filter(|line| !spectra.iter().any(|of| of.joint == line.joint));
        if let Some(AliasedLine { joint, periods, slot }) = aliased {
            let periods = periods.iter().map(u32::to_string).collect::<Vec<String>>().join(" and ");
            let why = NoModel::Aliases { joint, periods };
            if judgement.causes.iter().all(|cause| cause.slot == slot) {
                return Self::none(why);
            }
            let what = format!("the gear of joint {joint}");
            left_out.push(LeftOut { code: "diagnose::aliased-line", why: why.to_string(), what });
            // Of all others nothing new is looked for: something else would be found in the place of that gear.
            let others = fitted.model.chosen.iter().map(|c| &problem.candidates[c.candidate]);
            candidates = others
                .filter(|other| !(is_of_gear(other.kind) && other.variant.joint == Some(joint)))
                .cloned()
                .collect();
        }
        if drifts_by_rows(&linear.dataset, problem.candidates, &fitted.model.chosen) {
            left_out.push(LeftOut {
                code: "diagnose::untimed",
                why: UNTIMED.to_owned(),
                what: "it".to_owned(),
            });
            // Nor steps: together they would climb as the drift does.
            candidates.retain(|candidate| !is_by_rows(&linear.dataset, candidate));
        }
        if left_out.is_empty() {
            return Self::of_usual(measured, options, problem, fitted, judgement, left_out);
        }
        let problem = SearchProblem { candidates: &candidates, ..*problem };
        Self::of_usual(measured, options, &problem, &best_model(&problem), judgement, left_out)
    }

    /// The model of `fitted`. Where a term of it that is none of the causes named came out at a size that cannot be, that of a search without
    /// the term, if it is one.
    fn of_usual(
        measured: MeasuredRobot<'_>,
        options: &DiagnosisOptions,
        problem: &SearchProblem<'_>,
        fitted: &FittedModel<'_>,
        judgement: &Judgement,
        left_out: Vec<LeftOut>,
    ) -> Self {
        let found = identify(measured, fitted, options);
        let Err(NoModel::Beyond { cause, n, term, times }) = &found else { return Self { found, left_out } };
        let Judgement { verdict, causes, .. } = judgement;
        let is_named = causes.iter().any(|named| (named.key(), named.n) == (*cause, *n));
        // What takes a structure of no cause once takes it again, under another name.
        let is_explained = !matches!(verdict, Verdict::UnexplainedStructure | Verdict::UnexplainedScatter);
        let beyond = left_out.iter().filter(|left_out| left_out.code == BEYOND_USUAL).count();
        if is_named || !is_explained || beyond == MOST_BEYOND {
            return Self { found, left_out };
        }
        let others = problem.candidates.iter().filter(|c| (c.cause_key(), c.variant.n) != (*cause, *n));
        let candidates: Vec<Candidate> = others.cloned().collect();
        let why = format!("{term} came out at {times:.0} times its usual size");
        let beyond = LeftOut { code: BEYOND_USUAL, why, what: "it".to_owned() };
        let more = left_out.iter().cloned().chain([beyond]).collect();
        let problem = SearchProblem { candidates: &candidates, ..*problem };
        let without = Self::of_usual(measured, options, &problem, &best_model(&problem), judgement, more);
        if without.found.is_ok() { without } else { Self { found, left_out } }
    }

    /// That there is no model, and why.
    #[must_use]
    pub(super) fn none(why: NoModel) -> Self {
        Self { found: Err(why), left_out: Vec::new() }
    }

    /// Why there is none, for people.
    #[must_use]
    pub(super) fn no_model(&self) -> Option<String> {
        let why = self.found.as_ref().err()?;
        let left_out = self.left_out.iter().map(|left_out| format!("; {}", left_out.why));
        Some(std::iter::once(why.to_string()).chain(left_out).collect())
    }

    /// What the model is made without.
    pub(super) fn warnings(&self) -> impl Iterator<Item = Warning> {
        let left_out = self.left_out.iter().filter(|_| self.found.is_ok());
        left_out.map(|LeftOut { code, why, what }| Warning {
            code,
            message: format!("{why}: the model is fitted without {what}"),
        })
    }
}

/// That a model would leave more of its own rows than the noise that is stated, as far as that shows before one is made.
#[must_use]
pub(super) fn misses_stated(fitted: &FittedModel<'_>, options: &DiagnosisOptions) -> Option<NoModel> {
    let FittedModel { linear, model, .. } = fitted;
    let stated_m = options.sigma_m?;
    let kept = |i: usize| !model.outliers[i];
    holds(rms_m(&model.residuals, kept), rms_m(&linear.nominal, kept), fitted, Some(stated_m)).err()
}
