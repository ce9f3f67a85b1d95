//! What the variables of FOR loops get: the values of their bounds.

use super::ids::DatumId;
use super::index::{Ctx, DatumKind, Index};
use super::names::ByNumber;
use super::statements::{bodies, every_statement};
use rapid_syntax::diagnostic::{FileId, TextRange};
use rapid_syntax::tree::{Expr, StmtKind};

/// Every bound of every FOR, with where it stands and the variable that counts from it, to it or by it.
pub(super) fn loop_bounds<'a>(index: &Index<'a>) -> Vec<(Ctx, DatumId, &'a Expr)> {
    let mut variables: ByNumber<(FileId, TextRange), DatumId> = ByNumber::default();
    for (variable, datum) in index.data.numbered() {
        if datum.kind == DatumKind::LoopVariable {
            variables.insert((datum.ctx.file, datum.name_range), variable);
        }
    }
    let mut all = Vec::new();
    for routine in &index.routines {
        let ctx: Ctx = routine.ctx;
        for body in bodies(routine.tree) {
            every_statement(body, &mut |stmt| {
                if let StmtKind::For(looped) = &stmt.kind
                    && let Some(&variable) = variables.get(&(ctx.file, looped.var))
                {
                    let bounds = [Some(&looped.from), Some(&looped.to), looped.step.as_ref()];
                    all.extend(bounds.into_iter().flatten().map(|bound| (ctx, variable, bound)));
                }
            });
        }
    }
    all
}
