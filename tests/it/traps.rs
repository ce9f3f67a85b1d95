//! What a trap does to the arm or to its load, as far as motions are concerned that it may interrupt: between any two statements.

use super::model::{driftpost, path};

/// The zeros of two joints of the wrist.
const OFF: &str = "[[effect]]\neffect = \"joint_offset\"\njoint = 5\noffset_deg = 0.04\n[[effect]]\neffect = \"joint_offset\"\njoint = 4\n\
                   offset_deg = 0.04\n";
const PLAY: &str = "[[effect]]\neffect = \"backlash\"\njoint = 1\ngap_deg = 0.02\n";
const SAG: &str = "[[effect]]\neffect = \"joint_compliance\"\njoint = 2\nrad_per_n_m = 0.000006\n";

/// A program that a trap may interrupt: three moves, and what the trap does.
fn program(settings: &str, trap: &str) -> String {
    let ext = "[9E9,9E9,9E9,9E9,9E9,9E9]";
    let at = |y: f64| format!("[[430,{y},300],[0.0871557,0,0.9961947,0],[0,-1,0,0],{ext}]");
    format!(
        "MODULE Interrupted\n  PERS tooldata t:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];\n  \
         PERS loaddata part:=[5,[0,0,100],[1,0,0,0],0,0,0];\n  \
         CONST jointtarget a:=[[-15,10,20,5,50,5],{ext}];\n  CONST jointtarget b:=[[5,10,20,185,-50,-175],{ext}];\n  \
         CONST jointtarget c:=[[50,10,20,5,50,5],{ext}];\n  CONST robtarget p10:={};\n  CONST robtarget p20:={};\n  \
         VAR robtarget found;\n  VAR num n:=0;\n  VAR intnum ir;\n  PROC main()\n    IDelete ir;\n    CONNECT ir WITH tr;\n    \
         ITimer\\Single,0.1,ir;\n    {settings}\n    MoveAbsJ a,v500,fine,t;\n    WaitTime 1;\n    MoveL p20,v100,fine,t;\n    \
         MoveL p10,v100,fine,t;\n  ENDPROC\n  TRAP tr\n    {trap}\n  ENDTRAP\nENDMODULE\n",
        at(60.0),
        at(120.0)
    )
}

/// What is said of a program, and the file that is written.
fn compensated(text: &str, effects: &str) -> (String, String) {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| path(dir.path(), name);
    let head = "format = 1\nrobot = \"ABB IRB 140-6/0.8\"\n[seen]\npayload_kg = [0.0, 6.0]\n";
    std::fs::write(at("m.toml"), format!("{head}{effects}")).unwrap();
    std::fs::write(at("p.mod"), text).unwrap();
    let (program, model, out) = (at("p.mod"), at("m.toml"), at("out.mod"));
    let args = ["compensate", &program, "--model", &model, "--form", "ramp", "-o", &out, "--diff", "none"];
    let output = driftpost(&[&args[..], &["--start-joints", "5,10,20,5,50,5"]].concat());
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{said}");
    (said, std::fs::read_to_string(out).unwrap())
}

/// What the trap returns to, as StorePath and RestoPath ask for.
const BACK: &str = "StopMove;\n    StorePath;\n    found:=CRobT(\\Tool:=t);\n    MoveAbsJ b,v500,fine,t;\n    MoveJ found,v500,fine,t;\n    \
                    RestoPath;\n    StartMove;";

#[test]
fn a_trap_that_takes_the_arm_to_another_branch_leaves_open_on_which_it_goes_on() {
    let (said, text) = compensated(&program("ConfL\\Off;", "MoveAbsJ b,v500,fine,t;"), OFF);
    assert!(said.contains("[keep::branch-unknown]: line 19:"), "{said}");
    assert!(said.contains("a trap that moves the arm may run before it"), "{said}");
    assert!(text.contains("    MoveL p20,v100") && text.contains("    MoveL p10,v100"), "{text}");
    // Where the controller checks confdata it goes by them, or stops.
    let (said, text) = compensated(&program("ConfL\\On;", "MoveAbsJ b,v500,fine,t;"), OFF);
    assert!(!said.contains("keep::") && text.contains("MoveL tcAt(p20,"), "{said}");
    // So it is where the trap stays on the branch, goes back, or does not move.
    for trap in ["MoveAbsJ c,v500,fine,t;", BACK, "n:=n+1;"] {
        let (said, text) = compensated(&program("ConfL\\Off;", trap), OFF);
        assert!(!said.contains("branch") && !said.contains("conf::"), "{trap}: {said}");
        assert!(text.contains("MoveL tcAt(p20,") && text.contains("MoveL tcAt(p10,"), "{trap}: {text}");
    }
    // A reading behind a move is no way back.
    let late = BACK.replace(
        "found:=CRobT(\\Tool:=t);\n    MoveAbsJ b,v500,fine,t;",
        "MoveAbsJ b,v500,fine,t;\n    found:=CRobT(\\Tool:=t);",
    );
    let (said, _) = compensated(&program("ConfL\\Off;", &late), OFF);
    assert!(said.contains("[conf::unchecked]: line 19:"), "{said}");
}

#[test]
fn a_trap_turns_round_the_side_from_which_a_joint_comes() {
    let effects = format!("{OFF}{PLAY}");
    let (said, _) = compensated(&program("n:=0;", "MoveAbsJ c,v500,fine,t;"), &effects);
    assert!(said.contains("[model::either-side]: line 19:"), "{said}");
    let (said, _) = compensated(&program("n:=0;", "rElsewhere;"), &effects);
    assert!(said.contains("[model::direction]: line 17:"), "{said}");
    for trap in [BACK, "n:=n+1;"] {
        let (said, _) = compensated(&program("n:=0;", trap), &effects);
        assert!(
            !said.contains("either-side") && !said.contains("[model::direction]: line 1"),
            "{trap}: {said}"
        );
    }
}

#[test]
fn what_a_trap_grips_may_hang_there_at_any_motion() {
    let (said, _) = compensated(&program("n:=0;", "GripLoad part;"), SAG);
    assert!(said.contains("[model::gripload]: line 17:"), "{said}");
    let (said, _) = compensated(&program("n:=0;", "n:=n+1;"), SAG);
    assert!(!said.contains("model::gripload"), "{said}");
}
