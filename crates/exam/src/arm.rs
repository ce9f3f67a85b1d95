//! A virtual arm by the product of exponentials (Brockett 1984; Lynch and Park 2017, eq. 4.14).
//!
//! `base_from_flange(q) = exp(X_1) exp(S_1 q_1) ... exp(X_n) exp(S_n q_n) exp(X_n+1) M` with the screws S_i (of pitch zero, or
//! infinite where a joint slides) of
//! the zero pose in the base frame and small displacements X_i of each joint's seat. Nothing here
//! comes from `kinematics`.

use nalgebra::{Isometry3, Point3, Translation3, UnitQuaternion, Vector3};
use robot_model::robot::{Joints, MOST_JOINTS, SerialArm};

/// Standard gravity, m/s² (CGPM 1901).
pub const GRAVITY_M_S2: f64 = 9.806_65;

/// A joint's screw at the zero pose, in the base frame.
#[derive(Clone, Copy, Debug)]
struct Screw {
    axis: Vector3<f64>,
    point_m: Vector3<f64>,
    slides: bool,
}

/// A load that gravity pulls on: it moves with a joint, `after` counting joints before it.
#[derive(Clone, Copy, Debug)]
struct Mass {
    after: usize,
    mass_kg: f64,
    at_zero_m: Point3<f64>,
}

/// The arm at its zero pose.
#[derive(Clone, Debug)]
pub struct ScrewArm {
    screws: Vec<Screw>,
    home: Isometry3<f64>,
    masses: Vec<Mass>,
}

/// What disturbs the arm in one pose. Everything zero is the nominal arm.
#[derive(Clone, Copy, Debug)]
pub struct Disturbance {
    /// Added to each joint, radians; metres where it slides.
    pub joint_rad: [f64; MOST_JOINTS],
    /// Shift of the seat of each joint and, behind the last, of the tool, in base axes at the zero pose, metres.
    pub seat_m: [Vector3<f64>; MOST_JOINTS + 1],
    /// Turn of the same seats about their joint's point, rotation vector, radians.
    pub seat_rad: [Vector3<f64>; MOST_JOINTS + 1],
    /// The base moves: shift in metres and rotation vector in radians, in base axes.
    pub base_m: Vector3<f64>,
    /// Rotation vector of the base, radians, in base axes.
    pub base_rad: Vector3<f64>,
    /// The measured point moves by this in base axes, metres.
    pub point_m: Vector3<f64>,
    /// The instrument reads lengths this much too long (1 = 100 %).
    pub instrument_scale: f64,
}

impl Default for Disturbance {
    fn default() -> Self {
        Self {
            joint_rad: [0.0; MOST_JOINTS],
            seat_m: [Vector3::zeros(); MOST_JOINTS + 1],
            seat_rad: [Vector3::zeros(); MOST_JOINTS + 1],
            base_m: Vector3::zeros(),
            base_rad: Vector3::zeros(),
            point_m: Vector3::zeros(),
            instrument_scale: 0.0,
        }
    }
}

/// `exp` of a rotation by `rotation_rad` about `point_m`, followed by a shift.
fn turn_about(point_m: &Vector3<f64>, rotation_rad: Vector3<f64>, shift_m: Vector3<f64>) -> Isometry3<f64> {
    let rotation = UnitQuaternion::from_scaled_axis(rotation_rad);
    Isometry3::from_parts(Translation3::from(point_m - rotation * point_m + shift_m), rotation)
}

impl Screw {
    /// `exp` of the screw times the joint's coordinate.
    fn moved(&self, by: f64) -> Isometry3<f64> {
        if self.slides {
            return Isometry3::from_parts(Translation3::from(self.axis * by), UnitQuaternion::identity());
        }
        turn_about(&self.point_m, self.axis * by, Vector3::zeros())
    }
}

/// Moving links of an arm whose chain from joint 1's foot to the flange is 1 m long, kg. It grows with the square of that, which is right to a factor
/// of three: an IRB 120 (1.0 m) weighs 25 kg, an IRB 140 (1.2) 98, an IRB 2600 (2.2) 284, an IRB 6700-2.65 (3.6) 1205, base and all.
const LINKS_KG_PER_M2: f64 = 70.0;
/// Where along it a link's mass lies: castings are heavier at their roots.
const CENTRE_SHARE: f64 = 0.4;

/// Masses for a robot whose file has none: no arm weighs nothing, or all sag would be the payload's. Lighter outwards, with the length of the
/// chain that each link carries. Another hand than the guess that a diagnosis makes.
fn castings(robot: &SerialArm) -> Vec<(f64, Vector3<f64>)> {
    let joints = robot.joints.iter().skip(1).map(|joint| joint.previous_from_joint.translation.vector);
    let along: Vec<Vector3<f64>> = joints.chain([robot.last_from_flange.translation.vector]).collect();
    let carried_m = |k: usize| along[k..].iter().map(Vector3::norm).sum::<f64>();
    let length_m = carried_m(0);
    let weights: Vec<f64> = (0..along.len()).map(|k| (carried_m(k) / length_m).powf(1.5) + 0.02).collect();
    let kg = LINKS_KG_PER_M2 * length_m.powi(2) / weights.iter().sum::<f64>();
    along.iter().zip(weights).map(|(along, weight)| (kg * weight, along * CENTRE_SHARE)).collect()
}

impl ScrewArm {
    /// The arm of a robot file, with its links' masses or, where the file has none, such as an arm of its size has.
    #[must_use]
    pub fn new(robot: &SerialArm) -> Self {
        let links: Vec<(f64, Vector3<f64>)> = match &robot.links {
            Some(links) => links.iter().map(|link| (link.mass_kg, Vector3::from(link.com_m))).collect(),
            None => castings(robot),
        };
        let mut zero = Isometry3::identity();
        let mut masses = Vec::new();
        let screw = |(i, joint): (usize, &robot_model::robot::Joint)| {
            zero *= joint.previous_from_joint;
            let (mass_kg, com_m) = links[i];
            masses.push(Mass { after: i + 1, mass_kg, at_zero_m: zero * Point3::from(com_m) });
            Screw {
                axis: zero.rotation * joint.axis.into_inner(),
                point_m: zero.translation.vector,
                slides: joint.kind.slides(),
            }
        };
        let screws = robot.joints.iter().enumerate().map(screw).collect();
        Self { screws, home: zero * robot.last_from_flange, masses }
    }

    /// Number of joints, 4 to 7.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.screws.len()
    }

    /// Whether joint `i` (from 0) slides.
    #[must_use]
    pub fn slides(&self, i: usize) -> bool {
        self.screws.get(i).is_some_and(|screw| screw.slides)
    }

    /// The base's frame to the flange's.
    #[must_use]
    pub fn flange(&self, q_rad: &[f64], disturbance: &Disturbance) -> Isometry3<f64> {
        let mut pose = turn_about(&Vector3::zeros(), disturbance.base_rad, disturbance.base_m);
        for (i, screw) in self.screws.iter().enumerate() {
            pose *= turn_about(&screw.point_m, disturbance.seat_rad[i], disturbance.seat_m[i]);
            pose *= screw.moved(q_rad[i] + disturbance.joint_rad[i]);
        }
        let flange_m = self.home.translation.vector;
        let tool = self.joints();
        pose * turn_about(&flange_m, disturbance.seat_rad[tool], disturbance.seat_m[tool]) * self.home
    }

    /// Potential energy of links and payload in joules.
    fn potential_j(&self, q_rad: &[f64], payload_kg: f64, payload_at_m: &Point3<f64>) -> f64 {
        let mut pose = Isometry3::identity();
        let mut energy = 0.0;
        for (i, screw) in self.screws.iter().enumerate() {
            pose *= screw.moved(q_rad[i]);
            for mass in self.masses.iter().filter(|m| m.after == i + 1) {
                energy += mass.mass_kg * GRAVITY_M_S2 * (pose * mass.at_zero_m).z;
            }
        }
        energy + payload_kg * GRAVITY_M_S2 * (pose * self.home * payload_at_m).z
    }

    /// Torque of gravity about each axis in N·m (along one that slides: force in N), positive where it turns the joint forward:
    /// `-dU/dq`, by central differences. `payload_at_m` is the payload's centre in the flange frame.
    #[must_use]
    pub fn gravity_torque_n_m(&self, q_rad: &[f64], payload_kg: f64, payload_at_m: &Point3<f64>) -> Joints {
        const STEP_RAD: f64 = 1e-4;
        Joints::from_fn(self.joints(), |i| {
            let at = |sign: f64| {
                let mut q: Joints = q_rad.iter().copied().collect();
                q[i] += sign * STEP_RAD;
                self.potential_j(&q, payload_kg, payload_at_m)
            };
            (at(-1.0) - at(1.0)) / (2.0 * STEP_RAD)
        })
    }

    /// Moment of gravity of all that lies beyond joint `i` (from 0) about that joint's point, in the axes of
    /// the link before it at the zero pose, N·m.
    #[must_use]
    pub fn moment_n_m(
        &self,
        i: usize,
        q_rad: &[f64],
        payload_kg: f64,
        payload_at_m: &Point3<f64>,
    ) -> Vector3<f64> {
        let mut pose = Isometry3::identity();
        let mut before = Isometry3::identity();
        let mut moment = Vector3::zeros();
        let mut loads: Vec<(f64, Point3<f64>)> = Vec::new();
        for (k, screw) in self.screws.iter().enumerate() {
            if k == i {
                before = pose;
            }
            pose *= screw.moved(q_rad[k]);
            if k >= i {
                loads.extend(
                    self.masses.iter().filter(|m| m.after == k + 1).map(|m| (m.mass_kg, pose * m.at_zero_m)),
                );
            }
        }
        loads.push((payload_kg, pose * self.home * payload_at_m));
        let joint = before * Point3::from(self.screws[i].point_m);
        for (mass_kg, at) in loads {
            moment += (at - joint).cross(&Vector3::new(0.0, 0.0, -mass_kg * GRAVITY_M_S2));
        }
        before.rotation.inverse() * moment
    }

    /// The axis of joint `i` (from 0) at the zero pose, in the base frame.
    #[must_use]
    pub fn axis(&self, i: usize) -> Vector3<f64> {
        self.screws[i].axis
    }

    /// The vector from joint `i` (from 0) to the next joint (to the flange, for the last) at the zero pose.
    #[must_use]
    pub fn link_m(&self, i: usize) -> Vector3<f64> {
        let next = self.screws.get(i + 1).map_or(self.home.translation.vector, |s| s.point_m);
        next - self.screws[i].point_m
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn irb140() -> ScrewArm {
        ScrewArm::new(&SerialArm::built_in("irb140").unwrap())
    }

    #[test]
    fn the_arm_stands_where_the_papers_table_says() {
        // P19 of the paper's Table 3: joints to 0.01 degrees, so the TCP to about 0.2 mm
        let q = [17.19_f64, 14.3, 9.09, 37.92, -28.74, -34.34].map(f64::to_radians);
        let flange = irb140().flange(&q, &Disturbance::default());
        let off = flange.translation.vector - Vector3::new(0.55, 0.15, 0.55);
        assert!(off.norm() < 2e-4, "{off}");
    }

    #[test]
    fn a_scara_stands_where_its_two_links_and_its_spindle_put_it() {
        let arm = SerialArm::from_toml(include_str!("../../../fixtures/robots/scara.toml")).unwrap();
        let [q1, q2, z_m]: [f64; 3] = [0.5, -1.1, -0.08];
        let flange = ScrewArm::new(&arm).flange(&[q1, q2, z_m, 0.7], &Disturbance::default());
        let x = 0.325 * q1.cos() + 0.275 * (q1 + q2).cos();
        let y = 0.325 * q1.sin() + 0.275 * (q1 + q2).sin();
        let off = flange.translation.vector - Vector3::new(x, y, 0.34 + z_m - 0.02);
        assert!(off.norm() < 1e-15, "{off}");
        // The weight of spindle and payload along it: 1.5, 0.5 and 2 kg, downward.
        let force = ScrewArm::new(&arm).gravity_torque_n_m(&[q1, q2, z_m, 0.7], 2.0, &Point3::origin())[2];
        assert!((force + 4.0 * GRAVITY_M_S2).abs() < 1e-6, "{force}");
    }

    /// By hand from the data sheet's lengths: 290 + 270 + 70 + 302 + 72 mm are 1.004 m, and 70 times its square 70.561 kg. Joint 2 of the arm at its
    /// zero pose carries each mass before it by its own lever.
    #[test]
    fn an_arm_whose_file_has_no_masses_weighs_as_much_as_its_size_says() {
        let robot = SerialArm::built_in("irb120").unwrap();
        assert!(robot.links.is_none());
        let arm = ScrewArm::new(&robot);
        let total_kg: f64 = arm.masses.iter().map(|mass| mass.mass_kg).sum();
        assert!((total_kg - 70.561).abs() < 1e-3, "{total_kg} kg");
        // No link is heavier than the one before it.
        assert!(arm.masses.windows(2).all(|two| two[1].mass_kg <= two[0].mass_kg));
        let torque = arm.gravity_torque_n_m(&[0.0; 6], 0.0, &Point3::origin());
        let by_hand: f64 = arm.masses[1..]
            .iter()
            .map(|mass| mass.mass_kg * GRAVITY_M_S2 * (mass.at_zero_m.x - arm.screws[1].point_m.x))
            .sum();
        assert!(by_hand > 1.0 && (torque[1] - by_hand).abs() < 1e-6, "{torque:?} {by_hand}");
    }

    #[test]
    fn gravity_torque_of_a_payload_alone_is_weight_times_lever() {
        let mut arm = irb140();
        arm.masses.clear();
        // stretched forward from the shoulder at x = 0.07: flange at x = 0.07 + 0.38 + 0.065
        let torque = arm.gravity_torque_n_m(&[0.0; 6], 5.0, &Point3::origin());
        let expected = [
            0.0,
            5.0 * GRAVITY_M_S2 * 0.445,
            5.0 * GRAVITY_M_S2 * 0.445,
            0.0,
            5.0 * GRAVITY_M_S2 * 0.065,
            0.0,
        ];
        for (got, want) in torque.iter().zip(expected) {
            assert!((got - want).abs() < 1e-6, "{torque:?}");
        }
    }

    #[test]
    fn the_moment_about_a_joint_holds_its_torque() {
        let arm = irb140();
        let q = [0.3, 0.4, -0.6, 0.8, -0.5, 0.2];
        let at = Point3::new(0.01, 0.02, 0.08);
        let torque = arm.gravity_torque_n_m(&q, 3.0, &at);
        for (i, t) in torque.iter().enumerate() {
            let along = arm.moment_n_m(i, &q, 3.0, &at).dot(&arm.axis(i));
            assert!((along - t).abs() < 1e-5, "joint {}: {along} {t}", i + 1);
        }
    }
}
