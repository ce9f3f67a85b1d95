//! Edits of a text as changes of its lines.

use crate::Edit;

/// Lines `from..to` of the source (from 0) become `new`.
#[derive(Debug)]
pub struct Change {
    /// First line of the source that changes.
    pub from: usize,
    /// The line behind the last that changes.
    pub to: usize,
    /// What stands in their place, with line ends.
    pub new: Vec<Vec<u8>>,
}

/// The edits by lines, in order: neighbouring changes stay apart, so that each changed line stands beside
/// what it becomes.
#[derive(Debug)]
pub struct Changes<'d> {
    source: &'d [u8],
    lines: &'d Lines,
    rest: &'d [Edit<&'d [u8]>],
}

/// The changes of lines that `edits` of `source` are; `lines` are those of the source.
#[must_use]
pub fn changes<'d>(source: &'d [u8], lines: &'d Lines, edits: &'d [Edit<&'d [u8]>]) -> Changes<'d> {
    Changes { source, lines, rest: edits }
}

impl Iterator for Changes<'_> {
    type Item = Change;

    fn next(&mut self) -> Option<Change> {
        let Self { source, lines, .. } = *self;
        while let Some(first) = self.rest.first() {
            let (from, mut to) = lines.touched(first);
            let mut count = 1;
            while let Some(next) = self.rest.get(count) {
                let (next_from, next_to) = lines.touched(next);
                if next_from >= to {
                    break;
                }
                to = to.max(next_to);
                count += 1;
            }
            let (these, later) = self.rest.split_at(count);
            self.rest = later;
            if let Some(change) = change(source, lines, from, to, these) {
                return Some(change);
            }
        }
        None
    }
}

/// What the lines `from..to` become; what stays equal at either end is left out.
fn change(
    source: &[u8],
    lines: &Lines,
    mut from: usize,
    mut to: usize,
    edits: &[Edit<&[u8]>],
) -> Option<Change> {
    let mut text = Vec::new();
    let mut at = lines.start(from);
    for edit in edits {
        let (start, end) = (edit.range.start as usize, edit.range.end as usize);
        text.extend_from_slice(source.get(at..start).unwrap_or_default());
        text.extend_from_slice(edit.text);
        at = end;
    }
    text.extend_from_slice(source.get(at..lines.start(to)).unwrap_or_default());
    let new_lines = Lines::new(&text);
    let mut new: Vec<Vec<u8>> = (0..new_lines.count()).map(|i| new_lines.of(&text, i).to_vec()).collect();
    while from < to && new.last().is_some_and(|n| n == lines.of(source, to - 1)) {
        new.pop();
        to -= 1;
    }
    let equal = (from..to).zip(&new).take_while(|(i, n)| lines.of(source, *i) == n.as_slice()).count();
    new.drain(..equal);
    from += equal;
    (from < to || !new.is_empty()).then_some(Change { from, to, new })
}

/// Where lines begin, by LF alone as in every tool that reads diffs.
#[derive(Debug)]
pub struct Lines {
    starts: Vec<usize>,
    end: usize,
}

impl Lines {
    /// The lines of a text.
    #[must_use]
    pub fn new(text: &[u8]) -> Self {
        let mut starts = vec![0];
        starts.extend(memchr::memchr_iter(b'\n', text).map(|at| at + 1));
        if starts.last() == Some(&text.len()) {
            starts.pop();
        }
        Self { starts, end: text.len() }
    }

    /// All lines of the text, each with its end.
    #[must_use]
    pub fn all<'t>(&self, text: &'t [u8]) -> Vec<&'t [u8]> {
        (0..self.count()).map(|line| self.of(text, line)).collect()
    }

    /// How many there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.starts.len()
    }

    fn start(&self, line: usize) -> usize {
        self.starts.get(line).copied().unwrap_or(self.end)
    }

    /// A line of the text, counted from 0, with its end; nothing behind the last.
    #[must_use]
    pub fn of<'t>(&self, text: &'t [u8], line: usize) -> &'t [u8] {
        text.get(self.start(line)..self.start(line + 1)).unwrap_or_default()
    }

    /// The lines an edit changes: `from..to`, empty where whole lines are put in between two.
    fn touched(&self, edit: &Edit<&[u8]>) -> (usize, usize) {
        let (start, end) = (edit.range.start as usize, edit.range.end as usize);
        let holding = |at: usize| self.starts.partition_point(|&s| s <= at).saturating_sub(1);
        let from = holding(start);
        if start == end && self.start(from) == start && edit.text.last() == Some(&b'\n') {
            return (from, from);
        }
        (from, (holding(end) + 1).min(self.count()))
    }
}

/// How many bytes two texts share at their beginning, and at the end of what is left, in whole letters.
#[must_use]
pub fn shared_ends(old: &str, new: &str) -> (usize, usize) {
    let same = |(a, b): &(u8, u8)| a == b;
    let mut start = old.bytes().zip(new.bytes()).take_while(same).count();
    while !old.is_char_boundary(start) {
        start -= 1;
    }
    let (old_rest, new_rest) = (&old[start..], &new[start..]);
    let reversed = old_rest.bytes().rev().zip(new_rest.bytes().rev());
    let mut end = reversed.take_while(same).count();
    while !old_rest.is_char_boundary(old_rest.len() - end) {
        end -= 1;
    }
    (start, end)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_of_two_bytes_are_shared_whole_or_not_at_all() {
        assert_eq!(shared_ends("MoveL p1,v5;", "MoveL p27,v5;"), (7, 4));
        // U+00E9 and U+00E8 share their first byte, U+00E9 and U+0129 their last.
        assert_eq!(shared_ends("xéy", "xèy"), (1, 1));
        assert_eq!(shared_ends("xéy", "xĩy"), (1, 1));
        assert_eq!(shared_ends("aaa", "aa"), (2, 0));
        assert_eq!(shared_ends("", "é"), (0, 0));
    }
}
