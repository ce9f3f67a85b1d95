//! What a program is entered with: declared values and nothing in force in its first pass, and in later ones what it has left in the
//! PERS and the VAR of its modules, and the motion settings (ConfL, GripLoad, PDispOn, ...) in force where `main` ends: they
//! all outlive a cycle (ABB, "RAPID Instructions", ExitCycle: variables, persistents and motion settings are not affected).
//!
//! The entry is widened by what is written, component by component, until a walk writes nothing that it does not have. Routines
//! that nothing calls beside a `main` are called by hand: what they set counts where it is known, as somebody may choose a tool so; what
//! only run time tells (a tool that is calibrated) does not, or nothing made of it could be corrected by tables.

use super::held_parts::HeldParts;
use super::in_force::{lose, same, unknown};
use super::{MOST_STEPS, SlotState, State, StateAnalysis};
use crate::const_eval::Constant;
use crate::data::LoadData;
use crate::file_values::differs_on_controllers;
use crate::flow::BLOCKERS;
use crate::ids::{DatumId, IdSet, RoutineIndex, Slot, Table};
use crate::index::DatumKind;
use crate::mod_ref::RoutineEffects;
use crate::motion::SkipReason;
use crate::open_variables::{has_main, is_seen_by_others};
use crate::value::{Value, Why};
use rapid_syntax::diagnostic::Span;
use rapid_syntax::tree::DataKind;
use std::rc::Rc;

/// More values are too many to look at each.
const MOST_LEFT: usize = 16;

/// What a program writes into a datum that outlives a cycle.
#[derive(Clone, Debug, Default)]
pub(crate) struct LeftBehind {
    /// The values that are known in every part, each with the first place that sets it.
    pub(crate) values: Vec<(Value, Span)>,
    /// Where a value is set that is not known, or one too many.
    pub(crate) unknown: Option<Span>,
    /// The same in what is called by hand alone.
    pub(crate) by_hand: Option<Span>,
    /// What all of them have in common.
    common: Option<Value>,
}

impl StateAnalysis<'_, '_> {
    /// Takes what the last pass has left into the entry, and forgets that pass; `false` where the entry had it all.
    pub(super) fn widen_entry(&mut self) -> bool {
        if self.steps > MOST_STEPS {
            return false;
        }
        let before = self.entry();
        let mut widened = before.clone();
        if let Some(end) = self.cycle_end.take() {
            widened.join_settings(&end);
        }
        let entered = widened.slots.iter_mut().zip(&self.left);
        for ((SlotState { value, .. }, left), &datum) in entered.zip(&self.tracked.data) {
            if !self.outlives(datum) {
                continue;
            }
            for (known, at) in &left.values {
                *value = value.join(known, &|| self.as_left(Some(*at)));
            }
            if let Some(common) = &left.common {
                let why = self.as_left(left.unknown);
                *value = unknown_since(value, &value.join(common, &|| why.clone()), &why);
            }
        }
        if same(&before, &widened) {
            return false;
        }
        self.entry = Some(widened);
        self.at_motions.fill(None);
        self.last_seen = None;
        self.walked.iter_mut().for_each(Vec::clear);
        self.common.fill(None);
        self.steps = 0;
        self.left.fill(LeftBehind::default());
        true
    }

    /// Notes the settings in force where a cycle ends: the next one begins with them.
    pub(super) fn end_cycle(&mut self, state: &State) {
        match &mut self.cycle_end {
            Some(end) => end.join_settings(state),
            None => self.cycle_end = Some(state.clone()),
        }
    }

    fn as_left(&self, at: Option<Span>) -> Why {
        let place = at.map_or(String::new(), |at| format!(": {}", self.evaluator.index.place(at)));
        let reason = format!("it is used before it is set, as the program has left it{place}");
        Rc::new(SkipReason { code: "keep::runtime-target", reason, because: at })
    }

    /// Notes what a statement sets.
    pub(super) fn leave_behind(&mut self, slot: Slot, value: Value, at: Span) {
        let Some(left) = self.left.get_mut(slot) else { return };
        let is_known = value.unknown().is_none();
        if !is_known && self.by_hand {
            left.by_hand.get_or_insert(at);
            return;
        }
        left.common = Some(match left.common.take() {
            None => value.clone(),
            Some(common) => common.join(&value, &|| unknown("it is set to several values")),
        });
        if left.values.iter().any(|(known, _)| known.same(&value)) {
            return;
        }
        if is_known && left.values.len() < MOST_LEFT {
            left.values.push((value, at));
        } else {
            left.unknown.get_or_insert(at);
        }
    }

    /// Whether a datum has at the entry what the cycle before has left in it.
    fn outlives(&self, datum: DatumId) -> bool {
        let entry = &self.evaluator.index.data[datum];
        let kept = [DataKind::Pers, DataKind::Var].map(DatumKind::Declared);
        entry.ctx.routine.is_none() && kept.contains(&entry.kind)
    }

    /// Whether a variable may have been set before the first routine that is given: one that other modules see, of a task without `main`.
    fn is_handed_over(&self, datum: DatumId) -> bool {
        let index = self.evaluator.index;
        let entry = &index.data[datum];
        is_seen_by_others(entry) && !has_main(index, entry.ctx)
    }

    /// The routines that nothing calls: those with which the program or a library begins, and those beside a `main`, which only a
    /// hand calls.
    pub(super) fn not_called(&self) -> [Vec<RoutineIndex>; 2] {
        let index = self.evaluator.index;
        let called: IdSet<RoutineIndex> = self.effects.iter().flat_map(|t| t.calls.iter()).collect();
        let task =
            |id: RoutineIndex| index.modules.get(index.routines[id].ctx.module).map(|module| module.task);
        let of_kind = |id: RoutineIndex| !index.interrupts(id);
        let ids = self.control_flow.routines.ids();
        let with_main: Vec<Option<u32>> = ids.clone().filter(|&id| self.is_main(id)).map(task).collect();
        let entries = ids.filter(|&id| of_kind(id) && !called.contains(id));
        let (by_hand, begins) = entries.partition(|&id| !self.is_main(id) && with_main.contains(&task(id)));
        [begins, by_hand]
    }

    /// Whether a program begins there, anew in every cycle.
    pub(super) fn is_main(&self, id: RoutineIndex) -> bool {
        let index = self.evaluator.index;
        index.names.text(index.routines[id].name) == "main"
    }

    /// The state a program starts with: in its first pass everything off.
    pub(super) fn entry(&mut self) -> State {
        if let Some(entry) = &self.entry {
            return entry.clone();
        }
        let mut slots: Table<Slot, SlotState> = Table::default();
        for &datum in &self.tracked.data {
            let kind = self.evaluator.index.data[datum].kind;
            let value = match kind {
                DatumKind::Declared(_) => self.evaluator.initial(datum),
                DatumKind::Param { .. } | DatumKind::LoopVariable => self.evaluator.datum(datum, &Constant),
            };
            let mut value = value.unwrap_or_else(Value::Unknown);
            if !self.watched.is_empty() && matches!(kind, DatumKind::Declared(_)) {
                // What a cycle of the program has left in it the next one begins with.
                value = Value::Unknown(unknown("it may be as the cycle before has left it"));
            } else if self.is_handed_over(datum) {
                value = Value::Unknown(unknown("main is not given, and may have set it"));
            }
            let outlives = self.outlives(datum);
            // What a search has found, and where the robot stood, the next cycle begins with, too.
            let of_file = differs_on_controllers(self.evaluator.index, datum).then_some(datum);
            let read = if outlives { HeldParts::ALL } else { HeldParts::NONE };
            slots.push(SlotState { value, at_entry: outlives, found: outlives, read, of_file, set_at: None });
        }
        // From its beginning a program grips nothing.
        let grip = Some(LoadData::default());
        State {
            slots,
            conf_l: Some(true),
            conf_j: Some(true),
            grip,
            blockers: [const { None }; BLOCKERS.len()],
        }
    }

    /// A state of which nothing is known that the program changes.
    pub(super) fn anything(&mut self, reason: &str) -> State {
        let mut state = self.entry();
        let mut all = RoutineEffects::default();
        for effects in &self.effects {
            all.add(effects);
        }
        lose(&mut state, &all, &unknown(reason));
        state
    }
}

/// A value with a reason for the parts that were known `before` and are not known `now`.
fn unknown_since(before: &Value, now: &Value, why: &Why) -> Value {
    match (before, now) {
        (Value::Unknown(_), _) => before.clone(),
        (_, Value::Unknown(_)) => Value::Unknown(why.clone()),
        (Value::Parts(before), Value::Parts(now)) => {
            Value::parts(before.iter().zip(now.iter()).map(|(before, now)| unknown_since(before, now, why)))
        }
        _ => now.clone(),
    }
}
