//! What is diagnosed: measurements of one robot as stations; knows nothing of models and effects.

use measurements::{Measurements, Stations};
use robot_model::robot::SerialArm;

/// Measurements of one robot, and the stations that they were gathered to.
#[derive(Clone, Copy)]
pub(super) struct MeasuredRobot<'a> {
    /// The nominal arm, as its model says.
    pub robot: &'a SerialArm,
    /// Rows as read, seen from one stand of the instrument.
    pub measurements: &'a Measurements,
    /// Means of rows of one pose, target and time.
    pub stations: &'a Stations,
}

impl MeasuredRobot<'_> {
    /// Lines in the file of the rows with these indices.
    #[must_use]
    pub(super) fn lines<'r>(&self, rows: impl Iterator<Item = &'r usize>) -> Vec<u64> {
        rows.filter_map(|&row| self.measurements.rows.get(row)).map(|row| row.line).collect()
    }
}
