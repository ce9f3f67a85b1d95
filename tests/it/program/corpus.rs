//! Real RAPID: every repository below the folder that `DRIFTPOST_CORPUS` names is read as one program.

use crate::folders;
use rapid_program::motion::Path as How;
use rapid_program::{Overrides, Program};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::FileId;
use std::collections::BTreeMap;
use std::path::PathBuf;

#[test]
#[ignore = "needs a folder of RAPID programs in DRIFTPOST_CORPUS"]
fn every_motion_of_real_programs_is_known_or_has_a_reason() {
    let folder = folders::corpus();
    let mut tally = BTreeMap::<&str, usize>::new();
    let mut warned = BTreeMap::<&str, usize>::new();
    for entry in std::fs::read_dir(&folder).unwrap() {
        let entry = entry.unwrap().path();
        let paths = if entry.is_dir() { folders::files_below(&entry) } else { vec![entry] };
        // Each folder with files is a program of its own.
        let mut programs = BTreeMap::<PathBuf, Vec<PathBuf>>::new();
        for path in paths {
            programs.entry(path.parent().unwrap().to_owned()).or_default().push(path);
        }
        for paths in programs.values() {
            let read = |(id, path): (usize, &PathBuf)| {
                let name = path.display().to_string();
                SourceFile::read(FileId(id as u32), name, std::fs::read(path).unwrap())
            };
            let files: Vec<SourceFile> = paths.iter().enumerate().map(read).collect();
            let start = std::time::Instant::now();
            let program = Program::read(files, &Overrides::default());
            assert!(start.elapsed().as_secs() < 20, "{paths:?}");
            for motion in &program.motions {
                let code = motion.skip_reason.as_ref().map_or("-", |k| k.code);
                *tally.entry(code).or_default() += 1;
                if let Some(keep) = &motion.skip_reason {
                    assert!(!keep.reason.is_empty());
                    if std::env::var_os("DRIFTPOST_SHOW").is_some_and(|show| show == code) {
                        let file = program.file(motion.file);
                        let text = String::from_utf8_lossy(file.text(motion.range)).into_owned();
                        println!("{}:{}: {text}\n    {}", file.path, motion.line, keep.reason);
                    }
                } else {
                    assert!(motion.targets.iter().all(|t| t.values().next().is_some()));
                    assert!(!motion.targets.is_empty());
                    let framed = motion.setup.tool.is_some() && motion.setup.wobj.is_some();
                    assert!(motion.setup.path == How::AbsJoint || framed);
                }
            }
            for diagnostic in &program.diagnostics {
                *warned.entry(diagnostic.code).or_default() += 1;
                if std::env::var_os("DRIFTPOST_SHOW").is_some_and(|show| show == diagnostic.code) {
                    println!("{}", diagnostic.message);
                }
            }
        }
    }
    println!("{} motions: {tally:#?}\nwarnings: {warned:#?}", tally.values().sum::<usize>());
}
