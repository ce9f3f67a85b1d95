//! The model that is made of what was found: what of it cannot be in one, what stands there then, and why there is none.

use super::heldout::{self, Folds};
use super::identify::{drifts_by_rows, identify, is_by_rows};
use super::iterated_search::{SearchProblem, best_model};
use super::measured_robot::MeasuredRobot;
use super::model::FittedModel;
use super::no_model::{NoModel, holds};
use super::options::DiagnosisOptions;
use super::outcome::{HeldOutBlock, Verdict, Warning};
use super::verdict::{Judgement, describe_candidate};
use inference::effects::Candidate;
use inference::gear_lines::{AliasedLine, aliased_line, is_of_gear};
use inference::linearise::rms_m;
use inference::spectrum;
use robot_model::deform::identified::Identified;
use robot_model::units::m_from_mm;

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
    /// What it has and was not found beside all others, of a search after the first: without what is left out something else may take its
    /// place.
    in_place: Option<Vec<String>>,
}

/// A fit of which a model may be made.
struct Fit<'f, 'a> {
    fitted: &'f FittedModel<'a>,
    /// What it leaves of a region held out, without and with it.
    region: Option<HeldOutBlock>,
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
        (judgement, folds, region): (&Judgement, &Folds, Option<HeldOutBlock>),
    ) -> Self {
        let linear = problem.linear;
        let found = &fitted.workspace.library.candidates;
        let mut left_out = Vec::new();
        let mut candidates = problem.candidates.to_vec();
        let spectra = spectrum::spectra(found, &fitted.model.chosen);
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
            let others = fitted.model.chosen.iter().map(|c| &found[c.candidate]);
            candidates = others
                .filter(|other| !(is_of_gear(other.kind) && other.variant.joint == Some(joint)))
                .cloned()
                .collect();
        }
        if drifts_by_rows(&linear.dataset, found, &fitted.model.chosen) {
            left_out.push(LeftOut {
                code: "diagnose::untimed",
                why: UNTIMED.to_owned(),
                what: "it".to_owned(),
            });
            // Nor steps: together they would climb as the drift does.
            candidates.retain(|candidate| !is_by_rows(&linear.dataset, candidate));
        }
        let maker = ModelMaker { measured, options, judgement, folds, first: fitted };
        let mut made = match left_out.is_empty() {
            true => maker.of_usual(problem, &Fit { fitted, region }, left_out),
            false => maker.without(&SearchProblem { candidates: &candidates, ..*problem }, left_out),
        };
        made.left_out.splice(0..0, untimed_mounting(fitted));
        made
    }

    /// That there is no model, and why.
    #[must_use]
    pub(super) fn none(why: NoModel) -> Self {
        Self { found: Err(why), left_out: Vec::new(), in_place: None }
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
        let in_place = match self.in_place.as_deref() {
            None | Some([]) => String::new(),
            Some(others) => format!("; in its place stands {}", others.join(" and ")),
        };
        // What was left out last is what the last search was without.
        let last = self.left_out.len().saturating_sub(1);
        left_out.enumerate().map(move |(at, LeftOut { code, why, what })| {
            let in_place = if at == last { in_place.as_str() } else { "" };
            Warning { code, message: format!("{why}: the model is fitted without {what}{in_place}") }
        })
    }
}

/// Makes models of one diagnosis, each of a search of its own.
struct ModelMaker<'m, 'a> {
    measured: MeasuredRobot<'m>,
    options: &'m DiagnosisOptions,
    judgement: &'m Judgement,
    folds: &'m Folds,
    /// What was found at first, with all candidates.
    first: &'m FittedModel<'a>,
}

impl ModelMaker<'_, '_> {
    /// The model of a search among the candidates of `problem`, which lack what is left out.
    fn without(&self, problem: &SearchProblem<'_>, left_out: Vec<LeftOut>) -> Identification {
        let mut fitted = best_model(problem).over_groups(&self.folds.group_of);
        let region = heldout::region_block(&mut fitted, self.folds);
        let in_place = self.not_found_before(&fitted);
        let made = self.of_usual(problem, &Fit { fitted: &fitted, region }, left_out);
        // Of a search after this one, without still more, that one says it.
        Identification { in_place: made.in_place.or(Some(in_place)), ..made }
    }

    /// The model of a fit. Where a term of it that is none of the causes named came out at a size that cannot be, that of a search without
    /// the term, if it is one.
    fn of_usual(
        &self,
        problem: &SearchProblem<'_>,
        fit: &Fit<'_, '_>,
        left_out: Vec<LeftOut>,
    ) -> Identification {
        let found = identify(self.measured, fit.fitted, self.options);
        let Err(NoModel::Beyond { cause, n, term, times }) = &found else {
            let region = fit.region.as_ref();
            let region_held_out_m = region.map(|r| [r.before_rms_mm, r.after_rms_mm].map(m_from_mm));
            let found = found.map(|model| Identified { region_held_out_m, ..model });
            return Identification { found, left_out, in_place: None };
        };
        let Judgement { verdict, causes, .. } = self.judgement;
        let is_named = causes.iter().any(|named| (named.key(), named.n) == (*cause, *n));
        // What takes a structure of no cause once takes it again, under another name.
        let is_explained = !matches!(verdict, Verdict::UnexplainedStructure | Verdict::UnexplainedScatter);
        let beyond = left_out.iter().filter(|left_out| left_out.code == BEYOND_USUAL).count();
        if is_named || !is_explained || beyond == MOST_BEYOND {
            return Identification { found, left_out, in_place: None };
        }
        let others = problem.candidates.iter().filter(|c| (c.cause_key(), c.variant.n) != (*cause, *n));
        let candidates: Vec<Candidate> = others.cloned().collect();
        let why = format!("{term} came out at {times:.0} times its usual size");
        let beyond = LeftOut { code: BEYOND_USUAL, why, what: "it".to_owned() };
        let more = left_out.iter().cloned().chain([beyond]).collect();
        let without = self.without(&SearchProblem { candidates: &candidates, ..*problem }, more);
        match without.found.is_ok() {
            true => without,
            false => Identification { found, left_out, in_place: None },
        }
    }

    /// The causes of a later fit that the first one has not, in words.
    fn not_found_before(&self, later: &FittedModel<'_>) -> Vec<String> {
        let of = |fitted: &FittedModel<'_>| -> Vec<Candidate> {
            let chosen = fitted.model.chosen.iter();
            chosen.map(|cause| fitted.workspace.library.candidates[cause.candidate].clone()).collect()
        };
        let before = of(self.first);
        let is_new = |cause: &&Candidate| {
            !before.iter().any(|b| (b.cause_key(), b.variant.n) == (cause.cause_key(), cause.variant.n))
        };
        let later_causes = of(later);
        let new = later_causes.iter().filter(is_new);
        new.map(|candidate| describe_candidate(candidate, &later.linear.dataset)).collect()
    }
}

/// A base or target that moved at some row of a file without times, or over several cold starts: it is registered again wherever a model is used.
fn untimed_mounting(fitted: &FittedModel<'_>) -> Option<LeftOut> {
    let dataset = &fitted.linear.dataset;
    let candidates = &fitted.workspace.library.candidates;
    let mut chosen = fitted.model.chosen.iter().map(|cause| &candidates[cause.candidate]);
    let untimed = |c: &&Candidate| {
        let is_moment = c.variant.t0_min().is_some();
        dataset.time_min.is_none() || is_moment && dataset.several_starts
    };
    let moved = chosen.find(|c| c.kind.is_of_mounting() && untimed(c))?;
    Some(LeftOut {
        code: "diagnose::untimed",
        why: format!(
            "{} has no time, and base and target are registered again wherever a model is used",
            describe_candidate(moved, dataset)
        ),
        what: "it".to_owned(),
    })
}

/// That a model would leave more of its own rows than the noise that is stated, as far as that shows before one is made.
#[must_use]
pub(super) fn misses_stated(fitted: &FittedModel<'_>, options: &DiagnosisOptions) -> Option<NoModel> {
    let FittedModel { linear, model, .. } = fitted;
    let stated_m = options.sigma_m?;
    let kept = |i: usize| !model.outliers[i];
    holds(rms_m(&model.residuals, kept), rms_m(&linear.nominal, kept), fitted, Some(stated_m)).err()
}
