//! Every message code of the program stands in `docs/MESSAGES.md`, and every code there is one of the program's.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn sources(at: &Path, ending: &str, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(at).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() && name != "tests" {
            sources(&path, ending, found);
        } else if name.ends_with(ending) && name != "tests.rs" {
            found.push(path);
        }
    }
}

/// `area::what` in lower case with hyphens, alone between two `quote`s.
fn codes(text: &str, quote: char) -> BTreeSet<String> {
    let is_word =
        |w: &str| w.len() > 1 && w.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-');
    text.split(quote)
        .filter(|part| part.split_once("::").is_some_and(|(area, what)| is_word(area) && is_word(what)))
        .map(str::to_owned)
        .collect()
}

#[test]
fn every_code_is_documented_and_every_documented_code_exists() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = Vec::new();
    sources(&root.join("src"), ".rs", &mut files);
    sources(&root.join("crates"), ".rs", &mut files);
    sources(&root.join("python/src"), ".rs", &mut files);
    sources(&root.join("python/driftpost"), ".py", &mut files);
    let mut used = BTreeSet::new();
    for path in files {
        let text = fs::read_to_string(&path).unwrap();
        used.extend(codes(text.split("#[cfg(test)]\nmod ").next().unwrap(), '"'));
    }
    let page = fs::read_to_string(root.join("docs/MESSAGES.md")).unwrap();
    let rows = page.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next());
    let rows: Vec<String> = rows.map(str::to_owned).collect();
    assert!(rows.is_sorted_by(|a, b| a < b), "the rows are in order of code, each code once");
    let documented: BTreeSet<String> = rows.into_iter().collect();
    let missing: Vec<_> = used.difference(&documented).collect();
    let unknown: Vec<_> = documented.difference(&used).collect();
    assert!(used.len() > 50, "the search found only {} codes", used.len());
    assert!(missing.is_empty() && unknown.is_empty(), "not documented: {missing:?}\nnot used: {unknown:?}");
}
