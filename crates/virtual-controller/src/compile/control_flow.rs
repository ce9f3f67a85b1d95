//! Branches, loops and jumps as tests and jumps between operations; what decides whether a loop is left is looked at where it is entered.
//!
//! Knows nothing of what the other statements do.

use super::{Compiler, PendingGoto, latin1, lower_case_name};
use crate::code::{CompiledCall, CompiledExits, Expr, Op};
use crate::exits;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree;

impl Compiler<'_> {
    pub(super) fn branch(&mut self, range: TextRange, branch: &tree::IfStmt) {
        let mut ends = Vec::new();
        for (cond, body) in &branch.arms {
            let cond_range = cond.range;
            let cond = self.expr(cond);
            let test = self.push(Op::JumpUnless(cond, 0), cond_range);
            self.block(body);
            ends.push(self.push(Op::Jump(0), range));
            self.patch_jump(test);
        }
        if let Some(body) = &branch.otherwise {
            self.block(body);
        }
        ends.into_iter().for_each(|at| self.patch_jump(at));
    }

    pub(super) fn for_loop(&mut self, range: TextRange, looped: &tree::ForStmt) {
        let (slot, end, by) = (self.slot(), self.slot(), self.slot());
        let init = Op::ForInit {
            var: slot,
            end,
            step: by,
            from: self.expr(&looped.from),
            to: self.expr(&looped.to),
            by: looped.step.as_ref().map(|s| self.expr(s)),
        };
        self.push(init, range);
        let name = lower_case_name(self.file, looped.var);
        let hidden = self.scope.insert(name.clone(), slot);
        let top = self.push(Op::ForTest { var: slot, end, step: by, exit: 0 }, range);
        self.block(&looped.body);
        self.push(Op::ForStep { var: slot, step: by, top }, range);
        self.patch_jump(top);
        match hidden {
            Some(outer) => self.scope.insert(name, outer),
            None => self.scope.remove(&name),
        };
    }

    pub(super) fn while_loop(&mut self, range: TextRange, looped: &tree::WhileStmt) {
        let endless = matches!(unparen(&looped.cond).kind, tree::ExprKind::Bool(true));
        let top = self.instructions.len();
        if endless {
            self.enter_loop(&looped.body, range);
        }
        let cond = self.expr(&looped.cond);
        let test = self.push(Op::JumpUnless(cond, 0), range);
        self.block(&looped.body);
        self.push(if endless { Op::LoopBack(top) } else { Op::Jump(top) }, range);
        self.patch_jump(test);
    }

    pub(super) fn test(&mut self, range: TextRange, test: &tree::TestStmt) {
        let kept = self.slot();
        let value = self.expr(&test.value);
        self.push(Op::Store(kept, value), range);
        let mut ends = Vec::new();
        for (values, body) in &test.cases {
            let values: Vec<Expr> = values.iter().map(|v| self.expr(v)).collect();
            let hit = self.push(Op::JumpIfIn(kept, values, 0), range);
            let miss = self.push(Op::Jump(0), range);
            self.patch_jump(hit);
            self.block(body);
            ends.push(self.push(Op::Jump(0), range));
            self.patch_jump(miss);
        }
        if let Some(body) = &test.default {
            self.block(body);
        }
        ends.into_iter().for_each(|at| self.patch_jump(at));
    }

    /// A jump to a label that may stand further down: unknown until all labels are there.
    pub(super) fn goto(&mut self, range: TextRange, name: TextRange) {
        let label = lower_case_name(self.file, name);
        let at = self.push(Op::Unknown(format!("GOTO {label}").into()), range);
        self.gotos.push(PendingGoto { at, label, unconditional: self.depth == 1 });
    }

    /// Lets the jumps whose labels are there go to them.
    pub(super) fn resolve_gotos(&mut self) {
        for PendingGoto { at, label, unconditional } in std::mem::take(&mut self.gotos) {
            let (Some(&to), Some(step)) = (self.labels.get(&label), self.instructions.get_mut(at)) else {
                continue;
            };
            step.op = if to <= at && unconditional { Op::LoopBack(to) } else { Op::Jump(to) };
        }
    }

    /// Have what decides whether a loop is left from inside looked at when it is entered.
    pub(super) fn enter_loop(&mut self, body: &[tree::Stmt], range: TextRange) {
        let label = |stmt: &tree::Stmt| match stmt.kind {
            tree::StmtKind::Label(name) | tree::StmtKind::Goto(name) => {
                Some(latin1(self.file, name).to_lowercase())
            }
            _ => None,
        };
        let exits = self.exits(&exits::of_loop(body, &label));
        if !exits.exit_conditions.is_empty() || !exits.calls.is_empty() {
            self.push(Op::LoopEnter(exits.into()), range);
        }
    }

    pub(super) fn exits(&self, found: &exits::BodyExits<'_>) -> CompiledExits {
        let all = |of: &[&tree::Expr]| of.iter().map(|expr| self.expr(expr)).collect();
        let calls = found.calls.iter().map(|call| CompiledCall {
            name: lower_case_name(self.file, call.name),
            exit_conditions: all(&call.exit_conditions),
        });
        CompiledExits {
            leaves: found.leaves,
            exit_conditions: all(&found.exit_conditions),
            calls: calls.collect(),
        }
    }
}

fn unparen(expr: &tree::Expr) -> &tree::Expr {
    let mut e = expr;
    while let tree::ExprKind::Paren(inner) = &e.kind {
        e = inner;
    }
    e
}
