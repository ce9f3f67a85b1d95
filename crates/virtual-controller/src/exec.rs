//! Execution of statements: one operation after another, errors to their handlers, interrupts between.

use super::controller::{Bound, Controller, Frame};
use super::ir::{Callee, Code, Expr, Op};
use super::memory::Kind;
use super::outcome::{Fault, Outcome, fatal};

use super::predefined;
use super::value::{Type, Value};
use std::rc::Rc;

/// Functions in execution inside expressions of one another.
const DEEPEST_FUNCTIONS: usize = 40;
/// Passes of an endless loop inside another one, or of a routine called by one, before the run ends.
const INNER_PASSES: u64 = 10_000;

impl Controller {
    /// Execute until only `base` routines are left in execution.
    pub(super) fn run(&mut self, base: usize) -> Result<(), Fault> {
        while self.frames.len() > base {
            if self.steps_left == 0 {
                return Err(Fault::Ended(Outcome::OutOfSteps));
            }
            if base == 0 && self.moves_to_stop == Some(0) {
                self.moves_to_stop = None;
                return Err(Fault::Ended(Outcome::Stopped));
            }
            self.steps_left -= 1;
            let step_s = self.calendar.step_s;
            self.calendar.advance_s(step_s);
            self.interrupt()?;
            let Some(frame) = self.frames.last_mut() else { break };
            let code = frame.code.clone();
            let Some(step) = code.steps.get(frame.pc) else {
                self.leave();
                continue;
            };
            frame.current = frame.pc;
            frame.pc += 1;
            self.effort.statements += u64::from(step.counts);
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

    fn jump(&mut self, to: usize) {
        if let Some(frame) = self.frames.last_mut() {
            frame.pc = to;
        }
    }

    fn set_slot(&mut self, slot: usize, value: Value) {
        if let Some(slot) = self.stack.get_mut(self.scope.1 + slot) {
            slot.bound = Bound::Own(value);
        }
    }

    fn slot_num(&self, slot: usize) -> f32 {
        match self.stack.get(self.scope.1 + slot).map(|s| &s.bound) {
            Some(Bound::Own(v)) => v.number().unwrap_or(0.0) as f32,
            _ => 0.0,
        }
    }

    fn operation(&mut self, op: &Op) -> Result<(), Fault> {
        match op {
            Op::Assign(target, value) => self.assign(target, value),
            Op::Call(call) => match &call.callee {
                Callee::Name(name, spelt) => self.call_procedure(name, spelt, call),
                Callee::Late(expr) => {
                    let name = self.eval(expr, Some(&Type::Str))?;
                    let Some(name) = name.string().map(str::to_lowercase) else {
                        return fatal("late binding with something that is no string");
                    };
                    if self.memory.routine(self.scope.0, &name).is_none() {
                        return super::outcome::raise("err_refunkprc", format!("no procedure {name}"));
                    }
                    self.call_procedure(&name.as_str().into(), &name, call)
                }
            },
            Op::Jump(to) => {
                self.jump(*to);
                Ok(())
            }
            Op::LoopBack(to) => self.loop_back(*to),
            Op::JumpUnless(cond, to) => {
                if !self.eval_bool(cond)? {
                    self.jump(*to);
                }
                Ok(())
            }
            Op::ForInit { var, end, step, from, to, by } => {
                let (from, to) = (self.eval_num(from)?, self.eval_num(to)?);
                let by = match by {
                    Some(by) => self.eval_num(by)?,
                    None if from > to => -1.0,
                    None => 1.0,
                };
                self.set_slot(*var, Value::Num(from));
                self.set_slot(*end, Value::Num(to));
                self.set_slot(*step, Value::Num(by));
                Ok(())
            }
            Op::ForTest { var, end, step, exit } => {
                let (at, end, by) = (self.slot_num(*var), self.slot_num(*end), self.slot_num(*step));
                if (by >= 0.0 && at > end) || (by < 0.0 && at < end) {
                    self.jump(*exit);
                }
                Ok(())
            }
            Op::ForStep { var, step, top } => {
                let next = self.slot_num(*var) + self.slot_num(*step);
                self.set_slot(*var, Value::Num(next));
                self.jump(*top);
                Ok(())
            }
            Op::Keep(slot, expr) => {
                let value = match self.eval(expr, None)? {
                    Value::Literal(x) => Value::num(x),
                    value => value,
                };
                self.set_slot(*slot, value);
                Ok(())
            }
            Op::JumpIfIn(slot, values, to) => self.jump_if_in(*slot, values, *to),
            Op::Return(value) => self.leave_with(value.as_ref()),
            Op::Raise(number) => self.raise_again(number.as_ref()),
            Op::Retry | Op::TryNext => self.resume(matches!(op, Op::Retry)),
            Op::Exit => Err(Fault::Ended(Outcome::Exited)),
            Op::Connect(interrupt, trap) => self.connect(interrupt, trap),
            Op::Unknown(text) => {
                self.unknown.insert(text.to_string());
                Ok(())
            }
            Op::End => self.end_of_routine(),
        }
    }

    fn assign(&mut self, target: &Expr, value: &Expr) -> Result<(), Fault> {
        let Some((place, ty)) = self.place(target)? else {
            return fatal("an assignment to something that is declared nowhere");
        };
        let value = self.eval(value, Some(&ty))?;
        self.write(&place, value)
    }

    fn jump_if_in(&mut self, slot: usize, values: &[Expr], to: usize) -> Result<(), Fault> {
        let kept = match self.stack.get(self.scope.1 + slot).map(|s| &s.bound) {
            Some(Bound::Own(value)) => value.clone(),
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
                self.jump(to);
                return Ok(());
            }
        }
        Ok(())
    }

    /// Count a pass of an endless loop; the outermost one ends the run when there were enough.
    fn loop_back(&mut self, to: usize) -> Result<(), Fault> {
        let inside = self.frames.iter().any(inside_loop);
        let allowed = self.passes;
        let Some(frame) = self.frames.last_mut() else { return Ok(()) };
        let at = frame.current;
        let passes = frame.passes.entry(at).or_insert(0);
        *passes += 1;
        if *passes >= if inside { allowed.max(INNER_PASSES) } else { allowed } {
            return Err(Fault::Ended(Outcome::Passes));
        }
        frame.pc = to;
        Ok(())
    }

    /// Put a routine with its slots on the stack and evaluate its declarations.
    pub(super) fn enter(
        &mut self,
        routine: usize,
        slots: Vec<super::controller::Slot>,
        trap: bool,
    ) -> Result<(), Fault> {
        if self.frames.len() >= 500 {
            return fatal("the chain of calls is too deep");
        }
        let code = self.code(routine)?;
        let module = self.memory.routines.get(routine).map_or(usize::MAX, |r| r.module);
        let base = self.stack.len();
        self.stack.extend(slots);
        let own = |ty: Type| super::controller::Slot { bound: Bound::Own(ty.initial()), ty, constant: false };
        self.stack.resize_with(base + code.slots, || own(Type::Num));
        self.frames.push(Frame {
            routine,
            module,
            code: code.clone(),
            base,
            pc: 0,
            current: 0,
            failed: None,
            trap,
            effort: self.effort,
            passes: std::collections::BTreeMap::new(),
        });
        self.scope = (module, base);
        for decl in &code.decls {
            let ty = self.memory.type_named(module, &decl.type_name).array_of(decl.dims.len());
            let value = self.declared_value("a local", &ty, &decl.dims, decl.init.as_ref())?;
            if let Some(slot) = self.stack.get_mut(base + decl.slot) {
                slot.constant = decl.kind == rapid_syntax::tree::DataKind::Const;
                slot.ty = ty;
                slot.bound = Bound::Own(value);
            }
        }
        Ok(())
    }

    /// The executable form of a routine, made when it is first called.
    pub(super) fn code(&mut self, routine: usize) -> Result<Rc<Code>, Fault> {
        let Some(r) = self.memory.routines.get(routine) else { return fatal("no such routine") };
        if let Some(code) = &r.code {
            return Ok(code.clone());
        }
        let Some(module) = self.memory.modules.get(r.module) else { return fatal("no such module") };
        let Some(tree) = module.routine(r.at) else { return fatal("no such routine") };
        let code = Rc::new(super::compile::routine(&module.file, tree));
        if let Some(r) = self.memory.routines.get_mut(routine) {
            r.code = Some(code.clone());
        }
        Ok(code)
    }

    /// Take the innermost routine off the stack.
    fn leave(&mut self) {
        if let Some(frame) = self.frames.pop() {
            self.stack.truncate(frame.base);
            if frame.trap {
                self.effort = frame.effort;
            }
        }
        self.scope = self.frames.last().map_or((usize::MAX, 0), |f| (f.module, f.base));
    }

    fn leave_with(&mut self, value: Option<&Expr>) -> Result<(), Fault> {
        let routine = self.frames.last().and_then(|f| self.memory.routines.get(f.routine));
        let kind = routine.map(|r| r.kind.clone());
        self.returned = match (kind, value) {
            (Some(Kind::Func(ty)), Some(value)) => Some(self.eval_as(value, &ty)?),
            (Some(Kind::Func(_)), None) => return fatal("RETURN without value in a function"),
            (_, Some(_)) => return fatal("RETURN with a value in a procedure"),
            (_, None) => None,
        };
        self.leave();
        Ok(())
    }

    fn end_of_routine(&mut self) -> Result<(), Fault> {
        let routine = self.frames.last().and_then(|f| self.memory.routines.get(f.routine));
        if let Some(Kind::Func(_)) = routine.map(|r| &r.kind) {
            return fatal("the end of a function is reached without RETURN");
        }
        self.leave();
        Ok(())
    }

    /// Hand an error to the innermost routine that has a handler for it.
    fn recover(&mut self, fault: Fault, base: usize) -> Result<(), Fault> {
        let Fault::Raised { number, .. } = &fault else { return Err(fault) };
        let number = *number;
        while self.frames.len() > base {
            let Some(frame) = self.frames.last() else { break };
            if frame.failed.is_some() || frame.trap {
                // "Errors within an error clause are always propagated to the system error handler."
                return Err(Fault::Ended(self.failure(fault)));
            }
            let code = frame.code.clone();
            for (numbers, start) in &code.handlers {
                let mut meant = numbers.is_empty();
                for n in numbers {
                    meant |= self.eval_num(n)? == number;
                }
                if meant && let Some(frame) = self.frames.last_mut() {
                    frame.failed = Some(frame.current);
                    frame.pc = *start;
                    self.errno = number;
                    return Ok(());
                }
            }
            self.leave();
        }
        Err(fault)
    }

    fn failure(&self, fault: Fault) -> Outcome {
        match fault {
            Fault::Raised { number, text, at } => Outcome::Failed {
                error: predefined::error_name(number),
                message: text,
                at: at.unwrap_or_default(),
            },
            Fault::Fatal(message) => Outcome::Failed { error: None, message, at: self.here() },
            Fault::Ended(outcome) => outcome,
        }
    }

    /// RAISE: in a routine's statements to its own handler, in its handler to the caller's.
    fn raise_again(&mut self, number: Option<&Expr>) -> Result<(), Fault> {
        let at = Some(self.here());
        let in_handler = self.frames.last().is_some_and(|f| f.failed.is_some());
        let number = match number {
            Some(n) => self.eval_num(n)?,
            None if in_handler => self.errno,
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
        let Some(frame) = self.frames.last_mut() else { return Ok(()) };
        let Some(failed) = frame.failed.take() else {
            return fatal("RETRY or TRYNEXT outside of an ERROR handler");
        };
        frame.pc = if again { failed } else { frame.code.steps.get(failed).map_or(failed, |s| s.next) };
        Ok(())
    }

    /// Call a function of the program in an expression.
    pub(super) fn run_function(
        &mut self,
        routine: usize,
        slots: Vec<super::controller::Slot>,
    ) -> Result<Value, Fault> {
        let base = self.frames.len();
        let functions = self.frames.iter().filter(|f| self.is_function(f.routine)).count();
        if functions >= DEEPEST_FUNCTIONS {
            return fatal("functions call one another too deep");
        }
        self.measured(routine, |c| c.enter(routine, slots, false).and_then(|()| c.run(base)))?;
        match self.returned.take() {
            Some(value) => Ok(value),
            None => fatal("a function without value"),
        }
    }
}

/// Whether the operation in work stands in the body of an endless loop, its own back jump not counted.
fn inside_loop(frame: &Frame) -> bool {
    let mut later = frame.code.steps.iter().skip(frame.current + 1);
    later.any(|s| matches!(s.op, Op::LoopBack(top) if top <= frame.current))
}
