//! Which motion comes before which, and loops.

use super::{at, main_of, module};
use rapid_program::Program;
use rapid_program::motion::{MotionId, RoutineId};

fn mv() -> String {
    format!("MoveL {},v100,fine,tool0;\n", at(1, 2, 3))
}

fn previous(program: &Program) -> Vec<Option<usize>> {
    program.motions.iter().map(|m| m.previous.map(MotionId::index)).collect()
}

#[test]
fn straight_on_and_over_waits() {
    let m = mv();
    let read = main_of(
        "",
        &format!("{m}{m}WaitTime 1.5;\nWaitTime\\InPos,2;\nSetDO do1,1;\n{m}WaitDI di1,1;\n{m}Stop;\n{m}"),
    );
    assert_eq!(previous(&read), [None, Some(0), Some(1), Some(2), Some(3)]);
}

#[test]
fn where_ways_meet_only_a_common_motion_comes_before() {
    let m = mv();
    let read =
        main_of("", &format!("{m}IF DI1=1 THEN\n{m}ENDIF\n{m}IF DI1=1 THEN\nSetDO do1,1;\nENDIF\n{m}"));
    assert_eq!(previous(&read), [None, Some(0), None, Some(2)]);
    let read = main_of("", &format!("{m}WHILE TRUE DO\n{m}{m}ENDWHILE"));
    assert_eq!(previous(&read), [None, None, Some(1)]);
    let read = main_of("", &format!("FOR i FROM 1 TO 3 DO\n{m}ENDFOR\n{m}"));
    assert_eq!(previous(&read), [None, Some(0)]);
    let read = main_of("", &format!("{m}FOR i FROM 1 TO n DO\nWaitTime 1;\nENDFOR\n{m}"));
    assert_eq!(previous(&read), [None, Some(0)]);
    let read = main_of("", &format!("{m}WHILE DI1=0 DO\nENDWHILE\n{m}"));
    assert_eq!(previous(&read), [None, Some(0)]);
}

#[test]
fn through_calls() {
    let m = mv();
    let read = module(&format!(
        "PROC main()\n{m}sub;\n{m}empty;\n{m}WaitTime 2;\nsub2;\nNotGiven;\n{m}ENDPROC
PROC sub()\n{m}WaitTime 1;\n{m}WaitTime 1;\nENDPROC\nPROC empty()\nSetDO do1,1;\nENDPROC\nPROC sub2()\nWaitTime 1;\n{m}ENDPROC"
    ));
    // main: 0, 1, 2, 3 | sub: 4, 5 | sub2: 6
    assert_eq!(previous(&read), [None, Some(5), Some(1), None, Some(0), Some(4), Some(2)]);
    assert!(read.diagnostics.iter().any(|d| d.code == "resolve::routine-not-given"));
    // Called from two places: what comes before is not the same.
    let read = module(&format!("PROC main()\n{m}sub;\n{m}sub;\nENDPROC\nPROC sub()\n{m}ENDPROC"));
    assert_eq!(previous(&read), [None, Some(2), None]);
}

#[test]
fn after_a_search_the_arm_stands_somewhere_on_its_way() {
    let m = mv();
    let p = at(1, 2, 3);
    let read = main_of("", &format!("{m}SearchL\\Stop,di1,sp,{p},v100,tool0;\n{m}"));
    assert_eq!(previous(&read), [None, Some(0), None]);
    let trap = module(&format!("TRAP t1\n{m}{m}ENDTRAP"));
    assert_eq!(previous(&trap), [None, Some(0)]);
}

#[test]
fn loops_round_motion() {
    let m = mv();
    let body = format!(
        "WHILE TRUE DO\n! first\nSetDO do1,1;\n{m}FOR i FROM 1 TO 9 STEP 2 DO\n{m}ENDFOR\nFOR i FROM n TO 3 DO\n{m}ENDFOR\nFOR i FROM 1 TO 3 DO\nENDFOR\nENDWHILE\nWHILE DI1=1 DO\n{m}ENDWHILE"
    );
    let read = main_of("", &body);
    let loops: Vec<_> = read.loops.iter().map(|l| (l.unconditional, l.passes)).collect();
    assert_eq!(loops, [(true, None), (false, Some(5)), (false, None), (false, None)]);
    let of: Vec<_> = read.motions.iter().map(|m| m.setup.loops.clone()).collect();
    assert_eq!(of, [vec![0], vec![0, 1], vec![0, 2], vec![3]]);
}

#[test]
fn loops_by_goto() {
    let m = mv();
    let read = main_of("", &format!("{m}back:\n! c\n{m}again:\n{m}IF DI1=1 GOTO again;\n{m}GOTO back;\n{m}"));
    let loops: Vec<_> = read.loops.iter().map(|l| (l.unconditional, l.passes)).collect();
    assert_eq!(loops, [(true, None), (false, None)]);
    let of: Vec<_> = read.motions.iter().map(|m| m.setup.loops.clone()).collect();
    assert_eq!(of, [vec![], vec![0], vec![0, 1], vec![0], vec![]]);
    assert_eq!(read.motions[4].skip_reason.as_ref().map(|k| k.code), Some("keep::unreachable"));
    let forward = main_of("", &format!("GOTO over;\nover:\n{m}"));
    assert!(forward.loops.is_empty());
}

#[test]
fn routines_with_motion_are_known_by_name() {
    let m = mv();
    let text = format!(
        "PROC a()\n! c\nVAR num n;\n! d\nn:=1;\n{m}ENDPROC\nPROC b()\nERROR\n{m}ENDPROC\nPROC none()\nENDPROC"
    );
    let read = module(&text);
    assert_eq!(read.routines.iter().map(|r| r.name.as_str()).collect::<Vec<_>>(), ["a", "b"]);
    assert_eq!(read.routines[0].module, "M");
    assert_eq!(read.motions[1].setup.routine, RoutineId(1));
}

#[test]
fn after_the_arm_was_moved_otherwise_it_stands_anywhere() {
    for moved in [
        "EGMRunPose e,EGM_STOP_HOLD\\x;",
        "LoadId TOOL_LOAD_ID,MASS_WITH_AX3,t;",
        "PathRecMoveBwd;",
        "StepBwdPath 50,1;",
    ] {
        let read = main_of(
            "",
            &format!(
                "MoveAbsJ [[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\n{moved}\nMoveL {},v100,fine,tool0;",
                at(5, 5, 5)
            ),
        );
        let last = read.motions.last().unwrap();
        assert!(last.previous.is_none() && !last.from_start, "{moved}");
        let message = read.diagnostics.iter().any(|d| d.code == "resolve::routine-not-given");
        assert!(!message, "{moved} is the controller's own");
    }
}
