//! Every value that an expression can have, where it is one of a few that are all known: of data that are assigned from
//! constants, of parameters whose calls all hand over such values, of variables of FOR loops with constant bounds. What is
//! changed in part or from what it was, the ways through the program tell ([`targets_on_ways`](super::state::targets_on_ways)).
//!
//! A superset is enough: which of the values it is, run time tells. What may be changed in another way (in part, by an
//! instruction, through a parameter, in a trap or a handler, by another task, by a name that is computed) has no such set.

use super::call_arguments::match_arguments;
use super::const_eval::{ConstEvaluator, Constant, TrackedValues};
use super::expressions::{every_call, expressions_of, words};
use super::ids::{DatumId, IdSet, RoutineIndex};
use super::index::{Ctx, DatumKind, Index, Resolved};
use super::names::ByNumber;
use super::repeated_moves::every_naming_statement;
use super::statements::bodies;
use super::tracked::names_in;
use super::value::Value;
use super::writes::How;
use rapid_syntax::diagnostic::{FileId, TextRange};
use rapid_syntax::tree::{Arg, Callee, DataKind, Expr, ExprKind, ModuleItem, StmtKind};
use std::rc::Rc;

/// More values than these are not asked for: a motion would have to look through them.
pub(super) const MOST_VALUES: usize = 32;
/// More combinations of the data in one expression are not tried.
const MOST_COMBINATIONS: usize = 64;

/// The values that something can have, and the data that they come from.
#[derive(Clone, Debug, Default)]
pub(super) struct FiniteSet {
    pub(super) values: Vec<Value>,
    pub(super) made_of: IdSet<DatumId>,
}

/// What of a program's text gives data their values.
#[derive(Debug, Default)]
pub(super) struct FiniteSets<'a> {
    /// What is assigned to each datum as a whole.
    assigned: ByNumber<DatumId, Vec<(Ctx, &'a Expr)>>,
    /// Data of which a part is assigned.
    in_part: IdSet<DatumId>,
    /// For each call of a routine what it hands to a required parameter; `None` where that cannot be told.
    handed: ByNumber<DatumId, Vec<Option<(Ctx, &'a Expr)>>>,
    /// First, last and step of FOR loops, by their variable.
    loops: ByNumber<(FileId, TextRange), [Option<&'a Expr>; 3]>,
    /// Text that was not understood may call these.
    doubtful: IdSet<RoutineIndex>,
    /// A routine is called with arguments by a name that is computed: it may be any.
    any_called: bool,
    known: ByNumber<DatumId, Option<Rc<FiniteSet>>>,
    busy: Vec<DatumId>,
}

/// Data have these values.
#[derive(Clone)]
struct Assumed(Vec<(DatumId, Value)>);

impl TrackedValues for Assumed {
    fn value(&self, datum: DatumId) -> Option<Value> {
        self.0.iter().find(|(known, _)| *known == datum).map(|(_, value)| value.clone())
    }
}

impl<'a> FiniteSets<'a> {
    /// Of all given files.
    pub(super) fn new(index: &Index<'a>) -> Self {
        let mut sets = Self::default();
        for routine in &index.routines {
            for body in bodies(routine.tree) {
                let ctx = routine.ctx;
                every_naming_statement(index, ctx, body, &mut |stmt| {
                    match &stmt.kind {
                        StmtKind::Assign(assign) => sets.assign(index, ctx, &assign.target, &assign.value),
                        StmtKind::For(looped) => {
                            let bounds = [Some(&looped.from), Some(&looped.to), looped.step.as_ref()];
                            sets.loops.insert((ctx.file, looped.var), bounds);
                        }
                        StmtKind::Call(call) => match &call.callee {
                            Callee::Name(name) => sets.call(index, ctx, *name, &call.args),
                            Callee::Late(_) => sets.any_called |= !call.args.is_empty(),
                        },
                        StmtKind::Opaque => sets.not_read(index, ctx, stmt.range),
                        _ => {}
                    }
                    for expr in expressions_of(stmt) {
                        every_call(expr, &mut |name, args| sets.call(index, ctx, name, args));
                    }
                });
            }
        }
        for (id, module) in index.modules.numbered() {
            let ctx = Ctx { file: module.file, module: id, routine: None };
            for item in &module.tree.items {
                if let ModuleItem::Opaque(range) = item {
                    sets.not_read(index, ctx, *range);
                }
            }
        }
        sets
    }

    /// Whether one of the data is a parameter that a call may hand over which the text does not tell.
    pub(super) fn are_handed_unseen(&self, index: &Index<'_>, data: &IdSet<DatumId>) -> bool {
        data.iter().any(|datum| match index.data[datum].kind {
            DatumKind::Param { optional, .. } => {
                let routine = index.data[datum].ctx.routine;
                optional || self.any_called || routine.is_none_or(|id| self.doubtful.contains(id))
            }
            DatumKind::LoopVariable | DatumKind::Declared(_) => false,
        })
    }

    fn assign(&mut self, index: &Index<'a>, ctx: Ctx, target: &'a Expr, value: &'a Expr) {
        if matches!(target.kind, ExprKind::Name) {
            if let Resolved::Here(datum) | Resolved::Elsewhere(datum) = index.datum(target.range, ctx) {
                self.assigned.entry(datum).or_default().push((ctx, value));
            }
        } else {
            names_in(index, ctx, target, &mut |datum| {
                self.in_part.insert(datum);
            });
        }
    }

    fn call(&mut self, index: &Index<'a>, ctx: Ctx, name: TextRange, args: &'a [Arg]) {
        let Some(name) = index.name_at(ctx.file, name) else { return };
        let callees = match index.routine(name, ctx) {
            Resolved::Here(callee) | Resolved::Elsewhere(callee) => vec![callee],
            Resolved::Twice(one, other) => vec![one, other],
            Resolved::Nowhere => return,
        };
        for callee in callees {
            let given = match_arguments(index, ctx, callee, args);
            let Some(routine) = index.routines.get(callee) else { continue };
            for &param in &routine.params {
                let value = given.iter().find(|given| given.param == param).and_then(|given| given.value);
                self.handed.entry(param).or_default().push(value.map(|value| (ctx, value)));
            }
        }
    }

    /// Text that was not understood: the routines that it names may be called in it.
    fn not_read(&mut self, index: &Index<'a>, ctx: Ctx, range: TextRange) {
        for word in words(index.text(ctx.file, range), range.start) {
            let routine = index.name_at(ctx.file, word).map(|name| index.routine(name, ctx));
            if let Some(Resolved::Here(id) | Resolved::Elsewhere(id) | Resolved::Twice(id, _)) = routine {
                self.doubtful.insert(id);
            }
        }
    }

    /// The values that an expression can have; `None` where they are not all known, or too many.
    pub(super) fn of(
        &mut self,
        evaluator: &mut ConstEvaluator<'a>,
        expr: &'a Expr,
        ctx: Ctx,
    ) -> Option<FiniteSet> {
        let index = evaluator.index;
        let mut made_of = IdSet::default();
        names_in(index, ctx, expr, &mut |datum| {
            made_of.insert(datum);
        });
        let mut combinations = vec![Assumed(Vec::new())];
        for datum in made_of.clone().iter() {
            let changes = match index.data[datum].kind {
                DatumKind::Param { .. } | DatumKind::LoopVariable => true,
                DatumKind::Declared(DataKind::Const) => false,
                DatumKind::Declared(_) => evaluator.writes.first(datum).is_some(),
            };
            if !changes {
                continue;
            }
            let set = self.of_datum(evaluator, datum)?;
            made_of.add_all(&set.made_of);
            let with = |known: &Assumed, value: &Value| {
                let mut known = known.clone();
                known.0.push((datum, value.clone()));
                known
            };
            combinations = combinations.iter().flat_map(|c| set.values.iter().map(|v| with(c, v))).collect();
            if combinations.len() > MOST_COMBINATIONS {
                return None;
            }
        }
        let mut values: Vec<Value> = Vec::new();
        for assumed in &combinations {
            let value = evaluator.fold(expr, ctx, assumed).ok()?.value;
            if matches!(value, Value::Unknown(_) | Value::Reached(_)) {
                return None;
            }
            if !values.contains(&value) {
                values.push(value);
            }
        }
        (values.len() <= MOST_VALUES).then_some(FiniteSet { values, made_of })
    }

    fn of_datum(&mut self, evaluator: &mut ConstEvaluator<'a>, datum: DatumId) -> Option<Rc<FiniteSet>> {
        if let Some(known) = self.known.get(&datum) {
            return known.clone();
        }
        if self.busy.contains(&datum) {
            return None; // it is made of itself: a counter, a recursion
        }
        self.busy.push(datum);
        let found = self.found(evaluator, datum).map(Rc::new);
        self.busy.pop();
        if self.busy.is_empty() || found.is_some() {
            self.known.insert(datum, found.clone());
        }
        found
    }

    fn found(&mut self, evaluator: &mut ConstEvaluator<'a>, datum: DatumId) -> Option<FiniteSet> {
        let (index, writes) = (evaluator.index, evaluator.writes);
        let entry = &index.data[datum];
        let written_otherwise = writes.worst(datum).is_some_and(|how| how != How::Assigned);
        if entry.array || written_otherwise || self.in_part.contains(datum) {
            return None;
        }
        let mut from: Vec<(Ctx, &'a Expr)> = self.assigned.get(&datum).cloned().unwrap_or_default();
        let mut set = FiniteSet { values: Vec::new(), made_of: IdSet::from_iter([datum]) };
        match entry.kind {
            DatumKind::LoopVariable => {
                set.values = self.counted(evaluator, entry.ctx, entry.name_range)?;
                return Some(set);
            }
            DatumKind::Param { optional, .. } => {
                let routine = entry.ctx.routine?;
                if optional || self.any_called || self.doubtful.contains(routine) {
                    return None;
                }
                let handed = self.handed.get(&datum)?.iter().copied().collect::<Option<Vec<_>>>()?;
                from.extend(handed);
            }
            DatumKind::Declared(kind) => {
                if writes.by_computed_name(index, datum).is_some() {
                    return None;
                }
                match (entry.init, index.type_text(entry.type_name)) {
                    (Some(init), _) => from.push((entry.ctx, init)),
                    (None, "num") if kind == DataKind::Var => set.values.push(Value::Num(0.0)),
                    // Without a value its quaternion is zero: no controller moves to it.
                    (None, "robtarget") if kind == DataKind::Var => {}
                    (None, _) => return None,
                }
            }
        }
        for (ctx, expr) in from {
            let more = self.of(evaluator, expr, ctx)?;
            set.made_of.add_all(&more.made_of);
            for value in more.values {
                if !set.values.contains(&value) {
                    set.values.push(value);
                }
            }
        }
        (set.values.len() <= MOST_VALUES).then_some(set)
    }

    /// What the variable of a FOR loop with constant bounds counts through.
    fn counted(&self, evaluator: &mut ConstEvaluator<'a>, ctx: Ctx, var: TextRange) -> Option<Vec<Value>> {
        let [from, to, step] = self.loops.get(&(ctx.file, var)).copied()?;
        let mut number = |expr: &Expr| match evaluator.fold_held(expr, ctx, &Constant).ok()?.value {
            Value::Num(n) => Some(n as f32),
            _ => None,
        };
        let (from, to) = (number(from?)?, number(to?)?);
        let step = match step {
            Some(step) => number(step)?,
            None if to < from => -1.0, // without STEP it counts towards the end
            None => 1.0,
        };
        let mut values = Vec::new();
        let mut at = from;
        // In single precision, as the controller counts: 7.4 three times is 22.2 there.
        while step != 0.0 && (if step > 0.0 { at <= to } else { at >= to }) {
            values.push(Value::of_single(at));
            at += step;
            if values.len() > MOST_VALUES {
                return None;
            }
        }
        (!values.is_empty()).then_some(values)
    }
}
