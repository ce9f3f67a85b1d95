//! Tables and models of another robot: what takes them only where that is allowed, and what says whose they are.

use super::{Bench, CUBE, driftpost, err, out};
use std::fs;

const TARGETS: [&str; 5] =
    ["tabulate", "fixtures/paper/targets45.csv", "--orient-deg", "0,90,0", "--minutes"];
const TOUCHES: [&str; 6] = ["state", "fixtures/docs/touches.csv", "--tool", "0,0,100", "--stop", "120:165"];

/// Exit code and messages.
fn ended(arguments: &[&[&str]]) -> (Option<i32>, String) {
    let output = driftpost(&arguments.concat());
    (output.status.code(), err(&output))
}

#[test]
fn whose_the_built_in_table_is_stands_beside_what_is_worked_out_with_it() {
    let bench = Bench::default();
    let joints = bench.path("j.csv").display().to_string();
    let [tabulate, simulate]: [&[&str]; 2] = [
        &[
            "tabulate",
            "fixtures/paper/targets45.csv",
            "--orient-deg",
            "0,90,0",
            "--minutes",
            "60",
            "--joints-csv",
            &joints,
        ],
        &["simulate", CUBE, "--minutes", "60"],
    ];
    let warned = |arguments: &[&str], robot: &str| {
        let (code, text) = ended(&[arguments, &["--robot", robot]]);
        assert!(text.contains("warning[deform::other-robot]"), "{code:?} {arguments:?}: {text}");
        assert!(text.contains("an IRB 140's, the robot is ABB IRB"), "{text}");
    };
    warned(tabulate, "irb4600");
    warned(simulate, "irb4600");
    warned(&TOUCHES, "irb1200");
    // What writes a program refuses it.
    let (code, text) = ended(&[&["compensate", CUBE, "-o", "-", "--robot", "irb4600"]]);
    assert!(code == Some(2) && text.contains("error[deform::other-robot]"), "{text}");
    let own: [&[&str]; 3] = [&[&TARGETS[..], &["0"]].concat(), simulate, &TOUCHES];
    for arguments in own {
        let (code, text) = ended(&[arguments, &["--robot", "irb140"]]);
        assert!(code != Some(2) && !text.contains("other-robot"), "{arguments:?}: {text}");
    }
    // With a table of its own nothing is to be said.
    let table = [
        "--robot",
        "irb4600",
        "--deformation",
        "fixtures/paper/table2_deformation.csv",
        "--growth",
        "two-stage:46",
    ];
    for arguments in [tabulate, simulate] {
        let (_, text) = ended(&[arguments, &table]);
        assert!(!text.contains("other-robot"), "{text}");
    }
}

#[test]
fn a_model_of_another_robot_is_refused_by_each_that_applies_it() {
    let bench = Bench::default();
    let text = fs::read_to_string("fixtures/docs/identified.toml").unwrap();
    assert!(text.contains("robot = \"ABB IRB 140"), "{text}");
    let own_line = text.lines().find(|line| line.starts_with("robot = ")).unwrap();
    let model = bench.file("m.toml", text.replace(own_line, "robot = \"ABB IRB 2600-12/1.65\""));
    for arguments in [&["compensate", CUBE, "-o", "-"][..], &["simulate", CUBE, "--minutes", "60"], &TOUCHES]
    {
        let (code, text) = ended(&[arguments, &["--model", &model]]);
        assert_eq!(code, Some(2), "{arguments:?}: {text}");
        assert!(text.contains("error[model::robot]"), "{arguments:?}: {text}");
        assert!(text.contains("the model is of ABB IRB 2600-12/1.65, the robot is ABB IRB 140"), "{text}");
    }
    let accepted = ["--model", &model, "--allow-other-robot"];
    let (code, text) = ended(&[&["simulate", CUBE, "--minutes", "60"], &accepted]);
    assert!(code != Some(2) && text.contains("warning[model::robot]"), "{text}");
}

/// Who made the module has said so already.
#[test]
fn a_module_that_was_made_with_another_robots_table_is_simulated_with_it() {
    let bench = Bench::default();
    let made = bench.path("made.mod").display().to_string();
    let frame = "wobj2=[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]]";
    let compensate =
        ["compensate", CUBE, "--robot", "irb1600-1.45", "--allow-other-robot", "--wobj", frame, "-o", &made];
    let output = driftpost(&compensate);
    assert_eq!(output.status.code(), Some(0), "{}{}", out(&output), err(&output));
    let (code, text) = ended(&[&["simulate", &made, "--minutes", "60"]]);
    assert!(code != Some(2) && !text.contains("other-robot"), "{code:?} {text}");
    let (code, text) = ended(&[&["simulate", &made, "--minutes", "60", "--robot", "irb4600"]]);
    assert!(text.contains("warning[deform::other-robot]"), "{code:?} {text}");
}
