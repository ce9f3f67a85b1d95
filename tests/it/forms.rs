//! Every form of correction with every clock and law of growth: what a module calls it declares, and what is executed stands where it is meant to.

use super::play::HEAD;
use assert_cmd::Command;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::Path;

const CUBE: &str = "fixtures/robodk/irc5/Cube45.mod";
const FORMS: [&str; 4] = ["schedule", "ramp", "live", "auto"];

/// A deformation table: nothing in its first row, then all joints' frames shifted and turned, not in proportion.
fn table(index: &str, at: [u32; 3]) -> String {
    let mut text = format!("{index},joint,dx_mm,dy_mm,dz_mm,rx_deg,ry_deg,rz_deg\n");
    for (at, [a, b]) in at.into_iter().zip([[0.0, 0.0], [1.0, 0.2], [2.0, 1.0]]) {
        for joint in 1..=6 {
            writeln!(text, "{at},{joint},{},{},0,0,{},{}", 0.01 * a, 0.02 * b, 0.002 * a, 0.001 * b).unwrap();
        }
    }
    text
}

fn run(args: &[&str]) -> std::process::Output {
    Command::cargo_bin("driftpost").unwrap().args(args).output().unwrap()
}

/// The words of a module's code that begin with `tc` and a capital, with what follows each: no comments, no strings.
fn words(module: &str) -> Vec<(String, char)> {
    let mut words = Vec::new();
    for line in module.lines() {
        let code: String = line.split('"').step_by(2).collect::<Vec<_>>().join("\"\"");
        let code = code.split('!').next().unwrap_or_default();
        let mut rest = code;
        while let Some(at) = rest.find(|c: char| c.is_ascii_alphabetic()) {
            let word: String =
                rest[at..].chars().take_while(|c| c.is_ascii_alphanumeric() || *c == '_').collect();
            rest = &rest[at + word.len()..];
            let own =
                word.strip_prefix("tc").is_some_and(|w| w.starts_with(|c: char| c.is_ascii_uppercase()));
            if own {
                words.push((word, rest.trim_start().chars().next().unwrap_or('\n')));
            }
        }
    }
    words
}

/// The functions that a module calls and nobody declares.
fn undeclared(module: &str) -> BTreeSet<String> {
    let declares = |name: &str| {
        let head = |line: &str| line.contains("FUNC ") || line.contains("PROC ");
        module.lines().any(|line| head(line) && line.contains(&format!(" {name}(")))
    };
    let called = words(module).into_iter().filter(|(_, next)| *next == '(').map(|(word, _)| word);
    called.filter(|name| !declares(name)).collect()
}

/// What is left of a program, mm, corrected in a form and executed at some minutes or temperatures; at most `most_mm` may be.
fn holds(dir: &Path, of_drift: &[&str], clock: &[&str], at: &str, most_mm: f64) {
    let [corrected, json] = ["c.mod", "s.json"].map(|name| dir.join(name).to_string_lossy().into_owned());
    for form in FORMS {
        let what = format!("{form} {of_drift:?} {clock:?}");
        let start = ["compensate", CUBE, "--robot", "irb140", "--form", form, "-o", &corrected, "--force"];
        let made = run(&[&start[..], of_drift, clock].concat());
        assert!(made.status.success(), "{what}: {}", String::from_utf8_lossy(&made.stderr));
        let module = std::fs::read_to_string(&corrected).unwrap();
        assert_eq!(undeclared(&module), BTreeSet::new(), "{what}");
        let start = [
            "simulate",
            &corrected,
            "--original",
            CUBE,
            "--robot",
            "irb140",
            "--minutes",
            at,
            "--json",
            &json,
        ];
        run(&[&start[..], of_drift].concat());
        let found: serde_json::Value = serde_json::from_slice(&std::fs::read(&json).unwrap()).unwrap();
        for minute in found["minutes"].as_array().unwrap() {
            let (before, after) =
                (minute["before"]["max_mm"].as_f64().unwrap(), minute["after"]["max_mm"].as_f64().unwrap());
            assert!(after < most_mm, "{what} at {}: {after} mm of {before}", minute["t_min"]);
        }
    }
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    /// Tables by time and by temperature with each clock that reads them. A schedule's tolerance is 0.005 mm.
    #[test]
    #[ignore = "long"]
    fn each_form_with_each_clock_declares_what_it_calls_and_holds() {
        let dir = tempfile::tempdir().unwrap();
        let file = |name: &str, text: &str| {
            let path = dir.path().join(name);
            std::fs::write(&path, text).unwrap();
            path.to_string_lossy().into_owned()
        };
        let by_time = file("t.csv", &table("t_min", [0, 60, 180]));
        let by_temperature = file("c.csv", &table("temp_c", [20, 26, 40]));
        let minutes = "0,10,45,100,170,300";
        holds(dir.path(), &["--deformation", &by_time], &["--tau-cool", "46"], minutes, 0.006);
        holds(dir.path(), &["--deformation", &by_time], &["--clock", "elapsed"], minutes, 0.006);
        for clock in ["signal:aiTemperature", "pers:nTemperature"] {
            holds(dir.path(), &["--deformation", &by_temperature], &["--clock", clock], "20,24,31,40", 0.006);
        }
        // Table 2 of the paper, which is there without a file.
        for (growth, clock) in [("exp:46", "warmth"), ("two-stage:46", "elapsed"), ("none", "elapsed")] {
            holds(dir.path(), &["--growth", growth], &["--clock", clock], minutes, 0.006);
        }
    }

    /// Models of one effect: what drifts by no law of warm-up, and what is off in the wrist alone.
    #[test]
    #[ignore = "long"]
    fn each_form_holds_models_of_one_effect() {
        let dir = tempfile::tempdir().unwrap();
        for effect in [
            "effect = \"tool_drift\"\ndx_mm = 0.05\ndy_mm = 0.0\ndz_mm = -0.03\ngrowth = \"linear\"\nfrom_min = 0.0\nto_min = 240.0\n",
            "effect = \"thermal_joint_drift\"\njoint = 2\ndrift_deg = 0.01\nconstant_deg = 0.002\ngrowth = \"linear\"\nfrom_min = 20.0\nto_min = 200.0\n",
            "effect = \"joint_offset\"\njoint = 4\noffset_deg = 0.03\n",
            "effect = \"joint_offset\"\njoint = 5\noffset_deg = 0.03\n",
        ] {
            let model = dir.path().join("m.toml");
            std::fs::write(&model, format!("{HEAD}\n[[effect]]\n{effect}")).unwrap();
            holds(dir.path(), &["--model", &model.to_string_lossy()], &[], "0,50,120,239,300", 0.006);
        }
    }
}
