//! What is in force where: the values of the data that are tracked, ConfL and ConfJ, displacements,
//! carried through every routine in the order of its statements and into the routines it calls.
//!
//! A routine is walked once for each state it is called with; a routine called with many is from then
//! on walked with what they have in common. What a motion sees is what all its visits have in common.
//!
//! An error leaves a routine with the state at the statement that fails; where a handler of a caller goes
//! on with TRYNEXT or RETRY, it goes on with that.

mod earlier_rounds;
mod entry;
mod held_parts;
mod in_force;
mod routine;
mod steps;
mod targets;

pub(super) use entry::LeftBehind;
pub(super) use in_force::{SlotState, State};
pub(super) use targets::{TargetsOnWays, targets_on_ways};

use super::cfg::ControlFlow;
use super::const_eval::{ConstEvaluator, TrackedValues};
use super::file_values::FileValues;
use super::flow::{RoutineCfg, every_step};
use super::ids::{DatumId, RoutineIndex, Slot, Table};
use super::index::{Ctx, Index};
use super::mod_ref::{RoutineEffects, routine_effects};
use super::motion::{MotionId, SkipReason};
use super::names::ByNumber;
use super::open_variables::has_main;
use super::own_position::OwnPositions;
use super::tracked::{TrackedData, names_in};
use super::value::{Value, Why};
use earlier_rounds::{CallPath, EarlierRounds};
use rapid_syntax::tree::{Expr, RoutineKind};
use std::collections::BTreeSet;
use std::rc::Rc;

/// States a routine is walked with one by one; behind it only what they have in common counts.
const MOST_STATES: usize = 16;
/// Calls nested deeper are not followed.
const DEEPEST_CALL: usize = 100;
/// Steps in all, behind which everything counts as not known.
const MOST_STEPS: u64 = 30_000_000;

/// A state as the values of the data that are tracked.
pub(super) struct View<'s> {
    pub(super) state: &'s State,
    pub(super) tracked: &'s TrackedData,
}

impl View<'_> {
    /// The PERS of whose value in the file an expression is made.
    pub(super) fn of_file(
        &self,
        file_values: &FileValues,
        index: &Index<'_>,
        expr: &Expr,
        ctx: Ctx,
    ) -> Option<DatumId> {
        let mut found = None;
        names_in(index, ctx, expr, &mut |datum| {
            let of = match self.tracked.slot(datum) {
                Some(slot) => self.state.slots.get(slot).and_then(|slot| slot.of_file),
                None => file_values.of_untracked(datum),
            };
            found = found.or(of);
        });
        found
    }
}

impl TrackedValues for View<'_> {
    fn value(&self, datum: DatumId) -> Option<Value> {
        let slot = self.tracked.slot(datum)?;
        self.state.slots.get(slot).map(|s| s.value.clone())
    }
}

/// What each motion sees; `None` where no way leads to it.
pub(super) type AtMotions = Vec<Option<Rc<State>>>;

/// What motions see, by passes of the program.
pub(super) struct StatesAtMotions {
    /// In the first pass, which begins with the declared values.
    pub(super) first: AtMotions,
    /// In whatever pass: data that outlive a cycle begin with the declared value or with one that the program has left.
    pub(super) any: AtMotions,
    /// What the program leaves in the data that are tracked.
    pub(super) left: Table<Slot, LeftBehind>,
}

/// What each of so many motions sees.
pub(super) fn states_at_motions<'a>(
    evaluator: &mut ConstEvaluator<'a>,
    motions: usize,
    control_flow: &ControlFlow<'a>,
    (tracked, file_values): (&TrackedData, &FileValues),
) -> StatesAtMotions {
    let mut walker = StateAnalysis::new(evaluator, motions, control_flow, (tracked, file_values));
    walker.run();
    let first = walker.at_motions.clone();
    while walker.widen_entry() {
        walker.run();
    }
    StatesAtMotions { first, any: walker.at_motions, left: walker.left }
}

struct StateAnalysis<'w, 'a> {
    evaluator: &'w mut ConstEvaluator<'a>,
    control_flow: &'w ControlFlow<'a>,
    tracked: &'w TrackedData,
    file_values: &'w FileValues,
    at_motions: Vec<Option<Rc<State>>>,
    /// The last one seen: most motions of a routine see the same.
    last_seen: Option<Rc<State>>,
    walked: Table<RoutineIndex, Vec<Walked>>,
    common: Table<RoutineIndex, Option<State>>,
    busy: Vec<Busy>,
    earlier: EarlierRounds,
    steps: u64,
    effects: Table<RoutineIndex, RoutineEffects>,
    /// What the handlers of each routine and those they call may change.
    in_handlers: Table<RoutineIndex, RoutineEffects>,
    /// Motions whose target is looked at on every visit.
    watched: ByNumber<MotionId, Watched<'a>>,
    /// Points that searches have found, and the motions to which they come.
    found: Option<FollowedPositions<'w, 'a>>,
    /// The same of what was read from where the robot stands.
    read: Option<FollowedPositions<'w, 'a>>,
    /// What the program is entered with; nothing: declared values, and everything off.
    entry: Option<State>,
    /// What motion settings are in force where a cycle ends, on any way of this pass.
    cycle_end: Option<State>,
    /// What this pass has left in them so far.
    left: Table<Slot, LeftBehind>,
    /// What is being walked runs only where somebody calls it by hand.
    by_hand: bool,
}

/// The target of a motion, and what it was on the visits so far; `None` where that is not known or too much.
struct Watched<'a> {
    target: &'a Expr,
    ctx: Ctx,
    values: Option<Vec<Value>>,
    /// The PERS of whose value in the file it is made on some visit.
    of_file: Option<DatumId>,
}

/// What holds the arm's own position, followed to the motions.
struct FollowedPositions<'w, 'a> {
    positions: &'w OwnPositions,
    /// The targets of each motion that can hold one at some time.
    targets: ByNumber<MotionId, (Vec<&'a Expr>, Ctx)>,
    /// The motions to which one comes.
    motions: BTreeSet<MotionId>,
}

impl<'a> FollowedPositions<'_, 'a> {
    /// The targets of a motion that can hold one at some time, and where they are written.
    fn targets_of(&self, motion: MotionId) -> Option<(Vec<&'a Expr>, Ctx)> {
        self.targets.get(&motion).cloned()
    }
}

/// What a routine leaves.
#[derive(Clone, Debug, Default)]
struct After {
    /// At its end; `None` where it never comes back.
    exit: Option<State>,
    /// Where an error leaves it; `None` where none does.
    failed: Option<State>,
}

/// A routine that has been walked.
#[derive(Clone)]
struct Walked {
    /// What it was called with.
    asked: Rc<State>,
    /// What it was entered with in the end, by the calls of itself further down too.
    entry: State,
    after: After,
}

/// A routine that is being walked.
struct Busy {
    routine: RoutineIndex,
    path: CallPath,
    /// What it was entered with, by the calls of itself further down too.
    entry: State,
    /// What it is known to leave so far.
    after: After,
    /// Where an error may have come in this walk.
    failed: Option<State>,
    recursive: bool,
}

impl<'w, 'a> StateAnalysis<'w, 'a> {
    fn new(
        evaluator: &'w mut ConstEvaluator<'a>,
        motions: usize,
        control_flow: &'w ControlFlow<'a>,
        (tracked, file_values): (&'w TrackedData, &'w FileValues),
    ) -> Self {
        let routines = control_flow.routines.len();
        Self {
            at_motions: vec![None; motions],
            last_seen: None,
            walked: Table::filled(routines, Vec::new()),
            common: Table::filled(routines, None),
            busy: Vec::new(),
            earlier: EarlierRounds::default(),
            steps: 0,
            in_handlers: Table::default(),
            effects: routine_effects(control_flow),
            watched: ByNumber::default(),
            found: None,
            read: None,
            entry: None,
            cycle_end: None,
            left: Table::filled(tracked.data.len(), LeftBehind::default()),
            by_hand: false,
            evaluator,
            control_flow,
            tracked,
            file_values,
        }
    }
}

impl StateAnalysis<'_, '_> {
    fn run(&mut self) {
        self.in_handlers = self.control_flow.routines.iter().map(|cfg| self.in_handlers_of(cfg)).collect();
        let index = self.evaluator.index;
        let entered = self.entry();
        let ids = self.control_flow.routines.ids();
        for id in ids.clone().filter(|&id| index.interrupts(id)) {
            let what = match index.routines[id].tree.kind {
                RoutineKind::Trap => "a trap may run at any time",
                _ => "a procedure that a motion calls may run at any time",
            };
            let anything = self.anything(what);
            self.call(id, anything);
        }
        let [begins, by_hand] = self.not_called();
        for id in begins {
            let after = self.call(id, entered.clone());
            // Where `main` is not given it may call one after the other.
            let goes_on = self.is_main(id) || !has_main(index, index.routines[id].ctx);
            if let Some(exit) = after.exit.filter(|_| goes_on) {
                self.end_cycle(&exit);
            }
        }
        self.by_hand = true;
        for id in by_hand {
            self.call(id, entered.clone());
        }
        self.by_hand = false;
        for id in ids {
            if self.walked[id].is_empty() {
                self.call(id, entered.clone()); // it is called in a circle only
            }
        }
        if self.steps > MOST_STEPS {
            let anything = self.anything("there are too many ways through the program to follow");
            let mut shared = None;
            for motion in (0..self.at_motions.len()).map(MotionId::new) {
                self.record(motion, &anything, &mut shared);
            }
        }
        self.at_any_time();
    }

    /// ConfL and the like in traps and handlers may come into force anywhere, and so may what a trap grips.
    fn at_any_time(&mut self) {
        let index = self.evaluator.index;
        let mut any = RoutineEffects::default();
        let mut a_trap_grips = false;
        for (id, in_handlers) in self.in_handlers.numbered() {
            if index.interrupts(id) {
                any.add(&self.effects[id]);
                a_trap_grips |= self.effects[id].grip;
            }
            any.add(in_handlers);
        }
        if !any.conf_l && !any.conf_j && !a_trap_grips && any.blockers.iter().all(Option::is_none) {
            return;
        }
        for state in self.at_motions.iter_mut().flatten().map(Rc::make_mut) {
            state.conf_l = state.conf_l.filter(|_| !any.conf_l);
            state.conf_j = state.conf_j.filter(|_| !any.conf_j);
            state.grip = state.grip.filter(|_| !any.grip);
            for (by, blocker) in any.blockers.iter().zip(&mut state.blockers) {
                if let Some(by) = by
                    && blocker.is_none()
                {
                    *blocker = Some(at_any_time(by));
                }
            }
        }
    }

    fn in_handlers_of(&self, cfg: &RoutineCfg<'_>) -> RoutineEffects {
        let mut own = RoutineEffects::default();
        for handler in &cfg.handlers {
            every_step(handler, &mut |step| own.add_step(step));
        }
        for callee in own.calls.clone().iter() {
            own.add(&self.effects[callee]);
        }
        own
    }
}

/// What a trap, an error handler or a procedure that a motion calls puts in force.
fn at_any_time(by: &Why) -> Why {
    let reason = format!(
        "a trap, an error handler or a procedure that a motion calls may put it in force: {}",
        by.reason
    );
    Rc::new(SkipReason { reason, ..(**by).clone() })
}
