//! From the statements of a routine to the ways through it.

use super::built_in::is_built_in_function;
use super::convert;
use super::data::LoadData;
use super::draft::Drafts;
use super::errors::{Recovery, any_handled, arguments_may_fail, expression_may_fail, may_fail};
use super::expressions::{every_call, expressions_of, root_of, words};
use super::flow::{Binding, Hold, Node, Step, Ways, every_step};
use super::fold::{Constant, Folder};
use super::followed::FollowedData;
use super::index::{Ctx, DatumKind, Index, Resolved, RoutineId};
use super::instructions::{harmless, is_written_option, waits, written_arguments};
use super::motion::Keep;
use super::names::{Sym, as_text, lower_case};
use super::value::{Value, Why};
use super::writes::{NotGiven, doubtful_arguments, match_arguments};
use crate::diagnostic::{Span, TextRange};
use crate::syntax::tree::{
    Arg, ArgKind, BinaryOp, CallStmt, Callee, DataKind, Expr, ExprKind, RoutineKind, Stmt, StmtKind,
};
use nalgebra::Isometry3;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The ways through all routines.
#[derive(Debug, Default)]
pub(super) struct Lowered<'a> {
    /// One for each of the index's routines.
    pub(super) ways: Vec<Ways<'a>>,
    /// Routines that are called and not given, by name in lower case, with the first call.
    pub(super) not_given: BTreeMap<String, Span>,
}

impl<'a> Lowered<'a> {
    /// The ways through all routines of a program.
    pub(super) fn new(folder: &mut Folder<'a>, drafts: &Drafts<'a>, followed: &FollowedData) -> Self {
        let mut out = Self::default();
        let index = folder.index;
        let fallible = any_handled(index);
        for routine in &index.routines {
            let (ctx, folder) = (routine.ctx, &mut *folder);
            let recovery = Recovery::of(index, ctx, routine.tree);
            let mut lower = Lower { folder, drafts, followed, ctx, fallible, recovery, out: &mut out };
            let body = lower.body(&routine.tree.body);
            lower.recovery = Recovery::default(); // an error in a handler goes to the caller
            let handlers = routine.tree.handlers.iter().map(|h| lower.body(&h.body)).collect();
            out.ways.push(Ways { body, handlers, recovery });
        }
        out
    }
}

impl Lowered<'_> {
    /// For each routine whether another one calls it.
    pub(super) fn called(&self) -> Vec<bool> {
        let mut called = vec![false; self.ways.len()];
        for (caller, ways) in self.ways.iter().enumerate() {
            for nodes in std::iter::once(&ways.body).chain(&ways.handlers) {
                every_step(nodes, &mut |step| {
                    if let Step::Call { routines, .. } = step {
                        for &callee in routines.iter().filter(|&&callee| callee != caller) {
                            if let Some(called) = called.get_mut(callee) {
                                *called = true;
                            }
                        }
                    }
                });
            }
        }
        called
    }
}

struct Lower<'l, 'a> {
    folder: &'l mut Folder<'a>,
    drafts: &'l Drafts<'a>,
    followed: &'l FollowedData,
    ctx: Ctx,
    /// Some routine handles errors: they are to be followed.
    fallible: bool,
    /// What becomes of an error.
    recovery: Recovery,
    out: &'l mut Lowered<'a>,
}

impl<'a> Lower<'_, 'a> {
    fn index(&self) -> &'a Index<'a> {
        self.folder.index
    }

    fn text(&self, range: TextRange) -> &'a [u8] {
        self.index().text(self.ctx.file, range)
    }

    fn label(&self, range: TextRange) -> Option<Sym> {
        self.index().names.find(self.text(range))
    }

    fn body(&mut self, body: &'a [Stmt]) -> Vec<Node<'a>> {
        let mut out = Vec::new();
        for stmt in body {
            self.statement(stmt, &mut out);
        }
        out
    }

    fn statement(&mut self, stmt: &'a Stmt, out: &mut Vec<Node<'a>>) {
        let at = Span { file: self.ctx.file, range: stmt.range };
        if !matches!(stmt.kind, StmtKind::While { .. }) {
            self.functions(&expressions_of(stmt), at, out);
        }
        let fails = may_fail(self.index(), self.ctx, stmt);
        if fails {
            self.fail(out);
        }
        let skipped = fails && self.recovery.next;
        match &stmt.kind {
            StmtKind::Data(decl) => {
                if decl.kind != DataKind::Const
                    && let Some(value) = &decl.init
                {
                    self.assign(decl.name, Vec::new(), value, at, out);
                }
            }
            StmtKind::Assign { target, value } => {
                let mut path = Vec::new();
                if let Some(root) = self.path(target, &mut path) {
                    self.assign(root, path, value, at, out);
                }
            }
            StmtKind::Call(call) => self.call(stmt, call, at, out),
            StmtKind::If { arms, otherwise } => {
                let mut bodies: Vec<_> = arms.iter().map(|(_, body)| self.body(body)).collect();
                bodies.extend(otherwise.as_ref().map(|body| self.body(body)));
                branch(bodies, otherwise.is_none() || skipped, out);
            }
            StmtKind::CompactIf { then, .. } => {
                let body = self.body(std::slice::from_ref(then));
                branch(vec![body], true, out);
            }
            StmtKind::Test { cases, default, .. } => {
                let mut bodies: Vec<_> = cases.iter().map(|(_, body)| self.body(body)).collect();
                bodies.extend(default.as_ref().map(|body| self.body(body)));
                branch(bodies, default.is_none() || skipped, out);
            }
            StmtKind::For { from, to, step, body, .. } => {
                let at_least_once = self.runs(from, to, step.as_deref());
                let body = self.body(body);
                if !body.is_empty() {
                    out.push(Node::Loop { body, at_least_once, endless: false });
                }
            }
            StmtKind::While { cond, body } => self.while_loop(cond, body, at, out),
            StmtKind::Label(name) => out.extend(self.label(*name).map(Node::Label)),
            StmtKind::Goto(name) => out.extend(self.label(*name).map(Node::Goto)),
            StmtKind::Return(_) if skipped => {
                out.push(Node::Branch { arms: vec![vec![Node::Return]], otherwise: true });
            }
            StmtKind::Return(_) => out.push(Node::Return),
            StmtKind::Raise(_) if self.recovery.next => {}
            StmtKind::Raise(_) | StmtKind::Retry | StmtKind::TryNext | StmtKind::Exit => out.push(Node::Stop),
            StmtKind::Opaque => self.opaque(stmt.range, out),
            StmtKind::Connect { .. } | StmtKind::Empty | StmtKind::Placeholder | StmtKind::Comment => {}
        }
    }

    fn fail(&self, out: &mut Vec<Node<'a>>) {
        if self.fallible {
            out.push(Node::Step(Step::MayFail(self.recovery)));
        }
    }

    fn while_loop(&mut self, cond: &'a Expr, body: &'a [Stmt], at: Span, out: &mut Vec<Node<'a>>) {
        let ctx = self.ctx;
        let known = self.folder.fold(cond, ctx, &Constant).map(|t| t.value);
        let endless = matches!(known, Ok(Value::Bool(true)));
        self.functions(&[cond], at, out);
        let mut body = self.body(body);
        self.functions(&[cond], at, &mut body);
        if expression_may_fail(cond) {
            self.fail(&mut body);
        }
        let still = |node: &Node<'_>| matches!(node, Node::Step(Step::Wait(_) | Step::MayFail(_)));
        if body.iter().all(still) {
            body.push(Node::Step(Step::Wait(None))); // it waits for its condition
        }
        out.push(Node::Loop { body, at_least_once: endless, endless });
    }

    /// Whether constants say that a FOR runs at least once.
    fn runs(&mut self, from: &Expr, to: &Expr, step: Option<&Expr>) -> bool {
        let ctx = self.ctx;
        let mut number = |expr| match self.folder.fold(expr, ctx, &Constant).ok()?.value {
            Value::Num(n) => Some(n),
            _ => None,
        };
        match (number(from), number(to), step.map(number)) {
            (Some(_), Some(_), None) => true, // without STEP it counts towards the end
            (Some(from), Some(to), Some(Some(step))) => step != 0.0 && (to - from) / step >= 0.0,
            _ => false,
        }
    }

    /// The root of `a.b.c` and the names behind it; `None` where an index stands on the way.
    fn path(&self, target: &Expr, path: &mut Vec<Sym>) -> Option<TextRange> {
        match &target.kind {
            ExprKind::Name => Some(target.range),
            ExprKind::Field { base, name } => {
                let root = self.path(base, path)?;
                path.push(self.label(*name)?);
                Some(root)
            }
            _ => None,
        }
    }

    fn assign(
        &mut self,
        root: TextRange,
        path: Vec<Sym>,
        value: &'a Expr,
        at: Span,
        out: &mut Vec<Node<'a>>,
    ) {
        if let Some(slot) = self.slot(root) {
            out.push(Node::Step(Step::Assign { slot, path, value, ctx: self.ctx, at }));
        }
    }

    fn slot(&self, name: TextRange) -> Option<usize> {
        match self.index().datum(name, self.ctx) {
            Resolved::Here(datum) | Resolved::Elsewhere(datum) => self.followed.slot(datum),
            Resolved::Twice(..) | Resolved::Nowhere => None,
        }
    }

    fn call(&mut self, stmt: &'a Stmt, call: &'a CallStmt, at: Span, out: &mut Vec<Node<'a>>) {
        if let Some(&motion) = self.drafts.at.get(&(at.file.0, stmt.range.start)) {
            out.push(Node::Step(Step::Motion(motion)));
            self.written(&call.args, call, at, out);
            return;
        }
        match &call.callee {
            Callee::Late(expr) => self.late(expr, &call.args, out),
            Callee::Name(name) => match self.routine(*name) {
                Some(routine) => {
                    let skipped = self.recovery.next && arguments_may_fail(&call.args);
                    out.push(self.known_call(vec![routine], &call.args, skipped));
                }
                None => {
                    self.written(&call.args, call, at, out);
                    self.instruction(*name, call, at, out);
                }
            },
        }
    }

    fn routine(&self, name: TextRange) -> Option<RoutineId> {
        match self.index().routine(self.label(name)?, self.ctx) {
            Resolved::Here(id) | Resolved::Elsewhere(id) | Resolved::Twice(id, _) => Some(id),
            Resolved::Nowhere => None,
        }
    }

    fn known_call(&self, routines: Vec<RoutineId>, args: &'a [Arg], maybe: bool) -> Node<'a> {
        let mut bindings = Vec::new();
        for &routine in &routines {
            let given = match_arguments(self.index(), self.ctx, routine, args);
            let params = self.index().routines.get(routine).map_or(&[][..], |r| &r.params);
            for &param in params {
                if let Some(slot) = self.followed.slot(param) {
                    let value = given.iter().find(|(p, ..)| *p == param).and_then(|(_, value, _)| *value);
                    bindings.push(Binding { slot, param, value });
                }
            }
        }
        Node::Step(Step::Call { routines, bindings, maybe, recovery: self.recovery, ctx: self.ctx })
    }

    /// Functions that are called in expressions, those of the program and those that are not given.
    fn functions(&self, expressions: &[&'a Expr], at: Span, out: &mut Vec<Node<'a>>) {
        for expr in expressions {
            every_call(expr, &mut |name, args| match self.routine(name) {
                Some(routine) => out.push(self.known_call(vec![routine], args, true)),
                None if is_built_in_function(&lower_case(self.text(name))) => {}
                None => self.doubtful(name, args, NotGiven::Function, at, out),
            });
        }
    }

    /// Followed data that a routine that is not given may write.
    fn doubtful(&self, name: TextRange, args: &[Arg], callee: NotGiven, at: Span, out: &mut Vec<Node<'a>>) {
        for root in doubtful_arguments(self.index(), self.ctx, args, callee) {
            if let Some(slot) = self.slot(root) {
                let written = as_text(self.text(name));
                let why = self.why(at, format!("{written} is not given and may change it"));
                out.push(Node::Step(Step::Lose { slot, why, at }));
            }
        }
    }

    /// A call by a name that is worked out at run time: one of the routines whose name fits.
    fn late(&mut self, expr: &'a Expr, args: &'a [Arg], out: &mut Vec<Node<'a>>) {
        let ctx = self.ctx;
        let index = self.index();
        let required = args.iter().filter(|a| matches!(a.kind, ArgKind::Positional(_))).count();
        let known = self.folder.fold(expr, ctx, &Constant).map(|t| t.value);
        let (start, end, whole) = match &known {
            Ok(Value::Text(name)) => {
                let name = lower_case(name);
                let name = name.rsplit(':').next().unwrap_or_default().to_owned();
                (name, String::new(), true)
            }
            _ => {
                let start = lower_case(&self.literal(expr, true));
                let start = start.rsplit(':').next().unwrap_or_default().to_owned();
                (start, lower_case(&self.literal(expr, false)), false)
            }
        };
        let task = index.modules.get(ctx.module).map(|m| m.task);
        let fits = |id: &RoutineId| {
            let entry = &index.routines[*id];
            let name = index.names.text(entry.name);
            let wanted =
                |&&p: &&usize| !matches!(index.data[p].kind, DatumKind::Param { optional: true, .. });
            entry.tree.kind == RoutineKind::Proc
                && index.modules.get(entry.ctx.module).map(|m| m.task) == task
                && entry.params.iter().filter(wanted).count() == required
                && if whole {
                    name == start
                } else {
                    name.starts_with(&start) && name.ends_with(&end) && name != "main"
                }
        };
        let routines: Vec<RoutineId> = (0..index.routines.len()).filter(fits).collect();
        if !routines.is_empty() {
            out.push(self.known_call(routines.clone(), args, !whole || self.recovery.next));
        }
        if !whole || routines.is_empty() {
            out.push(Node::Step(Step::Away));
        }
    }

    /// The string literal that a sum of strings begins or ends with.
    fn literal(&self, expr: &Expr, first: bool) -> Vec<u8> {
        match &expr.kind {
            ExprKind::String => super::value::string(self.text(expr.range)),
            ExprKind::Paren(inner) => self.literal(inner, first),
            ExprKind::Binary { op: BinaryOp::Add, lhs, rhs } => {
                self.literal(if first { lhs } else { rhs }, first)
            }
            _ => Vec::new(),
        }
    }

    /// Followed data that an instruction writes.
    fn written(&self, args: &'a [Arg], call: &CallStmt, at: Span, out: &mut Vec<Node<'a>>) {
        let Callee::Name(name) = &call.callee else { return };
        let positions = written_arguments(&lower_case(self.text(*name)));
        let mut position = 0;
        for arg in args {
            let (expr, writes) = match &arg.kind {
                ArgKind::Positional(expr) => {
                    position += 1;
                    (expr, positions.contains(&(position - 1)))
                }
                ArgKind::Named { name, value: Some(expr) } => {
                    (expr, is_written_option(&lower_case(self.text(*name))))
                }
                ArgKind::Named { value: None, .. } | ArgKind::Conditional { .. } => continue,
            };
            if writes
                && let Some((root, _)) = root_of(expr)
                && let Some(slot) = self.slot(root)
            {
                let why = self.why(at, format!("{} writes it", as_text(self.text(*name))));
                out.push(Node::Step(Step::Lose { slot, why, at }));
            }
        }
    }

    fn why(&self, at: Span, what: String) -> Why {
        let reason = format!("{what}: {}", self.index().place(at));
        Rc::new(Keep { code: "keep::runtime-target", reason, because: Some(at) })
    }

    fn instruction(&mut self, name: TextRange, call: &'a CallStmt, at: Span, out: &mut Vec<Node<'a>>) {
        let written = as_text(self.text(name));
        let lower = lower_case(self.text(name));
        let has = |option: &str| {
            call.args.iter().any(|arg| match &arg.kind {
                ArgKind::Named { name, .. } => lower_case(self.text(*name)) == option,
                _ => false,
            })
        };
        let conditional = call.args.iter().any(|a| matches!(a.kind, ArgKind::Conditional { .. }));
        let on = if conditional { None } else { Some(!has("off")) };
        let displaces_nothing = lower == "pdispset" && self.is_no_displacement(call);
        let active = |what: &str| Some(self.why(at, format!("{what} ({written})")));
        let step = match lower.as_str() {
            "confl" => Step::ConfL(on),
            "confj" => Step::ConfJ(on),
            "gripload" => Step::Grip(self.gripped(call)),
            "pdispset" if displaces_nothing => Step::Hold(Hold::Displacement, None),
            "pdispon" | "pdispset" => {
                Step::Hold(Hold::Displacement, active("a program displacement is in force"))
            }
            "pdispoff" => Step::Hold(Hold::Displacement, None),
            "eoffson" | "eoffsset" => {
                Step::Hold(Hold::ExternalOffset, active("an offset of external axes is in force"))
            }
            "eoffsoff" => Step::Hold(Hold::ExternalOffset, None),
            "softact" => Step::Hold(Hold::SoftServo, active("the soft servo is active")),
            "softdeact" => Step::Hold(Hold::SoftServo, None),
            "syncmoveon" => Step::Hold(Hold::MultiMove, active("the robot moves together with others")),
            "syncmoveoff" | "syncmoveundo" => Step::Hold(Hold::MultiMove, None),
            "waittime" => {
                let seconds = call.args.iter().find_map(|arg| match &arg.kind {
                    ArgKind::Positional(expr) => Some(expr),
                    _ => None,
                });
                let ctx = self.ctx;
                let value = seconds.and_then(|s| self.folder.fold(s, ctx, &Constant).ok()).map(|t| t.value);
                Step::Wait(match value {
                    Some(Value::Num(seconds)) => Some(seconds.max(0.0)),
                    _ => None,
                })
            }
            "callbyvar" => {
                // CallByVar "proc", n calls procn.
                if let Some(ArgKind::Positional(expr)) = call.args.first().map(|a| &a.kind) {
                    let start = lower_case(&self.literal(expr, true));
                    self.by_number(&start, out);
                }
                Step::Away
            }
            "exitcycle" => return out.push(Node::Stop),
            _ if waits(&lower) => Step::Wait(None),
            _ if harmless(&lower) => return,
            _ => {
                let first = Span { file: self.ctx.file, range: name };
                self.doubtful(name, &call.args, NotGiven::Procedure, at, out);
                self.out.not_given.entry(lower).or_insert(first);
                Step::Away
            }
        };
        out.push(Node::Step(step));
    }

    /// Whether the pose given to PDispSet is a constant that displaces nothing.
    fn is_no_displacement(&mut self, call: &CallStmt) -> bool {
        let Some(ArgKind::Positional(pose)) = call.args.first().map(|arg| &arg.kind) else { return false };
        let ctx = self.ctx;
        let pose = self.folder.fold(pose, ctx, &Constant).map(|typed| convert::pose(&typed.value));
        matches!(pose, Ok(Ok(pose)) if pose == Isometry3::identity())
    }

    /// The load of a GripLoad, where it is constant.
    fn gripped(&mut self, call: &CallStmt) -> Option<LoadData> {
        let load = call.args.iter().find_map(|arg| match &arg.kind {
            ArgKind::Positional(load) => Some(load),
            _ => None,
        })?;
        let ctx = self.ctx;
        let load = self.folder.fold(load, ctx, &Constant).ok()?;
        convert::loaddata(&load.value).ok()
    }

    fn by_number(&self, start: &str, out: &mut Vec<Node<'a>>) {
        let index = self.index();
        let fits = |id: &RoutineId| {
            let name = index.names.text(index.routines[*id].name);
            let rest = name.strip_prefix(start);
            rest.is_some_and(|rest| !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_digit()))
        };
        let routines: Vec<RoutineId> = (0..index.routines.len()).filter(fits).collect();
        if !routines.is_empty() {
            out.push(self.known_call(routines, &[], true));
        }
    }

    /// Text that was not understood: what it names is no longer known, nor where the arm is.
    fn opaque(&self, range: TextRange, out: &mut Vec<Node<'a>>) {
        let at = Span { file: self.ctx.file, range };
        for word in words(self.text(range), range.start) {
            let lower = lower_case(self.text(word));
            let named = || Some(self.why(at, format!("text that was not understood names {lower}")));
            out.push(Node::Step(match lower.as_str() {
                "confl" => Step::ConfL(None),
                "confj" => Step::ConfJ(None),
                "gripload" => Step::Grip(None),
                "pdispon" | "pdispset" | "pdispoff" => Step::Hold(Hold::Displacement, named()),
                "eoffson" | "eoffsset" | "eoffsoff" => Step::Hold(Hold::ExternalOffset, named()),
                "softact" | "softdeact" => Step::Hold(Hold::SoftServo, named()),
                "syncmoveon" | "syncmoveoff" => Step::Hold(Hold::MultiMove, named()),
                _ => match self.slot(word) {
                    Some(slot) => {
                        let why = self.why(at, "text that was not understood names it".into());
                        Step::Lose { slot, why, at }
                    }
                    None => continue,
                },
            }));
        }
        out.push(Node::Step(Step::Away));
    }
}

fn branch<'a>(arms: Vec<Vec<Node<'a>>>, otherwise: bool, out: &mut Vec<Node<'a>>) {
    if arms.iter().any(|arm| !arm.is_empty()) {
        out.push(Node::Branch { arms, otherwise });
    }
}
