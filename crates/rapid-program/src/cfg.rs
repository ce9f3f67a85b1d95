//! From the statements of a routine to the ways through it.

mod calls;
mod external_axes;
mod instruction;
mod never_runs;
mod unread_blocks;

use super::const_eval::{ConstEvaluator, Constant};
use super::errors::{Recovery, any_handled, expression_may_fail, may_fail};
use super::expressions::{expressions_of, root_of};
use super::flow::{FlowStep, Node, RoutineCfg, every_step};
use super::ids::{DatumId, RoutineIndex, Table};
use super::index::{Ctx, DatumKind, Index, Resolved};
use super::motion::SkipReason;
use super::motion_site::MotionSites;
use super::names::{Sym, lower_case};
use super::tracked::TrackedData;
use super::value::{Value, Why};
use rapid_syntax::diagnostic::{Span, TextRange};
use rapid_syntax::tree::{AssignStmt, DataKind, Expr, ExprKind, Stmt, StmtKind};
use std::collections::BTreeMap;
use std::rc::Rc;

/// The ways through all routines.
#[derive(Debug, Default)]
pub(super) struct ControlFlow<'a> {
    /// One for each of the index's routines.
    pub(super) routines: Table<RoutineIndex, RoutineCfg<'a>>,
    /// Routines that are called and not given, by name in lower case, with the first call.
    pub(super) not_given: BTreeMap<String, Span>,
}

impl<'a> ControlFlow<'a> {
    /// The ways through all routines of a program.
    pub(super) fn new(
        evaluator: &mut ConstEvaluator<'a>,
        sites: &MotionSites<'a>,
        tracked: &TrackedData,
        base_fixed: [bool; 6],
    ) -> Self {
        let mut out = Self::default();
        let index = evaluator.index;
        let fallible = any_handled(index);
        let mut placed_anywhere = None;
        for routine in &index.routines {
            let (ctx, evaluator) = (routine.ctx, &mut *evaluator);
            let recovery = Recovery::of(index, ctx, routine.tree);
            let mut builder = CfgBuilder {
                evaluator,
                sites,
                tracked,
                base_fixed,
                placed_anywhere: &mut placed_anywhere,
                ctx,
                fallible,
                recovery,
                before: None,
                out: &mut out,
            };
            let body = builder.body(&routine.tree.body);
            builder.recovery = Recovery::default(); // an error in a handler goes to the caller
            let handlers = routine.tree.handlers.iter().map(|h| builder.body(&h.body)).collect();
            out.routines.push(RoutineCfg { body, handlers, recovery });
        }
        out
    }
}

impl ControlFlow<'_> {
    /// For each routine whether another one calls it.
    pub(super) fn called(&self) -> Table<RoutineIndex, bool> {
        let mut called = Table::filled(self.routines.len(), false);
        for (caller, cfg) in self.routines.numbered() {
            for nodes in std::iter::once(&cfg.body).chain(&cfg.handlers) {
                every_step(nodes, &mut |step| {
                    if let FlowStep::Call { routines, .. } = step {
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

struct CfgBuilder<'l, 'a> {
    evaluator: &'l mut ConstEvaluator<'a>,
    sites: &'l MotionSites<'a>,
    tracked: &'l TrackedData,
    /// External axes that move neither the robot's base nor a work object.
    base_fixed: [bool; 6],
    /// External axes that the program places away from 0 somewhere, once that was asked.
    placed_anywhere: &'l mut Option<[bool; 6]>,
    ctx: Ctx,
    /// Some routine handles errors: they are to be followed.
    fallible: bool,
    /// What becomes of an error.
    recovery: Recovery,
    /// The statement that runs just before the one that is looked at, where it stands just above it.
    before: Option<&'a Stmt>,
    out: &'l mut ControlFlow<'a>,
}

impl<'a> CfgBuilder<'_, 'a> {
    fn index(&self) -> &'a Index<'a> {
        self.evaluator.index
    }

    fn text(&self, range: TextRange) -> &'a [u8] {
        self.index().text(self.ctx.file, range)
    }

    fn label(&self, range: TextRange) -> Option<Sym> {
        self.index().names.find(self.text(range))
    }

    fn statement(&mut self, stmt: &'a Stmt, out: &mut Vec<Node<'a>>) {
        let at = Span { file: self.ctx.file, range: stmt.range };
        if !matches!(stmt.kind, StmtKind::While(_)) {
            self.functions(expressions_of(stmt), at, out);
        }
        let fails = may_fail(self.index(), self.ctx, stmt);
        if fails {
            self.fail(out);
        }
        let skipped = fails && self.recovery.next;
        match &stmt.kind {
            StmtKind::Data(decl) if decl.kind != DataKind::Const => {
                if let Some(value) = &decl.init {
                    self.assign(decl.name, Vec::new(), value, at, out);
                }
            }
            StmtKind::Assign(assign) if skipped => branch(vec![self.assignment(assign, at)], true, out),
            StmtKind::Assign(assign) => out.extend(self.assignment(assign, at)),
            StmtKind::Call(call) => self.call(stmt, call, at, out),
            StmtKind::If(tested) => {
                let arms: Vec<&[Stmt]> = self.arms_that_run(&tested.arms);
                self.branches(arms.into_iter(), tested.otherwise.as_deref(), skipped, out);
            }
            StmtKind::CompactIf(tested)
                if self.never_runs(&tested.cond, std::slice::from_ref(&tested.then)) => {}
            StmtKind::CompactIf(tested) => {
                let body = self.body(std::slice::from_ref(&tested.then));
                branch(vec![body], true, out);
            }
            StmtKind::Test(tested) => {
                let cases = tested.cases.iter().map(|(_, body)| body.as_slice());
                self.branches(cases, tested.default.as_deref(), skipped, out);
            }
            StmtKind::For(looped) => {
                let at_least_once = self.runs(&looped.from, &looped.to, looped.step.as_ref());
                let body = self.body(&looped.body);
                if !body.is_empty() {
                    out.push(Node::Loop { body, at_least_once, endless: false });
                }
            }
            StmtKind::While(looped) if self.never_runs(&looped.cond, &looped.body) => {}
            StmtKind::While(looped) => self.while_loop(&looped.cond, &looped.body, at, out),
            StmtKind::Label(name) => out.extend(self.label(*name).map(Node::Label)),
            StmtKind::Goto(name) => out.extend(self.label(*name).map(Node::Goto)),
            StmtKind::Return(_) if skipped => {
                out.push(Node::Branch { arms: vec![vec![Node::Return]], otherwise: true });
            }
            StmtKind::Return(_) => out.push(Node::Return),
            StmtKind::Raise(_) if self.recovery.next => {}
            StmtKind::Raise(_) | StmtKind::Retry | StmtKind::TryNext | StmtKind::Exit => out.push(Node::Stop),
            StmtKind::Opaque => self.opaque_statement(stmt, at, out),
            StmtKind::Connect(connect) => self.connected(connect.trap),
            StmtKind::Data(_) | StmtKind::Empty | StmtKind::Placeholder | StmtKind::Comment => {}
        }
    }

    /// Notes a trap that is not given.
    fn connected(&mut self, trap: TextRange) {
        if self.routine(trap).is_none() {
            self.not_given(lower_case(self.text(trap)), trap);
        }
    }

    /// Notes what is called at `range` and is not given: its name in lower case, and the first place alone.
    fn not_given(&mut self, name: String, range: TextRange) {
        let at = Span { file: self.ctx.file, range };
        self.out.not_given.entry(name).or_insert(at);
    }

    fn opaque_statement(&mut self, stmt: &Stmt, at: Span, out: &mut Vec<Node<'a>>) {
        if let Some(first) = self.sites.motion_at(at.file, stmt) {
            out.push(Node::Step(FlowStep::Motions { first, count: 1 }));
        }
        self.opaque(stmt.range, out);
    }

    /// The bodies of an IF or a TEST; `skipped`: an error in its condition may lead past all of them.
    fn branches(
        &mut self,
        arms: impl Iterator<Item = &'a [Stmt]>,
        otherwise: Option<&'a [Stmt]>,
        skipped: bool,
        out: &mut Vec<Node<'a>>,
    ) {
        let mut bodies: Vec<_> = arms.map(|body| self.body(body)).collect();
        bodies.extend(otherwise.map(|body| self.body(body)));
        branch(bodies, otherwise.is_none() || skipped, out);
    }

    fn fail(&self, out: &mut Vec<Node<'a>>) {
        if self.fallible {
            out.push(Node::Step(FlowStep::MayFail(self.recovery)));
        }
    }

    fn while_loop(&mut self, cond: &'a Expr, body: &'a [Stmt], at: Span, out: &mut Vec<Node<'a>>) {
        let ctx = self.ctx;
        let known = self.evaluator.fold(cond, ctx, &Constant).map(|t| t.value);
        let endless = matches!(known, Ok(Value::Bool(true))) && !self.can_be_set(cond);
        self.functions([cond], at, out);
        let mut body = self.body(body);
        self.functions([cond], at, &mut body);
        if expression_may_fail(cond) {
            self.fail(&mut body);
        }
        out.push(Node::Loop { body, at_least_once: endless, endless });
    }

    /// Whether constants say that a FOR runs at least once.
    fn runs(&mut self, from: &Expr, to: &Expr, step: Option<&Expr>) -> bool {
        if step.is_some_and(|step| [from, to, step].iter().any(|bound| self.can_be_set(bound))) {
            return false;
        }
        let ctx = self.ctx;
        let mut number = |expr| match self.evaluator.fold_held(expr, ctx, &Constant).ok()?.value {
            Value::Num(n) => Some(n),
            _ => None,
        };
        match (number(from), number(to), step.map(number)) {
            (Some(_), Some(_), None) => true, // without STEP it counts towards the end
            (Some(from), Some(to), Some(Some(step))) => step != 0.0 && (to - from) / step >= 0.0,
            _ => false,
        }
    }

    /// What an assignment sets; where it fails TRYNEXT goes on behind it with what was there before.
    fn assignment(&mut self, AssignStmt { target, value }: &'a AssignStmt, at: Span) -> Vec<Node<'a>> {
        let (mut path, mut out) = (Vec::new(), Vec::new());
        if let Some(root) = self.path(target, &mut path) {
            self.assign(root, path, value, at, &mut out);
        } else if let Some((root, _)) = root_of(target) {
            self.invalidate(root, "an element of it is changed", at, &mut out);
        }
        out
    }

    /// The root of `a.b.c` and the names behind it; `None` where an index stands on the way.
    fn path(&self, target: &Expr, path: &mut Vec<Sym>) -> Option<TextRange> {
        match &target.kind {
            ExprKind::Name => Some(target.range),
            ExprKind::Field(field) => {
                let root = self.path(&field.base, path)?;
                path.push(self.label(field.name)?);
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
        let Some(datum) = self.datum(root) else { return };
        if let Some(slot) = self.tracked.slot(datum) {
            out.push(Node::Step(FlowStep::Assign { slot, path, value, ctx: self.ctx, at }));
        }
        self.aliases_change(datum, at, out);
    }

    /// What a name means is no longer known.
    fn invalidate(&self, name: TextRange, what: &str, at: Span, out: &mut Vec<Node<'a>>) {
        let Some(datum) = self.datum(name) else { return };
        if let Some(slot) = self.tracked.slot(datum) {
            let why = self.why(at, what.to_owned());
            out.push(Node::Step(FlowStep::Invalidate { slot, why, at }));
        }
        self.aliases_change(datum, at, out);
    }

    /// A parameter by reference changes with the datum that was handed over, and with another parameter that was handed the same.
    fn aliases_change(&self, datum: DatumId, at: Span, out: &mut Vec<Node<'a>>) {
        for &alias in self.tracked.aliases(datum) {
            let Some(&param) = self.tracked.data.get(alias) else { continue };
            let [param, name] = [param, datum].map(|datum| self.evaluator.name_of(datum));
            let what = match self.index().data[datum].kind {
                DatumKind::Param { .. } => {
                    format!("{param} may stand for what {name} stands for, which is changed")
                }
                DatumKind::Declared(_) | DatumKind::LoopVariable => {
                    format!("{param} stands for {name}, which is changed")
                }
            };
            out.push(Node::Step(FlowStep::Invalidate { slot: alias, why: self.why(at, what), at }));
        }
    }

    fn datum(&self, name: TextRange) -> Option<DatumId> {
        match self.index().datum(name, self.ctx) {
            Resolved::Here(datum) | Resolved::Elsewhere(datum) => Some(datum),
            Resolved::Twice(..) | Resolved::Nowhere => None,
        }
    }

    fn why(&self, at: Span, what: String) -> Why {
        let reason = format!("{what}: {}", self.index().place(at));
        Rc::new(SkipReason { code: "keep::runtime-target", reason, because: Some(at) })
    }
}

fn branch<'a>(arms: Vec<Vec<Node<'a>>>, otherwise: bool, out: &mut Vec<Node<'a>>) {
    if arms.iter().any(|arm| !arm.is_empty()) {
        out.push(Node::Branch { arms, otherwise });
    }
}
