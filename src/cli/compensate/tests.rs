//! What is made of a program in several files.

use super::*;
use crate::report::{ColorMode, write_messages};
use clap::{Args as _, FromArgMatches as _};
use rapid_compensation::emit::EmittedFile;
use rapid_program::Program;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

fn fixture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(name)
}

/// All that comes out, as text: files, review, table of joints, messages, JSON.
struct Out {
    files: BTreeMap<String, Vec<u8>>,
    texts: Vec<String>,
    messages: String,
    json: Value,
}

fn out(words: &[&str]) -> Out {
    let folder = fixture("parts");
    let words = [&["compensate"], words, &[folder.to_str().unwrap()]].concat();
    let command = Args::augment_args(clap::Command::new("compensate"));
    let args = Args::from_arg_matches(&command.try_get_matches_from(words).unwrap()).unwrap();
    let given = ProgramInput::read(&args.program).unwrap();
    let job = args.compensation(None).unwrap();
    let mut files: BTreeMap<String, Vec<u8>> = BTreeMap::new();
    let mut accept = |_: &Program, file: EmittedFile| {
        assert!(files.insert(file.path, file.bytes).is_none(), "each file is given once");
        Ok(())
    };
    let (mut json, mut texts, mut message_text) = (Vec::new(), Vec::new(), Vec::new());
    let messages = match job.run_each(&given.program(), &mut accept) {
        Ok(made) => {
            let (mut review, mut joints) = (Vec::new(), Vec::new());
            made.write_review(&mut review, args.all).unwrap();
            Compensated::write_joints(std::slice::from_ref(&made), &mut joints).unwrap();
            made.write_json(&mut json).unwrap();
            texts.extend([review, joints].map(|text| String::from_utf8(text).unwrap()));
            made.messages
        }
        Err(refusal) => {
            refusal.write_json(&mut json).unwrap();
            refusal.messages
        }
    };
    write_messages(&mut message_text, &messages, ColorMode::Plain, true).unwrap();
    let (messages, json) = (String::from_utf8(message_text).unwrap(), serde_json::from_slice(&json).unwrap());
    Out { files, texts, messages, json }
}

#[test]
fn pages_are_made_with_one_common_module() {
    let schedule = out(&["--form", "schedule"]);
    assert_eq!(schedule.files.len(), 6, "A, B, C, D, Main and the common module");
    assert!(schedule.messages.contains("reach::none"));
    let ramp = out(&["--form", "ramp", "--all", "--clock", "elapsed"]);
    assert_eq!(ramp.files.len(), 6);
    assert_eq!(ramp.json["motions"].as_array().unwrap().len(), 57);
    assert_eq!(ramp.json["buckets"], Value::Array(Vec::new()));
    // A row for each of the targets that the table's header and the JSON count, at every minute.
    let compensated = |motion: &&Value| motion["status"] == "compensated";
    let count = ramp.json["motions"].as_array().unwrap().iter().filter(compensated).count();
    let minutes = ramp.json["until_min"].as_f64().unwrap().floor() as usize + 1;
    assert_eq!(ramp.texts[1].lines().count(), 1 + count * minutes);
    assert_eq!(ramp.texts[0].lines().filter(|line| line.contains(".mod:")).count(), 57);
}

#[test]
fn what_is_refused_gives_no_file_and_says_why() {
    let strict = out(&["--strict"]);
    assert!(strict.files.is_empty() && !strict.json["errors"].as_array().unwrap().is_empty());
    let one_module = out(&["--core", "embedded"]);
    assert!(one_module.files.is_empty() && one_module.messages.contains("emit::embedded-in-several"));
    let out_of_reach = out(&["--robot", "irb6700"]);
    assert!(!out_of_reach.messages.is_empty());
}

/// A pipe gives its bytes once.
#[cfg(unix)]
#[test]
fn a_program_is_read_from_a_pipe() {
    let folder = tempfile::tempdir().unwrap();
    let pipe = folder.path().join("A.mod");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status().unwrap();
    assert!(made.success());
    let bytes = std::fs::read(fixture("parts").join("A.mod")).unwrap();
    let (to, sent) = (pipe.clone(), bytes.clone());
    let writer = std::thread::spawn(move || std::fs::write(to, sent).unwrap());
    let given = ProgramInput::read(&[pipe, fixture("parts").join("Main.mod")]).unwrap();
    writer.join().unwrap();
    assert_eq!(&*given.bytes[0], bytes.as_slice());
}
