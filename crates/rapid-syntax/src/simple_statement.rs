//! The productions of simple statements: those that end in a semicolon.

use super::ending::{Ending, end_of, terminated, warn_unless_terminated};
use super::expression::{argument, arguments, expression, variable};
use super::input::{NoMatch, Read, Text, failure_at};
use super::lexical::{
    FirstWord, any_word, becomes, begins_name, blank, line_ends_before, name, placeholder, sign, word,
};
use super::recover::{begins_anew, element_end};
use super::tree::{Arg, ArgKind, AssignStmt, CallStmt, Callee, ConnectStmt, Expr, ExprKind, Stmt, StmtKind};
use super::word::Word;
use nom::Parser;
use nom::sequence::preceded;

/// `simple_statement = label | placeholder [ ";" ] | ( assignment | call | return_statement | raise_statement | goto_statement | connect_statement | "RETRY" | "TRYNEXT" | "EXIT" | ? nothing ? ) ";" ;`
pub(super) fn simple_statement<'a>(i: Text<'a>, first: FirstWord<'a>) -> Read<'a, Stmt> {
    let Some((after, first)) = first else {
        return match i.peek() {
            Some(b';') => Ok((i.skip(1), Stmt { range: i.until(i.skip(1)), kind: StmtKind::Empty })),
            Some(b'%') => call(i),
            Some(b'<') => {
                let (rest, _) = placeholder(i)?;
                let rest = sign(b';')(rest).map_or(rest, |(rest, ())| rest);
                Ok((rest, Stmt { range: i.until(rest), kind: StmtKind::Placeholder }))
            }
            Some(b) if begins_name(b) => named_statement(i),
            _ => i.no_match(),
        };
    };
    let (rest, kind) = match first {
        Word::Return => return_statement(i)?,
        Word::Raise => raise_statement(i)?,
        Word::Goto => goto_statement(i)?,
        Word::Connect => connect_statement(i)?,
        Word::Retry => (after, StmtKind::Retry),
        Word::TryNext => (after, StmtKind::TryNext),
        Word::Exit => (after, StmtKind::Exit),
        _ => return i.no_match(),
    };
    terminated(i, rest, kind)
}

/// A label, an assignment or a call: what follows the name tells.
fn named_statement<'a>(i: Text<'a>) -> Read<'a, Stmt> {
    let (after, _) = name(i)?;
    let next = blank(after);
    match next.rest {
        [b':', b'=', ..] => assignment(i),
        [b':', ..] => match becomes(next) {
            Ok(_) => assignment(i),
            Err(_) => label(i),
        },
        [b'{', ..] => assignment(i),
        [b'.', ..] if blank(next.skip(1)).peek().is_some_and(begins_name) => assignment(i),
        _ => call(i),
    }
}

/// `label = name ":" ;`
fn label<'a>(i: Text<'a>) -> Read<'a, Stmt> {
    let (rest, range) = name(i)?;
    let (rest, ()) = sign(b':')(rest)?;
    Ok((rest, Stmt { range: i.until(rest), kind: StmtKind::Label(range) }))
}

/// `assignment = variable becomes expression ;`
fn assignment<'a>(i: Text<'a>) -> Read<'a, Stmt> {
    let (rest, (target, (), value)) = (variable, becomes, expression).parse(i)?;
    terminated(i, rest, StmtKind::Assign(Box::new(AssignStmt { target, value })))
}

/// `return_statement = "RETURN" [ expression ] ;`
fn return_statement<'a>(i: Text<'a>) -> Read<'a, StmtKind> {
    let (rest, _) = word(Word::Return)(i)?;
    let (rest, value) = value_on_line(rest)?;
    Ok((rest, StmtKind::Return(value)))
}

/// `raise_statement = "RAISE" [ expression ] ;`
fn raise_statement<'a>(i: Text<'a>) -> Read<'a, StmtKind> {
    let (rest, _) = word(Word::Raise)(i)?;
    let (rest, value) = value_on_line(rest)?;
    Ok((rest, StmtKind::Raise(value)))
}

/// The value of RETURN or RAISE; what begins anew on the next line is none.
fn value_on_line<'a>(i: Text<'a>) -> Read<'a, Option<Box<Expr>>> {
    let next = blank(i);
    let none = match next.peek() {
        None | Some(b';') => true,
        _ => {
            (line_ends_before(i, next) && begins_anew(next))
                || any_word(next).is_some_and(|(_, w)| !w.inside_statement())
        }
    };
    if none {
        return Ok((i, None));
    }
    let (rest, value) = expression(next)?;
    Ok((rest, Some(Box::new(value))))
}

/// `goto_statement = "GOTO" name ;`
fn goto_statement<'a>(i: Text<'a>) -> Read<'a, StmtKind> {
    let (rest, target) = preceded(word(Word::Goto), name).parse(i)?;
    Ok((rest, StmtKind::Goto(target)))
}

/// `connect_statement = "CONNECT" variable "WITH" name ;`
fn connect_statement<'a>(i: Text<'a>) -> Read<'a, StmtKind> {
    let (rest, (_, interrupt, _, trap)) = (word(Word::Connect), variable, word(Word::With), name).parse(i)?;
    Ok((rest, StmtKind::Connect(Box::new(ConnectStmt { interrupt, trap }))))
}

/// `call = ( name | late_name ) [ arguments ] ;`
///
/// Also what RoboDK writes and no controller takes: all arguments in parentheses, no semicolon.
fn call<'a>(i: Text<'a>) -> Read<'a, Stmt> {
    let (after, callee) = if i.peek() == Some(b'%') {
        let (after, name) = late_name(i)?;
        (after, Callee::Late(Box::new(name)))
    } else {
        let (after, name) = name(i)?;
        (after, Callee::Name(name))
    };
    let next = blank(after);
    if next.peek() == Some(b';') {
        let kind =
            StmtKind::Call(CallStmt { callee, args: Box::default(), parenthesised: false, terminated: true });
        return Ok((next.skip(1), Stmt { range: i.until(next.skip(1)), kind }));
    }
    let (rest, args, parenthesised) = match ended_arguments(after) {
        Ok((rest, args)) => (rest, args, false),
        Err(failure) => match parenthesised_arguments(next) {
            Ok((rest, args)) => (rest, args, true),
            Err(_) if stands_alone(after, next, &failure) => (after, Box::default(), false),
            Err(_) => return Err(failure),
        },
    };
    finish_call(i, rest, CallStmt { callee, args, parenthesised, terminated: true })
}

/// Whether a procedure's name is a whole statement without its semicolon, what follows being no arguments.
fn stands_alone(after: Text<'_>, next: Text<'_>, failure: &nom::Err<NoMatch>) -> bool {
    let read = failure_at(failure).saturating_sub(after.at()) as usize;
    end_of(after).is_some() && (next.is_empty() || after.state.may_read_again(read))
}

fn finish_call<'a>(start: Text<'a>, rest: Text<'a>, mut call: CallStmt) -> Read<'a, Stmt> {
    let Some(ending) = end_of(rest) else { return blank(rest).no_match() };
    call.terminated = matches!(ending, Ending::Semicolon(_));
    let end = ending.after(rest);
    let range = start.until(end);
    if call.parenthesised {
        let message = "the arguments of this procedure stand with parentheses; no controller loads this";
        start.state.warn(range, "syntax::parentheses", message);
    }
    warn_unless_terminated(start, range, &ending);
    Ok((end, Stmt { range, kind: StmtKind::Call(call) }))
}

/// Arguments that the end of a statement follows.
fn ended_arguments<'a>(i: Text<'a>) -> Read<'a, Box<[Arg]>> {
    let (rest, args) = arguments(i)?;
    match end_of(rest) {
        Some(_) => Ok((rest, args)),
        None => blank(rest).no_match(),
    }
}

/// `(a,b)` or `()` after a procedure's name; what is no argument there becomes an opaque one.
fn parenthesised_arguments<'a>(i: Text<'a>) -> Read<'a, Box<[Arg]>> {
    let (mut i, ()) = sign(b'(')(i)?;
    let mut args = Vec::new();
    if let Ok((rest, ())) = sign(b')')(i) {
        return Ok((rest, Box::default()));
    }
    loop {
        let start = blank(i);
        let (rest, arg) = match argument(start) {
            Ok((rest, arg)) if matches!(blank(rest).peek(), Some(b',' | b')' | b'\\')) => (rest, arg),
            _ => {
                let end = element_end(start);
                let range = start.until(end);
                if range.is_empty() {
                    return start.no_match();
                }
                (end, Arg { range, kind: ArgKind::Positional(Expr { range, kind: ExprKind::Opaque }) })
            }
        };
        args.push(arg);
        let next = blank(rest);
        i = match next.peek() {
            Some(b',') => next.skip(1),
            Some(b'\\') => next,
            Some(b')') => return Ok((next.skip(1), args.into_boxed_slice())),
            _ => return next.no_match(),
        };
    }
}

/// `late_name = "%" expression "%" ;`
fn late_name<'a>(i: Text<'a>) -> Read<'a, Expr> {
    let (rest, ((), name, ())) = (sign(b'%'), expression, sign(b'%')).parse(i)?;
    Ok((rest, name))
}
