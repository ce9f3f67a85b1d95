//! What `compensate` writes, and what it leaves alone.

use super::{Bench, CUBE, driftpost, err, out};
use serde_json::Value;
use std::fs;

#[test]
fn one_file_goes_beside_itself_and_comes_back_byte_for_byte() {
    let bench = Bench::default();
    let source = fs::read(CUBE).unwrap();
    let cube = bench.file("Cube45.mod", &source);
    let output = driftpost(&["compensate", &cube, "--tolerance-mm", "0.02"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert_eq!(bench.files(), ["Cube45.mod", "Cube45_tc.mod"]);
    assert_eq!(fs::read(&cube).unwrap(), source);
    assert!(out(&output).contains("46 motions: 46 compensated"), "{}", out(&output));
    assert!(
        out(&output).starts_with("--- ") && out(&output).contains("\n+++ "),
        "the diff comes before the table"
    );
    let emitted = bench.path("Cube45_tc.mod").display().to_string();
    let back = bench.path("back.mod").display().to_string();
    let output = driftpost(&["restore", &emitted, "-o", &back]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert_eq!(fs::read(&back).unwrap(), source);
}

#[test]
fn a_folder_is_written_whole_under_the_same_names() {
    let bench = Bench::default();
    let module = fs::read_to_string("fixtures/golden/two_tools_loop/source/Cell.mod").unwrap();
    bench.file("cell/RAPID/TASK1/Cell.MOD", &module);
    bench.file("cell/RAPID/TASK1/Idle.sys", "MODULE Idle\n  VAR num n;\nENDMODULE");
    bench.file("cell/old_tc.mod", "MODULE Old\n  ! driftpost 0.1.0\n no module at all");
    // Called as a result is, and none.
    bench.file("cell/glue_tc.mod", "MODULE Glue\n  VAR num g;\nENDMODULE");
    bench.file("cell/notes.txt", b"\xff\x00");
    let folder = bench.path("cell").display().to_string();
    let output = driftpost(&["compensate", &folder, "--core", "separate", "--tolerance-mm", "0.05"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let made: Vec<String> = bench.files().into_iter().filter(|f| f.starts_with("cell_tc/")).collect();
    let of_task = ["Cell.MOD", "Idle.sys", "tcCore.mod"].map(|name| format!("RAPID/TASK1/{name}"));
    let [cell, idle, core] = of_task.each_ref().map(String::as_str);
    let expected = [".driftpost", cell, idle, core, "glue_tc.mod", "notes.txt"];
    assert!(
        err(&output).contains("input::not-read") && err(&output).contains("glue_tc.mod"),
        "{}",
        err(&output)
    );
    assert!(!err(&output).contains("old_tc.mod"), "{}", err(&output));
    assert_eq!(bench.text("cell_tc/glue_tc.mod"), bench.text("cell/glue_tc.mod"));
    assert_eq!(made, expected.map(|f| format!("cell_tc/{f}")));
    assert_eq!(fs::read(bench.path("cell_tc/notes.txt")).unwrap(), b"\xff\x00");
    assert_eq!(bench.text("cell_tc/RAPID/TASK1/Idle.sys"), bench.text("cell/RAPID/TASK1/Idle.sys"));
}

#[test]
fn a_pgf_is_read_in_its_order() {
    let bench = Bench::default();
    let module = fs::read_to_string("fixtures/golden/two_tools_loop/source/Cell.mod").unwrap();
    bench.file("Cell.mod", module);
    let pgf = bench.file("cell.pgf", "<Program><Module>Cell.mod</Module></Program>");
    let output = driftpost(&["compensate", &pgf, "--tolerance-mm", "0.05", "--diff", "none"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert_eq!(bench.files(), ["Cell.mod", "cell.pgf", "cell_tc/Cell.mod", "cell_tc/cell.pgf"]);
    assert!(!out(&output).contains("+++"), "no diff was wanted");
}

#[test]
fn an_input_is_overwritten_only_in_place() {
    let bench = Bench::default();
    let cube = bench.file("Cube45.mod", fs::read(CUBE).unwrap());
    let output = driftpost(&["compensate", &cube, "--in-place", "--tolerance-mm", "0.05"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert_eq!(bench.files(), ["Cube45.mod"]);
    assert!(bench.text("Cube45.mod").contains("tcUpdate"));
}

#[test]
fn json_has_the_keys_of_the_contract_and_is_alone_on_standard_output() {
    let bench = Bench::default();
    let result = bench.path("o.mod").display().to_string();
    let output = driftpost(&["compensate", CUBE, "-o", &result, "--json", "-"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let value: Value = serde_json::from_slice(&output.stdout).unwrap();
    let motions = value["motions"].as_array().unwrap();
    assert_eq!(motions.len(), 46);
    let keys = [
        "file",
        "line",
        "routine",
        "index",
        "kind",
        "target",
        "status",
        "reason",
        "max_correction_mm",
        "max_correction_deg",
        "mid_path_mm",
    ];
    assert!(keys.iter().all(|key| motions[1].get(key).is_some()), "{}", motions[1]);
    assert_eq!((&motions[1]["kind"], &motions[1]["status"]), (&"MoveL".into(), &"compensated".into()));
    assert_eq!((&motions[1]["target"], &motions[1]["reason"]), (&Value::Null, &Value::Null));
    let buckets = value["buckets"].as_array().unwrap();
    assert_eq!(buckets[0]["from_min"], 0.0);
    assert_eq!(buckets.last().unwrap()["to_min"], Value::Null);
    // before: 0.193 mm in the end (Table 2 of the paper, applied in full); after: the tolerance
    assert!((value["worst_before_mm"].as_f64().unwrap() - 0.193).abs() < 0.001);
    assert!(value["worst_after_mm"].as_f64().unwrap() <= 0.0055);
}

#[test]
fn joints_at_every_minute_have_the_columns_of_the_contract() {
    let bench = Bench::default();
    let csv = bench.path("j.csv").display().to_string();
    let result = bench.path("o.mod").display().to_string();
    let arguments = ["compensate", CUBE, "-o", &result, "--until", "180", "--joints-csv", &csv];
    let output = driftpost(&arguments);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let text = bench.text("j.csv");
    let header =
        "target,file,line,t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,residual_mm";
    assert_eq!(text.lines().next(), Some(header));
    assert_eq!(text.lines().count(), 1 + 46 * 181);
    let residual = |line: &str| line.rsplit(',').next().unwrap().parse::<f64>().unwrap();
    assert!(text.lines().skip(1).all(|line| residual(line) <= 1e-9));
}

#[test]
fn the_same_input_gives_the_same_bytes_on_any_number_of_threads() {
    let bench = Bench::default();
    let run = |threads: &str, name: &str| {
        let path = bench.path(name).display().to_string();
        let mut command = assert_cmd::Command::cargo_bin("driftpost").unwrap();
        command.current_dir(env!("CARGO_MANIFEST_DIR")).env("RAYON_NUM_THREADS", threads);
        let output = command.args(["compensate", CUBE, "-o", &path, "--json", "-"]).output().unwrap();
        (output.stdout, fs::read(&path).unwrap())
    };
    assert_eq!(run("1", "a.mod"), run("5", "b.mod"));
}

#[test]
fn the_list_of_modules_names_the_core_too() {
    let bench = Bench::default();
    let cube = fs::read_to_string(CUBE).unwrap();
    let second = cube
        .replace("MOD_Cube45", "MOD_Second")
        .replace("Cube45()", "Second()")
        .replace("rdkSpeed", "rdkFast");
    assert_ne!(cube, second);
    bench.file("cell/A.mod", &cube);
    bench.file("cell/sub/B.mod", &second);
    let list = "<Program>\n\t<Module>A.mod</Module>\n\t<Module>sub\\B.mod</Module>\n</Program>\n";
    let pgf = bench.file("cell/cell.pgf", list);
    let output = driftpost(&["compensate", &pgf, "--diff", "none"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let with_core = list.replace("\n</Program>", "\n\t<Module>tcCore.mod</Module>\n</Program>");
    assert_eq!(bench.text("cell/cell_tc/cell.pgf"), with_core);
    let minutes = bench.path("cell/cell_tc/cell.pgf").display().to_string();
    let output =
        driftpost(&["simulate", &minutes, "--original", &pgf, "--minutes", "0,61", "--entry", "Cube45"]);
    assert_eq!(output.status.code(), Some(0), "{} {}", out(&output), err(&output));
    let output = driftpost(&["compensate", &pgf, "--in-place", "--diff", "none"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert_eq!(bench.text("cell/cell.pgf"), with_core);
}

/// System modules stay where another program is loaded, program modules go (ABB, Technical reference manual RAPID Overview, system modules).
#[test]
fn a_core_beside_a_system_module_is_one_too() {
    let cube = fs::read_to_string(CUBE).unwrap();
    let second = cube.replace("Cube45()", "Second()").replace("rdkSpeed", "rdkFast");
    let [plain, system] =
        ["MOD_Second", "MOD_Second(SYSMODULE)"].map(|head| second.replace("MOD_Cube45", head));
    let run = |arguments: &[&str]| {
        let output = driftpost(arguments);
        assert_eq!(output.status.code(), Some(0), "{} {}", out(&output), err(&output));
    };
    for (first, other, text, core) in [
        ("A.mod", "SYSMOD/B.sys", &system, "SYSMOD/tcCore.sys"),
        ("A.modx", "SYSMOD/B.sysx", &system, "SYSMOD/tcCore.sysx"),
        ("A.mod", "sub/B.SYS", &plain, "sub/tcCore.sys"),
        ("A.mod", "sub/B.mod", &system, "sub/tcCore.mod"),
        ("Z.mod", "SYSMOD/B.mod", &plain, "SYSMOD/tcCore.mod"),
    ] {
        let bench = Bench::default();
        let list = |modules: &str| format!("<Program>\n\t<Module>{modules}</Module>\n</Program>\n");
        bench.file(&format!("cell/{first}"), &cube);
        bench.file(&format!("cell/{other}"), text);
        let program = list(first);
        bench.file("cell/program.pgf", &program);
        let both = list(&format!("{first}</Module>\n\t<Module>{other}"));
        bench.file("cell/both.pgf", &both);
        let [cell, made, back] = ["cell", "made", "back"].map(|name| bench.path(name).display().to_string());
        run(&["compensate", &cell, "-o", &made, "--diff", "none"]);
        let cores: Vec<String> = bench.files().into_iter().filter(|file| file.contains("tcCore")).collect();
        assert_eq!(cores, [format!("made/{core}")]);
        assert!(bench.text(&cores[0]).starts_with("MODULE tcCore(SYSMODULE)"), "{}", bench.text(&cores[0]));
        let with_core = both.replace("\n</Program>", &format!("\n\t<Module>{core}</Module>\n</Program>"));
        assert_eq!(bench.text("made/both.pgf"), with_core);
        if !core.ends_with(".mod") {
            assert_eq!(bench.text("made/program.pgf"), program, "system modules are none of a program's");
        }
        for (made, original) in [(&made, &cell), (&format!("{made}/both.pgf"), &format!("{cell}/both.pgf"))] {
            run(&["simulate", made, "--original", original, "--minutes", "0,61", "--entry", "Second"]);
        }
        run(&["restore", &made, "-o", &back]);
        let (restored, given): (Vec<String>, Vec<String>) = bench
            .files()
            .into_iter()
            .filter(|file| !file.starts_with("made/"))
            .partition(|file| file.starts_with("back/"));
        assert_eq!(restored.len(), given.len());
        for file in given {
            assert_eq!(bench.text(&file.replacen("cell/", "back/", 1)), bench.text(&file), "{file}");
        }
    }
}

#[test]
fn a_controllers_backup_goes_through_whole() {
    let bench = Bench::default();
    let cube = fs::read_to_string(CUBE).unwrap();
    let main = "MODULE Main\n  PROC main()\n    Cube45;\n  ENDPROC\nENDMODULE\n";
    bench.file("backup/RAPID/TASK1/PROGMOD/Cube45.mod", &cube);
    bench.file("backup/RAPID/TASK1/PROGMOD/Main.mod", main);
    bench.file(
        "backup/RAPID/TASK1/SYSMOD/user.sys",
        "MODULE user(SYSMODULE)\n  PERS num nUser:=1;\nENDMODULE\n",
    );
    // Another task has the same names, and the disk a copy of the program.
    bench.file(
        "backup/RAPID/TASK2/PROGMOD/Main.mod",
        "MODULE Main\n  PROC main()\n    WaitTime 1;\n  ENDPROC\nENDMODULE\n",
    );
    bench.file("backup/HOME/old/Cube45.mod", &cube);
    bench.file("backup/BACKINFO/backinfo.txt", "IRC5");
    let backup = bench.path("backup").display().to_string();
    for form in ["schedule", "ramp"] {
        let to = bench.path(form).display().to_string();
        let output = driftpost(&["compensate", &backup, "-o", &to, "--form", form, "--diff", "none"]);
        assert_eq!(output.status.code(), Some(0), "{}", err(&output));
        assert_eq!(bench.text(&format!("{form}/HOME/old/Cube45.mod")), cube);
        assert_eq!(bench.text(&format!("{form}/BACKINFO/backinfo.txt")), "IRC5");
        let output = driftpost(&["simulate", &to, "--original", &backup, "--minutes", "0,61,420"]);
        assert_eq!(output.status.code(), Some(0), "{} {}", out(&output), err(&output));
        assert!(out(&output).contains("138 moves executed"), "{}", out(&output));
    }
}

#[test]
fn two_robots_of_a_backup_are_compensated_one_by_one() {
    let bench = Bench::default();
    let cube = fs::read_to_string(CUBE).unwrap();
    for task in ["TASK1", "TASK2"] {
        bench.file(&format!("backup/RAPID/{task}/PROGMOD/Cube45.mod"), &cube);
    }
    let backup = bench.path("backup").display().to_string();
    let to = bench.path("out").display().to_string();
    let output = driftpost(&["compensate", &backup, "-o", &to, "--diff", "none"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("emit::several-tasks") && err(&output).contains("TASK1, TASK2"));
    let one = bench.path("backup/RAPID/TASK2").display().to_string();
    let output = driftpost(&["compensate", &one, "-o", &to, "--diff", "none"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let output = driftpost(&["simulate", &to, "--original", &one, "--minutes", "0,61"]);
    assert_eq!(output.status.code(), Some(0), "{} {}", out(&output), err(&output));
}

const SLOW: &str = "MODULE m
  PERS tooldata tGrip:=[TRUE,[[0,0,90],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  CONST robtarget p1:=[[450,-100,300],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget p2:=[[450,100,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  VAR num d:=0;
  PROC main()
    WHILE TRUE DO
@    ENDWHILE
  ENDPROC
ENDMODULE
";

/// The largest error of the corrected moves after five hours of work, mm; `speed` is what the program is run
/// at in place of v10.
fn after_five_hours(body: &str, speed: &str, more: &[&str]) -> f64 {
    let bench = Bench::default();
    let original = bench.file("p.mod", SLOW.replace('@', body));
    let emitted = bench.path("p_tc.mod").display().to_string();
    let run = driftpost(&[&["compensate", &original, "-o", &emitted, "--diff", "none"][..], more].concat());
    assert_eq!(run.status.code(), Some(0), "{}", err(&run));
    for path in [&original, &emitted] {
        let text = fs::read_to_string(path).unwrap().replace("v10,", speed);
        fs::write(path, text).unwrap();
    }
    let scenario = bench.file("s.toml", "steps = [\"call tcColdStart\", \"run 300\"]\n");
    let run =
        driftpost(&["simulate", &emitted, "--original", &original, "--scenario", &scenario, "--json", "-"]);
    let json: Value = serde_json::from_slice(&run.stdout).unwrap();
    let minutes = json["minutes"].as_array().unwrap();
    assert!(minutes.len() > 2, "{minutes:?}");
    minutes.iter().map(|m| m["corrected"]["max_mm"].as_f64().unwrap()).fold(0.0, f64::max)
}

#[test]
fn slow_work_is_not_taken_for_a_pause() {
    let there_and_back = "      MoveL p1,v10,fine,tGrip;\n      MoveL p2,v10,fine,tGrip;\n".repeat(10);
    // A bucket is right to its tolerance, and the drift goes on while the arm moves to its target.
    for (speed, more, limit) in [
        ("v10,", &[][..], 0.0075),
        ("v5,", &["--tolerance-mm", "0.01"], 0.015),
        ("v5,", &["--gap-min", "2"], 0.0075),
    ] {
        let worst_mm = after_five_hours(&there_and_back, speed, more);
        assert!(worst_mm < limit, "{speed} {more:?}: {worst_mm} mm");
    }
    // One corrected move among many that are kept.
    let kept = "      MoveL p1,v10,fine,tGrip;\n      FOR i FROM 1 TO 10 DO\n        d:=i;\n        MoveL Offs(p2,0,0,d),v10,fine,tGrip;\n        MoveL Offs(p1,0,0,d),v10,fine,tGrip;\n      ENDFOR\n";
    // A time that a motion is given counts in place of its speed: 6 min here, as long as a pause.
    let bench = Bench::default();
    let timed = there_and_back.replace("v10,", "v10\\T:=360,");
    let original = bench.file("p.mod", SLOW.replace('@', &timed));
    let output = driftpost(&["compensate", &original, "--diff", "none"]);
    assert!(err(&output).contains("clock::long-motion"), "{}", err(&output));
    // So does a speed that VelSet takes down: half a minute for a move at 10 mm/s, 8 min at a sixteenth of it.
    let slowed = format!("      VelSet 6.25,5000;\n{there_and_back}");
    let original = bench.file("v.mod", SLOW.replace('@', &slowed));
    let output = driftpost(&["compensate", &original, "--diff", "none"]);
    assert!(err(&output).contains("clock::long-motion"), "{}", err(&output));
    let original = bench.file("u.mod", SLOW.replace('@', &there_and_back));
    let output = driftpost(&["compensate", &original, "--diff", "none"]);
    assert!(!err(&output).contains("clock::long-motion"), "{}", err(&output));
    // Kept motion does not ask: that is said, and the program may ask itself.
    let worst_mm = after_five_hours(&kept.replace("d:=i;", "d:=i;tcUpdate;"), "v10,", &[]);
    assert!(worst_mm < 0.0075, "{worst_mm} mm");
    let bench = Bench::default();
    let original = bench.file("p.mod", SLOW.replace('@', kept));
    let output = driftpost(&["compensate", &original, "--diff", "none"]);
    assert!(
        err(&output).contains("clock::long-motion") && err(&output).contains("tcUpdate"),
        "{}",
        err(&output)
    );
}

/// Programs side by side in a folder each have a `main`: each is corrected, and that no controller loads both is said.
#[test]
fn names_that_two_modules_give_to_their_task_are_told() {
    let module = |name: &str, scope: &str| {
        format!(
            "MODULE {name}\r\n  {scope}CONST robtarget p10:=[[500,0,400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\r\n  \
             {scope}PROC main()\r\n    MoveJ p10,v100,fine,tool0;\r\n  ENDPROC\r\nENDMODULE\r\n"
        )
    };
    let bench = Bench::default();
    let first = bench.file("A.mod", module("A", ""));
    for (scope, told) in [("", true), ("LOCAL ", false)] {
        let second = bench.file("B.mod", module("B", scope));
        let to = bench.path("out").display().to_string();
        let output = driftpost(&["compensate", &first, &second, "-o", &to, "--force", "--diff", "none"]);
        assert_eq!(output.status.code(), Some(0), "{}", err(&output));
        let message = err(&output);
        assert_eq!(message.contains("input::name-twice"), told, "{message}");
        assert!(
            !told || message.contains("p10 is declared globally in") && message.contains("1 more such name"),
            "{message}"
        );
    }
}

/// A line from axis 1 at 40 deg to -40 with 170 deg of tool turn takes axis 6 from 125 deg down to -125 (followed by hand in 2,000 steps),
/// not up to 235; from a whole turn lower it would leave its range.
#[test]
fn an_axis_that_turns_by_more_than_half_a_turn_on_a_line_is_followed() {
    let module = |axis_6: &str| {
        format!(
            "MODULE Turn
  PERS tooldata tX:=[TRUE,[[100,0,60],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  PROC main()
    ConfL\\On;
    MoveAbsJ [[40,10,20,0,60,{axis_6}],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tX;
    MoveL [[344.89284,-396.33216,391.53079],[0,-0.675590208,0.737277337,0],[-1,0,-2,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tX;
  ENDPROC
ENDMODULE
"
        )
    };
    let bench = Bench::default();
    let model = bench.file(
        "gain.toml",
        "format = 1\nrobot = \"irb140\"\n[[effect]]\neffect = \"joint_gain\"\njoint = 6\ngain = 0.0002\n",
    );
    let [to, csv, json] = ["tc.mod", "q.csv", "s.json"].map(|name| bench.path(name).display().to_string());
    let source = bench.file("turn.mod", module("125"));
    for form in ["schedule", "ramp", "live"] {
        let made =
            ["--model", &model, "--form", form, "-o", &to, "--joints-csv", &csv, "--force", "--diff", "none"];
        let output = driftpost(&[&["compensate", &source][..], &made].concat());
        assert_eq!(output.status.code(), Some(0), "{}", err(&output));
        assert!(!err(&output).contains("conf::disagrees"), "{}", err(&output));
        let last = bench.text("q.csv");
        let axis_6: f64 = last.lines().last().unwrap().split(',').nth(9).unwrap().parse().unwrap();
        assert!((axis_6 + 125.0).abs() < 0.1, "{form}: {axis_6}");
        let played = ["--original", &source, "--minutes", "0", "--model", &model, "--json", &json];
        let output = driftpost(&[&["simulate", &to][..], &played].concat());
        assert_eq!(output.status.code(), Some(0), "{form}: {}{}", out(&output), err(&output));
        let worst: Value = serde_json::from_str(&bench.text("s.json")).unwrap();
        assert!(worst["worst"]["mm"].as_f64().unwrap() < 1e-4, "{form}: {worst}");
    }
    let lower = bench.file("lower.mod", module("-235"));
    let output =
        driftpost(&["compensate", &lower, "--model", &model, "-o", &to, "--force", "--diff", "none"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let why = "on a straight line axis 6 would turn to -485.0 deg, out of its range";
    assert!(err(&output).contains("reach::range") && err(&output).contains(why), "{}", err(&output));
}
