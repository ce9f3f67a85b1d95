//! `grammar/rapid.ebnf` and the parser's functions say the same: one function per production, named as
//! there, the production in its doc comment.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Words of the grammar that its head explains.
const LETTERS: [&str; 3] = ["letter", "digit", "capital"];

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// Name and text of each production of the grammar, one blank between symbols.
fn productions() -> BTreeMap<String, String> {
    let text = read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("grammar/rapid.ebnf"));
    let mut blocks: Vec<String> = Vec::new();
    let mut in_comment = false;
    for line in text.lines() {
        in_comment |= line.starts_with("(*");
        if !in_comment && line.starts_with(|c: char| c.is_ascii_lowercase()) {
            blocks.push(line.to_owned());
        } else if !in_comment && !line.is_empty() {
            let last = blocks.last_mut().expect("a production goes on");
            last.push(' ');
            last.push_str(line.trim());
        }
        in_comment &= !line.ends_with("*)");
    }
    named(blocks)
}

/// Name and text of each production in a doc comment, with a function of that name below it.
fn documented() -> BTreeMap<String, String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("crates/rapid-syntax/src");
    let mut blocks = Vec::new();
    for entry in std::fs::read_dir(folder).expect("the sources") {
        let path = entry.expect("a source").path();
        if path.is_dir() {
            continue; // the parts of the tree: no productions
        }
        let text = read(&path);
        let lines: Vec<&str> = text.lines().collect();
        for (n, line) in lines.iter().enumerate() {
            let Some(production) = line.strip_prefix("/// `").and_then(|l| l.strip_suffix(" ;`")) else {
                continue;
            };
            let Some((name, _)) = production.split_once(" = ") else { continue };
            let below =
                lines[n..].iter().find(|l| !l.starts_with("///") && !l.starts_with('#')).unwrap_or(&"");
            let function = below.split("fn ").nth(1).and_then(|f| f.split(['<', '(']).next());
            assert_eq!(function, Some(name), "the function below the production {name}");
            blocks.push(format!("{production} ;"));
        }
    }
    named(blocks)
}

fn named(blocks: Vec<String>) -> BTreeMap<String, String> {
    let count = blocks.len();
    let split = |b: String| b.split_once(" = ").map(|(name, _)| (name.to_owned(), b.clone()));
    let named: BTreeMap<_, _> = blocks.into_iter().filter_map(split).collect();
    assert_eq!(named.len(), count, "two productions have one name, or one has none");
    named
}

#[test]
fn every_production_is_a_function_and_every_function_a_production() {
    let (grammar, code) = (productions(), documented());
    assert!(grammar.len() > 40);
    for (name, text) in &grammar {
        assert_eq!(Some(text), code.get(name), "in the grammar (left) and in the code (right)");
    }
    let extra: Vec<_> = code.keys().filter(|name| !grammar.contains_key(*name)).collect();
    assert!(extra.is_empty(), "in the code alone: {extra:?}");
}

#[test]
fn every_name_in_a_production_is_one() {
    let grammar = productions();
    let mut used = BTreeSet::new();
    for text in grammar.values() {
        let body = text.split_once(" = ").map_or("", |(_, body)| body);
        let mut special = false;
        for symbol in body.split(' ') {
            special ^= symbol == "?";
            if !special && symbol.starts_with(|c: char| c.is_ascii_lowercase()) {
                used.insert(symbol);
            }
        }
    }
    let unknown: Vec<_> =
        used.iter().filter(|u| !grammar.contains_key(**u) && !LETTERS.contains(u)).collect();
    assert!(unknown.is_empty(), "used but not defined: {unknown:?}");
    let lost: Vec<_> = grammar.keys().filter(|n| !used.contains(n.as_str())).collect();
    assert_eq!(lost, ["blank", "file", "word"], "defined but not used");
}
