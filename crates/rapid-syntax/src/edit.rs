//! Edits over source bytes: sorted, non-overlapping replacements.

use crate::diagnostic::TextRange;

/// Replace the bytes of `range` by `text`; an empty range inserts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// The bytes that are replaced.
    pub range: TextRange,
    /// The bytes that take their place.
    pub text: Vec<u8>,
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
pub fn apply(source: &[u8], edits: &[Edit]) -> Result<Vec<u8>, EditError> {
    let mut order: Vec<&Edit> = edits.iter().collect();
    order.sort_by_key(|e| (e.range.start, e.range.end)); // stable: insertions at one place keep their order
    let grown: usize = order.iter().map(|e| e.text.len()).sum();
    let mut out = Vec::with_capacity(source.len() + grown);
    let mut last = TextRange::empty(0);
    for edit in order {
        let range = edit.range;
        if range.end as usize > source.len() {
            return Err(EditError::Outside(range, source.len()));
        }
        if range.start < last.end {
            return Err(EditError::Overlap(last, range));
        }
        out.extend_from_slice(&source[last.end as usize..range.start as usize]);
        out.extend_from_slice(&edit.text);
        last = range;
    }
    out.extend_from_slice(&source[last.end as usize..]);
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edit(start: u32, end: u32, text: &str) -> Edit {
        Edit { range: TextRange::new(start, end), text: text.as_bytes().to_vec() }
    }

    #[test]
    fn edits_are_made_in_source_order_and_the_rest_stays() {
        let out = apply(
            b"MoveL p10,v100;",
            &[edit(10, 14, "v50"), edit(6, 9, "tcp10{tcK()}"), edit(0, 0, "start; ")],
        );
        assert_eq!(out.unwrap(), b"start; MoveL tcp10{tcK()},v50;");
        assert_eq!(apply(b"abc", &[]).unwrap(), b"abc");
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
