//! Where the lines of a text begin, as an editor counts them.

use super::TextRange;

/// Where the lines of a file begin; a line ends after LF, after CR LF, or after a CR that no LF follows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LineIndex {
    starts: Vec<u32>,
    /// The number of each line in the whole text, where this is the index of parts of one; else empty.
    numbers: Vec<u32>,
}

impl LineIndex {
    /// The index of `source`.
    #[must_use]
    pub fn new(source: &[u8]) -> Self {
        let mut starts = vec![0];
        for at in memchr::memchr2_iter(b'\n', b'\r', source) {
            if source[at] == b'\r' && source.get(at + 1) == Some(&b'\n') {
                continue;
            }
            starts.push(at as u32 + 1);
        }
        Self { starts, numbers: Vec::new() }
    }

    /// The index of what is left where of a text only the ranges `kept` (in order, apart from each other) are put together; lines
    /// keep their numbers.
    #[must_use]
    pub fn of_parts(&self, kept: &[TextRange]) -> Self {
        let mut parts = Self::default();
        let mut at = 0;
        for range in kept.iter().filter(|range| !range.is_empty()) {
            let first = self.position(range.start);
            let inside =
                self.starts.iter().enumerate().skip(first + 1).take_while(|(_, start)| **start < range.end);
            let begin = std::iter::once((first, &range.start)).chain(inside);
            for (position, start) in begin {
                parts.starts.push(at + start - range.start);
                parts.numbers.push(self.number(position));
            }
            at += range.end - range.start;
        }
        parts
    }

    /// Which of the known lines a byte is in.
    fn position(&self, offset: u32) -> usize {
        self.starts.partition_point(|&s| s <= offset).saturating_sub(1)
    }

    fn number(&self, position: usize) -> u32 {
        self.numbers.get(position).copied().unwrap_or(position as u32 + 1)
    }

    /// The line of a byte, counted from 1.
    #[must_use]
    pub fn line(&self, offset: u32) -> u32 {
        self.number(self.position(offset))
    }

    /// The column of a byte in its line, in bytes, counted from 1.
    #[must_use]
    pub fn column(&self, offset: u32) -> u32 {
        offset - self.starts.get(self.position(offset)).copied().unwrap_or(0) + 1
    }

    /// The first byte of a line (from 1); past the last line, that of the last.
    #[must_use]
    pub fn start_of(&self, line: u32) -> u32 {
        let position = match self.numbers.is_empty() {
            true => line.saturating_sub(1) as usize,
            false => self.numbers.partition_point(|&number| number < line),
        };
        self.starts.get(position).or(self.starts.last()).copied().unwrap_or(0)
    }

    /// Number of lines.
    #[must_use]
    pub fn lines(&self) -> u32 {
        self.starts.len().checked_sub(1).map_or(0, |last| self.number(last))
    }
}

#[cfg(test)]
mod tests {
    use super::{LineIndex, TextRange};

    #[test]
    fn lines_end_after_lf_crlf_and_lone_cr() {
        let index = LineIndex::new(b"a\r\nbc\n\rd\r");
        assert_eq!(index.lines(), 5);
        assert_eq!([0, 2, 3, 5, 6, 7, 8].map(|o| index.line(o)), [1, 1, 2, 2, 3, 4, 4]);
        assert_eq!((index.column(4), index.start_of(4), index.start_of(9)), (2, 7, 9));
    }

    #[test]
    fn parts_of_a_text_keep_the_numbers_of_their_lines() {
        let text = b"one\ntwo\nthree\nfour\nfive";
        let at = |word: &str| text.windows(word.len()).position(|w| w == word.as_bytes()).unwrap() as u32;
        // "one\ntwo" and "ve" are left: "one\ntwove".
        let kept = [TextRange::new(0, at("two") + 3), TextRange::new(at("ve"), text.len() as u32)];
        let index = LineIndex::new(text).of_parts(&kept);
        assert_eq!([0, 3, 4, 6, 7, 8].map(|o| index.line(o)), [1, 1, 2, 2, 5, 5]);
        assert_eq!((index.start_of(2), index.start_of(5), index.lines()), (4, 7, 5));
    }
}
