//! The productions of expressions and arguments.

use super::input::{MAX_HEIGHT, MAX_NESTING, ParseState, Read, Text};
use super::lexical::{
    any_word, becomes, begins_name, blank, identifier, name, number, placeholder, sign, string,
};
use super::numbers::is_plain;
use super::operator::{COMPARISON, CONJUNCTION, binding, operator};
use super::plain_list::{self, PlainList, PlainPart};
use super::recover::balanced;
use super::tree::{Arg, ArgKind, BinaryExpr, CallExpr, Expr, ExprKind, FieldExpr, IndexExpr, UnaryOp};
use super::word::Word;
use crate::diagnostic::TextRange;

/// `expression = operand { operator operand } ;`
///
/// Operators bind as [`binding`] says, equal ones from the left. Nested deeper than is read, a bracketed
/// expression becomes one opaque node.
#[inline]
pub(super) fn expression<'a>(i: Text<'a>) -> Read<'a, Expr> {
    let i = blank(i);
    let (rest, operand) = match i.peek() {
        Some(b'0'..=b'9') => leaf(number(i), ExprKind::Number)?, // most of all expressions: a number in a list
        Some(b'-') => unary(i, i.skip(1), UnaryOp::Neg, 0)?,
        Some(b'[') => match i.state.nested(|| aggregate(i)) {
            Some(read) => read?,
            None => return too_deep(i),
        },
        _ => return nested_expression(i),
    };
    match rest.peek() {
        Some(b',' | b']' | b';' | b')') => Ok((rest, operand)),
        _ => operations(rest, operand, 0),
    }
}

fn nested_expression<'a>(i: Text<'a>) -> Read<'a, Expr> {
    match i.state.nested(|| operand(i, 0).and_then(|(rest, lhs)| operations(rest, lhs, 0))) {
        Some(read) => read,
        None => too_deep(i),
    }
}

fn too_deep<'a>(i: Text<'a>) -> Read<'a, Expr> {
    match balanced(i) {
        Some(end) => {
            let range = i.until(end);
            let message = format!("nested more than {MAX_NESTING} deep; this part is kept unread");
            i.state.warn(range, "syntax::deep", message);
            i.state.height.set(0);
            Ok((end, Expr { range, kind: ExprKind::Opaque }))
        }
        None => i.no_match(),
    }
}

/// Reads on after `lhs` with every operator that binds at least as strongly as `least`.
fn operations<'a>(mut i: Text<'a>, mut lhs: Expr, least: u8) -> Read<'a, Expr> {
    while let Some((after, op)) = operator(i) {
        let strength = binding(op);
        if strength < least {
            break;
        }
        let state = i.state;
        let left_height = state.height.get();
        let (rest, rhs) = state
            .nested(|| {
                operand(after, strength + 1).and_then(|(rest, rhs)| operations(rest, rhs, strength + 1))
            })
            .unwrap_or_else(|| after.no_match())?;
        raise(rest, left_height.max(state.height.get()))?;
        i = rest;
        let range = lhs.range.cover(rhs.range);
        lhs = Expr { range, kind: ExprKind::Binary(Box::new(BinaryExpr { op, lhs, rhs })) };
    }
    Ok((i, lhs))
}

/// One level above parts of height `below`; a failure where the tree grows too high.
#[inline]
fn raise<'a>(i: Text<'a>, below: u16) -> Read<'a, ()> {
    if below >= MAX_HEIGHT {
        return i.no_match();
    }
    i.state.height.set(below + 1);
    Ok((i, ()))
}

/// `operand = [ "-" | "+" ] operand | "NOT" expression | primary ;`
///
/// NOT takes all with it that AND joins (`NOT a=1 AND b` is `NOT ((a=1) AND b)`: ABB's syntax summary has `[ NOT ] <logical term>`, and
/// their list of priorities has it last, with OR and XOR), behind an AND a comparison alone; signs take nothing. What stands beside it
/// binds at least as strongly as `least`.
#[inline]
fn operand<'a>(i: Text<'a>, least: u8) -> Read<'a, Expr> {
    let i = blank(i);
    match i.peek() {
        Some(b'-') => unary(i, i.skip(1), UnaryOp::Neg, least),
        Some(b'+') => unary(i, i.skip(1), UnaryOp::Plus, least),
        Some(b'n' | b'N') => match any_word(i) {
            Some((rest, Word::Not)) => unary(i, rest, UnaryOp::Not, least),
            _ => primary(i),
        },
        _ => primary(i),
    }
}

#[inline]
fn unary<'a>(start: Text<'a>, after: Text<'a>, op: UnaryOp, least: u8) -> Read<'a, Expr> {
    let (rest, inner) = match after.peek() {
        Some(b'0'..=b'9') => primary(after)?,
        _ => nested_operand(after, op, least)?,
    };
    raise(rest, start.state.height.get())?;
    let range = TextRange::new(start.at(), inner.range.end);
    Ok((rest, Expr { range, kind: ExprKind::Unary { op, operand: Box::new(inner) } }))
}

fn nested_operand<'a>(i: Text<'a>, op: UnaryOp, least: u8) -> Read<'a, Expr> {
    let read = i.state.nested(|| {
        let (rest, inner) = operand(i, least)?;
        if op == UnaryOp::Not {
            operations(rest, inner, least.clamp(CONJUNCTION, COMPARISON))
        } else {
            Ok((rest, inner))
        }
    });
    read.unwrap_or_else(|| i.no_match())
}

/// `primary = number | string | placeholder | aggregate | "(" expression ")" | reference ;`
#[inline]
fn primary<'a>(i: Text<'a>) -> Read<'a, Expr> {
    match i.peek() {
        Some(b'0'..=b'9' | b'.') => leaf(number(i), ExprKind::Number),
        Some(b'[') => aggregate(i),
        Some(b'"') => leaf(string(i), ExprKind::String),
        Some(b'(') => {
            let (rest, inner) = expression(i.skip(1))?;
            let (rest, ()) = sign(b')')(rest)?;
            raise(rest, i.state.height.get())?;
            Ok((rest, Expr { range: i.until(rest), kind: ExprKind::Paren(Box::new(inner)) }))
        }
        Some(b'<') => leaf(placeholder(i), ExprKind::Placeholder),
        Some(b) if begins_name(b) => reference(i),
        _ => i.no_match(),
    }
}

#[inline(always)]
fn leaf(read: Read<'_, TextRange>, kind: ExprKind) -> Read<'_, Expr> {
    let (rest, range) = read?;
    rest.state.height.set(0);
    Ok((rest, Expr { range, kind }))
}

/// `aggregate = "[" [ expression { "," expression } ] "]" ;`
pub(super) fn aggregate<'a>(i: Text<'a>) -> Read<'a, Expr> {
    if i.state.plain_forms
        && i.state.may_nest(plain_list::DEEPEST)
        && let Some(PlainList { len, height }) = PlainList::begins(i.rest)
    {
        let rest = i.skip(len);
        i.state.height.set(height);
        return Ok((rest, Expr { range: i.until(rest), kind: ExprKind::Numbers }));
    }
    any_aggregate(i)
}

/// As the production says, whatever the parts are.
pub(super) fn any_aggregate<'a>(i: Text<'a>) -> Read<'a, Expr> {
    let (rest, parts) = list(i.skip(1), b']')?;
    let range = i.until(rest);
    let plain = !parts.is_empty() && parts.iter().all(is_plain);
    if plain && memchr::memchr(b'!', i.bytes_until(rest)).is_none() {
        return Ok((rest, Expr { range, kind: ExprKind::Numbers }));
    }
    Ok((rest, Expr { range, kind: ExprKind::Aggregate(Box::new(parts)) }))
}

/// Expressions between commas up to the closing sign; leaves the height of the whole.
fn list<'a>(i: Text<'a>, close: u8) -> Read<'a, Box<[Expr]>> {
    let open = &i.state.parts;
    let own = open.borrow().len();
    let read = parts(i, close);
    let mut open = open.borrow_mut();
    match read {
        Ok((rest, ())) => Ok((rest, open.split_off(own).into_boxed_slice())),
        Err(failure) => {
            open.truncate(own);
            Err(failure)
        }
    }
}

/// The expressions of a [`list`], behind those of the lists around it.
fn parts<'a>(mut i: Text<'a>, close: u8) -> Read<'a, ()> {
    let mut height = 0;
    if let Ok((rest, ())) = sign(close)(i) {
        raise(rest, height)?;
        return Ok((rest, ()));
    }
    // A string that is nested too deep is left to the productions, which say so.
    let is_scanned = i.state.plain_forms && i.state.may_nest(1);
    loop {
        let plain = if is_scanned { PlainPart::begins(i.rest) } else { None };
        let rest = if let Some(part) = plain {
            let rest = i.skip(part.to);
            let range = i.skip(part.from).until(rest);
            if part.is_string {
                add_leaf::<true>(range, i.state);
            } else {
                add_leaf::<false>(range, i.state);
            }
            rest
        } else {
            let (rest, part) = expression(i)?;
            i.state.parts.borrow_mut().push(part);
            height = height.max(i.state.height.get());
            blank(rest)
        };
        match rest.peek() {
            Some(b',') => i = rest.skip(1),
            Some(b) if b == close => {
                let rest = rest.skip(1);
                raise(rest, height)?;
                return Ok((rest, ()));
            }
            _ => return rest.no_match(),
        }
    }
}

/// A string, or a number, among the parts of the list that is open.
///
/// Two functions, each with its kind known and the range in a register: a node that is put together in memory field by field makes the copy
/// of it wait.
#[inline(never)]
fn add_leaf<const STRING: bool>(range: TextRange, state: &ParseState) {
    let kind = if STRING { ExprKind::String } else { ExprKind::Number };
    state.parts.borrow_mut().push(Expr { range, kind });
}

/// `reference = ( "TRUE" | "FALSE" | name [ "(" [ arguments ] ")" ] ) { component | indices } ;`
fn reference<'a>(i: Text<'a>) -> Read<'a, Expr> {
    let (rest, range) = identifier(i)?;
    i.state.height.set(0);
    match Word::of(i.bytes_until(rest)) {
        Some(Word::True) => return Ok((rest, Expr { range, kind: ExprKind::Bool(true) })),
        Some(Word::False) => return Ok((rest, Expr { range, kind: ExprKind::Bool(false) })),
        Some(_) => return i.no_match(),
        None => {}
    }
    match blank(rest).peek() {
        Some(b'(') => {
            let (rest, args) = parenthesised(rest)?;
            let call = CallExpr { name: range, args };
            postfix(rest, Expr { range: i.until(rest), kind: ExprKind::Call(Box::new(call)) })
        }
        Some(b'.' | b'{') => postfix(rest, Expr { range, kind: ExprKind::Name }),
        _ => Ok((rest, Expr { range, kind: ExprKind::Name })),
    }
}

/// `variable = name { component | indices } ;`
pub(super) fn variable<'a>(i: Text<'a>) -> Read<'a, Expr> {
    let (rest, range) = name(i)?;
    i.state.height.set(0);
    postfix(rest, Expr { range, kind: ExprKind::Name })
}

fn postfix<'a>(mut i: Text<'a>, mut base: Expr) -> Read<'a, Expr> {
    loop {
        let height = i.state.height.get();
        let next = blank(i);
        let start = base.range.start;
        let (rest, kind) = match next.peek() {
            Some(b'.') => {
                let (rest, name) = component(next)?;
                i.state.height.set(height);
                (rest, ExprKind::Field(Box::new(FieldExpr { base, name })))
            }
            Some(b'{') => {
                let (rest, indices) = indices(next)?;
                (rest, ExprKind::Index(Box::new(IndexExpr { base, indices })))
            }
            _ => return Ok((i, base)),
        };
        raise(rest, height.max(i.state.height.get()))?;
        base = Expr { range: TextRange::new(start, rest.at()), kind };
        i = rest;
    }
}

/// `component = "." identifier ;`
fn component<'a>(i: Text<'a>) -> Read<'a, TextRange> {
    let (i, ()) = sign(b'.')(i)?;
    identifier(i)
}

/// `indices = "{" ( "*" { "," "*" } | expression { "," expression } ) "}" ;`
pub(super) fn indices<'a>(i: Text<'a>) -> Read<'a, Box<[Expr]>> {
    let (mut i, ()) = sign(b'{')(i)?;
    if blank(i).peek() != Some(b'*') {
        return list(i, b'}');
    }
    i.state.height.set(0);
    loop {
        (i, ()) = sign(b'*')(i)?;
        let next = blank(i);
        match next.peek() {
            Some(b',') => i = next.skip(1),
            Some(b'}') => return Ok((next.skip(1), Box::default())),
            _ => return next.no_match(),
        }
    }
}

fn parenthesised<'a>(i: Text<'a>) -> Read<'a, Box<[Arg]>> {
    let (rest, ()) = sign(b'(')(i)?;
    if let Ok((rest, ())) = sign(b')')(rest) {
        return Ok((rest, Box::default()));
    }
    let (rest, args) = arguments(rest)?;
    let (rest, ()) = sign(b')')(rest)?;
    raise(rest, i.state.height.get())?;
    Ok((rest, args))
}

/// `arguments = [ "," ] argument { "," argument | [ "," ] option } ;`
///
/// The comma that may stand first is one before an option.
pub(super) fn arguments<'a>(i: Text<'a>) -> Read<'a, Box<[Arg]>> {
    let mut args = Vec::with_capacity(5); // target, speed, zone, tool, work object
    let mut height = 0;
    let mut i = blank(i);
    if let (Some(b','), after) = (i.peek(), blank(i.skip(1)))
        && after.peek() == Some(b'\\')
    {
        i = after;
    }
    loop {
        let (rest, arg) = argument(i)?;
        args.push(arg);
        height = height.max(i.state.height.get());
        let next = blank(rest);
        match next.peek() {
            Some(b',') => i = next.skip(1),
            Some(b'\\') => i = next,
            _ => {
                i.state.height.set(height);
                return Ok((rest, args.into_boxed_slice()));
            }
        }
    }
}

/// `argument = option | [ name becomes ] expression ;`
///
/// A required argument may bear its parameter's name; its place in the order counts all the same.
pub(super) fn argument<'a>(i: Text<'a>) -> Read<'a, Arg> {
    let i = blank(i);
    if i.peek() == Some(b'\\') {
        return option(i);
    }
    let (rest, expr) = expression(i)?;
    if matches!(expr.kind, ExprKind::Name)
        && let Ok((value_at, ())) = becomes(blank(rest))
    {
        let (rest, value) = expression(value_at)?;
        return Ok((rest, Arg { range: i.until(rest), kind: ArgKind::Positional(value) }));
    }
    Ok((rest, Arg { range: expr.range, kind: ArgKind::Positional(expr) }))
}

/// `option = "\" identifier [ becomes expression | "?" name ] ;`
fn option<'a>(i: Text<'a>) -> Read<'a, Arg> {
    let (after, ()) = sign(b'\\')(i)?;
    let (after, name_range) = identifier(after)?;
    i.state.height.set(0);
    let next = blank(after);
    let (rest, kind) = match next.peek() {
        Some(b':') => match becomes(next) {
            Ok((value_at, ())) => {
                let (rest, value) = expression(value_at)?;
                (rest, ArgKind::Named { name: name_range, value: Some(value) })
            }
            Err(_) => (after, ArgKind::Named { name: name_range, value: None }),
        },
        Some(b'?') => {
            let (rest, param) = name(next.skip(1))?;
            (rest, ArgKind::Conditional { name: name_range, param })
        }
        _ => (after, ArgKind::Named { name: name_range, value: None }),
    };
    Ok((rest, Arg { range: i.until(rest), kind }))
}
