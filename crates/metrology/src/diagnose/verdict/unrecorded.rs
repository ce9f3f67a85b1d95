//! Which channel is missing, by what the gap follows where no cause explains it: the direction of approach where a joint stands on two
//! sides whatever its angle, the payload where the arm gives at some rows as under a load and at others not.

use super::judgement::Decision;
use super::structure::{causes_log_odds, likeliest_structure, structure_odds};
use super::two_states::{State, TwoStates, two_states};
use super::wording::two_states_reason;
use crate::diagnose::evidence::NuisanceModel;
use crate::diagnose::linear_fit::solve;
use crate::diagnose::missing_channel::MissingChannel;
use crate::diagnose::model::FittedModel;
use crate::diagnose::outcome::{Location, Verdict};
use crate::diagnose::search::{
    ALARM_NATS, ChosenCause, DROP_NATS, HypothesisRanking, NULL_PRIOR, UNEXPLAINED_PRIOR, cause_columns,
};

/// Share of two states that nothing in the file tells apart in structure of no named cause.
const WEIGHT: f64 = 0.1;
/// States beside which more than so many times the noise is left that is stated or repeated are not all that is in the file: no column is told
/// by them.
const MOST_LEFT: f64 = 1.8;

/// What is in two states, where the `verdict` is that something is not explained and they explain it better than structure does, with
/// and without the causes that are `chosen`; `rest` is ranked beside these, `scatter_nats` what plain scatter along a joint gains.
#[must_use]
pub(super) fn in_two_states(
    fitted: &FittedModel<'_>,
    chosen: &[ChosenCause],
    rest: &HypothesisRanking,
    scatter_nats: f64,
    location: &Location,
) -> Option<Decision> {
    let channels = fitted.linear.dataset.channels;
    if channels.direction && channels.payload {
        return None;
    }
    let FittedModel { model, workspace, .. } = fitted;
    let groups = workspace.design.all_groups();
    let mut bare = NuisanceModel::new(&workspace.design, &groups, &[], model.noise);
    let structure = |ranking: &HypothesisRanking| {
        likeliest_structure(workspace, ranking).map_or(0.0, |s| structure_odds(s.gain_nats).max(0.0))
    };
    let alone = structure(&workspace.library.rank_gp_alternatives(&bare));
    let causes = causes_log_odds(fitted, &mut bare, chosen);
    let explained = (causes + structure(rest)).max(alone);
    let beside: Vec<(f64, TwoStates)> = [(0.0, &[][..]), (causes, chosen)]
        .into_iter()
        .take(1 + usize::from(!chosen.is_empty()))
        .filter_map(|(odds, chosen)| states_beside(fitted, chosen).map(|states| (odds, states)))
        .filter(|(_, states)| states.gain_nats > ALARM_NATS.max(scatter_nats + DROP_NATS))
        .filter(|(_, states)| {
            model.noise.known.is_none_or(|known| states.sigma_m < MOST_LEFT * known.sigma_m)
        })
        .collect();
    let odds = |(causes, states): &(f64, TwoStates)| {
        causes + states.gain_nats + (UNEXPLAINED_PRIOR * WEIGHT / NULL_PRIOR).ln()
    };
    let best = beside.into_iter().max_by(|a, b| odds(a).total_cmp(&odds(b)))?;
    (odds(&best) > explained + DROP_NATS).then(|| {
        let (joint, missing) = match best.1.state {
            State::Side(joint) => (joint, MissingChannel::Direction),
            State::Load(joint) => (joint, MissingChannel::Payload),
        };
        Decision {
            verdict: Verdict::UnexplainedScatter,
            reason: two_states_reason(&best.1, &fitted.linear.dataset),
            location: Location { joint: Some(joint), ..location.clone() },
            missing_channel: Some(missing),
        }
    })
}

/// What is left beside `chosen`, as two states.
fn states_beside(fitted: &FittedModel<'_>, chosen: &[ChosenCause]) -> Option<TwoStates> {
    let FittedModel { model, workspace, linear } = fitted;
    let design = &workspace.design;
    let groups = design.all_groups();
    let nuisance = NuisanceModel::new(design, &groups, &cause_columns(chosen, None), model.noise);
    let ratio = nuisance.null().geometry_ratio;
    let fit = solve(design, &groups, chosen, Some(ratio)).without_slow(design);
    // Orientation has rows of its own; half of the parameters are then the points'.
    let share = 3.0 / linear.dataset.rows_per_observation as f64;
    two_states(fitted, &design.residuals(&fit.coefficients), share * nuisance.parameters(ratio))
}
