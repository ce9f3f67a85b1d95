//! What a controller is and how it stands: system, tasks, modules, memory, and the data of corrected programs.

use super::emitted_state::EmittedState;
use robot_link::{FreeMemory, Identity, LinkError, LoadedModule, Session};
use serde_json::{Value, json};
use std::io::{self, Write};

/// A controller as it answers.
pub struct LinkInfo {
    identity: Identity,
    /// The loaded modules, by task.
    modules: Vec<(String, Vec<LoadedModule>)>,
    own: Vec<EmittedState>,
    left: FreeMemory,
}

impl LinkInfo {
    /// Asks a controller.
    ///
    /// # Errors
    /// No or an incomplete answer.
    pub fn of(session: &mut Session) -> Result<Self, LinkError> {
        let identity = session.identity()?;
        let (mut modules, mut own) = (Vec::new(), Vec::new());
        for task in &identity.tasks {
            let loaded = session.modules(&task.name)?;
            own.extend(EmittedState::of_task(session, &task.name, &loaded)?);
            modules.push((task.name.clone(), loaded));
        }
        let left = session.free_memory()?;
        Ok(Self { identity, modules, own, left })
    }

    /// What was found, for people.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let i = &self.identity;
        let kind = if i.is_virtual { ", virtual" } else { "" };
        writeln!(out, "controller  {}{kind}", i.controller.as_deref().unwrap_or("(no name)"))?;
        writeln!(out, "system      {}, RobotWare {} ({})", i.system, i.version, i.dialect)?;
        writeln!(out, "robot       {}", i.robot.as_deref().unwrap_or("(unknown)"))?;
        writeln!(out, "mode        {}, motors {}, RAPID {}", i.mode, i.motors, i.execution)?;
        let accuracy = match i.absolute_accuracy {
            Some(true) => "ON: corrected targets are made for nominal kinematics and need it off",
            Some(false) => "off",
            None => "(unknown)",
        };
        writeln!(out, "Absolute Accuracy {accuracy}")?;
        writeln!(out, "right to write    {}", i.writer.as_deref().unwrap_or("nobody holds it"))?;
        let rapid = self.left.rapid.iter().map(|p| format!("{} {} {}", p.name, p.value, p.unit));
        writeln!(out, "memory of RAPID   {}", or_not_offered(rapid))?;
        let disks = self.left.disks.iter().map(|disk| {
            let of = disk.total_bytes.map_or_else(String::new, |total| format!(" of {}", megabytes(total)));
            format!("{}: {}{of}", disk.name, megabytes(disk.free_bytes))
        });
        writeln!(out, "free on disk      {}", or_not_offered(disks))?;
        writeln!(out, "options     {}", i.options.join(", "))?;
        for (task, (_, modules)) in i.tasks.iter().zip(&self.modules) {
            let moves = if task.moves { ", moves an arm" } else { "" };
            let active = if task.is_active { "" } else { ", switched off" };
            let names: Vec<&str> = modules.iter().map(|m| m.name.as_str()).collect();
            let names = if names.is_empty() { "no module".to_owned() } else { names.join(", ") };
            writeln!(out, "task {} ({}{moves}{active}): {names}", task.name, task.state)?;
        }
        for own in &self.own {
            writeln!(out, "corrected {}/{}: {}", own.task, own.module, own.line())?;
        }
        if self.own.is_empty() {
            writeln!(out, "no corrected program is loaded")?;
        }
        Ok(())
    }

    /// The same for programs.
    #[must_use]
    pub fn json(&self) -> Value {
        let i = &self.identity;
        let tasks = i.tasks.iter().zip(&self.modules).map(|(task, (_, modules))| {
            let modules: Vec<_> = modules.iter().map(|m| json!({"name": m.name, "type": m.kind})).collect();
            json!({"name": task.name, "moves": task.moves, "active": task.is_active, "state": task.state, "modules": modules})
        });
        json!({
            "dialect": i.dialect.to_string(),
            "robotware": i.version,
            "system": i.system,
            "controller": i.controller,
            "virtual": i.is_virtual,
            "robot": i.robot,
            "options": i.options,
            "mode": i.mode.to_string(),
            "motors": i.motors,
            "execution": i.execution.to_string(),
            "absolute_accuracy": i.absolute_accuracy,
            "writer": i.writer,
            "free_memory": {
                "rapid": self.left.rapid.iter()
                    .map(|p| json!({"name": p.name, "value": p.value, "unit": p.unit})).collect::<Vec<_>>(),
                "disks": self.left.disks.iter()
                    .map(|d| json!({"name": d.name, "free_bytes": d.free_bytes, "total_bytes": d.total_bytes}))
                    .collect::<Vec<_>>(),
            },
            "tasks": tasks.collect::<Vec<_>>(),
            "corrected": self.own.iter().map(EmittedState::json).collect::<Vec<_>>(),
        })
    }
}

/// The parts in a row.
fn or_not_offered(parts: impl Iterator<Item = String>) -> String {
    let parts: Vec<String> = parts.map(|part| part.trim_end().to_owned()).collect();
    if parts.is_empty() { "not offered by this controller".to_owned() } else { parts.join(", ") }
}

/// Bytes as a disk is sold: millions of them, with one decimal.
fn megabytes(bytes: u64) -> String {
    format!("{:.1} MB", bytes as f64 / 1e6)
}
