//! What the controller wrote of its touches, taken to `driftpost state`.

use super::refusals::as_the_table;
use super::{Cell, TABLE_TAU_MIN, Truth, job, run, search};
use assert_cmd::Command;
use rapid_compensation::compensate::FormChoice;
use robot_model::deform::GrowthLaw;
use serde_json::Value;

const LAW: GrowthLaw = GrowthLaw::TwoStage { tau_min: TABLE_TAU_MIN };

/// A cell whose program logs its touches.
fn logging(truth: &Truth) -> Cell {
    let mut job = job(FormChoice::Ramp, LAW, Some((search(), 0.01)));
    job.touch.as_mut().unwrap().log = true;
    Cell::of(&run(&job), truth)
}

/// The only file that was written, or the one that was not there before.
fn written(cell: &Cell, before: usize) -> (String, String) {
    let files = cell.controller.files();
    assert_eq!(files.len(), before + 1, "{:?}", files.keys());
    let (name, bytes) = files.iter().next_back().unwrap();
    (name.clone(), String::from_utf8(bytes.clone()).unwrap())
}

#[test]
fn first_the_controller_logs_then_state_finds_what_robot_it_is() {
    let truth = Truth {
        amount: 1.25,
        law: GrowthLaw::TwoStage { tau_min: 60.0 },
        tau_cool_min: 80.0,
        noise_mm: 0.01,
        seed: 3,
        ..as_the_table()
    };
    let mut cell = logging(&truth);
    cell.call("tcColdStart");
    cell.call("tcTouch");
    // 240 minutes of work, 60 of standing, 120 of work: a touch every ten minutes of work.
    for step in 0..36 {
        cell.pass_min(if step == 24 { 60.0 } else { 0.0 }, false);
        for _ in 0..4 {
            cell.pass_min(2.5, true);
            cell.call("tcUpdate");
        }
        cell.call("tcTouch");
    }
    let (name, text) = written(&cell, 0);
    assert!(name.starts_with("tcs1_") && name.ends_with(".csv"), "{name}");
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], "fixed_id,t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg");
    // 37 calls; a touch that surprises is made again at once.
    let mut minutes: Vec<&str> = lines[1..].iter().map(|line| line.split(',').nth(1).unwrap()).collect();
    minutes.dedup();
    let expected = (0..37).map(|call| 10 * call + if call > 24 { 60 } else { 0 });
    assert_eq!(minutes, expected.map(|minute| format!("{minute}.00")).collect::<Vec<_>>());
    assert!((38..60).contains(&lines.len()), "{text}");
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join(name);
    std::fs::write(&file, &text).unwrap();
    let args =
        ["state", &file.display().to_string(), "--stop", "240:300", "--sigma-mm", "0.01", "--json", "-"];
    let run = Command::cargo_bin("driftpost").unwrap().args(args).assert().success();
    let json: Value = serde_json::from_slice(&run.get_output().stdout).unwrap();
    for (key, sigma, expected, most) in [
        ("amount", "amount_sigma", 1.25, 0.15),
        ("tau_min", "tau_sigma_min", 60.0, 12.0),
        ("tau_cool_min", "tau_cool_sigma_min", 80.0, 35.0),
    ] {
        let [value, sigma] = [key, sigma].map(|key| json[key].as_f64().unwrap());
        println!("{key} {value:.3} +- {sigma:.3}, true {expected}");
        assert!((value - expected).abs() < 3.0 * sigma && sigma < most, "{key} {value} +- {sigma}");
    }
}

#[test]
fn a_log_that_cannot_be_written_stops_no_touch_and_a_cold_start_begins_a_new_one() {
    let mut cell = logging(&as_the_table());
    cell.call("tcColdStart");
    cell.controller.protect_disk(true);
    cell.call("tcTouch");
    assert_eq!(cell.touch_message(), "Touch taken");
    let shown: Vec<String> = cell.controller.take_messages().into_iter().map(|m| m.text).collect();
    assert!(shown.iter().any(|text| text.starts_with("Touch not logged: tcS1_")), "{shown:?}");
    assert!(shown.iter().all(|text| text.len() <= 80), "{shown:?}");
    cell.controller.protect_disk(false);
    cell.pass_min(3.0, true);
    cell.call("tcTouch");
    let (first, text) = written(&cell, 0);
    let lines: Vec<&str> = text.lines().collect();
    assert!(lines.len() == 2 && lines[0].starts_with("fixed_id,"), "{text}");
    // The minutes count from the first touch, logged or not.
    assert!(lines[1].starts_with("S1,3.00,"), "{text}");
    cell.pass_min(600.0, false);
    cell.call("tcColdStart");
    cell.call("tcTouch");
    let (second, text) = written(&cell, 1);
    assert!(first < second && text.lines().nth(1).unwrap().starts_with("S1,0.00,"), "{second}: {text}");
}

#[test]
fn where_no_log_is_asked_for_nothing_is_written() {
    let text = super::emitted(FormChoice::Ramp, LAW, Some((search(), 0.02)));
    assert!(!String::from_utf8_lossy(&text).contains("tcLog"));
    let mut cell = Cell::new(&text, &as_the_table());
    cell.call("tcColdStart");
    cell.call("tcTouch");
    assert!(cell.controller.files().is_empty());
}
