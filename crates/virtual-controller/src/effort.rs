//! What it takes a controller to work out the argument of a motion, counted and not timed.
//!
//! Functions are evaluated when a motion is read, some motions ahead of the arm: what they do between two
//! fly-by points has to be little. Counted are the statements that are executed, those of routines called on
//! the way included, and what they calculate. Not counted are declarations (what their initial values
//! calculate is), values of module data, which a controller has since it loaded them, and interrupts.

use super::controller::Controller;
use super::memory::Kind;
use std::collections::BTreeMap;

/// What was executed.
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

    /// Count a function of the controller that calculates.
    pub(super) fn count_function(&mut self, name: &str) {
        match name.strip_suffix("dnum").unwrap_or(name) {
            "sin" | "cos" | "tan" | "asin" | "acos" | "atan" | "atan2" => self.trigonometric += 1,
            _ => self.arithmetic += 1,
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

impl Controller {
    /// What the program's functions took that motions call in their arguments, or that were called from
    /// outside, by name as declared, since the last time this was asked for. What such a function calls
    /// itself is part of it; what stands in its own arguments is not.
    pub fn take_efforts(&mut self) -> BTreeMap<String, EffortRange> {
        let name = |routine: usize| self.memory.routines.get(routine).map(|r| r.name.to_string());
        let efforts = self.efforts.iter().filter_map(|(routine, range)| Some((name(*routine)?, *range)));
        let taken = efforts.collect();
        self.efforts.clear();
        taken
    }

    /// Evaluate arguments of a motion: calls of functions are counted.
    pub(super) fn metered<T>(&mut self, evaluate: impl FnOnce(&mut Self) -> T) -> T {
        let before = std::mem::replace(&mut self.is_metered, true);
        let out = evaluate(self);
        self.is_metered = before;
        out
    }

    /// Run a function or what calls one; counted where a motion's argument or the outside asks.
    pub(super) fn measured<T>(&mut self, routine: usize, run: impl FnOnce(&mut Self) -> T) -> T {
        if !std::mem::replace(&mut self.is_metered, false) {
            return run(self);
        }
        let before = self.effort;
        let out = run(self);
        self.is_metered = true;
        let spent = self.effort.each(before, u64::saturating_sub);
        self.efforts
            .entry(routine)
            .and_modify(|range| {
                range.calls += 1;
                range.fewest = range.fewest.each(spent, u64::min);
                range.most = range.most.each(spent, u64::max);
            })
            .or_insert(EffortRange { calls: 1, fewest: spent, most: spent });
        out
    }

    /// Whether a routine is a function.
    pub(super) fn is_function(&self, routine: usize) -> bool {
        matches!(self.memory.routines.get(routine).map(|r| &r.kind), Some(Kind::Func(_)))
    }
}
