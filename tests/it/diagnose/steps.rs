//! What moves at one moment, in files that have no points: touches of fixed points and lengths of wires.

use super::{diagnose, verdict};
use crate::recipe::rows_each_minute;
use exam::rng::Rng;
use nalgebra::{Matrix3x6, Point3, Vector3};
use robot_model::kinematics::Chain;
use robot_model::robot::Robot;
use serde_json::Value;
use std::fmt::Write as _;

const JOINTS: &str = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg";

/// Cause, line from which on it is and size of the only cause of `json`.
fn only_cause(json: &Value) -> (&str, u64, f64) {
    let causes = json["causes"].as_array().unwrap();
    assert_eq!(causes.len(), 1, "{causes:?}");
    let cause = &causes[0];
    (cause["effect"].as_str().unwrap(), cause["from_line"].as_u64().unwrap(), cause["size"].as_f64().unwrap())
}

/// Points as [`rows_each_minute`] has them, as lengths of three wires in turn, the base moved by `step_mm` from row 40 on.
fn wires(rows: usize, step_mm: Vector3<f64>) -> String {
    let points = rows_each_minute(rows, [0.08, 0.03, 0.1], 0.02, 11, |_| [0.0; 6]);
    let anchors_mm = [[1500.0, 300.0, -800.0], [-900.0, 1200.0, 500.0], [200.0, -1500.0, 900.0]];
    let mut csv = format!("t_min,{JOINTS},length_mm,fixed_id\n");
    for (row, line) in points.lines().skip(1).enumerate() {
        let cells: Vec<&str> = line.split(',').collect();
        let mut point_mm = Vector3::from_fn(|k, _| cells[7 + k].parse::<f64>().unwrap());
        if row >= 40 {
            point_mm += step_mm;
        }
        let length_mm = (point_mm - Vector3::from(anchors_mm[row % 3])).norm();
        writeln!(csv, "{},{length_mm:.4},W{}", cells[..7].join(","), row % 3).unwrap();
    }
    csv
}

/// By hand: row 40 stands in line 42.
#[test]
fn a_base_that_was_moved_shows_in_lengths() {
    let step_mm = Vector3::new(0.3, -0.2, 0.25);
    let (code, answer, json) = diagnose(wires(90, step_mm).as_bytes(), &["--sigma-mm", "0.02"]);
    assert_eq!((code, verdict(&json)), (0, "explained"), "{answer}");
    let json = json.unwrap();
    let (effect, line, size_mm) = only_cause(&json);
    assert_eq!((effect, line), ("base_step", 42), "{json:#}");
    assert!((size_mm - step_mm.norm()).abs() < 0.1, "{size_mm}");
    // Twelve lengths before a step and twelve after it: 23 have no room for one.
    let (_, _, json) = diagnose(wires(23, Vector3::zeros()).as_bytes(), &["--sigma-mm", "0.02"]);
    let json = json.unwrap();
    let untestable: Vec<&str> =
        json["untestable"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
    for step in ["base_step", "tool_step", "joint_step"] {
        assert!(untestable.contains(&step), "{untestable:?}");
    }
}

/// Three points are touched in turn, each with the arm otherwise; the tip is moved by `step_m` on the flange from row 45 on.
fn touches(rows: usize, step_m: Vector3<f64>) -> String {
    let robot = Robot::built_in("irb140").unwrap();
    let (chain, mut rng) = (Chain::nominal(&robot), Rng::new(7, 0));
    let seats_deg = [
        [-40.0, 20.0, -10.0, 15.0, 40.0, 0.0],
        [35.0, 35.0, -30.0, -20.0, 55.0, 30.0],
        [5.0, 5.0, 15.0, 60.0, -45.0, -50.0],
    ];
    let tip_m = Vector3::new(0.03, 0.02, 0.1);
    let point = |q_rad: &[f64; 6], tip_m: Vector3<f64>| chain.forward(q_rad) * Point3::from(tip_m);
    let mut csv = format!("t_min,{JOINTS},fixed_id\n");
    for row in 0..rows {
        let seat_rad = seats_deg[row % 3].map(f64::to_radians);
        let goal = point(&seat_rad, tip_m) + 2e-5 * Vector3::from(rng.normal3());
        let tip_m = if row >= 45 { tip_m + step_m } else { tip_m };
        let mut q_rad = seat_rad.map(|q| q + rng.uniform(-0.4, 0.4));
        for _ in 0..20 {
            let here = point(&q_rad, tip_m);
            let jacobian = Matrix3x6::from_fn(|k, joint| {
                let mut q_rad = q_rad;
                q_rad[joint] += 1e-6;
                1e6 * (point(&q_rad, tip_m) - here)[k]
            });
            let turn = jacobian.pseudo_inverse(1e-9).unwrap() * (goal - here);
            q_rad.iter_mut().zip(turn.iter()).for_each(|(q, turn)| *q += turn);
        }
        assert!((point(&q_rad, tip_m) - goal).norm() < 1e-8);
        let joints = q_rad.map(|q| format!("{:.6}", q.to_degrees())).join(",");
        writeln!(csv, "{row},{joints},S{}", row % 3).unwrap();
    }
    csv
}

/// By hand: row 45 stands in line 47.
#[test]
fn a_tip_that_was_moved_shows_in_touches() {
    let step_m = Vector3::new(2e-4, -1e-4, 2e-4);
    let (code, answer, json) = diagnose(touches(90, step_m).as_bytes(), &["--sigma-mm", "0.02"]);
    assert_eq!((code, verdict(&json)), (0, "explained"), "{answer}");
    let json = json.unwrap();
    let (effect, line, size_mm) = only_cause(&json);
    assert_eq!((effect, line), ("tool_step", 47), "{json:#}");
    assert!((size_mm - 0.3).abs() < 0.05, "{size_mm}");
}

/// Two sessions of 30 rows, each with minutes since its own cold start; joint 2 stands 0.3 mrad further in the second. With minutes that
/// were never set back the same, from line 32 on.
#[test]
fn what_was_moved_between_two_cold_starts_shows() {
    let further = |t_min: f64| if t_min < 30.0 { [0.0; 6] } else { [0.0, 3e-4, 0.0, 0.0, 0.0, 0.0] };
    let one = rows_each_minute(60, [0.08, 0.03, 0.1], 0.02, 3, further);
    let mut two = String::new();
    for line in one.lines() {
        match line.split_once(',').map(|(t_min, rest)| (t_min.parse::<u32>(), rest)) {
            Some((Ok(t_min), rest)) => writeln!(two, "{},{rest}", t_min % 30).unwrap(),
            _ => writeln!(two, "{line}").unwrap(),
        }
    }
    for (csv, sessions) in [(one, false), (two, true)] {
        let (code, answer, json) = diagnose(csv.as_bytes(), &["--sigma-mm", "0.02"]);
        assert_eq!((code, verdict(&json)), (0, "explained"), "{answer}");
        assert_eq!(answer.contains("warning[measure::cold-starts]"), sessions, "{answer}");
        let json = json.unwrap();
        let (effect, line, size_rad) = only_cause(&json);
        assert_eq!((effect, line), ("joint_step", 32), "{json:#}");
        assert!((size_rad - 3e-4).abs() < 5e-5, "{size_rad}");
        assert_eq!(json["causes"][0]["t0_min"].is_null(), sessions);
    }
}
