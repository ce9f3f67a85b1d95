//! Loops that wait for what nothing here brings about: found, and named, instead of being run for ever.

use super::Interpreter;
use crate::code::{Arg, CompiledCall, CompiledExits, Expr, ExprKind, Instruction, NameRef, Op};
use crate::ids::{ModuleId, RoutineId};
use crate::machine::{Access, DataRef, ExitConditions};
use crate::outcome::{Fault, Outcome, SourceLine};
use crate::predefined;
use crate::value::Value;
use rapid_syntax::diagnostic::TextRange;
use std::collections::BTreeMap;
use std::rc::Rc;

/// Passes after which a loop is examined once more.
const PASSES_BETWEEN_EXAMINATIONS: u64 = 8;
/// Examinations between which nothing at all changes, after which nothing ever will.
const UNCHANGED_EXAMINATIONS: u64 = 3;
/// Passes, or moves, in which nothing changes that the loop's conditions ask for: too many for any work.
const PATIENCE: u64 = 10_000;
/// Names that a message lists at most.
const LISTED: usize = 4;

/// What is known of a loop at its back jump.
pub(super) enum LoopProgress {
    /// The loop may end.
    MayEnd,
    /// Nothing at all changes in it.
    Unchanging,
    /// Nothing changes that its conditions ask for, for long; whether it moves the arm.
    ExitUnchanging { moves: bool },
}

/// Operands of a loop's exit conditions, as they are collected.
struct ExitOperandSearch {
    operands: Vec<(Option<ModuleId>, Expr)>,
    /// Of routines that were looked at: whether they leave what calls them.
    leaving: BTreeMap<RoutineId, bool>,
}

impl ExitOperandSearch {
    fn ask(&mut self, expressions: &[Expr], of: Option<ModuleId>) {
        let mut found = Vec::new();
        expressions.iter().for_each(|expr| leaves(expr, &mut found));
        // Locals of a routine that is not in execution have no value yet.
        let is_there = |leaf: &&&Expr| of.is_none() || matches!(leaf.kind, ExprKind::Name(_));
        self.operands.extend(found.iter().filter(is_there).map(|leaf| (of, (*leaf).clone())));
    }
}

impl Interpreter<'_> {
    /// Whether the loop from `to` to the operation in work can still end; counts this pass.
    pub(super) fn loop_progress(&mut self, to: usize) -> LoopProgress {
        let Some(frame) = self.machine.stack.frames.last_mut() else { return LoopProgress::MayEnd };
        let (code, at) = (frame.code.clone(), frame.current);
        let poll = frame.polls.entry(at).or_default();
        poll.passes += 1;
        if poll.passes % PASSES_BETWEEN_EXAMINATIONS != 0 {
            return LoopProgress::MayEnd;
        }
        let mut operands = Vec::new();
        conditions(code.instructions.get(to..=at).unwrap_or_default(), &mut operands);
        let values: Vec<Option<Value>> = operands.into_iter().map(|leaf| self.present(leaf)).collect();
        let (changes, moves) = (self.machine.changes, self.machine.limits.moves_made);
        let q_rad = self.arm.as_ref().and_then(|arm| arm.q_rad());
        let timer = self.machine.interrupts.list.iter().any(|interrupt| interrupt.timer.is_some());
        let frame = self.machine.stack.frames.last_mut();
        let Some(poll) = frame.and_then(|frame| frame.polls.get_mut(&at)) else {
            return LoopProgress::MayEnd;
        };
        let is_still = !timer && (poll.changes, poll.q_rad) == (Some(changes), q_rad);
        poll.still = if is_still { poll.still + 1 } else { 0 };
        (poll.changes, poll.q_rad) = (Some(changes), q_rad);
        if poll.values != values {
            (poll.values, poll.since) = (values, [poll.passes, moves]);
        }
        if poll.still >= UNCHANGED_EXAMINATIONS {
            LoopProgress::Unchanging
        } else if poll.passes - poll.since[0] >= PATIENCE || moves - poll.since[1] >= PATIENCE {
            LoopProgress::ExitUnchanging { moves: moves > poll.since[1] }
        } else {
            LoopProgress::MayEnd
        }
    }

    /// Whether, since the last pass of the loop that begins at `top`, an operand has changed of the conditions on which it
    /// is left from inside: a loop whose exits ask for what stays as it is counts as endless.
    pub(super) fn exit_operands_changed(&mut self, top: usize) -> bool {
        let Some(frame) = self.machine.stack.frames.last() else { return false };
        let Some(operands) =
            frame.exit_conditions.get(&top).map(|exit_conditions| exit_conditions.operands.clone())
        else {
            return false;
        };
        let now = self.operand_values(&operands);
        let Some(frame) = self.machine.stack.frames.last_mut() else { return false };
        let Some(exit_conditions) = frame.exit_conditions.get_mut(&top) else { return false };
        std::mem::replace(&mut exit_conditions.values, now.clone()) != now
    }

    /// The conditions on which the loop that begins here is left from inside, by itself or by what it calls.
    pub(super) fn exit_conditions(&mut self, exits: &CompiledExits) -> ExitConditions {
        let mut search = ExitOperandSearch { operands: Vec::new(), leaving: BTreeMap::new() };
        self.collect_exit_operands(exits, (self.machine.stack.scope.0, None), &mut search);
        let operands: Rc<[_]> = search.operands.into();
        let values = self.operand_values(&operands);
        ExitConditions { operands, values }
    }

    /// Collects the operands of the exit conditions of a body whose names are those of a module, and of what it calls; whether
    /// there is an exit. Names are looked up in `of`, `None` for those of the routine in execution.
    fn collect_exit_operands(
        &self,
        exits: &CompiledExits,
        (module, of): (Option<ModuleId>, Option<ModuleId>),
        search: &mut ExitOperandSearch,
    ) -> bool {
        search.ask(&exits.exit_conditions, of);
        let mut leaves = exits.leaves;
        for CompiledCall { name, exit_conditions: way } in &exits.calls {
            let Some(callee) = self.program.routine(module, name) else { continue };
            let known = search.leaving.get(&callee).copied();
            let callee_leaves = known.unwrap_or_else(|| {
                search.leaving.insert(callee, false); // a circle of calls adds nothing
                let Some(code) = self.program.code(callee) else { return false };
                let Some(home) = self.program.module_of(callee) else { return false };
                let leaves = self.collect_exit_operands(&code.exits, (Some(home), Some(home)), search);
                search.leaving.insert(callee, leaves);
                leaves
            });
            if callee_leaves {
                leaves = true;
                search.ask(way, of);
            }
        }
        leaves
    }

    /// The present values of operands.
    fn operand_values(&mut self, operands: &[(Option<ModuleId>, Expr)]) -> Vec<Option<Value>> {
        let one = |(module, leaf): &(Option<ModuleId>, Expr)| match module {
            None => self.present(leaf),
            Some(module) => self.in_module(*module, |c| c.present(leaf)),
        };
        operands.iter().map(one).collect()
    }

    /// The end of a run in a loop that waits in vain: the loop from `to` to the operation in work.
    pub(super) fn endless(&self, to: usize) -> Fault {
        let Some(frame) = self.machine.stack.frames.last() else {
            return Fault::Ended(Outcome::OutOfSteps { at: SourceLine::default(), moving: false });
        };
        let body = frame.code.instructions.get(to..=frame.current).unwrap_or_default();
        let mut operands = Vec::new();
        conditions(body, &mut operands);
        let mut names: Vec<String> = Vec::new();
        for leaf in operands {
            if let ExprKind::Name(NameRef { name, spelt, .. }) = &leaf.kind
                && !self.is_constant(name)
                && !names.iter().any(|known| known.eq_ignore_ascii_case(spelt))
            {
                names.push(spelt.to_string());
            }
        }
        names.truncate(LISTED);
        let first = body.first().map_or(TextRange::empty(0), |instruction| instruction.range);
        Fault::Ended(Outcome::Endless { at: self.program.source_line(frame.module, first), names })
    }

    fn is_constant(&self, name: &str) -> bool {
        let datum = self.program.datum(self.machine.stack.scope.0, name);
        let is_predefined = predefined::constant(&self.program.types, name).is_some();
        datum.map_or(is_predefined, |datum| self.access(&DataRef::data(datum)) == Access::Constant)
    }

    /// The present value of a name or a local; `None` where that takes work to find out.
    fn present(&mut self, leaf: &Expr) -> Option<Value> {
        if let ExprKind::Name(NameRef { name, .. }) = &leaf.kind
            && let Some(level) = self.machine.signals.levels.get(name)
        {
            return Some(Value::Num(*level));
        }
        let (place, _) = self.data_ref(leaf).ok()??;
        self.read(&place).ok()
    }
}

/// What the conditions of some operations ask for.
fn conditions<'c>(body: &'c [Instruction], operands: &mut Vec<&'c Expr>) {
    for instruction in body {
        match &instruction.op {
            Op::JumpUnless(condition, _) => leaves(condition, operands),
            Op::Store(_, value) => leaves(value, operands),
            _ => {}
        }
    }
}

/// The names, locals, components and elements that an expression asks for.
fn leaves<'e>(expr: &'e Expr, found: &mut Vec<&'e Expr>) {
    match &expr.kind {
        ExprKind::Local(_) | ExprKind::Name(..) => found.push(expr),
        ExprKind::Field(base, _) => leaves(base, found),
        ExprKind::Index(base, indices) => {
            leaves(base, found);
            indices.iter().for_each(|index| leaves(index, found));
        }
        ExprKind::Aggregate(parts) => parts.iter().for_each(|part| leaves(part, found)),
        ExprKind::Unary(_, inner) => leaves(inner, found),
        ExprKind::Binary(_, a, b) => {
            leaves(a, found);
            leaves(b, found);
        }
        ExprKind::Call(call) => {
            for argument in &call.args {
                match argument {
                    Arg::Positional(e) | Arg::Named(_, e) | Arg::Conditional(_, e) => leaves(e, found),
                    Arg::Switch(_) => {}
                }
            }
        }
        ExprKind::Number(_) | ExprKind::Str(_) | ExprKind::Bool(_) | ExprKind::Opaque => {}
    }
}
