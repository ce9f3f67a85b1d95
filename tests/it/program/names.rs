//! Names: scopes, several files, tasks, tools given from outside; facts about modules.

use super::{at, codes, main_of, module, program, tool, tools_mm, warnings};
use rapid_program::motion::TargetValue;
use rapid_program::{Overrides, Program};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::FileId;

fn xs_mm(program: &Program) -> Vec<Option<i32>> {
    let x = |m: &rapid_program::motion::Motion| match m.targets[0].value() {
        Some(TargetValue::Rob(p)) => Some((p.object_from_tcp.translation.x * 1e3).round() as i32),
        _ => None,
    };
    program.motions.iter().map(x).collect()
}

#[test]
fn the_routine_shadows_the_module_and_the_module_the_task() {
    let a = format!(
        "MODULE A\nLOCAL CONST robtarget p:={};\nCONST robtarget q:={};
PROC one()\nCONST robtarget P:={};\nMoveL p,v100,fine,tool0;\nENDPROC
PROC two()\nMoveL p,v100,fine,tool0;\nMoveL q,v100,fine,tool0;\nENDPROC\nENDMODULE",
        at(1, 0, 0),
        at(2, 0, 0),
        at(3, 0, 0)
    );
    let b = format!(
        "MODULE B\nCONST robtarget p:={};\nPROC three()\nMoveL p,v100,fine,tool0;\nMoveL q,v100,fine,tool0;\nENDPROC\nENDMODULE",
        at(4, 0, 0)
    );
    let read = program(&[("A.mod", &a), ("B.mod", &b)]);
    assert_eq!(xs_mm(&read), [Some(3), Some(1), Some(2), Some(4), Some(2)]);
    assert!(warnings(&read).is_empty());
}

#[test]
fn a_name_local_to_another_module_is_used_with_one_warning() {
    let a = format!("MODULE A\nLOCAL CONST robtarget p:={};\nENDMODULE", at(1, 0, 0));
    let b = "MODULE B\nPROC main()\nMoveL p,v100,fine,tool0;\nMoveL p,v100,fine,tool0;\nENDPROC\nENDMODULE";
    let read = program(&[("A.mod", &a), ("B.mod", b)]);
    assert_eq!(xs_mm(&read), [Some(1), Some(1)]);
    assert_eq!(warnings(&read), ["resolve::local-elsewhere"]);
    // Two modules that hide the same name: nobody can say which is meant.
    let c = a.replace("MODULE A", "MODULE C");
    let read = program(&[("A.mod", &a), ("B.mod", b), ("C.mod", &c)]);
    assert_eq!(codes(&read), ["keep::ambiguous"; 2]);
}

#[test]
fn a_name_declared_twice_in_its_scope_is_ambiguous() {
    let data = format!("CONST robtarget p:={};\nCONST robtarget P:={};", at(1, 0, 0), at(2, 0, 0));
    assert_eq!(codes(&main_of(&data, "MoveL p,v100,fine,tool0;")), ["keep::ambiguous"]);
}

#[test]
fn tasks_of_a_backup_do_not_see_each_other() {
    let data = |x| format!("MODULE D\nCONST robtarget p:={};\nENDMODULE", at(x, 0, 0));
    let main = "MODULE M\nPROC main()\nMoveL p,v100,fine,tool0;\nENDPROC\nENDMODULE";
    let read = program(&[
        ("RAPID/TASK1/PROGMOD/M.mod", main),
        ("RAPID/TASK1/SYSMOD/D.sys", &data(1)),
        ("RAPID/TASK2/PROGMOD/M.mod", main),
        ("RAPID/TASK2/SYSMOD/D.sys", &data(2)),
        ("RAPID/TASK3/PROGMOD/M.mod", main),
    ]);
    assert_eq!(xs_mm(&read), [Some(1), Some(2), None]);
    assert_eq!(codes(&read), ["-", "-", "keep::not-declared"]);
}

#[test]
fn letters_of_latin_1_have_no_case_either() {
    let text = format!(
        "MODULE M\nCONST robtarget p\u{c4}:={};\nPROC main()\nMoveL P\u{e4},v100,fine,tool0;\nENDPROC\nENDMODULE",
        at(7, 0, 0)
    );
    let latin: Vec<u8> = text.chars().map(|c| c as u8).collect();
    for bytes in [latin, text.into_bytes()] {
        let file = SourceFile::read(FileId(0), "M.mod", bytes);
        assert_eq!(xs_mm(&Program::read(vec![file], &Overrides::default())), [Some(7)]);
    }
}

#[test]
fn a_routine_named_like_an_instruction_is_the_routine() {
    let p = at(1, 0, 0);
    let text =
        format!("PROC main()\nSpotL 1;\nENDPROC\nPROC SpotL(num n)\nMoveL {p},v100,fine,tool0;\nENDPROC");
    let read = module(&text);
    assert_eq!(codes(&read), ["-"]);
}

#[test]
fn tools_and_work_objects_from_outside() {
    let text = format!(
        "MODULE M\nPROC main()\nMoveL {},v100,fine,Gun\\WObj:=Table;\nENDPROC\nENDMODULE",
        at(1, 0, 0)
    );
    let read = |tools: &[(&str, &str)], wobjs: &[(&str, &str)]| {
        let own = |list: &[(&str, &str)]| list.iter().map(|(n, t)| ((*n).into(), (*t).into())).collect();
        let file = SourceFile::read(FileId(0), "M.mod", text.clone().into_bytes());
        Program::read(vec![file], &Overrides { tools: own(tools), wobjs: own(wobjs), ..Overrides::default() })
    };
    let table = "[FALSE,TRUE,\"\",[[100,0,0],[1,0,0,0]],[[0,20,0],[1,0,0,0]]]";
    let both = read(&[("gun", &tool(50))], &[("TABLE", table)]);
    assert_eq!((codes(&both), tools_mm(&both)), (vec!["-"], vec![Some(50)]));
    let frame = both.motions[0].setup.wobj.as_ref().unwrap().frame_from_object();
    assert_eq!(frame.translation.vector.as_slice(), [0.1, 0.02, 0.0]);
    assert_eq!(codes(&read(&[], &[("Table", table)])), ["keep::tool-unknown"]);
    assert_eq!(codes(&read(&[("Gun", &tool(50))], &[])), ["keep::wobj-unknown"]);
    for bad in ["[TRUE,[[0,0,0],[0,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]]", "12", "[TRUE", "];ENDMODULE", ""] {
        let read = read(&[("Gun", bad)], &[]);
        assert!(warnings(&read).contains(&"override::not-read"), "{bad}");
    }
}

#[test]
fn facts_about_modules() {
    let text = "MODULE Teil(NOSTEPIN)\n  ! driftpost 0.1.0\n  VAR num tcI:=1;\n  CONST num b:=2;\n  PROC a()\n    ! Using calibrated kinematics.\n    b2;\n  ENDPROC\n  PROC b2()\n  ENDPROC\nENDMODULE\n";
    let read = program(&[("Teil.mod", text)]);
    let facts = &read.facts;
    let [module] = facts.modules.as_slice() else { panic!("one module") };
    let of = |range: rapid_syntax::diagnostic::TextRange| &text[range.start as usize..range.end as usize];
    assert_eq!(module.name, "Teil");
    assert_eq!(of(module.compensated.unwrap()), "! driftpost 0.1.0");
    assert_eq!(facts.kinematics[0].word, "calibrated");
    assert!(!facts.kinematics[0].is_nominal());
    assert_eq!(facts.entries.iter().map(|e| e.name.as_str()).collect::<Vec<_>>(), ["a"]);
    // The names alone may be the user's own; with both it is one of ours whose header is gone.
    for (text, expected) in [
        ("VAR num n;\nPROC main()\nENDPROC", false),
        ("VAR num tcState;\nPROC main()\nENDPROC", false),
        ("PROC main()\nENDPROC\nPROC tcUpdate()\nENDPROC", false),
        ("VAR num TCSTATE;\nPROC main()\nENDPROC\nPROC TcUpdate()\nENDPROC", true),
    ] {
        assert_eq!(super::module(text).facts.modules[0].compensated.is_some(), expected, "{text}");
    }
}

#[test]
fn what_robodk_says_of_kinematics_is_read_however_it_is_written() {
    for (comment, expected) in [
        ("! Using nominal kinematics.", Some(true)),
        ("!using  NOMINAL\tKinematics .", Some(true)),
        ("!Using calibrated kinematics", Some(false)),
        ("! USING Absolute Accuracy KINEMATICS.", Some(false)),
        ("! Using kinematics.", None),
        ("! We are using nominal kinematics.", None),
    ] {
        let read = module(&format!("PROC main()\n{comment}\nENDPROC"));
        assert_eq!(read.facts.kinematics.first().map(|k| k.is_nominal()), expected, "{comment}");
    }
}

/// A global PERS of one name and type is one datum for all tasks, whatever each says of it.
#[test]
fn data_that_tasks_declare_differently_are_named_where_motions_are_made_of_them() {
    let frame = |x: &str| format!("[FALSE,TRUE,\"\",[[{x},60,180],[1,0,0,0]],[[0,0,0],[1,0,0,0]]]");
    let main = |data: &str, target: &str| {
        format!("MODULE A\n{data}\nPROC main()\nMoveL {target},v100,fine,t\\WObj:=w;\nENDPROC\nENDMODULE\n")
    };
    let messages = |data: &str, target: &str, other: &str| {
        let other = format!("MODULE B\n{other}\nPROC main()\nWaitTime 1;\nENDPROC\nENDMODULE\n");
        let paths = ["RAPID/TASK1/PROGMOD/A.mod", "RAPID/TASK2/PROGMOD/B.mod"];
        let read = program(&[(paths[0], &main(data, target)), (paths[1], &other)]);
        let found = read.diagnostics.iter().filter(|found| found.code == "resolve::tasks-differ");
        found.map(|found| found.message.clone()).collect::<Vec<_>>()
    };
    let own = format!(
        "PERS tooldata t:={};\nPERS wobjdata w:={};\nPERS robtarget p{{2}}:=[{},{}];\nPERS num nUp:=12;",
        tool(1),
        frame("430.0"),
        at(5, 0, 0),
        at(6, 0, 0)
    );
    for (target, other, expected) in [
        ("p{1}", format!("PERS wobjdata w:={};", frame("530")), "w.uframe.trans.x is 430 here, 530"),
        ("p{1}", format!("PERS wobjdata w:={};", frame("430")), ""),
        ("p{1}", format!("TASK PERS wobjdata w:={};", frame("530")), ""),
        ("p{1}", format!("PERS wobjdata w:={};\nPROC set()\nw:=wobj0;\nENDPROC", frame("530")), ""),
        (
            "p{1}",
            format!("PERS tooldata t:={};", tool(1).replace("TRUE", "FALSE")),
            "t.robhold is TRUE here, FALSE",
        ),
        ("p{1}", "PERS tooldata t;".to_owned(), ""),
        (
            "p{2}",
            format!("PERS robtarget p{{2}}:=[{},{}];", at(5, 0, 0), at(6, 0, 7)),
            "p{2}.trans.z is 0 here, 7",
        ),
        ("Offs(p{1},0,0,nUp)", "PERS num nUp:=13;".to_owned(), "nUp is 12 here, 13"),
        ("p{1}", "PERS num nUp:=13;".to_owned(), ""),
    ] {
        let found = messages(&own, target, &other);
        assert_eq!(found.len(), usize::from(!expected.is_empty()), "{other}: {found:?}");
        let expected = format!("{expected} in line 2 of RAPID/TASK2/PROGMOD/B.mod");
        assert!(found.iter().all(|found| found.ends_with(&expected)), "{found:?}");
    }
}
