//! Where the lines of a text begin, as an editor counts them.

/// Where the lines of a file begin; a line ends after LF, after CR LF, or after a CR that no LF follows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LineIndex {
    starts: Vec<u32>,
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
        Self { starts }
    }

    /// Which of the known lines a byte is in.
    fn position(&self, offset: u32) -> usize {
        self.starts.partition_point(|&s| s <= offset).saturating_sub(1)
    }

    /// The line of a byte, counted from 1.
    #[must_use]
    pub fn line(&self, offset: u32) -> u32 {
        self.position(offset) as u32 + 1
    }

    /// The column of a byte in its line, in bytes, counted from 1.
    #[must_use]
    pub fn column(&self, offset: u32) -> u32 {
        offset - self.starts.get(self.position(offset)).copied().unwrap_or(0) + 1
    }

    /// The first byte of a line (from 1); past the last line, that of the last.
    #[must_use]
    pub fn start_of(&self, line: u32) -> u32 {
        let position = line.saturating_sub(1) as usize;
        self.starts.get(position).or(self.starts.last()).copied().unwrap_or(0)
    }

    /// Number of lines in the text.
    #[must_use]
    pub fn lines(&self) -> u32 {
        self.starts.len() as u32
    }
}

#[cfg(test)]
mod tests {
    use super::LineIndex;

    #[test]
    fn lines_end_after_lf_crlf_and_lone_cr() {
        let index = LineIndex::new(b"a\r\nbc\n\rd\r");
        assert_eq!(index.lines(), 5);
        assert_eq!([0, 2, 3, 5, 6, 7, 8].map(|o| index.line(o)), [1, 1, 2, 2, 3, 4, 4]);
        assert_eq!((index.column(4), index.start_of(4), index.start_of(9)), (2, 7, 9));
    }
}
