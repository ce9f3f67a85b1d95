//! Which data a program changes while it runs, and where: by assignment, whole or by component, by an
//! instruction that writes its argument, or through a routine that writes its parameter.

use super::index::{Ctx, DatumId, DatumKind, Index, Resolved, RoutineId, every_statement};
use super::instructions::{is_written_option, move_form, written_arguments, written_by_function};
use super::names::Sym;
use super::value;
use crate::diagnostic::{Span, TextRange};
use crate::syntax::tree::{
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
}

/// One change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Write {
    pub(super) at: Span,
    pub(super) how: How,
}

/// All changes of all data.
#[derive(Debug, Default)]
pub(super) struct Writes {
    /// For each datum the first change and the least orderly one.
    by_datum: Vec<Option<(Write, How)>>,
    /// A value is set by a name that is computed at run time: anything may be changed.
    pub(super) by_computed_name: Option<Span>,
    by_name: Vec<(Sym, Span)>,
}

/// A datum handed to a routine's parameter that it may write.
struct Passed {
    datum: DatumId,
    param: DatumId,
    at: Span,
}

impl Writes {
    /// Every change in the given files.
    pub(super) fn new(index: &Index<'_>) -> Self {
        let by_datum = vec![None; index.data.len()];
        let mut scan = Scan { index, writes: Self { by_datum, ..Self::default() }, passed: Vec::new() };
        for (id, routine) in index.routines.iter().enumerate() {
            let trap = routine.tree.kind == RoutineKind::Trap;
            scan.body(&routine.tree.body, id, trap);
            for handler in &routine.tree.handlers {
                scan.body(&handler.body, id, true);
            }
        }
        for (id, module) in index.modules.iter().enumerate() {
            let ctx = Ctx { file: module.file, module: id, routine: None };
            for item in &module.tree.items {
                if let ModuleItem::Opaque(range) = item {
                    scan.opaque(*range, ctx, How::Aliased);
                }
            }
        }
        scan.follow_parameters();
        let Scan { mut writes, .. } = scan;
        for (name, at) in std::mem::take(&mut writes.by_name) {
            for (id, datum) in index.data.iter().enumerate() {
                if datum.name == name {
                    writes.add(id, Write { at, how: How::AnyTime }, datum.kind);
                }
            }
        }
        writes
    }

    /// The first change of a datum in file order.
    pub(super) fn first(&self, datum: DatumId) -> Option<Write> {
        self.by_datum.get(datum).copied().flatten().map(|(first, _)| first)
    }

    /// Whether all changes happen in the ordinary course of routines, so that they can be followed.
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
            Some((first, worst)) => (first, worst.max(write.how)),
        });
    }
}

/// The name at the root of `a.b{1}.c`, and whether an index lies on the way.
pub(super) fn root_of(expr: &Expr) -> Option<(TextRange, bool)> {
    let mut at = expr;
    let mut indexed = false;
    loop {
        at = match &at.kind {
            ExprKind::Name => return Some((at.range, indexed)),
            ExprKind::Field { base, .. } => base,
            ExprKind::Index { base, .. } => {
                indexed = true;
                base
            }
            ExprKind::Paren(inner) => inner,
            _ => return None,
        };
    }
}

/// The names handed to a routine that is not given, and that it may write: targets, numbers and so on.
/// Tools, work objects, speeds and zones are taken to be left alone, as moves leave them.
pub(super) fn doubtful_arguments(index: &Index<'_>, ctx: Ctx, args: &[Arg]) -> Vec<TextRange> {
    let mut out = Vec::new();
    for arg in args {
        let (ArgKind::Positional(expr) | ArgKind::Named { value: Some(expr), .. }) = &arg.kind else {
            continue;
        };
        let Some((root, _)) = root_of(expr) else { continue };
        let Some(name) = index.name_at(ctx.file, root) else { continue };
        if let Resolved::Here(datum) | Resolved::Elsewhere(datum) = index.datum(name, ctx) {
            let left_alone = matches!(
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

/// The arguments of a call matched with the callee's parameters.
pub(super) fn match_arguments<'c>(
    index: &Index<'_>,
    ctx: Ctx,
    callee: RoutineId,
    args: &'c [Arg],
) -> Vec<(DatumId, Option<&'c Expr>, Option<TextRange>)> {
    let mut out = Vec::new();
    let Some(routine) = index.routines.get(callee) else { return out };
    let required = |&&id: &&DatumId| !matches!(index.data[id].kind, DatumKind::Param { optional: true, .. });
    let mut positional = routine.params.iter().filter(required);
    for arg in args {
        match &arg.kind {
            ArgKind::Positional(expr) => {
                if let Some(&param) = positional.next() {
                    out.push((param, Some(expr), None));
                }
            }
            ArgKind::Named { name, value } => {
                if let Some(param) = parameter_named(index, ctx, routine.params.as_slice(), *name) {
                    out.push((param, value.as_ref(), None));
                }
            }
            ArgKind::Conditional { name, param: own } => {
                if let Some(param) = parameter_named(index, ctx, routine.params.as_slice(), *name) {
                    out.push((param, None, Some(*own)));
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

struct Scan<'i, 'a> {
    index: &'i Index<'a>,
    writes: Writes,
    passed: Vec<Passed>,
}

impl Scan<'_, '_> {
    fn body(&mut self, body: &[Stmt], routine: RoutineId, any_time: bool) {
        let Some(entry) = self.index.routines.get(routine) else { return };
        let ctx = entry.ctx;
        let ordinary = if any_time { How::AnyTime } else { How::Assigned };
        every_statement(body, &mut |stmt| {
            let at = Span { file: ctx.file, range: stmt.range };
            match &stmt.kind {
                StmtKind::Assign { target, .. } => self.written(target, ctx, Write { at, how: ordinary }),
                StmtKind::Call(call) => self.call(call, ctx, at, any_time),
                StmtKind::Connect { interrupt, .. } => {
                    self.written(interrupt, ctx, Write { at, how: How::AnyTime });
                }
                StmtKind::Opaque => self.opaque(stmt.range, ctx, ordinary.max(How::Perhaps)),
                _ => {}
            }
            for expr in expressions_of(stmt) {
                self.functions_in(expr, ctx, at);
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
        let name = self.index.name_at(ctx.file, name)?;
        match self.index.datum(name, ctx) {
            Resolved::Here(id) | Resolved::Elsewhere(id) => Some(id),
            Resolved::Twice(..) | Resolved::Nowhere => None,
        }
    }

    fn call(&mut self, call: &CallStmt, ctx: Ctx, at: Span, any_time: bool) {
        let doubtful = if any_time { How::AnyTime } else { How::Perhaps };
        let Callee::Name(name) = &call.callee else {
            return self.perhaps(&call.args, ctx, Write { at, how: doubtful });
        };
        let lower = super::names::lower_case(self.index.text(ctx.file, *name));
        if let Some(sym) = self.index.names.find(lower.as_bytes())
            && let Resolved::Here(routine) | Resolved::Elsewhere(routine) | Resolved::Twice(routine, _) =
                self.index.routine(sym, ctx)
        {
            return self.handed_to(&call.args, routine, ctx, at);
        }
        let how = if any_time { How::AnyTime } else { How::Instruction };
        self.built_in(&call.args, written_arguments(&lower), ctx, Write { at, how });
        match lower.as_str() {
            "setdataval" | "setalldataval" => self.by_name(&call.args, at),
            _ if super::instructions::harmless(&lower) || move_form(&lower).is_some() => {}
            _ => self.perhaps(&call.args, ctx, Write { at, how: doubtful }),
        }
    }

    fn built_in(&mut self, args: &[Arg], positions: &[usize], ctx: Ctx, write: Write) {
        let mut position = 0;
        for arg in args {
            match &arg.kind {
                ArgKind::Positional(expr) => {
                    if positions.contains(&position) {
                        self.written(expr, ctx, write);
                    }
                    position += 1;
                }
                ArgKind::Named { name, value: Some(value) } => {
                    let name = super::names::lower_case(self.index.text(ctx.file, *name));
                    if is_written_option(&name) {
                        self.written(value, ctx, write);
                    }
                }
                ArgKind::Named { value: None, .. } | ArgKind::Conditional { .. } => {}
            }
        }
    }

    fn handed_to(&mut self, args: &[Arg], routine: RoutineId, ctx: Ctx, at: Span) {
        for (param, value, own) in match_arguments(self.index, ctx, routine, args) {
            let by_reference =
                !matches!(self.index.data[param].kind, DatumKind::Param { mode: ParamMode::In, .. });
            let name = value.and_then(root_of).map(|(name, _)| name).or(own);
            if by_reference
                && let Some(name) = name
                && let Some(datum) = self.datum(name, ctx)
            {
                self.passed.push(Passed { datum, param, at });
            }
        }
    }

    /// A routine that is not among the files may write what it is handed.
    fn perhaps(&mut self, args: &[Arg], ctx: Ctx, write: Write) {
        for root in doubtful_arguments(self.index, ctx, args) {
            self.written_name(root, ctx, write);
        }
    }

    fn by_name(&mut self, args: &[Arg], at: Span) {
        match args.first().map(|a| &a.kind) {
            Some(ArgKind::Positional(Expr { kind: ExprKind::String, range })) => {
                let name = value::string(self.index.text(at.file, *range));
                if let Some(name) = self.index.names.find(&name) {
                    self.writes.by_name.push((name, at));
                }
            }
            _ => {
                self.writes.by_computed_name.get_or_insert(at);
            }
        }
    }

    fn functions_in(&mut self, expr: &Expr, ctx: Ctx, at: Span) {
        every_call(expr, &mut |name, args| {
            let lower = super::names::lower_case(self.index.text(ctx.file, name));
            match self.index.names.find(lower.as_bytes()).map(|sym| self.index.routine(sym, ctx)) {
                Some(Resolved::Here(id) | Resolved::Elsewhere(id) | Resolved::Twice(id, _)) => {
                    self.handed_to(args, id, ctx, at);
                }
                Some(Resolved::Nowhere) | None => {
                    let write = Write { at, how: How::AnyTime };
                    self.built_in(args, written_by_function(&lower), ctx, write);
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
            for Passed { datum, param, at } in &self.passed {
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

/// The words in bytes that begin at `start`, strings and comments left out.
pub(super) fn words(bytes: &[u8], start: u32) -> Vec<TextRange> {
    let letter = |b: u8| b.is_ascii_alphabetic() || b >= 0x80;
    let mut out = Vec::new();
    let mut at = 0;
    while let Some(&b) = bytes.get(at) {
        let rest = &bytes[at..];
        let length = match b {
            b'"' => {
                rest[1..].iter().position(|b| matches!(b, b'"' | b'\n' | b'\r')).map_or(rest.len(), |n| n + 2)
            }
            b'!' => rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len()),
            _ if letter(b) || b == b'_' || b.is_ascii_digit() => {
                let end = rest.iter().position(|&b| !(letter(b) || b == b'_' || b.is_ascii_digit()));
                let end = end.unwrap_or(rest.len());
                if letter(b) {
                    out.push(TextRange::new(start + at as u32, start + (at + end) as u32));
                }
                end
            }
            _ => 1,
        };
        at += length;
    }
    out
}

/// The expressions that stand directly in a statement.
pub(super) fn expressions_of(stmt: &Stmt) -> Vec<&Expr> {
    fn of_args(args: &[Arg]) -> impl Iterator<Item = &Expr> {
        args.iter().filter_map(|arg| match &arg.kind {
            ArgKind::Positional(expr) | ArgKind::Named { value: Some(expr), .. } => Some(expr),
            ArgKind::Named { value: None, .. } | ArgKind::Conditional { .. } => None,
        })
    }
    match &stmt.kind {
        StmtKind::Data(decl) => decl.init.iter().collect(),
        StmtKind::Assign { target, value } => vec![target, value],
        StmtKind::Call(call) => match &call.callee {
            Callee::Late(expr) => std::iter::once(expr).chain(of_args(&call.args)).collect(),
            Callee::Name(_) => of_args(&call.args).collect(),
        },
        StmtKind::If { arms, .. } => arms.iter().map(|(cond, _)| cond).collect(),
        StmtKind::CompactIf { cond, .. } | StmtKind::While { cond, .. } => vec![cond],
        StmtKind::For { from, to, step, .. } => [from, to].into_iter().chain(step.as_ref()).collect(),
        StmtKind::Test { value, cases, .. } => {
            std::iter::once(value).chain(cases.iter().flat_map(|(values, _)| values)).collect()
        }
        StmtKind::Return(value) | StmtKind::Raise(value) => value.iter().collect(),
        _ => Vec::new(),
    }
}

/// Calls `see` with the name and arguments of every function call in an expression, inner ones first.
pub(super) fn every_call<'a>(expr: &'a Expr, see: &mut impl FnMut(TextRange, &'a [Arg])) {
    match &expr.kind {
        ExprKind::Call { name, args } => {
            for arg in args {
                if let ArgKind::Positional(e) | ArgKind::Named { value: Some(e), .. } = &arg.kind {
                    every_call(e, see);
                }
            }
            see(*name, args);
        }
        ExprKind::Field { base, .. } | ExprKind::Paren(base) => every_call(base, see),
        ExprKind::Unary { operand, .. } => every_call(operand, see),
        ExprKind::Index { base, indices } => {
            every_call(base, see);
            indices.iter().for_each(|i| every_call(i, see));
        }
        ExprKind::Aggregate(parts) => parts.iter().for_each(|p| every_call(p, see)),
        ExprKind::Binary { lhs, rhs, .. } => {
            every_call(lhs, see);
            every_call(rhs, see);
        }
        ExprKind::Number
        | ExprKind::Numbers
        | ExprKind::String
        | ExprKind::Bool(_)
        | ExprKind::Name
        | ExprKind::Placeholder
        | ExprKind::Opaque => {}
    }
}

#[cfg(test)]
mod tests {
    use super::words;
    use crate::diagnostic::TextRange;

    #[test]
    fn words_outside_strings_and_comments() {
        let text = b"p1 := \"p2\" + 3x_p3 ! p4\n tool\xE4.x;";
        let found: Vec<&[u8]> = words(text, 0).into_iter().map(|r: TextRange| r.of(text)).collect();
        assert_eq!(found, [b"p1".as_slice(), b"tool\xE4", b"x"]);
    }
}
