//! A file that contradicts itself or the robot: units, axes, columns, rows, robot and tool, tried one by one.

mod by_name;
mod change;
mod coded;
mod columns;
mod far_rows;
mod frozen;
mod knocked;
mod late;
mod moved;
mod one_target;
mod orientation;
mod pasted;
mod rows;
mod scale;
mod trials;
mod whole;

pub use columns::{find_in_cells, find_in_stamps, find_pose_names};
pub use far_rows::{PartFault, PosedRow};
pub use knocked::{MovedTarget, describe_knock, find_moved_target};
pub use moved::{describe_move, describe_remounting};
pub use one_target::find_in_one_target;
pub use orientation::find_in_orientations;
pub use rows::{find_apart, find_in_rows};
pub use whole::{TOOL_M, ToolApart, find_fault, find_in_columns, tool_apart};

use serde::{Serialize, Serializer};

/// A zero that is off, or has jumped, by more is no slip of a gear or a belt, radians: the column is another one.
const FURTHEST_ZERO_RAD: f64 = 0.09;

/// Kinds of contradictions that are looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaultKind {
    /// Points in metres, inches.
    PositionUnits,
    /// Joints are in radians, the columns say degrees.
    JointUnits,
    /// One column is in another unit than its name says.
    ColumnUnits,
    /// Measured axes swapped or one with the wrong sign.
    SwappedAxes,
    /// Joint columns swapped, or counted the other way.
    JointColumns,
    /// Joints outside the robot's range.
    JointsOutOfRange,
    /// Joints rounded more coarsely than the measurement.
    RoundedJoints,
    /// One point at many poses.
    FrozenPoint,
    /// Joint columns that stand still while the arm moves.
    FrozenJoints,
    /// Points and joints are shifted against each other.
    RowsShifted,
    /// Points of one target under the name of another.
    ExchangedTargets,
    /// Orientations that do not go with the points.
    Orientations,
    /// Rows of one `pose_id` at different joints.
    PoseNames,
    /// A payload that weighs more than the arm.
    PayloadBeyondArm,
    /// The tool is not the one named.
    WrongTool,
    /// The points fit another robot.
    WrongRobot,
    /// More scatter than any instrument has that was stated or repeated.
    NoiseBeyondStated,
    /// Too many rows are false.
    TooManyFalse,
    /// Nothing fits, reason not found.
    NothingFits,
}

impl FaultKind {
    /// The word in every file.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::PositionUnits => "position_units",
            Self::JointUnits => "joint_units",
            Self::ColumnUnits => "column_units",
            Self::SwappedAxes => "swapped_axes",
            Self::JointColumns => "joint_columns",
            Self::JointsOutOfRange => "joints_out_of_range",
            Self::RoundedJoints => "rounded_joints",
            Self::FrozenPoint => "frozen_point",
            Self::FrozenJoints => "frozen_joints",
            Self::RowsShifted => "rows_shifted",
            Self::ExchangedTargets => "exchanged_targets",
            Self::Orientations => "orientations",
            Self::PoseNames => "pose_names",
            Self::PayloadBeyondArm => "payload_beyond_arm",
            Self::WrongTool => "wrong_tool",
            Self::WrongRobot => "wrong_robot",
            Self::NoiseBeyondStated => "noise_beyond_stated",
            Self::TooManyFalse => "too_many_false",
            Self::NothingFits => "nothing_fits",
        }
    }
}

impl Serialize for FaultKind {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// A contradiction, and what it rests on.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Fault {
    /// Kind of the contradiction.
    pub kind: FaultKind,
    /// Columns that it is in, as their names; `None` where it is in none alone.
    pub column: Option<String>,
    /// Lines of the file that it is in; none: in all.
    pub lines: Vec<u64>,
    /// One sentence for people.
    #[serde(skip)]
    pub reason: String,
}

impl Fault {
    /// One of the whole file.
    #[must_use]
    pub fn of_all(kind: FaultKind, column: Option<&str>, reason: impl Into<String>) -> Self {
        Self { kind, column: column.map(str::to_owned), lines: Vec::new(), reason: reason.into() }
    }

    /// One in some lines; `describe` gives the sentence from their number and their names.
    #[must_use]
    pub fn in_rows(
        kind: FaultKind,
        column: &str,
        mut lines: Vec<u64>,
        describe: impl Fn(usize, &str) -> String,
    ) -> Self {
        sorting::ascending(&mut lines);
        let reason = describe(lines.len(), &in_words(&lines));
        Self { kind, column: Some(column.to_owned()), lines, reason }
    }
}

/// Lines as people write them: the first and the last where they are many.
fn in_words(lines: &[u64]) -> String {
    match lines {
        [] => String::new(),
        [one] => format!("line {one}"),
        [first, .., last] => {
            let all = last - first + 1 == lines.len() as u64;
            if all { format!("lines {first} to {last}") } else { format!("lines {first} to {last}, not all") }
        }
    }
}

#[cfg(test)]
mod tests;
