//! What is written: data, files, modules.

use crate::Personality;
use crate::controller::{Controller, Holder, TASK};
use crate::http::{Incoming, Reply};
use crate::page::{self, MediaType};
use crate::rapid;
use crate::resources::{NOT_KNOWN, Rejection, found, is_home};
use crate::rights::Asker;

/// Writes a RAPID datum, if the rights allow.
pub(crate) fn set(c: &mut Controller, asker: Asker, request: &Incoming) -> Result<Reply, Rejection> {
    let parts = request.parts();
    let (task, module, name) = match (c.personality, parts.as_slice()) {
        (Personality::Rw6, ["rw", "rapid", "symbol", "data", "RAPID", task, module, name]) => {
            (*task, *module, *name)
        }
        (
            Personality::Rw7 | Personality::Rw8,
            ["rw", "rapid", "symbol", "RAPID", task, module, name, "data"],
        ) => (*task, *module, *name),
        _ => return Err(NOT_KNOWN),
    };
    c.may_write(asker)?;
    let (data, element) = found(c, task, module, name)?;
    if data.kind != "per" {
        return Err((400, -1_073_442_786, "symbol is not persistent"));
    }
    let wrong = (400, -1_073_442_803, "the value is not of this type");
    let value = request.field("value").ok_or(wrong)?;
    let kept = if data.dims.is_empty() || element.is_some() {
        rapid::kept(&data.data_type, &value).map_err(|_| wrong)?
    } else {
        let given = rapid::elements(&value).ok_or(wrong)?;
        let count: usize = data.dims.iter().product();
        if given.len() != count {
            return Err(wrong);
        }
        let kept: Result<Vec<String>, _> =
            given.iter().map(|value| rapid::kept(&data.data_type, value)).collect();
        format!("[{}]", kept.map_err(|_| wrong)?.join(","))
    };
    let kept = match element {
        None => kept,
        Some(n) => {
            let mut all = rapid::elements(&data.value).ok_or(wrong)?;
            *all.get_mut(n.wrapping_sub(1)).ok_or(wrong)? = kept;
            format!("[{}]", all.join(","))
        }
    };
    let bare = name.split('{').next().unwrap_or(name);
    if let Some(data) = c.data_mut(module, bare) {
        data.value = kept;
    }
    c.changes += 1;
    if c.write_clears_right {
        c.holder = Holder::Nobody;
    }
    Ok(Reply::new(204))
}

/// Keeps a file; `half` of it where the line breaks.
pub(crate) fn put(c: &mut Controller, request: &Incoming, half: bool) -> Result<Reply, Rejection> {
    c.may_use_disk()?;
    let parts = request.parts();
    let ["fileservice", home, name] = parts.as_slice() else { return Err(NOT_KNOWN) };
    if !is_home(c.personality, home) {
        return Err((400, -1_073_438_716, "virtual root does not exist"));
    }
    let length = if half { request.body.len() / 2 } else { request.body.len() };
    let is_new = c.files.insert((*name).to_owned(), request.body[..length].to_vec()).is_none();
    c.written.extend(rapid::module_name(&String::from_utf8_lossy(&request.body)));
    Ok(Reply::new(if is_new { 201 } else { 200 }))
}

/// Loads a module or takes one out.
pub(crate) fn task(
    c: &mut Controller,
    asker: Asker,
    request: &Incoming,
    media: MediaType,
) -> Result<Reply, Rejection> {
    let parts = request.parts();
    let (task, what) = match (c.personality, parts.as_slice()) {
        (Personality::Rw6, ["rw", "rapid", "tasks", task]) => {
            (*task, request.query("action").unwrap_or_default())
        }
        (Personality::Rw7 | Personality::Rw8, ["rw", "rapid", "tasks", task, what]) => (*task, *what),
        _ => return Err(NOT_KNOWN),
    };
    c.may_write(asker)?;
    if c.execution != "stopped" || c.pointer_is_not_reset {
        return Err((400, -1_073_442_809, "not in this state of execution"));
    }
    if task != TASK {
        return Err((404, -1_073_445_879, "task does not exist"));
    }
    match what {
        "loadmod" => load(c, request, media),
        "unloadmod" => {
            let name = request.field("module").unwrap_or_default();
            let before = c.modules.len();
            c.modules.retain(|module| !module.name.eq_ignore_ascii_case(&name));
            if c.modules.len() == before {
                return Err((400, -1_073_442_816, "unknown module name"));
            }
            c.changes += 1;
            Ok(Reply::new(204))
        }
        _ => Err(NOT_KNOWN),
    }
}

fn load(c: &mut Controller, request: &Incoming, media: MediaType) -> Result<Reply, Rejection> {
    let path = request.field("modulepath").unwrap_or_default();
    let no_file = (400, -1_073_438_708, "file not found");
    let (home, name) = path.split_once('/').ok_or(no_file)?;
    if !is_home(c.personality, home) {
        return Err((400, -1_073_438_716, "virtual root does not exist"));
    }
    let bytes = c.files.get(name).ok_or(no_file)?;
    let text = String::from_utf8_lossy(bytes).into_owned();
    let module = rapid::module_name(&text).unwrap_or_default();
    if c.module(&module).is_some() {
        return Err((400, -1_073_442_813, "a module of this name is loaded"));
    }
    // Names that are global in the task are there once: data, routines, and modules besides.
    let global = |text: &str, name: &str| {
        let data = rapid::data(text).into_iter().filter(|d| !d.is_local).map(|d| d.name);
        let mut names: Vec<String> = data.map(|name| name.to_ascii_lowercase()).collect();
        names.extend(rapid::global_routines(text));
        names.push(name.to_ascii_lowercase());
        names
    };
    let names = global(&text, &module);
    let is_taken = |m: &crate::Module| global(&m.text, &m.name).iter().any(|name| names.contains(name));
    let clashes = c.modules.iter().any(is_taken);
    let has_errors = clashes || c.finds_errors || !rapid::is_whole(&text);
    c.load(&text, "ProgMod");
    if has_errors {
        return Ok(page::page(media, &[], 299_008, None));
    }
    Ok(Reply::new(204))
}
