//! Forward and inverse kinematics of a six-axis arm, its Jacobian, configuration and singularities; forward kinematics of
//! any serial arm.
//!
//! Pure functions over constant models; knows nothing of RAPID or of files. Inside, rotations and positions
//! are plain arrays; `nalgebra` types stand at the public edge.

mod calibrate;
mod chain;
mod chains;
mod closed_form;
mod configuration;
mod dispatch;
mod eight_branches;
mod flange_points;
mod follow;
mod forward;
mod frame_columns;
mod lanes;
mod linear;
mod matrix;
mod offset_columns;
mod real;
mod right_angled;
mod serial_chain;
mod solve;
mod solve_eight;
mod sparse_chain;
mod steps;
mod structure;
mod wide_frames;

pub use calibrate::{CalibrateError, Calibration, CalibrationOptions, MeasuredPose, calibrate};
pub use chain::{ArmKinematics, Chain, FrameOffsets, NominalFrames, PoseAndJacobian};
pub use chains::Chains;
pub use closed_form::{ClosedForm, Solution};
pub use configuration::{Configuration, Posture, outside_quadrant_rad};
pub use flange_points::{ArmsJoints, FlangePoint, FlangePoints};
pub use serial_chain::{SerialChain, SerialFrames, SerialOffsets};
pub use solve::{RESIDUAL_M, RESIDUAL_RAD, SolveError, Solved, solve};
pub use structure::StructureError;
