//! Faults that a measurement file gets where its rows and columns are put together by hand or by a script.

use serde::{Deserialize, Serialize};

/// What goes wrong with some rows or columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RowFault {
    /// Points in metres from a row on: another export.
    Metres,
    /// The instrument's last point again and again: the beam was lost.
    Frozen,
    /// Each point beside the joints of the row before it.
    OneLate,
    /// One joint in radians.
    Radians,
    /// One coordinate in inches.
    Inches,
    /// From a row on each point beside the joints of the row before its own: one was not taken, and the last row has none.
    OneEarly,
    /// Points in inches from a row on.
    RowsInInches,
    /// Joints rounded to a twentieth of a degree.
    FineRounding,
    /// The payload in grams.
    Grams,
    /// Temperatures in degrees Fahrenheit.
    Fahrenheit,
    /// One and the same `pose_id` in every row.
    OnePose,
}

impl RowFault {
    /// Every fault, in the order in which an exam draws them.
    pub const ALL: [Self; 11] = [
        Self::Metres,
        Self::Frozen,
        Self::OneLate,
        Self::Radians,
        Self::Inches,
        Self::OneEarly,
        Self::RowsInInches,
        Self::FineRounding,
        Self::Grams,
        Self::Fahrenheit,
        Self::OnePose,
    ];
}
