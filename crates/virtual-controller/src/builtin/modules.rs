//! Modules loaded and unloaded while the program runs.

use super::parameter::{Data, Function, Instruction, Parameter, Unevaluated, function, instruction, string};
use crate::ids::ModuleId;
use crate::interpreter::{Args, Interpreter};
use crate::machine::Disk;
use crate::outcome::{Fault, fatal, raise};
use crate::value::Value;

pub(super) const FUNCTIONS: &[Function] = &[
    function!("isfile", Nothing, (path: String), |vm, args| {
        let file = file(vm, args, path)?;
        Ok(Value::Bool(vm.machine.disk.files.contains_key(&file)))
    }),
    function!("modexist", Nothing, (module: String), |vm, args| {
        let mut modules = vm.program.modules.iter();
        Ok(Value::Bool(modules.any(|m| m.loaded && m.name.eq_ignore_ascii_case(&module))))
    }),
];

pub(super) const INSTRUCTIONS: &[Instruction] = &[
    instruction!("load", (path: String), |vm, args| {
        let file = file(vm, args, path)?;
        load(vm, &file)
    }),
    instruction!("startload", (path: String, session: Data), |vm, args| {
        let file = file(vm, args, path)?;
        if !vm.machine.disk.files.contains_key(&file) {
            return raise("err_filnotfnd", format!("there is no file {file}"));
        }
        let Some((place, _)) = session else {
            return fatal("StartLoad expects a variable of type loadsession");
        };
        vm.machine.disk.load_sessions.push(Some(file));
        let session = Value::num(vm.machine.disk.load_sessions.len() as f64);
        vm.write(&place, session)
    }),
    instruction!("waitload", (session: Unevaluated), |vm, args| {
        if let Some(e) = args.named("unloadfile").or_else(|| args.named("unloadpath")) {
            let old = string(vm, e)?;
            unload(vm, &Disk::file_name(&old))?;
        }
        match session_file(vm, args)? {
            Some(file) => load(vm, &file),
            None => raise("err_loadno_nouse", "WaitLoad of a session that is not in use"),
        }
    }),
    instruction!("cancelload", (session: Unevaluated), |vm, args| match session_file(vm, args)? {
        Some(_) => Ok(()),
        None => raise("err_loadno_nouse", "CancelLoad of a session that is not in use"),
    }),
    instruction!("unload", (path: String), |vm, args| {
        let file = file(vm, args, path)?;
        unload(vm, &file)
    }),
    instruction!("checkprogref", (), |vm, args| Ok(())),
];

/// The file that a path means, or `\File` beside it.
fn file(vm: &mut Interpreter<'_>, args: &Args<'_>, path: String) -> Result<String, Fault> {
    let whole = match args.named("file") {
        Some(e) => string(vm, e)?,
        None => path,
    };
    Ok(Disk::file_name(&whole))
}

/// The file that a load session still waits for; it waits no longer.
fn session_file(vm: &mut Interpreter<'_>, args: &Args<'_>) -> Result<Option<String>, Fault> {
    let session = vm.eval_num(args.at(0)?)?;
    let sessions = &mut vm.machine.disk.load_sessions;
    Ok(sessions.get_mut((session as usize).wrapping_sub(1)).and_then(Option::take))
}

fn load(vm: &mut Interpreter<'_>, file: &str) -> Result<(), Fault> {
    let Some(bytes) = vm.machine.disk.files.get(file) else {
        return raise("err_filnotfnd", format!("there is no file {file}"));
    };
    if vm.program.modules.iter().any(|m| m.loaded && m.dynamic.as_deref() == Some(file)) {
        return raise("err_loaded", format!("{file} is loaded already"));
    }
    match vm.program.load(file, bytes, Some(file)) {
        Ok(()) => Ok(()),
        Err(why) => raise("err_syntax", format!("{file} does not load: {why}")),
    }
}

fn unload(vm: &mut Interpreter<'_>, file: &str) -> Result<(), Fault> {
    let is_of_file =
        |(_, m): &(usize, &crate::loaded::Module)| m.loaded && m.dynamic.as_deref() == Some(file);
    let loaded: Vec<ModuleId> =
        vm.program.modules.iter().enumerate().filter(is_of_file).map(|(id, _)| ModuleId::new(id)).collect();
    if loaded.is_empty() || vm.machine.stack.frames.iter().any(|f| loaded.contains(&f.module)) {
        return raise("err_unload", format!("{file} cannot be unloaded: not loaded, or in execution"));
    }
    for datum in loaded.into_iter().flat_map(|id| vm.program.unload(id)) {
        vm.machine.data.forget(datum);
    }
    Ok(())
}
