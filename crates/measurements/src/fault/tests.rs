//! Rows of an arm that stands exactly where its model says, seen by an instrument or with a target that is put elsewhere.

use super::{FaultKind, PartFault, PosedRow, find_in_one_target, find_in_rows, find_moved_target};
use crate::{Reading, Station};
use nalgebra::{Isometry3, Point3, Translation3, UnitQuaternion, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Joints, SerialArm};

const TOOL_M: Vector3<f64> = Vector3::new(0.05, -0.03, 0.12);

/// Joints all over the middle of their ranges, by the powers of the golden section.
fn q_rad(i: usize) -> Joints {
    Joints::from_fn(6, |j| {
        let part = ((i as f64 + 1.0) * 0.618_034_f64.powi(j as i32 + 1)).fract();
        [1.5, 0.8, 0.7, 1.6, 1.2, 2.0][j] * (2.0 * part - 1.0) + if j == 4 { 0.3 } else { 0.0 }
    })
}

/// 60 rows seen from where `instrument_from_base` says, the target at `tool_m`, both by row.
fn rows(
    instrument_from_base: impl Fn(usize) -> Isometry3<f64>,
    tool_m: impl Fn(usize) -> Vector3<f64>,
) -> (SerialArm, Vec<PosedRow>) {
    let arm = SerialArm::built_in("irb140").unwrap();
    let chain = SerialChain::nominal(&arm);
    let row = |i: usize| {
        let pose = chain.forward(&q_rad(i));
        let position_m = (instrument_from_base(i) * (pose * Point3::from(tool_m(i)))).coords;
        let station = Station::bare(i, q_rad(i), Reading::Point { position_m });
        PosedRow { station: Station { line: i as u64 + 2, ..station }, pose }
    };
    let rows = (0..60).map(row).collect();
    (arm, rows)
}

fn stand(k: usize) -> Isometry3<f64> {
    let turn_rad = [Vector3::zeros(), Vector3::new(0.1, -0.2, 0.3), Vector3::new(-0.3, 0.1, 0.2)][k];
    let shift_m =
        [Vector3::new(1.5, 0.2, 0.1), Vector3::new(1.2, -0.4, 0.2), Vector3::new(1.9, 0.5, -0.1)][k];
    Isometry3::from_parts(Translation3::from(shift_m), UnitQuaternion::from_scaled_axis(turn_rad))
}

#[test]
fn an_instrument_that_is_moved_twice_is_taken_back_step_by_step() {
    let stand_of = |i: usize| usize::from(i >= 22) + usize::from(i >= 41);
    let (arm, mut rows) = rows(|i| stand(stand_of(i)), |_| TOOL_M);
    let mut moves = 0;
    while let Some(PartFault::Moved { rows: moved, first_from_second }) = find_in_rows(&arm, &rows, 1, None) {
        moves += 1;
        assert!(moved.start == 22 || moved.start == 41, "{moved:?}");
        for row in &mut rows[moved] {
            let seen_m = Point3::from(row.station.reading.position_m().unwrap());
            row.station.reading = Reading::Point { position_m: (first_from_second * seen_m).coords };
        }
    }
    assert_eq!(moves, 2);
    // All in one frame: what is left of the moves is one rigid motion for all rows.
    let frame_of = |i: usize| {
        let row = &rows[i];
        let in_base = row.pose * Point3::from(TOOL_M);
        (row.station.reading.position_m().unwrap(), in_base.coords)
    };
    let apart = |i: usize, k: usize| {
        let ((seen_a, base_a), (seen_b, base_b)) = (frame_of(i), frame_of(k));
        ((seen_a - seen_b).norm() - (base_a - base_b).norm()).abs()
    };
    assert!((0..60).all(|i| apart(i, 21) < 1e-6 && apart(i, 30) < 1e-6 && apart(i, 50) < 1e-6));
}

#[test]
fn a_target_that_is_mounted_anew_is_another_one_in_its_rows() {
    let by_m = Vector3::new(0.006, 0.01, 0.022);
    let (arm, rows) = rows(|_| stand(1), |i| if i >= 36 { TOOL_M + by_m } else { TOOL_M });
    let Some(PartFault::Remounted { rows: found, by_m: found_m }) = find_in_rows(&arm, &rows, 1, None) else {
        panic!("not found")
    };
    assert_eq!(found, 36..60);
    assert!((found_m - by_m.norm()).abs() < 1e-6, "{found_m}");
}

#[test]
fn repeats_of_few_poses_place_no_second_stand() {
    // Joint 1 counted the other way round in the second half, which sees three poses eight times each.
    let (arm, mut rows) = rows(|_| stand(0), |_| TOOL_M);
    let chain = SerialChain::nominal(&arm);
    for (i, row) in rows.iter_mut().enumerate().skip(36) {
        let q_rad = q_rad(36 + i % 3);
        let point = chain.forward(&q_rad) * Point3::from(TOOL_M);
        row.station.q_rad = q_rad;
        row.station.q_rad[0] = -q_rad[0];
        row.station.reading = Reading::Point { position_m: (stand(0) * point).coords };
        row.pose = chain.forward(&row.station.q_rad);
    }
    let Some(PartFault::Fault(fault)) = find_in_rows(&arm, &rows, 1, None) else { panic!("no fault") };
    assert_eq!((fault.kind.name(), fault.column.as_deref()), ("joint_columns", Some("q1_deg")));
}

/// Every ninth row, or eight in a row, with one coordinate ten times too large: metres and more beyond what the arm reaches, where a fit of all
/// rows would go astray.
#[test]
fn rows_without_a_decimal_mark_are_named_wherever_they_stand() {
    let scattered: Vec<usize> = (4..60).step_by(9).collect();
    for wrong in [scattered, (30..38).collect()] {
        let (arm, mut rows) = rows(|_| stand(0), |_| TOOL_M);
        for &i in &wrong {
            let position_m = rows[i].station.reading.position_mut().unwrap();
            position_m.x *= 10.0;
        }
        let Some(PartFault::Fault(fault)) = find_in_rows(&arm, &rows, 1, None) else { panic!("no fault") };
        assert!(fault.reason.contains("column x_mm is 10 times too large"), "{}", fault.reason);
        let lines: Vec<u64> = wrong.iter().map(|&i| rows[i].station.line).collect();
        assert_eq!(fault.lines, lines);
    }
}

/// Three targets in turn at 60 poses of an arm whose joint 3 is off by 0.5 mrad, with noise of some 0.03 mm; `tool_m` by pose and target, and
/// joint 6 off by `q6_rad`, by pose.
fn visits(
    targets: usize,
    tool_m: impl Fn(usize, usize) -> Vector3<f64>,
    q6_rad: impl Fn(usize) -> f64,
) -> (SerialArm, Vec<PosedRow>, Vec<usize>) {
    let arm = SerialArm::built_in("irb140").unwrap();
    let chain = SerialChain::nominal(&arm);
    let row = |k: usize| {
        let (i, target) = (k / targets, k % targets);
        let mut stands = q_rad(i);
        stands[2] += 5e-4;
        stands[5] += q6_rad(i);
        // Even over +-0.05 mm, by the golden section.
        let noise = |a: usize| 1e-4 * (((7 * k + 3 * a + 1) as f64 * 0.754_877_666).fract() - 0.5);
        let noise_m = Vector3::new(noise(0), noise(1), noise(2));
        let seen = stand(0) * (chain.forward(&stands) * Point3::from(tool_m(i, target)));
        let station = Station::bare(i, q_rad(i), Reading::Point { position_m: seen.coords + noise_m });
        PosedRow {
            station: Station { line: k as u64 + 2, target, ..station },
            pose: chain.forward(&q_rad(i)),
        }
    };
    let rows: Vec<PosedRow> = (0..60 * targets).map(row).collect();
    let named = rows.iter().map(|row| row.station.target).collect();
    (arm, rows, named)
}

const TARGETS_M: [Vector3<f64>; 3] =
    [Vector3::new(0.06, 0.04, 0.1), Vector3::new(-0.08, 0.03, 0.06), Vector3::new(0.01, -0.09, 0.12)];
/// 0.3 mm along no plane of the targets.
const KNOCK_M: Vector3<f64> = Vector3::new(1.8e-4, 1.92e-4, 1.44e-4);

#[test]
fn the_one_of_three_targets_that_is_knocked_is_named_whatever_the_arm_does() {
    let knocked =
        |i: usize, t: usize| TARGETS_M[t] + if t == 1 && i >= 40 { KNOCK_M } else { Vector3::zeros() };
    let (_, rows, named) = visits(3, knocked, |_| 0.0);
    let moved = find_moved_target(&rows, &named, 3).unwrap();
    assert_eq!((moved.target, moved.from), (Some(1), 3 * 40 + 1));
    assert!((moved.by_m - 3e-4).abs() < 3e-5, "{}", moved.by_m);
}

#[test]
fn targets_that_move_together_are_no_knock_of_one() {
    let still = |_: usize, t: usize| TARGETS_M[t];
    let all = |i: usize, t: usize| TARGETS_M[t] + if i >= 40 { KNOCK_M } else { Vector3::zeros() };
    let turned = |i: usize| if i >= 40 { 2e-3 } else { 0.0 };
    for (targets, (_, rows, named)) in [
        (3, visits(3, still, |_| 0.0)),
        (3, visits(3, all, |_| 0.0)),
        (3, visits(3, still, turned)),
        (2, visits(2, still, turned)),
    ] {
        assert_eq!(find_moved_target(&rows, &named, targets), None);
    }
}

/// The distance between them has changed; which of both has moved it does not say.
#[test]
fn of_two_targets_either_may_have_been_knocked() {
    let knocked =
        |i: usize, t: usize| TARGETS_M[t] + if t == 0 && i >= 20 { KNOCK_M } else { Vector3::zeros() };
    let (_, rows, named) = visits(2, knocked, |_| 0.0);
    let moved = find_moved_target(&rows, &named, 2).unwrap();
    assert_eq!((moved.target, moved.from), (None, 2 * 20));
    assert!((moved.by_m - 3e-4).abs() < 3e-5, "{}", moved.by_m);
}

#[test]
fn one_target_in_metres_is_named() {
    let (arm, mut rows, _) = visits(3, |_, t| TARGETS_M[t], |_| 0.0);
    for row in rows.iter_mut().filter(|row| row.station.target == 2) {
        let seen_m = row.station.reading.position_m().unwrap();
        row.station.reading = Reading::Point { position_m: seen_m * 1e-3 };
    }
    let names = ["A", "B", "C"].map(str::to_owned);
    let fault = find_in_one_target(&arm, &rows, &names).unwrap();
    assert_eq!((fault.kind, fault.lines.len()), (FaultKind::PositionUnits, 60));
    assert!(
        fault.reason.starts_with("of target C alone: the measured points are in metres"),
        "{}",
        fault.reason
    );
}

/// Points of a cylindrical arm: a turn, a height and a radius that slide, and a hand that turns; `radius_off_m` is what the radius counts wrong,
/// and `factor` the instrument's.
fn cylindrical(radius_off_m: f64, factor: f64) -> (SerialArm, Vec<Station>) {
    let joint = |origin: &str, axis: &str, range: &str| {
        format!("[[joint]]\norigin_mm = {origin}\naxis = {axis}\n{range}\n")
    };
    let text = [
        "name = \"cylindrical\"\nsource = \"made up\"\n".to_owned(),
        joint("[0, 0, 200]", "[0, 0, 1]", "range_deg = [-170, 170]"),
        joint("[0, 0, 150]", "[0, 0, 1]", "type = \"prismatic\"\nrange_mm = [0, 600]"),
        joint("[150, 0, 60]", "[1, 0, 0]", "type = \"prismatic\"\nrange_mm = [0, 450]"),
        joint("[120, 0, 0]", "[0, 0, 1]", "range_deg = [-180, 180]"),
        "[flange]\norigin_mm = [60, 0, -40]\n".to_owned(),
    ]
    .concat();
    let arm = SerialArm::from_toml(&text).unwrap();
    let chain = SerialChain::nominal(&arm);
    let station = |i: usize| {
        let part = |j: i32| ((i as f64 + 1.0) * 0.618_034_f64.powi(j)).fract();
        let [turn, height, radius, hand] =
            [6.0 * part(1) - 3.0, 0.6 * part(2), 0.45 * part(3), 6.0 * part(4)];
        let is_rad = Joints::from_fn(4, |j| [turn, height, radius + radius_off_m, hand][j]);
        let point = stand(1) * (chain.forward(&is_rad) * Point3::from(TOOL_M));
        let noise = |k: f64| 6e-5 * ((i as f64 * k).fract() - 0.5);
        let position_m = point.coords * factor + Vector3::new(noise(0.317), noise(0.871), noise(0.143));
        Station::bare(
            i,
            Joints::from_fn(4, |j| [turn, height, radius, hand][j]),
            Reading::Point { position_m },
        )
    };
    (arm, (0..80).map(station).collect())
}

/// A home switch that is 2.5 mm off lets the points of a cylindrical arm lie nearer to each other by a half per cent: no fault of the instrument. A
/// scale that is as much off remains one.
#[test]
fn a_radius_that_counts_from_elsewhere_is_no_scale() {
    let found = |(arm, stations): (SerialArm, Vec<Station>)| {
        let chain = SerialChain::nominal(&arm);
        let poses: Vec<Isometry3<f64>> = stations.iter().map(|s| s.pose(&chain)).collect();
        let registration = crate::register(&stations, &poses, 1, None).unwrap();
        super::scale::find_scale(&arm, &stations, 1, &registration)
    };
    for radius_off_m in [-0.006, -0.0025, 0.0025, 0.006] {
        let fault = found(cylindrical(radius_off_m, 1.0));
        assert!(fault.is_none(), "{radius_off_m}: {fault:?}");
    }
    for factor in [0.99, 0.995, 1.003, 1.02, 1.6] {
        let fault = found(cylindrical(0.0, factor));
        assert!(fault.is_some_and(|fault| fault.kind == FaultKind::PositionUnits), "{factor}");
    }
}
