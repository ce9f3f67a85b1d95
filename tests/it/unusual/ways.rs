//! Ways through a program that are seldom taken: loops left from inside, handlers that go on, what a cycle leaves to the next.

use super::{HEAD, driftpost, made};

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
            let reported = &review["motions"][motion];
            assert_eq!(reported["status"], status, "{begin} {end}: {reported}");
            assert_eq!(reported["code"] == "keep::displacement", status == "kept", "{reported}");
        }
    }
}

/// Nobody checks configurations, and the first move may end on any branch: neither a gripper's routine that is not given, nor a move to where only
/// run time knows or to where the arm does not reach, tells which. Two motions told a branch that nothing says, and the second was corrected for it.
#[test]
fn a_branch_that_is_not_known_stays_so_until_something_settles_it() {
    let cell = |between: &str| {
        format!(
            "MODULE Cell
  PERS tooldata tW:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  CONST robtarget p1:=[[400,100,400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget p2:=[[400,150,400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pFar:=[[400,100,4000],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  VAR robtarget pSeen;
  PROC main()
    ConfJ\\Off;
    ConfL\\Off;
    MoveJ p1,v100,fine,tW;
    {between}
    MoveL p2,v100,fine,tW;
    MoveAbsJ [[20,20,20,0,50,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tW;
  ENDPROC
ENDMODULE\n"
        )
    };
    let home = "MoveAbsJ [[14,10,10,0,70,14],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tW;";
    let folder = tempfile::tempdir().unwrap();
    for (between, status) in [
        ("", "kept"),
        ("rGrip;", "kept"),
        ("pSeen:=rVision();\n    MoveL pSeen,v100,fine,tW;", "kept"),
        ("MoveL pFar,v100,fine,tW;", "kept"),
        ("MoveJ pFar,v100,fine,tW;\n    rGrip;", "kept"),
        ("SearchL di1,pSeen,Offs(p1,0,0,-20),v100,tW;", "kept"),
        (home, "compensated"),
        // What is not given may leave the arm where it was, or where nobody knows; both say the same branch.
        (&format!("{home}\n    rGrip;"), "compensated"),
    ] {
        std::fs::write(folder.path().join("Cell.mod"), cell(between)).unwrap();
        for form in ["schedule", "ramp", "live", "auto"] {
            let args = ["compensate", "Cell.mod", "--form", form, "-o", "out.mod", "--force", "--json", "-"];
            let review = driftpost(folder.path(), &args);
            let motions = review["motions"].as_array().unwrap();
            let p2 = motions.iter().find(|motion| motion["target"] == "p2").unwrap();
            assert_eq!(p2["status"], status, "{form}: {between}");
            let reason = p2["reason"].as_str().unwrap_or_default();
            let may_move =
                status == "kept" && (between.ends_with("rGrip;") || between.starts_with("SearchL"));
            assert_eq!(reason.contains("a call of what is not given"), may_move, "{form}: {reason}");
            // The line of the motion behind the call.
            assert!(between != "rGrip;" || reason.contains("before line 12 of Cell.mod"), "{form}: {reason}");
        }
    }
}

/// A RoboDK export whose configurations were never set is followed from its MoveAbsJ; behind a gripper's routine that is not given nobody knows where the
/// arm stands, and the reason says so.
#[test]
fn a_call_that_may_have_moved_the_arm_is_named_where_nothing_tells_the_branch() {
    let cell = |between: &str| {
        format!(
            "MODULE Cell
  CONST robtarget p2:=[[400,300,250],[0.70710678,0,0.70710678,0],[0,0,0,1],[9E9,9E9,9E9,9E9,9E9,9E9]];
  PROC main()
    ConfL\\Off;
    MoveAbsJ [[41.845,44.625,25.881,43.53,-75.606,-13.287],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;
    {between}
    MoveL p2,v100,fine,tool0;
  ENDPROC
ENDMODULE\n"
        )
    };
    let folder = tempfile::tempdir().unwrap();
    for (between, status) in [("", "compensated"), ("Gripper_Open;", "kept")] {
        std::fs::write(folder.path().join("Cell.mod"), cell(between)).unwrap();
        let args = ["compensate", "Cell.mod", "--form", "ramp", "-o", "out.mod", "--force", "--json", "-"];
        let review = driftpost(folder.path(), &args);
        let p2 = &review["motions"][1];
        assert_eq!(p2["status"], status, "{review}");
        let reason = p2["reason"].as_str().unwrap_or_default();
        assert_eq!(reason.contains("before it a call of what is not given"), status == "kept", "{reason}");
    }
}
