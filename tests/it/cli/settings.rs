//! Defaults of a shop, `--quiet` and `--watch`.

use super::{Bench, CUBE, driftpost, err, out};
use std::fs;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

fn shown(arguments: &[&str]) -> Vec<String> {
    let output = driftpost(&[arguments, &["--show-settings"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    out(&output).lines().map(str::to_owned).collect()
}

#[test]
fn the_nearest_file_upwards_holds_and_the_command_line_wins() {
    let bench = Bench::default();
    bench.file("driftpost.toml", "tolerance-mm = 0.5\nform = \"live\"\n");
    let near = bench.file(
        "shop/driftpost.toml",
        "form = \"schedule\"\ntolerance-mm = 0.1\ndeformation = \"drift.csv\"\nuntil = 60\n\
         [compensate]\ntolerance-mm = 0.02\nkeep = [\"a*\", \"b*\"]\n[diagnose]\nsigma-mm = 0.03\n",
    );
    let program = bench.file("shop/line/cell/Cube45.mod", fs::read(CUBE).unwrap());
    let lines = shown(&["compensate", &program, "--form", "ramp", "--bucket-min", "5"]);
    let has = |line: String| assert!(lines.contains(&line), "{line}\n{}", lines.join("\n"));
    has("form = ramp  (command line)".to_owned());
    has(format!("until = 60  ({near})"));
    has(format!("keep = a* b*  ({near})"));
    has(format!("deformation = {}  ({near})", bench.path("shop/drift.csv").display()));
    has("robot = irb140  (default)".to_owned());
    // A bucket's width on the command line stands against the tolerance of the file.
    assert!(!lines.iter().any(|line| line.starts_with("tolerance-mm") && line.contains(&near)), "{lines:?}");
    let lines = shown(&["compensate", &program]);
    assert!(lines.contains(&format!("tolerance-mm = 0.02  ({near})")), "{lines:?}");
    // What only another command has is left alone.
    let table = bench.file("shop/m.csv", "");
    let lines = shown(&["diagnose", &table]);
    assert!(lines.contains(&format!("sigma-mm = 0.03  ({near})")), "{lines:?}");
    assert_eq!(bench.files().len(), 4, "nothing is done");
}

/// Of the working folder where a command works on no file; `state` as any other that reads measurements.
#[test]
fn plan_and_state_find_their_settings() {
    let bench = Bench::default();
    bench.file(
        "shop/driftpost.toml",
        "robot = \"irb2600\"\n[plan]\nsigma-mm = 0.07\n[state]\nsigma-mm = 0.05\n",
    );
    let mut plan = assert_cmd::Command::cargo_bin("driftpost").unwrap();
    let plan = plan.current_dir(bench.path("shop")).args(["plan", "--show-settings"]).output().unwrap();
    assert!(
        out(&plan).contains("robot = irb2600  (") && out(&plan).contains("sigma-mm = 0.07  ("),
        "{}",
        out(&plan)
    );
    let touches = bench.file("shop/touches.csv", fs::read("fixtures/docs/touches.csv").unwrap());
    let lines = shown(&["state", &touches]);
    assert!(lines.iter().any(|line| line.starts_with("robot = irb2600  (")), "{lines:?}");
    assert!(lines.iter().any(|line| line.starts_with("sigma-mm = 0.05  (")), "{lines:?}");
    let lines = shown(&["state", "--points", &touches, "--joints", &touches]);
    assert!(lines.iter().any(|line| line.starts_with("robot = irb2600  (")), "{lines:?}");
    bench.file("shop/driftpost.toml", "[state]\nnonsense = 1\n");
    let output = driftpost(&["state", &touches]);
    assert!(
        output.status.code() == Some(2) && err(&output).contains("`nonsense` is no option of state"),
        "{}",
        err(&output)
    );
}

#[test]
fn a_file_of_settings_that_is_named_is_there_and_read_or_it_is_said() {
    let bench = Bench::default();
    for command in
        [&["inspect", CUBE][..], &["simulate", CUBE], &["diff", CUBE, CUBE], &["robot"], &["state", "x.csv"]]
    {
        let output = driftpost(&[command, &["--settings", "nope.toml"]].concat());
        assert_eq!(output.status.code(), Some(2), "{command:?}");
        assert!(
            err(&output).contains("input::missing") && err(&output).contains("nope.toml"),
            "{}",
            err(&output)
        );
    }
    let settings = bench.file("shop.toml", "robot = \"irb2600\"\n");
    let output = driftpost(&["inspect", CUBE, "--settings", &settings]);
    assert_eq!(output.status.code(), Some(0));
    let warning = err(&output);
    assert!(
        warning.contains("warning[settings::not-read]") && warning.contains("inspect takes no defaults"),
        "{warning}"
    );
    // Help, page and program name the same commands.
    let page = fs::read_to_string("docs/SETTINGS.md").unwrap();
    let help = out(&driftpost(&["inspect", "--help"])).split_whitespace().collect::<Vec<_>>().join(" ");
    let named = warning.split("settings are read by ").nth(1).unwrap().lines().next().unwrap();
    let named: Vec<&str> = named.split(", ").collect();
    assert_eq!(named.len(), 10, "{named:?}");
    assert!(named.iter().all(|name| page.contains(&format!("`{name}`"))), "{named:?}");
    let last = named[9];
    assert!(help.contains(&format!("Read by {} and {last}", named[..9].join(", "))), "{help}");
}

#[test]
fn settings_change_what_is_made() {
    let bench = Bench::default();
    let program = bench.file("Cube45.mod", fs::read(CUBE).unwrap());
    bench.file("driftpost.toml", "tolerance-mm = 0.02\nform = \"ramp\"\n");
    let output = driftpost(&["compensate", &program, "--quiet"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert_eq!((out(&output), err(&output)), (String::new(), String::new()), "--quiet");
    assert!(bench.text("Cube45_tc.mod").contains("tcAt("));
    let other = bench.file("other.toml", "tolerance-mm = 0.02\n");
    let output = driftpost(&["compensate", "--settings", &other, &program]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert!(bench.text("Cube45_tc.mod").contains("{tcK()}"), "the file that is named, alone");
}

#[test]
fn what_is_no_default_is_refused_with_its_key() {
    let bench = Bench::default();
    let program = bench.file("Cube45.mod", fs::read(CUBE).unwrap());
    for (text, code, named) in [
        ("tolerence-mm = 1\n", "settings::unknown", "did you mean `tolerance-mm`?"),
        ("[compensate]\nsigma-mm = 1\n", "settings::unknown", "`sigma-mm` is no option of compensate"),
        ("in-place = true\n", "settings::not-a-default", "`in-place`"),
        ("[compensate]\noutput = \"x\"\n", "settings::not-a-default", "`output`"),
        ("robot = \n", "settings::toml", "driftpost.toml"),
        ("[compensat]\nform = \"ramp\"\n", "settings::unknown", "did you mean `[compensate]`?"),
        ("[shop]\nform = \"ramp\"\n", "settings::unknown", "`[shop]` is no command"),
        ("form = \"rampp\"\n", "settings::value", "driftpost.toml: invalid value 'rampp' for '--form"),
        ("[compensate]\ntolerance-mm = \"wide\"\n", "settings::value", "invalid float literal"),
        ("tolerance-mm = [0.01, 0.02]\n", "settings::value", "--tolerance-mm"),
    ] {
        bench.file("driftpost.toml", text);
        let output = driftpost(&["compensate", &program]);
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(err(&output).contains(code) && err(&output).contains(named), "{text}: {}", err(&output));
    }
    // What is wrong on the command line is none of the file's.
    bench.file("driftpost.toml", "form = \"rampp\"\n");
    let output = driftpost(&["compensate", &program, "--form", "rump"]);
    assert!(err(&output).contains("'rump'") && !err(&output).contains("settings::"), "{}", err(&output));
    let output = driftpost(&["compensate", &program, "--settings", "/nowhere/x.toml"]);
    assert!(err(&output).contains("input::missing"), "{}", err(&output));
    assert_eq!(bench.files(), ["Cube45.mod", "driftpost.toml"]);
}

#[test]
fn a_program_that_is_written_anew_is_compensated_again() {
    let bench = Bench::default();
    let text = fs::read_to_string(CUBE).unwrap();
    let program = bench.file("Cube45.mod", &text);
    let mut child = Command::new(env!("CARGO_BIN_EXE_driftpost"))
        .args(["compensate", &program, "--watch", "--tolerance-mm", "0.05"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let made = bench.path("Cube45_tc.mod");
    let wait_for = |word: &str| {
        let start = Instant::now();
        while !fs::read_to_string(&made).is_ok_and(|text| text.contains(word)) {
            assert!(start.elapsed() < Duration::from_secs(120), "{word} does not come");
            std::thread::sleep(Duration::from_millis(50));
        }
    };
    wait_for("PROC Cube45()");
    bench.file("Cube45.mod", "MODULE");
    bench.file("Cube45.mod", text.replace("PROC Cube45()", "PROC Anew()"));
    wait_for("PROC Anew()");
    child.kill().unwrap();
    child.wait().unwrap();
    let output = driftpost(&["compensate", "-", "--watch"]);
    assert!(err(&output).contains("watch::standard"), "{}", err(&output));
}

/// Whoever put it there means something by it: the defaults of no shop hold in its place.
#[cfg(unix)]
#[test]
fn a_file_of_settings_that_cannot_be_read_is_not_passed_over() {
    let bench = Bench::default();
    let program = bench.file("Cube45.mod", fs::read(CUBE).unwrap());
    let settings = bench.path("driftpost.toml");
    let refused = || driftpost(&["compensate", &program, "--diff", "none"]);
    std::os::unix::fs::symlink("/nowhere/shop.toml", &settings).unwrap();
    let link = refused();
    assert_eq!(link.status.code(), Some(2));
    assert!(err(&link).contains("is a link to /nowhere/shop.toml"), "{}", err(&link));
    fs::remove_file(&settings).unwrap();
    fs::create_dir(&settings).unwrap();
    assert!(err(&refused()).contains("is a folder, not a file of settings"), "{}", err(&refused()));
}
