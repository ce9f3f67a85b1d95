//! What a file cannot tell apart is said as a choice; what belongs to one cause is one.

use super::{anywhere_deg, diagnose, file, noise, verdict};
use nalgebra::Point3;
use robot_model::kinematics::Chain;
use robot_model::robot::Robot;
use serde_json::Value;

/// The diagnosis of 120 rows of 0.02 mm noise: `q_deg` of each row, and its hand (metres) by the joints (radians).
fn answer(
    q_deg: impl Fn(usize) -> [f64; 6],
    hand_m: impl Fn([f64; 6], usize) -> Point3<f64>,
    arguments: &[&str],
) -> (i32, String, Value) {
    let csv = file(120, |k| {
        let q_deg = q_deg(k);
        let hand_m = hand_m(q_deg.map(f64::to_radians), k);
        let measured_mm = |axis| 1000.0 * hand_m[axis] + 0.03 * noise(3 * k + axis);
        (q_deg, std::array::from_fn(measured_mm))
    });
    let (code, text, json) = diagnose(csv.as_bytes(), &[&["--sigma-mm", "0.018"], arguments].concat());
    assert!(json.is_some(), "{code} {text}");
    (code, text, json.unwrap())
}

fn chain() -> Chain {
    Chain::nominal(&Robot::built_in("irb140").unwrap())
}

/// The hand with joint `joint`, from 0, turned by `turn_rad` more.
fn turned(chain: &Chain, mut q_rad: [f64; 6], joint: usize, turn_rad: f64) -> Point3<f64> {
    q_rad[joint] += turn_rad;
    chain.forward(&q_rad) * Point3::new(0.04, 0.03, 0.09)
}

/// Periods per turn of the gear lines named, by slot.
fn periods(answer: &Value) -> Vec<(u64, u64)> {
    let causes = answer["causes"].as_array().unwrap().iter();
    causes
        .filter(|c| c["effect"] == "gear_mesh")
        .map(|c| (c["slot"].as_u64().unwrap(), c["n"].as_u64().unwrap()))
        .collect()
}

/// Joint 2 on a grid of 10 deg, 36 steps a turn: lines of 8, 36 - 8, 36 + 8 and 72 - 8 periods are the same numbers there. At any angles
/// the line is told, and makes a model.
#[test]
fn gear_lines_that_a_grid_of_angles_does_not_tell_apart_are_one_choice_and_no_model() {
    let chain = chain();
    let hand = |q_rad: [f64; 6], _| turned(&chain, q_rad, 1, 2e-4 * (44.0 * q_rad[1]).sin());
    let on_grid = |k| {
        let mut q_deg = anywhere_deg(k);
        q_deg[1] = 10.0 * (q_deg[1] / 10.0).round();
        q_deg
    };
    let folder = tempfile::tempdir().unwrap();
    let model = folder.path().join("model.toml");
    let wanted = ["--model-out", model.to_str().unwrap()];
    let (code, text, answer_on_grid) = answer(on_grid, hand, &wanted);
    assert_eq!((code, verdict(&Some(answer_on_grid.clone()))), (2, "ambiguous"), "{text}");
    let found = periods(&answer_on_grid);
    for n in [8, 28, 44, 64] {
        assert!(found.contains(&(1, n)), "{n}: {found:?}");
    }
    assert!(text.contains("joint 2 are the same numbers at the angles measured"), "{text}");
    assert!(!model.exists());
    let reason = answer_on_grid["next_step"]["reason"].as_str().unwrap();
    assert!(reason.contains("at angles of joint 2 between those measured"), "{reason}");
    let (code, text, anywhere) = answer(anywhere_deg, hand, &wanted);
    assert_eq!((code, verdict(&Some(anywhere.clone()))), (0, "explained"), "{text}");
    assert_eq!(periods(&anywhere), [(1, 44)]);
    assert!(model.exists());
}

/// Beside such a line the target slips by 0.5 mm: the model holds the slip and nothing of joint 2's gear.
#[test]
fn a_gear_line_that_may_be_any_of_several_does_not_cost_the_model_of_another_cause() {
    let chain = chain();
    let hand = |q_rad: [f64; 6], k| {
        let mut q_rad = q_rad;
        q_rad[1] += 7e-5 * (44.0 * q_rad[1]).sin();
        let slipped_m = if k < 60 { 0.0 } else { 5e-4 };
        chain.forward(&q_rad) * Point3::new(0.04 + 0.6 * slipped_m, 0.03, 0.09 - 0.8 * slipped_m)
    };
    let on_grid = |k| {
        let mut q_deg = anywhere_deg(k);
        q_deg[1] = 10.0 * (q_deg[1] / 10.0).round();
        q_deg
    };
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("model.toml");
    let (code, text, found) = answer(on_grid, hand, &["--model-out", path.to_str().unwrap()]);
    assert_eq!(code, 0, "{text}");
    assert!(text.contains("the model is fitted without the gear of joint 2"), "{text}");
    let codes: Vec<_> = found["warnings"].as_array().unwrap().iter().map(|w| w["code"].as_str()).collect();
    assert!(codes.contains(&Some("diagnose::aliased-line")), "{codes:?}");
    let model: toml::Table = std::fs::read_to_string(&path).unwrap().parse().unwrap();
    let effects: Vec<_> =
        model["effect"].as_array().unwrap().iter().map(|term| term["effect"].as_str().unwrap()).collect();
    assert!(effects.contains(&"tool_step") && !effects.contains(&"gear_mesh"), "{effects:?}");
}

/// A line of 8 periods a turn with a seventh of its size at 16 is one gear; as large as the line, it is another.
#[test]
fn a_gear_line_has_a_double_frequency_of_its_own() {
    let chain = chain();
    for (size_rad, causes) in [(6e-5, 1), (4e-4, 2)] {
        let hand = |q_rad: [f64; 6], _| {
            let line_rad = 4e-4 * (8.0 * q_rad[1]).sin() + size_rad * (16.0 * q_rad[1]).cos();
            turned(&chain, q_rad, 1, line_rad)
        };
        let (_, text, found) = answer(anywhere_deg, hand, &[]);
        assert_eq!(periods(&found).len(), causes, "{text} {found:#}");
        assert_eq!(found["verdict"], if causes == 1 { "explained" } else { "several" });
    }
}

/// From row 60 on the target stands 0.1 mrad further about joint 6's axis: slipped on the flange, or joint 6's zero jumped.
#[test]
fn a_slip_about_the_last_axis_is_a_step_of_the_target_or_of_the_joint() {
    let chain = chain();
    let hand = |q_rad, k| turned(&chain, q_rad, 5, if k < 60 { 0.0 } else { 3e-3 });
    let (_, text, found) = answer(anywhere_deg, hand, &[]);
    assert_eq!(found["verdict"], "ambiguous", "{text}");
    let causes = found["causes"].as_array().unwrap();
    let mut named: Vec<_> = causes.iter().map(|c| (c["effect"].as_str(), c["slot"].as_u64())).collect();
    named.sort_unstable();
    assert_eq!(named, [(Some("joint_step"), Some(1)), (Some("tool_step"), Some(1))]);
    assert_eq!(causes[0]["posterior"], causes[1]["posterior"]);
}

/// The last seven of 120 rows with the target 0.3 mm along its flange: a step, not seven false readings.
#[test]
fn a_target_that_slipped_near_the_end_is_a_step() {
    let chain = chain();
    let hand = |q_rad: [f64; 6], k| {
        let slipped_m = if k < 113 { 0.0 } else { 3e-4 };
        chain.forward(&q_rad) * Point3::new(0.04 + 0.6 * slipped_m, 0.03, 0.09 - 0.8 * slipped_m)
    };
    let (_, text, found) = answer(anywhere_deg, hand, &[]);
    assert_eq!(found["false_lines"], Value::Array(Vec::new()), "{text} {found:#}");
    let first = &found["causes"][0];
    assert_eq!((&first["effect"], &first["from_line"]), (&"tool_step".into(), &115.into()), "{found:#}");
}
