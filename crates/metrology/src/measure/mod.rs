//! Measurement files: what a tracker, a probe or a draw-wire saw, and how it hangs on the robot.
//!
//! Reads the file, gathers repeats into stations, registers instrument and tool, and says when a file
//! contradicts itself or the robot. Knows nothing of effects.

mod check;
mod column_map;
mod error;
mod fault;
mod initial_guess;
mod iso9283;
mod join;
mod performance;
mod read;
mod reading;
mod refine;
mod register;
mod registration;
mod station;
mod table;
mod timestamp;
mod touch;

pub use check::{RowCheck, check_rows};
pub use column_map::ColumnMap;
pub use error::MeasureError;
pub use fault::{Fault, FaultKind, find_fault};
pub use iso9283::{Accuracy, Repeatability, accuracy, barycentre_m, orientation, repeatability};
pub use join::{Joined, MatchBy, join};
pub use performance::{
    ComparisonFrame, Performance, PerformanceAtTime, PerformanceError, PosePerformance, performance,
};
pub use reading::Reading;
pub use register::{FreeParameters, RegisterError, register, register_with};
pub use registration::Registration;
pub use station::{Repeats, Station, Stations, gather};
pub use table::{Line, Table};
pub use touch::{Touch, Touches};

use nalgebra::UnitQuaternion;
use rapid_syntax::diagnostic::Diagnostic;

/// One measured pose, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasurementRow {
    /// Line in the file, from 1.
    pub line: u64,
    /// `id`, where the file has it.
    pub id: Option<String>,
    /// Which commanded pose: rows with the same number repeat one.
    pub pose: usize,
    /// Which reflector or stylus, index into [`Measurements::targets`].
    pub target: usize,
    /// Minutes since cold start.
    pub t_min: Option<f64>,
    /// Joints; at a nest they say nothing.
    pub q_rad: [f64; 6],
    /// What was measured.
    pub reading: Reading,
    /// The measured orientation in the instrument's frame.
    pub orientation: Option<UnitQuaternion<f64>>,
    /// Sign of each joint's last motion before the pose.
    pub direction: Option<[i8; 6]>,
    /// Payload.
    pub payload_kg: Option<f64>,
    /// Temperature of each joint.
    pub joint_temperature_c: Option<[f64; 6]>,
    /// Temperature of the air.
    pub air_temperature_c: Option<f64>,
}

/// What three measured angles are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rotation {
    /// Roll, pitch, yaw about the instrument's x, y, z in turn, as in URDF; the same as moving z, y, x in reverse order.
    FixedXyz,
    /// About x, the turned y, the turned z: RoboDK's and Leica's T-Mac.
    MovingXyz,
    /// About z, the turned y, the turned x: KUKA's A, B, C, ABB's EulerZYX.
    MovingZyx,
    /// An axis times an angle.
    Vector,
}

/// Which optional columns the file has, complete for every row.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Channels {
    /// `pose_id`.
    pub pose_id: bool,
    /// `t_min`.
    pub time: bool,
    /// `qw, qx, qy, qz`.
    pub orientation: bool,
    /// `dir1` to `dir6`.
    pub direction: bool,
    /// `payload_kg`.
    pub payload: bool,
    /// `temp_j1_c` to `temp_j6_c`.
    pub joint_temperature: bool,
    /// `temp_air_c`.
    pub air_temperature: bool,
}

/// A measurement file as read.
#[derive(Clone, Debug)]
pub struct Measurements {
    /// Rows in the file's order.
    pub rows: Vec<MeasurementRow>,
    /// Optional columns.
    pub channels: Channels,
    /// Names of the reflectors; one unnamed where the file does not tell them apart.
    pub targets: Vec<String>,
    /// Names of the fixed places: nests, points touched, ends of wires.
    pub fixed_points: Vec<String>,
    /// Smallest step that the joint columns are written with, degrees as decimals in the file: 3 for 0.001.
    pub joint_decimals: usize,
    /// What a person should look at.
    pub warnings: Vec<Diagnostic>,
}

impl Measurements {
    /// Reads a measurement file: CSV with columns by name (mm, degrees, minutes), in any order.
    ///
    /// # Errors
    /// A column that is missing, a cell that is no number, a file without rows, with line and column.
    pub fn from_csv(bytes: &[u8]) -> Result<Self, MeasureError> {
        Self::from_table(&Table::from_csv(bytes)?)
    }

    /// As [`Measurements::from_csv`], of a table that a column map made or that was put together.
    ///
    /// # Errors
    /// As there.
    pub fn from_table(table: &Table) -> Result<Self, MeasureError> {
        read::from_table(table)
    }
}
