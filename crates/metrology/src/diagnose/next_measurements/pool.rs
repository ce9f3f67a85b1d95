//! Poses that could be measured next: those that the robot may take, with either payload and direction, now or on a new warm-up.

use crate::admissible::{Admission, Space, drawn_range_rad, kept_range_rad};
use crate::diagnose::options::DiagnosisOptions;
use crate::diagnose::outcome::NextMeasurement;
use inference::dataset::{Dataset, Observation, ObservationKind};
use inference::linearise::Linearised;
use inference::split_mix::SplitMix64;
use measurements::{Reading, Registration, Station};
use nalgebra::{Isometry3, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Joint, Joints, SerialArm};
use std::f64::consts::TAU;

const CANDIDATES: usize = 400;
/// With nests each takes four times the arithmetic.
const CANDIDATES_WITH_NESTS: usize = 150;
/// Poses tried for each candidate: of an arm of six joints a fifth to a third are allowed.
const TRIES: usize = 40;

/// When the next rows are measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum When {
    /// After the last row, the robot as warm as it is.
    After,
    /// From a cold start again.
    FromCold,
}

/// What is measured at each pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Setup {
    /// When the poses are measured.
    pub when: When,
    /// Whether nests on the base are read at each pose.
    pub with_nests: bool,
}

/// Nests on the base.
pub(super) const NESTS: usize = 3;
/// How far they are from the base's axis, metres.
const NEST_RADIUS_M: f64 = 0.4;

/// A pose that could be measured next.
#[derive(Clone, Debug)]
pub(super) struct PoolPose {
    /// The arm as it would stand there, and the nests on the base that are read meanwhile.
    pub observations: Vec<Observation>,
    /// As it is written.
    pub next: NextMeasurement,
}

/// The pool for at most `most` rows.
pub(super) fn pool(
    robot: &SerialArm,
    linear: &Linearised,
    options: &DiagnosisOptions,
    setup: Setup,
    most: usize,
) -> Vec<PoolPose> {
    let chain = SerialChain::nominal(robot);
    let registration = with_nests(linear, options);
    let (space, tool_m) = (Space::default(), registration.tools_m[0]);
    let admission = Admission::new(robot, tool_m, &space);
    let first_nest = linear.registration.fixed_points_m.len();
    let mut draw = Draw {
        robot,
        dataset: &linear.dataset,
        ranges: ranges(robot, linear),
        payloads_kg: payloads_kg(robot, &linear.dataset),
        setup,
        most,
        random: SplitMix64::new(0x2545_f491_4f6c_dd1d),
    };
    let mut all = Vec::new();
    let candidates = if setup.with_nests { CANDIDATES_WITH_NESTS } else { CANDIDATES };
    for _ in 0..TRIES * candidates {
        if all.len() == candidates {
            break;
        }
        let (station, next) = draw.station();
        if admission.restriction(&station.q_rad, &next.dir).is_some() {
            continue;
        }
        let observation = Observation::new(robot, &chain, &registration, &station);
        let nests = (first_nest..first_nest + NESTS).filter(|_| setup.with_nests).map(|fixed_point| {
            let reading = Reading::Nest { fixed_point, position_m: Vector3::zeros(), with_joints: true };
            Observation::new(robot, &chain, &registration, &Station { reading, ..station.clone() })
        });
        let observations = std::iter::once(observation).chain(nests).collect();
        all.push(PoolPose { observations, next });
    }
    all
}

/// The registration of the rows measured, in the base's frame, with the tool that is wanted and nests on the base.
fn with_nests(linear: &Linearised, options: &DiagnosisOptions) -> Registration {
    let tool_m = options
        .tool_m
        .or_else(|| linear.registration.tools_m.first().copied())
        .unwrap_or_else(Vector3::zeros);
    Registration {
        instrument_from_base: Isometry3::identity(),
        tools_m: vec![tool_m],
        fixed_points_m: linear.registration.fixed_points_m.iter().copied().chain(nests_m()).collect(),
        ..linear.registration.clone()
    }
}

/// What is hung on: nothing and, where the file has payloads, its largest, or where all are 0 what the arm may carry.
fn payloads_kg(robot: &SerialArm, dataset: &Dataset) -> Vec<f64> {
    let usual_kg = robot.rated_payload_kg().map_or(USUAL_PAYLOAD_KG, |rated| rated.min(USUAL_PAYLOAD_KG));
    let most_kg = dataset.largest_payload_kg;
    match dataset.channels.payload {
        true => vec![0.0, if most_kg > 0.0 { most_kg } else { usual_kg }],
        false => vec![0.0],
    }
}

/// Draws poses with payload, direction and time.
struct Draw<'a> {
    robot: &'a SerialArm,
    dataset: &'a Dataset,
    /// Of each joint, radians.
    ranges: Vec<[f64; 2]>,
    payloads_kg: Vec<f64>,
    setup: Setup,
    /// Rows that are measured at most.
    most: usize,
    random: SplitMix64,
}

impl Draw<'_> {
    /// The next one, and as it is written.
    fn station(&mut self) -> (Station, NextMeasurement) {
        let Self { robot, dataset, ranges, payloads_kg, random, .. } = self;
        let mut q_rad = Joints::all(robot.joints.len(), 0.0);
        for (q, [low, high]) in q_rad.iter_mut().zip(&*ranges) {
            *q = low + (high - low) * random.unit();
        }
        let direction = Joints::from_fn(robot.joints.len(), |_| if random.unit() < 0.5 { -1 } else { 1 });
        let payload_kg = payloads_kg[random.below(payloads_kg.len())];
        let share = random.unit();
        let (stand, by_time) = (dataset.stands.saturating_sub(1), dataset.time_min.is_some());
        let next = NextMeasurement { q_deg: robot.in_deg_or_mm(&q_rad), payload_kg, dir: direction };
        let RowTime { clock, joint_temperature_c } = self.time_of_row(share);
        let place = clock.filter(|_| !by_time);
        let station = Station {
            stand,
            t_min: clock.filter(|_| by_time),
            direction: Some(direction),
            payload_kg: Some(payload_kg),
            joint_temperature_c,
            rows: vec![place.map_or(0, |row| row.max(0.0) as usize)],
            ..Station::bare(0, q_rad, Reading::Point { position_m: Vector3::zeros() })
        };
        (station, next)
    }

    /// The moment after this share of the rows that are still to be measured, and how warm the joints are then: as in the row next to it,
    /// or the last.
    fn time_of_row(&self, share: f64) -> RowTime {
        let observations = &self.dataset.observations;
        let (clock, like) = match self.dataset.clock {
            None => (None, observations.iter().max_by(|a, b| a.clock().total_cmp(&b.clock()))),
            Some([low, high]) => {
                let each = (high - low) / observations.len().max(1) as f64;
                // The clock of a file of several days is 0 at the last cold start, and a file may begin long after one.
                let from = match self.setup.when {
                    When::After => high,
                    _ if self.dataset.time_min.is_some() => 0.0,
                    _ => low,
                };
                let at = from + share * each * self.most as f64;
                let near = |o: &Observation| (o.clock() - at).abs();
                (Some(at), observations.iter().min_by(|a, b| near(a).total_cmp(&near(b))))
            }
        };
        RowTime { clock, joint_temperature_c: like.and_then(|o| o.joint_temperature_c) }
    }
}

/// When a row is measured.
struct RowTime {
    /// Minute, or place in the file; `None` where neither tells the order.
    clock: Option<f64>,
    joint_temperature_c: Option<Joints>,
}

/// Where nests on the base are taken to stand, base frame.
fn nests_m() -> impl Iterator<Item = Vector3<f64>> {
    let angles = (0..NESTS).map(|n| TAU * n as f64 / NESTS as f64);
    angles.map(|angle| Vector3::new(NEST_RADIUS_M * angle.cos(), NEST_RADIUS_M * angle.sin(), 0.0))
}

/// What is hung on where the file has payloads and all are 0, kg, on an arm that may carry it.
const USUAL_PAYLOAD_KG: f64 = 5.0;

/// The ranges that poses are drawn from, radians; of a joint whose range is not given, or is more than a turn, within the range measured.
fn ranges(robot: &SerialArm, linear: &Linearised) -> Vec<[f64; 2]> {
    let measured = |j: usize| {
        let all = linear
            .dataset
            .observations
            .iter()
            .filter(|s| s.kind != ObservationKind::Nest)
            .map(|s| s.q_rad[j]);
        all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], q| [low.min(q), high.max(q)])
    };
    let of = |(j, joint): (usize, &Joint)| {
        match joint.range_rad.is_some_and(|[low, high]| high - low <= TAU) {
            true => drawn_range_rad(joint),
            false => {
                let ([lowest, highest], [low, high]) = (measured(j), kept_range_rad(joint));
                // Rows that all lie at an end of the range leave nothing between.
                if low.max(lowest) < high.min(highest) {
                    [low.max(lowest), high.min(highest)]
                } else {
                    [lowest, highest]
                }
            }
        }
    };
    robot.joints.iter().enumerate().map(of).collect()
}
