//! Real RAPID: every file of the folder `DRIFTPOST_CORPUS` names (and of `../shared/robodk`, where it stands)
//! comes back byte for byte, and what was not understood is counted.

#![allow(clippy::unwrap_used, reason = "a test stops where a file cannot be read")]

use driftpost::diagnostic::{FileId, TextRange};
use driftpost::syntax::{SourceFile, walk};
use std::path::{Path, PathBuf};

fn folders() -> Vec<PathBuf> {
    let beside = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/robodk");
    let named = std::env::var_os("DRIFTPOST_CORPUS").map(PathBuf::from);
    named.into_iter().chain([beside]).filter(|f| f.is_dir()).collect()
}

fn files_below(folder: &Path, files: &mut Vec<PathBuf>) {
    let mut entries: Vec<_> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() { files_below(&path, files) } else { files.push(path) }
    }
}

#[test]
fn real_files_come_back_and_are_understood() {
    let folders = folders();
    if folders.is_empty() {
        println!("skipped: neither DRIFTPOST_CORPUS nor ../shared/robodk is there");
        return;
    }
    let mut paths = Vec::new();
    folders.iter().for_each(|f| files_below(f, &mut paths));
    let (mut opaque, mut warned) = (0, 0);
    for path in &paths {
        let bytes = std::fs::read(path).unwrap();
        let file = SourceFile::read(FileId(0), path.display().to_string(), bytes);
        let leaves = walk::leaves(&file.tree);
        assert_eq!(reprinted(&file.bytes, leaves.iter().map(|n| n.range)), file.bytes, "{}", file.path);
        let here: Vec<_> = leaves.iter().filter(|n| n.what == "opaque").collect();
        for node in &here {
            let text = String::from_utf8_lossy(file.text(node.range)).into_owned();
            let short: String = text.chars().take(120).collect();
            println!("{}:{}: opaque {short:?}", file.path, file.line(node.range));
        }
        for w in &file.warnings {
            println!("{}:{}: {w}", file.path, w.span.map_or(0, |s| file.line(s.range)));
        }
        opaque += here.len();
        warned += usize::from(!file.warnings.is_empty());
    }
    println!("{} files, {opaque} opaque nodes, {warned} files with warnings", paths.len());
}

/// The source again from its leaves and the gaps between them.
fn reprinted(source: &[u8], leaves: impl Iterator<Item = TextRange>) -> Vec<u8> {
    let mut out = Vec::new();
    let mut at = 0;
    for leaf in leaves {
        assert!(leaf.start >= at, "leaves overlap at byte {}", leaf.start);
        out.extend_from_slice(&source[at as usize..leaf.start as usize]);
        out.extend_from_slice(leaf.of(source));
        at = leaf.end;
    }
    out.extend_from_slice(&source[at as usize..]);
    out
}
