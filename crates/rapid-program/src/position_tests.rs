//! Decisions of the program that depend on where the arm stands: a corrected arm stands beside its target by the correction, and a narrow
//! tolerance then says something else than it did.

use super::expressions::expressions_of;
use super::index::{Ctx, Index};
use super::names::lower_case;
use super::own_position::OwnPositions;
use super::repeated_moves::every_naming_statement;
use super::statements::bodies;
use rapid_syntax::diagnostic::{Diagnostic, Span};
use rapid_syntax::tree::{Callee, Stmt, StmtKind};

/// A decision, and the reading of the arm's position that it depends on.
struct PositionTest {
    at: Span,
    /// The word or instruction that decides.
    by: &'static str,
    reading: Span,
}

/// One warning for all decisions of a program that depend on where the arm stands, at the first of them.
pub(super) fn warning(index: &Index<'_>, own_positions: &OwnPositions) -> Option<Diagnostic> {
    if !own_positions.are_asked_for {
        return None;
    }
    let mut found: Vec<PositionTest> = Vec::new();
    for routine in &index.routines {
        for body in bodies(routine.tree) {
            every_naming_statement(index, routine.ctx, body, &mut |stmt| {
                found.extend(position_test(index, routine.ctx, own_positions, stmt));
            });
        }
    }
    let first = found.iter().min_by_key(|test| test.at)?;
    let more = match found.len() {
        1 => String::new(),
        2 => ", and one more test does".to_owned(),
        n => format!(", and {} more tests do", n - 1),
    };
    let text = format!(
        "{} decides by where the arm stands{more}: a corrected arm stands beside its target by the correction",
        first.by
    );
    let help = "a tolerance narrower than the corrections (--max-correction-mm and -deg, and what a joint turns by) decides otherwise than in \
                the original: widen it, or keep the motions before it (--keep)";
    Some(
        Diagnostic::warning("state::position-tested", text)
            .at(first.at)
            .label(first.reading, "read here")
            .help(help),
    )
}

/// The decision that a statement makes by a reading.
fn position_test(
    index: &Index<'_>,
    ctx: Ctx,
    own_positions: &OwnPositions,
    stmt: &Stmt,
) -> Option<PositionTest> {
    let by = match &stmt.kind {
        StmtKind::If(_) | StmtKind::CompactIf(_) => "IF",
        StmtKind::While(_) => "WHILE",
        StmtKind::For(_) => "FOR",
        StmtKind::Test(_) => "TEST",
        StmtKind::Call(call) => {
            let Callee::Name(name) = call.callee else { return None };
            let waits = lower_case(index.text(ctx.file, name)) == "waituntil";
            (waits && !index.declares_routine(name, ctx)).then_some("WaitUntil")?
        }
        _ => return None,
    };
    let reading = expressions_of(stmt).find_map(|expr| own_positions.read_at(index, ctx, expr))?;
    Some(PositionTest { at: Span { file: ctx.file, range: stmt.range }, by, reading })
}
