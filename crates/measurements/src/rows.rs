//! The rows of a measurement file, in SI units, and which optional columns it has.

use super::Reading;
use nalgebra::UnitQuaternion;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::robot::{JointKind, Joints};

/// Joints of one pose differ by less than this, radians.
pub(super) const SAME_POSE_RAD: f64 = 0.01;

/// One measured pose, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasurementRow {
    /// Line in the file, from 1.
    pub line: u64,
    /// `id`, where the file has it.
    pub id: Option<String>,
    /// `pose_id`, where the file has it.
    pub pose_id: Option<String>,
    /// Which commanded pose: rows with the same number repeat one.
    pub pose: usize,
    /// Which reflector or stylus, index into [`Measurements::targets`].
    pub target: usize,
    /// Which stand of the instrument saw it, from 0: more than one where it was moved in the middle of the file.
    pub stand: usize,
    /// Minutes since cold start.
    pub t_min: Option<f64>,
    /// How long before that of the file's last cold start the clock of [`Self::t_min`] began, minutes: 0 where the file has one.
    pub earlier_min: f64,
    /// Joints, radians, those that slide metres; at a nest where the arm stood, 0 where its row does not say.
    pub q_rad: Joints,
    /// What the instrument, or the touch, gave.
    pub reading: Reading,
    /// The measured orientation in the instrument's frame.
    pub orientation: Option<UnitQuaternion<f64>>,
    /// Sign of each joint's last motion before the pose.
    pub direction: Option<Joints<i8>>,
    /// Mass of the payload as declared, kg.
    pub payload_kg: Option<f64>,
    /// Temperature of each joint.
    pub joint_temperature_c: Option<Joints>,
}

impl MeasurementRow {
    /// Minutes on a clock that goes on over all sessions, since the last cold start.
    #[must_use]
    pub fn clock_min(&self) -> Option<f64> {
        self.t_min.map(|t_min| t_min - self.earlier_min)
    }

    /// Whether the arm stood elsewhere than at `other`.
    #[must_use]
    pub(super) fn is_apart_from(&self, other: &Self) -> bool {
        self.q_rad.iter().zip(&other.q_rad).any(|(a, b)| (a - b).abs() > SAME_POSE_RAD)
    }
}

/// Which optional columns the file has, complete for every row.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Channels {
    /// Name of the commanded pose: `pose_id`.
    pub pose_id: bool,
    /// Minutes since cold start: `t_min`.
    pub time: bool,
    /// `qw, qx, qy, qz`.
    pub orientation: bool,
    /// Directions of approach: `dir1` to `dir6`.
    pub direction: bool,
    /// Payload as declared: `payload_kg`.
    pub payload: bool,
    /// Joint temperatures: `temp_j1_c` to `temp_j6_c`.
    pub joint_temperature: bool,
}

/// A measurement file as read.
#[derive(Clone, Debug)]
pub struct Measurements {
    /// Rows in the file's order.
    pub rows: Vec<MeasurementRow>,
    /// Optional columns that are complete.
    pub channels: Channels,
    /// Names of the reflectors; one unnamed where the file does not tell them apart.
    pub targets: Vec<String>,
    /// Names of the fixed points: nests, points touched, ends of wires.
    pub fixed_points: Vec<String>,
    /// How each joint moves, by the unit of its column.
    pub joint_kinds: Joints<JointKind>,
    /// Smallest step that the joint columns are written with, degrees as decimals in the file: 3 for 0.001.
    pub joint_decimals: usize,
    /// What a person should look at.
    pub warnings: Vec<Diagnostic>,
}
