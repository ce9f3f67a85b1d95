//! Data of corrected programs on a controller, as scripts read them.

use serde_json::{Value, json};

/// A datum of a corrected program where it stands on the controller.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LinkDatum {
    /// The task that has it loaded.
    pub task: String,
    /// The module that declares it.
    pub module: String,
    /// Its name, with indices.
    pub name: String,
    /// Its value as RAPID writes it.
    pub value: String,
    /// The value that it had, where another was set.
    pub before: Option<String>,
}

impl LinkDatum {
    /// The same for programs.
    #[must_use]
    pub fn json(&self) -> Value {
        let Self { task, module, name, value, before } = self;
        match before {
            Some(before) => {
                json!({ "task": task, "module": module, "name": name, "value": value, "before": before })
            }
            None => json!({ "task": task, "module": module, "name": name, "value": value }),
        }
    }

    /// All that was asked for, in its order.
    #[must_use]
    pub fn all_json(data: &[Self]) -> Value {
        json!({ "data": data.iter().map(Self::json).collect::<Vec<Value>>() })
    }
}
