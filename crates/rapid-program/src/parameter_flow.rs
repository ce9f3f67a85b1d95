//! What calls by a name that is worked out at run time hand over, and back.

use super::call_arguments::{MatchedArgument, match_arguments};
use super::expressions::root_of;
use super::ids::RoutineIndex;
use super::index::{Ctx, DatumKind, Index, Resolved};
use super::late_bound::reached;
use super::statements::{bodies, every_statement};
use super::tracked::names_in;
use super::value_flow::ValueFlow;
use rapid_syntax::tree::{Arg, Callee, ParamMode, StmtKind};

/// What late-bound calls hand from datum to datum.
pub(super) struct ParameterFlow {
    /// From arguments into parameters.
    pub(super) into: Vec<ValueFlow>,
    /// What a parameter by reference has become into what was handed over.
    pub(super) out_of: Vec<ValueFlow>,
}

impl ParameterFlow {
    /// By all late-bound calls of a program.
    pub(super) fn new(index: &Index<'_>) -> Self {
        let mut handed = Self { into: Vec::new(), out_of: Vec::new() };
        for routine in &index.routines {
            for body in bodies(routine.tree) {
                every_statement(body, &mut |stmt| {
                    if let StmtKind::Call(call) = &stmt.kind
                        && let Callee::Late(name) = &call.callee
                        && !call.args.is_empty()
                    {
                        for callee in reached(index, routine.ctx, name, &call.args) {
                            handed.call(index, routine.ctx, callee, &call.args);
                        }
                    }
                });
            }
        }
        handed
    }

    fn call(&mut self, index: &Index<'_>, ctx: Ctx, callee: RoutineIndex, args: &[Arg]) {
        for MatchedArgument { param, value, handed_on } in match_arguments(index, ctx, callee, args) {
            if let Some(value) = value {
                names_in(index, ctx, value, &mut |from| self.into.push(ValueFlow { to: param, from }));
            }
            let root = value.and_then(root_of).map(|(root, _)| root).or(handed_on);
            let Some(Resolved::Here(datum) | Resolved::Elsewhere(datum)) =
                root.map(|root| index.datum(root, ctx))
            else {
                continue;
            };
            if handed_on.is_some() {
                self.into.push(ValueFlow { to: param, from: datum });
            }
            if !matches!(index.data[param].kind, DatumKind::Param { mode: ParamMode::In, .. }) {
                self.out_of.push(ValueFlow { to: datum, from: param });
            }
        }
    }
}
