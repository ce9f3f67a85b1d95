//! What `accuracy` makes of rows as shops have them: read in steps, beyond the robot.

use assert_cmd::Command;
use serde_json::Value;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

const JOINTS: &str = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg";

/// What a run of the command came to.
struct Run {
    code: i32,
    out: String,
    err: String,
}

/// Runs `accuracy` on `csv`, a file in `folder`.
fn accuracy(folder: &Path, csv: &str, options: &[&str]) -> Run {
    let path = folder.join("measured.csv");
    fs::write(&path, csv).unwrap();
    let output =
        Command::cargo_bin("driftpost").unwrap().arg("accuracy").arg(path).args(options).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    Run { code: output.status.code().unwrap(), out: text(&output.stdout), err: text(&output.stderr) }
}

/// x off the barycentre by 0.01, 0.01, 0.01 and 0.03 mm: l = 0.015, S = sqrt((3 * 0.005^2 + 0.015^2) / 3) = 0.01, RP = 0.045.
/// Of the two that differ, RP would be 0.02.
#[test]
fn equal_readings_are_cycles_of_their_own() {
    let folder = tempfile::tempdir().unwrap();
    let mut csv = format!("pose_id,{JOINTS},x_mm,y_mm,z_mm\n");
    for x in ["500.00", "500.00", "500.00", "500.04"] {
        writeln!(csv, "A,10,20,5,25,45,-20,{x},100.00,600.00").unwrap();
    }
    let found = accuracy(folder.path(), &csv, &["--limit-rp-mm", "0.0449"]);
    assert!(found.code == 1 && found.out.contains(" 0.0450 "), "{}{}", found.out, found.err);
    assert!(found.err.contains("measure::equal-cycles") && found.err.contains("line 3"), "{}", found.err);
    assert_eq!(accuracy(folder.path(), &csv, &["--limit-rp-mm", "0.0451"]).code, 0);
}

/// Joint 2 of the IRB 140 ends at 110 deg.
#[test]
fn a_go_names_the_poses_that_it_does_not_judge() {
    let folder = tempfile::tempdir().unwrap();
    let mut csv = format!("pose_id,{JOINTS},x_mm,y_mm,z_mm\n");
    for k in 0..20 {
        writeln!(csv, "A,10,20,5,25,45,-20,500.0{},100,600", k % 2).unwrap();
    }
    let judged = accuracy(folder.path(), &csv, &["--limit-rp-mm", "1"]);
    assert!(judged.out.ends_with("\nGO\n"), "{}", judged.out);
    csv += "B,10,112,20,30,40,50,500,100,600\nB,10,112,20,30,40,50,503,100,600\n";
    let json = folder.path().join("a.json").to_string_lossy().into_owned();
    let found = accuracy(folder.path(), &csv, &["--limit-rp-mm", "1", "--json", &json]);
    assert!(found.code == 0 && found.err.contains("measure::joint-range"), "{}", found.err);
    assert!(found.out.ends_with("\nGO; not judged: 2 rows, lines 22, 23\n"), "{}", found.out);
    let read: Value = serde_json::from_slice(&fs::read(&json).unwrap()).unwrap();
    assert_eq!(read["lines_left_out"], serde_json::json!([22, 23]));
}
