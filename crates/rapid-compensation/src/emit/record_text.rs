//! Records of numbers as RAPID text: positions in mm, orientations, joints in degrees.

use nalgebra::Isometry3;
use rapid_syntax::write_list;
use robot_model::units::{deg_from_rad, mm_from_m};

/// Appends a position as RAPID's `pos`, in mm; gives what is read back.
pub fn write_pos(out: &mut Vec<u8>, position_m: [f64; 3]) -> [f32; 3] {
    write_list(out, position_m.map(mm_from_m))
}

/// Appends a quaternion as RAPID's `orient`, normalised; gives what is read back.
pub fn write_orient(out: &mut Vec<u8>, wxyz: [f64; 4]) -> [f32; 4] {
    let norm = wxyz.iter().map(|c| c * c).sum::<f64>().sqrt();
    let unit = if norm > 0.0 { wxyz.map(|c| c / norm) } else { [1.0, 0.0, 0.0, 0.0] };
    write_list(out, unit)
}

/// Appends six joints as RAPID's `robjoint`, in degrees; `None` is `9E9`. Gives what is read back.
pub(super) fn write_robjoint(out: &mut Vec<u8>, q_rad: [Option<f64>; 6]) -> [f32; 6] {
    write_optional(out, q_rad.map(|q| q.map(deg_from_rad)))
}

/// Appends six optional numbers as RAPID's `extjoint`; `None` is `9E9`. Gives what is read back.
pub(super) fn write_optional(out: &mut Vec<u8>, values: [Option<f64>; 6]) -> [f32; 6] {
    write_list(out, values.map(|v| v.unwrap_or(f64::INFINITY)))
}

/// A frame as RAPID's `pose`, mm.
#[must_use]
pub(super) fn pose(frame: &Isometry3<f64>) -> String {
    let turn = frame.rotation;
    let mut text = vec![b'['];
    write_pos(&mut text, frame.translation.vector.into());
    text.push(b',');
    write_orient(&mut text, [turn.w, turn.i, turn.j, turn.k]);
    text.push(b']');
    String::from_utf8_lossy(&text).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_in_rapids_units() {
        let mut out = Vec::new();
        write_pos(&mut out, [0.4, -0.15, 0.25]);
        write_orient(&mut out, [2.0, 0.0, 0.0, 0.0]);
        let right = std::f64::consts::FRAC_PI_2;
        write_robjoint(&mut out, [Some(right), None, Some(0.0), Some(-right), Some(0.0), Some(0.0)]);
        assert_eq!(out, b"[400,-150,250][1,0,0,0][90,9E9,0,-90,0,0]");
    }
}
