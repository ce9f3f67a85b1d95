//! A program read in parts is the program read at once.

use super::{at, tool};
use rapid_program::program::motion::{Motion, Origin, Target};
use rapid_program::program::{InParts, Overrides, Parts, Program};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{Diagnostic, FileId, Span, TextRange};
use std::path::Path;

/// A span as it is in the whole file.
fn whole(program: &Program, span: Span) -> Span {
    Span { range: program.file(span.file).in_whole(span.range), ..span }
}

/// A motion with its places as they are in the whole files, and the place of the motion before it.
fn told(program: &Program, motion: &Motion) -> String {
    let range = |range: TextRange| program.file(motion.file).in_whole(range);
    let before = motion.previous.map(|p| &program.motions[p]);
    let target = |target: &Target| {
        let origin = match &target.origin {
            Origin::Named { name, declaration } => {
                Origin::Named { name: name.clone(), declaration: whole(program, *declaration) }
            }
            other => other.clone(),
        };
        let literal = target.literal.map(|span| whole(program, span));
        Target { range: range(target.range), origin, literal, ..target.clone() }
    };
    let mut keep = motion.keep.clone();
    if let Some(keep) = &mut keep {
        keep.because = keep.because.map(|span| whole(program, span));
    }
    // Loops and routines are numbered anew in each part.
    let loops = motion.loops.iter().map(|&l| &program.loops[l]);
    let loops: Vec<_> = loops.map(|l| (l.file, l.unconditional, l.passes)).collect();
    let routine = &program.routines[motion.routine];
    let moved = Motion {
        range: range(motion.range),
        targets: motion.targets.iter().map(target).collect(),
        previous: None,
        loops: Vec::new(),
        routine: 0,
        keep,
        ..motion.clone()
    };
    let before = before.map(|m| (m.file, m.line, program.file(m.file).in_whole(m.range)));
    format!("{moved:?} {loops:?} {} {before:?}", routine.name)
}

fn message(program: &Program, message: &Diagnostic) -> String {
    let place = message.span.map(|span| whole(program, span));
    let labels: Vec<_> =
        message.labels.iter().map(|(span, text)| (whole(program, *span), text.clone())).collect();
    format!("{} {} {:?} {labels:?}", message.code, message.message, place)
}

/// Reads files at once and each as a part of its own, and compares; gives how many motions the outlines leave out.
fn compare(files: &[(String, Vec<u8>)]) -> usize {
    let read = |id: usize| SourceFile::read(FileId(id as u32), files[id].0.clone(), files[id].1.clone());
    let overrides = Overrides::default();
    let at_once = Program::read((0..files.len()).map(read).collect(), &overrides);
    let mut parts = InParts::new(files.len(), 1, &overrides, |FileId(id)| Ok(read(id as usize))).unwrap();
    assert_eq!(parts.count(), files.len());
    let expected: Vec<String> = at_once.motions.iter().map(|m| told(&at_once, m)).collect();
    let said: Vec<String> = at_once.diagnostics.iter().map(|d| message(&at_once, d)).collect();
    let (mut found, mut heard, mut left_out) = (Vec::new(), Vec::new(), 0);
    for part in 0..parts.count() {
        parts
            .visit(part, &mut |part| {
                let program = part.program;
                left_out += at_once.motions.len() - program.motions.len();
                let own = program.motions.iter().filter(|m| program.is_own(m));
                found.extend(own.map(|m| told(program, m)));
                heard.extend(program.own_diagnostics(part.number).map(|d| message(program, d)));
                assert_eq!(program.facts.identifiers, at_once.facts.identifiers);
                let names = |p: &Program| p.facts.entries.iter().map(|e| e.name.clone()).collect::<Vec<_>>();
                assert_eq!(names(program), names(&at_once));
            })
            .unwrap();
    }
    for (found, expected) in found.iter().zip(&expected) {
        assert_eq!(found, expected);
    }
    assert_eq!(found.len(), expected.len());
    let (mut heard, mut said) = (heard, said);
    heard.sort();
    said.sort();
    assert_eq!(heard, said);
    left_out
}

#[test]
fn what_is_in_force_goes_from_part_to_part() {
    let moves = |y: i32, n: i32| {
        let line = |x| format!("MoveL {},v100,z1,t\\WObj:=w;\n", at(400 + x, y, 300));
        (0..n).map(line).collect::<String>()
    };
    let main = format!(
        "MODULE Main\nPERS tooldata t:={};\nPERS wobjdata w:=[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];\n\
         VAR num n;\nPROC main()\nMoveAbsJ [[0,0,0,0,90,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,t;\none;\n{}two;\n\
         t.tframe.trans.x:=55;\nFOR i FROM 1 TO 3 DO\none;\nWaitTime 2;\nENDFOR\nIF n>1 THEN\nConfL\\Off;\nENDIF\ntwo;\n{}\
         ERROR\nTRYNEXT;\nENDPROC\nENDMODULE\n",
        tool(10),
        moves(7, 5),
        moves(8, 4),
    );
    let one = format!(
        "MODULE One\nLOCAL VAR num k;\nPROC one()\nConfL\\On;\n{}WaitTime 1;\nagain:\n{}IF k<3 GOTO again;\n{}ENDPROC\nENDMODULE\n",
        moves(1, 9),
        moves(2, 6),
        moves(3, 3)
    );
    let two = format!(
        "MODULE Two\nPROC two()\n{}w.uframe.trans.z:=10;\n{}PDispOn [[1,0,0],[1,0,0,0]],t;\n{}PDispOff;\nlost x;\n{}ENDPROC\n\
         TRAP stop\nStopMove;\n{}ENDTRAP\nENDMODULE\n",
        moves(4, 8),
        moves(5, 8),
        moves(6, 5),
        moves(9, 5),
        moves(10, 4)
    );
    let files = [("Main.mod", main), ("One.mod", one), ("Two.mod", two)];
    let files: Vec<_> = files.into_iter().map(|(path, text)| (path.to_owned(), text.into_bytes())).collect();
    assert!(compare(&files) > 50);
}

/// All modules of the fixtures as one program: names that are declared many times over, text that is not understood.
#[test]
fn every_fixture_is_read_in_parts_as_at_once() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures");
    let mut files = Vec::new();
    collect(&folder, &mut files);
    files.sort();
    assert!(files.len() > 20, "{}", files.len());
    assert!(compare(&files) > 500);
    for file in files {
        // With another that calls it and moves before and behind.
        let beside = format!(
            "MODULE Z\nPROC z()\nMoveL {0},v5,fine,tool0;\nMain;\nMoveL {0},v5,fine,tool0;\nENDPROC\nENDMODULE",
            at(1, 2, 3)
        );
        compare(&[file, ("Z.mod".to_owned(), beside.into_bytes())]);
    }
}

/// Twenty thousand moves in six files.
#[test]
fn pages_are_read_in_parts_as_at_once() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/robodk/mill20000");
    if !folder.is_dir() {
        eprintln!("skipped: {} is not there", folder.display());
        return;
    }
    let mut files = Vec::new();
    collect(&folder, &mut files);
    files.sort();
    // Each part sees a few moves of the other five pages.
    assert!(compare(&files) > 99_000);
}

fn collect(folder: &Path, files: &mut Vec<(String, Vec<u8>)>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|e| e == "mod" || e == "prg" || e == "sys" || e == "MOD") {
            files.push((path.to_string_lossy().into_owned(), std::fs::read(&path).unwrap()));
        }
    }
}
