//! What `accuracy` makes of rows as shops have them: read in steps, out of order, over midnight, beyond the robot, of several reflectors.

use assert_cmd::Command;
use measurements::{ColumnMap, Measurements};
use nalgebra::Point3;
use robot_model::kinematics::Chain;
use robot_model::robot::Robot;
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

/// Where the nominal arm puts a tool, mm.
fn command_mm(q_deg: [f64; 6], tool_mm: [f64; 3]) -> [f64; 3] {
    let chain = Chain::nominal(&Robot::built_in("irb140").unwrap());
    let [x, y, z] = tool_mm.map(|mm| 1e-3 * mm);
    ((chain.forward(&q_deg.map(f64::to_radians)) * Point3::new(x, y, z)).coords * 1e3).into()
}

fn joints(q_deg: [f64; 6]) -> String {
    q_deg.map(|q| q.to_string()).join(",")
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

#[test]
fn a_tool_that_is_fitted_anyway_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let mut csv = format!("{JOINTS},x_mm,y_mm,z_mm\n");
    for k in 0..8 {
        let q_deg = [10.0 * f64::from(k), 5.0, -4.0 * f64::from(k), 20.0 - 9.0 * f64::from(k), 40.0, 6.0];
        let [x, y, z] = command_mm(q_deg, [10.0, 20.0, 150.0]);
        writeln!(csv, "{},{x},{y},{z}", joints(q_deg)).unwrap();
    }
    let idle = |options: &[&str]| {
        accuracy(folder.path(), &csv, options).err.contains("option::idle]: --tool changes nothing")
    };
    assert!(idle(&["--tool", "10,20,150"]));
    assert!(!idle(&["--tool", "10,20,150", "--register", "base"]) && !idle(&[]));
}

/// Eight poses, 9 numbers of 24 fitted: the root of 15/24 is left, 21 % less. Three nests beside them are no poses (9 of 33 would be 15 %), read
/// twice to the last digit they are no cycles, and need no pose_id; each pose's AP is as without them.
#[test]
fn nests_on_the_base_are_no_poses() {
    let folder = tempfile::tempdir().unwrap();
    let mut poses = format!("pose_id,{JOINTS},x_mm,y_mm,z_mm,kind,fixed_id\n");
    for k in 0..8 {
        let of = |step: f64, wide: f64| wide * (2.0 * (0.5 + f64::from(k) * step).fract() - 1.0);
        let q_deg = [
            of(0.62, 100.0),
            of(0.75, 40.0),
            of(0.57, 40.0),
            of(0.41, 120.0),
            of(0.73, 80.0),
            of(0.24, 150.0),
        ];
        let [x, y, z] = command_mm(q_deg, [0.0, 0.0, 80.0]);
        let off_mm = 0.1 * f64::from(k % 3);
        writeln!(poses, "P{k},{},{:.6},{y:.6},{z:.6},pose,", joints(q_deg), x + off_mm).unwrap();
    }
    let mut nests = poses.clone();
    for (name, at) in [("N1", "900,700,-300"), ("N2", "-800,900,-300"), ("N3", "100,-900,-310")] {
        nests += &format!(",,,,,,,{at},base,{name}\n").repeat(2);
        writeln!(nests, ",,,,,,,{at}.4,base,{name}").unwrap();
    }
    let [without, with] = [&poses, &nests]
        .map(|csv| accuracy(folder.path(), csv, &["--tool", "0,0,80", "--register", "base,tool"]));
    assert!(
        with.err.contains("fitted to the 24 of 8 poses") && with.err.contains("some 21 %"),
        "{}",
        with.err
    );
    assert!(!with.err.contains("equal-cycles") && !with.err.contains("pose_id"), "{}", with.err);
    assert_eq!((with.code, with.out), (without.code, without.out));
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

/// AP is 0.1 mm at minute 0, 0.2 at 30, 0.4 at 60: dAP = 0.3 in whatever order the rows are.
#[test]
fn drift_is_the_same_in_any_order_of_the_rows() {
    let folder = tempfile::tempdir().unwrap();
    let mut rows = Vec::new();
    for (off_mm, t_min) in [(0.1, 0), (0.2, 30), (0.4, 60)] {
        for (pose, q1_deg) in [(0, 10.0), (1, -40.0), (2, 80.0)] {
            let q_deg = [q1_deg, 20.0, -10.0, 30.0, 40.0, 50.0];
            let [x, y, z] = command_mm(q_deg, [0.0, 0.0, 80.0]);
            for again in 0..3 {
                let minute = t_min + 3 * pose + again;
                rows.push(format!("{pose},{minute},{},{:.6},{y:.6},{z:.6}", joints(q_deg), x + off_mm));
            }
        }
    }
    let options = ["--tool", "0,0,80", "--register", "none", "--limit-drift-mm", "0.2999", "--json", "-"];
    let drift_mm = |order: &dyn Fn(usize) -> usize| {
        let rows: Vec<&str> = (0..27).map(|k| rows[order(k)].as_str()).collect();
        let csv = format!("pose_id,t_min,{JOINTS},x_mm,y_mm,z_mm\n{}\n", rows.join("\n"));
        let found = accuracy(folder.path(), &csv, &options);
        let read: Value = serde_json::from_str(&found.out).unwrap();
        let of_poses: Vec<f64> =
            (0..3).map(|pose| read["poses"][pose]["drift_ap_mm"].as_f64().unwrap()).collect();
        assert!(of_poses.iter().all(|mm| (mm - 0.3).abs() < 1e-5), "{of_poses:?}");
        assert_eq!(found.code, 1, "{}", found.err);
        found.err.contains("measure::time-order")
    };
    let warned = [drift_mm(&|k| k), drift_mm(&|k| 26 - k), drift_mm(&|k| 7 * k % 27)];
    assert_eq!(warned, [false, true, true]);
}

#[test]
fn times_of_day_go_on_over_midnight() {
    let mut text = format!("time,{JOINTS},x_mm,y_mm,z_mm\n");
    for time in ["23:30:00", "23:50:00", "00:10:30", "00:30:00"] {
        writeln!(text, "{time},10,20,5,25,45,-20,500,100,600").unwrap();
    }
    let columns = JOINTS.split(',').chain(["x_mm", "y_mm", "z_mm"]);
    let columns: String = columns.map(|name| format!("{name} = \"{name}\"\n")).collect();
    let map = format!("time_format = \"hh:mm:ss\"\n[columns]\nt_min = \"time\"\n{columns}");
    let table = ColumnMap::from_toml(&map).unwrap().table(text.as_bytes()).unwrap();
    let minutes: Vec<f64> =
        Measurements::from_table(&table).unwrap().rows.iter().map(|row| row.t_min.unwrap()).collect();
    assert_eq!(minutes, [0.0, 20.0, 40.5, 60.0]);
}

/// A second reflector 60 mm beside the tool is no error of the robot.
#[test]
fn one_place_on_the_flange_is_not_that_of_several_reflectors() {
    let folder = tempfile::tempdir().unwrap();
    let mut csv = format!("pose_id,target,{JOINTS},x_mm,y_mm,z_mm\n");
    for k in 0..12 {
        let at = |step: f64| (f64::from(k) * step).fract() - 0.5;
        let q_deg = [
            180.0 * at(0.618),
            80.0 * at(0.755),
            60.0 * at(0.57) - 20.0,
            200.0 * at(0.414),
            60.0,
            100.0 * at(0.236),
        ];
        for (target, tool_mm) in [("A", [0.0, 0.0, 100.0]), ("B", [60.0, 0.0, 100.0])] {
            let [x, y, z] = command_mm(q_deg, tool_mm);
            writeln!(csv, "{k},{target},{},{x:.5},{y:.5},{z:.5}", joints(q_deg)).unwrap();
        }
    }
    for register in ["base", "none"] {
        let options = ["--tool", "0,0,100", "--register", register, "--limit-ap-mm", "0.1"];
        let found = accuracy(folder.path(), &csv, &options);
        assert!(found.code == 2 && found.err.contains("measure::several-targets"), "{}", found.err);
        assert!(found.err.contains("2 targets (A, B)"), "{}", found.err);
        let of_one: String =
            csv.lines().filter(|line| !line.contains(",B,")).map(|line| format!("{line}\n")).collect();
        assert_eq!(accuracy(folder.path(), &of_one, &options).code, 0);
    }
    let found = accuracy(folder.path(), &csv, &["--limit-ap-mm", "0.001"]);
    assert_eq!(found.code, 0, "each place is fitted: {}{}", found.out, found.err);
}

/// Five poses, ten cycles each, of the nominal arm with a few micrometres of scatter; `change` alters a row's joints and point, degrees and mm.
fn cycles(change: impl Fn(usize, &mut [f64; 6], &mut [f64; 3])) -> String {
    let poses = [
        [10.0, 20.0, -10.0, 15.0, 40.0, 20.0],
        [-35.0, 40.0, -30.0, -50.0, 60.0, 90.0],
        [55.0, -10.0, 20.0, 70.0, -45.0, -30.0],
        [-70.0, 30.0, 5.0, -20.0, 80.0, 10.0],
        [25.0, 5.0, -40.0, 100.0, 30.0, -80.0],
    ];
    let mut csv = format!("pose_id,{JOINTS},x_mm,y_mm,z_mm\n");
    for cycle in 0..10 {
        for (k, pose) in poses.iter().enumerate() {
            let (mut q_deg, mut point_mm) = (*pose, command_mm(*pose, [20.0, 10.0, 100.0]));
            point_mm[cycle % 3] += 0.004 * ((cycle * 7 + k * 3) % 5) as f64;
            change(5 * cycle + k, &mut q_deg, &mut point_mm);
            let [x, y, z] = point_mm;
            writeln!(csv, "P{k},{},{x:.5},{y:.5},{z:.5}", joints(q_deg)).unwrap();
        }
    }
    csv
}

#[test]
fn a_reading_that_no_arm_made_is_named_by_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let csv = cycles(|row, _, point| {
        if row == 21 {
            point[2] += 28.0;
        }
    });
    let found = accuracy(folder.path(), &csv, &["--limit-rp-mm", "0.05"]);
    assert_eq!(found.code, 1);
    assert!(
        found.err.contains("measure::far-cycle") && found.err.contains("line 23: up to 28.0 mm"),
        "{}",
        found.err
    );
    // Of three cycles two agree, and say so of a third that is centimetres beside them; of two nobody knows which.
    let second_far = cycles(|row, _, point| point[2] += if row == 6 { 28.0 } else { 0.0 });
    let of_first = |count: usize| {
        let text: String = second_far.lines().take(1 + 5 * count).map(|line| format!("{line}\n")).collect();
        accuracy(folder.path(), &text, &[]).err
    };
    assert!(of_first(3).contains("measure::far-cycle"), "{}", of_first(3));
    assert!(!of_first(2).contains("measure::far-cycle"), "{}", of_first(2));
}

#[test]
fn few_poses_are_told_to_fit_less_than_they_do() {
    let folder = tempfile::tempdir().unwrap();
    let help = |options: &[&str]| {
        let err = accuracy(folder.path(), &cycles(|_, _, _| {}), options).err;
        let few = err.split_once("measure::few-poses").expect(&err).1;
        few.lines().find(|line| line.contains("help:")).expect(&err).to_owned()
    };
    assert!(help(&[]).contains("(--register base, or none)"));
    let of_base = help(&["--register", "base", "--tool", "20,10,100"]);
    assert!(of_base.contains("--register none") && !of_base.contains("--register base"), "{of_base}");
}

/// Joints all over the middle of their ranges, by the powers of the golden section; the same written with some decimals.
fn one_each(decimals: usize) -> String {
    let mut csv = format!("pose_id,{JOINTS},x_mm,y_mm,z_mm\n");
    for k in 0..60 {
        let q_deg: [f64; 6] = std::array::from_fn(|j| {
            let part = ((f64::from(k) + 1.0) * 0.618_034_f64.powi(j as i32 + 1)).fract();
            [85.0, 45.0, 40.0, 90.0, 60.0, 110.0][j] * (2.0 * part - 1.0) + if j == 4 { 15.0 } else { 0.0 }
        });
        let [x, y, z] = command_mm(q_deg, [20.0, 10.0, 100.0]);
        let written = q_deg.map(|q| format!("{q:.decimals$}")).join(",");
        writeln!(csv, "P{k},{written},{x:.4},{y:.4},{z:.4}").unwrap();
    }
    csv
}

#[test]
fn joints_with_too_few_decimals_are_named_beside_the_accuracy_that_they_make() {
    let folder = tempfile::tempdir().unwrap();
    let coarse = accuracy(folder.path(), &one_each(1), &[]).err;
    assert!(
        coarse.contains("measure::rounded")
            && coarse.contains("rounded to 0.1 deg, which moves the points by"),
        "{coarse}"
    );
    assert!(!accuracy(folder.path(), &one_each(4), &[]).err.contains("measure::rounded"));
    // Poses that were commanded in whole degrees are what the file says.
    assert!(!accuracy(folder.path(), &cycles(|_, _, _| {}), &[]).err.contains("measure::rounded"));
}

/// The zero of joint 3 half a degree off: the five poses lie 0.5 % nearer to each other by it than the arm says.
#[test]
fn a_zero_that_is_off_is_no_scale_of_an_instrument_in_few_poses() {
    let folder = tempfile::tempdir().unwrap();
    let poses = [
        [-19.07, 0.89, 18.85, -73.46, 58.01, 54.85],
        [-24.97, -16.14, -13.50, 28.34, 54.98, -83.99],
        [-5.39, 26.85, -4.63, 23.97, 87.39, 43.94],
        [-8.67, -6.89, -9.24, 1.99, 81.30, 66.14],
        [-14.55, 44.70, -1.75, 34.88, 18.58, -94.91],
    ];
    let mut csv = format!("pose_id,{JOINTS},x_mm,y_mm,z_mm\n");
    for (k, q_deg) in poses.into_iter().enumerate() {
        let [q1, q2, q3, q4, q5, q6] = q_deg;
        let [x, y, z] = command_mm([q1, q2, q3 + 0.5, q4, q5, q6], [60.0, 40.0, 100.0]);
        writeln!(csv, "P{k},{},{x:.4},{y:.4},{z:.4}", joints(q_deg)).unwrap();
    }
    let found = accuracy(folder.path(), &csv, &["--limit-ap-mm", "0.05"]);
    assert!(found.code == 1 && found.out.contains("NO GO"), "{}{}", found.out, found.err);
}

/// The rows of the first cycle, and those of P0 in `more` later ones.
fn once_and_first_again(more: usize) -> String {
    let csv = cycles(|_, _, _| ());
    let again = csv.lines().skip(6).filter(|line| line.starts_with("P0,")).take(more);
    csv.lines().take(6).chain(again).map(|line| format!("{line}\n")).collect()
}

/// Of five poses one is measured three times: its RP says nothing of the others.
#[test]
fn a_limit_that_few_poses_tell_is_neither_kept_nor_exceeded() {
    let folder = tempfile::tempdir().unwrap();
    let as_measured = ["--tool", "20,10,100", "--register", "none"];
    let judged = |csv: &str, limits: &[&str]| accuracy(folder.path(), csv, &[&as_measured, limits].concat());
    let csv = once_and_first_again(2);
    let found = judged(&csv, &["--limit-rp-mm", "0.5", "--limit-ap-mm", "0.5"]);
    let expected = "\nNOT JUDGED: too few poses for --limit-rp-mm 0.5 (1 of 5 poses measured three times and more, 5 are needed)\n";
    assert!(found.code == 2 && found.out.ends_with(expected), "{}", found.out);
    let found = judged(&csv, &["--limit-rp-mm", "0.5", "--limit-ap-mm", "0.000001"]);
    assert!(
        found.code == 1 && found.out.contains("NO GO: beyond --limit-ap-mm 0.000001; too few"),
        "{}",
        found.out
    );
    let found = judged(&csv, &["--limit-rp-mm", "0.000001"]);
    assert!(
        found.code == 1 && found.out.ends_with("NO GO: beyond --limit-rp-mm 0.000001\n"),
        "{}",
        found.out
    );
    let found = judged(&csv, &["--limit-rp-mm", "0.5", "--json", "-"]);
    let read: Value = serde_json::from_str(&found.out).unwrap();
    assert_eq!((found.code, &read["within"]), (2, &Value::Null), "{read}");
    assert_eq!(read["limits"][0]["verdict"], "not_judged", "{read}");
    assert_eq!(
        (&read["limits"][0]["poses"], &read["limits"][0]["poses_needed"]),
        (&1.into(), &5.into()),
        "{read}"
    );
    // Two points are equally far from their middle: no scatter is seen.
    let all_twice: String = cycles(|_, _, _| ()).lines().take(11).map(|line| format!("{line}\n")).collect();
    let found = judged(&all_twice, &["--limit-rp-mm", "0.5"]);
    assert!(found.code == 2 && found.out.contains("(0 of 5 poses measured three times"), "{}", found.out);
    let all: String = cycles(|_, _, _| ());
    assert_eq!(judged(&all, &["--limit-rp-mm", "0.5", "--limit-ap-mm", "0.5"]).code, 0);
}

/// Five reflectors at each of five poses; at the first pose one of them, or all, are read three times: one commanded pose of five.
#[test]
fn reflectors_of_one_pose_are_one_pose_of_a_limit() {
    let folder = tempfile::tempdir().unwrap();
    let tools_mm = [
        [20.0, 10.0, 100.0],
        [60.0, -40.0, 80.0],
        [-50.0, 30.0, 120.0],
        [10.0, 70.0, 90.0],
        [-20.0, -60.0, 110.0],
    ];
    let of_one = |tool_mm| {
        cycles(|row, q_deg, point_mm| {
            *point_mm = command_mm(*q_deg, tool_mm);
            point_mm[row % 3] += 0.004 * (row * 7 % 5) as f64;
        })
    };
    let files = tools_mm.map(of_one);
    let judged = |is_read: &dyn Fn(usize, usize) -> bool| {
        let mut csv = format!("target,{}\n", files[0].lines().next().unwrap());
        for row in 0..50 {
            for (k, file) in files.iter().enumerate().filter(|(k, _)| is_read(row, *k)) {
                writeln!(csv, "R{k},{}", file.lines().nth(row + 1).unwrap()).unwrap();
            }
        }
        accuracy(folder.path(), &csv, &["--limit-rp-mm", "0.5"])
    };
    for reflectors in [1, 5] {
        let found = judged(&|row, k| row < 5 || [5, 10].contains(&row) && k < reflectors);
        let expected = "(1 of 5 poses measured three times and more, 5 are needed)";
        assert!(found.code == 2 && found.out.contains(expected), "{}{}", found.out, found.err);
    }
    let found = judged(&|_, _| true);
    assert!(found.code == 0 && found.out.ends_with("\nGO\n"), "{}{}", found.out, found.err);
}

#[test]
fn a_drift_limit_that_one_pose_tells_is_not_judged() {
    let folder = tempfile::tempdir().unwrap();
    let csv: String = once_and_first_again(1)
        .lines()
        .enumerate()
        .map(|(k, line)| match k {
            0 => format!("t_min,{line}\n"),
            6 => format!("30,{line}\n"),
            _ => format!("0,{line}\n"),
        })
        .collect();
    let options = ["--tool", "20,10,100", "--register", "none", "--limit-drift-mm", "0.5"];
    let found = accuracy(folder.path(), &csv, &options);
    assert!(
        found.code == 2 && found.out.contains("(1 of 5 poses measured at times more than 10 min"),
        "{}",
        found.out
    );
}

#[test]
fn without_a_limit_there_is_no_go_and_poses_have_their_names() {
    let folder = tempfile::tempdir().unwrap();
    let csv = cycles(|_, _, _| ());
    let found = accuracy(folder.path(), &csv, &["--register", "none", "--tool", "20,10,100"]);
    assert!(found.code == 0 && !found.out.contains("GO") && found.out.contains(" P3 "), "{}", found.out);
    let found = accuracy(folder.path(), &csv, &["--register", "none", "--tool", "20,10,100", "--json", "-"]);
    let read: Value = serde_json::from_str(&found.out).unwrap();
    assert_eq!(
        (&read["within"], &read["verdict"], &read["limits"]),
        (&Value::Null, &Value::Null, &serde_json::json!([]))
    );
    assert_eq!((&read["poses"][3]["pose_id"], &read["poses"][3]["id"]), (&"P3".into(), &Value::Null));
    let numbered: String = csv
        .lines()
        .enumerate()
        .map(|(k, line)| if k == 0 { format!("id,{line}\n") } else { format!("row{k},{line}\n") })
        .collect();
    let found =
        accuracy(folder.path(), &numbered, &["--register", "none", "--tool", "20,10,100", "--json", "-"]);
    let read: Value = serde_json::from_str(&found.out).unwrap();
    assert_eq!((&read["poses"][3]["pose_id"], &read["poses"][3]["id"]), (&"P3".into(), &"row4".into()));
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    /// Points in metres repeat a thousand times better than they do.
    #[test]
    #[ignore = "long"]
    fn a_file_in_other_units_or_columns_is_no_go_and_no_no_go() {
        let folder = tempfile::tempdir().unwrap();
        let limits = ["--limit-rp-mm", "0.05"];
        let sound = accuracy(folder.path(), &cycles(|_, _, _| {}), &limits);
        assert!(sound.code == 0 && sound.out.ends_with("\nGO\n"), "{}{}", sound.out, sound.err);
        type Change = fn(usize, &mut [f64; 6], &mut [f64; 3]);
        let faults: [(Change, &str); 4] = [
            (|_, _, point| point.iter_mut().for_each(|mm| *mm *= 1e-3), "the measured points are in metres"),
            (|_, q, _| q[2] = q[2].to_radians(), "column q3_deg is in radians"),
            (|_, q, _| q.swap(3, 4), "the columns of joints 4 and 5 are swapped"),
            (|_, _, point| point.swap(0, 1), "mirrored"),
        ];
        for (change, reason) in faults {
            let found = accuracy(folder.path(), &cycles(change), &limits);
            assert!(found.code == 2 && found.err.contains("measure::fault"), "{reason}: {}", found.out);
            assert!(found.err.contains(reason), "{reason}: {}", found.err);
        }
    }
}
