//! A text that is made of its source edit by edit, from its beginning to its end: what an edit puts in is written where it stays.

use crate::diagnostic::TextRange;
use crate::edit::{Edit, EditError, check_place};

/// What was made of a source so far.
#[derive(Debug)]
pub struct Rewrite<'s> {
    source: &'s [u8],
    /// The range that was replaced last.
    last: TextRange,
    bytes: Vec<u8>,
    replaced: Vec<Replaced>,
}

/// A range of a source that was replaced, and by how many bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Replaced {
    /// In the source; empty where bytes were put in.
    pub range: TextRange,
    /// How many bytes stand there now.
    pub length: u32,
}

/// Which replacement it was, and where its text begins.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    nth: usize,
    from: usize,
}

impl<'s> Rewrite<'s> {
    /// Nothing is made yet.
    #[must_use]
    pub fn new(source: &'s [u8]) -> Self {
        Self { source, last: TextRange::empty(0), bytes: Vec::new(), replaced: Vec::new() }
    }

    /// Copies the source up to `range`, in place of which `write` appends what it puts there; gives what `write` gives, too.
    ///
    /// # Errors
    /// [`EditError`] where the range begins before the end of the last one, or does not lie in the source; `write` is not called then.
    pub fn replace_with<R>(
        &mut self,
        range: TextRange,
        write: impl FnOnce(&mut Vec<u8>) -> R,
    ) -> Result<(Place, R), EditError> {
        check_place(self.source, self.last, range)?;
        self.bytes.extend_from_slice(&self.source[self.last.end as usize..range.start as usize]);
        self.last = range;
        let place = Place { nth: self.replaced.len(), from: self.bytes.len() };
        let given = write(&mut self.bytes);
        let length = (self.bytes.len() - place.from) as u32;
        self.replaced.push(Replaced { range, length });
        Ok((place, given))
    }

    /// Copies the source up to `range`, in place of which `text` stands.
    ///
    /// # Errors
    /// [`EditError`] where the range begins before the end of the last one, or does not lie in the source.
    pub fn replace(&mut self, range: TextRange, text: &[u8]) -> Result<Place, EditError> {
        let (place, ()) = self.replace_with(range, |bytes| bytes.extend_from_slice(text))?;
        Ok(place)
    }

    /// Puts another text where one was put before: at no cost for what stands behind it where both are of one length.
    pub fn exchange(&mut self, place: Place, text: &[u8]) {
        let Some(replaced) = self.replaced.get_mut(place.nth) else { return };
        let before = place.from..place.from + replaced.length as usize;
        replaced.length = text.len() as u32;
        match self.bytes.get_mut(before.clone()) {
            Some(bytes) if bytes.len() == text.len() => bytes.copy_from_slice(text),
            _ => drop(self.bytes.splice(before, text.iter().copied())),
        }
    }

    /// All of it, with the rest of the source; and what was replaced, in source order.
    #[must_use]
    pub fn finish(mut self) -> (Vec<u8>, Vec<Replaced>) {
        self.bytes.extend_from_slice(&self.source[self.last.end as usize..]);
        self.replaced.retain(|replaced| replaced.length > 0 || replaced.range.start < replaced.range.end);
        (self.bytes, self.replaced)
    }
}

/// The edits that made `bytes`, by what they replaced, in source order.
#[must_use]
pub fn edits_of<'t>(bytes: &'t [u8], replaced: &[Replaced]) -> Vec<Edit<&'t [u8]>> {
    // By how much the new text is further on than the source, at what comes next.
    let mut shift = 0_isize;
    let edit = |&Replaced { range, length }: &Replaced| {
        let from = (range.start as usize).saturating_add_signed(shift);
        let to = from + length as usize;
        shift = to as isize - range.end as isize;
        Edit { range, text: bytes.get(from..to).unwrap_or_default() }
    };
    replaced.iter().map(edit).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edit::apply;

    const SOURCE: &[u8] = b"MoveL p10,v100;";

    #[test]
    fn a_text_made_piece_by_piece_is_that_of_its_edits() {
        let mut text = Rewrite::new(SOURCE);
        let start = text.replace(TextRange::empty(0), b"start; ").unwrap();
        text.replace(TextRange::empty(0), b"").unwrap();
        text.replace(TextRange::new(6, 9), b"tcp10{tcK()}").unwrap();
        let write = |bytes: &mut Vec<u8>| {
            assert_eq!(bytes, b"start; MoveL tcp10{tcK()},");
            bytes.extend_from_slice(b"v50");
        };
        text.replace_with(TextRange::new(10, 14), write).unwrap();
        for (begin, made) in [("Start; ", "Start; MoveL tcp10{tcK()},v50;"), ("", "MoveL tcp10{tcK()},v50;")]
        {
            let mut text = Rewrite { bytes: text.bytes.clone(), replaced: text.replaced.clone(), ..text };
            text.exchange(start, begin.as_bytes());
            let (bytes, replaced) = text.finish();
            assert_eq!(String::from_utf8_lossy(&bytes), made);
            let edits = edits_of(&bytes, &replaced);
            assert_eq!(edits.len(), if begin.is_empty() { 2 } else { 3 });
            assert_eq!(
                edits[edits.len() - 2],
                Edit { range: TextRange::new(6, 9), text: &b"tcp10{tcK()}"[..] }
            );
            assert_eq!(apply(SOURCE, &edits).unwrap(), bytes);
        }
    }

    #[test]
    fn what_cannot_be_made_is_refused() {
        let mut text = Rewrite::new(SOURCE);
        text.replace(TextRange::new(6, 9), b"").unwrap();
        let (before, outside) = (TextRange::new(8, 10), TextRange::new(14, 16));
        assert_eq!(text.replace(before, b"x").err(), Some(EditError::Overlap(TextRange::new(6, 9), before)));
        assert_eq!(text.replace(outside, b"x").err(), Some(EditError::Outside(outside, SOURCE.len())));
        assert_eq!(text.finish().0, b"MoveL ,v100;");
    }
}
