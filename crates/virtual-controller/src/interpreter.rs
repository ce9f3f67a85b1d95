//! Executes a loaded program: the only place where program, machine state and arm come together.
//!
//! What one step needs of the three is borrowed for as long as it runs; nothing is kept here.

mod arguments;
mod arithmetic;
mod call;
mod data;
mod endless;
mod eval;
mod exec;
mod outside;
mod pure;

pub(super) use arguments::Args;

use super::arm::ControllerArm;
use super::code::{Call, Name};
use super::ids::{ModuleId, RoutineId};
use super::loaded::LoadedProgram;
use super::machine::{MOST_VALUES, Machine};
use super::outcome::{Fault, Outcome, SourceLine};
use super::value::{Type, Value};
use rapid_syntax::diagnostic::TextRange;

/// What every controller executes that is not written in RAPID.
pub(super) trait BuiltIns {
    /// An instruction of the controller.
    fn instruction(
        &self,
        vm: &mut Interpreter<'_>,
        name: &Name,
        spelt: &str,
        call: &Call,
    ) -> Result<(), Fault>;

    /// A function of the controller; `want` is the type that the caller has use for.
    fn function(
        &self,
        vm: &mut Interpreter<'_>,
        name: &Name,
        spelt: &str,
        call: &Call,
        want: Option<&Type>,
    ) -> Result<Value, Fault>;

    /// Data that the system keeps, by name in lower case.
    fn system_data(&self, vm: &Interpreter<'_>, name: &str) -> Option<Value>;
}

/// A program, the state it runs in, and the arm that it moves.
pub(super) struct Interpreter<'c> {
    pub program: &'c mut LoadedProgram,
    pub machine: &'c mut Machine,
    /// `None`: it computes, keeps time and lists moves, but knows no joints.
    pub arm: Option<&'c mut ControllerArm>,
    pub built_ins: &'static dyn BuiltIns,
}

impl Interpreter<'_> {
    /// The instruction in work: file and line.
    pub(crate) fn here(&self) -> SourceLine {
        let Some(frame) = self.machine.stack.frames.last() else { return SourceLine::default() };
        self.program.source_line(frame.module, self.position())
    }

    /// Ends the run: there is more of something than this controller holds.
    pub(crate) fn over_limit<T>(&self, what: String) -> Result<T, Fault> {
        Err(Fault::Ended(Outcome::OverLimit { at: self.here(), what }))
    }

    /// Makes sure that so many single values more fit beside those that are there.
    pub(crate) fn reserve_values(&self, name: &str, more: u64) -> Result<(), Fault> {
        if self.machine.data.grown() + self.machine.stack.values() + more <= MOST_VALUES {
            return Ok(());
        }
        self.over_limit(format!("with {name} the program's data are more than {MOST_VALUES} single values"))
    }

    /// The instruction in work: its place in its file.
    pub(crate) fn position(&self) -> TextRange {
        let frame = self.machine.stack.frames.last();
        let instruction = frame.and_then(|frame| frame.code.instructions.get(frame.current));
        instruction.map_or(TextRange::empty(0), |instruction| instruction.range)
    }

    /// Shows a message at the instruction in work.
    pub(crate) fn report(&mut self, source: &'static str, text: impl Into<String>) {
        let at = self.here();
        self.machine.log.report(source, text.into(), at);
    }

    /// Evaluates arguments of a motion: calls of functions are counted.
    pub(crate) fn metered<T>(&mut self, evaluate: impl FnOnce(&mut Self) -> T) -> T {
        let before = std::mem::replace(&mut self.machine.meter.is_on, true);
        let out = evaluate(self);
        self.machine.meter.is_on = before;
        out
    }

    /// Runs a function or what calls one; counted where a motion's argument or the outside asks.
    pub(crate) fn measured<T>(&mut self, routine: RoutineId, run: impl FnOnce(&mut Self) -> T) -> T {
        if !std::mem::replace(&mut self.machine.meter.is_on, false) {
            return run(self);
        }
        let before = self.machine.meter.total;
        let out = run(self);
        self.machine.meter.is_on = true;
        self.machine.meter.add_call(routine, before);
        out
    }

    /// Does something with names looked up in a module instead of the running routine.
    fn in_module<T>(&mut self, module: ModuleId, f: impl FnOnce(&mut Self) -> T) -> T {
        let scope = (Some(module), self.machine.stack.slots.len());
        let scope = std::mem::replace(&mut self.machine.stack.scope, scope);
        let (effort, is_metered) =
            (self.machine.meter.total, std::mem::replace(&mut self.machine.meter.is_on, false));
        let out = f(self);
        self.machine.stack.scope = scope;
        // A controller has the values of module data since it loaded them: they cost nothing when asked for.
        (self.machine.meter.total, self.machine.meter.is_on) = (effort, is_metered);
        out
    }
}
