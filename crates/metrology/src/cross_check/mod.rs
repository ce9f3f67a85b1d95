//! What an answer cannot say of itself: whether one touched point moves otherwise than the rest, whether the touches tell where the
//! tip is, and what two files of one arm do not have in common.
//!
//! Knows no RAPID and no files.

mod course;
mod moving_point;
mod tip;

pub use moving_point::moving_points;
pub use tip::{TipCheck, check_tip};
