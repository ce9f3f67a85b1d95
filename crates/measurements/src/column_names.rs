//! The names of the columns that a measurement table may have (`docs/MEASURING.md`).

use robot_model::robot::{FEWEST_JOINTS, MOST_JOINTS};

/// Columns of joints that turn.
pub(super) static JOINTS: [&str; MOST_JOINTS] =
    ["q1_deg", "q2_deg", "q3_deg", "q4_deg", "q5_deg", "q6_deg", "q7_deg"];
/// Columns of joints that slide.
pub(super) static SLIDES: [&str; MOST_JOINTS] =
    ["q1_mm", "q2_mm", "q3_mm", "q4_mm", "q5_mm", "q6_mm", "q7_mm"];
pub(super) const POINT: [&str; 3] = ["x_mm", "y_mm", "z_mm"];
pub(super) const QUATERNION: [&str; 4] = ["qw", "qx", "qy", "qz"];
pub(super) static DIRECTIONS: [&str; MOST_JOINTS] = ["dir1", "dir2", "dir3", "dir4", "dir5", "dir6", "dir7"];
pub(super) static TEMPERATURES: [&str; MOST_JOINTS] =
    ["temp_j1_c", "temp_j2_c", "temp_j3_c", "temp_j4_c", "temp_j5_c", "temp_j6_c", "temp_j7_c"];
/// Temperature of the air: no effect is driven by it.
pub(super) const AIR: &str = "temp_air_c";
pub(super) const OTHERS: [&str; 7] = ["id", "pose_id", "t_min", "target", "kind", "payload_kg", AIR];
pub(super) const FIXED: &str = "fixed_id";
pub(super) const LENGTH: &str = "length_mm";

pub(super) fn known() -> Vec<&'static str> {
    [&JOINTS[..], &SLIDES, &POINT, &QUATERNION, &DIRECTIONS, &TEMPERATURES, &OTHERS, &[FIXED, LENGTH]]
        .concat()
}

/// The columns of the joints that a table has, joint 1 first: each as an angle or as a length.
///
/// # Errors
/// The first column that is missing below the last joint that is there, or below the fewest joints that an arm has.
pub(super) fn joints(has: impl Fn(&str) -> bool) -> Result<Vec<&'static str>, &'static str> {
    let column = |j: usize| [SLIDES[j], JOINTS[j]].into_iter().find(|name| has(name));
    let last = (0..MOST_JOINTS).rev().find(|&j| column(j).is_some());
    let joints = last.map_or(0, |last| last + 1).max(FEWEST_JOINTS);
    (0..joints).map(|j| column(j).ok_or(JOINTS[j])).collect()
}

/// The columns of where each joint came from, as words: `dir1 to dir6`.
#[must_use]
pub fn direction_columns(joints: usize) -> String {
    format!("dir1 to dir{joints}")
}

/// The columns of the joints' temperatures, as words: `temp_j1_c to temp_j6_c`.
#[must_use]
pub fn temperature_columns(joints: usize) -> String {
    format!("temp_j1_c to temp_j{joints}_c")
}
