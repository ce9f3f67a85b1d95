//! `driftpost link get` and `set`: the data of corrected programs, and of nothing else.

use super::connection::Connection;
use crate::application::{LinkDatum, is_emitted_name};
use crate::cli::files::Output;
use crate::cli::{Console, Outcome};
use rapid_syntax::diagnostic::Diagnostic;
use robot_link::Session;
use std::path::PathBuf;

/// Options of `link get`.
#[derive(Debug, clap::Args)]
pub struct GetArgs {
    /// The host, who logs in, and how its certificate is pinned.
    #[command(flatten)]
    connection: Connection,

    /// Data of corrected programs, `tcMode`, `tcMinute`, `tcState{2}`.
    #[arg(required = true, value_name = "NAME")]
    names: Vec<String>,

    /// The same as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    json: Option<PathBuf>,
}

/// Options of `link set`.
#[derive(Debug, clap::Args)]
pub struct SetArgs {
    /// The host, who logs in, and how its certificate is pinned.
    #[command(flatten)]
    connection: Connection,

    /// Persistent data of a corrected program, `tcMode`.
    #[arg(value_name = "NAME")]
    name: String,

    /// As RAPID writes it: -1, TRUE, "text".
    #[arg(value_name = "VALUE", allow_hyphen_values = true)]
    value: String,

    /// The module, where several have data of this name.
    #[arg(long, value_name = "MODULE")]
    module: Option<String>,

    /// What was set and what it was before, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    json: Option<PathBuf>,
}

/// Where on the controller data are.
struct Place {
    task: String,
    module: String,
}

/// Runs `link get`.
///
/// # Errors
/// `link::*`.
pub fn get(args: &GetArgs, console: &mut Console) -> anyhow::Result<Outcome> {
    args.names.iter().try_for_each(|name| check(name))?;
    let json = Output::new(args.json.as_deref())?;
    let takes_standard_output = json.is_standard();
    let mut session = args.connection.open(console)?;
    let mut found = Vec::new();
    for name in &args.names {
        for Place { task, module } in places(&mut session, name)? {
            let value = session.value(&task, &module, name)?;
            if !takes_standard_output {
                writeln!(console.out(), "{task}/{module} {name} {value}")?;
            }
            found.push(LinkDatum { task, module, name: name.clone(), value, before: None });
        }
    }
    session.end()?;
    json.write_json(console, &LinkDatum::all_json(&found))?;
    Ok(Outcome::Done)
}

/// Runs `link set`.
///
/// # Errors
/// `link::*`.
pub fn set(args: &SetArgs, console: &mut Console) -> anyhow::Result<Outcome> {
    check(&args.name)?;
    let json = Output::new(args.json.as_deref())?;
    let takes_standard_output = json.is_standard();
    let mut session = args.connection.open(console)?;
    let mut found = places(&mut session, &args.name)?;
    if let Some(module) = &args.module {
        found.retain(|place| place.module.eq_ignore_ascii_case(module));
    }
    let [place] = found.as_slice() else {
        let all: Vec<String> = found.iter().map(|p| format!("{}/{}", p.task, p.module)).collect();
        let text = format!(
            "{} stands in {}",
            args.name,
            if all.is_empty() { "no such module".into() } else { all.join(", ") }
        );
        return Err(Diagnostic::error("link::which-module", text).help("name one with --module").into());
    };
    let before = session.value(&place.task, &place.module, &args.name)?;
    let mut on_notice = |text: &str| console.note(text);
    session.with_right(&mut on_notice, |session| {
        session.set_value(&place.task, &place.module, &args.name, &args.value)
    })?;
    session.end()?;
    let Place { task, module } = place;
    if !takes_standard_output {
        writeln!(console.out(), "{task}/{module} {} {} (was {before}; read back)", args.name, args.value)?;
    }
    let set = LinkDatum {
        task: task.clone(),
        module: module.clone(),
        name: args.name.clone(),
        value: args.value.clone(),
        before: Some(before),
    }
    .json();
    json.write_json(console, &set)?;
    Ok(Outcome::Done)
}

fn check(name: &str) -> Result<(), Diagnostic> {
    if is_emitted_name(name) {
        return Ok(());
    }
    let text = format!("{name} is none of the data of a corrected program");
    Err(Diagnostic::error("link::not-ours", text)
        .help("they are called tcMode, tcMinute and so on; see the head of the module"))
}

/// Where data of a name are, in all tasks.
fn places(session: &mut Session, name: &str) -> anyhow::Result<Vec<Place>> {
    let mut found = Vec::new();
    for task in session.tasks()? {
        for module in session.modules(&task.name)? {
            if session.property(&task.name, &module.name, name)?.is_some() {
                found.push(Place { task: task.name.clone(), module: module.name });
            }
        }
    }
    if found.is_empty() {
        let text = format!("no module that is loaded has data called {name}");
        return Err(Diagnostic::error("link::no-data", text)
            .help("`link info` lists what corrected programs have")
            .into());
    }
    Ok(found)
}
