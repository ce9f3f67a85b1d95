//! What to measure next: poses, payloads and directions that tell the likeliest cause from its rival.

use super::dataset::{Observation, ObservationKind, Twist};
use super::heldout::SplitMix64;
use super::linearise::Linearised;
use super::model::Workspace;
use super::options::Options;
use super::outcome::{NextMeasurement, Verdict};
use super::verdict::describe_candidate;
use crate::measure::{Reading, Registration, Station};
use nalgebra::{DMatrix, DVector, Isometry3, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Joints, SerialArm};
use std::f64::consts::TAU;

const CANDIDATES: usize = 300;
const CHOSEN: usize = 12;
/// Away from the ends of the joints' ranges, share of the range.
const MARGIN: f64 = 0.1;
/// The measured point stays this far above the base's plane, metres.
const FLOOR_M: f64 = 0.1;

/// Poses that separate `pair` best, and what they are good for.
#[must_use]
pub fn next_measurements(
    robot: &SerialArm,
    workspace: &Workspace<'_>,
    linear: &Linearised,
    pair: Option<(usize, Option<usize>)>,
    verdict: Verdict,
    options: &Options,
) -> (Vec<NextMeasurement>, String) {
    let Some((first, rival)) = pair else { return (Vec::new(), String::new()) };
    let observations = candidate_observations(robot, linear, options);
    let candidates = workspace.library.candidates;
    let own = &candidates[first];
    let other = rival.map(|r| &candidates[r]);
    let widths = own.prior_sigma.len() + other.map_or(0, |c| c.prior_sigma.len());
    let dataset = &linear.dataset;
    // Rows at one observation: registration, the rival, then the cause itself.
    let rows = |observation: &Observation| -> DMatrix<f64> {
        let mut twists: Vec<Twist> = (0..6).map(|k| observation.frame_offset(0, k)).collect();
        for k in 0..3 {
            let axis = observation.flange.column(k);
            twists.push([axis[0], axis[1], axis[2], 0.0, 0.0, 0.0]);
        }
        for candidate in other.iter().copied().chain([own]) {
            candidate.scaled_signature(dataset, observation, &mut twists);
        }
        DMatrix::from_fn(3, 9 + widths, |r, c| twists[c][r])
    };
    let width = 9 + widths;
    let mut gram = DMatrix::zeros(width, width);
    for observation in &dataset.observations {
        let a = rows(observation);
        gram += a.transpose() * a;
    }
    let each: Vec<DMatrix<f64>> = observations.iter().map(|(observation, _)| rows(observation)).collect();
    let mut taken: Vec<usize> = Vec::new();
    for _ in 0..CHOSEN.min(observations.len()) {
        let mut best: Option<(f64, usize)> = None;
        for (i, a) in each.iter().enumerate().filter(|(i, _)| !taken.contains(i)) {
            let with = &gram + a.transpose() * a;
            let gain = separation_m2(&with, width - own.prior_sigma.len());
            if best.is_none_or(|(b, _)| gain > b) {
                best = Some((gain, i));
            }
        }
        let Some((_, i)) = best else { break };
        gram += each[i].transpose() * &each[i];
        taken.push(i);
    }
    let poses = taken.into_iter().map(|i| observations[i].1.clone()).collect();
    let name = describe_candidate(own, dataset);
    let reason = match (verdict, other) {
        (Verdict::Ambiguous, Some(rival)) => {
            format!("to tell {name} from {}", describe_candidate(rival, dataset))
        }
        (Verdict::Explained | Verdict::Several, Some(rival)) => {
            format!("to confirm {name} against its nearest rival, {}", describe_candidate(rival, dataset))
        }
        _ => format!("to see effects as small as the noise; most of all {name}"),
    };
    (poses, reason)
}

/// Squared length of the cause's main column that registration and rival leave.
fn separation_m2(gram: &DMatrix<f64>, from: usize) -> f64 {
    let mut before = gram.view((0, 0), (from, from)).into_owned();
    let top = before.diagonal().max();
    for i in 0..from {
        before[(i, i)] += 1e-9 * top;
    }
    let cross: DVector<f64> = gram.view((0, from), (from, 1)).column(0).into_owned();
    let Some(cholesky) = before.cholesky() else { return 0.0 };
    gram[(from, from)] - cross.dot(&cholesky.solve(&cross))
}

fn candidate_observations(
    robot: &SerialArm,
    linear: &Linearised,
    options: &Options,
) -> Vec<(Observation, NextMeasurement)> {
    let mut random = SplitMix64::new(0x2545_f491_4f6c_dd1d);
    let chain = SerialChain::nominal(robot);
    let tool_m = options
        .tool_m
        .or_else(|| linear.registration.tools_m.first().copied())
        .unwrap_or_else(Vector3::zeros);
    let registration = Registration {
        instrument_from_base: Isometry3::identity(),
        tools_m: vec![tool_m],
        ..linear.registration.clone()
    };
    let payloads: Vec<f64> = {
        let most = linear.dataset.observations.iter().filter_map(|s| s.payload_kg).fold(0.0, f64::max);
        if linear.dataset.channels.payload {
            vec![0.0, if most > 0.0 { most } else { 5.0 }]
        } else {
            vec![0.0]
        }
    };
    let time = linear.dataset.clock;
    let ranges = ranges(robot, linear);
    let mut all = Vec::new();
    for _ in 0..20 * CANDIDATES {
        if all.len() == CANDIDATES {
            break;
        }
        let mut q_rad = Joints::all(robot.joints.len(), 0.0);
        for (q, [low, high]) in q_rad.iter_mut().zip(&ranges) {
            let margin = MARGIN * (high - low);
            *q = low + margin + (high - low - 2.0 * margin) * random.unit();
        }
        let direction = Joints::from_fn(robot.joints.len(), |_| if random.unit() < 0.5 { -1 } else { 1 });
        let payload_kg = payloads[random.below(payloads.len())];
        let station = Station {
            pose: 0,
            target: 0,
            stand: 0,
            t_min: time.map(|[low, high]| low + (high - low) * random.unit()),
            q_rad,
            reading: Reading::Point { position_m: Vector3::zeros() },
            orientation: None,
            direction: Some(direction),
            payload_kg: Some(payload_kg),
            joint_temperature_c: linear
                .dataset
                .joint_temperature_c
                .map(|ranges| ranges.map(|[low, high]| low + (high - low) * random.unit())),
            air_temperature_c: None,
            line: 0,
            rows: vec![0],
        };
        let observation = Observation::new(robot, &chain, &registration, &station);
        if observation.point_m.z < FLOOR_M
            || observation.origins_m[3..=chain.joints()].iter().any(|o| o.z < FLOOR_M)
        {
            continue;
        }
        let next = NextMeasurement { q_deg: robot.in_deg_or_mm(&q_rad), payload_kg, dir: direction };
        all.push((observation, next));
    }
    all
}

/// The joints' ranges, radians; of a joint whose range is not given, or is more than a turn, the range measured.
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
    let of = |(j, given): (usize, Option<[f64; 2]>)| {
        given.filter(|[low, high]| high - low <= TAU).unwrap_or_else(|| measured(j))
    };
    robot.joints.iter().map(|joint| joint.range_rad).enumerate().map(of).collect()
}
