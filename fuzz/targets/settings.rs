//! Any file of settings is taken or refused.

#![allow(clippy::expect_used, reason = "a target stops where its promise is broken")]

use driftpost::command_line::{Outcome, run_captured};
use std::ffi::OsString;
use std::fs;
use std::sync::LazyLock;

/// A file of this process's own, which each execution writes anew.
static FILE: LazyLock<OsString> = LazyLock::new(|| {
    std::env::temp_dir().join(format!("driftpost-settings-{}.toml", std::process::id())).into()
});

/// `driftpost.toml` of a command: shown as settings, or refused with an error that names the file.
pub fn settings(data: &[u8]) {
    fs::write(&*FILE, data).expect("a temporary file can be written");
    for command in [["compensate", "none.mod"], ["diagnose", "none.csv"]] {
        let words = command.map(OsString::from).into_iter();
        let asked = ["--show-settings", "--settings"].map(OsString::from);
        let words: Vec<OsString> =
            ["driftpost".into()].into_iter().chain(words).chain(asked).chain([FILE.clone()]).collect();
        let shown = run_captured(&words);
        match shown.outcome {
            Outcome::Done => assert!(!shown.output.is_empty(), "nothing is shown"),
            Outcome::Refused => {
                let messages = String::from_utf8_lossy(&shown.messages);
                assert!(messages.contains("error"), "refused without a reason: {messages}");
            }
            Outcome::Difference => panic!("settings make no difference"),
        }
    }
    drop(fs::remove_file(&*FILE));
}
