//! Which data are tracked as program state: tools, work objects, speeds, zones and loads that the
//! program changes in the ordinary course of its routines, and whatever their new values are made of.

use super::call_arguments::{MatchedArgument, match_arguments};
use super::expressions::{every_call, expressions_of, root_of, value_of};
use super::ids::{DatumId, Id, IdSet, Slot, Table};
use super::index::{Ctx, DatumKind, Index, Resolved};
use super::motion_site::MotionSites;
use super::names::ByNumber;
use super::repeated_moves::every_naming_statement;
use super::statements::bodies;
use super::value_flow::{ValueFlow, ValueFlows};
use super::writes::Writes;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{Arg, Callee, DataKind, Expr, ExprKind, ParamMode, StmtKind};

/// The data that are tracked, and their positions in a state.
#[derive(Debug, Default)]
pub(super) struct TrackedData {
    pub(super) slot_of: Table<DatumId, Option<Slot>>,
    pub(super) data: Table<Slot, DatumId>,
    /// For each name, tracked or not, the slots of the parameters by reference that may mean the same.
    aliases: ByNumber<DatumId, Vec<Slot>>,
}

impl TrackedData {
    /// What must be tracked for the tools, work objects, speeds and zones of a program's motions.
    pub(super) fn new(index: &Index<'_>, writes: &Writes, sites: &MotionSites<'_>) -> Self {
        let mut wanted = IdSet::default();
        for site in sites.naming(index) {
            let args = site.args(index);
            let options = args.options.iter().filter_map(|(_, value)| *value);
            for expr in [args.speed, args.zone, args.tool].into_iter().flatten().chain(options) {
                names_in(index, site.ctx(index), expr, &mut |datum| {
                    wanted.insert(datum);
                });
            }
        }
        Self::of(index, writes, wanted)
    }

    /// What must be tracked for the targets of motions that have one, and for those of any that `is_position` names: they
    /// can hold the arm's own position, as a search found it or as it was read.
    pub(super) fn of_targets(
        index: &Index<'_>,
        writes: &Writes,
        sites: &MotionSites<'_>,
        is_position: &dyn Fn(DatumId) -> bool,
    ) -> Self {
        let mut wanted = IdSet::default();
        for site in sites.naming(index) {
            let targets = site.args(index).targets;
            for target in &targets {
                names_in(index, site.ctx(index), target, &mut |datum| {
                    if targets.len() == 1 || is_position(datum) {
                        wanted.insert(datum);
                    }
                });
            }
        }
        Self::of(index, writes, wanted)
    }

    /// Those that can be tracked, and whatever their values are made of.
    fn of(index: &Index<'_>, writes: &Writes, wanted: IdSet<DatumId>) -> Self {
        let slot_of = Table::filled(index.data.len(), None);
        let mut out = Self { slot_of, ..Self::default() };
        let mut data: Vec<DatumId> = Vec::new();
        let can_be = |datum: DatumId| {
            let entry = &index.data[datum];
            let changes = match entry.kind {
                DatumKind::Param { mode: ParamMode::In, .. } => true,
                DatumKind::Param { .. } => {
                    !writes.aliases.are_too_many() && !writes.means_what_changes_unseen(datum)
                }
                DatumKind::Declared(DataKind::Const) | DatumKind::LoopVariable => false,
                DatumKind::Declared(_) => writes.first(datum).is_some(),
            };
            changes
                && !entry.array
                && writes.orderly(datum)
                && writes.by_computed_name(index, datum).is_none()
        };
        let sources = sources(index);
        let mut new: Vec<DatumId> = wanted.iter().collect();
        while let Some(datum) = new.pop() {
            if out.slot_of[datum].is_some() || !can_be(datum) {
                continue;
            }
            out.slot_of[datum] = Some(Slot::at(data.len()));
            data.push(datum);
            new.extend(sources.sources_of(datum));
        }
        sorting::ascending(&mut data);
        out.data = data.into();
        for (slot, &datum) in out.data.numbered() {
            out.slot_of[datum] = Some(slot);
        }
        for (slot, &datum) in out.data.numbered() {
            if is_by_reference(index, datum) {
                for same in writes.aliases.of(datum) {
                    out.aliases.entry(same).or_default().push(slot);
                }
            }
        }
        out
    }

    /// The slots of parameters by reference that may mean the same as a name: they change with it.
    pub(super) fn aliases(&self, datum: DatumId) -> &[Slot] {
        self.aliases.get(&datum).map_or(&[], Vec::as_slice)
    }

    /// The slot of a datum that is tracked.
    pub(super) fn slot(&self, datum: DatumId) -> Option<Slot> {
        self.slot_of.get(datum).copied().flatten()
    }
}

fn is_by_reference(index: &Index<'_>, datum: DatumId) -> bool {
    matches!(index.data[datum].kind, DatumKind::Param { mode, .. } if mode != ParamMode::In)
}

/// Which datum's value goes into which, by assignment, declaration or as an argument.
pub(super) fn sources(index: &Index<'_>) -> ValueFlows {
    sources_where(index, &|_, _| true)
}

/// The same of those parts of expressions that `counts` says count.
pub(super) fn sources_where(index: &Index<'_>, counts: &dyn Fn(Ctx, &Expr) -> bool) -> ValueFlows {
    let mut out: Vec<ValueFlow> = Vec::new();
    for routine in &index.routines {
        let ctx = routine.ctx;
        for body in bodies(routine.tree) {
            every_naming_statement(index, ctx, body, &mut |stmt| {
                match &stmt.kind {
                    StmtKind::Assign(assign) => {
                        if let Some((root, _)) = root_of(&assign.target)
                            && let Some(to) = datum_at(index, ctx, root)
                        {
                            names_in_where(index, ctx, &assign.value, counts, &mut |from| {
                                out.push(ValueFlow { to, from });
                            });
                        }
                    }
                    StmtKind::Data(decl) => {
                        if let Some(init) = &decl.init
                            && let Some(to) = datum_at(index, ctx, decl.name)
                        {
                            names_in_where(index, ctx, init, counts, &mut |from| {
                                out.push(ValueFlow { to, from });
                            });
                        }
                    }
                    StmtKind::Call(call) => {
                        if let Callee::Name(name) = &call.callee {
                            arguments(index, ctx, *name, &call.args, counts, &mut out);
                        }
                    }
                    _ => {}
                }
                for expr in expressions_of(stmt) {
                    every_call(expr, &mut |name, args| {
                        arguments(index, ctx, name, args, counts, &mut out);
                    });
                }
            });
        }
    }
    ValueFlows::new(out)
}

fn arguments(
    index: &Index<'_>,
    ctx: Ctx,
    callee: TextRange,
    args: &[Arg],
    counts: &dyn Fn(Ctx, &Expr) -> bool,
    out: &mut Vec<ValueFlow>,
) {
    let Some(name) = index.name_at(ctx.file, callee) else { return };
    let (Resolved::Here(callee) | Resolved::Elsewhere(callee)) = index.routine(name, ctx) else { return };
    for MatchedArgument { param: to, value, handed_on } in match_arguments(index, ctx, callee, args) {
        if let Some(value) = value {
            names_in_where(index, ctx, value, counts, &mut |from| out.push(ValueFlow { to, from }));
        }
        if let Some(from) = handed_on.and_then(|own| datum_at(index, ctx, own)) {
            out.push(ValueFlow { to, from });
        }
    }
}

fn datum_at(index: &Index<'_>, ctx: Ctx, name: TextRange) -> Option<DatumId> {
    match index.datum(name, ctx) {
        Resolved::Here(datum) | Resolved::Elsewhere(datum) => Some(datum),
        Resolved::Twice(..) | Resolved::Nowhere => None,
    }
}

/// Whether a function asks about its argument, whatever that is worth.
fn asks_about(index: &Index<'_>, ctx: Ctx, function: TextRange) -> bool {
    let name = super::names::lower_case(index.text(ctx.file, function));
    matches!(&*name, "argname" | "dim" | "ispers" | "isvar" | "present" | "type")
        && !index.declares_routine(function, ctx)
}

/// Calls `visit` with every datum whose value an expression reads.
pub(super) fn names_in(index: &Index<'_>, ctx: Ctx, expr: &Expr, visit: &mut dyn FnMut(DatumId)) {
    names_in_where(index, ctx, expr, &|_, _| true, visit);
}

/// The same of those parts of the expression that `counts` says count.
pub(super) fn names_in_where(
    index: &Index<'_>,
    ctx: Ctx,
    expr: &Expr,
    counts: &dyn Fn(Ctx, &Expr) -> bool,
    visit: &mut dyn FnMut(DatumId),
) {
    if !counts(ctx, expr) {
        return;
    }
    let mut within = |expr: &Expr| names_in_where(index, ctx, expr, counts, visit);
    match &expr.kind {
        ExprKind::Name => {
            if let Some(datum) = datum_at(index, ctx, expr.range) {
                visit(datum);
            }
        }
        ExprKind::Field(field) => within(&field.base),
        ExprKind::Paren(inner) | ExprKind::Unary { operand: inner, .. } => within(inner),
        ExprKind::Index(element) => {
            within(&element.base);
            element.indices.iter().for_each(within);
        }
        ExprKind::Aggregate(parts) => parts.iter().for_each(within),
        ExprKind::Binary(binary) => {
            within(&binary.lhs);
            within(&binary.rhs);
        }
        ExprKind::Call(call) if asks_about(index, ctx, call.name) => {}
        ExprKind::Call(call) => {
            call.args.iter().filter_map(value_of).for_each(within);
        }
        ExprKind::Number
        | ExprKind::Numbers
        | ExprKind::String
        | ExprKind::Bool(_)
        | ExprKind::Placeholder
        | ExprKind::Opaque => {}
    }
}
