//! How an effect shows over the time of a measurement; knows no effect by name.

use serde::{Serialize, Serializer};
use std::fmt;

/// How an effect shows over the time of a measurement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimeCourse {
    /// The same from the first row to the last.
    Constant,
    /// Grows or fades over the measurement.
    Drift,
    /// Begins at one moment.
    Step,
}

impl TimeCourse {
    /// The word in every file.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Constant => "constant",
            Self::Drift => "drift",
            Self::Step => "step",
        }
    }
}

impl fmt::Display for TimeCourse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl Serialize for TimeCourse {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}
