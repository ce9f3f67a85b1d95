//! A file as read: its name, its bytes, where its lines begin, and its tree.

use super::parse::parse;
use super::tree::{FileItem, ModuleItem, Tree};
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
    /// What was read out of it; without what stands inside routines after [`forget_bodies`](Self::forget_bodies).
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

    /// Lets go of what stands inside routines: of a large program that takes several times the text's room.
    ///
    /// [`whole_tree`](Self::whole_tree) reads it again.
    pub fn forget_bodies(&mut self) {
        for item in &mut self.tree.items {
            let FileItem::Module(module) = item else { continue };
            for item in &mut module.items {
                if let ModuleItem::Routine(routine) = item {
                    routine.body = Vec::new();
                    routine.handlers = Vec::new();
                }
            }
        }
    }

    /// The tree with all that stands inside routines, read anew.
    #[must_use]
    pub fn whole_tree(&self) -> Tree {
        parse(&self.bytes).0
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
    fn what_stands_in_routines_can_be_forgotten_and_read_again() {
        let text = "MODULE m\n PROC main()\n MoveL p,v100,fine,t;\n ERROR\n RETRY;\n ENDPROC\nENDMODULE\n";
        let mut file = SourceFile::read(FileId(0), "m.mod", text.as_bytes().to_vec());
        let whole = file.tree.clone();
        file.forget_bodies();
        let bodies = |tree: &Tree| match tree.items.as_slice() {
            [FileItem::Module(module)] => match module.items.as_slice() {
                [ModuleItem::Routine(routine)] => (routine.body.len(), routine.handlers.len(), routine.range),
                _ => panic!(),
            },
            _ => panic!(),
        };
        let range = bodies(&whole).2;
        assert_eq!((bodies(&whole), bodies(&file.tree)), ((1, 1, range), (0, 0, range)));
        assert_eq!(file.whole_tree(), whole);
    }

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
