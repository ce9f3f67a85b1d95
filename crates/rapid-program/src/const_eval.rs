//! What a constant expression is worth.
//!
//! CONST folds, and so does a VAR or PERS with an initial value that nothing in the given files changes.
//! Data that the program changes are worth what the state says at that point, where they are tracked,
//! else nothing: the reason names the line that changes them.

mod calls;
mod names;

pub(super) use names::NameMeaning;

use super::expressions::every_expr_where;
use super::functions;
use super::ids::DatumId;
use super::index::{Ctx, Index, Resolved};
use super::motion::SkipReason;
use super::names::{ByNumber, Sym, as_text, lower_case};
use super::value::{self, Value, Why, why, wrong_type};
use super::writes::Writes;
use rapid_syntax::diagnostic::{Diagnostic, FileId, Span, TextRange};
use rapid_syntax::parts_of_numbers;
use rapid_syntax::tree::{BinaryOp, Expr, ExprKind, UnaryOp};
use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::rc::Rc;

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
    /// The same as the controller holds them.
    known_held: ByNumber<DatumId, Result<Value, Why>>,
    busy: Vec<DatumId>,
    at_element: Option<AtElement>,
    precision: Precision,
    /// Whether the program is displaced anywhere, once that was asked for.
    displaced: OnceCell<bool>,
}

/// With how many digits numbers are worked out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Precision {
    /// As they are written, so that nothing is lost of a target; what jumps is decided as the controller decides it.
    Written,
    /// As the controller works with `num`: single precision after each step.
    Single,
    /// As it works with `dnum`.
    Double,
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
            known_held: ByNumber::default(),
            busy: Vec::new(),
            at_element: None,
            precision: Precision::Written,
            displaced: OnceCell::new(),
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
        sorting::ascending(&mut elsewhere);
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

    /// What an expression is worth as the controller holds it: `num` in single precision after each step. By these digits it decides
    /// where a small difference makes a large one: which element, which branch, how often, to which whole number.
    pub(super) fn fold_held(
        &mut self,
        expr: &Expr,
        ctx: Ctx,
        state: &dyn TrackedValues,
    ) -> Result<Typed, Why> {
        let wanted = if self.is_dnum(expr, ctx) { Precision::Double } else { Precision::Single };
        let before = std::mem::replace(&mut self.precision, wanted);
        let folded = self.fold(expr, ctx, state);
        self.precision = before;
        folded
    }

    /// What an expression is worth with all its digits, where the controller's are those digits rounded; else the controller's.
    pub(super) fn fold_number(
        &mut self,
        expr: &Expr,
        ctx: Ctx,
        state: &dyn TrackedValues,
    ) -> Result<Value, Why> {
        let written = self.fold(expr, ctx, state)?.value;
        match written {
            Value::Num(_) => Ok(written.unless_held_otherwise(&self.fold_held(expr, ctx, state)?.value)),
            _ => Ok(written),
        }
    }

    /// Whether an expression is worked out in double precision: a `dnum` or a conversion to one stands in it.
    fn is_dnum(&self, expr: &Expr, ctx: Ctx) -> bool {
        let is_double = |expr: &Expr| match &expr.kind {
            ExprKind::Name => match self.index.datum(expr.range, ctx) {
                Resolved::Here(datum) | Resolved::Elsewhere(datum) => self.holds_dnum(datum),
                Resolved::Twice(..) | Resolved::Nowhere => false,
            },
            ExprKind::Call(call) => self.index.text(ctx.file, call.name).eq_ignore_ascii_case(b"numtodnum"),
            _ => false,
        };
        // What a conversion to `num` is made of is a matter of its own.
        let counts = |expr: &Expr| match &expr.kind {
            ExprKind::Call(call) => !self.index.text(ctx.file, call.name).eq_ignore_ascii_case(b"dnumtonum"),
            _ => true,
        };
        let mut found = false;
        every_expr_where(expr, &counts, &mut |expr| found |= is_double(expr));
        found
    }

    fn holds_dnum(&self, datum: DatumId) -> bool {
        self.index.type_text(self.index.data[datum].type_name) == "dnum"
    }

    /// A value of `num` as the controller holds it, where that is asked for.
    fn held(&self, value: Value) -> Value {
        if self.precision == Precision::Single { value.in_single() } else { value }
    }

    fn fold_typed(&mut self, expr: &Expr, ctx: Ctx, state: &dyn TrackedValues) -> Result<Typed, Why> {
        let untyped = |value| Typed { value, type_name: None };
        let source = |range| self.index.text(ctx.file, range);
        match &expr.kind {
            ExprKind::Number => match value::number(source(expr.range)) {
                Some(n) => Ok(untyped(self.held(Value::Num(n)))),
                None => Err(why("keep::bad-number", format!("{} is no number", as_text(source(expr.range))))),
            },
            ExprKind::String => Ok(untyped(Value::Text(value::string(source(expr.range)).into()))),
            ExprKind::Bool(b) => Ok(untyped(Value::Bool(*b))),
            ExprKind::Name => self.name(expr.range, ctx, state),
            ExprKind::Paren(inner) => self.fold_typed(inner, ctx, state),
            ExprKind::Aggregate(parts) => self.fold_parts(parts, ctx, state).map(untyped),
            ExprKind::Numbers => {
                if let Some(value) = Value::of_plain_list(source(expr.range)) {
                    return Ok(untyped(self.held(value)));
                }
                let parts = parts_of_numbers(&self.index.file(ctx.file).bytes, expr.range);
                self.fold_parts(&parts, ctx, state).map(untyped)
            }
            ExprKind::Field(field) => {
                let base = self.fold_typed(&field.base, ctx, state)?;
                self.component(&base, field.name, ctx)
            }
            ExprKind::Index(element_of) => {
                let base = self.fold_typed(&element_of.base, ctx, state)?;
                let indices = self.indices(expr.range, &element_of.indices, ctx, state)?;
                let value = indices.into_iter().try_fold(base.value, |value, n| element(&value, n))?;
                Ok(Typed { value, type_name: base.type_name })
            }
            ExprKind::Call(call) => {
                let value = self.call(call.name, &call.args, ctx, state)?;
                let jumps = functions::jumps(&lower_case(source(call.name)));
                let value = if jumps && self.precision == Precision::Written {
                    value.unless_held_otherwise(&self.fold_held(expr, ctx, state)?.value)
                } else {
                    self.held(value)
                };
                Ok(untyped(value))
            }
            ExprKind::Unary { op, operand } => {
                let operand = self.fold_typed(operand, ctx, state)?.value;
                unary(*op, &operand).map(untyped)
            }
            ExprKind::Binary(binary) if self.precision == Precision::Written && decides(binary.op) => {
                self.fold_held(expr, ctx, state)
            }
            ExprKind::Binary(binary) => {
                let lhs = self.fold_typed(&binary.lhs, ctx, state)?;
                let rhs = self.fold_typed(&binary.rhs, ctx, state)?;
                let value = self.held(functions::binary(binary.op, &lhs.value, &rhs.value)?);
                let keeps = matches!(binary.op, BinaryOp::Add | BinaryOp::Sub);
                Ok(Typed { value, type_name: lhs.type_name.filter(|_| keeps) })
            }
            ExprKind::Placeholder => Err(why("keep::placeholder", "a placeholder stands here".into())),
            ExprKind::Opaque => Err(why("keep::not-read", "this text was not understood".into())),
        }
    }

    /// The values of the parts of an aggregate.
    fn fold_parts(&mut self, parts: &[Expr], ctx: Ctx, state: &dyn TrackedValues) -> Result<Value, Why> {
        let values: Result<Rc<[Value]>, Why> =
            parts.iter().map(|part| self.fold_typed(part, ctx, state).map(|typed| typed.value)).collect();
        values.map(Value::Parts)
    }

    /// The indices of an array's element that stands in `range`: what they are taken to be, else what they are worth.
    fn indices(
        &mut self,
        range: TextRange,
        indices: &[Expr],
        ctx: Ctx,
        state: &dyn TrackedValues,
    ) -> Result<Vec<f64>, Why> {
        let is_meant = |at: &&AtElement| at.file == ctx.file && at.elements.contains(&range);
        if let Some(at) = self.at_element.as_ref().filter(is_meant) {
            return Ok(at.indices.clone());
        }
        let number = |index| match self.fold_held(index, ctx, state)?.value {
            Value::Num(n) => Ok(n),
            _ => Err(wrong_type()),
        };
        indices.iter().map(number).collect()
    }
}

/// Whether an operator makes a large difference of a small one.
fn decides(op: BinaryOp) -> bool {
    use BinaryOp as B;
    matches!(op, B::IntDiv | B::Mod | B::Lt | B::Le | B::Ge | B::Gt | B::Eq | B::Ne)
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
