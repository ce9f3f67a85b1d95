//! What a call hands to whom: its arguments matched with the callee's parameters, and those that a routine which is not among the
//! files may write.
//!
//! Knows nothing of what becomes of the data.

use super::expressions::{root_of, value_of};
use super::ids::{DatumId, RoutineIndex};
use super::index::{Ctx, DatumKind, Index, Resolved};
use super::names::lower_case;
use super::predefined::{guessed, predefined};
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{Arg, ArgKind, Expr, ExprKind};

/// What is called and is not among the files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NotGiven {
    /// A procedure: one that is handed a speed, too, is taken to move, and to leave tool, work object and load alone, as moves leave them.
    Procedure,
    /// An instruction of an option that measures the tool that it is handed, and sets it, whatever speed it is handed.
    ToolCalibration,
    /// A function: it moves nothing, so it may be there to write any of its arguments.
    Function,
}

impl NotGiven {
    /// What an instruction is, by its name in lower case: BullsEye's measure the tool.
    pub(super) fn instruction(name: &str) -> Self {
        match name {
            "bechecktcp" | "berefpointer" | "besetuptoolj" | "betcpextend" | "beupdatetcp" => {
                Self::ToolCalibration
            }
            _ => Self::Procedure,
        }
    }
}

/// The names handed to a routine that is not given, and that it may write.
pub(super) fn doubtful_arguments(
    index: &Index<'_>,
    ctx: Ctx,
    args: &[Arg],
    callee: NotGiven,
) -> Vec<TextRange> {
    let moves = callee == NotGiven::Procedure
        && args.iter().filter_map(value_of).any(|expr| is_speed(index, ctx, expr));
    let mut out = Vec::new();
    for arg in args {
        let Some(expr) = value_of(arg) else { continue };
        let Some((root, _)) = root_of(expr) else { continue };
        if let Resolved::Here(datum) | Resolved::Elsewhere(datum) = index.datum(root, ctx) {
            let left_alone = match index.type_text(index.data[datum].type_name) {
                "speeddata" | "zonedata" => callee != NotGiven::Function,
                // A move takes them whole.
                "tooldata" | "wobjdata" | "loaddata" => moves && matches!(expr.kind, ExprKind::Name),
                _ => false,
            };
            if !left_alone {
                out.push(root);
            }
        }
    }
    out
}

/// Whether an argument is a speed, which moves alone are handed.
pub(super) fn is_speed(index: &Index<'_>, ctx: Ctx, expr: &Expr) -> bool {
    let Some((root, _)) = root_of(expr).filter(|_| !matches!(expr.kind, ExprKind::Field(_))) else {
        return false;
    };
    let of_type = match index.datum(root, ctx) {
        Resolved::Here(datum) | Resolved::Elsewhere(datum) | Resolved::Twice(datum, _) => {
            index.type_text(index.data[datum].type_name)
        }
        Resolved::Nowhere => {
            let name = lower_case(index.text(ctx.file, root));
            predefined(&name).or_else(|| guessed(&name)).map_or("", |(of_type, _)| of_type)
        }
    };
    of_type == "speeddata"
}

/// What a call hands to a parameter of the callee.
pub(super) struct MatchedArgument<'c> {
    pub(super) param: DatumId,
    /// The expression that stands there; `None` for a switch.
    pub(super) value: Option<&'c Expr>,
    /// The caller's own parameter that is handed on if it is present, of `\Name?parameter`.
    pub(super) handed_on: Option<TextRange>,
}

/// The arguments of a call matched with the callee's parameters.
pub(super) fn match_arguments<'c>(
    index: &Index<'_>,
    ctx: Ctx,
    callee: RoutineIndex,
    args: &'c [Arg],
) -> Vec<MatchedArgument<'c>> {
    let mut out = Vec::new();
    let Some(routine) = index.routines.get(callee) else { return out };
    let required = |&&id: &&DatumId| !matches!(index.data[id].kind, DatumKind::Param { optional: true, .. });
    let mut positional = routine.params.iter().filter(required);
    for arg in args {
        match &arg.kind {
            ArgKind::Positional(expr) => {
                if let Some(&param) = positional.next() {
                    out.push(MatchedArgument { param, value: Some(expr), handed_on: None });
                }
            }
            ArgKind::Named { name, value } => {
                if let Some(param) = parameter_named(index, ctx, routine.params.as_slice(), *name) {
                    out.push(MatchedArgument { param, value: value.as_ref(), handed_on: None });
                }
            }
            ArgKind::Conditional { name, param: own } => {
                if let Some(param) = parameter_named(index, ctx, routine.params.as_slice(), *name) {
                    out.push(MatchedArgument { param, value: None, handed_on: Some(*own) });
                }
            }
        }
    }
    out
}

fn parameter_named(index: &Index<'_>, ctx: Ctx, params: &[DatumId], name: TextRange) -> Option<DatumId> {
    let name = index.name_at(ctx.file, name)?;
    params.iter().copied().find(|&p| index.data[p].name == name)
}
