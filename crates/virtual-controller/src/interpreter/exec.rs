//! Execution of statements: one operation after another, errors to their handlers, interrupts between.

use super::Interpreter;
use super::endless::LoopProgress;
use crate::code::{Call, Callee, Code, Expr, Op};
use crate::ids::RoutineId;
use crate::loaded::RoutineKind;
use crate::machine::{Binding, Frame, LimitReached, Slot};
use crate::outcome::{Fault, Outcome, fatal, raise};
use crate::predefined;
use crate::value::{Type, Value};
use rapid_syntax::tree::DataKind;
use std::collections::BTreeMap;
use std::rc::Rc;

/// Functions in execution inside expressions of one another.
const MAX_NESTED_FUNCTIONS: usize = 40;
/// Passes of an endless loop inside another one, or of a routine called by one, before the run ends.
const INNER_PASSES: u64 = 10_000;
/// Passes of a loop that is about to be left from inside, as far as can be told.
const LEAVING_PASSES: u64 = 1_000;

impl Interpreter<'_> {
    /// Execute until only `base` routines are left in execution.
    pub(crate) fn run(&mut self, base: usize) -> Result<(), Fault> {
        while self.machine.stack.frames.len() > base {
            self.machine.limits.next_step(base == 0).map_err(|limit| match limit {
                LimitReached::Moves => Fault::Ended(Outcome::Stopped),
                LimitReached::Steps { moving } => {
                    Fault::Ended(Outcome::OutOfSteps { at: self.here(), moving })
                }
            })?;
            let step_s = self.machine.calendar.step_s;
            self.machine.calendar.advance_s(step_s);
            self.interrupt()?;
            let Some(frame) = self.machine.stack.frames.last_mut() else { break };
            let code = frame.code.clone();
            let Some(step) = code.instructions.get(frame.pc) else {
                self.leave();
                continue;
            };
            frame.current = frame.pc;
            frame.pc += 1;
            self.machine.meter.total.statements += u64::from(step.counts);
            match self.operation(&step.op) {
                Ok(()) => {}
                Err(Fault::Raised { number, text, at }) => {
                    let at = at.or_else(|| Some(self.here()));
                    self.recover(Fault::Raised { number, text, at }, base)?;
                }
                Err(fault) => return Err(fault),
            }
        }
        Ok(())
    }

    fn operation(&mut self, op: &Op) -> Result<(), Fault> {
        match op {
            Op::Assign(target, value) => self.assign(target, value),
            Op::Call(call) => match &call.callee {
                Callee::Name(name, spelt) => self.call_procedure(name, spelt, call),
                Callee::Late(expr) => self.call_late(expr, call),
            },
            Op::Jump(to) => {
                let is_back = self.machine.stack.frames.last().is_some_and(|frame| *to <= frame.current);
                if is_back && !matches!(self.loop_progress(*to), LoopProgress::MayEnd) {
                    return Err(self.endless(*to));
                }
                self.machine.stack.jump(*to);
                Ok(())
            }
            Op::LoopEnter(exits) => {
                let exit_conditions = self.exit_conditions(exits);
                if let Some(frame) = self.machine.stack.frames.last_mut() {
                    frame.exit_conditions.insert(frame.current, exit_conditions);
                }
                Ok(())
            }
            Op::LoopBack(to) => self.loop_back(*to),
            Op::JumpUnless(cond, to) => {
                if !self.eval_bool(cond)? {
                    self.machine.stack.jump(*to);
                }
                Ok(())
            }
            Op::ForInit { .. } | Op::ForTest { .. } | Op::ForStep { .. } => self.for_operation(op),
            Op::Store(slot, expr) => {
                let value = match self.eval(expr, None)? {
                    Value::Literal(x) => Value::num(x),
                    value => value,
                };
                self.machine.stack.set_local(*slot, value);
                Ok(())
            }
            Op::JumpIfIn(slot, values, to) => self.jump_if_in(*slot, values, *to),
            Op::Return(value) => self.leave_with(value.as_ref()),
            Op::Raise(number) => self.raise_again(number.as_ref()),
            Op::Retry | Op::TryNext => self.resume(matches!(op, Op::Retry)),
            Op::Exit => Err(Fault::Ended(Outcome::Exited)),
            Op::Connect(interrupt, trap) => self.connect(interrupt, trap),
            Op::Unknown(text) => {
                self.machine.log.unknown.insert(text.to_string());
                Ok(())
            }
            Op::End => self.end_of_routine(),
        }
    }

    /// Calls the procedure whose name an expression gives.
    fn call_late(&mut self, expr: &Expr, call: &Call) -> Result<(), Fault> {
        let name = self.eval(expr, Some(&Type::Str))?;
        let Some(name) = name.string().map(str::to_lowercase) else {
            return fatal("late binding with something that is no string");
        };
        if self.program.routine(self.machine.stack.scope.0, &name).is_none() {
            return raise("err_refunkprc", format!("no procedure {name}"));
        }
        self.call_procedure(&name.as_str().into(), &name, call)
    }

    /// The beginning, the test and the step of a FOR.
    fn for_operation(&mut self, op: &Op) -> Result<(), Fault> {
        match op {
            Op::ForInit { var, end, step, from, to, by } => {
                let (from, to) = (self.eval_num(from)?, self.eval_num(to)?);
                let by = match by {
                    Some(by) => self.eval_num(by)?,
                    None if from > to => -1.0,
                    None => 1.0,
                };
                self.machine.stack.set_local(*var, Value::Num(from));
                self.machine.stack.set_local(*end, Value::Num(to));
                self.machine.stack.set_local(*step, Value::Num(by));
            }
            Op::ForTest { var, end, step, exit } => {
                let (at, end, by) = (
                    self.machine.stack.local_num(*var),
                    self.machine.stack.local_num(*end),
                    self.machine.stack.local_num(*step),
                );
                if (by >= 0.0 && at > end) || (by < 0.0 && at < end) {
                    self.machine.stack.jump(*exit);
                }
            }
            Op::ForStep { var, step, top } => {
                let next = self.machine.stack.local_num(*var) + self.machine.stack.local_num(*step);
                self.machine.stack.set_local(*var, Value::Num(next));
                self.machine.stack.jump(*top);
            }
            _ => {}
        }
        Ok(())
    }

    fn assign(&mut self, target: &Expr, value: &Expr) -> Result<(), Fault> {
        if self.assign_num(target, value) {
            return Ok(());
        }
        let Some((place, ty)) = self.data_ref(target)? else {
            return fatal("an assignment to something that is declared nowhere");
        };
        let value = self.eval(value, Some(&ty))?;
        self.write(&place, value)
    }

    fn jump_if_in(&mut self, slot: usize, values: &[Expr], to: usize) -> Result<(), Fault> {
        let kept = match self.machine.stack.local(slot) {
            Some(Binding::Own(value)) => value.clone(),
            _ => return fatal("TEST without value"),
        };
        for value in values {
            let value = self.eval(value, None)?;
            let same = match (kept.number(), value.number()) {
                (Some(a), Some(b)) => a == b,
                (None, None) if kept.type_name() == value.type_name() => kept == value,
                _ => return fatal(format!("a CASE of another type than the {}", kept.type_name())),
            };
            if same {
                self.machine.stack.jump(to);
                return Ok(());
            }
        }
        Ok(())
    }

    /// Count a pass of an endless loop; the outermost one ends the run when there were enough.
    fn loop_back(&mut self, to: usize) -> Result<(), Fault> {
        let inside = self.machine.stack.frames.iter().any(inside_loop);
        let allowed = self.machine.limits.passes;
        if inside {
            match self.loop_progress(to) {
                LoopProgress::MayEnd => {}
                LoopProgress::ExitUnchanging { moves: true } => return Err(Fault::Ended(Outcome::Passes)),
                LoopProgress::Unchanging | LoopProgress::ExitUnchanging { moves: false } => {
                    return Err(self.endless(to));
                }
            }
        }
        let exit_operands_changed = self.exit_operands_changed(to);
        let Some(frame) = self.machine.stack.frames.last_mut() else { return Ok(()) };
        let at = frame.current;
        let passes = frame.passes.entry(at).or_insert(0);
        *passes += 1;
        let allowed = if exit_operands_changed { allowed.max(LEAVING_PASSES) } else { allowed };
        if *passes >= if inside { allowed.max(INNER_PASSES) } else { allowed } {
            return Err(Fault::Ended(Outcome::Passes));
        }
        // A loop is entered once, however often it is passed.
        frame.pc = to + usize::from(frame.exit_conditions.contains_key(&to));
        Ok(())
    }

    /// Put a routine with its slots on the stack and evaluate its declarations.
    pub(crate) fn enter(&mut self, routine: RoutineId, slots: Vec<Slot>, trap: bool) -> Result<(), Fault> {
        if self.machine.stack.frames.len() >= 500 {
            return fatal("the chain of calls is too deep");
        }
        let code = self.code(routine)?;
        let Some(module) = self.program.module_of(routine) else { return fatal("no such routine") };
        let base = self.machine.stack.slots.len();
        let handed_over = slots.iter().map(Slot::values).sum::<u64>();
        self.reserve_values("what is handed over", handed_over)?;
        let values = self.machine.stack.values() + handed_over;
        self.machine.stack.slots.extend(slots);
        self.machine.stack.slots.resize_with(base + code.slots, || Slot::local(Type::Num));
        self.machine.stack.frames.push(Frame {
            routine,
            module,
            code: code.clone(),
            base,
            pc: 0,
            current: 0,
            failed: None,
            trap,
            values,
            effort: self.machine.meter.total,
            passes: BTreeMap::new(),
            exit_conditions: BTreeMap::new(),
            polls: BTreeMap::new(),
        });
        self.machine.stack.scope = (Some(module), base);
        for decl in &code.decls {
            let ty = self.program.type_named(Some(module), &decl.type_name).array_of(decl.dims.len());
            let value = self.declared_value("a local", &ty, &decl.dims, decl.init.as_ref())?;
            if let Some(frame) = self.machine.stack.frames.last_mut() {
                frame.values += value.values();
            }
            if let Some(slot) = self.machine.stack.slots.get_mut(base + decl.slot) {
                slot.constant = decl.kind == DataKind::Const;
                slot.ty = ty;
                slot.binding = Binding::Own(value);
            }
        }
        Ok(())
    }

    /// The executable form of a routine, made when it is first called.
    pub(crate) fn code(&self, routine: RoutineId) -> Result<Rc<Code>, Fault> {
        match self.program.code(routine) {
            Some(code) => Ok(code),
            None => fatal("no such routine"),
        }
    }

    /// Take the innermost routine off the stack.
    fn leave(&mut self) {
        if let Some(frame) = self.machine.stack.pop()
            && frame.trap
        {
            self.machine.meter.total = frame.effort;
        }
    }

    fn leave_with(&mut self, value: Option<&Expr>) -> Result<(), Fault> {
        let routine = self.machine.stack.frames.last().and_then(|f| self.program.kind(f.routine));
        let kind = routine.cloned();
        self.machine.stack.returned = match (kind, value) {
            (Some(RoutineKind::Func(ty)), Some(value)) => Some(self.eval_as(value, &ty)?),
            (Some(RoutineKind::Func(_)), None) => return fatal("RETURN without value in a function"),
            (_, Some(_)) => return fatal("RETURN with a value in a procedure"),
            (_, None) => None,
        };
        self.leave();
        Ok(())
    }

    fn end_of_routine(&mut self) -> Result<(), Fault> {
        let routine = self.machine.stack.frames.last().and_then(|f| self.program.kind(f.routine));
        if let Some(RoutineKind::Func(_)) = routine {
            return fatal("the end of a function is reached without RETURN");
        }
        self.leave();
        Ok(())
    }

    /// Hand an error to the innermost routine that has a handler for it.
    fn recover(&mut self, fault: Fault, base: usize) -> Result<(), Fault> {
        let Fault::Raised { number, .. } = &fault else { return Err(fault) };
        let number = *number;
        while self.machine.stack.frames.len() > base {
            let Some(frame) = self.machine.stack.frames.last() else { break };
            if frame.failed.is_some() || frame.trap {
                // "Errors within an error clause are always propagated to the system error handler."
                return Err(Fault::Ended(self.outcome(fault)));
            }
            let code = frame.code.clone();
            for (numbers, start) in &code.handlers {
                let mut meant = numbers.is_empty();
                for n in numbers {
                    meant |= self.eval_num(n)? == number;
                }
                if meant && let Some(frame) = self.machine.stack.frames.last_mut() {
                    frame.failed = Some(frame.current);
                    frame.pc = *start;
                    self.machine.errors.errno = number;
                    return Ok(());
                }
            }
            self.leave();
        }
        Err(fault)
    }

    /// RAISE: in a routine's statements to its own handler, in its handler to the caller's.
    fn raise_again(&mut self, number: Option<&Expr>) -> Result<(), Fault> {
        let at = Some(self.here());
        let in_handler = self.machine.stack.frames.last().is_some_and(|f| f.failed.is_some());
        let number = match number {
            Some(n) => self.eval_num(n)?,
            None if in_handler => self.machine.errors.errno,
            None => return fatal("RAISE without number outside of an ERROR handler"),
        };
        if in_handler {
            self.leave();
        }
        let text = match predefined::error_name(number) {
            Some(name) => format!("{} was raised", name.to_uppercase()),
            None => format!("error number {number} was raised"),
        };
        Err(Fault::Raised { number, text, at })
    }

    fn resume(&mut self, again: bool) -> Result<(), Fault> {
        let Some(frame) = self.machine.stack.frames.last_mut() else { return Ok(()) };
        let Some(failed) = frame.failed.take() else {
            return fatal("RETRY or TRYNEXT outside of an ERROR handler");
        };
        frame.pc =
            if again { failed } else { frame.code.instructions.get(failed).map_or(failed, |s| s.next) };
        Ok(())
    }

    /// Call a function of the program in an expression.
    pub(crate) fn run_function(&mut self, routine: RoutineId, slots: Vec<Slot>) -> Result<Value, Fault> {
        let base = self.machine.stack.frames.len();
        let functions =
            self.machine.stack.frames.iter().filter(|f| self.program.is_function(f.routine)).count();
        if functions >= MAX_NESTED_FUNCTIONS {
            return fatal("functions call one another too deep");
        }
        self.measured(routine, |c| c.enter(routine, slots, false).and_then(|()| c.run(base)))?;
        match self.machine.stack.returned.take() {
            Some(value) => Ok(value),
            None => fatal("a function without value"),
        }
    }
}

/// Whether the operation in work stands in the body of an endless loop, its own back jump not counted.
fn inside_loop(frame: &Frame) -> bool {
    let mut later = frame.code.instructions.iter().skip(frame.current + 1);
    later.any(|s| matches!(s.op, Op::LoopBack(top) if top <= frame.current))
}
