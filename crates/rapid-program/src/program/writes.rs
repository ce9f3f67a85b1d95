//! Which data a program changes while it runs, and where: by assignment, whole or by component, by an
//! instruction that writes its argument, or through a routine that writes its parameter.

use super::built_in::is_built_in_function;
use super::expressions::{every_call, expressions_of, root_of, value_of, words};
use super::ids::{DatumId, RoutineIndex, Table};
use super::index::{Ctx, DatumKind, Index, Resolved};
use super::instructions::move_form;
use super::late_bound;
use super::names::Sym;
use super::other_tasks;
use super::repeated_moves::every_naming_statement;
use super::value;
use super::written_by::{written_by_function, written_by_instruction};
use rapid_syntax::diagnostic::{Span, TextRange};
use rapid_syntax::tree::{
    Arg, ArgKind, CallStmt, Callee, DataKind, Expr, ExprKind, ModuleItem, ParamMode, RoutineKind, Stmt,
    StmtKind,
};

/// How a datum is changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum How {
    /// `name := ...` or `name.component := ...` in the ordinary course of a routine.
    Assigned,
    /// By an instruction that writes its argument, in the ordinary course of a routine.
    Instruction,
    /// Perhaps: handed to a routine that is not given, or named in text that was not understood.
    Perhaps,
    /// In a trap or an error handler, which may run at any time.
    AnyTime,
    /// Through a routine's parameter, or an element of an array, or by text that was not understood
    /// outside of routines.
    Aliased,
    /// By another task, at any time.
    OtherTask,
}

/// One place where a datum is changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Write {
    pub(super) at: Span,
    pub(super) how: How,
}

/// All changes of all data.
#[derive(Debug, Default)]
pub(super) struct Writes {
    /// For each datum the first change and the least orderly one.
    by_datum: Table<DatumId, Option<(Write, How)>>,
    /// A value is set by a name that is computed at run time: anything may be changed.
    pub(super) by_computed_name: Option<Span>,
    pub(super) by_reference: Vec<PassedDatum>,
    by_name: Vec<(Sym, Span)>,
}

/// A datum handed to a routine's parameter by reference, which then stands for it.
#[derive(Debug)]
pub(super) struct PassedDatum {
    pub(super) datum: DatumId,
    pub(super) param: DatumId,
    at: Span,
}

impl Writes {
    /// Every change in the given files.
    pub(super) fn new(index: &Index<'_>) -> Self {
        let by_datum = Table::filled(index.data.len(), None);
        let mut scan = Scan { index, writes: Self { by_datum, ..Self::default() }, passed: Vec::new() };
        for (id, routine) in index.routines.numbered() {
            let trap = routine.tree.kind == RoutineKind::Trap;
            scan.body(&routine.tree.body, id, trap);
            for handler in &routine.tree.handlers {
                scan.body(&handler.body, id, true);
            }
        }
        for (id, module) in index.modules.numbered() {
            let ctx = Ctx { file: module.file, module: id, routine: None };
            for item in &module.tree.items {
                if let ModuleItem::Opaque(range) = item {
                    scan.opaque(*range, ctx, How::Aliased);
                }
            }
        }
        scan.follow_parameters();
        let Scan { mut writes, passed, .. } = scan;
        writes.by_reference = passed;
        for (name, at) in std::mem::take(&mut writes.by_name) {
            for (id, datum) in index.data.numbered() {
                if datum.name == name {
                    writes.add(id, Write { at, how: How::AnyTime }, datum.kind);
                }
            }
        }
        for shared in other_tasks::shared(index) {
            let task = |id: &DatumId| index.modules.get(index.data[*id].ctx.module).map(|module| module.task);
            let written: Vec<(DatumId, Write)> =
                shared.iter().filter_map(|&id| Some((id, writes.first(id)?))).collect();
            for (by, write) in written {
                for &other in shared.iter().filter(|other| task(other) != task(&by)) {
                    let how = How::OtherTask;
                    writes.add(other, Write { how, ..write }, index.data[other].kind);
                }
            }
        }
        writes
    }

    /// The first change of a datum in file order.
    pub(super) fn first(&self, datum: DatumId) -> Option<Write> {
        self.by_datum.get(datum).copied().flatten().map(|(first, _)| first)
    }

    /// The least orderly change of a datum.
    pub(super) fn worst(&self, datum: DatumId) -> Option<How> {
        self.by_datum.get(datum).copied().flatten().map(|(_, worst)| worst)
    }

    /// Whether all changes happen in the ordinary course of routines, so that they can be tracked.
    pub(super) fn orderly(&self, datum: DatumId) -> bool {
        self.by_datum.get(datum).copied().flatten().is_none_or(|(_, worst)| worst <= How::Perhaps)
    }

    fn add(&mut self, datum: DatumId, write: Write, kind: DatumKind) {
        if kind == DatumKind::Declared(DataKind::Const) {
            return; // no controller changes a constant
        }
        let Some(slot) = self.by_datum.get_mut(datum) else { return };
        *slot = Some(match *slot {
            None => (write, write.how),
            // What another task does is the better reason.
            Some((first, worst)) if write.how == How::OtherTask && first.how != How::OtherTask => {
                (write, worst.max(write.how))
            }
            Some((first, worst)) => (first, worst.max(write.how)),
        });
    }
}

/// What is called and is not among the files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NotGiven {
    /// A procedure: tools, work objects, speeds and zones are taken to be left alone, as moves leave them.
    Procedure,
    /// A function: it moves nothing, so it may be there to write any of its arguments.
    Function,
}

/// The names handed to a routine that is not given, and that it may write.
pub(super) fn doubtful_arguments(
    index: &Index<'_>,
    ctx: Ctx,
    args: &[Arg],
    callee: NotGiven,
) -> Vec<TextRange> {
    let mut out = Vec::new();
    for arg in args {
        let Some(expr) = value_of(arg) else { continue };
        let Some((root, _)) = root_of(expr) else { continue };
        if let Resolved::Here(datum) | Resolved::Elsewhere(datum) = index.datum(root, ctx) {
            let left_alone = callee == NotGiven::Procedure
                && matches!(
                    index.type_text(index.data[datum].type_name),
                    "tooldata" | "wobjdata" | "speeddata" | "zonedata" | "loaddata"
                );
            if !left_alone {
                out.push(root);
            }
        }
    }
    out
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

fn positional(arg: &Arg) -> Option<&Expr> {
    match &arg.kind {
        ArgKind::Positional(expr) => Some(expr),
        _ => None,
    }
}

struct Scan<'i, 'a> {
    index: &'i Index<'a>,
    writes: Writes,
    passed: Vec<PassedDatum>,
}

impl Scan<'_, '_> {
    fn body(&mut self, body: &[Stmt], routine: RoutineIndex, any_time: bool) {
        let Some(entry) = self.index.routines.get(routine) else { return };
        let ctx = entry.ctx;
        let ordinary = if any_time { How::AnyTime } else { How::Assigned };
        every_naming_statement(self.index, ctx, body, &mut |stmt| {
            let at = Span { file: ctx.file, range: stmt.range };
            match &stmt.kind {
                StmtKind::Assign(assign) => self.written(&assign.target, ctx, Write { at, how: ordinary }),
                StmtKind::Call(call) => self.call(call, ctx, at, any_time),
                StmtKind::Connect(connect) => {
                    self.written(&connect.interrupt, ctx, Write { at, how: How::AnyTime });
                }
                StmtKind::Opaque => self.opaque(stmt.range, ctx, ordinary.max(How::Perhaps)),
                _ => {}
            }
            for expr in expressions_of(stmt) {
                self.functions_in(expr, ctx, at, any_time);
            }
        });
    }

    fn written(&mut self, target: &Expr, ctx: Ctx, write: Write) {
        let Some((root, indexed)) = root_of(target) else { return };
        let how = if indexed { write.how.max(How::Aliased) } else { write.how };
        self.written_name(root, ctx, Write { how, ..write });
    }

    fn written_name(&mut self, name: TextRange, ctx: Ctx, write: Write) {
        if let Some(datum) = self.datum(name, ctx) {
            self.writes.add(datum, write, self.index.data[datum].kind);
        }
    }

    fn datum(&self, name: TextRange, ctx: Ctx) -> Option<DatumId> {
        match self.index.datum(name, ctx) {
            Resolved::Here(id) | Resolved::Elsewhere(id) => Some(id),
            Resolved::Twice(..) | Resolved::Nowhere => None,
        }
    }

    fn call(&mut self, call: &CallStmt, ctx: Ctx, at: Span, any_time: bool) {
        let doubtful = if any_time { How::AnyTime } else { How::Perhaps };
        let Callee::Name(name) = &call.callee else {
            if let Callee::Late(name) = &call.callee {
                for routine in late_bound::reached(self.index, ctx, name, &call.args) {
                    self.handed_to(&call.args, routine, ctx, at);
                }
            }
            return self.perhaps(&call.args, NotGiven::Procedure, ctx, Write { at, how: doubtful });
        };
        let lower = super::names::lower_case(self.index.text(ctx.file, *name));
        if let Some(sym) = self.index.names.find(lower.as_bytes())
            && let Resolved::Here(routine) | Resolved::Elsewhere(routine) | Resolved::Twice(routine, _) =
                self.index.routine(sym, ctx)
        {
            return self.handed_to(&call.args, routine, ctx, at);
        }
        let how = if any_time { How::AnyTime } else { How::Instruction };
        for expr in written_by_instruction(self.index, ctx, &lower, &call.args) {
            self.written(expr, ctx, Write { at, how });
        }
        match lower.as_str() {
            "setdataval" => self.by_name(call.args.first().and_then(positional), at),
            "setalldataval" => self.by_type(&call.args, ctx, at),
            _ if super::instructions::harmless(&lower) || move_form(&lower).is_some() => {}
            _ => self.perhaps(&call.args, NotGiven::Procedure, ctx, Write { at, how: doubtful }),
        }
    }

    fn handed_to(&mut self, args: &[Arg], routine: RoutineIndex, ctx: Ctx, at: Span) {
        for MatchedArgument { param, value, handed_on } in match_arguments(self.index, ctx, routine, args) {
            let by_reference =
                !matches!(self.index.data[param].kind, DatumKind::Param { mode: ParamMode::In, .. });
            let name = value.and_then(root_of).map(|(name, _)| name).or(handed_on);
            if by_reference
                && let Some(name) = name
                && let Some(datum) = self.datum(name, ctx)
            {
                self.passed.push(PassedDatum { datum, param, at });
            }
        }
    }

    /// A routine that is not among the files may write what it is handed.
    fn perhaps(&mut self, args: &[Arg], callee: NotGiven, ctx: Ctx, write: Write) {
        for root in doubtful_arguments(self.index, ctx, args, callee) {
            self.written_name(root, ctx, write);
        }
    }

    /// A datum is set by its name: `SetDataVal "name",value`.
    fn by_name(&mut self, name: Option<&Expr>, at: Span) {
        match self.literal(name, at) {
            Some(name) => {
                if let Some(name) = self.index.names.find(&name) {
                    self.writes.by_name.push((name, at));
                }
            }
            None => {
                self.writes.by_computed_name.get_or_insert(at);
            }
        }
    }

    /// `SetAllDataVal "type"\Object:="pattern",value`: a pattern of letters, digits and underscores alone
    /// stands for the very name, any other, or none, for all data of the type.
    fn by_type(&mut self, args: &[Arg], ctx: Ctx, at: Span) {
        let object = args.iter().find_map(|arg| match &arg.kind {
            ArgKind::Named { name, value } => {
                let name = super::names::lower_case(self.index.text(ctx.file, *name));
                value.as_ref().filter(|_| name == "object")
            }
            _ => None,
        });
        let plain = |name: &Vec<u8>| name.iter().all(|b| b.is_ascii_alphanumeric() || *b == b'_');
        if self.literal(object, at).as_ref().is_some_and(plain) {
            return self.by_name(object, at);
        }
        let Some(type_name) = self.literal(args.first().and_then(positional), at) else {
            self.writes.by_computed_name.get_or_insert(at);
            return;
        };
        let type_name = super::names::lower_case(&type_name);
        for (id, datum) in self.index.data.numbered() {
            if self.index.names.text(datum.type_name) == type_name
                || self.index.type_text(datum.type_name) == type_name
            {
                self.writes.add(id, Write { at, how: How::AnyTime }, datum.kind);
            }
        }
    }

    fn literal(&self, expr: Option<&Expr>, at: Span) -> Option<Vec<u8>> {
        match expr? {
            Expr { kind: ExprKind::String, range } => Some(value::string(self.index.text(at.file, *range))),
            _ => None,
        }
    }

    fn functions_in(&mut self, expr: &Expr, ctx: Ctx, at: Span, any_time: bool) {
        every_call(expr, &mut |name, args| {
            let lower = super::names::lower_case(self.index.text(ctx.file, name));
            match self.index.names.find(lower.as_bytes()).map(|sym| self.index.routine(sym, ctx)) {
                Some(Resolved::Here(id) | Resolved::Elsewhere(id) | Resolved::Twice(id, _)) => {
                    self.handed_to(args, id, ctx, at);
                }
                Some(Resolved::Nowhere) | None if is_built_in_function(&lower) => {
                    for expr in written_by_function(self.index, ctx, &lower, args) {
                        self.written(expr, ctx, Write { at, how: How::AnyTime });
                    }
                }
                Some(Resolved::Nowhere) | None => {
                    let how = if any_time { How::AnyTime } else { How::Perhaps };
                    self.perhaps(args, NotGiven::Function, ctx, Write { at, how });
                }
            }
        });
    }

    fn opaque(&mut self, range: TextRange, ctx: Ctx, how: How) {
        let at = Span { file: ctx.file, range };
        for name in words(self.index.text(ctx.file, range), range.start) {
            self.written_name(name, ctx, Write { at, how });
        }
    }

    /// A datum handed to a parameter by reference is written where the parameter is.
    fn follow_parameters(&mut self) {
        loop {
            let mut changed = false;
            for PassedDatum { datum, param, at } in &self.passed {
                if self.writes.first(*param).is_some() && self.writes.orderly(*datum) {
                    let write = Write { at: *at, how: How::Aliased };
                    self.writes.add(*datum, write, self.index.data[*datum].kind);
                    changed |= !self.writes.orderly(*datum);
                }
            }
            if !changed {
                break;
            }
        }
    }
}
