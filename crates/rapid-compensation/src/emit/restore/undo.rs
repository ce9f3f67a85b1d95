//! What makes an original of an emitted file: ranges that are taken out, and texts that are put in their place.

use rapid_syntax::Edit;
use rapid_syntax::diagnostic::TextRange;

/// Edits of an emitted file. Nearly all take something out, or put back what stands elsewhere in the file.
#[derive(Default)]
pub(super) struct UndoEdits {
    removed: Vec<TextRange>,
    put: Vec<(TextRange, UndoText)>,
}

/// What is put back.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum UndoText {
    /// What stands in the emitted file there.
    At(TextRange),
    /// A text that stands nowhere in it.
    Own(Vec<u8>),
}

impl UndoText {
    /// The text, `bytes` being the emitted file.
    pub(super) fn of<'t>(&'t self, bytes: &'t [u8]) -> &'t [u8] {
        match self {
            Self::At(range) => range.of(bytes),
            Self::Own(text) => text,
        }
    }

    /// The text as it goes into a comment: on one line, without comments of its own.
    pub(super) fn on_one_line(self, bytes: &[u8]) -> Self {
        let lines = self.of(bytes);
        if memchr::memchr2(b'\n', b'\r', lines).is_none() {
            return self;
        }
        let parts = lines.split(|byte| matches!(byte, b'\n' | b'\r'));
        let code = parts.map(|line| line.split(|byte| *byte == b'!').next().unwrap_or_default().trim_ascii());
        Self::Own(code.collect::<Vec<_>>().concat())
    }
}

impl UndoEdits {
    /// Takes a range out.
    pub(super) fn remove(&mut self, range: TextRange) {
        self.removed.push(range);
    }

    /// Puts a text in the place of a range.
    pub(super) fn put(&mut self, range: TextRange, text: UndoText) {
        self.put.push((range, text));
    }

    /// Puts all in the order of their places.
    pub(super) fn put_in_order(&mut self) {
        let place = |range: &TextRange| (range.start, range.end);
        // To sort takes memory when most is in use.
        if !self.removed.is_sorted_by_key(place) {
            sorting::by_key(&mut self.removed, place);
        }
        if !self.put.is_sorted_by_key(|(range, _)| place(range)) {
            sorting::by_key(&mut self.put, |(range, _)| place(range));
        }
    }

    /// The edits of the emitted file `bytes`, in the order of their places once they are sorted.
    pub(super) fn of<'t>(&'t self, bytes: &'t [u8]) -> impl Iterator<Item = Edit<&'t [u8]>> {
        let (mut removed, mut put) = (self.removed.iter().peekable(), self.put.iter().peekable());
        std::iter::from_fn(move || {
            let next_put = put.peek().map(|(range, _)| (range.start, range.end));
            let is_next = |range: &&TextRange| next_put.is_none_or(|put| (range.start, range.end) <= put);
            if let Some(&range) = removed.next_if(is_next) {
                return Some(Edit { range, text: &[][..] });
            }
            put.next().map(|(range, text)| Edit { range: *range, text: text.of(bytes) })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_removed_and_what_is_put_come_in_the_order_of_their_places() {
        let mut edits = UndoEdits::default();
        edits.put(TextRange::new(7, 9), UndoText::At(TextRange::new(0, 2)));
        edits.remove(TextRange::new(10, 12));
        edits.put(TextRange::new(2, 2), UndoText::Own(b"own".to_vec()));
        edits.remove(TextRange::new(2, 5));
        edits.put_in_order();
        let all: Vec<_> = edits.of(b"ab").map(|edit| (edit.range.start, edit.range.end, edit.text)).collect();
        assert_eq!(all, [(2, 2, &b"own"[..]), (2, 5, b""), (7, 9, b"ab"), (10, 12, b"")]);
    }

    #[test]
    fn what_goes_into_a_comment_is_one_line() {
        let one = |text: &str| UndoText::Own(text.into()).on_one_line(b"").of(b"").to_vec();
        assert_eq!(one("[[1,2,3], ! here\r\n   [1,0,0,0],\n[0,0,0,0]]"), b"[[1,2,3],[1,0,0,0],[0,0,0,0]]");
        assert_eq!(one("Offs(p1, 0,0,1)"), b"Offs(p1, 0,0,1)");
    }
}
