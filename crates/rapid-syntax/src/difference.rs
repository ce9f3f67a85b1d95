//! Whether two texts are the same but for stretches that may differ.

use crate::diagnostic::TextRange;

/// Where two texts begin to differ token by token, as offsets into each; `None` where they do not.
///
/// White space between tokens does not count, nor does what stands in `free_a` and `free_b`: the n-th of
/// the one may become the n-th of the other. Both must be in order and not overlap. Strings and comments
/// count whole.
#[must_use]
pub fn first_difference(
    a: &[u8],
    free_a: &[TextRange],
    b: &[u8],
    free_b: &[TextRange],
) -> Option<(u32, u32)> {
    let (mut a, mut b) = (Tokens::new(a, free_a), Tokens::new(b, free_b));
    loop {
        let (one, other) = (a.next(), b.next());
        match (&one, &other) {
            (None, None) => return None,
            (Some((_, one)), Some((_, other))) if one == other => {}
            _ => {
                let at = |token: &Option<(usize, _)>, end: usize| token.as_ref().map_or(end, |t| t.0) as u32;
                return Some((at(&one, a.text.len()), at(&other, b.text.len())));
            }
        }
    }
}

/// A token: its bytes, or a free stretch.
#[derive(PartialEq, Eq)]
enum Token<'t> {
    Text(&'t [u8]),
    Free,
}

struct Tokens<'t> {
    text: &'t [u8],
    free: &'t [TextRange],
    at: usize,
}

impl<'t> Tokens<'t> {
    fn new(text: &'t [u8], free: &'t [TextRange]) -> Self {
        Self { text, free, at: 0 }
    }

    /// Length of the token that begins at `rest`, which begins with no white space.
    fn length(rest: &[u8]) -> usize {
        let word = |b: &u8| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'.') || !b.is_ascii();
        match rest.first() {
            Some(b'!') => rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len()),
            Some(b'"') => {
                let end = rest.iter().skip(1).position(|b| matches!(b, b'"' | b'\n' | b'\r'));
                end.map_or(rest.len(), |end| end + 2).min(rest.len())
            }
            Some(b) if word(b) => rest.iter().position(|b| !word(b)).unwrap_or(rest.len()),
            _ => 1,
        }
    }
}

impl<'t> Iterator for Tokens<'t> {
    type Item = (usize, Token<'t>);

    fn next(&mut self) -> Option<Self::Item> {
        let rest = self.text.get(self.at..)?;
        self.at += rest.iter().position(|b| !b.is_ascii_whitespace()).unwrap_or(rest.len());
        let rest = self.text.get(self.at..).filter(|rest| !rest.is_empty())?;
        let at = self.at;
        while let Some((first, others)) = self.free.split_first() {
            if first.start as usize > at {
                break;
            }
            self.free = others;
            if (first.end as usize) > at {
                self.at = first.end as usize;
                return Some((at, Token::Free));
            }
        }
        let before_free = self.free.first().map_or(usize::MAX, |free| free.start as usize - at);
        let length = Self::length(rest).min(before_free);
        self.at += length;
        Some((at, Token::Text(rest.get(..length).unwrap_or(rest).trim_ascii_end())))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn difference(a: &str, b: &str, free: &str) -> Option<(u32, u32)> {
        let ranges = |text: &str| -> Vec<TextRange> {
            text.match_indices(free)
                .map(|(at, _)| TextRange::new(at as u32, (at + free.len()) as u32))
                .collect()
        };
        first_difference(a.as_bytes(), &ranges(a), b.as_bytes(), &ranges(b))
    }

    #[test]
    fn layout_does_not_count_and_everything_else_does() {
        assert_eq!(difference("a := b + 1;\n", "a:=b+1;\r\n\r\n", "@"), None);
        assert_eq!(difference("a:=b+1;", "a:=b-1;", "@"), Some((4, 4)));
        assert_eq!(difference("a b", "ab", "@"), Some((0, 0)));
        assert_eq!(difference("x ! one  \n", "x ! one\n", "@"), None);
        assert_eq!(difference("x ! one", "x ! two", "@"), Some((2, 2)));
        assert_eq!(difference("s:=\"a b\";", "s:=\"a  b\";", "@"), Some((3, 3)));
        assert_eq!(difference("a;", "a;b;", "@"), Some((2, 2)));
    }

    #[test]
    fn free_stretches_may_become_each_other_but_must_be_there() {
        let (a, b) = ("MoveL p1,v5;", "MoveL [[1,2]],v5;");
        let free = |from, to| [TextRange::new(from, to)];
        assert_eq!(first_difference(a.as_bytes(), &free(6, 8), b.as_bytes(), &free(6, 13)), None);
        assert_eq!(first_difference(a.as_bytes(), &free(6, 8), b.as_bytes(), &[]), Some((6, 6)));
        let c = "MoveL [[1,2]],v9;";
        assert_eq!(first_difference(a.as_bytes(), &free(6, 8), c.as_bytes(), &free(6, 13)), Some((9, 14)));
    }
}
