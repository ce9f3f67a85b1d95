//! `driftpost report`: a page of a result's JSON.

use super::{Console, Outcome, files};
use driftpost::report::{Page, write_page};
use rapid_syntax::diagnostic::Diagnostic;
use serde_json::{Value, json};
use std::io::{BufWriter, Write};
use std::path::PathBuf;

/// What tells the JSON of a command, in the order in which they are asked for.
const KEYS: [(&str, &[&str]); 7] = [
    ("compensate", &["motions", "buckets", "worst_before_mm"]),
    ("diagnose", &["verdict", "causes", "shrink"]),
    ("simulate", &["minutes", "worst", "switches"]),
    ("compare-measurements", &["changed", "pairs", "tools"]),
    ("closed-loop", &["withheld", "verdict", "before", "after"]),
    ("fit", &["touches", "growth", "parameters"]),
    ("accuracy", &["poses", "within", "worst"]),
];

/// Command line of `driftpost report`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// What a command wrote with --json; - is standard input.
    #[arg(value_name = "JSON")]
    pub result: PathBuf,

    /// The page [default: the result's name with .html].
    #[arg(short, long, value_name = "FILE.html")]
    pub output: Option<PathBuf>,
}

/// Runs `report`.
///
/// # Errors
/// A file that cannot be read or written, or that is no result of ours.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let path = args.output.clone().unwrap_or_else(|| match files::is_standard(&args.result) {
        true => PathBuf::from("report.html"),
        false => args.result.with_extension("html"),
    });
    files::keep_apart(&[&args.result], &[&path])?;
    let mut page = files::Pending::new(&path)?;
    let bytes = files::read(&args.result, "result")?;
    let data: Value = serde_json::from_slice(&bytes).map_err(|cause| {
        Diagnostic::error("report::not-json", format!("{} is no JSON: {cause}", args.result.display()))
            .help("give what a command wrote with --json")
    })?;
    // of several tasks each is a result
    let tasks = data.get("tasks").and_then(Value::as_array);
    let first = tasks.and_then(|tasks| tasks.first()).unwrap_or(&data);
    let has = |key: &&str| first.get(*key).is_some();
    let command = KEYS.iter().find(|(_, keys)| keys.iter().all(has)).map(|(command, _)| *command);
    let command = command.ok_or_else(|| {
        Diagnostic::error("report::unknown", format!("{} is no result of ours", args.result.display()))
            .help("give what a command wrote with --json")
    })?;
    let title = args.result.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let from_json = json!({ "from_json": true });
    let view =
        tasks.map_or_else(|| from_json.clone(), |tasks| json!({ "tasks": vec![&from_json; tasks.len()] }));
    let mut out = BufWriter::with_capacity(1 << 16, page.out());
    write_page(&mut out, &Page { command, title, data, view })?;
    out.flush()?;
    drop(out);
    page.place()?;
    console.say(format_args!("wrote {}", path.display()));
    Ok(Outcome::Done)
}
