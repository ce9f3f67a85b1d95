//! What moves the target and is no error of the arm: a tool that gives, a load, a knock, an instrument. Files of somebody else's physics.

use assert_cmd::Command;
use serde_json::Value;
use std::path::Path;

/// What `diagnose` prints and warns of, and its JSON.
struct Answer {
    json: Value,
    text: String,
    warnings: String,
}

fn diagnose(name: &str, robot: &str, known: &[&str]) -> Answer {
    let folder = tempfile::tempdir().unwrap();
    let json = folder.path().join("answer.json");
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/measuring/outside_the_arm").join(name);
    let mut command = Command::cargo_bin("driftpost").unwrap();
    command.arg("diagnose").arg(file).args(["--robot", robot]).args(known).arg("--json").arg(&json);
    let output = command.output().unwrap();
    Answer {
        json: serde_json::from_slice(&std::fs::read(&json).unwrap()).unwrap(),
        text: String::from_utf8(output.stdout).unwrap(),
        warnings: String::from_utf8(output.stderr).unwrap(),
    }
}

const TOOL: [&str; 2] = ["--tool", "60,40,100"];

fn follows(name: &str, robot: &str, what: &str) {
    let answer = diagnose(name, robot, &TOOL);
    let reason = answer.json["reason"].as_str().unwrap();
    assert_eq!(answer.json["verdict"], "unexplained_structure", "{name}: {reason}");
    assert!(reason.contains(what), "{name}: {reason}");
}

/// The tip sags by 0.15 mm, and by 0.3 mm under the payload: the arm stands where its model says.
#[test]
fn a_tool_that_gives_is_no_joint_that_gives() {
    follows("tool_bends.csv", "irb140", "how gravity pulls along the flange's axes");
}

/// Target B alone is knocked by 0.3 mm before row 122, line 123 of the file.
#[test]
fn the_target_that_was_knocked_is_named_and_nothing_of_the_arm() {
    let answer = diagnose("one_of_three_knocked.csv", "irb140", &[]);
    let named = "from line 123 on target B sits 0.30 mm from where it sat before";
    assert!(
        answer.warnings.contains("measure::target-moved") && answer.warnings.contains(named),
        "{}",
        answer.warnings
    );
    assert_eq!(answer.json["verdict"], "geometry", "{}", answer.text);
    assert!(!answer.text.contains("Set aside as false readings"), "{}", answer.text);
}

/// Joint 4 plays by 0.04 mm at the tool, in a gap of 2.5 mm that is geometry.
#[test]
fn what_takes_little_of_the_gap_does_not_stand_for_all_of_it() {
    let answer = diagnose("geometry_and_play.csv", "irb2600", &TOOL);
    let mut lines = answer.text.lines();
    let first = lines.next().unwrap();
    assert!(
        first.starts_with("Mostly geometry:") && first.contains("nearly all of the gap's square"),
        "{first}"
    );
    assert!(lines.next().unwrap().starts_with("Explained: backlash of joint 4"), "{}", answer.text);
}

/// 0.06 m is 60 mm, and no place 0.12 mm from the flange.
#[test]
fn a_tool_in_other_units_than_millimetres_is_refused() {
    for tool in ["0.06,0.04,0.1", "60000,40000,100000"] {
        let mut plan = Command::cargo_bin("driftpost").unwrap();
        let output = plan.args(["plan", "--robot", "irb140", "--tool", tool]).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(
            message.contains("diagnose::tool") && message.contains("the numbers are millimetres"),
            "{message}"
        );
    }
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    /// The tool rocks at the flange by 1 mrad under the payload.
    #[test]
    #[ignore = "long"]
    fn a_tool_that_rocks_is_no_wrong_payload() {
        follows("tool_rocks.csv", "irb140", "how gravity pulls along the flange's axes");
    }

    #[test]
    #[ignore = "long"]
    fn a_target_that_sits_elsewhere_under_load_is_no_payload() {
        follows(
            "target_under_load.csv",
            "irb140",
            "the payload: the target sits elsewhere on the flange under load",
        );
    }

    #[test]
    #[ignore = "long"]
    fn zeros_that_shift_under_load_are_no_gear_lines() {
        follows("zeros_under_load.csv", "irb6700", "the payload: joints stand elsewhere under load");
    }

    /// 150 ppm over the measurement.
    #[test]
    #[ignore = "long"]
    fn a_scale_that_wanders_is_no_growth() {
        follows(
            "scale_wanders.csv",
            "irb140",
            "the distance from the instrument, over time: its scale wanders",
        );
    }
}
