//! What it takes a controller to work out the argument of a motion, counted and not timed.
//!
//! Functions are evaluated when a motion is read, some motions ahead of the arm: what they do between two
//! fly-by points has to be little. Counted are the statements that are executed, those of routines called on
//! the way included, and what they calculate. Not counted are declarations (what their initial values
//! calculate is), values of module data, which a controller has since it loaded them, and interrupts.

use super::ids::RoutineId;
use std::collections::BTreeMap;

/// How much was executed, by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Statements. A condition counts each time it is looked at: of IF and of each ELSEIF, and of FOR and WHILE
    /// before every pass; TEST counts once.
    pub statements: u64,
    /// `+ - * / DIV MOD` and a sign on numbers and vectors, and functions of numbers, poses and targets such as
    /// Abs, PoseMult or CalcJointT as one each.
    pub arithmetic: u64,
    /// Sin, Cos, Tan, ASin, ACos, ATan and ATan2.
    pub trigonometric: u64,
}

impl Effort {
    fn each(self, other: Self, pick: fn(u64, u64) -> u64) -> Self {
        Self {
            statements: pick(self.statements, other.statements),
            arithmetic: pick(self.arithmetic, other.arithmetic),
            trigonometric: pick(self.trigonometric, other.trigonometric),
        }
    }
}

/// The calls of one function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EffortRange {
    /// How many there were.
    pub calls: u64,
    /// The least of each count in any call.
    pub fewest: Effort,
    /// The most of each count in any call.
    pub most: Effort,
}

/// Counts what is executed while arguments of motions are worked out.
#[derive(Debug, Default)]
pub(super) struct EffortMeter {
    /// All that was executed so far; what a function takes is a difference of it.
    pub total: Effort,
    /// What functions in arguments of motions took, by routine.
    by_routine: BTreeMap<RoutineId, EffortRange>,
    /// Arguments of a motion are being evaluated.
    pub is_on: bool,
}

impl EffortMeter {
    /// A call of a routine took what was executed since `before`.
    pub(crate) fn add_call(&mut self, routine: RoutineId, before: Effort) {
        let spent = self.total.each(before, u64::saturating_sub);
        self.by_routine
            .entry(routine)
            .and_modify(|range| {
                range.calls += 1;
                range.fewest = range.fewest.each(spent, u64::min);
                range.most = range.most.each(spent, u64::max);
            })
            .or_insert(EffortRange { calls: 1, fewest: spent, most: spent });
    }

    /// What was counted by routine since the last time this was asked for.
    pub(crate) fn take_ranges(&mut self) -> BTreeMap<RoutineId, EffortRange> {
        std::mem::take(&mut self.by_routine)
    }
}
