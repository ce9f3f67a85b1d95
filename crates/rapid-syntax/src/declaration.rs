//! The productions of records, aliases, routines and their parameters.

use super::block::block;
use super::data::{declared_name, scope};
use super::ending::semicolon;
use super::expression::expression;
use super::input::{Read, Text};
use super::lexical::{any_word, blank, line_len, name, placeholder, sign, word};
use super::tree::{AliasDecl, Handler, HandlerKind, Param, ParamMode, RecordDecl, Routine, RoutineKind};
use super::word::Word;
use crate::diagnostic::TextRange;
use nom::Parser;
use nom::combinator::opt;
use nom::multi::separated_list1;
use nom::sequence::delimited;

/// `record_declaration = scope "RECORD" name { name name ";" } "ENDRECORD" ;`
pub(super) fn record_declaration<'a>(i: Text<'a>) -> Read<'a, RecordDecl> {
    let start = blank(i);
    let (rest, scope) = scope(start);
    let (mut rest, (_, own_name)) = (word(Word::Record), name).parse(rest)?;
    let mut components = Vec::new();
    loop {
        if let Ok((rest, _)) = word(Word::EndRecord)(rest) {
            return Ok((rest, RecordDecl { range: start.until(rest), scope, name: own_name, components }));
        }
        let (after, (type_name, component, ())) = (name, name, sign(b';')).parse(rest)?;
        components.push((type_name, component));
        rest = after;
    }
}

/// `alias_declaration = scope "ALIAS" name name ";" ;`
pub(super) fn alias_declaration<'a>(i: Text<'a>) -> Read<'a, AliasDecl> {
    let start = blank(i);
    let (rest, scope) = scope(start);
    let (rest, (_, type_name, name)) = (word(Word::Alias), name, name).parse(rest)?;
    let (rest, range) = semicolon(start, rest)?;
    Ok((rest, AliasDecl { range, scope, type_name, name }))
}

/// `routine = scope ( "PROC" declared_name parameters | "FUNC" name declared_name parameters | "TRAP" declared_name ) block { handler } ( "ENDPROC" | "ENDFUNC" | "ENDTRAP" ) ;`
pub(super) fn routine<'a>(i: Text<'a>) -> Read<'a, Routine> {
    let start = blank(i);
    let (rest, scope) = scope(start);
    let (rest, kind, end_word) = match any_word(rest) {
        Some((rest, Word::Proc)) => (rest, RoutineKind::Proc, Word::EndProc),
        Some((rest, Word::Func)) => {
            let (rest, value) = name(rest)?;
            (rest, RoutineKind::Func(value), Word::EndFunc)
        }
        Some((rest, Word::Trap)) => (rest, RoutineKind::Trap, Word::EndTrap),
        _ => return rest.no_match(),
    };
    let (rest, name) = declared_name(rest)?;
    let (rest, params) = match blank(rest).peek() {
        Some(b'(') => parameters(rest)?,
        _ => {
            if kind != RoutineKind::Trap {
                start.state.warn(
                    start.until(rest),
                    "syntax::parameters",
                    "the routine has no parameter list, not even ()",
                );
            }
            (rest, Vec::new())
        }
    };
    let head = start.until(rest);
    let (mut rest, body) = block(rest);
    let mut handlers = Vec::new();
    while let Some((after, handler)) = handler(rest) {
        handlers.push(handler);
        rest = after;
    }
    let (rest, end) = routine_end(rest, head, end_word);
    Ok((rest, Routine { range: start.until(rest), head, scope, kind, name, params, body, handlers, end }))
}

fn routine_end<'a>(i: Text<'a>, head: TextRange, expected: Word) -> (Text<'a>, Option<TextRange>) {
    match any_word(i) {
        Some((rest, found @ (Word::EndProc | Word::EndFunc | Word::EndTrap))) => {
            let range = blank(i).until(rest);
            if found != expected {
                i.state.warn(range, "syntax::end", "this END word does not fit the routine's first word");
            }
            (rest, Some(range))
        }
        _ => {
            i.state.warn(head, "syntax::end", "the routine that begins here has no END word");
            (i, None)
        }
    }
}

/// `handler = ( "BACKWARD" | "ERROR" [ "(" expression { "," expression } ")" ] | "UNDO" ) block ;`
fn handler<'a>(i: Text<'a>) -> Option<(Text<'a>, Handler)> {
    let start = blank(i);
    let (rest, kind) = match any_word(start)? {
        (rest, Word::Backward) => (rest, HandlerKind::Backward),
        (rest, Word::Undo) => (rest, HandlerKind::Undo),
        (rest, Word::Error) => {
            let numbers = delimited(sign(b'('), separated_list1(sign(b','), expression), sign(b')'));
            let (rest, numbers) = opt(numbers).parse(rest).unwrap_or((rest, None));
            (rest, HandlerKind::Error(numbers.unwrap_or_default()))
        }
        _ => return None,
    };
    let (rest, body) = block(rest);
    Some((rest, Handler { range: start.until(rest), kind, body }))
}

/// `parameters = "(" [ [ "," ] parameter { ( "," | "|" | ? nothing ? ) parameter } ] ")" ;`
///
/// The comma before an optional parameter may be left out.
fn parameters<'a>(i: Text<'a>) -> Read<'a, Vec<Param>> {
    let (mut i, ()) = sign(b'(')(i)?;
    let mut params: Vec<Param> = Vec::new();
    let mut alternative = false;
    loop {
        let next = blank(i);
        match next.peek() {
            Some(b')') => return Ok((next.skip(1), params)),
            Some(b',') => i = next.skip(1),
            Some(b'|') => {
                alternative = true;
                i = next.skip(1);
            }
            _ => {
                let (rest, mut param) = parameter(next)?;
                param.alternative = std::mem::take(&mut alternative);
                param.optional |= param.alternative && params.last().is_some_and(|p| p.optional);
                params.push(param);
                i = rest;
            }
        }
    }
}

/// `parameter = [ "\" ] ( "switch" name | [ "VAR" | "PERS" | "INOUT" ] name name [ "{" "*" { "," "*" } "}" ] ) ;`
fn parameter<'a>(i: Text<'a>) -> Read<'a, Param> {
    let start = blank(i);
    if let Ok((rest, range)) = placeholder(start) {
        return Ok((
            rest,
            Param {
                range,
                optional: false,
                alternative: false,
                mode: ParamMode::In,
                type_name: range,
                name: range,
                dims: 0,
            },
        ));
    }
    let (rest, backslash) = opt(sign(b'\\')).parse(start)?;
    let (rest, mode) = match any_word(rest) {
        Some((rest, Word::Var)) => (rest, ParamMode::Var),
        Some((rest, Word::Pers)) => (rest, ParamMode::Pers),
        Some((rest, Word::InOut)) => (rest, ParamMode::InOut),
        _ => (rest, ParamMode::In),
    };
    let (rest, (type_name, name)) = (name, name).parse(rest)?;
    let (rest, dims) = match blank(rest).peek() {
        Some(b'{') => dimensions(rest)?,
        _ => (rest, 0),
    };
    let optional = backslash.is_some();
    Ok((rest, Param { range: start.until(rest), optional, alternative: false, mode, type_name, name, dims }))
}

fn dimensions<'a>(i: Text<'a>) -> Read<'a, u8> {
    let stars = separated_list1(sign(b','), sign(b'*'));
    let (rest, stars) = delimited(sign(b'{'), stars, sign(b'}')).parse(i)?;
    Ok((rest, u8::try_from(stars.len()).unwrap_or(u8::MAX)))
}

/// The end of a record or routine that begins at `start` and cannot be read: at its END word where one
/// follows before another declaration.
pub(super) fn broken_record_end<'a>(start: Text<'a>) -> Option<Text<'a>> {
    let (mut i, _) = any_word(scope(start).0).filter(|(_, w)| *w == Word::Record)?;
    while !i.is_empty() {
        match any_word(i) {
            Some((rest, Word::EndRecord)) => return Some(rest),
            Some((_, w)) if w.ends_statements() || matches!(w, Word::Var | Word::Const | Word::Pers) => {
                return None;
            }
            _ => i = i.skip(line_len(i.rest) + 1),
        }
    }
    None
}
