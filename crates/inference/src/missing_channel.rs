//! A column that is not in the file, and that would tell what the gap follows.

use crate::gp_alternative::GpAlternative;
use serde::{Serialize, Serializer};

/// A column that is not in the file, and that would tell what the gap follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MissingChannel {
    /// From which side each joint came.
    Direction,
    /// What hung at the tool at each row.
    Payload,
    /// When each row was measured.
    Time,
}

impl MissingChannel {
    /// The name in JSON: that of the column, `dir` for `dir1` to `dir6`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Direction => "dir",
            Self::Payload => "payload_kg",
            Self::Time => "t_min",
        }
    }

    /// The column that would tell what a structure follows; `timed`: the file has times.
    #[must_use]
    pub fn of(gp_alternative: GpAlternative, timed: bool) -> Option<Self> {
        match gp_alternative {
            GpAlternative::HiddenLoad => Some(Self::Payload),
            GpAlternative::Time
            | GpAlternative::TimeFine
            | GpAlternative::TimeVaryingCause(_)
            | GpAlternative::ToolTime
            | GpAlternative::JointTime(_)
            | GpAlternative::JointTimeFine(_)
            | GpAlternative::Cycle(_)
            | GpAlternative::WanderingScale
                if !timed =>
            {
                Some(Self::Time)
            }
            _ => None,
        }
    }
}

impl Serialize for MissingChannel {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}
