//! A misspelt word is answered with the right one.

use super::{Bench, CUBE, driftpost, err};

/// Every long option, with one letter dropped, is answered with itself.
#[test]
fn a_misspelt_option_is_answered_with_the_right_one() {
    let help = driftpost(&["compensate", "--help"]);
    let help = String::from_utf8_lossy(&help.stdout).into_owned();
    let options: Vec<&str> = help
        .lines()
        .filter(|line| line.trim_start().starts_with('-'))
        .filter_map(|line| line.split_whitespace().find(|w| w.starts_with("--")))
        .filter(|w| w.len() > 7)
        .collect();
    assert!(options.len() > 15, "{options:?}");
    for option in options {
        let at = option.len() - 3;
        let wrong = format!("{}{}", &option[..at], &option[at + 1..]);
        let output = driftpost(&["compensate", CUBE, &wrong]);
        assert_eq!(output.status.code(), Some(2), "{wrong}");
        assert!(err(&output).contains(&format!("'{option}'")), "{wrong}: {}", err(&output));
    }
}

#[test]
fn a_misspelt_command_or_value_is_answered_with_the_right_one() {
    let output = driftpost(&["compensat", CUBE]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("'compensate'"), "{}", err(&output));
    let output = driftpost(&["help", "compensat"]);
    assert!(output.status.code() == Some(2) && err(&output).contains("'compensate'"), "{}", err(&output));
    let output = driftpost(&["compensate", CUBE, "--clock", "elapse"]);
    assert!(output.status.code() == Some(2) && err(&output).contains("elapsed, "), "{}", err(&output));
}

#[test]
fn a_misspelt_name_of_the_program_is_answered_with_the_right_one() {
    let bench = Bench::default();
    let cell = concat!(env!("CARGO_MANIFEST_DIR"), "/fixtures/simulate/cell.mod");
    let corrected = bench.path("cell_tc.mod").display().to_string();
    assert!(driftpost(&["compensate", cell, "-o", &corrected]).status.success());
    let refused = |options: &[&str]| {
        let output = driftpost(&[&["simulate", corrected.as_str()], options].concat());
        assert_eq!(output.status.code(), Some(2), "{options:?}");
        err(&output)
    };
    for (options, hint) in [
        (["--entry", "mian"], "did you mean main?"),
        (["--entry", "tcColdStrat"], "did you mean tcColdStart?"),
        (["--set", "tcMod=-2"], "did you mean tcMode?"),
        (["--thermometer", "tcMinut"], "did you mean tcMinute?"),
        (["--task", "TASK3"], "leave it out"),
    ] {
        assert!(refused(&options).contains(hint), "{options:?}: {}", refused(&options));
    }
    for (steps, hint) in [
        ("steps = [\"call tcColdStrat\"]", "did you mean tcColdStart?"),
        ("steps = [\"rnu 10\"]", "did you mean run?"),
        ("steps = [\"ppto_main\"]", "did you mean pp_to_main?"),
        ("steps = [\"tcColdStart\"]", "called by `call tcColdStart`"),
        ("steps = [\"signal tcMod 1\", \"run 5\"]", "did you mean tcMode?"),
        ("steps = [\"set tcMod 1\", \"run 5\"]", "did you mean tcMode?"),
        ("taucool = 3\nsteps = [\"run 5\"]", "did you mean tau_cool_min?"),
    ] {
        let scenario = bench.file("lunch.toml", steps);
        let message = refused(&["--scenario", &scenario]);
        assert!(message.contains(hint), "{steps}: {message}");
    }
    let message = refused(&["--scenario", &bench.path("lunhc.toml").display().to_string()]);
    assert!(message.contains("lunch.toml?"), "{message}");
    let output = driftpost(&["compensate", cell, "--home", "jHmoe", "-o", "-"]);
    assert!(err(&output).contains("jointtarget of the program (jHome)"), "{}", err(&output));
    let output = driftpost(&["help", "link", "chek"]);
    assert!(!cfg!(feature = "link") || err(&output).contains("'check'"), "{}", err(&output));
}

/// A routine that is nowhere near is answered with those that there are.
#[test]
fn an_entry_that_is_not_there_is_answered_with_those_that_are() {
    let cell = concat!(env!("CARGO_MANIFEST_DIR"), "/fixtures/simulate/cell.mod");
    let output = driftpost(&["simulate", cell, "--entry", "xyz"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("the routines are main, "), "{}", err(&output));
}

/// A form that is no more is refused, not ignored.
#[test]
fn a_form_that_does_not_exist_is_refused() {
    let output = driftpost(&["compensate", CUBE, "--form", "modules"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("'modules'"), "{}", err(&output));
}

/// What is wrong is named as it was given, and its remedy is one that there is.
#[test]
fn a_remedy_speaks_of_what_was_given() {
    let bench = Bench::default();
    let made = bench.path("Cube45_tc.mod").display().to_string();
    assert_eq!(driftpost(&["compensate", CUBE, "-o", &made, "--form", "ramp"]).status.code(), Some(0));
    let refused = |arguments: &[&str]| {
        let output = driftpost(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        err(&output)
    };
    let text = refused(&["simulate", &made, "--set", "tcMode=abc"]);
    assert!(text.contains("--set") && !text.contains("scenario"), "{text}");
    let empty = bench.file("empty.toml", "");
    let text = refused(&["simulate", &made, "--scenario", &empty]);
    assert!(text.contains("steps = [") && !text.contains("routine"), "{text}");
    let text = refused(&["golden", CUBE]);
    assert!(text.contains("is a file, not a folder") && !text.contains("permissions"), "{text}");
    let text = refused(&["compensate", CUBE, "-o", &made, "--tolerance-mm", "0"]);
    assert!(text.contains("at least 1e-6 mm"), "{text}");
}

#[test]
fn a_tool_for_a_name_that_the_program_has_not_is_told() {
    let bench = Bench::default();
    let source = bench.file(
        "m.mod",
        "MODULE m\n  CONST robtarget p1:=[[450,-100,300],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n  PROC main()\n    \
         MoveL p1,v100,fine,tGrip;\n  ENDPROC\nENDMODULE\n",
    );
    let to = bench.path("o.mod").display().to_string();
    let run = |names: &[&str]| {
        let value = |name: &&str| format!("{name}=[TRUE,[[0,0,90],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]]");
        let tools: Vec<String> = names.iter().map(value).collect();
        let tools = tools.iter().flat_map(|tool| ["--tool", tool.as_str()]);
        let arguments: Vec<&str> =
            ["compensate", &source, "-o", &to, "--diff", "none"].into_iter().chain(tools).collect();
        err(&driftpost(&arguments))
    };
    let wrong = run(&["tGrpi"]);
    assert!(wrong.contains("override::unused") && wrong.contains("tGrip"), "{wrong}");
    assert!(run(&["tGrip", "tGrpi"]).contains("override::unused"));
    assert!(!run(&["TGRIP"]).contains("override::unused"));
}
