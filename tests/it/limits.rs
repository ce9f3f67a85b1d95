//! Input as large and as deep as nobody sends it: read, or refused with the limit.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

fn target(i: usize) -> String {
    let (x, y, z) = (350 + i % 100, 1 + i % 77, 300 + i % 53);
    format!("[[{x},{y},{z}],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]")
}

fn driftpost(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_driftpost")).args(arguments).current_dir(folder).output().unwrap()
}

fn err(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn a_file_of_more_than_1_gb_is_refused_without_reading_it() {
    let folder = tempfile::tempdir().unwrap();
    let file = fs::File::create(folder.path().join("in.mod")).unwrap();
    // Sparse: it takes no place on the disk, and reading it would take seconds.
    file.set_len((1 << 30) + 1).unwrap();
    let start = Instant::now();
    let output = driftpost(folder.path(), &["inspect", "in.mod"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        err(&output).contains("error[input::too-large]") && err(&output).contains("1 GB"),
        "{}",
        err(&output)
    );
    assert!(start.elapsed() < Duration::from_secs(20), "{:?}", start.elapsed());
}

/// A program of one move and comments, so many bytes in all, and what becomes of it.
fn of_size(folder: &Path, bytes: usize) -> (String, Output) {
    let line = format!("! {}\n", "x".repeat(997));
    let mut text =
        format!("MODULE Large\n  PROC main()\n    MoveL {},v100,fine,tool0;\n  ENDPROC\n", target(1));
    text.extend(std::iter::repeat_n(line.as_str(), bytes / line.len()));
    text.push_str("ENDMODULE\n");
    fs::write(folder.join("in.mod"), &text).unwrap();
    let arguments =
        ["compensate", "in.mod", "--robot", "irb140", "--form", "ramp", "--diff", "none", "-o", "out.mod"];
    let output = driftpost(folder, &arguments);
    (text, output)
}

#[test]
#[ignore = "takes 4 GB of memory: cargo test --release --test it limits:: -- --ignored"]
fn a_program_of_a_gb_is_compensated_and_restored() {
    let folder = tempfile::tempdir().unwrap();
    let (text, output) = of_size(folder.path(), (1 << 30) - (1 << 20));
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let output = driftpost(folder.path(), &["restore", "out.mod", "-o", "again.mod"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert!(fs::read(folder.path().join("again.mod")).unwrap() == text.as_bytes());
}

#[test]
#[ignore = "takes 4 GB of memory: cargo test --release --test it limits:: -- --ignored"]
fn a_result_that_would_be_too_large_to_be_restored_is_not_written() {
    let folder = tempfile::tempdir().unwrap();
    let (_, output) = of_size(folder.path(), (1 << 30) - 4096);
    assert_eq!(output.status.code(), Some(2), "{}", err(&output));
    assert!(err(&output).contains("error[output::too-large]"), "{}", err(&output));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

/// A program of `count` routines, each called by the one before, compensated and restored.
fn routines(count: usize) {
    let folder = tempfile::tempdir().unwrap();
    let mut text = String::from("MODULE Many\n");
    for i in 0..count {
        let call = if i + 1 < count { format!("    p{};\n", i + 1) } else { String::new() };
        _ = write!(text, "  PROC p{i}()\n    MoveL {},v100,fine,tool0;\n{call}  ENDPROC\n", target(i));
    }
    text.push_str("ENDMODULE\n");
    fs::write(folder.path().join("in.mod"), &text).unwrap();
    let json = ["--json", "out.json", "--diff", "none", "--quiet"];
    let arguments = ["compensate", "in.mod", "--robot", "irb140", "--form", "ramp", "-o", "out.mod"];
    let output = driftpost(folder.path(), &[&arguments[..], &json].concat());
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let emitted = fs::read_to_string(folder.path().join("out.mod")).unwrap();
    // Each of them asks for its own target.
    let corrected = emitted.lines().filter(|line| line.trim_start().starts_with("MoveL tc")).count();
    assert_eq!(corrected, count);
    let output = driftpost(folder.path(), &["restore", "out.mod", "-o", "again.mod"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert!(fs::read(folder.path().join("again.mod")).unwrap() == text.as_bytes());
}

#[test]
fn two_thousand_routines_that_call_each_other_are_compensated() {
    routines(2000);
}

#[test]
#[ignore = "a minute: cargo test --release --test it limits:: -- --ignored"]
fn a_hundred_thousand_routines_that_call_each_other_are_compensated() {
    routines(100_000);
}

#[test]
fn ten_thousand_nested_blocks_are_kept_unread_and_what_is_around_them_is_compensated() {
    let folder = tempfile::tempdir().unwrap();
    let depth = 10_000;
    let text = format!(
        "MODULE Deep\n  PROC main()\n    MoveL {},v100,fine,tool0;\n{}    MoveL {},v100,fine,tool0;\n{}    MoveL {},v100,fine,tool0;\n  ENDPROC\nENDMODULE\n",
        target(1),
        "IF TRUE THEN\n".repeat(depth),
        target(2),
        "ENDIF\n".repeat(depth),
        target(3)
    );
    fs::write(folder.path().join("in.mod"), &text).unwrap();
    let arguments = ["compensate", "in.mod", "--robot", "irb140", "-o", "out.mod", "--diff", "none"];
    let output = driftpost(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    let message = format!("{}{}", err(&output), String::from_utf8_lossy(&output.stdout));
    assert!(message.contains("syntax::deep") && message.contains("keep::not-read"), "{message}");
    let emitted = fs::read_to_string(folder.path().join("out.mod")).unwrap();
    assert!(emitted.contains(&format!("    MoveL {},v100", target(2))), "what was not read is as it was");
    assert!(!emitted.contains(&format!("    MoveL {},v100", target(1))), "what stands around is corrected");
    let output = driftpost(folder.path(), &["restore", "out.mod", "-o", "again.mod"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert!(fs::read(folder.path().join("again.mod")).unwrap() == text.as_bytes());
}
