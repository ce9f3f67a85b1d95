//! Data that can be read and written: whole, by component, by element.

use super::Interpreter;
use crate::code::{Expr, ExprKind};
use crate::compile;
use crate::loaded::DatumOrigin;
use crate::machine::{Access, Binding, DataRef, DataRoot, DataState, MOST_VALUES, Selector};
use crate::outcome::{Fault, fatal};
use crate::predefined;
use crate::value::{Type, Value};
use rapid_syntax::parts_of_numbers;
use rapid_syntax::tree::{self, DataKind};

impl Interpreter<'_> {
    /// The place an expression names, with its type; `None` where it names none.
    pub(crate) fn data_ref(&mut self, expr: &Expr) -> Result<Option<(DataRef, Type)>, Fault> {
        match &expr.kind {
            ExprKind::Local(slot) => {
                let at = self.machine.stack.scope.1 + slot;
                let Some(slot) = self.machine.stack.slots.get(at) else { return fatal("no such local") };
                match &slot.binding {
                    Binding::Own(_) => {
                        Ok(Some((DataRef { root: DataRoot::Slot(at), path: Vec::new() }, slot.ty.clone())))
                    }
                    Binding::Ref(place) => Ok(Some((place.clone(), slot.ty.clone()))),
                    Binding::Signal(_) => Ok(None),
                    Binding::Absent => fatal("an optional argument that was not given is used"),
                }
            }
            ExprKind::Name(named) => Ok(self.resolve_datum(named).and_then(|d| {
                let ty = self.program.data.get(d)?.ty.clone();
                Some((DataRef::data(d), ty))
            })),
            ExprKind::Field(base, field) => {
                let Some((mut place, ty)) = self.data_ref(base)? else { return Ok(None) };
                let Type::Record(record) = &ty else {
                    return fatal(format!("{} has no component {field}", ty.name()));
                };
                let Some((at, ty)) = record.field(field) else {
                    return fatal(format!("{} has no component {field}", record.name));
                };
                place.path.push(Selector::Field(at));
                Ok(Some((place, ty.clone())))
            }
            ExprKind::Index(base, indices) => {
                let Some((mut place, mut ty)) = self.data_ref(base)? else { return Ok(None) };
                for index in indices {
                    let Type::Array(inner) = ty else { return fatal("more indices than dimensions") };
                    place.path.push(Selector::Element(self.index(index)?));
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
    pub(crate) fn access(&self, place: &DataRef) -> Access {
        match place.root {
            DataRoot::Data(d) => match self.program.data.get(d).map(|d| d.kind) {
                Some(DataKind::Pers) => Access::Persistent,
                Some(DataKind::Var) => Access::Variable,
                _ => Access::Constant,
            },
            DataRoot::Slot(at) => match self.machine.stack.slots.get(at) {
                Some(slot) if !slot.constant => Access::Variable,
                _ => Access::Constant,
            },
        }
    }

    /// The value at a place.
    pub(crate) fn read(&mut self, place: &DataRef) -> Result<Value, Fault> {
        if let DataRoot::Data(datum) = place.root {
            if let Some(value) = self.machine.data.pinned.get(&datum).filter(|_| place.path.is_empty()) {
                return Ok(value.clone());
            }
            if let Some(value) = self.constant_part(datum, &place.path)? {
                return Ok(value);
            }
            self.initialise(datum)?;
        }
        let mut value = match place.root {
            DataRoot::Data(d) => match self.machine.data.known(d) {
                Some(value) => value,
                None => return fatal("data without value"),
            },
            DataRoot::Slot(at) => match self.machine.stack.slots.get(at).map(|s| &s.binding) {
                Some(Binding::Own(value)) => value,
                _ => return fatal("a place that is gone"),
            },
        };
        for select in &place.path {
            let at = select.position();
            match value.parts().get(at) {
                Some(part) => value = part,
                None => return fatal(format!("index {} outside of the array", at + 1)),
            }
        }
        Ok(value.clone())
    }

    /// Assign to a place.
    pub(crate) fn write(&mut self, place: &DataRef, value: Value) -> Result<(), Fault> {
        if self.access(place) == Access::Constant {
            return fatal("an assignment to a constant");
        }
        let (mut ty, mut target) = match place.root {
            DataRoot::Data(datum) => {
                if self.machine.data.pinned.contains_key(&datum) {
                    return Ok(());
                }
                self.initialise(datum)?;
                let ty = self.program.data.get(datum).map(|d| &d.ty);
                match (ty, self.machine.data.state_mut(datum)) {
                    (Some(ty), DataState::Known(value)) => (ty, value),
                    _ => return fatal("data without value"),
                }
            }
            DataRoot::Slot(at) => match self.machine.stack.slots.get_mut(at).map(|s| (&s.ty, &mut s.binding))
            {
                Some((ty, Binding::Own(value))) => (ty, value),
                _ => return fatal("a place that is gone"),
            },
        };
        for select in &place.path {
            let (part, inner) = match (select, target, ty) {
                (Selector::Field(at), Value::Record(_, parts), Type::Record(r)) => {
                    (parts.get_mut(*at), r.fields.get(*at).map(|(_, ty)| ty))
                }
                (Selector::Element(at), Value::Array(parts), Type::Array(inner)) => {
                    (parts.get_mut(*at), Some(&**inner))
                }
                _ => (None, None),
            };
            match (part, inner) {
                (Some(part), Some(inner)) => (target, ty) = (part, inner),
                _ => return fatal("an index outside of the array"),
            }
        }
        match value.coerced(ty) {
            Ok(Value::Str(text)) if text.chars().count() > 80 => {
                fatal(format!("a string of {} characters; 80 fit", text.chars().count()))
            }
            Ok(value) => {
                let is_changed = *target != value;
                *target = value;
                self.machine.changes += u64::from(is_changed);
                Ok(())
            }
            Err(given) => fatal(format!("a {given} is assigned to data of type {}", ty.name())),
        }
    }

    /// Evaluate the initial value of data that nobody asked for yet.
    fn initialise(&mut self, id: usize) -> Result<(), Fault> {
        match self.machine.data.state(id) {
            DataState::Known(_) => return Ok(()),
            DataState::InEvaluation => {
                let name = self.program.data.get(id).map_or("", |d| &*d.name);
                return fatal(format!("the initial value of {name} depends on itself"));
            }
            DataState::Untouched => *self.machine.data.state_mut(id) = DataState::InEvaluation,
        }
        let value = self.initial(id);
        if let Ok(value) = &value
            && !self.has_initial_text(id)
        {
            self.machine.data.note_grown(id, value.values());
        }
        *self.machine.data.state_mut(id) = match &value {
            Ok(value) => DataState::Known(value.clone()),
            Err(_) => DataState::Untouched,
        };
        value.map(drop)
    }

    /// Whether the text of the program gives the datum a value.
    fn has_initial_text(&self, id: usize) -> bool {
        let Some(DatumOrigin::Module { module, at }) = self.program.data.get(id).map(|datum| datum.origin)
        else {
            return true; // the controller's own
        };
        let module = self.program.modules.get(module.index());
        module.and_then(|module| module.data_decl(at)).is_some_and(|decl| decl.init.is_some())
    }

    fn initial(&mut self, id: usize) -> Result<Value, Fault> {
        let Some(datum) = self.program.data.get(id) else { return fatal("no such data") };
        let (ty, name) = (datum.ty.clone(), datum.name.clone());
        let DatumOrigin::Module { module, at } = datum.origin else {
            return match predefined::constant(&self.program.types, &name) {
                Some(value) => Ok(value),
                None => fatal("data without value"),
            };
        };
        let Some(m) = self.program.modules.get(module.index()) else { return fatal("no such module") };
        let file = m.file.clone();
        let Some(decl) = m.data_decl(at) else { return fatal("no such declaration") };
        let dims: Vec<Expr> = decl.dims.iter().map(|e| compile::constant(&file, e)).collect();
        let init = decl.init.as_ref().map(|e| compile::constant(&file, e));
        self.in_module(module, |c| c.declared_value(&name, &ty, &dims, init.as_ref()))
    }

    /// The value that data begin with: dimensions and initial value are evaluated and compared.
    pub(crate) fn declared_value(
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
        let elements = sizes.iter().fold(1_u64, |n, size| n.saturating_mul(*size as u64));
        self.reserve_values(name, elements.saturating_mul(ty.values_up_to(MOST_VALUES + 1)))?;
        let Some(init) = init else { return Ok(ty.initial_array(&sizes)) };
        let value = self.eval(init, Some(ty))?;
        let value = match value.coerced(ty) {
            Ok(value) => value,
            Err(given) => {
                return fatal(format!("{name}: a {given} as initial value of a {}", ty.name()));
            }
        };
        if !fits(&value, &sizes) {
            return fatal(format!("{name}: the initial value has another number of elements than {sizes:?}"));
        }
        Ok(value)
    }

    /// A part of a CONST whose value is an aggregate, without evaluating the rest of it, where that would take much memory: a long
    /// program has arrays of targets for each motion, and reads one element at a time.
    fn constant_part(&mut self, id: usize, path: &[Selector]) -> Result<Option<Value>, Fault> {
        let Some(datum) = self.program.data.get(id) else { return Ok(None) };
        if path.is_empty() || datum.kind != DataKind::Const || self.machine.data.known(id).is_some() {
            return Ok(None);
        }
        let DatumOrigin::Module { module, at } = datum.origin else { return Ok(None) };
        let mut ty = datum.ty.clone();
        let Some(m) = self.program.modules.get(module.index()) else { return Ok(None) };
        let file = m.file.clone();
        let Some(init) = m.data_decl(at).and_then(|d| d.init.as_ref()) else { return Ok(None) };
        if self.machine.data.keep_constant(init.range.len()) {
            return Ok(None);
        }
        let mut expr = init.clone();
        for select in path {
            let mut parts = match expr.kind {
                tree::ExprKind::Aggregate(parts) => parts.into_vec(),
                tree::ExprKind::Numbers => parts_of_numbers(&file.bytes, expr.range),
                _ => return Ok(None),
            };
            let at = select.position();
            let inner = match (&ty, select) {
                (Type::Array(inner), Selector::Element(_)) => Some((**inner).clone()),
                (Type::Record(r), Selector::Field(at)) => r.fields.get(*at).map(|(_, ty)| ty.clone()),
                _ => None,
            };
            match inner {
                Some(inner) if at < parts.len() => (expr, ty) = (parts.swap_remove(at), inner),
                _ => return fatal(format!("index {} outside of the array", at + 1)),
            }
        }
        let expr = compile::constant(&file, &expr);
        let value = self.in_module(module, |c| c.eval(&expr, Some(&ty)))?;
        match value.coerced(&ty) {
            Ok(value) => Ok(Some(value)),
            Err(_) => fatal(format!("an element that is no {}", ty.name())),
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
