//! What is written and what is not: full disks, interruption, results that somebody has changed.

use super::{Bench, CUBE, driftpost, err, out};
#[cfg(target_os = "linux")]
use crate::stepped::Stepped;
use std::process::{Command, Stdio};
use std::time::Duration;

/// A program of tens of thousands of moves is large enough to be interrupted in the middle.
fn large(moves: usize) -> String {
    let target = |i: usize| {
        format!(
            "[[{},{},{}],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]",
            350 + i % 100,
            1 + i % 77,
            300 + i % 53
        )
    };
    let lines: String = (0..moves).map(|i| format!("    MoveL {},v100,fine,tool0;\n", target(i))).collect();
    format!("MODULE Large\n  PROC main()\n{lines}  ENDPROC\nENDMODULE\n")
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told_with_what_was_written() {
    let bench = Bench::default();
    let made = bench.path("o.mod").display().to_string();
    let json = driftpost(&["compensate", CUBE, "-o", &made, "--json", "/dev/full"]);
    assert_eq!(json.status.code(), Some(2));
    assert!(
        err(&json).contains("/dev/full cannot be written") && err(&json).contains("nothing was written"),
        "{}",
        err(&json)
    );
    assert!(bench.files().is_empty() && out(&json).is_empty(), "{:?}", bench.files());
    // A device that gives bytes without end is no earlier result, and is not asked for any.
    let program = driftpost(&["compensate", CUBE, "-o", "/dev/full", "--diff", "none"]);
    assert!(err(&program).contains("output::unwritable"), "{}", err(&program));
    let full = || Stdio::from(std::fs::File::create("/dev/full").unwrap());
    let run = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_driftpost"));
        command.current_dir(env!("CARGO_MANIFEST_DIR")).args(arguments).stdout(full()).output().unwrap()
    };
    let shown = run(&["compensate", CUBE, "-o", &made]);
    assert_eq!(shown.status.code(), Some(2));
    let message = err(&shown);
    assert!(
        message.contains("standard output cannot be written") && message.contains(&format!("wrote {made}")),
        "{message}"
    );
    assert!(!message.contains("nothing was written") && bench.files() == ["o.mod"], "{message}");
    let program = run(&["compensate", CUBE, "-o", "-"]);
    assert_eq!(program.status.code(), Some(2));
    assert!(err(&program).contains("the program was not written whole"), "{}", err(&program));
    let restored = run(&["restore", &made, "-o", "-"]);
    assert_eq!(restored.status.code(), Some(2));
    let message = err(&restored);
    assert!(message.contains("standard output cannot be written") && !message.contains("wrote"), "{message}");
    for arguments in [&["inspect", CUBE][..], &["simulate", CUBE], &["diff", CUBE, CUBE], &["--help"]] {
        let output = run(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?} {}", err(&output));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn an_interrupted_run_leaves_nothing_and_a_killed_one_what_the_next_takes_away() {
    let bench = Bench::default();
    let source = bench.file("in/Large.mod", large(30_000));
    let result = bench.path("out/deep/Large.mod").display().to_string();
    let page = bench.path("Large.html").display().to_string();
    let start = || {
        // The page waits from the beginning to the end; the program only while it is written.
        let arguments = ["compensate", &source, "-o", &result, "--diff", "none", "--report", &page];
        let mut run = Stepped::start(&bench.path(""), &arguments);
        assert!(run.run_until(|| bench.files() != ["in/Large.mod"]), "something waits beside its place");
        run
    };
    for signal in ["-INT", "-TERM"] {
        assert_eq!(start().interrupt(signal).status.code(), Some(130), "{signal}");
        assert_eq!(bench.files(), ["in/Large.mod"], "{signal}");
        assert!(!bench.path("out/deep").exists(), "{signal}");
    }
    start().kill();
    let left = bench.files();
    let is_known = |file: &String| file == "in/Large.mod" || file.starts_with(".driftpost-");
    assert!(left.len() > 1 && left.iter().all(is_known), "{left:?}");
    let small = driftpost(&["compensate", CUBE, "-o", &result, "--diff", "none"]);
    assert_eq!(small.status.code(), Some(0), "{}", err(&small));
    assert_eq!(bench.files(), ["in/Large.mod", "out/deep/Large.mod"]);
}

/// Nobody reads the pipe: the run waits for that with its results beside their places, and an interruption ends it.
#[cfg(target_os = "linux")]
#[test]
fn a_run_that_waits_for_the_reader_of_a_pipe_can_be_interrupted() {
    let bench = Bench::default();
    let (pipe, result) = (bench.path("pipe"), bench.path("Cube.mod").display().to_string());
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let mut child = Command::new(env!("CARGO_BIN_EXE_driftpost"))
        .args(["compensate", CUBE, "-o", &result, "--diff", "none", "--json", &pipe.display().to_string()])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let begun = std::time::Instant::now();
    while bench.files() == ["pipe"] && begun.elapsed().as_secs() < 60 {
        assert!(child.try_wait().unwrap().is_none(), "it ended before it came to the pipe");
    }
    // What is left to do before the pipe takes some milliseconds.
    std::thread::sleep(Duration::from_millis(500));
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let asked = std::time::Instant::now();
    let ended = loop {
        if let Some(ended) = child.try_wait().unwrap() {
            break Some(ended);
        }
        if asked.elapsed().as_secs() >= 10 {
            child.kill().unwrap();
            child.wait().unwrap();
            break None;
        }
        std::thread::sleep(Duration::from_millis(5));
    };
    assert_eq!(ended.and_then(|ended| ended.code()), Some(130));
    assert_eq!(bench.files(), ["pipe"]);
}

#[test]
fn a_result_that_was_changed_is_overwritten_only_by_force() {
    let bench = Bench::default();
    let made = bench.path("o.mod").display().to_string();
    let run =
        |more: &[&str]| driftpost(&[&["compensate", CUBE, "-o", &made, "--diff", "none"][..], more].concat());
    assert_eq!(run(&[]).status.code(), Some(0));
    let text = bench.text("o.mod");
    // As it was written it may be written again, with other options too.
    assert_eq!(run(&["--form", "ramp"]).status.code(), Some(0));
    assert_eq!(run(&[]).status.code(), Some(0));
    assert!(bench.text("o.mod") == text);
    for (what, from, by) in [
        ("touched up", "[[400.000,", "[[400.5,"),
        ("saved back by a controller", "tcMinute:=0;", "tcMinute:=61.5;"),
        ("laid out anew", "\n", "\r\n"),
        ("edited elsewhere", "rdkSpeed,z1", "rdkSpeed,z5"),
    ] {
        let changed = text.replacen(from, by, if from == "\n" { usize::MAX } else { 1 });
        assert!(changed != text, "{what}");
        bench.file("o.mod", &changed);
        let output = run(&[]);
        assert_eq!(output.status.code(), Some(2), "{what}");
        assert!(
            err(&output).contains("error[output::changed]") && err(&output).contains("--force"),
            "{}",
            err(&output)
        );
        assert!(bench.text("o.mod") == changed, "{what}");
    }
    assert_eq!(run(&["--force"]).status.code(), Some(0));
    assert!(bench.text("o.mod") == text);
    // The common module as much as the others.
    let parts = bench.path("parts").display().to_string();
    let run = |more: &[&str]| {
        driftpost(&[&["compensate", "fixtures/parts", "-o", &parts, "--diff", "none"][..], more].concat())
    };
    assert_eq!(run(&[]).status.code(), Some(0), "{}", err(&run(&[])));
    let core = bench.text("parts/tcCore.mod");
    bench.file("parts/tcCore.mod", core.replacen("tcMode:=-1", "tcMode:=-2", 1));
    assert!(
        run(&[]).status.code() == Some(2) && err(&run(&[])).contains("tcCore.mod was changed"),
        "{}",
        err(&run(&[]))
    );
    assert_eq!(run(&["--force"]).status.code(), Some(0));
    assert!(bench.text("parts/tcCore.mod") == core);
}

#[test]
fn global_names_are_spoken_of_only_where_they_meet_others() {
    let bench = Bench::default();
    let run = |name: &str| {
        driftpost(&["compensate", CUBE, "-o", &bench.path(name).display().to_string(), "--diff", "none"])
    };
    assert!(!err(&run("a.mod")).contains("global names"));
    assert!(!err(&run("a.mod")).contains("global names"), "its own result is no other clock");
    let second = run("b.mod");
    assert!(err(&second).contains("global names") && err(&second).contains("a.mod"), "{}", err(&second));
}

/// What is copied into the result as it was is no less somebody's work when it was changed there.
#[test]
fn a_copy_that_was_changed_is_overwritten_only_by_force() {
    let bench = Bench::default();
    bench.file("cell/Cube45.mod", std::fs::read(CUBE).unwrap());
    bench.file("cell/Idle.sys", "MODULE Idle\n  VAR num n;\nENDMODULE\n");
    bench.file("cell/notes.txt", "first");
    let [cell, to] = ["cell", "out"].map(|name| bench.path(name).display().to_string());
    let run =
        |more: &[&str]| driftpost(&[&["compensate", &cell, "-o", &to, "--diff", "none"], more].concat());
    assert_eq!(run(&[]).status.code(), Some(0), "{}", err(&run(&[])));
    let record = bench.text("out/.driftpost");
    let places: Vec<&str> = record.lines().filter_map(|line| Some(line.split_once("  ")?.1)).collect();
    assert_eq!(places, ["Idle.sys", "notes.txt"]);
    // The source changed since: its copy is as it was made, and follows.
    bench.file("cell/Idle.sys", "MODULE Idle\n  VAR num other;\nENDMODULE\n");
    bench.file("cell/notes.txt", "second");
    assert_eq!(run(&[]).status.code(), Some(0), "{}", err(&run(&[])));
    assert!(bench.text("out/Idle.sys").contains("other") && bench.text("out/notes.txt") == "second");
    for name in ["Idle.sys", "notes.txt"] {
        let path = format!("out/{name}");
        let written = bench.text(&path);
        bench.file(&path, format!("{written}! by hand\n"));
        let output = run(&[]);
        assert_eq!(output.status.code(), Some(2), "{name}");
        assert!(
            err(&output).contains("error[output::changed]") && err(&output).contains(name),
            "{}",
            err(&output)
        );
        assert!(bench.text(&path).ends_with("by hand\n"), "{name}");
        assert_eq!(run(&["--force"]).status.code(), Some(0), "{}", err(&run(&["--force"])));
        assert_eq!(bench.text(&path), written);
    }
    // A folder that holds somebody else's file of the same name is no result.
    bench.file("foreign/Idle.sys", "MODULE Idle\n  VAR num theirs;\nENDMODULE\n");
    let foreign = bench.path("foreign").display().to_string();
    let output = driftpost(&["compensate", &cell, "-o", &foreign, "--diff", "none"]);
    assert_eq!(output.status.code(), Some(2), "{}", err(&output));
    assert!(err(&output).contains("output::changed"), "{}", err(&output));
    assert!(bench.text("foreign/Idle.sys").contains("theirs"));
}

/// Somebody else's program is as worthy as an input: the place of a single result is no licence to overwrite it.
#[test]
fn a_program_of_somebody_else_is_not_overwritten() {
    let bench = Bench::default();
    let place = bench.path("Cube45_tc.mod");
    let name = place.display().to_string();
    let run =
        |more: &[&str]| driftpost(&[&["compensate", CUBE, "-o", &name, "--diff", "none"], more].concat());
    std::fs::write(&place, "MODULE Mine\n  PROC main()\n  ENDPROC\nENDMODULE\n").unwrap();
    let refused = run(&[]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(err(&refused).contains("output::changed") && err(&refused).contains("no result of this one"));
    assert!(std::fs::read_to_string(&place).unwrap().starts_with("MODULE Mine"));
    assert_eq!(run(&["--force"]).status.code(), Some(0));
    // What is no program, the original once more and a result of ours make room.
    for there in [String::new(), "notes".to_owned(), std::fs::read_to_string(CUBE).unwrap()] {
        std::fs::write(&place, there).unwrap();
        assert_eq!((run(&[]).status.code(), run(&[]).status.code()), (Some(0), Some(0)));
    }
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    /// Each element of an array has a correction, whether it is asked for or not.
    #[test]
    #[ignore = "long"]
    fn corrections_of_a_large_array_are_told_of() {
        let rest = "[0.0871557,0,0.9961947,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let run = |count: usize, form: &str| {
            let bench = Bench::default();
            let row =
                |i: usize| format!("[[{}.{:03},{},300],{rest}", 430 + i % 17, i / 17 % 1000, 60 + i % 19);
            let rows: Vec<String> = (0..count).map(row).collect();
            let text = format!(
                "MODULE Rows\n  CONST robtarget pa{{{count}}}:=[{}];\n  VAR num n;\n  PROC main()
    MoveAbsJ [[5,10,20,5,50,5],[9E9,9E9,9E9,9E9,9E9,9E9]],v500,fine,tool0;\n    n:=n+1;\n    MoveJ Offs(pa{{n}},0,0,10),v100,fine,tool0;
  ENDPROC\nENDMODULE\n",
                rows.join(",\n")
            );
            let (from, to) = (bench.file("rows.mod", text), bench.path("o.mod").display().to_string());
            let output = driftpost(&["compensate", &from, "-o", &to, "--form", form, "--diff", "none"]);
            assert!(output.status.success(), "{}", err(&output));
            err(&output)
        };
        let message = run(70_000, "ramp");
        assert!(message.contains(" MB of corrections, one for each of 70001 targets"), "{message}");
        assert!(!run(1_000, "ramp").contains(" MB of "));
        assert!(run(5_000, "schedule").contains(" MB of arrays: "));
    }

    #[test]
    #[ignore = "long"]
    fn a_sheet_that_has_been_filled_in_is_overwritten_only_by_force() {
        let bench = Bench::default();
        let sheet = bench.path("sheet.csv").display().to_string();
        let plan =
            |more: &[&str]| driftpost(&[&["plan", "--n", "20", "--template-out", &sheet], more].concat());
        assert_eq!(plan(&[]).status.code(), Some(0));
        let blank = bench.text("sheet.csv");
        assert_eq!(plan(&["--seed", "5"]).status.code(), Some(0), "a blank sheet is one of many");
        assert_eq!(plan(&[]).status.code(), Some(0));

        // One row is measured, with the separators of the program or of a spreadsheet that has saved the sheet.
        let measured = blank.replacen(",,,\n", ",612.25,-3.5,418.75\n", 1);
        let touches =
            "fixed_id,t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\nA,1,0,0,0,0,30,0\n".to_owned();
        let renamed = measured.replacen("x_mm,y_mm,z_mm", "X [mm],Y [mm],Z [mm]", 1);
        for filled in [measured.clone(), measured.replace(',', ";"), renamed, touches] {
            bench.file("sheet.csv", &filled);
            let refused = plan(&[]);
            assert_eq!(refused.status.code(), Some(2), "{}", err(&refused));
            assert!(err(&refused).contains("error[output::changed]"), "{}", err(&refused));
            assert_eq!(bench.text("sheet.csv"), filled);
        }
        assert_eq!(plan(&["--force"]).status.code(), Some(0));
        assert_eq!(bench.text("sheet.csv"), blank);
    }

    /// A robot whose length was corrected by hand, a model, a module that measures: written anew as often as asked, and not over a change.
    #[test]
    #[ignore = "long"]
    fn what_was_corrected_by_hand_is_overwritten_only_by_force() {
        let bench = Bench::default();
        let touches = format!("{}/fixtures/first_day/touches.csv", env!("CARGO_MANIFEST_DIR"));
        let [robot, model, module] =
            ["robot.toml", "model.toml", "Measure.mod"].map(|name| bench.path(name).display().to_string());
        for (name, args) in [
            ("robot.toml", vec!["robot", "--robot", "irb4600", "-o", &robot]),
            ("model.toml", vec!["fit", &touches, "--tool", "0,0,100", "--model-out", &model]),
            ("Measure.mod", vec!["plan", "--n", "20", "--rapid-out", &module]),
        ] {
            let run = |more: &[&str]| driftpost(&[&args[..], more].concat());
            for _ in 0..2 {
                let made = run(&[]);
                assert_eq!(made.status.code(), Some(0), "{}", err(&made));
            }
            let written = bench.text(name);
            let corrected = written.replacen("0", "1", 1);
            bench.file(name, &corrected);
            let refused = run(&[]);
            assert_eq!(refused.status.code(), Some(2), "{name}: {}", err(&refused));
            assert!(err(&refused).contains("error[output::changed]"), "{}", err(&refused));
            assert_eq!(bench.text(name), corrected);
            assert_eq!(run(&["--force"]).status.code(), Some(0));
            assert_eq!(bench.text(name), written);
        }
        bench.file("Measure.mod", "MODULE Mine\n  PROC main()\n  ENDPROC\nENDMODULE\n");
        let refused = driftpost(&["plan", "--n", "20", "--rapid-out", &module]);
        assert!(err(&refused).contains("no module that measures"), "{}", err(&refused));
    }
}

/// The common clock of an earlier run, left beside a module with a clock of its own: a controller loads one of them.
#[test]
fn a_common_clock_that_an_earlier_run_left_is_named() {
    let bench = Bench::default();
    bench.file("cell/Cube45.mod", std::fs::read(CUBE).unwrap());
    let [cell, to] = ["cell", "out"].map(|name| bench.path(name).display().to_string());
    let run =
        |more: &[&str]| driftpost(&[&["compensate", &cell, "-o", &to, "--diff", "none"], more].concat());
    let separate = run(&["--core", "separate"]);
    assert!(separate.status.success() && !err(&separate).contains("an earlier run"), "{}", err(&separate));
    let embedded = run(&[]);
    assert!(embedded.status.success() && err(&embedded).contains("tcCore.mod"), "{}", err(&embedded));
    assert!(err(&embedded).contains("which an earlier run has left"), "{}", err(&embedded));
    assert!(err(&embedded).contains("remove it"), "{}", err(&embedded));
    std::fs::remove_file(bench.path("out/tcCore.mod")).unwrap();
    assert!(!err(&run(&[])).contains("an earlier run"));
}
