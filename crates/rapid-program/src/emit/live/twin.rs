//! The same first-order correction in double precision, for figures.

use super::deformation::LiveModel;
use nalgebra::{Isometry3, Point3, Rotation3, Translation3, UnitQuaternion, Vector3};
use robot_model::deform::Conditions;
use robot_model::deform::gravity::loads_at;

/// What a target is moved by: `tcLive(p) = p * to_isometry`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LiveCorrection {
    /// In the axes of the target, metres.
    pub shift_m: Vector3<f64>,
    /// Rotation vector in the axes of the target, radians.
    pub turn_rad: Vector3<f64>,
}

impl LiveCorrection {
    /// As a transform in the target's frame.
    #[must_use]
    pub fn to_isometry(&self) -> Isometry3<f64> {
        Isometry3::from_parts(
            Translation3::from(self.shift_m),
            UnitQuaternion::from_scaled_axis(self.turn_rad),
        )
    }
}

impl LiveModel {
    /// The correction at nominal joints, with the tool in the flange's frame and the functions of time as they are (those
    /// left out are 0). Of the conditions the load counts alone. The cap is not applied, and steep turns are not evaluated a
    /// second time: for that, call it again with the corrected target's joints.
    #[must_use]
    pub fn correction(
        &self,
        q_rad: &[f64; 6],
        flange_from_tcp: &Isometry3<f64>,
        functions: &[f64],
        conditions: &Conditions,
    ) -> LiveCorrection {
        let torques = self.torques(q_rad, conditions);
        let (mut shift_m, mut turn_rad) = (Vector3::zeros(), Vector3::zeros());
        for (i, step) in self.steps.iter().enumerate() {
            shift_m += turn_rad.cross(&step.place_m);
            for function in (0..self.functions()).map(Some).chain([None]) {
                let by = function.map_or(1.0, |r| functions.get(r).copied().unwrap_or(0.0));
                let [shift, turn] = self.row(function, i);
                shift_m += shift * by;
                turn_rad += turn * by;
            }
            let mut back = step.rotation.transpose();
            if let Some((axis, sign)) = step.axis {
                let about = nalgebra::Unit::new_unchecked(Vector3::ith(axis, sign));
                back = Rotation3::from_axis_angle(&about, -q_rad[i]).into_inner() * back;
            }
            shift_m = back * shift_m;
            turn_rad = back * turn_rad;
            if let Some((axis, sign)) = step.axis {
                turn_rad[axis] += sign
                    * (self.turns[i].iter().map(|t| t.at(i, q_rad, functions)).sum::<f64>() + torques[i]);
            }
        }
        shift_m += turn_rad.cross(&flange_from_tcp.translation.vector);
        let into_tool = flange_from_tcp.rotation.inverse();
        LiveCorrection { shift_m: -(into_tool * shift_m), turn_rad: -(into_tool * turn_rad) }
    }

    /// What each joint gives under load, radians.
    fn torques(&self, q_rad: &[f64; 6], conditions: &Conditions) -> [f64; 6] {
        if self.compliance.iter().all(Option::is_none) {
            return [0.0; 6];
        }
        let frames = self.nominal.frames(q_rad);
        let axes: [_; 6] =
            std::array::from_fn(|j| frames[j].rotation * self.robot.joints[j].axis.into_inner());
        let payload = &conditions.payload;
        let at_m = (frames[6] * Point3::from(Vector3::from(payload.cog_m))).coords;
        let loads = loads_at(self.robot.geometry(), &frames, &axes, at_m, payload.mass_kg);
        std::array::from_fn(|j| {
            self.compliance[j].map_or(0.0, |own| {
                let links: f64 = (0..6).map(|k| own.link[k] * loads.link_torque_n_m[j][k]).sum();
                own.whole * loads.torque_n_m[j] + links
            })
        })
    }
}
