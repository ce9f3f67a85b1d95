//! A writer that passes on the first lines of a long text.

use std::io::{self, Write};

/// Passes on so many lines and counts the rest.
pub struct Cut<'w> {
    out: &'w mut dyn Write,
    left: usize,
    /// Lines that were not passed on.
    pub dropped: usize,
}

impl<'w> Cut<'w> {
    /// Passes `lines` lines on to `out`.
    pub fn new(out: &'w mut dyn Write, lines: usize) -> Self {
        Self { out, left: lines, dropped: 0 }
    }
}

impl Write for Cut<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut passed = 0;
        while self.left > 0 && passed < bytes.len() {
            let end = memchr::memchr(b'\n', &bytes[passed..]).map_or(bytes.len(), |at| passed + at + 1);
            self.out.write_all(&bytes[passed..end])?;
            if bytes[end - 1] == b'\n' {
                self.left -= 1;
            }
            passed = end;
        }
        self.dropped += memchr::memchr_iter(b'\n', &bytes[passed..]).count();
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_cut_is_counted() {
        let mut out = Vec::new();
        let mut cut = Cut::new(&mut out, 2);
        cut.write_all(b"a\nb").unwrap();
        cut.write_all(b"c\nd\ne\n").unwrap();
        assert_eq!(cut.dropped, 2);
        assert_eq!(out, b"a\nbc\n");
    }
}
