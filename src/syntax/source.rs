//! A file as read: its name, its bytes, where its lines begin, and its tree.

use super::parse;
use super::tree::Tree;
use crate::diagnostic::{Diagnostic, FileId, LineIndex, Span, TextRange};
use std::sync::Arc;

/// One file of a program.
#[derive(Clone, Debug)]
pub struct SourceFile {
    /// Its number in the program.
    pub id: FileId,
    /// Its path as the user knows it, `/` between folders.
    pub path: String,
    /// Its bytes, as read.
    pub bytes: Arc<[u8]>,
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
    pub fn read(id: FileId, path: impl Into<String>, bytes: impl Into<Arc<[u8]>>) -> Self {
        let bytes = bytes.into();
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
}
