//! Any text is read.

use crate::tree_check::check;
use rapid_syntax::{parse, parse_by_productions};

/// Read: no byte is lost, no node lies outside of the one that holds it, and the scans of common forms find what the productions
/// of the grammar find.
pub fn text(data: &[u8]) {
    assert!(parse(data) == parse_by_productions(data), "scanned to another tree than read");
    if let Err(problem) = check(data) {
        panic!("{problem}");
    }
}
