//! Places that can be read and written: data, a component of data, an element of an array.

use super::compile;
use super::controller::{Bound, Controller};
use super::ir::{Expr, ExprKind};
use super::memory::State;
use super::outcome::{Fault, fatal};
use super::value::{Type, Value};
use rapid_syntax::parts_of_numbers;
use rapid_syntax::tree::{self, DataKind};

/// Where a value is kept.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Place {
    pub root: Root,
    pub path: Vec<Select>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Root {
    /// Data of a module.
    Data(usize),
    /// A slot of the stack, counted from its bottom.
    Slot(usize),
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Select {
    Field(usize),
    /// From 0.
    Element(usize),
}

impl Place {
    pub fn data(datum: usize) -> Self {
        Self { root: Root::Data(datum), path: Vec::new() }
    }
}

/// How data may be handed over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Access {
    Constant,
    Variable,
    Persistent,
}

impl Controller {
    /// The place an expression names, with its type; `None` where it names none.
    pub(super) fn place(&mut self, expr: &Expr) -> Result<Option<(Place, Type)>, Fault> {
        match &expr.kind {
            ExprKind::Local(slot) => {
                let at = self.scope.1 + slot;
                let Some(slot) = self.stack.get(at) else { return fatal("no such local") };
                match &slot.bound {
                    Bound::Own(_) => {
                        Ok(Some((Place { root: Root::Slot(at), path: Vec::new() }, slot.ty.clone())))
                    }
                    Bound::Ref(place) => Ok(Some((place.clone(), slot.ty.clone()))),
                    Bound::Signal(_) => Ok(None),
                    Bound::Absent => fatal("an optional argument that was not given is used"),
                }
            }
            ExprKind::Name(name, spelt) => Ok(self.visible(name, spelt).and_then(|d| {
                let ty = self.memory.data.get(d)?.ty.clone();
                Some((Place::data(d), ty))
            })),
            ExprKind::Field(base, field) => {
                let Some((mut place, ty)) = self.place(base)? else { return Ok(None) };
                let Type::Record(record) = &ty else {
                    return fatal(format!("{} has no component {field}", ty.name()));
                };
                let Some((at, ty)) = record.field(field) else {
                    return fatal(format!("{} has no component {field}", record.name));
                };
                place.path.push(Select::Field(at));
                Ok(Some((place, ty.clone())))
            }
            ExprKind::Index(base, indices) => {
                let Some((mut place, mut ty)) = self.place(base)? else { return Ok(None) };
                for index in indices {
                    let Type::Array(inner) = ty else { return fatal("more indices than dimensions") };
                    place.path.push(Select::Element(self.index(index)?));
                    ty = (*inner).clone();
                }
                Ok(Some((place, ty)))
            }
            _ => Ok(None),
        }
    }

    /// An index as RAPID counts it, from 1, to one from 0.
    fn index(&mut self, expr: &Expr) -> Result<usize, Fault> {
        let value = self.eval(expr, Some(&Type::Num))?;
        match value.number() {
            Some(x) if x >= 1.0 && x <= f64::from(u32::MAX) && x == x.trunc() => Ok(x as usize - 1),
            _ => fatal(format!("an array index of {value:?}")),
        }
    }

    /// Whether a place is CONST, VAR or PERS.
    pub(super) fn access(&self, place: &Place) -> Access {
        match place.root {
            Root::Data(d) => match self.memory.data.get(d).map(|d| d.kind) {
                Some(DataKind::Pers) => Access::Persistent,
                Some(DataKind::Var) => Access::Variable,
                _ => Access::Constant,
            },
            Root::Slot(at) => match self.stack.get(at) {
                Some(slot) if !slot.constant => Access::Variable,
                _ => Access::Constant,
            },
        }
    }

    /// The value at a place.
    pub(super) fn read(&mut self, place: &Place) -> Result<Value, Fault> {
        if let Root::Data(datum) = place.root {
            if let Some(value) = self.pinned.get(&datum).filter(|_| place.path.is_empty()) {
                return Ok(value.clone());
            }
            if let Some(value) = self.constant_part(datum, &place.path)? {
                return Ok(value);
            }
            self.settle(datum)?;
        }
        let mut value = match place.root {
            Root::Data(d) => match self.memory.data.get(d).map(|d| &d.state) {
                Some(State::Known(value)) => value,
                _ => return fatal("data without value"),
            },
            Root::Slot(at) => match self.stack.get(at).map(|s| &s.bound) {
                Some(Bound::Own(value)) => value,
                _ => return fatal("a place that is gone"),
            },
        };
        for select in &place.path {
            let (Select::Field(at) | Select::Element(at)) = select;
            match value.parts().get(*at) {
                Some(part) => value = part,
                None => return fatal(format!("index {} outside of the array", at + 1)),
            }
        }
        Ok(value.clone())
    }

    /// Assign to a place.
    pub(super) fn write(&mut self, place: &Place, value: Value) -> Result<(), Fault> {
        if self.access(place) == Access::Constant {
            return fatal("an assignment to a constant");
        }
        let (mut ty, mut target) = match place.root {
            Root::Data(datum) => {
                if self.pinned.contains_key(&datum) {
                    return Ok(());
                }
                self.settle(datum)?;
                let datum = self.memory.data.get_mut(datum).map(|d| (&d.ty, &mut d.state));
                match datum {
                    Some((ty, State::Known(value))) => (ty, value),
                    _ => return fatal("data without value"),
                }
            }
            Root::Slot(at) => match self.stack.get_mut(at).map(|s| (&s.ty, &mut s.bound)) {
                Some((ty, Bound::Own(value))) => (ty, value),
                _ => return fatal("a place that is gone"),
            },
        };
        for select in &place.path {
            let (part, inner) = match (select, target, ty) {
                (Select::Field(at), Value::Record(_, parts), Type::Record(r)) => {
                    (parts.get_mut(*at), r.fields.get(*at).map(|(_, ty)| ty))
                }
                (Select::Element(at), Value::Array(parts), Type::Array(inner)) => {
                    (parts.get_mut(*at), Some(&**inner))
                }
                _ => (None, None),
            };
            match (part, inner) {
                (Some(part), Some(inner)) => (target, ty) = (part, inner),
                _ => return fatal("an index outside of the array"),
            }
        }
        let given = value.type_name();
        match value.coerced(ty) {
            Some(Value::Str(text)) if text.chars().count() > 80 => {
                fatal(format!("a string of {} characters; 80 fit", text.chars().count()))
            }
            Some(value) => {
                *target = value;
                Ok(())
            }
            None => fatal(format!("a {given} is assigned to data of type {}", ty.name())),
        }
    }

    /// Evaluate the initial value of data that nobody asked for yet.
    fn settle(&mut self, id: usize) -> Result<(), Fault> {
        let Some(datum) = self.memory.data.get_mut(id) else { return fatal("no such data") };
        match datum.state {
            State::Known(_) => return Ok(()),
            State::InWork => return fatal(format!("the initial value of {} depends on itself", datum.name)),
            State::Untouched => datum.state = State::InWork,
        }
        let value = self.initial(id);
        if let Some(datum) = self.memory.data.get_mut(id) {
            datum.state = match &value {
                Ok(value) => State::Known(value.clone()),
                Err(_) => State::Untouched,
            };
        }
        value.map(drop)
    }

    fn initial(&mut self, id: usize) -> Result<Value, Fault> {
        let Some((ty, module, decl_at, name)) =
            self.memory.data.get(id).map(|d| (d.ty.clone(), d.module, d.at, d.name.clone()))
        else {
            return fatal("no such data");
        };
        let Some(m) = self.memory.modules.get(module) else { return fatal("no such module") };
        let file = m.file.clone();
        let Some(decl) = m.data_decl(decl_at) else { return fatal("no such declaration") };
        let dims: Vec<Expr> = decl.dims.iter().map(|e| compile::constant(&file, e)).collect();
        let init = decl.init.as_ref().map(|e| compile::constant(&file, e));
        self.in_module(module, |c| c.declared_value(&name, &ty, &dims, init.as_ref()))
    }

    /// The value that data begin with: dimensions and initial value are evaluated and compared.
    pub(super) fn declared_value(
        &mut self,
        name: &str,
        ty: &Type,
        dims: &[Expr],
        init: Option<&Expr>,
    ) -> Result<Value, Fault> {
        let mut sizes = Vec::with_capacity(dims.len());
        for dim in dims {
            sizes.push(self.index(dim)? + 1);
        }
        if sizes.iter().try_fold(1_usize, |n, s| n.checked_mul(*s)).is_none_or(|n| n > 10_000_000) {
            return fatal(format!("{name}: an array this large does not fit into memory"));
        }
        let Some(init) = init else { return Ok(ty.initial_array(&sizes)) };
        let value = self.eval(init, Some(ty))?;
        let given = value.type_name();
        let Some(value) = value.coerced(ty) else {
            return fatal(format!("{name}: a {given} as initial value of a {}", ty.name()));
        };
        if !fits(&value, &sizes) {
            return fatal(format!("{name}: the initial value has another number of elements than {sizes:?}"));
        }
        Ok(value)
    }

    /// Do something with names looked up in a module instead of the running routine.
    pub(super) fn in_module<T>(&mut self, module: usize, f: impl FnOnce(&mut Self) -> T) -> T {
        let scope = std::mem::replace(&mut self.scope, (module, self.stack.len()));
        let (effort, is_metered) = (self.effort, std::mem::replace(&mut self.is_metered, false));
        let out = f(self);
        self.scope = scope;
        // A controller has the values of module data since it loaded them: they cost nothing when asked for.
        (self.effort, self.is_metered) = (effort, is_metered);
        out
    }

    /// A part of a CONST whose value is an aggregate, without evaluating the rest of it: arrays of
    /// targets are large, and a program reads one element at a time.
    fn constant_part(&mut self, id: usize, path: &[Select]) -> Result<Option<Value>, Fault> {
        let Some(datum) = self.memory.data.get(id) else { return Ok(None) };
        if path.is_empty() || datum.kind != DataKind::Const || matches!(datum.state, State::Known(_)) {
            return Ok(None);
        }
        let (module, mut ty) = (datum.module, datum.ty.clone());
        let Some(m) = self.memory.modules.get(module) else { return Ok(None) };
        let file = m.file.clone();
        let Some(mut expr) = m.data_decl(datum.at).and_then(|d| d.init.clone()) else { return Ok(None) };
        for select in path {
            let mut parts = match expr.kind {
                tree::ExprKind::Aggregate(parts) => parts.into_vec(),
                tree::ExprKind::Numbers => parts_of_numbers(&file.bytes, expr.range),
                _ => return Ok(None),
            };
            let (Select::Field(at) | Select::Element(at)) = select;
            let inner = match (&ty, select) {
                (Type::Array(inner), Select::Element(_)) => Some((**inner).clone()),
                (Type::Record(r), Select::Field(at)) => r.fields.get(*at).map(|(_, ty)| ty.clone()),
                _ => None,
            };
            match inner {
                Some(inner) if *at < parts.len() => (expr, ty) = (parts.swap_remove(*at), inner),
                _ => return fatal(format!("index {} outside of the array", at + 1)),
            }
        }
        let expr = compile::constant(&file, &expr);
        let value = self.in_module(module, |c| c.eval(&expr, Some(&ty)))?;
        match value.coerced(&ty) {
            Some(value) => Ok(Some(value)),
            None => fatal(format!("an element that is no {}", ty.name())),
        }
    }
}

/// Whether an array has just these dimensions.
fn fits(value: &Value, sizes: &[usize]) -> bool {
    match (value, sizes.split_first()) {
        (Value::Array(parts), Some((n, rest))) => parts.len() == *n && parts.iter().all(|p| fits(p, rest)),
        (Value::Array(_), None) => false,
        (_, None) => true,
        (_, Some(_)) => false,
    }
}
