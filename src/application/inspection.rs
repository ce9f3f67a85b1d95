//! What a program's motions are, and which can be compensated as far as their text tells.

use super::program_files::{ProgramFiles, check_modules};
use crate::report::{self, LocatedDiagnostic};
use rapid_compensation::emit::{self, Clock};
use rapid_program::{Overrides, Program};
use std::io::{self, Write};

/// Lists a program's motions, and which of them can be compensated as far as their text tells.
///
/// ```
/// use driftpost::ProgramFiles;
/// use driftpost::application::Inspection;
///
/// let program = ProgramFiles::one("Cube45.mod", *include_bytes!("../../fixtures/robodk/irc5/Cube45.mod"));
/// let inspected = Inspection::new().run(&program)?;
/// assert!(inspected.program.motions.iter().all(|motion| motion.skip_reason.is_none()));
/// assert_eq!(inspected.json()["form"], "schedule");
/// # Ok::<(), Box<driftpost::LocatedDiagnostic>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Inspection {
    /// Tools and work objects that stand for the program's own.
    pub overrides: Overrides,
}

impl Inspection {
    /// An inspection with the program's own tools and work objects.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Reads the program: its names resolved, its motions with their targets.
    ///
    /// # Errors
    /// `input::no-module` or `input::truncated`, with the place in the file.
    pub fn run(&self, program: &ProgramFiles) -> Result<Inspected, Box<LocatedDiagnostic>> {
        let files = program.sources();
        if let Err(why) = check_modules(&files) {
            return Err(Box::new(LocatedDiagnostic::new(why, &files)));
        }
        // Which clock and which touch there will be nobody has said; a program is written with any of them.
        let added_routines = emit::routines_to_call(&Clock::Elapsed, true);
        let overrides = Overrides { added_routines, ..self.overrides.clone() };
        let program = Program::read(files, &overrides);
        let warnings = program.files.iter().flat_map(|file| &file.warnings);
        let messages = LocatedDiagnostic::all(warnings.chain(&program.diagnostics).cloned(), &program.files);
        Ok(Inspected { program, messages })
    }
}

/// A program that was looked at.
#[derive(Debug)]
pub struct Inspected {
    /// The program, read.
    pub program: Program,
    /// What is worth knowing before it is compensated.
    pub messages: Vec<LocatedDiagnostic>,
}

impl Inspected {
    /// Counts and motions for people; of a long program the first motions, or with `all` every one.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write(&self, out: &mut dyn Write, all: bool) -> io::Result<()> {
        report::write_inspection(out, &self.program, all)
    }

    /// The motions as CSV, one a line.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        report::write_inspection_csv(out, &self.program)
    }

    /// The JSON of the contract.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        report::inspection(&self.program, &self.messages)
    }
}
