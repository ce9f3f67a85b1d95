//! Functions are short: each step has a name. What is longer stands in a list, with the reason why it is better in one piece.

use crate::architecture::{files_of_members, root};
use std::collections::BTreeSet;
use std::fs;

/// The longest function of the command line and of the application: its steps are to be read as a table of contents.
const MOST_LINES: usize = 50;

/// The longest function of the crates.
const MOST_LINES_IN_CRATES: usize = 60;

/// Functions of the crates that are longer, each with its reason.
const LONGER: [(&str, &str, &str); 1] = [(
    "robot-model/src/kinematics/eight_branches.rs",
    "joints",
    "formulas of a closed form, each of which goes on with the sines and cosines of the one before",
)];

/// Each function of a text with its number of lines; a function ends at the brace that is indented as it is.
fn function_lengths(text: &str) -> Vec<(String, usize)> {
    let lines: Vec<&str> = text.lines().collect();
    let mut found = Vec::new();
    for (at, line) in lines.iter().enumerate() {
        let indent = line.len() - line.trim_start().len();
        let Some((before, rest)) = line.trim_start().split_once("fn ") else { continue };
        let is_qualifier = |word: &str| {
            word.starts_with("pub") || word.starts_with("in") || ["const", "unsafe"].contains(&word)
        };
        if !before.split_whitespace().all(is_qualifier) {
            continue;
        }
        let name = rest.split(['(', '<']).next().unwrap_or_default().to_owned();
        let is_end = |line: &&str| {
            let trimmed = line.trim_start();
            trimmed.starts_with('}') && line.len() - trimmed.len() == indent
        };
        let length = lines[at..].iter().position(is_end).map_or(1, |n| n + 1);
        found.push((name, if line.ends_with('}') { 1 } else { length }));
    }
    found
}

#[test]
fn commands_read_as_tables_of_contents_and_put_no_json_together() {
    let (mut long, mut with_json, mut seen) = (Vec::new(), Vec::new(), 0);
    for folder in ["src/cli", "src/application"] {
        let mut open = vec![root().join(folder)];
        while let Some(path) = open.pop() {
            if path.is_dir() {
                open.extend(fs::read_dir(&path).unwrap().map(|entry| entry.unwrap().path()));
                continue;
            }
            let text = fs::read_to_string(&path).unwrap();
            let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
            let lengths = function_lengths(text);
            seen += lengths.len();
            let name = |function: &str| format!("{}: {function}", path.display());
            long.extend(lengths.iter().filter(|f| f.1 > MOST_LINES).map(|f| (name(&f.0), f.1)));
            if folder == "src/cli" && text.contains("json!(") {
                with_json.push(path.display().to_string());
            }
        }
    }
    assert!(seen > 300, "the search found only {seen} functions");
    assert!(long.is_empty(), "steps of these want names of their own: {long:?}");
    assert!(with_json.is_empty(), "JSON is put together in the library: {with_json:?}");
}

#[test]
fn functions_of_the_crates_are_short_or_have_their_reason() {
    let (mut long, mut seen) = (BTreeSet::new(), 0);
    for file in files_of_members() {
        let text = fs::read_to_string(&file).unwrap();
        let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
        let lengths = function_lengths(text);
        seen += lengths.len();
        let path = file.strip_prefix(root().join("crates")).unwrap();
        let path = path.to_string_lossy().replace('\\', "/");
        long.extend(lengths.into_iter().filter(|f| f.1 > MOST_LINES_IN_CRATES).map(|f| (path.clone(), f.0)));
    }
    assert!(seen > 2000, "the search found only {seen} functions");
    let known: BTreeSet<_> =
        LONGER.iter().map(|(path, name, _)| ((*path).to_owned(), (*name).to_owned())).collect();
    let unknown: Vec<_> = long.difference(&known).collect();
    assert!(unknown.is_empty(), "steps of these want names of their own: {unknown:?}");
    let short: Vec<_> = known.difference(&long).collect();
    assert!(short.is_empty(), "these are no longer too long, or are gone, and leave the list: {short:?}");
}

#[test]
fn the_length_of_a_function_is_that_of_its_lines() {
    let text = "fn one() {}\nimpl X {\n    pub(super) fn two(\n        &self,\n    ) -> bool {\n        true\n    }\n}\nlet fn_ = 1;\n";
    assert_eq!(function_lengths(text), [("one".to_owned(), 1), ("two".to_owned(), 5)]);
}
