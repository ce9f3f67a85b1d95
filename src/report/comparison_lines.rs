//! The lines in which two programs differ, file by file.

use super::Compared;
use super::cut_lines::Cut;
use super::diff::{write_created, write_texts};
use super::plural;
use std::io::{self, Cursor, Write};

/// A longer diff is cut.
const MOST_LINES: usize = 2000;

impl Compared<'_> {
    /// Writes a unified diff of all files, cut where it is long and not `all` is wanted, and an empty line.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write_lines(&self, out: &mut dyn Write, all: bool) -> io::Result<()> {
        let mut cut = Cut::new(&mut *out, if all { usize::MAX } else { MOST_LINES });
        for (old, new) in self.pairs.pairs.iter().map(|(a, b)| (self.before.file(*a), self.after.file(*b))) {
            write_texts(&mut cut, &old.path, &new.path, &old.bytes, &new.bytes)?;
        }
        for file in self.pairs.only_after.iter().map(|file| self.after.file(*file)) {
            write_created(&mut cut, &file.path, &mut Cursor::new(&file.bytes))?;
        }
        let dropped = cut.dropped;
        if dropped > 0 {
            writeln!(out, "... and {dropped} more {}; --all shows all of them", plural(dropped, "line"))?;
        }
        writeln!(out)
    }
}
