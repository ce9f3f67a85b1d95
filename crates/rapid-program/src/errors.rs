//! Where a statement may fail, and what a routine's ERROR handlers then do.
//!
//! An error goes to the handler of its routine; without one, or with one for other numbers, it goes on
//! to that of the caller. TRYNEXT goes on behind the statement that failed in the handler's own routine,
//! RETRY runs that statement again: it may be a call of which a part has already been done.

use super::index::{Ctx, Index};
use super::names::lower_case;
use super::statements::every_statement;
use rapid_syntax::tree::{
    Arg, ArgKind, BinaryOp, Callee, Expr, ExprKind, HandlerKind, Routine, Stmt, StmtKind,
};

/// What a routine's ERROR handlers do with an error in its body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Recovery {
    /// No error of the body gets past them to the caller.
    pub(super) catches_all: bool,
    /// The statement behind the failed one may be next.
    pub(super) next: bool,
    /// The failed statement may run again.
    pub(super) again: bool,
}

impl Recovery {
    /// What the handlers of a routine do.
    pub(super) fn of(index: &Index<'_>, ctx: Ctx, routine: &Routine) -> Self {
        let mut out = Self::default();
        for handler in &routine.handlers {
            let HandlerKind::Error(numbers) = &handler.kind else { continue };
            out.catches_all |= numbers.is_empty();
            every_statement(&handler.body, &mut |stmt| match &stmt.kind {
                StmtKind::TryNext => out.next = true,
                StmtKind::Retry => out.again = true,
                StmtKind::Call(call) => {
                    if let Callee::Name(name) = call.callee {
                        out.again |= lower_case(index.text(ctx.file, name)) == "startmoveretry";
                    }
                }
                _ => {}
            });
        }
        out.catches_all &= !out.again; // after a number of attempts the error goes on to the caller
        out
    }

    /// Whether the body may go on after an error.
    pub(super) fn resumes(self) -> bool {
        self.next || self.again
    }
}

/// Whether any routine handles errors: otherwise the first one ends the program.
pub(super) fn any_handled(index: &Index<'_>) -> bool {
    let is_error = |kind: &HandlerKind| matches!(kind, HandlerKind::Error(_));
    index.routines.iter().any(|routine| routine.tree.handlers.iter().any(|h| is_error(&h.kind)))
}

/// Whether a statement itself, not one inside it or in a routine that it calls, may fail.
pub(super) fn may_fail(index: &Index<'_>, ctx: Ctx, stmt: &Stmt) -> bool {
    match &stmt.kind {
        StmtKind::Raise(_) | StmtKind::Connect(_) | StmtKind::Opaque => true,
        StmtKind::Call(call) => match &call.callee {
            Callee::Late(_) => true,
            Callee::Name(name) => {
                let own = index.name_at(ctx.file, *name).map(|sym| index.routine(sym, ctx));
                let is_own = own.is_some_and(|own| own != super::index::Resolved::Nowhere);
                let name = lower_case(index.text(ctx.file, *name));
                !is_own && !NEVER_FAIL.contains(&name.as_str()) || arguments_may_fail(&call.args)
            }
        },
        _ => super::expressions::expressions_of(stmt).any(expression_may_fail),
    }
}

/// Instructions that no error handler hears of.
const NEVER_FAIL: &[&str] = &[
    "add", "clear", "confj", "confl", "decr", "eoffsoff", "incr", "pdispoff", "pdispset", "singarea",
    "tperase", "tpwrite", "waittime",
];

/// Whether working out the arguments of a call may fail.
pub(super) fn arguments_may_fail(args: &[Arg]) -> bool {
    args.iter().any(|arg| match &arg.kind {
        ArgKind::Positional(expr) => expression_may_fail(expr),
        ArgKind::Named { value: Some(expr), .. } => expression_may_fail(expr),
        ArgKind::Named { value: None, .. } | ArgKind::Conditional { .. } => false,
    })
}

/// Whether working out an expression may fail: a function, an index out of range, a division by zero.
pub(super) fn expression_may_fail(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Call(_) | ExprKind::Index(_) | ExprKind::Opaque => true,
        ExprKind::Binary(binary) => {
            matches!(binary.op, BinaryOp::Div | BinaryOp::IntDiv | BinaryOp::Mod)
                || expression_may_fail(&binary.lhs)
                || expression_may_fail(&binary.rhs)
        }
        ExprKind::Field(field) => expression_may_fail(&field.base),
        ExprKind::Paren(inner) | ExprKind::Unary { operand: inner, .. } => expression_may_fail(inner),
        ExprKind::Aggregate(parts) => parts.iter().any(expression_may_fail),
        ExprKind::Number
        | ExprKind::Numbers
        | ExprKind::String
        | ExprKind::Bool(_)
        | ExprKind::Name
        | ExprKind::Placeholder => false,
    }
}
