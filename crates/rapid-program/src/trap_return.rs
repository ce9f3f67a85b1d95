//! Traps that bring the arm back: they read where it stands before they move it, and go there in the end (StorePath, CRobT, ..., RestoPath).

use super::ids::DatumId;
use super::index::{Ctx, Index, Resolved};
use super::motion::MotionId;
use super::motion_site::MotionSite;
use super::names::lower_case;
use super::statements::every_statement;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{Callee, Expr, ExprKind, RoutineKind, StmtKind};

/// Whether a motion stands in a trap and goes to where that has found the arm: to a datum that the trap sets once, before anything moves, to a
/// reading of the arm's place.
pub(super) fn goes_back(index: &Index<'_>, sites: &[MotionSite<'_>], motion: MotionId) -> bool {
    found_again(index, sites, motion).unwrap_or(false)
}

fn found_again(index: &Index<'_>, sites: &[MotionSite<'_>], motion: MotionId) -> Option<bool> {
    let site = sites.get(motion.index())?;
    let ctx = site.ctx(index);
    let trap = index.routines.get(ctx.routine?).filter(|routine| routine.tree.kind == RoutineKind::Trap)?;
    let [target] = site.args(index).targets[..] else { return None };
    let target = named(index, ctx, target)?;
    let first_move = sites.iter().find(|other| other.info == site.info)?.stmt.range.start;
    let (mut readings, mut others, mut moved) = (0, 0, false);
    every_statement(&trap.tree.body, &mut |stmt| match &stmt.kind {
        StmtKind::Assign(assign) if named(index, ctx, &assign.target) == Some(target) => {
            let is_first = !moved && stmt.range.end <= first_move;
            match is_first && reads_the_place(index, ctx, &assign.value) {
                true => readings += 1,
                false => others += 1,
            }
        }
        StmtKind::Call(call) => {
            moved |= match &call.callee {
                Callee::Name(name) => index.declares_routine(*name, ctx),
                Callee::Late(_) => true,
            };
        }
        StmtKind::Opaque => moved = true,
        _ => {}
    });
    Some(readings == 1 && others == 0)
}

fn named(index: &Index<'_>, ctx: Ctx, expr: &Expr) -> Option<DatumId> {
    if !matches!(expr.kind, ExprKind::Name) {
        return None;
    }
    match index.datum(expr.range, ctx) {
        Resolved::Here(datum) | Resolved::Elsewhere(datum) => Some(datum),
        Resolved::Twice(..) | Resolved::Nowhere => None,
    }
}

fn reads_the_place(index: &Index<'_>, ctx: Ctx, expr: &Expr) -> bool {
    let reads = |name: TextRange| {
        matches!(&*lower_case(index.text(ctx.file, name)), "crobt" | "cjointt")
            && !index.declares_routine(name, ctx)
    };
    matches!(&expr.kind, ExprKind::Call(call) if reads(call.name))
}
