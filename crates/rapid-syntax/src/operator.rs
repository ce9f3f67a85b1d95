//! The operators of expressions, and how strongly they bind.

use super::input::Text;
use super::lexical::{any_word, blank, placeholder};
use super::tree::BinaryOp;
use super::word::Word;

/// How strongly an operator binds: OR XOR < AND < comparisons < + - < * / DIV MOD.
pub(super) fn binding(op: BinaryOp) -> u8 {
    use BinaryOp::*;
    match op {
        Or | Xor => 0,
        And => CONJUNCTION,
        Lt | Le | Eq | Ge | Gt | Ne => COMPARISON,
        Add | Sub => 3,
        Mul | Div | IntDiv | Mod => 4,
    }
}

/// The binding power of AND.
pub(super) const CONJUNCTION: u8 = 1;

/// The binding power of comparisons: a higher one binds before a lower one.
pub(super) const COMPARISON: u8 = 2;

/// `operator = "OR" | "XOR" | "AND" | "<" | "<=" | "<>" | "=" | ">=" | ">" | "+" | "-" | "*" | "/" | "DIV" | "MOD" ;`
#[inline]
pub(super) fn operator<'a>(i: Text<'a>) -> Option<(Text<'a>, BinaryOp)> {
    use BinaryOp::*;
    let i = blank(i);
    let (n, op) = match i.rest {
        [b',' | b']' | b')' | b';' | b':' | b'\\' | b'}' | b'%' | b'[', ..] => return None,
        [b'<', b'=', ..] => (2, Le),
        [b'<', b'>', ..] => (2, Ne),
        [b'>', b'=', ..] => (2, Ge),
        [b'<', ..] if placeholder(i).is_ok() => return None,
        [b'<', ..] => (1, Lt),
        [b'>', ..] => (1, Gt),
        [b'=', ..] => (1, Eq),
        [b'+', ..] => (1, Add),
        [b'-', ..] => (1, Sub),
        [b'*', ..] => (1, Mul),
        [b'/', ..] => (1, Div),
        _ => return word_operator(i),
    };
    Some((i.skip(n), op))
}

fn word_operator<'a>(i: Text<'a>) -> Option<(Text<'a>, BinaryOp)> {
    let (rest, word) = any_word(i)?;
    let op = match word {
        Word::Or => BinaryOp::Or,
        Word::Xor => BinaryOp::Xor,
        Word::And => BinaryOp::And,
        Word::Div => BinaryOp::IntDiv,
        Word::Mod => BinaryOp::Mod,
        _ => return None,
    };
    Some((rest, op))
}
