//! Cells of a measurement file that are empty, stand still or are rounded, and models of files that say how large their noise is.

use assert_cmd::Command;
use serde_json::Value;
use std::fs;
use std::sync::LazyLock;
use tempfile::TempDir;

/// Standard error, JSON and, where one was asked for and written, the model.
struct Answer {
    code: i32,
    messages: String,
    json: Value,
    model: Option<String>,
}

fn diagnose(csv: &str, arguments: &[&str]) -> Answer {
    let folder = TempDir::new().unwrap();
    let [csv_path, json_path, model] =
        ["m.csv", "out.json", "model.toml"].map(|name| folder.path().join(name));
    fs::write(&csv_path, csv).unwrap();
    let mut command = Command::cargo_bin("driftpost").unwrap();
    command.arg("diagnose").arg(&csv_path).arg("--json").arg(&json_path).args(arguments);
    if arguments.contains(&"--sigma-mm") {
        command.arg("--model-out").arg(&model);
    }
    let output = command.output().unwrap();
    Answer {
        code: output.status.code().unwrap(),
        messages: String::from_utf8_lossy(&output.stderr).into_owned(),
        json: serde_json::from_slice(&fs::read(&json_path).unwrap()).unwrap(),
        model: fs::read_to_string(&model).ok(),
    }
}

/// The header, and each row as its cells.
type Cells = (Vec<String>, Vec<Vec<String>>);

/// Poses of a virtual arm whose second joint gives way, each measured once.
static SOUND: LazyLock<Cells> = LazyLock::new(|| {
    let folder = TempDir::new().unwrap();
    let sets = folder.path().join("sets");
    let mut command = Command::cargo_bin("driftpost").unwrap();
    command.arg("synth").arg(&sets);
    command.args(["--effects", "joint_compliance:2", "--n", "80", "--seed", "5"]).assert().success();
    let text = fs::read_to_string(sets.join("set_0000/measurements.csv")).unwrap();
    let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<String>>());
    let header = lines.next().unwrap();
    let mut seen = std::collections::BTreeSet::new();
    (header, lines.filter(|row| seen.insert(row[1].clone())).collect())
});

/// The sound file with its rows changed; `at` finds a column.
fn changed(change: impl Fn(&mut Vec<Vec<String>>, &dyn Fn(&str) -> usize)) -> String {
    let (header, mut rows) = SOUND.clone();
    let at = |name: &str| header.iter().position(|column| column == name).unwrap();
    change(&mut rows, &at);
    let lines = std::iter::once(&header).chain(&rows).map(|row| row.join(",") + "\n");
    lines.collect()
}

/// What is wrong: kind, column and lines.
fn fault(text: &str, arguments: &[&str]) -> (String, String, Vec<u64>) {
    let answer = diagnose(text, arguments);
    assert_eq!(answer.json["verdict"], "data_fault", "{}", answer.json["reason"]);
    let fault = &answer.json["fault"];
    let lines = fault["lines"].as_array().unwrap().iter().map(|line| line.as_u64().unwrap()).collect();
    (fault["kind"].as_str().unwrap().to_owned(), fault["column"].as_str().unwrap().to_owned(), lines)
}

const JOINTS: [&str; 6] = ["q1_deg", "q2_deg", "q3_deg", "q4_deg", "q5_deg", "q6_deg"];

/// Joints `which` with the values of row `from` in the rows behind it, up to `to`.
fn frozen(which: &[&str], from: usize, to: usize) -> String {
    changed(|rows, at| {
        for (k, &name) in (from + 1..to.min(rows.len())).flat_map(|k| which.iter().map(move |name| (k, name)))
        {
            rows[k][at(name)] = rows[from][at(name)].clone();
        }
    })
}

/// Rounded to steps that nobody writes, some of them counted from an angle that is no multiple of the step.
#[test]
fn joints_rounded_to_any_step_are_told_with_it() {
    for (step_deg, offset_deg) in [(0.1, 0.0), (0.1, 0.037), (0.15, 0.0), (0.15, 0.02)] {
        let text = changed(|rows, at| {
            for row in rows.iter_mut() {
                for name in JOINTS {
                    let cell = &mut row[at(name)];
                    let steps = ((cell.parse::<f64>().unwrap() - offset_deg) / step_deg).round();
                    *cell = format!("{:.4}", steps * step_deg + offset_deg);
                }
            }
        });
        let answer = diagnose(&text, &[]);
        assert_eq!(answer.json["fault"]["kind"], "rounded_joints", "{}", answer.json["reason"]);
        let reason = answer.json["reason"].as_str().unwrap();
        assert!(reason.contains(&format!("rounded to {step_deg} deg")), "{reason}");
    }
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    /// A row with an empty cell is answered as if it were not in the file, which says so; it took the whole column with it.
    #[test]
    #[ignore = "long"]
    fn an_empty_cell_costs_its_row_and_not_its_column() {
        let without = diagnose(&changed(|rows, _| drop(rows.pop())), &[]);
        for (column, cell) in [("t_min", ""), ("payload_kg", "NaN"), ("temp_j3_c", "nan"), ("dir2", "")] {
            let text = changed(|rows, at| cell.clone_into(&mut rows.last_mut().unwrap()[at(column)]));
            let line = text.lines().count();
            let mut answer = diagnose(&text, &[]);
            let cold = if column.starts_with("temp") { ", no temperature" } else { "" };
            let warning = format!("{column} is empty{cold} or no number in 1 row: line {line}");
            assert!(answer.messages.contains(&warning), "{}", answer.messages);
            answer.json["warnings"] = without.json["warnings"].clone();
            assert_eq!(answer.json, without.json, "{column}");
        }
    }

    #[test]
    #[ignore = "long"]
    fn a_joint_that_is_never_read_anew_is_named() {
        for joint in ["q6_deg", "q4_deg"] {
            let (kind, column, found) = fault(&frozen(&[joint], 0, usize::MAX), &[]);
            assert_eq!((kind.as_str(), column.as_str()), ("frozen_joints", joint));
            assert_eq!(found.len(), SOUND.1.len());
        }
    }

    /// Held against two fifths of the noise that is in it, no model of a set is one.
    #[test]
    #[ignore = "long"]
    fn a_model_that_leaves_more_than_the_stated_noise_is_none() {
        let text = changed(|_, _| ());
        let own_mm = diagnose(&text, &[]).json["noise"]["model_sigma_mm"].as_f64().unwrap();
        let [held, less] = [own_mm, 0.4 * own_mm]
            .map(|sigma_mm| diagnose(&text, &["--sigma-mm", &format!("{sigma_mm:.5}")]));
        assert!(held.code == 0 && held.model.is_some(), "{}", held.messages);
        assert!(less.code == 2 && less.model.is_none(), "{}", less.messages);
        let why = less.json["no_model"].as_str().unwrap();
        assert!(why.contains("noise as stated leaves") && less.messages.contains(why), "{why}");
    }

    /// A joint that turns by six in a thousand too far: a hundred times a gear's usual error, so that something else is wrong.
    #[test]
    #[ignore = "long"]
    fn a_term_of_any_effect_far_beyond_its_usual_size_is_no_model() {
        let text = changed(|rows, at| {
            for row in rows.iter_mut() {
                let cell = &mut row[at("q1_deg")];
                *cell = format!("{:.6}", cell.parse::<f64>().unwrap() / 1.006);
            }
        });
        let answer = diagnose(&text, &["--sigma-mm", "0.03"]);
        assert!(answer.code == 2 && answer.model.is_none(), "{} {}", answer.json["reason"], answer.messages);
        assert!(answer.messages.contains("times its usual size"), "{}", answer.messages);
    }

    #[test]
    #[ignore = "long"]
    fn joints_that_are_not_read_anew_are_named_with_their_rows() {
        let n = SOUND.1.len();
        let lines = |from: usize, to: usize| (from as u64 + 2..to as u64 + 2).collect::<Vec<u64>>();
        for (from, to) in [(n - 12, n), (30, 36)] {
            let (kind, column, found) = fault(&frozen(&JOINTS, from, to), &[]);
            assert_eq!((kind.as_str(), column.as_str()), ("frozen_joints", "q1_deg to q6_deg"));
            assert_eq!(found, lines(from, to));
        }
        for (joint, from, to) in [("q4_deg", 20, 35), ("q2_deg", 40, n), ("q6_deg", 30, n)] {
            let (kind, column, found) = fault(&frozen(&[joint], from, to), &[]);
            assert_eq!((kind.as_str(), column.as_str()), ("frozen_joints", joint));
            // Where the joint happened to stand near the value that was written the row is not far off.
            assert!(found.len() + 3 >= to - from - 1, "{found:?}");
            assert!(found.iter().all(|line| lines(from + 1, to).contains(line)), "{found:?}");
        }
    }
}
