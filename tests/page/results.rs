//! The pages of what was measured, fitted and executed.

use super::{Browser, driftpost, looks_right, path};
use serde_json::Value;
use std::fs;

const ROWS: &str = "fixtures/measurements/r2000ic/measurements.csv";
const ROBOT: &str = "fixtures/measurements/r2000ic/robot.toml";

fn json(file: &std::path::Path) -> Value {
    serde_json::from_slice(&fs::read(file).unwrap()).unwrap()
}

/// The value of a figure by its label.
fn figure(browser: &mut Browser, label: &str) -> String {
    let script = format!(
        "[...document.querySelectorAll('.figure')].find((f) => f.querySelector('dt').textContent === {label:?}).querySelector('.value').textContent"
    );
    browser.eval(&script).as_str().unwrap().to_owned()
}

#[test]
fn a_diagnosis_is_seen_used_and_true() {
    let Some(mut browser) = Browser::launch() else { return };
    let folder = tempfile::tempdir().unwrap();
    let ((page, page_name), (file, file_name)) = (path(&folder, "d.html"), path(&folder, "d.json"));
    driftpost(&["diagnose", ROWS, "--robot", ROBOT, "--report", &page_name, "--json", &file_name], 0);
    let json = json(&file);
    looks_right(&mut browser, &page);
    browser.open(&page, 1440, "light");

    assert_eq!(figure(&mut browser, "Rows"), json["rows"].to_string());
    let shrink = &json["shrink"];
    let percent = (100.0 * shrink["ratio"].as_f64().unwrap()).round();
    assert_eq!(figure(&mut browser, "The gap shrinks to"), format!("{percent} %"));
    let bars = browser.eval("document.querySelector('#overview .bars svg').getAttribute('aria-label')");
    for key in ["before_rms_mm", "causes_only_rms_mm", "after_rms_mm", "floor_rms_mm"] {
        let value = format!("{:.3} mm", shrink[key].as_f64().unwrap());
        assert!(bars.as_str().unwrap().contains(&value), "{key} {value}: {bars}");
    }
    let causes = json["causes"].as_array().unwrap();
    let named = "[...document.querySelectorAll('[data-name=causes] tbody tr')].map((tr) => tr.children[3].textContent)";
    let shown: Vec<String> = serde_json::from_value(browser.eval(named)).unwrap();
    let moves = causes.iter().map(|cause| format!("{:.3}", cause["rms_mm"].as_f64().unwrap()));
    assert_eq!(shown, Vec::from_iter(moves));

    let rows = "document.querySelector('[data-name=rows] tbody tr').children[2].textContent";
    let worst: f64 = browser.eval(rows).as_str().unwrap().parse().unwrap();
    let (residuals, residuals_name) = path(&folder, "r.csv");
    driftpost(&["diagnose", ROWS, "--robot", ROBOT, "--csv", &residuals_name], 0);
    let most = fs::read_to_string(residuals).unwrap().lines().skip(1).map(length_before).fold(0.0, f64::max);
    assert!((worst - most).abs() < 0.000_6, "{worst} on the page, {most} in the table of residuals");

    let picture = "document.querySelector('#workspace canvas').toDataURL()";
    let mut seen = vec![browser.eval(picture)];
    for act in [
        "document.querySelector('[data-name=after] input[value=yes]').click()",
        "document.querySelector('[data-name=next] tbody button').click()",
        "document.querySelector('[data-name=rows] tbody button').click()",
    ] {
        browser.eval(act);
        browser.settle();
        let now = browser.eval(picture);
        assert!(!seen.contains(&now), "the picture is the same after {act}");
        seen.push(now);
    }
    assert_eq!(browser.complaints(), [""; 0]);
}

/// The distance in space of a line `line,id,x,y,z,...`, mm.
fn length_before(line: &str) -> f64 {
    let numbers = line.split(',').skip(2).take(3).map(|n| n.parse::<f64>().unwrap());
    numbers.map(|n| n * n).sum::<f64>().sqrt()
}

#[test]
fn pages_of_the_other_commands_are_right_in_every_setting() {
    let Some(mut browser) = Browser::launch() else { return };
    let folder = tempfile::tempdir().unwrap();
    let cube = "fixtures/robodk/irc5/Cube45.mod";
    let (_, made) = path(&folder, "cube_tc.mod");
    driftpost(&["compensate", cube, "-o", &made], 0);
    // arguments, exit code, a figure of the page, and where in the JSON it stands
    let commands: [(&[&str], i32, &str, &str); 5] = [
        (
            &["simulate", &made, "--original", cube, "--minutes", "0,60,120,180"],
            0,
            "Worst error as executed",
            "/worst/mm",
        ),
        (
            &["fit", "fixtures/docs/touches.csv", "--tool", "0,0,100"],
            0,
            "Noise of one coordinate",
            "/sigma_mm",
        ),
        (
            &["accuracy", "fixtures/docs/measured.csv", "--tool", "0,0,80", "--limit-ap-mm", "0.001"],
            1,
            "Pose accuracy AP",
            "/worst/ap_mm",
        ),
        (
            &[
                "compare-measurements",
                "fixtures/docs/before.csv",
                "fixtures/docs/after.csv",
                "--tool",
                "0,0,80",
            ],
            1,
            "The points have moved by",
            "/rms_mm",
        ),
        (
            &["closed-loop", cube, "--inject", "joint_offset:2", "--n", "60"],
            0,
            "Truly, before",
            "/before/true_rms_mm",
        ),
    ];
    for (command, code, label, place) in commands {
        let name = command[0];
        let (page, page_name) = path(&folder, &format!("{name}.html"));
        let (file, file_name) = path(&folder, &format!("{name}.json"));
        let arguments = [command, &["--report", &page_name, "--json", &file_name]].concat();
        driftpost(&arguments, code);
        let expected = format!("{:.4}", json(&file).pointer(place).unwrap().as_f64().unwrap());
        looks_right(&mut browser, &page);
        assert_eq!(figure(&mut browser, label), expected, "{name}");
        // and from its JSON alone
        driftpost(&["report", &file_name, "-o", &page_name], 0);
        browser.open(&page, 390, "dark");
        assert_eq!(figure(&mut browser, label), expected, "{name} from its JSON");
        assert_eq!(browser.complaints(), [""; 0], "{name} from its JSON");
    }
}

#[test]
fn a_diagnosis_that_says_nothing_has_a_page_too() {
    let Some(mut browser) = Browser::launch() else { return };
    let folder = tempfile::tempdir().unwrap();
    let (rows, rows_name) = path(&folder, "one.csv");
    let text = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n0,0,0,0,30,0,515,0,712\n";
    fs::write(rows, text).unwrap();
    let (page, page_name) = path(&folder, "one.html");
    driftpost(&["diagnose", &rows_name, "--report", &page_name], 0);
    looks_right(&mut browser, &page);
    assert!(browser.text(".verdict").starts_with("Too few"));
}
