//! The process's two outputs: results on standard output, messages on standard error.
//!
//! A reader that goes away (`driftpost ... | head`) is not an error: what is written to a closed pipe is
//! dropped, the work goes on and the exit code is what it would have been.

use super::Outcome;
use driftpost::report::{self, ColorMode, LocatedDiagnostic};
use rapid_syntax::diagnostic::Diagnostic;
use std::io::{self, IsTerminal, Write};

/// Standard output and standard error.
pub struct Console {
    out: Sink<io::BufWriter<io::Stdout>>,
    err: Sink<io::Stderr>,
    /// Whether a person sees standard error.
    err_is_terminal: bool,
    /// Whether a person sees standard output, in colours.
    is_coloured: bool,
}

impl Console {
    /// The process's own.
    #[must_use]
    pub fn of_process() -> Self {
        Self {
            out: Sink::new(io::BufWriter::with_capacity(1 << 16, io::stdout())),
            err: Sink::new(io::stderr()),
            err_is_terminal: io::stderr().is_terminal(),
            is_coloured: io::stdout().is_terminal() && std::env::var_os("NO_COLOR").is_none(),
        }
    }

    /// Where results go.
    pub fn out(&mut self) -> &mut dyn Write {
        &mut self.out
    }

    /// Whether results may be coloured.
    #[must_use]
    pub fn is_coloured(&self) -> bool {
        self.is_coloured
    }

    /// Where messages go.
    pub fn err(&mut self) -> &mut dyn Write {
        &mut self.err
    }

    /// Does long work; a person at a terminal sees that something goes on.
    pub fn while_busy<T>(&mut self, what: &'static str, work: impl FnOnce() -> T) -> T {
        if !self.err_is_terminal {
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
        let look = if self.err_is_terminal { ColorMode::Coloured } else { ColorMode::Plain };
        let _ = report::write_messages(&mut self.err, messages, look, all); // as in `say`
    }

    /// One line to standard error.
    pub fn say(&mut self, line: impl std::fmt::Display) {
        let _ = writeln!(self.err, "{line}"); // nobody is left to tell that standard error is gone
    }

    /// Says why a command could not do its work.
    pub fn fail(&mut self, error: &anyhow::Error) -> Outcome {
        let _ = self.out.flush();
        match error.downcast_ref::<Diagnostic>() {
            Some(message) => self.explain(&[LocatedDiagnostic::new(message.clone(), &[])], true),
            None => self.say(format_args!("error: {error:#}")),
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
