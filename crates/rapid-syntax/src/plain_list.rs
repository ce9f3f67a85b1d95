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

impl PlainList {
    /// The one with which `text` begins, at its bracket.
    pub(super) fn begins(text: &[u8]) -> Option<Self> {
        let mut heights = [0_u16; DEEPEST as usize];
        let mut open = 1;
        let mut at = 1;
        loop {
            at = past_spaces(text, at);
            let height = match text.get(at)? {
                b'[' => {
                    *heights.get_mut(open)? = 0;
                    open += 1;
                    at += 1;
                    continue;
                }
                b'-' => {
                    at = past_number(text, at + 1)?;
                    1
                }
                _ => {
                    at = past_number(text, at)?;
                    0
                }
            };
            let of_list = heights.get_mut(open - 1)?;
            *of_list = height.max(*of_list);
            loop {
                at = past_spaces(text, at);
                let next = text.get(at)?;
                at += 1;
                match next {
                    b',' => break,
                    b']' => {
                        open -= 1;
                        let height = *heights.get(open)? + 1;
                        let Some(outer) = open.checked_sub(1) else { return Some(Self { len: at, height }) };
                        let of_list = heights.get_mut(outer)?;
                        *of_list = height.max(*of_list);
                    }
                    _ => return None,
                }
            }
        }
    }
}

#[inline(always)]
fn past_spaces(text: &[u8], mut at: usize) -> usize {
    while text.get(at).is_some_and(|&byte| is_space(byte)) {
        at += 1;
    }
    at
}

/// Past a decimal number that begins with a digit.
#[inline(always)]
fn past_number(text: &[u8], at: usize) -> Option<usize> {
    let mut end = past_digits(text, at);
    if end == at {
        return None;
    }
    if text.get(end) == Some(&b'.') {
        end = past_digits(text, end + 1);
    }
    if matches!(text.get(end), Some(b'e' | b'E')) {
        let signed = end + 1 + usize::from(matches!(text.get(end + 1), Some(b'+' | b'-')));
        end = past_digits(text, signed);
        if end == signed {
            return None;
        }
    }
    // What goes on like a name is no number; the no-break space of Latin-1 is among these bytes.
    let goes_on = text.get(end).is_some_and(|&byte| in_name(byte));
    (!goes_on).then_some(end)
}

#[inline(always)]
fn past_digits(text: &[u8], mut at: usize) -> usize {
    while text.get(at).is_some_and(u8::is_ascii_digit) {
        at += 1;
    }
    at
}

#[cfg(test)]
mod tests {
    use super::super::expression::any_aggregate;
    use super::super::input::{State, Text};
    use super::super::tree::ExprKind;
    use super::*;
    use std::path::{Path, PathBuf};

    /// Holds the scan to the productions at every bracket of `text`; how often it found something.
    fn agrees(text: &[u8]) -> usize {
        let mut found = 0;
        for at in memchr::memchr_iter(b'[', text) {
            let state = State::new(text);
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

    fn programs(folder: &Path, into: &mut Vec<PathBuf>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let named = |name: &str| path.extension().is_some_and(|e| e.eq_ignore_ascii_case(name));
            if path.is_dir() {
                programs(&path, into);
            } else if ["mod", "sys", "prg"].into_iter().any(named) {
                into.push(path);
            }
        }
    }

    #[test]
    fn the_scan_agrees_with_the_productions_on_every_fixture_and_on_mutated_ones() {
        let mut paths = Vec::new();
        programs(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures"), &mut paths);
        assert!(paths.len() > 50, "{}", paths.len());
        paths.sort();
        let (mut found, mut found_mutated) = (0, 0);
        let mut chance = 0x9E37_79B9_7F4A_7C15_u64;
        let mut next = |below: usize| {
            chance ^= chance << 13;
            chance ^= chance >> 7;
            chance ^= chance << 17;
            (chance >> 11) as usize % below
        };
        for path in paths {
            let mut text = std::fs::read(&path).unwrap();
            found += agrees(&text);
            text.truncate(8192);
            let brackets: Vec<usize> = memchr::memchr_iter(b'[', &text).collect();
            for _ in 0..if brackets.is_empty() { 0 } else { 20 } {
                let mut text = text.clone();
                for _ in 0..6 {
                    let near = brackets[next(brackets.len())] + next(40);
                    let by = b"[],-+.eE0x9! \n\xA0\t;a_\"<(*\xE9{"[next(25)];
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
