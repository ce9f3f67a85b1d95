//! What `restore` and `diff` say where what motions ask was changed by hand: the clock that is not asked, a motion that was copied, a
//! correction taken out or put in, a target whose declaration is gone.

use super::changed_by_hand::{HOME, REST, compensated, module, once, restored};
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
        let told = format!("changed.mod:{}: the motion does not ask as it was made", line_of(&text, was));
        assert!(message.contains("restore::arguments") && message.contains(&told), "{form}: {message}");
        assert_eq!(back, source, "{form}");
        assert_eq!(compared(&bench, &source, &changed).0, Some(1), "{form}");
    }
}

/// An array holds the target after its declaration is gone: what is got back is told to name it, in whichever way it is gone.
#[test]
fn a_target_whose_declaration_is_gone_is_told() {
    let bench = Bench::default();
    let source = module(
        "CONST robtarget p20:=[[430,60,300],@;\nCONST robtarget pa{2}:=[[[450,60,300],@,[[450,70,300],@];",
        "MoveL p20,v100,fine,tGun;\nMoveL Offs(p20,0,0,5),v100,fine,tGun;\nMoveL pa{nPos},v100,fine,tGun;\nTPWrite \"p20\";",
    );
    let text = compensated(&bench, &source, "schedule");
    let gone = |name: &str| -> String {
        let is_it = |line: &&str| line.starts_with(&format!("CONST robtarget {name}"));
        text.lines().filter(|line| !is_it(line)).map(|line| format!("{line}\n")).collect()
    };
    let both = vec![("MoveL tcp20{", "p20"), ("MoveL tc1", "Offs(p20,0,0,5)")];
    for (changed, told) in [
        (gone("p20"), both.clone()),
        (once(&text, "CONST robtarget p20:", "CONST robtarget pWeld:"), both),
        (gone("pa{2}"), vec![("MoveL tcpa{", "pa")]),
    ] {
        let (message, _) = restored(&bench, &changed, 1);
        assert_eq!(message.matches("restore::lost").count(), told.len(), "{message}");
        for (motion, target) in told {
            let told = format!(":{}: the motion goes to {target}, whose", line_of(&changed, motion));
            assert!(message.contains(&told), "{told}\n{message}");
        }
        assert_eq!(compared(&bench, &source, &changed).0, Some(1));
    }
    // With its motions gone as well nothing names it; nor is the target of another module lost to this one.
    let is_motion = |line: &&str| line.contains("{tcK()}") && !line.contains("tcpa{");
    let all: String =
        gone("p20").lines().filter(|line| !is_motion(line)).map(|line| format!("{line}\n")).collect();
    let (message, _) = restored(&bench, &all, 0);
    assert!(!message.contains("warning"), "{message}");
    let elsewhere = [
        ("cell/A.mod", module("", "MoveL p20,v100,fine,tGun;")),
        (
            "cell/B.mod",
            format!("MODULE B\n{}\nENDMODULE\n", "CONST robtarget p20:=[[430,60,300],@;".replace('@', REST)),
        ),
    ];
    elsewhere.iter().for_each(|(path, text)| _ = bench.file(path, text));
    let path = |name: &str| bench.path(name).display().to_string();
    let made = driftpost(&["compensate", &path("cell"), "-o", &path("tc"), "--diff", "none"]);
    assert_eq!(made.status.code(), Some(0), "{}", err(&made));
    let back = driftpost(&["restore", &path("tc"), "-o", &path("back")]);
    assert!(back.status.code() == Some(0) && !err(&back).contains("warning"), "{}", err(&back));
}

/// Arrays of targets that are written out are called by their lines in every module: the one of another module is of another place.
#[test]
fn a_motion_that_was_copied_with_the_name_of_its_array_is_told() {
    let bench = Bench::default();
    let source = source();
    let text = compensated(&bench, &source, "schedule");
    let motion = text.lines().find(|line| line.starts_with("MoveL tc1")).unwrap();
    let changed = once(&text, motion, &format!("{motion}\nWaitTime 1;\n{motion}"));
    let line = line_of(&text, motion);
    let (message, _) = restored(&bench, &changed, 1);
    let told =
        format!("was made for one motion, and several go by it, lines {line}, {}: one was copied", line + 2);
    assert!(message.contains("restore::copied") && message.contains(&told), "{message}");
    // A target of a name is the same one wherever it is named.
    let named = "MoveL tcp20{tcK()},v100,fine,tGun;\n";
    let (message, back) = restored(&bench, &once(&text, named, &named.repeat(2)), 0);
    assert!(!message.contains("warning"), "{message}");
    assert_eq!(back, source.replace("MoveL p20,v100,fine,tGun;\n", &"MoveL p20,v100,fine,tGun;\n".repeat(2)));
}

/// One that is deleted took its correction with it.
#[test]
fn a_correction_taken_off_a_target_that_is_written_out_is_told() {
    let bench = Bench::default();
    let source = source();
    let plain = source.lines().find(|line| line.contains("MoveL [[425")).unwrap();
    for form in ["ramp", "schedule", "auto", "live"] {
        let text = compensated(&bench, &source, form);
        let is_it =
            |line: &&str| line.starts_with("MoveL") && (line.contains("[[425") || line.contains("tc1"));
        let motion = text.lines().find(is_it).unwrap();
        let changed = once(&text, motion, plain);
        let (message, back) = restored(&bench, &changed, 1);
        let told = format!(
            "the correction of [[425,35,350],...] was taken out of a motion: it goes to [[425,35,350],...] as it is, line {}",
            line_of(&text, motion)
        );
        assert!(message.contains("restore::uncorrected") && message.contains(&told), "{form}: {message}");
        assert_eq!(back, source, "{form}");
        assert_eq!(compared(&bench, &source, &changed).0, Some(1), "{form}");
        let (message, _) = restored(&bench, &once(&text, &format!("{motion}\n"), ""), 0);
        assert!(!message.contains("warning"), "{form}: {message}");
    }
}

/// The original is the same, byte for byte, whatever asks: what is corrected is not.
#[test]
fn a_correction_that_was_taken_out_or_put_in_is_told() {
    let bench = Bench::default();
    let source = source().replace("ENDPROC", "rSub p20;\nENDPROC\nPROC rSub(robtarget p)\nENDPROC");
    for (form, was, by, code, target) in [
        ("ramp", "MoveL tcAt(p20,tcP20)", "MoveL p20", "uncorrected", "p20"),
        ("ramp", "tcAtSame(p40,tcP40)", "p40", "uncorrected", "p40"),
        ("ramp", "rSub p20;", "rSub tcAt(p20,tcP20);", "corrected", "p20"),
        ("schedule", "MoveL tcp20{tcK()}", "MoveL p20", "uncorrected", "p20"),
        ("schedule", "rSub p20;", "rSub tcp20{tcK()};", "corrected", "p20"),
        ("live", "MoveL tcLive(p20,tGun)", "MoveL p20", "uncorrected", "p20"),
    ] {
        let text = compensated(&bench, &source, form);
        let changed = once(&text, was, by);
        let (message, back) = restored(&bench, &changed, 1);
        let told = format!("warning[restore::{code}]");
        let what = format!("the correction of {target} was");
        assert!(message.contains(&told) && message.contains(&what), "{form} {by}: {message}");
        assert!(message.contains(&line_of(&text, was).to_string()), "{form} {by}: {message}");
        assert_eq!(back, source, "{form}");
        assert_eq!(compared(&bench, &source, &changed).0, Some(1), "{form} {by}");
    }
    // A motion that is gone took its correction with it, and one that was put in has none.
    let text = compensated(&bench, &source, "ramp");
    let motion = "MoveL tcAt(p20,tcP20),v100,fine,tGun;\n";
    let put_in = text.replace("rSub p20;\n", "rSub p20;\nMoveL p20,v100,fine,tGun;\n");
    for changed in [once(&text, motion, ""), once(&text, motion, &motion.repeat(2)), put_in] {
        let (message, _) = restored(&bench, &changed, 0);
        assert!(!message.contains("warning"), "{message}");
    }
}

/// A routine's own target hides the module's of that name.
#[test]
fn a_motion_copied_to_where_its_name_is_another_target_is_told() {
    let bench = Bench::default();
    let source = module("CONST robtarget p20:=[[430,60,300],@;", "MoveL p20,v100,fine,tGun;").replace(
        "ENDMODULE",
        &format!(
            "PROC rB()\nCONST robtarget p20:=[[300,-200,420],{REST};\n{HOME}\nMoveL p20,v200,fine,tGun;\nENDPROC\nENDMODULE"
        ),
    );
    let text = compensated(&bench, &source.replace("\nENDPROC\nPROC", "\nrB;\nENDPROC\nPROC"), "ramp");
    let own = text.lines().find(|line| line.contains(",v200")).unwrap();
    let changed = once(&text, "rB;\n", &format!("rB;\n{own}\n"));
    let (message, _) = restored(&bench, &changed, 1);
    assert!(message.contains("restore::arguments"), "{message}");
    let told = format!(":{}: the motion asks with another correction", line_of(&text, "rB;\n") + 1);
    assert!(message.contains(&told), "{message}");
}
