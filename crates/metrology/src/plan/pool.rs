//! Poses that the robot may take: inside its ranges, off singularities, above the floor, clear of its own foot.

use super::options::{PlanError, PlanOptions, Restriction};
use inference::signature::PlannedMeasurement;
use nalgebra::{Matrix6xX, Vector3};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Joint, Joints, SerialArm};
use robot_model::units::rad_from_deg;
use std::f64::consts::PI;

/// Each joint comes from so far away.
const APPROACH_DEG: f64 = 3.0;
/// The same of a joint that slides, metres.
const APPROACH_M: f64 = 5e-3;
/// So far from the ends of the joints' ranges.
const MARGIN_DEG: f64 = 5.0;
/// The same of a joint that slides, metres, and how far one without a range is taken to reach.
const MARGIN_M: f64 = 5e-3;
const ANY_M: f64 = 0.5;
/// Smallest singular value of the Jacobian, lengths over the reach, that is no singularity.
const SINGULAR: f64 = 0.03;
/// Joint 5 nearer to zero than this has joints 4 and 6 in line, degrees.
const WRIST_DEG: f64 = 10.0;
/// Room round joint 2's own radius that wrist and tool keep from the foot, metres.
const FOOT_M: f64 = 0.15;
/// Tried for each pose wanted.
const TRIES: usize = 400;

/// A pose and how it is come to.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Pose {
    /// Joint angles, joint 1 first, radians.
    pub q_rad: Joints,
    /// Where they come from.
    pub approach_rad: Joints,
    /// Sign of each joint's last motion.
    pub direction: Joints<i8>,
    /// Mass of the payload as declared, kg.
    pub payload_kg: f64,
}

impl Pose {
    /// As a measurement at a minute.
    #[must_use]
    pub(super) fn possible(&self, t_min: f64) -> PlannedMeasurement {
        PlannedMeasurement {
            q_rad: self.q_rad,
            direction: self.direction,
            payload_kg: self.payload_kg,
            t_min,
            nest: None,
        }
    }
}

/// `count` poses that are allowed.
pub(super) fn poses(
    robot: &SerialArm,
    options: &PlanOptions,
    count: usize,
    random: &mut ChaCha8Rng,
) -> Result<Vec<Pose>, PlanError> {
    let chain = SerialChain::nominal(robot);
    let ranges: Vec<[f64; 2]> = robot
        .joints
        .iter()
        .map(|joint| {
            // No joint needs to be turned further than once round.
            let most = match (joint.kind.slides(), joint.range_rad) {
                (true, Some(_)) => f64::INFINITY,
                (true, None) => ANY_M - MARGIN_M,
                (false, _) => PI - rad_from_deg(MARGIN_DEG),
            };
            let [low, high] = kept_range_rad(joint);
            [low.max(-most), high.min(most)]
        })
        .collect();
    let mut found = Vec::new();
    let mut refused = [0_usize; 4];
    let mut tried = 0;
    while found.len() < count && tried < TRIES * count {
        tried += 1;
        let mut q_rad = Joints::all(ranges.len(), 0.0);
        for (q, [low, high]) in q_rad.iter_mut().zip(&ranges) {
            *q = low + (high - low) * random.random::<f64>();
        }
        let direction = Joints::from_fn(ranges.len(), |_| if random.random::<bool>() { 1 } else { -1 });
        let payload = random.random_range(0..options.payloads_kg.len().max(1));
        let approach_rad = approach_rad(robot, &q_rad, &direction);
        match [q_rad, approach_rad].iter().find_map(|q| restriction_of(robot, &chain, options, q)) {
            Some(restriction) => refused[restriction as usize] += 1,
            None => found.push(Pose {
                q_rad,
                approach_rad,
                direction,
                payload_kg: options.payloads_kg.get(payload).copied().unwrap_or(0.0),
            }),
        }
    }
    if found.len() < count {
        let all = [Restriction::Floor, Restriction::Foot, Restriction::Singular, Restriction::Outside];
        let restriction =
            all.into_iter().max_by_key(|w| refused[*w as usize]).unwrap_or(Restriction::Outside);
        return Err(PlanError::NoRoom { tried, found: found.len(), restriction });
    }
    Ok(found)
}

/// The range in which poses keep from a joint's ends, radians or metres; without end where it has none.
pub(super) fn kept_range_rad(joint: &Joint) -> [f64; 2] {
    let margin = if joint.kind.slides() { MARGIN_M } else { rad_from_deg(MARGIN_DEG) };
    let [low, high] = joint.range_rad.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
    [low + margin, high - margin]
}

/// Where the joints come from.
pub(super) fn approach_rad(robot: &SerialArm, q_rad: &Joints, direction: &Joints<i8>) -> Joints {
    Joints::from_fn(robot.joints.len(), |j| {
        let far = if robot.joints[j].kind.slides() { APPROACH_M } else { rad_from_deg(APPROACH_DEG) };
        q_rad[j] - f64::from(direction[j]) * far
    })
}

/// Why a pose is not allowed.
pub(super) fn restriction_of(
    robot: &SerialArm,
    chain: &SerialChain,
    options: &PlanOptions,
    q_rad: &Joints,
) -> Option<Restriction> {
    let frames = chain.frames(q_rad);
    let flange = &frames[robot.joints.len()];
    let point_m = flange.translation.vector + flange.rotation * options.tool_m;
    let moving: Vec<Vector3<f64>> =
        frames[3..].iter().map(|f| f.translation.vector).chain([point_m]).collect();
    if moving.iter().any(|p| p.z < options.space.floor_m) {
        return Some(Restriction::Floor);
    }
    let shoulder = frames[1].translation.vector;
    let foot_m = shoulder.xy().norm() + FOOT_M;
    if moving[1..].iter().any(|p| p.xy().norm() < foot_m && p.z < shoulder.z + FOOT_M) {
        return Some(Restriction::Foot);
    }
    let beyond = options.space.reach_m.is_some_and(|reach_m| point_m.xy().norm() > reach_m);
    let outside = options
        .space
        .box_m
        .is_some_and(|[low, high]| (0..3).any(|k| point_m[k] < low[k] || point_m[k] > high[k]));
    if beyond || outside {
        return Some(Restriction::Outside);
    }
    let reach_m: f64 =
        robot.joints.iter().skip(1).map(|j| j.previous_from_joint.translation.vector.norm()).sum();
    let (_, jacobian) = chain.forward_and_jacobian(q_rad);
    // A slide's travel counts over the reach, too: its column has no turn.
    let scaled = Matrix6xX::from_fn(jacobian.len(), |r, c| {
        let length = if r < 3 { reach_m.max(1e-3) } else { 1.0 };
        jacobian[c][r] / length * if robot.joints[c].kind.slides() { reach_m } else { 1.0 }
    });
    let in_line = robot.joints.len() == 6 && q_rad[4].abs() < rad_from_deg(WRIST_DEG);
    let singular = scaled.singular_values().min() < SINGULAR || in_line;
    singular.then_some(Restriction::Singular)
}
