//! The linear problem, reduced once: whitened columns and their products, summed over groups of stations.
//!
//! Groups are the smallest groups of stations that a fold, a block in time or a region keeps together, so
//! every held-out fit is a sum of small matrices.

mod joint_rotations;
mod matrix;
mod products;
pub(super) mod registration;
mod rigid_motions;
mod visits;
mod whitening;

pub use joint_rotations::Turning;
pub use matrix::Design;
pub use products::{Products, Sums};
pub use rigid_motions::RigidMotions;
pub use visits::Visits;
pub use whitening::{SharedError, Whitening};
