//! How a statement or declaration goes to its end: with its semicolon, or without it, which is said.

use super::input::{Read, Text};
use super::lexical::{any_word, blank, line_ends_before};
use super::recover::begins_anew;
use super::tree::{Stmt, StmtKind};
use crate::diagnostic::TextRange;

/// How a statement goes to its end.
#[derive(Clone, Copy, Debug)]
pub(super) enum Ending<'a> {
    /// With its semicolon; what follows it.
    Semicolon(Text<'a>),
    /// Without: the next line begins anew, or the text ends.
    Missing,
}

impl<'a> Ending<'a> {
    /// What follows the statement whose last part ends where `rest` begins.
    pub(super) fn after(self, rest: Text<'a>) -> Text<'a> {
        match self {
            Self::Semicolon(after) => after,
            Self::Missing => rest,
        }
    }
}

/// How a statement whose last part ends where `rest` begins goes to its end.
pub(super) fn end_of<'a>(rest: Text<'a>) -> Option<Ending<'a>> {
    let next = blank(rest);
    match next.peek() {
        Some(b';') => Some(Ending::Semicolon(next.skip(1))),
        None => Some(Ending::Missing),
        Some(_) if line_ends_before(rest, next) && begins_anew(next) => Some(Ending::Missing),
        Some(_) => any_word(next).filter(|(_, w)| !w.inside_statement()).map(|_| Ending::Missing),
    }
}

pub(super) fn warn_unless_terminated(at: Text<'_>, range: TextRange, ending: &Ending<'_>) {
    if matches!(ending, Ending::Missing) {
        at.state.warn(
            range,
            "syntax::semicolon",
            "this statement has no semicolon at its end; no controller loads this",
        );
    }
}

/// The statement from `start` whose last part ends where `rest` begins: with its semicolon, or without
/// it, which is said.
pub(super) fn terminated<'a>(start: Text<'a>, rest: Text<'a>, kind: StmtKind) -> Read<'a, Stmt> {
    let Some(ending) = end_of(rest) else { return blank(rest).no_match() };
    let end = ending.after(rest);
    let range = start.until(end);
    warn_unless_terminated(start, range, &ending);
    Ok((end, Stmt { range, kind }))
}

/// Past the semicolon of a declaration from `start`, which may lack it like a statement.
pub(super) fn semicolon<'a>(start: Text<'a>, rest: Text<'a>) -> Read<'a, TextRange> {
    let (rest, stmt) = terminated(start, rest, StmtKind::Empty)?;
    Ok((rest, stmt.range))
}
