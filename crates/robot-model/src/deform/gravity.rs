//! Gravity's loads on an arm at rest: torque about each joint, force and moment at each joint's origin.
//!
//! Gravity points along -z of the base. Masses come from the robot file; without them a guess by size
//! gives the shape, and effects of gravity let each link's share float.

use crate::robot::{ArmGeometry, Joints, Link, MOST_JOINTS};
use nalgebra::{Isometry3, Vector3};

/// Standard gravity, m/s2 (CGPM 1901).
pub const GRAVITY_M_S2: f64 = 9.80665;
/// Mass of the moving links guessed for an arm of 1 m reach, kg; it grows with the cube of the reach.
const GUESS_KG: f64 = 100.0;
/// How that mass is shared over the links of an arm of six joints.
const GUESS_SHARES: [f64; 6] = [0.36, 0.26, 0.2, 0.1, 0.05, 0.03];

/// The same for an arm of `n` joints: as much of the mass lies within the same part of the chain.
fn guess_shares(n: usize) -> Joints {
    if n == GUESS_SHARES.len() {
        return Joints::from(GUESS_SHARES);
    }
    let within = |part: f64| {
        let links = part * GUESS_SHARES.len() as f64;
        let share = |(k, share): (usize, &f64)| share * (links - k as f64).clamp(0.0, 1.0);
        GUESS_SHARES.iter().enumerate().map(share).sum::<f64>()
    };
    Joints::from_fn(n, |k| within((k + 1) as f64 / n as f64) - within(k as f64 / n as f64))
}

/// Loads at one station, of as many joints as the arm has; those past them are zero.
#[derive(Clone, Debug, Default)]
pub struct Loads {
    /// Torque about each joint's axis from all links beyond it and the payload, N.m; of a joint that slides the force along
    /// it, N, here and below.
    pub torque_n_m: [f64; MOST_JOINTS],
    /// The part of each link k on each joint j: `parts[j][k]`, N.m.
    pub link_torque_n_m: [[f64; MOST_JOINTS]; MOST_JOINTS],
    /// The payload's part on each joint, N.m.
    pub payload_torque_n_m: [f64; MOST_JOINTS],
    /// What one kilogram at the payload's place would add on each joint, N.m.
    pub unit_torque_n_m: [f64; MOST_JOINTS],
    /// Moment that the same kilogram adds about any point per metre further along the flange's axis k, base axes, N.
    pub unit_lever_moment_n: [Vector3<f64>; 3],
    /// Its part on joint j: `levers[j][k]`, N.
    pub unit_lever_n: [[f64; 3]; MOST_JOINTS],
    /// Load beyond each joint, about that joint's origin: of all links and the payload.
    pub beyond: [Wrench; MOST_JOINTS],
    /// The part of each link k in it: `parts[j][k]`.
    pub link_beyond: [[Wrench; MOST_JOINTS]; MOST_JOINTS],
    /// Moment of the whole moving arm about the base's origin, N.m.
    pub base_moment_n_m: Vector3<f64>,
    /// The part of each link, N.m.
    pub link_base_moment_n_m: [Vector3<f64>; MOST_JOINTS],
}

/// The wrench of gravity: a moment about a point, and a force straight down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench {
    /// About a joint's origin, base axes, N.m.
    pub moment_n_m: Vector3<f64>,
    /// Downward, along -z, N.
    pub weight_n: f64,
}

/// Slope and deflection of a cantilever's end under gravity, per unit of its L/EI (Gere and Timoshenko, Mechanics of Materials, appendix G).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamDeflection {
    /// Slope of its end, base axes, N.m: M + F L / 2.
    pub slope_n_m: Vector3<f64>,
    /// Deflection of its end, base axes, N.m times metres: M L / 2 + F L^2 / 3.
    pub deflection_m_n_m: Vector3<f64>,
}

impl Wrench {
    /// How the link between two joints' origins (base frame) bends under this wrench at its end: an even one, the change where it
    /// gives more near its root than near its tip, and what the end force has in the first, apart from the moment.
    #[must_use]
    pub fn bend(&self, from_m: &Vector3<f64>, to_m: &Vector3<f64>) -> [BeamDeflection; 3] {
        let along = to_m - from_m;
        let across = |v: Vector3<f64>| {
            if along.norm() > 1e-6 { v - along * (v.dot(&along) / along.norm_squared()) } else { v }
        };
        let moment = across(self.moment_n_m);
        let lever = along.cross(&Vector3::new(0.0, 0.0, -self.weight_n));
        let even = BeamDeflection {
            slope_n_m: moment + lever * 0.5,
            deflection_m_n_m: (moment * 0.5 + lever / 3.0).cross(&along),
        };
        let uneven = BeamDeflection { slope_n_m: lever, deflection_m_n_m: (moment + lever).cross(&along) };
        [
            even,
            uneven,
            BeamDeflection { slope_n_m: lever * 0.5, deflection_m_n_m: (lever / 3.0).cross(&along) },
        ]
    }

    fn add(&mut self, moment_n_m: &Vector3<f64>, weight_n: f64) {
        self.moment_n_m += moment_n_m;
        self.weight_n += weight_n;
    }
}

/// Length of the arm stretched out, metres.
fn reach_m(arm: ArmGeometry<'_>) -> f64 {
    arm.joints.iter().skip(1).map(|j| j.previous_from_joint.translation.vector.norm()).sum::<f64>()
        + arm.last_from_flange.translation.vector.norm()
}

/// The arm's links, or a guess from its size.
#[must_use]
pub fn links(arm: ArmGeometry<'_>) -> Joints<Link> {
    match arm.links {
        Some(links) => links.iter().copied().collect(),
        None => {
            let total_kg = GUESS_KG * reach_m(arm).powi(3);
            let shares = guess_shares(arm.joints.len());
            Joints::from_fn(arm.joints.len(), |i| {
                let middle_m = arm.after_link(i).translation.vector * 0.5;
                Link { mass_kg: total_kg * shares[i], com_m: middle_m.into() }
            })
        }
    }
}

/// Loads of the arm whose joint frames (then flange) are `frames` and whose joints' axes are `axes` in the base, with
/// `payload_kg` at `point_m`.
#[must_use]
pub fn loads_at(
    arm: ArmGeometry<'_>,
    frames: &[Isometry3<f64>],
    axes: &[Vector3<f64>],
    point_m: Vector3<f64>,
    payload_kg: f64,
) -> Loads {
    let joints = arm.joints.len();
    let Some(flange) = frames.get(joints) else { return Loads::default() };
    // What a joint feels of a force: its moment about the axis, or the force along it.
    let felt = |j: usize, moment: &Vector3<f64>, force: &Vector3<f64>| {
        if arm.slides(j) { axes[j].dot(force) } else { axes[j].dot(moment) }
    };
    let down = Vector3::new(0.0, 0.0, -GRAVITY_M_S2);
    let mut loads = Loads::default();
    let mut add = |k: usize, mass_kg: f64, at_m: Vector3<f64>, payload: bool| {
        let force = down * mass_kg;
        loads.base_moment_n_m += at_m.cross(&force);
        if !payload {
            loads.link_base_moment_n_m[k] += at_m.cross(&force);
        }
        for (j, frame) in frames.iter().enumerate().take(k + 1) {
            let moment = (at_m - frame.translation.vector).cross(&force);
            let torque = felt(j, &moment, &force);
            loads.torque_n_m[j] += torque;
            if payload {
                loads.payload_torque_n_m[j] += torque;
            } else {
                loads.link_torque_n_m[j][k] += torque;
                loads.link_beyond[j][k].add(&moment, mass_kg * GRAVITY_M_S2);
            }
            loads.beyond[j].add(&moment, mass_kg * GRAVITY_M_S2);
        }
    };
    for (k, link) in links(arm).iter().enumerate() {
        // The centre of mass is given in the joint's frame at the zero pose: it turns with the joint.
        let at_m = frames[k].transform_point(&Vector3::from(link.com_m).into()).coords;
        add(k, link.mass_kg, at_m, false);
    }
    if payload_kg > 0.0 {
        add(joints - 1, payload_kg, point_m, true);
    }
    loads.unit_lever_moment_n =
        std::array::from_fn(|k| (flange.rotation * Vector3::ith(k, 1.0)).cross(&down));
    for (j, frame) in frames.iter().enumerate().take(joints) {
        let moment = (point_m - frame.translation.vector).cross(&down);
        loads.unit_torque_n_m[j] = felt(j, &moment, &down);
        loads.unit_lever_n[j] = loads.unit_lever_moment_n.map(|moment| felt(j, &moment, &Vector3::zeros()));
    }
    loads
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinematics::{Chain, SerialChain};
    use crate::robot::{Robot, SerialArm};

    #[test]
    fn a_guess_gives_the_same_part_of_the_chain_the_same_mass() {
        // By hand: of four links the first has all of the six's first and half of their second.
        let four = guess_shares(4);
        assert!(
            (four[0] - (0.36 + 0.13)).abs() < 1e-15 && (four[3] - (0.025 + 0.03)).abs() < 1e-15,
            "{four:?}"
        );
        for n in 4..=7 {
            assert!((guess_shares(n).iter().sum::<f64>() - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn a_joint_that_slides_feels_the_weight_along_it() {
        let arm = SerialArm::from_toml(include_str!("../../../../fixtures/robots/scara.toml")).unwrap();
        let frames = SerialChain::nominal(&arm).frames(&[0.4, 0.3, -0.1, 0.2]);
        let axes = [Vector3::z(); 4];
        let loads = loads_at(arm.geometry(), &frames, &axes, frames[4].translation.vector, 3.0);
        // The spindle's two links of 1.5 and 0.5 kg and the payload, downward.
        assert!((loads.torque_n_m[2] + 9.80665 * (1.5 + 0.5 + 3.0)).abs() < 1e-12, "{:?}", loads.torque_n_m);
        assert_eq!((loads.torque_n_m[0], loads.unit_lever_n[2]), (0.0, [0.0; 3]));
        assert!((loads.unit_torque_n_m[2] + 9.80665).abs() < 1e-12);
    }

    #[test]
    fn a_stretched_irb140_loads_joint_2_by_its_levers() {
        let robot = Robot::built_in("irb140").unwrap();
        let q_rad = [0.0, std::f64::consts::FRAC_PI_2, -std::f64::consts::FRAC_PI_2, 0.0, 0.0, 0.0];
        let frames = Chain::nominal(&robot).frames(&q_rad);
        let axes: [_; 6] = std::array::from_fn(|j| frames[j].rotation * robot.joints[j].axis.into_inner());
        let point_m = frames[6].translation.vector;
        let loads = loads_at(robot.geometry(), &frames, &axes, point_m, 2.0);
        // Upper arm level, forearm level: levers from joint 2 are each centre's x minus 0.07 m.
        let links = robot.links.unwrap();
        let levers_m = [0.18, 0.36 + 0.015, 0.36 + 0.24, 0.36 + 0.38 + 0.015, 0.36 + 0.38 + 0.05];
        let torque: f64 = links[1..].iter().zip(levers_m).map(|(l, x)| l.mass_kg * x * 9.80665).sum::<f64>()
            + 2.0 * 9.80665 * (0.36 + 0.38 + 0.065);
        assert!((loads.torque_n_m[1] - torque).abs() < 1e-9, "{} {torque}", loads.torque_n_m[1]);
        assert!(loads.torque_n_m[0].abs() < 1e-9);
        // Level, straight ahead: a kilogram one metre further along the flange's z.
        assert!((loads.unit_lever_n[1][2] - 9.80665).abs() < 1e-9, "{:?}", loads.unit_lever_n[1]);
        // The upper arm under the weight and the moment of all beyond the elbow.
        let [even, ..] = loads.beyond[2].bend(&frames[1].translation.vector, &frames[2].translation.vector);
        let weight = 9.80665 * (links[2..].iter().map(|l| l.mass_kg).sum::<f64>() + 2.0);
        let moment = loads.torque_n_m[2];
        assert!((even.slope_n_m.y - moment - 0.36 * weight / 2.0).abs() < 1e-9, "{even:?}");
        let deflection = moment * 0.36 / 2.0 + 0.36 * 0.36 * weight / 3.0;
        assert!((even.deflection_m_n_m.z + deflection).abs() < 1e-9, "{even:?}");
        assert!((loads.payload_torque_n_m[1] - 2.0 * loads.unit_torque_n_m[1]).abs() < 1e-12);
        // The weight's own part of that; without it a beam under an end moment alone is left: M and M L / 2.
        let [even, _, force] =
            loads.beyond[2].bend(&frames[1].translation.vector, &frames[2].translation.vector);
        assert!((force.slope_n_m.y - 0.36 * weight / 2.0).abs() < 1e-9, "{force:?}");
        assert!((force.deflection_m_n_m.z + 0.36 * 0.36 * weight / 3.0).abs() < 1e-9, "{force:?}");
        assert!(((even.slope_n_m - force.slope_n_m).y - moment).abs() < 1e-9);
        assert!(((even.deflection_m_n_m - force.deflection_m_n_m).z + moment * 0.36 / 2.0).abs() < 1e-9);
    }
}
