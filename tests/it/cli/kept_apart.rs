//! What must not add up, and what must not be written over: one drift given twice, names that mean something else, files of somebody else's.

use super::{Bench, CUBE, driftpost, err, out};
use std::path::Path;

/// Model and table that `fit` makes of the documentation's touches.
fn fitted(bench: &Bench) -> [String; 2] {
    let [model, table] = ["drift.toml", "drift.csv"].map(|name| bench.path(name).display().to_string());
    let touches = "fixtures/docs/touches.csv";
    let made =
        driftpost(&["fit", touches, "--tool", "0,0,100", "--model-out", &model, "--table-out", &table]);
    assert!(made.status.success(), "{}", err(&made));
    [model, table]
}

#[test]
fn the_model_and_the_table_of_one_fit_are_one_drift() {
    let bench = Bench::default();
    let [model, table] = fitted(&bench);
    let to = bench.path("tc.mod").display().to_string();
    let compensate = |more: &[&str]| {
        let output = driftpost(&[&["compensate", CUBE, "-o", &to, "--diff", "none"][..], more].concat());
        (output.status.code(), err(&output))
    };
    let (code, message) = compensate(&["--model", &model, "--deformation", &table]);
    assert!(code == Some(2) && message.contains("deform::twice"), "{message}");
    // The terms of a model have a law of their own, and the clock goes by it.
    for of in [&["compensate", CUBE, "-o", &to, "--diff", "none"][..], &["simulate", CUBE, "--minutes", "60"]]
    {
        let output = driftpost(&[of, &["--model", &model, "--growth", "exp:20"]].concat());
        let message = err(&output);
        assert!(output.status.code() == Some(2) && message.contains("deform::growth-not-used"), "{message}");
    }
    assert!(!Path::new(&to).exists());
    for alone in [&["--model", &*model][..], &["--deformation", &*table, "--tau-cool", "41"]] {
        let (code, message) = compensate(alone);
        assert!(code == Some(0), "{message}");
    }
}

/// In the folder that it runs in, a place without a folder before it is in that folder too.
#[test]
fn a_common_module_of_another_program_is_kept_in_the_current_folder_too() {
    let bench = Bench::default();
    for name in ["Part.mod", "Cell.mod"] {
        bench.file(name, std::fs::read(CUBE).unwrap());
    }
    let run = |arguments: &[&str]| {
        let here = bench.path("");
        assert_cmd::Command::cargo_bin("driftpost")
            .unwrap()
            .args(arguments)
            .current_dir(here)
            .output()
            .unwrap()
    };
    let first = run(&["compensate", "Part.mod", "--core", "separate", "-o", "P.mod"]);
    assert!(first.status.success(), "{}", err(&first));
    let core = bench.text("tcCore.mod");
    for to in ["C.mod", "./C.mod"] {
        let second =
            run(&["compensate", "Cell.mod", "--core", "separate", "--tolerance-mm", "0.02", "-o", to]);
        let message = err(&second);
        assert!(second.status.code() == Some(2) && message.contains("output::other-core"), "{to}: {message}");
        assert_eq!(bench.text("tcCore.mod"), core, "{to}");
    }
}

#[test]
fn names_of_the_program_are_neither_signals_nor_procedures() {
    let bench = Bench::default();
    let text = std::fs::read_to_string(CUBE).unwrap();
    let target =
        "    CONST robtarget pSphere:=[[400,0,400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n";
    let at = text.find("    LOCAL PERS tooldata").unwrap();
    let source = bench.file("m.mod", format!("{}{target}{}", &text[..at], &text[at..]));
    let to = bench.path("tc.mod").display().to_string();
    let asked = |more: &[&str]| {
        let output = driftpost(&[&["compensate", &source, "-o", &to, "--diff", "none"][..], more].concat());
        (output.status.code(), err(&output))
    };
    let touch = ["--touch", "S1=pSphere,rdkTool,rdkWObj"];
    for name in ["pSphere", "Cube45"] {
        let (code, message) = asked(&[&touch[..], &["--touch-signal", name]].concat());
        assert!(code == Some(2) && message.contains("emit::bad-sensor"), "{name}: {message}");
    }
    let (code, message) = asked(&[&touch[..], &["--touch-routine", "pSphere"]].concat());
    assert!(code == Some(2) && message.contains("touch::how") && message.contains("robtarget"), "{message}");
    let (code, message) = asked(&[&touch[..], &["--touch-routine", "rFind"]].concat());
    assert!(code == Some(0) && message.contains("no PROC rFind is in the given files"), "{message}");
    let (code, message) = asked(&[&touch[..], &["--touch-signal", "diProbe"]].concat());
    assert!(code == Some(0) && !message.contains("diProbe"), "{message}");
}

/// Two results of one source, of which one was touched up: the one does not go over the other.
#[test]
fn two_results_of_one_original_are_not_restored_to_one_place() {
    let bench = Bench::default();
    let made: Vec<String> = ["ramp", "live"]
        .into_iter()
        .map(|form| {
            let to = bench.path(&format!("{form}.mod")).display().to_string();
            let output = driftpost(&["compensate", CUBE, "-o", &to, "--form", form, "--diff", "none"]);
            assert!(output.status.success(), "{}", err(&output));
            to
        })
        .collect();
    let folder = bench.path("back").display().to_string();
    std::fs::create_dir(&folder).unwrap();
    let output = driftpost(&["restore", &made[0], &made[1], "-o", &folder]);
    assert!(output.status.code() == Some(2) && err(&output).contains("output::twice"), "{}", err(&output));
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 0);
}

/// On a robot that does not reach its places neither source nor result makes the moves: what is not made is no success.
#[test]
fn moves_that_no_robot_makes_are_not_within() {
    let bench = Bench::default();
    let to = bench.path("tc.mod").display().to_string();
    let made = driftpost(&["compensate", CUBE, "-o", &to, "--form", "ramp", "--diff", "none"]);
    assert!(made.status.success(), "{}", err(&made));
    let output = driftpost(&["simulate", &to, "--minutes", "5", "--robot", "irb2600"]);
    let shown = out(&output);
    assert_eq!(output.status.code(), Some(1), "{shown}");
    assert!(shown.contains("moves are not made") && shown.contains("NOT within"), "{shown}");
    // Of a cold robot alone nothing is learned of its warm-up.
    let output = driftpost(&["simulate", &to]);
    assert!(err(&output).contains("minute 0 alone is judged"), "{}", err(&output));
}

/// A fit that makes no model still has a page, pictures and residuals.
#[test]
fn what_needs_no_model_is_written_without_one() {
    let bench = Bench::default();
    let measured = std::fs::read_to_string("fixtures/docs/measured.csv").unwrap();
    let few: String = measured.lines().take(9).map(|line| format!("{line}\n")).collect();
    let file = bench.file("few.csv", few);
    let at = |name: &str| bench.path(name).display().to_string();
    let all =
        [("--model-out", "m.toml"), ("--rapid-out", "r.mod"), ("--csv", "c.csv"), ("--report", "p.html")];
    let options: Vec<String> =
        all.iter().flat_map(|(option, name)| [(*option).to_owned(), at(name)]).collect();
    let options: Vec<&str> = options.iter().map(String::as_str).collect();
    let output = driftpost(&[&["diagnose", &file][..], &options].concat());
    let message = err(&output);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("r.mod and") && message.contains("m.toml were not written"), "{message}");
    assert_eq!(bench.files(), ["c.csv", "few.csv", "p.html"]);
}

/// A tracker's points are at joints that were commanded, and those never drift.
#[test]
fn the_state_is_told_by_touches_and_no_points() {
    let bench = Bench::default();
    let touches = std::fs::read_to_string("fixtures/docs/touches.csv").unwrap();
    let seen = touches.lines().enumerate().map(|(k, line)| {
        format!("{line},{}\n", if k == 0 { "x_mm,y_mm,z_mm".to_owned() } else { format!("{k},0,500") })
    });
    let file = bench.file("seen.csv", seen.collect::<String>());
    let output = driftpost(&["state", &file, "--tool", "0,0,100"]);
    assert!(output.status.code() == Some(2) && err(&output).contains("state::measured"), "{}", err(&output));
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn a_plan_repeats_as_often_as_asked_and_sweeps_what_turns() {
        let output = driftpost(&["plan", "--n", "60", "--repeats", "45"]);
        assert!(out(&output).contains("60 measurements of 15 poses"), "{}{}", out(&output), err(&output));
        let sweep = |robot: &str, joint: &str| {
            let output = driftpost(&["plan", "--n", "20", "--robot", robot, "--sweep", joint]);
            (output.status.code(), err(&output))
        };
        let (code, message) = sweep("fixtures/robots/scara.toml", "3");
        assert!(code == Some(2) && message.contains("it slides"), "{message}");
        let (code, message) = sweep("fixtures/robots/seven_axes.toml", "7");
        assert!(code == Some(0), "{message}");
    }

    /// One target is placed by base and tool whatever the robot does; where no move is made there is nothing to place.
    #[test]
    #[ignore = "long"]
    fn a_rehearsal_of_few_targets_is_no_proof() {
        let bench = Bench::default();
        let program = |moves: &str| {
            let text = format!(
                "MODULE m\n  CONST robtarget p1:=[[450,0,500],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n  PROC main()\n{moves}  ENDPROC\nENDMODULE\n"
            );
            bench.file("m.mod", text)
        };
        for moves in [
            "    MoveJ p1,v100,fine,tool0;\n",
            "    IF FALSE THEN\n      MoveJ p1,v100,fine,tool0;\n    ENDIF\n",
        ] {
            let output =
                driftpost(&["closed-loop", &program(moves), "--inject", "joint_compliance:2", "--n", "60"]);
            let message = err(&output);
            assert!(output.status.code() == Some(2) && message.contains("rehearse::targets"), "{message}");
        }
    }

    #[test]
    #[ignore = "long"]
    fn a_program_is_overwritten_by_nothing_else() {
        let bench = Bench::default();
        let cube = std::fs::read(CUBE).unwrap();
        let program = bench.file("Part.mod", &cube);
        let measured = "fixtures/docs/measured.csv";
        let is_kept = |command: &[&str]| {
            let output = driftpost(command);
            let message = err(&output);
            let is_refused = output.status.code() == Some(2) && message.contains("output::changed");
            assert!(is_refused, "{command:?}: {message}");
            assert_eq!(std::fs::read(&program).unwrap(), cube, "{command:?}");
        };
        for (option, more) in [
            ("--rapid-out", &["--tool", "0,0,80"][..]),
            ("--json", &[]),
            ("--csv", &[]),
            ("--clean-out", &[]),
        ] {
            is_kept(&[&["diagnose", measured, option, &program], more].concat());
        }
        let result = bench.path("plan.json").display().to_string();
        assert!(driftpost(&["plan", "--n", "20", "--json", &result]).status.success());
        let to = bench.path("to.mod").display().to_string();
        let page = ["compensate", CUBE, "-o", &to, "--report", &program, "--diff", "none"];
        let diff = ["compensate", CUBE, "-o", &to, "--diff", &program];
        for command in [&["report", &*result, "-o", &*program][..], &page, &diff] {
            is_kept(command);
        }
        // What was written there before is written anew.
        let json = bench.path("d.json").display().to_string();
        for _ in 0..2 {
            let output = driftpost(&["inspect", CUBE, "--json", &json]);
            assert_eq!(output.status.code(), Some(0), "{}", err(&output));
        }
        // A robot is no model, nor the other way round.
        let [model, _] = fitted(&bench);
        let was = std::fs::read(&model).unwrap();
        let output = driftpost(&["robot", "--robot", "irb140", "-o", &model]);
        assert!(
            output.status.code() == Some(2) && err(&output).contains("output::changed"),
            "{}",
            err(&output)
        );
        assert_eq!(std::fs::read(&model).unwrap(), was);
    }
}
