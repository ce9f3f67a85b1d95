//! Calls of what is not among the given files and seems to move the arm.

use super::state::{MOVE, data};
use super::{at, codes, main_of, module, warnings};

/// Each call with a motion behind it: whether the call is listed as a motion that is kept.
fn is_listed(call: &str) -> bool {
    let more = "CONST jointtarget j:=[[1,2,3,4,50,6],[9E9,9E9,9E9,9E9,9E9,9E9]];\nCONST speeddata slow:=[20,10,5000,1000];\n\
                CONST robtarget grid{2}:=[p,p];\nVAR num n;\nVAR pos ps;";
    let read = main_of(&format!("{}\n{more}", data()), &format!("{call};\n{MOVE}"));
    match &*codes(&read) {
        ["-"] => false,
        ["keep::instruction", "-"] => true,
        other => panic!("{call}: {other:?}"),
    }
}

/// What is handed a target and a speed goes there somehow; a name may say by itself that the arm moves.
#[test]
fn a_call_of_what_is_not_given_is_a_motion_that_is_kept_where_it_seems_to_move() {
    let inline = at(5, 5, 5);
    for call in [
        &*format!("Go_CollClr 3\\Coll_B:=4,d,{inline},v200,fine,t\\WObj:=w"),
        "Go p,v100,z10,t",
        "Go p,v83,z10,t", // a speed that a post-processor writes and nobody declares
        "Go j,slow,z10,t",
        "Go Offs(p,0,0,10),v100,z10,t",
        "Go grid{n},v100,z10,t",
        "Go [[1,2,3,4,50,6],[9E9,9E9,9E9,9E9,9E9,9E9]],v100",
        "Go [[n,5,5],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100",
        "Go\\To:=p\\Speed:=v100",
        "MoveHome",
        "move_home n",
        "SearchPart",
        "ArcStitch p",
        "SPOT_2 n",
    ] {
        assert!(is_listed(call), "{call}");
    }
    for call in [
        "Go p,z10",
        "Go v100,t",
        "Go ps,v100",
        "Go p.trans,v100",
        "Go [1,2,3,4],v100",
        "rHome",
        "ArcOn",
        "Archive n",
        "TPWrite \"Move\"",
        "ArcRefresh",
        "TriggSpeed n,1,0.1,ao1,1",
    ] {
        assert!(!is_listed(call), "{call}");
    }
}

/// It has the name that stands there, and says with what the arm moves where nobody knows; behind it nobody knows where the arm stands.
#[test]
fn the_reason_names_the_call_and_its_target() {
    let read = main_of(&data(), &format!("{MOVE}MoveL_CollClr 3,p,v200,fine,t;\n{MOVE}"));
    assert_eq!(codes(&read), ["-", "keep::instruction", "-"]);
    let listed = &read.motions[1];
    assert_eq!((&*listed.setup.kind, listed.line, listed.targets.len()), ("MoveL_CollClr", 7, 0));
    let reason = &listed.skip_reason.as_ref().unwrap().reason;
    assert!(reason.starts_with("MoveL_CollClr is neither") && reason.ends_with(" with p"), "{reason}");
    assert_eq!((read.motions[2].previous, read.motions[2].from_start), (None, false));
    assert_eq!(warnings(&read), ["resolve::routine-not-given", "target::read-as-data"]);
    let inline = main_of(&data(), &format!("Go {},v200,fine,t;\n{MOVE}", at(5, 5, 5)));
    let reason = &inline.motions[0].skip_reason.as_ref().unwrap().reason;
    assert!(reason.ends_with("with the target that is written there"), "{reason}");
}

/// A wrapper that is given is followed: its own motion is what moves.
#[test]
fn a_wrapper_that_is_given_is_no_motion_of_its_own() {
    let wrapper = "PROC MoveL_CollClr(num n,robtarget q,speeddata v,zonedata z,PERS tooldata u)\nMoveL q,v,z,u;\nENDPROC";
    let read =
        module(&format!("{}\nPROC main()\nMoveL_CollClr 3,p,v200,fine,t;\n{MOVE}ENDPROC\n{wrapper}", data()));
    assert_eq!(read.motions.iter().map(|m| &*m.setup.kind).collect::<Vec<_>>(), ["MoveL", "MoveL"]);
    assert!(!warnings(&read).contains(&"resolve::routine-not-given"));
}

/// Externally guided motion goes where a sensor says, and what comes behind begins there.
#[test]
fn motion_that_a_sensor_guides_is_kept() {
    for run in ["EGMRunPose egm1,EGM_STOP_HOLD\\X\\Y\\Z\\CondTime:=5;", "EGMRunJoint egm1,EGM_STOP_HOLD\\J1;"]
    {
        let read = main_of(&data(), &format!("{MOVE}{run}\n{MOVE}"));
        assert_eq!(codes(&read), ["-", "keep::instruction", "-"], "{run}");
        assert_eq!((read.motions[2].previous, read.motions[2].from_start), (None, false), "{run}");
        assert!(read.motions[1].skip_reason.as_ref().unwrap().reason.contains("sensor"));
        assert_eq!(warnings(&read), [""; 0], "{run}");
    }
}
