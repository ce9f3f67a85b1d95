//! How a command ended, as the exit code says it.

use std::process::ExitCode;

/// How a command ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Done as asked: exit 0.
    Done,
    /// Found a difference, or out of tolerance: exit 1.
    Difference,
    /// Could not, or refused: exit 2.
    Refused,
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        match outcome {
            Outcome::Done => ExitCode::SUCCESS,
            Outcome::Difference => ExitCode::from(1),
            Outcome::Refused => ExitCode::from(2),
        }
    }
}
