//! Files that look like faulty ones and are sound.

use super::nominal_cell::{NominalCell, even};
use metrology::diagnose::Verdict;
use nalgebra::{UnitQuaternion, Vector3};

/// Joint 2 is commanded in tenths of a degree, and stands there; its gear's line is as large as rounding would be.
#[test]
fn a_joint_that_is_commanded_in_round_steps_is_not_rounded() {
    let q_deg: Vec<[f64; 6]> = NominalCell::new(60)
        .q_deg
        .into_iter()
        .map(|q_deg| {
            std::array::from_fn(|j| if j == 1 { (10.0 * q_deg[j]).round() / 10.0 } else { q_deg[j] })
        })
        .collect();
    let geared = |mut q_deg: [f64; 6]| {
        q_deg[1] += 0.04 * (20.0 * q_deg[1].to_radians()).sin();
        q_deg
    };
    let found = NominalCell::at(q_deg, geared).answer("id", |k| k.to_string());
    assert_eq!(found.verdict, Verdict::Explained, "{}", found.reason);
    assert_eq!((found.causes[0].effect.name(), found.causes[0].n), ("gear_mesh", Some(20)));
}

/// Five quick readings of the cold arm, half an hour of warming up, then a pose every five minutes.
#[test]
fn a_pause_before_slower_work_is_no_other_unit_of_time() {
    let t_min = |k: usize| if k < 5 { 0.1 * k as f64 } else { 30.0 + 5.0 * (k - 5) as f64 };
    let found = NominalCell::new(50).answer("t_min", |k| t_min(k).to_string());
    assert_eq!(found.verdict, Verdict::NothingAboveNoise, "{}", found.reason);
}

#[test]
fn orientations_of_a_poor_sensor_are_no_fault() {
    let cell = NominalCell::new(50);
    let found = cell.answer("qw,qx,qy,qz", |k| {
        let off = [29.0, 31.0, 37.0].map(|root| 0.15 * even(k, root));
        let turn = cell.flanges[k].rotation * UnitQuaternion::from_scaled_axis(Vector3::from(off));
        [turn.w, turn.i, turn.j, turn.k].map(|part| format!("{part:.7}")).join(",")
    });
    assert!(found.fault.is_none(), "{}", found.reason);
}
