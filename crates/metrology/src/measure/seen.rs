//! What a row of measurements saw: a point on the tool, a nest on the base, the touch of a fixed point, a length.

use nalgebra::Vector3;

/// What was seen at a row.
///
/// A place is a point that stands still in the base's frame, unknown: an index into [`Measurements::places`].
///
/// [`Measurements::places`]: super::Measurements::places
#[derive(Clone, Debug, PartialEq)]
pub enum Seen {
    /// The target on the tool, in the instrument's frame.
    Point {
        /// Metres.
        position_m: Vector3<f64>,
    },
    /// A nest on base or floor, in the instrument's frame; the arm has no part in it.
    Nest {
        /// Which.
        place: usize,
        /// Metres.
        position_m: Vector3<f64>,
    },
    /// The tip touches a fixed point: a closed loop without an instrument.
    Touch {
        /// Which.
        place: usize,
    },
    /// How far the target is from a fixed point: a draw-wire, a ballbar.
    Length {
        /// Which.
        place: usize,
        /// Metres.
        length_m: f64,
    },
}

impl Seen {
    /// The fixed place that takes part.
    #[must_use]
    pub fn place(&self) -> Option<usize> {
        match *self {
            Self::Point { .. } => None,
            Self::Nest { place, .. } | Self::Touch { place } | Self::Length { place, .. } => Some(place),
        }
    }

    /// Whether the arm takes part.
    #[must_use]
    pub fn by_arm(&self) -> bool {
        !matches!(self, Self::Nest { .. })
    }

    /// The position in the instrument's frame, metres, where there is one.
    #[must_use]
    pub fn position_m(&self) -> Option<Vector3<f64>> {
        match *self {
            Self::Point { position_m } | Self::Nest { position_m, .. } => Some(position_m),
            Self::Touch { .. } | Self::Length { .. } => None,
        }
    }

    /// The numbers that an instrument gave, metres, and how many they are; of a touch there is none.
    #[must_use]
    pub fn reading_m(&self) -> Option<(Vector3<f64>, usize)> {
        match *self {
            Self::Point { position_m } | Self::Nest { position_m, .. } => Some((position_m, 3)),
            Self::Length { length_m, .. } => Some((Vector3::new(length_m, 0.0, 0.0), 1)),
            Self::Touch { .. } => None,
        }
    }

    /// The same with another reading.
    #[must_use]
    pub fn with_reading_m(&self, reading_m: Vector3<f64>) -> Self {
        match *self {
            Self::Point { .. } => Self::Point { position_m: reading_m },
            Self::Nest { place, .. } => Self::Nest { place, position_m: reading_m },
            Self::Length { place, .. } => Self::Length { place, length_m: reading_m.x },
            Self::Touch { place } => Self::Touch { place },
        }
    }

    /// The same read by an instrument whose unit is `factor` times as long.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        self.reading_m()
            .map_or_else(|| self.clone(), |(reading_m, _)| self.with_reading_m(reading_m * factor))
    }
}
