//! A file as read: its name, its bytes, where its lines begin, and its tree.

use super::parse::parse;
use super::tree::{FileItem, ModuleItem, Stmt, StmtKind, Tree};
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
    /// What was read out of it; of a routine's statements only those that declare after [`keep_declarations`](Self::keep_declarations).
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

    /// Lets go of all statements but those that declare data, loop variables and labels, and those round them: the moves of a large
    /// program take several times the text's room, and once they are known only names are still asked for.
    pub fn keep_declarations(&mut self) {
        for item in &mut self.tree.items {
            let FileItem::Module(module) = item else { continue };
            for item in &mut module.items {
                if let ModuleItem::Routine(routine) = item {
                    keep_declaring(&mut routine.body);
                    routine.handlers.iter_mut().for_each(|handler| keep_declaring(&mut handler.body));
                }
            }
        }
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

/// Keeps the statements of a body that declare something, or hold one that does.
fn keep_declaring(body: &mut Vec<Stmt>) {
    body.retain_mut(declares);
    body.shrink_to_fit();
}

/// Whether a statement declares something itself or in what is kept of its bodies.
fn declares(stmt: &mut Stmt) -> bool {
    let holds = |body: &mut Vec<Stmt>| {
        keep_declaring(body);
        !body.is_empty()
    };
    match &mut stmt.kind {
        StmtKind::Data(_) | StmtKind::Label(_) => true,
        StmtKind::For(looped) => {
            keep_declaring(&mut looped.body);
            true
        }
        StmtKind::While(looped) => holds(&mut looped.body),
        StmtKind::CompactIf(branch) => declares(&mut branch.then),
        StmtKind::If(branch) => {
            let bodies = branch.arms.iter_mut().map(|(_, body)| body).chain(&mut branch.otherwise);
            bodies.map(holds).max() == Some(true) // each of them is shortened
        }
        StmtKind::Test(test) => {
            let bodies = test.cases.iter_mut().map(|(_, body)| body).chain(&mut test.default);
            bodies.map(holds).max() == Some(true) // each of them is shortened
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_statements_those_are_kept_that_declare() {
        let text = "MODULE m\n PROC main()\n VAR num n;\n MoveL p,v100,fine,t;\n IF a THEN\n MoveL p,v100,fine,t;\n ELSE\n \
            FOR i FROM 1 TO 2 DO\n n:=i;\n ENDFOR\n ENDIF\n IF b THEN\n Stop;\n ENDIF\n TEST n\n CASE 1:\n Stop;\n DEFAULT:\n \
            again:\n ENDTEST\n ERROR\n RETRY;\n ENDPROC\nENDMODULE\n";
        let mut file = SourceFile::read(FileId(0), "m.mod", text.as_bytes().to_vec());
        let routine = |tree: &Tree| match tree.items.as_slice() {
            [FileItem::Module(module)] => module.routines().next().cloned(),
            _ => None,
        };
        let whole = routine(&file.tree).unwrap();
        file.keep_declarations();
        let kept = routine(&file.tree).unwrap();
        assert_eq!((whole.body.len(), whole.handlers[0].body.len()), (5, 1));
        assert_eq!((kept.range, kept.handlers.len(), kept.handlers[0].body.len()), (whole.range, 1, 0));
        let [data, branch, test] = kept.body.as_slice() else { panic!("{:?}", kept.body) };
        assert_eq!(data, &whole.body[0]);
        let StmtKind::If(branch) = &branch.kind else { panic!() };
        let looped = branch.otherwise.as_deref().unwrap();
        assert!(branch.arms[0].1.is_empty());
        assert!(matches!(&looped[0].kind, StmtKind::For(looped) if looped.body.is_empty()));
        let StmtKind::Test(test) = &test.kind else { panic!() };
        let default = test.default.as_deref().unwrap();
        assert!(test.cases[0].1.is_empty() && matches!(default[0].kind, StmtKind::Label(_)));
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
