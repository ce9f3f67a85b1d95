//! Units in which sizes of effects are reported; conversion factors are no business of this module.

use serde::{Serialize, Serializer};
use std::fmt;

/// The unit in which the size of an effect is reported.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SizeUnit {
    /// A shift of a frame or of a sliding joint.
    Millimetre,
    /// An angle of a joint.
    Radian,
    /// Compliance of a joint that turns, of a link, of the base.
    RadianPerNewtonMetre,
    /// Compliance of a joint that slides.
    MillimetrePerNewton,
    /// Coupling of a joint that turns into one that slides.
    MillimetrePerRadian,
    /// Coupling of a joint that slides into one that turns.
    RadianPerMillimetre,
    /// A ratio of like quantities, written `1`.
    One,
    /// A relative change of length.
    PartsPerMillion,
    /// A mass, of the payload.
    Kilogram,
}

impl SizeUnit {
    /// As written in every file and report.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Millimetre => "mm",
            Self::Radian => "rad",
            Self::RadianPerNewtonMetre => "rad/(N.m)",
            Self::MillimetrePerNewton => "mm/N",
            Self::MillimetrePerRadian => "mm/rad",
            Self::RadianPerMillimetre => "rad/mm",
            Self::One => "1",
            Self::PartsPerMillion => "ppm",
            Self::Kilogram => "kg",
        }
    }
}

impl fmt::Display for SizeUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.symbol())
    }
}

impl Serialize for SizeUnit {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.symbol())
    }
}
