//! What a file is that stands where a result is to go, as far as its bytes tell.

use rapid_compensation::emit::is_as_written;
use rapid_program::module_facts::EMITTED_MARK;

/// A module that was emitted by an earlier run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum EarlierResult {
    /// Byte for byte as it was written.
    AsWritten,
    /// Changed since it was written: touched up, or saved back by a controller.
    Altered,
}

impl EarlierResult {
    /// `None` where the bytes hold no module that was emitted.
    pub(crate) fn of(bytes: &[u8]) -> Option<Self> {
        if !is_emitted(bytes) {
            return None;
        }
        Some(if is_as_written(bytes) == Some(true) { Self::AsWritten } else { Self::Altered })
    }

    /// Whether the bytes hold an emitted module with a clock of its own.
    pub(crate) fn has_clock(bytes: &[u8]) -> bool {
        is_emitted(bytes) && memchr::memmem::find(bytes, b"PROC tcUpdate").is_some()
    }
}

fn is_emitted(bytes: &[u8]) -> bool {
    memchr::memmem::find(bytes, EMITTED_MARK.as_bytes()).is_some()
}
