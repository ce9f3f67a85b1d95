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
        let command_of = |result: &Value| {
            let has = |key: &&str| result.get(*key).is_some();
            KEYS.iter().find(|(_, keys)| keys.iter().all(has)).map(|(command, _)| *command)
        };
        let whole = command_of(&data);
        // Of several tasks each is a result; a controller's are a list in one.
        let tasks = data.get("tasks").and_then(Value::as_array).filter(|_| whole.is_none());
        let first = tasks.and_then(|tasks| tasks.first());
        let command = whole.or_else(|| first.and_then(command_of)).ok_or_else(|| {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_of_tasks_makes_pages_of_tasks_only_where_each_is_a_result() {
        let of = |text: &str| Page::from_json(text.as_bytes(), "x.json", String::new()).unwrap();
        let info =
            of(r#"{"robotware":"7","controller":"c","execution":"stopped","tasks":[{"name":"T_ROB1"}]}"#);
        assert_eq!((info.command, info.view.get("tasks")), ("link info", None));
        let both = of(r#"{"tasks":[{"motions":[],"buckets":[],"worst_before_mm":1}]}"#);
        assert_eq!((both.command, both.view["tasks"].as_array().map(Vec::len)), ("compensate", Some(1)));
    }
}
