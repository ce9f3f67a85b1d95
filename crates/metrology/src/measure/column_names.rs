//! The names of the columns that a measurement table may have (`docs/MEASURING.md`).

pub(super) const JOINTS: [&str; 6] = ["q1_deg", "q2_deg", "q3_deg", "q4_deg", "q5_deg", "q6_deg"];
pub(super) const POINT: [&str; 3] = ["x_mm", "y_mm", "z_mm"];
pub(super) const QUATERNION: [&str; 4] = ["qw", "qx", "qy", "qz"];
pub(super) const DIRECTIONS: [&str; 6] = ["dir1", "dir2", "dir3", "dir4", "dir5", "dir6"];
pub(super) const TEMPERATURES: [&str; 6] =
    ["temp_j1_c", "temp_j2_c", "temp_j3_c", "temp_j4_c", "temp_j5_c", "temp_j6_c"];
pub(super) const OTHERS: [&str; 7] = ["id", "pose_id", "t_min", "target", "kind", "payload_kg", "temp_air_c"];
/// Instead of a point: the name of the fixed point that was touched.
pub(super) const FIXED: &str = "fixed_id";
/// Instead of a point: the distance from a fixed point.
pub(super) const LENGTH: &str = "length_mm";

/// Every column that a measurement table may have.
pub(super) fn known() -> Vec<&'static str> {
    [&JOINTS[..], &POINT, &QUATERNION, &DIRECTIONS, &TEMPERATURES, &OTHERS, &[FIXED, LENGTH]].concat()
}
