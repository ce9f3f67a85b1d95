//! The reference paper's Table 2: static deformation of an IRB 140 (International Journal of Modern Manufacturing
//! Technologies, accepted December 15, 2022).

use crate::kinematics::FrameOffsets;
use crate::units::{m_from_mm, rad_from_deg};

/// As printed: dx, dy, dz in mm, turns about x, y, z in degrees, row i = joint i; `fixtures/paper` holds the same as CSV.
const TABLE_2: [[f64; 6]; 6] = [
    [-0.0200698, 0.000154, -0.05297, 0.0, -0.011, -0.0137],
    [0.0, 0.0, 0.0, 0.0108, 0.0, 0.0],
    [0.100863597, 0.11485519, -0.001420766, 0.0, 0.0081, 0.0098],
    [-0.0044, 0.0241, -0.0149, 0.0, 0.0, 0.0],
    [0.0; 6],
    [-0.0162926, 0.0, 0.0, 0.0, 0.0, 0.0],
];

/// Table 2 in SI; the flange does not move.
pub(super) fn table_2() -> FrameOffsets {
    let mut offsets = FrameOffsets::default();
    for (row, [dx, dy, dz, rx, ry, rz]) in offsets.0.iter_mut().zip(TABLE_2) {
        *row = [
            m_from_mm(dx),
            m_from_mm(dy),
            m_from_mm(dz),
            rad_from_deg(rx),
            rad_from_deg(ry),
            rad_from_deg(rz),
        ];
    }
    offsets
}
