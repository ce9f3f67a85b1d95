//! RAPID text, losslessly: bytes in, a tree of byte ranges out, and edits over the source.
//!
//! The source bytes stay the truth: the tree holds only [`TextRange`](crate::diagnostic::TextRange)s, so an unedited file comes back
//! byte for byte whatever its encoding and line ends. Text that is not understood becomes an opaque node
//! with a warning, never a stop. Knows nothing of geometry or of what a name means.
//!
//! One function per production of `grammar/rapid.ebnf`, named as there.

pub mod diagnostic;

mod block;
mod block_head;
pub mod changed_lines;
mod data;
mod declaration;
mod difference;
pub mod edit;
mod edit_text;
mod ending;
mod expression;
mod input;
mod lexical;
pub mod literal;
mod module;
mod number_text;
mod numbers;
mod operator;
mod parse;
mod plain_list;
mod plain_statement;
mod recover;
mod rewrite;
mod simple_statement;
pub mod source;
#[cfg(test)]
mod test_programs;
pub mod tree;
pub mod walk;
mod warning;
pub mod word;

pub use difference::first_difference;
pub use edit::{Edit, EditError, EditText, apply, gives};
pub use literal::{leading_decimal, number_value, string_value};
pub use number_text::{num, operand, write_list, write_num};
pub use numbers::{parts_of_numbers, ranges_of_numbers};
pub use parse::{parse, parse_by_productions};
pub use rewrite::{Replaced, Rewrite, edits_of};
pub use source::SourceFile;
pub use warning::Warning;
pub use word::{Word, fold, is_reserved, same_name};
