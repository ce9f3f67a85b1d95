//! The command line, run within Python.

use crate::errors::refused;
use driftpost::LocatedDiagnostic;
use driftpost::command_line::{self, Outcome};
use pyo3::prelude::*;
use std::ffi::OsString;

/// Runs a command; gives its exit code, standard output and standard error. A refusal is an exception, but for one with the code
/// `accepted`.
#[pyfunction]
#[pyo3(signature = (words, accepted=None))]
pub(crate) fn command(
    py: Python<'_>,
    words: Vec<OsString>,
    accepted: Option<&str>,
) -> PyResult<(u8, String, String)> {
    let words: Vec<OsString> = [OsString::from("driftpost")].into_iter().chain(words).collect();
    // Nothing of a run is shared with another thread until it has ended.
    let (code, output, messages, errors) = py.detach(|| {
        let captured = command_line::run_captured(&words);
        (code_of(captured.outcome), captured.output, captured.messages, captured.errors)
    });
    let is_accepted = |message: &LocatedDiagnostic| Some(message.diagnostic.code) == accepted;
    if code == 2 && !errors.iter().all(is_accepted) {
        return Err(refused(py, &errors));
    }
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    Ok((code, text(&output), text(&messages)))
}

/// The `driftpost` program.
#[pyfunction]
pub(crate) fn main(py: Python<'_>, words: Vec<OsString>) -> u8 {
    py.detach(|| code_of(command_line::run_with(words)))
}

fn code_of(outcome: Outcome) -> u8 {
    match outcome {
        Outcome::Done => 0,
        Outcome::Difference => 1,
        Outcome::Refused => 2,
    }
}
