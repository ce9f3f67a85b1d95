//! Every command of the front page and of the documentation, run as it would be pasted, on the files of `fixtures/docs`.
//!
//! A block is run where its fence says `sh` and nothing more; `sh slow` and `sh data` mark what takes hours or files of others.

use rayon::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The commands of a page, continued lines put together, block by block.
fn commands(page: &Path) -> Vec<String> {
    let text = fs::read_to_string(page).unwrap();
    let mut found: Vec<String> = Vec::new();
    let (mut is_inside, mut goes_on) = (false, false);
    for line in text.lines() {
        if line.starts_with("```") {
            is_inside = line == "```sh";
        } else if is_inside && !line.trim().is_empty() {
            match found.last_mut().filter(|_| goes_on) {
                Some(last) => last.push_str(line.trim_end_matches('\\')),
                None => found.push(line.trim_end_matches('\\').to_owned()),
            }
            goes_on = line.ends_with('\\');
        }
    }
    found
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let path = entry.unwrap().path();
        let place = to.join(path.file_name().unwrap());
        if path.is_dir() {
            copy(&path, &place);
        } else {
            fs::copy(&path, &place).unwrap();
        }
    }
}

fn pages() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let docs = fs::read_dir(root.join("docs")).unwrap().map(|entry| entry.unwrap().path());
    let mut pages: Vec<PathBuf> = docs.filter(|path| path.extension().is_some_and(|e| e == "md")).collect();
    pages.sort();
    pages.insert(0, root.join("README.md"));
    pages
}

/// A page that names a command must name one that there is.
#[test]
fn every_command_that_is_named_is_there() {
    let help = Command::new(env!("CARGO_BIN_EXE_driftpost")).arg("--help").output().unwrap();
    let help = String::from_utf8_lossy(&help.stdout).into_owned();
    let known: Vec<&str> = help
        .lines()
        .skip_while(|line| !line.starts_with("Commands:"))
        .filter_map(|line| {
            line.strip_prefix("  ").filter(|rest| !rest.starts_with(' '))?.split_whitespace().next()
        })
        .collect();
    assert!(known.len() > 14, "{known:?}");
    for page in pages() {
        for word in fs::read_to_string(&page).unwrap().split("driftpost ").skip(1) {
            let name: String = word.chars().take_while(|c| c.is_ascii_lowercase() || *c == '-').collect();
            let is_command =
                name.len() > 2 && word[name.len()..].starts_with(' ') && known.contains(&name.as_str());
            let is_old = ["changed", "rehearse"].contains(&name.as_str());
            assert!(is_command || !is_old, "{}: driftpost {name}", page.display());
        }
    }
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[cfg(unix)]
    #[test]
    #[ignore = "long"]
    fn every_command_of_the_documentation_runs_as_pasted() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let bench = tempfile::tempdir().unwrap();
        // `driftpost` as installed, and `cargo run --release --` as the same; what cargo tests is tested already.
        let tools = bench.path().join("bin");
        fs::create_dir(&tools).unwrap();
        let binary = env!("CARGO_BIN_EXE_driftpost");
        symlink(binary, tools.join("driftpost")).unwrap();
        let cargo = format!("#!/bin/sh\n[ \"$1\" = run ] || exit 0\nshift 3\nexec {binary} \"$@\"\n");
        fs::write(tools.join("cargo"), cargo).unwrap();
        fs::set_permissions(tools.join("cargo"), fs::Permissions::from_mode(0o755)).unwrap();
        let path = format!("{}:{}", tools.display(), std::env::var("PATH").unwrap());
        let run = |page: &Path, folder: &Path, command: &str| {
            let mut shell = Command::new("sh");
            let output = shell.args(["-c", command]).current_dir(folder).env("PATH", &path).output().unwrap();
            let message = String::from_utf8_lossy(&output.stderr);
            assert!(matches!(output.status.code(), Some(0 | 1)), "{}: {command}\n{message}", page.display());
        };
        let run = &run;
        // Pages know nothing of each other: each has a folder of its own. Commands against a double have one of their own, and wait for the
        // client's pace between two requests: they do so beside what follows them.
        let pages = pages();
        let run: usize = std::thread::scope(|scope| {
            let run_page = |page: &PathBuf| {
                let folder = bench.path().join(page.file_stem().unwrap());
                copy(&root.join("fixtures/docs"), &folder);
                symlink(root.join("fixtures"), folder.join("fixtures")).unwrap();
                let commands = commands(page);
                let count = commands.len();
                for command in commands {
                    if command.starts_with("driftpost link double") {
                        let (page, folder) = (page.clone(), folder.clone());
                        scope.spawn(move || run(&page, &folder, &command));
                    } else {
                        run(page, &folder, &command);
                    }
                }
                count
            };
            pages.par_iter().map(run_page).sum()
        });
        assert!(run >= 25, "{run} commands");
    }
}
