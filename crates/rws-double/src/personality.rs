//! Which RobotWare the double is.

use std::fmt;

/// A generation of RobotWare.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Personality {
    /// IRC5: digest over HTTP.
    Rw6,
    /// OmniCore: TLS and basic authentication.
    Rw7,
    /// OmniCore with control stations.
    Rw8,
}

impl Personality {
    /// The three personalities, oldest first.
    pub const ALL: [Self; 3] = [Self::Rw6, Self::Rw7, Self::Rw8];

    /// Whether it speaks TLS.
    #[must_use]
    pub fn is_tls(self) -> bool {
        self != Self::Rw6
    }

    pub(crate) fn version(self) -> &'static str {
        match self {
            Self::Rw6 => "6.16.0033",
            Self::Rw7 => "7.21.0+229",
            Self::Rw8 => "8.2.1+1023",
        }
    }
}

impl fmt::Display for Personality {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Rw6 => "RobotWare 6",
            Self::Rw7 => "RobotWare 7",
            Self::Rw8 => "RobotWare 8",
        })
    }
}
