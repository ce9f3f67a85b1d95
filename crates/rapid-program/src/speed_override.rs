//! How much slower than written a program may move: what its VelSet and SpeedRefresh say.

use super::const_eval::{ConstEvaluator, Constant};
use super::expressions::value_of;
use super::names::lower_case;
use super::repeated_moves::every_naming_statement;
use super::statements::bodies;
use super::value::Value;
use rapid_syntax::tree::{Callee, Expr, StmtKind};
use robot_model::units::m_from_mm;

/// The slowest that any VelSet or SpeedRefresh of the files asks for, wherever it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedOverride {
    /// Share of the written speed, above 0 and up to 1.
    pub share: f64,
    /// Fastest speed of the TCP, m/s.
    pub max_tcp_m_s: f64,
    /// False where a value is known at run time alone.
    pub is_known: bool,
}

impl Default for SpeedOverride {
    fn default() -> Self {
        Self { share: 1.0, max_tcp_m_s: f64::INFINITY, is_known: true }
    }
}

/// Slower than this share nobody works, %: it stops the arm.
const LEAST_PERCENT: f64 = 1.0;

/// That of all files.
pub(super) fn speed_override(evaluator: &mut ConstEvaluator<'_>) -> SpeedOverride {
    let index = evaluator.index;
    let mut found = SpeedOverride::default();
    for routine in &index.routines {
        let ctx = routine.ctx;
        for body in bodies(routine.tree) {
            every_naming_statement(index, ctx, body, &mut |stmt| {
                let StmtKind::Call(call) = &stmt.kind else { return };
                let Callee::Name(name) = &call.callee else { return };
                let written = lower_case(index.text(ctx.file, *name));
                if !["velset", "speedrefresh"].contains(&written.as_str())
                    || index.declares_routine(*name, ctx)
                {
                    return;
                }
                let mut number = |expr: Option<&Expr>| match evaluator.fold(expr?, ctx, &Constant).ok()?.value
                {
                    Value::Num(n) => Some(n),
                    _ => None,
                };
                let mut arguments = call.args.iter().filter_map(value_of);
                match number(arguments.next()) {
                    Some(percent) => found.share = found.share.min(percent.max(LEAST_PERCENT) / 100.0),
                    None => found.is_known = false,
                }
                if written == "velset" {
                    match number(arguments.next()) {
                        Some(max_mm_s) => found.max_tcp_m_s = found.max_tcp_m_s.min(m_from_mm(max_mm_s)),
                        None => found.is_known = false,
                    }
                }
            });
        }
    }
    found
}
