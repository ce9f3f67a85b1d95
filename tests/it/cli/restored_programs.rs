//! Whole programs in which a module or the common one is not what it was: what `restore`, `diff` and others say of them.

use super::changed_by_hand::{HOME, REST, compensated, module, once, restored};
use super::{Bench, driftpost, err, out};

/// A cell of two modules that move, compensated into the folder `tc`; gives the paths of both.
fn cell(bench: &Bench, options: &[&str]) -> [String; 2] {
    let a = module("CONST robtarget p20:=[[430,60,300],@;", "MoveL p20,v100,fine,tGun;\nrB;");
    let b = format!("MODULE B\nPROC rB()\nMoveL [[440,70,310],{REST},v100,fine,tool0;\nENDPROC\nENDMODULE\n");
    bench.file("cell/A.mod", a);
    bench.file("cell/B.mod", b);
    let [from, to] = ["cell", "tc"].map(|name| bench.path(name).display().to_string());
    let _ = std::fs::remove_dir_all(&to);
    let made = driftpost(&[&["compensate", &from, "-o", &to, "--diff", "none"], options].concat());
    assert_eq!(made.status.code(), Some(0), "{}", err(&made));
    [from, to]
}

/// A text without its comments.
fn without_comments(text: &str) -> String {
    text.lines().filter(|line| !line.trim_start().starts_with('!')).map(|line| format!("{line}\n")).collect()
}

#[test]
fn a_module_of_a_folder_that_lost_its_comment_block_is_no_original() {
    for form in ["schedule", "ramp", "live"] {
        let bench = Bench::default();
        let [_, tc] = cell(&bench, &["--form", form]);
        let stripped = without_comments(&bench.text("tc/B.mod"));
        bench.file("tc/B.mod", &stripped);
        let back = bench.path("back").display().to_string();
        let output = driftpost(&["restore", &tc, "-o", &back]);
        assert_eq!(output.status.code(), Some(2), "{form}: {}", err(&output));
        let line = 1 + stripped[..stripped.find("MoveL").unwrap()].matches('\n').count();
        let message = err(&output);
        assert!(message.contains("restore::header-lost"), "{form}: {message}");
        assert!(message.contains(&format!("tc/B.mod:{line}: tc")), "{form}: {message}");
        assert!(!bench.path("back").exists(), "{form}");
        // A module that was none of the program's motions is copied as before, and one that calls the clock by a name that a source may have.
        bench.file("tc/B.mod", "MODULE B\nPROC rB()\ntcColdStart;\nENDPROC\nENDMODULE\n");
        assert_eq!(driftpost(&["restore", &tc, "-o", &back]).status.code(), Some(0), "{form}");
        assert!(bench.text("back/B.mod").contains("tcColdStart"));
    }
}

#[test]
fn a_compensated_module_called_as_results_are_does_not_vanish() {
    let bench = Bench::default();
    let [_, tc] = cell(&bench, &[]);
    std::fs::rename(bench.path("tc/B.mod"), bench.path("tc/B_tc.mod")).unwrap();
    let output = driftpost(&["restore", &tc, "-o", &bench.path("back").display().to_string()]);
    assert_eq!(output.status.code(), Some(2), "{}", err(&output));
    assert!(
        err(&output).contains("restore::not-read") && err(&output).contains("B_tc.mod"),
        "{}",
        err(&output)
    );
    assert!(!bench.path("back").exists());
}

#[test]
fn a_common_module_that_is_gone_or_of_another_run_is_told() {
    for form in ["schedule", "ramp", "live"] {
        let bench = Bench::default();
        let [from, tc] = cell(&bench, &["--form", form, "--growth", "two-stage:20"]);
        let other = bench.text("tc/tcCore.mod");
        cell(&bench, &["--form", form]);
        let own = bench.text("tc/tcCore.mod");
        let back = bench.path("back").display().to_string();
        let run = |code: i32, told: &str| {
            let output = driftpost(&["restore", &tc, "-o", &back]);
            assert_eq!(output.status.code(), Some(code), "{form}: {}", err(&output));
            assert_eq!(err(&output).contains("warning"), code == 1, "{form}: {}", err(&output));
            assert!(err(&output).contains(told), "{form}: {}", err(&output));
            let compared = driftpost(&["diff", &from, &tc]);
            assert_eq!(compared.status.code(), Some(code), "{form}: {}", out(&compared));
        };
        run(0, "");
        bench.file("tc/tcCore.mod", other);
        run(1, "restore::other-core");
        std::fs::remove_file(bench.path("tc/tcCore.mod")).unwrap();
        run(1, "restore::no-core");
        // A module by itself asks a common one that need not be given.
        let [a, b] = ["cell/A.mod", "tc/A.mod"].map(|name| bench.path(name).display().to_string());
        assert_eq!(driftpost(&["diff", &a, &b]).status.code(), Some(0), "{form}");
        assert_eq!(driftpost(&["restore", &b, "-o", &back]).status.code(), Some(0), "{form}");
        // As a controller may have saved it.
        bench.file(
            "tc/tcCore.mod",
            own.replace("\n", "\r\n").replace("PERS num tcMinute:=0", "PERS num tcMinute:=31"),
        );
        run(0, "");
    }
}

#[test]
fn what_helps_a_module_without_comment_block_is_its_original_file() {
    let bench = Bench::default();
    let source = module("CONST robtarget p20:=[[430,60,300],@;", "MoveL p20,v100,fine,tGun;");
    let text = compensated(&bench, &source, "ramp");
    for (text, is_whole) in [(text.clone(), true), (without_comments(&text), false)] {
        let file = bench.file("tc.mod", text);
        let refused = driftpost(&["compensate", &file, "-o", &bench.path("x.mod").display().to_string()]);
        assert_eq!(refused.status.code(), Some(2));
        let inspected = driftpost(&["inspect", &file]);
        for said in [err(&refused), out(&inspected)] {
            assert!(said.contains("already compensated"), "{said}");
            assert_eq!(said.contains("comment block"), !is_whole, "{said}");
            assert_eq!(
                said.contains("cannot get it back") || said.contains("take the original file"),
                !is_whole,
                "{said}"
            );
        }
    }
}

#[test]
fn modules_of_different_runs_are_not_the_same_but_for_their_layout() {
    let bench = Bench::default();
    let source = module("CONST robtarget p20:=[[430,60,300],@;", "MoveL p20,v100,fine,tGun;");
    let from = bench.file("source.mod", source);
    let make = |name: &str, options: &[&str]| {
        let to = bench.path(name).display().to_string();
        let made = driftpost(
            &[&["compensate", &from, "-o", &to, "--form", "ramp", "--diff", "none"], options].concat(),
        );
        assert_eq!(made.status.code(), Some(0), "{}", err(&made));
        to
    };
    let first = make("first.mod", &[]);
    for (options, told) in [
        (["--growth", "two-stage:60"], "growth two-stage:46 and two-stage:60"),
        (["--clock", "elapsed"], "were not made alike"),
        (["--gap-min", "30"], "were not made alike"),
    ] {
        let other = make(&format!("{}.mod", &options[1].replace(':', "")), &options);
        let compared = driftpost(&["diff", &first, &other]);
        assert_eq!(compared.status.code(), Some(1));
        let text = out(&compared);
        assert!(text.contains(told) && text.trim_end().ends_with("see the lines above."), "{text}");
        assert!(!text.contains("The same but for its layout"), "{text}");
    }
    // As a controller may have saved it.
    let saved = bench.file("saved.mod", bench.text("first.mod").replace('\n', "\r\n"));
    let text = out(&driftpost(&["diff", &first, &saved]));
    assert!(text.contains("The same but for its layout"), "{text}");
}

#[test]
fn a_case_that_was_emptied_is_told() {
    let bench = Bench::default();
    bench.file("cases/one/source/a.mod", module("", ""));
    std::fs::create_dir_all(bench.path("cases/two")).unwrap();
    let cases = bench.path("cases").display().to_string();
    let output = driftpost(&["golden", &cases]);
    assert!(
        err(&output).contains("two is no case: it holds no source/ and no expected/"),
        "{}",
        err(&output)
    );
    assert!(!err(&output).contains("one is no case"), "{}", err(&output));
}

/// The new value stands in the declaration, by which other motions go as well.
#[test]
fn what_goes_with_a_touched_up_target_is_named() {
    let bench = Bench::default();
    let data =
        "CONST robtarget p20:=[[430,60,300],@;\nCONST robtarget pa{2}:=[[[450,60,300],@,[[450,70,300],@];";
    let source = module(
        data,
        "MoveL p20,v100,fine,tGun;\nMoveL Offs(p20,0,0,5),v100,fine,tGun;\nrSub p20;\nMoveL pa{nPos},v100,fine,tGun;",
    )
    .replace("ENDMODULE", "PROC rSub(robtarget p)\nENDPROC\nENDMODULE");
    assert!(source.contains(HOME));
    let text = compensated(&bench, &source, "schedule");
    let line = |what: &str| 1 + text[..text.find(what).unwrap()].matches('\n').count();
    // The first element of the array is the original itself.
    let begins = text.find("robtarget tcp20{").unwrap();
    let touched =
        format!("{}{}", &text[..begins], text[begins..].replacen("[[430,60,300]", "[[430,63,304]", 1));
    let (message, back) = restored(&bench, &touched, 1);
    let told = format!(
        "p20 was touched up on the controller by 5.0000 mm; its new value is in the declaration; lines {}, {} name it too, and go with it",
        line("MoveL tcp20{") + 1,
        line("rSub p20;"),
    );
    assert!(message.contains(&told), "{told}\n{message}");
    assert_eq!(back, once(&source, "[[430,60,300]", "[[430,63,304]"));
    // An element of the program's own array.
    let begins = text.find("robtarget tcpa{").unwrap();
    let touched =
        format!("{}{}", &text[..begins], text[begins..].replacen("[[450,70,300]", "[[450,73,304]", 1));
    let (message, _) = restored(&bench, &touched, 1);
    assert!(
        message.contains("pa{2} was touched up on the controller by 5.0000 mm; its new value"),
        "{message}"
    );
}

/// What a programmer has gone on with in the folder that a program is restored to.
#[test]
fn what_was_changed_where_a_program_is_restored_to_stays() {
    let bench = Bench::default();
    let [from, tc] = cell(&bench, &["--form", "ramp"]);
    let restore = |more: &[&str], code: i32| {
        let output = driftpost(&[&["restore", &tc, "-o", &from], more].concat());
        assert_eq!(output.status.code(), Some(code), "{}", err(&output));
        err(&output)
    };
    let original = bench.text("cell/A.mod");
    restore(&[], 0);
    assert_eq!(bench.files().iter().filter(|file| file.starts_with("cell/")).count(), 2);
    // Touched up on the controller, by 3 and 4 mm, and again: the originals follow.
    let emitted = bench.text("tc/A.mod");
    for now in ["[[433,64,300]", "[[430,63,304]"] {
        bench.file("tc/A.mod", once(&emitted, "[[430,60,300]", now));
        assert!(restore(&[], 1).contains("by 5.0000 mm"));
        assert_eq!(bench.text("cell/A.mod"), original.replace("[[430,60,300]", now));
    }
    // Gone on with by hand.
    let own = original.replace("MoveL p20,v100", "MoveL p20,v50");
    bench.file("cell/A.mod", &own);
    let message = restore(&[], 2);
    assert!(
        message.contains("output::changed") && message.contains("cell/A.mod is not as it was"),
        "{message}"
    );
    assert_eq!(bench.text("cell/A.mod"), own);
    restore(&["--force"], 1);
    assert_eq!(bench.text("cell/A.mod"), original.replace("[[430,60,300]", "[[430,63,304]"));
}
