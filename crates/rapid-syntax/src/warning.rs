//! What a reader warns of.

use crate::diagnostic::TextRange;

/// A place that is not read as the language has it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// The bytes it is about.
    pub range: TextRange,
    /// Stable name of its kind, `syntax::what`.
    pub code: &'static str,
    /// What is the matter.
    pub message: String,
}
