//! A module uses only what stands to its left; factors between units stand in `units` alone.

#![allow(clippy::unwrap_used)] // a test that cannot read the source may well panic

use std::fs;
use std::path::{Path, PathBuf};

const ORDER: [&str; 16] = [
    "units",
    "diagnostic",
    "syntax",
    "program",
    "robot",
    "kinematics",
    "deform",
    "schedule",
    "compensate",
    "emit",
    "simulate",
    "measure",
    "diagnose",
    "plan",
    "exam",
    "report",
];

/// `cli` is the last; it is not a module that another may use.
fn position(module: &str) -> Option<usize> {
    ORDER.iter().chain(["cli"].iter()).position(|m| *m == module)
}

/// Every `.rs` file of a module, in order of path.
fn files_of(module: &str) -> Vec<PathBuf> {
    fn walk(at: &Path, found: &mut Vec<PathBuf>) {
        let mut entries: Vec<PathBuf> = fs::read_dir(at).unwrap().map(|e| e.unwrap().path()).collect();
        entries.sort();
        for entry in entries {
            if entry.is_dir() {
                walk(&entry, found);
            } else if entry.extension().is_some_and(|e| e == "rs") {
                found.push(entry);
            }
        }
    }
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = Vec::new();
    let single = src.join(format!("{module}.rs"));
    if single.exists() {
        found.push(single);
    }
    if src.join(module).is_dir() {
        walk(&src.join(module), &mut found);
    }
    found
}

/// The code of a file without its comments (a doc link is not a use) and without what strings hold.
fn code(text: &str) -> String {
    text.lines().map(|line| line.split("//").next().unwrap_or("")).collect::<Vec<_>>().join("\n")
}

/// The identifiers that directly follow `prefix`, those of a `{...}` group included.
fn names_after(code: &str, prefix: &str) -> Vec<String> {
    let ident = |s: &str| s.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>();
    let mut names = Vec::new();
    for (at, _) in code.match_indices(prefix) {
        let before = code[..at].chars().next_back();
        if before.is_some_and(|c| c.is_alphanumeric() || c == '_') {
            continue;
        }
        let rest = &code[at + prefix.len()..];
        let Some(group) = rest.strip_prefix('{') else {
            names.push(ident(rest));
            continue;
        };
        let (mut depth, mut item) = (1, String::new());
        for c in group.chars() {
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                ',' if depth == 1 => names.push(ident(std::mem::take(&mut item).trim_start())),
                _ => {}
            }
            if depth == 0 {
                names.push(ident(item.trim_start()));
                break;
            }
            if depth == 1 && c != ',' {
                item.push(c);
            }
        }
    }
    names
}

/// The top-level modules a file uses: `crate::x`, and `super::x` that leaves the module.
fn uses(path: &Path, own: &str) -> Vec<String> {
    let code = code(&fs::read_to_string(path).unwrap());
    let mut used = names_after(&code, "crate::");
    used.extend(names_after(&code, "driftpost::"));
    let home = Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(own);
    for name in names_after(&code, "super::") {
        let local = home.join(format!("{name}.rs")).exists() || home.join(&name).is_dir();
        if position(&name).is_some() && name != own && !local {
            used.push(name);
        }
    }
    used.retain(|name| position(name).is_some() && name != own);
    used
}

#[test]
fn a_module_uses_only_what_stands_to_its_left() {
    let mut wrong = Vec::new();
    for module in ORDER.iter().chain(["cli"].iter()) {
        for path in files_of(module) {
            for used in uses(&path, module) {
                if position(&used) > position(module) {
                    wrong.push(format!("{}: `{module}` uses `{used}`", path.display()));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "the order is {ORDER:?}, cli:\n{}", wrong.join("\n"));
}

/// What executes a program must not be led by what wrote it: the two have this in common and nothing else.
#[test]
fn interpreter_and_emitter_share_reading_and_the_arm_alone() {
    const SHARED: [&str; 6] = ["units", "diagnostic", "syntax", "robot", "kinematics", "deform"];
    let mut wrong = Vec::new();
    let mut seen = 0;
    for path in files_of("simulate") {
        let used = uses(&path, "simulate");
        seen += used.len();
        wrong.extend(
            used.iter()
                .filter(|used| !SHARED.contains(&used.as_str()))
                .map(|u| format!("{}: {u}", path.display())),
        );
    }
    assert!(seen > 10 && wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(files_of("emit").iter().all(|path| !uses(path, "emit").contains(&"simulate".to_owned())));
}

#[test]
fn every_module_stands_in_the_order() {
    let lib = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lib.rs")).unwrap();
    let declared: Vec<&str> = code_lines(&lib)
        .filter_map(|line| line.trim_start_matches("pub ").strip_prefix("mod ")?.strip_suffix(';'))
        .collect();
    let positions: Vec<usize> = declared
        .iter()
        .map(|m| position(m).unwrap_or_else(|| panic!("`{m}` has no place in the order of modules")))
        .collect();
    assert!(positions.len() > 5 && positions.is_sorted(), "lib.rs declares {declared:?}");
}

fn code_lines(text: &str) -> impl Iterator<Item = &str> {
    text.lines().map(str::trim).filter(|l| !l.starts_with("//"))
}

/// Ways to write a conversion between mm and m, or degrees and radians.
const WORDS: [&str; 6] = ["to_radians", "to_degrees", "* 1000.0", "/ 1000.0", "180.0 /", "/ 180.0"];

#[test]
fn conversion_factors_stand_in_units_alone() {
    let mut wrong = Vec::new();
    for module in ORDER.iter().chain(["cli"].iter()).filter(|m| **m != "units") {
        for path in files_of(module) {
            if path.components().any(|part| ["tests", "tests.rs"].iter().any(|t| part.as_os_str() == *t)) {
                continue;
            }
            let text = fs::read_to_string(&path).unwrap();
            let product = text.split("#[cfg(test)]").next().unwrap_or("");
            for word in WORDS {
                if code(product).contains(word) {
                    wrong.push(format!("{} holds `{word}`: use crate::units", path.display()));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_reader_of_uses_sees_groups_and_ignores_comments() {
    let text = "use crate::{a::B, c::{d, e}, f};\n// use crate::g;\nlet x = crate::h::i();";
    assert_eq!(names_after(&code(text), "crate::"), ["a", "c", "f", "h"]);
}
