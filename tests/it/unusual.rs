//! Programs of unusual but valid shapes, corrected and executed: each motion goes where it should, or is kept with its reason.

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
    let said = report["messages"].as_array().unwrap().iter().filter(|m| m["source"] == "TPWrite");
    Made {
        motions: review["motions"].as_array().unwrap().iter().map(motion).collect(),
        corrected_mm: worst.fold(0.0, f64::max),
        messages: said.filter_map(|m| m["text"].as_str().map(str::to_owned)).collect(),
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

#[test]
fn motions_behind_a_loop_that_is_left_from_inside_are_corrected() {
    let body = "  VAR num n:=0;
  PROC main()
    MoveAbsJ jh,v100,fine,tool0;
    n:=0;
    WHILE TRUE DO
      n:=n+1;
      MoveL pA,v100,fine,tool0;
      IF n>2 GOTO out;
      MoveL pB,v100,fine,tool0;
    ENDWHILE
    out:
    MoveL pC,v100,fine,tool0;
    twice;
    MoveL pA,v100,fine,tool0;
  ENDPROC
  PROC twice()
    WHILE TRUE DO
      n:=n+1;
      IF n>5 RAISE ERR_ARGVALERR;
      MoveL pB,v100,fine,tool0;
    ENDWHILE
  ERROR
    MoveL pC,v100,fine,tool0;
    RETURN;
  ENDPROC\n";
    for form in ["schedule", "ramp", "live", "auto"] {
        let made = made(form, body);
        assert!(made.motions.iter().all(|(status, _)| status == "compensated"), "{form}: {:?}", made.motions);
        assert!(made.corrected_mm < 0.0055, "{form}: {}", made.corrected_mm);
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

/// At its end a program begins anew where the arm stands, which need not be where it stood at first.
#[test]
fn the_second_cycle_comes_from_where_the_first_has_ended() {
    let cell = |end: &str| {
        format!(
            "{HEAD}  PROC main()
    ConfL\\Off;
    ConfJ\\Off;
    MoveJ pA,v100,fine,tool0;
    MoveJ pC,v100,fine,tool0;
    {end}
  ENDPROC
ENDMODULE\n"
        )
    };
    // Behind axis 1: pA is nearest on the other side from there.
    let behind =
        "MoveAbsJ [[-165.964,-27.0938,-186.002,-180,56.9044,14],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;";
    let folder = tempfile::tempdir().unwrap();
    for (end, status) in [
        (behind.to_owned(), "kept"),
        (format!("IF DInput(di1)=1 ExitCycle;\n    {behind}\n    MoveAbsJ jh,v100,fine,tool0;"), "kept"),
        ("MoveAbsJ jh,v100,fine,tool0;".to_owned(), "compensated"),
        (format!("{behind}\n    WHILE TRUE DO\n      WaitTime 1;\n    ENDWHILE"), "compensated"),
    ] {
        std::fs::write(folder.path().join("Cell.mod"), cell(&end)).unwrap();
        let args = ["compensate", "Cell.mod", "--form", "ramp", "-o", "out.mod", "--force", "--json", "-"];
        let args = [&args[..], &["--start-joints", "0,0,0,0,90,0"]].concat();
        let review = driftpost(folder.path(), &args);
        assert_eq!(review["motions"][0]["status"], status, "{end}");
    }
}

/// Where a loop begins is known before its way back is: the branches of all its motions are.
#[test]
fn a_loop_that_nobody_checks_is_followed_from_where_it_is_entered() {
    let body = "  PROC main()
    ConfJ\\Off;
    ConfL\\Off;
    MoveAbsJ jh,v100,fine,tool0;
    MoveJ pB,v100,fine,tool0;
    FOR i FROM 1 TO 3 DO
      MoveJ pA,v100,fine,tool0;
      IF DInput(di1)=1 MoveL Offs(pC,0,0,20),v100,fine,tool0;
      MoveJ pC,v100,fine,tool0;
    ENDFOR
    WHILE TRUE DO
      MoveJ pA,v100,fine,tool0;
      MoveL pC,v100,fine,tool0;
      MoveJ pB,v100,fine,tool0;
    ENDWHILE
  ENDPROC\n";
    for form in ["schedule", "ramp"] {
        let made = made(form, body);
        assert!(made.motions.iter().all(|(status, _)| status == "compensated"), "{form}: {:?}", made.motions);
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
            let said = String::from_utf8_lossy(&run.stderr);
            assert_eq!(run.status.code(), Some(if refused { 2 } else { 0 }), "{declaration}: {said}");
            assert_eq!(
                said.contains("Cell.mod:10: ") && said.contains("hides the controller's own"),
                refused,
                "{said}"
            );
        }
        let separate = ["compensate", "Cell.mod", "--form", "ramp", "--core", "separate", "-o", "far.mod"];
        let mut run = Command::cargo_bin("driftpost").unwrap();
        let run = run.current_dir(folder.path()).args(separate).arg("--force").output().unwrap();
        let local = declaration.starts_with("LOCAL") || !refused;
        assert_eq!(run.status.success(), local, "{declaration}: {}", String::from_utf8_lossy(&run.stderr));
    }
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

/// Behind a handler that goes on the arm may stand anywhere, or where the way without an error leaves it: confdata that nobody
/// checks, and that speak against this way, are not believed.
#[test]
fn a_handler_that_goes_on_does_not_hide_where_the_arm_comes_from() {
    let body = |conf: &str, handler: &str| {
        format!(
            "  CONST robtarget pT:=[[400,100,400],[0.08063959,0.15119923,0.97775502,0.12095938],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST jointtarget jBehind:=[[-167.453,-25.2762,-189.232,14.1156,-42.5385,-159.216],[9E9,9E9,9E9,9E9,9E9,9E9]];
  VAR num n:=1;
  PROC main()
    {conf}
    go;
    MoveL pT,v100,fine,tool0;
    MoveAbsJ jh,v100,fine,tool0;
    MoveL pA,v100,fine,tool0;
  ERROR
    {handler}
    TRYNEXT;
  ENDPROC
  PROC go()
    MoveAbsJ jBehind,v100,fine,tool0;
    n:=1/n;
  ENDPROC\n"
        )
    };
    for handler in ["n:=2;", "MoveAbsJ jh,v100,fine,tool0;"] {
        for form in ["schedule", "ramp"] {
            let off = made(form, &body("ConfL\\Off;", handler));
            assert_eq!(off.motions[0].0, "kept", "{form} {handler}: {:?}", off.motions);
            assert!(off.motions[0].1.contains("any of"), "{form} {handler}: {:?}", off.motions);
            assert_eq!(off.motions[2].0, "compensated", "{form} {handler}: {:?}", off.motions);
            assert!(off.corrected_mm < 0.0055, "{form} {handler}: {}", off.corrected_mm);
        }
    }
}

/// A routine that is called from more places than are told apart, one of them behind a handler that goes on: nothing tells the branch
/// there, and reading the program ends.
#[test]
fn a_routine_called_from_many_places_and_from_anywhere_is_read() {
    let calls: String =
        (0..12).map(|k| format!("    MoveJ Offs(pA,{k},0,0),v100,fine,tool0;\n    further;\n")).collect();
    let body = format!(
        "  PROC main()
    ConfJ\\Off;
    ConfL\\Off;
    MoveAbsJ jh,v100,fine,tool0;
    further;
{calls}    WaitDI di1,1;
    further;
    ERROR
      MoveAbsJ jh,v100,fine,tool0;
      TRYNEXT;
  ENDPROC
  PROC further()
    MoveL pC,v100,fine,tool0;
    last;
  ENDPROC
  PROC last()
    MoveL pA,v100,fine,tool0;
  ENDPROC\n"
    );
    let made = made("ramp", &body);
    assert!(made.motions.iter().any(|motion| motion.0 == "compensated"), "{:?}", made.motions);
    assert!(made.corrected_mm < 0.0005, "{}", made.corrected_mm);
}

/// Motion settings outlive a cycle, as PERS do: what is in force where `main` ends, or at ExitCycle, is in force where it begins anew.
#[test]
fn a_displacement_that_main_leaves_on_is_on_in_the_next_cycle() {
    let cell = |begin: &str, end: &str| {
        format!(
            "{HEAD}  PROC main()
    {begin}
    MoveAbsJ jh,v100,fine,tool0;
    MoveL pA,v100,fine,tool0;
    MoveL pC,v100,fine,tool0;
    {end}
  ENDPROC
ENDMODULE\n"
        )
    };
    let on = "PDispSet [[0,0,-60],[1,0,0,0]];";
    let folder = tempfile::tempdir().unwrap();
    for (begin, end, status) in [
        ("", on.to_owned(), "kept"),
        ("", format!("IF DInput(di1)=1 THEN\n      {on}\n      ExitCycle;\n    ENDIF"), "kept"),
        ("", format!("WHILE TRUE DO\n      {on}\n      WaitTime 1;\n    ENDWHILE"), "compensated"),
        ("PDispOff;", on.to_owned(), "compensated"),
        ("", format!("{on}\n    PDispOff;"), "compensated"),
    ] {
        std::fs::write(folder.path().join("Cell.mod"), cell(begin, &end)).unwrap();
        let args = ["compensate", "Cell.mod", "--form", "ramp", "-o", "out.mod", "--force", "--json", "-"];
        let review = driftpost(folder.path(), &args);
        for motion in [1, 2] {
            let told = &review["motions"][motion];
            assert_eq!(told["status"], status, "{begin} {end}: {told}");
            assert_eq!(told["code"] == "keep::displacement", status == "kept", "{told}");
        }
    }
}
