//! Where the comment block of an emitted module stands.

use crate::emit::{header, insertion};
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{Module, ModuleItem};

/// The first comment of a block of ours in a module.
pub(super) fn header_of(bytes: &[u8], module: &Module) -> Option<TextRange> {
    module.items.iter().take_while(|item| !matches!(item, ModuleItem::Routine(_))).find_map(|item| match item
    {
        ModuleItem::Comment(range) if header::begins(range.of(bytes)) => Some(*range),
        _ => None,
    })
}

/// The lines from `start` on, without line ends, as long as they are comments.
pub(super) fn comment_block(bytes: &[u8], start: u32) -> Vec<TextRange> {
    let mut lines = Vec::new();
    let mut at = start as usize;
    while at < bytes.len() {
        let eol = memchr::memchr2(b'\n', b'\r', &bytes[at..]).map_or(bytes.len(), |e| at + e);
        if bytes[at..eol].trim_ascii_start().first() != Some(&b'!') {
            break;
        }
        lines.push(TextRange::new(at as u32, eol as u32));
        at = insertion::past_eol(bytes, eol);
    }
    lines
}
