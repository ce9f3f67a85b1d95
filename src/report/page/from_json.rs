//! The page of a result that a command wrote as JSON.

use super::Page;
use rapid_syntax::diagnostic::Diagnostic;
use serde_json::{Value, json};

/// What tells the JSON of a command, in the order in which they are asked for.
const KEYS: [(&str, &[&str]); 20] = [
    ("compensate", &["motions", "buckets", "worst_before_mm"]),
    ("diagnose", &["verdict", "causes", "shrink"]),
    ("simulate", &["minutes", "worst", "switches"]),
    ("compare-measurements", &["changed", "pairs", "tools"]),
    ("closed-loop", &["withheld", "verdict", "before", "after"]),
    ("fit", &["touches", "growth", "parameters"]),
    ("accuracy", &["poses", "within", "worst"]),
    // These have no pictures: their figures and lists alone.
    ("validate", &["joints_outside", "nominal", "rms_mm"]),
    ("plan", &["confounded", "exchanges", "lines"]),
    ("state", &["amount", "tau_min", "touches"]),
    ("diff", &["same", "same_elsewhere", "motions"]),
    ("inspect", &["entries", "form", "motions"]),
    ("tabulate", &["minutes", "rows", "targets"]),
    ("golden", &["cases", "updated"]),
    ("exam", &["measures", "sets"]),
    ("synth", &["out_dir", "seed", "sets"]),
    ("link info", &["robotware", "controller", "execution"]),
    ("link check", &["verdict", "display_mm"]),
    ("link check", &["verdict", "why"]),
    ("restore", &["files"]),
];

const HELP: &str = "give what a command wrote with --json";

impl Page<Value, Value> {
    /// The page of the bytes that a command wrote with `--json`; `place` is where they come from, `title` the page's.
    ///
    /// # Errors
    /// `report::not-json` where the bytes are no JSON, `report::unknown` where it is no result of a command.
    pub fn from_json(bytes: &[u8], place: &str, title: String) -> Result<Self, Diagnostic> {
        let data: Value = serde_json::from_slice(bytes).map_err(|cause| {
            Diagnostic::error("report::not-json", format!("{place} is no JSON: {cause}")).help(HELP)
        })?;
        // Of several tasks each is a result.
        let tasks = data.get("tasks").and_then(Value::as_array);
        let first = tasks.and_then(|tasks| tasks.first()).unwrap_or(&data);
        let has = |key: &&str| first.get(*key).is_some();
        let command = KEYS.iter().find(|(_, keys)| keys.iter().all(has)).map(|(command, _)| *command);
        let command = command.ok_or_else(|| {
            Diagnostic::error("report::unknown", format!("{place} is no result of ours")).help(HELP)
        })?;
        let from_json = json!({ "from_json": true });
        let view = match tasks {
            Some(tasks) => json!({ "tasks": vec![&from_json; tasks.len()] }),
            None => from_json,
        };
        Ok(Self { command, title, data, view })
    }
}
