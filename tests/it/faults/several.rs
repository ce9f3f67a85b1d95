//! Several modules are put in their places one after the other, and a run may be killed between any two.

use crate::stepped::Stepped;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::os::unix::fs::DirEntryExt;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// So many modules that are changed stand beside `main`, which stays as it is.
const MODULES: usize = 4;
const CORE: &str = "tcCore.mod";

fn program(folder: &Path) {
    fs::create_dir_all(folder).unwrap();
    let calls: String = (0..MODULES).map(|k| format!("    part{k};\n")).collect();
    let main = format!("MODULE Main\n  PROC main()\n{calls}  ENDPROC\nENDMODULE\n");
    fs::write(folder.join("Main.mod"), main).unwrap();
    for k in 0..MODULES {
        let (x, y) = (400 + k % 100, 3 * k % 200);
        let text = format!(
            "MODULE Part{k}\n  PROC part{k}()\n    MoveL [[{x},{y},300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\n  ENDPROC\nENDMODULE\n"
        );
        fs::write(folder.join(format!("Part{k}.mod")), text).unwrap();
    }
}

const COMPENSATE: [&str; 7] = ["compensate", "cell", "--robot", "irb140", "--diff", "none", "--quiet"];

fn driftpost(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_driftpost"));
    command.args(arguments).current_dir(folder).stdin(Stdio::null()).output().unwrap()
}

fn compensate(folder: &Path, more: &[&str]) -> Output {
    driftpost(folder, &[&COMPENSATE, more].concat())
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

/// What stands in `watched` where a run with `more` is killed as soon as names or files have changed there `changes` times; `None`
/// where it came to its end.
fn killed(folder: &Path, more: &[&str], watched: &Path, changes: usize) -> Option<BTreeMap<String, Vec<u8>>> {
    let names = || -> BTreeMap<String, u64> {
        let entries = fs::read_dir(watched).into_iter().flatten().flatten();
        entries.map(|entry| (entry.file_name().into_string().unwrap(), entry.ino())).collect()
    };
    let (mut last, mut seen) = (names(), 0);
    let mut run = Stepped::start(folder, &[&COMPENSATE, more].concat());
    let is_reached = run.run_until(|| {
        let now = names();
        seen += usize::from(now != last);
        last = now;
        seen == changes
    });
    is_reached.then(|| {
        run.kill();
        contents(watched)
    })
}

fn is_hidden(name: &str) -> bool {
    name.starts_with('.')
}

/// The next run says what is half done, and takes away what waited beside its place; what it says to do gives the originals back.
fn half_compensated_is_told_and_restored(
    bench: &Path,
    there: &BTreeMap<String, Vec<u8>>,
    originals: &BTreeMap<String, Vec<u8>>,
) {
    let output = compensate(bench, &["--in-place"]);
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
    assert!(
        !contents(&bench.join("cell")).keys().any(|name| is_hidden(name)),
        "files are left beside their places"
    );

    let restored = driftpost(bench, &["restore", "cell", "-o", "originals"]);
    assert!(restored.status.success(), "{}", String::from_utf8_lossy(&restored.stderr));
    assert_eq!(&contents(&bench.join("originals")), originals);
    fs::remove_dir_all(bench.join("originals")).unwrap();
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    /// Over an earlier result, new modules never stand beside the old clock nor old ones beside the new: until all are there, none is.
    #[test]
    #[ignore = "long"]
    fn modules_of_two_results_never_share_a_clock() {
        let bench = tempfile::tempdir().unwrap();
        let out = bench.path().join("out");
        let coarse = ["-o", "out", "--tolerance-mm", "0.05"];
        let result = |more: &[&str]| {
            let output = compensate(bench.path(), more);
            assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
            contents(&out)
        };
        program(&bench.path().join("cell"));
        let (old, new) = (result(&["-o", "out"]), result(&coarse));
        assert_ne!(old.get(CORE), new.get(CORE));
        let differing = |there: &BTreeMap<String, Vec<u8>>, than: &BTreeMap<String, Vec<u8>>| {
            than.iter().filter(|(name, bytes)| *name != CORE && there.get(*name) != Some(*bytes)).count()
        };
        let modules = differing(&old, &new);
        let mut exchanged = BTreeSet::new();
        for changes in 1.. {
            assert!(result(&["-o", "out"]) == old);
            let Some(there) = killed(bench.path(), &coarse, &out, changes) else { break };
            let (from_old, to_new) = (differing(&there, &old), differing(&there, &new));
            exchanged.insert(from_old);
            assert_eq!(from_old + to_new, modules, "each module is that of one of the two results");
            match there.get(CORE) {
                None => assert!(result(&coarse) == new, "the next run completes what was half done"),
                clock if clock == old.get(CORE) => {
                    assert_eq!(from_old, 0, "new modules beside the old clock");
                }
                clock => assert!(clock == new.get(CORE) && to_new == 0, "old modules beside the new clock"),
            }
        }
        assert!(exchanged.into_iter().eq(0..=modules), "a run is killed between any two modules");
    }

    /// In place, the common module comes first: whatever stands there loads, and what is corrected finds its clock.
    #[test]
    #[ignore = "long"]
    fn modules_that_are_exchanged_in_place_always_find_what_they_call() {
        let bench = tempfile::tempdir().unwrap();
        let cell = bench.path().join("cell");
        let original = || {
            drop(fs::remove_dir_all(&cell));
            program(&cell);
            contents(&cell)
        };
        let originals = original();
        assert!(compensate(bench.path(), &["--in-place"]).status.success());
        let corrected = contents(&cell);
        assert_eq!(corrected.len(), originals.len() + 1);
        // So many modules were changed at each moment at which a run was killed.
        let mut exchanged = BTreeSet::new();
        for changes in 1.. {
            assert!(original() == originals);
            let Some(there) = killed(bench.path(), &["--in-place"], &cell, changes) else { break };
            for (name, bytes) in there.iter().filter(|(name, _)| !is_hidden(name)) {
                let is_whole = corrected.get(name) == Some(bytes) || originals.get(name) == Some(bytes);
                assert!(is_whole, "{name} is neither the original nor the corrected module");
            }
            let is_changed = |name: &&String| there.get(*name) != originals.get(*name);
            let changed = originals.keys().filter(is_changed).count();
            exchanged.insert(changed);
            if changed > 0 {
                assert_eq!(there.get(CORE), corrected.get(CORE), "the module that all call comes first");
            }
            if (1..MODULES).contains(&changed) {
                half_compensated_is_told_and_restored(bench.path(), &there, &originals);
            }
        }
        assert!(exchanged.into_iter().eq(0..=MODULES), "a run is killed between any two modules");
    }
}
