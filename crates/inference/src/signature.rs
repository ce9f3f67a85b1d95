//! What every effect would do to measurements that are not yet taken: the diagnosis's own signatures, for planning.

use crate::dataset::{Dataset, Observation, Twist, scaled};
use crate::effects::{Candidate, testable_effects};
use crate::size_unit::SizeUnit;
use crate::time_course::TimeCourse;
use measurements::{Channels, Reading, Registration, Station};
use nalgebra::{Isometry3, Vector3};
use robot_model::deform::EffectKind;
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Axis, Joints, SerialArm};
use std::collections::BTreeSet;

/// A measurement that could be taken.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedMeasurement {
    /// Joint angles, joint 1 first, radians.
    pub q_rad: Joints,
    /// Sign of each joint's last motion.
    pub direction: Joints<i8>,
    /// Mass of the payload as declared, kg.
    pub payload_kg: f64,
    /// Minute since cold start at which it is taken.
    pub t_min: f64,
    /// Instead of the arm: nest number so and so, in the base.
    pub nest: Option<(usize, Vector3<f64>)>,
}

/// One variant of an effect: its columns in [`Signatures::rows`].
#[derive(Clone, Debug, PartialEq)]
pub struct Signature {
    /// Kind of the effect, which names it.
    pub effect: EffectKind,
    /// Joint that it sits in, or link; `None` for effects of the whole arm, its base or its target.
    pub joint: Option<Axis>,
    /// The joint that is driven.
    pub joint_b: Option<Axis>,
    /// Whether it changes with time.
    pub in_time: bool,
    /// Unit of its size.
    pub unit: SizeUnit,
    /// Usual size of its first parameter, in that unit.
    pub usual: f64,
    /// Its first column; the first is the effect itself, the others leave its shape open.
    pub first: usize,
    /// Number of columns of the effect.
    pub width: usize,
    /// Prior weight: families alike, variants share their family's.
    pub weight: f64,
}

/// Columns of registration, geometry and effects at each measurement.
#[derive(Clone, Debug)]
pub struct Signatures {
    /// Columns of base, target and nests: flat.
    pub registration: usize,
    /// Columns of geometry, per tolerance.
    pub geometry: usize,
    /// One for each effect and joint.
    pub effects: Vec<Signature>,
    /// Number of all columns together.
    pub width: usize,
    /// Three rows for each measurement, metres, each of `width` numbers; effects per prior sigma.
    pub rows: Vec<f64>,
    /// How each joint moves the target at each measurement, metres per radian.
    pub turns: Vec<Joints<[f64; 3]>>,
}

/// The signatures at `measurements` of a tool at `tool_m`; gear lines are left out, there are thousands: `turns` has what
/// they are made of.
#[must_use]
pub fn signatures(
    robot: &SerialArm,
    tool_m: Vector3<f64>,
    measurements: &[PlannedMeasurement],
) -> Signatures {
    let nests = measurements.iter().filter_map(|m| m.nest).map(|(nest, _)| nest + 1).max().unwrap_or(0);
    let dataset = planned_dataset(robot, tool_m, measurements, nests);
    let candidates = variants(&dataset);
    let registration = 9 + 3 * nests;
    let geometry = 6 * (dataset.joints() - 1);
    let effects = effect_columns(&candidates, registration + geometry);
    let width = effects.last().map_or(registration + geometry, |last| last.first + last.width);
    let mut rows = vec![0.0; 3 * dataset.observations.len() * width];
    for (observation, rows) in dataset.observations.iter().zip(rows.chunks_exact_mut(3 * width)) {
        for (c, twist) in twists(&dataset, observation, &candidates, nests).into_iter().enumerate() {
            let seen = observation.observed(twist);
            for r in 0..3 {
                rows[r * width + c] = seen[r];
            }
        }
    }
    let turns = dataset
        .observations
        .iter()
        .map(|observation| {
            Joints::from_fn(observation.joints(), |j| {
                std::array::from_fn(|k| observation.observed(observation.jacobian_column(j))[k])
            })
        })
        .collect();
    Signatures { registration, geometry, effects, width, rows, turns }
}

/// The measurements as if they had been taken, with all channels that a plan has.
fn planned_dataset(
    robot: &SerialArm,
    tool_m: Vector3<f64>,
    measurements: &[PlannedMeasurement],
    nests: usize,
) -> Dataset {
    let chain = SerialChain::nominal(robot);
    let mut fixed_points_m = vec![Vector3::zeros(); nests];
    for (nest, at_m) in measurements.iter().filter_map(|m| m.nest) {
        fixed_points_m[nest] = at_m;
    }
    let registration = Registration::assumed(Isometry3::identity(), vec![tool_m], fixed_points_m);
    let observation = |(i, m): (usize, &PlannedMeasurement)| {
        let reading = match m.nest {
            Some((fixed_point, position_m)) => Reading::Nest { fixed_point, position_m, with_joints: false },
            None => Reading::Point { position_m: Vector3::zeros() },
        };
        let involves_arm = m.nest.is_none();
        let station = Station {
            t_min: Some(m.t_min),
            direction: involves_arm.then_some(m.direction),
            payload_kg: involves_arm.then_some(m.payload_kg),
            ..Station::bare(i, m.q_rad, reading)
        };
        Observation::new(robot, &chain, &registration, &station)
    };
    let channels =
        Channels { pose_id: true, time: true, direction: true, payload: true, ..Channels::default() };
    Dataset::new(robot, measurements.iter().enumerate().map(observation).collect(), channels)
}

/// Where each candidate's columns stand, from `first` on.
fn effect_columns(candidates: &[Candidate], mut first: usize) -> Vec<Signature> {
    let families: BTreeSet<EffectKind> = candidates.iter().map(|c| c.kind).collect();
    let signature = |c: &Candidate| {
        let of_family: f64 = candidates.iter().filter(|o| o.kind == c.kind).map(|o| o.weight).sum();
        let signature = Signature {
            effect: c.kind,
            joint: c.variant.joint,
            joint_b: c.variant.joint_b,
            in_time: c.effect().time() != TimeCourse::Constant,
            unit: c.unit(),
            usual: c.prior_sigma.first().copied().unwrap_or(0.0) * c.display_scale,
            first,
            width: c.prior_sigma.len(),
            weight: c.weight / of_family / families.len() as f64,
        };
        first += c.prior_sigma.len();
        signature
    };
    candidates.iter().map(signature).collect()
}

/// One variant of each effect and joint: the likeliest.
fn variants(dataset: &Dataset) -> Vec<Candidate> {
    let mut kept: Vec<Candidate> = Vec::new();
    for candidate in testable_effects(dataset).candidates {
        let kind = candidate.kind;
        if kind == EffectKind::GearMesh || candidate.of_all_joints() {
            continue;
        }
        let same = |k: &&mut Candidate| {
            k.kind == candidate.kind
                && k.variant.joint == candidate.variant.joint
                && k.variant.joint_b == candidate.variant.joint_b
        };
        match kept.iter_mut().find(same) {
            Some(known) if known.weight < candidate.weight => *known = candidate,
            Some(_) => {}
            None => kept.push(candidate),
        }
    }
    kept
}

fn twists(
    dataset: &Dataset,
    observation: &Observation,
    candidates: &[Candidate],
    nests: usize,
) -> Vec<Twist> {
    let mut out: Vec<Twist> = (0..6).map(|k| observation.frame_offset(0, k)).collect();
    for k in 0..3 {
        let axis = observation.flange.column(k);
        out.push(Twist([axis[0], axis[1], axis[2], 0.0, 0.0, 0.0]));
    }
    for nest in 0..nests {
        for k in 0..3 {
            let mut shift = Twist::default();
            shift[k] = f64::from(u8::from(observation.fixed_point == Some(nest)));
            out.push(shift);
        }
    }
    for frame in 1..observation.joints() {
        for k in 0..6 {
            out.push(scaled(observation.frame_offset(frame, k), crate::design::Design::tolerance(k)));
        }
    }
    for candidate in candidates {
        candidate.scaled_signature(dataset.at(observation), &mut out);
    }
    out
}
