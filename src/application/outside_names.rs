//! Names by which what is emitted asks the cell: signals, and a procedure that finds a point. No controller loads a module in which one of
//! these is something else.

use super::compensation::Compensation;
use rapid_compensation::emit::{Clock, Core, Sensor, TouchBy};
use rapid_program::Program;
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{Diagnostic, Span, TextRange};
use rapid_syntax::tree::{FileItem, ModuleItem, RoutineKind, Scope};

/// What a name is declared as in a module.
struct Declared {
    at: Span,
    /// Its type, or what a routine is, as written.
    kind: String,
    is_procedure: bool,
    is_local: bool,
}

impl Compensation {
    /// What says that a signal or a procedure that the emitted text asks is declared as something else, or is in none of the files.
    pub(super) fn check_outside_names(&self, program: &Program) -> Vec<Diagnostic> {
        let by = self.touch.as_ref().map(|touch| &touch.by);
        let is_separate = self.emit.core == Some(Core::Separate);
        let clock = match &self.emit.clock {
            Clock::Sensor { source: Sensor::Signal(name), .. } => Some(("--clock signal:", name)),
            _ => None,
        };
        let touch = match by {
            Some(TouchBy::Search { signal, .. }) => Some(("--touch-signal ", signal)),
            _ => None,
        };
        let signals = clock.into_iter().chain(touch);
        let mut found: Vec<Diagnostic> =
            signals.filter_map(|(option, name)| no_signal(program, is_separate, option, name)).collect();
        if let Some(TouchBy::Routine(name)) = by {
            found.extend(no_procedure(program, name));
        }
        found
    }
}

/// That a name is declared as anything but a signal.
fn no_signal(program: &Program, is_separate: bool, option: &str, name: &str) -> Option<Diagnostic> {
    let all = declared(program, name);
    let is_seen = |one: &Declared| one.kind.starts_with("signal") && !(one.is_local && is_separate);
    let other = all.into_iter().find(|one| !is_seen(one))?;
    let text = match other.kind.starts_with("signal") {
        true => format!("{option}{name}: {name} is LOCAL to its module, and tcCore cannot see it"),
        false => format!("{option}{name}: {name} is a {} of the program, and no signal", other.kind),
    };
    Some(
        Diagnostic::error("emit::bad-sensor", text)
            .at(other.at)
            .help("name a signal of the controller's configuration"),
    )
}

/// That a name is declared as anything but a procedure, or in none of the files.
fn no_procedure(program: &Program, name: &str) -> Option<Diagnostic> {
    let all = declared(program, name);
    if all.iter().any(|one| one.is_procedure) {
        return None;
    }
    Some(match all.first() {
        Some(other) => {
            let text =
                format!("--touch-routine {name}: {name} is a {} of the program, and no PROC", other.kind);
            Diagnostic::error("touch::how", text)
                .at(other.at)
                .help("name a PROC(robtarget expected,INOUT robtarget found)")
        }
        None => {
            let text = format!("--touch-routine {name}: no PROC {name} is in the given files");
            let help = "where no other module of the task has it, what is written here does not load";
            Diagnostic::warning("resolve::routine-not-given", text).help(help)
        }
    })
}

/// What a name is in the modules of a program; data of routines, which nothing outside of them sees, do not count.
fn declared(program: &Program, name: &str) -> Vec<Declared> {
    let mut all = Vec::new();
    for file in &program.files {
        let modules = file.tree.items.iter().filter_map(|item| match item {
            FileItem::Module(module) => Some(&module.items),
            _ => None,
        });
        let is_named = |range: TextRange| file.text(range).eq_ignore_ascii_case(name.as_bytes());
        let of = |item: &ModuleItem| match item {
            ModuleItem::Data(data) if is_named(data.name) => {
                Some((data.name, as_text(file, data.type_name), false, data.scope == Scope::Local))
            }
            ModuleItem::Routine(routine) if is_named(routine.name) => Some(match routine.kind {
                RoutineKind::Proc => (routine.name, "PROC".to_owned(), true, routine.scope == Scope::Local),
                RoutineKind::Func(_) => (routine.name, "FUNC".to_owned(), false, false),
                RoutineKind::Trap => (routine.name, "TRAP".to_owned(), false, false),
            }),
            _ => None,
        };
        all.extend(modules.flatten().filter_map(of).map(|(range, kind, is_procedure, is_local)| Declared {
            at: Span { file: file.id, range },
            kind,
            is_procedure,
            is_local,
        }));
    }
    all
}

fn as_text(file: &SourceFile, range: TextRange) -> String {
    String::from_utf8_lossy(file.text(range)).to_ascii_lowercase()
}
