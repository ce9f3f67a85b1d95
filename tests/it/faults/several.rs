//! Several modules are put in their places one after the other, and a run may be killed between any two.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// So many modules stand beside `main`, one number after the other: the more there are, the longer a run takes to put them all in
/// their places. On an idle machine the fewest do; where others have the processor, a run may put those in place before it is killed.
const MODULES: [usize; 5] = [60, 120, 250, 500, 1000];
/// So often is a run with one number of modules killed.
const ATTEMPTS: usize = 8;
const CORE: &str = "tcCore.mod";

fn program(folder: &Path, modules: usize) {
    fs::create_dir_all(folder).unwrap();
    let calls: String = (0..modules).map(|k| format!("    part{k};\n")).collect();
    let main = format!("MODULE Main\n  PROC main()\n{calls}  ENDPROC\nENDMODULE\n");
    fs::write(folder.join("Main.mod"), main).unwrap();
    for k in 0..modules {
        let (x, y) = (400 + k % 100, 3 * k % 200);
        let text = format!(
            "MODULE Part{k}\n  PROC part{k}()\n    MoveL [[{x},{y},300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\n  ENDPROC\nENDMODULE\n"
        );
        fs::write(folder.join(format!("Part{k}.mod")), text).unwrap();
    }
}

fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_driftpost"));
    command.args(arguments).current_dir(folder).stdin(Stdio::null());
    command
}

fn compensate(folder: &Path, more: &[&str]) -> Output {
    let own = ["compensate", "cell", "--robot", "irb140", "--diff", "none", "--quiet"];
    command(folder, &[&own, more].concat()).output().unwrap()
}

/// The files of a folder by name, those that are hidden too.
fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    entries
        .map(|entry| {
            let entry = entry.unwrap();
            (entry.file_name().into_string().unwrap(), fs::read(entry.path()).unwrap_or_default())
        })
        .collect()
}

/// What stands in `watched` where a run with `more` is killed as soon as `is_begun` says so of it; `None` where it was whole by then.
fn killed(
    folder: &Path,
    more: &[&str],
    watched: &Path,
    whole: &BTreeMap<String, Vec<u8>>,
    is_begun: impl Fn() -> bool,
) -> Option<BTreeMap<String, Vec<u8>>> {
    let own = ["compensate", "cell", "--robot", "irb140", "--diff", "none", "--quiet"];
    let mut child = command(folder, &[&own, more].concat()).stderr(Stdio::null()).spawn().unwrap();
    while !is_begun() && child.try_wait().unwrap().is_none() {}
    drop(child.kill());
    child.wait().unwrap();
    let there = contents(watched);
    (there != *whole).then_some(there)
}

fn is_hidden(name: &str) -> bool {
    name.starts_with('.')
}

/// In place, the common module comes first: whatever stands there loads, and what is corrected finds its clock.
#[test]
fn modules_that_are_exchanged_in_place_always_find_what_they_call() {
    let half_done = MODULES.into_iter().find_map(|modules| {
        let bench = tempfile::tempdir().unwrap();
        let cell = bench.path().join("cell");
        program(&cell, modules);
        let originals = contents(&cell);
        assert!(compensate(bench.path(), &["--in-place"]).status.success());
        let corrected = contents(&cell);
        assert_eq!(corrected.len(), originals.len() + 1);
        let there = (0..ATTEMPTS).find_map(|_| {
            fs::remove_dir_all(&cell).unwrap();
            program(&cell, modules);
            killed(bench.path(), &["--in-place"], &cell, &corrected, || cell.join(CORE).exists())
        });
        there.map(|there| (bench, originals, corrected, there))
    });
    let (bench, originals, corrected, there) = half_done.expect("no run was killed between two modules");
    let cell = bench.path().join("cell");
    for (name, bytes) in there.iter().filter(|(name, _)| !is_hidden(name)) {
        let is_whole = corrected.get(name) == Some(bytes) || originals.get(name) == Some(bytes);
        assert!(is_whole, "{name} is neither the original nor the corrected module");
    }
    assert_eq!(there.get(CORE), corrected.get(CORE), "the module that all call comes first");

    // The next run says what is half done, and takes away what waited beside its place.
    let output = compensate(bench.path(), &["--in-place"]);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("error[refuse::half-compensated]"), "{message}");
    let still =
        originals.iter().find(|(name, bytes)| name.starts_with("Part") && there.get(*name) == Some(*bytes));
    let (still, _) = still.expect("a module that is still the original");
    assert!(
        message.contains(&format!("cell/{still}")) && message.contains(" compensated, and what moves"),
        "{message}"
    );
    assert!(!contents(&cell).keys().any(|name| is_hidden(name)), "files are left beside their places");

    // What the message says to do gives the originals back.
    let restored = command(bench.path(), &["restore", "cell", "-o", "originals"]).output().unwrap();
    assert!(restored.status.success(), "{}", String::from_utf8_lossy(&restored.stderr));
    assert_eq!(contents(&bench.path().join("originals")), originals);
}

/// Over an earlier result, new modules never stand beside the old clock nor old ones beside the new: until all are there, none is.
#[test]
fn modules_of_two_results_never_share_a_clock() {
    let coarse = ["--tolerance-mm", "0.05"];
    let made = |bench: &Path, more: &[&str]| {
        let output = compensate(bench, &[&["-o", "out"], more].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        contents(&bench.join("out"))
    };
    let half_done = MODULES.into_iter().find_map(|modules| {
        let bench = tempfile::tempdir().unwrap();
        let out = bench.path().join("out");
        program(&bench.path().join("cell"), modules);
        let (old, new) = (made(bench.path(), &[]), made(bench.path(), &coarse));
        assert_ne!(old.get(CORE), new.get(CORE));
        let there = (0..ATTEMPTS).find_map(|_| {
            assert!(made(bench.path(), &[]) == old);
            let more = ["-o", "out", coarse[0], coarse[1]];
            let is_exchanged =
                |(name, bytes): (&String, &Vec<u8>)| !is_hidden(name) && old.get(name) != Some(bytes);
            killed(bench.path(), &more, &out, &new, || !out.join(CORE).exists())
                .filter(|there| there.iter().any(is_exchanged))
        });
        there.map(|there| (bench, old, new, there))
    });
    let (bench, old, new, there) = half_done.expect("no run was killed between two modules");
    assert!(there.iter().any(|(name, bytes)| old.get(name) == Some(bytes) && new.get(name) != Some(bytes)));
    assert_eq!(there.get(CORE), None, "old and new modules stand side by side with a clock");
    assert!(made(bench.path(), &coarse) == new, "the next run completes what was half done");
}
