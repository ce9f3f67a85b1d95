//! A backup with two motion tasks, two robots: each is compensated with its own, and compared, executed and restored with it.

use super::{Bench, CUBE, driftpost, err, out};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;

const LARGE: &str = "irb4600";
/// A larger arm's module: nothing of it is within an IRB 140's reach.
const PRESS: &str = "MODULE Press
  PERS tooldata tGrip:=[TRUE,[[0,0,250],[1,0,0,0]],[10,[0,0,100],[1,0,0,0],0,0,0]];
  CONST jointtarget jHome:=[[0,0,10,0,60,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pIn:=[[1300,200,700],[0,0,1,0],[0,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pOut:=[[1500,400,900],[0,0,1,0],[0,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

  PROC main()
    MoveAbsJ jHome,v500,fine,tGrip;
    MoveJ pIn,v500,z10,tGrip;
    MoveL pOut,v200,fine,tGrip;
  ENDPROC
ENDMODULE
";
/// A deformation of the larger arm: mm and deg of each joint's frame.
const TABLE: &str = "Dx [mm],Dy[mm],Dz[mm],DOx[deg],DOy[deg],DOz[deg]
0.02,0,0.09,0,0.003,0.001
0.03,0.01,0,0.001,0.004,0
0,0.02,0.06,0,0.003,0.002
0.01,0,0.01,0.002,0,0
0,0.01,0.02,0,0.002,0
0,0,0,0,0,0
";

fn backup(bench: &Bench) -> String {
    bench.file("backup/RAPID/TASK1/PROGMOD/Cube45.mod", fs::read_to_string(CUBE).unwrap());
    bench.file("backup/RAPID/TASK2/PROGMOD/Press.mod", PRESS);
    bench.file("backup/SYSPAR/SYS.cfg", "SYS:CFG_1.0::\n");
    bench.path("backup").display().to_string()
}

fn json(bench: &Bench, name: &str) -> Value {
    serde_json::from_str(&bench.text(name)).unwrap()
}

#[test]
fn each_task_is_corrected_for_its_own_robot() {
    let bench = Bench::default();
    let source = backup(&bench);
    let table = bench.file("drift2.csv", TABLE);
    let second = format!("TASK2={LARGE},{table}");
    for form in ["schedule", "ramp", "live", "auto"] {
        let to = bench.path(form).display().to_string();
        let report = bench.path("report.json").display().to_string();
        let tasks = ["--task", "TASK1=irb140", "--task", second.as_str(), "--growth", "two-stage:60"];
        let rest = ["-o", &to, "--diff", "none", "--form", form, "--json", &report];
        let output = driftpost(&[["compensate", &source].as_slice(), &tasks, &rest].concat());
        assert_eq!(output.status.code(), Some(0), "{form}: {} {}", out(&output), err(&output));
        let message = out(&output);
        assert!(
            message.contains("TASK1: ABB IRB 140") && message.contains("TASK2: ABB IRB 4600"),
            "{message}"
        );
        let report = json(&bench, "report.json");
        let motions = |k: usize| report["tasks"][k]["motions"].as_array().unwrap();
        assert_eq!((motions(0).len(), motions(1).len()), (46, 3), "{form}");
        let all = motions(0).iter().chain(motions(1));
        assert!(all.into_iter().all(|motion| motion["status"] == "compensated"), "{form}: {report}");
        let [cube, press] = ["TASK1/PROGMOD/Cube45.mod", "TASK2/PROGMOD/Press.mod"]
            .map(|place| bench.text(&format!("{form}/RAPID/{place}")));
        assert!(cube.contains("irb140") && !cube.contains(LARGE), "{form}: {cube}");
        assert!(
            press.contains(LARGE) && press.contains("drift2.csv") && !press.contains("irb140"),
            "{form}: {press}"
        );

        // Each robot is read from its own task's modules; the larger one's targets are out of the smaller one's reach.
        for (task, moves) in [("TASK1", 46), ("TASK2", 3)] {
            let figures = bench.path("figures.json").display().to_string();
            let tolerance = if form == "schedule" { "0.006" } else { "0.0005" };
            let words = ["simulate", &to, "--original", &source, "--task", task, "--minutes", "0,61,420"];
            let output =
                driftpost(&[&words[..], &["--tolerance-mm", tolerance, "--json", &figures]].concat());
            assert_eq!(output.status.code(), Some(0), "{form} {task}: {} {}", out(&output), err(&output));
            let figures = json(&bench, "figures.json");
            let last = &figures["minutes"][2];
            assert_eq!(last["n"], moves, "{form} {task}: {figures}");
            assert!(last["before"]["max_mm"].as_f64().unwrap() > 0.1, "{form} {task}: {last}");
        }
        let output = driftpost(&["diff", &source, &to]);
        let message = out(&output);
        assert_eq!(output.status.code(), Some(0), "{form}: {message} {}", err(&output));
        assert!(
            message.contains("49 motions") && err(&output).is_empty(),
            "{form}: {message} {}",
            err(&output)
        );
        let back = bench.path(&format!("{form}_back"));
        let output = driftpost(&["restore", &to, "-o", &back.display().to_string()]);
        assert_eq!(output.status.code(), Some(0), "{form}: {}", err(&output));
        for place in ["RAPID/TASK1/PROGMOD/Cube45.mod", "RAPID/TASK2/PROGMOD/Press.mod", "SYSPAR/SYS.cfg"] {
            let [was, is] = ["backup".to_owned(), format!("{form}_back")]
                .map(|folder| fs::read(bench.path(&folder).join(place)).unwrap());
            assert_eq!(was, is, "{form}: {place}");
        }
    }
}

/// One table of joints, the file of a row saying whose it is: every minute of a target is in it once, and a joint target's angles are those of
/// the source. The JSON and the page have the tasks as lists.
#[test]
fn joints_and_page_of_several_tasks_are_one_file_each() {
    let bench = Bench::default();
    let source = backup(&bench);
    let second = format!("TASK2={LARGE},{}", bench.file("drift2.csv", TABLE));
    let to = |name: &str| bench.path(name).display().to_string();
    let words =
        ["compensate", &source, "--task", "TASK1=irb140", "--task", &second, "--growth", "two-stage:60"];
    let results =
        ["-o", &to("out"), "--diff", "none", "--joints-csv", &to("joints.csv"), "--report", &to("page.html")];
    let output = driftpost(&[&words[..], &results, &["--json", &to("all.json")]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let table = bench.text("joints.csv");
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!((rows[0][0], rows.iter().filter(|row| row[0] == "target").count()), ("target", 1));
    let of = |task: &str| rows.iter().filter(|row| row[1].contains(task)).collect::<Vec<_>>();
    let [cube, press] = [of("TASK1"), of("TASK2")];
    let minutes =
        |rows: &[&Vec<&str>]| rows.iter().map(|row| row[3].to_owned()).collect::<BTreeSet<_>>().len();
    assert_eq!((cube.len(), press.len()), (46 * minutes(&cube), 3 * minutes(&press)));
    assert_eq!(rows.len(), 1 + cube.len() + press.len());
    let home: Vec<f64> = press[0][4..10].iter().map(|q| q.parse().unwrap()).collect();
    // at minute 0 nothing is deformed yet: the joints of jHome
    assert!(
        home.iter().zip([0.0, 0.0, 10.0, 0.0, 60.0, 0.0]).all(|(q, of)| (q - of).abs() < 1e-6),
        "{home:?}"
    );
    let page = bench.text("page.html");
    let (_, data) = page.split_once("id=\"data\">").unwrap();
    let data: Value = serde_json::from_str(data.split_once("</script>").unwrap().0).unwrap();
    let report = json(&bench, "all.json");
    for (k, (task, motions)) in [("TASK1", 46), ("TASK2", 3)].into_iter().enumerate() {
        let [of_page, of_json] = [&data["data"]["tasks"][k], &report["tasks"][k]];
        assert_eq!(
            (&of_page["task"], &of_page["worst_before_mm"]),
            (&task.into(), &of_json["worst_before_mm"])
        );
        assert_eq!(data["view"]["tasks"][k]["points"]["motion"].as_array().unwrap().len(), motions);
        let files = data["view"]["tasks"][k]["source"]["files"].as_array().unwrap();
        assert!(files.len() == 1 && files[0].to_string().contains(task), "{task}: {files:?}");
    }
}

#[test]
fn tasks_may_stand_in_the_settings_with_files_beside_them() {
    let bench = Bench::default();
    let source = backup(&bench);
    let table = bench.file("drift2.csv", TABLE);
    bench.file(
        "driftpost.toml",
        format!("[compensate]\ntask = [\"TASK1=irb140\", \"TASK2={LARGE},drift2.csv\"]\ngrowth = \"two-stage:60\"\n"),
    );
    let to = |name: &str| bench.path(name).display().to_string();
    let output = driftpost(&["compensate", &source, "-o", &to("by_settings"), "--diff", "none"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let second = format!("TASK2={LARGE},{table}");
    let words =
        ["compensate", &source, "-o", &to("by_options"), "--diff", "none", "--growth", "two-stage:60"];
    let output = driftpost(&[&words[..], &["--task", "task1=irb140", "--task", &second]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    for place in ["RAPID/TASK1/PROGMOD/Cube45.mod", "RAPID/TASK2/PROGMOD/Press.mod"] {
        assert_eq!(bench.text(&format!("by_settings/{place}")), bench.text(&format!("by_options/{place}")));
    }
}

#[test]
fn tasks_that_are_not_named_or_hold_no_motion_are_refused() {
    let bench = Bench::default();
    let source = backup(&bench);
    let to = bench.path("out").display().to_string();
    let refused = |words: &[&str]| {
        let output = driftpost(&[&["compensate", &source, "-o", &to, "--diff", "none"], words].concat());
        assert_eq!(output.status.code(), Some(2), "{words:?}: {}", out(&output));
        assert!(!bench.path("out").exists(), "{words:?}");
        err(&output)
    };
    let none = refused(&[]);
    assert!(none.contains("emit::several-tasks") || none.contains("reach::"), "{none}");
    let one = refused(&["--task", "TASK1=irb140"]);
    assert!(one.contains("task::not-named") && one.contains("TASK2 holds motion"), "{one}");
    let none = refused(&["--task", "TASK1=irb140", "--task", "TASK3=irb140"]);
    assert!(none.contains("task::no-motion") && none.contains("TASK1, TASK2"), "{none}");
    let twice = refused(&["--task", "TASK1=irb140", "--task", "task1=irb140"]);
    assert!(twice.contains("task::twice"), "{twice}");
    let without = refused(&["--task", "TASK1=irb140", "--task", &format!("TASK2={LARGE}")]);
    assert!(without.contains("deform::other-robot"), "the built-in table is an IRB 140's: {without}");
    let both = refused(&["--task", "TASK1=irb140", "--robot", "irb140"]);
    assert!(both.contains("cannot be used with"), "{both}");
}

/// Modules saved by their tasks' names are tasks as those of a backup are: two robots are never corrected as one.
#[test]
fn folders_by_the_names_of_tasks_are_tasks() {
    let bench = Bench::default();
    // A project's own folder may be called like a task's.
    bench.file("t_cell/T_ROB1/Cube45.mod", fs::read_to_string(CUBE).unwrap());
    bench.file("t_cell/T_ROB2/Cube45.mod", fs::read_to_string(CUBE).unwrap());
    let source = bench.path("t_cell").display().to_string();
    let to = bench.path("made").display().to_string();
    let run = |words: &[&str]| {
        driftpost(
            &[
                &[
                    "compensate",
                    &source,
                    "-o",
                    &to,
                    "--diff",
                    "none",
                    "--form",
                    "auto",
                    "--growth",
                    "two-stage:60",
                ],
                words,
            ]
            .concat(),
        )
    };
    let refused = run(&[]);
    assert_eq!(refused.status.code(), Some(2), "{}", out(&refused));
    assert!(err(&refused).contains("emit::several-tasks"), "{}", err(&refused));
    assert!(!bench.path("made").exists());
    fs::remove_file(bench.path("t_cell/T_ROB2/Cube45.mod")).unwrap();
    bench.file("t_cell/T_ROB2/Press.mod", PRESS);
    let second = format!("T_ROB2={LARGE},{}", bench.file("drift2.csv", TABLE));
    let made = run(&["--task", "T_ROB1=irb140", "--task", &second]);
    assert_eq!(made.status.code(), Some(0), "{}", err(&made));
    for place in ["made/T_ROB1/Cube45.mod", "made/T_ROB2/Press.mod"] {
        assert!(bench.text(place).contains("tcAt("), "{place}");
    }
}

/// What stands in no task's folder has no task to be named by.
#[test]
fn a_recommendation_beside_loose_modules_is_one_that_works() {
    let bench = Bench::default();
    let cube = fs::read(CUBE).unwrap();
    let loose = bench.file("cell/Cube45.mod", &cube);
    bench.file("cell/RAPID/TASK1/Cube45.mod", &cube);
    let run = |program: &str, to: &str, more: &[&str]| {
        let to = bench.path(to).display().to_string();
        driftpost(&[&["compensate", program, "-o", &to, "--diff", "none"][..], more].concat())
    };
    let cell = bench.path("cell").display().to_string();
    for named in [&[][..], &["--task", "TASK1=irb140"]] {
        let refused = run(&cell, "all", named);
        assert_eq!(refused.status.code(), Some(2));
        let text = err(&refused);
        assert!(!text.contains("--task =") && text.contains("by themselves"), "{text}");
    }
    assert_eq!(run(&bench.path("cell/RAPID").display().to_string(), "one", &[]).status.code(), Some(0));
    assert_eq!(run(&loose, "two.mod", &[]).status.code(), Some(0));
}

const POSITIONER: &str = "MODULE Turn
  CONST jointtarget jLoad:=[[9E9,9E9,9E9,9E9,9E9,9E9],[0,9E9,9E9,9E9,9E9,9E9]];
  PROC main()
    ActUnit STN1;
    MoveExtJ jLoad,vrot50,fine;
  ENDPROC
ENDMODULE
";
const READING: &str = "MODULE Here
  PROC main()
    VAR robtarget pNow;
    pNow:=CRobT(\\Tool:=tool0);
    MoveL pNow,v100,fine,tool0;
  ENDPROC
ENDMODULE
";

/// A positioner's task needs no robot, and a task in which nothing can be corrected keeps no other from it.
#[test]
fn a_task_that_stays_as_it_is_keeps_no_other_from_being_corrected() {
    let bench = Bench::default();
    let cube = fs::read_to_string(CUBE).unwrap();
    bench.file("cell/RAPID/TASK1/PROGMOD/Here.mod", READING);
    bench.file("cell/RAPID/TASK2/PROGMOD/Cube45.mod", &cube);
    bench.file("cell/RAPID/TASK3/PROGMOD/Turn.mod", POSITIONER);
    let source = bench.path("cell").display().to_string();
    let [to, report] = ["made", "report.json"].map(|name| bench.path(name).display().to_string());
    let run = |words: &[&str]| {
        let rest = ["-o", &to, "--diff", "none", "--form", "ramp", "--json", &report];
        driftpost(&[["compensate", &source].as_slice(), words, &rest].concat())
    };
    let made = run(&["--task", "TASK1=irb140", "--task", "TASK2=irb140"]);
    assert_eq!(made.status.code(), Some(0), "{}", err(&made));
    assert!(
        err(&made).contains("task::left-alone") && err(&made).contains("TASK1 stays as it is"),
        "{}",
        err(&made)
    );
    assert!(out(&made).contains("TASK2: ABB IRB 140") && !out(&made).contains("TASK1: "), "{}", out(&made));
    assert!(bench.text("made/RAPID/TASK2/PROGMOD/Cube45.mod").contains("tcAt("));
    let found = json(&bench, "report.json");
    let tasks: Vec<&str> =
        found["tasks"].as_array().unwrap().iter().map(|t| t["task"].as_str().unwrap()).collect();
    assert_eq!(tasks, ["TASK2", "TASK1"]);
    assert_eq!(found["tasks"][1]["motions"][0]["status"], "kept", "{}", found["tasks"][1]);
    // The positioner's has no arm.
    let named = run(&["--task", "TASK2=irb140", "--task", "TASK3=irb140"]);
    assert!(err(&named).contains("task::no-motion"), "{}", err(&named));
    // Where no task can be corrected, nothing is written.
    bench.file("cell/RAPID/TASK2/PROGMOD/Cube45.mod", READING);
    fs::remove_dir_all(&to).unwrap();
    let none = run(&["--task", "TASK1=irb140", "--task", "TASK2=irb140"]);
    assert_eq!(none.status.code(), Some(2), "{}", out(&none));
    assert!(err(&none).contains("compensate::nothing") && !bench.path("made").exists(), "{}", err(&none));
}

/// A module that was encoded, as those of packages of options, is copied as it is; what it declares is not known.
#[test]
fn an_encoded_module_stays_as_it_is() {
    let bench = Bench::default();
    let encoded: Vec<u8> = (0..200_u32).map(|k| (k * 197 % 251) as u8).collect();
    assert!(encoded.contains(&0));
    let library = bench.path("cell/RAPID/TASK1/SYSMOD/Library.sys");
    bench.file("cell/RAPID/TASK1/PROGMOD/Cube45.mod", fs::read_to_string(CUBE).unwrap());
    bench.file("cell/RAPID/TASK1/SYSMOD/Library.sys", "");
    fs::write(&library, &encoded).unwrap();
    let source = bench.path("cell").display().to_string();
    let to = bench.path("made").display().to_string();
    let made = driftpost(&["compensate", &source, "-o", &to, "--diff", "none", "--form", "ramp"]);
    assert_eq!(made.status.code(), Some(0), "{}", err(&made));
    assert!(err(&made).contains("input::encoded") && err(&made).contains("Library.sys"), "{}", err(&made));
    assert_eq!(fs::read(bench.path("made/RAPID/TASK1/SYSMOD/Library.sys")).unwrap(), encoded);
    assert!(bench.text("made/RAPID/TASK1/PROGMOD/Cube45.mod").contains("tcAt("));
    // By itself it is nothing to correct.
    let alone = driftpost(&["compensate", &library.display().to_string(), "-o", &to]);
    assert_eq!(alone.status.code(), Some(2), "{}", out(&alone));
    assert!(err(&alone).contains("input::binary"), "{}", err(&alone));
}

/// A row of the hint belongs to the task that its file stands in, and is looked up there alone.
#[test]
fn joints_known_from_outside_are_a_tasks_own() {
    let bench = Bench::default();
    let source = backup(&bench);
    let loose = PRESS
        .replace("    MoveAbsJ jHome,v500,fine,tGrip;\n    MoveJ pIn", "    ConfL \\Off;\n    MoveL pIn");
    // From nowhere the configuration as it is written counts.
    let loose = loose.replace("[0,0,-1,0]", "[0,0,0,0]");
    bench.file("backup/RAPID/TASK2/PROGMOD/Press.mod", &loose);
    let second = format!("TASK2={LARGE},{}", bench.file("drift2.csv", TABLE));
    let to = |name: &str| bench.path(name).display().to_string();
    let run = |rest: &[&str]| {
        let tasks = ["compensate", &source, "--task", "TASK1=irb140", "--task", &second, "--growth"];
        let results = ["two-stage:60", "-o", &to("out"), "--force", "--diff", "none"];
        driftpost(&[&tasks[..], &results, &["--joints-csv", &to("joints.csv")], rest].concat())
    };
    // The joints of pIn at minute 0, when nothing is deformed.
    let p_in = || {
        let table = bench.text("joints.csv");
        let row = table.lines().find(|row| row.starts_with("pIn,")).unwrap().to_owned();
        let cells: Vec<f64> = row.split(',').skip(4).take(6).map(|cell| cell.parse().unwrap()).collect();
        cells
    };
    let output = run(&[]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let written = p_in();
    // The other wrist: axes 4 and 6 half a turn on, axis 5 turned over.
    let mut other = written.clone();
    (other[3], other[4], other[5]) = (written[3] - 180.0, -written[4], written[5] + 180.0);
    let row = |file: &str, line: u32, q_deg: &[f64]| {
        let joints: Vec<String> = q_deg.iter().map(f64::to_string).collect();
        format!("{file},{line},{}\n", joints.join(","))
    };
    let head = "file,line,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n";
    let cube = fs::read_to_string(CUBE).unwrap();
    let (first, line) = cube.lines().enumerate().find(|(_, line)| line.contains("MoveAbsJ")).unwrap();
    let start = line.split_once("[[").unwrap().1.split_once(']').unwrap().0;
    let start: Vec<f64> = start.split(',').map(|q| q.trim().parse().unwrap()).collect();
    let cube = row("TASK1/PROGMOD/Cube45.mod", first as u32 + 1, &start);
    let hint = bench.file("hint.csv", format!("{head}{cube}{}", row("TASK2/PROGMOD/Press.mod", 9, &other)));
    let output = run(&["--joints-hint", &hint]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let hinted = p_in();
    assert!(
        hinted.iter().zip(&other).all(|(a, b)| ((a - b + 540.0) % 360.0 - 180.0).abs() < 1e-3),
        "{hinted:?}"
    );
    for wrong in [row("TASK2/PROGMOD/Press.mod", 1, &other), row("TASK3/PROGMOD/Press.mod", 9, &other)] {
        let hint = bench.file("hint.csv", format!("{head}{wrong}"));
        let output = run(&["--joints-hint", &hint]);
        assert_eq!(output.status.code(), Some(2), "{wrong}: {}", out(&output));
        assert!(err(&output).contains("hint::line"), "{wrong}: {}", err(&output));
    }
}

/// Where each arm stands at its entry, by a jointtarget of its own task or by angles; of one name in both tasks each has its own.
#[test]
fn home_and_start_joints_are_a_tasks_own() {
    let bench = Bench::default();
    let source = backup(&bench);
    bench.file(
        "backup/RAPID/TASK1/PROGMOD/Data.mod",
        "MODULE Data\n  CONST jointtarget jHome:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\nENDMODULE\n",
    );
    let table = bench.file("drift2.csv", TABLE);
    let second = format!("TASK2={LARGE},{table}");
    let to = bench.path("out").display().to_string();
    let tasks = ["compensate", &source, "--task", "TASK1=irb140", "--task", &second, "--growth"];
    let run = |start: &[&str]| {
        let rest = ["two-stage:60", "-o", &to, "--force", "--diff", "none"];
        driftpost(&[&tasks[..], &rest, start].concat())
    };
    let cube = "start-joints 0,0,0,0,30,0";
    let press = "start-joints 0,0,10,0,60,0";
    for (start, of_cube, of_press) in [
        (vec!["--home", "TASK1=jHome", "--home", "task2=jHome"], true, true),
        (vec!["--home", "TASK2=jHome"], false, true),
        (vec!["--start-joints", "TASK1=0,0,0,0,30,0", "--start-joints", "TASK2=0,0,10,0,60,0"], true, true),
    ] {
        let output = run(&start);
        assert_eq!(output.status.code(), Some(0), "{start:?}: {}", err(&output));
        let text = |place: &str| bench.text(&format!("out/RAPID/{place}"));
        let found = [
            text("TASK1/PROGMOD/Cube45.mod").contains(cube),
            text("TASK2/PROGMOD/Press.mod").contains(press),
        ];
        assert_eq!(found, [of_cube, of_press], "{start:?}");
    }
    for (start, code) in [
        (["--home", "jHome"].as_slice(), "task::not-named"),
        (&["--start-joints", "0,0,10,0,60,0"], "task::not-named"),
        (&["--home", "TASK3=jHome"], "task::not-named"),
        (&["--home", "TASK1=jHome", "--home", "TASK1=jHome"], "task::twice"),
        (&["--home", "TASK2=jElsewhere"], "override::home"),
    ] {
        let output = run(start);
        assert_eq!(output.status.code(), Some(2), "{start:?}: {}", out(&output));
        assert!(err(&output).contains(code), "{start:?}: {}", err(&output));
    }
    // Without tasks: once, and of no task.
    for start in [["--home", "jHome", "--home", "jHome"].as_slice(), &["--home", "TASK1=jHome"]] {
        let output = driftpost(&[&["compensate", CUBE, "-o", &to, "--force"], start].concat());
        assert_eq!(output.status.code(), Some(2), "{start:?}: {}", out(&output));
        assert!(err(&output).contains("task::"), "{start:?}: {}", err(&output));
    }
}

/// A cell of two robots is kept under review as one is: what `golden` expects of each module is what `compensate` writes.
#[test]
fn a_golden_case_has_the_robots_of_its_tasks() {
    let bench = Bench::default();
    let source = backup(&bench);
    let table = bench.file("drift2.csv", TABLE);
    let to = bench.path("made").display().to_string();
    let second = format!("TASK2={LARGE},{table}");
    let tasks = ["--task", "TASK1=irb140", "--task", second.as_str(), "--growth", "two-stage:60"];
    let made = driftpost(&[["compensate", &source, "-o", &to, "--diff", "none"].as_slice(), &tasks].concat());
    assert!(made.status.success(), "{}", err(&made));

    bench.file("cases/cell/source/RAPID/TASK1/PROGMOD/Cube45.mod", fs::read_to_string(CUBE).unwrap());
    bench.file("cases/cell/source/RAPID/TASK2/PROGMOD/Press.mod", PRESS);
    bench.file("cases/cell/drift2.csv", TABLE);
    let options = |second: &str| {
        let text = format!("task = [\"TASK1=irb140\", \"TASK2={second}\"]\ngrowth = \"two-stage:60\"\n");
        bench.file("cases/cell/options.toml", text);
    };
    options("irb4600,drift2.csv");
    let cases = bench.path("cases").display().to_string();
    let updated = driftpost(&["golden", &cases, "--update"]);
    assert!(updated.status.success(), "{}", err(&updated));
    for place in ["RAPID/TASK1/PROGMOD/Cube45.mod", "RAPID/TASK2/PROGMOD/Press.mod"] {
        // Where the program came from stands in the header.
        let code = |text: String| {
            text.lines().filter(|line| !line.trim_start().starts_with('!')).collect::<Vec<_>>().join("\n")
        };
        let [expected, written] = [format!("cases/cell/expected/{place}"), format!("made/{place}")]
            .map(|place| code(bench.text(&place)));
        assert_eq!(expected, written, "{place}");
    }
    let review = bench.text("cases/cell/expected/review.txt");
    assert!(review.contains("ABB IRB 140") && review.contains("ABB IRB 4600"), "{review}");
    assert_eq!(driftpost(&["golden", &cases]).status.code(), Some(0));
    // The second robot's corrections are beyond what is allowed: nothing of the cell would be written.
    bench.file("cases/cell/far.csv", TABLE.replacen("0.02,0,0.09", "20,0,9", 1));
    options("irb4600,far.csv");
    assert_eq!(driftpost(&["golden", &cases]).status.code(), Some(1));
    assert!(driftpost(&["golden", &cases, "--update"]).status.success());
    assert!(!bench.path("cases/cell/expected/review.txt").exists());
    assert!(!bench.path("cases/cell/expected/RAPID/TASK1/PROGMOD/Cube45.mod").exists());
}
