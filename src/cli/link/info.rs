//! `driftpost link info`: what a controller is and how it stands.

use super::connection::Connection;
use crate::cli::files::Output;
use crate::cli::{Console, Outcome};
use driftpost::application::OwnData;
use robot_link::{FreeMemory, Identity, LoadedModule};
use std::io::{self, Write};
use std::path::PathBuf;

/// Options of `link info`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The host, who logs in, and how its certificate is pinned.
    #[command(flatten)]
    connection: Connection,

    /// The same as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    json: Option<PathBuf>,
}

/// All that is shown.
struct Shown {
    identity: Identity,
    /// The loaded modules, by task.
    modules: Vec<(String, Vec<LoadedModule>)>,
    own: Vec<OwnData>,
    left: FreeMemory,
}

/// Runs `link info`.
///
/// # Errors
/// `link::*`.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let json = Output::new(args.json.as_deref())?;
    let mut session = args.connection.open(console)?;
    let identity = session.identity()?;
    let mut modules = Vec::new();
    let mut own = Vec::new();
    for task in &identity.tasks {
        let loaded = session.modules(&task.name)?;
        own.extend(OwnData::of_task(&mut session, &task.name, &loaded)?);
        modules.push((task.name.clone(), loaded));
    }
    let left = session.free_memory()?;
    session.end()?;
    let shown = Shown { identity, modules, own, left };
    if !json.is_standard() {
        shown.write(console.out())?;
    }
    json.write(console, || Ok(format!("{:#}\n", shown.json()).into_bytes()))?;
    Ok(Outcome::Done)
}

impl Shown {
    fn write(&self, out: &mut dyn Write) -> io::Result<()> {
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

    fn json(&self) -> serde_json::Value {
        let i = &self.identity;
        let tasks = i.tasks.iter().zip(&self.modules).map(|(task, (_, modules))| {
            let modules: Vec<_> = modules.iter().map(|m| serde_json::json!({"name": m.name, "type": m.kind})).collect();
            serde_json::json!({"name": task.name, "moves": task.moves, "active": task.is_active, "state": task.state, "modules": modules})
        });
        serde_json::json!({
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
                    .map(|p| serde_json::json!({"name": p.name, "value": p.value, "unit": p.unit})).collect::<Vec<_>>(),
                "disks": self.left.disks.iter()
                    .map(|d| serde_json::json!({"name": d.name, "free_bytes": d.free_bytes, "total_bytes": d.total_bytes}))
                    .collect::<Vec<_>>(),
            },
            "tasks": tasks.collect::<Vec<_>>(),
            "corrected": self.own.iter().map(OwnData::json).collect::<Vec<_>>(),
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
