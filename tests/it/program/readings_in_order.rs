//! Data that hold where the robot stands at one time and a written target at another: what counts is what comes to the motion.

use super::{codes, main_of};

const DATA: &str = "CONST robtarget p10:=[[400,0,300],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p20:=[[400,90,300],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
CONST jointtarget home:=[[0,10,20,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
PERS bool choice:=TRUE;
VAR bool asked;
VAR robtarget pc;
VAR robtarget other;
VAR robtarget row{2};
VAR jointtarget jv;
VAR num n;
VAR num z;";

const OWN: &str = "keep::own-position";
const OPEN: &str = "keep::runtime-target";

/// The codes of the motions of a `main`; where a written target comes to them they are those without the reading.
fn of_main(statements: &str) -> Vec<&'static str> {
    codes(&main_of(DATA, statements))
}

#[test]
fn what_was_set_last_comes_to_the_motion() {
    for (statements, expected) in [
        ("pc:=p10;\nMoveL pc,v100,fine,tool0;", vec!["-"]),
        ("pc:=CRobT();\npc:=p10;\nMoveL pc,v100,fine,tool0;", vec!["-"]),
        ("pc:=p10;\nMoveL pc,v100,fine,tool0;\npc:=CRobT();\nMoveL pc,v100,fine,tool0;", vec!["-", OWN]),
        (
            "pc:=CRobT();\nIF choice THEN\npc:=p10;\nELSE\npc:=p20;\nENDIF\nMoveL pc,v100,fine,tool0;",
            vec![OPEN],
        ),
        ("pc:=CRobT();\nIF choice THEN\npc:=p10;\nENDIF\nMoveL pc,v100,fine,tool0;", vec![OWN]),
        ("pc:=p10;\nWHILE asked DO\nMoveL pc,v100,fine,tool0;\npc:=CRobT();\nENDWHILE", vec![OWN]),
        (
            "pc:=CRobT();\nWHILE asked DO\npc:=p10;\nMoveL pc,v100,fine,tool0;\nENDWHILE\nMoveL pc,v100,fine,tool0;",
            vec!["-", OWN],
        ),
        ("n:=ReadMotor(1);\nn:=10;\nMoveL Offs(p10,0,0,n),v100,fine,tool0;", vec!["-"]),
        // The next cycle begins with what this one leaves.
        ("MoveL pc,v100,fine,tool0;\npc:=CRobT();", vec![OWN]),
        ("again:\npc:=p10;\nMoveL pc,v100,fine,tool0;\npc:=CRobT();\nIF asked GOTO again;", vec!["-"]),
        ("pc:=p10;\nagain:\nMoveL pc,v100,fine,tool0;\npc:=CRobT();\nIF asked GOTO again;", vec![OWN]),
    ] {
        assert_eq!(of_main(statements), expected, "{statements}");
    }
}

#[test]
fn a_copy_holds_what_was_copied() {
    for (statements, code) in [
        ("pc:=CRobT();\nother:=pc;\npc:=p10;\nMoveL other,v100,fine,tool0;", OWN),
        ("pc:=p10;\nother:=pc;\npc:=CRobT();\nMoveL other,v100,fine,tool0;", "-"),
        ("row{1}:=CRobT();\nrow{1}:=p10;\nMoveL row{1},v100,fine,tool0;", OWN),
        ("pc:=CRobT();\nrow{1}:=pc;\npc:=row{1};\nMoveL pc,v100,fine,tool0;", OWN),
        ("pc:=CRobT();\nz:=pc.trans.z;\nMoveL Offs(p10,0,0,z),v100,fine,tool0;", OWN),
        ("pc:=CRobT();\nz:=pc.trans.z;\nz:=5;\nMoveL Offs(p10,0,0,z),v100,fine,tool0;", "-"),
    ] {
        assert_eq!(of_main(statements), [code], "{statements}");
    }
}

/// Whatever part of position and orientation is left of the reading counts; configuration and external axes hold no drift.
#[test]
fn a_reading_whose_pose_was_set_anew_is_none() {
    for (statements, code) in [
        ("pc:=CRobT();\npc.trans:=p10.trans;\npc.rot:=p10.rot;\nMoveL pc,v100,fine,tool0;", OPEN),
        ("pc:=CRobT();\npc.trans:=p10.trans;\nMoveL pc,v100,fine,tool0;", OWN),
        ("pc:=CRobT();\npc.trans.x:=1;\npc.trans.y:=1;\npc.rot:=p10.rot;\nMoveL pc,v100,fine,tool0;", OWN),
        (
            "pc:=CRobT();\nother:=pc;\nother.trans:=p10.trans;\nother.rot:=p10.rot;\nMoveL other,v100,fine,tool0;",
            OPEN,
        ),
        ("pc:=p20;\npc.extax:=CRobT().extax;\nMoveL pc,v100,fine,tool0;", OPEN),
        ("pc:=p20;\npc.rot:=CRobT().rot;\nMoveL pc,v100,fine,tool0;", OWN),
        ("pc:=CRobT();\nother:=p10;\nother.robconf:=pc.robconf;\nMoveL other,v100,fine,tool0;", OPEN),
        ("pc:=CRobT();\nother:=p10;\nother.rot:=pc.rot;\nMoveL other,v100,fine,tool0;", OWN),
        ("jv:=home;\njv.robax.rax_4:=ReadMotor(4);\nMoveAbsJ jv,v100,fine,tool0;", OWN),
        ("jv:=home;\njv.robax.rax_4:=ReadMotor(4);\njv:=home;\nMoveAbsJ jv,v100,fine,tool0;", OPEN),
    ] {
        assert_eq!(of_main(statements), [code], "{statements}");
    }
}

/// Across calls, traps and handlers a reading may come in between.
#[test]
fn what_other_routines_read_counts() {
    for (statements, expected) in [
        ("pc:=p10;\nhere;\nMoveL pc,v100,fine,tool0;\nENDPROC\nPROC here()\npc:=CRobT();", vec![OWN]),
        ("pc:=CRobT();\ntable;\nMoveL pc,v100,fine,tool0;\nENDPROC\nPROC table()\npc:=p10;", vec!["-"]),
        (
            "VAR intnum i;\nCONNECT i WITH t;\npc:=p10;\nMoveL pc,v100,fine,tool0;\nENDPROC\nTRAP t\npc:=CRobT();\nENDTRAP\nPROC unused()",
            vec![OWN],
        ),
        ("pc:=p10;\nMoveL pc,v100,fine,tool0;\nERROR\npc:=CRobT();\nRETRY;", vec![OWN]),
        (
            "go p10;\ngo CRobT();\nENDPROC\nPROC go(robtarget p)\nMoveL p,v100,fine,tool0;\np:=p20;\nMoveL p,v100,fine,tool0;",
            vec![OWN, "-"],
        ),
        (
            "pc:=p10;\nset pc;\nMoveL pc,v100,fine,tool0;\nENDPROC\nPROC set(INOUT robtarget p)\np:=CRobT();\np:=p10;",
            vec![OWN],
        ),
        ("pc:=CRobT();\npc:=p10;\n%\"not\"+\"Given\"%;\nMoveL pc,v100,fine,tool0;", vec!["-"]),
        ("pc:=CRobT();\npc:=p10;\nunknown pc;\nMoveL pc,v100,fine,tool0;", vec![OWN]),
        ("pc:=CRobT();\npc:=p10;\nSetDataVal \"pc\",p20;\nMoveL pc,v100,fine,tool0;", vec![OWN]),
    ] {
        assert_eq!(of_main(statements), expected, "{statements}");
    }
}

/// An assignment that fails is passed over by TRYNEXT: what was there before is still there.
#[test]
fn what_an_assignment_that_fails_leaves_counts() {
    for (statements, code) in [
        ("pc:=CRobT();\npc:=row{n};\nMoveL pc,v100,fine,tool0;\nERROR\nTRYNEXT;", OWN),
        ("z:=ReadMotor(1);\nz:=1/n;\nMoveL Offs(p10,0,0,z),v100,fine,tool0;\nERROR\nTRYNEXT;", OWN),
        ("pc:=CRobT();\npc:=p10;\nMoveL pc,v100,fine,tool0;\nERROR\nTRYNEXT;", "-"),
        ("pc:=CRobT();\npc:=row{n};\npc:=p10;\nMoveL pc,v100,fine,tool0;\nERROR\nTRYNEXT;", "-"),
    ] {
        assert_eq!(of_main(statements), [code], "{statements}");
    }
}

/// A reading comes by ways that no assignment shows: a loop's bounds, a datum's name, an axis' angle within a function, a fit.
#[test]
fn a_reading_that_comes_by_other_ways_is_one() {
    for statements in [
        "FOR h FROM CRobT().trans.z TO 20 DO\nMoveL Offs(p10,0,0,h),v100,fine,tool0;\nENDFOR",
        "FOR h FROM 1 TO 20 STEP ReadMotor(1) DO\nz:=h;\nMoveL Offs(p10,0,0,z),v100,fine,tool0;\nENDFOR",
        "other:=CRobT();\npc:=recall(\"other\");\nMoveL pc,v100,fine,tool0;\nENDPROC\nFUNC robtarget recall(string name)
VAR robtarget r;\nGetDataVal name,r;\nRETURN r;\nENDFUNC\nPROC unused()",
        "MoveAbsJ here(home),v100,fine,tool0;\nENDPROC\nFUNC jointtarget here(jointtarget q)\nVAR num a;
GetJointData 1\\Position:=a;\nq.robax.rax_1:=a;\nRETURN q;\nENDFUNC\nPROC unused()",
        "pc:=p20;\nother:=CRobT();\nSetAllDataVal \"robtarget\"\\Object:=\"pc\",other;\nMoveL pc,v100,fine,tool0;",
        "VAR pos pts{3};\nVAR pos middle;\nVAR num radius;\nVAR pos normal;\npts{1}:=CPos();
FitCircle pts,middle,radius,normal;\npc:=p10;\npc.trans:=middle;\nMoveL pc,v100,fine,tool0;",
    ] {
        assert_eq!(of_main(statements), [OWN], "{statements}");
    }
    let counted = "FOR h FROM 1 TO 20 DO\nMoveL Offs(p10,0,0,h),v100,fine,tool0;\nENDFOR";
    assert_ne!(of_main(counted), [OWN]);
}
