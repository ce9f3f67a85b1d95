//! Calls by a name that is worked out at run time: which routines they may reach.

use super::expressions::value_of;
use super::ids::{DatumId, RoutineIndex};
use super::index::{Ctx, DatumKind, Index, Resolved, RoutineEntry};
use super::names::lower_case;
use super::value;
use rapid_syntax::tree::{Arg, ArgKind, BinaryOp, DataKind, Expr, ExprKind, RoutineKind};

/// The procedures of the same task that take these arguments and whose name fits what is written of it.
pub(super) fn reached(index: &Index<'_>, ctx: Ctx, name: &Expr, args: &[Arg]) -> Vec<RoutineIndex> {
    let [start, end] = [true, false].map(|first| written(index, ctx, name, first));
    let whole = start.whole;
    let start = start.text.rsplit(':').next().unwrap_or_default().to_owned();
    let task = |ctx: Ctx| index.modules.get(ctx.module).map(|module| module.task);
    let given = args.iter().filter(|arg| matches!(arg.kind, ArgKind::Positional(_))).count();
    let fits = |id: &RoutineIndex| {
        let routine = &index.routines[*id];
        let called = index.names.text(routine.name);
        let required =
            |&&p: &&DatumId| !matches!(index.data[p].kind, DatumKind::Param { optional: true, .. });
        let name_fits =
            if whole { called == start } else { called.starts_with(&start) && called.ends_with(&end.text) };
        routine.tree.kind == RoutineKind::Proc
            && task(routine.ctx) == task(ctx)
            && routine.params.iter().filter(required).count() == given
            && name_fits
            && args.iter().all(|arg| value_of(arg).is_none_or(|value| is_of_type(index, ctx, value, routine)))
    };
    index.routines.ids().filter(fits).collect()
}

/// Whether `CallByVar` of this text reaches a procedure of the same task, whatever the number.
pub(super) fn reaches_by_number(index: &Index<'_>, ctx: Ctx, name: &Expr) -> bool {
    let start = written(index, ctx, name, true).text;
    let task = |ctx: Ctx| index.modules.get(ctx.module).map(|module| module.task);
    index.routines.iter().any(|routine| {
        let ends_in_digit = |name: &str| name.ends_with(|c: char| c.is_ascii_digit());
        let called = index.names.text(routine.name);
        routine.tree.kind == RoutineKind::Proc
            && task(routine.ctx) == task(ctx)
            && called.strip_prefix(start.as_str()).is_some_and(ends_in_digit)
    })
}

/// Whether a routine has a parameter of an argument's type, where that is a datum.
fn is_of_type(index: &Index<'_>, ctx: Ctx, value: &Expr, routine: &RoutineEntry<'_>) -> bool {
    let ExprKind::Name = value.kind else { return true };
    let (Resolved::Here(datum) | Resolved::Elsewhere(datum)) = index.datum(value.range, ctx) else {
        return true;
    };
    let type_of = |datum: DatumId| index.type_text(index.data[datum].type_name);
    routine.params.iter().any(|&param| type_of(param) == type_of(datum))
}

/// What a sum of strings begins or ends with.
struct NamePart {
    text: String,
    /// It is all of it.
    whole: bool,
}

fn written(index: &Index<'_>, ctx: Ctx, expr: &Expr, first: bool) -> NamePart {
    match &expr.kind {
        ExprKind::String => {
            NamePart { text: lower_case(&value::string(index.text(ctx.file, expr.range))), whole: true }
        }
        ExprKind::Paren(inner) => written(index, ctx, inner, first),
        ExprKind::Name => match index.datum(expr.range, ctx) {
            Resolved::Here(datum) | Resolved::Elsewhere(datum) => match &index.data[datum] {
                entry if entry.kind == DatumKind::Declared(DataKind::Const) => match entry.init {
                    Some(init) if !matches!(init.kind, ExprKind::Name) => {
                        written(index, entry.ctx, init, first)
                    }
                    _ => NamePart { text: String::new(), whole: false },
                },
                _ => NamePart { text: String::new(), whole: false },
            },
            _ => NamePart { text: String::new(), whole: false },
        },
        ExprKind::Binary(sum) if sum.op == BinaryOp::Add => {
            let [near, far] = if first { [&sum.lhs, &sum.rhs] } else { [&sum.rhs, &sum.lhs] };
            let near = written(index, ctx, near, first);
            if !near.whole {
                return near;
            }
            let far = written(index, ctx, far, first);
            let text = if first { near.text + &far.text } else { far.text + &near.text };
            NamePart { text, whole: far.whole }
        }
        _ => NamePart { text: String::new(), whole: false },
    }
}
