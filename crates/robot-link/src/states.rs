//! Mode and execution, as a controller tells them.

use std::fmt;

/// Operating mode: automatic, or manual at reduced or full speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Automatic: the pendant's enabling device is not needed.
    Auto,
    /// Manual at reduced speed, at most 250 mm/s.
    ManualReduced,
    /// Manual at full speed.
    ManualFull,
    /// Between two modes, starting, or not known.
    Changing,
}

impl Mode {
    /// Whether the operator decides at the pendant.
    #[must_use]
    pub fn is_manual(self) -> bool {
        matches!(self, Self::ManualReduced | Self::ManualFull)
    }
}

impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Auto => "automatic",
            Self::ManualReduced => "manual reduced speed",
            Self::ManualFull => "manual full speed",
            Self::Changing => "no mode (it is being changed)",
        })
    }
}

/// Whether a program runs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Execution {
    /// A RAPID program runs.
    Running,
    /// All RAPID programs stand still.
    Stopped,
    /// A word that is not known: taken as running.
    Other(String),
}

impl fmt::Display for Execution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Running => "running",
            Self::Stopped => "stopped",
            Self::Other(word) => word,
        })
    }
}
