//! The index filled in: what the modules of the files declare, each name with the scopes it is seen in.
//!
//! Decides no name's meaning; that is looked up when all is declared.

use super::{Ctx, Datum, DatumKind, Index, ModuleEntry, NameScope, RoutineEntry, ScopedName};
use crate::ids::DatumId;
use crate::names::{ByNumber, Sym};
use crate::record;
use crate::statements::{bodies, every_statement};
use crate::through_task;
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{DataDecl, Module, ModuleItem, Routine, Scope, StmtKind};

/// The part of a path that names its task: up to the folder of the task.
pub(super) fn task_of(path: &str) -> String {
    through_task(path).map_or_else(String::new, |upto| format!("{upto}/"))
}

impl<'a> Index<'a> {
    pub(super) fn add_module(&mut self, file: &'a SourceFile, tree: &'a Module, task: u32) {
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
    pub(super) fn intern_predefined(&mut self, names: &[&str]) {
        for name in names {
            self.names.intern(name.as_bytes());
            for (component, type_name) in record::components(name).unwrap_or_default() {
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

#[cfg(test)]
mod tests {
    use super::task_of;

    #[test]
    fn a_task_folder_is_a_task_of_its_own() {
        assert_eq!(task_of("b/RAPID/TASK1/PROGMOD/a.mod"), "b/RAPID/TASK1/");
        assert_eq!(task_of("b/RAPID/task12/SYSMOD/a.sys"), "b/RAPID/task12/");
        assert_eq!(task_of("RAPID/T_ROB1/a.mod"), "RAPID/T_ROB1/");
        assert_eq!(task_of("t_rob_l/PROGMOD/a.mod"), "t_rob_l/");
        assert_eq!(task_of("T_pick.mod"), "");
        // A project's folder above the tasks, and a part of a task in a backup.
        assert_eq!(task_of("t_cell/RAPID/T_ROB2/a.mod"), "t_cell/RAPID/T_ROB2/");
        assert_eq!(task_of("b/TASK1/T_parts/a.mod"), "b/TASK1/");
        assert_eq!(task_of("RAPID/T_/a.mod"), "");
        assert_eq!(task_of("TASKS/a.mod"), "");
        assert_eq!(task_of("TASK1"), "");
        assert_eq!(task_of("a.mod"), "");
    }
}
