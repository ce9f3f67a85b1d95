//! Points that lie too far apart or too near by one and the same share.

use super::trials::{most_left_m, most_m, trial};
use super::{Fault, FaultKind};
use crate::column_names::POINT;
use crate::register::register_from_usual_starts;
use crate::{Reading, Registration, Station};
use nalgebra::{Isometry3, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::SerialArm;
use robot_model::units::mm_from_m;
use std::collections::BTreeSet;

/// Lengths that differ by more than this share are of another scale: instruments are off by 1e-6 a kelvin, arms that warm by 1e-4, and
/// links by their tolerance, each in its own way.
const OTHER_SCALE: f64 = 1.5e-3;
/// A scale must leave this share of the distance or less.
const SCALED: f64 = 0.35;
/// In fewer poses the zero of a joint lets the points lie as far apart as a scale of some percent does.
const FEWEST_FOR_SCALE: usize = 12;
/// Beyond this share no zero does: a unit's factor.
const OF_A_UNIT: f64 = 0.5;
/// Steps of the secant that finds the scale.
const SCALINGS: usize = 4;

/// The first try of a zero: metres of a joint that slides, radians.
const FIRST_ZERO: f64 = 1e-3;
/// Steps that find a zero.
const ZEROINGS: usize = 4;

/// All points too far apart or too near, by more than any instrument or arm is off, where that is what they miss by.
pub(super) fn find_scale(
    robot: &SerialArm,
    stations: &[Station],
    targets: usize,
    registration: &Registration,
) -> Option<Fault> {
    let stations = trial(stations);
    let chain = SerialChain::nominal(robot);
    let poses: Vec<Isometry3<f64>> = stations.iter().map(|s| s.pose(&chain)).collect();
    let factor = right_scale(&stations, &poses, targets, registration)?;
    let before_m = most_left_m(&stations, &poses, targets)?;
    let after_m = most_left_m(&scaled(&stations, factor), &poses, targets)?;
    let by = 1.0 / factor - 1.0;
    let poses: BTreeSet<usize> = stations.iter().map(|station| station.pose).collect();
    if poses.len() < FEWEST_FOR_SCALE && by.abs() < OF_A_UNIT {
        return None;
    }
    let is_of_scale = by.abs() > OTHER_SCALE && after_m < SCALED * before_m;
    // An arm whose radius slides and counts from elsewhere has all its points too far apart, or too near, by about the same share.
    let is_a_zero = || {
        (0..robot.joints.len())
            .any(|j| with_zero_m(&chain, &stations, targets, j).is_some_and(|m| m < after_m))
    };
    (is_of_scale && (by.abs() >= OF_A_UNIT || !is_a_zero())).then(|| {
        let than = if by > 0.0 { "longer" } else { "shorter" };
        Fault::of_all(
            FaultKind::PositionUnits,
            Some(&POINT.join(", ")),
            format!(
                "all lengths between the points are {:.1} % {than} than the arm's: with that taken out {:.2} mm are left of {:.2} mm; look at the \
                 instrument's scale, its refraction and its unit, or at whether this is the arm that was measured",
                1e2 * by.abs(),
                mm_from_m(after_m),
                mm_from_m(before_m)
            ),
        )
    })
}

/// What `stations` leave, metres, where joint `j` is taken to count from where it leaves the least; `None` where that is not found.
fn with_zero_m(chain: &SerialChain, stations: &[Station], targets: usize, j: usize) -> Option<f64> {
    let left_at = |zero: f64| -> Option<(Vec<Vector3<f64>>, f64)> {
        let moved = |station: &Station| {
            let mut moved = station.clone();
            moved.q_rad[j] += zero;
            moved
        };
        let moved: Vec<Station> = stations.iter().map(moved).collect();
        let poses: Vec<Isometry3<f64>> = moved.iter().map(|s| s.pose(chain)).collect();
        let fit = register_from_usual_starts(&moved, &poses, targets, None).ok()?;
        let left: Vec<Vector3<f64>> =
            moved.iter().zip(&poses).map(|(s, pose)| fit.residual_m(s, pose)).collect();
        let most_m = most_m(&mut left.iter().map(|left| left.norm()).collect::<Vec<f64>>());
        Some((left, most_m))
    };
    let (mut known, mut step) = ((0.0, left_at(0.0)?.0), FIRST_ZERO);
    let mut least_m = f64::INFINITY;
    for _ in 0..ZEROINGS {
        let zero = known.0 + step;
        let (left, most_m) = left_at(zero)?;
        least_m = least_m.min(most_m);
        // What is left goes nearly straight with the zero, whatever the registration takes of it.
        let per_step = |i: usize| (left[i] - known.1[i]) / step;
        let along: f64 = (0..left.len()).map(|i| left[i].dot(&per_step(i))).sum();
        let squares: f64 = (0..left.len()).map(|i| per_step(i).norm_squared()).sum();
        step = -along / squares;
        known = (zero, left);
        if !step.is_finite() || step.abs() < 1e-7 {
            break;
        }
    }
    least_m.is_finite().then_some(least_m)
}

fn scaled(stations: &[Station], factor: f64) -> Vec<Station> {
    stations.iter().map(|s| Station { reading: s.reading.scaled(factor), ..s.clone() }).collect()
}

/// What the points must be multiplied by to lie as far apart as the arm puts them; `None` where that is about 1.
fn right_scale(
    stations: &[Station],
    poses: &[Isometry3<f64>],
    targets: usize,
    registration: &Registration,
) -> Option<f64> {
    let excess_at = |factor: f64| -> Option<f64> {
        let tried = scaled(stations, factor);
        excess(&tried, poses, &register_from_usual_starts(&tried, poses, targets, None).ok()?)
    };
    let mut known = (1.0, excess(stations, poses, registration)?);
    if known.1.abs() < 0.5 * OTHER_SCALE {
        return None;
    }
    // The registration takes a part of the excess: a secant finds where none is left.
    let mut factor = 1.0 - known.1;
    for _ in 0..SCALINGS {
        let now = (factor, excess_at(factor)?);
        let step = now.1 * (now.0 - known.0) / (now.1 - known.1);
        known = now;
        if !step.is_finite() || step.abs() < 1e-7 {
            break;
        }
        factor -= step;
    }
    Some(factor)
}

/// By which share the points of `stations` lie further from their middle than `fit` puts them; `None` where they are no points.
fn excess(stations: &[Station], poses: &[Isometry3<f64>], fit: &Registration) -> Option<f64> {
    let read: Vec<(Vector3<f64>, Vector3<f64>)> = stations
        .iter()
        .zip(poses)
        .filter(|(s, _)| matches!(s.reading, Reading::Point { .. }))
        .filter_map(|(s, pose)| {
            let point = fit.instrument_from_base.inverse_transform_point(&s.reading.position_m()?.into());
            Some((point.coords, fit.residual_m(s, pose)))
        })
        .collect();
    let middle_m = read.iter().map(|(point_m, _)| point_m).sum::<Vector3<f64>>() / read.len().max(1) as f64;
    let mut shares: Vec<[f64; 2]> = read
        .iter()
        .map(|(point_m, left_m)| {
            let arm_m = point_m - middle_m;
            [arm_m.dot(left_m), arm_m.norm_squared()]
        })
        .collect();
    // A few false rows must not decide: those that say most are left out.
    sorting::by(&mut shares, |a, b| (a[0].abs()).total_cmp(&b[0].abs()));
    shares.truncate(shares.len() - shares.len() / 10);
    let sum = |k: usize| shares.iter().map(|share| share[k]).sum::<f64>();
    (sum(1) > 0.0).then(|| sum(0) / sum(1))
}
