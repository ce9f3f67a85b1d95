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
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn a_diagnosis_is_seen_used_and_true() {
    let mut browser = Browser::launch();
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
    let bars = browser.eval("document.querySelector('#overview .bars').getAttribute('aria-label')");
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

#[test]
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn gears_of_a_diagnosis_are_seen() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let (set, set_name) = path(&folder, "gears");
    let effects =
        ["--effects", "gear_mesh:3:20,gear_eccentricity:2", "--n", "150", "--rho", "4", "--seed", "3"];
    driftpost(&[&["synth", &set_name], &effects[..]].concat(), 0);
    let rows = set.join("set_0000/measurements.csv").display().to_string();
    let ((page, page_name), (file, file_name)) = (path(&folder, "d.html"), path(&folder, "d.json"));
    driftpost(&["diagnose", &rows, "--robot", "irb140", "--report", &page_name, "--json", &file_name], 0);
    looks_right(&mut browser, &page);
    browser.open(&page, 1440, "light");
    let json = json(&file);
    let causes = json["causes"].as_array().unwrap();
    gear_lines_are_the_jsons(&mut browser, causes);
    let planted = [("gear_mesh", 3), ("gear_eccentricity", 2)];
    assert!(
        planted.iter().all(|(effect, joint)| causes
            .iter()
            .any(|one| one["effect"] == *effect && one["joint"] == *joint))
    );
}

/// Every gear line that is the likeliest of its slot is in the table of lines, with about the causes' size (the model is fitted once more on the exact arm)
/// and, at the tool, an amplitude that fits what it moves the tool by; and its bar stands in the picture of its joint.
fn gear_lines_are_the_jsons(browser: &mut Browser, causes: &[Value]) {
    let table = "[...document.querySelectorAll('[data-name=gear-lines] tbody tr')].map((tr) => [...tr.children].map((td) => td.textContent))";
    let rows: Vec<[String; 5]> = serde_json::from_value(browser.eval(table)).unwrap();
    let is_first = |i: usize| !causes[..i].iter().any(|before| before["slot"] == causes[i]["slot"]);
    let is_gear = |cause: &Value| cause["effect"].as_str().unwrap().starts_with("gear");
    let lines: Vec<&Value> =
        (0..causes.len()).filter(|&i| is_first(i) && is_gear(&causes[i])).map(|i| &causes[i]).collect();
    assert_eq!(lines.len(), 2, "both gears show");
    assert_eq!(rows.iter().filter(|row| !row[4].is_empty()).count(), lines.len());
    for line in lines {
        let n = line["n"].as_u64().unwrap_or_else(|| match line["effect"].as_str() {
            Some("gear_eccentricity") => 1,
            _ => 2,
        });
        let [_, _, mrad, mm, _] = rows
            .iter()
            .find(|row| [row[0].parse().ok(), row[1].parse().ok()] == [line["joint"].as_u64(), Some(n)])
            .unwrap_or_else(|| panic!("{line} in {rows:?}"));
        let number = |text: &String| text.split(' ').next().unwrap().parse::<f64>().unwrap();
        let (rad, sigma) = (line["size"].as_f64().unwrap(), line["sigma"].as_f64().unwrap());
        assert!((number(mrad) / 1e3 - rad).abs() < 2.0 * sigma, "{mrad} mrad, {rad} rad in the JSON");
        // The report's own number is the rms over the poses, 0.71 of a sine's amplitude where they are spread over its periods.
        let of_amplitude = line["rms_mm"].as_f64().unwrap() / number(mm);
        assert!((0.5..1.0).contains(&of_amplitude), "{line} beside {mm} mm at the tool");
        let joint = &line["joint"];
        let picture = browser.eval(&format!(
            "(() => {{ const figure = [...document.querySelectorAll('#gears figure')].find((one) => one.textContent.startsWith('Joint {joint}:'));
               const canvas = figure.querySelector('canvas'); const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
               copy.drawImage(canvas, 0, 0); const {{ data }} = copy.getImageData(0, 0, canvas.width, canvas.height);
               const after = getComputedStyle(document.documentElement).getPropertyValue('--after').trim(); let n = 0;
               const [r, g, b] = [1, 3, 5].map((at) => parseInt(after.slice(at, at + 2), 16));
               for (let i = 0; i < data.length; i += 4) if (data[i] === r && data[i + 1] === g && data[i + 2] === b) n += 1;
               return [n, [...figure.querySelectorAll('.mark-label')].map((one) => one.textContent)]; }})()"
        ));
        assert!(picture[0].as_u64().unwrap() > 50, "no bar of joint {joint}");
        assert!(picture[1].as_array().unwrap().contains(&Value::from(n.to_string())), "{picture}");
    }
}

/// Two touches of the documentation's file with another joint 1, by 0.05 and -0.06 degrees: half a millimetre at the tip.
#[test]
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn false_touches_are_seen_beside_the_curve() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let text = fs::read_to_string("fixtures/docs/touches.csv").unwrap();
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for (line, turn_deg) in [(61, 0.05), (120, -0.06)] {
        let mut cells: Vec<String> = lines[line - 1].split(',').map(str::to_owned).collect();
        cells[2] = format!("{:.6}", cells[2].parse::<f64>().unwrap() + turn_deg);
        lines[line - 1] = cells.join(",");
    }
    let (touches, touches_name) = path(&folder, "touches.csv");
    fs::write(touches, lines.join("\n")).unwrap();
    let (page, page_name) = path(&folder, "fit.html");
    driftpost(&["fit", &touches_name, "--tool", "0,0,100", "--report", &page_name], 0);
    looks_right(&mut browser, &page);
    browser.open(&page, 1440, "light");
    let table = "[...document.querySelectorAll('[data-name=touches] tbody tr')].map((tr) => [...tr.children].map((td) => td.textContent))";
    let rows: Vec<Vec<String>> = serde_json::from_value(browser.eval(table)).unwrap();
    let mut wrong: Vec<&str> =
        rows.iter().filter(|row| row[6] == "looks false, set aside").map(|row| row[0].as_str()).collect();
    wrong.sort_unstable();
    assert_eq!(wrong, ["120", "61"]);
    assert!(browser.text(".figures").contains("5 points; 2 look false"));
    // Both pictures show each of them as a large dot of its own colour; what is chosen in the table is marked in both.
    let dots = "(() => [...document.querySelectorAll('#curves figure')].slice(1, 3).map((figure) => { const canvas = figure.querySelector('canvas');
        const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height); const bad = getComputedStyle(document.documentElement).getPropertyValue('--bad').trim();
        const [r, g, b] = [1, 3, 5].map((at) => parseInt(bad.slice(at, at + 2), 16)); let n = 0;
        for (let i = 0; i < data.length; i += 4) if (data[i] === r && data[i + 1] === g && data[i + 2] === b) n += 1; return n; }))()";
    let dots: [u64; 2] = serde_json::from_value(browser.eval(dots)).unwrap();
    // two discs of ten pixels across are 157 pixels, less their soft edges
    assert!(dots.iter().all(|n| (90..=160).contains(n)), "{dots:?}");
    browser.eval("document.querySelector('[data-name=touches] tbody button').click()");
    browser.settle();
    let needles = "[...document.querySelectorAll('#curves figure')].slice(1, 3).map((figure) => figure.querySelector('.needle').hidden)";
    assert_eq!(browser.eval(needles), serde_json::json!([false, false]));
}

/// The distance in space of a line `line,id,x,y,z,...`, mm.
fn length_before(line: &str) -> f64 {
    let numbers = line.split(',').skip(2).take(3).map(|n| n.parse::<f64>().unwrap());
    numbers.map(|n| n * n).sum::<f64>().sqrt()
}

#[test]
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn pages_of_the_other_commands_are_right_in_every_setting() {
    let mut browser = Browser::launch();
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
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn what_happens_in_a_scenario_stands_on_the_curves() {
    let mut browser = Browser::launch();
    let folder = tempfile::tempdir().unwrap();
    let cube = "fixtures/robodk/irc5/Cube45.mod";
    let (_, made) = path(&folder, "cube_tc.mod");
    driftpost(&["compensate", cube, "-o", &made, "--diff", "none"], 0);
    let (day, day_name) = path(&folder, "day.toml");
    let steps = r#"steps = ["call tcColdStart", "run 10", "stand 45 lunch", "pp_to_main", "run 6 second shift",
        "power_off 20", "run 4", "stand 30 night", "call tcWarmStart", "run 4"]"#;
    fs::write(day, steps).unwrap();
    let ((page, page_name), (file, file_name)) = (path(&folder, "day.html"), path(&folder, "day.json"));
    let command = ["simulate", &made, "--original", cube, "--scenario", &day_name, "--tolerance-mm", "1"];
    driftpost(&[&command[..], &["--report", &page_name, "--json", &file_name]].concat(), 0);
    let marks = json(&file)["marks"].clone();
    let words =
        ["cold start", "lunch", "PP to main", "second shift", "power off 20 min", "night", "warm start"];
    let lasts = [0.0, 45.0, 0.0, 6.0, 20.0, 30.0, 0.0];
    for (i, (mark, (words, lasts))) in
        marks.as_array().unwrap().iter().zip(words.iter().zip(lasts)).enumerate()
    {
        assert_eq!(mark["words"], *words);
        let took = mark["to_min"].as_f64().unwrap() - mark["from_min"].as_f64().unwrap();
        // a pass goes on to its end: half a minute at most
        assert!((lasts..lasts + 0.6).contains(&took) || (took - lasts).abs() < 1e-9, "{words}: {took} min");
        assert_eq!(mark["standing"], [1, 4, 5].contains(&i), "{words}");
    }
    assert_eq!(marks.as_array().unwrap().len(), words.len());
    looks_right(&mut browser, &page);

    let begins = |i: usize| marks[i]["from_min"].as_f64().unwrap();
    for (width, scheme) in [(1440, "light"), (390, "dark")] {
        browser.open(&page, width, scheme);
        let found = browser.eval(
            "(() => { const figure = document.querySelector('#curves figure'); const box = (one) => { const b = one.getBoundingClientRect();
               return [b.left, b.top, b.right, b.bottom]; };
               return { labels: [...figure.querySelectorAll('.mark-label')].filter((one) => !one.hidden).map((one) => [one.textContent, ...box(one)]),
                 poles: [...figure.querySelectorAll('.mark-pole')].map((one) => box(one)[0]).sort((a, b) => a - b), plot: box(figure) }; })()",
        );
        let number = |value: &Value| value.as_f64().unwrap();
        let labels = found["labels"].as_array().unwrap();
        let shown: Vec<&str> = labels.iter().map(|label| label[0].as_str().unwrap()).collect();
        assert_eq!(
            shown,
            ["cold start", "lunch", "PP to main, second shift", "power off 20 min", "night", "warm start"]
        );
        for (i, a) in labels.iter().enumerate() {
            assert!(number(&a[1]) >= 0.0 && number(&a[3]) <= f64::from(width), "{a} beside the window");
            for b in &labels[i + 1..] {
                let apart = number(&a[3]) <= number(&b[1])
                    || number(&b[3]) <= number(&a[1])
                    || number(&a[4]) <= number(&b[2])
                    || number(&b[4]) <= number(&a[2]);
                assert!(apart, "{a} and {b} overlap at {width} px");
            }
        }
        // The lines stand where their minutes do: distances on the page are as distances in time.
        let poles: Vec<f64> = found["poles"].as_array().unwrap().iter().map(number).collect();
        let at = [0, 1, 2, 4, 5, 6].map(begins);
        let per_min = (poles[5] - poles[0]) / (at[5] - at[0]);
        for (pole, at_min) in poles.iter().zip(at) {
            assert!(
                (pole - poles[0] - per_min * (at_min - at[0])).abs() < 1.0,
                "{pole} px for minute {at_min}"
            );
        }
    }
}

#[test]
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn a_diagnosis_that_says_nothing_has_a_page_too() {
    let mut browser = Browser::launch();
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
#[ignore = "needs Chromium, and `npm ci` in assets"]
fn arms_of_four_and_seven_joints_are_drawn_where_they_stand() {
    let mut browser = Browser::launch();
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
