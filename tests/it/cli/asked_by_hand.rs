//! What `restore` and `diff` say where what motions ask was changed by hand: the clock that is not asked, a motion that was copied, a
//! correction taken out or put in, a target whose declaration is gone.

use super::changed_by_hand::{compensated, module, once, restored};
use super::{Bench, driftpost, err, out};

/// Two named targets, an arc, and a target that is written out.
fn source() -> String {
    module(
        "CONST robtarget p20:=[[430,60,300],@;\nCONST robtarget p30:=[[460,80,330],@;\nCONST robtarget p40:=[[440,90,330],@;",
        "MoveL p20,v100,fine,tGun;\nMoveC p30,p40,v100,fine,tGun;\nMoveL [[425,35,350],@,v100,fine,tGun;",
    )
}

/// The line, counted from 1, in which a text stands.
fn line_of(text: &str, what: &str) -> usize {
    1 + text[..text.find(what).unwrap()].matches('\n').count()
}

/// The exit code of `diff` between the source and a changed module, and all that it says.
fn compared(bench: &Bench, source: &str, changed: &str) -> (Option<i32>, String) {
    let (a, b) = (bench.file("source.mod", source), bench.file("changed.mod", changed));
    let output = driftpost(&["diff", &a, &b]);
    (output.status.code(), format!("{}{}", out(&output), err(&output)))
}

#[test]
fn a_motion_that_does_not_ask_the_clock_is_told() {
    let bench = Bench::default();
    let source = source();
    for (form, was, by) in [
        ("schedule", "MoveL tcp20{tcK()}", "MoveL tcp20{tcI}"),
        ("schedule", "tcp40{tcI}", "tcp40{tcK()}"),
        ("ramp", "tcAt([[425", "tcAtSame([[425"),
        ("live", "tcLive(p20", "tcLiveSame(p20"),
        ("live", "tcLiveSame(p40", "tcLive(p40"),
    ] {
        let text = compensated(&bench, &source, form);
        let changed = once(&text, was, by);
        let (message, back) = restored(&bench, &changed, 1);
        let told = format!("changed.mod:{}: the motion asks with another correction", line_of(&text, was));
        assert!(message.contains("restore::arguments") && message.contains(&told), "{form}: {message}");
        assert_eq!(back, source, "{form}");
        assert_eq!(compared(&bench, &source, &changed).0, Some(1), "{form}");
    }
}
