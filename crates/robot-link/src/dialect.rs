//! The three generations of Robot Web Services, and what each wants to be sent.

use std::fmt;

/// A generation of Robot Web Services.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Dialect {
    /// RobotWare 6 (IRC5): digest, plain HTTP, `?json=1`.
    Rw6,
    /// RobotWare 7 (OmniCore): TLS, basic, versioned media types.
    Rw7,
    /// RobotWare 8 (OmniCore): as 7, with write access of control stations in place of mastership.
    Rw8,
}

impl Dialect {
    /// The three dialects, oldest first.
    pub const ALL: [Self; 3] = [Self::Rw6, Self::Rw7, Self::Rw8];

    /// Of a version as the controller states it, `7.21.0+229`.
    #[must_use]
    pub fn of_version(version: &str) -> Option<Self> {
        match version.trim().split('.').next()? {
            "6" => Some(Self::Rw6),
            "7" => Some(Self::Rw7),
            "8" => Some(Self::Rw8),
            _ => None,
        }
    }

    /// What answers are asked for in, where nothing else is wanted.
    pub(crate) fn accept(self) -> &'static str {
        match self {
            Self::Rw6 => "application/json",
            Self::Rw7 | Self::Rw8 => "application/hal+json;v=2.0",
        }
    }

    /// The media type of form fields; RobotWare 7 and 8 want it on requests without a body too.
    pub(crate) fn form_type(self) -> &'static str {
        match self {
            Self::Rw6 => "application/x-www-form-urlencoded",
            Self::Rw7 | Self::Rw8 => "application/x-www-form-urlencoded;v=2.0",
        }
    }

    /// The media type of a file.
    pub(crate) fn file_type(self) -> &'static str {
        match self {
            Self::Rw6 => "application/octet-stream",
            Self::Rw7 | Self::Rw8 => "application/octet-stream;v=2.0",
        }
    }

    /// What a websocket of events is asked for by.
    pub(crate) fn event_protocol(self) -> &'static str {
        match self {
            Self::Rw6 => "robapi2_subscription",
            Self::Rw7 | Self::Rw8 => "rws_subscription",
        }
    }
}

impl fmt::Display for Dialect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Rw6 => "RobotWare 6",
            Self::Rw7 => "RobotWare 7",
            Self::Rw8 => "RobotWare 8",
        })
    }
}
