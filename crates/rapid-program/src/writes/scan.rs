//! The search for changes of data: every statement of every routine, what it assigns, writes through an argument or hands on.
//!
//! Says where and how a datum is changed; what that means for its value, it does not know.

use super::{How, Write, Writes};
use crate::aliases::{Handed, PartStep};
use crate::built_in::is_built_in_function;
use crate::call_arguments::{MatchedArgument, NotGiven, doubtful_arguments, match_arguments};
use crate::expressions::{every_call, expressions_of, root_of, words};
use crate::ids::{DatumId, RoutineIndex, Table};
use crate::index::{Ctx, DatumKind, Index, Resolved};
use crate::interrupting::called_at_any_time;
use crate::late_bound;
use crate::move_instructions::move_form;
use crate::names::{Sym, lower_case};
use crate::other_instructions::harmless;
use crate::repeated_moves::every_naming_statement;
use crate::value;
use crate::value_type::type_of_value;
use crate::written_by::{written_by_function, written_by_instruction};
use rapid_syntax::diagnostic::{Span, TextRange};
use rapid_syntax::tree::{
    Arg, ArgKind, CallStmt, Callee, Expr, ExprKind, ModuleItem, ParamMode, Stmt, StmtKind,
};
use std::collections::BTreeSet;

/// What the text of all files changes.
pub(super) struct ScannedWrites {
    pub(super) writes: Writes,
    /// What is handed to parameters by reference.
    passed: Vec<PassedDatum>,
    /// The same, together with what else the same call hands to such parameters.
    pub(super) calls: BTreeSet<Vec<Handed>>,
    /// Names of data that are set by their name, and where.
    pub(super) by_name: Vec<(Sym, Span)>,
}

/// A datum handed to a routine's parameter by reference, which then stands for it.
struct PassedDatum {
    datum: DatumId,
    param: DatumId,
    at: Span,
    in_trap: bool,
}

impl ScannedWrites {
    /// The changes in all files of an index.
    pub(super) fn of(index: &Index<'_>) -> Self {
        let writes = Writes { by_datum: Table::filled(index.data.len(), None), ..Writes::default() };
        let changes = Self { writes, passed: Vec::new(), calls: BTreeSet::new(), by_name: Vec::new() };
        let mut scan = WriteScan { index, changes, in_trap: false, is_called_at_any_time: false };
        let called = called_at_any_time(index);
        for (id, routine) in index.routines.numbered() {
            let trap = index.interrupts(id);
            scan.in_trap = trap;
            scan.is_called_at_any_time = called.contains(id);
            scan.body(&routine.tree.body, id, trap);
            for handler in &routine.tree.handlers {
                scan.body(&handler.body, id, true);
            }
        }
        (scan.in_trap, scan.is_called_at_any_time) = (false, false);
        for (id, module) in index.modules.numbered() {
            let ctx = Ctx { file: module.file, module: id, routine: None };
            for item in &module.tree.items {
                if let ModuleItem::Opaque(range) = item {
                    scan.opaque(*range, ctx, How::Aliased);
                }
            }
        }
        scan.follow_parameters();
        scan.changes
    }
}

struct WriteScan<'i, 'a> {
    index: &'i Index<'a>,
    changes: ScannedWrites,
    /// What is being read is a trap, which runs at any time.
    in_trap: bool,
    /// A trap, or a procedure that a move calls, calls it: what is not its own changes at any time, too.
    is_called_at_any_time: bool,
}

impl WriteScan<'_, '_> {
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
            let is_hidden = self.is_hidden(datum);
            if is_hidden {
                self.changes.writes.unseen.insert(datum);
            }
            let how = if is_hidden { write.how.max(How::AnyTime) } else { write.how };
            self.changes.writes.add(datum, Write { how, ..write }, self.index.data[datum].kind);
        }
    }

    /// Whether a datum that is written here changes where the ways through the routines do not show it.
    fn is_hidden(&self, datum: DatumId) -> bool {
        self.in_trap || (self.is_called_at_any_time && self.index.data[datum].ctx.routine.is_none())
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
        let lower = lower_case(self.index.text(ctx.file, *name));
        if let Some(sym) = self.index.names.find(lower.as_bytes())
            && let Resolved::Here(routine) | Resolved::Elsewhere(routine) | Resolved::Twice(routine, _) =
                self.index.routine(sym, ctx)
        {
            return self.handed_to(&call.args, routine, ctx, at);
        }
        // What a sensor sends goes into its data again and again from there on.
        let how = if any_time || lower == "sigetcyclic" { How::AnyTime } else { How::Instruction };
        for expr in written_by_instruction(self.index, ctx, &lower, &call.args) {
            self.written(expr, ctx, Write { at, how });
        }
        match lower.as_str() {
            "setdataval" => self.by_name(&call.args, ctx, at),
            "setalldataval" => self.by_type(&call.args, ctx, at),
            _ if harmless(&lower) || move_form(&lower).is_some() => {}
            _ if self.index.added_routine(&lower).is_some() => {}
            _ => {
                let callee = NotGiven::instruction(&lower);
                self.perhaps(&call.args, callee, ctx, Write { at, how: doubtful });
            }
        }
    }

    fn handed_to(&mut self, args: &[Arg], routine: RoutineIndex, ctx: Ctx, at: Span) {
        let mut call = Vec::new();
        for MatchedArgument { param, value, handed_on } in match_arguments(self.index, ctx, routine, args) {
            let by_reference =
                !matches!(self.index.data[param].kind, DatumKind::Param { mode: ParamMode::In, .. });
            let name = value.and_then(root_of).map(|(name, _)| name).or(handed_on);
            if by_reference
                && let Some(name) = name
                && let Some(datum) = self.datum(name, ctx)
            {
                let in_trap = self.is_hidden(datum);
                self.changes.passed.push(PassedDatum { datum, param, at, in_trap });
                let mut part = Vec::new();
                value.into_iter().for_each(|value| self.part_of(value, ctx, &mut part));
                call.push(Handed { datum, param, part });
            }
        }
        if !call.is_empty() {
            self.changes.calls.insert(call);
        }
    }

    /// The steps from the datum at the root of `a.b{1}.c` to what is meant.
    fn part_of(&self, expr: &Expr, ctx: Ctx, part: &mut Vec<PartStep>) {
        match &expr.kind {
            ExprKind::Field(field) => {
                self.part_of(&field.base, ctx, part);
                part.extend(self.index.name_at(ctx.file, field.name).map(PartStep::Component));
            }
            ExprKind::Index(element) => {
                self.part_of(&element.base, ctx, part);
                let literal = |index: &Expr| match index.kind {
                    ExprKind::Number => {
                        value::number(self.index.text(ctx.file, index.range)).map(|n| n as u32)
                    }
                    _ => None,
                };
                part.push(PartStep::Element(element.indices.iter().map(literal).collect()));
            }
            ExprKind::Paren(inner) => self.part_of(inner, ctx, part),
            _ => {}
        }
    }

    /// A routine that is not among the files may write what it is handed.
    fn perhaps(&mut self, args: &[Arg], callee: NotGiven, ctx: Ctx, write: Write) {
        for root in doubtful_arguments(self.index, ctx, args, callee) {
            self.written_name(root, ctx, write);
        }
    }

    /// A datum is set by its name: `SetDataVal "name",value`.
    fn by_name(&mut self, args: &[Arg], ctx: Ctx, at: Span) {
        let mut values = args.iter().filter_map(positional);
        let (name, value) = (values.next(), values.next());
        match self.literal(name, at) {
            Some(name) => self.named(&name, at),
            None => {
                let set_to = value.and_then(|value| type_of_value(self.index, ctx, value));
                self.changes.writes.add_computed_name(set_to, at);
            }
        }
    }

    fn named(&mut self, name: &[u8], at: Span) {
        if let Some(name) = self.index.names.find(name) {
            self.changes.by_name.push((name, at));
        }
    }

    /// `SetAllDataVal "type"\Object:="pattern",value`: a pattern of letters, digits and underscores alone
    /// stands for the very name, any other, or none, for all data of the type.
    fn by_type(&mut self, args: &[Arg], ctx: Ctx, at: Span) {
        let object = args.iter().find_map(|arg| match &arg.kind {
            ArgKind::Named { name, value } => {
                let name = lower_case(self.index.text(ctx.file, *name));
                value.as_ref().filter(|_| name == "object")
            }
            _ => None,
        });
        let plain = |name: &Vec<u8>| name.iter().all(|b| b.is_ascii_alphanumeric() || *b == b'_');
        if let Some(name) = self.literal(object, at).filter(plain) {
            return self.named(&name, at);
        }
        let Some(type_name) = self.literal(args.first().and_then(positional), at) else {
            self.changes.writes.add_computed_name(None, at);
            return;
        };
        let type_name = lower_case(&type_name);
        for (id, datum) in self.index.data.numbered() {
            if self.index.names.text(datum.type_name) == type_name
                || self.index.type_text(datum.type_name) == type_name
            {
                self.changes.writes.unseen.insert(id);
                self.changes.writes.add(id, Write { at, how: How::AnyTime }, datum.kind);
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
            let lower = lower_case(self.index.text(ctx.file, name));
            match self.index.names.find(lower.as_bytes()).map(|sym| self.index.routine(sym, ctx)) {
                Some(Resolved::Here(id) | Resolved::Elsewhere(id) | Resolved::Twice(id, _)) => {
                    self.handed_to(args, id, ctx, at);
                }
                Some(Resolved::Nowhere) | None if is_built_in_function(&lower) => {
                    for expr in written_by_function(self.index, ctx, &lower, args) {
                        let datum = root_of(expr).and_then(|(root, _)| self.datum(root, ctx));
                        self.changes.writes.unseen.extend(datum);
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
            for PassedDatum { datum, param, at, .. } in &self.changes.passed {
                if self.changes.writes.first(*param).is_some() && self.changes.writes.orderly(*datum) {
                    let write = Write { at: *at, how: How::Aliased };
                    self.changes.writes.add(*datum, write, self.index.data[*datum].kind);
                    changed |= !self.changes.writes.orderly(*datum);
                }
            }
            if !changed {
                break;
            }
        }
        for PassedDatum { datum, param, in_trap, .. } in &self.changes.passed {
            if *in_trap && self.changes.writes.first(*param).is_some() {
                self.changes.writes.unseen.insert(*datum);
            }
        }
    }
}

fn positional(arg: &Arg) -> Option<&Expr> {
    match &arg.kind {
        ArgKind::Positional(expr) => Some(expr),
        _ => None,
    }
}
