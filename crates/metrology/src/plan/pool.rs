//! Poses among which a plan is chosen, at random among those that the robot may take.

use super::options::{PlanError, PlanOptions};
use crate::admissible::{Admission, Restriction, approach_rad, drawn_range_rad};
use inference::signature::PlannedMeasurement;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use robot_model::robot::{Joints, SerialArm};

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
    let admission = Admission::new(robot, options.tool_m, &options.space);
    let ranges: Vec<[f64; 2]> = robot.joints.iter().map(drawn_range_rad).collect();
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
        match admission.restriction(&q_rad, &direction) {
            Some(restriction) => refused[restriction as usize] += 1,
            None => found.push(Pose {
                q_rad,
                approach_rad: approach_rad(robot, &q_rad, &direction),
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
