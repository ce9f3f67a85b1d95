//! What becomes of every motion of real programs: the table of docs/CORPUS.md.

use crate::folders;
use driftpost::{Compensation, Deformation, ProgramFiles, Robot};
use rapid_compensation::compensate::FormChoice;
use rapid_compensation::compensate::plan::{Form, Status};
use rapid_program::task_of;
use rapid_syntax::diagnostic::FileId;
use rapid_syntax::tree::FileItem;
use rapid_syntax::{SourceFile, walk};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Move instructions by the text alone.
const MOVES: [&[u8]; 31] = [
    b"movel",
    b"movej",
    b"movec",
    b"moveabsj",
    b"moveldo",
    b"movejdo",
    b"movecdo",
    b"movelao",
    b"movelgo",
    b"movelsync",
    b"movejsync",
    b"movecsync",
    b"moveextj",
    b"arcl",
    b"arclstart",
    b"arclend",
    b"arcc",
    b"arccstart",
    b"arccend",
    b"capl",
    b"egmmovec",
    b"egmmovel",
    b"searchl",
    b"searchc",
    b"searchextj",
    b"spotl",
    b"spotj",
    b"triggabsj",
    b"triggc",
    b"triggj",
    b"triggl",
];

#[derive(Default)]
struct Table {
    programs: usize,
    files: usize,
    understood: usize,
    words: usize,
    motions: usize,
    by_outcome: BTreeMap<String, usize>,
}

#[test]
#[ignore = "needs a folder of RAPID programs in DRIFTPOST_CORPUS"]
fn what_becomes_of_every_motion() {
    let robot = std::env::var("DRIFTPOST_ROBOT").unwrap_or_else(|_| "irb140".to_owned());
    let form = match std::env::var("DRIFTPOST_FORM").as_deref() {
        Ok("schedule") => FormChoice::Schedule,
        Ok("ramp") => FormChoice::Ramp,
        _ => FormChoice::Auto,
    };
    let mut compensation =
        Compensation::new(Robot::built_in(&robot).unwrap(), Deformation::paper()).in_form(form);
    compensation.allow_other_robot = true;
    compensation.allow_non_nominal = true;
    // A table of another, larger arm: its size is no matter here.
    compensation.options.max_correction_m = 0.01;
    compensation.options.max_correction_rad = 0.1;
    let mut table = Table::default();
    for paths in programs(&folders::files_below(&folders::corpus())).values() {
        table.programs += 1;
        if !table.add(&compensation, paths) {
            // Several versions of a program in one folder: each is one of its own.
            paths.iter().for_each(|path| assert!(table.add(&compensation, std::slice::from_ref(path))));
        }
    }
    let Table { programs, files, understood, words, motions, by_outcome } = table;
    println!(
        "{files} files of {programs} programs, {understood} without text that is not understood; robot {robot}"
    );
    println!(
        "{motions} motions; {words} motion words in modules\n\n| outcome | motions | share |\n| --- | --- | --- |"
    );
    let mut rows: Vec<_> = by_outcome.into_iter().collect();
    rows.sort_by(|a, b| b.1.cmp(&a.1).then_with(|| a.0.cmp(&b.0)));
    for (outcome, count) in rows {
        println!("| {outcome} | {count} | {:.1} % |", 100.0 * count as f64 / motions as f64);
    }
    assert_eq!(words, motions, "every motion word inside of modules is a motion");
}

/// Files by the task's folder, or else the folder that they stand in.
fn programs(paths: &[PathBuf]) -> BTreeMap<PathBuf, Vec<PathBuf>> {
    let mut programs: BTreeMap<PathBuf, Vec<PathBuf>> = BTreeMap::new();
    let is_task = |folder: &&Path| {
        let name = folder.file_name().unwrap_or_default().to_string_lossy();
        task_of(&name).is_some()
    };
    for path in paths {
        let folder = path.ancestors().find(is_task).or(path.parent()).unwrap_or(path);
        programs.entry(folder.to_owned()).or_default().push(path.clone());
    }
    programs
}

impl Table {
    /// Enters a program; `false` where its files do not belong together.
    fn add(&mut self, compensation: &Compensation, paths: &[PathBuf]) -> bool {
        let read = |path: &PathBuf| (path.display().to_string(), std::fs::read(path).unwrap());
        let files: Vec<(String, Vec<u8>)> = paths.iter().map(read).collect();
        let mut modules: Vec<Vec<u8>> = Vec::new();
        let (mut words, mut understood) = (0, 0);
        for (id, (path, bytes)) in files.iter().enumerate() {
            let file = SourceFile::read(FileId(id as u32), path.as_str(), bytes.clone());
            for item in &file.tree.items {
                let FileItem::Module(module) = item else { continue };
                modules.push(file.text(module.name).to_ascii_lowercase());
                words +=
                    module.routines().map(|routine| motion_words(routine.range.of(bytes))).sum::<usize>();
            }
            understood += usize::from(walk::leaves(&file.tree).iter().all(|node| node.what != "opaque"));
        }
        let count = modules.len();
        modules.sort();
        modules.dedup();
        if modules.len() < count && paths.len() > 1 {
            return false;
        }
        let mut count =
            |outcome: String, motions: usize| *self.by_outcome.entry(outcome).or_default() += motions;
        let program = match compensation.run(&ProgramFiles::new(files)) {
            Ok(made) => {
                for planned in &made.plan.motions {
                    let outcome = match (&planned.status, planned.form) {
                        (Status::Compensated, Form::Live) => "compensated at run time (`live`)".to_owned(),
                        (Status::Compensated, _) => "compensated".to_owned(),
                        (Status::Kept(why) | Status::Refused(why), _) => format!("`{}`", why.code),
                    };
                    count(outcome, 1);
                }
                made.program
            }
            Err(refused) => {
                let refused = *refused;
                let error =
                    refused.messages.iter().rev().find(|m| m.diagnostic.code != "compensate::nothing");
                let code = error.map_or("?", |m| m.diagnostic.code);
                match refused.kept.len() {
                    0 => count(format!("the program is refused: `{code}`"), refused.program.motions.len()),
                    _ => refused.kept.iter().for_each(|why| count(format!("`{}`", why.code), 1)),
                }
                if refused.program.motions.is_empty() && words > 0 {
                    words = 0; // nothing of it was read: cut off, or no module
                }
                refused.program
            }
        };
        if words != program.motions.len() {
            println!("{}: {words} motion words, {} motions", paths[0].display(), program.motions.len());
        }
        self.files += paths.len();
        self.understood += understood;
        self.words += words;
        self.motions += program.motions.len();
        true
    }
}

/// Words that name a move where a statement begins: behind a semicolon, a line's end, a colon, THEN, ELSE or a condition.
fn motion_words(routine: &[u8]) -> usize {
    let mut words = 0;
    for line in routine.split(|&b| b == b'\n' || b == b'\r') {
        let (mut text, mut in_string) = (Vec::new(), false);
        for &byte in line {
            match byte {
                b'"' => in_string = !in_string,
                b'!' if !in_string => break,
                _ if in_string => {}
                byte => text.push(byte.to_ascii_lowercase()),
            }
        }
        let mut rest = text.as_slice();
        while let Some(start) = rest.iter().position(|b| b.is_ascii_alphabetic()) {
            let letter = |b: &u8| b.is_ascii_alphanumeric() || *b == b'_';
            let end = rest[start..].iter().position(|b| !letter(b)).map_or(rest.len(), |n| start + n);
            let follows = rest.get(end..).and_then(|rest| rest.trim_ascii_start().first().copied());
            let called = !matches!(follows, Some(b':' | b'(' | b',' | b')') | None);
            words += usize::from(called && MOVES.contains(&&rest[start..end]));
            rest = rest.get(end..).unwrap_or_default();
        }
    }
    words
}
