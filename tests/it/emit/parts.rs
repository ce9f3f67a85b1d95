//! A program emitted part by part gives what it gives in one.

use super::{NAMED, by_tool, options, toy};
use rapid_program::compensate::plan::{Plan, Totals};
use rapid_program::emit::{Core, Emission, EmitError, EmitOptions, EmittedFile, emit};
use rapid_program::program::Program;
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{FileId, TextRange};

const BUCKETS: usize = 3;

/// A page of plain moves that can stand in another module, and some that cannot.
fn page(name: &str, eol: &str) -> Vec<u8> {
    let moves = |from: u32| -> String {
        let one = |n| {
            format!("    MoveL [[{n},0,350],[1,0,0,0],[0,0,0,1],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,z5,tGun;\n")
        };
        (from..from + 12).map(one).collect()
    };
    let lines = [
        format!("MODULE {name}\n  PROC {name}main(PERS tooldata tGun)\n"),
        moves(400),
        "    weld;\n".to_owned(),
        moves(420),
        "    MoveL p10,v100,z5,tGun;\n  ENDPROC\n\n  PROC go()\n    MoveL p20,v100,z5,tGun;\n".to_owned(),
        "  ENDPROC\nENDMODULE\n".to_owned(),
    ];
    lines.concat().replace('\n', eol).into_bytes()
}

fn file(id: u32, path: &str, bytes: &[u8]) -> SourceFile {
    SourceFile::read(FileId(id), path, bytes)
}

/// The file without most of its moves to numbers, perhaps with all.
fn outline(file: &SourceFile) -> SourceFile {
    let moves: Vec<u32> = memchr::memmem::find_iter(&file.bytes, b"MoveL [[").map(|at| at as u32).collect();
    let runs = moves.chunks_exact(12).map(|run| TextRange::new(run[3], run[9]));
    let outline = file.without(&runs.chain([TextRange::empty(file.bytes.len() as u32)]).collect::<Vec<_>>());
    assert!(outline.is_outline());
    outline
}

fn planned(files: Vec<SourceFile>) -> (Program, Plan) {
    let program = toy::program_of(files);
    let plan = toy::plan(&program, BUCKETS, &[], by_tool(&program));
    (program, plan)
}

/// The program, and each of its files with all others as outlines.
fn parts(files: &[SourceFile]) -> Vec<(Program, Plan)> {
    let part = |own: usize| {
        let others = files.iter().enumerate();
        planned(others.map(|(i, f)| if i == own { f.clone() } else { outline(f) }).collect())
    };
    (0..files.len()).map(part).collect()
}

/// What is emitted, piece by piece.
fn pieces(options: &EmitOptions, parts: &[(Program, Plan)]) -> Result<Vec<EmittedFile>, EmitError> {
    let mut emission = Emission::new(options);
    let mut totals = Totals::default();
    for (program, plan) in parts {
        emission.look(program, plan)?;
        totals.add(&Totals::of(program, plan));
    }
    let mut taken = Vec::new();
    let Some(ready) = emission.ready(&parts[0].1.schedule, &totals)? else { return Ok(taken) };
    let mut take = |file| {
        taken.push(file);
        Ok::<(), EmitError>(())
    };
    for (program, plan) in parts {
        ready.emit(program, plan, &mut take)?;
    }
    ready.finish(&mut take)?;
    Ok(taken)
}

fn whole_of(pieces: &[EmittedFile], file: &EmittedFile) -> Vec<u8> {
    let own = pieces.iter().filter(|piece| piece.path == file.path);
    own.flat_map(|piece| piece.bytes.iter().copied()).collect()
}

#[test]
fn two_parts_give_the_same_bytes_as_one() {
    let files = [
        file(0, "x/named.mod", NAMED),
        file(1, "x/page.mod", &page("Page", "\n")),
        file(2, "x/second.mod", &page("Second", "\r\n")),
        file(3, "x/idle.mod", b"MODULE Idle\n  VAR num tcSay:=1;\nENDMODULE\n"),
    ];
    let (program, plan) = planned(files.to_vec());
    let parts = parts(&files);
    let page = |own: usize| parts[own].0.files[1].bytes.len();
    assert!(page(0) < page(1) && page(1) == files[1].bytes.len());
    let options = options();
    let whole = emit(&program, &plan, &options).unwrap();
    let pieces = pieces(&options, &parts).unwrap();
    // named.mod, page.mod, second.mod, tcCore.mod
    assert_eq!((whole.len(), pieces.len()), (4, 4));
    for file in &whole {
        let of_parts = String::from_utf8(whole_of(&pieces, file)).unwrap();
        assert_eq!(of_parts, String::from_utf8_lossy(&file.bytes), "{}", file.path);
        let first = pieces.iter().find(|piece| piece.path == file.path).unwrap();
        assert_eq!((first.source, &first.edits), (file.source, &file.edits));
    }
}

#[test]
fn what_concerns_all_parts_is_refused_when_all_are_known() {
    let files = [file(0, "x/page.mod", &page("Page", "\n")), file(1, "x/second.mod", &page("Second", "\n"))];
    let embedded = EmitOptions { core: Some(Core::Embedded), ..options() };
    assert_eq!(pieces(&embedded, &parts(&files)), Err(EmitError::EmbeddedInSeveral { modules: 2 }));
    assert!(pieces(&embedded, &parts(&files[..1])).is_ok());
    let tasks = ["TASK1/page.mod", "TASK2/second.mod"];
    let files: Vec<_> = (0..).zip(tasks).map(|(id, path)| file(id, path, &page("Page", "\n"))).collect();
    let several = EmitError::SeveralTasks { tasks: vec!["TASK1".to_owned(), "TASK2".to_owned()] };
    assert_eq!(pieces(&options(), &parts(&files)), Err(several));
}

#[test]
fn a_part_that_was_not_looked_at_is_not_emitted() {
    let files = [file(0, "x/page.mod", &page("Page", "\n")), file(1, "x/second.mod", &page("Second", "\n"))];
    let parts = parts(&files);
    let options = options();
    let mut emission = Emission::new(&options);
    emission.look(&parts[0].0, &parts[0].1).unwrap();
    let ready = emission.ready(&parts[0].1.schedule, &Totals::default()).unwrap().unwrap();
    let emitted = ready.emit(&parts[1].0, &parts[1].1, &mut |_| Ok::<(), EmitError>(()));
    assert_eq!(emitted.unwrap_err().code(), "emit::plan-mismatch");
}
