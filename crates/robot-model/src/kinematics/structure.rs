//! Whether a robot is an ortho-parallel basis with a spherical wrist, and its lengths if so.
//!
//! Brandstötter, Angerer, Hofbaur: An Analytical Solution of the Inverse Kinematics Problem of Industrial Serial
//! Manipulators with an Ortho-parallel Basis and a Spherical Wrist, 2014. Axis 2 crosses axis 1 at a right angle, axis 3 is
//! parallel to axis 2, axis 4 crosses axis 3 at a right angle, axes 4, 5, 6 meet in the wrist centre at right angles. Only
//! the axes in space at the zero pose count, not how a file spreads them over frames, rpy and axis signs.

use super::chain::Chain;
use super::matrix::{Mat3, Vec3, add, apply, cross, dot, mul, norm, scale, sub, transpose};
use rapid_syntax::diagnostic::Diagnostic;
use thiserror::Error;

/// Why the closed form does not apply.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error(
    "the robot is no ortho-parallel arm with a spherical wrist, which the closed-form inverse kinematics needs: {0}"
)]
pub struct StructureError(pub(super) &'static str);

impl From<StructureError> for Diagnostic {
    fn from(error: StructureError) -> Self {
        Self::error("robot::structure", error.to_string())
    }
}

/// A link that lies along an axis by more than this share of its length at the zero pose says which way that axis points.
const CLEARLY: f64 = 0.5;
/// The same of the shoulder, which lies this far along axis 1 or in front of it, metres.
const CLEARLY_M: f64 = 0.01;
/// Largest deviation of axes, radians and metres: rounding of a file's numbers, not a real offset.
const DEVIATION: f64 = 1e-8;

/// The arm in canonical angles θ: `R = K Rz(θ1) Ry(θ2 + θ3) Rx(θ4) Ry(θ5) Rx(θ6) T`, `θ_i = zero_i + sign_i q_i`. At θ = 0 the
/// upper arm points along z, the forearm along x. Lengths in metres, symbols as in the paper but b, which is signed to y.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Structure {
    /// K: canonical axes in the base.
    pub base_from_canonical: Mat3,
    /// The point of axis 1 at the height of axis 2.
    pub shoulder_m: Vec3,
    /// From axis 1 to axis 2.
    pub a1: f64,
    /// From axis 3 to axis 4, along z.
    pub a2: f64,
    /// Of the wrist centre, to the side.
    pub b: f64,
    /// Length of the upper arm.
    pub c2: f64,
    /// Forearm along axis 4, never negative.
    pub c3: f64,
    /// θ at q = 0.
    pub zero_rad: [f64; 6],
    /// Sense of each joint, 1 or -1.
    pub sign: [f64; 6],
    /// The wrist centre in the flange's frame.
    pub wrist_m: Vec3,
    /// T: the flange in the sixth canonical frame.
    pub canonical6_from_flange: Mat3,
}

impl Structure {
    pub(super) fn of(chain: &Chain) -> Result<Self, StructureError> {
        let zero = chain.lines(&[0.0; 6]);
        let (w, p) = (&zero.axes, &zero.origins_m);
        check_angles(w)?;

        let upper_arm = sub(&p[2], &p[1]);
        let wrist = crossing(&p[3], &w[3], &p[4], &w[4]);
        let to_wrist = sub(&wrist, &p[2]);
        let ([sign_1, sign_2], [x, y, z]) = senses(w, p, &to_wrist);
        let base_from_canonical = transpose(&[x, y, z]);
        let shoulder_m = add(&p[0], &scale(&z, dot(&sub(&p[1], &p[0]), &z)));
        let a1 = dot(&sub(&p[1], &shoulder_m), &x);

        let (upper_x, upper_z) = (dot(&upper_arm, &x), dot(&upper_arm, &z));
        let c2 = upper_x.hypot(upper_z);
        if c2 < DEVIATION {
            return Err(StructureError("axes 2 and 3 coincide"));
        }
        for i in 3..6 {
            let from_axis = cross(&w[i], &sub(&wrist, &p[i]));
            if norm(&from_axis) > DEVIATION {
                return Err(StructureError("axes 4, 5 and 6 do not meet in one point"));
            }
        }
        let sign_4 = if dot(&to_wrist, &w[3]) < 0.0 { -1.0 } else { 1.0 };
        // The forearm's frame at the zero pose: u along axis 4, y, n.
        let u = scale(&w[3], sign_4);
        let n = cross(&u, &y);
        let (c3, a2) = (dot(&to_wrist, &u), dot(&to_wrist, &n));
        if c3.hypot(a2) < DEVIATION {
            return Err(StructureError("the wrist centre lies on axis 3"));
        }
        let theta_2 = upper_x.atan2(upper_z);
        let theta_23 = (-dot(&u, &z)).atan2(dot(&u, &x));
        let theta_4 = dot(&w[4], &n).atan2(dot(&w[4], &y));
        let across = cross(&u, &w[4]);
        let sign_6 = if dot(&w[5], &u) < -DEVIATION { -1.0 } else { 1.0 };
        let last = scale(&w[5], sign_6);
        let theta_5 = (-dot(&last, &across)).atan2(dot(&last, &u));
        // Axes of the sixth canonical frame in the base.
        let base_from_sixth = transpose(&[last, w[4], cross(&last, &w[4])]);
        let flange_from_base = transpose(&zero.flange.rotation);
        Ok(Self {
            base_from_canonical,
            shoulder_m,
            a1,
            a2,
            b: dot(&sub(&wrist, &shoulder_m), &y),
            c2,
            c3,
            zero_rad: [0.0, theta_2, theta_23 - theta_2, theta_4, theta_5, 0.0],
            sign: [sign_1, sign_2, if dot(&w[2], &y) < 0.0 { -1.0 } else { 1.0 }, sign_4, 1.0, sign_6],
            wrist_m: apply(&flange_from_base, &sub(&wrist, &zero.flange.position_m)),
            canonical6_from_flange: mul(&transpose(&base_from_sixth), &zero.flange.rotation),
        })
    }
}

/// Senses of joints 1 and 2 at the zero pose, and the canonical axes x, y, z in the base; `to_wrist`: from axis 3.
///
/// Axis 1 points to the shoulder and on along the upper arm, and front is where the shoulder lies and the forearm points: a file in which
/// neither is so counts the joint the other way round. One alone is another zero pose.
fn senses(w: &[Vec3; 6], p: &[Vec3; 6], to_wrist: &Vec3) -> ([f64; 2], [Vec3; 3]) {
    let (to_shoulder, upper_arm) = (sub(&p[1], &p[0]), sub(&p[2], &p[1]));
    let is_backward = |link: &Vec3, along: &Vec3| {
        dot(link, along) < -CLEARLY * norm(link) && dot(&to_shoulder, along) < -CLEARLY_M
    };
    let sense = |is_backward: bool| if is_backward { -1.0 } else { 1.0 };
    let sign_1 = sense(is_backward(&upper_arm, &w[0]));
    let z = scale(&w[0], sign_1);
    let across = unit(&sub(&w[1], &scale(&z, dot(&z, &w[1]))));
    let sign_2 = sense(is_backward(to_wrist, &cross(&across, &z)));
    let y = scale(&across, sign_2);
    ([sign_1, sign_2], [cross(&y, &z), y, z])
}

/// Whether the axes stand to each other as the closed form takes them to.
fn check_angles(w: &[Vec3; 6]) -> Result<(), StructureError> {
    let right_angled = |i: usize, j: usize, what| {
        if dot(&w[i], &w[j]).abs() < DEVIATION { Ok(()) } else { Err(StructureError(what)) }
    };
    right_angled(0, 1, "axis 2 is not at a right angle to axis 1")?;
    if norm(&cross(&w[1], &w[2])) > DEVIATION {
        return Err(StructureError("axis 3 is not parallel to axis 2"));
    }
    right_angled(2, 3, "axis 4 is not at a right angle to axis 3")?;
    right_angled(3, 4, "axis 5 is not at a right angle to axis 4")?;
    right_angled(4, 5, "axis 6 is not at a right angle to axis 5")
}

fn unit(v: &Vec3) -> Vec3 {
    scale(v, 1.0 / norm(v))
}

/// The point of line a nearest to line b; the lines are at right angles.
fn crossing(a: &Vec3, along_a: &Vec3, b: &Vec3, along_b: &Vec3) -> Vec3 {
    let between = sub(b, a);
    let slant = dot(along_a, along_b);
    let reach = (dot(&between, along_a) - slant * dot(&between, along_b)) / (1.0 - slant * slant);
    add(a, &scale(along_a, reach))
}
