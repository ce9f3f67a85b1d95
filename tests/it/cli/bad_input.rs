//! Input that no program should trip over: devices, pipes, links, streams without end, numbers beyond all measure.

use super::{Bench, CUBE, driftpost, err, out};
use std::process::{Command, Stdio};

/// Runs the program in the checkout with bytes on its standard input.
fn fed(arguments: &[&str], input: &[u8]) -> std::process::Output {
    let mut command = assert_cmd::Command::cargo_bin("driftpost").unwrap();
    command.current_dir(env!("CARGO_MANIFEST_DIR")).args(arguments).write_stdin(input).output().unwrap()
}

#[test]
fn standard_input_is_a_program_and_standard_output_a_place() {
    let bench = Bench::default();
    let source = std::fs::read(CUBE).unwrap();
    let made = bench.path("o.mod").display().to_string();
    for name in ["-", "/dev/stdin"] {
        let output = fed(&["compensate", name, "-o", &made], &source);
        assert_eq!(output.status.code(), Some(0), "{name}: {}", err(&output));
        assert!(out(&output).trim_end().lines().last().unwrap().starts_with("wrote "), "{}", out(&output));
    }
    let through = fed(&["compensate", "-"], &source);
    assert_eq!(through.status.code(), Some(0), "{}", err(&through));
    // The source's name stands in the comment block, nothing else differs.
    let without = |text: &str| -> Vec<String> {
        text.lines()
            .filter(|l| !l.contains("driftpost s") && !l.contains("driftpost digest"))
            .map(str::to_owned)
            .collect()
    };
    assert_eq!(without(&out(&through)), without(&bench.text("o.mod")));
    assert!(err(&through).contains("wrote standard output"), "{}", err(&through));
    let into = driftpost(&["compensate", CUBE, "-o", "-"]);
    assert_eq!(without(&out(&into)), without(&out(&through)));
    let twice = driftpost(&["compensate", CUBE, "-o", "-", "--json", "-"]);
    assert!(twice.status.code() == Some(2) && err(&twice).contains("output::twice"), "{}", err(&twice));
    let core = driftpost(&["compensate", CUBE, "-o", "-", "--core", "separate"]);
    assert!(core.status.code() == Some(2) && err(&core).contains("output::one-file"), "{}", err(&core));
    assert_eq!(out(&core), "");
    let in_place = fed(&["compensate", "-", "--in-place"], &source);
    assert!(in_place.status.code() == Some(2) && err(&in_place).contains("standard input is no file"));
    let simulated = fed(&["simulate", "-", "--original", CUBE, "--minutes", "60"], &through.stdout);
    assert_eq!(simulated.status.code(), Some(0), "{}", err(&simulated));
}

#[test]
fn a_name_that_ends_in_a_slash_is_a_folder() {
    let bench = Bench::default();
    let folder = format!("{}/", bench.path("new/deep").display());
    let output = driftpost(&["compensate", CUBE, "-o", &folder]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert_eq!(bench.files(), ["new/deep/Cube45_tc.mod"]);
}

#[test]
fn the_whole_difference_goes_to_standard_output_where_it_is_asked_for() {
    let bench = Bench::default();
    let made = bench.path("o.mod").display().to_string();
    let diff = bench.path("o.diff").display().to_string();
    let whole = driftpost(&["compensate", CUBE, "-o", &made, "--diff", "-"]);
    assert_eq!(driftpost(&["compensate", CUBE, "-o", &made, "--diff", &diff]).status.code(), Some(0));
    assert!(out(&whole).starts_with(&bench.text("o.diff")) && bench.text("o.diff").lines().count() > 1000);
    assert!(!out(&whole).contains('\x1b'), "no colours in a pipe");
    let short = out(&driftpost(&["compensate", CUBE, "-o", &made]));
    let shown = short.lines().take_while(|line| !line.starts_with("program")).count();
    assert!((20..=62).contains(&shown) && short.contains("+        MoveL tc31{tcK()}"), "{short}");
    let none = out(&driftpost(&["compensate", CUBE, "-o", &made, "--diff", "none"]));
    assert!(none.starts_with("program ") && !none.contains("+++"), "{none}");
    // The verdict comes last.
    let last: Vec<&str> = none.trim_end().lines().rev().take(3).collect();
    assert!(last[2].starts_with("46 motions: 46 compensated, 0 kept, 0 refused"), "{last:?}");
    assert!(
        last[1].contains("0.1926 mm before, 0.0050 mm after") && last[0].starts_with("wrote "),
        "{last:?}"
    );
    for digits in short.split(|c: char| !c.is_ascii_hexdigit()).filter(|word| word.len() == 64) {
        assert_eq!(short.matches(digits).count(), 1, "{digits}");
    }
}

#[test]
fn numbers_beyond_all_measure_are_answered_with_a_short_sentence() {
    let bench = Bench::default();
    let result = bench.path("o.mod").display().to_string();
    let refused = |options: &[&str], sentence: &str| {
        let output = driftpost(&[&["compensate", CUBE, "-o", &result][..], options].concat());
        assert_eq!(output.status.code(), Some(2), "{options:?} {}", err(&output));
        assert!(err(&output).contains(sentence), "{options:?}: {}", err(&output));
        assert!(err(&output).lines().all(|line| line.len() < 250), "{}", err(&output));
    };
    for option in ["--tau-cool", "--gap-min", "--hold-min", "--stale-min", "--until", "--bucket-min"] {
        let range = format!("{option} must be from 0.01 to 525600 minutes, which is a year, not ");
        refused(&[option, "1e300"], &format!("{range}1e300"));
        refused(&[option, "1e-300"], &format!("{range}1e-300"));
        refused(&[option, "-1"], "not -1");
    }
    refused(
        &["--start-joints", "0,0,0,0,300,0"],
        "joint 5 at 300.0 deg is outside its range -115.0 to 115.0 deg",
    );
    refused(&["--tool", "-12,0,80"], "write NAME=VALUE");
    refused(
        &["--payload-kg", "-1", "--model", "fixtures/model/every_effect.toml"],
        "--payload-kg must be more than 0",
    );
    let robot = std::fs::read_to_string("crates/robot-model/src/robot/built_in/irb140.toml").unwrap();
    let wide = robot.replace("range_deg = [-180, 180]", "range_deg = [-1e9, 1e9]");
    assert_ne!(robot, wide);
    let wide = bench.file("wide.toml", wide);
    let start = std::time::Instant::now();
    refused(&["--robot", &wide], "is more than 10800 degrees from zero");
    assert!(start.elapsed().as_secs() < 5);
    let model = std::fs::read_to_string("fixtures/model/every_effect.toml").unwrap();
    for (from, by, sentence) in [
        ("n = 18", "n = 1000000000", "1000000000 periods per turn are no gear"),
        ("n = 18", "n = 0", "0 periods per turn are no gear"),
    ] {
        let other = model.replacen(from, by, 1);
        assert_ne!(other, model, "{from}");
        refused(&["--model", &bench.file("m.toml", other), "--temperature-c", "30"], sentence);
    }
    for (arguments, sentence) in [
        (&["simulate", CUBE, "--passes", "0"][..], "--passes must be 1 or more"),
        (&["simulate", CUBE, "--passes", "-1"], "'-1' for '--passes"),
        (&["simulate", CUBE, "--minutes", "0,1e300"], "minute 1e300 is later than a year"),
        (
            &["simulate", CUBE, "--start-joints", "0,0,-900,0,0,0"],
            "joint 3 at -900.0 deg is outside its range",
        ),
        (&["simulate", "fixtures/cell/two_tasks", "--task", "TASK9"], "no module stands in a folder TASK9"),
        (&["changed", CUBE, CUBE, "--limit-mm", "-1"], "--limit-mm must be more than 0"),
        (&["plan", "--n", "-3"], "'-3' for '--n"),
    ] {
        let output = driftpost(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(err(&output).contains(sentence), "{arguments:?}: {}", err(&output));
    }
    for date in ["2026-02-30 08:00:00", "2026-04-31 08:00:00", "2026-13-01 08:00:00"] {
        let scenario = bench.file("s.toml", format!("start = \"{date}\"\nsteps = [\"run 1\"]\n"));
        let output = driftpost(&["simulate", CUBE, "--scenario", &scenario]);
        assert_eq!(output.status.code(), Some(2), "{date}");
        assert!(err(&output).contains("is no date and time that exists"), "{}", err(&output));
    }
}

#[test]
fn the_same_measurements_are_not_changed() {
    let file = "fixtures/measurements/ur10/measurements.csv";
    let output = driftpost(&["changed", file, file, "--robot", "fixtures/measurements/ur10/robot.toml"]);
    assert_eq!(output.status.code(), Some(0), "{} {}", out(&output), err(&output));
    assert!(out(&output).to_lowercase().contains("not changed"), "{}", out(&output));
}

/// The branch that confdata name reaches the target only with axis 2 or 3 beyond its range, and nothing says where the arm comes from.
#[test]
fn a_target_that_no_branch_in_range_reaches_as_written_is_no_fault_of_the_program() {
    let bench = Bench::default();
    let program = bench.path("beyond.mod");
    for conf in ["  ConfJ\\Off;\n", ""] {
        let text = format!(
            "MODULE m\n PROC main()\n{conf}  MoveJ [[450,-100,-300],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v200,fine,tool0;\n ENDPROC\nENDMODULE\n"
        );
        std::fs::write(&program, text).unwrap();
        for form in ["schedule", "ramp", "live", "auto"] {
            let made = bench.path("made.mod").display().to_string();
            let output = fed(
                &["compensate", &program.display().to_string(), "-o", &made, "--form", form, "--force"],
                b"",
            );
            assert!(matches!(output.status.code(), Some(0..=2)), "{form}: {}", err(&output));
        }
    }
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
/// A module of standard input has no name that it could be put back under.
#[test]
fn standard_input_beside_files_is_refused() {
    let bench = Bench::default();
    let cube = std::fs::read(CUBE).unwrap();
    let other = bench.file("B.mod", &cube);
    let to = bench.path("c").display().to_string();
    let output = fed(&["compensate", "-", &other, "-o", &to], &cube);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        err(&output).contains("input::mixed") && err(&output).contains("give it as a file"),
        "{}",
        err(&output)
    );
    assert_eq!(bench.files(), ["B.mod"]);
}

mod long {
    use super::*;

    #[cfg(target_os = "linux")]
    #[test]
    #[ignore = "long"]
    fn devices_pipes_and_links_are_answered_at_once() {
        let bench = Bench::default();
        let refused = |arguments: &[&str], sentence: &str| {
            let start = std::time::Instant::now();
            let output = driftpost(arguments);
            assert_eq!(output.status.code(), Some(2), "{arguments:?} {}", err(&output));
            assert!(err(&output).contains(sentence), "{arguments:?}: {}", err(&output));
            assert!(start.elapsed().as_secs() < 20, "{arguments:?}");
        };
        for device in ["/dev/zero", "/dev/urandom"] {
            refused(&["compensate", device], "is a device, not a program");
            refused(&["compensate", CUBE, "--robot", device], "is a device, not a robot file");
            refused(&["diagnose", device], "is a device, not a measurement file");
            refused(&["simulate", CUBE, "--scenario", device], "is a device, not a scenario");
        }
        let pipe = bench.path("pipe.mod");
        assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        refused(&["compensate", pipe.to_str().unwrap()], "nothing is written to the pipe");
        let folder = bench.path("").display().to_string();
        refused(&["compensate", &folder], "pipe.mod is no file");
        std::fs::remove_file(&pipe).unwrap();
        let link = bench.path("link.mod");
        std::os::unix::fs::symlink("nowhere.mod", &link).unwrap();
        refused(&["compensate", link.to_str().unwrap()], "is a link to nowhere.mod, which does not exist");
        refused(&["compensate", &folder], "is a link to nowhere.mod, which does not exist");
        // A stream that does not end: more than any program is refused, not gathered for ever.
        let mut endless = Command::new("yes").stdout(Stdio::piped()).spawn().unwrap();
        let output = Command::new(env!("CARGO_BIN_EXE_driftpost"))
            .args(["compensate", "-"])
            .stdin(endless.stdout.take().unwrap())
            .output()
            .unwrap();
        endless.kill().unwrap();
        endless.wait().unwrap();
        assert_eq!(output.status.code(), Some(2));
        assert!(err(&output).contains("is larger than 1 GB"), "{}", err(&output));
    }
}
