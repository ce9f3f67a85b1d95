//! What happens when the machine fails: killed at any moment, two runs at once, a folder that cannot be, no home.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

const CUBE: &str = "fixtures/robodk/irc5/Cube45.mod";

fn compensate(folder: &Path, more: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_driftpost"));
    command.args(["compensate", "in.mod", "--robot", "irb140", "-o", "out.mod", "--diff", "none", "--force"]);
    command.args(more).current_dir(folder).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

fn bench() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::copy(Path::new(env!("CARGO_MANIFEST_DIR")).join(CUBE), folder.path().join("in.mod")).unwrap();
    folder
}

/// Kills runs at moments spread evenly over the time that a whole one takes: a result is there whole or not at all.
fn killed(times: u32) {
    let folder = bench();
    let source = fs::read(folder.path().join("in.mod")).unwrap();
    let out = folder.path().join("out.mod");
    let start = Instant::now();
    assert!(compensate(folder.path(), &["--json", "out.json"]).status().unwrap().success());
    let whole = start.elapsed();
    let good = fs::read(&out).unwrap();
    let (mut kept, mut none) = (0, 0);
    for k in 0..times {
        drop(fs::remove_file(&out));
        let mut child: Child = compensate(folder.path(), &["--json", "out.json"]).spawn().unwrap();
        std::thread::sleep(whole * k / times + Duration::from_micros(u64::from(k * 37 % 1000)));
        drop(child.kill());
        child.wait().unwrap();
        match fs::read(&out) {
            Ok(bytes) => {
                assert!(bytes == good, "killed at {k} of {times}: a part of the result is in place");
                kept += 1;
            }
            Err(_) => none += 1,
        }
        let json = fs::read(folder.path().join("out.json")).unwrap();
        assert!(serde_json::from_slice::<serde_json::Value>(&json).is_ok(), "killed at {k} of {times}");
    }
    assert!(none > 0, "no run was killed before its end: {kept} of {times}");
    assert_eq!(fs::read(folder.path().join("in.mod")).unwrap(), source);
    // What killed runs left is taken away by the next that is whole.
    assert!(compensate(folder.path(), &["--json", "out.json"]).status().unwrap().success());
    let mut names: Vec<_> =
        fs::read_dir(folder.path()).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    assert_eq!(names, ["in.mod", "out.json", "out.mod"]);
}

#[test]
fn a_run_that_is_killed_leaves_a_whole_result_or_none() {
    killed(25);
}

#[test]
#[ignore = "two hundred runs"]
fn two_hundred_runs_that_are_killed_leave_whole_results_or_none() {
    killed(200);
}

#[test]
fn two_runs_at_once_leave_the_result_of_one_of_them() {
    let folder = bench();
    let result = |more: &[&str]| {
        assert!(compensate(folder.path(), more).status().unwrap().success());
        fs::read(folder.path().join("out.mod")).unwrap()
    };
    let (ramp, schedule) = (result(&["--form", "ramp"]), result(&["--form", "schedule"]));
    assert_ne!(ramp, schedule);
    for _ in 0..4 {
        let mut one = compensate(folder.path(), &["--form", "ramp"]).spawn().unwrap();
        let mut other = compensate(folder.path(), &["--form", "schedule"]).spawn().unwrap();
        assert!(one.wait().unwrap().success() && other.wait().unwrap().success());
        let there = fs::read(folder.path().join("out.mod")).unwrap();
        assert!(there == ramp || there == schedule, "a mixture of {} bytes", there.len());
    }
}

#[test]
fn a_folder_that_cannot_be_is_told() {
    let folder = bench();
    let source = fs::read(folder.path().join("in.mod")).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_driftpost"))
        .args(["compensate", "in.mod", "--robot", "irb140", "-o", "in.mod/out.mod", "--diff", "none"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("in.mod") && said.contains("nothing was written"), "{said}");
    assert_eq!(fs::read(folder.path().join("in.mod")).unwrap(), source);
}

#[test]
fn no_home_and_no_environment_are_needed() {
    let folder = bench();
    assert!(compensate(folder.path(), &[]).env_clear().status().unwrap().success());
    assert!(folder.path().join("out.mod").exists());
}
