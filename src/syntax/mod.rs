//! RAPID text, losslessly: bytes in, a tree of byte ranges out, and edits over the source.
//!
//! The source bytes stay the truth: the tree holds only [`TextRange`](crate::diagnostic::TextRange)s, so
//! an unedited file comes back byte for byte whatever its encoding and line ends. Text that is not
//! understood becomes an opaque node with a warning, never a stop. Knows nothing of geometry or of what a
//! name means.

pub mod edit;
pub mod source;
pub mod tree;

pub use edit::{Edit, EditError, apply};
pub use source::{LineIndex, SourceFile};
