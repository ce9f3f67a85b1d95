//! Expressions: values of names, operators with RAPID's rules, aggregates by the type that is wanted.

use super::Interpreter;
use super::arithmetic::arithmetic;
use crate::code::{Callee, Expr, ExprKind, NameRef};
use crate::machine::{Binding, DataRef};
use crate::outcome::{Fault, fatal, raise};
use crate::predefined;
use crate::value::{Type, Value};
use rapid_syntax::tree::{BinaryOp, UnaryOp};
use std::rc::Rc;

/// Expressions and function calls inside one another, all told.
pub(super) const MAX_NESTING: usize = 400;

impl Interpreter<'_> {
    /// The value of an expression; `want` is the type of what it is for, which gives aggregates their
    /// type and numbers as written their precision.
    pub(crate) fn eval(&mut self, expr: &Expr, want: Option<&Type>) -> Result<Value, Fault> {
        self.machine.stack.nesting += 1;
        let value = if self.machine.stack.nesting > MAX_NESTING {
            fatal("expressions or function calls nested too deep")
        } else {
            self.eval_inner(expr, want)
        };
        self.machine.stack.nesting -= 1;
        value
    }

    fn eval_inner(&mut self, expr: &Expr, want: Option<&Type>) -> Result<Value, Fault> {
        match &expr.kind {
            ExprKind::Number(x) => Ok(match want {
                Some(Type::Num) => Value::num(*x),
                _ => Value::Literal(*x),
            }),
            ExprKind::Str(text) => Ok(Value::Str(text.clone())),
            ExprKind::Bool(b) => Ok(Value::Bool(*b)),
            ExprKind::Local(slot) => self.local(*slot),
            ExprKind::Name(named) => self.name(named),
            ExprKind::Field(..) | ExprKind::Index(..) => self.part(expr),
            ExprKind::Aggregate(parts) => self.aggregate(parts, want),
            ExprKind::Call(call) => match &call.callee {
                Callee::Name(name, spelt) => self.call_function(name, spelt, call, want),
                Callee::Late(_) => fatal("a function cannot be called by late binding"),
            },
            ExprKind::Unary(op, operand) => self.unary(*op, operand, want),
            ExprKind::Binary(op, lhs, rhs) => self.binary(*op, lhs, rhs, want),
            ExprKind::Opaque => fatal("an expression that is not understood"),
        }
    }

    /// The value of an expression as a type.
    pub(crate) fn eval_as(&mut self, expr: &Expr, ty: &Type) -> Result<Value, Fault> {
        if *ty == Type::Num
            && let Some(x) = self.pure_num(expr)
        {
            return Ok(Value::Num(x));
        }
        let value = self.eval(expr, Some(ty))?;
        match value.coerced(ty) {
            Ok(value) => Ok(value),
            Err(given) => fatal(format!("a {given} where a {} is asked for", ty.name())),
        }
    }

    /// The value of a `num` expression (a `dnum` is not one).
    pub(crate) fn eval_num(&mut self, expr: &Expr) -> Result<f32, Fault> {
        if let Some(x) = self.pure_num(expr) {
            return Ok(x);
        }
        match self.eval_as(expr, &Type::Num)? {
            Value::Num(x) => Ok(x),
            _ => fatal("no number"),
        }
    }

    /// The value of a condition.
    pub(crate) fn eval_bool(&mut self, expr: &Expr) -> Result<bool, Fault> {
        if let Some(b) = self.pure_bool(expr) {
            return Ok(b);
        }
        match self.eval(expr, Some(&Type::Bool))? {
            Value::Bool(b) => Ok(b),
            other => fatal(format!("a {} where a condition is asked for", other.type_name())),
        }
    }

    fn local(&mut self, slot: usize) -> Result<Value, Fault> {
        match self.machine.stack.local(slot) {
            Some(Binding::Own(value)) => Ok(value.clone()),
            Some(Binding::Ref(place)) => {
                let place = place.clone();
                self.read(&place)
            }
            Some(Binding::Signal(name)) => {
                let name = name.clone();
                self.signal_value(&name)
            }
            Some(Binding::Absent) => fatal("an optional argument that was not given is used"),
            None => fatal("no such local"),
        }
    }

    /// The data a name means here. Data that are LOCAL to another module are taken from there, and that is
    /// said: RoboDK's pages use what the first one declares; no controller loads them.
    pub(crate) fn resolve_datum(&mut self, named: &NameRef) -> Option<usize> {
        if let Some(datum) = self.program.named_datum(self.machine.stack.scope.0, named) {
            return Some(datum);
        }
        let NameRef { name, spelt, .. } = named;
        let name: &str = name;
        let predefined = matches!(name, "errno" | "intno" | "c_progdisp")
            || self.machine.signals.levels.contains_key(name);
        if predefined || predefined::constant(&self.program.types, name).is_some() {
            return None;
        }
        let elsewhere = self.program.datum_anywhere(name)?;
        if !self.machine.log.from_elsewhere.contains(name) {
            self.machine.log.from_elsewhere.insert(name.to_owned());
            self.report("controller", format!("{spelt} is LOCAL to another module; taken from there"));
        }
        Some(elsewhere)
    }

    fn name(&mut self, named: &NameRef) -> Result<Value, Fault> {
        if let Some(datum) = self.resolve_datum(named) {
            return self.read(&DataRef::data(datum));
        }
        let NameRef { name, spelt, .. } = named;
        match &**name {
            "errno" => return Ok(Value::Num(self.machine.errors.errno)),
            "intno" => return Ok(Value::Num(self.machine.interrupts.intno)),
            _ => {}
        }
        if let Some(value) = self.built_ins.system_data(self, name) {
            return Ok(value);
        }
        if let Some(value) = predefined::constant(&self.program.types, name) {
            return Ok(value);
        }
        if self.machine.signals.levels.contains_key(name) {
            return self.signal_value(name);
        }
        if self.program.routine(self.machine.stack.scope.0, name).is_some() {
            return fatal(format!("{spelt} is a routine, not data"));
        }
        // A name that nothing declares is a signal of the cell, as far as this controller can know.
        self.report("controller", format!("{spelt} is declared nowhere: taken as a signal that is 0"));
        self.signal_value(name)
    }

    /// The value of a signal; a unit that is down raises an error.
    pub(crate) fn signal_value(&mut self, name: &Rc<str>) -> Result<Value, Fault> {
        if self.machine.signals.units_down.contains(name) {
            return raise("err_norununit", format!("no contact with the unit of signal {name}"));
        }
        Ok(Value::Num(self.machine.signals.levels.get(name).copied().unwrap_or(0.0)))
    }

    /// A component or element of something.
    fn part(&mut self, expr: &Expr) -> Result<Value, Fault> {
        if let Some(value) = self.pure_value(expr) {
            return Ok(value);
        }
        if let Some((place, _)) = self.data_ref(expr)? {
            return self.read(&place);
        }
        match &expr.kind {
            ExprKind::Field(base, field) => match self.eval(base, None)? {
                Value::Record(record, parts) => match record.field(field).and_then(|(at, _)| parts.get(at)) {
                    Some(part) => Ok(part.clone()),
                    None => fatal(format!("{} has no component {field}", record.name)),
                },
                other => fatal(format!("a {} has no component {field}", other.type_name())),
            },
            _ => fatal("an index into something that is no array"),
        }
    }

    fn aggregate(&mut self, parts: &[Expr], want: Option<&Type>) -> Result<Value, Fault> {
        match want {
            Some(Type::Record(record)) => {
                if parts.len() != record.fields.len() {
                    return fatal(format!(
                        "a {} of {} components; it has {}",
                        record.name,
                        parts.len(),
                        record.fields.len()
                    ));
                }
                let mut values = Vec::with_capacity(parts.len());
                for (part, (_, ty)) in parts.iter().zip(&record.fields) {
                    values.push(self.eval_as(part, ty)?);
                }
                Ok(Value::Record(record.clone(), values))
            }
            Some(Type::Array(inner)) => {
                let values = parts.iter().map(|p| self.eval_as(p, inner)).collect::<Result<_, _>>()?;
                Ok(Value::Array(values))
            }
            _ => {
                let values = parts.iter().map(|p| self.eval(p, None)).collect::<Result<_, _>>()?;
                Ok(Value::Array(values))
            }
        }
    }

    fn unary(&mut self, op: UnaryOp, operand: &Expr, want: Option<&Type>) -> Result<Value, Fault> {
        let value = self.eval(operand, want)?;
        self.machine.meter.total.arithmetic += u64::from(op == UnaryOp::Neg);
        match (op, value) {
            (UnaryOp::Not, Value::Bool(b)) => Ok(Value::Bool(!b)),
            (UnaryOp::Neg, Value::Num(x)) => Ok(Value::Num(-x)),
            (UnaryOp::Neg, Value::Dnum(x)) => Ok(Value::Dnum(-x)),
            (UnaryOp::Neg, Value::Literal(x)) => Ok(Value::Literal(-x)),
            (UnaryOp::Neg, Value::Record(r, parts)) if &*r.name == "pos" => {
                let parts = parts.iter().map(|p| Value::num(-p.number().unwrap_or(0.0))).collect();
                Ok(Value::Record(r, parts))
            }
            (UnaryOp::Plus, v @ (Value::Num(_) | Value::Dnum(_) | Value::Literal(_))) => Ok(v),
            (_, other) => fatal(format!("a sign or NOT before a {}", other.type_name())),
        }
    }

    fn binary(&mut self, op: BinaryOp, l: &Expr, r: &Expr, want: Option<&Type>) -> Result<Value, Fault> {
        match op {
            // The right side is evaluated only where the left one does not decide.
            BinaryOp::And => Ok(Value::Bool(self.eval_bool(l)? && self.eval_bool(r)?)),
            BinaryOp::Or => Ok(Value::Bool(self.eval_bool(l)? || self.eval_bool(r)?)),
            BinaryOp::Xor => Ok(Value::Bool(self.eval_bool(l)? ^ self.eval_bool(r)?)),
            BinaryOp::Lt | BinaryOp::Le | BinaryOp::Gt | BinaryOp::Ge | BinaryOp::Eq | BinaryOp::Ne => {
                self.compare(op, l, r)
            }
            _ => {
                let hint = want.filter(|t| matches!(t, Type::Num | Type::Dnum));
                let (l, r) = self.both_sides(l, r, hint, want)?;
                self.machine.meter.total.arithmetic += u64::from(!matches!(l, Value::Str(_)));
                arithmetic(op, l, r, hint)
            }
        }
    }

    /// Both sides of an operator, taken for `hint`. An aggregate has the type of the other side; beside a number, which scales it,
    /// that of the result, `want`.
    fn both_sides(
        &mut self,
        l: &Expr,
        r: &Expr,
        hint: Option<&Type>,
        want: Option<&Type>,
    ) -> Result<(Value, Value), Fault> {
        let is_aggregate = |e: &Expr| matches!(e.kind, ExprKind::Aggregate(_));
        let beside = |value: &Value| match value.number() {
            Some(_) => want.cloned(),
            None => type_of(value),
        };
        if is_aggregate(l) {
            let right = self.eval(r, hint)?;
            return Ok((self.eval(l, beside(&right).as_ref())?, right));
        }
        let left = self.eval(l, hint)?;
        let right = if is_aggregate(r) { self.eval(r, beside(&left).as_ref())? } else { self.eval(r, hint)? };
        Ok((left, right))
    }

    fn compare(&mut self, op: BinaryOp, l: &Expr, r: &Expr) -> Result<Value, Fault> {
        let (left, right) = self.both_sides(l, r, None, None)?;
        if let (Some(a), Some(b)) = (left.number(), right.number()) {
            let (a, b) = match (&left, &right) {
                (Value::Num(_), Value::Dnum(_)) | (Value::Dnum(_), Value::Num(_)) => {
                    return fatal("a num compared with a dnum");
                }
                (Value::Dnum(a), Value::Literal(b)) | (Value::Literal(a), Value::Dnum(b)) => (*a, *b),
                _ => (a, b),
            };
            return Ok(Value::Bool(match op {
                BinaryOp::Lt => a < b,
                BinaryOp::Le => a <= b,
                BinaryOp::Gt => a > b,
                BinaryOp::Ge => a >= b,
                BinaryOp::Ne => a != b,
                _ => a == b,
            }));
        }
        if left.type_name() != right.type_name() {
            return fatal(format!("a {} compared with a {}", left.type_name(), right.type_name()));
        }
        match op {
            BinaryOp::Eq => Ok(Value::Bool(left == right)),
            BinaryOp::Ne => Ok(Value::Bool(left != right)),
            _ => fatal(format!("which {} is larger is not defined", left.type_name())),
        }
    }
}

/// The type an aggregate beside this value has.
fn type_of(value: &Value) -> Option<Type> {
    match value {
        Value::Record(r, _) => Some(Type::Record(r.clone())),
        Value::Array(parts) => Some(Type::Array(Rc::new(parts.first().and_then(type_of)?))),
        Value::Num(_) | Value::Literal(_) => Some(Type::Num),
        Value::Dnum(_) => Some(Type::Dnum),
        Value::Bool(_) => Some(Type::Bool),
        Value::Str(_) => Some(Type::Str),
        Value::Clock(_) => None,
    }
}
