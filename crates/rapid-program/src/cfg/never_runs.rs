//! Code under a condition that is FALSE on every controller: switched off for good, it leaves everything as it is.

use super::CfgBuilder;
use crate::const_eval::Constant;
use crate::expressions::every_call;
use crate::index::DatumKind;
use crate::statements::every_statement;
use crate::tracked::names_in;
use crate::value::Value;
use rapid_syntax::tree::{DataKind, Expr, Stmt, StmtKind};

impl<'a> CfgBuilder<'_, 'a> {
    /// The bodies of an IF but for those that never run.
    pub(super) fn arms_that_run(&mut self, arms: &'a [(Expr, Vec<Stmt>)]) -> Vec<&'a [Stmt]> {
        let runs = |(cond, body): &&'a (Expr, Vec<Stmt>)| !self.never_runs(cond, body);
        arms.iter().filter(runs).map(|(_, body)| body.as_slice()).collect()
    }

    /// Whether a body never runs, as its condition is made of literals and constants alone and is FALSE. One with motions, which are
    /// corrected for the day on which they are switched on, or to which a GOTO may lead counts as one that runs.
    pub(super) fn never_runs(&mut self, cond: &'a Expr, body: &'a [Stmt]) -> bool {
        let (index, ctx, mut fixed) = (self.index(), self.ctx, true);
        names_in(index, ctx, cond, &mut |datum| {
            fixed &= index.data[datum].kind == DatumKind::Declared(DataKind::Const);
        });
        every_call(cond, &mut |_, _| fixed = false);
        if !fixed {
            return false;
        }
        let folded = self.evaluator.fold(cond, ctx, &Constant).map(|typed| typed.value);
        if !matches!(folded, Ok(Value::Bool(false))) {
            return false;
        }
        let mut counts = false;
        every_statement(body, &mut |stmt| {
            counts |= matches!(stmt.kind, StmtKind::Label(_) | StmtKind::Opaque);
            counts |= self.sites.motion_at(ctx.file, stmt).is_some();
        });
        !counts
    }
}
