//! Variables that only what is not among the files can set.
//!
//! A VAR without LOCAL is seen by all modules of its task. Where nothing among the files sets it and not all of the task is given, one of
//! the others is there to set it: what stands in the file is its value before that. Knows nothing of what the variables go into.

use super::built_in::{is_built_in_function, is_controllers_own};
use super::expressions::{every_call, expressions_of, value_of};
use super::ids::{DatumId, IdSet};
use super::index::{Ctx, Datum, DatumKind, Index};
use super::interrupting::called_by;
use super::late_bound::{reached, reaches_by_number};
use super::names::lower_case;
use super::repeated_moves::every_naming_statement;
use super::statements::bodies;
use super::writes::Writes;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{Arg, Callee, DataKind, RoutineKind, Stmt, StmtKind};
use std::collections::BTreeMap;

/// The variables that only what is not given can set.
pub(super) fn open_variables(index: &Index<'_>, writes: &Writes) -> IdSet<DatumId> {
    let mut open = IdSet::default();
    let is_never_set = |(id, datum): &(DatumId, &Datum<'_>)| {
        is_seen_by_others(datum)
            && writes.first(*id).is_none()
            && writes.by_computed_name(index, *id).is_none()
    };
    let never_set: Vec<(DatumId, Ctx)> =
        index.data.numbered().filter(is_never_set).map(|(id, datum)| (id, datum.ctx)).collect();
    let mut lacks: BTreeMap<Option<u32>, bool> = BTreeMap::new();
    for (id, ctx) in never_set {
        let not_all = || !has_main(index, ctx) || calls_others(index, task_of(index, ctx));
        if *lacks.entry(task_of(index, ctx)).or_insert_with(not_all) {
            open.insert(id);
        }
    }
    open
}

/// Whether other modules of the task can set a variable.
pub(super) fn is_seen_by_others(datum: &Datum<'_>) -> bool {
    datum.kind == DatumKind::Declared(DataKind::Var) && datum.ctx.routine.is_none() && !datum.local
}

/// Whether the procedure is given with which the task begins that something stands in.
pub(super) fn has_main(index: &Index<'_>, ctx: Ctx) -> bool {
    let task = task_of(index, ctx);
    index.routines.iter().any(|routine| {
        task_of(index, routine.ctx) == task
            && routine.tree.kind == RoutineKind::Proc
            && index.names.text(routine.name) == "main"
    })
}

fn task_of(index: &Index<'_>, ctx: Ctx) -> Option<u32> {
    index.modules.get(ctx.module).map(|module| module.task)
}

/// Whether a task calls what is neither given nor the controller's own.
fn calls_others(index: &Index<'_>, task: Option<u32>) -> bool {
    index.routines.iter().filter(|routine| task_of(index, routine.ctx) == task).any(|routine| {
        let mut found = false;
        for body in bodies(routine.tree) {
            every_naming_statement(index, routine.ctx, body, &mut |stmt| {
                found = found || calls_another(index, routine.ctx, stmt);
            });
        }
        found
    })
}

fn calls_another(index: &Index<'_>, ctx: Ctx, stmt: &Stmt) -> bool {
    let is_another = |name: TextRange, is_own: &dyn Fn(&str) -> bool| {
        !index.declares_routine(name, ctx) && !is_own(&lower_case(index.text(ctx.file, name)))
    };
    let is_known = |name: &str| is_controllers_own(name) || index.added_routine(name).is_some();
    let calls_by_number = |name: TextRange, args: &[Arg]| {
        let is_call = lower_case(index.text(ctx.file, name)) == "callbyvar";
        let text = args.first().and_then(value_of).filter(|_| is_call);
        text.is_some_and(|text| !reaches_by_number(index, ctx, text))
    };
    let mut found = match &stmt.kind {
        StmtKind::Call(call) => match &call.callee {
            Callee::Name(name) => {
                is_another(*name, &is_known)
                    || calls_by_number(*name, &call.args)
                    || called_by(index, ctx, call)
                        .is_some_and(|name| reached(index, ctx, name, &[]).is_empty())
            }
            Callee::Late(name) => reached(index, ctx, name, &call.args).is_empty(),
        },
        StmtKind::Connect(connect) => is_another(connect.trap, &|_| false),
        _ => false,
    };
    for expr in expressions_of(stmt) {
        every_call(expr, &mut |name, _| found = found || is_another(name, &is_built_in_function));
    }
    found
}
