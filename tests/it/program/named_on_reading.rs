//! What a program does that a correction would change, named when it is read.

use super::{at, codes, main_of, module, tool, warnings};

/// A tool and a target, and a motion to it.
fn data() -> String {
    format!("PERS tooldata t:={};\nCONST robtarget p:={};\n", tool(1), at(5, 5, 5))
}

const MOVE: &str = "MoveL p,v100,fine,t;\n";

/// The arm stands a correction beside its target: a test of that is named, once for all of a program, and no other.
#[test]
fn a_decision_by_where_the_arm_stands_is_named() {
    let at_home =
        "FUNC bool AtHome()\nVAR jointtarget j;\nj:=CJointT();\nRETURN Abs(j.robax.rax_1-3)<0.01;\nENDFUNC\n";
    let found = |body: &str| -> Vec<String> {
        let read = module(&format!("{}{at_home}PROC main()\n{MOVE}{body}ENDPROC\n", data()));
        let tested = read.diagnostics.iter().filter(|found| found.code == "state::position-tested");
        tested.map(|found| found.message.split(':').next().unwrap().to_owned()).collect()
    };
    let one = |by: &str| vec![format!("{by} decides by where the arm stands")];
    assert_eq!(found("IF AtHome() THEN\nStop;\nENDIF\n"), one("IF"));
    assert_eq!(found("IF NOT AtHome() Stop;\n"), one("IF"));
    assert_eq!(found("WaitUntil AtHome();\n"), one("WaitUntil"));
    let twice = "TEST CPos(\\Tool:=t).x>5\nCASE TRUE:\nStop;\nENDTEST\nWHILE AtHome() DO\nStop;\nENDWHILE\n";
    assert_eq!(found(twice), ["TEST decides by where the arm stands, and one more test does"]);
    for other in ["IF TRUE Stop;\n", "TPWrite \"home\"\\Bool:=AtHome();\n", ""] {
        assert_eq!(found(other), [""; 0], "{other}");
    }
}

/// All data of a type: clock and schedule have numbers, texts and truth values of their own.
#[test]
fn a_statement_that_sets_or_finds_all_data_of_a_type_is_named() {
    let found = |statement: &str| {
        let read = module(&format!("{}PROC main()\n{MOVE}{statement}\nENDPROC\n", data()));
        read.diagnostics.iter().filter(|found| found.code == "state::set-all-data").count()
    };
    for (statement, named) in [
        ("SetAllDataVal \"num\",0;", 1),
        ("SetAllDataVal \"Bool\"\\TypeMod,FALSE;", 1),
        ("SetAllDataVal \"num\"\\Object:=\"t.*\",0;", 1),
        ("SetAllDataVal \"num\"\\Object:=\".*\",0;", 1),
        ("SetAllDataVal \"num\"\\Object:=\"n.*\",0;", 0),
        ("SetAllDataVal \"robtarget\",p;", 0),
        ("SetDataVal \"n1\",0;", 0),
        // A search finds what is set, or read, one after the other.
        ("SetDataSearch \"num\"\\PersSym;", 1),
        ("SetDataSearch \"robtarget\"\\InMod:=\"M\";", 1),
        // Nothing is added to a module that is not given, or that moves nothing.
        ("SetDataSearch \"robtarget\"\\InMod:=\"R1_Data\";", 0),
        ("SetDataSearch \"robtarget\"\\InMod:=sModule;", 1),
        ("SetDataSearch sType\\Object:=\".*\";", 1),
        ("SetDataSearch \"robtarget\"\\Object:=\"p.*\";", 0),
        ("SetDataSearch \"robtarget\"\\Object:=\"^p.*\";", 0),
        ("SetDataSearch \"speeddata\";", 0),
    ] {
        assert_eq!(found(statement), named, "{statement}");
    }
}

/// ReadMotor gives the angle of an axis' motor, where the arm stands: drift included.
#[test]
fn a_motors_angle_is_the_arms_own_place() {
    let data = format!(
        "PERS tooldata t:={};\nVAR jointtarget j;\nCONST robtarget p:={};\nVAR num n;",
        tool(1),
        at(5, 5, 5)
    );
    let read = |statements: &str| main_of(&data, statements);
    let target = read("j.robax.rax_1:=ReadMotor(1)/121;\nMoveAbsJ j,v100,fine,t;");
    assert_eq!(codes(&target), ["keep::own-position"]);
    let handed_on = read("n:=ReadMotor(\\MecUnit:=ROB_1,3);\nMoveL Offs(p,0,0,n),v100,fine,t;");
    assert_eq!(codes(&handed_on), ["keep::own-position"]);
    // A positioner's axis holds none of the arm's drift.
    for (unit, expected) in [
        ("STN_1", "keep::runtime-target"),
        ("ROB_1", "keep::own-position"),
        ("rob_2", "keep::own-position"),
        ("IRB140", "keep::own-position"),
    ] {
        let motor = read(&format!("n:=ReadMotor(\\MecUnit:={unit},1);\nMoveL Offs(p,0,0,n),v100,fine,t;"));
        assert_eq!(codes(&motor), [expected], "{unit}");
        let joint = read(&format!(
            "GetJointData\\MechUnit:={unit},1\\Position:=n;\nMoveL Offs(p,0,0,n),v100,fine,t;"
        ));
        assert_eq!(codes(&joint), [expected], "{unit}");
    }
    // Which one a parameter stands for nobody knows here.
    let handed = read(
        "go ROB_1;\nENDPROC\nPROC go(VAR mecunit unit)\nn:=ReadMotor(\\MecUnit:=unit,1);\nMoveL Offs(p,0,0,n),v100,fine,t;",
    );
    assert_eq!(codes(&handed), ["keep::own-position"]);
    // GetJointData gives the joint's own angle; a speed is none.
    let given = |what: &str| read(&format!("GetJointData 1\\{what}:=n;\nMoveL Offs(p,0,0,n),v100,fine,t;"));
    assert_eq!(codes(&given("Position")), ["keep::own-position"]);
    assert_eq!(codes(&given("Speed")), ["keep::runtime-target"]);
    let tested = read("IF ReadMotor(1)>0.5 THEN\nMoveL p,v100,fine,t;\nENDIF");
    assert_eq!(warnings(&tested), ["state::position-tested"]);
    assert_eq!(warnings(&read("IF n>0.5 THEN\nMoveL p,v100,fine,t;\nENDIF")), Vec::<&str>::new());
}
