//! The command line as scripts rely on it: exit codes, what is written where, and every refusal.

mod asked_by_hand;
mod asked_names;
mod bad_input;
mod changed_by_hand;
mod clock_calls;
mod compensate;
mod cooling;
mod diff;
mod elements;
mod kept_apart;
mod kept_by_name;
mod left_over;
mod other_robots;
mod outputs;
mod put_in;
mod refusals;
mod restored;
mod restored_programs;
mod reviewing;
mod robots;
mod settings;
mod shell;
mod tasks;
mod touched_elements;
mod typos;
mod written;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

pub const CUBE: &str = "fixtures/robodk/irc5/Cube45.mod";

/// A folder of its own, and the program run in the checkout.
pub struct Bench {
    folder: tempfile::TempDir,
}

impl Default for Bench {
    fn default() -> Self {
        Self { folder: tempfile::tempdir().unwrap() }
    }
}

impl Bench {
    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// A file of the bench with these bytes.
    pub fn file(&self, name: &str, bytes: impl AsRef<[u8]>) -> String {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, bytes).unwrap();
        path.display().to_string()
    }

    pub fn text(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    /// All files of the bench, by name.
    pub fn files(&self) -> Vec<String> {
        fn walk(at: &Path, root: &Path, found: &mut Vec<String>) {
            for entry in fs::read_dir(at).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    walk(&path, root, found);
                } else {
                    found.push(path.strip_prefix(root).unwrap().display().to_string());
                }
            }
        }
        let mut found = Vec::new();
        walk(self.folder.path(), self.folder.path(), &mut found);
        found.sort();
        found
    }
}

/// Runs the program in the checkout's root.
pub fn driftpost(arguments: &[&str]) -> Output {
    let mut command = assert_cmd::Command::cargo_bin("driftpost").unwrap();
    command.current_dir(env!("CARGO_MANIFEST_DIR")).args(arguments).output().unwrap()
}

pub fn out(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

pub fn err(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}
