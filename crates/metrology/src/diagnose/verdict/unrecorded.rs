//! Which channel is missing, by what the gap follows where no cause explains it: the direction of approach where a joint stands on two
//! sides whatever its angle, the payload where the arm or the base gives at some rows as under a load and at others not. Where a body stands
//! in two places, whatever the pose, no column of such files tells it.

use super::judgement::Decision;
use super::noise::points_share;
use super::structure::{causes_log_odds, likeliest_structure, structure_odds};
use super::two_states::{State, TwoStates, two_states};
use super::wording::two_states_reason;
use crate::diagnose::model::FittedModel;
use crate::diagnose::outcome::{Location, Verdict};
use inference::evidence::NuisanceModel;
use inference::linear_fit::solve;
use inference::missing_channel::MissingChannel;
use inference::search::{
    ChosenCause, DROP_NATS, HypothesisRanking, NULL_PRIOR, UNEXPLAINED_PRIOR, cause_columns,
};
use statistics::ALARM_NATS;

/// Two states of what was taken for noise gain so much, nats: rows of slow noise lie on either side of its middle, too.
const HIDDEN_NATS: f64 = 20.0;
/// Share of two states that nothing in the file tells apart in structure of no named cause.
const WEIGHT: f64 = 0.1;
/// States beside which more than so many times the noise is left that is stated or repeated are not all that is in the file: no column is told
/// by them.
const MOST_LEFT: f64 = 1.8;

/// What is in two states, where the `verdict` is that something is not explained, or that nothing is left but noise, and they explain it better
/// than structure does, with and without the causes that are `chosen`; `rest` is ranked beside these, `scatter_nats` is what plain scatter along
/// a joint gains. In what was taken for noise nothing slow may be: that comes and goes too.
#[must_use]
pub(super) fn in_two_states(
    fitted: &FittedModel<'_>,
    chosen: &[ChosenCause],
    rest: &HypothesisRanking,
    (scatter_nats, verdict): (f64, Verdict),
    location: &Location,
) -> Option<Decision> {
    let is_hidden = matches!(verdict, Verdict::NothingAboveNoise | Verdict::Geometry);
    if is_hidden && fitted.model.slow.is_some() {
        return None;
    }
    let least_nats = if is_hidden { HIDDEN_NATS } else { ALARM_NATS };
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
        .filter(|(_, states)| {
            let rival = scatter_nats.max(states.scattered_nats);
            states.gain_nats > least_nats.max(rival + DROP_NATS)
        })
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
            State::Side(joint) => (Some(joint), Some(MissingChannel::Direction)),
            State::Load(joint) => (Some(joint), Some(MissingChannel::Payload)),
            State::LoadOnBase => (None, Some(MissingChannel::Payload)),
            State::Place(..) => (None, None),
        };
        Decision {
            verdict: Verdict::UnexplainedScatter,
            reason: two_states_reason(&best.1, &fitted.linear.dataset),
            location: Location { joint, ..location.clone() },
            missing_channel: missing,
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
    let used = points_share(&linear.dataset) * nuisance.parameters(ratio);
    two_states(fitted, &design.residuals(&fit.coefficients), used)
}
