//! The pages of results without pictures: what the terminal says stands on them, in sentences and in tables.

use super::{Browser, looks_right, path};
use serde_json::{Value, json};
use std::path::Path;
use std::process::Command;

const CUBE: &str = "fixtures/robodk/irc5/Cube45.mod";

/// What a command prints.
fn printed(arguments: &[&str], code: i32) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let output =
        Command::new(env!("CARGO_BIN_EXE_driftpost")).args(arguments).current_dir(root).output().unwrap();
    let messages = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{arguments:?}\n{messages}");
    String::from_utf8(output.stdout).unwrap()
}

fn in_one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Opens the page of a result's JSON, with all that is folded on it opened too.
fn opened(browser: &mut Browser, folder: &tempfile::TempDir, name: &str, data: &Value) {
    let ((file, file_name), (page, page_name)) =
        (path(folder, &format!("{name}.json")), path(folder, &format!("{name}.html")));
    std::fs::write(file, data.to_string()).unwrap();
    printed(&["report", &file_name, "-o", &page_name], 0);
    browser.open(&page, 1440, "light");
    browser.eval("document.querySelectorAll('details').forEach((one) => { one.open = true; })");
    browser.settle();
}

/// The rows of a table as far as they are shown, cell by cell.
fn rows(browser: &mut Browser, name: &str) -> Vec<Vec<String>> {
    let script = format!(
        "[...document.querySelectorAll('[data-name=\"{name}\"] tbody tr')].map((tr) => [...tr.children].map((td) => td.textContent))"
    );
    serde_json::from_value(browser.eval(&script)).unwrap()
}

fn headings(browser: &mut Browser, name: &str) -> Vec<String> {
    let script =
        format!("[...document.querySelectorAll('[data-name=\"{name}\"] th')].map((th) => th.textContent)");
    serde_json::from_value(browser.eval(&script)).unwrap()
}

/// Every sentence of the JSON is one of the terminal's and stands on the page; the page has a verdict.
fn sentences_are_the_terminals(browser: &mut Browser, text: &str, data: &Value) {
    let (text, page) = (in_one_line(text), in_one_line(&browser.text("#overview")));
    let notes: Vec<&str> = data["notes"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
    assert!(!notes.is_empty(), "{data}");
    for note in notes {
        // how many pairs there are is counted on the terminal by its list
        assert!(text.contains(note) || note.contains("stay confounded"), "{note} is not in {text}");
        assert!(page.contains(note), "{note} is not on the page: {page}");
    }
    assert!(browser.text(".verdict").len() > 5);
}

#[test]
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn what_the_terminal_says_stands_on_the_page() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let (_, made) = path(&folder, "cube_tc.mod");
    printed(&["compensate", CUBE, "-o", &made, "--diff", "none"], 0);
    let model = "fixtures/docs/identified.toml";
    let measured = ["--tool", "0,0,80", "--limit-ap-mm", "0.001"];
    let commands: [(&[&str], i32); 8] = [
        (&["state", "fixtures/docs/touches.csv", "--tool", "0,0,100", "--stop", "120:165", "--plan"], 0),
        (&["plan", "--robot", "irb140", "--n", "60"], 0),
        (&["validate", "fixtures/docs/other.csv", "--robot", "irb140", "--model", model], 0),
        (&["tabulate", "fixtures/paper/targets45.csv"], 0),
        (&["inspect", CUBE], 0),
        (&["diff", CUBE, &made], 0),
        (&[&["accuracy", "fixtures/docs/measured.csv"], &measured[..]].concat(), 1),
        (
            &[
                "compare-measurements",
                "fixtures/docs/before.csv",
                "fixtures/docs/after.csv",
                "--tool",
                "0,0,80",
            ],
            1,
        ),
    ];
    for (command, code) in commands {
        let (file, file_name) = path(&folder, "result.json");
        let text = printed(&[command, &["--json", &file_name]].concat(), code);
        let data: Value = serde_json::from_slice(&std::fs::read(file).unwrap()).unwrap();
        let (page, page_name) = path(&folder, "result.html");
        printed(&["report", &file_name, "-o", &page_name], 0);
        looks_right(&mut browser, &page);
        opened(&mut browser, &folder, "opened", &data);
        sentences_are_the_terminals(&mut browser, &text, &data);
        match command[0] {
            "state" => how_often_is_told(&mut browser, &text),
            "plan" => a_plan_is_whole(&mut browser, &text, &data),
            "diff" => every_bucket_is_there(&mut browser, &text, &data),
            "accuracy" => assert!(headings(&mut browser, "poses").iter().any(|one| one == "AP x (mm)")),
            _ => {}
        }
        assert_eq!(browser.complaints(), [""; 0], "{command:?}");
    }
}

/// Each point's numbers, as the terminal has them: `P3 moves 0.185 mm; 10: 0.0094, 15: 0.0108`.
fn how_often_is_told(browser: &mut Browser, text: &str) {
    let lines: Vec<&str> = text.lines().filter(|line| line.contains(" moves ")).collect();
    let table = rows(browser, "plan");
    assert_eq!((table.len(), lines.len()), (5, 5));
    for (row, line) in table.iter().zip(lines) {
        let (_, intervals) = line.split_once(';').unwrap();
        let on_terminal: Vec<&str> =
            intervals.split(',').filter_map(|one| Some(one.split_once(": ")?.1.trim())).collect();
        assert!(line.trim().starts_with(&row[0]) && on_terminal == row[2..], "{row:?} beside {line}");
    }
    assert_eq!(headings(browser, "plan")[2], "left, every 10 min (mm)");
    assert_eq!(rows(browser, "false_first")[0][..2], ["5", "P4"]);
}

/// Effects as on the terminal, and whole what the terminal cuts: joints, lines of gears, pairs.
fn a_plan_is_whole(browser: &mut Browser, text: &str, data: &Value) {
    let begin = text.lines().skip_while(|line| !line.starts_with("  effect ")).skip(1);
    let effects: Vec<String> = begin
        .take_while(|line| !line.contains("usual:"))
        .map(|line| line.split_whitespace().next().unwrap().replace('_', " "))
        .collect();
    let shown: Vec<String> = rows(browser, "expected").iter().map(|row| row[0].clone()).collect();
    assert_eq!(shown, effects);
    let status = |browser: &mut Browser, name: &str| browser.text(&format!("[data-name={name}] .status"));
    let all = data["parameters"].as_array().unwrap().len();
    assert!(status(browser, "parameters").starts_with(&format!("{all} rows")));
    let pairs = data["confounded"].as_array().unwrap();
    let open = pairs.iter().filter(|pair| pair["contained"] == false).count();
    assert!(status(browser, "confounded").starts_with(&format!("{open} rows")));
    assert!(status(browser, "contained").starts_with(&format!("{} rows", pairs.len() - open)));
    let gears = rows(browser, "lines");
    let of_others: usize = data["lines"]
        .as_array()
        .unwrap()
        .iter()
        .map(|gear| gear["confounded"].as_array().unwrap().len())
        .sum();
    assert_eq!((gears.len(), gears[0][4].as_str()), (6, "318 of 318"));
    assert!(status(browser, "lines-confounded").starts_with(&format!("{of_others} rows")));
}

/// A row for each motion with its worst bucket, as on the terminal, and beneath it every bucket.
fn every_bucket_is_there(browser: &mut Browser, text: &str, data: &Value) {
    let row = &rows(browser, "motions")[1];
    let line = text.lines().find(|line| line.starts_with(&format!("{:<6}", row[0]))).unwrap();
    let on_terminal: Vec<&str> = line.split_whitespace().collect();
    assert_eq!(row[..6], on_terminal[..6], "{row:?} beside {line}");
    let all: usize =
        data["motions"].as_array().unwrap().iter().map(|m| m["buckets"].as_array().unwrap().len()).sum();
    let all = format!("{},{:03} rows", all / 1000, all % 1000);
    assert!(browser.text("[data-name=buckets] .status").starts_with(&all), "{all}");
}

#[test]
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn a_list_within_a_row_is_a_table_of_its_own() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let touched: Vec<Value> = (1..=5).map(|line| json!({ "line": line, "moved_mm": 0.5 })).collect();
    let data = json!({ "files": [{ "file": "a.mod", "output": "b.mod", "exact": false, "altered": [], "touched": touched }] });
    opened(&mut browser, &folder, "restored", &data);
    assert_eq!(browser.text(".verdict"), "1 of 1 file not byte for byte the original");
    assert!(browser.text("[data-name=files]").contains("5 rows below"));
    let inner = rows(&mut browser, "files-touched");
    assert!(inner.len() == 5 && inner.iter().all(|row| row.contains(&"a.mod".to_owned())), "{inner:?}");
}

#[test]
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn what_a_controller_was_not_asked_is_named() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let target = |at: &str, agrees: bool| json!({ "at": at, "element": 1, "apart_mm": 0.25, "apart_deg": 0.0, "joints_deg": 0.0, "configurations": null, "solutions": { "count": 8, "ours": true }, "agrees": agrees });
    let notes: Vec<String> = (1..=16).map(|n| format!("sentence {n}")).collect();
    let data = json!({
        "verdict": "out_of_reach", "display_mm": 0.0, "robot": "ABB IRB 140", "not_known": 2, "host": "cell3", "notes": notes,
        "out_of_reach": ["Cell.mod:6"], "elements_out_of_reach": [{ "at": "Cell.mod:9", "element": 3 }],
        "targets": [target("Cell.mod:7", true), target("Cell.mod:8", false)],
    });
    opened(&mut browser, &folder, "check", &data);
    assert_eq!(rows(&mut browser, "out_of_reach"), [["Cell.mod:6"]]);
    assert_eq!(rows(&mut browser, "elements_out_of_reach"), [["Cell.mod:9", "3"]]);
    assert_eq!(rows(&mut browser, "wrong").len(), 1);
    assert_eq!(rows(&mut browser, "targets").len(), 2);
    // What is folded on the screen is open on paper.
    browser.eval("document.querySelectorAll('details').forEach((one) => { one.open = false; })");
    browser.settle();
    browser.call("Emulation.setEmulatedMedia", json!({ "media": "print" }));
    browser.eval("dispatchEvent(new Event('beforeprint'))");
    browser.settle();
    let seen = "[...document.querySelectorAll('.notes li')].filter((one) => one.getBoundingClientRect().height > 0).length";
    assert_eq!(browser.eval(seen), json!(16));
}
