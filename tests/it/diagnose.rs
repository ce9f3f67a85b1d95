//! `diagnose`, `synth` and `exam` as scripts rely on them: bad input, the same bytes at any number of threads,
//! files written, and a small fixed exam.

mod held_out;
mod outside_the_library;
mod told_apart;
mod unrecorded;

use assert_cmd::Command;
use serde_json::Value;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

fn driftpost() -> Command {
    Command::cargo_bin("driftpost").unwrap()
}

/// A measurement set of the generator: `measurements.csv` of the only set.
fn synth(folder: &Path, arguments: &[&str]) -> String {
    let out = folder.join("sets");
    driftpost().arg("synth").arg(&out).args(arguments).assert().success();
    fs::read_to_string(out.join("set_0000/measurements.csv")).unwrap()
}

/// Exit code, standard error and the JSON of `diagnose` over `csv`.
fn diagnose(csv: &[u8], arguments: &[&str]) -> (i32, String, Option<Value>) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("m.csv");
    fs::write(&path, csv).unwrap();
    let json = folder.path().join("out.json");
    let output =
        driftpost().arg("diagnose").arg(&path).arg("--json").arg(&json).args(arguments).output().unwrap();
    let answer = String::from_utf8_lossy(&output.stderr).into_owned();
    let json = fs::read(&json).ok().map(|bytes| serde_json::from_slice(&bytes).unwrap());
    (output.status.code().unwrap(), answer, json)
}

fn verdict(json: &Option<Value>) -> &str {
    json.as_ref().unwrap()["verdict"].as_str().unwrap()
}

/// `rows` rows, each the joints (degrees) and point (mm) that `row` gives.
fn file(rows: usize, row: impl Fn(usize) -> ([f64; 6], [f64; 3])) -> String {
    let mut text = "t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
    for k in 0..rows {
        let (q, p) = row(k);
        let cells: Vec<String> = q.iter().chain(&p).map(|v| format!("{v:.4}")).collect();
        writeln!(text, "{k},{}", cells.join(",")).unwrap();
    }
    text
}

/// Numbers from -1 to 1 without a pattern.
fn noise(k: usize) -> f64 {
    let x = (k as f64 * 12.9898).sin() * 43_758.547;
    2.0 * (x - x.floor()) - 1.0
}

/// Joints of row `k`, degrees: equidistributed by the golden section and its powers.
fn anywhere_deg(k: usize) -> [f64; 6] {
    let most_deg = [150.0, 50.0, 50.0, 160.0, 100.0, 160.0];
    let share = |j: usize| ((k + 1) as f64 * 0.618_034_f64.powi(j as i32 + 1)).fract();
    std::array::from_fn(|j| most_deg[j] * (2.0 * share(j) - 1.0))
}

fn garbage(k: usize) -> ([f64; 6], [f64; 3]) {
    (
        std::array::from_fn(|j| 40.0 * noise(7 * k + j)),
        std::array::from_fn(|j| 500.0 * noise(100_000 + 3 * k + j)),
    )
}

#[test]
fn a_file_that_cannot_be_read_says_what_and_where() {
    let head = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n";
    let cases: [(String, &[&str]); 8] = [
        (String::new(), &["header"]),
        (head.to_owned(), &["no rows"]),
        (
            "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,x_mm,y_mm,z_mm\n1,2,3,4,5,6,7,8\n".into(),
            &["q6_deg", "missing"],
        ),
        (format!("{head}1,2,3,4,5,six,7,8,9\n"), &["line 2", "q6_deg", "six"]),
        (format!("{head}1,2,3,4,5,6,NaN,8,9\n"), &["line 2", "x_mm"]),
        (format!("{head}1,2,3,4,5,6,inf,8,9\n"), &["line 2", "x_mm"]),
        (format!("{head}1,2,3,4,5,6,7,8\n"), &["line 2", "8"]),
        (head.replace("x_mm", "q7_deg,x_mm") + "1,2,3,4,5,6,7,8,9,10\n", &["q7_deg", "q1_deg to q6_deg"]),
    ];
    for (text, expected) in cases {
        let (code, answer, json) = diagnose(text.as_bytes(), &[]);
        assert_eq!(code, 2, "{text}: {answer}");
        assert!(json.is_none(), "{text}");
        for word in expected {
            assert!(answer.contains(word), "{text}: {word} is not in {answer}");
        }
    }
    let (code, answer, _) = diagnose(&[0xff, 0xfe, 0x00, 0x12, 0x0a], &[]);
    assert_eq!(code, 2, "{answer}");
}

/// The points of a set as they stand, the joint angles of one joint changed from a row on: the joint's zero has jumped.
fn with_a_jump(csv: &str, joint: usize, from: usize, by_deg: f64) -> Vec<Vec<String>> {
    let mut rows: Vec<Vec<String>> =
        csv.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect();
    let column = rows[0].iter().position(|name| *name == format!("q{joint}_deg")).unwrap();
    for row in rows.iter_mut().skip(1 + from) {
        row[column] = format!("{:.5}", row[column].parse::<f64>().unwrap() + by_deg);
    }
    rows
}

fn as_csv(rows: &[Vec<String>]) -> String {
    rows.iter().map(|row| row.join(",") + "\n").collect()
}

/// Takes times and temperatures, clocks both, out of a file.
fn without_times(rows: &mut [Vec<String>]) {
    let kept: Vec<bool> = rows[0].iter().map(|name| name != "t_min" && !name.starts_with("temp_")).collect();
    for row in rows {
        let mut kept = kept.iter();
        row.retain(|_| *kept.next().unwrap());
    }
}

/// A joint whose zero has jumped stands, in the model of rows without times, as it stood at the end.
#[test]
fn a_model_of_rows_without_times_is_that_behind_the_last_step() {
    let folder = tempfile::tempdir().unwrap();
    let csv = synth(folder.path(), &["--effects", "none", "--n", "60", "--sigma-mm", "0.02", "--seed", "5"]);
    let mut rows = with_a_jump(&csv, 4, 25, 0.1);
    without_times(&mut rows);
    let [all, since, model, json] =
        ["all.csv", "since.csv", "m.toml", "v.json"].map(|name| folder.path().join(name));
    fs::write(&all, as_csv(&rows)).unwrap();
    rows.drain(1..26);
    fs::write(&since, as_csv(&rows)).unwrap();
    driftpost().arg("diagnose").arg(&all).arg("--model-out").arg(&model).assert().success();
    driftpost()
        .arg("validate")
        .arg(&since)
        .arg("--model")
        .arg(&model)
        .arg("--json")
        .arg(&json)
        .assert()
        .success();
    let validated: Value = serde_json::from_slice(&fs::read(&json).unwrap()).unwrap();
    let [left, nominal] =
        [&validated["rms_mm"], &validated["nominal"]["rms_mm"]].map(|rms| rms.as_f64().unwrap());
    // Noise leaves 0.02 mm * sqrt(3).
    assert!(left < 1.3 * 0.02 * 3.0_f64.sqrt() && nominal > 2.0 * left, "{left} {nominal}");
}

/// A wrist that gives under a payload whose centre is not where the target is: `validate` of the model on its own rows leaves the noise
/// alone, for the model carries where the payload hung. Without that it left 0.13 mm.
#[test]
fn a_model_of_sag_is_validated_with_the_payload_where_it_hung() {
    let folder = tempfile::tempdir().unwrap();
    let options = ["--effects", "joint_compliance:5", "--n", "60", "--seed", "5", "--rho", "10"];
    let csv = synth(folder.path(), &options);
    let [rows, model, json] = ["rows.csv", "m.toml", "v.json"].map(|name| folder.path().join(name));
    fs::write(&rows, csv).unwrap();
    driftpost().arg("diagnose").arg(&rows).arg("--model-out").arg(&model).assert().success();
    let validate = |more: &[&str]| {
        let mut command = driftpost();
        command.arg("validate").arg(&rows).arg("--model").arg(&model).arg("--json").arg(&json).args(more);
        command.assert().success();
        let validated: Value = serde_json::from_slice(&fs::read(&json).unwrap()).unwrap();
        [&validated["rms_mm"], &validated["nominal"]["rms_mm"]].map(|rms| rms.as_f64().unwrap())
    };
    for more in [&[][..], &["--register", "base"]] {
        let [left, nominal] = validate(more);
        // Noise leaves 0.02 mm * sqrt(3).
        assert!(left < 1.3 * 0.02 * 3.0_f64.sqrt() && nominal > 5.0 * left, "{left} {nominal}");
    }
}

/// The points of a set without its times and temperatures, the joint angles of joint 3 changed more and more, up to `by_deg`.
fn with_a_drift_and_no_times(csv: &str, by_deg: f64) -> String {
    let mut rows: Vec<Vec<String>> =
        csv.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect();
    let column = |name: &str| rows[0].iter().position(|cell| cell == name).unwrap();
    let joint = column("q3_deg");
    let last = (rows.len() - 2) as f64;
    for (k, row) in rows.iter_mut().skip(1).enumerate() {
        row[joint] = format!("{:.5}", row[joint].parse::<f64>().unwrap() + by_deg * k as f64 / last);
    }
    without_times(&mut rows);
    as_csv(&rows)
}

#[test]
#[ignore = "a million rows take a minute unoptimised: cargo test --release -- --ignored a_million"]
fn a_million_rows_are_thinned_and_answered() {
    let (code, answer, json) = diagnose(file(1_000_000, garbage).as_bytes(), &[]);
    assert_eq!((code, verdict(&json)), (0, "data_fault"));
    assert!(answer.contains("warning[measure::many-rows]"), "{answer}");
}

#[test]
fn the_same_bytes_whatever_the_number_of_threads_and_every_file_is_written() {
    let folder = tempfile::tempdir().unwrap();
    synth(folder.path(), &["--effects", "gear_mesh:2:20,joint_compliance:3", "--n", "60", "--seed", "9"]);
    let path = folder.path().join("sets/set_0000/measurements.csv");
    let run = |threads: &str| {
        let json = folder.path().join(format!("{threads}.json"));
        let csv = folder.path().join(format!("{threads}.csv"));
        let plots = folder.path().join(format!("plots{threads}"));
        driftpost()
            .env("RAYON_NUM_THREADS", threads)
            .args(["diagnose", "--robot", "irb140"])
            .arg(&path)
            .arg("--json")
            .arg(&json)
            .arg("--csv")
            .arg(&csv)
            .arg("--plots")
            .arg(&plots)
            .assert()
            .success();
        let pictures = ["joints.svg", "time.svg", "workspace.svg"]
            .map(|name| fs::read_to_string(plots.join(name)).unwrap());
        (fs::read_to_string(json).unwrap(), fs::read_to_string(csv).unwrap(), pictures)
    };
    let one = run("1");
    assert_eq!(one, run("3"));
    let json: Value = serde_json::from_str(&one.0).unwrap();
    assert_eq!(json["verdict"], "several");
    let mut found: Vec<(&str, i64)> = json["causes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|c| (c["effect"].as_str().unwrap(), c["joint"].as_i64().unwrap()))
        .collect();
    found.sort_unstable();
    assert_eq!(found, [("gear_mesh", 2), ("joint_compliance", 3)]);
    assert_eq!(one.1.lines().count(), 61);
    for picture in one.2 {
        assert!(picture.starts_with("<svg") && picture.ends_with("</svg>\n"));
        assert!(picture.matches("<circle").count() > 60);
    }
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn garbage_gets_no_confident_answer() {
        let one = file(1, garbage);
        let alike = file(40, |_| garbage(3));
        let nearly_alike = file(40, |k| {
            let (q, p) = garbage(3);
            (q.map(|v| v + 0.001 * noise(k)), p.map(|v| v + 0.01 * noise(k + 50)))
        });
        for text in [&one, &alike, &nearly_alike] {
            let (code, answer, json) = diagnose(text.as_bytes(), &[]);
            assert_eq!((code, verdict(&json)), (0, "insufficient_data"), "{answer}");
        }
        let (code, _, json) = diagnose(file(60, garbage).as_bytes(), &[]);
        assert_eq!((code, verdict(&json)), (0, "data_fault"));
        let out_of_range = file(60, |k| {
            let (mut q, p) = garbage(k);
            q[1] = 170.0 + noise(k);
            (q, p)
        });
        let (code, _, json) = diagnose(out_of_range.as_bytes(), &[]);
        assert_eq!((code, verdict(&json)), (0, "data_fault"));
    }

    /// Two and three false readings one after the other, near the beginning and in the middle: rows to be set aside, and no step
    /// of base or target there and back.
    #[test]
    #[ignore = "long"]
    fn false_readings_side_by_side_are_no_step() {
        let folder = tempfile::tempdir().unwrap();
        let csv = synth(folder.path(), &["--effects", "joint_gain:2", "--n", "100", "--seed", "7"]);
        // Up to 0.6 mm off, each another way.
        let off_mm = [[0.4, -0.3, 0.2], [-0.1, 0.5, 0.3], [0.3, 0.1, -0.5]];
        for (first, rows) in [(3, 2), (4, 3), (60, 3)] {
            let mut lines: Vec<String> = csv.lines().map(str::to_owned).collect();
            let x = lines[0].split(',').position(|name| name == "x_mm").unwrap();
            for (line, off_mm) in lines[first..first + rows].iter_mut().zip(off_mm) {
                let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
                for (cell, off_mm) in cells[x..x + 3].iter_mut().zip(off_mm) {
                    *cell = format!("{:.5}", cell.parse::<f64>().unwrap() + off_mm);
                }
                *line = cells.join(",");
            }
            let (code, answer, json) = diagnose(lines.join("\n").as_bytes(), &[]);
            let json = json.unwrap();
            let causes: Vec<&str> =
                json["causes"].as_array().unwrap().iter().map(|c| c["effect"].as_str().unwrap()).collect();
            assert_eq!(
                (code, causes.as_slice()),
                (0, ["joint_gain"].as_slice()),
                "rows {first} on: {answer}"
            );
            let aside: Vec<u64> =
                json["false_rows"].as_array().unwrap().iter().map(|r| r["line"].as_u64().unwrap()).collect();
            let falsified: Vec<u64> = (first..first + rows).map(|line| line as u64 + 1).collect();
            assert_eq!(aside, falsified);
        }
    }

    /// Zeros of two joints in a row are two numbers that the six of the link between them can take up, as are a zero and the next
    /// link; and the link itself stays one.
    #[test]
    #[ignore = "long"]
    fn two_joint_offsets_in_a_row_are_no_link_geometry() {
        let cases = [
            ("2", "joint_offset:3,joint_offset:4", vec![("joint_offset", 3), ("joint_offset", 4)]),
            ("2", "joint_offset:4,joint_offset:5", vec![("joint_offset", 4), ("joint_offset", 5)]),
            ("1.2", "joint_offset:4,link_geometry:5", vec![("joint_offset", 4), ("link_geometry", 5)]),
            ("2", "link_geometry:4", vec![("link_geometry", 4)]),
        ];
        for (rho, effects, truth) in cases {
            let folder = tempfile::tempdir().unwrap();
            let out = folder.path().join("sets");
            let options = ["--effects", effects, "--sets", "3", "--n", "60", "--rho", rho, "--seed", "5"];
            driftpost().arg("synth").arg(&out).args(options).assert().success();
            for set in 0..3 {
                let csv = fs::read(out.join(format!("set_000{set}/measurements.csv"))).unwrap();
                let (_, message, json) = diagnose(&csv, &["--robot", "irb140"]);
                let causes = json.as_ref().unwrap()["causes"].as_array().unwrap();
                let mut found: Vec<(&str, u64)> = causes
                    .iter()
                    .filter(|cause| cause["posterior"].as_f64().unwrap() > 0.5)
                    .map(|cause| (cause["effect"].as_str().unwrap(), cause["joint"].as_u64().unwrap()))
                    .collect();
                found.sort_unstable();
                assert_eq!(found, truth, "{effects}, set {set}: {message}");
            }
        }
    }

    /// 18 sets of the exam's mixture, of the first seed from 42 on whose sets are of all six kinds; the same draws on every machine.
    #[test]
    #[ignore = "long"]
    fn a_small_fixed_exam() {
        let folder = tempfile::tempdir().unwrap();
        let sets = folder.path().join("sets");
        driftpost()
            .arg("synth")
            .arg(&sets)
            .args(["--sets", "18", "--seed", "44", "--most-rows", "60"])
            .assert()
            .success();
        let json = folder.path().join("exam.json");
        driftpost().arg("exam").arg(&sets).arg("--json").arg(&json).assert().success();
        let answer: Value = serde_json::from_slice(&fs::read(json).unwrap()).unwrap();
        let value = |name: &str| {
            let all = answer["measures"].as_array().unwrap();
            let one = all.iter().find(|m| m["name"].as_str().unwrap().starts_with(name)).unwrap();
            one["value"].as_f64()
        };
        assert_eq!(value("confident and wrong, overall"), Some(0.0));
        assert_eq!(value("false alarms"), Some(0.0));
        assert_eq!(value("faults of the file"), Some(1.0));
        // Four sets of 30 and 60 rows: of such, drawn from families, about every other shape is seen (docs/EXAM.md).
        assert!(value("outside the library: recall").unwrap() >= 0.5, "{answer:#}");
        assert!(value("two effects").unwrap() >= 0.5, "{answer:#}");

        // A truth that was changed after the seal is seen.
        let truth = sets.join("sealed/truth.json");
        let changed = fs::read_to_string(&truth).unwrap().replacen("\"n\": 60", "\"n\": 61", 1);
        fs::write(&truth, changed).unwrap();
        let output = driftpost().arg("exam").arg(&sets).output().unwrap();
        assert_eq!(output.status.code(), Some(2));
        assert!(String::from_utf8_lossy(&output.stderr).contains("exam::seal"));
    }

    #[test]
    #[ignore = "long"]
    fn time_that_steps_back_once_is_a_warning_and_shuffled_rows_are_sorted() {
        let folder = tempfile::tempdir().unwrap();
        let csv = synth(folder.path(), &["--effects", "joint_compliance:2", "--n", "60", "--seed", "5"]);
        let retimed = |at: &dyn Fn(usize, f64) -> f64| {
            let mut lines = csv.lines();
            let mut text = lines.next().unwrap().to_owned() + "\n";
            for (k, line) in lines.enumerate() {
                let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
                cells[2] = format!("{:.2}", at(k, cells[2].parse().unwrap()));
                text += &(cells.join(",") + "\n");
            }
            text
        };
        let (code, answer, json) =
            diagnose(retimed(&|k, t| if k < 30 { t } else { t - 20.0 }).as_bytes(), &[]);
        assert_eq!(code, 0);
        assert!(answer.contains("warning[measure::time-step-back]"), "{answer}");
        assert_eq!(json.unwrap()["causes"][0]["effect"], "joint_compliance");
        let (code, answer, json) = diagnose(retimed(&|k, _| ((37 * k) % 60) as f64).as_bytes(), &[]);
        assert_eq!(code, 0);
        assert!(answer.contains("warning[measure::time-order]"), "{answer}");
        assert_eq!(json.unwrap()["causes"][0]["effect"], "joint_compliance");
    }

    #[test]
    #[ignore = "long"]
    fn a_joint_whose_zero_jumps_is_told_with_the_row_sorted_or_not_and_without_times() {
        let folder = tempfile::tempdir().unwrap();
        let csv =
            synth(folder.path(), &["--effects", "none", "--n", "60", "--sigma-mm", "0.02", "--seed", "5"]);
        let rows = with_a_jump(&csv, 4, 25, 0.03);
        let time = rows[0].iter().position(|name| name == "t_min").unwrap();
        let minute = |row: &Vec<String>| row[time].parse::<f64>().unwrap();
        let reported = |rows: &[Vec<String>]| {
            let (code, answer, json) = diagnose(as_csv(rows).as_bytes(), &[]);
            assert_eq!(code, 0, "{answer}");
            let cause = json.as_ref().unwrap()["causes"][0].clone();
            assert_eq!(verdict(&json), "explained", "{cause}");
            assert_eq!((cause["effect"].as_str(), cause["joint"].as_u64()), (Some("joint_step"), Some(4)));
            // Turned back by as much as the file says too much: 0.03 deg.
            let size_deg = cause["size"].as_f64().unwrap().to_degrees();
            assert!((size_deg - 0.03).abs() < 0.003, "{size_deg}");
            cause
        };
        let cause = reported(&rows);
        let [before, after] = [&rows[25], &rows[26]].map(minute);
        let t0_min = cause["t0_min"].as_f64().unwrap();
        assert!(before < t0_min && t0_min < after, "{before} {t0_min} {after}");
        assert_eq!(cause["from_line"], 27);
        // 37 and 60 have no common divisor: every row once.
        let shuffled: Vec<Vec<String>> =
            std::iter::once(0).chain((0..60).map(|k| 1 + 37 * k % 60)).map(|k| rows[k].clone()).collect();
        assert_eq!(reported(&shuffled)["t0_min"].as_f64(), Some(t0_min));
        let untimed: Vec<Vec<String>> = rows
            .iter()
            .map(|row| {
                row.iter().enumerate().filter(|(c, _)| *c != time).map(|(_, cell)| cell.clone()).collect()
            })
            .collect();
        let cause = reported(&untimed);
        assert_eq!((cause["t0_min"].as_f64(), cause["from_line"].as_u64()), (None, Some(27)));
    }

    /// What drifts over rows without times is in no model: it is fitted without, so that the joint's zero is off by the drift's mean.
    #[test]
    #[ignore = "long"]
    fn a_drift_over_rows_without_times_is_in_no_model() {
        let folder = tempfile::tempdir().unwrap();
        let csv =
            synth(folder.path(), &["--effects", "none", "--n", "60", "--sigma-mm", "0.02", "--seed", "5"]);
        let [rows, model] = ["m.csv", "m.toml"].map(|name| folder.path().join(name));
        fs::write(&rows, with_a_drift_and_no_times(&csv, 0.05)).unwrap();
        let output = driftpost().arg("diagnose").arg(&rows).arg("--model-out").arg(&model).output().unwrap();
        let reported = String::from_utf8(output.stdout).unwrap();
        assert!(reported.starts_with("Explained: thermal_joint_drift of joint 3"), "{reported}");
        let warned = String::from_utf8(output.stderr).unwrap();
        assert!(warned.contains("warning[diagnose::untimed]"), "{warned}");
        let model: toml::Table = fs::read_to_string(&model).unwrap().parse().unwrap();
        let effects = model["effect"].as_array().unwrap();
        assert!(effects.iter().all(|effect| effect.get("growth").is_none()), "{effects:?}");
        let offset = effects.iter().find(|effect| effect["effect"].as_str() == Some("joint_offset")).unwrap();
        assert_eq!(offset["joint"].as_integer(), Some(3));
        // The file says up to 0.05 deg too much, evenly over its rows.
        let offset_deg = offset["offset_deg"].as_float().unwrap();
        assert!((offset_deg + 0.025).abs() < 0.004, "{offset_deg}");
    }

    /// A joint that turns by three in ten thousand more than it says, counted from the model's zero and from 40 deg: one cause, whatever
    /// its scale's zero, and the same gain in the model.
    #[test]
    #[ignore = "long"]
    fn a_gain_is_one_cause_wherever_its_zero_lies() {
        const GAIN: f64 = 3e-4;
        let folder = tempfile::tempdir().unwrap();
        let csv = synth(folder.path(), &["--effects", "none", "--n", "60", "--seed", "1"]);
        for zero_deg in [0.0, 40.0] {
            let mut lines: Vec<String> = csv.lines().map(str::to_owned).collect();
            let q2 = lines[0].split(',').position(|name| name == "q2_deg").unwrap();
            for line in &mut lines[1..] {
                let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
                let stood_deg: f64 = cells[q2].parse().unwrap();
                cells[q2] = format!("{:.6}", stood_deg - GAIN * (stood_deg - zero_deg));
                *line = cells.join(",");
            }
            let (_, message, json) = diagnose(lines.join("\n").as_bytes(), &["--robot", "irb140"]);
            let json = json.unwrap();
            let cause = &json["causes"][0];
            assert_eq!(json["verdict"], "explained", "{zero_deg}: {message}");
            assert_eq!((cause["effect"].as_str(), cause["joint"].as_u64()), (Some("joint_gain"), Some(2)));
            let [size, sigma] = ["size", "sigma"].map(|key| cause[key].as_f64().unwrap());
            assert!((size - GAIN).abs() < 4.0 * sigma && sigma < 0.1 * GAIN, "{zero_deg}: {size} +- {sigma}");
        }
    }

    /// What an effect moves the tool by is larger than what measurements show of it, as base and target stand where they fit best. The
    /// generator, which shares no code with the diagnosis, says the latter of what it plants.
    #[test]
    #[ignore = "long"]
    fn what_base_and_target_leave_of_a_cause_is_told_beside_its_own_size() {
        let folder = tempfile::tempdir().unwrap();
        let planted =
            ["--effects", "gear_mesh:3:20,gear_eccentricity:2", "--n", "150", "--rho", "4", "--seed", "3"];
        let csv = synth(folder.path(), &planted);
        let truth: Value =
            serde_json::from_slice(&fs::read(folder.path().join("sets/sealed/truth.json")).unwrap()).unwrap();
        let (_, _, json) = diagnose(csv.as_bytes(), &["--robot", "irb140"]);
        let json = json.unwrap();
        for effect in truth["sets"][0]["effects"].as_array().unwrap() {
            let causes = json["causes"].as_array().unwrap();
            let cause = causes.iter().find(|cause| cause["effect"] == effect["effect"]).unwrap();
            let mm = |of: &Value, key: &str| of[key].as_f64().unwrap();
            let (seen, own, expected) = (mm(cause, "rms_seen_mm"), mm(cause, "rms_mm"), mm(effect, "rms_mm"));
            assert!((seen / expected - 1.0).abs() < 0.03, "{seen} for {expected} mm");
            // A gear line of many periods looks like no shift or turn; one of a single period does.
            let absorbed = if cause["effect"] == "gear_eccentricity" { 0.1..0.5 } else { -0.001..0.02 };
            assert!(absorbed.contains(&(1.0 - seen / own)), "{own} mm of its own, {seen} mm shown");
            // A line that nothing else looks like is missed whole where it is left out; of one of a single period others take a part over.
            let of_gap = mm(cause, "rms_of_gap_mm");
            let resting = if cause["effect"] == "gear_eccentricity" { 0.1..1.01 } else { 0.95..1.01 };
            assert!(resting.contains(&(of_gap / seen)), "{of_gap} mm of the gap, {seen} mm shown");
        }
    }
}
