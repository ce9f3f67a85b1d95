//! What is declared where: modules, routines and data of all files, and which of them a name means.
//!
//! RAPID's scopes: the variable of a FOR inside its loop, before data and parameters of the routine, before
//! those of its module, `LOCAL` or not, before the global ones of all modules of the task. A folder `TASKn` in a file's path is a task of its own;
//! files outside such a folder share one.

use super::ids::{DatumId, ModuleId, RoutineIndex, Table};
use super::names::{ByNumber, Names, Sym, lower_case};
use super::statements::{bodies, every_statement};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{FileId, Span, TextRange};
use rapid_syntax::tree::{
    DataDecl, DataKind, Expr, FileItem, Module, ModuleItem, ParamMode, RecordDecl, Routine, Scope, StmtKind,
};

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
    pub(super) names: Names,
    pub(super) modules: Table<ModuleId, ModuleEntry<'a>>,
    pub(super) routines: Table<RoutineIndex, RoutineEntry<'a>>,
    pub(super) data: Table<DatumId, Datum<'a>>,
    data_at: ByNumber<(NameScope, Sym), ScopedName<DatumId>>,
    /// Variables of FOR with the statements they are seen in, outer loops first.
    loop_variables: ByNumber<(RoutineIndex, Sym), Vec<(TextRange, DatumId)>>,
    routines_at: ByNumber<(NameScope, Sym), ScopedName<RoutineIndex>>,
    records: ByNumber<Sym, (FileId, &'a RecordDecl)>,
    aliases: ByNumber<Sym, Sym>,
}

impl<'a> Index<'a> {
    /// The index of all files.
    pub(super) fn new(files: &'a [SourceFile]) -> Self {
        let mut index = Self {
            files,
            names: Names::default(),
            modules: Table::default(),
            routines: Table::default(),
            data: Table::default(),
            data_at: ByNumber::default(),
            loop_variables: ByNumber::default(),
            routines_at: ByNumber::default(),
            records: ByNumber::default(),
            aliases: ByNumber::default(),
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

    /// Names and types of a record's components.
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

    fn add_module(&mut self, file: &'a SourceFile, tree: &'a Module, task: u32) {
        self.names.intern(file.text(tree.name));
        let module = self.modules.push(ModuleEntry { file: file.id, task, tree });
        let ctx = Ctx { file: file.id, module, routine: None };
        for item in &tree.items {
            match item {
                ModuleItem::Data(decl) => self.add_data(file, decl, ctx, task),
                ModuleItem::Routine(routine) => self.add_routine(file, routine, ctx, task),
                ModuleItem::Record(record) => {
                    let name = self.names.intern(file.text(record.name));
                    for (type_name, component) in &record.components {
                        self.names.intern(file.text(*type_name));
                        self.names.intern(file.text(*component));
                    }
                    self.records.insert(name, (file.id, record));
                }
                ModuleItem::Alias(alias) => {
                    let name = self.names.intern(file.text(alias.name));
                    let type_name = self.names.intern(file.text(alias.type_name));
                    self.aliases.insert(name, type_name);
                }
                ModuleItem::Comment(_) | ModuleItem::Opaque(_) => {}
            }
        }
    }

    fn add_data(&mut self, file: &'a SourceFile, decl: &'a DataDecl, ctx: Ctx, task: u32) {
        let local = decl.scope == Scope::Local;
        let datum = Datum {
            ctx,
            kind: DatumKind::Declared(decl.kind),
            name: self.names.intern(file.text(decl.name)),
            type_name: self.names.intern(file.text(decl.type_name)),
            array: !decl.dims.is_empty(),
            local,
            shared: decl.scope == Scope::Global,
            init: decl.init.as_ref(),
            range: decl.range,
            name_range: decl.name,
        };
        self.push_datum(datum, task);
    }

    fn push_datum(&mut self, datum: Datum<'a>, task: u32) -> DatumId {
        let (id, name) = (self.data.next_id(), datum.name);
        match datum.ctx.routine {
            Some(routine) => enter(&mut self.data_at, NameScope::Routine(routine), name, id),
            None => {
                enter(&mut self.data_at, NameScope::Module(datum.ctx.module), name, id);
                let wider = if datum.local { NameScope::Hidden(task) } else { NameScope::Task(task) };
                enter(&mut self.data_at, wider, name, id);
            }
        }
        self.data.push(datum)
    }

    fn add_routine(&mut self, file: &'a SourceFile, tree: &'a Routine, ctx: Ctx, task: u32) {
        let id = self.routines.next_id();
        let name = self.names.intern(file.text(tree.name));
        enter(&mut self.routines_at, NameScope::Module(ctx.module), name, id);
        let local = tree.scope == Scope::Local;
        let wider = if local { NameScope::Hidden(task) } else { NameScope::Task(task) };
        enter(&mut self.routines_at, wider, name, id);
        let ctx = Ctx { routine: Some(id), ..ctx };
        self.routines.push(RoutineEntry { ctx, name, tree, params: Vec::new() });
        for param in &tree.params {
            let datum = Datum {
                ctx,
                kind: DatumKind::Param { mode: param.mode, optional: param.optional },
                name: self.names.intern(file.text(param.name)),
                type_name: self.names.intern(file.text(param.type_name)),
                array: param.dims > 0,
                local: true,
                shared: false,
                init: None,
                range: param.range,
                name_range: param.name,
            };
            let datum = self.push_datum(datum, task);
            self.routines[id].params.push(datum);
        }
        let mut loop_variables = Vec::new();
        for body in bodies(tree) {
            every_statement(body, &mut |stmt| match &stmt.kind {
                StmtKind::Data(decl) => self.add_data(file, decl, ctx, task),
                StmtKind::For(looped) => {
                    let first = looped.body.first().map_or(stmt.range.end, |first| first.range.start);
                    loop_variables.push((looped.var, TextRange::new(first, stmt.range.end)));
                }
                StmtKind::Label(label) => {
                    self.names.intern(file.text(*label));
                }
                _ => {}
            });
        }
        let num = self.names.intern(b"num");
        for (var, seen_in) in loop_variables {
            let name = self.names.intern(file.text(var));
            let kind = DatumKind::LoopVariable;
            let datum = Datum {
                ctx,
                kind,
                name,
                type_name: num,
                array: false,
                local: true,
                shared: false,
                init: None,
                range: var,
                name_range: var,
            };
            let variable = self.data.push(datum);
            self.loop_variables.entry((id, name)).or_default().push((seen_in, variable));
        }
    }

    /// Makes the names of predefined types and components known.
    fn intern_predefined(&mut self, names: &[&str]) {
        for name in names {
            self.names.intern(name.as_bytes());
            for (component, type_name) in super::record::components(name).unwrap_or_default() {
                self.names.intern(component.as_bytes());
                self.names.intern(type_name.as_bytes());
            }
        }
    }
}

fn enter<I: Copy>(at: &mut ByNumber<(NameScope, Sym), ScopedName<I>>, scope: NameScope, name: Sym, id: I) {
    at.entry((scope, name))
        .and_modify(|found| {
            found.second.get_or_insert(id);
        })
        .or_insert(ScopedName { first: id, second: None });
}

/// The part of a path that names its task: up to a folder `TASKn`, as in a controller's backup.
fn task_of(path: &str) -> String {
    let mut upto = 0;
    for part in path.split_inclusive('/') {
        upto += part.len();
        let digits = part.trim_end_matches('/').as_bytes();
        let is_task = part.ends_with('/')
            && digits.len() > 4
            && lower_case(&digits[..4]) == "task"
            && digits[4..].iter().all(u8::is_ascii_digit);
        if is_task {
            return path[..upto].to_owned();
        }
    }
    String::new()
}

#[cfg(test)]
mod tests {
    use super::task_of;

    #[test]
    fn a_task_folder_is_a_task_of_its_own() {
        assert_eq!(task_of("b/RAPID/TASK1/PROGMOD/a.mod"), "b/RAPID/TASK1/");
        assert_eq!(task_of("b/RAPID/task12/SYSMOD/a.sys"), "b/RAPID/task12/");
        assert_eq!(task_of("TASKS/a.mod"), "");
        assert_eq!(task_of("TASK1"), "");
        assert_eq!(task_of("a.mod"), "");
    }
}
