//! What to measure next: poses, payloads and directions that tell the causes of the least certain slot apart, how many rows it
//! takes and what they would decide; and, where later poses cannot tell, what can.

mod advice;
mod pool;
mod question;
mod rival_model;
mod separation;
mod wording;

use super::model::FittedModel;
use super::options::DiagnosisOptions;
use super::outcome::{NextMeasurement, NextStep, Verdict};
use super::verdict::{Judgement, OpenSlot, describe_candidate};
use inference::dataset::Dataset;
use inference::effects::Candidate;
use inference::gear_lines::are_aliases;
use pool::{Setup, When, pool};
use question::{DECIDES, HOPELESS, MOST_ALTERNATIVES, Planned, Question};
use robot_model::robot::{Axis, SerialArm};

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
    let mut slots: Vec<&OpenSlot> =
        judgement.open.iter().filter(|slot| !slot.alternatives.is_empty()).collect();
    sorting::by(&mut slots, |a, b| b.uncertainty().total_cmp(&a.uncertainty()));
    let open = slots.iter().filter(|slot| ambiguous && slot.uncertainty() > OPEN_NATS).count();
    if let Some(slot) = slots.iter().find(|slot| ambiguous && open == 0 && slot.or_balancing) {
        return NextMeasurements { measurements: Vec::new(), step: look_at_balancing(fitted, slot) };
    }
    slots.truncate(open.max(1));
    if slots.is_empty() {
        // Where no effect leaves a signal there is none to measure for.
        return NextMeasurements::default();
    }
    let Some(planned) = plan(robot, fitted, &slots, ambiguous, options) else {
        return NextMeasurements::default();
    };
    let asked = Asked::new(fitted, &slots, &planned);
    let step = NextStep {
        slot: slots[asked.slots[0]].slot.map(|i| i + 1),
        rows: planned.poses.len() * (1 + planned.nests()),
        readings_per_pose: 1,
        base_nests: planned.nests(),
        from_cold: planned.setup.when == When::FromCold,
        log_odds_gained: 0.5 * asked.slots.iter().map(|&s| planned.lambda[s]).fold(f64::INFINITY, f64::min),
        decides: asked.undecided.is_none(),
        other_means: asked.other_means(),
        reason: wording::reason(
            judgement.verdict,
            &asked.slots.iter().map(|&s| asked.names(s)).collect::<Vec<_>>(),
        ),
    };
    if !asked.tells && ambiguous && step.other_means.is_some() {
        let step = NextStep { rows: 0, readings_per_pose: 0, base_nests: 0, from_cold: false, ..step };
        return NextMeasurements { measurements: Vec::new(), step };
    }
    NextMeasurements { measurements: planned.poses, step }
}

/// What tells a cause of `slot` from the balancing of joint 2, where all else is decided: no poses do.
fn look_at_balancing(fitted: &FittedModel<'_>, slot: &OpenSlot) -> NextStep {
    let FittedModel { linear, workspace, .. } = fitted;
    let likeliest = slot.alternatives.first().map(|one| &workspace.library.candidates[one.candidate]);
    let names = likeliest.map(|candidate| describe_candidate(candidate, &linear.dataset)).into_iter();
    NextStep {
        slot: slot.slot.map(|i| i + 1),
        other_means: Some(advice::BALANCING.to_owned()),
        reason: wording::question(
            &names.chain(["a balancing spring or cylinder".to_owned()]).collect::<Vec<_>>(),
        ),
        ..NextStep::default()
    }
}

/// The slots that planned poses are for, by their place among the open ones.
struct Asked<'a> {
    fitted: &'a FittedModel<'a>,
    open: &'a [&'a OpenSlot],
    /// Those that the poses tell something of; the least certain one where they tell nothing.
    slots: Vec<usize>,
    /// Whether the poses tell something of any.
    tells: bool,
    /// The least certain of those that the poses do not decide.
    undecided: Option<usize>,
    with_nests: bool,
}

impl<'a> Asked<'a> {
    fn new(fitted: &'a FittedModel<'a>, open: &'a [&'a OpenSlot], planned: &Planned) -> Self {
        let told: Vec<usize> = (0..open.len()).filter(|&s| planned.lambda[s] >= HOPELESS).collect();
        let undecided = (0..open.len()).find(|&s| planned.lambda[s] < DECIDES || planned.rests_on_shape[s]);
        let tells = !told.is_empty();
        let slots = if tells { told } else { vec![0] };
        Self { fitted, open, slots, tells, undecided, with_nests: planned.setup.with_nests }
    }

    /// The candidates of an open slot, the likeliest first.
    fn candidates(&self, slot: usize) -> impl Iterator<Item = &'a Candidate> {
        let candidates = &self.fitted.workspace.library.candidates;
        let rivals = self.open[slot].alternatives.iter().take(MOST_ALTERNATIVES);
        rivals.map(move |rival| &candidates[rival.candidate])
    }

    /// The same in words; of lines that are the same numbers at the angles measured, with where they are not.
    fn names(&self, slot: usize) -> Vec<String> {
        let dataset = &self.fitted.linear.dataset;
        let rivals: Vec<&Candidate> = self.candidates(slot).collect();
        let mut names: Vec<String> =
            rivals.iter().map(|candidate| describe_candidate(candidate, dataset)).collect();
        if let (Some(joint), Some(name)) = (aliased_joint(dataset, &rivals), names.last_mut()) {
            *name += &format!(", at angles of joint {joint} between those measured");
        }
        names
    }

    /// What tells that the poses cannot; nests, where the poses have them, are themselves the other means.
    fn other_means(&self) -> Option<String> {
        let is_asked = |slot: &usize| self.slots.contains(slot);
        let slot = self.undecided.filter(|slot| !(self.with_nests && is_asked(slot)))?;
        let kinds: Vec<_> = self.candidates(slot).map(|candidate| candidate.kind).collect();
        let means = advice::other_means(&kinds, &self.fitted.linear.dataset.channels)?;
        Some(match is_asked(&slot) {
            true => means.to_owned(),
            false => format!("{}: {means}", wording::question(&self.names(slot))),
        })
    }
}

/// The joint whose gear the likeliest of the `rivals` is a line of, where another is the same at the angles measured.
fn aliased_joint(dataset: &Dataset, rivals: &[&Candidate]) -> Option<Axis> {
    let line = |c: &Candidate| c.variant.joint.zip(c.variant.n);
    let (joint, n) = line(rivals.first()?)?;
    let mut others = rivals.iter().filter_map(|c| line(c)).filter(|(of, _)| *of == joint);
    others.any(|(_, m)| are_aliases(dataset, joint, n, m)).then_some(joint)
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
