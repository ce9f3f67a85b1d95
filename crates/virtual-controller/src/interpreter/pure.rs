//! Expressions of names, numbers and operators alone, worked out where the values stand.
//!
//! Most of what a program calculates is of this kind. Nothing here changes anything, so where a value is of another type, not known
//! yet, or an error, the answer is `None` and the general evaluation begins anew: its rules are the ones that count.

use super::Interpreter;
use super::arithmetic::single;
use super::eval::MAX_NESTING;
use crate::code::{Expr, ExprKind};
use crate::machine::{Binding, DataRef, DataRoot, DataState, Slot};
use crate::value::Value;
use rapid_syntax::tree::{BinaryOp, DataKind, UnaryOp};

/// An evaluation: how deep it stands and what it has calculated so far.
struct Depth<'o> {
    nesting: usize,
    operations: &'o mut u64,
}

impl Depth<'_> {
    /// One expression further in; `None` where it is too deep.
    fn inner(&mut self) -> Option<Depth<'_>> {
        let nesting = self.nesting + 1;
        (nesting <= MAX_NESTING).then_some(Depth { nesting, operations: self.operations })
    }
}

/// Components and elements inside one another that are followed.
const DEEPEST: usize = 8;

/// Data or a slot, and the components and elements on the way to a part of it, positions from 0.
struct DataPath {
    root: DataRoot,
    path: [usize; DEEPEST],
    len: usize,
}

impl DataPath {
    /// The whole of a datum.
    fn whole(root: DataRoot) -> Self {
        Self { root, path: [0; DEEPEST], len: 0 }
    }

    /// A component or element of it.
    fn inside(mut self, at: usize) -> Option<Self> {
        *self.path.get_mut(self.len)? = at;
        self.len += 1;
        Some(self)
    }
}

impl Interpreter<'_> {
    /// The value of a `num` expression.
    pub(crate) fn pure_num(&mut self, expr: &Expr) -> Option<f32> {
        self.pure(expr, Self::num_of)
    }

    /// The value of a condition.
    pub(crate) fn pure_bool(&mut self, expr: &Expr) -> Option<bool> {
        self.pure(expr, Self::bool_of)
    }

    /// A copy of a component or element.
    pub(crate) fn pure_value(&mut self, expr: &Expr) -> Option<Value> {
        self.pure(expr, |vm, expr, depth| vm.value_of(expr, depth).cloned())
    }

    /// Assigns a number to data that hold one, or to a number in a record or array; whether that was all there was to do.
    pub(crate) fn assign_num(&mut self, target: &Expr, value: &Expr) -> bool {
        if !value.is_pure {
            return false;
        }
        let found = self.pure(target, |vm, target, depth| match vm.place_of(target, depth)? {
            (place, Value::Num(_)) => Some((place, vm.num_of(value, depth)?)),
            _ => None,
        });
        let Some((place, x)) = found else { return false };
        let Some(held) = self.held(&place) else { return false };
        let new = Value::Num(x);
        let is_changed = *held != new;
        *held = new;
        self.machine.changes += u64::from(is_changed);
        true
    }

    /// Where something stands that may be assigned to, and what it holds; `None` for all that is rare.
    fn place_of(&self, target: &Expr, depth: &mut Depth<'_>) -> Option<(DataPath, &Value)> {
        match &target.kind {
            ExprKind::Local(slot) => {
                let at = self.machine.stack.scope.1 + slot;
                match self.machine.stack.slots.get(at)? {
                    Slot { constant: false, binding: Binding::Own(value), .. } => {
                        Some((DataPath::whole(DataRoot::Slot(at)), value))
                    }
                    _ => None,
                }
            }
            ExprKind::Name(named) => {
                let datum = self.program.named_datum(self.machine.stack.scope.0, named)?;
                let is_variable = self.program.data.get(datum).is_some_and(|d| d.kind != DataKind::Const);
                let value = self.datum_value(datum).filter(|_| is_variable)?;
                Some((DataPath::whole(DataRoot::Data(datum)), value))
            }
            ExprKind::Field(base, field) => match self.place_of(base, &mut depth.inner()?)? {
                (place, Value::Record(record, parts)) => {
                    let at = record.field(field)?.0;
                    Some((place.inside(at)?, parts.get(at)?))
                }
                _ => None,
            },
            ExprKind::Index(base, indices) => {
                let (mut place, mut value) = self.place_of(base, &mut depth.inner()?)?;
                for index in indices {
                    let Value::Array(parts) = value else { return None };
                    let at = self.position_of(index, &mut depth.inner()?)?;
                    (place, value) = (place.inside(at)?, parts.get(at)?);
                }
                Some((place, value))
            }
            _ => None,
        }
    }

    fn held(&mut self, place: &DataPath) -> Option<&mut Value> {
        let whole = match place.root {
            DataRoot::Slot(at) => match &mut self.machine.stack.slots.get_mut(at)?.binding {
                Binding::Own(value) => value,
                _ => return None,
            },
            DataRoot::Data(datum) => match self.machine.data.state_mut(datum) {
                DataState::Known(value) => value,
                _ => return None,
            },
        };
        place.path[..place.len].iter().try_fold(whole, |value, &at| match value {
            Value::Record(_, parts) | Value::Array(parts) => parts.get_mut(at),
            _ => None,
        })
    }

    fn pure<T>(
        &mut self,
        expr: &Expr,
        evaluate: impl FnOnce(&Self, &Expr, &mut Depth<'_>) -> Option<T>,
    ) -> Option<T> {
        if !expr.is_pure {
            return None;
        }
        let mut operations = 0;
        let mut depth = Depth { nesting: self.machine.stack.nesting + 1, operations: &mut operations };
        let value = evaluate(self, expr, &mut depth)?;
        self.machine.meter.total.arithmetic += operations;
        Some(value)
    }

    fn num_of(&self, expr: &Expr, depth: &mut Depth<'_>) -> Option<f32> {
        match &expr.kind {
            ExprKind::Number(x) => Some(*x as f32).filter(|x| x.is_finite()),
            ExprKind::Unary(op, operand) => {
                let x = self.num_of(operand, &mut depth.inner()?)?;
                match op {
                    UnaryOp::Neg => {
                        *depth.operations += 1;
                        Some(-x)
                    }
                    UnaryOp::Plus => Some(x),
                    UnaryOp::Not => None,
                }
            }
            ExprKind::Binary(op, lhs, rhs) => {
                let a = self.num_of(lhs, &mut depth.inner()?)?;
                let b = self.num_of(rhs, &mut depth.inner()?)?;
                *depth.operations += 1;
                match op {
                    BinaryOp::Add
                    | BinaryOp::Sub
                    | BinaryOp::Mul
                    | BinaryOp::Div
                    | BinaryOp::IntDiv
                    | BinaryOp::Mod => single(*op, a, b).ok(),
                    _ => None,
                }
            }
            _ => match self.value_of(expr, depth)? {
                Value::Num(x) => Some(*x),
                _ => None,
            },
        }
    }

    fn bool_of(&self, expr: &Expr, depth: &mut Depth<'_>) -> Option<bool> {
        match &expr.kind {
            ExprKind::Bool(b) => Some(*b),
            ExprKind::Unary(UnaryOp::Not, operand) => Some(!self.bool_of(operand, &mut depth.inner()?)?),
            ExprKind::Binary(BinaryOp::And, lhs, rhs) => {
                Some(self.bool_of(lhs, &mut depth.inner()?)? && self.bool_of(rhs, &mut depth.inner()?)?)
            }
            ExprKind::Binary(BinaryOp::Or, lhs, rhs) => {
                Some(self.bool_of(lhs, &mut depth.inner()?)? || self.bool_of(rhs, &mut depth.inner()?)?)
            }
            ExprKind::Binary(op, lhs, rhs) => {
                let compare: fn(&f32, &f32) -> bool = match op {
                    BinaryOp::Lt => f32::lt,
                    BinaryOp::Le => f32::le,
                    BinaryOp::Gt => f32::gt,
                    BinaryOp::Ge => f32::ge,
                    BinaryOp::Eq => f32::eq,
                    BinaryOp::Ne => f32::ne,
                    _ => return None,
                };
                let a = self.num_of(lhs, &mut depth.inner()?)?;
                let b = self.num_of(rhs, &mut depth.inner()?)?;
                Some(compare(&a, &b))
            }
            _ => match self.value_of(expr, depth)? {
                Value::Bool(b) => Some(*b),
                _ => None,
            },
        }
    }

    /// Where a value stands that is known.
    fn value_of(&self, expr: &Expr, depth: &mut Depth<'_>) -> Option<&Value> {
        match &expr.kind {
            ExprKind::Local(slot) => match self.machine.stack.local(*slot)? {
                Binding::Own(value) => Some(value),
                Binding::Ref(place) => self.value_at(place),
                Binding::Signal(_) | Binding::Absent => None,
            },
            ExprKind::Name(named) => {
                self.datum_value(self.program.named_datum(self.machine.stack.scope.0, named)?)
            }
            ExprKind::Field(base, field) => match self.value_of(base, &mut depth.inner()?)? {
                Value::Record(record, parts) => parts.get(record.field(field)?.0),
                _ => None,
            },
            ExprKind::Index(base, indices) => {
                let mut value = self.value_of(base, &mut depth.inner()?)?;
                for index in indices {
                    let Value::Array(parts) = value else { return None };
                    value = parts.get(self.position_of(index, &mut depth.inner()?)?)?;
                }
                Some(value)
            }
            _ => None,
        }
    }

    /// An index as RAPID counts it, from 1, to one from 0.
    fn position_of(&self, index: &Expr, depth: &mut Depth<'_>) -> Option<usize> {
        let x = self.num_of(index, depth)?;
        let whole = x as usize;
        (whole >= 1 && whole as f32 == x).then(|| whole - 1)
    }

    fn value_at(&self, place: &DataRef) -> Option<&Value> {
        let whole = match place.root {
            DataRoot::Data(datum) => self.datum_value(datum)?,
            DataRoot::Slot(at) => match &self.machine.stack.slots.get(at)?.binding {
                Binding::Own(value) => value,
                _ => return None,
            },
        };
        place.path.iter().try_fold(whole, |value, select| value.parts().get(select.position()))
    }

    fn datum_value(&self, datum: usize) -> Option<&Value> {
        let pinned = &self.machine.data.pinned;
        if !pinned.is_empty() && pinned.contains_key(&datum) {
            return None;
        }
        self.machine.data.known(datum)
    }
}
