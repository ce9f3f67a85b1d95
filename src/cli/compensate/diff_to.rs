//! Where the difference between a program and what is made of it goes.

use crate::application::write_file_diff;
use crate::cli::Console;
use crate::cli::files::{Pending, unwritable};
use crate::cli::program_at::check_no_program;
use crate::report::{self, ShortDiff};
use rapid_compensation::emit::EmittedFile;
use rapid_program::Program;
use rapid_syntax::diagnostic::Diagnostic;
use std::io::{self, BufWriter, Read, Seek, Write};
use std::path::Path;

/// What is shown or written of the difference.
pub(super) enum DiffTo {
    Nowhere,
    /// The first changes, on standard output.
    Short(ShortDiff),
    /// All of it on standard output; until all is well in a file without a name.
    Standard(std::fs::File),
    File(Pending),
}

impl DiffTo {
    /// What `asked` says in words, or the file that it names.
    ///
    /// # Errors
    /// A place where no file can be put, as [`Pending::new`] says.
    pub fn new(asked: &Path, is_quiet: bool) -> Result<Self, Diagnostic> {
        let unnamed = || tempfile::tempfile().map_err(|cause| no_output(&cause));
        match asked.to_str() {
            Some("none") => Ok(Self::Nowhere),
            Some("short") if is_quiet => Ok(Self::Nowhere),
            Some("short") => Ok(Self::Short(ShortDiff::default())),
            Some("-") => unnamed().map(Self::Standard),
            _ => {
                check_no_program(asked)?;
                Pending::new(asked).map(Self::File)
            }
        }
    }

    /// Takes what changes in an emitted file, which goes to `path`.
    ///
    /// # Errors
    /// `output::unwritable`, naming the difference's own file.
    pub fn add(&mut self, program: &Program, file: &EmittedFile, path: &str) -> Result<(), Diagnostic> {
        let buffered = |out: &mut dyn Write| {
            let mut out = BufWriter::with_capacity(1 << 16, out);
            write_file_diff(&mut out, program, file, path)?;
            out.flush()
        };
        match self {
            Self::Nowhere => Ok(()),
            Self::Short(short) => {
                if let Some(id) = file.source {
                    let source = program.file(id);
                    short.add(&source.path, path, &source.bytes, &file.edits());
                }
                Ok(())
            }
            Self::Standard(all) => buffered(all).map_err(|cause| no_output(&cause)),
            Self::File(pending) => {
                let written = buffered(pending.out());
                written.map_err(|cause| unwritable(pending.path(), cause))
            }
        }
    }

    /// The file that is to be put in its place; nothing is left of it here.
    pub fn take_file(&mut self) -> Option<Pending> {
        if !matches!(self, Self::File(_)) {
            return None;
        }
        match std::mem::replace(self, Self::Nowhere) {
            Self::File(pending) => Some(pending),
            _ => None,
        }
    }

    /// Writes what goes to standard output.
    ///
    /// # Errors
    /// What cannot be written, a full disk or a closed pipe.
    pub fn show(&mut self, console: &mut Console) -> io::Result<()> {
        let mut text = Vec::new();
        match self {
            Self::Short(short) => short.write(&mut text)?,
            Self::Standard(all) => {
                all.rewind()?;
                if !console.is_coloured() {
                    io::copy(all, console.out())?;
                    return writeln!(console.out());
                }
                all.read_to_end(&mut text)?;
                text.push(b'\n');
            }
            Self::Nowhere | Self::File(_) => return Ok(()),
        }
        match console.is_coloured() {
            true => report::write_coloured(console.out(), &text),
            false => console.out().write_all(&text),
        }
    }
}

pub(super) fn no_output(cause: &io::Error) -> Diagnostic {
    Diagnostic::error("output::unwritable", format!("standard output cannot be written: {cause}"))
}
