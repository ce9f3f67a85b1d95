//! A program made part by part is the program made at once.

use super::*;
use crate::report::{Look, write_messages};
use clap::{Args as _, FromArgMatches as _};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::PathBuf;

fn fixture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(name)
}

fn args(words: &[&str]) -> Args {
    let command = Args::augment_args(clap::Command::new("compensate"));
    let words = ["compensate"].iter().chain(words);
    Args::from_arg_matches(&command.try_get_matches_from(words).unwrap()).unwrap()
}

/// All that comes out, as text: files, review, messages, table of joints, JSON; and whether it was made in parts.
#[derive(Debug, PartialEq)]
struct Out {
    files: BTreeMap<String, Vec<u8>>,
    texts: Vec<String>,
    json: Value,
}

fn out(words: &[&str], folder: &str, part_bytes: usize) -> (Out, bool) {
    let folder = fixture(folder);
    let words = [words, &[folder.to_str().unwrap()]].concat();
    let args = args(&words);
    let given = Given::read_up_to(&args.program, part_bytes).unwrap();
    let job = Job::new(&args).unwrap();
    let mut files: BTreeMap<String, Vec<u8>> = BTreeMap::new();
    let mut take = |_: &Program, file: EmittedFile| {
        files.entry(file.path).or_default().extend(file.bytes);
        Ok(())
    };
    let (mut json, mut said) = (Vec::new(), Vec::new());
    let mut texts = Vec::new();
    match job.make(&given, args.all, &mut take) {
        Ok(mut made) => {
            let (mut review, mut joints) = (Vec::new(), Vec::new());
            made.write_review(&mut review).unwrap();
            made.write_joints(&mut joints).unwrap();
            made.write_json(&mut json).unwrap();
            texts.extend([review, joints].map(|text| String::from_utf8(text).unwrap()));
            texts.push(format!("{:?}", made.about_size()));
            texts.push(format!("{:?}", made.about_core()));
            write_messages(&mut said, &made.messages, Look::Plain, true).unwrap();
        }
        Err(refusal) => {
            refusal.write_json(&mut json).unwrap();
            write_messages(&mut said, &refusal.messages, Look::Plain, true).unwrap();
        }
    }
    texts.push(String::from_utf8(said).unwrap());
    (Out { files, texts, json: serde_json::from_slice(&json).unwrap() }, given.is_large())
}

/// The figure of the rival, which is found from a few points of each part, set to that of the whole; it is near it.
fn with_rival_of(mut parts: Out, whole: &Out) -> Out {
    let key = "rigid_shift_worst_mm";
    if let (Some(found), Some(expected)) = (parts.json[key].as_f64(), whole.json[key].as_f64()) {
        assert!((found / expected - 1.0).abs() < 0.02, "{found} {expected}");
        parts.json[key] = whole.json[key].clone();
        let spelled = |mm: f64| format!("{mm:.4} mm with one");
        parts.texts[0] = parts.texts[0].replace(&spelled(found), &spelled(expected));
    }
    parts
}

fn same(words: &[&str], folder: &str) -> Out {
    let (whole, large) = out(words, folder, usize::MAX);
    assert!(!large);
    let (parts, large) = out(words, folder, 1);
    assert!(large);
    let parts = with_rival_of(parts, &whole);
    for (found, expected) in parts.texts.iter().zip(&whole.texts) {
        assert_eq!(found, expected);
    }
    assert_eq!(parts.json, whole.json);
    assert_eq!(parts.files.keys().collect::<Vec<_>>(), whole.files.keys().collect::<Vec<_>>());
    for (path, bytes) in &parts.files {
        let texts = [bytes, &whole.files[path]].map(|bytes| String::from_utf8_lossy(bytes).into_owned());
        assert_eq!(texts[0], texts[1], "{path}");
    }
    whole
}

#[test]
fn what_comes_out_does_not_depend_on_the_parts() {
    let schedule = same(&["--form", "schedule"], "parts");
    assert_eq!(schedule.files.len(), 5, "A, B, C, Main and the common module");
    assert!(schedule.texts.last().unwrap().contains("keep::configuration"));
    let ramp = same(&["--form", "ramp", "--all", "--clock", "elapsed"], "parts");
    assert_eq!(ramp.files.len(), 5);
    assert_eq!(ramp.json["motions"].as_array().unwrap().len(), 57);
    assert_eq!(ramp.json["buckets"], Value::Array(Vec::new()));
    same(&["--tolerance-mm", "0.02"], "golden/pages/source");
}

#[test]
fn what_is_refused_is_refused_whatever_the_parts() {
    let strict = same(&["--strict"], "parts");
    assert!(strict.files.is_empty() && !strict.json["errors"].as_array().unwrap().is_empty());
    let one_module = same(&["--core", "embedded"], "parts");
    assert!(one_module.files.is_empty());
    let out_of_reach = same(&["--robot", "irb6700"], "parts");
    assert!(!out_of_reach.texts.last().unwrap().is_empty());
}

#[test]
fn a_file_that_changes_between_the_parts_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["A.mod", "B.mod", "C.mod", "D.mod", "Main.mod"] {
        std::fs::copy(fixture("parts").join(name), folder.path().join(name)).unwrap();
    }
    let given = Given::read_up_to(&[folder.path().to_path_buf()], 1).unwrap();
    std::fs::write(folder.path().join("C.mod"), "MODULE C\nENDMODULE\n").unwrap();
    let args = args(&[folder.path().to_str().unwrap()]);
    let job = Job::new(&args).unwrap();
    let refusal = job.make(&given, false, &mut |_, _| panic!("nothing is emitted")).err().unwrap();
    assert_eq!(refusal.messages[0].diagnostic.code, "input::changed");
}

/// A pipe gives its bytes once: they are held, however many there are.
#[cfg(unix)]
#[test]
fn a_pipe_is_not_read_again() {
    let folder = tempfile::tempdir().unwrap();
    let pipe = folder.path().join("A.mod");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status().unwrap();
    assert!(made.success());
    let bytes = std::fs::read(fixture("parts").join("A.mod")).unwrap();
    let (to, sent) = (pipe.clone(), bytes.clone());
    let writer = std::thread::spawn(move || std::fs::write(to, sent).unwrap());
    let given = Given::read_up_to(&[pipe, fixture("parts").join("Main.mod")], 1).unwrap();
    writer.join().unwrap();
    assert!(!given.is_large());
    assert_eq!(&*given.content(0).unwrap(), bytes.as_slice());
}
