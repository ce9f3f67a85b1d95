//! The process's two outputs: results on standard output, messages on standard error.
//!
//! A reader that goes away (`driftpost ... | head`) is not an error: what is written to a closed pipe is
//! dropped, the work goes on and the exit code is what it would have been.

use super::Outcome;
use crate::report::{self, ColorMode, LocatedDiagnostic};
use rapid_syntax::diagnostic::{Diagnostic, Severity};
use std::io::{self, IsTerminal, Write};

/// Standard output and standard error.
pub struct Console {
    out: Sink<Box<dyn Write>>,
    err: Sink<Box<dyn Write>>,
    /// Whether a person sees standard error, and whether in colours.
    err_is_terminal: bool,
    err_is_coloured: bool,
    /// Nothing but errors is said.
    is_quiet: bool,
    /// The errors that were told, where somebody collects them.
    errors: Option<Vec<LocatedDiagnostic>>,
    /// The warnings that were told, where a result carries them along.
    warnings: Option<Vec<LocatedDiagnostic>>,
    /// Whether a person sees standard output, in colours.
    is_coloured: bool,
}

impl Console {
    /// Streams of the process itself.
    #[must_use]
    pub fn of_process() -> Self {
        let colours = std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
        Self {
            out: Sink::new(Box::new(io::BufWriter::with_capacity(1 << 16, io::stdout()))),
            err: Sink::new(Box::new(io::stderr())),
            err_is_terminal: io::stderr().is_terminal(),
            err_is_coloured: io::stderr().is_terminal() && colours,
            is_quiet: false,
            errors: None,
            warnings: None,
            is_coloured: io::stdout().is_terminal() && colours,
        }
    }

    /// One that writes to `out` and `err`, and keeps the errors that are told.
    pub(super) fn collecting(out: impl Write + 'static, err: impl Write + 'static) -> Self {
        Self {
            out: Sink::new(Box::new(out)),
            err: Sink::new(Box::new(err)),
            err_is_terminal: false,
            err_is_coloured: false,
            is_quiet: false,
            errors: Some(Vec::new()),
            warnings: None,
            is_coloured: false,
        }
    }

    /// The errors that were told.
    pub(super) fn take_errors(&mut self) -> Vec<LocatedDiagnostic> {
        self.errors.take().unwrap_or_default()
    }

    /// From here on warnings are kept for [`add_warnings`](Self::add_warnings).
    pub(super) fn keep_warnings(&mut self) {
        self.warnings = Some(Vec::new());
    }

    /// Adds the warnings that were told to the JSON of a result, as `warnings` beside those which it has.
    pub(super) fn add_warnings(&mut self, data: &mut serde_json::Value) {
        let mut all = data["warnings"].as_array().cloned().unwrap_or_default();
        let kept = report::messages(&self.warnings.take().unwrap_or_default());
        all.extend(kept.as_array().cloned().unwrap_or_default());
        data["warnings"] = all.into();
    }

    /// From here on nothing but errors is said.
    pub(super) fn set_quiet(&mut self, is_quiet: bool) {
        self.is_quiet = is_quiet;
    }

    /// Whether nothing but errors is said.
    #[must_use]
    pub fn is_quiet(&self) -> bool {
        self.is_quiet
    }

    /// Stream that results are written to.
    pub fn out(&mut self) -> &mut dyn Write {
        &mut self.out
    }

    /// Whether results may be coloured.
    #[must_use]
    pub fn is_coloured(&self) -> bool {
        self.is_coloured
    }

    /// Stream that messages are written to.
    pub fn err(&mut self) -> &mut dyn Write {
        &mut self.err
    }

    /// Does long work; a person at a terminal sees that something goes on.
    pub fn while_busy<T>(&mut self, what: &'static str, work: impl FnOnce() -> T) -> T {
        if !self.err_is_terminal || self.is_quiet {
            return work();
        }
        let bar = indicatif::ProgressBar::new_spinner().with_message(what);
        bar.enable_steady_tick(std::time::Duration::from_millis(300));
        let result = work();
        bar.finish_and_clear();
        result
    }

    /// Messages to standard error, with excerpts of the files they are about.
    pub fn explain(&mut self, messages: &[LocatedDiagnostic], all: bool) {
        let is_error = |m: &&LocatedDiagnostic| m.diagnostic.severity == Severity::Error;
        if let Some(errors) = &mut self.errors {
            errors.extend(messages.iter().filter(is_error).cloned());
        }
        if let Some(warnings) = &mut self.warnings {
            warnings.extend(messages.iter().filter(|message| !is_error(message)).cloned());
        }
        let errors: Vec<LocatedDiagnostic>;
        let messages = if self.is_quiet {
            errors = messages.iter().filter(is_error).cloned().collect();
            &errors
        } else {
            messages
        };
        let color_mode = if self.err_is_coloured { ColorMode::Coloured } else { ColorMode::Plain };
        let _ = report::write_messages(&mut self.err, messages, color_mode, all); // as in `note`
    }

    /// Messages about no place in a file to standard error, each of them.
    pub fn report(&mut self, messages: impl IntoIterator<Item = Diagnostic>) {
        self.explain(&LocatedDiagnostic::all(messages, &[]), true);
    }

    /// Brings out what is still to be written, as far as there is a reader.
    pub fn flush(&mut self) {
        let _ = self.out.flush(); // told at the end
    }

    /// One line to standard error.
    pub fn note(&mut self, line: impl std::fmt::Display) {
        if self.is_quiet {
            return;
        }
        let _ = writeln!(self.err, "{line}"); // nobody is left to tell that standard error is gone
    }

    /// Says why a command could not do its work.
    pub fn fail(&mut self, error: &anyhow::Error) -> Outcome {
        let _ = self.out.flush();
        let of_run = || error.downcast_ref::<Diagnostic>().cloned().map(Box::from);
        match error.downcast_ref::<Box<LocatedDiagnostic>>().cloned().or_else(of_run) {
            Some(message) => self.explain(std::slice::from_ref(&*message), true),
            None => {
                let text = format!("{error:#}");
                if let Some(errors) = &mut self.errors {
                    errors.push(LocatedDiagnostic::new(Diagnostic::error("run::failed", text), &[]));
                }
                let _ = writeln!(self.err, "error: {error:#}"); // as in `note`
            }
        }
        Outcome::Refused
    }

    /// Brings out what is still to be written; a full disk is found here at the latest.
    pub(super) fn finish(&mut self, outcome: Outcome) -> Outcome {
        match self.out.flush() {
            Ok(()) => outcome,
            Err(cause) => self.fail(&anyhow::Error::new(cause).context("standard output cannot be written")),
        }
    }

    /// Shows help, the version, or what is wrong with the arguments.
    pub(super) fn usage(&mut self, error: &clap::Error) -> Outcome {
        if let Some(errors) = &mut self.errors {
            let text = error.to_string();
            let _ = write!(self.err, "{text}"); // as in `note`
            if !error.use_stderr() {
                return Outcome::Done;
            }
            errors.push(LocatedDiagnostic::new(usage(&text), &[]));
            return Outcome::Refused;
        }
        match error.print() {
            Err(cause) if cause.kind() != io::ErrorKind::BrokenPipe => {
                self.fail(&anyhow::Error::new(cause).context("standard output cannot be written"))
            }
            _ if error.use_stderr() => Outcome::Refused,
            _ => Outcome::Done,
        }
    }
}

/// A writer that drops everything once its reader has gone.
struct Sink<W> {
    inner: W,
    closed: bool,
}

impl<W: Write> Sink<W> {
    fn new(inner: W) -> Self {
        Self { inner, closed: false }
    }

    fn forgive<T>(&mut self, result: io::Result<T>, instead: T) -> io::Result<T> {
        match result {
            Err(e) if e.kind() == io::ErrorKind::BrokenPipe => {
                self.closed = true;
                Ok(instead)
            }
            other => other,
        }
    }
}

impl<W: Write> Write for Sink<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.closed {
            return Ok(bytes.len());
        }
        let result = self.inner.write(bytes);
        self.forgive(result, bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        if self.closed {
            return Ok(());
        }
        let result = self.inner.flush();
        self.forgive(result, ())
    }
}

/// What is wrong with arguments, of which clap gives `text` for a terminal: its first paragraph, with a tip as help.
pub(super) fn usage(text: &str) -> Diagnostic {
    let mut paragraphs =
        text.split("\n\n").map(|lines| lines.split_whitespace().collect::<Vec<_>>().join(" "));
    let first = paragraphs.next().unwrap_or_default();
    let message = Diagnostic::error("option::usage", first.trim_start_matches("error: "));
    match paragraphs.find_map(|lines| Some(lines.strip_prefix("tip: ")?.to_owned())) {
        Some(tip) => message.help(tip),
        None => message,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Gone;

    impl Write for Gone {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(io::ErrorKind::BrokenPipe.into())
        }
        fn flush(&mut self) -> io::Result<()> {
            Err(io::ErrorKind::BrokenPipe.into())
        }
    }

    struct Full;

    impl Write for Full {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(io::ErrorKind::StorageFull.into())
        }
        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn a_closed_pipe_is_forgiven_and_a_full_disk_is_not() {
        let mut gone = Sink::new(Gone);
        assert!(gone.write_all(b"x").is_ok() && gone.flush().is_ok() && gone.closed);
        assert_eq!(Sink::new(Full).write_all(b"x").unwrap_err().kind(), io::ErrorKind::StorageFull);
    }
}
