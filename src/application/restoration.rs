//! Originals of emitted modules.

use super::one_run::not_of_one_run;
use super::program_files::ProgramFiles;
use crate::report::restored as report;
use rapid_compensation::emit::{
    AddedToProgram, Altered, RestoreError, Restored, altered_core, core_names, restore_beside,
};
use rapid_program::pgf_without_module;
use rapid_syntax::diagnostic::Diagnostic;
use std::path::Path;

/// Emitted modules that wait to become their originals.
///
/// ```
/// use driftpost::application::{Restoration, RestoredFile};
/// use driftpost::{Compensation, Deformation, ProgramFiles, Robot};
///
/// let robot = Robot::built_in("irb140").expect("it is one of the library's");
/// let cube = include_bytes!("../../fixtures/robodk/irc5/Cube45.mod");
/// let program = ProgramFiles::one("Cube45.mod", *cube);
/// let job = Compensation::new(robot, Deformation::paper());
/// let emitted = ProgramFiles::new(job.run(&program)?.loaded());
///
/// let found = Restoration::new(emitted).run()?;
/// let RestoredFile::Original(original) = &found.files[0] else { panic!("it is an emitted one") };
/// assert!(original.exact && original.bytes == cube);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Restoration {
    files: ProgramFiles,
    /// What a whole program is called; `None` for emitted modules alone.
    program: Option<String>,
}

impl Restoration {
    /// Emitted modules; beside others the common module may be among them.
    #[must_use]
    pub fn new(files: ProgramFiles) -> Self {
        Self { files, program: None }
    }

    /// A whole program, called `name` in messages: modules that are no emitted ones stay as they are.
    pub fn of_program(files: ProgramFiles, name: impl Into<String>) -> Self {
        Self { files, program: Some(name.into()) }
    }

    /// The original of each emitted module.
    ///
    /// # Errors
    /// [`RestorationError`]
    pub fn run(&self) -> Result<RestoredFiles, RestorationError> {
        let alone = self.program.is_none() && self.files.iter().count() == 1;
        let core: Vec<Vec<u8>> = self.files.iter().flat_map(|(_, bytes)| core_names(bytes)).collect();
        let one = |(path, bytes): (&str, &[u8])| match restore_beside(bytes, &core) {
            Ok(restored) => Ok(RestoredFile::Original(restored)),
            Err(RestoreError::IsCore) if !alone => Ok(RestoredFile::Core(altered_core(bytes))),
            Err(RestoreError::NotEmitted) if self.program.is_some() => Ok(RestoredFile::Other),
            Err(error) => Err(RestorationError::File { path: path.to_owned(), error: Box::new(error) }),
        };
        let files = self.files.iter().map(one).collect::<Result<Vec<_>, _>>()?;
        self.check_headers(&files)?;
        // A common module alone is what a run leaves that was stopped before it exchanged the first of the others.
        let is_emitted = |file: &RestoredFile| !matches!(file, RestoredFile::Other);
        match &self.program {
            Some(program) if !files.iter().any(is_emitted) => {
                Err(RestorationError::NoneEmitted { program: program.clone() })
            }
            _ => Ok(RestoredFiles {
                of_other_runs: not_of_one_run(&self.files, self.program.is_some()),
                files,
                paths: self.files.iter().map(|(path, _)| path.to_owned()).collect(),
            }),
        }
    }

    /// Refuses a program with a module that asks like the others and has no comment block any more: what it was cannot be told.
    fn check_headers(&self, files: &[RestoredFile]) -> Result<(), RestorationError> {
        if !files.iter().any(|file| matches!(file, RestoredFile::Other)) {
            return Ok(());
        }
        let added = AddedToProgram::of(self.files.iter().map(|(_, bytes)| bytes));
        let others = self.files.iter().zip(files).filter(|(_, file)| matches!(file, RestoredFile::Other));
        let lost = others.map(|((path, bytes), _)| (path, added.named_in(bytes)));
        match lost.filter_map(|(path, named)| Some((path.to_owned(), named?))).next() {
            Some((path, (line, name))) => Err(RestorationError::HeaderLost { path, line, name }),
            None => Ok(()),
        }
    }
}

/// What a file of an emitted program was.
#[derive(Clone, Debug)]
pub enum RestoredFile {
    /// An emitted module, with its original.
    Original(Restored),
    /// The common module, which has no original, with what was changed in it.
    Core(Vec<Altered>),
    /// No emitted module.
    Other,
}

impl RestoredFile {
    /// The original; `None` of what has none.
    #[must_use]
    pub fn original(&self) -> Option<&Restored> {
        match self {
            Self::Original(restored) => Some(restored),
            Self::Core(_) | Self::Other => None,
        }
    }
}

/// What the files of an emitted program were.
#[derive(Clone, Debug)]
pub struct RestoredFiles {
    /// In the order of the files that were given.
    pub files: Vec<RestoredFile>,
    /// What is said of modules whose common module is not there, or of another run.
    pub of_other_runs: Vec<Diagnostic>,
    paths: Vec<String>,
}

impl RestoredFiles {
    /// The emitted modules with their originals, by the path of each.
    pub fn originals(&self) -> impl Iterator<Item = (&str, &Restored)> {
        let all = self.paths.iter().zip(&self.files);
        all.filter_map(|(path, file)| Some((path.as_str(), file.original()?)))
    }

    /// The common modules and what was changed in each, by the path of each.
    pub fn cores(&self) -> impl Iterator<Item = (&str, &[Altered])> {
        self.paths.iter().zip(&self.files).filter_map(|(path, file)| match file {
            RestoredFile::Core(altered) => Some((path.as_str(), altered.as_slice())),
            _ => None,
        })
    }

    /// Whether nothing was changed since of what motions ask with, in the common module either. Edits of other text, and numbers that a controller has written anew,
    /// stand in the originals as they were made ([`Restored::exact`] is false then).
    #[must_use]
    pub fn is_untouched(&self) -> bool {
        let is_as_made = |restored: &Restored| restored.touched.is_empty() && restored.altered.is_empty();
        self.of_other_runs.is_empty()
            && self.originals().all(|(_, restored)| is_as_made(restored))
            && self.cores().all(|(_, altered)| altered.is_empty())
    }

    /// A list of modules (`.pgf`) at `path` without the common ones.
    #[must_use]
    pub fn list_without_cores(&self, path: &Path, list: Vec<u8>) -> Vec<u8> {
        let beside = path.parent().unwrap_or(Path::new(""));
        let cores = self.cores().filter_map(|(core, _)| Path::new(core).strip_prefix(beside).ok());
        cores.fold(list, |list, core| pgf_without_module(&list, &core.to_string_lossy().replace('\\', "/")))
    }

    /// The JSON of the contract; `outputs` says where each original goes.
    #[must_use]
    pub fn json(&self, outputs: &[String]) -> serde_json::Value {
        report::json(
            self.originals().zip(outputs).map(|((path, restored), output)| (path, output.as_str(), restored)),
        )
    }
}

/// Why nothing is restored.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RestorationError {
    /// A module is none of ours, or was edited where it must not be.
    #[error("{path}: {error}")]
    File {
        /// Path of the module as it was given.
        path: String,
        /// What is the matter with it.
        error: Box<RestoreError>,
    },
    /// A module of a program asks as compensated ones do, and has no comment block.
    #[error(
        "{path}:{line}: {name} is named there, which was added to this program, and the comment block after MODULE is gone: what the module \
         was cannot be told; put its original file in its place, and restore again"
    )]
    HeaderLost {
        /// Path of the module as it was given.
        path: String,
        /// The line, from 1.
        line: u32,
        /// The data or function that was added and is named there.
        name: String,
    },
    /// A program that was never compensated.
    #[error("no module of {program} is a compensated one")]
    NoneEmitted {
        /// What the program is called.
        program: String,
    },
}

impl RestorationError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::File { error, .. } => error.code(),
            Self::HeaderLost { .. } => "restore::header-lost",
            Self::NoneEmitted { .. } => RestoreError::NotEmitted.code(),
        }
    }
}

impl From<RestorationError> for Diagnostic {
    fn from(error: RestorationError) -> Self {
        Self::error(error.code(), error.to_string())
    }
}
