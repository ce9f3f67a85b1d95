//! The lexical productions: blanks, comments, names, words, numbers, strings, signs.
//!
//! Each token skips the blanks before it, so a range never holds the blanks round what it names.

use super::input::{Read, Text};
use super::word::Word;
use crate::diagnostic::TextRange;
use nom::Parser;
use nom::bytes::complete::{take_while, take_while1};
use nom::character::complete::char;
use nom::combinator::opt;

/// White space: all control characters that space text, and the Latin-1 no-break space.
#[inline(always)]
pub(super) fn is_space(byte: u8) -> bool {
    CLASSES[usize::from(byte)] & SPACE != 0
}

/// A letter a name may begin with: ASCII or ISO 8859-1.
#[inline]
pub(super) fn begins_name(byte: u8) -> bool {
    byte.is_ascii_alphabetic() || (byte >= 0xC0 && byte != 0xD7 && byte != 0xF7)
}

/// A byte a name may go on with; from 0x80 on also the trail bytes of UTF-8 letters.
#[inline(always)]
pub(super) fn in_name(byte: u8) -> bool {
    CLASSES[usize::from(byte)] & IN_NAME != 0
}

const SPACE: u8 = 1;
const IN_NAME: u8 = 2;

/// What each byte may be: every byte of a text is asked for.
static CLASSES: [u8; 256] = {
    let mut classes = [0; 256];
    let mut byte = 0_u8;
    loop {
        if matches!(byte, b' ' | b'\t'..=b'\r' | 0xA0) {
            classes[byte as usize] |= SPACE;
        }
        if byte.is_ascii_alphanumeric() || byte == b'_' || byte >= 0x80 {
            classes[byte as usize] |= IN_NAME;
        }
        if byte == 0xFF {
            break classes;
        }
        byte += 1;
    }
};

/// `comment = "!" { ? any byte but a line end ? } ;`
pub(super) fn comment<'a>(i: Text<'a>) -> Read<'a, TextRange> {
    if i.peek() != Some(b'!') {
        return i.no_match();
    }
    let end = i.skip(line_len(i.rest));
    Ok((end, i.until(end)))
}

/// Number of bytes before the next line end.
pub(super) fn line_len(rest: &[u8]) -> usize {
    memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len())
}

/// `blank = { ? white space ? | comment } ;`
#[inline]
pub(super) fn blank(i: Text<'_>) -> Text<'_> {
    match i.rest {
        [b, ..] if *b > b' ' && *b != b'!' && *b != 0xA0 => i,
        [b' ', b, ..] if *b > b' ' && *b != b'!' && *b != 0xA0 => i.skip(1),
        _ => long_blank(i),
    }
}

fn long_blank(mut i: Text<'_>) -> Text<'_> {
    loop {
        i = white(i);
        match i.peek() {
            Some(b'!') => i = i.skip(line_len(i.rest)),
            _ => return i,
        }
    }
}

/// Past white space, not past comments.
#[inline]
pub(super) fn white(i: Text<'_>) -> Text<'_> {
    let spaces = i.rest.iter().position(|&b| !is_space(b));
    i.skip(spaces.unwrap_or(i.rest.len()))
}

/// `identifier = letter { letter | digit | "_" } ;`
#[inline]
pub(super) fn identifier<'a>(i: Text<'a>) -> Read<'a, TextRange> {
    let i = blank(i);
    match i.peek() {
        Some(b) if begins_name(b) => {
            let end = past_name(i);
            Ok((end, i.until(end)))
        }
        _ => i.no_match(),
    }
}

/// Past the bytes of a name.
#[inline]
pub(super) fn past_name(i: Text<'_>) -> Text<'_> {
    let len = i.rest.iter().position(|&b| !in_name(b));
    i.skip(len.unwrap_or(i.rest.len()))
}

/// `name = identifier ;`
///
/// That is no reserved word.
#[inline]
pub(super) fn name<'a>(i: Text<'a>) -> Read<'a, TextRange> {
    let i = blank(i);
    let (end, range) = identifier(i)?;
    match Word::of(i.bytes_until(end)) {
        None => Ok((end, range)),
        Some(_) => i.no_match(),
    }
}

/// The reserved word with which something begins, if with one, and what follows it.
pub(super) type FirstWord<'a> = Option<(Text<'a>, Word)>;

/// The reserved word that stands here after blanks, and what follows it.
#[inline]
pub(super) fn any_word<'a>(i: Text<'a>) -> FirstWord<'a> {
    let i = blank(i);
    if !i.peek()?.is_ascii_alphabetic() {
        return None;
    }
    let end = past_name(i);
    Some((end, Word::of(i.bytes_until(end))?))
}

/// `word = identifier ;`
///
/// That is the given reserved word, in any case.
pub(super) fn word<'a>(expected: Word) -> impl Fn(Text<'a>) -> Read<'a, TextRange> + Copy {
    move |i| {
        let i = blank(i);
        match any_word(i) {
            Some((end, found)) if found == expected => Ok((end, i.until(end))),
            _ => i.no_match(),
        }
    }
}

/// One byte of punctuation after blanks.
#[inline]
pub(super) fn sign<'a>(expected: u8) -> impl Fn(Text<'a>) -> Read<'a, ()> + Copy {
    move |i| {
        let i = blank(i);
        if i.peek() == Some(expected) { Ok((i.skip(1), ())) } else { i.no_match() }
    }
}

/// `becomes = ":" "=" ;`
///
/// Also with blanks between.
pub(super) fn becomes<'a>(i: Text<'a>) -> Read<'a, ()> {
    let (i, ()) = sign(b':')(i)?;
    sign(b'=')(i)
}

/// `number = decimal | "0" ( "x" | "o" | "b" ) digit { digit } ;`
///
/// Without a sign: that is an operator.
#[inline(always)]
pub(super) fn number<'a>(i: Text<'a>) -> Read<'a, TextRange> {
    let (end, _) = match i.rest {
        [b'0', b'x' | b'X', d, ..] if d.is_ascii_hexdigit() => digits(i.skip(2), u8::is_ascii_hexdigit),
        [b'0', b'o' | b'O', b'0'..=b'7', ..] => digits(i.skip(2), |d| matches!(d, b'0'..=b'7')),
        [b'0', b'b' | b'B', b'0' | b'1', ..] => digits(i.skip(2), |d| matches!(d, b'0' | b'1')),
        _ => decimal(i),
    }?;
    match end.peek() {
        Some(b) if in_name(b) => end.no_match(),
        _ => Ok((end, i.until(end))),
    }
}

/// `decimal = ( digit { digit } [ "." { digit } ] | "." digit { digit } ) [ exponent ] ;`
#[inline(always)]
fn decimal<'a>(i: Text<'a>) -> Read<'a, ()> {
    let rest = i.rest;
    let whole = digit_run(rest);
    let mut n = whole;
    if rest.get(n) == Some(&b'.') {
        let part = digit_run(&rest[n + 1..]);
        if whole + part == 0 {
            return i.no_match();
        }
        n += 1 + part;
    } else if whole == 0 {
        return i.no_match();
    }
    let end = i.skip(n);
    match end.peek() {
        Some(b'e' | b'E') => opt(exponent).parse(end).map(|(end, _)| (end, ())),
        _ => Ok((end, ())),
    }
}

/// `exponent = ( "e" | "E" ) [ "+" | "-" ] digit { digit } ;`
fn exponent<'a>(i: Text<'a>) -> Read<'a, ()> {
    let signed = usize::from(matches!(i.peek_at(1), Some(b'+' | b'-')));
    match i.peek_at(1 + signed) {
        Some(d) if d.is_ascii_digit() => digits(i.skip(1 + signed), u8::is_ascii_digit),
        _ => i.no_match(),
    }
}

#[inline(always)]
fn digit_run(bytes: &[u8]) -> usize {
    bytes.iter().position(|b| !b.is_ascii_digit()).unwrap_or(bytes.len())
}

fn digits<'a>(i: Text<'a>, is_digit: impl Fn(&u8) -> bool) -> Read<'a, ()> {
    let (i, _) = take_while(|b| is_digit(&b)).parse(i)?;
    Ok((i, ()))
}

/// `string = '"' { ? any byte but a quote and a line end ? | '""' } '"' ;`
///
/// On one line; a backslash does not hide a quote.
pub(super) fn string<'a>(i: Text<'a>) -> Read<'a, TextRange> {
    if i.peek() != Some(b'"') {
        return i.no_match();
    }
    let mut end = i.skip(1);
    loop {
        let Some(n) = memchr::memchr3(b'"', b'\n', b'\r', end.rest) else { return i.no_match() };
        end = end.skip(n);
        match (end.peek(), end.peek_at(1)) {
            (Some(b'"'), Some(b'"')) => end = end.skip(2),
            (Some(b'"'), _) => {
                let end = end.skip(1);
                return Ok((end, i.until(end)));
            }
            _ => return i.no_match(),
        }
    }
}

/// `placeholder = "<" capital { capital } ">" ;`
pub(super) fn placeholder<'a>(i: Text<'a>) -> Read<'a, TextRange> {
    let capitals = take_while1(|b: u8| b.is_ascii_uppercase());
    let (end, _) = (char('<'), capitals, char('>')).parse(i)?;
    Ok((end, i.until(end)))
}

/// Whether a line end stands between `from` and `to`.
pub(super) fn line_ends_before(from: Text<'_>, to: Text<'_>) -> bool {
    memchr::memchr2(b'\n', b'\r', from.bytes_until(to)).is_some()
}
