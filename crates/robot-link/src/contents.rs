//! What an answer says, whatever it is written in.

use crate::abb::{Refusal, tidy};
use serde_json::Value;
use std::collections::BTreeMap;

/// One entry of an answer.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct ResourceState {
    pub class: String,
    pub title: String,
    pub fields: BTreeMap<String, String>,
}

/// What an answer says, whatever it is written in.
#[derive(Clone, Debug, Default)]
pub(crate) struct Contents {
    pub states: Vec<ResourceState>,
    /// ABB's number, where the answer holds one.
    pub code: Option<i64>,
    pub message: String,
    /// The next page of a list.
    pub next: Option<String>,
    /// It says that it failed, whatever the status.
    pub is_error: bool,
}

impl Contents {
    /// Takes what a JSON value says.
    pub(crate) fn read(&mut self, value: &Value, depth: usize) {
        match value {
            Value::Array(items) if depth < 12 => items.iter().for_each(|item| self.read(item, depth + 1)),
            Value::Object(map) if depth < 12 => {
                if let Some(class) = map.get("_type").and_then(Value::as_str) {
                    let text = |v: &Value| match v {
                        Value::String(text) => Some(text.clone()),
                        Value::Number(_) | Value::Bool(_) => Some(v.to_string()),
                        _ => None,
                    };
                    let fields = map.iter().filter_map(|(k, v)| Some((k.clone(), text(v)?))).collect();
                    let title = map.get("_title").and_then(Value::as_str).unwrap_or_default().to_owned();
                    self.states.push(ResourceState { class: class.to_owned(), title, fields });
                }
                if let Some(status) = map.get("status").filter(|s| s.is_object()) {
                    self.code = status.get("code").and_then(Value::as_i64);
                    self.message = status.get("msg").and_then(Value::as_str).unwrap_or_default().to_owned();
                }
                if let Some(links) = map.get("_links") {
                    let href = |name: &str| links.get(name)?.get("href")?.as_str();
                    self.next = href("next").map(|next| next.replace("&amp;", "&")).or(self.next.take());
                    if let Some(code) = href("error").and_then(|h| h.rsplit_once("code=")) {
                        (self.is_error, self.code) = (true, code.1.parse().ok());
                    }
                }
                for (name, inner) in map {
                    if !["_links", "status"].contains(&name.as_str()) {
                        self.read(inner, depth + 1);
                    }
                }
            }
            _ => {}
        }
    }

    /// The refusal that it is, if it is one.
    pub(crate) fn refusal(&self, status: u16) -> Option<Refusal> {
        let says_no = self.is_error || self.code.is_some_and(|code| code < 0);
        if (200..300).contains(&status) && !says_no {
            return None;
        }
        let (message, inner) = tidy(&self.message);
        Some(Refusal { status, number: self.code, inner, message })
    }
}
