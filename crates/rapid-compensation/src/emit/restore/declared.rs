//! Targets that were changed where they are declared, while the motions of the form schedule go by arrays made of them.

use super::arrays::{Array, NamedArray};
use super::findings::{ModifiedIn, ModifiedTarget, RestoreError};
use super::removal::Remover;
use crate::emit::declarations::Declarations;
use crate::emit::elements::elements;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{DataDecl, ModuleItem, Routine, StmtKind};
use std::collections::BTreeSet;

impl<'w> Remover<'w> {
    /// Targets whose declaration was changed: motions of arrays go by element 1.
    pub(super) fn declared_otherwise(
        &self,
        arrays: &[NamedArray<'w>],
        declarations: &Declarations<'w>,
    ) -> Result<Vec<ModifiedTarget>, RestoreError> {
        let (mut found, mut seen) = (Vec::new(), BTreeSet::new());
        for named in arrays.iter().filter(|_| self.record.is_whole) {
            let NamedArray { name, array, meant, .. } = named;
            let values = match named.routine() {
                Some(routine) if !array.dims.is_empty() => self.declared_elements(array, Some(routine)),
                Some(routine) => declarations.initial_value(array.was(), routine).into_iter().collect(),
                None => Vec::new(),
            };
            for (row, (value, new)) in values.into_iter().zip(meant).enumerate() {
                let text = value.of(self.bytes);
                let target = || array.target(row);
                match new {
                    Some(new) if !new.allows(text) => {
                        return Err(RestoreError::DeclaredOtherwise {
                            target: target(),
                            array: name.clone(),
                            line: self.lines.line(value.start),
                            declared: self.text(value),
                            meant: String::from_utf8_lossy(&new.text).into_owned(),
                        });
                    }
                    Some(_) => {}
                    None => {
                        if let Some((moved, unit)) = array.declared_apart(row, text)
                            && seen.insert(value.start)
                        {
                            found.push(ModifiedTarget {
                                array: Some(name.clone()),
                                target: target(),
                                value: self.text(value),
                                line: self.lines.line(value.start),
                                into: ModifiedIn::DeclarationAlone,
                                moved,
                                unit,
                                others: Vec::new(),
                            });
                        }
                    }
                }
            }
        }
        Ok(found)
    }

    /// The elements of the array that a motion in `routine` named, where it is declared in this module.
    pub(super) fn declared_elements(&self, array: &Array, routine: Option<&Routine>) -> Vec<TextRange> {
        let is_named = |data: &DataDecl| data.name.of(self.bytes).eq_ignore_ascii_case(array.was());
        let mut of_routine = routine.into_iter().flat_map(|routine| &routine.body);
        let local = of_routine.find_map(|stmt| match &stmt.kind {
            StmtKind::Data(data) if is_named(data) => Some(&**data),
            _ => None,
        });
        let mut of_module = self.module.items.iter();
        let named = local.or_else(|| {
            of_module.find_map(|item| match item {
                ModuleItem::Data(data) if is_named(data) => Some(data),
                _ => None,
            })
        });
        named
            .and_then(|data| data.init.as_ref())
            .map(|init| elements(self.bytes, init, array.dims.len()))
            .unwrap_or_default()
    }
}
