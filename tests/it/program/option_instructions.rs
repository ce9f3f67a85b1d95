//! Instructions of the controller's options: they are no routines that are missing.

use super::{at, codes, main_of, module, tool, warnings};

#[test]
fn instructions_of_options_are_the_controllers_own() {
    let data = format!("PERS tooldata t:={};\nCONST robtarget p:={};", tool(1), at(5, 5, 5));
    for instruction in [
        "RecoveryPosSet;",
        "RecoveryPosReset;",
        "IndGunMove gunA,50;",
        "IndGunMoveReset gunA;",
        "FricIdInit;",
        "FCSupvForce\\Zmax:=1000;",
        "FCSpdChgAct 20;",
        "FCSpdChgDeact;",
        "CornerPathWarning FALSE;",
    ] {
        let read = main_of(&data, &format!("{instruction}\nMoveL p,v100,fine,t;"));
        assert_eq!((codes(&read), warnings(&read)), (vec!["-"], vec![]), "{instruction}");
    }
}

/// RobotWare Arc, BullsEye: the tool is measured and set, whatever speed the measuring moves have. The call moves the arm, too.
#[test]
fn a_tool_that_bullseye_measures_is_not_known_behind_it() {
    let data = format!(
        "PERS tooldata t:={};\nCONST robtarget p:={};\nCONST jointtarget j:=[[1,2,3,4,50,6],[9E9,9E9,9E9,9E9,9E9,9E9]];\nPERS num scan;",
        tool(1),
        at(5, 5, 5)
    );
    let behind = |call: &str| codes(&main_of(&data, &format!("{call};\nMoveL p,v100,fine,t;"))).join(" ");
    assert_eq!(behind("BESetupToolJ j,j,scan,v100,fine,t"), "keep::instruction keep::tool-unknown");
    for call in ["BERefPointer p,v100,t", "BETcpExtend p,v100,t\\UserInit"] {
        assert_eq!(behind(call), "keep::instruction keep::tool-unknown", "{call}");
    }
    for call in ["BECheckTcp t\\UserInit", "BEUpdateTcp t", "BECheckTcp t\\Speed:=v100"] {
        assert_eq!(behind(call), "keep::tool-unknown", "{call}");
    }
    // Any other that is handed a speed moves, and leaves its tool.
    assert_eq!(behind("BEGoTo p,v100,t"), "keep::instruction -");
}

/// What a sensor sends goes into the data that are named second, from then on at any time.
#[test]
fn a_sensor_writes_what_it_is_asked_for() {
    let read = |instruction: &str| {
        module(&format!(
            "PERS tooldata t:={};\nCONST robtarget p:={};\nVAR num nH:=10;\nPROC main()\nMoveL Offs(p,0,0,nH),v100,fine,t;\n\
             {instruction}\nMoveL Offs(p,0,0,nH),v100,fine,t;\nENDPROC",
            tool(1),
            at(5, 5, 5)
        ))
    };
    assert_eq!(codes(&read("SiSetCyclic dev,nH,24;")), ["-", "-"]);
    assert_eq!(codes(&read("SiGetCyclic dev,nH,24;")), ["keep::runtime-target"; 2]);
}
