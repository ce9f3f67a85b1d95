//! Orientations that contradict points and joints: what happened to them is named, and sound ones are believed.

use super::nominal_cell::NominalCell;
use metrology::diagnose::{Findings, Verdict};
use nalgebra::{UnitQuaternion, Vector3};

const ROWS: usize = 40;

/// Parts w, x, y, z of each row's orientation, by its number and what was seen.
type Written<'a> = &'a dyn Fn(usize, &[UnitQuaternion<f64>]) -> [f64; 4];

fn parts(turn: UnitQuaternion<f64>) -> [f64; 4] {
    [turn.w, turn.i, turn.j, turn.k]
}

/// What is said of an arm as drawn, with a sensor on its flange whose orientations are `written` so.
fn answer(written: Written<'_>) -> Findings {
    let cell = NominalCell::new(ROWS);
    let flange_from_sensor = UnitQuaternion::from_scaled_axis(Vector3::new(0.6, -1.0, 0.4));
    let seen: Vec<UnitQuaternion<f64>> =
        cell.flanges.iter().map(|flange| flange.rotation * flange_from_sensor).collect();
    cell.answer("qw,qx,qy,qz", |k| written(k, &seen).map(|part| format!("{part:.7}")).join(","))
}

/// What is said of a file whose orientations are `written` so, and the lines.
fn fault(written: Written<'_>) -> (String, Vec<u64>) {
    let found = answer(written);
    let Some(fault) = found.fault.filter(|_| found.verdict == Verdict::DataFault) else {
        panic!("{:?}: {}", found.verdict, found.reason)
    };
    assert_eq!((fault.kind.name(), fault.column.as_deref()), ("orientations", Some("qw, qx, qy, qz")));
    (found.reason, fault.lines)
}

#[test]
fn sound_orientations_are_no_fault_nor_is_a_single_false_one() {
    let found = answer(&|k, seen| parts(seen[k]));
    assert_eq!(found.verdict, Verdict::NothingAboveNoise, "{}", found.reason);
    let found = answer(&|k, seen| parts(seen[if k == 7 { 30 } else { k }]));
    assert_eq!(found.verdict, Verdict::NothingAboveNoise, "{}", found.reason);
    let aside: Vec<_> = found.false_rows.iter().map(|row| (row.line, row.looks_like.as_deref())).collect();
    assert!(matches!(aside[..], [(9, Some(what))] if what.contains("its orientation is off")), "{aside:?}");
}

#[test]
fn orientations_of_another_order_or_direction_are_named_as_that() {
    let (reason, lines) = fault(&|k, seen| {
        let [w, x, y, z] = parts(seen[k]);
        [x, y, z, w]
    });
    assert!(reason.contains("hold x, y, z, w:") && lines.is_empty(), "{reason}");
    let (reason, _) = fault(&|k, seen| parts(seen[k].inverse()));
    assert!(reason.contains("the orientation is the inverse"), "{reason}");
    let (reason, _) = fault(&|k, seen| parts(seen[k.saturating_sub(1)]));
    assert!(reason.contains("that of the row before"), "{reason}");
    // Roll, pitch, yaw about fixed axes, given to turns about the moving ones.
    let (reason, _) = fault(&|k, seen| {
        let (roll, pitch, yaw) = seen[k].euler_angles();
        let about = UnitQuaternion::from_scaled_axis;
        parts(about(Vector3::x() * roll) * about(Vector3::y() * pitch) * about(Vector3::z() * yaw))
    });
    assert!(reason.contains("angles are fixed-xyz and were taken for moving-xyz"), "{reason}");
    let (reason, _) = fault(&|k, seen| parts(seen[(7 * k + 3) % ROWS]));
    assert!(reason.contains("leave the columns qw, qx, qy, qz out"), "{reason}");
}

#[test]
fn orientations_that_change_from_a_row_on_are_named_with_their_lines() {
    let from = 28;
    let last = (from as u64 + 2..ROWS as u64 + 2).collect::<Vec<u64>>();
    let (reason, lines) = fault(&|k, seen| {
        let [w, x, y, z] = parts(seen[k]);
        if k < from { [w, x, y, z] } else { [x, y, z, w] }
    });
    assert!(reason.contains("hold x, y, z, w") && lines == last, "{reason} {lines:?}");
    // The sensor hung for six rows: the first of these orientations is its own.
    let (reason, lines) = fault(&|k, seen| parts(seen[if (10..16).contains(&k) { 10 } else { k }]));
    assert!(reason.contains("the sensor stood still") && lines == [13, 14, 15, 16, 17], "{reason} {lines:?}");
    // The sensor was mounted anew, half a radian round.
    let turned = UnitQuaternion::from_scaled_axis(Vector3::z() * 0.5);
    let (reason, lines) = fault(&|k, seen| parts(if k < from { seen[k] } else { seen[k] * turned }));
    assert!(reason.contains("the sensor sits on the flange turned by 29 deg") && lines == last, "{reason}");
    // Turned by less, with the hand: the diagnosis finds that, and no row is a false one.
    let turned = UnitQuaternion::from_scaled_axis(Vector3::z() * 0.15);
    let found = answer(&|k, seen| parts(if k < from { seen[k] } else { seen[k] * turned }));
    assert!(found.fault.is_none() && found.false_rows.is_empty(), "{}: {:?}", found.reason, found.false_rows);
}
