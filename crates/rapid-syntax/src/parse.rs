//! From bytes to a tree.

use super::input::{ParseState, Text};
use super::module::file;
use super::tree::Tree;
use super::warning::Warning;

/// The tree of a file and what could not be read as it stands.
///
/// Takes any bytes, in time linear in their number and on a small stack. A source of 4 GiB and more is
/// one opaque node up to there: ranges are 32 bits wide.
#[must_use]
pub fn parse(source: &[u8]) -> (Tree, Vec<Warning>) {
    parse_with(source, true)
}

/// The same by the productions of the grammar alone, without the scans that pass the common forms: slower, and what
/// tests hold [`parse`] to.
#[must_use]
pub fn parse_by_productions(source: &[u8]) -> (Tree, Vec<Warning>) {
    parse_with(source, false)
}

fn parse_with(source: &[u8], plain_forms: bool) -> (Tree, Vec<Warning>) {
    let source = source.get(..u32::MAX as usize).unwrap_or(source);
    let mut state = ParseState::new(source);
    state.plain_forms = plain_forms;
    let tree = file(Text::new(source, &state));
    (tree, state.into_warnings())
}
