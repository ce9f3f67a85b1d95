//! Campaigns over a day or two, measured on virtual arms by another hand: what grows with the load, sways, or happens overnight.

use assert_cmd::Command;
use serde_json::Value;

fn diagnose(file: &str, robot: &str, sigma_mm: &str) -> Value {
    let file = format!("{}/fixtures/measuring/campaigns/{file}", env!("CARGO_MANIFEST_DIR"));
    let arguments = ["diagnose", &file, "--robot", robot, "--sigma-mm", sigma_mm, "--json", "-"];
    let output = Command::cargo_bin("driftpost").unwrap().args(arguments).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// Drift over the night, or a step in it: from sixty rows of which none was measured then nothing can tell.
#[test]
fn what_happens_overnight_is_a_step_or_a_drift() {
    let found = diagnose("step_overnight.csv", "irb140", "0.04");
    assert_eq!(found["verdict"], "ambiguous", "{}", found["reason"]);
    let posterior = |effect: &str| {
        let causes = found["causes"].as_array().unwrap();
        let of = causes.iter().find(|cause| cause["effect"] == effect && cause["joint"] == 2);
        of.map_or(0.0, |cause| cause["posterior"].as_f64().unwrap())
    };
    let (step, drift) = (posterior("joint_step"), posterior("thermal_joint_drift"));
    assert!(step > 0.1 && drift > 0.1 && step + drift > 0.9, "{step} {drift}");
}

/// Friction grows with the load, play does not.
#[test]
fn friction_is_no_play() {
    let found = diagnose("friction.csv", "irb2600", "0.05");
    assert_eq!(found["verdict"], "unexplained_structure", "{}", found["reason"]);
    assert_eq!(found["where"]["joint"], 2);
    assert!(found["reason"].as_str().unwrap().contains("gravity's torque"), "{}", found["reason"]);
    // Orientation says little of it, and halves what a sigma over all six numbers says.
    let found = diagnose("friction_with_orientation.csv", "irb6700", "0.04");
    assert_eq!(found["verdict"], "unexplained_structure", "{}", found["reason"]);
    assert!(found["reason"].as_str().unwrap().contains("gravity's torque"), "{}", found["reason"]);
    let found = diagnose("play.csv", "irb140", "0.05");
    assert_eq!(found["verdict"], "explained", "{}", found["reason"]);
    let first = &found["causes"][0];
    assert_eq!((&first["effect"], &first["joint"]), (&"backlash".into(), &2.into()));
}

/// Errors of the geometry take most of the gap; the sway is on top of the noise that is stated.
#[test]
fn what_sways_is_structure_beside_geometry() {
    let found = diagnose("sway.csv", "irb2600", "0.03");
    assert_eq!(found["verdict"], "unexplained_structure", "{}", found["reason"]);
    assert_eq!(found["where"]["time"], "drift", "{}", found["where"]);
}
