//! Compensation of programs that are given as texts or by their paths.

use crate::errors::{Message, message, refused};
use driftpost::ProgramFiles;
use driftpost::command_line;
use driftpost::{Diagnostic, LocatedDiagnostic};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::path::PathBuf;

/// What a compensation gives: files (path, bytes), diff, JSON, review, messages.
type Made<'py> = (Vec<(String, Bound<'py, PyBytes>)>, Bound<'py, PyBytes>, String, String, Vec<Message>);

/// Path and bytes of each file.
type Files = Vec<(String, Vec<u8>)>;

/// A program as it is given.
#[derive(FromPyObject)]
pub(crate) enum Program {
    /// Path and bytes of each module.
    Texts(Files),
    /// Modules, a folder or a `.pgf`.
    Paths(Vec<PathBuf>),
}

/// What is made without the interpreter's lock.
struct Plain {
    files: Files,
    diff: Vec<u8>,
    json: String,
    review: String,
    messages: Vec<Message>,
}

/// Compensates modules, given by their paths as on the command line or as texts; `options` are those of the command line. `progress` is called with files done and files in all.
#[pyfunction]
pub(crate) fn compensate<'py>(
    py: Python<'py>,
    program: Program,
    options: Vec<String>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Made<'py>> {
    let mut stopped = None;
    let made = py.detach(|| run(program, &options, progress.as_ref(), &mut stopped));
    if let Some(error) = stopped {
        return Err(error);
    }
    let made = made.map_err(|messages| refused(py, &messages))?;
    let files = made.files.iter().map(|(path, bytes)| (path.clone(), PyBytes::new(py, bytes))).collect();
    Ok((files, PyBytes::new(py, &made.diff), made.json, made.review, made.messages))
}

fn run(
    program: Program,
    options: &[String],
    progress: Option<&Py<PyAny>>,
    stopped: &mut Option<PyErr>,
) -> Result<Plain, Vec<LocatedDiagnostic>> {
    let alone = |diagnostic: Diagnostic| vec![LocatedDiagnostic::new(diagnostic, &[])];
    let job = command_line::compensation(options).map_err(alone)?;
    let program = match program {
        Program::Texts(files) => ProgramFiles::new(files),
        Program::Paths(paths) => command_line::program(&paths).map_err(alone)?,
    };
    let made = job
        .run_with_progress(&program, &mut |done, all| {
            let Some(progress) = progress else { return Ok(()) };
            Python::attach(|py| progress.call1(py, (done, all))).map(drop).map_err(|error| {
                *stopped = Some(error);
                Diagnostic::error("run::stopped", "the callback has stopped the work")
            })
        })
        .map_err(|refusal| refusal.messages)?;
    let failed = |error: std::io::Error| alone(Diagnostic::error("output::unwritable", error.to_string()));
    let (mut json, mut review) = (Vec::new(), Vec::new());
    made.write_json(&mut json).map_err(failed)?;
    made.write_review(&mut review, true).map_err(failed)?;
    let text = |bytes: Vec<u8>| String::from_utf8_lossy(&bytes).into_owned();
    Ok(Plain {
        files: made.loaded().into_iter().map(|(path, bytes)| (path.to_owned(), bytes.to_vec())).collect(),
        diff: made.diff(),
        json: text(json),
        review: text(review),
        messages: made.messages.iter().map(message).collect(),
    })
}
