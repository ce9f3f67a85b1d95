//! Which poses to measure, so that all effects can be told apart: chosen from many that the robot can take, ordered, written
//! as a list to fill in and as RAPID to run.
//!
//! Knows no terminal and no files; the RAPID is written with `emit`'s numbers.

mod exchange;
mod information;
mod lines;
mod options;
mod outlook;
mod pool;
mod rapid;
mod sheet;
mod sweep;

pub use lines::GearLines;
pub use options::{PlanError, PlanOptions, Sweeps};
pub use outlook::{Confounded, EffectName, Outlook, Parameter};
pub use rapid::rapid;
pub use sheet::{poses_csv, template_csv};

use exchange::Choice;
use inference::signature::{PlannedMeasurement, signatures};
use nalgebra::Vector3;
use pool::Pose;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use robot_model::robot::{Joints, SerialArm};

/// Possible poses among which the best are chosen.
const POOL: usize = 1500;
/// Rounds of exchanging each pose for a better one.
const ROUNDS: usize = 3;
/// Where nests are believed to be, for what they will say: round the base, metres.
const NESTS_M: [[f64; 3]; 4] = [[0.5, 0.5, 0.0], [0.5, -0.5, 0.0], [-0.4, 0.0, 0.2], [0.0, 0.6, 0.4]];
/// Poses between two looks at the nests.
const BETWEEN_NESTS: usize = 10;

/// One step of a measurement run.
#[derive(Clone, Debug, PartialEq)]
pub enum MeasurementStep {
    /// Drive to a pose, from its side, and measure.
    Pose {
        /// Which pose, from 0: repeats share it.
        pose: usize,
        /// Joint angles, joint 1 first, radians.
        q_rad: Joints,
        /// Where each joint comes from.
        approach_rad: Joints,
        /// Sign of each joint's last motion.
        direction: Joints<i8>,
        /// Mass of the payload as declared, kg.
        payload_kg: f64,
    },
    /// Measure a nest on the base.
    Nest {
        /// Number of the nest, from 0.
        nest: usize,
    },
}

/// A measurement run and what it will say.
#[derive(Clone, Debug)]
pub struct MeasurementPlan {
    /// In the order of the run.
    pub steps: Vec<MeasurementStep>,
    /// What can be expected of it.
    pub outlook: Outlook,
    /// Exchanges that made it better.
    pub exchanges: usize,
    /// Possible poses among which it was chosen.
    pub pool: usize,
}

/// Plans a measurement run.
///
/// # Errors
/// [`PlanError`]
pub fn plan(robot: &SerialArm, options: &PlanOptions) -> Result<MeasurementPlan, PlanError> {
    plan_from(robot, options, POOL, ROUNDS)
}

/// As [`plan`], from a pool of `pool` poses and with `rounds` of exchange: fewer are quicker.
///
/// # Errors
/// As [`plan`].
pub fn plan_from(
    robot: &SerialArm,
    options: &PlanOptions,
    pool: usize,
    rounds: usize,
) -> Result<MeasurementPlan, PlanError> {
    let distinct = options.n.saturating_sub(options.repeats);
    if distinct < 12 {
        return Err(PlanError::TooFew { n: options.n, repeats: options.repeats });
    }
    let mut random = ChaCha8Rng::seed_from_u64(options.seed);
    let poses = pool::poses(robot, options, pool.max(2 * distinct), &mut random)?;
    let possible: Vec<PlannedMeasurement> =
        poses.iter().enumerate().map(|(i, pose)| pose.possible(i as f64 * options.each_min)).collect();
    let all = signatures(robot, options.tool_m, &possible);
    let Choice { chosen, exchanges } = exchange::choose(&all, distinct, options.sigma_m, rounds);
    let mut taken: Vec<Pose> = chosen.into_iter().filter_map(|i| poses.get(i).cloned()).collect();
    shuffle(&mut taken, &mut random);
    let swept = sweep::sweeps(robot, options, &poses)?;
    let steps = in_order(&taken, &swept, options);
    let run = timed(&steps, options, robot.joints.len());
    let signatures = signatures(robot, options.tool_m, &run);
    let mut outlook = outlook::outlook(&signatures, options.sigma_m);
    let q_rad: Vec<Joints> = run.iter().map(|m| m.q_rad).collect();
    outlook.lines = lines::lines(&signatures, &q_rad, options.sigma_m);
    Ok(MeasurementPlan { steps, outlook, exchanges, pool: poses.len() })
}

/// Fisher and Yates (1938): what comes when has nothing to do with where it is.
fn shuffle(poses: &mut [Pose], random: &mut ChaCha8Rng) {
    for i in (1..poses.len()).rev() {
        let k = random.random_range(0..=i);
        poses.swap(i, k);
    }
}

/// Payload by payload, the first one again at the end, with the repeats and the sweeps; nests in between.
fn in_order(poses: &[Pose], swept: &[Pose], options: &PlanOptions) -> Vec<MeasurementStep> {
    let of = |payload: &f64| -> Vec<usize> {
        (0..poses.len()).filter(|&i| poses[i].payload_kg == *payload).collect()
    };
    let mut order: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = Vec::new();
    for (k, payload) in options.payloads_kg.iter().enumerate() {
        let mut own = of(payload);
        if k == 0 {
            last = own.split_off(own.len().div_ceil(2));
        }
        order.extend(own);
    }
    let first: Vec<usize> = options.payloads_kg.first().map(of).unwrap_or_default();
    order.extend(last);
    let repeated = options.repeats;
    // Of the first payload as far as there are, spread over the run; where more come back than there are, each comes back several times.
    let from: Vec<usize> = if first.len() >= repeated { first } else { (0..poses.len()).collect() };
    let spread =
        |k: usize| if repeated <= from.len() { k * from.len() / repeated } else { k % from.len().max(1) };
    order.extend((0..repeated).filter_map(|k| from.get(spread(k)).copied()));
    let mut steps = Vec::new();
    for (k, &i) in order.iter().enumerate() {
        if k % BETWEEN_NESTS == 0 {
            steps.extend((0..options.nests).map(|nest| MeasurementStep::Nest { nest }));
        }
        steps.push(step(i, &poses[i]));
    }
    steps.extend(swept.iter().enumerate().map(|(k, pose)| step(poses.len() + k, pose)));
    steps.extend((0..options.nests).map(|nest| MeasurementStep::Nest { nest }));
    steps
}

fn step(number: usize, pose: &Pose) -> MeasurementStep {
    MeasurementStep::Pose {
        pose: number,
        q_rad: pose.q_rad,
        approach_rad: pose.approach_rad,
        direction: pose.direction,
        payload_kg: pose.payload_kg,
    }
}

fn timed(steps: &[MeasurementStep], options: &PlanOptions, joints: usize) -> Vec<PlannedMeasurement> {
    steps
        .iter()
        .enumerate()
        .map(|(k, step)| {
            let t_min = k as f64 * options.each_min;
            match *step {
                MeasurementStep::Pose { q_rad, direction, payload_kg, .. } => {
                    PlannedMeasurement { q_rad, direction, payload_kg, t_min, nest: None }
                }
                MeasurementStep::Nest { nest } => {
                    let at_m = Vector3::from(NESTS_M[nest % NESTS_M.len()])
                        + Vector3::z() * (nest / NESTS_M.len()) as f64 * 0.1;
                    let nest = Some((nest, at_m));
                    PlannedMeasurement {
                        q_rad: Joints::all(joints, 0.0),
                        direction: Joints::all(joints, 0),
                        payload_kg: 0.0,
                        t_min,
                        nest,
                    }
                }
            }
        })
        .collect()
}
