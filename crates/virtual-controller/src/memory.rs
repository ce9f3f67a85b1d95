//! The task's memory: modules with their data, routines and types, and what a name means where.
//!
//! Initial values are evaluated when they are first asked for (`eval`); this file knows where they stand.

use super::compile::{latin1, name_of};
use super::ir::Name;
use super::predefined;
use super::value::{RecordType, Type, Value};
use rapid_syntax::SourceFile;
use rapid_syntax::tree::{self, DataKind, FileItem, ModuleItem, RoutineKind, Scope};
use std::collections::BTreeMap;
use std::rc::Rc;

/// A module in program memory.
#[derive(Debug)]
pub(super) struct Module {
    pub name: String,
    pub file: Rc<SourceFile>,
    pub data: BTreeMap<Name, usize>,
    pub routines: BTreeMap<Name, usize>,
    pub types: BTreeMap<Name, Type>,
    /// Loaded by the program while it runs: vanishes when the program pointer goes to main.
    pub dynamic: Option<String>,
    pub loaded: bool,
}

/// CONST, VAR or PERS of a module.
#[derive(Debug)]
pub(super) struct Datum {
    pub module: usize,
    pub name: Rc<str>,
    pub kind: DataKind,
    pub ty: Type,
    /// Item of the file, and item of that module.
    pub at: (usize, usize),
    pub state: State,
}

/// How far the value of a datum is known.
#[derive(Debug)]
pub(super) enum State {
    /// Nobody asked yet.
    Untouched,
    /// Its initial value is being evaluated: asked for again, it depends on itself.
    InWork,
    Known(Value),
}

/// A routine of a module.
#[derive(Debug)]
pub(super) struct Routine {
    pub module: usize,
    pub name: Rc<str>,
    pub kind: Kind,
    pub at: (usize, usize),
    pub code: Option<Rc<super::ir::Code>>,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Kind {
    Proc,
    Func(Type),
    Trap,
}

impl Module {
    fn item(&self, at: (usize, usize)) -> Option<&ModuleItem> {
        match self.file.tree.items.get(at.0)? {
            FileItem::Module(m) => m.items.get(at.1),
            _ => None,
        }
    }

    pub fn data_decl(&self, at: (usize, usize)) -> Option<&tree::DataDecl> {
        match self.item(at)? {
            ModuleItem::Data(d) => Some(d),
            _ => None,
        }
    }

    pub fn routine(&self, at: (usize, usize)) -> Option<&tree::Routine> {
        match self.item(at)? {
            ModuleItem::Routine(r) => Some(r),
            _ => None,
        }
    }
}

/// Everything loaded.
#[derive(Debug)]
pub(super) struct Memory {
    pub modules: Vec<Module>,
    pub data: Vec<Datum>,
    pub routines: Vec<Routine>,
    /// tool0, wobj0 and load0, once they were handed over as PERS.
    own_data: BTreeMap<Name, usize>,
    global_data: BTreeMap<Name, usize>,
    global_routines: BTreeMap<Name, usize>,
    global_types: BTreeMap<Name, Type>,
}

impl Memory {
    pub fn new() -> Self {
        Self {
            modules: Vec::new(),
            data: Vec::new(),
            routines: Vec::new(),
            own_data: BTreeMap::new(),
            global_data: BTreeMap::new(),
            global_routines: BTreeMap::new(),
            global_types: predefined::types(),
        }
    }

    /// The controller's own PERS of this name, with its value, as data that can be handed over.
    pub fn own_datum(&mut self, name: &Name, ty: Type, value: Value) -> usize {
        *self.own_data.entry(name.clone()).or_insert_with(|| {
            self.data.push(Datum {
                module: usize::MAX,
                name: name.clone(),
                kind: DataKind::Pers,
                ty,
                at: (0, 0),
                state: State::Known(value),
            });
            self.data.len() - 1
        })
    }

    /// Put the modules of a file into memory.
    ///
    /// # Errors
    /// What a controller would not load: a name that is there already.
    pub fn load(&mut self, file: &Rc<SourceFile>, dynamic: Option<&str>) -> Result<Vec<usize>, String> {
        let mut loaded = Vec::new();
        for (index, item) in file.tree.items.iter().enumerate() {
            if let FileItem::Module(module) = item {
                match self.load_module(file, index, module, dynamic) {
                    Ok(id) => loaded.push(id),
                    Err(why) => {
                        loaded.into_iter().for_each(|id| self.unload(id));
                        return Err(why);
                    }
                }
            }
        }
        if loaded.is_empty() { Err(format!("{} holds no module", file.path)) } else { Ok(loaded) }
    }

    fn load_module(
        &mut self,
        file: &Rc<SourceFile>,
        index: usize,
        module: &tree::Module,
        dynamic: Option<&str>,
    ) -> Result<usize, String> {
        let id = self.modules.len();
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
            if let Err(why) = self.declare(id, file, (index, k), item) {
                self.unload(id);
                return Err(why);
            }
        }
        Ok(id)
    }

    fn declare_type(&mut self, id: usize, file: &SourceFile, item: &ModuleItem) {
        let (name, scope, ty) = match item {
            ModuleItem::Record(r) => {
                let name = name_of(file, r.name);
                let fields = r
                    .components
                    .iter()
                    .map(|(ty, field)| (name_of(file, *field), self.type_named(id, &name_of(file, *ty))))
                    .collect();
                (name.clone(), r.scope, Type::Record(Rc::new(RecordType { name, fields })))
            }
            ModuleItem::Alias(a) => {
                let ty = self.type_named(id, &name_of(file, a.type_name));
                (name_of(file, a.name), a.scope, ty)
            }
            _ => return,
        };
        if scope == Scope::Local {
            if let Some(m) = self.modules.get_mut(id) {
                m.types.insert(name, ty);
            }
        } else {
            self.global_types.insert(name, ty);
        }
    }

    fn declare(
        &mut self,
        id: usize,
        file: &SourceFile,
        at: (usize, usize),
        item: &ModuleItem,
    ) -> Result<(), String> {
        let (range, scope) = match item {
            ModuleItem::Data(d) => (d.name, d.scope),
            ModuleItem::Routine(r) => (r.name, r.scope),
            _ => return Ok(()),
        };
        let (name, spelt) = (name_of(file, range), latin1(file, range));
        let global = scope != Scope::Local;
        let clash = |what: &str| Err(format!("{spelt} is declared twice ({what})"));
        let Some(module) = self.modules.get(id) else { return Ok(()) };
        if module.data.contains_key(&name) || module.routines.contains_key(&name) {
            return clash("in one module");
        }
        if global && (self.global_data.contains_key(&name) || self.global_routines.contains_key(&name)) {
            return clash("globally, in two modules");
        }
        match item {
            ModuleItem::Data(d) => {
                let ty = self.type_named(id, &name_of(file, d.type_name)).array_of(d.dims.len());
                let datum = self.data.len();
                self.data.push(Datum {
                    module: id,
                    name: spelt.into(),
                    kind: d.kind,
                    ty,
                    at,
                    state: State::Untouched,
                });
                if global {
                    self.global_data.insert(name.clone(), datum);
                }
                if let Some(m) = self.modules.get_mut(id) {
                    m.data.insert(name, datum);
                }
            }
            ModuleItem::Routine(r) => {
                let kind = match r.kind {
                    RoutineKind::Proc => Kind::Proc,
                    RoutineKind::Func(ty) => Kind::Func(self.type_named(id, &name_of(file, ty))),
                    RoutineKind::Trap => Kind::Trap,
                };
                let routine = self.routines.len();
                self.routines.push(Routine { module: id, name: spelt.into(), kind, at, code: None });
                if global {
                    self.global_routines.insert(name.clone(), routine);
                }
                if let Some(m) = self.modules.get_mut(id) {
                    m.routines.insert(name, routine);
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// Take a module out of memory; its data are lost.
    pub fn unload(&mut self, id: usize) {
        let Some(module) = self.modules.get_mut(id) else { return };
        module.loaded = false;
        let data = std::mem::take(&mut module.data);
        let routines = std::mem::take(&mut module.routines);
        self.global_data.retain(|_, d| !data.values().any(|x| x == d));
        self.global_routines.retain(|_, r| !routines.values().any(|x| x == r));
        for d in data.values() {
            if let Some(datum) = self.data.get_mut(*d) {
                datum.state = State::Untouched;
            }
        }
    }

    /// The type a name means in a module; an unknown one is kept by its name.
    pub fn type_named(&self, module: usize, name: &str) -> Type {
        let local = self.modules.get(module).and_then(|m| m.types.get(name));
        local.or_else(|| self.global_types.get(name)).cloned().unwrap_or_else(|| Type::Other(name.into()))
    }

    /// Data a name means in a module.
    pub fn datum(&self, module: usize, name: &str) -> Option<usize> {
        let local = self.modules.get(module).and_then(|m| m.data.get(name));
        local.or_else(|| self.global_data.get(name)).copied()
    }

    /// The routine a name means in a module; `MODULE:ROUTINE` names one of another module.
    pub fn routine(&self, module: usize, name: &str) -> Option<usize> {
        if let Some((module, name)) = name.split_once(':') {
            let home = self.modules.iter().find(|m| m.loaded && m.name.eq_ignore_ascii_case(module))?;
            return home.routines.get(name).copied();
        }
        let local = self.modules.get(module).and_then(|m| m.routines.get(name));
        local.or_else(|| self.global_routines.get(name)).copied()
    }

    /// Data of a name wherever they are: global, else of the first module that has them. For callers
    /// outside of the program (an operator, a test).
    pub fn datum_anywhere(&self, name: &str) -> Option<usize> {
        let in_some_module = || self.modules.iter().filter(|m| m.loaded).find_map(|m| m.data.get(name));
        self.global_data.get(name).or_else(in_some_module).copied()
    }

    /// The same for a routine.
    pub fn routine_anywhere(&self, name: &str) -> Option<usize> {
        let in_some_module = || self.modules.iter().filter(|m| m.loaded).find_map(|m| m.routines.get(name));
        self.routine(usize::MAX, name).or_else(|| in_some_module().copied())
    }
}
