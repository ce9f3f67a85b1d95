//! The model that is made of what was found: what of it cannot be in one, and why there is none.

use super::cause::Cause;
use super::gear_lines::{AliasedLine, aliased_line, is_of_gear};
use super::identify::{drifts_by_rows, identify, is_by_rows};
use super::iterated_search::{SearchProblem, best_model};
use super::linearise::rms_m;
use super::measured_robot::MeasuredRobot;
use super::model::FittedModel;
use super::no_model::{NoModel, holds};
use super::options::DiagnosisOptions;
use super::outcome::Warning;
use super::spectrum;
use robot_model::deform::identified::Identified;

/// Why a drift over rows is in no model.
const UNTIMED: &str = "what drifts from row to row cannot be carried to another file without times (t_min)";

/// What became of the model that was wanted.
pub(super) struct Identification {
    /// The model, or why there is none.
    pub found: Result<Identified, NoModel>,
    /// What was found and is not in it.
    left_out: Vec<LeftOut>,
}

/// What a model is made without, although it was found.
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
        causes: &[Cause],
    ) -> Self {
        let linear = problem.linear;
        let mut left_out = Vec::new();
        let mut candidates = problem.candidates.to_vec();
        let spectra = spectrum::spectra(problem.candidates, &fitted.model.chosen);
        // In a spectrum all lines of the gear stand side by side, of one size: what is the same at the angles measured is shared out.
        let aliased = aliased_line(&linear.dataset, causes)
            .filter(|line| !spectra.iter().any(|of| of.joint == line.joint));
        if let Some(AliasedLine { joint, periods, slot }) = aliased {
            let periods = periods.iter().map(u32::to_string).collect::<Vec<String>>().join(" and ");
            let why = NoModel::Aliases { joint, periods };
            if causes.iter().all(|cause| cause.slot == slot) {
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
            return Self { found: identify(measured, fitted, options), left_out };
        }
        let fitted = best_model(&SearchProblem { candidates: &candidates, ..*problem });
        Self { found: identify(measured, &fitted, options), left_out }
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
