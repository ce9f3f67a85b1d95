//! Reports on measurements of real robots, word by word; and models carried from one measurement to another.

use super::model::rows_where;
use assert_cmd::Command;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

/// Numbers may differ by this share: processors round differently.
const SHARE: f64 = 0.02;

fn same(expected: &str, got: &str) -> bool {
    let bare = |word: &str| word.trim_matches(|c: char| ",;:()%".contains(c)).parse::<f64>().ok();
    match (bare(expected), bare(got)) {
        // The last of three printed decimals may move by one.
        (Some(a), Some(b)) => (a - b).abs() <= (SHARE * a.abs()).max(0.0011),
        _ => expected == got,
    }
}

fn report_is_as_expected(folder: &str) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/measurements").join(folder);
    let output = Command::cargo_bin("driftpost")
        .unwrap()
        .arg("diagnose")
        .arg(folder.join("measurements.csv"))
        .arg("--robot")
        .arg(folder.join("robot.toml"))
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let got = String::from_utf8(output.stdout).unwrap();
    let expected = fs::read_to_string(folder.join("expected.txt")).unwrap();
    for (number, (want, line)) in expected.lines().zip(got.lines()).enumerate() {
        let (a, b): (Vec<&str>, Vec<&str>) = (want.split(' ').collect(), line.split(' ').collect());
        let alike = a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| same(a, b));
        assert!(alike, "line {}:\n{want}\n{line}", number + 1);
    }
    assert_eq!(expected.lines().count(), got.lines().count(), "{got}");
}

#[test]
fn fanuc_r2000ic() {
    report_is_as_expected("r2000ic");
}

/// A model found in the measurements of one folder and validated on those of another: base and tool fitted again.
fn carried_over(from: &Path, to: &Path, robot: &Path) -> Value {
    let dir = tempfile::tempdir().unwrap();
    let (model, json) = (dir.path().join("model.toml"), dir.path().join("v.json"));
    let run = |args: &[&Path]| {
        let output = Command::cargo_bin("driftpost").unwrap().args(args).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    };
    let path = Path::new;
    let rows = |folder: &Path| folder.join("measurements.csv");
    run(&[path("diagnose"), &rows(from), path("--robot"), robot, path("--model-out"), &model]);
    let validate = [path("validate"), &rows(to), path("--robot"), robot, path("--model"), &model];
    run(&[&validate[..], &[path("--json"), &json]].concat());
    serde_json::from_slice(&fs::read(json).unwrap()).unwrap()
}

fn rms_mm(part: &Value) -> (f64, f64, u64) {
    let rms = |of: &Value| of["rms_mm"].as_f64().unwrap();
    (rms(part), rms(&part["nominal"]), part["n"].as_u64().unwrap())
}

/// The whole sets: docs/FIELD_RESULTS.md has the figures.
#[test]
#[ignore = "minutes, and 2 GB: run with --release, DRIFTPOST_MEASUREMENTS naming the folder of ur10_ipa_A and ur10_ipa_B"]
fn a_model_of_one_season_holds_in_the_next() {
    let folder = PathBuf::from(std::env::var("DRIFTPOST_MEASUREMENTS").unwrap());
    let robot = folder.join("ur10_ipa_A/robot.toml");
    let found = carried_over(&folder.join("ur10_ipa_A"), &folder.join("ur10_ipa_B"), &robot);
    let (inside, _, _) = rms_mm(&found["inside"]);
    let (outside, outside_nominal, _) = rms_mm(&found["outside"]);
    assert!(inside <= 0.30, "{inside}");
    assert!(outside < outside_nominal, "{outside} of {outside_nominal}");
}

/// A fifth of the rows held out, those whose number times 101 leaves 1 of 5 beyond a prime: four fifths make a model, and it holds there. Beside
/// the causes a gear of joint 2 comes out at eighty times its usual size, which is in no model.
#[test]
#[ignore = "half a minute: run with --release, DRIFTPOST_MEASUREMENTS naming the folder of irb120_faro"]
fn four_fifths_of_an_arms_rows_make_a_model_for_the_last() {
    let folder = PathBuf::from(std::env::var("DRIFTPOST_MEASUREMENTS").unwrap()).join("irb120_faro");
    let csv = fs::read_to_string(folder.join("measurements.csv")).unwrap();
    let dir = tempfile::tempdir().unwrap();
    let part = |name: &str, is_held_out: bool| {
        fs::create_dir(dir.path().join(name)).unwrap();
        let rows = rows_where(&csv, |i| ((i * 101 % 691) % 5 == 1) == is_held_out);
        fs::write(dir.path().join(name).join("measurements.csv"), rows).unwrap();
        dir.path().join(name)
    };
    let found = carried_over(&part("seen", false), &part("unseen", true), &folder.join("robot.toml"));
    let (rms, nominal, n) = rms_mm(&found);
    assert!(n > 130 && rms < 0.083 && nominal > 0.6, "{rms} of {nominal} mm, {n} poses");
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn ur10() {
        report_is_as_expected("ur10");
    }

    /// 139 rows of one season; the same arm four months later in other configurations, most with joint 4 outside of what was seen.
    #[test]
    #[ignore = "long"]
    fn a_model_is_never_worse_than_nominal_where_it_was_not_learned() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/measurements");
        let robot = folder.join("ur10/robot.toml");
        let found = carried_over(&folder.join("ur10_a"), &folder.join("ur10"), &robot);
        let (inside, inside_nominal, n) = rms_mm(&found["inside"]);
        let (outside, outside_nominal, m) = rms_mm(&found["outside"]);
        assert_eq!((n + m, found["n"].as_u64().unwrap()), (80, 80));
        assert!(n > 20 && m > 20, "{n} {m}");
        assert!(outside < 0.5 * outside_nominal, "{outside} of {outside_nominal}");
        assert!(inside < 0.4 * inside_nominal, "{inside} of {inside_nominal}");
    }
}
