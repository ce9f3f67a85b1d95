//! A request of the table with its arguments in place.

use crate::names::encoded;
use crate::requests::{self, Request};
use crate::{Dialect, LinkError};
use ureq::http;

/// What goes with a request beside what its form says.
#[derive(Clone, Copy, Default)]
pub(crate) struct Filling<'a> {
    pub arguments: &'a [(&'static str, &'a str)],
    /// Which page of a list, as the end of the query.
    pub page: Option<&'a str>,
    pub file: Option<&'a [u8]>,
}

/// A request as it is sent.
pub(crate) struct Filled {
    pub method: http::Method,
    /// Path and query, with every name escaped.
    pub uri: String,
    pub form: String,
}

impl Filled {
    pub(crate) fn new(
        dialect: Dialect,
        request: &'static Request,
        filling: Filling<'_>,
    ) -> Result<Self, LinkError> {
        let arguments = filling.arguments;
        let not_offered = || LinkError::NotOffered { dialect: dialect.to_string(), request: request.name };
        let form = request.form(dialect).ok_or_else(not_offered)?;
        let mut words = form.splitn(3, ' ');
        let method = words.next().and_then(|m| m.parse().ok()).ok_or_else(not_offered)?;
        let mut uri = fill(words.next().unwrap_or_default(), arguments, false);
        let is_json = dialect == Dialect::Rw6 && method == http::Method::GET;
        let has_text =
            ![requests::FILE.name, requests::LOGOUT.name, requests::EVENTS.name].contains(&request.name);
        for more in filling.page.into_iter().chain((is_json && has_text).then_some("json=1")) {
            uri.push(if uri.contains('?') { '&' } else { '?' });
            uri.push_str(more);
        }
        Ok(Self { method, uri, form: fill(words.next().unwrap_or_default(), arguments, true) })
    }
}

/// A form with its arguments in place. `$HOME` stays as it is in a path, and a list of resources comes encoded.
fn fill(template: &str, arguments: &[(&'static str, &str)], is_form: bool) -> String {
    let mut out = template.to_owned();
    for (name, value) in arguments {
        let is_raw = *name == "resources" || (*name == "home" && !is_form);
        let value = if is_raw { (*value).to_owned() } else { encoded(value) };
        out = out.replace(&format!("{{{name}}}"), &value);
    }
    out
}
