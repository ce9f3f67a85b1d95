//! What `restore` says of a module in which motions were taken out or put in by hand.

use super::{Bench, driftpost, err};

const CONF: &str = "[0.70710678,0,0.70710678,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";

/// A module of three named targets and an inline one, compensated in the form ramp.
fn emitted(bench: &Bench) -> String {
    let source = format!(
        "MODULE A\n  CONST robtarget p10:=[[400,0,350],{CONF};\n  CONST robtarget p20:=[[420,30,350],{CONF};
  CONST robtarget p30:=[[440,60,350],{CONF};\n  PROC main()
    MoveAbsJ [[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v500,fine,tool0;\n    MoveL p10,v100,fine,tool0;
    MoveL p20,v100,fine,tool0;\n    MoveL [[430,40,350],{CONF},v100,fine,tool0;\n    MoveL p30,v100,fine,tool0;
  ENDPROC\nENDMODULE\n"
    );
    let (from, to) = (bench.file("a.mod", source), bench.path("o.mod").display().to_string());
    let made = driftpost(&["compensate", &from, "-o", &to, "--form", "ramp", "--diff", "none"]);
    assert_eq!(made.status.code(), Some(0), "{}", err(&made));
    bench.text("o.mod")
}

/// What is said of a changed module, and the original that is got back; it ends with `code`.
fn restored(bench: &Bench, changed: &str, code: i32) -> (String, String) {
    let (from, to) = (bench.file("changed.mod", changed), bench.path("back.mod").display().to_string());
    let output = driftpost(&["restore", &from, "-o", &to, "--force"]);
    assert_eq!(output.status.code(), Some(code), "{}", err(&output));
    (err(&output), bench.text("back.mod"))
}

/// The text without its motion that holds `what`.
fn without(text: &str, what: &str) -> String {
    let is_it = |line: &&str| line.trim_start().starts_with("Move") && line.contains(what);
    assert_eq!(text.lines().filter(is_it).count(), 1);
    text.lines().filter(|line| !is_it(line)).map(|line| format!("{line}\n")).collect()
}

#[test]
fn motions_that_were_taken_out_or_replaced_leave_the_others_as_they_were() {
    let bench = Bench::default();
    let text = emitted(&bench);
    let replaced = |from: &str, by: &str| {
        assert!(text.contains(from));
        text.replacen(from, by, 1)
    };
    for (changed, motions) in [
        (without(&text, "(p20,"), 4),
        (without(&text, "(p10,"), 4),
        (without(&text, "[[430,"), 4),
        (without(&text, "(p30,"), 4),
        (without(&text, "tcAtJ("), 4),
        (without(&without(&text, "(p10,"), "[[430,"), 3),
        (replaced("tcAt(p20,tcP20)", "tcAt(p30,tcP30)"), 5),
        (replaced("tcAt(p20,tcP20)", "p30"), 5),
        (
            replaced(
                "    MoveL tcAt(p20,",
                "    MoveL tcAt(p30,tcP30),v100,fine,tool0;\n    MoveL tcAt(p20,",
            ),
            6,
        ),
    ] {
        let (message, back) = restored(&bench, &changed, 0);
        assert!(!message.contains("touched up") && !message.contains("warning"), "{message}\n{changed}");
        assert_eq!(back.matches("    Move").count(), motions, "{back}");
    }
}

#[test]
fn a_point_that_was_touched_up_beside_a_motion_taken_out_is_told() {
    let bench = Bench::default();
    let text = emitted(&bench);
    // p30 by 3 and 4 mm; between it and what was taken out stands a motion as it was.
    let touched = text.replacen("p30:=[[440,60,", "p30:=[[443,64,", 1);
    let (message, back) = restored(&bench, &without(&touched, "(p20,"), 1);
    assert!(message.contains("p30 was touched up on the controller by 5.0000 mm"), "{message}");
    assert!(!message.contains("[[430") && back.contains("p30:=[[443,64,"), "{message}");
    // Of what stands right beside a motion that is gone nobody knows what it was.
    let (message, back) = restored(&bench, &without(&touched, "[[430,"), 1);
    assert!(
        message.contains("warning[restore::original]") && message.contains("p30 is none of"),
        "{message}"
    );
    assert!(!message.contains("was touched up") && back.contains("p30:=[[443,64,"), "{message}");
    // A motion put in by hand, that asks with a point of its own.
    let own = text.replacen(
        "(p20,",
        &format!("([[425,35,350],{CONF},tcP20),v100,fine,tool0;\n    MoveL tcAt(p20,"),
        1,
    );
    let (message, _) = restored(&bench, &own, 1);
    assert!(
        message.contains("warning[restore::original]") && !message.contains("was touched up"),
        "{message}"
    );
}

/// An element of the array that a motion asks with, and what stands in an expression of a target.
#[test]
fn elements_and_parts_of_expressions_that_were_touched_up_are_told() {
    let bench = Bench::default();
    let source = format!(
        "MODULE A\n  PERS num n:=1;\n  CONST robtarget p10:=[[400,0,350],{CONF};
  CONST robtarget pa{{3}}:=[[[420,30,350],{CONF},[[420,40,350],{CONF},[[420,50,350],{CONF}];
  CONST robtarget pg{{2,2}}:=[[[[410,30,340],{CONF},[[410,40,340],{CONF}],[[[410,50,340],{CONF},[[410,60,340],{CONF}]];
  PROC main()\n    MoveAbsJ [[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v500,fine,tool0;
    MoveL pa{{n}},v100,fine,tool0;\n    MoveL pg{{n,1}},v100,fine,tool0;\n    MoveL Offs(p10,0,0,5),v100,fine,tool0;
  ENDPROC\nENDMODULE\n"
    );
    let (from, to) = (bench.file("a.mod", &source), bench.path("o.mod").display().to_string());
    for form in ["ramp", "live", "auto"] {
        let made = driftpost(&["compensate", &from, "-o", &to, "--form", form, "--diff", "none", "--force"]);
        assert_eq!(made.status.code(), Some(0), "{form}: {}", err(&made));
        let text = bench.text("o.mod");
        let (message, back) = restored(&bench, &text, 0);
        assert!(back == source && !message.contains("touched up"), "{form}: {message}");
        // By 3 and 4 mm.
        for (was, now, name) in [
            ("[[420,40,350]", "[[423,44,350]", "pa{2}"),
            ("[[410,50,340]", "[[413,54,340]", "pg{2,1}"),
            ("[[400,0,350]", "[[403,4,350]", "p10"),
        ] {
            assert_eq!(text.matches(was).count(), 1, "{form}: {was}");
            let (message, back) = restored(&bench, &text.replacen(was, now, 1), 1);
            let told = format!("{name} was touched up on the controller by 5.0000 mm");
            assert!(message.contains(&told), "{form}: {message}");
            assert_eq!(back, source.replacen(was, now, 1), "{form}");
        }
        // With the motion that goes by it taken out, the others are known again.
        let (message, _) = restored(&bench, &without(&text, "pg{n,1}"), 0);
        assert!(!message.contains("touched up") && !message.contains("warning"), "{form}: {message}");
    }
}

/// A module from before elements of arrays and what stands in `Offs` had fingerprints: 27 characters of six joints, 15 of `p20`.
#[test]
fn a_module_whose_fingerprints_are_of_named_points_alone_is_known_again() {
    let bench = Bench::default();
    let older = include_str!("../../../fixtures/emit/expected/Older.mod");
    let source = include_str!("../../../fixtures/emit/Older.mod");
    let points = older.lines().find_map(|line| line.trim().strip_prefix("! driftpost points: ")).unwrap();
    assert_eq!(points.len(), 27 + 15);
    let (message, back) = restored(&bench, older, 0);
    assert!(back == source && !message.contains("warning"), "{message}");
    // By 3 and 4 mm.
    let touched = older.replacen("p20:=[[420,30,", "p20:=[[423,34,", 1);
    let (message, _) = restored(&bench, &touched, 1);
    assert!(message.contains("p20 was touched up on the controller by 5.0000 mm"), "{message}");
}

/// What was added and is named by hand would not be there any more: a controller would not load the module.
#[test]
fn an_added_correction_that_is_named_elsewhere_is_no_part_of_the_original() {
    let bench = Bench::default();
    let text = emitted(&bench);
    let named = text.replacen(
        "    MoveL tcAt(p20,",
        "    Set do1;\n    MoveL Offs(p20,tcP20.trans.x,0,0),v100,fine,tool0;\n    MoveL tcAt(p20,",
        1,
    );
    let output = driftpost(&[
        "restore",
        &bench.file("named.mod", &named),
        "-o",
        &bench.path("none.mod").display().to_string(),
    ]);
    let message = err(&output);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(
        message.contains("restore::damaged") && message.contains("tcP20 is still named there"),
        "{message}"
    );
    assert!(!bench.path("none.mod").exists());
    // In a comment it does no harm.
    let commented = text.replacen("    MoveL tcAt(p20,", "    ! see tcP20\n    MoveL tcAt(p20,", 1);
    let (message, _) = restored(&bench, &commented, 0);
    assert!(!message.contains("tcP20"), "{message}");
}

/// The same module in the form schedule, where the arrays hold the targets.
fn scheduled(bench: &Bench) -> String {
    emitted(bench);
    let (from, to) = (bench.path("a.mod").display().to_string(), bench.path("s.mod").display().to_string());
    let made = driftpost(&["compensate", &from, "-o", &to, "--diff", "none"]);
    assert_eq!(made.status.code(), Some(0), "{}", err(&made));
    bench.text("s.mod")
}

/// The text with x of an element of the array that begins in the line with `array` moved by 0.5 mm.
fn with_touched_element(text: &str, array: &str) -> String {
    let begins = text.find(array).unwrap();
    let element = text[begins..].match_indices("[[").nth(3).unwrap().0 + begins + 2;
    let end = text[element..].find(',').unwrap() + element;
    let x: f64 = text[element..end].parse().unwrap();
    format!("{}{}{}", &text[..element], x + 0.5, &text[end..])
}

#[test]
fn a_touched_up_point_whose_motion_is_gone_is_no_part_of_the_original() {
    let bench = Bench::default();
    let text = scheduled(&bench);
    for (array, motion, target) in [("tcp20{", "tcp20{", "p20"), ("robtarget tc9{", "tc9{", "[[430,40,350]")]
    {
        let touched = with_touched_element(&text, array);
        let (message, _) = restored(&bench, &touched, 1);
        assert!(message.contains("by 0.5000 mm") && !message.contains("restore::gone"), "{message}");
        let (message, back) = restored(&bench, &without(&touched, motion), 1);
        assert!(message.contains("warning[restore::gone]") && message.contains(target), "{message}");
        assert!(!message.contains("is in the motion") && !back.contains("30.5,"), "{message}");
    }
    // In its place a motion to the target itself: the original, byte for byte, and what was touched up is told.
    let plain = with_touched_element(&text, "tcp20{").replacen("MoveL tcp20{tcK()}", "MoveL p20", 1);
    let (message, _) = restored(&bench, &plain, 1);
    assert!(message.contains("warning[restore::gone]") && message.contains("byte for byte"), "{message}");
}

#[test]
fn a_motion_that_was_made_a_comment_counts_as_taken_out() {
    let bench = Bench::default();
    for (text, motion) in [(emitted(&bench), "    MoveL tcAt(p20,"), (scheduled(&bench), "    MoveL tcp20{")]
    {
        let commented = text.replacen(motion, &motion.replace("    ", "    ! "), 1);
        assert_ne!(commented, text);
        let (message, back) = restored(&bench, &commented, 0);
        assert!(!message.contains("touched up") && !message.contains("warning"), "{message}");
        let comments =
            ["    ! MoveL p20,v100,fine,tool0;\n", "    ! "].map(|comment| back.matches(comment).count());
        assert_eq!((back.matches("\n    Move").count(), comments), (4, [1, 1]), "{back}");
    }
    // What is named in a text or a statement is named; the line is that of the module that was given.
    let text = emitted(&bench);
    let named = text.replacen("  ENDPROC", "    TPWrite \"1!\"+ValToStr(tcAt(p20,tcP20));\n  ENDPROC", 1);
    let line = named.lines().position(|line| line.contains("TPWrite \"1!\"")).unwrap() + 1;
    let file = bench.file("named.mod", &named);
    let refused = driftpost(&["restore", &file, "-o", &bench.path("none.mod").display().to_string()]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(err(&refused).contains(&format!("line {line}: tcAt is still named")), "{}", err(&refused));
}

#[test]
fn numbers_that_a_controller_has_written_anew_are_no_touch_up() {
    let bench = Bench::default();
    let anew = |text: &str| {
        text.replace(
            "p20:=[[420,30,350],[0.70710678,0,0.70710678,0]",
            "p20:=[[420.00,30.00,350.0],[0.707107,0,0.707107,0]",
        )
        .replace("[[430,40,350],[0.70710678,0,0.70710678,0]", "[[430.00,40,350],[0.707107,0,0.707107,0]")
        .replace("9E9", "9E+09")
    };
    for text in [emitted(&bench), scheduled(&bench)] {
        let (message, _) = restored(&bench, &anew(&text), 0);
        assert!(!message.contains("touched up") && !message.contains("warning"), "{message}");
    }
    let text = anew(&emitted(&bench));
    let other = text.replacen("[0.707107,0,0.707107,0],[0,0,0,0]", "[0.707107,0,0.707107,0],[0,0,1,0]", 1);
    assert_ne!(other, text);
    let (message, _) = restored(&bench, &other, 1);
    assert!(message.contains("p20 was touched up") && message.contains("configuration"), "{message}");
}

/// The original of a module that was compensated in its own place would go there: the advice is one that can be followed.
#[test]
fn an_original_that_would_take_its_modules_place_is_told_to_go_elsewhere() {
    let bench = Bench::default();
    emitted(&bench);
    let (path, text) = (bench.path("a.mod").display().to_string(), bench.text("o.mod"));
    bench.file("a.mod", &text);
    for force in [&[][..], &["--force"]] {
        let refused = driftpost(&[&["restore", &path], force].concat());
        assert_eq!(refused.status.code(), Some(2), "{}", err(&refused));
        assert!(
            err(&refused).contains("error[output::is-input]")
                && err(&refused).contains("name another place with -o")
        );
    }
    assert_eq!(bench.text("a.mod"), text);
}
