//! How a loop that its own condition never ends is left from inside: what decides on the way to each exit.

use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{ArgKind, Callee, Expr, IfStmt, Stmt, StmtKind};
use std::collections::BTreeSet;

/// The exits of a loop's or routine's body, and the conditions on which they are taken.
#[derive(Debug, Default)]
pub(super) struct BodyExits<'t> {
    /// It is left on some way.
    pub leaves: bool,
    /// What decides on the ways to where it is left.
    pub exit_conditions: Vec<&'t Expr>,
    /// Calls of procedures, which may leave it in turn.
    pub calls: Vec<LeavingCall<'t>>,
}

/// A call of a procedure that may leave the body it stands in.
#[derive(Debug)]
pub(super) struct LeavingCall<'t> {
    /// Where the procedure's name stands.
    pub name: TextRange,
    /// What decides on the way there, and what is handed over.
    pub exit_conditions: Vec<&'t Expr>,
}

/// How a loop's body leaves the loop: by RETURN, EXIT, RAISE or a GOTO to a label outside.
///
/// `label` gives a label's name the same for every spelling.
pub(super) fn of_loop<'t>(body: &'t [Stmt], label: &impl Fn(&Stmt) -> Option<String>) -> BodyExits<'t> {
    let mut inside = BTreeSet::new();
    labels(body, label, &mut inside);
    let jumps_out = |stmt: &Stmt| match stmt.kind {
        StmtKind::Return(_) => true,
        StmtKind::Goto(_) => label(stmt).is_some_and(|to| !inside.contains(&to)),
        _ => false,
    };
    let mut found = ExitSearch { jumps_out, way: Vec::new(), out: BodyExits::default() };
    found.block(body);
    found.out
}

/// How a routine's body leaves what calls it: by EXIT or RAISE.
pub(super) fn of_routine(body: &[Stmt]) -> BodyExits<'_> {
    let mut found = ExitSearch { jumps_out: |_: &Stmt| false, way: Vec::new(), out: BodyExits::default() };
    found.block(body);
    found.out
}

struct ExitSearch<'t, J> {
    /// Whether a RETURN or GOTO leaves.
    jumps_out: J,
    /// What has decided on the way to the present statement.
    way: Vec<&'t Expr>,
    out: BodyExits<'t>,
}

impl<'t, J: Fn(&Stmt) -> bool> ExitSearch<'t, J> {
    fn block(&mut self, body: &'t [Stmt]) {
        for stmt in body {
            self.statement(stmt);
        }
    }

    fn statement(&mut self, stmt: &'t Stmt) {
        let before = self.way.len();
        match &stmt.kind {
            StmtKind::Raise(_) | StmtKind::Exit => self.leave(),
            _ if (self.jumps_out)(stmt) => self.leave(),
            StmtKind::Call(call) => {
                if let Callee::Name(name) = call.callee {
                    let handed = call.args.iter().filter_map(|arg| match &arg.kind {
                        ArgKind::Positional(value) | ArgKind::Named { value: Some(value), .. } => Some(value),
                        ArgKind::Named { value: None, .. } | ArgKind::Conditional { .. } => None,
                    });
                    let exit_conditions = self.way.iter().copied().chain(handed).collect();
                    self.out.calls.push(LeavingCall { name, exit_conditions });
                }
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

    fn leave(&mut self) {
        self.out.leaves = true;
        self.out.exit_conditions.extend(&self.way);
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
