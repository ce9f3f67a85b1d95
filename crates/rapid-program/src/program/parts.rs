//! A program that is read part by part, so that of a large one only a part is held at a time.
//!
//! Of each part the files are there in full, of the others their outlines: names, calls and what is in force are followed
//! across all files as in the whole program. Knows no files of a disk: they come from whoever gives the program.

use super::outline::{outline, shadows_a_move};
use super::{Overrides, Program};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{Diagnostic, FileId, Span};
use rayon::prelude::*;
use std::ops::Range;

/// A part of a program.
#[derive(Clone, Copy)]
pub struct Part<'p> {
    /// Which, from 0.
    pub number: usize,
    /// Its files in full and the others' outlines.
    pub program: &'p Program,
    /// Of all files, where there are several parts.
    outlines: &'p [SourceFile],
}

impl Part<'_> {
    /// Whether other parts see what stands at a place of its files, too.
    #[must_use]
    pub fn is_outlined(&self, place: Span) -> bool {
        self.outlines.get(place.file.0 as usize).is_some_and(|outline| outline.keeps(place.range.start))
    }
}

/// A program that is at hand part by part; the parts' own files follow one another in file order.
pub trait Parts {
    /// How many parts.
    fn count(&self) -> usize;

    /// Shows a part.
    ///
    /// # Errors
    /// Its files are not there any more, or not as they were.
    fn visit(&mut self, part: usize, see: &mut dyn FnMut(Part<'_>)) -> Result<(), Diagnostic>;
}

/// A whole program is its only part.
impl Parts for &Program {
    fn count(&self) -> usize {
        1
    }

    fn visit(&mut self, _: usize, see: &mut dyn FnMut(Part<'_>)) -> Result<(), Diagnostic> {
        see(Part { number: 0, program: self, outlines: &[] });
        Ok(())
    }
}

/// Outlines of more bytes than this, or than a part has, are too much to be read with each part: little is left out of files that
/// name their targets, and such a program is read at once.
const OUTLINES_BYTES: usize = 1_000_000;

/// Gives a file, as often as it is asked for.
type Load<'l> = Box<dyn Fn(FileId) -> Result<SourceFile, Diagnostic> + Sync + 'l>;

/// A program in parts.
pub struct InParts<'l> {
    load: Load<'l>,
    overrides: &'l Overrides,
    /// By [`FileId`]; empty where there is one part only.
    outlines: Vec<SourceFile>,
    /// The files of each part.
    parts: Vec<Range<usize>>,
    /// The part that is shown next.
    held: Option<(usize, Program)>,
}

impl<'l> InParts<'l> {
    /// A program of so many files in parts of about so many bytes; a file is never divided.
    ///
    /// # Errors
    /// Those of `load`.
    pub fn new(
        files: usize,
        part_bytes: usize,
        overrides: &'l Overrides,
        load: impl Fn(FileId) -> Result<SourceFile, Diagnostic> + Sync + 'l,
    ) -> Result<Self, Diagnostic> {
        let mut new =
            Self { load: Box::new(load), overrides, outlines: Vec::new(), parts: Vec::new(), held: None };
        let mut whole: Vec<SourceFile> = Vec::new();
        let (mut bytes, mut indivisible) = (0, false);
        for id in 0..files {
            let file = (new.load)(FileId(id as u32))?;
            indivisible |= shadows_a_move(&file);
            new.outlines.push(outline(&file));
            let begins = new.parts.is_empty() || bytes + file.bytes.len() > part_bytes;
            match new.parts.last_mut() {
                Some(part) if !begins => part.end = id + 1,
                _ => {
                    bytes = 0;
                    new.parts.push(id..id + 1);
                }
            }
            bytes += file.bytes.len();
            match new.parts.len() {
                1 => whole.push(file),
                _ => whole.clear(), // it is more than one part: none is held before it is asked for
            }
        }
        let outlines_bytes: usize = new.outlines.iter().map(|outline| outline.bytes.len()).sum();
        indivisible |= outlines_bytes > OUTLINES_BYTES.max(part_bytes);
        if indivisible || new.parts.len() < 2 {
            for id in whole.len()..files {
                whole.push((new.load)(FileId(id as u32))?);
            }
            new.outlines = Vec::new();
            new.parts = std::iter::once(0..files).collect();
            new.held = Some((0, Program::read(whole, overrides)));
        }
        Ok(new)
    }

    /// The program, where it is in one part.
    #[must_use]
    pub fn whole(&self) -> Option<&Program> {
        self.held.as_ref().filter(|_| self.parts.len() == 1).map(|(_, program)| program)
    }

    /// All of it, read anew.
    ///
    /// # Errors
    /// Those of reading a file.
    pub fn at_once(&self) -> Result<Program, Diagnostic> {
        let files = self.parts.last().map_or(0, |part| part.end);
        let files = (0..files).map(|id| (self.load)(FileId(id as u32))).collect::<Result<Vec<_>, _>>()?;
        Ok(Program::read(files, self.overrides))
    }

    /// The same as [`whole`](Self::whole), let go.
    #[must_use]
    pub fn into_whole(self) -> Option<Program> {
        self.held.filter(|_| self.parts.len() == 1).map(|(_, program)| program)
    }

    /// A part's files in full and the others' outlines.
    fn read(&self, part: usize) -> Result<Program, Diagnostic> {
        let own = self.parts.get(part).cloned().unwrap_or_default();
        let file = |(id, outline): (usize, &SourceFile)| match own.contains(&id) {
            true => (self.load)(FileId(id as u32)),
            false => Ok(outline.clone()),
        };
        let files = self.outlines.par_iter().enumerate().map(file).collect::<Result<Vec<_>, _>>()?;
        Ok(Program::read(files, self.overrides))
    }
}

impl Parts for InParts<'_> {
    fn count(&self) -> usize {
        self.parts.len()
    }

    fn visit(&mut self, part: usize, see: &mut dyn FnMut(Part<'_>)) -> Result<(), Diagnostic> {
        let held = self.held.take().filter(|(held, _)| *held == part).map(|(_, program)| program);
        let program = match held {
            Some(program) => program,
            None => self.read(part)?,
        };
        // Reading is one core's work: the next part is read while this one is looked at.
        let next = std::thread::scope(|scope| {
            let more = part + 1 < self.parts.len();
            let next = more.then(|| scope.spawn(|| self.read(part + 1)));
            see(Part { number: part, program: &program, outlines: &self.outlines });
            next.map(std::thread::ScopedJoinHandle::join)
        });
        self.held = match next {
            Some(Ok(next)) => Some((part + 1, next?)),
            Some(Err(panicked)) => std::panic::resume_unwind(panicked),
            None => (self.parts.len() == 1).then_some((part, program)),
        };
        Ok(())
    }
}
