//! Calls of procedures and functions: which routines they reach, with what.

use super::CfgBuilder;
use crate::built_in::is_built_in_function;
use crate::call_arguments::{NotGiven, doubtful_arguments, match_arguments};
use crate::const_eval::Constant;
use crate::errors::arguments_may_fail;
use crate::expressions::every_call;
use crate::file_values::can_be_set;
use crate::flow::{Binding, FlowStep, Node};
use crate::ids::{DatumId, RoutineIndex};
use crate::index::{DatumKind, Resolved};
use crate::interrupting::called_by;
use crate::motion::MotionId;
use crate::move_instructions::Special;
use crate::names::{as_text, lower_case};
use crate::value::Value;
use rapid_syntax::diagnostic::{Span, TextRange};
use rapid_syntax::tree::{Arg, ArgKind, BinaryOp, CallStmt, Callee, Expr, ExprKind, RoutineKind, Stmt};

impl<'a> CfgBuilder<'_, 'a> {
    pub(super) fn call(&mut self, stmt: &'a Stmt, call: &'a CallStmt, at: Span, out: &mut Vec<Node<'a>>) {
        if let Some(motion) = self.sites.motion_at(at.file, stmt) {
            match out.last_mut() {
                Some(Node::Step(FlowStep::Motions { first, count }))
                    if first.index() + *count as usize == motion.index()
                        && self.is_plain(*first)
                        && self.is_plain(motion) =>
                {
                    *count += 1;
                }
                _ => out.push(Node::Step(FlowStep::Motions { first: motion, count: 1 })),
            }
            self.external_axes(motion, at, out);
            self.written(call, at, out);
            self.force_control(motion, at, out);
            self.called_in_corner(call);
            if let (true, Callee::Name(name)) = (self.is_not_given(motion), &call.callee) {
                self.instruction(*name, call, at, out);
            }
            return;
        }
        match &call.callee {
            Callee::Late(expr) => self.late(expr, &call.args, at, out),
            Callee::Name(name) => match self.routine(*name) {
                Some(routine) => {
                    let skipped = self.recovery.next && arguments_may_fail(&call.args);
                    out.push(self.known_call(vec![routine], &call.args, skipped));
                }
                None => {
                    self.written(call, at, out);
                    self.instruction(*name, call, at, out);
                }
            },
        }
    }

    /// Notes a procedure that a move calls in its corner, by a name that the text tells, where none is given.
    fn called_in_corner(&mut self, call: &'a CallStmt) {
        let Some(text) = called_by(self.index(), self.ctx, call) else { return };
        let Some(called) = self.fixed_text(text) else { return };
        let name = called.rsplit(':').next().unwrap_or_default().to_owned();
        if self.procedures(0, &|other| other == name).is_empty() {
            self.not_given(name, text.range);
        }
    }

    /// Whether the arm stands at the target behind a motion.
    fn is_plain(&self, motion: MotionId) -> bool {
        let site = self.sites.motions.get(motion.index());
        site.is_some_and(|site| matches!(site.form.special, Special::Plain | Special::Unsupported))
    }

    /// Whether it is a call of what is not among the files.
    fn is_not_given(&self, motion: MotionId) -> bool {
        let site = self.sites.motions.get(motion.index());
        site.is_some_and(|site| site.form.special == Special::NotGiven)
    }

    pub(super) fn routine(&self, name: TextRange) -> Option<RoutineIndex> {
        match self.index().routine(self.label(name)?, self.ctx) {
            Resolved::Here(id) | Resolved::Elsewhere(id) | Resolved::Twice(id, _) => Some(id),
            Resolved::Nowhere => None,
        }
    }

    pub(super) fn known_call(&self, routines: Vec<RoutineIndex>, args: &'a [Arg], maybe: bool) -> Node<'a> {
        let mut bindings = Vec::new();
        for &routine in &routines {
            let given = match_arguments(self.index(), self.ctx, routine, args);
            let params = self.index().routines.get(routine).map_or(&[][..], |r| &r.params);
            for &param in params {
                if let Some(slot) = self.tracked.slot(param) {
                    let value = given.iter().find(|given| given.param == param).and_then(|given| given.value);
                    bindings.push(Binding { slot, param, value });
                }
            }
        }
        Node::Step(FlowStep::Call { routines, bindings, maybe, recovery: self.recovery, ctx: self.ctx })
    }

    /// Functions that are called in expressions, those of the program and those that are not given.
    pub(super) fn functions(
        &mut self,
        expressions: impl IntoIterator<Item = &'a Expr>,
        at: Span,
        out: &mut Vec<Node<'a>>,
    ) {
        for expr in expressions {
            every_call(expr, &mut |name, args| match self.routine(name) {
                Some(routine) => out.push(self.known_call(vec![routine], args, true)),
                None if is_built_in_function(&lower_case(self.text(name))) => {}
                None => {
                    self.doubtful(name, args, NotGiven::Function, at, out);
                    self.not_given(lower_case(self.text(name)), name);
                }
            });
        }
    }

    /// Tracked data that a routine that is not given may write.
    pub(super) fn doubtful(
        &self,
        name: TextRange,
        args: &[Arg],
        callee: NotGiven,
        at: Span,
        out: &mut Vec<Node<'a>>,
    ) {
        for root in doubtful_arguments(self.index(), self.ctx, args, callee) {
            let written = as_text(self.text(name));
            self.invalidate(root, &format!("{written} is not given and may change it"), at, out);
        }
    }

    /// A call by a name that is worked out at run time: one of the routines whose name fits.
    fn late(&mut self, expr: &'a Expr, args: &'a [Arg], stmt: Span, out: &mut Vec<Node<'a>>) {
        let required = args.iter().filter(|a| matches!(a.kind, ArgKind::Positional(_))).count();
        let called = self.called_name(expr);
        let (start, whole) = (called.start.rsplit(':').next().unwrap_or_default().to_owned(), called.whole);
        let fits = |name: &str| match whole {
            true => name == start,
            false => name.starts_with(&start) && name.ends_with(&called.end) && name != "main",
        };
        let routines = self.procedures(required, &fits);
        if !routines.is_empty() {
            out.push(self.known_call(routines.clone(), args, !whole || self.recovery.next));
        }
        if routines.is_empty() {
            self.doubtful(expr.range, args, NotGiven::Procedure, stmt, out);
        }
        if routines.is_empty() {
            let name = if whole { start } else { self.computed_name(expr) };
            self.not_given(name, expr.range);
        }
        if !whole || routines.is_empty() {
            out.push(Node::Step(FlowStep::UnknownPosition));
        }
    }

    /// What stands in a message for the procedure whose name an expression works out.
    fn computed_name(&self, expr: &Expr) -> String {
        format!("the procedure that {} names", as_text(self.text(expr.range)))
    }

    /// The procedures of the same task with so many `required` parameters whose name fits.
    fn procedures(&self, required: usize, fits: &dyn Fn(&str) -> bool) -> Vec<RoutineIndex> {
        let index = self.index();
        let task = index.modules.get(self.ctx.module).map(|m| m.task);
        let is_meant = |id: &RoutineIndex| {
            let entry = &index.routines[*id];
            let wanted =
                |&&p: &&DatumId| !matches!(index.data[p].kind, DatumKind::Param { optional: true, .. });
            entry.tree.kind == RoutineKind::Proc
                && index.modules.get(entry.ctx.module).map(|m| m.task) == task
                && entry.params.iter().filter(wanted).count() == required
                && fits(index.names.text(entry.name))
        };
        index.routines.ids().filter(is_meant).collect()
    }

    /// What the text tells of a name that is worked out at run time.
    fn called_name(&mut self, expr: &Expr) -> CalledName {
        match self.fixed_text(expr) {
            Some(start) => CalledName { start, end: String::new(), whole: true },
            None => {
                let [start, end] = [true, false].map(|first| self.literal(expr, first));
                CalledName { start, end, whole: false }
            }
        }
    }

    /// The text, in lower case, that an expression is on every controller.
    fn fixed_text(&mut self, expr: &Expr) -> Option<String> {
        if self.can_be_set(expr) {
            return None;
        }
        let ctx = self.ctx;
        match self.evaluator.fold(expr, ctx, &Constant).ok()?.value {
            Value::Text(text) => Some(lower_case(&text)),
            _ => None,
        }
    }

    /// Whether a PERS goes into an expression: a pendant, an operator panel or another task sets such data, so that a controller may hold
    /// another value than the text has.
    pub(super) fn can_be_set(&self, expr: &Expr) -> bool {
        can_be_set(self.index(), self.ctx, expr)
    }

    /// The text, in lower case, that a sum of strings begins or ends with.
    fn literal(&mut self, expr: &Expr, first: bool) -> String {
        match &expr.kind {
            ExprKind::Paren(inner) => self.literal(inner, first),
            ExprKind::Binary(sum) if sum.op == BinaryOp::Add => {
                self.literal(if first { &sum.lhs } else { &sum.rhs }, first)
            }
            ExprKind::String | ExprKind::Name => self.fixed_text(expr).unwrap_or_default(),
            _ => String::new(),
        }
    }

    /// `CallByVar "proc", n`: one of the procedures whose name is the text and a number.
    pub(super) fn call_by_number(&mut self, call: &CallStmt, out: &mut Vec<Node<'a>>) {
        let Some(ArgKind::Positional(text)) = call.args.first().map(|arg| &arg.kind) else { return };
        let called = self.called_name(text);
        let fits = |name: &str| {
            let text = name.trim_end_matches(|c: char| c.is_ascii_digit());
            match called.whole {
                true => name.strip_prefix(&called.start).is_some_and(is_number),
                // Of what is not known the end may be a digit, too.
                false => name.len() > text.len() && name.starts_with(&called.start),
            }
        };
        let routines = self.procedures(0, &fits);
        if !routines.is_empty() {
            out.push(self.known_call(routines, &[], true));
            return;
        }
        let name = self.computed_name(text);
        self.not_given(format!("{name} with a number"), text.range);
    }
}

/// What the text tells of a name, in lower case.
struct CalledName {
    start: String,
    /// Nothing where `start` is all of it.
    end: String,
    whole: bool,
}

fn is_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit())
}
