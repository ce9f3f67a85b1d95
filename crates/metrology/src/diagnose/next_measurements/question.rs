//! The explanations of the open slots as columns, and the poses that part them; knows nothing of words.

use super::pool::{NESTS, PoolPose, Setup, When};
use super::rival_model::{Coefficient, FittedColumn, RivalModel};
use super::separation::{Pair, Separation, ShapeDoubt};
use crate::diagnose::model::{FittedModel, Model, Workspace};
use crate::diagnose::outcome::NextMeasurement;
use crate::diagnose::verdict::{OpenSlot, SHAPE_KNOWN_TO, shapes_in_doubt};
use inference::dataset::{Observation, Twist, scaled};
use inference::design::{Design, registration};
use inference::effects::Candidate;
use inference::time_course::TimeCourse;
use robot_model::deform::EffectKind;

/// L that is asked for: nine of ten times the odds come out at more than 30 to 1 from L / 2 - 1.3 sqrt L = ln 30 on, L = 21; half as
/// much again for what no pair of causes shows: sizes are estimates, and other rivals come up.
pub(super) const DECIDES: f64 = 30.0;
/// Less than this at the most rows: later poses cannot tell.
pub(super) const HOPELESS: f64 = 4.0;
/// From this probability on that none of the slot's causes is there, it is a rival.
const SOMETHING_ELSE: f64 = 0.02;
/// Rivals of a slot that are looked at.
pub(super) const MOST_ALTERNATIVES: usize = 4;
/// Precision of where a new nest stands, noise variance over the prior's: it is not known.
const NEST_PRECISION: f64 = 1e-8;

/// Poses with what they reach.
pub(super) struct Planned {
    /// In the order in which they are measured.
    pub poses: Vec<NextMeasurement>,
    /// What is measured at each, and when.
    pub setup: Setup,
    /// L of the two causes of each slot that are parted least.
    pub lambda: Vec<f64>,
    /// Of each slot, whether its causes are parted by a shape that is in doubt, which no nests bear out.
    pub rests_on_shape: Vec<bool>,
    confusion: f64,
}

impl Planned {
    /// Nests that are read at each pose.
    #[must_use]
    pub(super) fn nests(&self) -> usize {
        if self.setup.with_nests { NESTS } else { 0 }
    }

    /// What stays open; a second warm-up has to be worth the night.
    #[must_use]
    pub(super) fn price(&self) -> f64 {
        if self.setup.when == When::FromCold { 2.0 * self.confusion } else { self.confusion }
    }
}

/// The explanations of the slots, in columns: those of the design first, in its order.
pub(super) struct Question {
    /// Candidates whose columns are needed, with where they begin.
    candidates: Vec<(usize, Vec<usize>)>,
    models: Vec<RivalModel>,
    pairs: Vec<Pair>,
    /// For each two that are to be parted, the slot that they stand in.
    slot_of: Vec<usize>,
    gram: nalgebra::DMatrix<f64>,
    sigma_m: f64,
    /// Weight of a visit with one target.
    visit_weight: f64,
    grows: bool,
    /// Whether a rival tilts the base under the arm, which nests on it show.
    pub tilts: bool,
    targets: usize,
}

/// Whether a tilt of the base stands against what has the same shape, as far as shapes are known.
fn tilts(slot: &OpenSlot, candidates: &[Candidate]) -> bool {
    let kinds: Vec<EffectKind> = slot
        .alternatives
        .iter()
        .take(MOST_ALTERNATIVES)
        .map(|rival| candidates[rival.candidate].kind)
        .collect();
    let Some((&first, others)) = kinds.split_first() else { return false };
    others.iter().any(|&other| {
        (first == EffectKind::BaseTilt || other == EffectKind::BaseTilt) && shapes_in_doubt(first, other)
    })
}

impl Question {
    /// `None` where two causes of one slot cannot stand beside each other in the normal matrix.
    pub(super) fn new(fitted: &mut FittedModel<'_>, slots: &[&OpenSlot]) -> Option<Self> {
        let FittedModel { linear, model, workspace } = fitted;
        let mut columns: Vec<Vec<Vec<usize>>> = Vec::new();
        for slot in slots {
            let Workspace { design, library, column_index } = &mut *workspace;
            let rivals: Vec<usize> =
                slot.alternatives.iter().take(MOST_ALTERNATIVES).map(|rival| rival.candidate).collect();
            columns.push(library.columns_in_design(design, column_index, &rivals));
        }
        let design = &workspace.design;
        let groups: Vec<usize> = (0..design.groups()).collect();
        let mut question = Self {
            candidates: model.chosen.iter().map(|c| (c.candidate, c.columns.clone())).collect(),
            models: Vec::new(),
            pairs: Vec::new(),
            slot_of: Vec::new(),
            gram: design.gram(&groups),
            sigma_m: model.peak.sigma_m,
            visit_weight: 1.0 / (1.0 + model.shared_ratio),
            grows: false,
            tilts: slots.iter().any(|slot| tilts(slot, &workspace.library.candidates)),
            targets: linear.registration.tools_m.len().max(1),
        };
        for (number, (slot, columns)) in slots.iter().zip(&columns).enumerate() {
            question.add(model, design, &workspace.library.candidates, slot, columns)?;
            question.slot_of.resize(question.next_both(), number);
        }
        question.add_nests();
        let drifts = |c: usize| workspace.library.candidates[c].effect().time() == TimeCourse::Drift;
        question.grows = linear.dataset.time_min.is_some()
            && slots
                .iter()
                .any(|slot| slot.alternatives.iter().take(MOST_ALTERNATIVES).any(|r| drifts(r.candidate)));
        Some(question)
    }

    /// The pairs of one slot: its likeliest cause against each of the others.
    fn add(
        &mut self,
        model: &Model,
        design: &Design,
        candidates: &[Candidate],
        slot: &OpenSlot,
        columns: &[Vec<usize>],
    ) -> Option<()> {
        let common = columns_beside(model, design, slot);
        let from = self.models.len();
        self.models.push(RivalModel { columns: common.clone() });
        let mut signals: Vec<Vec<Coefficient>> = Vec::new();
        for (rival, columns) in slot.alternatives.iter().zip(columns) {
            if columns.iter().any(|c| common.iter().any(|taken| taken.column == *c)) {
                return None;
            }
            self.candidates.push((rival.candidate, columns.clone()));
            let own = columns.iter().copied().map(with_precision(size_precision(rival.size_ratio)));
            let own = RivalModel { columns: common.iter().copied().chain(own).collect() };
            let fitted = own.fitted(&self.gram)?;
            let sizes = fitted.into_iter().skip(common.len());
            let of_column = |(&column, size)| Coefficient { column, size };
            signals.push(columns.iter().zip(sizes).map(of_column).collect());
            self.models.push(own);
        }
        let Some(first) = slot.alternatives.first() else { return Some(()) };
        let rest = 1.0 - slot.alternatives.iter().map(|r| r.probability).sum::<f64>();
        if signals.len() == 1 || rest > SOMETHING_ELSE {
            // What is not in the library is no better known than nothing.
            let weight = (first.probability * rest.max(SOMETHING_ELSE)).sqrt();
            let both = Some(self.next_both());
            let signal = signals[0].clone();
            let (model, fitted) = (from + 1, from);
            self.pairs.push(Pair { weight, signal, model, fitted, truth: 1.0, both, shape: None });
        }
        let both = self.next_both();
        for (b, other) in slot.alternatives.iter().enumerate().take(columns.len()).skip(1) {
            let weight = (first.probability * other.probability).sqrt();
            let both = Some(both + b - 1);
            let truth = first.probability / (first.probability + other.probability);
            let kinds = [first.candidate, other.candidate].map(|c| candidates[c].kind);
            for (truth, of, fitted) in [(truth, 0, from + 1 + b), (1.0 - truth, b, from + 1)] {
                let (signal, model) = (signals[of].clone(), from + 1 + of);
                let shape = match shapes_in_doubt(kinds[0], kinds[1]) {
                    true => Some(self.doubt(&signal, model, from)?),
                    false => None,
                };
                self.pairs.push(Pair { weight, signal, model, fitted, truth, both, shape });
            }
        }
        Some(())
    }

    fn next_both(&self) -> usize {
        self.pairs.iter().filter_map(|pair| pair.both).max().map_or(0, |last| last + 1)
    }

    /// What the shape of `signal` leaves open; adds the pair of the signal and of nothing, which parts no causes.
    fn doubt(&mut self, signal: &[Coefficient], model: usize, nothing: usize) -> Option<ShapeDoubt> {
        let square_m2 = self.models[nothing].square_left(&self.gram, signal)?;
        let over_nothing = self.pairs.len();
        self.pairs.push(Pair {
            weight: 0.0,
            signal: signal.to_vec(),
            model,
            fitted: nothing,
            truth: 1.0,
            both: None,
            shape: None,
        });
        let lambda = square_m2 / (self.sigma_m * self.sigma_m);
        Some(ShapeDoubt { share: SHAPE_KNOWN_TO * SHAPE_KNOWN_TO, lambda, over_nothing })
    }

    /// How high new nests stand is fitted by every model; nothing is known of it yet. A base that tilts lifts and sinks them.
    fn add_nests(&mut self) {
        if !self.tilts {
            return;
        }
        let first = self.gram.ncols();
        self.gram = self.gram.clone().resize(first + NESTS, first + NESTS, 0.0);
        let columns = first..self.gram.ncols();
        for model in &mut self.models {
            let nest = |column| FittedColumn { column, precision: NEST_PRECISION };
            model.columns.extend(columns.clone().map(nest));
        }
    }

    /// When it is worth measuring.
    #[must_use]
    pub(super) fn times(&self) -> Vec<When> {
        if self.grows { vec![When::After, When::FromCold] } else { vec![When::After] }
    }

    /// All columns at `observation`, whitened: one row for each coordinate; of a new nest its height alone.
    fn rows(&self, fitted: &FittedModel<'_>, observation: &Observation) -> Vec<Vec<f64>> {
        let FittedModel { linear, workspace, .. } = fitted;
        let new_nest = |place: usize| place.checked_sub(linear.dataset.fixed_points);
        let nest = observation.fixed_point.and_then(new_nest);
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
        let coordinates = match nest {
            Some(_) => 2..3,
            None => 0..linear.dataset.rows_per_observation,
        };
        coordinates
            .map(|r| {
                let mut row = vec![0.0; self.gram.ncols()];
                for (column, twist) in &all {
                    row[*column] = twist[r] * root * if r < 3 { 1.0 } else { characteristic_length_m };
                }
                if let Some(nest) = nest {
                    row[self.gram.ncols() - NESTS + nest] = root;
                }
                row
            })
            .collect()
    }

    /// L of the two causes of each slot that are parted least.
    fn of_slots(&self, parted: &[f64]) -> Vec<f64> {
        let slots = self.slot_of.last().map_or(0, |last| last + 1);
        let mut least = vec![f64::INFINITY; slots];
        for (&slot, &lambda) in self.slot_of.iter().zip(parted) {
            least[slot] = f64::min(least[slot], lambda);
        }
        least
    }

    /// Of each slot, whether its causes are parted by a shape in doubt alone.
    fn rests_on_shape(&self, setup: Setup) -> Vec<bool> {
        let slots = self.slot_of.last().map_or(0, |last| last + 1);
        let mut rests = vec![false; slots];
        for pair in self.pairs.iter().filter(|pair| pair.shape.is_some() && !setup.with_nests) {
            if let Some(both) = pair.both {
                rests[self.slot_of[both]] = true;
            }
        }
        rests
    }

    /// The poses of `pool` that part the pairs most, taken one by one until all are told apart that can be.
    pub(super) fn plan(
        &self,
        fitted: &FittedModel<'_>,
        pool: Vec<PoolPose>,
        setup: Setup,
        [fewest, most]: [usize; 2],
    ) -> Option<Planned> {
        let of_pose = |pose: &PoolPose| pose.observations.iter().flat_map(|o| self.rows(fitted, o)).collect();
        let rows: Vec<Vec<Vec<f64>>> = pool.iter().map(of_pose).collect();
        let mut separation =
            Separation::new(&self.gram, &self.models, self.pairs.clone(), &rows, self.sigma_m)?;
        let mut taken: Vec<usize> = Vec::new();
        // L grows no faster than the poses do: what is far off at the fewest is so at the most.
        let open = |separation: &Separation, taken: usize| {
            let reaches = |lambda: f64| lambda * most as f64 / taken.max(1) as f64 >= HOPELESS;
            separation.parted().into_iter().any(|lambda| lambda < DECIDES && reaches(lambda))
        };
        while taken.len() < most && (taken.len() < fewest || open(&separation, taken.len())) {
            let Some(i) = separation.best(|i| !taken.contains(&i)) else { break };
            separation.add_pose(i);
            taken.push(i);
        }
        // On a new warm-up the minutes count.
        let clock = |i: &usize| pool[*i].observations[0].clock();
        sorting::by(&mut taken, |a, b| clock(a).total_cmp(&clock(b)));
        Some(Planned {
            poses: taken.into_iter().map(|i| pool[i].next.clone()).collect(),
            setup,
            lambda: self.of_slots(&separation.parted()),
            rests_on_shape: self.rests_on_shape(setup),
            confusion: separation.confusion(),
        })
    }
}

fn with_precision(precision: f64) -> impl Fn(usize) -> FittedColumn {
    move |column| FittedColumn { column, precision }
}

/// Of a size that may be three times the one that is known.
fn size_precision(size_ratio: f64) -> f64 {
    (3.0 * size_ratio.max(1e-9)).powi(-2)
}

/// What is fitted beside the causes of a slot: registration, geometry, and what is in the model but in this slot.
fn columns_beside(model: &Model, design: &Design, slot: &OpenSlot) -> Vec<FittedColumn> {
    let ratio = model.peak.geometry_ratio;
    let mut beside: Vec<FittedColumn> = design.registration.clone().map(with_precision(0.0)).collect();
    if ratio > 0.0 {
        beside.extend(design.geometry.clone().map(with_precision(ratio.powi(-2))));
    }
    for (_, other) in model.chosen.iter().enumerate().filter(|(i, _)| Some(*i) != slot.slot) {
        beside.extend(other.columns.iter().copied().map(with_precision(size_precision(other.size_ratio))));
    }
    beside
}
