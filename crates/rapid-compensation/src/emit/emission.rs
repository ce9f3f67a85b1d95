//! A program emitted file by file, each proved to give its source back before it is handed on.

use std::collections::BTreeMap;

use super::change::{changes, check_plan};
use super::checksum::hex;
use super::clock::Law;
use super::context::{Changes, EmitContext};
use super::core_module::{core_file, is_system_module};
use super::digest;
use super::header;
use super::hidden;
use super::module;
use super::not_written::{NotWritten, not_written};
use super::options::{Clock, Core, EmitError, EmitOptions, EmittedFile, Sensor};
use super::restore::{gives_back, restore};
use crate::compensate::plan::Plan;
use rapid_program::{Program, task_of};
use rapid_syntax::diagnostic::FileId;
use rapid_syntax::tree::{DataKind, FileItem, ModuleItem, Scope};
use rapid_syntax::{Rewrite, SourceFile};
use sha2::{Digest, Sha256};

/// Emits `program` with the targets of `plan`: the changed files, and `tcCore` where the core is separate.
///
/// Files in which nothing is compensated are not among them; a plan that compensates nothing gives none.
/// Same input, same bytes.
///
/// # Errors
/// [`EmitError`] says which rule of an emitted program could not be kept, and where.
pub fn emit(program: &Program, plan: &Plan, options: &EmitOptions) -> Result<Vec<EmittedFile>, EmitError> {
    let mut emitted: Vec<EmittedFile> = Vec::new();
    emit_each(program, plan, options, &mut |file| {
        emitted.push(file);
        Ok::<(), EmitError>(())
    })?;
    Ok(emitted)
}

/// The same, file by file: a large program's result need not be held at once. Whatever can be refused for the
/// program as a whole is, before `accept` is called. Returned are the names of the core that the program uses and
/// that its core has not: no controller loads it.
///
/// # Errors
/// As [`emit`], and those of `accept`.
pub fn emit_each<E: From<EmitError>>(
    program: &Program,
    plan: &Plan,
    options: &EmitOptions,
    accept: &mut dyn FnMut(EmittedFile) -> Result<(), E>,
) -> Result<Vec<NotWritten>, E> {
    let already = program.files.iter().find_map(|f| Some((f, compensated_at(f)?)));
    if let Some((file, line)) = already {
        return Err(EmitError::AlreadyCompensated { path: file.path.clone().into(), line }.into());
    }
    check_plan(program, plan)?;
    let law = Law::of(&options.clock, plan.temperature_c)?;
    if let Clock::Sensor { source: Sensor::Pers(name), .. } = &options.clock {
        check_persistent(program, name)?;
    }
    let changes = changes(program, plan)?;
    if changes.is_empty() {
        return Ok(Vec::new());
    }
    let core = core_place(plan, options, changes.len())?;
    let mut changed: Vec<FileId> = changes.keys().map(|(id, _)| *id).collect();
    changed.dedup();
    let tasks = tasks(program, &changed);
    if tasks.len() > 1 {
        let of_files: Vec<Option<String>> =
            tasks.values().map(|file| task_of(&file.path).map(str::to_owned)).collect();
        let is_beside = of_files.contains(&None);
        let tasks = of_files.into_iter().flatten().collect();
        return Err(match is_beside {
            true => EmitError::BesideTasks { tasks },
            false => EmitError::SeveralTasks { tasks },
        }
        .into());
    }
    let context = EmitContext::new((program, plan), options, (&law, core), &changes)?;
    hidden::check(&context, &changes)?;
    // As many at a time as are worked on, so that memory does not grow with their number.
    for some in changed.chunks(parallel::threads()) {
        let emitted = parallel::map(some.len(), &|i| emitted_file(&context, some[i], &changes));
        let emitted: Vec<EmittedFile> = emitted.into_iter().collect::<Result<_, _>>()?;
        emitted.into_iter().try_for_each(&mut *accept)?;
    }
    if core == Core::Separate {
        tasks.into_values().try_for_each(|beside| accept(core_file(&context, beside)))?;
    }
    Ok(not_written(program, &context.names))
}

/// Where clock and functions go when so many modules are changed.
fn core_place(plan: &Plan, options: &EmitOptions, modules: usize) -> Result<Core, EmitError> {
    if plan.schedule.buckets.is_empty() && plan.functions.is_none() {
        return Err(EmitError::PlanMismatch("no bucket".to_owned()));
    }
    let core = options.core.unwrap_or(if modules > 1 { Core::Separate } else { Core::Embedded });
    if core == Core::Embedded && modules > 1 {
        return Err(EmitError::EmbeddedInSeveral { modules });
    }
    Ok(core)
}

/// The line of the comment block that says that `file` holds a module of ours; `None` where none does.
#[must_use]
pub fn compensated_at(file: &SourceFile) -> Option<u32> {
    let modules = file.tree.items.iter().filter_map(|item| match item {
        FileItem::Module(module) => Some(module),
        _ => None,
    });
    // Each module has its comment block before its own routines.
    let before_routines = |module: &'_ rapid_syntax::tree::Module| {
        let at = module.items.iter().position(|item| matches!(item, ModuleItem::Routine(_)));
        at.unwrap_or(module.items.len())
    };
    modules.flat_map(|module| &module.items[..before_routines(module)]).find_map(|item| match item {
        ModuleItem::Comment(range) if header::begins(file.text(*range)) => Some(file.line(*range)),
        _ => None,
    })
}

/// A changed file, proved to give its original back.
fn emitted_file(context: &EmitContext<'_>, id: FileId, changes: &Changes) -> Result<EmittedFile, EmitError> {
    let file = context.program.file(id);
    let source_sha256 = hex(&Sha256::digest(&file.bytes));
    let mut text = Rewrite::new(&file.bytes);
    for (&(_, index), motions) in changes.range((id, 0)..=(id, usize::MAX)) {
        let Some(FileItem::Module(module)) = file.tree.items.get(index) else { continue };
        module::write(context, (file, module), motions, &source_sha256, &mut text)?;
    }
    let (mut bytes, replaced) = text.finish();
    digest::seal(&mut bytes);
    if !gives_back(&bytes, (&file.bytes, &source_sha256)) {
        let why = restore(&bytes).err();
        let what = why.map_or_else(|| "it comes out changed".to_owned(), |error| error.to_string());
        return Err(EmitError::NotRestored { path: file.path.clone().into(), what });
    }
    Ok(EmittedFile { source: Some(id), path: file.path.clone(), bytes, replaced })
}

/// The first changed file of each of the controller's tasks, the first system module where one is changed, by the task's folder: a task
/// sees nothing of another's modules and needs a clock of its own.
fn tasks<'p>(program: &'p Program, changed: &[FileId]) -> BTreeMap<Option<String>, &'p SourceFile> {
    let mut first = BTreeMap::new();
    for file in changed.iter().map(|id| program.file(*id)) {
        let path = &file.path;
        let task = task_of(path).and_then(|task| {
            let end = path.find(task)? + task.len();
            path.get(..end).map(str::to_ascii_lowercase)
        });
        let known = first.entry(task).or_insert(file);
        if is_system_module(file) && !is_system_module(known) {
            *known = file;
        }
    }
    first
}

/// A persistent that the given files declare must be one that every module sees.
fn check_persistent(program: &Program, name: &str) -> Result<(), EmitError> {
    let modules = program.files.iter().flat_map(|file| {
        let items = file.tree.items.iter().filter_map(|item| match item {
            FileItem::Module(module) => Some(&module.items),
            _ => None,
        });
        items.flatten().map(move |item| (file, item))
    });
    for (file, item) in modules {
        let ModuleItem::Data(data) = item else { continue };
        if !file.text(data.name).eq_ignore_ascii_case(name.as_bytes()) {
            continue;
        }
        let is_num = file.text(data.type_name).eq_ignore_ascii_case(b"num") && data.dims.is_empty();
        if data.kind != DataKind::Pers || !is_num || data.scope == Scope::Local {
            let why = "a given module declares it, and not as a global PERS num";
            return Err(EmitError::BadSensor { name: name.to_owned(), why });
        }
    }
    Ok(())
}
