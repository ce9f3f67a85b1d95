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

/// The tool point of `fixtures/robots/scara.toml` by plane trigonometry, mm: links of 325 and 275, the flange 320 above the floor at
/// rest; joints in deg, the third in mm.
fn scara_point([q1, q2, q3, q4]: [f64; 4], [x, y, z]: [f64; 3]) -> [f64; 3] {
    let (a, b) = (q1.to_radians(), (q1 + q2).to_radians());
    let (sin, cos) = (q1 + q2 + q4).to_radians().sin_cos();
    let across = 325.0 * a.cos() + 275.0 * b.cos() + x * cos - y * sin;
    let along = 325.0 * a.sin() + 275.0 * b.sin() + x * sin + y * cos;
    [across, along, 320.0 + q3 + z]
}

#[test]
fn arms_of_four_and_seven_joints_are_drawn_where_they_stand() {
    let Some(mut browser) = Browser::launch() else { return };
    let folder = tempfile::tempdir().unwrap();
    for (name, effect, joints, slides) in
        [("scara", "joint_offset:2", 4, Some(3)), ("seven_axes", "joint_offset:4", 7, None)]
    {
        let robot = format!("fixtures/robots/{name}.toml");
        let (set, set_name) = path(&folder, name);
        driftpost(
            &["synth", &set_name, "--robot", &robot, "--effects", effect, "--n", "60", "--rho", "8"],
            0,
        );
        let rows = set.join("set_0000/measurements.csv").display().to_string();
        let ((page, page_name), (file, file_name)) =
            (path(&folder, &format!("{name}.html")), path(&folder, &format!("{name}.json")));
        driftpost(&["diagnose", &rows, "--robot", &robot, "--report", &page_name, "--json", &file_name], 0);
        let json = json(&file);
        looks_right(&mut browser, &page);
        browser.open(&page, 1440, "light");
        assert!(browser.text("[data-name=next-step]").starts_with("Next: write the model"), "{name}");
        assert!(!browser.text("[data-name=next-step]").contains("compensate"), "{name} writes no programs");

        let titles = browser
            .eval("[...document.querySelectorAll('#residuals figcaption')].map((one) => one.textContent)");
        let by = |joint| match slides == Some(joint) {
            true => format!("By the travel of joint {joint}"),
            false => format!("By the angle of joint {joint}"),
        };
        let wanted: Vec<String> =
            std::iter::once("Over time".to_owned()).chain((1..=joints).map(by)).collect();
        assert_eq!(serde_json::from_value::<Vec<String>>(titles).unwrap(), wanted);

        let drawn = |browser: &mut Browser| -> [f64; 3] {
            browser.settle();
            let hud = browser.text("#workspace .hud");
            let numbers = hud.rsplit(" at ").next().unwrap().trim_end_matches(" mm").to_owned();
            let all: Vec<f64> = numbers.split(", ").map(|n| n.parse().unwrap()).collect();
            all.try_into().unwrap()
        };
        let tool: [f64; 3] = serde_json::from_value(json["tool_mm"].clone()).unwrap();
        for (i, pose) in json["next_measurements"].as_array().unwrap().iter().enumerate().take(4) {
            browser.eval(&format!("document.querySelectorAll('[data-name=next] tbody button')[{i}].click()"));
            let seen = drawn(&mut browser);
            if name == "scara" {
                let q: [f64; 4] = serde_json::from_value(pose["q_deg"].clone()).unwrap();
                let meant = scara_point(q, tool);
                let off = seen.iter().zip(meant).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(off < 0.051, "pose {i}: {seen:?} drawn, {meant:?} by plane trigonometry");
            }
        }
        // At a row the arm stands where the program has put the row's point, by the kinematics of the diagnosis.
        browser.eval("document.querySelector('[data-name=rows] tbody button').click()");
        let seen = drawn(&mut browser);
        let line: u64 = browser.text("[data-name=rows] tbody button").parse().unwrap();
        let point = browser.eval(&format!(
            "(() => {{ const all = JSON.parse(document.getElementById('data').textContent).view.residuals;
               const i = all.line.indexOf({line}); return all.p_mm.slice(3 * i, 3 * i + 3); }})()"
        ));
        let point: [f64; 3] = serde_json::from_value(point).unwrap();
        let off = seen.iter().zip(point).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 0.06, "{name}, line {line}: {seen:?} drawn, {point:?} by the diagnosis");
    }
}
