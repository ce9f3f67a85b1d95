//! Where to go on after text that was not understood.

use super::input::Text;
use super::lexical::{
    any_word, begins_name, blank, in_name, line_ends_before, line_len, past_name, placeholder, string, white,
};
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
        let after = blank(i);
        let Some(byte) = after.peek() else { return end };
        if !first && line_ends_before(i, after) && begins_anew(after) {
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
    if matches!(byte, b'%' | b';') || placeholder(i).is_ok() {
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
        None | Some(b';' | b'"' | b'[' | b'{' | b'(' | b'\\' | b'!' | b'%' | b':' | b'.') => true,
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
/// comes first, or where that would be looked for too long.
pub(super) fn balanced(start: Text<'_>) -> Option<Text<'_>> {
    let farthest = start.at() as usize + start.state.allowance();
    let mut i = start;
    let mut open = 0usize;
    while (i.at() as usize) < farthest {
        i = blank(i);
        i = match i.peek() {
            None | Some(b';') => break,
            Some(b'(' | b'[' | b'{') => {
                open += 1;
                i.skip(1)
            }
            Some(b')' | b']' | b'}') => match open {
                0 => break,
                1 => return Some(i.skip(1)),
                _ => {
                    open -= 1;
                    i.skip(1)
                }
            },
            Some(b'"') => match string(i) {
                Ok((rest, _)) => rest,
                Err(_) => break,
            },
            Some(_) if open == 0 => break,
            Some(_) => i.skip(1),
        };
    }
    start.state.may_read_again(start.until(i).len() as usize);
    None
}

/// Past the END word of the construct that begins here, by counting words; before what ends a routine.
pub(super) fn matching_end(start: Text<'_>) -> Text<'_> {
    let mut i = start;
    let mut open = 0usize;
    let mut after_if = false;
    let mut last = start;
    loop {
        let at = blank(i);
        let Some(byte) = at.peek() else { return last };
        i = match byte {
            b'"' => string(at).map_or_else(|_| at.skip(line_len(at.rest)), |(i, _)| i),
            b if begins_name(b) => match any_word(at) {
                Some((_, w)) if w.ends_statements() => return last,
                Some((rest, w)) => {
                    match w {
                        Word::If => after_if = true,
                        Word::ElseIf => after_if = false,
                        Word::Then => open += usize::from(std::mem::take(&mut after_if)),
                        Word::For | Word::While | Word::Test => open += 1,
                        Word::EndIf | Word::EndFor | Word::EndWhile | Word::EndTest => {
                            open = open.saturating_sub(1);
                        }
                        _ => {}
                    }
                    rest
                }
                None => past_name(at),
            },
            _ => at.skip(1),
        };
        last = i;
        let compact_end = byte == b';' && open == 0;
        if compact_end
            || (open == 0
                && !after_if
                && begins_name(byte)
                && any_word(at).is_some_and(|(_, w)| w.block_slot().is_some()))
        {
            return i;
        }
    }
}

/// Where the line or the statement ends, strings regarded.
pub(super) fn line_end(i: Text<'_>) -> Text<'_> {
    let mut end = white_on_line(i);
    while let Some(byte) = end.peek() {
        match byte {
            b'\n' | b'\r' | b';' | b'!' => break,
            b'"' => end = string(end).map_or_else(|_| end.skip(line_len(end.rest)), |(end, _)| end),
            _ => end = end.skip(1),
        }
    }
    end
}

/// Past white space on this line.
pub(super) fn white_on_line(i: Text<'_>) -> Text<'_> {
    i.skip(i.rest.iter().position(|&b| !matches!(b, b' ' | b'\t')).unwrap_or(i.rest.len()))
}
