//! Walking through the statements of routines, those inside others included.

use rapid_syntax::tree::{Routine, Stmt, StmtKind};

/// The statements of a routine, then those of each of its handlers.
pub(super) fn bodies(routine: &Routine) -> impl Iterator<Item = &[Stmt]> {
    std::iter::once(routine.body.as_slice()).chain(routine.handlers.iter().map(|h| h.body.as_slice()))
}

/// Calls `visit` with every statement, the outer before the inner, in source order.
pub(super) fn every_statement<'a>(body: &'a [Stmt], visit: &mut dyn FnMut(&'a Stmt)) {
    for stmt in body {
        visit(stmt);
        for inner in inner_bodies(stmt) {
            every_statement(inner, visit);
        }
    }
}

/// The bodies inside a statement, in source order.
pub(super) fn inner_bodies(stmt: &Stmt) -> Vec<&[Stmt]> {
    match &stmt.kind {
        StmtKind::If(branch) => {
            branch.arms.iter().map(|(_, b)| b.as_slice()).chain(branch.otherwise.as_deref()).collect()
        }
        StmtKind::CompactIf(branch) => vec![std::slice::from_ref(&branch.then)],
        StmtKind::For(looped) => vec![looped.body.as_slice()],
        StmtKind::While(looped) => vec![looped.body.as_slice()],
        StmtKind::Test(test) => {
            test.cases.iter().map(|(_, b)| b.as_slice()).chain(test.default.as_deref()).collect()
        }
        _ => Vec::new(),
    }
}
