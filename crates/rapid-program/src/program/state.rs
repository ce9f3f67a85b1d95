//! What is in force where: the values of the data that are tracked, ConfL and ConfJ, displacements,
//! carried through every routine in the order of its statements and into the routines it calls.
//!
//! A routine is walked once for each state it is called with; a routine called with many is from then
//! on walked with what they have in common. What a motion sees is what all its visits have in common.
//!
//! An error leaves a routine with the state at the statement that fails; where a handler of a caller goes
//! on with TRYNEXT or RETRY, it goes on with that.

mod entry;
mod steps;
mod targets;

pub(super) use entry::LeftBehind;
pub(super) use targets::{TargetsOnWays, targets_on_ways};

use super::data::LoadData;

use super::cfg::ControlFlow;
use super::const_eval::{ConstEvaluator, TrackedValues};
use super::flow::{BLOCKERS, ForwardAnalysis, RoutineCfg, every_step, walk};
use super::ids::{DatumId, RoutineIndex, Slot, Table};
use super::index::Ctx;
use super::mod_ref::{RoutineEffects, routine_effects};
use super::motion::{MotionId, SkipReason};
use super::names::ByNumber;
use super::own_position::OwnPositions;
use super::tracked::TrackedData;
use super::value::{Value, Why};
use rapid_syntax::diagnostic::Span;
use rapid_syntax::tree::{Expr, RoutineKind};
use std::collections::BTreeSet;
use std::rc::Rc;

/// States a routine is walked with one by one; behind it only what they have in common counts.
const MOST_STATES: usize = 16;
/// Calls nested deeper are not followed.
const DEEPEST_CALL: usize = 100;
/// Steps in all, behind which everything counts as not known.
const MOST_STEPS: u64 = 30_000_000;

/// A tracked datum at one place.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SlotState {
    pub(super) value: Value,
    /// On some way that leads here it is still what the program was entered with; of data that outlive a cycle.
    pub(super) at_entry: bool,
    /// It can be what a search has found; looked at for data alone that can hold such a point at some time.
    found: bool,
    set_at: Option<Span>,
}

/// What is in force at one place.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct State {
    pub(super) slots: Table<Slot, SlotState>,
    pub(super) conf_l: Option<bool>,
    pub(super) conf_j: Option<bool>,
    /// What the last GripLoad said; `None` = not known.
    pub(super) grip: Option<LoadData>,
    /// In the order of [`BLOCKERS`]: why it is, or may be, in force.
    pub(super) blockers: [Option<Why>; BLOCKERS.len()],
}

/// A state as the values of the data that are tracked.
pub(super) struct View<'s> {
    pub(super) state: &'s State,
    pub(super) tracked: &'s TrackedData,
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
    tracked: &TrackedData,
) -> StatesAtMotions {
    let mut walker = Walker::new(evaluator, motions, control_flow, tracked);
    walker.run();
    let first = walker.at_motions.clone();
    while walker.widen_entry() {
        walker.run();
    }
    StatesAtMotions { first, any: walker.at_motions, left: walker.left }
}

struct Walker<'w, 'a> {
    evaluator: &'w mut ConstEvaluator<'a>,
    control_flow: &'w ControlFlow<'a>,
    tracked: &'w TrackedData,
    at_motions: Vec<Option<Rc<State>>>,
    /// The last one seen: most motions of a routine see the same.
    last_seen: Option<Rc<State>>,
    walked: Table<RoutineIndex, Vec<(State, After)>>,
    common: Table<RoutineIndex, Option<State>>,
    busy: Vec<Busy>,
    steps: u64,
    effects: Table<RoutineIndex, RoutineEffects>,
    /// What the handlers of each routine and those they call may change.
    in_handlers: Table<RoutineIndex, RoutineEffects>,
    /// Motions whose target is looked at on every visit.
    watched: ByNumber<MotionId, Watched<'a>>,
    /// Points that searches have found, and the motions to which they come.
    found: Option<FoundPoints<'w, 'a>>,
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
}

/// The points that searches have found, followed to the motions.
struct FoundPoints<'w, 'a> {
    points: &'w OwnPositions,
    /// The targets of each motion that can be one at some time.
    targets: ByNumber<MotionId, (Vec<&'a Expr>, Ctx)>,
    /// The motions to which one comes.
    motions: BTreeSet<MotionId>,
}

/// What a routine leaves.
#[derive(Clone, Debug, Default)]
struct After {
    /// At its end; `None` where it never comes back.
    exit: Option<State>,
    /// Where an error leaves it; `None` where none does.
    failed: Option<State>,
}

/// A routine that is being walked.
struct Busy {
    routine: RoutineIndex,
    /// What it was entered with, by the calls of itself further down too.
    entry: State,
    /// What it is known to leave so far.
    after: After,
    /// Where an error may have come in this walk.
    failed: Option<State>,
    recursive: bool,
}

impl<'w, 'a> Walker<'w, 'a> {
    fn new(
        evaluator: &'w mut ConstEvaluator<'a>,
        motions: usize,
        control_flow: &'w ControlFlow<'a>,
        tracked: &'w TrackedData,
    ) -> Self {
        let routines = control_flow.routines.len();
        Self {
            at_motions: vec![None; motions],
            last_seen: None,
            walked: Table::filled(routines, Vec::new()),
            common: Table::filled(routines, None),
            busy: Vec::new(),
            steps: 0,
            in_handlers: Table::default(),
            effects: routine_effects(control_flow),
            watched: ByNumber::default(),
            found: None,
            entry: None,
            cycle_end: None,
            left: Table::filled(tracked.data.len(), LeftBehind::default()),
            by_hand: false,
            evaluator,
            control_flow,
            tracked,
        }
    }
}

impl Walker<'_, '_> {
    fn run(&mut self) {
        self.in_handlers = self.control_flow.routines.iter().map(|cfg| self.in_handlers_of(cfg)).collect();
        let index = self.evaluator.index;
        let entered = self.entry();
        let ids = self.control_flow.routines.ids();
        for id in ids.clone().filter(|&id| index.routines[id].tree.kind == RoutineKind::Trap) {
            let anything = self.anything("a trap may run at any time");
            self.call(id, anything);
        }
        let [begins, by_hand] = self.not_called();
        for id in begins {
            let after = self.call(id, entered.clone());
            if let Some(exit) = after.exit.filter(|_| self.is_main(id)) {
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

    /// ConfL and the like in traps and handlers may come into force anywhere.
    fn at_any_time(&mut self) {
        let index = self.evaluator.index;
        let mut any = RoutineEffects::default();
        for (id, in_handlers) in self.in_handlers.numbered() {
            if index.routines[id].tree.kind == RoutineKind::Trap {
                any.add(&self.effects[id]);
            }
            any.add(in_handlers);
        }
        if !any.conf_l && !any.conf_j && any.blockers.iter().all(Option::is_none) {
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

    /// What a motion sees on one more visit; `shared`: the same for other motions that see it.
    fn record(&mut self, motion: MotionId, state: &State, shared: &mut Option<Rc<State>>) {
        self.watch(motion, state);
        self.watch_found(motion, state);
        let seen = self.at_motions.get_mut(motion.index()).and_then(Option::take);
        let seen = match seen {
            None => Rc::clone(shared.get_or_insert_with(|| match self.last_seen.take() {
                Some(last) if *last == *state => last,
                _ => Rc::new(state.clone()),
            })),
            Some(mut seen) => {
                self.join(Rc::make_mut(&mut seen), state);
                seen
            }
        };
        self.last_seen = Some(Rc::clone(&seen));
        if let Some(at) = self.at_motions.get_mut(motion.index()) {
            *at = Some(seen);
        }
    }

    /// What a routine leaves that is called in `entry`.
    fn call(&mut self, routine: RoutineIndex, mut entry: State) -> After {
        if let Some(at) = self.busy.iter().rposition(|b| b.routine == routine) {
            return self.call_again(at, &entry);
        }
        if let Some((_, after)) = self.walked[routine].iter().find(|(known, _)| same(known, &entry)) {
            return after.clone();
        }
        if self.busy.len() >= DEEPEST_CALL {
            self.steps = MOST_STEPS + 1;
            return After { exit: Some(entry), failed: None };
        }
        if self.walked[routine].len() >= MOST_STATES {
            if let Some(mut common) = self.common[routine].take() {
                self.join(&mut common, &entry);
                entry = common;
            }
            self.common[routine] = Some(entry.clone());
            if let Some((_, after)) = self.walked[routine].iter().find(|(known, _)| same(known, &entry)) {
                return after.clone();
            }
        }
        let known: Vec<usize> = self.walked.iter().map(Vec::len).collect();
        let mut after = After::default();
        loop {
            let (entered, known_after) = (entry.clone(), after.clone());
            self.busy.push(Busy {
                routine,
                entry: entered,
                after: known_after,
                failed: None,
                recursive: false,
            });
            let exit = self.body(routine, &entry);
            let Some(busy) = self.busy.pop() else { break };
            let before = std::mem::take(&mut after);
            after.exit = self.either(before.exit.clone(), exit);
            after.failed = self.either(before.failed.clone(), busy.failed);
            let settled = same_or_none(before.exit.as_ref(), after.exit.as_ref())
                && same_or_none(before.failed.as_ref(), after.failed.as_ref());
            if !busy.recursive || settled && same(&busy.entry, &entry) {
                break;
            }
            // What was walked on the way rests on what this routine was taken to do.
            for (walked, &known) in self.walked.iter_mut().zip(&known) {
                walked.truncate(known);
            }
            entry = busy.entry;
        }
        self.walked[routine].push((entry, after.clone()));
        after
    }

    /// A routine that calls itself: the outer call is walked again until it covers this one as well.
    fn call_again(&mut self, at: usize, entry: &State) -> After {
        let Some(mut covered) = self.busy.get(at).map(|busy| busy.entry.clone()) else {
            return After::default();
        };
        self.join(&mut covered, entry);
        let Some(busy) = self.busy.get_mut(at) else { return After::default() };
        busy.entry = covered;
        busy.recursive = true;
        busy.after.clone()
    }

    fn body(&mut self, routine: RoutineIndex, entry: &State) -> Option<State> {
        let control_flow = self.control_flow;
        let cfg = &control_flow.routines[routine];
        let mut exit = walk(self, &cfg.body, entry);
        let failed_in_body = self.busy.last_mut().and_then(|busy| busy.failed.take());
        if !cfg.handlers.is_empty() {
            let mut failed = entry.clone();
            let reason = unknown("an error may come before or after it is set");
            lose(&mut failed, &self.effects[routine], &reason);
            for handler in &cfg.handlers {
                let handled = walk(self, handler, &failed);
                exit = self.either(exit, handled);
            }
        }
        if let Some(failed) = failed_in_body.filter(|_| !cfg.recovery.catches_all) {
            self.fails(&failed);
        }
        exit
    }

    /// An error may leave what is being walked with this state.
    fn fails(&mut self, state: &State) {
        let known = self.busy.last_mut().and_then(|busy| busy.failed.take());
        let failed = self.either(known, Some(state.clone()));
        if let Some(busy) = self.busy.last_mut() {
            busy.failed = failed;
        }
    }

    /// The state behind the handlers of what is being walked.
    fn handled(&self, state: &mut State) {
        let in_handlers = self.busy.last().and_then(|busy| self.in_handlers.get(busy.routine));
        if let Some(in_handlers) = in_handlers {
            lose(state, in_handlers, &unknown("an error handler may change it"));
        }
    }

    fn either(&mut self, a: Option<State>, b: Option<State>) -> Option<State> {
        match (a, b) {
            (Some(mut a), Some(b)) => {
                self.join(&mut a, &b);
                Some(a)
            }
            (a, b) => a.or(b),
        }
    }
}

fn same(a: &State, b: &State) -> bool {
    a.conf_l == b.conf_l
        && a.conf_j == b.conf_j
        && a.grip == b.grip
        && a.blockers.iter().zip(&b.blockers).all(|(a, b)| a.is_some() == b.is_some())
        && a.slots
            .iter()
            .zip(&b.slots)
            .all(|(a, b)| a.at_entry == b.at_entry && a.found == b.found && a.value.same(&b.value))
}

fn same_or_none(a: Option<&State>, b: Option<&State>) -> bool {
    match (a, b) {
        (None, None) => true,
        (Some(a), Some(b)) => same(a, b),
        _ => false,
    }
}

fn lose(state: &mut State, effects: &RoutineEffects, why: &Why) {
    for slot in effects.slots.iter() {
        if let Some(slot) = state.slots.get_mut(slot) {
            slot.value = Value::Unknown(why.clone());
            slot.found = true;
        }
    }
    state.conf_l = state.conf_l.filter(|_| !effects.conf_l);
    state.conf_j = state.conf_j.filter(|_| !effects.conf_j);
    state.grip = state.grip.filter(|_| !effects.grip);
    for (by, blocker) in effects.blockers.iter().zip(&mut state.blockers) {
        if by.is_some() {
            blocker.clone_from(by);
        }
    }
}

/// What a trap or an error handler puts in force.
fn at_any_time(by: &Why) -> Why {
    let reason = format!("a trap or an error handler may put it in force: {}", by.reason);
    Rc::new(SkipReason { reason, ..(**by).clone() })
}

fn unknown(reason: &str) -> Why {
    Rc::new(SkipReason { code: "keep::runtime-target", reason: reason.into(), because: None })
}
