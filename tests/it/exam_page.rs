//! docs/EXAM.md says what the exam says: both seeds of the page, made and scored anew.

use assert_cmd::Command;
use serde_json::Value;
use std::path::Path;

/// Beginning of a row of the page's table, and of the measure in the exam's JSON.
const ROWS: [(&str, &str); 18] = [
    ("first answer right", "first answer right, rho >= 1"),
    ("*weak*: first answer right", "first answer right, rho = .5"),
    ("*weak*: one of the first two", "one of the first two right"),
    ("false alarms", "false alarms"),
    ("confident and wrong, overall", "confident and wrong, overall"),
    ("confident and wrong, channel", "confident and wrong, missing"),
    ("ambiguity set holds", "ambiguity set holds"),
    ("its mean size", "mean size"),
    ("outside the library: recall", "outside the library: recall"),
    ("outside the library: precision", "outside the library: precision"),
    ("two effects", "two effects"),
    ("spurious cause", "spurious cause"),
    ("faults of the file", "faults of the file"),
    ("shrink against an oracle: median", "shrink against the oracle: median"),
    ("shrink against an oracle: worst", "shrink against the oracle: worst"),
    ("90 % interval of the shrink", "90 % interval of the shrink"),
    ("calibration error", "calibration error"),
    ("right joint", "right joint"),
];

/// The measures of a folder of sets made with the options of the page.
fn measures(options: &[&str]) -> Vec<Value> {
    let folder = tempfile::tempdir().unwrap();
    let (sets, json) = (folder.path().join("sets"), folder.path().join("exam.json"));
    let driftpost = || Command::cargo_bin("driftpost").unwrap();
    driftpost().arg("synth").arg(&sets).args(options).assert().success();
    driftpost().arg("exam").arg(&sets).arg("--json").arg(&json).assert().success();
    let answer: Value = serde_json::from_slice(&std::fs::read(json).unwrap()).unwrap();
    answer["measures"].as_array().unwrap().clone()
}

#[test]
#[ignore = "twenty minutes optimised: cargo test --release --test it exam_page:: -- --ignored"]
fn the_page_says_what_the_exam_says() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/EXAM.md");
    let page = std::fs::read_to_string(page).unwrap();
    let all = measures(&["--sets", "600", "--seed", "9101"]);
    let weak = measures(&["--effects", "weak", "--sets", "150", "--seed", "9102"]);
    let mut wrong = Vec::new();
    for (row, name) in ROWS {
        let line = page.lines().find(|l| l.starts_with(&format!("| {row}"))).expect(row);
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let measures = if row.starts_with("*weak*") { &weak } else { &all };
        let measure = measures.iter().find(|m| m["name"].as_str().unwrap().starts_with(name)).expect(name);
        let (value, sets) = (measure["value"].as_f64().unwrap(), measure["sets"].as_u64().unwrap());
        let digits = cells[3].split('.').nth(1).map_or(0, str::len);
        let shown = format!("{value:.digits$}");
        println!("{row}: {shown} of {sets}, the page {} of {}", cells[3], cells[5]);
        if shown.trim_start_matches('0') != cells[3].trim_start_matches('0') || sets.to_string() != cells[5] {
            wrong.push(format!("{row}: {shown} of {sets}, the page says {} of {}", cells[3], cells[5]));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
