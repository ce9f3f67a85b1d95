//! What each routine, with those it calls, may change of what is followed.

use super::flow::{Hold, Step, every_step};
use super::index::RoutineId;
use super::lower::Lowered;
use std::collections::BTreeSet;

/// What a routine and those it calls may change.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Touched {
    pub(super) slots: BTreeSet<usize>,
    pub(super) conf_l: bool,
    pub(super) conf_j: bool,
    pub(super) grip: bool,
    pub(super) holds: BTreeSet<Hold>,
    pub(super) calls: BTreeSet<RoutineId>,
}

impl Touched {
    /// One step more.
    pub(super) fn touch(&mut self, step: &Step<'_>) {
        match step {
            Step::Assign { slot, .. } | Step::Lose { slot, .. } => {
                self.slots.insert(*slot);
            }
            Step::ConfL(_) => self.conf_l = true,
            Step::ConfJ(_) => self.conf_j = true,
            Step::Grip(_) => self.grip = true,
            Step::Hold(hold, Some(_)) => {
                self.holds.insert(*hold);
            }
            Step::Call { routines, bindings, .. } => {
                self.calls.extend(routines);
                self.slots.extend(bindings.iter().map(|b| b.slot));
            }
            Step::Motions { .. } | Step::Hold(_, None) | Step::Away | Step::MayFail(_) => {}
        }
    }

    /// What another changes, too; but for its calls.
    pub(super) fn add(&mut self, other: &Self) {
        self.slots.extend(&other.slots);
        self.conf_l |= other.conf_l;
        self.conf_j |= other.conf_j;
        self.grip |= other.grip;
        self.holds.extend(&other.holds);
    }
}

/// What each routine and those it calls may change.
pub(super) fn touched(lowered: &Lowered<'_>) -> Vec<Touched> {
    let mut all: Vec<Touched> = Vec::with_capacity(lowered.ways.len());
    for ways in &lowered.ways {
        let mut own = Touched::default();
        for nodes in std::iter::once(&ways.body).chain(&ways.handlers) {
            every_step(nodes, &mut |step| own.touch(step));
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
