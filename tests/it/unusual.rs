//! Programs of unusual but valid shapes, corrected and executed: each motion goes where it should, or is kept with its reason.

mod ways;

use assert_cmd::Command;
use serde_json::Value;
use std::path::Path;

const HEAD: &str = "MODULE Cell
  CONST robtarget pA:=[[400,100,400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pB:=[[450,-100,350],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pC:=[[380,50,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST jointtarget jh:=[[0,0,0,0,90,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n";

/// A program corrected in a form and executed.
struct Made {
    /// Of each motion: status, and why it is kept.
    motions: Vec<(String, String)>,
    /// What is left at most at the motions that are corrected, mm.
    corrected_mm: f64,
    /// Lines that the program wrote.
    messages: Vec<String>,
}

fn driftpost(folder: &Path, args: &[&str]) -> Value {
    let run = Command::cargo_bin("driftpost").unwrap().current_dir(folder).args(args).output().unwrap();
    serde_json::from_slice(&run.stdout)
        .unwrap_or_else(|_| panic!("{args:?}: {}", String::from_utf8_lossy(&run.stderr)))
}

fn made(form: &str, body: &str) -> Made {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("Cell.mod"), format!("{HEAD}{body}ENDMODULE\n")).unwrap();
    let args = ["compensate", "Cell.mod", "--form", form, "-o", "out.mod", "--json", "-"];
    let review = driftpost(folder.path(), &args);
    let motion = |m: &Value| {
        (m["status"].as_str().unwrap().to_owned(), m["reason"].as_str().unwrap_or_default().to_owned())
    };
    let args = ["simulate", "out.mod", "--original", "Cell.mod", "--minutes", "0,37,240", "--json", "-"];
    let report = driftpost(folder.path(), &args);
    let minutes = report["minutes"].as_array().unwrap();
    for minute in minutes {
        assert!(minute["failure"].is_null() && minute["mismatch"].is_null(), "{form}: {minute}");
    }
    let worst = minutes.iter().filter_map(|m| m["corrected"]["max_mm"].as_f64());
    let message = report["messages"].as_array().unwrap().iter().filter(|m| m["source"] == "TPWrite");
    Made {
        motions: review["motions"].as_array().unwrap().iter().map(motion).collect(),
        corrected_mm: worst.fold(0.0, f64::max),
        messages: message.filter_map(|m| m["text"].as_str().map(str::to_owned)).collect(),
    }
}

#[test]
fn a_reading_handed_back_by_a_late_bound_call_is_the_arms_own_position() {
    let body = "  VAR robtarget pX;
  VAR robtarget pY;
  VAR robtarget pZ;
  VAR num n:=2;
  PROC getit(INOUT robtarget p)
    p:=CRobT();
  ENDPROC
  PROC put1(INOUT robtarget p)
    p:=pA;
  ENDPROC
  PROC main()
    MoveAbsJ jh,v100,fine,tool0;
    pX:=pA;
    %\"get\"+\"it\"% pX;
    MoveL pX,v100,fine,tool0;
    pY:=pB;
    %\"get\"+Lower()% pY;
    MoveL Offs(pY,0,0,10),v100,fine,tool0;
    pZ:=pC;
    %\"put\"+NumToStr(n-1,0)% pZ;
    MoveL pZ,v100,fine,tool0;
  ENDPROC
  FUNC string Lower()
    RETURN \"it\";
  ENDFUNC\n";
    for form in ["schedule", "ramp", "live", "auto"] {
        let made = made(form, body);
        for kept in [1, 2] {
            let (status, reason) = &made.motions[kept];
            assert_eq!(status, "kept", "{form}");
            assert!(reason.contains("read from where the robot stands"), "{form}: {reason}");
        }
        // What another routine hands back is no reading.
        assert!(!made.motions[3].1.contains("where the robot stands"), "{form}: {:?}", made.motions[3]);
        assert!(made.corrected_mm < 0.0055, "{form}: {}", made.corrected_mm);
    }
}

#[test]
fn a_target_that_a_late_bound_routine_makes_a_frame_of_is_kept() {
    let body = "  VAR pose frame;
  PROC calibrate(robtarget p1,robtarget p2,robtarget p3)
    frame:=DefFrame(p1,p2,p3);
  ENDPROC
  PROC main()
    VAR string name:=\"calibrate\";
    MoveAbsJ jh,v100,fine,tool0;
    MoveL pA,v100,fine,tool0;
    MoveL pB,v100,fine,tool0;
    MoveL pC,v100,fine,tool0;
    %name% pA,pB,pC;
  ENDPROC\n";
    for form in ["schedule", "ramp", "live", "auto"] {
        let made = made(form, body);
        for (status, reason) in &made.motions[1..] {
            assert_eq!(status, "kept", "{form}");
            assert!(reason.contains("DefFrame makes a tool, frame or zone"), "{form}: {reason}");
        }
    }
}

#[test]
fn an_array_of_three_dimensions_is_corrected_where_its_index_is_known_at_run_time_only() {
    let target = |x: i32, y: i32| format!("[[{x},{y},400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]");
    let row =
        |x: i32| format!("[[{},{}],[{},{}]]", target(x, 60), target(x, 80), target(x, 100), target(x, 120));
    let body = format!(
        "  CONST robtarget a{{2,2,2}}:=[{},{}];
  PROC main()
    MoveAbsJ jh,v100,fine,tool0;
    FOR i FROM 1 TO 2 DO
      FOR k FROM 2 TO 1 STEP -1 DO
        FOR m FROM 1 TO 2 DO
          MoveL a{{i,k,m}},v100,fine,tool0;
        ENDFOR
        MoveL a{{i,2,k}},v100,fine,tool0;
      ENDFOR
    ENDFOR
    MoveL a{{1,2,1}},v100,fine,tool0;
  ENDPROC\n",
        row(400),
        row(430)
    );
    for form in ["ramp", "auto", "live"] {
        let made = made(form, &body);
        assert!(made.motions.iter().all(|(status, _)| status == "compensated"), "{form}: {:?}", made.motions);
        assert!(made.corrected_mm < 0.0005, "{form}: {}", made.corrected_mm);
    }
    let made = made("schedule", &body);
    for (status, reason) in &made.motions[1..3] {
        assert_eq!(status, "kept");
        assert!(reason.contains("--form ramp"), "{reason}");
    }
    assert_eq!(made.motions[3].0, "compensated");
}

/// RAPID takes `pRow` and `PROW` for one name; what stands in the motions comes back in the spelling of each.
#[test]
fn an_array_in_two_spellings_is_corrected_and_comes_back_as_written() {
    let target = |y: i32| format!("[[450,{y},300],[0,0,1,0],[0,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]]");
    let body = format!(
        "  CONST robtarget pRow{{2}}:=[{},{}];
  PROC main()
    MoveAbsJ jh,v100,fine,tool0;
    FOR i FROM 1 TO 2 DO
      MoveL pRow{{i}},v100,fine,tool0;
      MoveL PROW{{i}},v100,fine,tool0;
      MoveL prow{{3-i}},v100,fine,tool0;
    ENDFOR
  ENDPROC\n",
        target(40),
        target(80)
    );
    for form in ["schedule", "ramp", "auto", "live"] {
        // What cannot be got back is not written.
        let made = made(form, &body);
        assert!(made.motions.iter().all(|(status, _)| status == "compensated"), "{form}: {:?}", made.motions);
        assert!(made.corrected_mm < 0.0052, "{form}: {}", made.corrected_mm);
    }
}

#[test]
fn a_clock_under_another_name_is_the_one_that_is_started() {
    let body = "  PERS num tcMode:=7;
  PROC main()
    MoveAbsJ jh,v100,fine,tool0;
    MoveL pA,v100,fine,tool0;
  ENDPROC
  PROC tcColdStart()
    TPWrite \"mine\";
  ENDPROC
  PROC tcUpdate()
    TPWrite \"mine too\";
  ENDPROC\n";
    for form in ["schedule", "ramp"] {
        let made = made(form, body);
        assert!(made.corrected_mm < 0.0055, "{form}: {}", made.corrected_mm);
        assert_eq!(made.messages, Vec::<String>::new(), "{form}");
    }
}

#[test]
fn a_work_object_that_a_late_bound_routine_turns_is_not_the_one_before() {
    let routine = "  PROC turn(PERS wobjdata w)
    w.oframe:=[[850,0,0],[0,0,0,1]];
  ENDPROC\n";
    for call in ["%\"turn\"% wA", "%name% wA", "%\"tu\"+\"rn\"% wA", "turn wA"] {
        let body = format!(
            "  PERS wobjdata wA:=[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
  CONST robtarget pM:=[[425,0,350],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
{routine}  PROC main()
    VAR string name:=\"turn\";
    VAR errnum e;
    ConfL\\Off;
    MoveAbsJ jh,v100,fine,tool0;
    wA.oframe:=[[0,0,0],[1,0,0,0]];
    MoveL pM,v100,fine,tool0\\WObj:=wA;
    {call};
    MoveL pM,v100,fine,tool0\\WObj:=wA;
    wA.oframe:=[[0,0,0],[1,0,0,0]];
  ERROR
    TRYNEXT;
  ENDPROC\n"
        );
        for form in ["schedule", "ramp"] {
            let made = made(form, &body);
            let (status, reason) = &made.motions[2];
            assert_eq!(status, "kept", "{form} {call}");
            assert!(reason.contains("the work object wA is not known"), "{form} {call}: {reason}");
            assert!(made.corrected_mm < 0.0055, "{form} {call}: {}", made.corrected_mm);
        }
    }
}

/// A parameter by reference is the datum that was handed over: who changes the one changes the other.
#[test]
fn a_parameter_by_reference_changes_with_what_it_stands_for() {
    let body = "  PERS tooldata tG:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  PERS tooldata tH:=[TRUE,[[0,130,220],[0.9238795,0.3826834,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  PERS tooldata tCur:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  PERS wobjdata wA:=[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
  PROC main()
    tCur:=tG;
    wA.oframe:=[[0,0,0],[1,0,0,0]];
    MoveAbsJ jh,v100,fine,tool0;
    go tCur;
    work wA;
  ENDPROC
  PROC go(PERS tooldata t)
    MoveJ pA,v100,fine,t;
    tCur:=tH;
    MoveJ pA,v100,fine,t;
    further t;
  ENDPROC
  PROC further(PERS tooldata u)
    MoveJ pC,v100,fine,u;
    tCur:=tG;
    MoveJ pC,v100,fine,u;
  ENDPROC
  PROC work(PERS wobjdata w)
    MoveJ pA,v100,fine,tool0\\WObj:=w;
    find;
    MoveJ pA,v100,fine,tool0\\WObj:=w;
  ENDPROC
  PROC find()
    wA.oframe:=[[20,-150,-100],[0.9763,0.1,0.15,0.12]];
  ENDPROC\n";
    for form in ["schedule", "ramp"] {
        let made = made(form, body);
        let changed: Vec<&str> = [2, 4, 6].iter().map(|&at| made.motions[at].1.as_str()).collect();
        assert!(
            changed[0].contains("t stands for tCur, which is changed: line 19"),
            "{form}: {:?}",
            made.motions
        );
        assert!(changed[1].contains("u stands for tCur, which is changed: line 25"), "{form}: {changed:?}");
        assert!(changed[2].contains("w stands for wA, which is changed: line 34"), "{form}: {changed:?}");
        let before: Vec<&str> = [1, 5].iter().map(|&at| made.motions[at].0.as_str()).collect();
        assert_eq!(before, ["compensated"; 2], "{form}: {:?}", made.motions);
        assert!(made.corrected_mm < 0.0055, "{form}: {}", made.corrected_mm);
    }
}

/// What asks the operator, reads on in a file or tells the time is asked as often as in the source.
#[test]
fn an_index_that_asks_somebody_is_asked_once() {
    let body = "  CONST robtarget pRow{2}:=[[[420,60,330],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],
    [[420,70,330],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]];
  PERS tooldata tRow{2}:=[[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]],
    [TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]]];
  VAR iodev dev;
  PROC main()
    MoveAbsJ jh,v100,fine,tool0;
    MoveL pRow{UINumEntry(\"Which?\")},v100,fine,tool0;
    MoveL pRow{ReadNum(dev)},v100,fine,tool0;
    MoveL Offs(pA,0,0,DInput(di1)),v100,fine,tRow{ReadNum(dev)};
    MoveL pRow{DInput(di1)+1},v100,fine,tool0;
  ENDPROC\n";
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("Cell.mod"), format!("{HEAD}{body}ENDMODULE\n")).unwrap();
    for form in ["schedule", "ramp", "live", "auto"] {
        let args = ["compensate", "Cell.mod", "--form", form, "-o", "out.mod", "--force", "--json", "-"];
        let review = driftpost(folder.path(), &args);
        let text = std::fs::read_to_string(folder.path().join("out.mod")).unwrap();
        for asks in ["UINumEntry(", "ReadNum("] {
            let moves = text.lines().filter(|line| line.contains("MoveL") && line.contains(asks));
            for line in moves {
                assert_eq!(line.matches(asks).count(), 1, "{form}: {line}");
            }
        }
        // A signal is looked at twice.
        assert_eq!(review["motions"][4]["status"], "compensated", "{form}");
        let asked = if form == "live" || form == "auto" { "compensated" } else { "kept" };
        assert_eq!(review["motions"][2]["status"], asked, "{form}");
        assert_eq!(review["motions"][3]["status"], "kept", "{form}");
    }
}

/// Clock and functions would ask the program's own Exp where they mean the controller's.
#[test]
fn a_program_that_hides_what_the_clock_asks_the_controller_is_refused() {
    let hiding = |declaration: &str| {
        format!(
            "{HEAD}  PROC main()
    MoveAbsJ jh,v100,fine,tool0;
    MoveL pA,v100,fine,tool0;
  ENDPROC
  {declaration}
ENDMODULE\n"
        )
    };
    let folder = tempfile::tempdir().unwrap();
    for (declaration, refused) in [
        ("FUNC num Exp(num x)\n    RETURN 7;\n  ENDFUNC", true),
        ("LOCAL FUNC num EXP(num x)\n    RETURN 7;\n  ENDFUNC", true),
        ("PROC TPWrite(string s)\n  ENDPROC", true),
        ("FUNC num ASin(num x)\n    RETURN 7;\n  ENDFUNC", false),
    ] {
        std::fs::write(folder.path().join("Cell.mod"), hiding(declaration)).unwrap();
        for form in ["schedule", "ramp"] {
            let mut run = Command::cargo_bin("driftpost").unwrap();
            let args = ["compensate", "Cell.mod", "--form", form, "-o", "out.mod", "--force"];
            let run = run.current_dir(folder.path()).args(args).output().unwrap();
            let message = String::from_utf8_lossy(&run.stderr);
            assert_eq!(run.status.code(), Some(if refused { 2 } else { 0 }), "{declaration}: {message}");
            assert_eq!(
                message.contains("Cell.mod:10: ") && message.contains("hides the controller's own"),
                refused,
                "{message}"
            );
        }
        let separate = ["compensate", "Cell.mod", "--form", "ramp", "--core", "separate", "-o", "far.mod"];
        let mut run = Command::cargo_bin("driftpost").unwrap();
        let run = run.current_dir(folder.path()).args(separate).arg("--force").output().unwrap();
        let local = declaration.starts_with("LOCAL") || !refused;
        assert_eq!(run.status.success(), local, "{declaration}: {}", String::from_utf8_lossy(&run.stderr));
    }
}

/// A type or a datum of the name of a type that added data have: the module would not load, or hold something else.
#[test]
fn a_program_that_hides_a_type_of_what_is_added_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let runs = |declaration: &str, form: &str| {
        let text = format!(
            "{HEAD}  {declaration}\n  PROC main()\n    MoveAbsJ jh,v100,fine,tool0;\n    MoveL pA,v100,fine,tool0;\n  ENDPROC\nENDMODULE\n"
        );
        std::fs::write(folder.path().join("Cell.mod"), text).unwrap();
        let mut run = Command::cargo_bin("driftpost").unwrap();
        let args = ["compensate", "Cell.mod", "--form", form, "-o", "out.mod", "--force", "--diff", "none"];
        let run = run.current_dir(folder.path()).args(args).output().unwrap();
        let message = String::from_utf8_lossy(&run.stderr).into_owned();
        assert_eq!(run.status.success(), !message.contains("emit::hidden-name"), "{message}");
        run.status.success()
    };
    for declaration in ["RECORD pose\n    num a;\n  ENDRECORD", "ALIAS num pose;", "VAR num pose;"] {
        // A schedule adds no datum of that type.
        assert!(!runs(declaration, "ramp") && runs(declaration, "schedule"), "{declaration}");
    }
    assert!(runs("RECORD place\n    num a;\n  ENDRECORD", "ramp"));
}

/// An array of a routine's own hides the module's of the same name: what was touched up goes where the motion found it.
#[test]
fn a_touched_up_element_goes_into_the_array_that_the_routine_sees() {
    let target = |x: i32| format!("[[{x},60,330],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]");
    let array = |x: i32| format!("CONST robtarget pRow{{2}}:=[{},{}];", target(x), target(x + 10));
    let source = format!(
        "{HEAD}  {}
  PROC main()
    VAR num i:=1;
    MoveAbsJ jh,v100,fine,tool0;
    i:=i+1;
    MoveL pRow{{i}},v100,fine,tool0;
    own;
  ENDPROC
  PROC own()
    {}
    VAR num i:=0;
    i:=i+1;
    MoveL pRow{{i}},v100,fine,tool0;
  ENDPROC
ENDMODULE\n",
        array(420),
        array(400)
    );
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path("Cell.mod"), &source).unwrap();
    let run = |args: &[&str]| {
        Command::cargo_bin("driftpost").unwrap().current_dir(folder.path()).args(args).output().unwrap()
    };
    assert!(run(&["compensate", "Cell.mod", "-o", "made.mod", "--quiet"]).status.success());
    let untouched = run(&["restore", "made.mod", "-o", "back.mod"]);
    assert_eq!(untouched.status.code(), Some(0), "{}", String::from_utf8_lossy(&untouched.stderr));
    let made = std::fs::read_to_string(path("made.mod")).unwrap();
    let (before, array) = made.split_once("robtarget tcpRow_2{").unwrap();
    let touched = format!("{before}robtarget tcpRow_2{{{}", array.replacen("[[400,", "[[400.5,", 1));
    std::fs::write(path("touched.mod"), touched).unwrap();
    assert_eq!(run(&["restore", "touched.mod", "-o", "back2.mod"]).status.code(), Some(1));
    let back = std::fs::read_to_string(path("back2.mod")).unwrap();
    assert_eq!(back, source.replace("[[400,60", "[[400.5,60"));
}

/// What asks the model at run time holds for a tool that the robot carries: with one that stands a motion was called corrected, and went
/// to the original. A target that is known beforehand is corrected.
#[test]
fn a_target_of_run_time_with_a_stationary_tool_is_kept_with_its_reason() {
    let body = "  PERS tooldata tS:=[FALSE,[[450,0,400],[0,0,1,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];
  PERS wobjdata wR:=[TRUE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
  CONST robtarget pS:=[[10,5,-20],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  PROC main()
    MoveAbsJ jh,v100,fine,tool0;
    MoveJ pS,v100,fine,tS\\WObj:=wR;
  ENDPROC
  PROC given(robtarget p,jointtarget j)
    MoveL p,v100,fine,tS\\WObj:=wR;
    MoveC pS,p,v100,fine,tS\\WObj:=wR;
    MoveAbsJ j,v100,fine,tS\\WObj:=wR;
  ENDPROC\n";
    for form in ["live", "auto"] {
        let made = made(form, body);
        let statuses: Vec<&str> = made.motions.iter().map(|(status, _)| status.as_str()).collect();
        assert_eq!(statuses, ["compensated", "compensated", "kept", "kept", "kept"], "{:?}", made.motions);
        assert!(made.motions[2..].iter().all(|(_, why)| why.contains("the tool is stationary")));
        assert!(made.corrected_mm < 0.006, "{form}: {}", made.corrected_mm);
    }
}
