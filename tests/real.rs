//! Reports on measurements of real robots, word by word.

#![allow(clippy::unwrap_used, missing_docs)]

use assert_cmd::Command;
use std::fs;
use std::path::Path;

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

#[test]
fn ur10() {
    report_is_as_expected("ur10");
}
