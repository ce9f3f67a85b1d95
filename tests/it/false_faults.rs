//! Files that look like faulty ones and are sound.

use super::nominal_cell::{NominalCell, even};
use measurements::FaultKind;
use metrology::diagnose::Verdict;
use nalgebra::{UnitQuaternion, Vector3};
use robot_model::robot::Axis;

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

/// Two postures, from each of which one joint moves at a time, in tenths of a degree.
fn swept_deg() -> Vec<[f64; 6]> {
    let postures_deg = [[-11.6, -1.6, -26.6, 72.2, 40.3, 0.3], [10.1, 20.4, -36.0, -89.3, -43.6, -19.3]];
    let widest_deg = [70.0, 30.0, 25.0, 80.0, 40.0, 110.0];
    let row = |k: usize| {
        let mut q_deg = postures_deg[k % 2];
        let joint = k / 2 % 6;
        q_deg[joint] = (10.0 * (q_deg[joint] + widest_deg[joint] * even(k, 29.0))).round() / 10.0;
        q_deg
    };
    (0..144).map(row).collect()
}

/// The same sweeps of joints that were commanded to tenths of a degree and stand there, with a gear whose line is as large.
#[test]
fn sweeps_commanded_in_round_steps_are_not_rounded() {
    let geared = |mut q_deg: [f64; 6]| {
        q_deg[1] += 0.04 * (20.0 * q_deg[1].to_radians()).sin();
        q_deg
    };
    let found = NominalCell::at(swept_deg(), geared).answer("id", |k| k.to_string());
    assert_eq!(found.fault, None, "{}", found.reason);
    assert_eq!((found.causes[0].effect.name(), found.causes[0].joint), ("gear_mesh", Axis::numbered(2)));
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

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    /// The joints truly stand anywhere within half of the last decimal, at the same angle each time in the postures.
    #[test]
    #[ignore = "long"]
    fn joints_rounded_in_sweeps_are_no_gears() {
        let rounded = |q_deg: [f64; 6]| {
            q_deg.map(|q_deg| q_deg + 0.1 * (((1e4 + 1e3 * q_deg).sin() * 43_758.547).rem_euclid(1.0) - 0.5))
        };
        let found = NominalCell::at(swept_deg(), rounded).answer("id", |k| k.to_string());
        let fault = found.fault.unwrap_or_else(|| panic!("{}", found.reason));
        assert_eq!(fault.kind, FaultKind::RoundedJoints, "{}", found.reason);
    }
}
