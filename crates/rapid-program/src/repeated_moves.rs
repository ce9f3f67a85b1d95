//! Neighbouring moves that differ in nothing but the numbers of their target, as nearly all do in a path that a post-processor
//! wrote: the first of them names all that they name.

use super::index::{Ctx, Index};
use super::move_instructions::move_form;
use super::names::lower_case;
use super::statements::inner_bodies;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{ArgKind, CallStmt, Callee, ExprKind, Stmt, StmtKind};

/// Calls `visit` with statements, the outer before the inner, in source order, but of neighbouring moves that name the same with the
/// first alone.
pub(super) fn every_naming_statement<'a>(
    index: &Index<'_>,
    ctx: Ctx,
    body: &'a [Stmt],
    visit: &mut dyn FnMut(&'a Stmt),
) {
    let mut last: Option<&Stmt> = None;
    for stmt in body {
        if matches!(stmt.kind, StmtKind::Comment) {
            continue;
        }
        if last.is_some_and(|last| name_the_same(index, ctx, last, stmt)) {
            continue;
        }
        last = Some(stmt).filter(|stmt| is_move(index, ctx, stmt));
        visit(stmt);
        for inner in inner_bodies(stmt) {
            every_naming_statement(index, ctx, inner, visit);
        }
    }
}

/// A move of the controller's own; a routine of the program may be handed something else each time.
fn is_move(index: &Index<'_>, ctx: Ctx, stmt: &Stmt) -> bool {
    let Some((call, _)) = with_numbers(stmt) else { return false };
    let Callee::Name(name) = call.callee else { return false };
    move_form(&lower_case(index.text(ctx.file, name))).is_some() && !index.declares_routine(name, ctx)
}

/// Whether two calls are the same but for the numbers of their first argument.
pub(super) fn name_the_same(index: &Index<'_>, ctx: Ctx, one: &Stmt, other: &Stmt) -> bool {
    let (Some((_, of_one)), Some((_, of_other))) = (with_numbers(one), with_numbers(other)) else {
        return false;
    };
    let text = |from: u32, to: u32| index.text(ctx.file, TextRange::new(from, to));
    let round = |stmt: &Stmt, numbers: TextRange| {
        (text(stmt.range.start, numbers.start), text(numbers.end, stmt.range.end))
    };
    round(one, of_one) == round(other, of_other)
}

/// A call whose first argument is an aggregate of numbers, and where that stands.
fn with_numbers(stmt: &Stmt) -> Option<(&CallStmt, TextRange)> {
    let StmtKind::Call(call) = &stmt.kind else { return None };
    match &call.args.first()?.kind {
        ArgKind::Positional(expr) if expr.kind == ExprKind::Numbers => Some((call, expr.range)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::statements::bodies;
    use rapid_syntax::SourceFile;
    use rapid_syntax::diagnostic::FileId;

    #[test]
    fn of_moves_that_name_the_same_the_first_is_enough() {
        let text = "MODULE m\nPROC main()\n\
            MoveL [[1,0,0]],v1,z1,t1;\nMoveL [[2,0,0]],v1,z1,t1; ! a comment\nMoveL [[3,0,0]],v1,z1,t1;\n\
            MoveL [[3,0,0]],v2,z1,t1;\nMoveL p1,v2,z1,t1;\nMoveL p1,v2,z1,t1;\nMoveJ [[3,0,0]],v2,z1,t1;\n\
            Own [[1,0,0]],t1;\nOwn [[2,0,0]],t1;\n\
            FOR i FROM 1 TO 2 DO\nMoveJ [[3,0,0]],v{i},z1,t1;\nMoveJ [[4,0,0]],v{i},z1,t1;\nENDFOR\n\
            MoveJ [[4,0,0]],v{i},z1,t1;\nENDPROC\nPROC Own(robtarget p,tooldata t)\nENDPROC\nENDMODULE\n";
        let files = vec![SourceFile::read(FileId(0), "m.mod", text.as_bytes().to_vec())];
        let index = Index::new(&files);
        let mut found = Vec::new();
        for routine in &index.routines {
            for body in bodies(routine.tree) {
                every_naming_statement(&index, routine.ctx, body, &mut |stmt| {
                    let text = String::from_utf8_lossy(files[0].text(stmt.range)).into_owned();
                    found.push(text.lines().next().unwrap_or_default().to_owned());
                });
            }
        }
        assert_eq!(
            found,
            [
                "MoveL [[1,0,0]],v1,z1,t1;",
                "MoveL [[3,0,0]],v2,z1,t1;",
                "MoveL p1,v2,z1,t1;",
                "MoveL p1,v2,z1,t1;",
                "MoveJ [[3,0,0]],v2,z1,t1;",
                "Own [[1,0,0]],t1;",
                "Own [[2,0,0]],t1;",
                "FOR i FROM 1 TO 2 DO",
                "MoveJ [[3,0,0]],v{i},z1,t1;",
                "MoveJ [[4,0,0]],v{i},z1,t1;",
            ]
        );
    }
}
