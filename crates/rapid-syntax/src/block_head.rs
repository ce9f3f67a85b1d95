//! Heads and ends of statements that hold others: conditions, the words behind them, END words.

use super::expression::expression;
use super::input::{NoMatch, Text};
use super::lexical::{
    any_word, begins_name, blank, in_name, line_ends_before, line_len, past_name, string, word,
};
use super::recover::{line_end, white_on_line};
use super::tree::{Expr, ExprKind};
use super::word::Word;

/// Past the END word of the construct that begins at `start`, or not, which is said.
pub(super) fn end_word<'a>(start: Text<'a>, i: Text<'a>, end: Word, spelled: &str) -> Text<'a> {
    match word(end)(i) {
        Ok((rest, _)) => rest,
        Err(_) => {
            let head = start.until(start.skip(line_len(start.rest)));
            start.state.warn(head, "syntax::end", format!("what begins here has no {spelled}"));
            i
        }
    }
}

/// An expression and the word after it, which may be missing at a line's end; text that is no
/// expression, up to the word or the line's end, is opaque.
pub(super) fn head<'a>(i: Text<'a>, last: Word, spelled: &str) -> (Text<'a>, Expr) {
    if let Ok((rest, expr)) = expression(i) {
        if let Ok((rest, _)) = word(last)(rest) {
            return (rest, expr);
        }
        let next = blank(rest);
        if next.is_empty() || line_ends_before(rest, next) {
            i.state.warn(expr.range, "syntax::word", format!("{spelled} is missing after this"));
            return (rest, expr);
        }
    }
    condition_up_to(i, last).map_or_else(
        || opaque_expr(i, line_end(i)),
        |(rest, expr)| (word(last)(rest).map_or(rest, |(rest, _)| rest), expr),
    )
}

pub(super) fn opaque_expr<'a>(i: Text<'a>, end: Text<'a>) -> (Text<'a>, Expr) {
    let start = white_on_line(i);
    let trailing = start.bytes_until(end).iter().rev().take_while(|b| b.is_ascii_whitespace()).count();
    let len = start.bytes_until(end).len() - trailing;
    let range = start.until(start.skip(len));
    i.state.warn(range, "syntax::expression", "this is no expression; it is kept as it is");
    (end, Expr { range, kind: ExprKind::Opaque })
}

/// The text up to the word on this line and in this statement as an opaque condition.
pub(super) fn condition_up_to<'a>(i: Text<'a>, last: Word) -> Option<(Text<'a>, Expr)> {
    let mut at = white_on_line(i);
    let end_of_line = line_end(i);
    while at.at() < end_of_line.at() {
        match at.peek()? {
            b'"' => at = string(at).ok()?.0,
            b if begins_name(b) => match any_word(at) {
                Some((_, w)) if w == last => return Some(opaque_expr(i, at)),
                _ => at = past_name(at),
            },
            b if in_name(b) => at = past_name(at),
            _ => at = at.skip(1),
        }
    }
    None
}

/// Past the last word of a head, which may be missing where a line ends.
pub(super) fn last_word<'a>(
    start: Text<'a>,
    i: Text<'a>,
    last: Word,
    spelled: &str,
) -> Result<Text<'a>, nom::Err<NoMatch>> {
    let failure = match word(last)(i) {
        Ok((rest, _)) => return Ok(rest),
        Err(failure) => failure,
    };
    let next = blank(i);
    if !next.is_empty() && !line_ends_before(i, next) {
        return Err(failure);
    }
    start.state.warn(start.until(i), "syntax::word", format!("{spelled} is missing after this"));
    Ok(i)
}
