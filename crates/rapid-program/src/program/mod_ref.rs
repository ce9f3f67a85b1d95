//! What each routine, with those it calls, may change of what is tracked.

use super::cfg::ControlFlow;
use super::flow::{Blocker, FlowStep, every_step};
use super::index::RoutineIndex;
use super::value::Why;
use std::collections::{BTreeMap, BTreeSet};

/// What a routine and those it calls may change.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct RoutineEffects {
    pub(super) slots: BTreeSet<usize>,
    pub(super) conf_l: bool,
    pub(super) conf_j: bool,
    pub(super) grip: bool,
    /// What is put in force, and by which statement.
    pub(super) blockers: BTreeMap<Blocker, Why>,
    pub(super) calls: BTreeSet<RoutineIndex>,
}

impl RoutineEffects {
    /// Takes in what one step more changes.
    pub(super) fn add_step(&mut self, step: &FlowStep<'_>) {
        match step {
            FlowStep::Assign { slot, .. } | FlowStep::Invalidate { slot, .. } => {
                self.slots.insert(*slot);
            }
            FlowStep::ConfL(_) => self.conf_l = true,
            FlowStep::ConfJ(_) => self.conf_j = true,
            FlowStep::Grip(_) => self.grip = true,
            FlowStep::Blocker(hold, Some(why)) => {
                self.blockers.entry(*hold).or_insert_with(|| why.clone());
            }
            FlowStep::Call { routines, bindings, .. } => {
                self.calls.extend(routines);
                self.slots.extend(bindings.iter().map(|b| b.slot));
            }
            FlowStep::Motions { .. }
            | FlowStep::Blocker(_, None)
            | FlowStep::UnknownPosition
            | FlowStep::ExitCycle
            | FlowStep::MayFail(_) => {}
        }
    }

    /// What another changes, too; but for its calls.
    pub(super) fn add(&mut self, other: &Self) {
        self.slots.extend(&other.slots);
        self.conf_l |= other.conf_l;
        self.conf_j |= other.conf_j;
        self.grip |= other.grip;
        for (hold, why) in &other.blockers {
            self.blockers.entry(*hold).or_insert_with(|| why.clone());
        }
    }
}

/// What each routine and those it calls may change.
pub(super) fn routine_effects(control_flow: &ControlFlow<'_>) -> Vec<RoutineEffects> {
    let mut all: Vec<RoutineEffects> = Vec::with_capacity(control_flow.routines.len());
    for cfg in &control_flow.routines {
        let mut own = RoutineEffects::default();
        for nodes in std::iter::once(&cfg.body).chain(&cfg.handlers) {
            every_step(nodes, &mut |step| own.add_step(step));
        }
        all.push(own);
    }
    loop {
        let mut changed = false;
        for id in 0..all.len() {
            let mut own = all[id].clone();
            for callee in all[id].calls.clone() {
                if let Some(callee) = all.get(callee) {
                    own.add(callee);
                }
            }
            own.calls.clone_from(&all[id].calls);
            changed |= own != all[id];
            all[id] = own;
        }
        if !changed {
            return all;
        }
    }
}
