//! What a constant expression is worth.
//!
//! CONST folds, and so does a VAR or PERS with an initial value that nothing in the given files changes.
//! Data that the program changes are worth what the state says at that point, where they are tracked,
//! else nothing: the reason names the line that changes them.

use super::convert;
use super::functions;
use super::ids::DatumId;
use super::index::{Ctx, DatumKind, Index, Resolved};
use super::motion::SkipReason;
use super::names::{ByNumber, Sym, as_text};
use super::other_tasks;
use super::predefined::{is_predefined, predefined};
use super::value::{self, DataName, Reached, Value, Why, needs_kinematics, why, wrong_type};
use super::writes::{How, Writes};
use rapid_syntax::diagnostic::{Diagnostic, FileId, Span, TextRange};
use rapid_syntax::parts_of_numbers;
use rapid_syntax::tree::{Arg, ArgKind, BinaryOp, DataKind, Expr, ExprKind, UnaryOp};
use std::collections::BTreeMap;
use std::rc::Rc;

/// Constants that refer to constants deeper than this are not followed.
const DEEPEST: usize = 100;

/// A value and the type it is known to be of.
#[derive(Clone, Debug)]
pub(super) struct Typed {
    pub(super) value: Value,
    pub(super) type_name: Option<Sym>,
}

/// What the data that the program changes are worth at one point of it.
pub(super) trait TrackedValues {
    /// The value of a datum that is tracked.
    fn value(&self, datum: DatumId) -> Option<Value>;
}

/// No datum is tracked: constants alone are known.
pub(super) struct Constant;

impl TrackedValues for Constant {
    fn value(&self, _: DatumId) -> Option<Value> {
        None
    }
}

/// Folds expressions; remembers what constants are worth.
pub(super) struct ConstEvaluator<'a> {
    pub(super) index: &'a Index<'a>,
    pub(super) writes: &'a Writes,
    /// Values given from outside: type and value by name in lower case.
    pub(super) given: BTreeMap<String, (&'static str, Value)>,
    /// Predefined data that were asked for, by name in lower case.
    predefined: BTreeMap<String, (&'static str, Value)>,
    /// Names that were found only LOCAL to another module, with their first use.
    pub(super) elsewhere: ByNumber<DatumId, Span>,
    known: ByNumber<DatumId, Result<Value, Why>>,
    busy: Vec<DatumId>,
    at_element: Option<AtElement>,
}

/// What the indices of some array elements in one expression are taken to be.
struct AtElement {
    file: FileId,
    elements: Vec<TextRange>,
    indices: Vec<f64>,
}

impl<'a> ConstEvaluator<'a> {
    pub(super) fn new(index: &'a Index<'a>, writes: &'a Writes) -> Self {
        Self {
            index,
            writes,
            given: BTreeMap::new(),
            predefined: BTreeMap::new(),
            elsewhere: ByNumber::default(),
            known: ByNumber::default(),
            busy: Vec::new(),
            at_element: None,
        }
    }

    /// Warnings about names that a controller would not find from where they are used.
    pub(super) fn elsewhere_warnings(&self) -> Vec<Diagnostic> {
        let warning = |(&datum, &span): (&DatumId, &Span)| {
            let entry = &self.index.data[datum];
            let name = as_text(self.index.text(entry.ctx.file, entry.name_range));
            let module = self.index.modules.get(entry.ctx.module).map(|m| m.tree.name);
            let module = module.map_or(String::new(), |m| as_text(self.index.text(entry.ctx.file, m)));
            let text = format!("{name} is LOCAL to module {module}, and used outside of it");
            Diagnostic::warning("resolve::local-elsewhere", text)
                .at(span)
                .label(self.index.declaration(datum), "declared LOCAL here")
                .help("its value is used; a controller does not find it unless LOCAL is taken away")
        };
        let mut elsewhere: Vec<_> = self.elsewhere.iter().collect();
        elsewhere.sort_unstable();
        elsewhere.into_iter().map(warning).collect()
    }

    /// What an expression is worth.
    pub(super) fn fold(&mut self, expr: &Expr, ctx: Ctx, state: &dyn TrackedValues) -> Result<Typed, Why> {
        self.fold_typed(expr, ctx, state).map_err(|why| match why.because {
            Some(_) => why,
            None => Rc::new(SkipReason { because: Some(span(ctx, expr.range)), ..(*why).clone() }),
        })
    }

    /// What an expression of constants is worth where the array elements that stand in it at `elements` are those with these
    /// indices.
    pub(super) fn fold_at(
        &mut self,
        expr: &Expr,
        ctx: Ctx,
        (elements, indices): (&[TextRange], &[f64]),
    ) -> Result<Value, Why> {
        let (elements, indices) = (elements.to_vec(), indices.to_vec());
        self.at_element = Some(AtElement { file: ctx.file, elements, indices });
        let folded = self.fold(expr, ctx, &Constant);
        self.at_element = None;
        folded.map(|typed| typed.value)
    }

    fn fold_typed(&mut self, expr: &Expr, ctx: Ctx, state: &dyn TrackedValues) -> Result<Typed, Why> {
        let untyped = |value| Typed { value, type_name: None };
        let source = |range| self.index.text(ctx.file, range);
        match &expr.kind {
            ExprKind::Number => match value::number(source(expr.range)) {
                Some(n) => Ok(untyped(Value::Num(n))),
                None => Err(why("keep::bad-number", format!("{} is no number", as_text(source(expr.range))))),
            },
            ExprKind::String => Ok(untyped(Value::Text(value::string(source(expr.range)).into()))),
            ExprKind::Bool(b) => Ok(untyped(Value::Bool(*b))),
            ExprKind::Name => self.name(expr.range, ctx, state),
            ExprKind::Paren(inner) => self.fold_typed(inner, ctx, state),
            ExprKind::Aggregate(parts) => {
                let parts: Result<Rc<[Value]>, Why> =
                    parts.iter().map(|p| self.fold_typed(p, ctx, state).map(|t| t.value)).collect();
                Ok(untyped(Value::Parts(parts?)))
            }
            ExprKind::Numbers => {
                if let Some(value) = Value::of_plain_list(source(expr.range)) {
                    return Ok(untyped(value));
                }
                let parts = parts_of_numbers(&self.index.file(ctx.file).bytes, expr.range);
                let parts: Result<Rc<[Value]>, Why> =
                    parts.iter().map(|p| self.fold_typed(p, ctx, state).map(|t| t.value)).collect();
                Ok(untyped(Value::Parts(parts?)))
            }
            ExprKind::Field(field) => {
                let base = self.fold_typed(&field.base, ctx, state)?;
                self.component(&base, field.name, ctx)
            }
            ExprKind::Index(element_of) => {
                let base = self.fold_typed(&element_of.base, ctx, state)?;
                let is_meant = |at: &&AtElement| at.file == ctx.file && at.elements.contains(&expr.range);
                let indices = match self.at_element.as_ref().filter(is_meant) {
                    Some(at) => at.indices.clone(),
                    None => {
                        let number = |index| match self.fold_typed(index, ctx, state)?.value {
                            Value::Num(n) => Ok(n),
                            _ => Err(wrong_type()),
                        };
                        element_of.indices.iter().map(number).collect::<Result<_, _>>()?
                    }
                };
                let value = indices.into_iter().try_fold(base.value, |value, n| element(&value, n))?;
                Ok(Typed { value, type_name: base.type_name })
            }
            ExprKind::Call(call) => self.call(call.name, &call.args, ctx, state).map(untyped),
            ExprKind::Unary { op, operand } => {
                let operand = self.fold_typed(operand, ctx, state)?.value;
                unary(*op, &operand).map(untyped)
            }
            ExprKind::Binary(binary) => {
                let lhs = self.fold_typed(&binary.lhs, ctx, state)?;
                let rhs = self.fold_typed(&binary.rhs, ctx, state)?;
                let value = functions::binary(binary.op, &lhs.value, &rhs.value)?;
                let keeps = matches!(binary.op, BinaryOp::Add | BinaryOp::Sub);
                Ok(Typed { value, type_name: lhs.type_name.filter(|_| keeps) })
            }
            ExprKind::Placeholder => Err(why("keep::placeholder", "a placeholder stands here".into())),
            ExprKind::Opaque => Err(why("keep::not-read", "this text was not understood".into())),
        }
    }

    fn name(&mut self, range: TextRange, ctx: Ctx, state: &dyn TrackedValues) -> Result<Typed, Why> {
        match self.resolve(range, ctx) {
            Ok(NameMeaning::Datum(datum)) => {
                let type_name = Some(self.index.data[datum].type_name);
                self.datum(datum, state).map(|value| Typed { value, type_name })
            }
            Ok(NameMeaning::Predefined(name)) => {
                let (type_name, value) = match self.given.get(&name).or(self.predefined.get(&name)) {
                    Some((type_name, value)) => (*type_name, value.clone()),
                    None => {
                        let made = predefined(&name).ok_or_else(wrong_type)?;
                        self.predefined.insert(name, made.clone());
                        made
                    }
                };
                Ok(Typed { value, type_name: self.index.names.find(type_name.as_bytes()) })
            }
            Err(why) => Err(why),
        }
    }

    /// What a name means.
    pub(super) fn resolve(&mut self, range: TextRange, ctx: Ctx) -> Result<NameMeaning, Why> {
        let written = self.index.text(ctx.file, range);
        let resolved = self.index.datum(range, ctx);
        let lower = || super::names::lower_case(written);
        match resolved {
            Resolved::Here(datum) => Ok(NameMeaning::Datum(datum)),
            Resolved::Elsewhere(datum) => {
                if is_predefined(&lower()) {
                    return Ok(NameMeaning::Predefined(lower()));
                }
                self.elsewhere.entry(datum).or_insert(span(ctx, range));
                Ok(NameMeaning::Datum(datum))
            }
            Resolved::Twice(first, second) => {
                let places = [first, second].map(|d| self.index.place(self.index.declaration(d)));
                let text = format!("{} is declared twice: {} and {}", as_text(written), places[0], places[1]);
                let because = Some(self.index.declaration(second));
                Err(Rc::new(SkipReason { code: "keep::ambiguous", reason: text, because }))
            }
            Resolved::Nowhere => {
                let lower = lower();
                if is_predefined(&lower) || self.given.contains_key(&lower) {
                    return Ok(NameMeaning::Predefined(lower));
                }
                let text = format!("{} is not declared in the given files", as_text(written));
                Err(why("keep::not-declared", text))
            }
        }
    }

    /// The tool or work object that an argument names.
    pub(super) fn data_name(&mut self, expr: &Expr, ctx: Ctx) -> Option<DataName> {
        let ExprKind::Name = expr.kind else { return None };
        Some(match self.resolve(expr.range, ctx).ok()? {
            NameMeaning::Datum(datum) => DataName::Declared(datum),
            NameMeaning::Predefined(name) => DataName::Predefined(name),
        })
    }

    /// What a datum is worth.
    pub(super) fn datum(&mut self, datum: DatumId, state: &dyn TrackedValues) -> Result<Value, Why> {
        if let Some(value) = state.value(datum) {
            return match value {
                Value::Unknown(why) => Err(why),
                value => Ok(value),
            };
        }
        let entry = &self.index.data[datum];
        match entry.kind {
            DatumKind::Param { .. } => {
                return Err(self.about(datum, "keep::parameter", "is a parameter of the routine"));
            }
            DatumKind::LoopVariable => {
                return Err(self.about(datum, "keep::loop-variable", "counts a loop"));
            }
            DatumKind::Declared(DataKind::Const) => {}
            DatumKind::Declared(_) => {
                if let Some(write) = self.writes.first(datum) {
                    return Err(self.changed(datum, write.at, write.how));
                }
                if let Some(at) = self.writes.by_computed_name {
                    return Err(self.changed(datum, at, How::Perhaps));
                }
            }
        }
        self.initial(datum)
    }

    /// The initial value of a datum, whatever becomes of it later.
    pub(super) fn initial(&mut self, datum: DatumId) -> Result<Value, Why> {
        if let Some(known) = self.known.get(&datum) {
            return known.clone();
        }
        if self.busy.contains(&datum) {
            return Err(self.about(datum, "keep::cyclic", "is declared by way of itself"));
        }
        if self.busy.len() >= DEEPEST {
            return Err(self.about(datum, "keep::too-deep", "is declared by too long a chain of names"));
        }
        let entry = &self.index.data[datum];
        let Some(init) = entry.init else {
            let place = self.index.place(self.index.declaration(datum));
            return Err(self.about(datum, "keep::no-value", &format!("has no initial value: {place}")));
        };
        self.busy.push(datum);
        let folded = self.fold(init, entry.ctx, &Constant).map(|t| t.value);
        self.busy.pop();
        self.known.insert(datum, folded.clone());
        folded
    }

    /// The reason for a datum that the program changes.
    pub(super) fn changed(&self, datum: DatumId, at: Span, how: How) -> Why {
        let place = self.index.place(at);
        let name = self.name_of(datum);
        let reason = match how {
            How::Assigned | How::Instruction => format!("{name} is changed at run time: {place}"),
            How::AnyTime => format!("{name} is changed at any time by {place}"),
            How::Aliased => format!("{name} is changed in part or through a parameter: {place}"),
            How::Perhaps => format!("{name} may be changed at run time: {place}"),
            How::OtherTask => {
                let path = &self.index.file(at.file).path;
                let task = super::task_of(path).unwrap_or("another task");
                format!("{name} is shared with {task}, which changes it at any time: {place}")
            }
        };
        let code = if how == How::OtherTask { other_tasks::CODE } else { "keep::runtime-target" };
        Rc::new(SkipReason { code, reason, because: Some(at) })
    }

    fn about(&self, datum: DatumId, code: &'static str, what: &str) -> Why {
        let reason = format!("{} {what}", self.name_of(datum));
        Rc::new(SkipReason { code, reason, because: Some(self.index.declaration(datum)) })
    }

    /// The name of a datum as it is declared.
    pub(super) fn name_of(&self, datum: DatumId) -> String {
        let entry = &self.index.data[datum];
        as_text(self.index.text(entry.ctx.file, entry.name_range))
    }

    fn component(&self, base: &Typed, name: TextRange, ctx: Ctx) -> Result<Typed, Why> {
        let wanted = self.index.name_at(ctx.file, name);
        let components = base.type_name.and_then(|t| self.index.components(t));
        let position = components.as_ref().and_then(|c| c.iter().position(|(n, _)| Some(*n) == wanted));
        match (&base.value, position, components) {
            (Value::Parts(parts), Some(at), Some(components)) if at < parts.len() => match &parts[at] {
                Value::Unknown(why) => Err(why.clone()),
                value => Ok(Typed { value: value.clone(), type_name: Some(components[at].1) }),
            },
            (Value::Reached(_), ..) => Err(needs_kinematics("a component of CalcRobT")),
            (Value::Parts(_), _, None) if base.type_name.is_some() => {
                let type_name = base.type_name.map_or("", |name| self.index.type_text(name));
                Err(why(
                    "keep::not-declared",
                    format!("the type {type_name} is not declared in the given files"),
                ))
            }
            _ => {
                let name = as_text(self.index.text(ctx.file, name));
                Err(why("keep::wrong-type", format!("there is no component {name} here")))
            }
        }
    }

    fn call(
        &mut self,
        name: TextRange,
        args: &[Arg],
        ctx: Ctx,
        state: &dyn TrackedValues,
    ) -> Result<Value, Why> {
        let written = as_text(self.index.text(ctx.file, name));
        if self.index.declares_routine(name, ctx) {
            return Err(function_result(&written));
        }
        let lower = super::names::lower_case(written.as_bytes());
        if lower == "calcrobt" {
            return self.calc_rob_t(args, ctx, state);
        }
        if !functions::is_known(&lower) {
            return Err(match lower.as_str() {
                "calcjointt" => needs_kinematics("CalcJointT"),
                _ => function_result(&written),
            });
        }
        let mut positional = Vec::new();
        let mut options = Vec::new();
        for arg in args {
            match &arg.kind {
                ArgKind::Positional(expr) => positional.push(self.fold_typed(expr, ctx, state)?.value),
                ArgKind::Named { name, value } => {
                    let name = super::names::lower_case(self.index.text(ctx.file, *name));
                    let value = match value {
                        Some(expr) => self.fold_typed(expr, ctx, state)?.value,
                        None => Value::Bool(true),
                    };
                    options.push((name, value));
                }
                ArgKind::Conditional { .. } => {
                    return Err(why("keep::parameter", "an argument is handed on if present".into()));
                }
            }
        }
        functions::apply(&lower, &positional, &options)
    }

    fn calc_rob_t(&mut self, args: &[Arg], ctx: Ctx, state: &dyn TrackedValues) -> Result<Value, Why> {
        let mut positional = Vec::new();
        let mut wobj = Some(DataName::Predefined("wobj0".into()));
        for arg in args {
            match &arg.kind {
                ArgKind::Positional(expr) => positional.push(expr),
                ArgKind::Named { name, value: Some(expr) } => {
                    let name = super::names::lower_case(self.index.text(ctx.file, *name));
                    if name == "wobj" {
                        wobj = self.data_name(expr, ctx);
                    }
                }
                ArgKind::Named { value: None, .. } => {}
                ArgKind::Conditional { .. } => {
                    return Err(why("keep::parameter", "an argument is handed on if present".into()));
                }
            }
        }
        let [joints, tool] = positional.as_slice() else { return Err(wrong_type()) };
        let joints = self.fold_typed(joints, ctx, state)?.value;
        convert::jointtarget(&joints).map_err(|(code, reason)| why(code, reason))?;
        match (self.data_name(tool, ctx), wobj) {
            (Some(tool), Some(wobj)) => Ok(Value::Reached(Rc::new(Reached { joints, tool, wobj }))),
            _ => Err(why("keep::calc-frame", "the tool or work object of CalcRobT is not known".into())),
        }
    }
}

/// What a name was found to mean.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum NameMeaning {
    /// Declared in the given files.
    Datum(DatumId),
    /// The controller's own, or given from outside: the name in lower case.
    Predefined(String),
}

fn function_result(name: &str) -> Why {
    why("keep::function-result", format!("the result of {name} is known at run time only"))
}

fn span(ctx: Ctx, range: TextRange) -> Span {
    Span { file: ctx.file, range }
}

fn element(value: &Value, index: f64) -> Result<Value, Why> {
    let Value::Parts(parts) = value else { return Err(wrong_type()) };
    let at = index - 1.0; // RAPID counts from 1
    if at < 0.0 || at.fract() != 0.0 || at >= parts.len() as f64 {
        let text = format!("there is no element {index}: the array has {}", parts.len());
        return Err(why("keep::no-element", text));
    }
    match &parts[at as usize] {
        Value::Unknown(why) => Err(why.clone()),
        value => Ok(value.clone()),
    }
}

fn unary(op: UnaryOp, operand: &Value) -> Result<Value, Why> {
    match (op, operand) {
        (UnaryOp::Neg, Value::Num(n)) => Ok(Value::Num(-n)),
        (UnaryOp::Neg, Value::Parts(parts)) if parts.len() == 3 => {
            parts.iter().map(|p| unary(op, p)).collect::<Result<_, _>>().map(Value::Parts)
        }
        (UnaryOp::Plus, Value::Num(_) | Value::Parts(_)) => Ok(operand.clone()),
        (UnaryOp::Not, Value::Bool(b)) => Ok(Value::Bool(!b)),
        _ => Err(wrong_type()),
    }
}
