//! What is in force at one place of a program: tracked data, motion settings, what keeps motions from being corrected; whether two
//! states are the same, and what is left of one when it is not known what was done to it.
//!
//! Knows nothing of ways through the program.

use super::held_parts::HeldParts;
use crate::data::LoadData;
use crate::flow::{BLOCKERS, Blocker};
use crate::ids::{DatumId, Slot, Table};
use crate::mod_ref::RoutineEffects;
use crate::motion::SkipReason;
use crate::value::{Value, Why};
use rapid_syntax::diagnostic::Span;
use std::rc::Rc;

/// A tracked datum at one place.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SlotState {
    pub(crate) value: Value,
    /// On some way that leads here it is still what the program was entered with; of data that outlive a cycle.
    pub(crate) at_entry: bool,
    /// It can be what a search has found; looked at for data alone that can hold such a point at some time.
    pub(super) found: bool,
    /// The components of it that can hold what was read from where the robot stands; looked at for data alone that can hold such a
    /// reading at some time.
    pub(super) read: HeldParts,
    /// The PERS of whose value in the file it is made on some way that leads here.
    pub(super) of_file: Option<DatumId>,
    pub(super) set_at: Option<Span>,
}

/// What is in force at one place.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct State {
    pub(crate) slots: Table<Slot, SlotState>,
    pub(crate) conf_l: Option<bool>,
    pub(crate) conf_j: Option<bool>,
    /// What the last GripLoad said; `None` = not known.
    pub(crate) grip: Option<LoadData>,
    /// In the order of [`BLOCKERS`]: why it is, or may be, in force.
    pub(crate) blockers: [Option<Why>; BLOCKERS.len()],
}

impl State {
    /// Whether a blocker is, or may be, in force.
    pub(crate) fn is_in_force(&self, blocker: Blocker) -> bool {
        self.held(blocker).is_some()
    }

    /// Why a blocker is, or may be, in force.
    pub(crate) fn held(&self, blocker: Blocker) -> Option<&Why> {
        let held = BLOCKERS.iter().zip(&self.blockers).find(|(known, _)| **known == blocker);
        held.and_then(|(_, held)| held.as_ref())
    }
}

pub(super) fn same(a: &State, b: &State) -> bool {
    a.conf_l == b.conf_l
        && a.conf_j == b.conf_j
        && a.grip == b.grip
        && a.blockers.iter().zip(&b.blockers).all(|(a, b)| a.is_some() == b.is_some())
        && a.slots.iter().zip(&b.slots).all(|(a, b)| {
            a.at_entry == b.at_entry
                && a.found == b.found
                && a.read == b.read
                && a.of_file.is_some() == b.of_file.is_some()
                && a.value.same(&b.value)
        })
}

pub(super) fn same_or_none(a: Option<&State>, b: Option<&State>) -> bool {
    match (a, b) {
        (None, None) => true,
        (Some(a), Some(b)) => same(a, b),
        _ => false,
    }
}

pub(super) fn lose(state: &mut State, effects: &RoutineEffects, why: &Why) {
    for slot in effects.slots.iter() {
        if let Some(slot) = state.slots.get_mut(slot) {
            slot.value = Value::Unknown(why.clone());
            slot.found = true;
            slot.read = HeldParts::ALL;
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

pub(super) fn unknown(reason: &str) -> Why {
    Rc::new(SkipReason { code: "keep::runtime-target", reason: reason.into(), because: None })
}
