//! The files of a result: each is written whole beside its place before any is put there.

use super::destination::{Destination, STANDARD, is_pgf};
use super::files::{self, Pending};
use super::left_over::{WrittenModule, left_over};
use super::program_at::bytes_of_file;
use super::program_input::ProgramInput;
use crate::application::EarlierResult;
use crate::report::LocatedDiagnostic;
use driftpost::application::Compensated;
use rapid_compensation::emit::EmittedFile;
use rapid_syntax::diagnostic::{Diagnostic, FileId};
use std::fs;
use std::path::{Path, PathBuf};

/// Files of a result, each written beside its place; all are written before any is put in its place.
#[derive(Default)]
pub struct Writing {
    /// The common module, which the others call.
    cores: Vec<Pending>,
    /// Modules that are changed.
    changed: Vec<Pending>,
    /// What stays as it is, and lists of modules.
    others: Vec<Pending>,
    /// Paths and sizes of the emitted files.
    written: Vec<(PathBuf, usize)>,
    /// The emitted files; of the common module alone with what stands in it.
    emitted: Vec<EmittedFile>,
    /// The module that goes to standard output.
    standard: Option<Vec<u8>>,
}

/// Files that are whole, beside their places.
pub struct Written {
    /// To be put in their places in this order. A run may be killed between any two: what then stands there must be a program that
    /// moves the arm rightly, or one that no controller loads.
    pub pending: Vec<Pending>,
    /// Taken away before anything is put in its place: an earlier common module, with which what is new must never run.
    pub withdrawn: Vec<PathBuf>,
    /// Paths and sizes of the emitted files, changed and new.
    pub emitted: Vec<(PathBuf, usize)>,
    /// What goes to standard output.
    pub standard: Option<Vec<u8>>,
}

impl Writing {
    /// Writes an emitted file.
    ///
    /// # Errors
    /// `output::unwritable`.
    pub fn add(
        &mut self,
        to: &Destination,
        given: &ProgramInput,
        file: EmittedFile,
    ) -> Result<(), Diagnostic> {
        let path = to.path_of(&file, given);
        self.written.push((path.clone(), file.bytes.len()));
        if path == Path::new(STANDARD) {
            self.standard = Some(file.bytes.clone());
        } else {
            let whole = beside(&path, &file.bytes)?;
            if file.source.is_none() { &mut self.cores } else { &mut self.changed }.push(whole);
        }
        let bytes = if file.source.is_none() { file.bytes } else { Vec::new() };
        self.emitted.push(EmittedFile { bytes, replaced: Vec::new(), ..file });
        Ok(())
    }

    /// What an earlier run left beside these files; `all_made` says which modules are in them.
    pub fn left_over(
        &self,
        to: &Destination,
        given: &ProgramInput,
        all_made: &[Compensated<'_>],
    ) -> Vec<LocatedDiagnostic> {
        let cores = self.emitted.iter().filter(|file| file.source.is_none()).map(|file| {
            let path = to.path_of(file, given);
            let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            WrittenModule { path, name, is_core: true }
        });
        let own = all_made.iter().flat_map(|made| &made.program.facts.modules).filter_map(|module| {
            let path = to.modules.get(module.file.0 as usize)?.clone();
            Some(WrittenModule { path, name: module.name.clone(), is_core: false })
        });
        let written: Vec<WrittenModule> = own.chain(cores).collect();
        LocatedDiagnostic::all(left_over(to, &written), &[])
    }

    fn put(&mut self, path: &Path, bytes: &[u8]) -> Result<(), Diagnostic> {
        self.others.push(beside(path, bytes)?);
        Ok(())
    }

    /// Writes what stays as it is.
    ///
    /// # Errors
    /// `output::unwritable` or `input::unreadable`.
    pub fn finish(mut self, to: &Destination, given: &ProgramInput) -> Result<Written, Diagnostic> {
        to.check_new(given, &self.emitted)?;
        let mut record = String::new();
        if to.whole {
            for (id, (path, bytes)) in to.modules.iter().zip(&given.bytes).enumerate() {
                if !self.emitted.iter().any(|file| file.source == Some(FileId(id as u32))) {
                    match path == Path::new(STANDARD) {
                        true => self.standard = Some(bytes.to_vec()),
                        false => {
                            self.put(path, bytes)?;
                            record.extend(to.copies.as_ref().map(|copies| copies.line(path, bytes)));
                        }
                    }
                }
            }
        }
        for (from, place) in &to.others {
            if is_pgf(from) {
                let listed = files::read(from, "list of modules")?;
                let now = to.list_with(from, place, &listed, given, &self.emitted);
                if now != listed {
                    self.written.push((place.clone(), now.len()));
                }
                if from != place || now != listed {
                    self.put(place, &now)?;
                }
                continue;
            }
            let bytes = fs::read(from).map_err(|cause| files::cannot_read(from, "file", &cause))?;
            self.put(place, &bytes)?;
            record.extend(to.copies.as_ref().map(|copies| copies.line(place, &bytes)));
        }
        if let Some(copies) = to.copies.as_ref().filter(|_| !record.is_empty()) {
            self.put(&copies.record(), record.as_bytes())?;
        }
        Ok(self.in_order())
    }

    /// Where originals or nothing stands, the common module comes first: then whatever is there is corrected rightly or not at all.
    /// Where an earlier result stands, its common module goes first and the new one comes last: until then nothing loads, as old
    /// modules would ask a new clock, or new ones an old one.
    fn in_order(self) -> Written {
        let is_earlier =
            |path: &Path| bytes_of_file(path).is_some_and(|bytes| EarlierResult::of(&bytes).is_some());
        let mut withdrawn = Vec::new();
        for (core, file) in self.emitted.iter().filter(|file| file.source.is_none()).zip(&self.cores) {
            if bytes_of_file(file.path()).is_some_and(|there| there != core.bytes) {
                withdrawn.push(file.path().to_path_buf());
            }
        }
        let replaces = self.changed.iter().chain(&self.others).any(|file| is_earlier(file.path()));
        let (first, last) = if replaces || !withdrawn.is_empty() {
            (Vec::new(), self.cores)
        } else {
            (self.cores, Vec::new())
        };
        let pending = first.into_iter().chain(self.others).chain(self.changed).chain(last).collect();
        Written { pending, withdrawn, emitted: self.written, standard: self.standard }
    }
}

/// A file that is whole beside its place.
fn beside(path: &Path, bytes: &[u8]) -> Result<Pending, Diagnostic> {
    let mut file = Pending::new(path)?;
    file.fill(bytes)?;
    Ok(file)
}
