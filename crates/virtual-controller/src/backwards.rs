//! Stopping in the middle of a program and stepping back through it, as on a pendant.
//!
//! Backwards a routine is a list of statements: a move takes the arm to where the move before it ends, whose
//! argument is evaluated anew; other instructions are passed over without effect, what they did (a gripper that was
//! closed) stays done. What branches or jumps is not gone through backwards, and neither is a procedure without
//! BACKWARD section. An arc is gone back on the straight line.

use super::ids::RoutineId;
use crate::builtin::moves::{self, MoveForm};
use crate::code::{Call, Callee, Code, Op};
use crate::interpreter::Interpreter;
use crate::outcome::Fault;
use std::rc::Rc;

/// What one step back did.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BackStep {
    /// The arm went back to where it was before a move.
    Moved,
    /// An instruction was passed over, or a procedure gone through by its BACKWARD section.
    Passed,
    /// It does not go on backwards, for this reason; program and arm stay where they are.
    Refused(String),
}

fn refused(why: impl Into<String>) -> Result<BackStep, Fault> {
    Ok(BackStep::Refused(why.into()))
}

impl Interpreter<'_> {
    /// Goes through the statement before the one at which the program is stopped, backwards.
    pub(crate) fn step_back(&mut self) -> BackStep {
        let stopped = self.machine.stack.mark();
        let before = self.machine.stack.frames.last().map(|f| (f.pc, f.current));
        let step = self.try_step_back().unwrap_or_else(|fault| {
            BackStep::Refused(match fault {
                Fault::Raised { text, .. } | Fault::Fatal(text) => text,
                Fault::Ended(_) => "the run ends there".to_owned(),
            })
        });
        self.machine.stack.unwind_to(stopped);
        if let (Some(frame), Some((pc, current))) = (self.machine.stack.frames.last_mut(), before) {
            (frame.pc, frame.current) = match step {
                BackStep::Refused(_) => (pc, current),
                _ => (pc - 1, pc - 1),
            };
        }
        step
    }

    fn try_step_back(&mut self) -> Result<BackStep, Fault> {
        let Some(frame) = self.machine.stack.frames.last() else { return refused("no program is stopped") };
        let (code, pc) = (frame.code.clone(), frame.pc);
        let Some(at) = pc.checked_sub(1) else { return refused("the routine begins here") };
        let Some(op) = before(&code, pc) else {
            return refused("IF, FOR, WHILE, TEST and GOTO are not gone through backwards");
        };
        let Op::Call(call) = op else { return Ok(BackStep::Passed) };
        let Callee::Name(name, spelt) = &call.callee else {
            return refused("a procedure called by late binding is not gone through backwards");
        };
        if let Some(routine) = self.program.routine(self.machine.stack.scope.0, name) {
            return self.go_back_through(routine, spelt, call);
        }
        match moves::form(name) {
            Some(form) => self.move_back(&code, at, &form),
            None => Ok(BackStep::Passed),
        }
    }

    /// A procedure has its BACKWARD section executed.
    fn go_back_through(&mut self, routine: RoutineId, spelt: &str, call: &Call) -> Result<BackStep, Fault> {
        let Some(start) = self.code(routine)?.backward else {
            return refused(format!("{spelt} has no BACKWARD section"));
        };
        let depth = self.machine.stack.frames.len();
        let slots = self.bind(routine, call)?;
        self.enter(routine, slots, false)?;
        if let Some(frame) = self.machine.stack.frames.last_mut() {
            frame.pc = start;
        }
        self.run(depth)?;
        Ok(BackStep::Passed)
    }

    /// Go to where the move before the one at `at` ends.
    fn move_back(&mut self, code: &Rc<Code>, at: usize, later: &MoveForm) -> Result<BackStep, Fault> {
        let mut pc = at;
        loop {
            if pc == 0 {
                return refused("no move of this routine stands before it");
            }
            let Some(op) = before(code, pc) else {
                return refused("the move before it depends on an IF, FOR, WHILE, TEST or GOTO");
            };
            pc -= 1;
            let Op::Call(call) = op else { continue };
            let Callee::Name(name, spelt) = &call.callee else {
                return refused("a procedure called by late binding stands before it");
            };
            if let Some(routine) = self.program.routine(self.machine.stack.scope.0, name) {
                if self.has_moves(routine)? {
                    return refused(format!("it begins where {spelt} ended"));
                }
                continue;
            }
            let Some(form) = moves::form(name) else { continue };
            if let Some(frame) = self.machine.stack.frames.last_mut() {
                frame.current = pc;
            }
            let (form, args) = (form.back_from(later), self.args(name, call));
            self.metered(|c| moves::execute(c, &form, &args))?;
            return Ok(BackStep::Moved);
        }
    }

    /// Whether a procedure moves the arm, itself or by what it calls.
    fn has_moves(&mut self, routine: RoutineId) -> Result<bool, Fault> {
        let mut seen = vec![routine];
        let mut next = 0;
        while let Some(&routine) = seen.get(next) {
            next += 1;
            let module = self.program.module_of(routine);
            for instruction in &self.code(routine)?.instructions {
                let Op::Call(call) = &instruction.op else { continue };
                let Callee::Name(name, _) = &call.callee else { return Ok(true) };
                match self.program.routine(module, name) {
                    Some(inner) if !seen.contains(&inner) => seen.push(inner),
                    Some(_) => {}
                    None if moves::form(name).is_some() => return Ok(true),
                    None => {}
                }
            }
        }
        Ok(false)
    }
}

/// The operation before `pc`, where control can have come from nowhere else.
fn before(code: &Code, pc: usize) -> Option<&Op> {
    let lands_here = |op: &Op| match op {
        Op::Jump(to) | Op::LoopBack(to) | Op::JumpUnless(_, to) | Op::JumpIfIn(_, _, to) => *to == pc,
        Op::ForTest { exit, .. } => *exit == pc,
        Op::ForStep { top, .. } => *top == pc,
        _ => false,
    };
    if code.instructions.iter().any(|s| lands_here(&s.op)) {
        return None;
    }
    match &code.instructions.get(pc.checked_sub(1)?)?.op {
        op @ (Op::Assign(..) | Op::Call(_) | Op::Connect(..) | Op::Unknown(_)) => Some(op),
        _ => None,
    }
}
