//! Motions that were made comments by hand: what stood in them is put back in the comment, so that they can be made motions again.

use super::arrays::{Commented, NamedArray};
use super::removal::Remover;
use crate::emit::insertion::white;
use crate::emit::names::{start_of, words};
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{ModuleItem, Stmt, StmtKind};

impl<'w> Remover<'w> {
    /// Takes out what stands round targets in a statement that is a comment, and notes which arrays it names; another is left alone.
    pub(super) fn comment_of_statement(&mut self, stmt: &Stmt, arrays: &mut [NamedArray<'w>]) {
        if matches!(stmt.kind, StmtKind::Comment) {
            self.comment(stmt.range, arrays);
        }
    }

    /// The same for the module's comments outside routines.
    pub(super) fn comments_of_module(&mut self, arrays: &mut [NamedArray<'w>]) {
        for item in &self.module.items {
            let ModuleItem::Comment(range) = item else { continue };
            if range.end <= self.header.start || range.start >= self.header.end {
                self.comment(*range, arrays);
            }
        }
    }

    /// Takes out what stands round targets in a comment, and notes which arrays it names.
    fn comment(&mut self, comment: TextRange, arrays: &mut [NamedArray<'w>]) {
        let text: &'w [u8] = comment.of(self.bytes);
        if memchr::memchr2(b'{', b'(', text).is_none() {
            return;
        }
        let arguments = self.arguments();
        let range =
            |from: usize, to: usize| TextRange::new(comment.start + from as u32, comment.start + to as u32);
        let mut done = 0;
        words(text, |word| {
            let from = start_of(word, text);
            let blanks = text[from + word.len()..].iter().take_while(|&&byte| white(byte)).count();
            let open = from + word.len() + blanks;
            let Some((parts, end)) = bracketed(text, open).filter(|_| from >= done) else { return };
            let part = |part: &(usize, usize)| &text[part.0..part.1];
            let is_element =
                text[open] == b'{' && parts.last().is_some_and(|last| arguments.is_asking(part(last)));
            if is_element {
                let name = String::from_utf8_lossy(word).to_ascii_lowercase();
                let Some(at) = NamedArray::find(arrays, 0, &name) else { return };
                let own = &parts[..parts.len() - 1];
                let index = own.first().zip(own.last()).map(|(first, last)| range(first.0, last.1));
                arrays[at].commented.push(Commented { expr: range(from, end), index });
                done = end;
            } else if text[open] == b'('
                && arguments.stands_round(word)
                && let Some((first, last)) = parts.first()
            {
                self.edits.remove(range(from, *first));
                self.edits.remove(range(*last, end));
                done = end;
            }
        });
    }
}

/// The parts of a bracket that opens at `open`, between its own commas, without the blanks round them, and where it ends.
fn bracketed(text: &[u8], open: usize) -> Option<(Vec<(usize, usize)>, usize)> {
    if !matches!(text.get(open), Some(b'{' | b'(')) {
        return None;
    }
    let (mut depth, mut in_string, mut from, mut parts) = (0_u32, false, open + 1, Vec::new());
    let trimmed = |from: usize, to: usize| {
        let blanks = text[from..to].iter().take_while(|&&byte| white(byte)).count();
        (from + blanks, from + blanks + text[from + blanks..to].trim_ascii_end().len())
    };
    for (at, &byte) in text.iter().enumerate().skip(open) {
        match byte {
            b'"' => in_string = !in_string,
            _ if in_string => {}
            b'(' | b'[' | b'{' => depth += 1,
            b')' | b']' | b'}' => depth -= 1,
            _ => {}
        }
        if !in_string && (depth == 0 || depth == 1 && byte == b',') {
            parts.push(trimmed(from, at));
            from = at + 1;
        }
        if depth == 0 {
            return Some((parts, at + 1));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parts_of_a_bracket_are_found() {
        let parts = |text: &'static str, open| {
            let (parts, end) = bracketed(text.as_bytes(), open)?;
            Some((parts.into_iter().map(|(from, to)| &text[from..to]).collect::<Vec<_>>(), &text[end..]))
        };
        assert_eq!(parts("a{ i , b{2,3}, tcK( ) },v", 1), Some((vec!["i", "b{2,3}", "tcK( )"], ",v")));
        assert_eq!(parts("f([[1,2],[3]],\"a),\",c);", 1), Some((vec!["[[1,2],[3]]", "\"a),\"", "c"], ";")));
        assert_eq!(parts("f(a,b", 1), None);
        assert_eq!(parts("f a", 1), None);
    }
}
