//! Edits over source bytes: sorted, non-overlapping replacements.

use crate::diagnostic::TextRange;
pub use crate::edit_text::EditText;
use std::ops::Deref;

/// Replace the bytes of `range` by `text`, its own or borrowed; an empty range inserts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit<T = EditText> {
    /// The bytes that are replaced.
    pub range: TextRange,
    /// The bytes that take their place.
    pub text: T,
}

/// Two edits of one list that cannot both be made, or one that lies outside the source.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum EditError {
    /// The two ranges overlap (two insertions at one place do not: they are made in their order).
    #[error("two edits overlap: bytes {}..{} and {}..{}", .0.start, .0.end, .1.start, .1.end)]
    Overlap(TextRange, TextRange),
    /// The range does not lie in the source.
    #[error("an edit of bytes {}..{} lies outside a source of {} bytes", .0.start, .0.end, .1)]
    Outside(TextRange, usize),
}

/// The source with all edits made; `edits` may come in any order.
///
/// # Errors
/// [`EditError`] names the edits that cannot be made; the source is then not changed at all.
pub fn apply<T: Deref<Target = [u8]>>(source: &[u8], edits: &[Edit<T>]) -> Result<Vec<u8>, EditError> {
    let grown: usize = edits.iter().map(|e| e.text.len()).sum();
    let mut out = Vec::with_capacity(source.len() + grown);
    let mut order: Vec<Edit<&[u8]>> =
        edits.iter().map(|Edit { range, text }| Edit { range: *range, text: &**text }).collect();
    sorting::by_key(&mut order, |edit| (edit.range.start, edit.range.end)); // stable: insertions at one place keep their order
    each_piece(source, order, |piece| {
        out.extend_from_slice(piece);
        true
    })?;
    Ok(out)
}

/// Whether a source with all `edits` made, which come in its order, is `expected`; without the memory of a text.
///
/// # Errors
/// [`EditError`] names the edits that cannot be made; where a difference stands before them, that is told.
pub fn gives<'a>(
    source: &'a [u8],
    edits: impl IntoIterator<Item = Edit<&'a [u8]>>,
    expected: &[u8],
) -> Result<bool, EditError> {
    let mut left = Some(expected);
    each_piece(source, edits, |piece| {
        left = left.and_then(|left| left.strip_prefix(piece));
        left.is_some()
    })?;
    Ok(left.is_some_and(<[u8]>::is_empty))
}

/// Calls `visit` for the pieces of the source with all edits made, in their order, until it says no.
fn each_piece<'a>(
    source: &'a [u8],
    edits: impl IntoIterator<Item = Edit<&'a [u8]>>,
    mut visit: impl FnMut(&'a [u8]) -> bool,
) -> Result<(), EditError> {
    let mut last = TextRange::empty(0);
    for Edit { range, text } in edits {
        check_place(source, last, range)?;
        if !visit(&source[last.end as usize..range.start as usize]) || !visit(text) {
            return Ok(());
        }
        last = range;
    }
    visit(&source[last.end as usize..]);
    Ok(())
}

/// Whether an edit of `range` can be made behind that of `last`.
pub(crate) fn check_place(source: &[u8], last: TextRange, range: TextRange) -> Result<(), EditError> {
    if range.end as usize > source.len() {
        return Err(EditError::Outside(range, source.len()));
    }
    if range.start < last.end {
        return Err(EditError::Overlap(last, range));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edit(start: u32, end: u32, text: &str) -> Edit {
        Edit { range: TextRange::new(start, end), text: text.as_bytes().into() }
    }

    #[test]
    fn edits_are_made_in_source_order_and_the_rest_stays() {
        let out = apply(
            b"MoveL p10,v100;",
            &[edit(10, 14, "v50"), edit(6, 9, "tcp10{tcK()}"), edit(0, 0, "start; ")],
        );
        assert_eq!(out.unwrap(), b"start; MoveL tcp10{tcK()},v50;");
        assert_eq!(apply::<EditText>(b"abc", &[]).unwrap(), b"abc");
    }

    #[test]
    fn what_edits_give_is_told_without_making_it() {
        fn edit(start: u32, end: u32, text: &str) -> Edit<&[u8]> {
            Edit { range: TextRange::new(start, end), text: text.as_bytes() }
        }
        let edits = || [edit(0, 0, "start; "), edit(6, 9, "tcp10{tcK()}"), edit(10, 14, "v50")];
        let source = b"MoveL p10,v100;";
        let made = apply(source, &edits()).unwrap();
        assert_eq!(gives(source, edits(), &made), Ok(true));
        for at in 0..made.len() {
            let mut other = made.clone();
            other[at] ^= 1;
            assert_eq!(gives(source, edits(), &other), Ok(false), "{at}");
            assert_eq!(gives(source, edits(), &made[..at]), Ok(false), "{at}");
        }
        assert_eq!(gives(source, edits(), &[&made[..], b";"].concat()), Ok(false));
        let overlap = [edit(0, 3, "x"), edit(2, 4, "y")];
        assert_eq!(gives(b"abcdef", overlap.clone(), b"x"), apply(b"abcdef", &overlap).map(|_| true));
    }

    #[test]
    fn overlap_names_both_and_outside_is_refused() {
        assert_eq!(
            apply(b"abcdef", &[edit(0, 3, "x"), edit(2, 4, "y")]),
            Err(EditError::Overlap(TextRange::new(0, 3), TextRange::new(2, 4)))
        );
        assert_eq!(apply(b"abc", &[edit(2, 4, "y")]), Err(EditError::Outside(TextRange::new(2, 4), 3)));
    }
}
