//! Procedures that a move calls in its corner (MoveLSync, MoveJSync, MoveCSync): like traps they run beside the program, which has read
//! on in the meantime. And what traps and those call.

use super::expressions::{every_call, expressions_of};
use super::ids::{IdSet, RoutineIndex};
use super::index::{Ctx, Index, Resolved};
use super::late_bound::reached;
use super::move_instructions::move_form;
use super::names::lower_case;
use super::repeated_moves::every_naming_statement;
use super::statements::bodies;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{ArgKind, CallStmt, Callee, Expr, StmtKind};

/// The procedures that moves of a program call: of a name that is not known, each that it can be; no `main`.
pub(super) fn called_by_moves(index: &Index<'_>) -> IdSet<RoutineIndex> {
    let mut found = IdSet::default();
    for routine in &index.routines {
        let ctx = routine.ctx;
        for body in bodies(routine.tree) {
            every_naming_statement(index, ctx, body, &mut |stmt| {
                let StmtKind::Call(call) = &stmt.kind else { return };
                let Some(text) = called_by(index, ctx, call) else { return };
                let meant = reached(index, ctx, text, &[]).into_iter();
                meant.filter(|&id| !is_main(index, id)).for_each(|id| {
                    found.insert(id);
                });
            });
        }
    }
    found
}

/// The name of the procedure that a move calls in its corner.
pub(super) fn called_by<'a>(index: &Index<'_>, ctx: Ctx, call: &'a CallStmt) -> Option<&'a Expr> {
    let Callee::Name(name) = call.callee else { return None };
    let lower = lower_case(index.text(ctx.file, name));
    let form = move_form(&lower).filter(|_| lower.ends_with("sync") && !index.declares_routine(name, ctx))?;
    let mut positional = call.args.iter().filter_map(|arg| match &arg.kind {
        ArgKind::Positional(value) => Some(value),
        _ => None,
    });
    positional.nth(form.tool? + 1)
}

/// The routines that traps, and procedures that moves call, call in turn.
pub(super) fn called_at_any_time(index: &Index<'_>) -> IdSet<RoutineIndex> {
    let mut found = IdSet::default();
    let mut new: Vec<RoutineIndex> = index.routines.ids().filter(|&id| index.interrupts(id)).collect();
    while let Some(id) = new.pop() {
        let routine = &index.routines[id];
        let ctx = routine.ctx;
        let named = |name: TextRange| match index.routine(index.name_at(ctx.file, name)?, ctx) {
            Resolved::Here(callee) | Resolved::Elsewhere(callee) | Resolved::Twice(callee, _) => Some(callee),
            Resolved::Nowhere => None,
        };
        let mut called: Vec<RoutineIndex> = Vec::new();
        for body in bodies(routine.tree) {
            every_naming_statement(index, ctx, body, &mut |stmt| {
                if let StmtKind::Call(call) = &stmt.kind {
                    match &call.callee {
                        Callee::Name(name) => called.extend(named(*name)),
                        Callee::Late(name) => called.extend(reached(index, ctx, name, &call.args)),
                    }
                }
                for expr in expressions_of(stmt) {
                    every_call(expr, &mut |name, _| called.extend(named(name)));
                }
            });
        }
        new.extend(called.into_iter().filter(|&callee| found.insert(callee)));
    }
    found
}

fn is_main(index: &Index<'_>, id: RoutineIndex) -> bool {
    index.names.text(index.routines[id].name) == "main"
}
