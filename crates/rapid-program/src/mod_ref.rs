//! What each routine, with those it calls, may change of what is tracked.

use super::cfg::ControlFlow;
use super::flow::{BLOCKERS, Blocker, FlowStep, every_step};
use super::ids::{IdSet, RoutineIndex, Slot, Table};
use super::value::Why;

/// What a routine and those it calls may change.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct RoutineEffects {
    pub(super) slots: IdSet<Slot>,
    pub(super) conf_l: bool,
    pub(super) conf_j: bool,
    pub(super) grip: bool,
    /// In the order of [`BLOCKERS`]: what is put in force, and by which statement.
    pub(super) blockers: [Option<Why>; BLOCKERS.len()],
    pub(super) calls: IdSet<RoutineIndex>,
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
                self.put_in_force(*hold, why);
            }
            FlowStep::Call { routines, bindings, .. } => {
                self.calls.extend(routines.iter().copied());
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
        self.slots.add_all(&other.slots);
        self.conf_l |= other.conf_l;
        self.conf_j |= other.conf_j;
        self.grip |= other.grip;
        for (blocker, also) in self.blockers.iter_mut().zip(&other.blockers) {
            if blocker.is_none() {
                blocker.clone_from(also);
            }
        }
    }

    fn put_in_force(&mut self, blocker: Blocker, why: &Why) {
        for (known, by) in BLOCKERS.iter().zip(&mut self.blockers) {
            if *known == blocker && by.is_none() {
                *by = Some(why.clone());
            }
        }
    }
}

/// What each routine and those it calls may change.
pub(super) fn routine_effects(control_flow: &ControlFlow<'_>) -> Table<RoutineIndex, RoutineEffects> {
    let mut all: Table<RoutineIndex, RoutineEffects> = Table::default();
    for cfg in &control_flow.routines {
        let mut own = RoutineEffects::default();
        for nodes in std::iter::once(&cfg.body).chain(&cfg.handlers) {
            every_step(nodes, &mut |step| own.add_step(step));
        }
        all.push(own);
    }
    loop {
        let mut changed = false;
        for id in all.ids() {
            let mut own = all[id].clone();
            for callee in all[id].calls.iter() {
                if let Some(callee) = all.get(callee) {
                    own.add(callee);
                }
            }
            changed |= own != all[id];
            all[id] = own;
        }
        if !changed {
            return all;
        }
    }
}
