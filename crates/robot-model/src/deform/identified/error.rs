//! Why a model's file cannot be read.

use rapid_syntax::diagnostic::Diagnostic;
use thiserror::Error;

/// Why a model cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum ModelError {
    /// The text is not TOML.
    #[error("model, line {line}: {message}")]
    Toml {
        /// Line in the file, from 1.
        line: usize,
        /// What the TOML reader says.
        message: String,
    },
    /// A key or value that makes no model.
    #[error("model, {place}: {problem}")]
    Value {
        /// The table and the key.
        place: String,
        /// What is wrong with it.
        problem: String,
    },
}

impl From<ModelError> for Diagnostic {
    fn from(error: ModelError) -> Self {
        let code = match error {
            ModelError::Toml { .. } => "model::toml",
            ModelError::Value { .. } => "model::value",
        };
        Self::error(code, error.to_string()).help("docs/MODEL.md describes the file")
    }
}
