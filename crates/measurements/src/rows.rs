//! The rows of a measurement file, in SI units, and which optional columns it has.

use super::Reading;
use nalgebra::UnitQuaternion;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::robot::{JointKind, Joints};

/// Joints of one pose differ by less than this.
pub(super) const SAME_POSE: JointTolerance = JointTolerance { rad: 0.01, m: 1e-3 };

/// How far joints may be from each other, or from an end of their range: an angle and a length have no common measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct JointTolerance {
    /// Of joints that turn, radians.
    pub rad: f64,
    /// Of joints that slide, metres.
    pub m: f64,
}

impl JointTolerance {
    /// That of a joint of this kind, radians or metres.
    pub(super) fn of(self, kind: JointKind) -> f64 {
        if kind.slides() { self.m } else { self.rad }
    }

    /// Whether all joints of two poses, which move as `kinds` says, differ by less.
    pub(super) fn holds(self, kinds: &[JointKind], a: &[f64], b: &[f64]) -> bool {
        kinds.iter().zip(a.iter().zip(b)).all(|(kind, (a, b))| (a - b).abs() < self.of(*kind))
    }
}

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

    /// Whether the arm, whose joints move as `kinds` says, stood elsewhere than at `other`.
    #[must_use]
    pub(super) fn is_apart_from(&self, other: &Self, kinds: &[JointKind]) -> bool {
        !SAME_POSE.holds(kinds, &self.q_rad, &other.q_rad)
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
    /// Directions of approach: `dir1` and so on, one for each joint.
    pub direction: bool,
    /// Payload as declared: `payload_kg`.
    pub payload: bool,
    /// Joint temperatures: `temp_j1_c` and so on, one for each joint.
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
    /// What a person should look at.
    pub warnings: Vec<Diagnostic>,
}
