//! Names of the controller's own that a given module declares anew: clock and functions would ask those.

use super::context::{Changes, EmitContext};
use super::names::words;
use super::options::{Core, EmitError};
use rapid_program::{is_controllers_own, task_of};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{FileItem, Module, ModuleItem, Scope};
use std::collections::BTreeSet;

/// Refuses a program that declares what clock and functions ask the controller for.
///
/// # Errors
/// [`EmitError::HiddenName`], naming the first such declaration.
pub(super) fn check(context: &EmitContext<'_>, changes: &Changes) -> Result<(), EmitError> {
    let mut asked: BTreeSet<String> = BTreeSet::new();
    for line in context.data.iter().chain(&context.routines) {
        let code = line.split('!').next().unwrap_or_default();
        for part in code.split('"').step_by(2) {
            words(part.as_bytes(), |word| {
                asked.insert(String::from_utf8_lossy(word).to_ascii_lowercase());
            });
        }
    }
    asked.retain(|name| is_controllers_own(name));
    let tasks: Vec<Option<&str>> =
        changes.keys().map(|(id, _)| task_of(&context.program.file(*id).path)).collect();
    for file in context.program.files.iter().filter(|file| tasks.contains(&task_of(&file.path))) {
        for (at, item) in file.tree.items.iter().enumerate() {
            let FileItem::Module(module) = item else { continue };
            let is_host = context.core == Core::Embedded && changes.keys().any(|key| *key == (file.id, at));
            for (name, scope) in declared(module) {
                let text = String::from_utf8_lossy(file.text(name)).into_owned();
                if (is_host || scope != Scope::Local) && asked.contains(&text.to_ascii_lowercase()) {
                    return Err(hidden(file, name, text, scope));
                }
            }
        }
    }
    Ok(())
}

/// Names and scopes of a module's data, routines and types.
fn declared(module: &Module) -> impl Iterator<Item = (TextRange, Scope)> {
    module.items.iter().filter_map(|item| match item {
        ModuleItem::Data(data) => Some((data.name, data.scope)),
        ModuleItem::Routine(routine) => Some((routine.name, routine.scope)),
        ModuleItem::Record(record) => Some((record.name, record.scope)),
        ModuleItem::Alias(alias) => Some((alias.name, alias.scope)),
        ModuleItem::Comment(_) | ModuleItem::Opaque(_) => None,
    })
}

fn hidden(file: &SourceFile, at: TextRange, name: String, scope: Scope) -> EmitError {
    let instead = if scope == Scope::Local { ", or use --core separate" } else { "" };
    EmitError::HiddenName { path: file.path.clone().into(), line: file.line(at), name, instead }
}
