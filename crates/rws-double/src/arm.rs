//! The arm's kinematics, by a library that is not the client's.

use glam::{DQuat, DVec3};
use robot_model::units::rad_from_deg;
use rs_opw_kinematics::kinematic_traits::{Kinematics, Pose};
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Lengths of an arm with a spherical wrist, metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmLengths {
    /// From axis 1 outward to axis 2.
    pub a1: f64,
    /// From axis 3 up to axis 4, negative as the library counts.
    pub a2: f64,
    /// From the floor to axis 2.
    pub c1: f64,
    /// Length of the lower arm.
    pub c2: f64,
    /// Upper arm to the wrist centre.
    pub c3: f64,
    /// Wrist centre to the flange.
    pub c4: f64,
}

impl ArmLengths {
    /// IRB 140-6/0.8, by ABB's data sheet.
    pub const IRB140: Self = Self { a1: 0.070, a2: 0.0, c1: 0.352, c2: 0.360, c3: 0.380, c4: 0.065 };
}

/// What is wrong with the answers, on purpose.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Planted {
    /// Added to every pose that is calculated, metres.
    pub shift_m: [f64; 3],
    /// Joints for a pose are those of another branch, whatever confdata says.
    pub other_branch: bool,
    /// Added to the pose that is shown and not to what is calculated, metres.
    pub display_shift_m: [f64; 3],
}

/// The four numbers of `confdata`.
pub(crate) type Quadrants = [i32; 4];

/// Turned axes that the library's zero pose does not have.
const OFFSETS: [f64; 6] = [0.0, 0.0, -FRAC_PI_2, 0.0, 0.0, 0.0];

pub(crate) struct Solver {
    arm: ArmLengths,
    opw: OPWKinematics,
    pub planted: Planted,
}

/// Position in metres and quaternion, real part first.
pub(crate) type Frame = ([f64; 3], [f64; 4]);

/// The flange itself, as a tool.
pub(crate) const NO_TOOL: Frame = ([0.0; 3], [1.0, 0.0, 0.0, 0.0]);

fn pose((p, q): Frame) -> Pose {
    Pose::from_parts(DVec3::from(p), DQuat::from_xyzw(q[1], q[2], q[3], q[0]).normalize())
}

impl Solver {
    pub(crate) fn new(arm: ArmLengths, planted: Planted) -> Self {
        let ArmLengths { a1, a2, c1, c2, c3, c4 } = arm;
        let parameters =
            Parameters { a1, a2, b: 0.0, c1, c2, c3, c4, offsets: OFFSETS, sign_corrections: [1; 6], dof: 6 };
        Self { arm, opw: OPWKinematics::new(parameters), planted }
    }

    pub(crate) fn forward(&self, q: &[f64; 6], tool: Frame) -> (Frame, Quadrants) {
        let at = self.opw.forward(q) * pose(tool);
        let shifted = at.translation + DVec3::from(self.planted.shift_m);
        let r = at.rotation;
        ((shifted.to_array(), [r.w, r.x, r.y, r.z]), self.quadrants(q))
    }

    /// Joints in the configuration that is asked for; `Err(true)` where only others reach it.
    pub(crate) fn inverse(&self, at: Frame, tool: Frame, wanted: Quadrants) -> Result<[f64; 6], bool> {
        let all = self.all(at, tool);
        let matches = |q: &[f64; 6]| self.turned(q).into_iter().find(|q| self.quadrants(q) == wanted);
        let right = all.iter().find_map(matches);
        if self.planted.other_branch {
            let other = all.iter().find(|q| self.quadrants(q)[3] != wanted[3]);
            return other.copied().or(right).ok_or(!all.is_empty());
        }
        right.ok_or(!all.is_empty())
    }

    /// All joints within half a turn.
    pub(crate) fn all(&self, (p, q): Frame, tool: Frame) -> Vec<[f64; 6]> {
        let p = (DVec3::from(p) - DVec3::from(self.planted.shift_m)).to_array();
        let flange = pose((p, q)) * pose(tool).inverse();
        let wrapped = |q: [f64; 6]| q.map(|x| x - TAU * (x / TAU).round());
        let mut found: Vec<[f64; 6]> = self.opw.inverse(&flange).into_iter().map(wrapped).collect();
        found.retain(|q| q.iter().all(|x| x.is_finite()));
        found
    }

    /// The same joints with axes 1, 4 and 6 a whole turn on or back.
    fn turned(&self, q: &[f64; 6]) -> Vec<[f64; 6]> {
        let mut out = vec![*q];
        for axis in [0, 3, 5] {
            let turns = out.iter().flat_map(|q| {
                [-TAU, 0.0, TAU].map(|turn| {
                    let mut q = *q;
                    q[axis] += turn;
                    q
                })
            });
            out = turns.filter(|q| q[axis].abs() <= rad_from_deg(400.0)).collect();
        }
        out
    }

    /// Quadrants of axes 1, 4 and 6, and what stands behind what: 4 for the wrist centre behind axis 1, 2 behind the lower arm, 1
    /// for a negative axis 5.
    pub(crate) fn quadrants(&self, q: &[f64; 6]) -> Quadrants {
        let ArmLengths { a1, a2, c2, c3, .. } = self.arm;
        let quadrant = |x: f64| (x / FRAC_PI_2).floor() as i32;
        // In the plane of the arm: outward and up, from axis 1 and the height of axis 2.
        let (lean, reach) = (q[1], q[1] + q[2]);
        let elbow = (a1 + c2 * lean.sin(), c2 * lean.cos());
        let out = elbow.0 + c3 * reach.cos() - a2 * reach.sin();
        let up = elbow.1 - c3 * reach.sin() - a2 * reach.cos();
        // Which side of the line of the lower arm the wrist centre is on.
        let side = (out - a1) * lean.cos() - up * lean.sin();
        let behind = i32::from(out < 0.0) * 4 + i32::from(side < 0.0) * 2 + i32::from(q[4] < 0.0);
        [quadrant(q[0]), quadrant(q[3]), quadrant(q[5]), behind]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_1_SQRT_2;

    /// RoboDK's export of the first linear motion of Cube45: [400,300,250] mm, confdata [0,0,-1,1].
    #[test]
    fn a_robodk_target_is_reached_in_its_configuration() {
        let solver = Solver::new(ArmLengths::IRB140, Planted::default());
        let at = ([0.4, 0.3, 0.25], [FRAC_1_SQRT_2, 0.0, FRAC_1_SQRT_2, 0.0]);
        let q = solver.inverse(at, NO_TOOL, [0, 0, -1, 1]).unwrap();
        let ((p, _), quadrants) = solver.forward(&q, NO_TOOL);
        assert!((0..3).all(|i| (p[i] - at.0[i]).abs() < 1e-9), "{p:?}");
        assert_eq!(quadrants, [0, 0, -1, 1]);
        // MoveAbsJ of the same export stands just there.
        let robodk = [41.845_157_f64, 44.625_236, 25.881_2, 43.530_476, -75.605_869, -13.287_258];
        for (q, deg) in q.iter().zip(robodk) {
            assert!((q.to_degrees() - deg).abs() < 1e-3, "{q} {deg}");
        }
    }
}
