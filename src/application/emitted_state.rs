//! The data of a corrected program on a controller: what its header calls `tcMode`, `tcMinute` and so on.

use robot_link::{DataKind, LinkError, LoadedModule, Session};

/// What every corrected program has, and an operator sets.
const MODE: &str = "tcMode";

/// What is shown, as far as a program has it.
const SHOWN: [&str; 7] = [MODE, "tcBucket", "tcShare", "tcMinute", "tcDegrees", "tcTouchSigma", "tcTouchAge"];

/// What it last said to the operator.
const LAST_MESSAGE: &str = "tcSaid";

/// The data of one corrected module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EmittedState {
    /// Name of the task.
    pub task: String,
    /// The module that holds them: the corrected one, or `tcCore`.
    pub module: String,
    /// Name and value, as RAPID writes it.
    pub values: Vec<(String, String)>,
    /// The message that was shown last.
    pub last_message: Option<String>,
}

impl EmittedState {
    /// Those of all modules of a task.
    ///
    /// # Errors
    /// No or an incomplete answer.
    pub fn of_task(
        session: &mut Session,
        task: &str,
        modules: &[LoadedModule],
    ) -> Result<Vec<Self>, LinkError> {
        let mut found = Vec::new();
        for module in modules {
            found.extend(Self::of_module(session, task, &module.name)?);
        }
        Ok(found)
    }

    /// Those of one module; `None` where it is none of ours.
    ///
    /// # Errors
    /// No or an incomplete answer.
    pub fn of_module(session: &mut Session, task: &str, module: &str) -> Result<Option<Self>, LinkError> {
        let is_own = session
            .property(task, module, MODE)?
            .is_some_and(|p| p.kind == DataKind::Persistent && p.data_type == "num");
        if !is_own {
            return Ok(None);
        }
        let mut own =
            Self { task: task.to_owned(), module: module.to_owned(), values: Vec::new(), last_message: None };
        for name in SHOWN {
            if session.property(task, module, name)?.is_some() {
                own.values.push((name.to_owned(), session.value(task, module, name)?));
            }
        }
        if session.property(task, module, LAST_MESSAGE)?.is_some() {
            let last_message = session.value(task, module, LAST_MESSAGE)?;
            own.last_message = Some(last_message.trim_matches('"').to_owned())
                .filter(|last_message| !last_message.is_empty());
        }
        Ok(Some(own))
    }

    /// The values anew.
    ///
    /// # Errors
    /// No or an incomplete answer.
    #[cfg(feature = "cli")]
    pub fn read_again(&mut self, session: &mut Session) -> Result<(), LinkError> {
        for (name, value) in &mut self.values {
            *value = session.value(&self.task, &self.module, name)?;
        }
        if let Some(last_message) = &mut self.last_message {
            session.value(&self.task, &self.module, LAST_MESSAGE)?.trim_matches('"').clone_into(last_message);
        }
        Ok(())
    }

    /// `tcMode -1, tcBucket 3, tcMinute 24.5`, and what was said.
    #[must_use]
    pub fn line(&self) -> String {
        let values: Vec<String> = self.values.iter().map(|(name, value)| format!("{name} {value}")).collect();
        let last_message = self.last_message.as_ref().filter(|last_message| !last_message.is_empty());
        last_message.map_or_else(
            || values.join(", "),
            |last_message| format!("{}; it said: {last_message}", values.join(", ")),
        )
    }

    /// One object: task, module, what was said, and each datum under its name, a number where it is one.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        let number = |value: &String| {
            value.parse::<f64>().map_or_else(|_| value.clone().into(), serde_json::Value::from)
        };
        let values: serde_json::Map<_, _> = self.values.iter().map(|(n, v)| (n.clone(), number(v))).collect();
        serde_json::json!({"task": self.task, "module": self.module, "said": self.last_message, "values": values})
    }
}

/// Whether a name is one of ours: `tc`, then a capital letter, as in `tcMode` or `tcState{2}`.
#[must_use]
pub fn is_emitted_name(name: &str) -> bool {
    name.strip_prefix("tc").is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_uppercase()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_shows_values_and_what_was_said() {
        let own = EmittedState {
            task: "T_ROB1".into(),
            module: "Part".into(),
            values: vec![("tcMode".into(), "-1".into()), ("tcMinute".into(), "64.7".into())],
            last_message: Some("originals".into()),
        };
        assert_eq!(own.line(), "tcMode -1, tcMinute 64.7; it said: originals");
        assert_eq!(own.json()["values"]["tcMinute"], 64.7);
        assert!(is_emitted_name("tcMode") && is_emitted_name("tcState{2}"));
        assert!(!is_emitted_name("tc30") && !is_emitted_name("tcp") && !is_emitted_name("doGrip"));
    }
}
