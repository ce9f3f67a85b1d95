//! The productions of data declarations, which stand in modules and in routines.

use super::ending::semicolon;
use super::expression::{expression, indices};
use super::input::{Read, Text};
use super::lexical::{any_word, becomes, blank, name, placeholder};
use super::tree::{DataDecl, DataKind, Scope};
use super::word::Word;
use crate::diagnostic::TextRange;
use nom::Parser;
use nom::branch::alt;
use nom::sequence::preceded;

/// `scope = [ "LOCAL" | "TASK" ] ;`
pub(super) fn scope<'a>(i: Text<'a>) -> (Text<'a>, Scope) {
    match any_word(i) {
        Some((rest, Word::Local)) => (rest, Scope::Local),
        None if is_task_declaration(i) => name(i).map_or((i, Scope::Global), |(rest, _)| (rest, Scope::Task)),
        _ => (i, Scope::Global),
    }
}

/// `TASK` before PERS, VAR or CONST: no reserved word of its own, but nothing else begins so.
pub(super) fn is_task_declaration(i: Text<'_>) -> bool {
    let i = blank(i);
    if !matches!(i.peek(), Some(b't' | b'T')) {
        return false;
    }
    match name(i) {
        Ok((rest, _)) if i.bytes_until(rest).eq_ignore_ascii_case(b"task") => {
            matches!(any_word(rest), Some((_, Word::Pers | Word::Var | Word::Const)))
        }
        _ => false,
    }
}

/// `data_declaration = scope ( "CONST" | "VAR" | "PERS" ) declared_name declared_name [ indices ] [ becomes expression ] ";" ;`
///
/// Its type, then its own name.
pub(super) fn data_declaration<'a>(i: Text<'a>) -> Read<'a, DataDecl> {
    let start = blank(i);
    let (rest, scope) = scope(start);
    let (rest, kind) = match any_word(rest) {
        Some((rest, Word::Const)) => (rest, DataKind::Const),
        Some((rest, Word::Var)) => (rest, DataKind::Var),
        Some((rest, Word::Pers)) => (rest, DataKind::Pers),
        _ => return rest.no_match(),
    };
    let (rest, type_name) = declared_name(rest)?;
    let (rest, name) = declared_name(rest)?;
    let (rest, name) = name_with_parentheses(rest, name);
    let (rest, dims) = match blank(rest).peek() {
        Some(b'{') => indices(rest)?,
        _ => (rest, Box::default()),
    };
    let (rest, init) = match blank(rest).peek() {
        Some(b':') => {
            let (rest, value) = preceded(becomes, expression).parse(rest)?;
            (rest, Some(value))
        }
        _ => (rest, None),
    };
    let (rest, range) = semicolon(start, rest)?;
    Ok((rest, DataDecl { range, scope, kind, type_name, name, dims, init }))
}

/// `declared_name = name | placeholder ;`
pub(super) fn declared_name<'a>(i: Text<'a>) -> Read<'a, TextRange> {
    let i = blank(i);
    alt((name, placeholder)).parse(i)
}

/// RoboDK may declare `Gripper(Closed)`: the parentheses then belong to the name, which no controller takes.
fn name_with_parentheses<'a>(rest: Text<'a>, name: TextRange) -> (Text<'a>, TextRange) {
    if rest.peek() != Some(b'(') {
        return (rest, name);
    }
    let close = rest.rest.iter().position(|b| matches!(b, b')' | b';' | b'"' | b'\n' | b'\r'));
    let end = rest.skip(close.map_or(0, |n| n + 1));
    match (close.and_then(|n| rest.peek_at(n)), blank(end).peek()) {
        (Some(b')'), Some(b':' | b';' | b'{')) => {
            let whole = name.cover(rest.until(end));
            rest.state.warn(whole, "syntax::name", "no name has parentheses; no controller loads this");
            (end, whole)
        }
        _ => (rest, name),
    }
}
