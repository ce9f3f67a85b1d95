//! Steps in time that may be a load which was changed and is not in the file: the arm gives by gravity's torque then, and nothing moved.

use super::judgement::Decision;
use super::structure::{causes_log_odds, over_time};
use super::wording::hidden_load_reason;
use crate::diagnose::model::FittedModel;
use crate::diagnose::outcome::Location;
use inference::cause::Cause;
use inference::dataset::{Dataset, scaled};
use inference::effects::give_per_kg;
use inference::evidence::NuisanceModel;
use inference::gp_features::compress;
use inference::missing_channel::MissingChannel;
use inference::search::{ChosenCause, NULL_PRIOR, UNEXPLAINED_PRIOR, cause_columns};
use inference::time_course::TimeCourse;
use nalgebra::DMatrix;
use robot_model::deform::EffectKind;
use statistics::log_sum;

/// Share of loads that change and are not recorded in structure of no named cause.
const WEIGHT: f64 = 0.1;
/// Share of these in which the first load is not the one that the arm was calibrated with.
const LOADED_FROM_THE_START: f64 = 0.5;
/// Of more steps than this all are replaced, or none: some of them would be 2^n - 1 choices.
const MOST_STEPS: usize = 4;
/// A load of this probability stands beside the steps.
const IN_DOUBT: f64 = 0.05;
/// Joints before the wrist, each of which gives by itself.
const ARM_JOINTS: usize = 3;

/// What a load that is not in the file, changed where the steps of a model are, has against these steps.
#[derive(Clone, Debug)]
pub(super) struct HiddenLoad {
    /// ln odds over the steps in whose place it stands.
    log_odds: f64,
    /// Places in the model of the steps that it is likeliest to stand for.
    slots: Vec<usize>,
    /// Lines of the file from which on it is another one.
    lines: Vec<u64>,
}

impl HiddenLoad {
    /// Probability beside the steps in whose place it stands.
    fn probability(&self) -> f64 {
        1.0 / (1.0 + (-self.log_odds).exp())
    }

    /// Whether neither it nor the steps can be ruled out.
    #[must_use]
    pub(super) fn is_in_doubt(&self) -> bool {
        self.probability() > IN_DOUBT
    }

    /// Takes its probability from the causes in whose place it stands.
    pub(super) fn doubt(&self, causes: &mut [Cause]) {
        for cause in causes.iter_mut().filter(|c| self.slots.iter().any(|slot| slot + 1 == c.slot)) {
            cause.posterior *= 1.0 - self.probability();
        }
    }

    /// The verdict that the load was changed, where it is likelier than the steps, and more so than structure with `structure_odds` (ln)
    /// over all causes.
    #[must_use]
    pub(super) fn outcome(&self, fitted: &FittedModel<'_>, structure_odds: f64) -> Option<Decision> {
        (self.log_odds > structure_odds.max(0.0)).then(|| {
            let location = Location { time: Some(TimeCourse::Step), ..over_time(fitted, &[]) };
            Decision::structure(hidden_load_reason(&self.lines, &fitted.linear.dataset), location)
                .without(Some(MissingChannel::Payload))
        })
    }
}

/// A load in the place of those steps of `chosen` that it is likeliest to stand for; `None` where there are none, or the payload is
/// recorded and changes.
#[must_use]
pub(super) fn in_place_of_steps(fitted: &FittedModel<'_>, chosen: &[ChosenCause]) -> Option<HiddenLoad> {
    let candidates = &fitted.workspace.library.candidates;
    let is_step = |slot: &usize| candidates[chosen[*slot].candidate].variant.t0_min().is_some();
    let steps: Vec<usize> = (0..chosen.len()).filter(is_step).collect();
    if steps.is_empty() || payload_changes(&fitted.linear.dataset) {
        return None;
    }
    let choices: Vec<Vec<usize>> = if steps.len() > MOST_STEPS {
        vec![steps]
    } else {
        let picked =
            |choice: usize| (0..steps.len()).filter(|k| choice >> k & 1 == 1).map(|k| steps[k]).collect();
        (1..1 << steps.len()).map(picked).collect()
    };
    let weighed = choices.into_iter().map(|slots| in_place_of(fitted, chosen, slots));
    weighed.reduce(|a, b| if b.log_odds > a.log_odds { b } else { a })
}

/// Whether the file says that the load was not always the same.
fn payload_changes(dataset: &Dataset) -> bool {
    let mut loads = dataset.observations.iter().filter_map(|o| o.payload_kg);
    let first = loads.next();
    loads.any(|load| Some(load) != first)
}

/// A load in the place of the steps at `slots` of `chosen`.
fn in_place_of(fitted: &FittedModel<'_>, chosen: &[ChosenCause], slots: Vec<usize>) -> HiddenLoad {
    let FittedModel { model, workspace, linear } = fitted;
    let (library, design) = (&workspace.library, &workspace.design);
    let mut moments: Vec<f64> = slots
        .iter()
        .filter_map(|&slot| library.candidates[chosen[slot].candidate].variant.t0_min())
        .collect();
    sorting::numbers(&mut moments);
    moments.dedup();
    let others: Vec<ChosenCause> =
        (0..chosen.len()).filter(|slot| !slots.contains(slot)).map(|slot| chosen[slot].clone()).collect();
    let groups = design.all_groups();
    let mut nuisance = NuisanceModel::new(design, &groups, &cause_columns(&others, None), model.noise);
    let bare = nuisance.null().log_evidence;
    let gain = |loaded_from_start: bool| {
        let sums = design.sums(&load_columns(fitted, &moments, loaded_from_start));
        nuisance.evidence(&nuisance.project(&sums)).log_evidence - bare
    };
    let shares = [(false, 1.0 - LOADED_FROM_THE_START), (true, LOADED_FROM_THE_START)];
    let gain = log_sum(shares.into_iter().map(|(loaded, share)| gain(loaded) + share.ln()));
    let gaps = library.candidates.iter().filter(|c| c.kind == EffectKind::BaseStep).count().max(1);
    let load =
        gain + (UNEXPLAINED_PRIOR * WEIGHT / NULL_PRIOR).ln() - (gaps as f64).ln() * moments.len() as f64;
    let jumps = causes_log_odds(fitted, &mut nuisance, slots.iter().map(|&slot| &chosen[slot]));
    let lines = moments.iter().filter_map(|&t0| linear.dataset.line_from(t0)).collect();
    HiddenLoad { log_odds: load - jumps, slots, lines }
}

/// The give of each joint of the arm, and of the wrist's together, under a load at the tool, from each of the `moments` on, and from the
/// start.
fn load_columns(fitted: &FittedModel<'_>, moments: &[f64], loaded_from_start: bool) -> DMatrix<f64> {
    let dataset = &fitted.linear.dataset;
    let arm = ARM_JOINTS.min(dataset.joints());
    let mut parts: Vec<std::ops::Range<usize>> = (0..arm).map(|j| j..j + 1).collect();
    parts.push(arm..dataset.joints());
    let loads = moments.len() + usize::from(loaded_from_start);
    compress(&fitted.workspace.design.stack(dataset, loads * parts.len(), |_, observation, out| {
        let later = moments.iter().map(|&t0| if observation.clock() > t0 { 1.0 } else { 0.0 });
        for on in later.chain(loaded_from_start.then_some(1.0)) {
            out.extend(parts.iter().map(|joints| scaled(give_per_kg(observation, joints.clone()), on)));
        }
    }))
}
