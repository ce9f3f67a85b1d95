//! What a name in an expression means, and what the datum is worth that it names: its initial value where nothing changes it, else what
//! is tracked, else the reason why it is not known.
//!
//! Knows nothing of operators and functions.

use super::{ConstEvaluator, Constant, Precision, TrackedValues, Typed, span};
use crate::ids::DatumId;
use crate::index::{Ctx, DatumKind, Resolved};
use crate::motion::SkipReason;
use crate::names::{as_text, lower_case};
use crate::other_tasks;
use crate::predefined::{is_predefined, predefined};
use crate::task_of;
use crate::value::{DataName, Value, Why, why, wrong_type};
use crate::writes::How;
use rapid_syntax::diagnostic::{Span, TextRange};
use rapid_syntax::tree::{DataKind, Expr, ExprKind};
use std::rc::Rc;

/// Constants that refer to constants deeper than this are not followed.
const DEEPEST: usize = 100;

/// What a name was found to mean.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum NameMeaning {
    /// Declared in the given files.
    Datum(DatumId),
    /// The controller's own, or given from outside: the name in lower case.
    Predefined(String),
}

impl ConstEvaluator<'_> {
    pub(super) fn name(
        &mut self,
        range: TextRange,
        ctx: Ctx,
        state: &dyn TrackedValues,
    ) -> Result<Typed, Why> {
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
                Ok(Typed { value: self.held(value), type_name: self.index.names.find(type_name.as_bytes()) })
            }
            Err(why) => Err(why),
        }
    }

    /// What a name means.
    pub(crate) fn resolve(&mut self, range: TextRange, ctx: Ctx) -> Result<NameMeaning, Why> {
        let written = self.index.text(ctx.file, range);
        let resolved = self.index.datum(range, ctx);
        let lower = || lower_case(written);
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
    pub(crate) fn data_name(&mut self, expr: &Expr, ctx: Ctx) -> Option<DataName> {
        let ExprKind::Name = expr.kind else { return None };
        Some(match self.resolve(expr.range, ctx).ok()? {
            NameMeaning::Datum(datum) => DataName::Declared(datum),
            NameMeaning::Predefined(name) => DataName::Predefined(name),
        })
    }

    /// The name of a datum as it is declared.
    pub(crate) fn name_of(&self, datum: DatumId) -> String {
        let entry = &self.index.data[datum];
        as_text(self.index.text(entry.ctx.file, entry.name_range))
    }

    /// What a datum is worth.
    pub(crate) fn datum(&mut self, datum: DatumId, state: &dyn TrackedValues) -> Result<Value, Why> {
        if let Some(value) = state.value(datum) {
            return match value {
                Value::Unknown(why) => Err(why),
                value if self.precision == Precision::Written || self.holds_dnum(datum) => Ok(value),
                value => Ok(value.in_single()),
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
                if let Some(at) = self.writes.by_computed_name(self.index, datum) {
                    return Err(self.changed(datum, at, How::Perhaps));
                }
            }
        }
        self.initial(datum)
    }

    /// The initial value of a datum, whatever becomes of it later.
    pub(crate) fn initial(&mut self, datum: DatumId) -> Result<Value, Why> {
        let is_written = self.precision == Precision::Written;
        let known = if is_written { &self.known } else { &self.known_held };
        if let Some(known) = known.get(&datum) {
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
        let ctx = entry.ctx;
        self.busy.push(datum);
        let before = self.precision;
        if !is_written {
            self.precision = if self.holds_dnum(datum) { Precision::Double } else { Precision::Single };
        }
        let folded = self.fold(init, ctx, &Constant).map(|t| t.value);
        self.precision = before;
        self.busy.pop();
        let known = if is_written { &mut self.known } else { &mut self.known_held };
        known.insert(datum, folded.clone());
        folded
    }

    /// The reason for a datum that the program changes.
    pub(crate) fn changed(&self, datum: DatumId, at: Span, how: How) -> Why {
        let place = self.index.place(at);
        let name = self.name_of(datum);
        let reason = match how {
            How::Assigned | How::Instruction => format!("{name} is changed at run time: {place}"),
            How::AnyTime => format!("{name} is changed at any time by {place}"),
            How::Aliased => format!("{name} is changed in part or through a parameter: {place}"),
            How::Perhaps => format!("{name} may be changed at run time: {place}"),
            How::OtherTask => {
                let path = &self.index.file(at.file).path;
                let task = task_of(path).unwrap_or("another task");
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
}
