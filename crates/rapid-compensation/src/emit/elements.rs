//! The elements of an array in its declaration, as ranges of the text.

use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::ranges_of_numbers;
use rapid_syntax::tree::{Expr, ExprKind};

/// The elements of an initial value in `bytes`, an array of so many dimensions, the last one fastest.
pub(super) fn elements(bytes: &[u8], init: &Expr, dims: usize) -> Vec<TextRange> {
    match (&init.kind, dims.checked_sub(1)) {
        (_, None) => vec![init.range],
        (ExprKind::Aggregate(all), Some(rest)) => {
            all.iter().flat_map(|part| elements(bytes, part, rest)).collect()
        }
        (ExprKind::Numbers, Some(_)) => {
            let parts = |all: Vec<TextRange>| -> Vec<TextRange> {
                all.into_iter().flat_map(|part| ranges_of_numbers(bytes, part)).collect()
            };
            (0..dims).fold(vec![init.range], |all, _| parts(all))
        }
        _ => Vec::new(),
    }
}
