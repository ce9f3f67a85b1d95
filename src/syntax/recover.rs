//! Where to go on after text that was not understood.

use super::input::Text;
use super::lexical::{any_word, begins_name, blank, in_name, line_len, string, white};
use super::word::Word;

/// The end of a broken statement that begins at `start` and was read up to byte `reached`.
///
/// After its semicolon, at its line's end when the next line begins anew, or before a word that no
/// statement holds. Goes past `reached` instead of reading those bytes again once too many were.
pub(super) fn resync<'a>(start: Text<'a>, reached: u32) -> Text<'a> {
    let read = reached.saturating_sub(start.at()) as usize;
    let from = if start.state.may_read_again(read) { start } else { start.skip(read) };
    let end = statement_end(from);
    if end.at() > start.at() { end } else { start.skip(1) }
}

fn statement_end(start: Text<'_>) -> Text<'_> {
    let mut i = start;
    let mut end = start; // after the last byte that is neither white space nor comment
    let mut first = true;
    loop {
        let after = past_blanks(i);
        let Some(byte) = after.peek() else { return end };
        if !first && after.state_new_line(i) && begins_anew(after) {
            return end;
        }
        i = match byte {
            b';' => return after.skip(1),
            b'"' => string(after).map_or_else(|_| after.skip(line_len(after.rest)), |(i, _)| i),
            b if begins_name(b) => {
                let (next, found) = word_or_name(after);
                if !first && found.is_some_and(|w| w.ends_statements() || w.block_slot().is_some()) {
                    return end;
                }
                next
            }
            b if in_name(b) => past_name(after),
            _ => after.skip(1),
        };
        end = i;
        first = false;
    }
}

impl Text<'_> {
    fn state_new_line(self, from: Self) -> bool {
        super::lexical::line_ends_before(from, self)
    }
}

fn past_blanks(i: Text<'_>) -> Text<'_> {
    blank(i)
}

fn past_name(i: Text<'_>) -> Text<'_> {
    i.skip(i.rest.iter().position(|&b| !in_name(b)).unwrap_or(i.rest.len()))
}

fn word_or_name(i: Text<'_>) -> (Text<'_>, Option<Word>) {
    match any_word(i) {
        Some((next, w)) => (next, Some(w)),
        None => (past_name(i), None),
    }
}

/// Whether what stands at a line's first byte begins a statement rather than going on with one.
///
/// A reserved word that begins one, a late call, a placeholder, or a name followed by what follows the
/// name in a call, an assignment or a label.
pub(super) fn begins_anew(i: Text<'_>) -> bool {
    let Some(byte) = i.peek() else { return true };
    if matches!(byte, b'%' | b';') || super::lexical::placeholder(i).is_ok() {
        return true;
    }
    if !begins_name(byte) {
        return false;
    }
    let (after, found) = word_or_name(i);
    if let Some(w) = found {
        return !w.inside_statement();
    }
    let next = white(after);
    match next.peek() {
        None | Some(b';' | b'"' | b'[' | b'{' | b'\\' | b'!' | b'%') => true,
        Some(b'(') => true,
        Some(b':') => true,
        Some(b'.') => true,
        Some(b) => (begins_name(b) || b.is_ascii_digit() || b == b'-') && next.at() > after.at(),
    }
}

/// The range's text up to where the list element that begins at `start` ends: before a comma, a closing
/// bracket of an outer level, a semicolon or the line's end.
pub(super) fn element_end(start: Text<'_>) -> Text<'_> {
    let mut i = start;
    let mut open = 0usize;
    while let Some(byte) = i.peek() {
        i = match byte {
            b';' | b'\n' | b'\r' | b'!' => return i,
            b',' | b')' | b']' | b'}' if open == 0 => return i,
            b')' | b']' | b'}' => {
                open -= 1;
                i.skip(1)
            }
            b'(' | b'[' | b'{' => {
                open += 1;
                i.skip(1)
            }
            b'"' => string(i).map_or_else(|_| i.skip(line_len(i.rest)), |(i, _)| i),
            _ => i.skip(1),
        };
    }
    i
}

/// Past a balanced bracketed text that begins here, however deep; `None` where a semicolon or the end
/// comes first.
pub(super) fn balanced(start: Text<'_>) -> Option<Text<'_>> {
    let mut i = start;
    let mut open = 0usize;
    loop {
        i = blank(i);
        i = match i.peek()? {
            b';' => return None,
            b'(' | b'[' | b'{' => {
                open += 1;
                i.skip(1)
            }
            b')' | b']' | b'}' => {
                open = open.checked_sub(1)?;
                i.skip(1)
            }
            b'"' => string(i).ok()?.0,
            _ => i.skip(1),
        };
        if open == 0 {
            return Some(i);
        }
    }
}
