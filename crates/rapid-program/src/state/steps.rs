//! What each step of a routine does to the state.

use super::held_parts::HeldParts;
use super::in_force::{same, unknown};
use super::{MOST_STEPS, SlotState, State, StateAnalysis, View};
use crate::const_eval::Constant;
use crate::data::LoadData;
use crate::errors::Recovery;
use crate::flow::{BLOCKERS, Binding, FlowStep, ForwardAnalysis};
use crate::ids::{DatumId, RoutineIndex, Slot};
use crate::index::{Ctx, DatumKind};
use crate::motion::{MotionId, SkipReason};
use crate::names::Sym;
use crate::value::Value;
use rapid_syntax::diagnostic::Span;
use rapid_syntax::tree::Expr;
use std::rc::Rc;

impl<'a> ForwardAnalysis<'a> for StateAnalysis<'_, 'a> {
    type State = State;

    fn join(&mut self, into: &mut State, other: &State) -> bool {
        let before = into.clone();
        let index = self.evaluator.index;
        for ((a, b), &datum) in into.slots.iter_mut().zip(&other.slots).zip(&self.tracked.data) {
            let at = b.set_at.max(a.set_at);
            let why = || {
                let reason = match at {
                    Some(at) => {
                        format!("it is changed on one of the ways that lead here: {}", index.place(at))
                    }
                    None if matches!(index.data[datum].kind, DatumKind::Param { .. }) => {
                        "it is a parameter, and the calls hand over different ones".to_owned()
                    }
                    None => "it is changed on one of the ways that lead here".to_owned(),
                };
                Rc::new(SkipReason { code: "keep::runtime-target", reason, because: at })
            };
            a.value = a.value.join(&b.value, &why);
            a.at_entry |= b.at_entry;
            a.found |= b.found;
            a.read = a.read.or(b.read);
            a.of_file = a.of_file.or(b.of_file);
            a.set_at = at;
        }
        into.join_settings(other);
        !same(&before, into)
    }

    fn step(&mut self, step: &FlowStep<'a>, mut state: State) -> Option<State> {
        self.steps += 1;
        if let FlowStep::Motions { count, .. } = step {
            self.steps += u64::from(count.saturating_sub(1));
        }
        if self.steps > MOST_STEPS {
            return None;
        }
        match step {
            FlowStep::Motions { first, count } => {
                let mut shared = None;
                (first.index()..first.index() + *count as usize)
                    .for_each(|motion| self.record(MotionId::new(motion), &state, &mut shared));
            }
            FlowStep::Assign { slot, path, value, ctx, at } => {
                self.assign((*slot, path), (value, *ctx), *at, &mut state);
            }
            FlowStep::Invalidate { slot, why, at } => {
                if let Some(old) = state.slots.get_mut(*slot) {
                    let value = Value::Unknown(why.clone());
                    *old = SlotState {
                        value: value.clone(),
                        at_entry: false,
                        found: true,
                        read: HeldParts::ALL,
                        of_file: None,
                        set_at: Some(*at),
                    };
                    self.leave_behind(*slot, value, *at);
                }
            }
            FlowStep::ConfL(on) => state.conf_l = *on,
            FlowStep::ConfJ(on) => state.conf_j = *on,
            FlowStep::Grip(load) => state.grip = *load,
            FlowStep::Blocker(hold, why) => {
                for (known, held) in BLOCKERS.iter().zip(&mut state.blockers) {
                    if known == hold {
                        held.clone_from(why);
                    }
                }
            }
            FlowStep::MayFail(recovery) => {
                self.fails(&state);
                if recovery.resumes() {
                    self.handled(&mut state);
                }
            }
            FlowStep::Call { routines, bindings, maybe, recovery, ctx } => {
                return self.call_any(routines, bindings, *maybe, *recovery, *ctx, &state);
            }
            FlowStep::UnknownPosition => {}
            FlowStep::ExitCycle => {
                if !self.by_hand {
                    self.end_cycle(&state);
                }
                return None;
            }
        }
        Some(state)
    }
}

impl State {
    /// What is in force on either of two ways; unknown where they differ.
    pub(super) fn join_settings(&mut self, other: &Self) {
        self.conf_l = self.conf_l.filter(|on| other.conf_l == Some(*on));
        self.conf_j = self.conf_j.filter(|on| other.conf_j == Some(*on));
        let same_load = |load: &LoadData| {
            other.grip.is_some_and(|also| also == *load || also.weighs_nothing() && load.weighs_nothing())
        };
        self.grip = self.grip.filter(same_load);
        for (held, also) in self.blockers.iter_mut().zip(&other.blockers) {
            if held.is_none() {
                held.clone_from(also);
            }
        }
    }
}

impl StateAnalysis<'_, '_> {
    /// A datum, or the component of it that `path` names, is given the value of an expression.
    fn assign(
        &mut self,
        (slot, path): (Slot, &[Sym]),
        (value, ctx): (&Expr, Ctx),
        at: Span,
        state: &mut State,
    ) {
        let new = self.value(value, ctx, state);
        let found = self.reads_found(value, ctx, state);
        let read = self.parts_read(value, ctx, state);
        let of_file = self.of_file(value, ctx, state);
        let index = self.evaluator.index;
        if let (Some(old), Some(&datum)) = (state.slots.get_mut(slot), self.tracked.data.get(slot)) {
            let value = self.with_component(&old.value, index.data[datum].type_name, path, new);
            let read = old.read.with_part(index, datum, path, read);
            let found = found || !path.is_empty() && old.found;
            let of_file = of_file.or(old.of_file.filter(|_| !path.is_empty()));
            *old =
                SlotState { value: value.clone(), at_entry: false, found, read, of_file, set_at: Some(at) };
            self.leave_behind(slot, value, at);
        }
    }

    fn call_any(
        &mut self,
        routines: &[RoutineIndex],
        bindings: &[Binding<'_>],
        maybe: bool,
        recovery: Recovery,
        ctx: Ctx,
        state: &State,
    ) -> Option<State> {
        let mut entry = state.clone();
        for binding in bindings {
            let value = match binding.value {
                Some(expr) => self.value(expr, ctx, state),
                None => self.evaluator.datum(binding.param, &Constant).unwrap_or_else(Value::Unknown),
            };
            let found = binding.value.is_some_and(|value| self.reads_found(value, ctx, state));
            // Of one that is left out nobody knows here whether the caller was given it.
            let read = binding.value.map_or(HeldParts::ALL, |value| self.parts_read(value, ctx, state));
            let of_file = binding.value.and_then(|value| self.of_file(value, ctx, state));
            if let Some(slot) = entry.slots.get_mut(binding.slot) {
                *slot = SlotState { value, at_entry: false, found, read, of_file, set_at: None };
            }
        }
        let mut out = maybe.then(|| state.clone());
        for &routine in routines {
            let mut entry = entry.clone();
            loop {
                let after = self.call(routine, entry.clone());
                let after = self.back_in_caller(after, state);
                if let Some(mut failed) = after.failed {
                    self.fails(&failed);
                    self.handled(&mut failed);
                    if recovery.again && self.join(&mut entry, &failed) {
                        continue;
                    }
                    if recovery.next {
                        out = self.either(out, Some(failed));
                    }
                }
                out = self.either(out, after.exit);
                break;
            }
        }
        out
    }

    /// The PERS of whose value in the file an expression is made.
    pub(super) fn of_file(&self, expr: &Expr, ctx: Ctx, state: &State) -> Option<DatumId> {
        let view = View { state, tracked: self.tracked };
        view.of_file(self.file_values, self.evaluator.index, expr, ctx)
    }

    fn value(&mut self, expr: &Expr, ctx: Ctx, state: &State) -> Value {
        let view = View { state, tracked: self.tracked };
        self.evaluator.fold_number(expr, ctx, &view).unwrap_or_else(Value::Unknown)
    }

    /// The value with the component at `path` replaced.
    fn with_component(&self, value: &Value, type_name: Sym, path: &[Sym], new: Value) -> Value {
        let Some((name, rest)) = path.split_first() else { return new };
        let components = self.evaluator.index.components(type_name).unwrap_or_default();
        let Some(at) = components.iter().position(|(n, _)| n == name) else {
            return Value::Unknown(unknown("a component that its type does not have is set"));
        };
        let mut parts: Vec<Value> = match value {
            Value::Parts(parts) if parts.len() == components.len() => parts.to_vec(),
            Value::Unknown(why) => vec![Value::Unknown(why.clone()); components.len()],
            _ => return Value::Unknown(unknown("its value is not that of its type")),
        };
        if let Some(part) = parts.get_mut(at) {
            *part = self.with_component(part, components[at].1, rest, new);
        }
        Value::parts(parts)
    }
}
