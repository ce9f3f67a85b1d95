//! What to measure next: poses, payloads and directions that tell the causes of the least certain slot apart, how many rows it
//! takes and what they would decide; and, where later poses cannot tell, what can.

mod advice;
mod pool;
mod question;
mod separation;
mod wording;

use super::model::FittedModel;
use super::options::DiagnosisOptions;
use super::outcome::{NextMeasurement, NextStep, Verdict};
use super::verdict::{Judgement, OpenSlot, describe_candidate};
use pool::{Setup, When, pool};
use question::{DECIDES, HOPELESS, MOST_ALTERNATIVES, Planned, Question};
use robot_model::robot::SerialArm;

/// Poses at least and at most where something is open.
const FEWEST: usize = 24;
const MOST: usize = 60;
/// Poses at each of which nests are read as well, at least and at most.
const WITH_NESTS: [usize; 2] = [12, 30];
/// Poses where what is decided is only made surer.
const CONFIRMING: usize = 12;
/// How uncertain a slot is that poses are for, nats.
const OPEN_NATS: f64 = 0.1;

/// Measurements worth taking, and what they are good for.
#[derive(Clone, Debug, Default)]
pub(super) struct NextMeasurements {
    /// The poses, with payload and direction.
    pub measurements: Vec<NextMeasurement>,
    /// What they decide, and how many rows it takes.
    pub step: NextStep,
}

/// The poses that part the causes of all open slots, and what they are good for.
#[must_use]
pub(super) fn next_measurements(
    robot: &SerialArm,
    fitted: &mut FittedModel<'_>,
    judgement: &Judgement,
    options: &DiagnosisOptions,
) -> NextMeasurements {
    let ambiguous = judgement.verdict == Verdict::Ambiguous;
    let mut slots: Vec<&OpenSlot> = judgement.open.iter().collect();
    slots.sort_by(|a, b| b.uncertainty().total_cmp(&a.uncertainty()));
    let open = slots.iter().filter(|slot| ambiguous && slot.uncertainty() > OPEN_NATS).count();
    slots.truncate(open.max(1));
    let Some(planned) = plan(robot, fitted, &slots, ambiguous, options) else {
        return NextMeasurements::default();
    };
    let FittedModel { linear, workspace, .. } = fitted;
    let names = |slot: &OpenSlot| -> Vec<String> {
        let rivals = slot.alternatives.iter().take(MOST_ALTERNATIVES);
        rivals
            .map(|r| describe_candidate(&workspace.library.candidates[r.candidate], &linear.dataset))
            .collect()
    };
    let told: Vec<usize> = (0..slots.len()).filter(|&s| planned.lambda[s] >= HOPELESS).collect();
    // What the poses are for: where they tell something, or else the least certain slot.
    let asked = if told.is_empty() { &[0][..] } else { &told };
    let lambda = asked.iter().map(|&s| planned.lambda[s]).fold(f64::INFINITY, f64::min);
    // The least certain of those that the poses do not decide.
    let undecided = (0..slots.len()).find(|&s| planned.lambda[s] < DECIDES || planned.rests_on_shape[s]);
    // Nests are themselves the other means.
    let still_asked = undecided.filter(|s| !(planned.setup.with_nests && asked.contains(s)));
    let other_means = still_asked.and_then(|s| {
        let candidates = slots[s].alternatives.iter().take(MOST_ALTERNATIVES).map(|r| r.candidate);
        let kinds: Vec<_> = candidates.map(|c| workspace.library.candidates[c].kind).collect();
        let means = advice::other_means(&kinds, &linear.dataset.channels)?;
        Some(match asked.contains(&s) {
            true => means.to_owned(),
            false => format!("{}: {means}", wording::question(&names(slots[s]))),
        })
    });
    let step = NextStep {
        slot: slots[asked[0]].slot.map(|i| i + 1),
        rows: planned.poses.len() * (1 + planned.nests()),
        readings_per_pose: 1,
        base_nests: planned.nests(),
        from_cold: planned.setup.when == When::FromCold,
        log_odds_gained: 0.5 * lambda,
        decides: undecided.is_none(),
        other_means,
        reason: wording::reason(
            judgement.verdict,
            &asked.iter().map(|&s| names(slots[s])).collect::<Vec<_>>(),
        ),
    };
    if told.is_empty() && ambiguous && step.other_means.is_some() {
        let step = NextStep { rows: 0, readings_per_pose: 0, base_nests: 0, from_cold: false, ..step };
        return NextMeasurements { measurements: Vec::new(), step };
    }
    NextMeasurements { measurements: planned.poses, step }
}

/// The best poses, after the last row or on a new warm-up.
fn plan(
    robot: &SerialArm,
    fitted: &mut FittedModel<'_>,
    slots: &[&OpenSlot],
    ambiguous: bool,
    options: &DiagnosisOptions,
) -> Option<Planned> {
    let question = Question::new(fitted, slots)?;
    let numbers = if ambiguous { [FEWEST, MOST] } else { [CONFIRMING, CONFIRMING] };
    let mut best: Option<Planned> = None;
    for when in question.times() {
        let setup = Setup { when, with_nests: false };
        let pool = pool(robot, fitted.linear, options, setup, MOST);
        let Some(planned) = question.plan(fitted, pool, setup, numbers) else { continue };
        if best.as_ref().is_none_or(|b| planned.price() < b.price()) {
            best = Some(planned);
        }
    }
    if ambiguous && question.tilts {
        // Whatever poses seem to tell of a tilt rests on a shape that is not known: nests see it.
        let setup = Setup { when: When::After, with_nests: true };
        let pool = pool(robot, fitted.linear, options, setup, MOST);
        best = question.plan(fitted, pool, setup, WITH_NESTS).or(best);
    }
    best
}
