//! Configuration of an arm: quadrants of joints 1, 4, 6 and the branch, numbered as ABB's confdata does; and how far
//! the arm stands from where two branches meet.

use super::structure::Structure;
use crate::robot::Axis;
use crate::units::rad_from_deg;
use std::f64::consts::FRAC_PI_2;

/// ABB's confdata: the quadrants of axes 1, 4, 6 and the branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Configuration {
    /// floor(q1 / 90°): 0 is 0° to 90°, -1 is -90° to 0°.
    pub cf1: i32,
    /// The same quarter turn of joint 4, floor(q4 / 90°).
    pub cf4: i32,
    /// The same quarter turn of joint 6, floor(q6 / 90°).
    pub cf6: i32,
    /// 4 · (wrist centre behind axis 1) + 2 · (wrist centre behind the lower arm) + (joint 5 negative).
    pub cfx: i32,
}

impl Configuration {
    /// The axes whose quadrants it counts, each with its count.
    #[must_use]
    pub fn quadrants(&self) -> [(Axis, i32); 3] {
        [(Axis::at(0), self.cf1), (Axis::at(3), self.cf4), (Axis::at(5), self.cf6)]
    }
}

/// How far an arm stands from its three singularities, signed: the sign is the branch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Posture {
    /// Wrist centre in front of axis 1 (negative: behind), metres. Zero where joint 1 is lost.
    pub shoulder_m: f64,
    /// Angle of the forearm, from axis 3 to the wrist centre, in front of the lower arm (negative: behind), radians, at
    /// most 90°. Zero where the arm is stretched or folded.
    pub elbow_rad: f64,
    /// Angle of axes 4 and 6 (negative: joint 5 negative), radians, at most 90°. Zero where joints 4 and 6 turn about
    /// one line.
    pub wrist_rad: f64,
}

/// How far past a quadrant's border a joint still counts as in it, degrees.
const HYSTERESIS_DEG: f64 = 0.5;
/// Rounding: a joint this little below a border is on it, radians.
const ON_BORDER_RAD: f64 = 1e-9;

impl Posture {
    /// Posture of the joints `q_rad`, which are `theta_rad` counted as the closed form counts them.
    pub(super) fn of(structure: &Structure, theta_rad: &[f64; 6], q_rad: &[f64; 6]) -> Self {
        let in_front = forearm_in_front_m(structure, theta_rad) / structure.c3.hypot(structure.a2);
        let wrist = theta_rad[4].sin().abs().asin();
        Self {
            shoulder_m: shoulder_m(structure, theta_rad),
            elbow_rad: in_front.clamp(-1.0, 1.0).asin(),
            wrist_rad: if q_rad[4] < 0.0 { -wrist } else { wrist },
        }
    }
}

/// The wrist centre in front of axis 1, metres.
fn shoulder_m(s: &Structure, theta_rad: &[f64; 6]) -> f64 {
    let sin_2 = theta_rad[1].sin();
    let (sin_23, cos_23) = (theta_rad[1] + theta_rad[2]).sin_cos();
    s.a1 + s.c2 * sin_2 + s.c3 * cos_23 + s.a2 * sin_23
}

/// The wrist centre in front of the lower arm, metres.
fn forearm_in_front_m(s: &Structure, theta_rad: &[f64; 6]) -> f64 {
    let (sin_3, cos_3) = theta_rad[2].sin_cos();
    s.c3 * cos_3 + s.a2 * sin_3
}

impl Configuration {
    /// Quadrants and branch of the joints `q_rad`, which are `theta_rad` counted as the closed form counts them: the signs of their
    /// [`Posture`].
    pub(super) fn of(structure: &Structure, theta_rad: &[f64; 6], q_rad: &[f64; 6]) -> Self {
        let cfx = 4 * i32::from(shoulder_m(structure, theta_rad) < 0.0)
            + 2 * i32::from(forearm_in_front_m(structure, theta_rad) < 0.0)
            + i32::from(q_rad[4] < 0.0);
        Self::of_branch(q_rad, cfx)
    }

    /// Quadrants of joints that stand on a branch.
    pub(super) fn of_branch(q_rad: &[f64; 6], cfx: i32) -> Self {
        Self { cf1: quadrant(q_rad[0]), cf4: quadrant(q_rad[3]), cf6: quadrant(q_rad[5]), cfx }
    }

    /// Whether joints whose own configuration is `own` stand as this one says. A joint up to half a degree past its
    /// quadrant's border agrees: at 0° both 0 and -1 do. The branch has no such play.
    pub(super) fn agrees(&self, own: &Self, q_rad: &[f64; 6]) -> bool {
        self.cfx == own.cfx
            && in_quadrant(q_rad[0], self.cf1)
            && in_quadrant(q_rad[3], self.cf4)
            && in_quadrant(q_rad[5], self.cf6)
    }

    /// The configuration to write beside joints whose own is `own`: each number of this one stays unless its joint is
    /// clearly, by more than half a degree, past the border; cfx is always the joints' own.
    pub(super) fn kept(&self, own: &Self, q_rad: &[f64; 6]) -> Self {
        let keep = |source, q_rad, own| if in_quadrant(q_rad, source) { source } else { own };
        Self {
            cf1: keep(self.cf1, q_rad[0], own.cf1),
            cf4: keep(self.cf4, q_rad[3], own.cf4),
            cf6: keep(self.cf6, q_rad[5], own.cf6),
            cfx: own.cfx,
        }
    }
}

fn quadrant(q_rad: f64) -> i32 {
    ((q_rad + ON_BORDER_RAD) / FRAC_PI_2).floor() as i32
}

/// How far a joint stands outside of a quadrant, radians; 0 inside and on both borders, and within what the rounding of a
/// target's numbers (eight decimals of a quaternion, single precision) does to a joint.
#[must_use]
pub fn outside_quadrant_rad(q_rad: f64, quadrant: i32) -> f64 {
    const ROUNDING_RAD: f64 = 1e-5;
    let from_rad = f64::from(quadrant) * FRAC_PI_2;
    let outside_rad = (from_rad - q_rad).max(q_rad - from_rad - FRAC_PI_2);
    if outside_rad > ROUNDING_RAD { outside_rad } else { 0.0 }
}

fn in_quadrant(q_rad: f64, quadrant: i32) -> bool {
    outside_quadrant_rad(q_rad, quadrant) <= rad_from_deg(HYSTERESIS_DEG)
}

#[cfg(test)]
mod tests {
    use super::super::closed_form::ClosedForm;
    use super::*;
    use crate::robot::Robot;
    use nalgebra::{Unit, UnitQuaternion};

    fn closed(name: &str) -> ClosedForm {
        ClosedForm::new(&Robot::built_in(name).unwrap()).unwrap()
    }

    fn configuration(closed: &ClosedForm, q_deg: [f64; 6]) -> [i32; 4] {
        let c = closed.configuration(&q_deg.map(rad_from_deg));
        [c.cf1, c.cf4, c.cf6, c.cfx]
    }

    #[test]
    fn quadrants_count_from_zero_both_ways() {
        let closed = closed("irb140");
        for (q_deg, quadrant) in
            [(0.0, 0), (89.9, 0), (90.0, 1), (-0.1, -1), (-90.0, -1), (-91.0, -2), (200.0, 2)]
        {
            let found = configuration(&closed, [q_deg, 0.0, 0.0, -q_deg - 1.0, 10.0, q_deg]);
            assert_eq!((found[0], found[2]), (quadrant, quadrant), "{q_deg}");
        }
        assert_eq!(configuration(&closed, [0.0, 0.0, 0.0, -200.0, 10.0, 400.0])[1..3], [-3, 4]);
    }

    #[test]
    fn cfx_counts_rear_lower_arm_and_wrist() {
        let closed = closed("irb140");
        for (q_deg, cfx) in [
            ([0.0, 0.0, 0.0, 0.0, 10.0, 0.0], 0),
            ([0.0, 0.0, 0.0, 0.0, -10.0, 0.0], 1),
            // Forearm straight up and 10 degrees back: behind the lower arm, in front of axis 1 for the arm leans forward.
            ([0.0, 40.0, -100.0, 0.0, 10.0, 0.0], 2),
            ([0.0, 40.0, -100.0, 0.0, -10.0, 0.0], 3),
            // Leaning back by 80 degrees with the forearm bent forward.
            ([0.0, -80.0, -60.0, 0.0, 10.0, 0.0], 4),
            ([0.0, -80.0, -60.0, 0.0, -10.0, 0.0], 5),
            ([0.0, -80.0, -120.0, 0.0, 10.0, 0.0], 6),
            ([0.0, -80.0, -120.0, 0.0, -10.0, 0.0], 7),
        ] {
            assert_eq!(configuration(&closed, q_deg)[3], cfx, "{q_deg:?}");
        }
    }

    /// Where the wrist is does not change with the way in which a file counts its joints: the bits of the shoulder and of the lower arm are those of
    /// the arm as ABB counts it, and each branch solves the pose, whichever of its joints count the other way round.
    #[test]
    fn the_branch_is_where_the_wrist_is_however_joints_are_counted() {
        let q_deg = [
            [17.0, 8.0, -10.0, 32.0, 41.0, -53.0],
            [20.0, 40.0, -100.0, 10.0, 30.0, 5.0],
            [0.0, -80.0, -120.0, 0.0, 20.0, 0.0],
        ];
        for name in ["irb140", "irb4600"] {
            let own = closed(name);
            for signs in 0..64_u32 {
                let counts = |i: usize| if signs >> i & 1 == 1 { -1.0 } else { 1.0 };
                let mut robot = Robot::built_in(name).unwrap();
                for (i, joint) in robot.joints.iter_mut().enumerate() {
                    joint.axis = Unit::new_normalize(joint.axis.into_inner() * counts(i));
                }
                let other = ClosedForm::new(&robot).unwrap();
                for q_deg in q_deg {
                    let q_rad = q_deg.map(rad_from_deg);
                    let counted: [f64; 6] = std::array::from_fn(|i| counts(i) * q_rad[i]);
                    let [meant, found] =
                        [own.configuration(&q_rad), other.configuration(&counted)].map(|c| c.cfx >> 1);
                    assert_eq!(found, meant, "{name} {signs:b} {q_deg:?}");
                    let pose = own.chain.forward(&q_rad);
                    let branches = other.branches(&pose);
                    let at = usize::try_from(other.configuration(&counted).cfx).unwrap();
                    let solved = branches[at].unwrap();
                    assert!(
                        solved.iter().zip(counted).all(|(a, b)| (a - b).abs() < 1e-9),
                        "{name} {signs:b}: {solved:?}"
                    );
                }
            }
        }
    }

    /// The forearm points back at the zero pose, or the upper arm down: the same arm, whose joints count from elsewhere.
    #[test]
    fn another_zero_pose_is_no_other_sense_of_a_joint() {
        let q_deg = [17.0, 8.0, -10.0, 32.0, 41.0, -53.0];
        let own = closed("irb140");
        for (moved, by_deg) in [(2, -125.0), (2, -180.0), (1, 125.0), (1, 180.0)] {
            let mut robot = Robot::built_in("irb140").unwrap();
            let joint = &mut robot.joints[moved];
            joint.previous_from_joint *= UnitQuaternion::from_axis_angle(&joint.axis, rad_from_deg(by_deg));
            let other = ClosedForm::new(&robot).unwrap();
            let mut counted = q_deg;
            counted[moved] -= by_deg;
            let pose = own.chain.forward(&q_deg.map(rad_from_deg));
            assert!(
                (other.chain.forward(&counted.map(rad_from_deg)).translation.x - pose.translation.x).abs()
                    < 1e-12
            );
            let [meant, found] = [configuration(&own, q_deg), configuration(&other, counted)];
            assert_eq!(found, meant, "{moved} {by_deg}");
        }
    }

    #[test]
    fn every_branch_of_a_pose_has_its_own_number() {
        for name in Robot::built_in_names() {
            let closed = closed(name);
            let q_rad = [0.3, 0.2, -0.4, 0.5, 0.9, -0.6];
            let found = closed.branches(&closed.chain.forward(&q_rad));
            for (index, q_rad) in found.iter().enumerate() {
                if let Some(q_rad) = q_rad {
                    assert_eq!(usize::try_from(closed.configuration(q_rad).cfx), Ok(index), "{name}");
                }
            }
            assert!(found.iter().flatten().count() >= 4, "{name}");
        }
    }

    #[test]
    fn posture_of_the_irb140_by_hand() {
        let closed = closed("irb140");
        let posture = closed.posture(&[0.0, 0.0, 0.0, 0.0, rad_from_deg(-30.0), 0.0]);
        assert!((posture.shoulder_m - 0.450).abs() < 1e-15);
        assert!((posture.elbow_rad - FRAC_PI_2).abs() < 1e-7);
        assert!((posture.wrist_rad - rad_from_deg(-30.0)).abs() < 1e-15);
        // Stretched: the forearm in line with the lower arm.
        assert!(closed.posture(&[0.0, 0.5, -FRAC_PI_2, 0.0, 0.3, 0.0]).elbow_rad.abs() < 1e-15);
        // Past 90 degrees joint 5 comes back towards the singularity at 180.
        let posture = closed.posture(&[0.0, 0.0, 0.0, 0.0, rad_from_deg(110.0), 0.0]);
        assert!((posture.wrist_rad - rad_from_deg(70.0)).abs() < 1e-12);
    }

    #[test]
    fn a_joint_on_the_border_keeps_the_sources_quadrant() {
        let closed = closed("irb140");
        let at = |q1_deg: f64| [q1_deg, 20.0, 10.0, 45.0, -30.0, 60.0].map(rad_from_deg);
        let source = |cf1, cfx| Configuration { cf1, cf4: 0, cf6: 0, cfx };
        for q1_deg in [-0.4, 0.0, 0.4] {
            assert!(closed.agrees(&source(0, 1), &at(q1_deg)) && closed.agrees(&source(-1, 1), &at(q1_deg)));
            assert_eq!(closed.kept(&source(-1, 1), &at(q1_deg)), source(-1, 1));
            assert_eq!(closed.kept(&source(0, 1), &at(q1_deg)), source(0, 1));
        }
        assert!(!closed.agrees(&source(0, 1), &at(-0.6)));
        assert_eq!(closed.kept(&source(0, 1), &at(-0.6)), source(-1, 1));
        assert!(!closed.agrees(&source(0, 0), &at(10.0)), "the branch has no play");
    }

    #[test]
    fn both_ends_of_a_quadrant_belong_to_it() {
        for (q_rad, quadrant, outside_rad) in [
            (0.0, 0, 0.0),
            (0.0, -1, 0.0),
            (FRAC_PI_2, 0, 0.0),
            (-1e-3, 0, 1e-3),
            (-1e-3, -1, 0.0),
            (FRAC_PI_2 + 2e-3, 0, 2e-3),
            (7.0, 4, 0.0),
            (-2.7e-9, 0, 0.0), // axis 1 of a RoboDK target at y = 0
        ] {
            assert!(
                (outside_quadrant_rad(q_rad, quadrant) - outside_rad).abs() < 1e-12,
                "{q_rad} {quadrant}"
            );
        }
    }
}
