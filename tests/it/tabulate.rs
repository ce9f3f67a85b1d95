//! `driftpost tabulate` as a user runs it.

use assert_cmd::Command;
use nalgebra::Vector3;
use robot_model::deform::Deformation;
use robot_model::kinematics::Chain;
use robot_model::robot::Robot;
use std::fs;

const CUBE: &str = "fixtures/paper/targets45.csv";

fn tabulate(args: &[&str]) -> std::process::Output {
    Command::cargo_bin("driftpost").unwrap().arg("tabulate").args(args).output().unwrap()
}

/// Exit code and what was said on standard error.
fn refused(args: &[&str]) -> String {
    let output = tabulate(args);
    assert_eq!(output.status.code(), Some(2), "{args:?}");
    assert!(output.stdout.is_empty(), "{args:?}");
    String::from_utf8(output.stderr).unwrap()
}

#[test]
fn the_papers_table_comes_out_of_the_papers_targets() {
    let folder = tempfile::tempdir().unwrap();
    let (csv, json) = (folder.path().join("joints.csv"), folder.path().join("table.json"));
    let output = tabulate(&[CUBE, "--joints-csv", csv.to_str().unwrap(), "--json", json.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let message = String::from_utf8(output.stdout).unwrap();
    assert!(message.starts_with("45 targets x 181 minutes = 8145 rows\n"), "{message}");

    let text = fs::read_to_string(&csv).unwrap();
    let mut lines = text.lines();
    let header =
        "target,file,line,t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,residual_mm";
    assert_eq!(lines.next(), Some(header));
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 8145);

    // The joints as written, put on the deformed arm, stand on the target.
    let robot = Robot::built_in("irb140").unwrap();
    let targets = fs::read_to_string(CUBE).unwrap();
    let targets: Vec<Vec<&str>> = targets.lines().skip(1).map(|line| line.split(',').collect()).collect();
    for (n, row) in rows.iter().enumerate() {
        let target = &targets[n % 45];
        assert_eq!((row[0], row[1], row[2]), (target[0], CUBE, (n % 45 + 2).to_string().as_str()));
        assert_eq!(row[3], (n / 45).to_string());
        let number = |text: &str| text.parse::<f64>().unwrap();
        let q_rad: [f64; 6] = std::array::from_fn(|i| number(row[4 + i]).to_radians());
        let offsets = Deformation::paper().offsets_at(number(row[3]));
        let flange = Chain::with_offsets(&robot, &offsets).forward(&q_rad);
        let wanted_mm = Vector3::new(number(target[1]), number(target[2]), number(target[3]));
        assert!((flange.translation.vector * 1000.0 - wanted_mm).norm() < 1e-9);
        assert!(number(row[13]) <= 1e-9);
    }

    let json: serde_json::Value = serde_json::from_str(&fs::read_to_string(json).unwrap()).unwrap();
    assert_eq!(json["rows"], 8145);
    assert_eq!(json["targets"][18]["confdata"], serde_json::json!([0, 0, -1, 1]));
    assert_eq!(json["minutes"][180]["n"], 45);
    assert!(json["minutes"][180]["after"]["max_mm"].as_f64().unwrap() <= 1e-9);
}

#[test]
fn options_with_a_minus_sign_choose_the_branch_and_the_orientation() {
    let folder = tempfile::tempdir().unwrap();
    let positions = folder.path().join("positions.csv");
    fs::write(&positions, "name,x_mm,y_mm,z_mm\nA,550,-150,550\n").unwrap();
    let positions = positions.to_str().unwrap();
    let run = |confdata: &str| {
        let args =
            [positions, "--orient-deg", "-10,90,0", "--confdata", confdata, "--minutes", "0", "--json", "-"];
        let output = tabulate(&args);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        json["targets"][0]["confdata"].clone()
    };
    assert_eq!(run("-1,-1,0,1"), serde_json::json!([-1, -1, 0, 1]));
    assert_eq!(run("-1,1,-2,0")[3], 0);
    let message = refused(&[positions, "--joints-csv", "-"]);
    assert!(
        message.contains("targets::no-orientation") && message.contains("--orient-deg 0,90,0"),
        "{message}"
    );
    // The paper's targets say for themselves how the flange stands.
    let output = tabulate(&[CUBE, "--orient-deg", "10,20,30", "--minutes", "0", "--joints-csv", "-"]);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success() && message.contains("warning[targets::own-orientation]"), "{message}");
    assert_eq!(output.stdout, tabulate(&[CUBE, "--minutes", "0", "--joints-csv", "-"]).stdout);
}

#[test]
fn the_joints_can_go_to_standard_output() {
    let output = tabulate(&[CUBE, "--minutes", "0,5,37.5", "--growth", "exp:20", "--joints-csv", "-"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(text.lines().count(), 1 + 3 * 45);
    assert!(
        text.lines().nth(136 - 45).unwrap().starts_with("P1,fixtures/paper/targets45.csv,2,37.5,"),
        "{text}"
    );
    assert!(String::from_utf8(output.stderr).unwrap().starts_with("45 targets x 3 minutes = 135 rows\n"));
}

#[test]
fn bad_input_ends_with_2_and_one_message() {
    let table = "fixtures/paper/table2_deformation.csv";
    for (args, expected) in [
        (vec!["missing.csv"], "input::missing"),
        (vec![table], "targets::header"),
        (vec![CUBE, "--deformation", CUBE], "deform::header"),
        (vec![CUBE, "--deformation", table], "deform::no-growth"),
        (vec![CUBE, "--growth", "linear:3"], "deform::growth"),
        (vec![CUBE, "--robot", "irb2400"], "robot::coupled"),
        (vec![CUBE, "--robot", "irb141"], "did you mean `irb140`"),
        (vec![CUBE, "--robot", "irb1200", "--confdata", "0,0,0,7"], "reach::branch"),
        (vec![CUBE, "--minutes", "-5"], "before the cold start"),
        (vec![CUBE, "--confdata", "0,0,1"], "four whole numbers"),
        (vec![CUBE, "--orient-deg", "0,90"], "three angles"),
    ] {
        let message = refused(&args);
        assert!(message.contains(expected), "{args:?}: {message}");
        assert_eq!(message.matches("error").count(), 1, "{message}");
    }
}
