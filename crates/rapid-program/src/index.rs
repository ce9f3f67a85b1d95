//! What is declared where: modules, routines and data of all files, and which of them a name means.
//!
//! RAPID's scopes: the variable of a FOR inside its loop, before data and parameters of the routine, before
//! those of its module, `LOCAL` or not, before the global ones of all modules of the task. A folder `TASKn` or `T_ROBn` in a file's path is a task of its own;
//! files outside such a folder share one.

mod declare;

use declare::task_of;

use super::AddedRoutine;
use super::ids::{DatumId, IdSet, ModuleId, RoutineIndex, Table};
use super::names::{ByNumber, Interner, Sym};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{FileId, Span, TextRange};
use rapid_syntax::tree::{DataKind, Expr, FileItem, Module, ParamMode, RecordDecl, Routine, RoutineKind};

/// Name of the module with which a plan's poses are measured.
pub const MEASURING_MODULE: &str = "DriftpostPlan";

/// What kind of name for a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DatumKind {
    /// Data that are declared as CONST, VAR or PERS.
    Declared(DataKind),
    /// A parameter of a routine.
    Param { mode: ParamMode, optional: bool },
    /// The variable of a FOR.
    LoopVariable,
}

/// A datum, parameter or loop variable.
#[derive(Clone, Debug)]
pub(super) struct Datum<'a> {
    pub(super) ctx: Ctx,
    pub(super) kind: DatumKind,
    pub(super) name: Sym,
    pub(super) type_name: Sym,
    pub(super) array: bool,
    pub(super) local: bool,
    /// Neither LOCAL nor TASK: as PERS it is one datum for all tasks.
    pub(super) shared: bool,
    pub(super) init: Option<&'a Expr>,
    pub(super) range: TextRange,
    pub(super) name_range: TextRange,
}

/// A routine and where it stands.
#[derive(Clone, Debug)]
pub(super) struct RoutineEntry<'a> {
    pub(super) ctx: Ctx,
    pub(super) name: Sym,
    pub(super) tree: &'a Routine,
    /// Its parameters in order.
    pub(super) params: Vec<DatumId>,
}

/// A module and where it stands.
#[derive(Clone, Debug)]
pub(super) struct ModuleEntry<'a> {
    pub(super) file: FileId,
    pub(super) task: u32,
    pub(super) tree: &'a Module,
}

/// From where a name is looked up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Ctx {
    pub(super) file: FileId,
    pub(super) module: ModuleId,
    pub(super) routine: Option<RoutineIndex>,
}

/// What a name means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Resolved<I> {
    /// Declared where it is seen from here.
    Here(I),
    /// Declared `LOCAL` in another module: a controller would not find it.
    Elsewhere(I),
    /// Declared twice in the scope that decides.
    Twice(I, I),
    /// Not declared in the given files.
    Nowhere,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum NameScope {
    Routine(RoutineIndex),
    Module(ModuleId),
    Task(u32),
    /// LOCAL somewhere in the task.
    Hidden(u32),
}

#[derive(Clone, Copy, Debug)]
struct ScopedName<I> {
    first: I,
    second: Option<I>,
}

/// Everything that is declared.
#[derive(Debug)]
pub(super) struct Index<'a> {
    pub(super) files: &'a [SourceFile],
    pub(super) names: Interner,
    pub(super) modules: Table<ModuleId, ModuleEntry<'a>>,
    pub(super) routines: Table<RoutineIndex, RoutineEntry<'a>>,
    pub(super) data: Table<DatumId, Datum<'a>>,
    data_at: ByNumber<(NameScope, Sym), ScopedName<DatumId>>,
    /// Variables of FOR with the statements they are seen in, outer loops first.
    loop_variables: ByNumber<(RoutineIndex, Sym), Vec<(TextRange, DatumId)>>,
    routines_at: ByNumber<(NameScope, Sym), ScopedName<RoutineIndex>>,
    records: ByNumber<Sym, (FileId, &'a RecordDecl)>,
    aliases: ByNumber<Sym, Sym>,
    /// Procedures that moves call in their corners, once they are looked for.
    pub(super) called_by_moves: IdSet<RoutineIndex>,
    /// Variables that only what is not given can set, once they are looked for.
    pub(super) open_variables: IdSet<DatumId>,
    /// Procedures that the program is given when it is written.
    pub(super) added_routines: &'a [AddedRoutine],
}

impl<'a> Index<'a> {
    /// Whether a routine may run between any two statements of its task: a trap, or a procedure that a move calls in its corner.
    pub(super) fn interrupts(&self, id: RoutineIndex) -> bool {
        self.routines[id].tree.kind == RoutineKind::Trap || self.called_by_moves.contains(id)
    }

    /// The procedure of a name that the program is given when it is written; where the program declares one itself that one is meant.
    pub(super) fn added_routine(&self, name: &str) -> Option<&'a AddedRoutine> {
        self.added_routines.iter().find(|added| added.name.eq_ignore_ascii_case(name))
    }

    /// Whether what stands there belongs to a measuring program that `plan` has written: its module's name.
    pub(super) fn is_measurement_run(&self, ctx: Ctx) -> bool {
        self.modules.get(ctx.module).is_some_and(|module| {
            self.text(module.file, module.tree.name).eq_ignore_ascii_case(MEASURING_MODULE.as_bytes())
        })
    }

    /// The index of all files.
    pub(super) fn new(files: &'a [SourceFile]) -> Self {
        let mut index = Self {
            files,
            names: Interner::default(),
            modules: Table::default(),
            routines: Table::default(),
            data: Table::default(),
            data_at: ByNumber::default(),
            loop_variables: ByNumber::default(),
            routines_at: ByNumber::default(),
            records: ByNumber::default(),
            aliases: ByNumber::default(),
            called_by_moves: IdSet::default(),
            open_variables: IdSet::default(),
            added_routines: &[],
        };
        index.intern_predefined(super::record::TYPES);
        let mut tasks: Vec<String> = Vec::new();
        for file in files {
            let folder = task_of(&file.path);
            let known = tasks.iter().position(|known| *known == folder);
            let task = known.unwrap_or_else(|| {
                tasks.push(folder);
                tasks.len() - 1
            }) as u32;
            for item in &file.tree.items {
                if let FileItem::Module(tree) = item {
                    index.add_module(file, tree, task);
                }
            }
        }
        index
    }

    /// The source of a file.
    pub(super) fn file(&self, id: FileId) -> &'a SourceFile {
        &self.files[id.0 as usize]
    }

    /// The bytes of a range of a file.
    pub(super) fn text(&self, file: FileId, range: TextRange) -> &'a [u8] {
        range.of(&self.file(file).bytes)
    }

    /// The number of the name that stands in a range, where the program declares or uses it.
    pub(super) fn name_at(&self, file: FileId, range: TextRange) -> Option<Sym> {
        self.names.find(self.text(file, range))
    }

    /// The datum that the name in a range means.
    pub(super) fn datum(&self, name: TextRange, ctx: Ctx) -> Resolved<DatumId> {
        let Some(sym) = self.name_at(ctx.file, name) else { return Resolved::Nowhere };
        let loops = ctx.routine.and_then(|routine| self.loop_variables.get(&(routine, sym)));
        let inside = |(body, _): &&(TextRange, DatumId)| body.contains(TextRange::empty(name.start));
        match loops.and_then(|loops| loops.iter().rfind(inside)) {
            Some((_, variable)) => Resolved::Here(*variable),
            None => self.look_up(&self.data_at, sym, ctx),
        }
    }

    /// The routine that a name means.
    pub(super) fn routine(&self, name: Sym, ctx: Ctx) -> Resolved<RoutineIndex> {
        self.look_up(&self.routines_at, name, Ctx { routine: None, ..ctx })
    }

    /// Whether the program declares a routine of the name in a range: then that is meant, not the controller's own.
    pub(super) fn declares_routine(&self, name: TextRange, ctx: Ctx) -> bool {
        self.name_at(ctx.file, name).is_some_and(|name| self.routine(name, ctx) != Resolved::Nowhere)
    }

    /// The span of a datum's declaration.
    pub(super) fn declaration(&self, datum: DatumId) -> Span {
        let d = &self.data[datum];
        Span { file: d.ctx.file, range: d.range }
    }

    /// `line 12 of path`: a place for a message.
    pub(super) fn place(&self, span: Span) -> String {
        let file = self.file(span.file);
        format!("line {} of {}", file.line(span.range), file.path)
    }

    /// Interner and types of a record's components.
    pub(super) fn components(&self, type_name: Sym) -> Option<Vec<(Sym, Sym)>> {
        let type_name = self.plain_type(type_name);
        if let Some((file, record)) = self.records.get(&type_name) {
            let named =
                |&(t, n): &(TextRange, TextRange)| Some((self.name_at(*file, n)?, self.name_at(*file, t)?));
            return record.components.iter().map(named).collect();
        }
        let known = super::record::components(self.names.text(type_name))?;
        known
            .iter()
            .map(|(n, t)| Some((self.names.find(n.as_bytes())?, self.names.find(t.as_bytes())?)))
            .collect()
    }

    /// The type behind aliases.
    pub(super) fn plain_type(&self, mut type_name: Sym) -> Sym {
        for _ in 0..16 {
            match self.aliases.get(&type_name) {
                Some(&next) => type_name = next,
                None => break,
            }
        }
        type_name
    }

    /// The type's name behind aliases, lower case.
    pub(super) fn type_text(&self, type_name: Sym) -> &str {
        self.names.text(self.plain_type(type_name))
    }

    fn look_up<I: Copy>(
        &self,
        at: &ByNumber<(NameScope, Sym), ScopedName<I>>,
        name: Sym,
        ctx: Ctx,
    ) -> Resolved<I> {
        let Some(module) = self.modules.get(ctx.module) else { return Resolved::Nowhere };
        let scopes = [
            ctx.routine.map(NameScope::Routine),
            Some(NameScope::Module(ctx.module)),
            Some(NameScope::Task(module.task)),
            Some(NameScope::Hidden(module.task)),
        ];
        for scope in scopes.into_iter().flatten() {
            match at.get(&(scope, name)) {
                Some(ScopedName { first, second: Some(second) }) => return Resolved::Twice(*first, *second),
                Some(ScopedName { first, .. }) if matches!(scope, NameScope::Hidden(_)) => {
                    return Resolved::Elsewhere(*first);
                }
                Some(ScopedName { first, .. }) => return Resolved::Here(*first),
                None => {}
            }
        }
        Resolved::Nowhere
    }
}
