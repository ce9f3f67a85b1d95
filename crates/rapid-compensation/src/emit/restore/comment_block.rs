//! Where the comment block of an emitted module stands.

use crate::emit::checksum::MARK;
use crate::emit::{header, insertion};
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{Module, ModuleItem};
use std::borrow::Cow;

/// The line end that a transfer as text makes of CR LF, where it takes LF for the end of a line and writes CR LF for it.
const DOUBLED: &[u8] = b"\r\r\n";

/// A module whose comment block has such line ends as it was before them; another as it is.
pub(super) fn with_single_ends(bytes: &[u8]) -> Cow<'_, [u8]> {
    let begins = memchr::memmem::find(bytes, MARK.as_bytes()).unwrap_or(bytes.len());
    let rest = &bytes[begins..];
    let eol = memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
    if !rest[eol..].starts_with(DOUBLED) {
        return Cow::Borrowed(bytes);
    }
    let (mut single, mut from) = (Vec::with_capacity(bytes.len()), 0);
    for at in memchr::memmem::find_iter(bytes, DOUBLED) {
        single.extend_from_slice(&bytes[from..at]);
        from = at + 1;
    }
    single.extend_from_slice(&bytes[from..]);
    Cow::Owned(single)
}

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
        at = if bytes[eol..].starts_with(DOUBLED) {
            eol + DOUBLED.len()
        } else {
            insertion::past_eol(bytes, eol)
        };
    }
    lines
}
