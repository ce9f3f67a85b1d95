//! Errors that handlers of callers go on from, functions that are not given, and what a loop's variable hides.

use super::{at, codes, main_of, module, tool, tools_mm};

fn data() -> String {
    format!("PERS tooldata t:={};\nCONST robtarget p:={};", tool(1), at(5, 5, 5))
}

const MOVE: &str = "MoveL p,v100,fine,t;\n";

#[test]
fn an_error_leaves_a_routine_in_its_middle() {
    // `work` never ends but by its error, between two tools; TRYNEXT goes on behind its call.
    let text = |last: &str| {
        format!(
            "{}\nPROC main()\nt:={};\nwork;\n{MOVE}ERROR\nTRYNEXT;\nENDPROC\nPROC work()\nt:={};\n{last}\nt:={};\nENDPROC",
            data(),
            tool(2),
            tool(3),
            tool(2)
        )
    };
    assert_eq!(tools_mm(&module(&text("RAISE 1;"))), [Some(3)]);
    // With an error that may come or not it is one of two.
    assert_eq!(codes(&module(&text("IF DI1=1 RAISE 1;"))), ["keep::tool-unknown"]);
    assert_eq!(codes(&module(&text("WaitDI di1,1\\MaxTime:=2;"))), ["keep::tool-unknown"]);
    // What cannot fail ends with its last tool.
    assert_eq!(tools_mm(&module(&text("Incr n;"))), [Some(2)]);
}

#[test]
fn what_stands_behind_raise_runs_where_the_handler_tries_next() {
    let text = |handler: &str| {
        format!("{}\nPROC main()\nt:={};\nRAISE 1;\n{MOVE}ERROR\n{handler};\nENDPROC", data(), tool(2))
    };
    assert_eq!(tools_mm(&module(&text("TRYNEXT"))), [Some(2)]);
    assert_eq!(codes(&module(&text("TRYNEXT"))), ["-"]);
    assert_eq!(codes(&module(&text("RETURN"))), ["keep::unreachable"]);
}

#[test]
fn a_function_that_is_not_given_may_write_what_it_is_handed() {
    let read = |call: &str| {
        main_of(&data(), &format!("VAR num n;\nVAR robtarget q:={};\nn:={call};\n{MOVE}", at(1, 1, 1)))
    };
    assert_eq!(codes(&read("Weigh(t)")), ["keep::tool-unknown"]);
    // An expression is handed over by value, and the controller's own functions leave their arguments.
    assert_eq!(tools_mm(&read("Weigh(t.tload.mass+1)")), [Some(1)]);
    assert_eq!(tools_mm(&read("Abs(t.tload.mass)")), [Some(1)]);
    assert_eq!(tools_mm(&read("Weigh(n)")), [Some(1)]);
    // One that is given says itself what it does.
    let given = |mode: &str| {
        module(&format!(
            "{}\nPROC main()\nVAR num n;\nn:=Weigh(t);\n{MOVE}ENDPROC\nFUNC num Weigh({mode} tooldata x)\nRETURN 1;\nENDFUNC",
            data()
        ))
    };
    assert_eq!(tools_mm(&given("")), [Some(1)]);
    assert_eq!(tools_mm(&given("PERS")), [Some(1)]);
}

#[test]
fn what_the_controllers_own_instructions_hand_back_is_not_constant() {
    let read = |call: &str| {
        let data = format!("{}\nVAR num n:=5;\nPERS robtarget q:={};", data(), at(1, 1, 1));
        codes(&main_of(&data, &format!("{call};\nMoveL Offs(q,n,0,0),v100,fine,t;")))
    };
    for call in [
        "WaitAI ai1\\GT,3\\MaxTime:=2\\ValueAtTimeout:=n",
        "SocketReceive s1\\Str:=st\\NoRecBytes:=n",
        "RMQGetMsgHeader msg\\UserDef:=n",
        "CamGetParameter cam1,\"x\"\\NumVar:=n",
        "CamGetResult cam1,q",
        "ReadErrData td,n,k,l",
        "TPReadNum n,\"offset?\"",
    ] {
        assert_eq!(read(call), ["keep::runtime-target"], "{call}");
    }
    for call in ["TPWrite \"x\"\\Num:=n", "WaitDI di1,1\\MaxTime:=n", "SetGO go1,n", "Stop"] {
        assert_eq!(read(call), ["-"], "{call}");
    }
    let tool = |call: &str| codes(&main_of(&data(), &format!("{call};\n{MOVE}")));
    assert_eq!(tool("SToolRotCalib p1,p2,p3,t"), ["keep::tool-unknown"]);
    assert_eq!(tool("GripLoad t.tload"), ["-"]);
    // A routine that is not given is taken to leave tools alone that it is not handed, whatever it is called.
    assert_eq!(tool("GetReady"), ["-"]);
    assert_eq!(tool("GetReady t"), ["keep::tool-unknown"]);
}

#[test]
fn a_loops_variable_hides_others_of_its_name_inside_the_loop_alone() {
    let data =
        format!("{}\nCONST num i:=2;\nCONST robtarget ps{{2}}:=[{},{}];", data(), at(1, 0, 0), at(2, 0, 0));
    let body = "MoveL ps{i},v100,fine,t;\n";
    let read = main_of(&data, &format!("{body}FOR i FROM 1 TO 2 DO\n{body}ENDFOR\n{body}"));
    // In the loop any of the elements may be meant.
    let known: Vec<_> = read.motions.iter().map(|m| m.targets[0].values().count()).collect();
    assert_eq!((known, codes(&read)), (vec![1, 2, 1], vec!["-"; 3]));
}

#[test]
fn an_external_axis_away_from_0_may_carry_the_robot() {
    let ext = at(5, 5, 5).replacen("9E9", "250", 1);
    let zero = at(5, 5, 5).replacen("9E9", "0", 1);
    let lines = |target: &str| format!("MoveL {target},v100,fine,t;\nMoveL {target},v100,fine,t;");
    assert_eq!(codes(&main_of(&data(), &lines(&ext))), ["keep::external-base"; 2]);
    assert_eq!(codes(&main_of(&data(), &lines(&zero))), ["-"; 2]);
    // Where a target names no place for it the axis stays where it is, until it is back at 0.
    let none = at(5, 5, 5);
    let moves = |targets: &[&str]| {
        let lines: Vec<String> =
            targets.iter().map(|target| format!("MoveL {target},v100,fine,t;")).collect();
        codes(&main_of(&data(), &lines.join("\n")))
    };
    let kept = "keep::external-base";
    assert_eq!(moves(&[&none, &ext, &none, &none, &zero, &none]), ["-", kept, kept, kept, "-", "-"]);
    let joints = "[[1,2,3,4,50,6],[250,9E9,9E9,9E9,9E9,9E9]]";
    let line = format!("MoveAbsJ {joints},v100,fine,t;\nMoveL {none},v100,fine,t;\n");
    assert_eq!(codes(&main_of(&data(), &line)), ["-", kept]);
    let line = format!(
        "MoveExtJ {joints},vrot10,fine;\nIF GInput(gi1)=1 THEN\nMoveL {zero},v100,fine,t;\nENDIF\nMoveL {none},v100,fine,t;\n"
    );
    assert_eq!(codes(&main_of(&data(), &line)), ["keep::external-axes", "-", kept]);
    // Each axis by itself.
    let second = at(5, 5, 5).replacen("9E9,9E9", "9E9,0", 1);
    assert_eq!(moves(&[&ext, &none, &second, &none, &zero, &none]), [kept, kept, kept, kept, "-", "-"]);
}

/// 1E9 is a place a million kilometres away, and what is meant is 9E9; all axes are named that are to be fixed.
#[test]
fn external_axes_are_named_together_and_with_1e9_what_is_meant() {
    let reasons = |ext: &str, behind: &str| -> Vec<String> {
        let target = at(5, 5, 5).replace("9E9,9E9,9E9,9E9,9E9,9E9", ext);
        let read = main_of(&data(), &format!("MoveL {target},v100,fine,t;\n{behind}"));
        read.motions.iter().map(|m| m.skip_reason.as_ref().unwrap().reason.clone()).collect()
    };
    let behind = format!("MoveL {},v100,fine,t;", at(5, 5, 5));
    let found = reasons("1e9,9E9,1E+09,9E9,9E9,9E9", &behind);
    assert_eq!(
        found[0],
        "it places external axes a, c, which may carry the robot's base or the work object (--base-fixed a,c says that they do not; \
         1E9 is a place, and only 9E9 says that there is no axis)"
    );
    for part in ["axis a,", "1E9 is a place", "so it is with c (--base-fixed a,c)"] {
        assert!(found[1].contains(part), "{part} is not in {}", found[1]);
    }
    // A place is a place.
    let found = reasons("250,9E9,9E9,9E9,9E9,9E9", &behind);
    assert!(found[0].ends_with("(--base-fixed a says that it does not)"), "{}", found[0]);
    assert!(!found[1].contains("only 9E9") && !found[1].contains("so it is"), "{}", found[1]);
    assert!(reasons("9E8,9E9,9E9,9E9,9E9,9E9", "")[0].contains("9E8 is a place"));
}

#[test]
fn a_target_that_run_time_tells_may_have_placed_an_external_axis() {
    let (none, ext, zero) =
        (at(5, 5, 5), at(6, 5, 5).replacen("9E9", "150", 1), at(7, 5, 5).replacen("9E9", "0", 1));
    let with = |declared: &str, lines: &str| {
        let data = format!("{}\nVAR robtarget pV;\n{declared}", data());
        codes(&main_of(
            &data,
            &format!(
                "{lines}\nMoveL {none},v100,fine,t;\nMoveL {zero},v100,fine,t;\nMoveL {none},v100,fine,t;"
            ),
        ))
    };
    let kept = "keep::external-base";
    let last = |codes: Vec<&'static str>| codes[codes.len() - 3..].to_vec();
    for (declared, lines) in [
        (String::new(), format!("pV:={ext};\nMoveL pV,v100,fine,t;")),
        (
            format!("CONST robtarget ps{{2}}:=[{none},{ext}];\nVAR num i;"),
            "MoveL ps{i},v100,fine,t;".to_owned(),
        ),
        (
            format!("CONST robtarget pE:={ext};"),
            "pV:=pE;\nMoveL Offs(pV,0,0,GInput(gi1)),v100,fine,t;".to_owned(),
        ),
        (
            format!("CONST robtarget pN:={none};"),
            "pV:=pN;\npV.extax.eax_a:=GInput(gi1);\nMoveL pV,v100,fine,t;".to_owned(),
        ),
        (
            "VAR extjoint e:=[150,9E9,9E9,9E9,9E9,9E9];".to_owned(),
            format!("pV:={none};\npV.extax:=e;\nMoveL pV,v100,fine,t;"),
        ),
    ] {
        assert_eq!(last(with(&declared, &lines)), [kept, "-", "-"], "{declared}\n{lines}");
    }
    // An axis by its name may be written wherever it is handed, and each of several extjoints counts.
    let axes = "CONST extjoint es{2}:=[[150,9E9,9E9,9E9,9E9,9E9],[9E9,9E9,9E9,9E9,9E9,9E9]];\nVAR num i;";
    for (declared, line) in
        [("", "Add pV.extax.eax_a,150;"), ("", "Incr pV.extax.eax_a;"), (axes, "pV.extax:=es{i};")]
    {
        let lines = format!("pV:={none};\n{line}\nMoveL pV,v100,fine,t;");
        assert_eq!(last(with(declared, &lines)), [kept, "-", "-"], "{line}");
    }
    // Six numbers of another type are none, nor is a copy of an axis that nothing places.
    for declared in [
        "CONST num depth{6}:=[1,2,3,4,5,6];",
        "CONST num grid{2,6}:=[[1,2,3,4,5,6],[1,2,3,4,5,6]];",
        "CONST string names{6}:=[\"a\",\"b\",\"c\",\"d\",\"e\",\"f\"];",
        "CONST robtarget pN:=[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\nCONST robtarget six{6}:=[pN,pN,pN,pN,pN,pN];",
        "CONST jointtarget two{2}:=[[[1,2,3,4,5,6],[9E9,9E9,9E9,9E9,9E9,9E9]],[[1,2,3,4,5,6],[9E9,9E9,9E9,9E9,9E9,9E9]]];",
        "VAR robjoint six;\nVAR robtarget q;",
    ] {
        let copies = if declared.starts_with("VAR robjoint") {
            "six:=[1,2,3,4,5,6];\npV.extax.eax_a:=q.extax.eax_a;\n"
        } else {
            ""
        };
        let lines = format!("pV:={none};\n{copies}pV.trans.x:=GInput(gi1);\nMoveL pV,v100,fine,t;");
        assert_eq!(last(with(declared, &lines)), ["-"; 3], "{declared}");
    }
    // Where no text of the program places an axis, none was placed; the arm's own six joints are no external axes.
    let joints =
        "CONST robjoint r:=[1,2,3,4,50,6];\nVAR jointtarget j:=[[1,2,3,4,50,6],[9E9,9E9,9E9,9E9,9E9,9E9]];";
    let lines = format!(
        "j.robax:=[6,5,4,3,20,1];\npV:={none};\npV.extax.eax_a:=9E9;\nMoveL pV,v100,fine,t;\nMoveAbsJ j,v100,fine,t;"
    );
    assert_eq!(last(with(joints, &lines)), ["-"; 3]);
}
