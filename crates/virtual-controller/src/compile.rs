//! From the tree of a routine to the flat form it is executed in.

mod control_flow;

use super::code::{
    Arg, Call, Callee, Code, Expr, ExprKind, Instruction, LocalDecl, Name, NameRef, Op, Param,
};
use super::exits;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree;
use rapid_syntax::{SourceFile, number_value, parts_of_numbers, string_value};
use std::cell::Cell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The bytes of a range as text, one character a byte (ISO 8859-1).
pub(super) fn latin1(file: &SourceFile, range: TextRange) -> String {
    file.text(range).iter().map(|&b| char::from(b)).collect()
}

/// The bytes of a range as a person reads them: UTF-8 where they are, else ISO 8859-1.
pub(super) fn as_written(file: &SourceFile, range: TextRange) -> String {
    std::str::from_utf8(file.text(range)).map_or_else(|_| latin1(file, range), str::to_owned)
}

/// A name in lower case.
pub(super) fn lower_case_name(file: &SourceFile, range: TextRange) -> Name {
    latin1(file, range).to_lowercase().into()
}

/// An expression outside of a routine.
pub(super) fn constant(file: &SourceFile, expr: &tree::Expr) -> Expr {
    Compiler::new(file).expr(expr)
}

/// The executable form of a routine.
pub(super) fn routine(file: &SourceFile, routine: &tree::Routine) -> Code {
    let mut c = Compiler::new(file);
    let params: Vec<Param> = routine
        .params
        .iter()
        .map(|p| {
            let name = lower_case_name(file, p.name);
            let slot = c.slot();
            c.scope.insert(name.clone(), slot);
            Param {
                name,
                optional: p.optional,
                mode: p.mode,
                type_name: lower_case_name(file, p.type_name),
                dims: usize::from(p.dims),
            }
        })
        .collect();
    c.block(&routine.body);
    c.push(Op::End, TextRange::empty(routine.range.end));
    let exits = c.exits(&exits::of_routine(&routine.body));
    let mut handlers = Vec::new();
    let mut backward = None;
    for handler in &routine.handlers {
        let at = c.instructions.len();
        match &handler.kind {
            tree::HandlerKind::Error(numbers) => {
                handlers.push((numbers.iter().map(|n| c.expr(n)).collect(), at));
            }
            tree::HandlerKind::Backward => backward = Some(at),
            tree::HandlerKind::Undo => continue,
        }
        c.block(&handler.body);
        c.push(Op::End, TextRange::empty(handler.range.end));
    }
    c.resolve_gotos();
    Code { params, decls: c.decls, slots: c.slots, instructions: c.instructions, handlers, exits, backward }
}

/// A GOTO whose label has not been looked for.
struct PendingGoto {
    /// The number of its operation.
    at: usize,
    label: Name,
    /// Whether it stands in no other statement, so that it always jumps.
    unconditional: bool,
}

struct Compiler<'f> {
    file: &'f SourceFile,
    /// Names of parameters, locals and loop variables now in sight.
    scope: BTreeMap<Name, usize>,
    slots: usize,
    decls: Vec<LocalDecl>,
    instructions: Vec<Instruction>,
    labels: BTreeMap<Name, usize>,
    gotos: Vec<PendingGoto>,
    /// How many statements stand round the present one.
    depth: usize,
}

impl<'f> Compiler<'f> {
    fn new(file: &'f SourceFile) -> Self {
        Self {
            file,
            scope: BTreeMap::new(),
            slots: 0,
            decls: Vec::new(),
            instructions: Vec::new(),
            labels: BTreeMap::new(),
            gotos: Vec::new(),
            depth: 0,
        }
    }

    fn slot(&mut self) -> usize {
        self.slots += 1;
        self.slots - 1
    }

    fn push(&mut self, op: Op, range: TextRange) -> usize {
        let at = self.instructions.len();
        let counts = !matches!(
            op,
            Op::Jump(_)
                | Op::LoopBack(_)
                | Op::LoopEnter(_)
                | Op::ForInit { .. }
                | Op::ForStep { .. }
                | Op::JumpIfIn(..)
                | Op::End
        );
        self.instructions.push(Instruction { op, range, next: at + 1, counts });
        at
    }

    /// Let the jump at `at` go to where the next operation will be.
    fn patch_jump(&mut self, at: usize) {
        let here = self.instructions.len();
        match self.instructions.get_mut(at).map(|s| &mut s.op) {
            Some(Op::Jump(to) | Op::JumpUnless(_, to) | Op::JumpIfIn(_, _, to)) => *to = here,
            Some(Op::ForTest { exit, .. }) => *exit = here,
            _ => {}
        }
    }

    fn block(&mut self, body: &[tree::Stmt]) {
        self.depth += 1;
        for (at, stmt) in body.iter().enumerate() {
            let first = self.instructions.len();
            self.statement(stmt);
            if let tree::StmtKind::Label(name) = stmt.kind
                && self.depth == 1
            {
                let again = |s: &tree::Stmt| {
                    matches!(s.kind, tree::StmtKind::Goto(to)
                        if lower_case_name(self.file, to) == lower_case_name(self.file, name))
                };
                if let Some(end) = body.iter().rposition(again).filter(|&end| end > at) {
                    self.enter_loop(&body[at..end], stmt.range);
                }
            }
            let after = self.instructions.len();
            // An error in a condition leaves its whole statement; inner statements have set theirs.
            if !matches!(stmt.kind, tree::StmtKind::Label(_))
                && let Some(step) = self.instructions.get_mut(first)
            {
                step.next = after;
            }
        }
        self.depth -= 1;
    }

    fn statement(&mut self, stmt: &tree::Stmt) {
        use tree::StmtKind as S;
        let range = stmt.range;
        match &stmt.kind {
            S::Data(decl) => self.declaration(decl),
            S::Assign(assign) => {
                let op = Op::Assign(self.expr(&assign.target), self.expr(&assign.value));
                self.push(op, range);
            }
            S::Call(call) => self.call(range, call),
            S::If(branch) => self.branch(range, branch),
            S::CompactIf(branch) => {
                let cond = self.expr(&branch.cond);
                let test = self.push(Op::JumpUnless(cond, 0), range);
                self.block(std::slice::from_ref(&branch.then));
                self.patch_jump(test);
            }
            S::For(looped) => self.for_loop(range, looped),
            S::While(looped) => self.while_loop(range, looped),
            S::Test(test) => self.test(range, test),
            S::Label(name) => {
                let at = self.instructions.len();
                self.labels.insert(lower_case_name(self.file, *name), at);
            }
            S::Goto(name) => self.goto(range, *name),
            S::Return(value) => {
                let value = value.as_ref().map(|v| self.expr(v));
                self.push(Op::Return(value), range);
            }
            S::Raise(number) => {
                let number = number.as_ref().map(|n| self.expr(n));
                self.push(Op::Raise(number), range);
            }
            S::Retry => drop(self.push(Op::Retry, range)),
            S::TryNext => drop(self.push(Op::TryNext, range)),
            S::Exit => drop(self.push(Op::Exit, range)),
            S::Connect(connect) => {
                let op = Op::Connect(self.expr(&connect.interrupt), lower_case_name(self.file, connect.trap));
                self.push(op, range);
            }
            S::Opaque | S::Placeholder => {
                let text: String = as_written(self.file, range).chars().take(60).collect();
                self.push(Op::Unknown(text.trim().into()), range);
            }
            S::Empty | S::Comment => {}
        }
    }

    fn call(&mut self, range: TextRange, call: &tree::CallStmt) {
        let callee = match &call.callee {
            tree::Callee::Name(n) => {
                Callee::Name(lower_case_name(self.file, *n), as_written(self.file, *n).into())
            }
            tree::Callee::Late(e) => Callee::Late(self.expr(e)),
        };
        let args = self.args(&call.args);
        self.push(Op::Call(Rc::new(Call { callee, args })), range);
    }

    fn declaration(&mut self, decl: &tree::DataDecl) {
        // The initial value sees the names outside, not the new one.
        let init = decl.init.as_ref().map(|e| self.expr(e));
        let dims = decl.dims.iter().map(|e| self.expr(e)).collect();
        let slot = self.slot();
        self.scope.insert(lower_case_name(self.file, decl.name), slot);
        let type_name = lower_case_name(self.file, decl.type_name);
        self.decls.push(LocalDecl { slot, kind: decl.kind, type_name, dims, init });
    }

    fn args(&self, args: &[tree::Arg]) -> Vec<Arg> {
        args.iter()
            .map(|arg| match &arg.kind {
                tree::ArgKind::Positional(e) => Arg::Positional(self.expr(e)),
                tree::ArgKind::Named { name, value: Some(e) } => {
                    Arg::Named(lower_case_name(self.file, *name), self.expr(e))
                }
                tree::ArgKind::Named { name, value: None } => Arg::Switch(lower_case_name(self.file, *name)),
                tree::ArgKind::Conditional { name, param } => {
                    Arg::Conditional(lower_case_name(self.file, *name), self.name(*param))
                }
            })
            .collect()
    }

    fn name(&self, range: TextRange) -> Expr {
        let spelt = as_written(self.file, range);
        let lower = lower_case_name(self.file, range);
        let kind = match self.scope.get(&lower) {
            Some(&slot) => ExprKind::Local(slot),
            None => ExprKind::Name(NameRef { name: lower, spelt: spelt.into(), found: Cell::new(None) }),
        };
        Expr::new(kind)
    }

    fn expr(&self, expr: &tree::Expr) -> Expr {
        use tree::ExprKind as E;
        let kind = match &expr.kind {
            E::Number => match number_value(self.file.text(expr.range)).filter(|x| x.is_finite()) {
                Some(x) => ExprKind::Number(x),
                None => ExprKind::Opaque,
            },
            E::String => {
                let bytes = string_value(self.file.text(expr.range)).unwrap_or_default();
                ExprKind::Str(bytes.into_iter().map(char::from).collect::<String>().into())
            }
            E::Bool(b) => ExprKind::Bool(*b),
            E::Name => return self.name(expr.range),
            E::Field(field) => {
                ExprKind::Field(Box::new(self.expr(&field.base)), lower_case_name(self.file, field.name))
            }
            E::Index(element) => {
                let indices = element.indices.iter().map(|i| self.expr(i)).collect();
                ExprKind::Index(Box::new(self.expr(&element.base)), indices)
            }
            E::Numbers => {
                let parts = parts_of_numbers(&self.file.bytes, expr.range);
                ExprKind::Aggregate(parts.iter().map(|p| self.expr(p)).collect())
            }
            E::Aggregate(parts) => ExprKind::Aggregate(parts.iter().map(|p| self.expr(p)).collect()),
            E::Call(call) => ExprKind::Call(Rc::new(Call {
                callee: Callee::Name(
                    lower_case_name(self.file, call.name),
                    as_written(self.file, call.name).into(),
                ),
                args: self.args(&call.args),
            })),
            E::Unary { op, operand } => ExprKind::Unary(*op, Box::new(self.expr(operand))),
            E::Binary(binary) => {
                let (lhs, rhs) = (self.expr(&binary.lhs), self.expr(&binary.rhs));
                ExprKind::Binary(binary.op, Box::new(lhs), Box::new(rhs))
            }
            E::Paren(inner) => return self.expr(inner),
            E::Placeholder | E::Opaque => ExprKind::Opaque,
        };
        Expr::new(kind)
    }
}
