//! A file as read: its name, its bytes, where its lines begin, and its tree.

use super::parse;
use super::tree::Tree;
use crate::diagnostic::{Diagnostic, FileId, Span, TextRange};

/// Where the lines of a file begin; a line ends after LF, after CR LF, or after a CR that no LF follows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LineIndex {
    starts: Vec<u32>,
}

impl LineIndex {
    /// The index of `source`.
    #[must_use]
    pub fn new(source: &[u8]) -> Self {
        let mut starts = vec![0];
        for at in memchr::memchr2_iter(b'\n', b'\r', source) {
            if source[at] == b'\r' && source.get(at + 1) == Some(&b'\n') {
                continue;
            }
            starts.push(at as u32 + 1);
        }
        Self { starts }
    }

    /// The line of a byte, counted from 1.
    #[must_use]
    pub fn line(&self, offset: u32) -> u32 {
        self.starts.partition_point(|&s| s <= offset) as u32
    }

    /// The column of a byte in its line, in bytes, counted from 1.
    #[must_use]
    pub fn column(&self, offset: u32) -> u32 {
        offset - self.start_of(self.line(offset)) + 1
    }

    /// The first byte of a line (from 1); past the last line, that of the last.
    #[must_use]
    pub fn start_of(&self, line: u32) -> u32 {
        let last = self.starts.len() - 1;
        self.starts[(line.saturating_sub(1) as usize).min(last)]
    }

    /// Number of lines.
    #[must_use]
    pub fn lines(&self) -> u32 {
        self.starts.len() as u32
    }
}

/// One file of a program.
#[derive(Clone, Debug)]
pub struct SourceFile {
    /// Its number in the program.
    pub id: FileId,
    /// Its path as the user knows it, `/` between folders.
    pub path: String,
    /// Its bytes, as read.
    pub bytes: Vec<u8>,
    /// Where its lines begin.
    pub lines: LineIndex,
    /// What was read out of it.
    pub tree: Tree,
    /// What could not be read, and where.
    pub warnings: Vec<Diagnostic>,
}

impl SourceFile {
    /// Reads `bytes`, whatever they are; what is not understood is in [`warnings`](Self::warnings).
    #[must_use]
    pub fn read(id: FileId, path: impl Into<String>, bytes: Vec<u8>) -> Self {
        let (tree, warnings) = parse(&bytes);
        let at = |range| Span { file: id, range };
        let warnings =
            warnings.into_iter().map(|w| Diagnostic::warning(w.code, w.message).at(at(w.range))).collect();
        Self { id, path: path.into(), lines: LineIndex::new(&bytes), bytes, tree, warnings }
    }

    /// The bytes of a range.
    #[must_use]
    pub fn text(&self, range: TextRange) -> &[u8] {
        range.of(&self.bytes)
    }

    /// The span of a range of this file.
    #[must_use]
    pub fn span(&self, range: TextRange) -> Span {
        Span { file: self.id, range }
    }

    /// The line (from 1) a range begins on.
    #[must_use]
    pub fn line(&self, range: TextRange) -> u32 {
        self.lines.line(range.start)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_read_with_its_warnings_placed_in_it() {
        let bytes = b"MODULE m\n PROC main()\n  Prog1()\n ENDPROC\nENDMODULE".to_vec();
        let file = SourceFile::read(FileId(3), "a/m.mod", bytes);
        let spans: Vec<_> = file.warnings.iter().filter_map(|w| w.span).collect();
        assert!(!spans.is_empty());
        for span in spans {
            assert_eq!(
                (span.file, file.line(span.range), file.text(span.range)),
                (FileId(3), 3, &b"Prog1()"[..])
            );
        }
    }

    #[test]
    fn lines_end_after_lf_crlf_and_lone_cr() {
        let index = LineIndex::new(b"a\r\nbc\n\rd\r");
        assert_eq!(index.lines(), 5);
        assert_eq!([0, 2, 3, 5, 6, 7, 8].map(|o| index.line(o)), [1, 1, 2, 2, 3, 4, 4]);
        assert_eq!((index.column(4), index.start_of(4), index.start_of(9)), (2, 7, 9));
    }
}
