//! Instructions of options that change how the motions behind them go: force control, and how arcs turn the tool.

use super::state::{MOVE, data};
use super::{because_line, codes, main_of, warnings};

/// ABB's manual of force control: FCPress1LStart presses and goes on pressing, FCPressEnd ends it.
#[test]
fn motion_between_the_beginning_and_the_end_of_pressing_is_kept() {
    let start = "FCPress1LStart p,v100,\\Fz:=5,5,z10,t\\WObj:=w;\n";
    for end in ["FCPressEnd p,v100,t\\WObj:=w;", "FCPressL p,v100,5,z10,t;\nFCDeact;"] {
        let body = format!("{MOVE}{start}{MOVE}{end}\n{MOVE}");
        let read = main_of(&data(), &body);
        assert_eq!(codes(&read), ["-", "keep::instruction", "keep::soft-servo", "keep::instruction", "-"]);
        assert_eq!((because_line(&read, 2), warnings(&read)), (7, vec![]));
    }
}

/// ABB's reference manual, CirPathMode: with the wrist's axes the tool is not turned to what is written, with CirPointOri it is at the
/// circle point; whether it turns there is seen from the poses.
#[test]
fn the_way_in_which_arcs_turn_the_tool_is_followed() {
    let arc = "MoveC p,p,v100,fine,t\\WObj:=w;\n";
    let read = |body: &str| {
        let read = main_of(&data(), body);
        let uneven = |at: usize| read.motions[at].setup.uneven_turn.is_some();
        (codes(&read), (0..read.motions.len()).map(uneven).collect::<Vec<_>>())
    };
    for option in ["Wrist45", "Wrist46", "Wrist56"] {
        let body = format!("{arc}CirPathMode\\{option};\n{arc}{MOVE}CirPathMode\\PathFrame;\n{arc}");
        // What is in force where main ends is in force where it begins anew.
        assert_eq!(
            read(&body),
            (vec!["-", "keep::circle-orientation", "-", "-"], vec![false; 4]),
            "{option}"
        );
    }
    let body = format!("CirPathMode\\CirPointOri;\n{arc}{MOVE}CirPathMode \\ObjectFrame;\n{arc}");
    assert_eq!(read(&body), (vec!["-"; 3], vec![true, false, false]));
    let body = format!("{arc}IF DI1=1 CirPathMode\\CirPointOri;\n{arc}");
    assert_eq!(read(&body), (vec!["-"; 2], vec![true, true]));
    let body = format!("{arc}IF DI1=1 CirPathMode\\Wrist45;\n");
    assert_eq!(read(&body).0, ["keep::circle-orientation"]);
}

/// Arc welding, `\Track`: the sensor moves the path. It is said once, at the first weld that does.
#[test]
fn welds_that_follow_their_seam_are_told_of() {
    let weld = |name: &str, targets: &str, option: &str| {
        format!("{name} {targets},v100,sm,wd,z10,t\\WObj:=w{option};\n")
    };
    let seam = "VAR num sm;\nVAR num wd;\nVAR num td;\n";
    let read = |body: &str| main_of(&format!("{}{seam}", data()), body);
    let plain = format!("{}{}", weld("ArcLStart", "p", ""), weld("ArcCEnd", "p,p", ""));
    assert_eq!((codes(&read(&plain)), warnings(&read(&plain))), (vec!["-"; 2], vec![]));
    for tracked in [
        weld("ArcL", "p", "\\Track:=td"),
        format!("{}{}", weld("ArcLStart", "p", "\\Track:=td"), weld("ArcLEnd", "p", "\\Track:=td")),
        weld("ArcC", "p,p", " \\track:=td"),
    ] {
        let read = read(&format!("{MOVE}{tracked}"));
        assert_eq!(warnings(&read), ["path::seam-tracking"], "{tracked}");
        assert!(codes(&read).iter().all(|code| *code == "-"), "{tracked}");
    }
}
