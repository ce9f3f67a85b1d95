//! The verdict on the best model: from its evidence, its scatter, and structure that no effect takes.

use super::cause_group::scan;
use super::judgement::Judgement;
use super::listing::{at_most_one, never_rising};
use super::noise::{ReducedChiSquare, Scatter, joint_scatter, reduced_chi_square};
use super::structure::add_gp_alternatives;
use super::unrecorded::in_two_states;
use super::with_causes::with_causes;
use super::without_cause::without_cause;
use crate::diagnose::model::FittedModel;
use crate::diagnose::outcome::Verdict;
use inference::time_course::TimeCourse;
use statistics::ALARM_NATS;

/// Judges the best model of the data.
#[must_use]
pub(crate) fn judge(fitted: &mut FittedModel<'_>) -> Judgement {
    let chosen = fitted.model.chosen.clone();
    fitted.workspace.library.forget_columns();
    add_gp_alternatives(fitted);
    let rest = scan(fitted, &chosen, None);
    let chi = reduced_chi_square(fitted, &chosen);
    let along = joint_scatter(fitted).filter(|j| j.gain_nats > ALARM_NATS);
    let scatter = Scatter { chi: chi.filter(ReducedChiSquare::is_exceeded).map(|chi| chi.value), along };
    let mut judgement = if chosen.is_empty() {
        without_cause(fitted, &rest, scatter)
    } else {
        with_causes(fitted, &chosen, &rest.ranking, scatter)
    };
    if is_open(&judgement)
        && let Some(told) = in_two_states(
            fitted,
            &chosen,
            &rest.ranking,
            (along.map_or(0.0, |along| along.gain_nats), judgement.verdict),
            &judgement.location,
        )
    {
        judgement.overrule(told);
    }
    judgement.reduced_chi_square = chi;
    at_most_one(&mut judgement.causes);
    // Behind it: what it takes from one slot, a cause of another may have.
    never_rising(&mut judgement.causes);
    if matches!(judgement.verdict, Verdict::UnexplainedStructure | Verdict::UnexplainedScatter) {
        judgement.are_candidates();
    }
    judgement
}

/// Whether something is not explained that does not follow time, or may be hidden in what is taken for noise.
fn is_open(judgement: &Judgement) -> bool {
    match judgement.verdict {
        Verdict::UnexplainedScatter | Verdict::NothingAboveNoise | Verdict::Geometry => true,
        Verdict::UnexplainedStructure => {
            !matches!(judgement.location.time, Some(TimeCourse::Drift | TimeCourse::Step))
        }
        _ => false,
    }
}
