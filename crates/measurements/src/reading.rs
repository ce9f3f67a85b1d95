//! What a row of measurements saw: a point on the tool, a nest on the base, the touch of a fixed point, a length.

use nalgebra::Vector3;

/// What was seen at a row.
///
/// A fixed point stands still in the base's frame, where is unknown: an index into [`Measurements::fixed_points`].
///
/// [`Measurements::fixed_points`]: super::Measurements::fixed_points
#[derive(Clone, Debug, PartialEq)]
pub enum Reading {
    /// The target on the tool, in the instrument's frame.
    Point {
        /// In the instrument's frame, metres.
        position_m: Vector3<f64>,
    },
    /// A nest on base or floor, in the instrument's frame; the arm does not carry it.
    Nest {
        /// Index of the fixed point.
        fixed_point: usize,
        /// In the instrument's frame, metres.
        position_m: Vector3<f64>,
        /// Whether its row says where the arm stood, whose weight tilts the base.
        with_joints: bool,
    },
    /// The tip touches a fixed point: a closed loop without an instrument.
    Touch {
        /// Index of the fixed point.
        fixed_point: usize,
    },
    /// How far the target is from a fixed point: a draw-wire, a ballbar.
    Length {
        /// Index of the fixed point.
        fixed_point: usize,
        /// Distance from the fixed point, metres.
        length_m: f64,
    },
}

/// Numbers as an instrument gave them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coordinates {
    /// Metres; of a length the first alone.
    pub value_m: Vector3<f64>,
    /// How many of them were measured.
    pub count: usize,
}

impl Reading {
    /// The fixed point that takes part.
    #[must_use]
    pub fn fixed_point(&self) -> Option<usize> {
        match *self {
            Self::Point { .. } => None,
            Self::Nest { fixed_point, .. }
            | Self::Touch { fixed_point }
            | Self::Length { fixed_point, .. } => Some(fixed_point),
        }
    }

    /// Whether the arm takes part.
    #[must_use]
    pub fn involves_arm(&self) -> bool {
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

    /// The same to be changed.
    pub(super) fn position_mut(&mut self) -> Option<&mut Vector3<f64>> {
        match self {
            Self::Point { position_m } | Self::Nest { position_m, .. } => Some(position_m),
            Self::Touch { .. } | Self::Length { .. } => None,
        }
    }

    /// The numbers that an instrument gave; of a touch there is none.
    #[must_use]
    pub fn coordinates(&self) -> Option<Coordinates> {
        match *self {
            Self::Point { position_m } | Self::Nest { position_m, .. } => {
                Some(Coordinates { value_m: position_m, count: 3 })
            }
            Self::Length { length_m, .. } => {
                Some(Coordinates { value_m: Vector3::new(length_m, 0.0, 0.0), count: 1 })
            }
            Self::Touch { .. } => None,
        }
    }

    /// The same with another reading.
    #[must_use]
    pub fn with_coordinates_m(&self, coordinates_m: Vector3<f64>) -> Self {
        match *self {
            Self::Point { .. } => Self::Point { position_m: coordinates_m },
            Self::Nest { fixed_point, with_joints, .. } => {
                Self::Nest { fixed_point, position_m: coordinates_m, with_joints }
            }
            Self::Length { fixed_point, .. } => Self::Length { fixed_point, length_m: coordinates_m.x },
            Self::Touch { fixed_point } => Self::Touch { fixed_point },
        }
    }

    /// The same read by an instrument whose unit is `factor` times as long.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        self.coordinates().map_or_else(|| self.clone(), |read| self.with_coordinates_m(read.value_m * factor))
    }
}
