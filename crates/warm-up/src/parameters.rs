//! The settled deformation as parameters, and what each does to the tool.

use nalgebra::{Matrix3xX, Vector3};
use robot_model::kinematics::Chain;

/// Parameters: six for each of the six joint frames.
pub const PARAMETERS: usize = 36;

/// Where the arm has a point of the tool, `tool_m` from the flange, base axes, metres.
#[must_use]
pub(super) fn tip_m(chain: &Chain, q_rad: &[f64; 6], tool_m: &Vector3<f64>) -> Vector3<f64> {
    let flange = chain.forward(q_rad);
    flange.translation.vector + flange.rotation * tool_m
}

/// The shift of the tool's point per unit of each parameter (metres, radians), base axes: 3 x 36, six columns for each joint's
/// frame.
#[must_use]
pub fn signature(chain: &Chain, q_rad: &[f64; 6], tool_m: &Vector3<f64>) -> Matrix3xX<f64> {
    let frames = chain.frames(q_rad);
    let flange = &frames[6];
    let point_m = flange.translation.vector + flange.rotation * tool_m;
    let mut signature = Matrix3xX::zeros(PARAMETERS);
    for i in 0..6 {
        let axes = if i == 0 { None } else { Some(frames[i - 1].rotation) };
        let lever = point_m - frames[i].translation.vector;
        for k in 0..3 {
            let mut axis = Vector3::zeros();
            axis[k] = 1.0;
            let axis = axes.map_or(axis, |turn| turn * axis);
            signature.set_column(6 * i + k, &axis);
            signature.set_column(6 * i + k + 3, &axis.cross(&lever));
        }
    }
    signature
}
