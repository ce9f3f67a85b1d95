//! What is read: identity, states, tasks, data, files.

use crate::Personality;
use crate::arm::{NO_TOOL, Solver};
use crate::controller::{Controller, TASK, UNIT};
use crate::http::{Incoming, Reply};
use crate::page::{self, Entry, MediaType, entry};
use crate::rapid::{self, Data};
use robot_model::units::{mm_from_m, rad_from_deg};

/// Status, ABB's code and a sentence.
pub(crate) type Rejection = (u16, i64, &'static str);

pub(crate) const NOT_KNOWN: Rejection = (404, -1_073_414_146, "resource not found");

/// Answers a GET; what is no text of entries is a file.
pub(crate) fn read(
    c: &Controller,
    solver: &Solver,
    request: &Incoming,
    media: MediaType,
    loops: bool,
) -> Result<Reply, Rejection> {
    if let ["fileservice", home, name @ ..] = request.parts().as_slice() {
        return files(c, home, name, media);
    }
    let entries = entries(c, solver, request)?;
    let next = loops.then(|| format!("{}?start=0&limit=100", request.path));
    Ok(page::page(media, &entries, page::OK, next.as_deref()))
}

fn one(class: &'static str, fields: &[(&'static str, &str)]) -> Result<Vec<Entry>, Rejection> {
    Ok(vec![entry(class, fields.first().map_or("", |(name, _)| name), fields)])
}

fn entries(c: &Controller, solver: &Solver, request: &Incoming) -> Result<Vec<Entry>, Rejection> {
    let is_six = c.personality == Personality::Rw6;
    match request.parts().as_slice() {
        ["rw", "system"] => system(c),
        ["rw", "system", "options"] => Ok(["RobotWare Base", "616-1 PC Interface", "608-1 World Zones"]
            .iter()
            .map(|option| entry("sys-option-li", option, &[("option", option)]))
            .collect()),
        ["rw", "system", "robottype"] => one("sys-robottype", &[("robot-type", "IRB 140-6/0.8")]),
        ["ctrl", "identity"] => one(
            "ctrl-identity-info",
            &[("ctrl-name", "double"), ("ctrl-id", ""), ("ctrl-type", "VIRTUAL CONTROLLER")],
        ),
        ["rw", "panel", "opmode"] => one("pnl-opmode", &[("opmode", c.mode)]),
        ["rw", "panel", "ctrlstate"] if is_six => one("pnl-ctrlstate", &[("ctrlstate", "motoroff")]),
        ["rw", "panel", "ctrl-state"] if !is_six => one("pnl-ctrlstate", &[("ctrlstate", "motoroff")]),
        ["rw", "rapid", "execution"] => {
            one("rap-execution", &[("ctrlexecstate", c.execution), ("cycle", "forever")])
        }
        ["rw", "rapid", "tasks"] => Ok(tasks(c)),
        ["rw", "rapid", "modules"] if is_six => modules(c, request.query("task").unwrap_or_default()),
        ["rw", "rapid", "tasks", task, "modules"] if !is_six => modules(c, task),
        ["rw", "rapid", "symbol", "data", "RAPID", task, module, name] if is_six => {
            value(c, task, module, name)
        }
        ["rw", "rapid", "symbol", "RAPID", task, module, name, "data"] if !is_six => {
            value(c, task, module, name)
        }
        ["rw", "rapid", "symbol", "properties", "RAPID", task, module, name] if is_six => {
            properties(c, task, module, name)
        }
        ["rw", "rapid", "symbol", "RAPID", task, module, name, "properties"] if !is_six => {
            properties(c, task, module, name)
        }
        ["rw", "motionsystem"] => one(
            "ms-motionsystem",
            &[
                ("absacc-active", if c.has_absolute_accuracy { "ON" } else { "OFF" }),
                ("mechunit-name", UNIT),
                ("change-count", "1"),
            ],
        ),
        ["rw", "motionsystem", "mechunits", unit, "jointtarget"] => {
            known_unit(unit)?;
            jointtarget(c)
        }
        ["rw", "motionsystem", "mechunits", unit, "robtarget"] => {
            known_unit(unit)?;
            robtarget(c, solver, request)
        }
        ["fileservice"] => Ok(volumes(c)),
        ["rw", "devices", "SW_RESOURCES", path @ ..] => devices(c, path),
        ["rw", "retcode"] => one(
            "rw-retcode",
            &[("name", "CODE"), ("severity", "Error"), ("description", "a code of the double")],
        ),
        _ => Err(NOT_KNOWN),
    }
}

/// Name, RobotWare and identity of the system.
fn system(c: &Controller) -> Result<Vec<Entry>, Rejection> {
    let class = if c.personality == Personality::Rw6 { "sys-system-li" } else { "sys-system" };
    let fields = [
        ("name", "Double"),
        ("rwversion", c.personality.version()),
        ("sysid", &c.system_id),
        ("major", &c.personality.version()[..1]),
    ];
    one(class, &fields)
}

/// The task that moves the arm, and one in the background; RobotWare 8 lists a spy beside them.
fn tasks(c: &Controller) -> Vec<Entry> {
    let state = if c.execution == "running" { "started" } else { "stopped" };
    let task = |name: &str, moves: &str| {
        let fields = [
            ("name", name),
            ("type", "norm"),
            ("taskstate", "link"),
            ("excstate", state),
            ("active", "On"),
            ("motiontask", moves),
        ];
        entry("rap-task-li", name, &fields)
    };
    let mut tasks = vec![task(TASK, "TRUE"), task("T_BACK", "FALSE")];
    if c.personality == Personality::Rw8 {
        tasks.push(entry("rap-tasks-spy-li", "spy", &[("spy", "off")]));
    }
    tasks
}

/// The joints at which the arm stands, degrees.
fn jointtarget(c: &Controller) -> Result<Vec<Entry>, Rejection> {
    let joints = c.joints_deg.map(rapid::number);
    let names = ["rax_1", "rax_2", "rax_3", "rax_4", "rax_5", "rax_6"];
    let mut fields: Vec<(&'static str, &str)> =
        names.into_iter().zip(joints.iter().map(String::as_str)).collect();
    fields.push(("eax_a", "9E+09"));
    one("ms-jointtarget", &fields)
}

/// The flange's pose as the controller shows it, mm and a quaternion.
fn robtarget(c: &Controller, solver: &Solver, request: &Incoming) -> Result<Vec<Entry>, Rejection> {
    if !matches!(request.query("coordinate"), Some("Base" | "Wobj" | "Tool" | "Word")) {
        return Err((400, -1_073_445_879, "invalid argument"));
    }
    let ((p, q), _) = solver.forward(&c.joints_deg.map(rad_from_deg), NO_TOOL);
    let shown_m = p.iter().zip(solver.planted.display_shift_m).map(|(p, shift)| p + shift);
    let texts: Vec<String> = shown_m.map(mm_from_m).chain(q).map(rapid::number).collect();
    let names = ["x", "y", "z", "q1", "q2", "q3", "q4"];
    let fields: Vec<(&'static str, &str)> = names.into_iter().zip(texts.iter().map(String::as_str)).collect();
    one("ms-robtargets", &fields)
}

/// RobotWare 6 lists disks with their sizes, 7 and 8 volumes without.
fn volumes(c: &Controller) -> Vec<Entry> {
    if c.personality != Personality::Rw6 {
        return ["HOME", "BACKUP", "TEMP"].iter().map(|name| entry("fs-dir", name, &[])).collect();
    }
    let fields = [
        ("fs-device-type", "fixed"),
        ("fs-free-space", "873164800"),
        ("fs-total-space", "2068717568"),
        ("fs-enabled", "true"),
        ("fs-readonly", "false"),
    ];
    vec![entry("fs-device", "hd0a", &fields)]
}

/// The software resources; names below the first level are the double's own.
fn devices(c: &Controller, path: &[&str]) -> Result<Vec<Entry>, Rejection> {
    let branch = |title: &str, name: &str| entry("dev-id-li", title, &[("name", name)]);
    let number = |title: &str, name: &str, value: &str| {
        entry("dev-propint-li", title, &[("name", name), ("value", value), ("unit", "bytes")])
    };
    match path {
        [] => Ok(vec![branch("ROBAPI", "RobAPI"), branch("SYSTEM", "System"), branch("RAPID", "RAPID")]),
        ["RAPID"] if c.tells_memory => Ok(vec![branch("RAPID_MEMORY", "Memory")]),
        ["RAPID"] => Ok(Vec::new()),
        ["RAPID", "RAPID_MEMORY"] if c.tells_memory => Ok(vec![
            number("PROPERTY_TOTAL", "Total memory", "33554432"),
            number("PROPERTY_FREE", "Free memory", "30408704"),
        ]),
        _ => Err(NOT_KNOWN),
    }
}

pub(crate) fn known_unit(unit: &str) -> Result<(), Rejection> {
    if unit == UNIT { Ok(()) } else { Err((400, -1_073_436_668, "no such mechanical unit")) }
}

fn modules(c: &Controller, task: &str) -> Result<Vec<Entry>, Rejection> {
    match task {
        TASK => Ok(c
            .modules
            .iter()
            .map(|m| entry("rap-module-info-li", &m.name, &[("name", &m.name), ("type", m.kind)]))
            .collect()),
        "T_BACK" => Ok(Vec::new()),
        _ => Err((404, -1_073_445_879, "task does not exist")),
    }
}

/// No such data: RobotWare 6 says 400, the others 404.
fn no_symbol(c: &Controller) -> Rejection {
    match c.personality {
        Personality::Rw6 => (400, -1_073_414_146, "symbol not found"),
        _ => (404, -1_073_442_816, "symbol not found"),
    }
}

/// Data by task, module and name; with the element of an array that is meant, from 1.
pub(crate) fn found<'c>(
    c: &'c Controller,
    task: &str,
    module: &str,
    name: &str,
) -> Result<(&'c Data, Option<usize>), Rejection> {
    let (bare, element) = name
        .split_once('{')
        .map_or((name, None), |(bare, rest)| (bare, rest.trim_end_matches('}').parse().ok()));
    let data = (task == TASK).then(|| c.data(module, bare)).flatten().ok_or_else(|| no_symbol(c))?;
    Ok((data, element))
}

fn value(c: &Controller, task: &str, module: &str, name: &str) -> Result<Vec<Entry>, Rejection> {
    let (data, element) = found(c, task, module, name)?;
    let value = match element {
        None => data.value.clone(),
        Some(n) => rapid::elements(&data.value)
            .and_then(|all| all.get(n.checked_sub(1)?).cloned())
            .ok_or_else(|| no_symbol(c))?,
    };
    Ok(vec![entry("rap-data", &format!("RAPID/{task}/{module}/{name}"), &[("value", &value)])])
}

fn properties(c: &Controller, task: &str, module: &str, name: &str) -> Result<Vec<Entry>, Rejection> {
    let (data, _) = found(c, task, module, name)?;
    let class = match data.kind {
        "per" => "rap-symproppers",
        "var" => "rap-sympropvar",
        _ => "rap-sympropconstant",
    };
    let dims: Vec<String> = data.dims.iter().map(usize::to_string).collect();
    let (dims, count) = (dims.join(" "), data.dims.len().to_string());
    let flag = |is: bool| if is { "TRUE" } else { "FALSE" };
    let url = format!("RAPID/{task}/{module}/{}", data.name);
    Ok(vec![entry(
        class,
        &url,
        &[
            ("symburl", &url),
            ("symtyp", data.kind),
            ("dattyp", &data.data_type),
            ("ndim", &count),
            ("dim", &dims),
            ("local", flag(data.is_local)),
            ("rdonly", "FALSE"),
            ("taskpers", flag(data.is_task)),
        ],
    )])
}

/// What HOME is called: RobotWare 7 wants it without the sign.
pub(crate) fn is_home(personality: Personality, home: &str) -> bool {
    match personality {
        Personality::Rw6 | Personality::Rw8 => home == "$HOME",
        Personality::Rw7 => home == "HOME",
    }
}

fn files(c: &Controller, home: &str, name: &[&str], media: MediaType) -> Result<Reply, Rejection> {
    if !is_home(c.personality, home) {
        return Err((400, -1_073_438_716, "virtual root does not exist"));
    }
    match name {
        [] => {
            let size = |bytes: &Vec<u8>| bytes.len().to_string();
            let list: Vec<Entry> = c
                .files
                .iter()
                .map(|(name, b)| entry("fs-file", name, &[("fs-size", &size(b)), ("fs-readonly", "false")]))
                .collect();
            Ok(page::page(media, &list, page::OK, None))
        }
        [name] => {
            let missing = if c.personality == Personality::Rw6 { -1_073_414_146 } else { -1_073_438_713 };
            let bytes = c.files.get(*name).ok_or((404, missing, "path does not exist"))?;
            Ok(Reply { body: bytes.clone(), ..Reply::new(200) }
                .with("Content-Type", "application/octet-stream"))
        }
        _ => Err((404, -1_073_438_713, "path does not exist")),
    }
}
