//! What happens when the machine fails: killed at any moment, two runs at once, a folder that cannot be, no home.

#[cfg(target_os = "linux")]
mod several;

#[cfg(target_os = "linux")]
use crate::stepped::Stepped;
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
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("in.mod") && message.contains("nothing was written"), "{message}");
    assert_eq!(fs::read(folder.path().join("in.mod")).unwrap(), source);
}

#[test]
fn no_home_and_no_environment_are_needed() {
    let folder = bench();
    assert!(compensate(folder.path(), &[]).env_clear().status().unwrap().success());
    assert!(folder.path().join("out.mod").exists());
}

#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_goes_away_in_the_middle_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let line = |i: usize| {
        format!(
            "    MoveL [[{},10,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\n",
            350 + i % 100
        )
    };
    let source = format!(
        "MODULE Large\n  PROC main()\n{}  ENDPROC\nENDMODULE\n",
        (0..10_000).map(line).collect::<String>()
    );
    fs::write(folder.path().join("in.mod"), &source).unwrap();
    let out = folder.path().join("out");
    fs::create_dir(&out).unwrap();
    let mut run = Stepped::start(
        folder.path(),
        &["compensate", "in.mod", "--robot", "irb140", "-o", "out/out.mod", "--diff", "none", "--quiet"],
    );
    // An empty file is the trial before the work, and a folder that goes away then is made anew.
    let is_written = || {
        let mut entries = fs::read_dir(&out).unwrap().map(Result::unwrap);
        entries.any(|entry| entry.metadata().is_ok_and(|metadata| metadata.len() > 0))
    };
    assert!(run.run_until(is_written), "the result is written beside its place");
    fs::remove_dir_all(&out).unwrap();
    let output = run.finish();
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("error[output::unwritable]") && message.contains("out/out.mod"), "{message}");
    assert_eq!(fs::read_to_string(folder.path().join("in.mod")).unwrap(), source);
    let left = fs::read_dir(&out).map_or(0, Iterator::count);
    assert_eq!(left, 0, "files are left in {}", out.display());
}

/// On a disk of 48 kB of its own, where the system lets an ordinary user mount one.
#[cfg(target_os = "linux")]
#[test]
#[ignore = "needs `unshare` and the right to mount a disk"]
fn a_disk_that_fills_up_while_a_result_is_written_is_left_as_it_was() {
    let folder = bench();
    let script = r#"mkdir disk && mount -t tmpfs -o size=48k none disk || exit 3
        echo before > disk/out.mod
        "$0" compensate in.mod --robot irb140 -o disk/out.mod --diff none --quiet --force
        echo "exit $?"; ls -A disk; cat disk/out.mod"#;
    let output = Command::new("unshare")
        .args(["--map-root-user", "--mount", "sh", "-c", script, env!("CARGO_BIN_EXE_driftpost")])
        .current_dir(folder.path())
        .output()
        .unwrap();
    let (message, shown) = (String::from_utf8_lossy(&output.stderr), String::from_utf8_lossy(&output.stdout));
    assert_eq!(shown, "exit 2\nout.mod\nbefore\n", "{message}");
    assert!(message.contains("error[output::unwritable]") && message.contains("No space left"), "{message}");
}

/// What a run says that may write no file of more than so many blocks (of 512 or 1024 bytes, as the shell counts): the system refuses to write on, as on a full disk.
#[cfg(unix)]
fn with_short_files(folder: &Path, blocks: u32, more: &str) -> (Option<i32>, String) {
    let script = format!(
        "trap '' XFSZ; ulimit -f {blocks}; exec \"$0\" compensate in.mod --robot irb140 -o out.mod --form ramp --quiet {more}"
    );
    let output = Command::new("sh")
        .args(["-c", &script, env!("CARGO_BIN_EXE_driftpost")])
        .current_dir(folder)
        .output()
        .unwrap();
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

/// Of what goes beside the program that file is named which is too large for the disk.
#[cfg(unix)]
#[test]
fn the_file_is_named_that_does_not_fit_on_the_disk() {
    // The program has 25 kB, its difference 34, the page 760, the table of joints 2,000.
    for (blocks, option, name) in
        [(30, "--diff", "all.diff"), (200, "--report", "page.html"), (200, "--joints-csv", "joints.csv")]
    {
        let folder = bench();
        let (code, message) = with_short_files(folder.path(), blocks, &format!("{option} {name}"));
        assert_eq!(code, Some(2), "{option}: {message}");
        assert!(message.contains(&format!("{name} cannot be written")), "{option}: {message}");
        assert!(!message.contains("standard output"), "{option}: {message}");
        assert!(!folder.path().join("out.mod").exists(), "{option}");
    }
}

/// A clock that was set back: the source is of a later year, and so is what a killed run left; or all is of 1970.
#[cfg(target_os = "linux")]
#[test]
fn the_date_of_files_does_not_matter() {
    use std::time::SystemTime;
    let folder = bench();
    let date = |name: &str, at: SystemTime| {
        fs::File::options().write(true).open(folder.path().join(name)).unwrap().set_modified(at).unwrap();
    };
    assert!(compensate(folder.path(), &[]).status().unwrap().success());
    let good = fs::read(folder.path().join("out.mod")).unwrap();
    for at in [SystemTime::UNIX_EPOCH, SystemTime::now() + Duration::from_secs(50 * 365 * 86_400)] {
        // No process has this number.
        fs::write(folder.path().join(".driftpost-4294967295-left"), "a part").unwrap();
        for name in ["in.mod", "out.mod", ".driftpost-4294967295-left"] {
            date(name, at);
        }
        assert!(compensate(folder.path(), &[]).status().unwrap().success());
        assert!(fs::read(folder.path().join("out.mod")).unwrap() == good);
        assert!(!folder.path().join(".driftpost-4294967295-left").exists());
    }
}

#[cfg(unix)]
#[test]
fn closed_standard_streams_are_no_fault() {
    let folder = bench();
    let run = r#""$0" compensate in.mod --robot irb140 -o out.mod --diff none <&- >&- 2>&-"#;
    let status = Command::new("sh")
        .args(["-c", run, env!("CARGO_BIN_EXE_driftpost")])
        .current_dir(folder.path())
        .status();
    assert_eq!(status.unwrap().code(), Some(0));
    assert!(folder.path().join("out.mod").exists());
    let text = fs::read_to_string(folder.path().join("out.mod")).unwrap();
    assert!(text.starts_with("MODULE") || text.starts_with("%%%"), "{}", &text[..80]);
}
