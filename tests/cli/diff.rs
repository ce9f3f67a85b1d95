//! `diff`: what a reviewer is told of two programs.

use crate::{Bench, CUBE, driftpost, out};
use serde_json::Value;

fn compensated(bench: &Bench) -> String {
    let to = bench.path("tc.mod").display().to_string();
    assert!(driftpost(&["compensate", CUBE, "-o", &to, "--diff", "none"]).status.success());
    to
}

/// Numbers of the first bracketed triple of a line.
fn position(line: &str) -> [f64; 3] {
    let inner = line.trim_start_matches(|c| c != '[').trim_start_matches('[').split(']').next().unwrap();
    let numbers: Vec<f64> = inner.split(',').map(|n| n.trim().parse().unwrap()).collect();
    numbers.try_into().unwrap()
}

#[test]
fn a_compensated_program_differs_in_its_targets_alone() {
    let bench = Bench::default();
    let to = compensated(&bench);
    let output = driftpost(&["diff", CUBE, &to, "--json", "-"]);
    assert_eq!(output.status.code(), Some(1));
    let json: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&json["same"], &json["same_elsewhere"]), (&Value::Bool(false), &Value::Bool(true)));
    let motions = json["motions"].as_array().unwrap();
    assert_eq!(motions.len(), 46);
    // The distance of the second motion's last element from its first, by the text of the array.
    let text = bench.text("tc.mod");
    let mut rows = text.lines().skip_while(|l| !l.contains("robtarget tc31{"));
    let rows: Vec<[f64; 3]> = rows.by_ref().skip(1).take_while(|l| l.contains("[[")).map(position).collect();
    let (first, last) = (rows[0], rows[rows.len() - 1]);
    let far = first.iter().zip(&last).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    let buckets = motions[1]["buckets"].as_array().unwrap();
    assert_eq!(buckets.len(), rows.len());
    assert_eq!((&buckets[0]["index"], &buckets[0]["dp_mm"]), (&Value::Null, &Value::from(0.0)));
    let told = buckets[buckets.len() - 1]["dp_mm"].as_f64().unwrap();
    assert!(far > 0.1 && (told - far).abs() < 2e-5, "{told} {far}");
    for bucket in motions.iter().flat_map(|m| m["buckets"].as_array().unwrap()) {
        assert_eq!(
            (&bucket["same_branch"], &bucket["same_configuration"]),
            (&Value::Bool(true), &Value::Bool(true))
        );
        assert!(bucket["limit_margin_deg"].as_f64().unwrap() > 2.0);
    }
}

#[test]
fn the_same_program_has_no_difference() {
    let bench = Bench::default();
    let to = compensated(&bench);
    for path in [CUBE, &to] {
        assert_eq!(driftpost(&["diff", path, path]).status.code(), Some(0), "{path}");
    }
}

#[test]
fn a_changed_speed_tool_or_move_is_told() {
    let bench = Bench::default();
    let to = compensated(&bench);
    let text = std::fs::read_to_string(&to).unwrap();
    let told = |from: &str, by: &str| {
        let changed = text.replacen(from, by, 1);
        assert_ne!(changed, text, "{from}");
        let output = driftpost(&["diff", CUBE, &bench.file("changed.mod", changed)]);
        assert_eq!(output.status.code(), Some(1));
        out(&output)
    };
    let speed = told("tc40{tcI},rdkSpeed,z1", "tc40{tcI},rdkSpeed,z5");
    assert!(
        speed.contains("Beside the targets the text differs, first at fixtures/robodk/irc5/Cube45.mod:40"),
        "{speed}"
    );
    let tool = told("tc40{tcI},rdkSpeed,z1,rdkTool", "tc40{tcI},rdkSpeed,z1,tool0");
    assert!(tool.contains("1 with another instruction, tool or work object"), "{tool}");
    let dropped = told("        MoveL tc40{tcI}", "        ! MoveL tc40{tcI}");
    assert!(dropped.contains("Only in the first program"), "{dropped}");
}
