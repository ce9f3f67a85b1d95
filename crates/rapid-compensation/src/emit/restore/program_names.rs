//! What was added to a program, named in one of its modules that has no comment block: then that has lost it.

use super::altered::core_names;
use super::still_named::AddedNames;
use crate::emit::header;
use rapid_syntax::diagnostic::LineIndex;

/// Names that compensation added to a program's modules.
#[derive(Default)]
pub struct AddedToProgram(AddedNames);

impl AddedToProgram {
    /// Those of a program's files, whatever they hold.
    #[must_use]
    pub fn of<'f>(files: impl Iterator<Item = &'f [u8]>) -> Self {
        let (mut names, mut cores) = (AddedNames::default(), Vec::new());
        for bytes in files {
            if let Some(record) = header::record_of(bytes) {
                names.add_asked(&record);
            }
            cores.extend(core_names(bytes));
        }
        // Names that a source has itself are known by then.
        names.add_core(&cores);
        Self(names)
    }

    /// The first of them that no source names which stands in a file, and its line, from 1; `None` where none does.
    #[must_use]
    pub fn named_in(&self, bytes: &[u8]) -> Option<(u32, String)> {
        let (at, name) = self.0.named_in(bytes).err()?;
        Some((LineIndex::new(bytes).line(at), name))
    }
}
