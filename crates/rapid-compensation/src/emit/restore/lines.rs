//! Lines of an emitted module, counted when first asked for: most are restored without a message.

use rapid_syntax::diagnostic::LineIndex;
use std::cell::OnceCell;

/// The lines of a text.
pub(super) struct Lines<'b> {
    bytes: &'b [u8],
    index: OnceCell<LineIndex>,
}

impl<'b> Lines<'b> {
    pub(super) fn new(bytes: &'b [u8]) -> Self {
        Self { bytes, index: OnceCell::new() }
    }

    /// The line of a byte, counted from 1.
    pub(super) fn line(&self, offset: u32) -> u32 {
        self.index.get_or_init(|| LineIndex::new(self.bytes)).line(offset)
    }
}
