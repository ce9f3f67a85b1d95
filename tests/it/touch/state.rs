//! `driftpost state`: the filter off line, on touches of a robot made by another physics (`exam::touch`).

use assert_cmd::Command;
use exam::rng::Rng;
use exam::touch::{TouchRecipe, touches};
use robot_model::robot::Robot;
use serde_json::Value;

/// The paper's Table 2 as the exam takes it, times an amount.
fn table(amount: f64) -> [[f64; 6]; 7] {
    driftpost::Deformation::paper().settled().0.map(|row| row.map(|x| x * amount))
}

fn state(file: &str, stop: &str) -> (Value, String) {
    let args =
        ["state", file, "--tool", "0,0,100", "--stop", stop, "--sigma-mm", "0.01", "--plan", "--json", "-"];
    let run = Command::cargo_bin("driftpost").unwrap().args(args).assert().success();
    let output = run.get_output();
    (serde_json::from_slice(&output.stdout).unwrap(), String::from_utf8_lossy(&output.stderr).into_owned())
}

#[test]
fn amount_and_time_constants_of_a_robot_are_found_within_what_is_stated() {
    let robot = Robot::built_in("irb140").unwrap();
    let recipe = TouchRecipe {
        points: 2,
        times: 49,
        every_min: 10.0,
        stop_min: [240.0, 300.0],
        sigma_mm: 0.01,
        tau_min: [60.0, 80.0],
        two_stage: true,
        table: table(1.25),
        within_m: [[0.4, -0.3, 0.25], [0.7, 0.3, 0.55]],
        tool_m: [0.0, 0.0, 0.1],
    };
    let text = touches(&robot, &recipe, &mut Rng::new(7, 1)).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("touches.csv");
    std::fs::write(&file, text).unwrap();
    let (json, told) = state(&file.display().to_string(), "240:300");
    let number = |key: &str| json[key].as_f64().unwrap();
    for (key, sigma, truth, most) in [
        ("amount", "amount_sigma", 1.25, 0.1),
        ("tau_min", "tau_sigma_min", 60.0, 9.0),
        ("tau_cool_min", "tau_cool_sigma_min", 80.0, 30.0),
    ] {
        let (value, sigma) = (number(key), number(sigma));
        assert!((value - truth).abs() < 3.0 * sigma && sigma < most, "{key} {value} +- {sigma}");
    }
    let rows = json["touches"].as_array().unwrap();
    let mean = |key: &str| rows.iter().map(|row| row[key].as_f64().unwrap()).sum::<f64>() / rows.len() as f64;
    assert!(mean("smoothed_sigma") < 0.9 * mean("sigma"));
    assert!(rows.iter().filter(|row| row["taken"] == false).count() <= 3, "{told}");
    let plan = json["plan"].as_array().unwrap();
    let settled = |k: usize| plan[k]["settled_mm"].as_f64().unwrap();
    assert!(plan.len() == 2 && settled(0) >= settled(1) && told.contains("tells most"));
    let left: Vec<f64> =
        plan[0]["intervals"].as_array().unwrap().iter().map(|i| i["rms_mm"].as_f64().unwrap()).collect();
    assert!(left.is_sorted(), "touching less often leaves more: {left:?}");
}
