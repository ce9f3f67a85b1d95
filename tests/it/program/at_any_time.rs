//! What runs beside the program: traps, procedures that a move calls in its corner (MoveLSync), and what these call.

use super::{at, code, codes, module, tool};
use rapid_program::Program;

const TOOL: &str = "keep::tool-unknown";
const DISPLACED: &str = "keep::displacement";

/// A program with three moves, the second of which is `second`, and other routines.
fn moves(second: &str, routines: &str) -> Program {
    module(&format!(
        "PERS tooldata t:={};\nPERS loaddata ld:=[5,[0,0,80],[1,0,0,0],0,0,0];\nVAR string sv;\nVAR intnum i1;\nVAR triggdata tg;
CONST robtarget p:={};\nPROC main()\nt:={};\nMoveL p,v100,fine,t;\n{second}\nMoveL p,v100,fine,t;\nENDPROC\n{routines}",
        tool(1),
        at(5, 5, 5),
        tool(1)
    ))
}

fn sets_tool() -> String {
    format!("PROC rSet()\nt:={};\nENDPROC\n", tool(200))
}

#[test]
fn what_a_move_calls_in_its_corner_counts_at_any_time() {
    let displaces = "PROC rSet()\nPDispSet [[0,0,20],[1,0,0,0]];\nENDPROC";
    let calls = format!("PROC rOuter()\nrSet;\nENDPROC\n{}", sets_tool());
    for (second, routines, expected) in [
        ("MoveLSync p,v100,z10,t,\"rSet\";", &*sets_tool(), TOOL),
        ("MoveJSync p,v100\\T:=2,z10,t\\WObj:=wobj0,\"RSET\";", &*sets_tool(), TOOL),
        ("MoveCSync p,p,v100,z10,t,\"rSet\";", &*sets_tool(), TOOL),
        ("MoveLSync p,v100,z10,t,\"rOuter\";", &*calls, TOOL),
        // A name that only run time tells: any procedure without parameters.
        ("MoveLSync p,v100,z10,t,sv;", &*sets_tool(), TOOL),
        ("MoveLSync p,v100,z10,t,\"rSet\";", displaces, DISPLACED),
        // Another procedure is called.
        (
            "MoveLSync p,v100,z10,t,\"rOther\";",
            &*format!("{}PROC rOther()\nSetDO do1,1;\nENDPROC", sets_tool()),
            "-",
        ),
        ("MoveLSync p,v100,z10,t,\"rSet\";", "PROC rSet()\nSetDO do1,1;\nENDPROC", "-"),
    ] {
        let read = moves(second, routines);
        // As it may run later than the statements behind it, and the cycle before has called it, too.
        assert_eq!(codes(&read)[..3], [expected; 3], "{second} {routines}");
    }
}

/// ConfL\Off and a load that such a procedure grips come into force on some way.
#[test]
fn what_a_move_calls_in_its_corner_comes_into_force() {
    let second = "MoveLSync p,v100,z10,t,\"rSet\";";
    let off = moves(second, "PROC rSet()\nConfL\\Off;\nENDPROC");
    assert_eq!(off.motions[2].setup.conf_monitored, None);
    let none = moves(second, "PROC rSet()\nENDPROC");
    assert_eq!(none.motions[2].setup.conf_monitored, Some(true));
    // A motion there begins anywhere, as a trap's does.
    let moving = moves(second, "PROC rSet()\nMoveL p,v100,fine,t;\nENDPROC");
    assert_eq!(moving.motions.len(), 4);
    assert!(moving.after_traps.values().any(|after| after.motions.len() == 1));
}

/// A trap may run whether or not the text shows that it is connected, enabled, or its interrupt deleted.
#[test]
fn traps_count_wherever_they_are_connected() {
    let trap = format!("TRAP tr\nt:={};\nENDTRAP\n", tool(200));
    let connects = "PROC rConnect()\nCONNECT i1 WITH tr;\nISignalDI di1,1,i1;\nENDPROC\n";
    for second in [
        "rConnect;",
        "MoveL p,v100,fine,t;",
        "CONNECT i1 WITH tr;\nISignalDI di1,1,i1;\nMoveL p,v100,fine,t;\nIDelete i1;",
        "CONNECT i1 WITH tr;\nTriggInt tg,5,i1;\nTriggL p,v100,tg,z10,t;",
    ] {
        let read = moves(second, &format!("{connects}{trap}"));
        assert!(read.motions.iter().all(|motion| code(motion) == Some(TOOL)), "{second} {:?}", codes(&read));
    }
    let idle = moves("MoveL p,v100,fine,t;", "TRAP tr\nSetDO do1,1;\nENDTRAP");
    assert_eq!(codes(&idle), ["-"; 3]);
}

#[test]
fn what_a_trap_calls_counts_as_what_it_does_itself() {
    let by_name = "TRAP tr\nrSet;\nENDTRAP\n";
    let through_another = "TRAP tr\nrOuter;\nENDTRAP\nPROC rOuter()\nIF DI1=1 rSet;\nENDPROC\n";
    let by_text = "TRAP tr\n%\"rSet\"%;\nENDTRAP\n";
    for trap in [by_name, through_another, by_text] {
        let read = moves("MoveL p,v100,fine,t;", &format!("{trap}{}", sets_tool()));
        assert_eq!(codes(&read), [TOOL; 3], "{trap}");
    }
    // What it declares itself is its own in every call.
    let own =
        "TRAP tr\nrOwn;\nENDTRAP\nPROC rOwn()\nVAR robtarget q;\nq:=p;\nMoveL q,v100,fine,tool0;\nENDPROC\n";
    assert_eq!(codes(&moves("rOwn;", own)), ["-"; 3]);
}
