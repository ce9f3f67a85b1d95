//! Calls of the clock's own routines in a source, as the documentation asks for: what they do is known.

use super::{Bench, driftpost, err};

const TOOL: &str = "[TRUE,[[0,0,90],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]]";
const P1: &str = "[[450,-100,300],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";

/// The messages of a program that calls something before its motions, which go by a variable that nothing sets; `rShift`, which nothing
/// calls, sets a displacement.
fn messages(call: &str, options: &[&str]) -> (Option<i32>, String) {
    let bench = Bench::default();
    let source = bench.file(
        "m.mod",
        format!(
            "MODULE m\n  PERS tooldata tT:={TOOL};\n  CONST robtarget p1:={P1};\n  VAR num nH:=10;\n  VAR string sJob:=\"rJob\";\n  \
             PROC main()\n    {call}\n    MoveL Offs(p1,0,0,nH),v100,fine,tT;\n    %sJob%;\n    MoveL p1,v100,fine,tT;\n  ENDPROC\n  \
             PROC rJob()\n    MoveL p1,v100,fine,tT;\n  ENDPROC\n  PROC rShift()\n    PDispSet [[0,0,1],[1,0,0,0]];\n  ENDPROC\nENDMODULE\n"
        ),
    );
    let to = bench.path("m_tc.mod").display().to_string();
    let output = driftpost(&[&["compensate", &source, "-o", &to, "--diff", "none"][..], options].concat());
    (output.status.code(), err(&output))
}

#[test]
fn the_clocks_routines_are_no_routines_that_are_missing() {
    for form in ["schedule", "ramp"] {
        let (code, without) = messages("", &["--form", form]);
        assert_eq!(code, Some(0), "{without}");
        assert!(!without.contains("keep::"), "{without}");
        for call in
            ["tcColdStart;", "tcUpdate;", "TCUPDATE;", "tcStartAt 60;", "tcStartAt nH;", "tcWarmStart;"]
        {
            let (code, with) = messages(call, &["--form", form]);
            assert_eq!(code, Some(0), "{call}: {with}");
            let codes = |text: &str| {
                let codes = text.lines().filter_map(|line| Some(line.split_once(']')?.0.to_owned()));
                codes.filter(|code| code.starts_with("warning[")).collect::<Vec<_>>()
            };
            assert_eq!(codes(&with), codes(&without), "{form}, {call}: {with}");
        }
        let (_, other) = messages("tcOther;", &["--form", form]);
        assert!(other.contains("resolve::routine-not-given") && other.contains("tcOther"), "{other}");
    }
}

/// A name that this run does not write is none of its routines.
#[test]
fn what_another_clock_has_is_told() {
    let (_, touch) = messages("tcTouch;", &["--form", "ramp"]);
    assert!(touch.contains("resolve::routine-not-given") && touch.contains("tcTouch is not"), "{touch}");
    let search = ["--form", "ramp", "--touch", "S1=p1,tT,wobj0", "--touch-signal", "diProbe"];
    let (code, with) = messages("tcTouch;", &search);
    assert_eq!(code, Some(0), "{with}");
    assert!(!with.contains("routine-not-given") && !with.contains("not-written"), "{with}");
}
