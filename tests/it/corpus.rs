//! Real RAPID comes back byte for byte, its moves are read, and what was not understood is shown.

use crate::folders;
use rapid_syntax::diagnostic::FileId;
use rapid_syntax::tree::{FileItem, ModuleItem};
use rapid_syntax::{SourceFile, walk};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

#[test]
fn fixtures_come_back_and_are_understood() {
    let (moves, opaque) = check(&folders::modules_below(&folders::fixtures()));
    assert!(moves > 400, "{moves} moves");
    assert!(opaque < 20, "{opaque} opaque nodes");
}

#[test]
#[ignore = "needs a folder of RAPID programs in DRIFTPOST_CORPUS"]
fn real_files_come_back_and_are_understood() {
    let (moves, _) = check(&folders::files_below(&folders::corpus()));
    assert!(moves > 0);
}

/// Each file alone, and all of each folder, in three forms; what is written is given back from its files alone.
#[test]
#[ignore = "needs a folder of RAPID programs in DRIFTPOST_CORPUS"]
fn every_result_is_restored_byte_for_byte() {
    let mut programs: Vec<Vec<PathBuf>> = Vec::new();
    let mut folders: BTreeMap<PathBuf, Vec<PathBuf>> = BTreeMap::new();
    for path in folders::modules_below(&folders::corpus()) {
        folders.entry(path.parent().unwrap().to_owned()).or_default().push(path.clone());
        programs.push(vec![path]);
    }
    programs.extend(folders.into_values().filter(|files| files.len() > 1));
    for form in ["schedule", "ramp", "auto"] {
        let (mut results, mut changed) = (0, 0);
        for files in &programs {
            let bench = tempfile::tempdir().unwrap();
            let [emitted, restored] = ["emitted", "restored"].map(|name| bench.path().join(name));
            let options = ["--form", form, "--allow-other-robot", "--quiet", "--diff", "none"];
            let code = driftpost("compensate", files, &emitted, &options);
            assert!(matches!(code, Some(0..=2)), "{files:?}: {code:?}");
            if !emitted.is_dir() {
                continue;
            }
            results += 1;
            let written = folders::files_below(&emitted);
            let given = if files.len() > 1 { std::slice::from_ref(&emitted) } else { &written };
            assert_eq!(driftpost("restore", given, &restored, &["--quiet"]), Some(0), "{files:?}");
            let sources: Vec<Vec<u8>> = files.iter().map(|file| std::fs::read(file).unwrap()).collect();
            for (file, source) in files.iter().zip(&sources) {
                let back = std::fs::read(restored.join(file.file_name().unwrap())).unwrap();
                assert!(back == *source, "{}", file.display());
            }
            changed += written.iter().filter(|file| !sources.contains(&std::fs::read(file).unwrap())).count();
        }
        println!("{form}: {results} results, {changed} changed modules, each restored");
        assert!(changed > 0);
    }
}

fn driftpost(command: &str, files: &[PathBuf], folder: &Path, options: &[&str]) -> Option<i32> {
    let mut run = Command::new(env!("CARGO_BIN_EXE_driftpost"));
    run.arg(command).args(files).arg("-o").arg(folder.join("")).args(options);
    run.output().unwrap().status.code()
}

/// Number of moves and of places that were not understood.
fn check(paths: &[PathBuf]) -> (usize, usize) {
    let (mut opaque, mut warned, mut moves) = (0, 0, 0);
    for path in paths {
        let file = SourceFile::read(FileId(0), path.display().to_string(), std::fs::read(path).unwrap());
        crate::tree_check::check(&file.bytes).unwrap_or_else(|e| panic!("{}: {e}", file.path));
        let unread = print_unread(&file);
        if unread == 0 || file.bytes.windows(6).any(|w| w == b"RoboDK") {
            assert_eq!(moves_read(&file), moves_seen(&file), "{}", file.path);
        }
        moves += moves_read(&file);
        opaque += unread;
        warned += usize::from(!file.warnings.is_empty());
    }
    println!("{} files, {moves} moves, {opaque} opaque nodes, {warned} files with warnings", paths.len());
    (moves, opaque)
}

fn print_unread(file: &SourceFile) -> usize {
    let unread: Vec<_> = walk::leaves(&file.tree).into_iter().filter(|n| n.what == "opaque").collect();
    for node in &unread {
        let text: String = String::from_utf8_lossy(file.text(node.range)).chars().take(120).collect();
        println!("{}:{}: opaque {text:?}", file.path, file.line(node.range));
    }
    for w in &file.warnings {
        println!("{}:{}: {w}", file.path, w.span.map_or(0, |s| file.line(s.range)));
    }
    unread.len()
}

const MOVES: [&[u8]; 4] = [b"movel", b"movej", b"movec", b"moveabsj"];

/// Lines of the modules that begin with a move, by their text alone.
fn moves_seen(file: &SourceFile) -> usize {
    let in_routine = |at: u32| {
        file.tree.items.iter().any(|item| match item {
            FileItem::Module(m) => m.items.iter().any(|i| {
                matches!(i, ModuleItem::Routine(_)) && (i.range().start..i.range().end).contains(&at)
            }),
            _ => false,
        })
    };
    let mut at = 0;
    let mut seen = 0;
    for line in file.bytes.split_inclusive(|&b| b == b'\n' || b == b'\r') {
        let text = line.trim_ascii_start().to_ascii_lowercase();
        let word = text.split(|b| !b.is_ascii_alphanumeric() && *b != b'_').next().unwrap_or_default();
        let after = text.get(word.len()).copied();
        seen += usize::from(
            MOVES.contains(&word) && matches!(after, Some(b' ' | b'\t' | b'\\')) && in_routine(at),
        );
        at += line.len() as u32;
    }
    seen
}

/// Calls of the tree that begin a line and name a move.
fn moves_read(file: &SourceFile) -> usize {
    let nodes = walk::nodes(&file.tree);
    let begins_line = |at: u32| {
        let before = &file.bytes[..at as usize];
        let blanks = before.iter().rev().take_while(|b| **b == b' ' || **b == b'\t').count();
        before[..before.len() - blanks].last().is_none_or(|b| *b == b'\n' || *b == b'\r')
    };
    nodes
        .windows(2)
        .filter(|w| {
            w[0].what == "call" && w[0].range.start == w[1].range.start && begins_line(w[0].range.start)
        })
        .filter(|w| MOVES.contains(&&*file.text(w[1].range).to_ascii_lowercase()))
        .count()
}
