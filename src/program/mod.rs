//! What a RAPID program means as far as motion goes: data as typed values, names resolved, motions in
//! their order with what is known about tool, work object and targets.
//!
//! Meaning starts here; text stays in [`syntax`](crate::syntax). Knows nothing of robots' geometry or of
//! deformation.

pub mod data;
pub mod motion;

use crate::diagnostic::{Diagnostic, FileId};
use crate::syntax::SourceFile;
use motion::{Loop, Motion, RoutineInfo};

/// A program: all given files, read and understood together.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// The files, in the order given; [`FileId`] is the position.
    pub files: Vec<SourceFile>,
    /// Routines that hold motion, in file order.
    pub routines: Vec<RoutineInfo>,
    /// Loops round motion, in file order.
    pub loops: Vec<Loop>,
    /// Every motion instruction, in file order.
    pub motions: Vec<Motion>,
    /// What a reader of the program should know.
    pub diagnostics: Vec<Diagnostic>,
}

impl Program {
    /// The file of an id.
    #[must_use]
    pub fn file(&self, id: FileId) -> &SourceFile {
        &self.files[id.0 as usize]
    }
}
