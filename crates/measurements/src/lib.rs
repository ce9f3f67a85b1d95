//! Measurement files: what a tracker, a probe or a draw-wire saw, and how it hangs on the robot.
//!
//! Reads the file, gathers repeats into stations, registers instrument and tool, and says when a file
//! contradicts itself or the robot. Knows nothing of effects.

mod check;
mod codes;
mod column_map;
mod column_names;
mod copies;
mod error;
mod false_repeats;
mod fault;
mod gaps;
mod initial_guess;
mod iso9283;
mod join;
mod midnight;
mod one_stand;
mod own_names;
mod performance;
mod pose_performance;
mod read;
mod reading;
mod refine;
mod register;
mod registration;
mod repeats;
mod rotation;
mod rounded_points;
mod rounds;
mod row_cells;
mod rows;
mod sessions;
mod station;
mod table;
mod time_unit;
mod timestamp;
mod touch;
mod touch_times;

pub use check::{OUT_OF_RANGE_SHARE, RowCheck, check_cycles, check_rows, out_of_range};
pub use codes::describe_code;
pub use column_map::ColumnMap;
pub use column_names::{direction_columns, temperature_columns};
pub use error::MeasureError;
pub use false_repeats::describe_false_repeats;
pub use fault::{
    Fault, FaultKind, MovedTarget, PartFault, PosedRow, TOOL_M, ToolApart, describe_knock, describe_move,
    describe_remounting, find_apart, find_fault, find_in_cells, find_in_columns, find_in_one_target,
    find_in_orientations, find_in_rows, find_in_stamps, find_moved_target, find_pose_names, tool_apart,
};
pub use iso9283::{
    Accuracy, OrientationPerformance, Repeatability, accuracy, barycentre_m, orientation, repeatability,
};
pub use join::{Joined, MatchBy, join};
pub use one_stand::{JointElsewhere, OneStand, StandError, from_one_stand, from_sound_file, turned};
pub use own_names::OwnNames;
pub use performance::{ComparisonFrame, Performance, PerformanceError, WorstPerformance, performance};
pub use pose_performance::{PerformanceAtTime, PosePerformance};
pub use reading::{Coordinates, Reading};
pub use refine::FreeParameters;
pub use register::{RegisterError, register, register_near, register_with};
pub use registration::Registration;
pub use repeats::{FEWEST_FREEDOM, Repeats, STATED_FREEDOM};
pub use rotation::Rotation;
pub use rounds::ROUND_SHARE;
pub use rows::{Channels, MeasurementRow, Measurements};
pub use station::{Standing, Station, Stations, alone, gather, gather_about};
pub use table::{Line, Table};
pub use touch::{Touch, Touches};
