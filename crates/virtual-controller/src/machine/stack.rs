//! The call stack: routines in execution, their parameters and locals.

use super::DataRef;
use crate::code::{Code, Expr, Name};
use crate::effort::Effort;
use crate::ids::{ModuleId, RoutineId};
use crate::value::{Type, Value};
use std::collections::BTreeMap;
use std::rc::Rc;

/// A parameter, local or hidden value of a routine in execution.
#[derive(Clone, Debug)]
pub(crate) struct Slot {
    pub ty: Type,
    pub constant: bool,
    pub binding: Binding,
}

impl Slot {
    /// A local that holds the initial value of its type.
    pub(crate) fn local(ty: Type) -> Self {
        Self { binding: Binding::Own(ty.initial()), ty, constant: false }
    }

    /// How many single values it holds itself.
    pub(crate) fn values(&self) -> u64 {
        match &self.binding {
            Binding::Own(value) => value.values(),
            Binding::Ref(_) | Binding::Signal(_) | Binding::Absent => 0,
        }
    }
}

/// What a slot holds.
#[derive(Clone, Debug)]
pub(crate) enum Binding {
    Own(Value),
    /// Data of the caller or of a module.
    Ref(DataRef),
    Signal(Name),
    /// An optional parameter that was not given.
    Absent,
}

/// A routine in execution.
#[derive(Debug)]
pub(crate) struct Frame {
    pub routine: RoutineId,
    pub module: ModuleId,
    pub code: Rc<Code>,
    pub base: usize,
    pub pc: usize,
    /// The instruction in work.
    pub current: usize,
    /// In its ERROR handler: the instruction that failed.
    pub failed: Option<usize>,
    pub trap: bool,
    /// Single values of its parameters and locals and of the routines that it was called by.
    pub values: u64,
    /// What had been executed when it was entered: what a trap does is not part of what it interrupts.
    pub effort: Effort,
    /// Passes of each endless loop, by the instruction that jumps back.
    pub passes: BTreeMap<usize, u64>,
    /// What decides whether a loop is left, when its present pass began, by the loop's first instruction.
    pub exit_conditions: BTreeMap<usize, ExitConditions>,
    /// What is known of each loop that may wait in vain, by the instruction that jumps back.
    pub polls: BTreeMap<usize, WaitLoop>,
}

/// What decides whether a loop is left from inside.
#[derive(Debug)]
pub(crate) struct ExitConditions {
    /// The names that it hangs on, each with the module in which it is looked up; `None`: in the loop's own routine.
    pub operands: Rc<[(Option<ModuleId>, Expr)]>,
    /// Their values when the present pass began; `None` where that takes work to find out.
    pub values: Vec<Option<Value>>,
}

/// A loop that may wait for what never comes.
#[derive(Debug, Default)]
pub(crate) struct WaitLoop {
    pub passes: u64,
    /// What its conditions asked for when it was last looked at.
    pub values: Vec<Option<Value>>,
    /// Passes and moves when that changed last.
    pub since: [u64; 2],
    /// Changes of data and signals, and the arm's joints, when it was last looked at.
    pub changes: Option<u64>,
    pub q_rad: Option<[f64; 6]>,
    /// Looks since when nothing at all has changed.
    pub still: u64,
}

/// Routines in execution, the innermost last.
#[derive(Debug)]
pub(crate) struct CallStack {
    pub frames: Vec<Frame>,
    pub slots: Vec<Slot>,
    /// Module and first slot that names are looked up in; without a module those of the controller alone.
    pub scope: (Option<ModuleId>, usize),
    /// What the function that ended last gave.
    pub returned: Option<Value>,
    /// Expressions and function calls in evaluation inside one another.
    pub nesting: usize,
}

/// No module, no slot: names of the controller alone.
const OUTSIDE: (Option<ModuleId>, usize) = (None, 0);

impl Default for CallStack {
    fn default() -> Self {
        Self { frames: Vec::new(), slots: Vec::new(), scope: OUTSIDE, returned: None, nesting: 0 }
    }
}

/// How high the stack was at some time, to come back to.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StackMark {
    pub frames: usize,
    slots: usize,
    scope: (Option<ModuleId>, usize),
}

impl StackMark {
    /// No routine is in execution.
    pub(crate) fn bottom() -> Self {
        CallStack::default().mark()
    }
}

impl CallStack {
    /// No routine is in execution any more.
    pub(crate) fn clear(&mut self) {
        *self = Self::default();
    }

    /// Single values of all routines in execution.
    pub(crate) fn values(&self) -> u64 {
        self.frames.last().map_or(0, |frame| frame.values)
    }

    /// How high it is now.
    pub(crate) fn mark(&self) -> StackMark {
        StackMark { frames: self.frames.len(), slots: self.slots.len(), scope: self.scope }
    }

    /// Leaves what was entered since.
    pub(crate) fn unwind_to(&mut self, mark: StackMark) {
        self.frames.truncate(mark.frames);
        self.slots.truncate(mark.slots);
        self.scope = mark.scope;
        self.nesting = 0;
    }

    /// What a local of the routine in execution holds.
    pub(crate) fn local(&self, slot: usize) -> Option<&Binding> {
        self.slots.get(self.scope.1 + slot).map(|s| &s.binding)
    }

    /// Gives a hidden local a value.
    pub(crate) fn set_local(&mut self, slot: usize, value: Value) {
        if let Some(slot) = self.slots.get_mut(self.scope.1 + slot) {
            slot.binding = Binding::Own(value);
        }
    }

    /// The number in a hidden local, 0 where there is none.
    pub(crate) fn local_num(&self, slot: usize) -> f32 {
        match self.local(slot) {
            Some(Binding::Own(v)) => v.number().unwrap_or(0.0) as f32,
            _ => 0.0,
        }
    }

    /// The next instruction of the routine in execution is the one at `to`.
    pub(crate) fn jump(&mut self, to: usize) {
        if let Some(frame) = self.frames.last_mut() {
            frame.pc = to;
        }
    }

    /// Takes the innermost routine off.
    pub(crate) fn pop(&mut self) -> Option<Frame> {
        let frame = self.frames.pop();
        if let Some(frame) = &frame {
            self.slots.truncate(frame.base);
        }
        self.scope = self.frames.last().map_or(OUTSIDE, |f| (Some(f.module), f.base));
        frame
    }
}
