//! Forward and inverse kinematics of a six-axis arm, its Jacobian, configuration and singularities.
//!
//! Pure functions over constant models; knows nothing of RAPID or of files. Inside, rotations and positions
//! are plain arrays; `nalgebra` types stand at the public edge.

mod chain;
mod matrix;

pub use chain::{Arm, Chain, FrameOffsets, PoseAndJacobian};
