//! What two files of one arm do not have in common, and what else would explain that they differ.

use super::{TIP_M, file, robot_under_test, run, somewhere, with_points, write};
use exam::effect::Effect;
use nalgebra::{Isometry3, Vector3};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// Exit code and all that is printed of the comparison of two files.
fn compared(folder: &Path, before: &str, after: &str) -> (i32, String) {
    let (before, after) = (write(folder, "before.csv", before), write(folder, "after.csv", after));
    let json = folder.join("c.json").to_string_lossy().into_owned();
    let (code, out, answer) =
        run(&["compare-measurements", &before, &after, "--sigma-mm", "0.02", "--json", &json]);
    (code, out + &answer)
}

fn measured(effects: &[(Effect, f64)], tip_m: Vector3<f64>, seed: u64) -> String {
    file(&robot_under_test(effects), &somewhere(), tip_m, seed)
}

/// The file with a column of its own, the same in every row.
fn with_column(text: &str, name: &str, cell: &str) -> String {
    let more =
        text.lines().enumerate().map(|(k, line)| format!("{line},{}\n", if k == 0 { name } else { cell }));
    more.collect()
}

fn joints_moved(text: &str, by_deg: f64) -> String {
    let moved = text.lines().enumerate().map(|(k, line)| {
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        if k > 0 {
            cells[2] = format!("{:.6}", cells[2].parse::<f64>().unwrap() + by_deg);
        }
        cells.join(",") + "\n"
    });
    moved.collect()
}

#[test]
fn one_file_given_twice_and_columns_of_one_file_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let tip = Vector3::from(TIP_M);
    let [before, after] = [1, 2].map(|seed| measured(&[], tip, seed));
    let (code, answer) = compared(folder.path(), &before, &before);
    assert!(code == 0 && answer.contains("changed::same-readings"), "{answer}");
    // A row that was struck out of a copy is no change of the arm.
    let whole = fs::read_to_string("fixtures/docs/before.csv").unwrap();
    let struck: String =
        whole.lines().enumerate().filter(|(k, _)| *k != 7).map(|(_, line)| format!("{line}\n")).collect();
    let (code, answer) = compared(folder.path(), &whole, &struck);
    assert!(code == 0 && answer.contains("changed::same-readings"), "{answer}");
    let (code, answer) = compared(folder.path(), &before, &after);
    assert!(code == 0 && !answer.contains("changed::"), "{answer}");
    let (_, answer) = compared(folder.path(), &with_column(&before, "payload_kg", "3"), &after);
    assert!(answer.contains("changed::columns") && answer.contains("(payload_kg before alone)"), "{answer}");
}

/// The zero of joint 6, 2 mrad off, turns a target that is 67 mm off its axis by 0.134 mm.
#[test]
fn a_zero_of_the_last_axis_is_as_likely_as_a_target_that_turned() {
    let folder = tempfile::tempdir().unwrap();
    let tip = Vector3::from(TIP_M);
    let before = measured(&[], tip, 1);
    let (code, answer) =
        compared(folder.path(), &before, &measured(&[(Effect::JointOffset { joint: 6 }, 2e-3)], tip, 2));
    let turned: f64 = answer
        .split("zero of axis 6 has by ")
        .nth(1)
        .expect(&answer)
        .split(' ')
        .next()
        .unwrap()
        .parse()
        .unwrap();
    // 2 mrad are 0.1146 degrees.
    assert!(code == 1 && (turned.abs() - 0.1146).abs() < 0.012, "{answer}");
    // Along the axis no zero moves it.
    let (code, answer) =
        compared(folder.path(), &before, &measured(&[], tip + Vector3::new(0.0, 0.0, 3e-4), 2));
    assert!(code == 1 && !answer.contains("changed::last-zero"), "{answer}");
}

#[test]
fn a_shift_of_the_base_has_an_interval_that_holds_it() {
    let folder = tempfile::tempdir().unwrap();
    let tip = Vector3::from(TIP_M);
    let shift = Isometry3::new(Vector3::new(3e-4, -2e-4, 1e-4), Vector3::new(0.0, 2e-4, 0.0));
    let before = measured(&[], tip, 1);
    let after = file(&robot_under_test(&[]), &(somewhere() * shift), tip, 2);
    let (_, answer) = compared(folder.path(), &before, &after);
    let read: Value = serde_json::from_slice(&fs::read(folder.path().join("c.json")).unwrap()).unwrap();
    for (axis, true_mm) in [0.3, -0.2, 0.1].into_iter().enumerate() {
        let [by_mm, sigma_mm] = ["by_mm", "sigma_mm"].map(|key| read["base"][key][axis].as_f64().unwrap());
        assert!(
            (by_mm - true_mm).abs() < 4.0 * sigma_mm && (0.002..0.05).contains(&sigma_mm),
            "{axis}: {answer}"
        );
    }
    assert!(answer.contains(" mm (+- "), "{answer}");
}

#[test]
fn what_is_wrong_in_one_file_is_no_matter_of_the_poses() {
    let folder = tempfile::tempdir().unwrap();
    let sound = measured(&[], Vector3::from(TIP_M), 1);
    let in_m = with_points(&sound, |_, point_mm| point_mm.iter_mut().for_each(|mm| *mm *= 1e-3));
    let (code, answer) = compared(folder.path(), &sound, &in_m);
    assert!(code == 2 && answer.contains("measure::fault") && answer.contains("in metres"), "{answer}");
    assert!(!answer.contains("measure the same poses"), "{answer}");
}

#[test]
fn what_sags_may_be_a_load_that_one_file_does_not_tell() {
    let folder = tempfile::tempdir().unwrap();
    let tip = Vector3::from(TIP_M);
    let sags = measured(&[(Effect::JointCompliance { joint: 2 }, 8e-6)], tip, 2);
    let (code, answer) = compared(folder.path(), &measured(&[], tip, 1), &sags);
    assert!(code == 1 && answer.contains("changed::load"), "{answer}");
}

/// Two reflectors before, one after: the other is compared with nothing.
#[test]
fn a_target_of_one_file_alone_has_not_moved() {
    let folder = tempfile::tempdir().unwrap();
    let tip = Vector3::from(TIP_M);
    let far = tip + Vector3::new(0.08, -0.05, 0.02);
    let a = |seed| with_column(&measured(&[], tip, seed), "target", "A");
    let b = with_column(&measured(&[], far, 3), "target", "B");
    let both = a(1) + &b.lines().skip(1).map(|line| format!("{line}\n")).collect::<String>();
    for [before, after] in [[both.clone(), a(2)], [a(2), both]] {
        let (code, answer) = compared(folder.path(), &before, &after);
        assert!(code == 0 && answer.contains("target 1 (A)") && !answer.contains("target 2"), "{answer}");
    }
}

/// Joints that encoders read are never twice the same: 0.01 deg at 0.7 m are 0.12 mm, by which no point has moved.
#[test]
fn joints_as_encoders_read_them_move_no_point() {
    let folder = tempfile::tempdir().unwrap();
    let tip = Vector3::from(TIP_M);
    let off_deg = |k: usize, j: usize| 0.005 * ((k * 7 + 3 * j) % 5) as f64 - 0.01;
    let robot = robot_under_test(&[]);
    let text = file(&robot, &somewhere(), tip, 2);
    // The same poses a little beside, each point where its own joints put it.
    let moved = text.lines().enumerate().map(|(k, line)| {
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        if k > 0 {
            let q_deg: [f64; 6] = std::array::from_fn(|j| cells[1 + j].parse::<f64>().unwrap());
            let beside: [f64; 6] = std::array::from_fn(|j| q_deg[j] + off_deg(k, j));
            let hand = |q_deg: [f64; 6]| {
                robot_model::kinematics::Chain::nominal(
                    &robot_model::robot::Robot::built_in("irb140").unwrap(),
                )
                .forward(&q_deg.map(f64::to_radians))
                    * nalgebra::Point3::from(tip)
            };
            let by = somewhere() * (hand(beside) - hand(q_deg));
            (0..6).for_each(|j| cells[1 + j] = format!("{:.6}", beside[j]));
            for (axis, cell) in cells[7..10].iter_mut().enumerate() {
                *cell = format!("{:.6}", cell.parse::<f64>().unwrap() + 1000.0 * by[axis]);
            }
        }
        cells.join(",") + "\n"
    });
    let (code, answer) = compared(folder.path(), &measured(&[], tip, 1), &moved.collect::<String>());
    assert!(code == 0 && answer.contains("not changed"), "{answer}");
}

/// A reading 3 mm beside the two others of its pose takes no part, and the line is named.
#[test]
fn readings_beside_the_others_of_their_pose_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let tip = Vector3::from(TIP_M);
    let thrice = |seed: u64| {
        let all: Vec<String> = (0..3_u64).map(|k| measured(&[], tip, seed + 10 * k)).collect();
        let rows: Vec<Vec<&str>> = all.iter().map(|text| text.lines().collect()).collect();
        let mut text = format!("{}\n", rows[0][0]);
        (1..rows[0].len()).for_each(|k| rows.iter().for_each(|of| text += &format!("{}\n", of[k])));
        text
    };
    let off = with_points(&thrice(2), |k, point_mm| point_mm[0] += if k == 13 { 3.0 } else { 0.0 });
    let (_, answer) = compared(folder.path(), &thrice(1), &off);
    assert!(answer.contains("measure::false-repeat") && answer.contains("line "), "{answer}");
}

#[test]
fn what_keeps_poses_apart_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let tip = Vector3::from(TIP_M);
    let [before, after] = [1, 2].map(|seed| measured(&[], tip, seed));
    let target = |name: &str, text: &str| with_column(text, "target", name);
    let half = |text: &str, is_first: bool| {
        let rows = text.lines().enumerate().filter(|(k, _)| *k == 0 || (*k < 21) == is_first);
        rows.map(|(_, line)| format!("{line}\n")).collect::<String>()
    };
    let payload = |kg: &str, text: &str| with_column(text, "payload_kg", kg);
    let cases = [
        (target("A", &before), target("SMR1", &after), "target does not: A before, SMR1 after"),
        (payload("0", &before), payload("5", &after), "payload_kg does not: it is another one in 40 rows"),
        (before.clone(), joints_moved(&after, 0.1), "their joints differ by 0.100 deg in the middle"),
        (
            half(&before, true),
            half(&after, false),
            "no pose of one stands at the joints of a pose of the other",
        ),
    ];
    for (before, after, reason) in cases {
        let (code, answer) = compared(folder.path(), &before, &after);
        assert!(code == 2 && answer.contains("changed::too-few"), "{reason}: {answer}");
        assert!(answer.contains(reason), "{reason}: {answer}");
    }
    // The same points in other units are the robot's contradiction, not a pose that is missing.
    let metres = with_points(&after, |_, point_mm| point_mm.iter_mut().for_each(|mm| *mm *= 1e-3));
    assert!(compared(folder.path(), &before, &metres).1.contains("measure::fault"));
}

/// The file with three nests on the floor, read three times each; lengths between them are as long as `scale` says.
fn with_nests(text: &str, scale: f64) -> String {
    let poses = text.lines().enumerate();
    let mut out: String = poses
        .map(|(k, line)| format!("{line},{}\n", if k == 0 { "kind,fixed_id" } else { "pose," }))
        .collect();
    let columns = text.lines().next().unwrap().split(',').collect::<Vec<&str>>();
    for (name, at_mm) in
        [("N1", [900.0, 700.0, -300.0]), ("N2", [-800.0, 900.0, -300.0]), ("N3", [100.0, -900.0, -310.0])]
    {
        for noise_mm in [-0.02, 0.0, 0.02] {
            let cell = |column: &&str| match *column {
                "x_mm" => format!("{}", scale * at_mm[0] + noise_mm),
                "y_mm" => format!("{}", scale * at_mm[1] - noise_mm),
                "z_mm" => format!("{}", scale * at_mm[2] + noise_mm),
                _ => String::new(),
            };
            out +=
                &(columns.iter().map(cell).collect::<Vec<String>>().join(",") + &format!(",base,{name}\n"));
        }
    }
    out
}

fn answer_json(folder: &Path) -> Value {
    serde_json::from_slice(&fs::read(folder.join("c.json")).unwrap()).unwrap()
}

#[test]
fn nests_are_no_poses_of_a_comparison() {
    let folder = tempfile::tempdir().unwrap();
    let tip = Vector3::from(TIP_M);
    let [before, after] = [1, 2].map(|seed| measured(&[], tip, seed));
    let poses = before.lines().count() - 1;
    let (_, plain) = compared(folder.path(), &before, &after);
    let (code, answer) = compared(folder.path(), &with_nests(&before, 1.0), &with_nests(&after, 1.0));
    let all = format!("{poses} poses measured both times; 0 only before, 0 only after");
    assert!(code == 0 && answer.contains(&all), "{answer}");
    // The same nests, read to the same digits, are no poses that are copies.
    assert!(!answer.contains("same-readings"), "{answer}");
    assert_eq!(plain.lines().nth(2), answer.lines().nth(2));
    let shown = answer_json(folder.path());
    assert_eq!((&shown["pairs"], &shown["alone"]), (&serde_json::json!(poses), &serde_json::json!([0, 0])));
}

/// All points 1,000 ppm further from the instrument than before. Of nests 2.6 m apart whose readings scatter by 0.02 mm the scale is known to
/// some 20 ppm.
#[test]
fn a_scale_of_all_lengths_is_the_instrument_s_or_the_links_until_nests_tell() {
    let folder = tempfile::tempdir().unwrap();
    let tip = Vector3::from(TIP_M);
    let before = measured(&[], tip, 1);
    let grown = with_points(&measured(&[], tip, 2), |_, point_mm| {
        point_mm.iter_mut().for_each(|mm| *mm *= 1.001);
    });
    let near = |value: &Value, ppm: f64| (value.as_f64().unwrap() - ppm).abs() < 60.0;
    let (code, answer) = compared(folder.path(), &before, &grown);
    assert!(code == 1 && answer.contains("a scale bar, or nests on base or floor"), "{answer}");
    let shown = answer_json(folder.path());
    assert!(near(&shown["scale"]["ppm"], 1000.0) && shown["scale"]["links_ppm"].is_null(), "{answer}");
    assert_eq!(shown["verdict"], "ambiguous");
    let causes = shown["causes"].as_array().unwrap();
    let named: Vec<&str> = causes.iter().map(|cause| cause["effect"].as_str().unwrap()).collect();
    assert_eq!(named, ["instrument_scale", "link_geometry", "thermal_link_growth"], "{answer}");
    // None is likelier than another, and what has a size in ppm has that of the scale.
    assert!(causes.iter().all(|cause| cause["posterior"] == causes[0]["posterior"]), "{answer}");
    assert!(near(&causes[0]["size"], 1000.0) && near(&causes[2]["size"], 1000.0), "{answer}");
    for (of_nests, [instrument_ppm, links_ppm], effects) in [
        (1.001, [1000.0, 0.0], vec!["instrument_scale"]),
        (1.0, [0.0, 1000.0], vec!["link_geometry", "thermal_link_growth"]),
    ] {
        let (_, answer) = compared(folder.path(), &with_nests(&before, 1.0), &with_nests(&grown, of_nests));
        let shown = answer_json(folder.path());
        let scale = &shown["scale"];
        assert!(
            near(&scale["instrument_ppm"], instrument_ppm) && near(&scale["links_ppm"], links_ppm),
            "{answer}"
        );
        assert!(answer.contains("3 nests on base or floor tell whose"), "{answer}");
        let causes = shown["causes"].as_array().unwrap();
        assert_eq!(
            causes.iter().map(|c| c["effect"].as_str().unwrap()).collect::<Vec<_>>(),
            effects,
            "{answer}"
        );
    }
}

#[test]
fn another_tool_than_before_is_the_first_thing_of_the_report() {
    let folder = tempfile::tempdir().unwrap();
    let tip = Vector3::from(TIP_M);
    let before = measured(&[], tip, 1);
    let first_line = |off_m: Vector3<f64>| {
        let (code, answer) = compared(folder.path(), &before, &measured(&[], tip + off_m, 2));
        assert_eq!(code, 1, "{answer}");
        answer.lines().next().unwrap().to_owned()
    };
    let line = first_line(Vector3::new(0.0, 0.0, 0.1));
    let by_mm: f64 =
        line.split("target 1 by ").nth(1).expect(&line).split(' ').next().unwrap().parse().unwrap();
    // 100 mm, known to some hundredths.
    assert!(line.starts_with("CHANGED: the tool point differs, ") && (by_mm - 100.0).abs() < 0.1, "{line}");
    assert_eq!(answer_json(folder.path())["tools"][0]["is_other"], true);
    // Half a millimetre may be wear.
    assert_eq!(first_line(Vector3::new(0.0, 0.0, 5e-4)), "CHANGED");
}

/// Both times the target is where it was: 100 mm from where `--tool` has it.
#[test]
fn a_target_that_is_not_where_the_tool_was_given_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let tip = Vector3::from(TIP_M);
    let [before, after] =
        [1, 2].map(|seed| write(folder.path(), &format!("{seed}.csv"), &measured(&[], tip, seed)));
    let [x, y, z] = TIP_M.map(|m| 1e3 * m);
    let given =
        |tool: String| run(&["compare-measurements", &before, &after, "--sigma-mm", "0.02", "--tool", &tool]);
    let (code, out, err) = given(format!("{x},{y},{}", z + 100.0));
    assert!(code == 0 && err.contains("measure::tool-apart"), "{out}{err}");
    assert!(err.contains("before at (60.0, -30.0, 110.0) mm from the flange, 100.0 mm from --tool"), "{err}");
    assert!(!given(format!("{x},{y},{z}")).2.contains("tool-apart"));
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn rows_of_a_target_that_was_knocked_are_said_not_to_be_compared() {
        let folder = tempfile::tempdir().unwrap();
        let tip = Vector3::from(TIP_M);
        let after = measured(&[], tip, 2);
        let knocked = measured(&[], tip + Vector3::new(0.03, 0.02, 0.0), 2);
        let both = after.lines().take(26).chain(knocked.lines().skip(26)).collect::<Vec<_>>().join("\n");
        let before = measured(&[], tip, 1);
        for [before, after] in [[&before, &both], [&both, &before]] {
            // Of the target that one file has alone nothing is known the other time: it has not moved.
            let (code, answer) = compared(folder.path(), before, after);
            assert!(code == 0 && answer.contains("changed::target-moved"), "{answer}");
            assert!(answer.contains("15 poses") && !answer.contains("target 2"), "{answer}");
        }
    }

    /// 0.05 mm are more than five standard deviations of where 41 poses of 0.02 mm have the base, and less than five times what the six numbers of a
    /// base move the points by.
    #[test]
    #[ignore = "long"]
    fn a_base_that_is_elsewhere_by_more_than_its_interval_has_moved() {
        let folder = tempfile::tempdir().unwrap();
        let tip = Vector3::from(TIP_M);
        let before = measured(&[], tip, 1);
        let has_moved = |after: &str| {
            let (code, answer) = compared(folder.path(), &before, after);
            let read: Value =
                serde_json::from_slice(&fs::read(folder.path().join("c.json")).unwrap()).unwrap();
            assert!(code == 0 && read["base"]["sigma_mm"][0].as_f64().is_some(), "{answer}");
            assert_eq!(read["base"]["moved"] == true, answer.contains("the base has moved"), "{answer}");
            read["base"]["moved"] == true
        };
        let shift = Isometry3::translation(0.0, 0.0, 5e-5);
        assert!(has_moved(&file(&robot_under_test(&[]), &(somewhere() * shift), tip, 2)));
        for seed in 2..7 {
            assert!(!has_moved(&measured(&[], tip, seed)), "{seed}");
        }
    }
}
