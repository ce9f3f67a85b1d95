//! What an answer cannot say of itself: whether one touched point moves otherwise than the rest, whether the touches tell where the
//! tip is, and what two files of one arm do not have in common.
//!
//! Knows no RAPID and no files.

mod base_shift;
mod course;
mod last_zero;
mod moving_point;
mod tip;
mod two_files;

pub use base_shift::{BaseSigma, MeasuredPoses};
pub use last_zero::last_zero;
pub use moving_point::moving_points;
pub use tip::{TipCheck, check_tip};
pub use two_files::{beside_each_other, why_unpaired};
