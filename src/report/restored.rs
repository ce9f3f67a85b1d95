//! What was restored, as JSON.

use rapid_compensation::emit::Restored;
use serde_json::{Value, json};

/// The result as the contract's JSON: of each original the emitted file, where it goes, and what was changed since.
pub fn json<'r>(files: impl Iterator<Item = (&'r str, &'r str, &'r Restored)>) -> Value {
    let one = |(file, output, restored): (&str, &str, &Restored)| {
        let touched: Vec<Value> = restored
            .touched
            .iter()
            .map(|t| {
                json!({"line": t.line, "target": t.target, "value": t.value, "moved": t.moved, "unit": t.unit})
            })
            .collect();
        let altered: Vec<Value> = restored
            .altered
            .iter()
            .map(|a| json!({"code": a.code(), "line": a.line(), "message": a.to_string()}))
            .collect();
        json!({"file": file, "output": output, "exact": restored.exact, "touched": touched, "altered": altered})
    };
    json!({ "files": files.map(one).collect::<Vec<_>>() })
}
