//! Robots from descriptions, and as files.

use super::{Bench, CUBE, driftpost, err, out};
use std::fs;

const URDF: &str = "fixtures/robots/irb120.urdf";

#[test]
fn a_description_takes_the_place_of_a_robot_file() {
    let bench = Bench::default();
    let toml = bench.path("arm.toml").display().to_string();
    let output = driftpost(&["robot", "--robot", URDF, "-o", &toml]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    // The nearest of the cube's targets: those 400 mm in front of the base.
    let cube = fs::read_to_string("fixtures/paper/targets45.csv").unwrap();
    let near =
        bench.file("near.csv", cube.lines().take(16).map(|line| format!("{line}\n")).collect::<String>());
    let tabulate = |robot: &str| {
        let targets = ["tabulate", near.as_str(), "--orient-deg", "0,90,0", "--robot", robot];
        let output = driftpost(&[&targets[..], &["--minutes", "0", "--joints-csv", "-"]].concat());
        assert_eq!(output.status.code(), Some(0), "{}", err(&output));
        out(&output)
    };
    // Millimetres of the description and of the built-in robot are the same; radians have six digits.
    let joints = |text: String| -> Vec<f64> {
        text.lines()
            .skip(1)
            .flat_map(|line| line.split(',').skip(4).take(6))
            .map(|q| q.parse().unwrap())
            .collect()
    };
    let (ours, by_name) = (joints(tabulate(URDF)), joints(tabulate("irb120")));
    assert!(ours.len() == 15 * 6 && ours.iter().zip(&by_name).all(|(a, b)| (a - b).abs() < 1e-9));
    let (by_file, with_tip) = (joints(tabulate(&toml)), joints(tabulate(&format!("{URDF}:tool0"))));
    assert!(ours.iter().zip(&by_file).all(|(a, b)| (a - b).abs() < 1e-6));
    assert_eq!(ours, with_tip);
}

#[test]
fn a_denavit_hartenberg_table_takes_the_place_of_a_robot_file() {
    let bench = Bench::default();
    let to = bench.path("arm.toml").display().to_string();
    let output = driftpost(&["robot", "--robot", "dh:fixtures/robots/irb140_dh.csv", "-o", &to]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    // Cold, the same robot: the same joints at the same targets. (Warm it is another: a deformation table is in the joints' frames.)
    let joints = |robot: &[&str]| -> Vec<f64> {
        let targets =
            ["tabulate", "fixtures/paper/targets45.csv", "--orient-deg", "0,90,0", "--minutes", "0"];
        let output = driftpost(&[&targets[..], &["--joints-csv", "-"], robot].concat());
        assert_eq!(output.status.code(), Some(0), "{}", err(&output));
        let text = out(&output);
        let rows = text.lines().skip(1).flat_map(|line| line.split(',').skip(4).take(6));
        rows.map(|q| q.parse().unwrap()).collect()
    };
    let built_in = joints(&[]);
    for robot in ["dh:fixtures/robots/irb140_dh.csv", to.as_str()] {
        let table = joints(&["--robot", robot]);
        let off = table.iter().zip(&built_in).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(table.len() == 45 * 6 && built_in.len() == table.len() && off < 1e-6, "{robot}: {off} deg");
    }
    let message = |robot: &str, code: i32| {
        let output = driftpost(&["robot", "--robot", robot]);
        assert_eq!(output.status.code(), Some(code), "{}", err(&output));
        format!("{}{}", out(&output), err(&output))
    };
    assert!(message("mdh:fixtures/robots/panda_mdh.csv", 0).contains("joint 7"));
    let broken = bench.file("broken.csv", "a_mm,alpha_deg,d_mm,theta_deg\n0,0,x,0\n");
    let text = message(&format!("dh:{broken}"), 2);
    assert!(text.contains("robot::dh") && text.contains("line 2") && text.contains("d_mm `x`"), "{text}");
    assert!(message("dh:nowhere.csv", 2).contains("input::missing"));
}

#[test]
fn a_description_that_is_no_arm_is_refused_with_its_line() {
    let bench = Bench::default();
    let broken =
        bench.file("arm.urdf", "<robot name=\"x\">\n  <joint name=\"j\" type=\"revolute\"/>\n</robot>\n");
    let message = |robot: &str| {
        let output = driftpost(&["compensate", CUBE, "--robot", robot, "-o", "-"]);
        assert_eq!(output.status.code(), Some(2));
        err(&output)
    };
    assert!(
        message(&broken).contains("robot::urdf") && message(&broken).contains("line 2"),
        "{}",
        message(&broken)
    );
    assert!(message(&format!("{URDF}:hand")).contains("there is no link `hand`"));
    assert!(message("nowhere.urdf:tool0").contains("input::missing"));
    assert!(message("irb2400").contains("robot::coupled"));
    // Another maker's arm, by its name.
    let file = fs::read_to_string("crates/robot-model/src/robot/built_in/irb140.toml").unwrap();
    let fanuc = bench.file("fanuc.toml", file.replace("ABB IRB 140-6/0.8", "FANUC M-10"));
    assert!(message(&fanuc).contains("robot::not-abb"), "{}", message(&fanuc));
    // A description of independent joints that bears the name of an arm whose joints are coupled.
    let coupled = bench.file("own.toml", file.replace("ABB IRB 140-6/0.8", "ABB IRB 2400-16"));
    let urdf = fs::read_to_string(URDF).unwrap();
    let named = urdf.split_once("<robot name=\"").unwrap().1.split_once('"').unwrap().0.to_owned();
    let coupled_urdf = bench.file("own.urdf", urdf.replacen(&named, "abb_irb4400", 1));
    for robot in [&coupled, &coupled_urdf] {
        let text = message(robot);
        assert!(text.contains("robot::coupled") && text.contains("another name in its file"), "{text}");
        for command in [&["robot", "--robot"][..], &["tabulate", "--robot"], &["diagnose", CUBE, "--robot"]] {
            let output = driftpost(&[command, &[robot]].concat());
            assert_eq!(output.status.code(), Some(2), "{command:?}");
        }
    }
    let output = driftpost(&["robot", "-o", &bench.path("arm.step").display().to_string()]);
    assert!(err(&output).contains("robot::format"));
}

/// A program inside a backup whose robot stands elsewhere, whatever `--robot` names.
#[test]
fn the_backup_round_a_program_tells_where_the_base_stands() {
    let bench = Bench::default();
    let moc = fs::read_to_string("fixtures/robots/backup/SYSPAR/MOC.cfg").unwrap();
    let program = bench.file("RAPID/TASK1/PROGMOD/Cube45.mod", fs::read(CUBE).unwrap());
    let run = |moc: &str| {
        bench.file("SYSPAR/MOC.cfg", moc);
        let output = driftpost(&["compensate", &program, "-o", "-", "--tolerance-mm", "0.05"]);
        (output.status.code(), err(&output))
    };
    let (code, message) = run(&moc);
    assert!(
        code == Some(0)
            && message.contains("warning[robot::base-frame]")
            && message.contains("of ROB_1 stands"),
        "{message}"
    );
    let (code, message) =
        run(&moc.replace("\"r2_calib\"\\", "\"r2_calib\" -base_frame_orient_u0 0 -base_frame_orient_u1 1\\"));
    assert!(
        code == Some(2) && message.contains("error[robot::base-frame]") && message.contains("ROB_1, ROB_2"),
        "{message}"
    );
    let (code, message) = run(&moc.replace(" -base_frame_pos_z -0.5", ""));
    assert!(code == Some(0) && !message.contains("base-frame"), "{message}");
}

#[test]
fn a_backup_tells_type_bounds_and_calibration() {
    let output = driftpost(&["robot", "--robot", "backup:fixtures/robots/backup"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    // 1.5 rad are 85.9 deg.
    assert!(
        out(&output).starts_with("ABB IRB 140-6/0.8\n") && out(&output).contains("-180.0 to 85.9 deg"),
        "{}",
        out(&output)
    );
    let compensate = |more: &[&str]| {
        let second = [
            "compensate",
            CUBE,
            "--robot",
            "backup:fixtures/robots/backup:ROB_2",
            "-o",
            "-",
            "--tolerance-mm",
            "0.05",
        ];
        driftpost(&[&second[..], more].concat())
    };
    let refused = compensate(&[]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(err(&refused).contains("robot::absolute-accuracy"), "{}", err(&refused));
    let accepted = compensate(&["--absolute-accuracy"]);
    assert_eq!(accepted.status.code(), Some(0), "{}", err(&accepted));
    // Its first robot stands 500 mm below the world's frame: every work object would be taken for another place.
    for command in [&["compensate", CUBE, "-o", "-"][..], &["simulate", CUBE]] {
        let output = driftpost(&[command, &["--robot", "backup:fixtures/robots/backup"]].concat());
        assert_eq!(output.status.code(), Some(2));
        assert!(
            err(&output).contains("robot::base-frame") && err(&output).contains("-500.0"),
            "{}",
            err(&output)
        );
    }
    let output = driftpost(&["robot", "--robot", "backup:nowhere"]);
    assert!(err(&output).contains("input::missing"), "{}", err(&output));
}

/// ABB's data sheet: axis 2 stands 70 mm before axis 1 and 352 mm above the floor, axis 3 360 mm above it, the wrist 380 mm on, the
/// flange 65 mm before the wrist.
#[test]
fn a_robots_lengths_are_shown() {
    let output = driftpost(&["robot", "--robot", "irb140"]);
    let text = out(&output);
    let numbers = |line: &str| -> Vec<f64> {
        let origin = line.split("origin ").nth(1).unwrap().split(" mm").next().unwrap();
        origin.split(' ').map(|n| n.parse().unwrap()).collect()
    };
    let of: Vec<Vec<f64>> = text.lines().filter(|line| line.contains("origin")).map(numbers).collect();
    assert_eq!(of.len(), 7, "{text}");
    let sums = |range: std::ops::Range<usize>, k: usize| of[range].iter().map(|xyz| xyz[k]).sum::<f64>();
    assert_eq!((sums(0..2, 0), sums(0..2, 2)), (70.0, 352.0), "{text}");
    assert_eq!((sums(2..3, 0), sums(2..3, 2)), (0.0, 360.0), "{text}");
    assert_eq!((sums(3..5, 0), sums(5..7, 0)), (380.0, 65.0), "{text}");
    let output = driftpost(&["robot", "--robot", "irb140", "--json", "-"]);
    let robot: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let of_json = |joint: &serde_json::Value| -> Vec<f64> {
        serde_json::from_value(joint["origin_mm"].clone()).unwrap()
    };
    let mut frames: Vec<Vec<f64>> = robot["joints"].as_array().unwrap().iter().map(of_json).collect();
    frames.push(of_json(&robot["flange"]));
    assert_eq!(frames, of);
}
