//! `driftpost simulate` on the command line: what it writes and how it ends.

#![allow(clippy::unwrap_used, reason = "a test stops where something is missing")]

use assert_cmd::Command;
use serde_json::Value;
use std::path::Path;

const CUBE: &str = "fixtures/robodk/irc5/Cube45.mod";

fn driftpost(args: &[&str]) -> Command {
    let mut command = Command::cargo_bin("driftpost").unwrap();
    command.current_dir(env!("CARGO_MANIFEST_DIR")).args(args);
    command
}

fn compensated(folder: &Path) -> String {
    let out = folder.join("Cube45_tc.mod").display().to_string();
    driftpost(&["compensate", CUBE, "-o", &out, "--diff", "none"]).assert().success();
    out
}

#[test]
fn a_compensated_cube_is_within_and_its_original_is_not() {
    let folder = tempfile::tempdir().unwrap();
    let program = compensated(folder.path());
    let csv = folder.path().join("passes.csv").display().to_string();
    let run = driftpost(&[
        "simulate",
        &program,
        "--original",
        CUBE,
        "--minutes",
        "0,7,37.5,180",
        "--json",
        "-",
        "--csv",
        &csv,
    ])
    .assert()
    .success();
    let json: Value = serde_json::from_slice(&run.get_output().stdout).unwrap();
    let minutes = json["minutes"].as_array().unwrap();
    assert_eq!(
        minutes.iter().map(|m| m["t_min"].as_f64().unwrap()).collect::<Vec<_>>(),
        [0.0, 7.0, 37.5, 180.0]
    );
    assert!(minutes.iter().all(|m| m["n"] == 46));
    assert!(minutes[3]["after"]["max_mm"].as_f64().unwrap() < 0.0055);
    // The reference paper's table leaves 0.174 mm at 180 minutes.
    assert!((minutes[3]["before"]["max_mm"].as_f64().unwrap() - 0.174).abs() < 0.0005);
    assert!(minutes[3]["path_after_mm"].as_f64().unwrap() < 0.01);
    // Minutes 0 and 7 lie in one bucket.
    assert_eq!(json["switches"].as_array().unwrap().len(), 2);
    assert_eq!(json["unknown_instructions"].as_array().unwrap().len(), 0);
    assert_eq!(std::fs::read_to_string(csv).unwrap().lines().count(), 5);
    // Not compensated: out of tolerance.
    driftpost(&["simulate", CUBE, "--minutes", "180"]).assert().code(1);
}

#[test]
fn a_scenario_is_played() {
    let folder = tempfile::tempdir().unwrap();
    let program = compensated(folder.path());
    let file = folder.path().join("lunch.toml");
    std::fs::write(
        &file,
        "steps = [\"call tcColdStart\", \"run 20\", \"stand 45\", \"pp_to_main\", \"run 5\"]",
    )
    .unwrap();
    let scenario = file.display().to_string();
    let args =
        ["simulate", &program, "--original", CUBE, "--scenario", &scenario, "--tolerance-mm", "0.0065"];
    driftpost(&args).assert().success();
    std::fs::write(&file, "steps = [\"sleep 5\"]").unwrap();
    driftpost(&args).assert().code(2);
}

#[test]
fn what_cannot_be_run_is_refused() {
    for args in [
        &["simulate", "nowhere.mod"][..],
        &["simulate", CUBE, "--entry", "Nobody"],
        &["simulate", CUBE, "--tolerance-mm", "0"],
        &["simulate", CUBE, "--robot", "irb9"],
        &["simulate", CUBE, "--minutes", "-1"],
    ] {
        driftpost(args).assert().code(2);
    }
}
