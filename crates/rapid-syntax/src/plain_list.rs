//! Lists of nothing but numbers, most of a large program's text, past in one scan.
//!
//! What is found is what the productions find: they take over wherever anything else stands, comments among it.

use super::lexical::{in_name, is_space};

/// Lists nest no deeper here.
pub(super) const DEEPEST: u16 = 8;

/// An aggregate of decimal numbers, with or without a minus sign, and of such aggregates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PlainList {
    /// Bytes, both brackets among them.
    pub(super) len: usize,
    /// Of the tree that the productions make of it: a number has none, a sign and a list each add one.
    pub(super) height: u16,
}

/// External axes that are not there, as ABB and as RoboDK write them: a quarter of a target's text.
const NO_EXTERNAL_AXES: [&[u8]; 2] = [b"[9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]", b"[9E9,9E9,9E9,9E9,9E9,9E9]"];

impl PlainList {
    /// The one with which `text` begins, at its bracket.
    pub(super) fn begins(text: &[u8]) -> Option<Self> {
        let (mut open, mut height) = (1, 1);
        let mut at = 1;
        loop {
            at = past_spaces(text, at);
            match text.get(at)? {
                b'[' => {
                    if open == DEEPEST {
                        return None;
                    }
                    let axes = text.get(at..).and_then(no_external_axes);
                    height = height.max(open + 1);
                    at += axes.unwrap_or(1);
                    if axes.is_none() {
                        open += 1;
                        continue;
                    }
                }
                b'-' => {
                    at = past_number(text, at + 1)?;
                    height = height.max(open + 1);
                }
                _ => at = past_number(text, at)?,
            }
            loop {
                at = past_spaces(text, at);
                let next = text.get(at)?;
                at += 1;
                match next {
                    b',' => break,
                    b']' => {
                        open -= 1;
                        if open == 0 {
                            return Some(Self { len: at, height });
                        }
                    }
                    _ => return None,
                }
            }
        }
    }
}

/// A part of a list that is a decimal number or a string, with a comma or the list's end right behind it.
///
/// Neither has parts of its own, nor a height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PlainPart {
    /// Bytes of white space before it.
    pub(super) from: usize,
    /// Bytes up to what ends it.
    pub(super) to: usize,
    /// A node of the tree is not carried in here: handing on its bytes would take longer than the scan.
    pub(super) is_string: bool,
}

impl PlainPart {
    /// The one with which `text` begins.
    #[inline(always)]
    pub(super) fn begins(text: &[u8]) -> Option<Self> {
        let from = past_spaces(text, 0);
        let is_string = *text.get(from)? == b'"';
        let to = if is_string { past_string(text, from) } else { past_number(text, from) }?;
        matches!(text.get(to)?, b',' | b']' | b'}').then_some(Self { from, to, is_string })
    }
}

/// Past a string without a quote in it, on one line.
#[inline(always)]
fn past_string(text: &[u8], at: usize) -> Option<usize> {
    let mut end = at + 1;
    loop {
        match text.get(end)? {
            b'"' => return Some(end + 1),
            b'\n' | b'\r' => return None,
            _ => end += 1,
        }
    }
}

/// The length of one of [`NO_EXTERNAL_AXES`] with which `text` begins.
#[inline(always)]
fn no_external_axes(text: &[u8]) -> Option<usize> {
    NO_EXTERNAL_AXES.into_iter().find(|axes| text.starts_with(axes)).map(<[u8]>::len)
}

#[inline(always)]
pub(super) fn past_spaces(text: &[u8], mut at: usize) -> usize {
    while text.get(at).is_some_and(|&byte| is_space(byte)) {
        at += 1;
    }
    at
}

/// Past a decimal number that begins with a digit and does not end the text.
#[inline(always)]
pub(super) fn past_number(text: &[u8], at: usize) -> Option<usize> {
    let mut end = past_digits(text, at);
    if end == at {
        return None;
    }
    let mut next = *text.get(end)?;
    if next == b'.' {
        end = past_digits(text, end + 1);
        next = *text.get(end)?;
    }
    if matches!(next, b'e' | b'E') {
        let signed = end + 1 + usize::from(matches!(text.get(end + 1), Some(b'+' | b'-')));
        end = past_digits(text, signed);
        if end == signed {
            return None;
        }
        next = *text.get(end)?;
    }
    // What goes on like a name is no number; the no-break space of Latin-1 is among these bytes.
    (!in_name(next)).then_some(end)
}

/// Past digits: eight bytes at a time, since their number is what a processor guesses worst.
#[inline(always)]
fn past_digits(text: &[u8], mut at: usize) -> usize {
    while let Some(eight) = text.get(at..).and_then(<[u8]>::first_chunk) {
        let digits = leading_digits(u64::from_le_bytes(*eight));
        at += digits;
        if digits < 8 {
            return at;
        }
    }
    while text.get(at).is_some_and(u8::is_ascii_digit) {
        at += 1;
    }
    at
}

/// How many of eight bytes, the first the lowest, are digits before another is.
#[inline(always)]
pub(super) fn leading_digits(eight: u64) -> usize {
    const EACH: u64 = 0x0101_0101_0101_0101;
    let values = eight ^ (EACH * 0x30); // a digit becomes 0 to 9, all else more
    let others = (values.wrapping_add(EACH * 0x76) | values) & (EACH * 0x80); // a carry comes from no digit
    others.trailing_zeros() as usize / 8
}

#[cfg(test)]
mod tests {
    use super::super::expression::any_aggregate;
    use super::super::input::{ParseState, Text};
    use super::super::test_programs::{Chance, programs};
    use super::super::tree::ExprKind;
    use super::*;

    /// Holds the scan to the productions at every bracket of `text`; how often it found something.
    fn agrees(text: &[u8]) -> usize {
        let mut found = 0;
        for at in memchr::memchr_iter(b'[', text) {
            let state = ParseState::new(text);
            let here = Text::new(text, &state).skip(at);
            let Some(plain) = PlainList::begins(here.rest) else { continue };
            let (rest, expr) = any_aggregate(here).unwrap();
            let len = here.bytes_until(rest).len();
            let context = String::from_utf8_lossy(&here.rest[..plain.len.min(200)]).into_owned();
            assert_eq!(plain, PlainList { len, height: state.height.get() }, "{context}");
            assert_eq!((expr.kind, expr.range.len()), (ExprKind::Numbers, len as u32), "{context}");
            found += 1;
        }
        found
    }

    #[test]
    fn the_scan_agrees_with_the_productions_on_every_fixture_and_on_mutated_ones() {
        let (mut found, mut found_mutated) = (0, 0);
        let mut chance = Chance::new();
        for mut text in programs() {
            found += agrees(&text);
            text.truncate(8192);
            let brackets: Vec<usize> = memchr::memchr_iter(b'[', &text).collect();
            for _ in 0..if brackets.is_empty() { 0 } else { 20 } {
                let mut text = text.clone();
                for _ in 0..6 {
                    let near = brackets[chance.below(brackets.len())] + chance.below(40);
                    let by = b"[],-+.eE0x9! \n\xA0\t;a_\"<(*\xE9{"[chance.below(25)];
                    if let Some(byte) = text.get_mut(near) {
                        *byte = by;
                    }
                }
                found_mutated += agrees(&text);
            }
        }
        assert!(found > 1000 && found_mutated > 10_000, "{found} {found_mutated}");
    }

    #[test]
    fn what_is_not_plain_is_left_to_the_productions() {
        let begins = |text: &[u8]| PlainList::begins(text).map(|plain| (plain.len, plain.height));
        assert_eq!(begins(b"[1,2];"), Some((5, 1)));
        assert_eq!(begins(b"[[-1.5, 2.],\r\n [9E+09 ]]]"), Some((24, 3)));
        assert_eq!(begins(b"[1,[9E9,9E9,9E9,9E9,9E9,9E9]]"), Some((29, 2)));
        assert_eq!(begins(b"[12345678,123456789.0123456789012345e-1234567890]"), Some((49, 1)));
        for other in [
            &b"[]"[..],
            b"[1,]",
            b"[1",
            b"[1,2",
            b"[+1]",
            b"[- 1]",
            b"[.5]",
            b"[0x1F]",
            b"[1e]",
            b"[1e+]",
            b"[1 2]",
            b"[a]",
            b"[1,!c\n2]",
            b"[1+2]",
            b"[1.2.3]",
            b"[1a]",
            b"[(1)]",
            b"[[],1]",
            b"[[[[[[[[[1]]]]]]]]]",
        ] {
            assert_eq!(begins(other), None, "{}", String::from_utf8_lossy(other));
        }
    }
}
