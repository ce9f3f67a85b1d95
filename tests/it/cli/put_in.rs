//! What `restore` makes of a module in which routines, data and motions were put in by hand, or motions made comments.

use super::changed_by_hand::{HOME, compensated, module, once, restored};
use super::{Bench, driftpost, err, out};

const FORMS: [&str; 4] = ["schedule", "ramp", "live", "auto"];
const ROUTINES: &str = "! for the service\nPROC rService()\nWaitTime 1;\nENDPROC\nFUNC num nOwn()\nRETURN 1;\nENDFUNC\nTRAP tOwn\nRETURN;\nENDTRAP\n";

fn source() -> String {
    module(
        "CONST robtarget p20:=[[430,60,300],@;",
        "MoveL p20,v100,fine,tGun;\nMoveL [[444,50,300],@,v100,fine,tGun;\nMoveL Offs(p20,0,0,5),v100,fine,tGun;",
    )
}

/// The text with something in front of the only line that begins with `line`.
fn before(text: &str, line: &str, put_in: &str) -> String {
    once(text, &format!("\n{line}"), &format!("\n{put_in}{line}"))
}

/// The source line that a declaration of ours begins with, which is put among the others.
fn line_with<'t>(text: &'t str, what: &str) -> &'t str {
    text.lines().find(|line| line.contains(what) && !line.starts_with('!')).unwrap()
}

#[test]
fn routines_and_data_that_were_put_in_stay_where_they_are() {
    let bench = Bench::default();
    let source = source();
    let point = module("", "").lines().find(|line| line.contains("tGun:=")).unwrap().replace("tGun", "tNew");
    let datum = format!("! the new one\n{point}\n");
    for form in FORMS {
        let text = compensated(&bench, &source, form);
        let (first, second) = (line_with(&text, "num tcMode:="), line_with(&text, "num tcMinute"));
        let cold = line_with(&text, "PROC tcColdStart");
        for (changed, expected) in [
            (before(&text, "ENDMODULE", ROUTINES), before(&source, "ENDMODULE", ROUTINES)),
            (before(&text, "PROC main", &datum), before(&source, "PROC main", &datum)),
            (before(&text, first, &datum), before(&source, "PROC main", &datum)),
            (before(&text, first, ROUTINES), before(&source, "PROC main", ROUTINES)),
            (before(&text, second, &datum), before(&source, "PROC main", &datum)),
            (
                before(&text, cold, &format!("{ROUTINES}\n")),
                before(&source, "ENDMODULE", &format!("\n{ROUTINES}")),
            ),
            (
                before(&before(&text, second, &datum), "ENDMODULE", ROUTINES),
                before(&before(&source, "PROC main", &datum), "ENDMODULE", ROUTINES),
            ),
            // Called as what was added is.
            (
                before(
                    &before(&text, second, "VAR num tcOwn:=7;\n"),
                    "ENDMODULE",
                    "PROC tcRest()\nENDPROC\n",
                ),
                before(
                    &before(&source, "PROC main", "VAR num tcOwn:=7;\n"),
                    "ENDMODULE",
                    "PROC tcRest()\nENDPROC\n",
                ),
            ),
        ] {
            let (message, back) = restored(&bench, &changed, 0);
            assert_eq!(back, expected, "{form}");
            assert!(!message.contains("warning"), "{form}: {message}");
        }
        // With a point that was touched up, by 3 and 4 mm.
        let touched = once(&before(&text, "ENDMODULE", ROUTINES), "p20:=[[430,60,", "p20:=[[433,64,");
        let (message, back) = restored(&bench, &touched, 1);
        assert!(message.contains("p20 was ") && message.contains("by 5.0000 mm"), "{form}: {message}");
        assert_eq!(back, before(&once(&source, "p20:=[[430,60,", "p20:=[[433,64,"), "ENDMODULE", ROUTINES));
        let [a, changed] = ["a.mod", "changed.mod"].map(|name| bench.path(name).display().to_string());
        let shown = driftpost(&["diff", &a, &changed]);
        assert_eq!(shown.status.code(), Some(1), "{form}: {}{}", out(&shown), err(&shown));
    }
}

#[test]
fn what_may_be_added_or_put_in_is_not_taken_out() {
    let bench = Bench::default();
    let source = source();
    let text = compensated(&bench, &source, "ramp");
    let (own, changed) = ("PROC tcRest()\nENDPROC\n", once(&text, "IF tcText<>tcSaid ", "IF tcText=tcSaid "));
    let (message, _) = restored(&bench, &before(&changed, "ENDMODULE", own), 2);
    let line =
        |name: &str| changed.lines().position(|line| line.contains(&format!("PROC {name}("))).unwrap() + 1;
    assert!(
        message.contains(&format!("line {}: whether tcSay is one of the routines", line("tcSay")))
            && message.contains("restore::damaged")
            && message.contains("above tcAt"),
        "{message}"
    );
    // There it is told.
    let (message, back) =
        restored(&bench, &before(&changed, line_with(&changed, "FUNC robtarget tcAt("), own), 1);
    assert!(message.contains("tcSay, which was added, is not as it was made"), "{message}");
    assert_eq!(back, before(&source, "ENDMODULE", &format!("\n{own}")));
}

#[test]
fn a_motion_that_was_made_a_comment_has_its_target_again() {
    let bench = Bench::default();
    let source = module(
        "CONST robtarget p20:=[[430,60,300],@;\n\
         CONST robtarget pa{3}:=[[[420,30,350],@,[[420,40,350],@,[[420,50,350],@];",
        "MoveL p20,v100,fine,tGun;\nMoveL [[444,50,300],@,v100,fine,tGun;\nMoveL Offs(p20,0,0,5),v100,fine,tGun;\n\
         MoveL pa{nPos},v100,fine,tGun;\nMoveL Offs(pa{nPos},0,0,7),v100,fine,tGun;\nMoveC p20,[[444,70,300],@,v100,fine,tGun;",
    );
    // As a pendant and an editor make comments.
    let commented = |text: &str| {
        let motion = |line: &str| match line {
            HOME => line.to_owned(),
            _ if line.starts_with("MoveL") => format!("!{line}"),
            _ if line.starts_with("MoveC") => format!("  ! {line}"),
            _ => line.to_owned(),
        };
        text.lines().map(|line| motion(line) + "\n").collect::<String>()
    };
    for form in FORMS {
        let text = compensated(&bench, &source, form);
        let (message, back) = restored(&bench, &commented(&text), 0);
        assert_eq!(back, commented(&source), "{form}");
        assert!(!message.contains("warning") && !message.contains("touched up"), "{form}: {message}");
    }
    // A whole routine behind the others, and a target that stands on two lines.
    let two = once(&source, "MoveL [[444,50,300],", "MoveL [[444,50,300], ! there\n  ");
    let text = compensated(&bench, &two, "schedule");
    let (_, back) = restored(&bench, &commented(&text), 0);
    assert_eq!(back, commented(&source));
    let element = line_with(&text, "MoveL tcp20{tcK()}");
    let (_, back) =
        restored(&bench, &before(&text, "ENDMODULE", &format!("!PROC rOld()\n!{element}\n!ENDPROC\n")), 0);
    assert!(back.contains("!PROC rOld()\n!MoveL p20,v100,fine,tGun;\n!ENDPROC\n"), "{back}");
    // Touched up before: the comment has the new value.
    let array = text.find("robtarget tcp20{").unwrap();
    let moved = format!("{}{}", &text[..array], text[array..].replacen("[[430,60,300]", "[[433,64,300]", 1));
    let (message, back) = restored(&bench, &commented(&moved), 1);
    assert!(
        message.contains("p20 was touched up") && back.contains("!MoveL [[433,64,300],"),
        "{message}{back}"
    );
}

#[test]
fn a_motion_that_was_copied_is_as_it_was_made() {
    let bench = Bench::default();
    let source = source();
    let motion = |text: &str| line_with(text, "[[444,50,300]").to_owned() + "\n";
    for form in ["ramp", "live", "auto"] {
        let text = compensated(&bench, &source, form);
        let doubled = |text: &str| once(text, &motion(text), &motion(text).repeat(2));
        let (message, back) = restored(&bench, &doubled(&text), 0);
        assert_eq!(back, doubled(&source), "{form}");
        assert!(!message.contains("warning") && !message.contains("touched up"), "{form}: {message}");
        // Of another place it is none.
        let other =
            once(&text, &motion(&text), &(motion(&text) + &motion(&text).replace("[[444,50,", "[[444,55,")));
        let (message, _) = restored(&bench, &other, 1);
        assert!(
            message.contains("[[444,55,300]") && message.contains("restore::original"),
            "{form}: {message}"
        );
    }
}
