//! RAPID text, losslessly: bytes in, a tree of byte ranges out, and edits over the source.
//!
//! The source bytes stay the truth: the tree holds only [`TextRange`]s, so an unedited file comes back
//! byte for byte whatever its encoding and line ends. Text that is not understood becomes an opaque node
//! with a warning, never a stop. Knows nothing of geometry or of what a name means.
//!
//! One function per production of `grammar/rapid.ebnf`, named as there.

pub mod diagnostic;

mod block;
pub mod comments;
mod declaration;
pub mod edit;
mod expression;
mod input;
mod lexical;
pub mod literal;
mod module;
mod numbers;
mod recover;
mod same;
pub mod source;
mod statement;
pub mod tree;
pub mod walk;
pub mod word;

pub use edit::{Edit, EditError, apply};
pub use literal::{number_value, string_value};
pub use numbers::parts_of_numbers;
pub use same::first_difference;
pub use source::SourceFile;
pub use word::{Word, fold, is_reserved, same_name};

use crate::diagnostic::TextRange;
use tree::Tree;

/// A place that is not read as the language has it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// Which bytes.
    pub range: TextRange,
    /// Stable name, `syntax::what`.
    pub code: &'static str,
    /// What is the matter.
    pub message: String,
}

/// The tree of a file and what could not be read as it stands.
///
/// Takes any bytes, in time linear in their number and on a small stack. A source of 4 GiB and more is
/// one opaque node up to there: ranges are 32 bits wide.
#[must_use]
pub fn parse(source: &[u8]) -> (Tree, Vec<Warning>) {
    let source = source.get(..u32::MAX as usize).unwrap_or(source);
    let state = input::State::new(source);
    let tree = module::file(input::Text::new(source, &state));
    (tree, state.into_warnings())
}
