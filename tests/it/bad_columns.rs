//! Single columns that nobody should believe: a joint's sign, row, zero or decimals, and stamps in another unit.

use super::sound_file::{as_text, cells, diagnose, fault, fault_with, lines, rewritten, times};
use assert_cmd::Command;
use std::fs;
use tempfile::TempDir;

#[test]
fn joints_read_from_an_encoder_of_few_counts_are_rounded_whatever_their_decimals() {
    let joint = |name: &str| name.starts_with('q');
    for step_deg in [360.0 / 4096.0, 360.0 / 8192.0, 1e-3_f64.to_degrees()] {
        let counted = |cell: &str| {
            let counts = (cell.parse::<f64>().unwrap() / step_deg).round();
            format!("{:.3}", counts * step_deg)
        };
        let (kind, column, _) = fault(&rewritten(joint, counted));
        assert_eq!((kind.as_str(), column.as_str()), ("rounded_joints", "q1_deg to q6_deg"), "{step_deg}");
    }
}

#[test]
fn stamps_that_turn_from_minutes_to_seconds_are_named_with_their_rows() {
    let (names, mut rows) = cells();
    let t_min = names.iter().position(|name| name == "t_min").unwrap();
    for row in &mut rows[20..] {
        row[t_min] = times(60.0)(&row[t_min]);
    }
    let (kind, column, found) = fault(&as_text(&names, &rows));
    assert_eq!((kind.as_str(), column.as_str(), found), ("column_units", "t_min", lines(20, rows.len())));
    // A measurement that is taken up again the next day is none.
    let (names, mut rows) = cells();
    for row in &mut rows[20..] {
        row[t_min] = format!("{:.3}", row[t_min].parse::<f64>().unwrap() + 1440.0);
    }
    assert_ne!(diagnose(as_text(&names, &rows).as_bytes(), &[]).verdict(), "data_fault");
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    /// Rounding follows no gear, though some dozens of its lines follow it as closely as one likes.
    #[test]
    #[ignore = "long"]
    fn one_column_of_few_decimals_is_named_among_others_of_many() {
        for name in ["q1_deg", "q2_deg", "q3_deg"] {
            let rounded = |cell: &str| format!("{:.1}", cell.parse::<f64>().unwrap());
            let (kind, column, _) = fault(&rewritten(|column| column == name, rounded));
            assert_eq!((kind.as_str(), column.as_str()), ("rounded_joints", name));
        }
    }

    #[test]
    #[ignore = "long"]
    fn a_zero_that_jumps_by_degrees_is_a_step_and_nothing_else() {
        let (names, rows) = cells();
        let at = |name: &str| names.iter().position(|n| n == name).unwrap();
        let jumped = |name: &str, by_deg: f64| {
            let mut rows = rows.clone();
            // Each row a pose of its own: what is written of the joints is what changes here, not where the arm stands.
            rows.iter_mut().enumerate().for_each(|(k, row)| row[at("pose_id")] = k.to_string());
            for row in &mut rows[30..] {
                row[at(name)] = format!("{:.6}", row[at(name)].parse::<f64>().unwrap() + by_deg);
            }
            as_text(&names, &rows)
        };
        for (name, by_deg) in [("q2_deg", 0.5), ("q3_deg", 1.0), ("q3_deg", 2.0)] {
            let answer = diagnose(jumped(name, by_deg).as_bytes(), &["--sigma-mm", "0.02"]);
            let causes = answer.json.as_ref().unwrap()["causes"].as_array().unwrap();
            let certain: Vec<&str> = causes
                .iter()
                .filter(|cause| cause["posterior"].as_f64().unwrap() > 0.5)
                .map(|cause| cause["effect"].as_str().unwrap())
                .collect();
            assert_eq!(certain, ["joint_step", "joint_compliance"], "{name} {by_deg}: {}", answer.text);
            let size_deg = causes[0]["size"].as_f64().unwrap().to_degrees();
            assert!((size_deg - by_deg).abs() < 0.02 * by_deg, "{name}: {size_deg}, not {by_deg}");
        }
        let (kind, column, found) = fault(&jumped("q6_deg", 90.0));
        assert_eq!((kind.as_str(), column.as_str()), ("joint_columns", "q6_deg"));
        assert!(
            found.iter().all(|line| lines(30, rows.len()).contains(line)) && found.len() > 25,
            "{found:?}"
        );
    }

    #[test]
    #[ignore = "long"]
    fn a_joint_column_that_changes_its_sign_or_is_a_row_late_is_named_with_its_rows() {
        let (names, rows) = cells();
        let n = rows.len();
        let at = |name: &str| names.iter().position(|n| n == name).unwrap();
        // Joint 3 leaves its range so, which is not what is wrong.
        for name in ["q1_deg", "q3_deg", "q5_deg"] {
            let mut negated = rows.clone();
            for row in &mut negated[24..] {
                row[at(name)] = times(-1.0)(&row[at(name)]);
            }
            let (kind, column, found) = fault(&as_text(&names, &negated));
            assert_eq!((kind.as_str(), column.as_str()), ("joint_columns", name));
            assert!(found.iter().all(|line| lines(24, n).contains(line)) && found.len() > 30, "{found:?}");
        }
        // The last row stays: nothing tells its joint.
        for (name, from) in [("q2_deg", 30), ("q5_deg", 1)] {
            let mut late = rows.clone();
            for k in from..n {
                late[k][at(name)].clone_from(&rows[k - 1][at(name)]);
            }
            let (kind, column, found) = fault(&as_text(&names, &late));
            assert_eq!((kind.as_str(), column.as_str()), ("rows_shifted", name));
            assert!(found.iter().all(|line| lines(from, n).contains(line)), "{found:?}");
        }
    }

    /// The poses of a set of rounded joints three times, in rounds: each time they are rounded the same way, and what many lines of gears follow
    /// is still that.
    #[test]
    #[ignore = "long"]
    fn rounded_joints_are_named_where_poses_come_back() {
        let folder = TempDir::new().unwrap();
        let sets = folder.path().join("sets");
        let mut command = Command::cargo_bin("driftpost").unwrap();
        command.arg("synth").arg(&sets);
        command
            .args(["--effects", "joint_rounding", "--n", "27", "--sets", "3", "--seed", "4"])
            .assert()
            .success();
        for set in 0..3 {
            let text = fs::read_to_string(sets.join(format!("set_{set:04}/measurements.csv"))).unwrap();
            let (header, rows) = text.split_once('\n').unwrap();
            let names: Vec<&str> = header.split(',').collect();
            let at = |name: &str| names.iter().position(|n| *n == name).unwrap();
            let mut rounds = format!("{header}\n");
            for (k, line) in std::iter::repeat_n(rows.lines(), 3).flatten().enumerate() {
                let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
                cells[at("id")] = k.to_string();
                cells[at("t_min")] = format!("{k}");
                for (axis, name) in ["x_mm", "y_mm", "z_mm"].into_iter().enumerate() {
                    let even =
                        2.0 * ((k as f64 + 1.0).powi(2) * [2.0_f64, 3.0, 5.0][axis].sqrt()).fract() - 1.0;
                    cells[at(name)] = format!("{:.4}", cells[at(name)].parse::<f64>().unwrap() + 0.02 * even);
                }
                rounds += &(cells.join(",") + "\n");
            }
            let (kind, column, _) = fault_with(&rounds, &["--sigma-mm", "0.02"]);
            assert_eq!((kind.as_str(), column.as_str()), ("rounded_joints", "q1_deg to q6_deg"), "set {set}");
        }
    }
}
