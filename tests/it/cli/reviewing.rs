//! `diff` and `simulate` as a reviewer meets them: what the emitted module says is taken from it, and nothing is ever
//! called fine that was not looked at.

use super::{Bench, CUBE, driftpost, err, out};
use serde_json::Value;

const TOOL: &str = "tGrip=[TRUE,[[0,0,90],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]]";

/// A module with two motions of a tool that it does not declare, in a frame that it does not declare.
const ELSEWHERE: &str = "MODULE m
  CONST robtarget p1:=[[300,-100,300],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget p2:=[[300,100,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  PROC main()
    MoveL p1,v100,fine,tGrip\\WObj:=wTable;
    MoveL p2,v100,fine,tGrip\\WObj:=wTable;
  ENDPROC
ENDMODULE
";

#[test]
fn robot_tools_and_frames_are_read_from_the_emitted_module() {
    let bench = Bench::default();
    let source = bench.file("m.mod", ELSEWHERE);
    let emitted = bench.path("m_tc.mod").display().to_string();
    let wobj = "wTable=[FALSE,TRUE,\"\",[[150,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]]";
    let options =
        ["--robot", "irb1200", "--allow-other-robot", "--tool", TOOL, "--wobj", wobj, "--diff", "none"];
    let made = driftpost(&[&["compensate", &source, "-o", &emitted][..], &options].concat());
    assert_eq!(made.status.code(), Some(0), "{}", err(&made));
    let text = bench.text("m_tc.mod");
    assert!(text.contains("! driftpost with: tool tGrip=[TRUE") && text.contains(" irb1200\n"), "{text}");
    let json = |arguments: &[&str], code: i32| -> Value {
        let output = driftpost(&[arguments, &["--json", "-"]].concat());
        assert_eq!(output.status.code(), Some(code), "{arguments:?} {}", err(&output));
        serde_json::from_slice(&output.stdout).unwrap()
    };
    let simulated = json(&["simulate", &emitted, "--minutes", "0,61"], 0);
    assert_eq!(simulated["executed"], serde_json::json!({"motions": 2, "of": 2}));
    let reported = json(&["diff", &source, &emitted], 0);
    assert_eq!(reported["same_elsewhere"], Value::Bool(true));
    // Known tools and the arm of the header: every motion has figures, and joints of that arm.
    let last = |motion: &Value| motion["buckets"].as_array().unwrap().last().cloned().unwrap();
    for motion in reported["motions"].as_array().unwrap() {
        assert!(
            last(motion)["dp_mm"].as_f64().unwrap() > 0.01 && last(motion)["joint_deg"].is_number(),
            "{motion}"
        );
    }
    // An option wins: a tool of another length turns the same correction into another.
    let other = TOOL.replace("90", "190");
    let otherwise = json(&["diff", &source, &emitted, "--tool", &other], 0);
    let joint = |reported: &Value| last(&reported["motions"][0])["limit_margin_deg"].as_f64().unwrap();
    assert!((joint(&reported) - joint(&otherwise)).abs() > 0.1);
}

#[test]
fn a_robot_file_is_found_beside_the_module_and_known_by_its_hash() {
    let bench = Bench::default();
    let toml = std::fs::read_to_string("crates/robot-model/src/robot/built_in/irb140.toml").unwrap();
    let robot = bench.file("mine.toml", toml.replace("ABB IRB 140-6/0.8", "my arm"));
    let emitted = bench.path("out/cube.mod").display().to_string();
    let made = driftpost(&["compensate", CUBE, "-o", &emitted, "--robot", &robot, "--diff", "none"]);
    assert_eq!(made.status.code(), Some(0), "{}", err(&made));
    let run = |more: &[&str]| driftpost(&[&["simulate", &emitted][..], more].concat());
    assert_eq!(run(&[]).status.code(), Some(0), "{}", err(&run(&[])));
    bench.file("mine.toml", &toml);
    assert!(err(&run(&[])).contains("another robot than"), "{}", err(&run(&[])));
    std::fs::remove_file(&robot).unwrap();
    let missing = run(&[]);
    assert_eq!(missing.status.code(), Some(2));
    assert!(
        err(&missing).contains("made-with::missing") && err(&missing).contains("--robot"),
        "{}",
        err(&missing)
    );
    assert_eq!(run(&["--robot", "irb140"]).status.code(), Some(0));
}

#[test]
fn modules_of_a_backup_are_paired_by_their_place() {
    let bench = Bench::default();
    let module = |n: u32| {
        format!(
            "MODULE MainModule\n  VAR num n:={n};\n  PROC main()\n    WaitTime {n};\n  ENDPROC\nENDMODULE\n"
        )
    };
    for (backup, second) in [("a", 2), ("b", 3)] {
        bench.file(&format!("{backup}/RAPID/TASK1/PROGMOD/MainModule.mod"), module(1));
        bench.file(&format!("{backup}/RAPID/TASK2/PROGMOD/MainModule.mod"), module(second));
        bench.file(&format!("{backup}/SYSPAR/EIO.cfg"), "EIO:CFG_1.0");
    }
    let [a, b] = ["a", "b"].map(|name| bench.path(name).display().to_string());
    let output = driftpost(&["diff", &a, &b]);
    assert_eq!(output.status.code(), Some(1));
    let text = out(&output);
    assert!(text.contains("first at") && text.contains("TASK2/PROGMOD/MainModule.mod:2"), "{text}");
    assert!(!text.contains("TASK1") && text.contains("DIFFERENT beside the targets"), "{text}");
    bench.file("b/RAPID/TASK2/PROGMOD/MainModule.mod", module(2));
    assert_eq!(driftpost(&["diff", &a, &b]).status.code(), Some(0));
    bench.file("b/SYSPAR/EIO.cfg", "EIO:CFG_1.1");
    let output = driftpost(&["diff", &a, &b]);
    assert_eq!(output.status.code(), Some(1));
    assert!(out(&output).contains("SYSPAR/EIO.cfg differs."), "{}", out(&output));
}

#[test]
fn a_text_that_differs_is_never_the_same() {
    let bench = Bench::default();
    let text = "MODULE m\n  PERS tooldata tG:=[TRUE,[[0,0,90],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];\n  \
        CONST robtarget p:=[[450,-100,300],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n  PROC main(num d)\n    \
        MoveL Offs(p,0,0,d),v100,fine,tG;\n    MoveL p,v100,fine,tUnknown;\n  ENDPROC\nENDMODULE\n";
    let a = bench.file("a.mod", text);
    for (from, by, beside) in [
        ("0,0,d)", "0,0,d+5)", true),  // a target that only run time knows
        ("[[450,", "[[451,", true),    // a target that no known tool goes to, and one that is read
        ("  PROC", "    PROC", false), // the layout alone
        ("[0,0,1,0]", "[0,0,-1,0]", true),
    ] {
        let b = bench.file("b.mod", text.replacen(from, by, 1));
        let output = driftpost(&["diff", &a, &b]);
        assert_eq!(output.status.code(), Some(1), "{by}: {}", out(&output));
        assert_eq!(out(&output).contains("DIFFERENT"), beside, "{by}: {}", out(&output));
    }
}

#[test]
fn nothing_is_within_of_nothing() {
    let bench = Bench::default();
    let idle = bench.file("idle.mod", "MODULE m\n  PROC main()\n    WaitTime 1;\n  ENDPROC\nENDMODULE\n");
    let output = driftpost(&["simulate", &idle, "--minutes", "0,60"]);
    assert_eq!(output.status.code(), Some(2), "{}", out(&output));
    assert!(
        out(&output).contains("NOTHING was judged") && !out(&output).contains("within"),
        "{}",
        out(&output)
    );
    assert!(
        out(&output).starts_with("2 passes, 0 moves executed: 0 of the program's 0 motions"),
        "{}",
        out(&output)
    );
}

const CELL: &str = "MODULE m
  PERS tooldata tG:=[TRUE,[[0,0,90],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  PERS num nWork:=0;
  CONST robtarget p1:=[[450,-100,300],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget p2:=[[450,100,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  PROC main()
    WHILE DInput(diStart)=0 DO
      WaitTime 0.1;
    ENDWHILE
    MoveL p1,v100,fine,tG;
    IF nWork=2 THEN
      MoveL p2,v100,fine,tG;
    ENDIF
  ENDPROC
ENDMODULE
";

#[test]
fn a_cell_is_set_from_outside_and_a_wait_in_vain_is_named() {
    let bench = Bench::default();
    let source = bench.file("m.mod", CELL);
    let emitted = bench.path("m_tc.mod").display().to_string();
    assert!(driftpost(&["compensate", &source, "-o", &emitted, "--diff", "none"]).status.success());
    let run = |more: &[&str]| driftpost(&[&["simulate", &emitted, "--original", &source][..], more].concat());
    let start = std::time::Instant::now();
    let waits = run(&["--minutes", "0:180:1"]);
    assert!(start.elapsed().as_secs() < 10, "two seconds where it is optimised");
    assert_eq!(waits.status.code(), Some(2));
    let sentence = "m.mod:7: this loop waits for diStart, which nothing in the program changes";
    assert!(err(&waits).contains(sentence) && err(&waits).contains("--set"), "{}", err(&waits));
    let first_line = |more: &[&str]| {
        let output = run(more);
        assert_eq!(output.status.code(), Some(0), "{}", err(&output));
        out(&output).lines().next().unwrap().to_owned()
    };
    let started = ["--set", "diStart=1", "--minutes", "0,60"];
    assert_eq!(first_line(&started), "2 passes, 2 moves executed: 1 of the program's 2 motions (50 %)");
    let all = first_line(&[&started[..], &["--set", "nWork=2"]].concat());
    assert_eq!(all, "2 passes, 4 moves executed: 2 of the program's 2 motions (100 %)");
    let wrong = run(&["--set", "nWrok=2"]);
    assert_eq!(wrong.status.code(), Some(2));
    assert!(err(&wrong).contains("did you mean nWork?"), "{}", err(&wrong));
    let no_level = run(&["--set", "diStart=on"]);
    assert!(no_level.status.code() == Some(2) && err(&no_level).contains("no level"), "{}", err(&no_level));
}

#[test]
fn a_misspelt_entry_or_step_is_answered_with_the_right_one() {
    let bench = Bench::default();
    let entry = driftpost(&["simulate", CUBE, "--entry", "Cub45"]);
    assert!(
        entry.status.code() == Some(2) && err(&entry).contains("did you mean Cube45?"),
        "{}",
        err(&entry)
    );
    for (step, meant) in [("runn 60", "run"), ("pp_to_mian", "pp_to_main"), ("call Cube54", "Cube45")] {
        let scenario = bench.file("s.toml", format!("steps = [\"{step}\"]\n"));
        let output = driftpost(&["simulate", CUBE, "--scenario", &scenario]);
        assert_eq!(output.status.code(), Some(2));
        assert!(err(&output).contains(&format!("did you mean {meant}?")), "{step}: {}", err(&output));
    }
}

#[test]
fn two_modules_of_one_name_are_refused_by_both() {
    let bench = Bench::default();
    let cube = std::fs::read_to_string(CUBE).unwrap();
    bench.file("cell/Cube45.mod", &cube);
    bench.file("cell/old/Cube45.mod", &cube);
    let folder = bench.path("cell").display().to_string();
    let [compensated, simulated] = [&["compensate", &folder][..], &["simulate", &folder]].map(driftpost);
    assert_eq!([compensated.status.code(), simulated.status.code()], [Some(2); 2]);
    let sentence = "error[input::module-twice]: module MOD_Cube45 is there twice";
    for output in [&compensated, &simulated] {
        assert!(err(output).contains(sentence) && err(output).contains("old/Cube45.mod"), "{}", err(output));
    }
}

/// Which signal shows the temperature is what the module was made with; of another program it must be said.
#[test]
fn the_thermometer_is_the_one_that_the_modules_clock_reads() {
    let bench = Bench::default();
    let to = bench.path("signal.mod").display().to_string();
    let table = "fixtures/first_run/temperature.csv";
    let words =
        ["compensate", CUBE, "--clock", "signal:aiTemp", "--deformation", table, "-o", &to, "--diff", "none"];
    let output = driftpost(&words);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let shown = ["simulate", &to, "--original", CUBE, "--deformation", table, "--minutes", "22,30,40"];
    let output = driftpost(&shown);
    assert_eq!(output.status.code(), Some(0), "{} {}", out(&output), err(&output));
    assert!(!err(&output).contains("--thermometer"), "{}", err(&output));
    // The original has no clock that says so.
    let output = driftpost(&["simulate", CUBE, "--deformation", table, "--minutes", "40"]);
    assert_eq!(output.status.code(), Some(1), "{} {}", out(&output), err(&output));
    assert!(err(&output).contains("--thermometer NAME names the analog input"), "{}", err(&output));
}

/// A module that the program loads lies on the disk of both controllers, the original's and the corrected program's.
#[test]
fn the_original_loads_its_modules_too() {
    let bench = Bench::default();
    let target = |x: i32| format!("[[{x},60,350],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]");
    bench.file(
        "cell/Main.mod",
        format!(
            "MODULE MainModule\n  PROC main()\n    MoveAbsJ [[0,0,0,0,90,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\n    \
             Load \\Dynamic,\"HOME:/More.mod\";\n    %\"rMore\"%;\n    UnLoad \"HOME:/More.mod\";\n    \
             MoveL {},v100,fine,tool0;\n  ENDPROC\nENDMODULE\n",
            target(420)
        ),
    );
    bench.file(
        "cell/HOME/More.mod",
        format!(
            "MODULE More\n  PROC rMore()\n    MoveL {},v100,fine,tool0;\n  ENDPROC\nENDMODULE\n",
            target(400)
        ),
    );
    let [cell, made] = ["cell", "made"].map(|name| bench.path(name).display().to_string());
    assert_eq!(driftpost(&["compensate", &cell, "-o", &made]).status.code(), Some(0));
    for program in [[&made, &cell], [&cell, &cell]] {
        let [program, original] = program.map(String::as_str);
        let output =
            driftpost(&["simulate", program, "--original", original, "--minutes", "0,60", "--json", "-"]);
        let report: Value = serde_json::from_slice(&output.stdout).unwrap();
        for pass in report["minutes"].as_array().unwrap() {
            assert!(pass["failure"].is_null() && pass["mismatch"].is_null() && pass["n"] == 3, "{pass}");
        }
    }
    let alone = driftpost(&["simulate", &cell, "--minutes", "0"]);
    assert_eq!(alone.status.code(), Some(0), "{}", out(&alone));
}

/// Two motions in a frame that a camera gives, after one that is known.
const SEEN: &str = "MODULE m
  PERS wobjdata wSeen:=[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
  CONST robtarget p1:=[[400,100,400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget p2:=[[380,50,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  PROC main()
    VAR string answer;
    VAR bool isPose;
    VAR pose seen;
KNOWN    SocketReceive camera\\Str:=answer;
    isPose:=StrToVal(answer,seen);
    wSeen.oframe:=seen;
    MoveL p1,v100,fine,tool0\\WObj:=wSeen;
    MoveL p2,v100,fine,tool0\\WObj:=wSeen;
  ENDPROC
  VAR socketdev camera;
ENDMODULE
";

#[test]
fn where_run_time_can_correct_what_is_kept_that_is_said() {
    let bench = Bench::default();
    let known = bench.file("known.mod", SEEN.replace("KNOWN", "    MoveL p1,v100,fine,tool0;\n"));
    let unknown = bench.file("unknown.mod", SEEN.replace("KNOWN", ""));
    let emitted = bench.path("out.mod").display().to_string();
    let made = |source: &str, form: &str| {
        driftpost(&["compensate", source, "--form", form, "-o", &emitted, "--diff", "none"])
    };
    for form in ["schedule", "ramp"] {
        let part = out(&made(&known, form));
        assert!(
            part.contains(
                "\nall 2 kept go to what only the running program knows: --form auto corrects them"
            ),
            "{part}"
        );
        let none = made(&unknown, form);
        assert_eq!(none.status.code(), Some(2));
        assert!(err(&none).contains(
            "= help: all 2 kept go to what only the running program knows: --form auto corrects them"
        ));
    }
    // What an option leaves alone no form corrects.
    for form in ["ramp", "auto"] {
        let kept = out(&driftpost(&[
            "compensate",
            &known,
            "--form",
            form,
            "--keep",
            "p2",
            "-o",
            &emitted,
            "--diff",
            "none",
        ]));
        let is_hinted = kept.contains("1 of those kept goes to what only the running program knows");
        assert_eq!(is_hinted, form == "ramp", "{kept}");
    }
    // Nor what the model holds and a program cannot.
    let model = ["--model", "fixtures/model/every_effect.toml", "--temperature-c", "30"];
    let ramp = driftpost(
        &[&["compensate", &known, "--form", "ramp", "-o", &emitted, "--diff", "none"][..], &model].concat(),
    );
    assert!(
        out(&ramp).contains(" 2 kept,") && !out(&ramp).contains("--form auto"),
        "{}{}",
        out(&ramp),
        err(&ramp)
    );
    for source in [&known, &unknown] {
        let all = out(&made(source, "auto"));
        assert!(all.contains(" 0 kept,") && !all.contains("--form auto"), "{all}");
    }
}

/// `tcStartAt` asks for the minute: it was called without, and the robot was cold, whatever stood behind it.
#[test]
fn a_routine_is_called_with_the_values_that_a_scenario_gives() {
    let bench = Bench::default();
    let emitted = bench.path("tc.mod").display().to_string();
    assert!(driftpost(&["compensate", CUBE, "-o", &emitted, "--quiet"]).status.success());
    let played = |step: &str| {
        let scenario = bench.file("s.toml", format!("steps = [\"{step}\", \"pass\"]\n"));
        let csv = bench.path("s.csv").display().to_string();
        let output =
            driftpost(&["simulate", &emitted, "--original", CUBE, "--scenario", &scenario, "--csv", &csv]);
        (output.status.code(), err(&output))
    };
    let (_, message) = played("call tcStartAt 30");
    let csv = bench.text("s.csv");
    let mut lines = csv.lines();
    let at = lines.next().unwrap().split(',').position(|name| name == "program_min").unwrap();
    let minutes: f64 = lines.next().unwrap().split(',').nth(at).unwrap().parse().unwrap();
    assert!((30.0..31.0).contains(&minutes), "{minutes} {message}");
    for (step, why) in [
        ("call tcStartAt", "the argument for"),
        ("call tcStartAt soon", "`soon` is no num"),
        ("call tcColdStart 55", "more arguments than parameters"),
    ] {
        let (code, message) = played(step);
        assert_eq!(code, Some(2), "{step}: {message}");
        assert!(message.contains(why), "{step}: {message}");
    }
}

/// A model whose terms go by several laws of time: each motion names a correction for each function of time, and each of these is all that
/// the arm needs at one moment. What is told of a motion is how far those shift it, by the text alone.
#[test]
fn corrections_by_several_functions_of_time_are_told_one_by_one() {
    let bench = Bench::default();
    let to = bench.path("tc.mod").display().to_string();
    let model = "fixtures/model/every_effect.toml";
    let options = ["--model", model, "--temperature-c", "30", "--form", "ramp", "--diff", "none"];
    let made = driftpost(&[&["compensate", CUBE, "-o", &to][..], &options].concat());
    assert_eq!(made.status.code(), Some(0), "{}", err(&made));
    let text = bench.text("tc.mod");
    let shift_mm = |name: &str| -> f64 {
        let declared = text.split(&format!("CONST pose {name}:=[[")).nth(1).unwrap();
        let numbers = declared.split(']').next().unwrap().split(',');
        numbers.map(|mm| mm.parse::<f64>().unwrap().powi(2)).sum::<f64>().sqrt()
    };
    let output = driftpost(&["diff", CUBE, &to, "--json", "-"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let json: Value = serde_json::from_slice(&output.stdout).unwrap();
    let buckets = json["motions"][1]["buckets"].as_array().unwrap();
    let shifts: Vec<f64> = buckets.iter().map(|bucket| bucket["dp_mm"].as_f64().unwrap()).collect();
    let declared = ["tc31", "tc31_2", "tc31_3", "tc31_4"].map(shift_mm);
    assert_eq!((shifts.len(), shifts[0]), (1 + declared.len(), 0.0));
    // As many digits as the text has.
    assert!(shifts[1..].iter().zip(declared).all(|(a, b)| (a - b).abs() < 1e-5), "{shifts:?} {declared:?}");
    assert!(json["worst"]["dp_mm"].as_f64().unwrap() > 0.5, "{}", json["worst"]);

    // A motion that asks with another target's correction, and an original that was moved: who reviews is told where.
    let line = |text: &str, what: &str| text.lines().position(|line| line.contains(what)).unwrap() + 1;
    let swapped = text.replacen(",tc31,", ",tc32,", 1);
    let moved = text.replacen("MoveL tcAt([[400.000, 300", "MoveL tcAt([[401.000, 300", 1);
    for (name, edited) in [("swapped.mod", swapped), ("moved.mod", moved)] {
        assert_ne!(edited, text);
        let place = format!("{}:{}", name, line(&text, "tcAt([[400.000, 300"));
        let output = driftpost(&["diff", CUBE, &bench.file(name, edited)]);
        let shown = out(&output);
        assert_eq!(output.status.code(), Some(1), "{shown}");
        assert!(shown.contains("NOT declared") && shown.contains(&place), "{shown}");
    }
}
