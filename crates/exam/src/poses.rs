//! Which poses are measured, in which order, and how the robot got there.

use super::arm::{Disturbance, ScrewArm};
use super::effect::ArmState;
use super::rng::Rng;
use nalgebra::{Point3, Vector3};
use robot_model::robot::{Joints, MOST_JOINTS, SerialArm};
use robot_model::units::rad_from_deg;
use serde::{Deserialize, Serialize};

/// How the poses are spread.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Spread {
    /// All over the arm's reach.
    Wide,
    /// In a box of 0.3 × 0.6 × 0.3 m before the robot.
    Cube,
    /// A few degrees round one posture.
    Narrow,
    /// One joint at a time.
    Sweeps,
}

/// What a data set records besides joints and points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Recorded {
    /// Minutes since cold start: `t_min`.
    pub time: bool,
    /// Directions of approach: `dir1` to `dir6`.
    pub direction: bool,
    /// Payload as declared: `payload_kg`.
    pub payload: bool,
    /// Joint temperatures: `temp_j1_c` to `temp_j6_c`.
    pub temperature: bool,
    /// Measured orientation: `qw`, `qx`, `qy`, `qz`.
    pub orientation: bool,
}

impl Recorded {
    /// What can be noted of a point without thermometers: time, direction, payload.
    pub const NOTED: Self =
        Self { time: true, direction: true, payload: true, temperature: false, orientation: false };
}

/// Half the width, in degrees, that each joint moves over where its range is wider.
const WIDEST_DEG: [f64; MOST_JOINTS] = [120.0, 90.0, 100.0, 150.0, 110.0, 180.0, 180.0];
/// The same of a joint that slides and has no range, metres.
const WIDEST_M: f64 = 0.1;
/// The middle of a small six-axis arm's working posture, degrees.
const POSTURE_DEG: [f64; 6] = [10.0, 20.0, 5.0, 25.0, 45.0, -20.0];

fn joints(robot: &SerialArm, rng: &mut Rng, spread: Spread, k: usize, n: usize) -> Joints {
    let count = robot.joints.len();
    let limit = |i: usize| {
        if robot.joints[i].kind.slides() {
            return robot.joints[i].range_rad.unwrap_or([-WIDEST_M, WIDEST_M]);
        }
        let wide = rad_from_deg(WIDEST_DEG[i]);
        robot.joints[i]
            .range_rad
            .map_or([-wide, wide], |[lo, hi]| [lo.max(-wide) * 0.95, hi.min(wide) * 0.95])
    };
    let posture = Joints::from_fn(count, |i| match POSTURE_DEG.get(i).filter(|_| count == 6) {
        Some(deg) => rad_from_deg(*deg),
        None => limit(i).iter().sum::<f64>() / 2.0,
    });
    match spread {
        Spread::Wide | Spread::Cube => Joints::from_fn(count, |i| {
            let [low, high] = limit(i);
            rng.uniform(low, high)
        }),
        Spread::Narrow => Joints::from_fn(count, |i| {
            let about = if robot.joints[i].kind.slides() { 0.02 } else { rad_from_deg(12.0) };
            posture[i] + rng.uniform(-1.0, 1.0) * about
        }),
        Spread::Sweeps => {
            let joint = (count * k / n.max(1)).min(count - 1);
            let mut q = posture;
            let [low, high] = limit(joint);
            q[joint] = rng.uniform(low, high);
            q
        }
    }
}

/// Whether the pose can be measured: above the floor, in front of the cell where a cube is asked for.
fn fits(point_m: &Vector3<f64>, spread: Spread) -> bool {
    match spread {
        Spread::Cube => {
            (0.4..0.7).contains(&point_m.x) && point_m.y.abs() < 0.3 && (0.25..0.55).contains(&point_m.z)
        }
        Spread::Wide | Spread::Sweeps => point_m.z > 0.05,
        Spread::Narrow => true,
    }
}

/// A measurement run as it is planned.
#[derive(Clone, Copy, Debug)]
pub struct RunSpec {
    /// How the poses are spread.
    pub spread: Spread,
    /// Number of rows in all.
    pub n: usize,
    /// Of these, the last so many come back to the first poses.
    pub repeats: usize,
    /// The measured point in the flange frame, metres.
    pub tool_m: Vector3<f64>,
    /// Payloads in turn, kg.
    pub payloads_kg: [f64; 2],
}

/// One row of a run that others planned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CommandedRow {
    /// Which pose: rows that repeat one share it.
    pub pose: usize,
    /// Joint angles, joint 1 first, radians.
    pub q_rad: Joints,
    /// Sign of each joint's last motion.
    pub direction: Joints<i8>,
    /// Mass of the payload as declared, kg.
    pub payload_kg: f64,
}

/// The moments of a measurement run.
#[must_use]
pub fn states(robot: &SerialArm, arm: &ScrewArm, rng: &mut Rng, run: &RunSpec) -> Vec<ArmState> {
    states_and_more(robot, arm, rng, run, MoreRows::NONE)
}

/// Rows that are measured after those of a run, robot, instrument and target left as they were.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MoreRows<'a> {
    /// What the robot is driven to; the poses count on from the run's.
    pub rows: &'a [CommandedRow],
    /// After a night's rest: minutes count from 0 again. Otherwise they go on.
    pub from_cold: bool,
    /// Seed of their noise: that of the run's own rows stays as it was.
    pub seed: u64,
    /// Whether nests on the base are read at each of them.
    pub with_nests: bool,
}

impl MoreRows<'_> {
    /// No rows beside those of the run.
    pub const NONE: Self = Self { rows: &[], from_cold: false, seed: 0, with_nests: false };
}

/// The same, and those of `more` after them.
#[must_use]
pub(super) fn states_and_more(
    robot: &SerialArm,
    arm: &ScrewArm,
    rng: &mut Rng,
    run: &RunSpec,
    more: MoreRows<'_>,
) -> Vec<ArmState> {
    let RunSpec { n, repeats, tool_m, payloads_kg, .. } = *run;
    let climate = Climate::new(arm.joints(), rng);
    let mut out: Vec<ArmState> = Vec::with_capacity(n);
    let distinct = n - repeats.min(n / 2);
    for k in 0..n {
        let q_rad =
            if k >= distinct { out[k - distinct].q_rad } else { drawn(robot, arm, rng, run, k, distinct) };
        let direction = Joints::from_fn(arm.joints(), |_| rng.sign() as i8);
        let row = CommandedRow { pose: 0, q_rad, direction, payload_kg: payloads_kg[k % 2] };
        out.push(climate.state(arm, tool_m, k, &row));
    }
    let later = more.rows.iter().enumerate().map(|(k, row)| {
        let mut state = climate.state(arm, tool_m, if more.from_cold { k } else { n + k }, row);
        state.clock_min = climate.minutes_each * (n + k) as f64;
        state
    });
    out.extend(later);
    out
}

/// Joints of row `k` of `distinct`.
fn drawn(
    robot: &SerialArm,
    arm: &ScrewArm,
    rng: &mut Rng,
    run: &RunSpec,
    k: usize,
    distinct: usize,
) -> Joints {
    let mut tries = 0;
    loop {
        let q = joints(robot, rng, run.spread, k, distinct);
        let point_m = (arm.flange(&q, &Disturbance::default()) * Point3::from(run.tool_m)).coords;
        tries += 1;
        if fits(&point_m, run.spread) || tries > 5_000 {
            return q;
        }
    }
}

/// The moments of `states` at other poses and directions, drawn as those of the run were.
#[must_use]
pub(super) fn elsewhere(
    robot: &SerialArm,
    arm: &ScrewArm,
    rng: &mut Rng,
    run: &RunSpec,
    states: &[ArmState],
) -> Vec<ArmState> {
    let n = states.len();
    let other = |(k, state): (usize, &ArmState)| {
        let q_rad = drawn(robot, arm, rng, run, k, n);
        ArmState {
            q_rad,
            direction: Joints::from_fn(arm.joints(), |_| rng.sign() as i8),
            torque_n_m: arm.gravity_torque_n_m(&q_rad, state.payload_kg, &state.payload_at_m),
            point_m: (arm.flange(&q_rad, &Disturbance::default()) * Point3::from(run.tool_m)).coords,
            ..*state
        }
    };
    states.iter().enumerate().map(other).collect()
}

/// The moments of a run that others planned.
#[must_use]
pub fn states_of(
    arm: &ScrewArm,
    rng: &mut Rng,
    tool_m: Vector3<f64>,
    rows: &[CommandedRow],
) -> Vec<ArmState> {
    let climate = Climate::new(arm.joints(), rng);
    rows.iter().enumerate().map(|(k, row)| climate.state(arm, tool_m, k, row)).collect()
}

/// How long a row takes and how the joints warm meanwhile: quickly by their motors, slowly by their castings.
struct Climate {
    minutes_each: f64,
    heat_k: Joints,
    quick_min: Joints,
    slow_min: Joints,
}

impl Climate {
    fn new(joints: usize, rng: &mut Rng) -> Self {
        Self {
            minutes_each: rng.uniform(0.5, 3.0),
            heat_k: Joints::from_fn(joints, |_| rng.uniform(5.0, 25.0)),
            quick_min: Joints::from_fn(joints, |_| rng.uniform(15.0, 45.0)),
            slow_min: Joints::from_fn(joints, |_| rng.uniform(80.0, 200.0)),
        }
    }

    fn state(&self, arm: &ScrewArm, tool_m: Vector3<f64>, k: usize, row: &CommandedRow) -> ArmState {
        let payload_at_m = Point3::new(0.02, 0.0, 0.09);
        let t_min = self.minutes_each * k as f64;
        ArmState {
            q_rad: row.q_rad,
            t_min,
            clock_min: t_min,
            direction: row.direction,
            payload_kg: row.payload_kg,
            payload_at_m,
            warmer_k: Joints::from_fn(arm.joints(), |j| {
                let cold = 0.6 * (-t_min / self.quick_min[j]).exp() + 0.4 * (-t_min / self.slow_min[j]).exp();
                self.heat_k[j] * (1.0 - cold)
            }),
            torque_n_m: arm.gravity_torque_n_m(&row.q_rad, row.payload_kg, &payload_at_m),
            point_m: (arm.flange(&row.q_rad, &Disturbance::default()) * Point3::from(tool_m)).coords,
        }
    }
}
