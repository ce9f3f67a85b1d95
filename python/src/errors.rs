//! The library's messages as `driftpost.DriftpostError`.

use driftpost::LocatedDiagnostic;
use driftpost::{Diagnostic, Severity};
use pyo3::prelude::*;

/// One message: code, severity, text, help, file, line.
pub(crate) type Message = (String, &'static str, String, Option<String>, Option<String>, Option<u32>);

/// A message with its place.
pub(crate) fn message(located: &LocatedDiagnostic) -> Message {
    let Diagnostic { code, severity, message, help, .. } = &located.diagnostic;
    let severity = match severity {
        Severity::Note => "note",
        Severity::Warning => "warning",
        Severity::Error => "error",
    };
    let (file, line) = located.place().map(|(file, line)| (file.to_owned(), line)).unzip();
    ((*code).to_owned(), severity, message.clone(), help.clone(), file, line)
}

/// The exception for messages, of which the first error is the one that is told.
pub(crate) fn refused(py: Python<'_>, messages: &[LocatedDiagnostic]) -> PyErr {
    let all: Vec<Message> = messages.iter().map(message).collect();
    let made = || py.import("driftpost._errors")?.getattr("DriftpostError")?.call_method1("_of", (all,));
    made().map_or_else(|error| error, PyErr::from_value)
}

/// The exception for one message.
pub(crate) fn one(py: Python<'_>, diagnostic: Diagnostic) -> PyErr {
    refused(py, &[LocatedDiagnostic::new(diagnostic, &[])])
}
