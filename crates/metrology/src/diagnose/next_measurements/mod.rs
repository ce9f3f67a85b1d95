//! What to measure next: poses, payloads and directions that tell the causes of the least certain slot apart, how many rows it
//! takes and what they would decide; and, where later poses cannot tell, what can.

mod advice;
mod pool;
mod separation;

use super::dataset::{Observation, Twist, scaled};
use super::design::{Design, registration};
use super::effects;
use super::model::{FittedModel, Model, Workspace};
use super::options::DiagnosisOptions;
use super::outcome::{NextMeasurement, NextStep, Verdict};
use super::time_course::TimeCourse;
use super::verdict::{Judgement, OpenSlot, SHAPE_KNOWN_TO, describe_candidate, shapes_in_doubt};
use pool::{PoolPose, When, pool};
use robot_model::robot::SerialArm;
use separation::{Coefficient, FittedColumn, Pair, RivalModel, Separation, ShapeDoubt};

/// Different poses at least and at most.
const FEWEST: usize = 12;
const MOST: usize = 30;
/// Readings of each pose at most.
const MOST_TIMES: usize = 2;
/// L at which nine of ten times the odds come out at more than 30 to 1: L / 2 - 1.3 sqrt L = ln 30.
const DECIDES: f64 = 21.0;
/// Less than this at the most rows: later poses cannot tell.
const HOPELESS: f64 = 4.0;
/// From this probability on that none of the slot's causes is there, it is an alternative.
const SOMETHING_ELSE: f64 = 0.02;
/// Rivals of a slot that are looked at.
const MOST_ALTERNATIVES: usize = 4;
/// Slots beside the least certain one that the poses are for as well, and how uncertain they are, nats.
const MORE_SLOTS: usize = 2;
const OPEN_NATS: f64 = 0.1;

/// Measurements worth taking, and what they are good for.
#[derive(Clone, Debug, Default)]
pub(super) struct NextMeasurements {
    /// The poses, with payload and direction.
    pub measurements: Vec<NextMeasurement>,
    /// What they decide, and how many rows it takes.
    pub step: NextStep,
}

/// The poses that part the causes of the open slots, the least certain first, and what they are good for.
#[must_use]
pub(super) fn next_measurements(
    robot: &SerialArm,
    fitted: &mut FittedModel<'_>,
    judgement: &Judgement,
    options: &DiagnosisOptions,
) -> NextMeasurements {
    let Judgement { open, verdict, .. } = judgement;
    let verdict = *verdict;
    let mut slots: Vec<&OpenSlot> = open.iter().collect();
    slots.sort_by(|a, b| b.uncertainty().total_cmp(&a.uncertainty()));
    let Some(&slot) = slots.first() else { return NextMeasurements::default() };
    let also = slots[1..].iter().filter(|p| p.uncertainty() > OPEN_NATS).take(MORE_SLOTS);
    let asked: Vec<&OpenSlot> = std::iter::once(slot).chain(also.copied()).collect();
    let Some(question) = Question::new(fitted, &asked) else {
        return NextMeasurements::default();
    };
    let mut best: Option<Planned> = None;
    for when in question.times() {
        let pool = pool(robot, fitted.linear, options, when, MOST);
        // What is decided is only made surer.
        let most = if verdict == Verdict::Ambiguous { [MOST, MOST_TIMES] } else { [FEWEST, 1] };
        let Some(planned) = question.plan(fitted, pool, when, most) else { continue };
        // A second warm-up has to be worth the night.
        let worth = |p: &Planned| if p.when == When::FromCold { 2.0 * p.confusion } else { p.confusion };
        if best.as_ref().is_none_or(|b| worth(&planned) < worth(b)) {
            best = Some(planned);
        }
    }
    let Some(planned) = best else { return NextMeasurements::default() };
    let FittedModel { linear, workspace, .. } = fitted;
    let names: Vec<String> = slot
        .alternatives
        .iter()
        .take(MOST_ALTERNATIVES)
        .map(|r| describe_candidate(&workspace.library.candidates[r.candidate], &linear.dataset))
        .collect();
    let kinds: Vec<_> = slot
        .alternatives
        .iter()
        .take(MOST_ALTERNATIVES)
        .map(|r| workspace.library.candidates[r.candidate].kind)
        .collect();
    let other = advice::other_means(&kinds, &linear.dataset.channels);
    let reason = match (verdict, names.as_slice()) {
        (Verdict::Ambiguous, [one, alternatives @ ..]) if !alternatives.is_empty() => {
            format!("to tell {one} from {}", alternatives.join(" and from "))
        }
        (Verdict::Explained | Verdict::Several, [one, alternative, ..]) => {
            format!("to confirm {one} against its nearest rival, {alternative}")
        }
        (Verdict::UnexplainedStructure | Verdict::UnexplainedScatter, [one, ..]) => {
            format!("to test the nearest candidate, {one}")
        }
        (_, [one, ..]) => format!("to see effects as small as the noise; most of all {one}"),
        _ => String::new(),
    };
    let step = NextStep {
        slot: slot.slot.map(|i| i + 1),
        rows: planned.poses.len() * planned.times,
        readings_per_pose: planned.times,
        from_cold: planned.when == When::FromCold,
        log_odds_gained: 0.5 * planned.lambda,
        decides: planned.lambda >= DECIDES,
        other_means: other.filter(|_| planned.lambda < DECIDES).map(str::to_owned),
        reason,
    };
    if planned.lambda < HOPELESS && verdict == Verdict::Ambiguous && step.other_means.is_some() {
        let step = NextStep { rows: 0, readings_per_pose: 0, from_cold: false, ..step };
        return NextMeasurements { measurements: Vec::new(), step };
    }
    NextMeasurements { measurements: planned.poses, step }
}

/// Poses with what they reach.
struct Planned {
    poses: Vec<NextMeasurement>,
    times: usize,
    when: When,
    lambda: f64,
    confusion: f64,
}

/// The explanations of one slot, in columns: those of the design first, in its order.
struct Question {
    /// Candidates whose columns are needed, with where they begin.
    candidates: Vec<(usize, Vec<usize>)>,
    models: Vec<RivalModel>,
    pairs: Vec<Pair>,
    gram: nalgebra::DMatrix<f64>,
    sigma_m: f64,
    /// Weight of a visit with one target.
    visit_weight: f64,
    grows: bool,
    targets: usize,
}

impl Question {
    fn new(fitted: &mut FittedModel<'_>, slots: &[&OpenSlot]) -> Option<Self> {
        let FittedModel { linear, model, workspace } = fitted;
        let mut columns: Vec<Vec<Vec<usize>>> = Vec::new();
        for slot in slots {
            let Workspace { design, library, column_index } = &mut *workspace;
            let alternatives: Vec<usize> = slot
                .alternatives
                .iter()
                .take(MOST_ALTERNATIVES)
                .map(|alternative| alternative.candidate)
                .collect();
            columns.push(library.columns_in_design(design, column_index, &alternatives));
        }
        let design = &workspace.design;
        let groups: Vec<usize> = (0..design.groups()).collect();
        let mut question = Self {
            candidates: model.chosen.iter().map(|c| (c.candidate, c.columns.clone())).collect(),
            models: Vec::new(),
            pairs: Vec::new(),
            gram: design.gram(&groups),
            sigma_m: model.peak.sigma_m,
            visit_weight: 1.0 / (1.0 + model.shared_ratio),
            grows: false,
            targets: linear.registration.tools_m.len().max(1),
        };
        for (slot, columns) in slots.iter().zip(&columns) {
            question.add(model, design, workspace.library.candidates, slot, columns)?;
        }
        let drifts = |c: usize| workspace.library.candidates[c].effect().time() == TimeCourse::Drift;
        question.grows = linear.dataset.time_min.is_some()
            && slots[0].alternatives.iter().take(MOST_ALTERNATIVES).any(|r| drifts(r.candidate));
        Some(question)
    }

    /// The pairs of one slot: its likeliest cause against each of the others.
    fn add(
        &mut self,
        model: &Model,
        design: &Design,
        candidates: &[effects::Candidate],
        slot: &OpenSlot,
        columns: &[Vec<usize>],
    ) -> Option<()> {
        let ratio = model.peak.geometry_ratio;
        let fitted_with = |precision: f64| move |column| FittedColumn { column, precision };
        let mut common: Vec<FittedColumn> = design.registration.clone().map(fitted_with(0.0)).collect();
        if ratio > 0.0 {
            common.extend(design.geometry.clone().map(fitted_with(ratio.powi(-2))));
        }
        let precision = |size_ratio: f64| (3.0 * size_ratio.max(1e-9)).powi(-2);
        for (_, other) in model.chosen.iter().enumerate().filter(|(i, _)| Some(*i) != slot.slot) {
            common.extend(other.columns.iter().copied().map(fitted_with(precision(other.size_ratio))));
        }
        let from = self.models.len();
        self.models.push(RivalModel { columns: common.clone() });
        let mut signals: Vec<Vec<Coefficient>> = Vec::new();
        for (alternative, columns) in slot.alternatives.iter().zip(columns) {
            if columns.iter().any(|c| common.iter().any(|taken| taken.column == *c)) {
                return None;
            }
            self.candidates.push((alternative.candidate, columns.clone()));
            let own = columns.iter().copied().map(fitted_with(precision(alternative.size_ratio)));
            let own = RivalModel { columns: common.iter().copied().chain(own).collect() };
            let fitted = own.fitted(&self.gram)?;
            let sizes = fitted.into_iter().skip(common.len());
            let of_column = |(&column, size)| Coefficient { column, size };
            signals.push(columns.iter().zip(sizes).map(of_column).collect());
            self.models.push(own);
        }
        let both = self.next_both();
        let Some(first) = slot.alternatives.first() else { return Some(()) };
        let rest = 1.0 - slot.alternatives.iter().map(|r| r.probability).sum::<f64>();
        if signals.len() == 1 || rest > SOMETHING_ELSE {
            // What is not in the library is no better known than nothing.
            let weight = (first.probability * rest.max(SOMETHING_ELSE)).sqrt();
            let signal = signals[0].clone();
            self.pairs.push(Pair { weight, signal, fitted: from, truth: 1.0, both: Some(both), shape: None });
        }
        let both = self.next_both();
        for (b, other) in slot.alternatives.iter().enumerate().take(columns.len()).skip(1) {
            let weight = (first.probability * other.probability).sqrt();
            let both = Some(both + b - 1);
            let truth = first.probability / (first.probability + other.probability);
            let kinds = [first.candidate, other.candidate].map(|c| candidates[c].kind);
            for (truth, of, fitted) in [(truth, 0, from + 1 + b), (1.0 - truth, b, from + 1)] {
                let signal = &signals[of];
                let shape = match shapes_in_doubt(kinds[0], kinds[1]) {
                    true => Some(self.doubt(signal, from)?),
                    false => None,
                };
                self.pairs.push(Pair { weight, signal: signal.clone(), fitted, truth, both, shape });
            }
        }
        Some(())
    }

    fn next_both(&self) -> usize {
        self.pairs.iter().filter_map(|pair| pair.both).max().map_or(0, |last| last + 1)
    }

    /// What the shape of `signal` leaves open; adds the pair of the signal and of nothing, which parts no causes.
    fn doubt(&mut self, signal: &[Coefficient], nothing: usize) -> Option<ShapeDoubt> {
        let square_m2 = self.models[nothing].square_left(&self.gram, signal)?;
        let over_nothing = self.pairs.len();
        self.pairs.push(Pair {
            weight: 0.0,
            signal: signal.to_vec(),
            fitted: nothing,
            truth: 1.0,
            both: None,
            shape: None,
        });
        let lambda = square_m2 / (self.sigma_m * self.sigma_m);
        Some(ShapeDoubt { share: SHAPE_KNOWN_TO * SHAPE_KNOWN_TO, lambda, over_nothing })
    }

    /// When it is worth measuring.
    fn times(&self) -> Vec<When> {
        if self.grows { vec![When::After, When::FromCold] } else { vec![When::After] }
    }

    /// All columns at `observation`, whitened: one row for each coordinate.
    fn rows(&self, fitted: &FittedModel<'_>, observation: &Observation) -> Vec<Vec<f64>> {
        let FittedModel { linear, workspace, .. } = fitted;
        let design = &workspace.design;
        let mut all: Vec<(usize, Twist)> = Vec::new();
        let mut twists = Vec::new();
        registration::twists(linear.dataset.at(observation), self.targets, &mut twists);
        all.extend(design.registration.clone().zip(twists.drain(..)));
        for (column, k) in design.geometry.clone().zip(0..) {
            let offset = observation.frame_offset(1 + k / 6, k % 6);
            all.push((column, scaled(offset, Design::tolerance(k % 6))));
        }
        for (candidate, columns) in &self.candidates {
            let candidate = &workspace.library.candidates[*candidate];
            candidate.scaled_signature(linear.dataset.at(observation), &mut twists);
            all.extend(columns.iter().copied().zip(twists.drain(..)));
        }
        let (characteristic_length_m, root) =
            (design.whitening().characteristic_length_m, self.visit_weight.sqrt());
        (0..linear.dataset.rows_per_observation)
            .map(|r| {
                let mut row = vec![0.0; self.gram.ncols()];
                for (column, twist) in &all {
                    row[*column] = twist[r] * root * if r < 3 { 1.0 } else { characteristic_length_m };
                }
                row
            })
            .collect()
    }

    /// The poses of `pool` that part the pairs most, taken one by one until every pair is told apart.
    fn plan(
        &self,
        fitted: &FittedModel<'_>,
        pool: Vec<PoolPose>,
        when: When,
        [most, most_times]: [usize; 2],
    ) -> Option<Planned> {
        let rows: Vec<Vec<Vec<f64>>> = pool.iter().map(|pose| self.rows(fitted, &pose.observation)).collect();
        let mut separation =
            Separation::new(&self.gram, &self.models, self.pairs.clone(), &rows, self.sigma_m)?;
        let mut taken: Vec<usize> = Vec::new();
        while taken.len() < most && (taken.len() < FEWEST || separation.least() < DECIDES) {
            let Some(i) = separation.best(|i| !taken.contains(&i)) else { break };
            separation.add_pose(i);
            taken.push(i);
        }
        let mut times = 1;
        while times < most_times && taken.len() == most && separation.least() < DECIDES {
            taken.iter().for_each(|&i| separation.add_pose(i));
            times += 1;
        }
        let mut order = taken;
        // On a new warm-up the minutes count.
        order.sort_by(|a, b| pool[*a].observation.clock().total_cmp(&pool[*b].observation.clock()));
        Some(Planned {
            poses: order.into_iter().map(|i| pool[i].next.clone()).collect(),
            times,
            when,
            lambda: separation.least(),
            confusion: separation.confusion(),
        })
    }
}
