//! Rows of an arm that stands exactly where its model says, seen by an instrument or with a target that is put elsewhere.

use super::{PartFault, PosedRow, find_in_rows};
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
