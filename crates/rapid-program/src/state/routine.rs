//! One routine walked from the state it is called in to the state it leaves, through those that call themselves and through handlers
//! of errors.
//!
//! Knows nothing of where a program begins, nor of what a single step does.

use super::held_parts::HeldParts;
use super::in_force::{lose, same, same_or_none, unknown};
use super::{After, Busy, DEEPEST_CALL, MOST_STATES, MOST_STEPS, State, StateAnalysis, Walked};
use crate::flow::{ForwardAnalysis, walk};
use crate::ids::RoutineIndex;
use crate::index::DatumKind;
use crate::motion::MotionId;
use crate::value::Value;
use rapid_syntax::tree::{DataKind, ParamMode};
use std::rc::Rc;

impl StateAnalysis<'_, '_> {
    /// What a motion sees on one more visit; `shared`: the same for other motions that see it.
    pub(super) fn record(&mut self, motion: MotionId, state: &State, shared: &mut Option<Rc<State>>) {
        self.watch(motion, state);
        self.watch_positions(motion, state);
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
    pub(super) fn call(&mut self, routine: RoutineIndex, mut entry: State) -> After {
        if let Some(at) = self.busy.iter().rposition(|b| b.routine == routine) {
            return self.call_again(at, &entry);
        }
        if let Some(after) = self.walked_before(routine, &entry) {
            return after;
        }
        if self.busy.len() >= DEEPEST_CALL {
            self.steps = MOST_STEPS + 1;
        }
        if self.steps > MOST_STEPS {
            return After { exit: Some(entry), failed: None };
        }
        if self.walked[routine].len() >= MOST_STATES {
            if let Some(mut common) = self.common[routine].take() {
                self.join(&mut common, &entry);
                entry = common;
            }
            self.common[routine] = Some(entry.clone());
            if let Some(after) = self.walked_before(routine, &entry) {
                return after;
            }
        }
        let walked = self.walk_until_settled(routine, Rc::new(entry));
        if self.busy.is_empty() {
            self.earlier.clear();
        }
        let after = walked.after.clone();
        self.walked[routine].push(walked);
        after
    }

    /// Walks a routine until it covers the calls of itself further down; not for ever, as what it is entered with and leaves only grows.
    fn walk_until_settled(&mut self, routine: RoutineIndex, asked: Rc<State>) -> Walked {
        let known: Vec<usize> = self.walked.iter().map(Vec::len).collect();
        let path = self.earlier.path(self.busy.last().map(|busy| busy.path), routine, &asked);
        let found = self.earlier.found(path);
        let (mut entry, mut after) = found.unwrap_or_else(|| ((*asked).clone(), After::default()));
        loop {
            let (entered, known_after) = (entry.clone(), after.clone());
            self.busy.push(Busy {
                routine,
                path,
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
            if !busy.recursive {
                break;
            }
            self.earlier.note(path, &busy.entry, &after);
            if settled && same(&busy.entry, &entry) {
                break;
            }
            // What was walked on the way rests on what this routine was taken to do.
            for (walked, &known) in self.walked.iter_mut().zip(&known) {
                walked.truncate(known);
            }
            entry = busy.entry;
        }
        Walked { asked, entry, after }
    }

    /// What a routine left that was entered with the same, or that has to be with what it was walked with in the end.
    fn walked_before(&self, routine: RoutineIndex, entry: &State) -> Option<After> {
        let is_it = |walked: &&Walked| same(&walked.entry, entry) || same(&walked.asked, entry);
        self.walked[routine].iter().find(is_it).map(|walked| walked.after.clone())
    }

    /// What a call has left, seen from the caller, in which it was `before`: where routines call themselves, another call of the caller may
    /// have had its own parameters and variables under the same names.
    pub(super) fn back_in_caller(&self, after: After, before: &State) -> After {
        let caller = self.busy.last().filter(|_| self.busy.iter().any(|busy| busy.recursive));
        let Some(caller) = caller.map(|busy| busy.routine) else { return after };
        let After { mut exit, mut failed } = after;
        for (slot, &datum) in self.tracked.data.numbered() {
            let entry = &self.evaluator.index.data[datum];
            let is_own = entry.ctx.routine == Some(caller);
            for state in [&mut exit, &mut failed].into_iter().flatten().filter(|_| is_own) {
                let (Some(now), Some(before)) = (state.slots.get_mut(slot), before.slots.get(slot)) else {
                    continue;
                };
                match entry.kind {
                    DatumKind::Param { mode: ParamMode::In, .. } | DatumKind::Declared(DataKind::Var) => {
                        now.clone_from(before);
                    }
                    // What it stands for the other call may have changed.
                    DatumKind::Param { .. } => {
                        now.value = Value::Unknown(unknown("its routine calls itself"));
                        now.read = HeldParts::ALL;
                    }
                    DatumKind::Declared(_) | DatumKind::LoopVariable => {}
                }
            }
        }
        After { exit, failed }
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
    pub(super) fn fails(&mut self, state: &State) {
        let known = self.busy.last_mut().and_then(|busy| busy.failed.take());
        let failed = self.either(known, Some(state.clone()));
        if let Some(busy) = self.busy.last_mut() {
            busy.failed = failed;
        }
    }

    /// The state behind the handlers of what is being walked.
    pub(super) fn handled(&self, state: &mut State) {
        let in_handlers = self.busy.last().and_then(|busy| self.in_handlers.get(busy.routine));
        if let Some(in_handlers) = in_handlers {
            lose(state, in_handlers, &unknown("an error handler may change it"));
        }
    }

    pub(super) fn either(&mut self, a: Option<State>, b: Option<State>) -> Option<State> {
        match (a, b) {
            (Some(mut a), Some(b)) => {
                self.join(&mut a, &b);
                Some(a)
            }
            (a, b) => a.or(b),
        }
    }
}
