//! The outline of a file: its text without the inner motions of long runs, enough to understand other files by.
//!
//! Left out is what tells other files nothing: of moves that follow one another directly, and that name nothing that the
//! text before them does not name, all but the first and the last. What is in force before and behind such a run, which names are
//! taken, what is declared and which routines there are can be read in the outline as in the file. Where the arm stands cannot:
//! that must be known from the file itself.

use super::index::inner_bodies;
use super::instructions::{Special, move_form};
use super::names::lower_case;
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{
    ArgKind, CallStmt, Callee, Expr, ExprKind, FileItem, Routine, Stmt, StmtKind, UnaryOp,
};
use std::collections::BTreeSet;

/// The outline of a file whose tree is whole.
pub(super) fn outline(file: &SourceFile) -> SourceFile {
    let mut work = Work { file, seen: BTreeSet::new(), cuts: Vec::new() };
    for routine in routines(file) {
        work.list(&routine.body);
        routine.handlers.iter().for_each(|handler| work.list(&handler.body));
    }
    file.without(&work.cuts)
}

/// Whether a routine of the file bears the name of a move instruction: what looks like a move is then a call.
pub(super) fn shadows_a_move(file: &SourceFile) -> bool {
    routines(file).any(|routine| move_form(&lower_case(file.text(routine.name))).is_some())
}

fn routines(file: &SourceFile) -> impl Iterator<Item = &Routine> {
    let modules = file.tree.items.iter().filter_map(|item| match item {
        FileItem::Module(module) => Some(module),
        FileItem::Comment(_) | FileItem::Opaque(_) => None,
    });
    modules.flat_map(|module| module.routines())
}

struct Work<'a> {
    file: &'a SourceFile,
    /// Words, in lower case, of the moves that are left since there was something else: what they name is the same since.
    seen: BTreeSet<Vec<u8>>,
    cuts: Vec<TextRange>,
}

/// Moves that follow one another.
#[derive(Clone, Copy)]
struct Run {
    /// End of the first.
    from: u32,
    /// The last so far, where it is another.
    last: Option<TextRange>,
}

impl Work<'_> {
    fn list(&mut self, body: &[Stmt]) {
        let mut run: Option<Run> = None;
        for stmt in body {
            match &stmt.kind {
                StmtKind::Comment | StmtKind::Empty => continue,
                StmtKind::Call(call) if self.is_plain_move(call) => {
                    run = Some(self.next(run, stmt.range));
                    continue;
                }
                _ => {}
            }
            self.close(run.take());
            self.seen.clear();
            inner_bodies(stmt).into_iter().for_each(|body| self.list(body));
        }
        self.close(run);
        self.seen.clear();
    }

    /// One move more: it goes on with the run where it, and what stands before it, names nothing new.
    fn next(&mut self, run: Option<Run>, range: TextRange) -> Run {
        if let Some(run) = run {
            let since = run.last.map_or(run.from, |last| last.end);
            let mut known = true;
            words(self.file.text(TextRange::new(since, range.end)), |word| known &= self.seen.contains(word));
            if known {
                return Run { last: Some(range), ..run };
            }
        }
        self.close(run);
        let Self { file, seen, .. } = self;
        words(file.text(range), |word| {
            seen.insert(word.to_vec());
        });
        Run { from: range.end, last: None }
    }

    fn close(&mut self, run: Option<Run>) {
        if let Some(Run { from, last: Some(last) }) = run {
            // The blanks before the last one stay: what is left are lines.
            let text = self.file.text(TextRange::new(from, last.start));
            let blanks = text.iter().rev().take_while(|b| b.is_ascii_whitespace()).count() as u32;
            let cut = TextRange::new(from, last.start - blanks);
            // Of moves in one line nothing is left out: columns stay what they are.
            let begins_line = text.iter().rev().take(blanks as usize).any(|b| matches!(b, b'\n' | b'\r'));
            if !cut.is_empty() && begins_line {
                self.cuts.push(cut);
            }
        }
    }

    /// Whether a call is a move that does nothing but move: no function, no array, nothing handed on.
    fn is_plain_move(&self, call: &CallStmt) -> bool {
        let Callee::Name(name) = call.callee else { return false };
        let form = move_form(&lower_case(self.file.text(name)));
        let plain = |expr: Option<&Expr>| expr.is_none_or(is_plain);
        form.is_some_and(|form| form.special == Special::Plain)
            && call.terminated
            && !call.parenthesised
            && call.args.iter().all(|arg| match &arg.kind {
                ArgKind::Positional(expr) => plain(Some(expr)),
                ArgKind::Named { value, .. } => plain(value.as_ref()),
                ArgKind::Conditional { .. } => false,
            })
    }
}

fn is_plain(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Number | ExprKind::Numbers | ExprKind::String | ExprKind::Bool(_) | ExprKind::Name => true,
        ExprKind::Aggregate(parts) => parts.iter().all(is_plain),
        ExprKind::Unary { op: UnaryOp::Neg | UnaryOp::Plus, operand } => operand.kind == ExprKind::Number,
        _ => false,
    }
}

/// Calls `see` with every word, in lower case, those of comments and strings too; numbers are none.
fn words(text: &[u8], mut see: impl FnMut(&[u8])) {
    let part = |b: &u8| b.is_ascii_alphanumeric() || *b == b'_' || *b >= 0x80;
    let mut lower = Vec::new();
    for word in text.split(|b| !part(b)).filter(|word| word.first().is_some_and(|b| !b.is_ascii_digit())) {
        lower.clear();
        lower.extend(word.iter().map(u8::to_ascii_lowercase));
        see(&lower);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rapid_syntax::diagnostic::FileId;

    fn outlined(body: &str) -> String {
        let text = format!("MODULE m\nPROC p()\n{body}ENDPROC\nENDMODULE\n");
        let outline = outline(&SourceFile::read(FileId(0), "m.mod", text.into_bytes()));
        let text = String::from_utf8(outline.bytes.to_vec()).unwrap();
        text.trim_start_matches("MODULE m\nPROC p()\n").trim_end_matches("ENDPROC\nENDMODULE\n").to_owned()
    }

    #[test]
    fn of_a_run_of_moves_the_first_and_the_last_are_left() {
        let moves = "MoveL [1],v5,z1,t;\nMoveL [2],v5,z1,t;\nMOVEL [3],V5,z1,t;\nMoveL [4],v5,z1,t;\n";
        assert_eq!(outlined(moves), "MoveL [1],v5,z1,t;\nMoveL [4],v5,z1,t;\n");
        let two = "MoveL [1],v5,z1,t;\nMoveL [2],v5,z1,t;\n";
        assert_eq!(outlined(two), two);
    }

    #[test]
    fn what_names_something_new_or_does_more_than_move_is_left() {
        for kept in [
            "MoveL [2],v6,z1,t;\n",
            "! a word\nMoveL [2],v5,z1,t;\n",
            "MoveL Offs([2],1,1,1),v5,z1,t;\n",
            "MoveL p{1},v5,z1,t;\n",
            "Set do1;\n",
            "SearchL di1,[2],[3],v5,t;\n",
            "again:\n",
        ] {
            let text = format!("MoveL [1],v5,z1,t;\n{kept}MoveL [9],v5,z1,t;\n");
            assert_eq!(outlined(&text), text);
        }
        let in_line = "MoveL [1],v5,z1,t; MoveL [2],v5,z1,t; MoveL [3],v5,z1,t;\n";
        assert_eq!(outlined(in_line), in_line);
        let renamed = "MoveL [1],v5,z1,t;\nMoveL [2],v6,z1,t;\nt:=u;\nMoveL [3],v5,z1,t;\nMoveL [4],v6,z1,t;\nMoveL [5],v5,z1,t;\n";
        assert_eq!(outlined(renamed), renamed, "behind an assignment a name may mean something else");
        let numbers = "MoveL [1],v5,z1,t;\n! 12.5\nMoveL [2],v5,z1,t;\nMoveL [9],v5,z1,t;\n";
        assert_eq!(outlined(numbers), "MoveL [1],v5,z1,t;\nMoveL [9],v5,z1,t;\n");
        let inside =
            "FOR i FROM 1 TO 9 DO\nMoveL [1],v5,z1,t;\nMoveL [2],v5,z1,t;\nMoveL [3],v5,z1,t;\nENDFOR\n";
        assert_eq!(outlined(inside).matches("MoveL").count(), 2);
    }

    #[test]
    fn a_routine_with_the_name_of_a_move_is_found() {
        let file = |name: &str| {
            let text = format!("MODULE m\nPROC {name}(num x)\nENDPROC\nENDMODULE\n");
            SourceFile::read(FileId(0), "m.mod", text.into_bytes())
        };
        assert!(shadows_a_move(&file("MOVEL")) && !shadows_a_move(&file("MoveLeft")));
    }
}
