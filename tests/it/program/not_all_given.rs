//! Programs of which only a part is given: variables that another module sets, routines that are called and are in none of the files,
//! motion settings that a `main` elsewhere carries from one routine to the next.

use super::{at, codes, module, program, tool, warnings};
use rapid_program::Program;
use rapid_program::motion::PersUse;

fn data() -> String {
    format!(
        "PERS tooldata t:={};\nPERS wobjdata w:=[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];\nCONST robtarget p:={};\n",
        tool(1),
        at(5, 5, 5)
    )
}

const MOVE: &str = "MoveL p,v100,fine,t\\WObj:=w;\n";

/// The variables and PERS that each motion is made of, with whether they are variables.
fn made_of(read: &Program) -> Vec<(usize, &str, bool)> {
    let of_targets = read.made_of_pers.iter().filter(|made| made.goes_into == PersUse::Target);
    of_targets.map(|made| (made.motion.index(), made.name.as_str(), made.is_variable)).collect()
}

/// What `main` of another module sets before it calls: the value in the file is only the one before that.
#[test]
fn a_variable_that_only_another_module_can_set_is_told_of() {
    let read = |scope: &str, statements: &str, more: &str| {
        module(&format!(
            "{}{scope}VAR robtarget pPick:={};\n{scope}VAR num nDepth:=10;\nPROC rPick()\n{statements}\nENDPROC\n{more}",
            data(),
            at(6, 5, 5)
        ))
    };
    let to_pick = "MoveL pPick,v100,fine,t;\nMoveL Offs(p,0,0,-nDepth),v100,fine,t;\nMoveL p,v100,fine,t;";
    let open = read("", to_pick, "");
    assert_eq!((codes(&open), made_of(&open)), (vec!["-"; 3], vec![(0, "pPick", true), (1, "nDepth", true)]));
    // Nobody else sees it, or there is nobody else.
    for (scope, more) in
        [("LOCAL ", ""), ("TASK ", "PROC main()\nrPick;\nENDPROC"), ("", "PROC main()\nrPick;\nENDPROC")]
    {
        assert_eq!(made_of(&read(scope, to_pick, more)), [], "{scope}{more}");
    }
    // What is called and not given can set it: a procedure, a function, one of a name that is worked out.
    for call in [
        "GetVision;",
        "IF FindPart() rPick;",
        "%\"rJob\"+NumToStr(nDepth,0)%;",
        "CallByVar \"rJob\",2;",
        "CONNECT iNew WITH tNotGiven;",
        "MoveLSync p,v100,z10,t,\"rNotGiven\";",
    ] {
        let called = read("", to_pick, &format!("PROC main()\n{call}\nrPick;\nENDPROC"));
        assert_eq!(made_of(&called), [(0, "pPick", true), (1, "nDepth", true)], "{call}");
        let not_given = called.diagnostics.iter().find(|found| found.code == "resolve::routine-not-given");
        let help = not_given.unwrap().help.clone().unwrap();
        assert!(help.starts_with("it could set t, pPick and nDepth, used by motions here"), "{call}: {help}");
    }
    // The file that sets it is given: it is known at run time alone.
    let setter = "MODULE N\nPROC main()\npPick.trans.x:=DInput(di1);\nnDepth:=GInput(gi1);\nrPick;\nENDPROC\nENDMODULE";
    let text = format!(
        "MODULE M\n{}VAR robtarget pPick:={};\nVAR num nDepth:=10;\nPROC rPick()\n{to_pick}\nENDPROC\nENDMODULE",
        data(),
        at(6, 5, 5)
    );
    let both = program(&[("M.mod", &text), ("N.mod", setter)]);
    assert_eq!(codes(&both), ["keep::runtime-target", "keep::runtime-target", "-"]);
}

/// An index, the bound of a loop, a condition, a displacement and a name that another module may set.
#[test]
fn what_an_open_variable_decides_is_left_open() {
    let read = |declared: &str, statements: &str| {
        module(&format!(
            "{}{declared}\nCONST robtarget pr{{3}}:=[{},{},{}];\nPROC rPick()\n{statements}\nENDPROC\nPROC rOther()\nw.uframe.trans.x:=3;\nENDPROC",
            data(),
            at(6, 5, 5),
            at(7, 5, 5),
            at(8, 5, 5)
        ))
    };
    let elements =
        |declared: &str| read(declared, "MoveL pr{nIdx},v100,fine,t;").motions[0].targets[0].values().count();
    assert_eq!(elements("VAR num nIdx:=1;"), 3);
    assert_eq!(elements("LOCAL VAR num nIdx:=1;"), 1);
    let displaced = format!("PDispSet pd;\n{MOVE}");
    let none = "VAR pose pd:=[[0,0,0],[1,0,0,0]];";
    assert_eq!(codes(&read(none, &displaced)), ["keep::displacement"]);
    assert_eq!(codes(&read(&format!("LOCAL {none}"), &displaced)), ["-"]);
    let ends = format!("WHILE bEnd=FALSE DO\nStop;\nENDWHILE\n{MOVE}");
    assert_eq!(codes(&read("VAR bool bEnd:=FALSE;", &ends)), ["-"]);
    let named = format!("%sJob%;\n{MOVE}");
    assert_eq!(codes(&read("VAR string sJob:=\"rNone\";", &named)), ["keep::wobj-unknown"]);
    // Set before it is used, on every way: nobody else comes between.
    assert_eq!(codes(&read("VAR string sJob;", &format!("sJob:=\"x\";\n{MOVE}"))), ["-"]);
}

/// A variable that the file sets in one routine and uses in another: `main`, which is not given, may set it between the two.
#[test]
fn a_variable_that_comes_in_from_outside_is_not_known_until_it_is_set() {
    let read = |main: &str| {
        module(&format!(
            "{}VAR num nLen:=7;\nPROC rSet()\nnLen:=7;\nENDPROC\nPROC rGo()\nw.uframe.trans.x:=nLen;\n{MOVE}nLen:=4;\nw.uframe.trans.x:=nLen;\n{MOVE}ENDPROC\n{main}",
            data()
        ))
    };
    assert_eq!(codes(&read("")), ["keep::wobj-unknown", "-"]);
    assert_eq!(codes(&read("PROC main()\nrSet;\nrGo;\nENDPROC")), ["-", "-"]);
}

/// The controller's instructions are known by their whole names: `CorrFrame`, `WaitPart` and `TpSelect` are some library's.
#[test]
fn a_routine_is_not_the_controllers_for_the_first_letters_of_its_name() {
    for name in [
        "CorrFrame",
        "WaitPart",
        "TriggerVision",
        "TpSelect",
        "UiChoose",
        "WZFix",
        "ClkTool",
        "SocketFrame",
        "RMQFrame",
        "MatrixFrame",
        "ISignalFoo",
        "EgmFrame",
        "CamFrame",
    ] {
        let read = module(&format!("{}PROC main()\n{name} w;\n{MOVE}ENDPROC", data()));
        assert_eq!(codes(&read), ["keep::wobj-unknown"], "{name}");
        let found = read.diagnostics.iter().find(|found| found.code == "resolve::routine-not-given").unwrap();
        assert!(found.message.starts_with(&format!("{name} is not among")), "{}", found.message);
    }
    for own in [
        "WaitTime 1",
        "TPWrite \"x\"",
        "WZEnable z",
        "CorrClear",
        "EGMStop e",
        "ClkReset c",
        "ClearIOBuff ch",
        "RaiseToUser \\Continue",
        "WaitAndRecProf s",
        "UIMsgBox \"x\"",
    ] {
        let read = module(&format!("{}PROC main()\n{own};\n{MOVE}ENDPROC", data()));
        assert_eq!((codes(&read), warnings(&read)), (vec!["-"], vec![]), "{own}");
    }
}

/// Functions and procedures of worked-out names that are in none of the files.
#[test]
fn whatever_is_called_and_not_given_is_named() {
    let found = |statements: &str| -> Vec<String> {
        let read = module(&format!(
            "{}VAR num n;\nPROC main()\n{statements}\n{MOVE}ENDPROC\nPROC rA1()\nStop;\nENDPROC",
            data()
        ));
        let named = read.diagnostics.iter().filter(|found| found.code == "resolve::routine-not-given");
        named.map(|found| found.message.clone()).collect()
    };
    let one = |name: &str| vec![format!("{name} is not among the given files")];
    assert_eq!(found("IF FindPart() Stop;"), one("FindPart"));
    assert_eq!(found("n:=2*nWidth(3);"), one("nWidth"));
    assert_eq!(found("%\"rJob\"+NumToStr(n,0)%;"), one("the procedure that \"rJob\"+NumToStr(n,0) names"));
    assert_eq!(found("CallByVar \"rJob\",n;"), one("the procedure that \"rJob\" names with a number"));
    for known in ["%\"rA\"+NumToStr(n,0)%;", "CallByVar \"rA\",n;", "n:=Round(ClkRead(c)\\Dec:=1);"] {
        assert_eq!(found(known), [""; 0], "{known}");
    }
}

/// Routines that a `main` elsewhere calls one after the other: settings outlive each of them.
#[test]
fn settings_of_one_routine_may_be_in_force_in_the_next() {
    let read = |set: &str, main: &str| {
        module(&format!("{}PROC rInit()\n{set}\nENDPROC\nPROC rWeld()\n{MOVE}ENDPROC\n{main}", data()))
    };
    for (set, code) in [
        ("PDispSet [[0,0,-150],[1,0,0,0]];", "keep::displacement"),
        ("SoftAct 1,100;", "keep::soft-servo"),
        ("EOffsSet [5,0,0,0,0,0];", "keep::external-offset"),
    ] {
        assert_eq!(codes(&read(set, "")), [code], "{set}");
        // It is called by hand: the next start of the program puts settings back.
        assert_eq!(codes(&read(set, "PROC main()\nrWeld;\nENDPROC")), ["-"], "{set}");
    }
    assert_eq!(read("ConfL\\Off;", "").motions[0].setup.conf_monitored, None);
    assert_eq!(read("TPWrite \"x\";", "").motions[0].setup.conf_monitored, Some(true));
    assert_eq!(codes(&read("PDispSet [[0,0,-150],[1,0,0,0]];\nPDispOff;", "")), ["-"]);
}
