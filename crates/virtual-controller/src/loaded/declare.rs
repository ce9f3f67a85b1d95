//! Modules come into program memory, with all that they declare, and leave it.

use super::{Datum, DatumOrigin, ItemIndex, LoadedProgram, Module, Routine, RoutineKind};
use crate::compile::{as_written, latin1, lower_case_name};
use crate::ids::{ModuleId, RoutineId};
use crate::value::{RecordType, Type};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::FileId;
use rapid_syntax::tree::{self, FileItem, ModuleItem, Scope};
use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::rc::Rc;

impl LoadedProgram {
    /// Puts the modules of a file into memory; `dynamic` is the file's name where the program itself loads it.
    ///
    /// # Errors
    /// What a controller would not load: a name that is there already.
    pub(crate) fn load(&mut self, path: &str, bytes: &[u8], dynamic: Option<&str>) -> Result<(), String> {
        let id = FileId(self.files);
        self.files += 1;
        let file = &Rc::new(SourceFile::read(id, path, bytes.to_vec()));
        let mut loaded = Vec::new();
        for (index, item) in file.tree.items.iter().enumerate() {
            if let FileItem::Module(module) = item {
                match self.load_module(file, index, module, dynamic) {
                    Ok(id) => loaded.push(id),
                    Err(why) => {
                        loaded.into_iter().for_each(|id| drop(self.unload(id)));
                        return Err(why);
                    }
                }
            }
        }
        if loaded.is_empty() { Err(format!("{} holds no module", file.path)) } else { Ok(()) }
    }

    fn load_module(
        &mut self,
        file: &Rc<SourceFile>,
        index: usize,
        module: &tree::Module,
        dynamic: Option<&str>,
    ) -> Result<ModuleId, String> {
        self.changes += 1;
        let id = ModuleId::new(self.modules.len());
        let name = latin1(file, module.name);
        if self.modules.iter().any(|m| m.loaded && m.name.eq_ignore_ascii_case(&name)) {
            return Err(format!("a module {name} is loaded already"));
        }
        self.modules.push(Module {
            name,
            file: file.clone(),
            data: BTreeMap::new(),
            routines: BTreeMap::new(),
            types: BTreeMap::new(),
            dynamic: dynamic.map(str::to_owned),
            loaded: true,
        });
        // Types first: data may stand before the RECORD they are made of.
        for item in &module.items {
            self.declare_type(id, file, item);
        }
        for (k, item) in module.items.iter().enumerate() {
            if let Err(why) = self.declare(id, file, ItemIndex { module: index, item: k }, item) {
                self.unload(id);
                return Err(why);
            }
        }
        Ok(id)
    }

    fn declare_type(&mut self, id: ModuleId, file: &SourceFile, item: &ModuleItem) {
        let (name, scope, ty) = match item {
            ModuleItem::Record(r) => {
                let name = lower_case_name(file, r.name);
                let fields = r
                    .components
                    .iter()
                    .map(|(ty, field)| {
                        (
                            lower_case_name(file, *field),
                            self.type_named(Some(id), &lower_case_name(file, *ty)),
                        )
                    })
                    .collect();
                (name.clone(), r.scope, Type::Record(Rc::new(RecordType { name, fields })))
            }
            ModuleItem::Alias(a) => {
                let ty = self.type_named(Some(id), &lower_case_name(file, a.type_name));
                (lower_case_name(file, a.name), a.scope, ty)
            }
            _ => return,
        };
        if scope == Scope::Local {
            if let Some(m) = self.modules.get_mut(id.index()) {
                m.types.insert(name, ty);
            }
        } else {
            self.global_types.insert(name, ty);
        }
    }

    fn declare(
        &mut self,
        id: ModuleId,
        file: &SourceFile,
        at: ItemIndex,
        item: &ModuleItem,
    ) -> Result<(), String> {
        let (range, scope) = match item {
            ModuleItem::Data(d) => (d.name, d.scope),
            ModuleItem::Routine(r) => (r.name, r.scope),
            _ => return Ok(()),
        };
        let (name, spelt) = (lower_case_name(file, range), as_written(file, range));
        let global = scope != Scope::Local;
        let clash = |what: &str| Err(format!("{spelt} is declared twice ({what})"));
        let Some(module) = self.modules.get(id.index()) else { return Ok(()) };
        if module.data.contains_key(&name) || module.routines.contains_key(&name) {
            return clash("in one module");
        }
        if global && (self.global_data.contains_key(&name) || self.global_routines.contains_key(&name)) {
            return clash("globally, in two modules");
        }
        match item {
            ModuleItem::Data(d) => {
                let ty =
                    self.type_named(Some(id), &lower_case_name(file, d.type_name)).array_of(d.dims.len());
                let datum = self.data.len();
                let origin = DatumOrigin::Module { module: id, at };
                self.data.push(Datum { name: spelt.into(), kind: d.kind, ty, origin });
                if global {
                    self.global_data.insert(name.clone(), datum);
                }
                if let Some(m) = self.modules.get_mut(id.index()) {
                    m.data.insert(name, datum);
                }
            }
            ModuleItem::Routine(r) => {
                let kind = self.routine_kind(id, file, r);
                let routine = RoutineId::new(self.routines.len());
                self.routines.push(Routine {
                    module: id,
                    name: spelt.into(),
                    kind,
                    at,
                    code: OnceCell::new(),
                });
                if global {
                    self.global_routines.insert(name.clone(), routine);
                }
                if let Some(m) = self.modules.get_mut(id.index()) {
                    m.routines.insert(name, routine);
                }
            }
            _ => {}
        }
        Ok(())
    }

    fn routine_kind(&self, id: ModuleId, file: &SourceFile, routine: &tree::Routine) -> RoutineKind {
        match routine.kind {
            tree::RoutineKind::Proc => RoutineKind::Proc,
            tree::RoutineKind::Func(ty) => {
                RoutineKind::Func(self.type_named(Some(id), &lower_case_name(file, ty)))
            }
            tree::RoutineKind::Trap => RoutineKind::Trap,
        }
    }

    /// Take a module out of memory; the data whose values are lost with it.
    pub(crate) fn unload(&mut self, id: ModuleId) -> Vec<usize> {
        self.changes += 1;
        let Some(module) = self.modules.get_mut(id.index()) else { return Vec::new() };
        module.loaded = false;
        let data = std::mem::take(&mut module.data);
        let routines = std::mem::take(&mut module.routines);
        self.global_data.retain(|_, d| !data.values().any(|x| x == d));
        self.global_routines.retain(|_, r| !routines.values().any(|x| x == r));
        data.into_values().collect()
    }

    /// Takes all modules out of memory that the program loaded itself; the data whose values are lost.
    pub(crate) fn unload_dynamic(&mut self) -> Vec<usize> {
        let is_dynamic = |m: &Module| m.loaded && m.dynamic.is_some();
        let ids: Vec<usize> = (0..self.modules.len()).filter(|&id| is_dynamic(&self.modules[id])).collect();
        ids.into_iter().map(ModuleId::new).flat_map(|id| self.unload(id)).collect()
    }
}
