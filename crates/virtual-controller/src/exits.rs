//! How a loop that its own condition never ends is left from inside: what decides on the way to each exit.

use rapid_syntax::tree::{Expr, IfStmt, Stmt, StmtKind};
use std::collections::BTreeSet;

/// What decides whether a loop's body leaves the loop: by RETURN, EXIT, RAISE or a GOTO to a label outside.
///
/// `label` gives a label's name the same for every spelling.
pub(super) fn exits<'t>(body: &'t [Stmt], label: &impl Fn(&Stmt) -> Option<String>) -> Vec<&'t Expr> {
    let mut inside = BTreeSet::new();
    labels(body, label, &mut inside);
    let mut found = Found { inside, label, way: Vec::new(), out: Vec::new() };
    found.block(body);
    found.out
}

struct Found<'t, 'l, L> {
    inside: BTreeSet<String>,
    label: &'l L,
    /// What has decided on the way to the present statement.
    way: Vec<&'t Expr>,
    out: Vec<&'t Expr>,
}

impl<'t, L: Fn(&Stmt) -> Option<String>> Found<'t, '_, L> {
    fn block(&mut self, body: &'t [Stmt]) {
        for stmt in body {
            self.statement(stmt);
        }
    }

    fn statement(&mut self, stmt: &'t Stmt) {
        let before = self.way.len();
        match &stmt.kind {
            StmtKind::Return(_) | StmtKind::Raise(_) | StmtKind::Exit => self.out.extend(&self.way),
            StmtKind::Goto(_) if (self.label)(stmt).is_some_and(|to| !self.inside.contains(&to)) => {
                self.out.extend(&self.way);
            }
            StmtKind::While(looped) => self.way.push(&looped.cond),
            StmtKind::For(looped) => self.way.extend([&looped.from, &looped.to]),
            StmtKind::Test(test) => self.way.push(&test.value),
            StmtKind::If(branch) => self.way.extend(branch.arms.iter().map(|(cond, _)| cond)),
            StmtKind::CompactIf(branch) => self.way.push(&branch.cond),
            _ => {}
        }
        for body in inner(stmt) {
            self.block(body);
        }
        self.way.truncate(before);
    }
}

fn labels(body: &[Stmt], label: &impl Fn(&Stmt) -> Option<String>, found: &mut BTreeSet<String>) {
    for stmt in body {
        if matches!(stmt.kind, StmtKind::Label(_)) {
            found.extend(label(stmt));
        }
        inner(stmt).into_iter().for_each(|body| labels(body, label, found));
    }
}

/// The bodies of a statement.
fn inner(stmt: &Stmt) -> Vec<&[Stmt]> {
    match &stmt.kind {
        StmtKind::If(branch) => {
            let IfStmt { arms, otherwise, .. } = &**branch;
            arms.iter().map(|(_, body)| &body[..]).chain(otherwise.as_deref()).collect()
        }
        StmtKind::CompactIf(branch) => vec![std::slice::from_ref(&branch.then)],
        StmtKind::While(looped) => vec![&looped.body],
        StmtKind::For(looped) => vec![&looped.body],
        StmtKind::Test(test) => {
            test.cases.iter().map(|(_, body)| &body[..]).chain(test.default.as_deref()).collect()
        }
        _ => Vec::new(),
    }
}
