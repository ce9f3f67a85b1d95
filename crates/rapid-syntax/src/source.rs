//! A file as read: its name, its bytes, where its lines begin, and its tree.

use super::parse;
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
    /// Of an outline: the places where text was left out, and how many bytes are left out up to there in all. `None` for a file
    /// in full; an outline may leave out nothing.
    cuts: Option<Vec<(u32, u32)>>,
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
        Self { id, path: path.into(), lines: LineIndex::new(&bytes), bytes, tree, warnings, cuts: None }
    }

    /// The file without the ranges `cut` (in order, apart from each other): shorter text whose lines keep their numbers.
    #[must_use]
    pub fn without(&self, cut: &[TextRange]) -> Self {
        let mut kept = Vec::with_capacity(cut.len() + 1);
        let (mut from, mut at, mut missing) = (0, 0, 0);
        let mut cuts = Vec::with_capacity(cut.len());
        for range in cut {
            kept.push(TextRange::new(from, range.start));
            at += range.start - from;
            missing += range.end - range.start;
            cuts.push((at, missing));
            from = range.end;
        }
        kept.push(TextRange::new(from, self.bytes.len() as u32));
        let bytes: Arc<[u8]> = kept.iter().flat_map(|range| self.text(*range)).copied().collect();
        let (tree, _) = parse(&bytes);
        let (path, lines) = (self.path.clone(), self.lines.of_parts(&kept));
        Self { id: self.id, path, bytes, lines, tree, warnings: Vec::new(), cuts: Some(cuts) }
    }

    /// Whether it is an outline: what is read of such a file serves to understand others.
    #[must_use]
    pub fn is_outline(&self) -> bool {
        self.cuts.is_some()
    }

    /// Of an outline: whether a byte of the whole file is left.
    #[must_use]
    pub fn keeps(&self, offset: u32) -> bool {
        let mut missing = 0;
        for &(at, missing_here) in self.cuts.iter().flatten() {
            if offset < at + missing {
                return true;
            }
            if offset < at + missing_here {
                return false;
            }
            missing = missing_here;
        }
        true
    }

    /// Where a range of an outline stands in the whole file.
    #[must_use]
    pub fn in_whole(&self, range: TextRange) -> TextRange {
        let cuts = self.cuts.as_deref().unwrap_or_default();
        let whole = |offset: u32| {
            let before = cuts.partition_point(|(at, _)| *at <= offset);
            offset + before.checked_sub(1).and_then(|last| cuts.get(last)).map_or(0, |(_, missing)| *missing)
        };
        match range.is_empty() {
            true => TextRange::empty(whole(range.start)),
            false => TextRange::new(whole(range.start), whole(range.end - 1) + 1),
        }
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
    fn what_is_left_of_a_file_knows_where_it_stood() {
        let text = b"MODULE m\n PROC main()\n  a;\n  b;\n  c;\n  d;\n ENDPROC\nENDMODULE\n";
        let file = SourceFile::read(FileId(0), "m.mod", text.to_vec());
        let at = |word: &[u8]| text.windows(word.len()).position(|w| w == word).unwrap() as u32;
        let outline = file.without(&[TextRange::new(at(b"a;") + 2, at(b"d;"))]);
        assert_eq!(&outline.bytes[..], b"MODULE m\n PROC main()\n  a;d;\n ENDPROC\nENDMODULE\n");
        assert!(outline.is_outline() && !file.is_outline());
        let d = TextRange::new(at(b"a;") + 2, at(b"a;") + 4);
        assert_eq!((outline.text(d), outline.line(d)), (&b"d;"[..], 6));
        assert_eq!(file.text(outline.in_whole(d)), b"d;");
        let both = TextRange::new(at(b"a;"), d.end);
        assert_eq!(file.text(outline.in_whole(both)), b"a;\n  b;\n  c;\n  d;");
        let first = TextRange::new(at(b"a;"), d.start);
        assert_eq!(file.text(outline.in_whole(first)), b"a;");
        assert_eq!(
            [at(b"a;"), at(b"b;"), at(b"c;"), at(b"d;")].map(|o| outline.keeps(o)),
            [true, false, false, true]
        );
        assert_eq!(outline.tree.items.len(), 1);
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
