//! The loaded program: modules with their data, routines and types, and what a name means where.
//!
//! Constant while it runs, but for modules that the program itself loads and unloads. Values of data are the
//! machine's; initial values are evaluated when they are first asked for, this file knows where they stand.

mod declare;

use super::code::{Code, Found, Name, NameRef};
use super::compile;
use super::ids::{ModuleId, RoutineId};
use super::outcome::SourceLine;
use super::predefined::{self, Types};
use super::value::Type;
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{self, DataKind, FileItem, ModuleItem};
use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// Which item of a module's file a declaration is.
#[derive(Clone, Copy, Debug)]
pub(super) struct ItemIndex {
    /// Which item of the file the module is.
    pub module: usize,
    /// Which item of that module it is.
    pub item: usize,
}

/// A module in program memory.
#[derive(Debug)]
pub(super) struct Module {
    pub name: String,
    pub file: Rc<SourceFile>,
    pub data: BTreeMap<Name, usize>,
    pub routines: BTreeMap<Name, RoutineId>,
    pub types: BTreeMap<Name, Type>,
    /// Loaded by the program while it runs: vanishes when the program pointer goes to main.
    pub dynamic: Option<String>,
    pub loaded: bool,
}

/// CONST, VAR or PERS of a module, or the controller's own.
#[derive(Debug)]
pub(super) struct Datum {
    pub name: Rc<str>,
    pub kind: DataKind,
    pub ty: Type,
    pub origin: DatumOrigin,
}

/// Where a datum is declared.
#[derive(Clone, Copy, Debug)]
pub(super) enum DatumOrigin {
    /// In a module of the program.
    Module { module: ModuleId, at: ItemIndex },
    /// Nowhere: tool0, wobj0 and load0 are PERS that every controller has.
    Controller,
}

/// A routine of a module.
#[derive(Debug)]
pub(super) struct Routine {
    pub module: ModuleId,
    pub name: Rc<str>,
    pub kind: RoutineKind,
    pub at: ItemIndex,
    /// Its executable form, once it was called.
    code: OnceCell<Rc<Code>>,
}

/// What a routine is; a function has the type of its value.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum RoutineKind {
    Proc,
    Func(Type),
    Trap,
}

impl Module {
    fn item(&self, at: ItemIndex) -> Option<&ModuleItem> {
        match self.file.tree.items.get(at.module)? {
            FileItem::Module(m) => m.items.get(at.item),
            _ => None,
        }
    }

    pub(crate) fn data_decl(&self, at: ItemIndex) -> Option<&tree::DataDecl> {
        match self.item(at)? {
            ModuleItem::Data(d) => Some(d),
            _ => None,
        }
    }

    pub(crate) fn routine(&self, at: ItemIndex) -> Option<&tree::Routine> {
        match self.item(at)? {
            ModuleItem::Routine(r) => Some(r),
            _ => None,
        }
    }
}

/// Everything that is loaded, and what every controller has.
#[derive(Debug)]
pub(super) struct LoadedProgram {
    pub modules: Vec<Module>,
    pub data: Vec<Datum>,
    pub routines: Vec<Routine>,
    /// Built-in types that instructions need.
    pub types: Types,
    /// tool0, wobj0 and load0.
    own_data: BTreeMap<Name, usize>,
    /// Files that were read so far.
    files: u32,
    /// How often modules came or went.
    changes: u64,
    global_data: BTreeMap<Name, usize>,
    global_routines: BTreeMap<Name, RoutineId>,
    global_types: BTreeMap<Name, Type>,
}

impl LoadedProgram {
    /// No module is loaded.
    pub(crate) fn new() -> Self {
        let types = Types::new();
        let own = [("tool0", &types.tooldata), ("wobj0", &types.wobjdata), ("load0", &types.loaddata)];
        let datum = |(name, ty): (&str, &Type)| Datum {
            name: name.into(),
            kind: DataKind::Pers,
            ty: ty.clone(),
            origin: DatumOrigin::Controller,
        };
        Self {
            modules: Vec::new(),
            data: own.map(datum).into(),
            routines: Vec::new(),
            own_data: own.iter().enumerate().map(|(id, (name, _))| ((*name).into(), id)).collect(),
            types,
            files: 0,
            changes: 0,
            global_data: BTreeMap::new(),
            global_routines: BTreeMap::new(),
            global_types: predefined::types(),
        }
    }

    /// The controller's own PERS of this name, as data that can be handed over.
    pub(crate) fn own_datum(&self, name: &str) -> Option<(usize, Type)> {
        let id = *self.own_data.get(name)?;
        Some((id, self.data.get(id)?.ty.clone()))
    }

    /// What a routine is.
    pub(crate) fn kind(&self, routine: RoutineId) -> Option<&RoutineKind> {
        self.routines.get(routine.index()).map(|r| &r.kind)
    }

    /// The module a routine stands in; `None` where there is no such routine.
    pub(crate) fn module_of(&self, routine: RoutineId) -> Option<ModuleId> {
        self.routines.get(routine.index()).map(|r| r.module)
    }

    /// The executable form of a routine, made when it is first asked for.
    pub(crate) fn code(&self, routine: RoutineId) -> Option<Rc<Code>> {
        let routine = self.routines.get(routine.index())?;
        if let Some(code) = routine.code.get() {
            return Some(code.clone());
        }
        let module = self.modules.get(routine.module.index())?;
        let code = Rc::new(compile::routine(&module.file, module.routine(routine.at)?));
        Some(routine.code.get_or_init(|| code).clone())
    }

    /// Whether a routine is a function.
    pub(crate) fn is_function(&self, routine: RoutineId) -> bool {
        matches!(self.kind(routine), Some(RoutineKind::Func(_)))
    }

    /// Where a range of a module stands, for messages.
    pub(crate) fn source_line(&self, module: ModuleId, range: TextRange) -> SourceLine {
        match self.modules.get(module.index()) {
            Some(m) => SourceLine { file: m.file.path.clone(), line: m.file.line(range) },
            None => SourceLine::default(),
        }
    }

    /// A module by its number; without one, none.
    fn module(&self, id: Option<ModuleId>) -> Option<&Module> {
        self.modules.get(id?.index())
    }

    /// The type a name means in a module, or outside of all; an unknown one is kept by its name.
    pub(crate) fn type_named(&self, module: Option<ModuleId>, name: &str) -> Type {
        let local = self.module(module).and_then(|m| m.types.get(name));
        local.or_else(|| self.global_types.get(name)).cloned().unwrap_or_else(|| Type::Other(name.into()))
    }

    /// Data a name means in a module, or outside of all.
    pub(crate) fn datum(&self, module: Option<ModuleId>, name: &str) -> Option<usize> {
        let local = self.module(module).and_then(|m| m.data.get(name));
        local.or_else(|| self.global_data.get(name)).copied()
    }

    /// The same for a name in a routine, which is looked up once for as long as no module comes or goes.
    pub(crate) fn named_datum(&self, module: Option<ModuleId>, named: &NameRef) -> Option<usize> {
        match named.found.get() {
            Some(found) if found.module == module && found.changes == self.changes => found.datum,
            _ => {
                let datum = self.datum(module, &named.name);
                named.found.set(Some(Found { module, changes: self.changes, datum }));
                datum
            }
        }
    }

    /// The routine a name means in a module, or outside of all; `MODULE:ROUTINE` names one of another module.
    pub(crate) fn routine(&self, module: Option<ModuleId>, name: &str) -> Option<RoutineId> {
        if let Some((module, name)) = name.split_once(':') {
            let home = self.modules.iter().find(|m| m.loaded && m.name.eq_ignore_ascii_case(module))?;
            return home.routines.get(name).copied();
        }
        let local = self.module(module).and_then(|m| m.routines.get(name));
        local.or_else(|| self.global_routines.get(name)).copied()
    }

    /// Data of a name wherever they are: global, else of the first module that has them. For callers
    /// outside of the program (an operator, a test).
    pub(crate) fn datum_anywhere(&self, name: &str) -> Option<usize> {
        let in_some_module = || self.modules.iter().filter(|m| m.loaded).find_map(|m| m.data.get(name));
        self.global_data.get(name).or_else(in_some_module).copied()
    }

    /// The same for a routine.
    pub(crate) fn routine_anywhere(&self, name: &str) -> Option<RoutineId> {
        let in_some_module = || self.modules.iter().filter(|m| m.loaded).find_map(|m| m.routines.get(name));
        self.routine(None, name).or_else(|| in_some_module().copied())
    }
}
